"""How time and memory grow: ``python -m benchmarks.growth``.

Run-ups, impacts and recoveries of ARQ, in batches, with more flights, longer flights, more arms
and more obstacles, one thing at a time.  Every point is a fresh process, so that its memory is its
own; what has to be compiled is compiled before, by others.  Points of a round follow one another in
an order of their own, so that a change of the machine's mood meets all of them.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from benchmarks.rivals.contenders import STEP, Contender
from benchmarks.rivals.report import machine, spread
from benchmarks.rivals.rounds import Failed, run
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.style import StyledFigure, in_style, save
from springback.interfaces.output.robots import BLUE, INK, ORANGE

#: The point from which one thing is varied: flights, duration [s], arms, obstacles.
USUAL = {"flights": 256, "duration": 6.0, "arms": 4, "obstacles": 2}
#: Values of each, and the label below the panel.
GROWTH: dict[str, tuple[float, ...]] = {
    "flights": (1, 8, 64, 512, 4096),
    "duration": (1.0, 3.0, 6.0, 10.0, 20.0, 30.0),
    "arms": (3, 4, 6, 8),
    "obstacles": (1, 2, 4, 8),
}
LABELS = {
    "flights": "Flights", "duration": "Duration of a flight [s]", "arms": "Arms",
    "obstacles": "Obstacles",
}  # fmt: skip
QUICK = {"flights": (1, 8), "duration": (1.0, 2.0), "arms": (4,), "obstacles": (2,)}


class Point(NamedTuple):
    """One measurement: which thing is varied, and everything's value."""

    varied: str
    flights: int
    duration: float
    arms: int
    obstacles: int

    @property
    def value(self) -> float:
        """Of the thing that is varied."""
        return float(getattr(self, self.varied))


def points(growth: Mapping[str, Sequence[float]], usual: Mapping[str, Any] = USUAL) -> list[Point]:
    """All measurements; the usual point is in every panel that has its value."""
    return [
        Point(name, **{**usual, name: type(usual[name])(value)})
        for name, values in growth.items()
        for value in values
    ]


def contender(point: Point, estimator: str) -> Contender:
    """The program that measures a point."""
    options = {"estimator": estimator, "task": {**STEP, "duration": point.duration}}
    options |= {"arms": point.arms, "obstacles": point.obstacles}
    return Contender("growth", "collision", "springback_flights", "", (), options, "", "")


def measured(
    wanted: Sequence[Point], rounds: int, threads: int, estimator: str
) -> list[dict[str, Any]]:
    """Seconds and memory of every point in every round, in an order that differs each round.

    What has to be compiled is, once, before the rounds and in processes that do not count: a
    compiler takes more memory than flights.
    """
    for point in {(p.arms, p.obstacles): p for p in wanted}.values():
        run(contender(point, estimator), sys.executable, threads, [[1, 8]])
    found: dict[Point, list[dict[str, float]]] = {point: [] for point in wanted}
    for number in range(rounds):
        order = random.Random(number).sample(list(wanted), len(wanted))
        for point in order:
            said = run(contender(point, estimator), sys.executable, threads, [[1, point.flights]])
            seconds = said["many"][0]["seconds"]
            per = 1e3 * seconds / (point.flights * point.duration)
            found[point].append({"ms per flight-second": per, "MiB": said["memory"]})
            print(f"{point}: {per:.3g} ms per flight-second", file=sys.stderr, flush=True)
    return [
        {**point._asdict(), "rounds": values}
        | {key: spread([one[key] for one in values]) for key in values[0]}
        for point, values in found.items()
    ]


def markdown(report: Mapping[str, Any]) -> str:
    """The report to read."""
    lines = ["# How springback grows", ""]
    lines += [f"- {key}: {value}" for key, value in report["machine"].items()]
    usual = ", ".join(f"{key} {value:g}" for key, value in report["usual"].items())
    lines += [
        f"- run-ups, impacts and recoveries of ARQ, {report['estimator']} estimator; unless "
        f"varied: {usual}; medians of {report['rounds']} rounds, lowest and highest in brackets",
        "",
        "| varied | value | ms per flight-second | flight-seconds per second | memory |",
        "|:---|---:|---:|---:|---:|",
    ]
    for row in report["points"]:
        took = row["ms per flight-second"]
        lines.append(
            f"| {row['varied']} | {row[row['varied']]:g} | {took['median']:.3g} "
            f"({took['lowest']:.3g} to {took['highest']:.3g}) | {1e3 / took['median']:.0f} "
            f"| {row['MiB']['median']:.0f} MiB |"
        )
    return "\n".join([*lines, ""])


def _drawn(
    axes: Axes, rows: Sequence[Mapping[str, Any]], key: str, colour: str, style: str
) -> None:
    varied = rows[0]["varied"]
    middle, low, high = (
        [row[key][which] for row in rows] for which in ("median", "lowest", "highest")
    )
    Chart(axes, LABELS[varied], key).errorbars(
        "", [row[varied] for row in rows], middle, low, high, color=colour, linestyle=style,
        marker="o", markersize=3.5, elinewidth=1.0,
    )  # fmt: skip


def _panel(axes: Axes, rows: Sequence[Mapping[str, Any]]) -> Axes:
    """Time on the left axis, memory on the right one."""
    varied = rows[0]["varied"]
    memory = axes.twinx()
    memory.grid(visible=False)
    memory.spines["right"].set_visible(True)
    _drawn(axes, rows, "ms per flight-second", BLUE, "-")
    _drawn(memory, rows, "MiB", ORANGE, (0, (5, 1.5)))  # type: ignore[arg-type]
    if varied != "duration":
        axes.set_xscale("log", base=2)
    ticks = [row[varied] for row in rows]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    memory.minorticks_off()
    axes.set_xlabel(LABELS[varied])
    _from_nought(axes, rows, "ms per flight-second", 1.15, log=varied == "flights")
    _from_nought(memory, rows, "MiB", 2.0)  # so that the two do not hide each other
    return memory


def _from_nought(
    axes: Axes, rows: Sequence[Mapping[str, Any]], key: str, room: float, log: bool = False
) -> None:
    """The axis begins at nought and leaves room above, unless it is logarithmic."""
    highest = max(row[key]["highest"] for row in rows)
    if log:
        lowest = min(row[key]["lowest"] for row in rows)
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.set_ylim(
            10.0 ** math.floor(math.log10(lowest)), 10.0 ** math.ceil(math.log10(highest))
        )
    else:
        axes.set_ylim(0.0, room * highest)


@in_style
def growth_figure(report: Mapping[str, Any]) -> Figure:
    """Four panels, one for each thing that grows; time in blue, memory in orange, broken lines.

    Args:
        report: As written to JSON.
    """
    figure = StyledFigure(figsize=(7.2, 5.0))
    grid = figure.subplots(2, 2).flat
    for axes, (k, varied) in zip(grid, enumerate(GROWTH), strict=True):
        rows = [row for row in report["points"] if row["varied"] == varied]
        memory = _panel(axes, rows)
        if k % 2 == 0:
            axes.set_ylabel("ms per flight-second (blue)")
        else:
            memory.set_ylabel("Memory [MiB] (orange)")
    figure.supxlabel(
        f"{report['machine']['processor']}; medians of rounds ({report['rounds']}), "
        "bars from lowest to highest", fontsize=7, color=INK,
    )  # fmt: skip
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.growth", description=__doc__)
    parser.add_argument("--rounds", type=int, default=3, help="default 3")
    parser.add_argument("--threads", type=int, default=2, help="cores to use, default 2")
    parser.add_argument("--estimator", choices=("complementary", "kalman"), default="complementary")
    parser.add_argument("--quick", action="store_true", help="tiny, to see that all works")
    parser.add_argument("--out", type=Path, default=Path("growth"), help="folder, default growth")
    given = parser.parse_args()
    usual = {**USUAL, "flights": 8} if given.quick else USUAL
    described, rounds = machine(given.threads), 1 if given.quick else given.rounds
    try:
        found = measured(
            points(QUICK if given.quick else GROWTH, usual), rounds, given.threads, given.estimator
        )
    except Failed as why:
        raise SystemExit(f"a flight failed: {why}") from None
    report = {
        "machine": described, "rounds": rounds, "usual": usual, "estimator": given.estimator,
        "points": found,
    }  # fmt: skip
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "growth.json").write_text(json.dumps(report, indent=2) + "\n")
    (given.out / "growth.md").write_text(markdown(report))
    save(growth_figure(report), given.out / "growth")
    print(markdown(report))


if __name__ == "__main__":
    main()
