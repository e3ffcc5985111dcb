"""Convergence of impacts with step size, slip speed and the steps of the other phases.

    python studies/convergence.py [--out DIR] [--refresh]

Writes ``convergence.csv``, ``influences.csv`` and ``convergence.png``, and prints the tables
of studies/README.md; ``--refresh`` writes them there.
"""

from __future__ import annotations

import argparse
import io
import math
from collections.abc import Mapping, Sequence
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any, NamedTuple

from springback.files import write_csv
from springback.results.flight import fly

#: The page with the tables, and the marks before and after them.
PAGE = Path(__file__).with_name("README.md")
BEGIN, END = "<!-- tables of convergence.py -->\n", "<!-- end of these tables -->\n"
STEPS = (8e-4, 4e-4, 2e-4, 1e-4, 5e-5, 2.5e-5, 1.25e-5, 6.25e-6)
DEFAULT, TOLERANCE = 1e-4, 1e-3
MEASURES = {
    "restitution_at_separation": "COR",
    "peak_acceleration": "peak acceleration",
    "contact_time": "contact time",
    "travel": "travel",
}
#: Settle steps act on what comes after separation.
CHANGED = {**MEASURES, "restitution_at_return": "COR at return"}


class Case(NamedTuple):
    """An impact to be computed with many steps."""

    name: str
    scenario: dict[str, Any]


def _slider(vehicle: str) -> dict[str, Any]:
    """A slider test of the paper: its contact point, its friction, 1.85 m/s."""
    wall = {"preset": "wall", "friction_axes": "vertical"}
    return {
        "vehicle": vehicle,
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": wall}]},
        "start": {"position": [0.6, 0.0, 0.0], "velocity": [1.85, 0.0, 0.0]},
        "model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": 0.3},
    }


def _flight(vehicle: str, speed: float, yaw: str, pitch: str) -> dict[str, Any]:
    """A free vehicle at hover thrust into the wall, ring contact, friction along both tangents."""
    return {
        "vehicle": vehicle,
        "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {
            "position": [0.6, 0.0, 1.0],
            "velocity": [speed, 0.0, 0.0],
            "yaw": yaw,
            "pitch": pitch,
        },
        "simulation": {"duration": 0.3},
    }


CASES = (
    Case("Quad, slider, 1.85 m/s", _slider("quad-slider")),
    Case("ARQ, slider, 1.85 m/s", _slider("arq-slider")),
    Case("ARQ, oblique on one arm, 2 m/s", _flight("arq", 2.0, "30 deg", "15 deg")),
    Case("Quad, oblique, 6 m/s", _flight("quad", 6.0, "20 deg", "15 deg")),
)


def measured(scenario: Mapping[str, Any], *overrides: str) -> dict[str, float]:
    """The compared measures of a flight, its steps, and what its energy ledger leaves over."""
    flight = fly(scenario, *overrides, trajectory=False)
    names = (*CHANGED, "steps", "ledger_residual")
    return {name: float(flight.measures[name] or 0.0) for name in names}


def sweep(case: Case, steps: Sequence[float] = STEPS) -> list[dict[str, float]]:
    """A case at every step size, with errors against the finest."""
    rows = [
        {"step": step, **measured(case.scenario, f"simulation.impact_step={step!r}")}
        for step in steps
    ]
    for row in rows:
        for name in MEASURES:
            row[f"error_{name}"] = abs(row[name] / rows[-1][name] - 1.0)
    return rows


def order(rows: Sequence[Mapping[str, float]], name: str) -> float:
    """Observed order p of x(h) = x + C hᵖ, by least squares over the steps that show it.

    Errors against the finest step; those near the floor of rounding or of sampling say nothing.
    """
    points = [
        (math.log(row["step"]), math.log(row[f"error_{name}"]))
        for row in rows[:-2]
        if row[f"error_{name}"] > 1e-9
    ]
    if len(points) < 3:
        return math.nan
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / spread


def influences() -> list[dict[str, Any]]:
    """What slip speed, free step and settle step change, each in a case where it has a say."""
    oblique, guided = CASES[2], CASES[1]
    varied = (
        (oblique, "world.obstacles[0].surface.slip_speed", (0.3, 0.1, 0.03, 0.01, 0.003)),
        (oblique, "simulation.free_step", (4e-3, 2e-3, 1e-3, 5e-4, 1e-4)),
        (guided, "simulation.settle_step", (8e-4, 4e-4, 2e-4, 1e-4, 5e-5)),
    )
    rows = []
    for case, field, values in varied:
        reference = measured(case.scenario)
        for value in values:
            found = measured(case.scenario, f"{field}={value!r}")
            changes = {f"change_{name}": found[name] / reference[name] - 1.0 for name in CHANGED}
            row = {"case": case.name, "field": field.rpartition(".")[2], "value": value}
            rows.append({**row, **found, **changes})
    return rows


def coarsest(rows: Sequence[Mapping[str, float]], tolerance: float) -> float:
    """Largest step from which on no finer one errs by more than a tolerance in any measure."""
    best = rows[-1]["step"]
    for row in reversed(rows):
        if max(row[f"error_{name}"] for name in MEASURES) > tolerance:
            break
        best = row["step"]
    return best


def _draw(path: Path, found: Mapping[str, Sequence[Mapping[str, float]]]) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    from matplotlib.ticker import NullFormatter

    figure, axes = plt.subplots(1, len(found), figsize=(3.2 * len(found), 3.4), sharey=True)
    for ax, (name, rows) in zip(axes, found.items(), strict=True):
        for measure, label in MEASURES.items():
            shown = [(r["step"], r[f"error_{measure}"]) for r in rows[:-1]]
            shown = [(step, error) for step, error in shown if error > 1e-13]
            ax.loglog(*zip(*shown, strict=True), marker="o", ms=3, label=label)
        ax.axhline(TOLERANCE, color="0.5", lw=0.8, ls="--")
        ax.axvline(DEFAULT, color="0.5", lw=0.8, ls=":")
        ax.set(title=name, xlabel="impact step [s]")
        ax.xaxis.set_minor_formatter(NullFormatter())
        ax.title.set_fontsize(9)
    axes[0].set_ylabel("relative error")
    axes[0].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, dpi=150)
    plt.close(figure)


def _print_sweep(name: str, rows: Sequence[Mapping[str, float]]) -> None:
    print(f"\n### {name}\n")
    print("| step [s] | " + " | ".join(f"{label}, error" for label in MEASURES.values()), end="")
    print(" | steps | ledger |")
    print("|---:|" + "---:|" * (len(MEASURES) + 2))
    for row in rows:
        errors = " | ".join(f"{row[name]:.7g}, {row[f'error_{name}']:.0e}" for name in MEASURES)
        print(f"| {row['step']:g} | {errors} | {row['steps']:.0f} | {row['ledger_residual']:.0e} |")
    orders = ", ".join(f"{label} {order(rows, name):.1f}" for name, label in MEASURES.items())
    print(f"\nObserved order: {orders}.")
    print(f"Every step up to {coarsest(rows, TOLERANCE):g} s is within {TOLERANCE:.1%}.")


def _print_influences(rows: Sequence[Mapping[str, Any]]) -> None:
    print("\n### Slip speed, free step and settle step: change from the defaults\n")
    print("| case | | value | " + " | ".join(CHANGED.values()) + " | steps | ledger |")
    print("|---|---|---:|" + "---:|" * (len(CHANGED) + 2))
    for row in rows:
        changes = " | ".join(f"{row[f'change_{name}']:+.1e}" for name in CHANGED)
        tail = f"{row['steps']:.0f} | {row['ledger_residual']:.0e}"
        print(f"| {row['case']} | {row['field']} | {row['value']:g} | {changes} | {tail} |")


def _print_verdict(found: Mapping[str, Sequence[Mapping[str, float]]]) -> None:
    limit = min(coarsest(rows, TOLERANCE) for rows in found.values())
    at_default = max(
        row[f"error_{name}"]
        for rows in found.values()
        for row in rows
        if row["step"] == DEFAULT
        for name in MEASURES
    )
    verdict = "holds" if limit >= DEFAULT else "does NOT hold"
    print(
        f"\nEvery measure of every case is within {TOLERANCE:.1%} up to a step of {limit:g} s; "
        f"at the default, {DEFAULT:g} s, the largest error is {at_default:.1e}.  "
        f"The default {verdict}."
    )


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--out", type=Path, default=Path("out/convergence"))
    parser.add_argument("--refresh", action="store_true", help="put the tables into the page")
    given = parser.parse_args(arguments)
    folder: Path = given.out
    folder.mkdir(parents=True, exist_ok=True)

    found = {case.name: sweep(case) for case in CASES}
    changed = influences()
    tables = io.StringIO()
    with redirect_stdout(tables):
        for name, rows in found.items():
            _print_sweep(name, rows)
        _print_influences(changed)
        _print_verdict(found)
    print(tables.getvalue())
    if given.refresh:
        before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
        after = rest.partition(END)[2]
        PAGE.write_text(f"{before}{BEGIN}{tables.getvalue()}\n{END}{after}", encoding="utf-8")
    write_csv(
        folder / "convergence.csv",
        [{"case": name, **row} for name, rows in found.items() for row in rows],
    )
    write_csv(folder / "influences.csv", changed)
    _draw(folder / "convergence.png", found)


if __name__ == "__main__":
    main()
