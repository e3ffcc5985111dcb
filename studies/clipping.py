"""Errors of the estimate after an impact beyond the accelerometer's range, and their duration.

    python studies/clipping.py [--out DIR]

Quad flies into the paper's wall at 3.5 m/s with both estimators, with an accelerometer of 16 g and
with one that no impact exceeds, and with a Kalman filter that trusts clipped readings and one that
does not.  Writes ``clipping.csv`` and ``clipping.png``, and prints the table in
studies/README.md.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure

import springback
from springback.files import write_csv
from springback.interfaces.figures import style
from springback.interfaces.output.robots import INK, RED
from springback.results.estimate_errors import (
    EstimateErrors,
    clipped_area,
    estimate_errors,
    specific_force,
)
from springback.results.flight import Flight

RANGE, HUGE = 16.0 * 9.80665, 2e3  # [m/s²]
SPEED = 3.5  # [m/s], the faster of the paper's impacts
DELAYS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)  # [s] after separation
SEEDS = range(1, 9)


class Case(NamedTuple):
    """An estimator and its accelerometer."""

    name: str
    estimator: str
    full_scale: float
    distrust: bool


CASES = (
    Case("Kalman, 16 g, clipped readings distrusted", "kalman", RANGE, True),
    Case("Kalman, 16 g, trusted", "kalman", RANGE, False),
    Case("complementary, 16 g", "complementary", RANGE, True),
    Case("Kalman, no clipping", "kalman", HUGE, True),
    Case("complementary, no clipping", "complementary", HUGE, True),
)


def flown(case: Case, seed: int) -> Flight:
    """The impact and the second after it."""
    kalman = {"accelerometer_range": case.full_scale, "distrust_clipped": case.distrust}
    return springback.fly(
        {
            "vehicle": "quad",
            "reference": {"type": "hold", "position": (0.0, 0.0, 1.0)},
            "start": {"position": (2.2, 0.0, 1.0), "velocity": (SPEED, 0.0, 0.0)},
            "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
            "estimator": {"type": case.estimator, "kalman": kalman},
            "sensors": {"imu": {"accelerometer": {"full_scale": case.full_scale, "bits": 20}}},
            "simulation": {"duration": 1.0},
            "seed": seed,
        }
    )


def row(case: Case) -> dict[str, float | str]:
    """Errors after the impact: the median over some seeds."""
    found: list[list[float]] = []
    for seed in SEEDS:
        flight = flown(case, seed)
        e, left = estimate_errors(flight), flight.separation_time or math.nan
        at = [int(np.searchsorted(e.time, left + delay)) for delay in DELAYS]
        late = e.time > (flight.touch_time or 0.0)
        found.append(
            [clipped_area(flight, case.full_scale), e.velocity.max(), *e.velocity[at],
             math.degrees(e.attitude[late].max())]
        )  # fmt: skip
    values = np.median(found, axis=0).tolist()
    keys = (
        "clipped area [m/s]", "largest [m/s]", *(f"{1e3 * delay:g} ms" for delay in DELAYS),
        "largest angle [deg]",
    )  # fmt: skip
    return {"case": case.name, **dict(zip(keys, values, strict=True))}


def table(rows: list[dict[str, float | str]]) -> str:
    """Markdown."""
    lines = [
        "| " + " | ".join(rows[0]) + " |",
        "|:---|" + "---:|" * (len(rows[0]) - 1),
    ]
    for entry in rows:
        words = (x if isinstance(x, str) else f"{x:.3g}" for x in entry.values())
        lines.append("| " + " | ".join(words) + " |")
    return "\n".join(lines)


@style.in_style
def figure(made: dict[str, tuple[Flight, EstimateErrors]]) -> Figure:
    """Force felt and read; errors of velocity and of attitude over time after first touch."""
    drawn = style.StyledFigure(figsize=(style.WIDTH, 5.6), layout="constrained")
    top, middle, bottom = drawn.subplots(3, 1)
    flight, errors = made[CASES[0].name]
    start = flight.touch_time or 0.0
    time = 1e3 * (errors.time - start)
    top.plot(time, specific_force(flight)[:, 0] / 9.80665, color=INK, label="felt")
    top.plot(time, flight.telemetry["imu_ax"] / 9.80665, color=RED, ls="--", label="read")
    top.set(xlim=(-10.0, 50.0), ylabel="force along x [g]", xlabel="time after first touch [ms]")
    top.legend(loc="lower right")
    for (name, (_, e)), look in zip(made.items(), style.LOOKS, strict=False):
        late = 1e3 * (e.time - start)
        middle.semilogy(late, e.velocity, label=name, **look)
        bottom.plot(late, np.degrees(e.attitude), **look)
    middle.set(xlim=(-50.0, 600.0), ylim=(1e-3, 1e1), ylabel="velocity error [m/s]")
    middle.set_yticks([1e-3, 1e-2, 1e-1, 1.0, 10.0], ["0.001", "0.01", "0.1", "1", "10"])
    bottom.set(xlim=(-50.0, 600.0), ylim=(0.0, None), ylabel="attitude error [deg]")
    bottom.set_xlabel("time after first touch [ms]")
    drawn.legend(*middle.get_legend_handles_labels(), loc="outside lower center", ncols=1)
    return drawn


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("."), help="folder for the files")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    rows = [row(case) for case in CASES]
    write_csv(out / "clipping.csv", rows)
    made = {case.name: flown(case, SEEDS[0]) for case in CASES}
    shown = {name: (flight, estimate_errors(flight)) for name, flight in made.items()}
    (out / "clipping.png").write_bytes(style.png(figure(shown)))
    print(table(rows))


if __name__ == "__main__":
    main()
