"""Gains that match Quad's step responses in Table IV, and ARQ's responses by the same rule.

    python studies/gains.py [--out DIR]

Every number is from whole flights with sensors and estimator.  Gains are fitted to Quad alone: four
of them, three (one damping ratio for all axes), two (one stiffness as well), and two stiffnesses
with a textbook damping ratio.  Then ARQ flies by several rules for scaling Quad's gains to a
heavier robot.  The paper prints no inner loop either, so the fit is repeated with others.  Last,
the dependence of the errors on circles.  Writes
``fits.csv``, ``rules.csv``, ``inner.csv`` and ``circles.csv``, and prints them as in
studies/README.md.
"""

from __future__ import annotations

import argparse
import functools
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from scipy.optimize import least_squares

import springback
from springback.files import write_csv
from springback.paper.free_flight import (
    CIRCLE_TIME,
    PERIODS,
    QUANTITIES,
    RADIUS,
    TABLE_IV_CIRCLES,
    TABLE_IV_STEPS,
    circle_tables,
)
from springback.paper.responses import (
    circle_errors,
    mean_square_error,
    rise_time,
    step_response,
)
from springback.vehicle.library import BATTERY, VEHICLES

Kind = Literal["horizontal", "vertical"]
Robot = Literal["quad", "arq"]
WAIT, DWELL = 0.5, 5.0  # [s]
MASS = {name: VEHICLES[name].vehicle.mass for name in ("quad", "arq")}
BESSEL = math.sqrt(0.75)  # damping ratio of a Bessel filter of two poles
HORIZONTAL, VERTICAL = 9.25, 20.0  # [N/m], the defaults
Split = Callable[[np.ndarray], list[tuple[float, float]]]
DRY = {name: mass - BATTERY for name, mass in MASS.items()}
INERTIA = {name: float(VEHICLES[name].vehicle.inertia()[1, 1]) for name in ("quad", "arq")}


class Answer(NamedTuple):
    """Of a step: rise time [s] and mean square error [m²]."""

    rise: float
    mse: float


class Gains(NamedTuple):
    """Of one kind of axis, [N/m] and [N s/m]."""

    stiffness: float
    damping: float


def printed(robot: Robot, kind: Kind) -> Answer:
    """Table IV; x and y as their mean."""
    table = TABLE_IV_STEPS[robot]
    rows = [table[axis] for axis in (("z",) if kind == "vertical" else ("x", "y"))]
    return Answer(*np.mean(rows, axis=0).tolist())


@functools.cache
def answer(robot: Robot, kind: Kind, gains: Gains, inner: tuple[tuple[str, float], ...]) -> Answer:
    """Fly one step of 1 m along x or z."""
    stem, axis = ("vertical_", "z") if kind == "vertical" else ("", "x")
    goal = [0.0, 0.0, 2.0] if kind == "vertical" else [1.0, 0.0, 1.0]
    control: dict[str, Any] = {
        f"{stem}stiffness": gains.stiffness, f"{stem}damping": gains.damping, **dict(inner)
    }  # fmt: skip
    flight = springback.fly(
        {
            "vehicle": robot,
            "reference": {"type": "steps", "positions": [[0.0, 0.0, 1.0], goal], "dwell": WAIT},
            "simulation": {"duration": WAIT + DWELL},
            "control": control,
        }
    )
    response = step_response(flight, axis, WAIT, DWELL, 1.0 if kind == "vertical" else 0.0)
    return Answer(rise_time(*response), mean_square_error(*response))


def of_ratio(stiffness: float, ratio: float, mass: float) -> Gains:
    """K_v = 2 ζ √(K_p m)."""
    return Gains(stiffness, 2.0 * ratio * math.sqrt(stiffness * mass))


def fitted(
    kinds: tuple[Kind, ...],
    split: Split,
    start: list[float],
    inner: tuple[tuple[str, float], ...] = (),
) -> tuple[np.ndarray, list[float]]:
    """Numbers with which Quad answers as printed, and the relative deviations that remain.

    Args:
        kinds: Of axis.
        split: From the numbers to stiffness and damping ratio for each kind.
        start: Of the search.
        inner: Settings of the inner loops.
    """

    def residual(numbers: np.ndarray) -> list[float]:
        found = []
        for kind, (stiffness, ratio) in zip(kinds, split(numbers), strict=True):
            got = answer("quad", kind, of_ratio(stiffness, ratio, MASS["quad"]), inner)
            wanted = printed("quad", kind)
            found += [got.rise / wanted.rise - 1.0, got.mse / wanted.mse - 1.0]
        return found

    bounds = ([1.0 if value > 2.0 else 0.2 for value in start], [100.0] * len(start))
    solved = least_squares(residual, start, bounds=bounds, diff_step=3e-3, x_scale=start, xtol=1e-5)
    return solved.x, residual(solved.x)


def _stiffnesses(ratio: float) -> Split:
    """Two stiffnesses are free, the damping ratio is not."""
    return lambda v: [(v[0], ratio), (v[1], ratio)]


def fits() -> list[dict[str, Any]]:
    """Four, three and two free numbers; what Quad and ARQ then do."""
    both: tuple[Kind, ...] = ("horizontal", "vertical")
    kinds: dict[str, tuple[Split, list[float]]] = {
        "four": (lambda v: [(v[0], v[1]), (v[2], v[3])], [10.8, 0.94, 28.0, 0.96]),
        "three": (lambda v: [(v[0], v[2]), (v[1], v[2])], [11.0, 26.5, 0.95]),
        "two, one stiffness and one ratio": (lambda v: [(v[0], v[1]), (v[0], v[1])], [13.0, 0.78]),
        "two, Butterworth": (_stiffnesses(math.sqrt(0.5)), [7.0, 14.0]),
        "two, Bessel": (_stiffnesses(BESSEL), [9.25, 20.0]),
        "two, critical damping": (_stiffnesses(1.0), [12.5, 32.0]),
        "two, Bessel, rounded": (lambda v: [(HORIZONTAL, BESSEL), (VERTICAL, BESSEL)], []),
    }
    rows = []
    for name, (split, start) in kinds.items():
        numbers = fitted(both, split, start)[0] if start else np.array([])
        for kind, (stiffness, ratio) in zip(both, split(numbers), strict=True):
            for robot in ("quad", "arq"):
                got = answer(robot, kind, of_ratio(stiffness, ratio, MASS[robot]), ())
                rows.append(_row({"free numbers": name, "axis": kind, "K_p": stiffness,
                                  "zeta": ratio}, robot, kind, got))  # fmt: skip
    return rows


def rules() -> list[dict[str, Any]]:
    """ARQ by rules that need no further number, from the rounded gains of Quad."""
    heavier, dry = MASS["arq"] / MASS["quad"], DRY["arq"] / DRY["quad"]
    lazier = (("rate_gain", 40.0 * INERTIA["quad"] / INERTIA["arq"]),)
    named: dict[str, tuple[float, float, tuple[tuple[str, float], ...]]] = {
        "same stiffness and damping ratio": (1.0, math.sqrt(heavier), ()),
        "same forces": (1.0, 1.0, ()),
        "same accelerations": (heavier, heavier, ()),
        "accelerations by dry masses": (heavier / dry, heavier / dry, ()),
        "same forces and torques": (1.0, 1.0, lazier),
        "same stiffness, damping ratio, torques": (1.0, math.sqrt(heavier), lazier),
        "stiffness by dry masses, same ratio": (heavier / dry, heavier / math.sqrt(dry), ()),
    }
    rows = []
    for name, (stiffer, damper, inner) in named.items():
        for kind, k_p in (("horizontal", HORIZONTAL), ("vertical", VERTICAL)):
            quad = of_ratio(k_p, BESSEL, MASS["quad"])
            gains = Gains(stiffer * quad.stiffness, damper * quad.damping)
            got = answer("arq", kind, gains, inner)  # type: ignore[arg-type]
            rows.append(_row({"rule": name, "axis": kind}, "arq", kind, got))  # type: ignore[arg-type]
    return rows


def inner_loops() -> list[dict[str, Any]]:
    """The horizontal fit with other inner loops, how ill it is conditioned, and ARQ's answer."""
    rows = []
    for tau in (0.1, 1.0 / 6.5, 0.2):
        for rate_gain in (20.0, 30.0, 40.0, 50.0):
            inner = (("rate_gain", rate_gain), ("time_constant", tau))
            (k_p,), left = fitted(("horizontal",), lambda v: [(v[0], BESSEL)], [HORIZONTAL], inner)
            gains = of_ratio(k_p, BESSEL, MASS["quad"])
            softer = Gains(0.98 * gains.stiffness, gains.damping)
            soft = answer("quad", "horizontal", softer, inner).rise
            got = answer("arq", "horizontal", of_ratio(k_p, BESSEL, MASS["arq"]), inner)
            rows.append(
                _row(
                    {
                        "tau": tau, "k_omega": rate_gain, "K_p": k_p,
                        "left": max(map(abs, left)),
                        "Quad's rise, K_p 2 % less": soft,
                    },
                    "arq", "horizontal", got,
                )
            )  # fmt: skip
    return rows


def circles() -> list[dict[str, Any]]:
    """Errors by the rounds that count, and by how late the reference is in the record."""
    rows = []
    for robot in ("quad", "arq"):
        for pace, period in PERIODS.items():
            flight = springback.fly(circle_tables(robot, pace, 0))
            counted = {
                "whole": (0.0, CIRCLE_TIME, 0.0), "first round": (0.0, period, 0.0),
                "second round": (period, 2.0 * period, 0.0),
                "whole, 10 ms late": (0.0, CIRCLE_TIME, 0.01),
                "whole, 25 ms late": (0.0, CIRCLE_TIME, 0.025),
            }  # fmt: skip
            for name, (begins, ends, late) in counted.items():
                found = circle_errors(flight, period, RADIUS, begins, ends, late)
                rows.append({"robot": robot, "pace": pace, "counted": name} | found)
            cells = dict(zip(QUANTITIES, TABLE_IV_CIRCLES[robot, pace], strict=True))  # type: ignore[index]
            rows.append({"robot": robot, "pace": pace, "counted": "printed"} | cells)
    return rows


def _row(head: dict[str, Any], robot: Robot, kind: Kind, got: Answer) -> dict[str, Any]:
    wanted = printed(robot, kind)
    return {
        **head, "robot": robot, "rise": got.rise, "rise, printed": wanted.rise,
        "MSE": got.mse, "MSE, printed": wanted.mse,
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path())
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for part in (fits, rules, inner_loops, circles):
        rows = part()
        print("\n| " + " | ".join(rows[0]) + " |\n|" + "---|" * len(rows[0]))
        for row in rows:
            cells = (f"{x:.4g}" if isinstance(x, float) else str(x) for x in row.values())
            print("| " + " | ".join(cells) + " |", flush=True)
        write_csv(out / f"{part.__name__.replace('_loops', '')}.csv", rows)


if __name__ == "__main__":
    main()
