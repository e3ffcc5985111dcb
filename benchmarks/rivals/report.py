"""What a contest found: medians, spreads and ratios, as JSON and as Markdown."""

from __future__ import annotations

import os
import platform
import statistics
from collections.abc import Mapping, Sequence
from typing import Any

from benchmarks.rivals import impacts
from benchmarks.rivals.contenders import STEP
from benchmarks.run import processor

#: Ratios that are asked for: ours, the rival's (the fastest whose name so begins), least [-].
#: A free flight is compared with our collision, which is the harder thing to do.
WANTED = (
    ("springback, run-up, impact, recovery, complementary", "RotorPy, one by one", 1000.0),
    ("springback, run-up, impact, recovery, complementary", "RotorPy, batches", None),
    ("springback, run-up, impact, recovery, complementary", "Crazyflow, contact flags", 1.0),
    ("springback, run-up, impact, recovery, complementary", "Crazyflow, floor only", None),
    ("springback, run-up, impact, recovery, complementary", "gym-pybullet-drones", None),
    ("springback, step, complementary", "RotorPy, one by one", None),
    ("springback, step, complementary", "RotorPy, batches", None),
    ("springback, step, complementary", "Crazyflow, contact flags", None),
    ("springback, step, complementary", "Crazyflow, floor only", None),
    ("springback, step, complementary", "gym-pybullet-drones", None),
    ("springback, impact, coarsest step within 1 %", "MuJoCo rollout", 40.0),
    ("springback, impact, default step", "MuJoCo rollout", None),
)
COLUMNS = ("flights per second", "latency", "import", "first flight", "memory")


def machine(threads: int) -> dict[str, str]:
    """What the figures were taken on."""
    return {
        "processor": f"{processor()}, {os.cpu_count()} cores, {threads} used",
        "system": platform.platform(),
        "python": platform.python_version(),
        "load before": ", ".join(f"{x:.2f}" for x in os.getloadavg()),
    }


def horizon(kind: str) -> float:
    """Of a flight [s]."""
    return impacts.HORIZON if kind == "impact" else float(STEP["duration"])


def spread(values: Sequence[float]) -> dict[str, float]:
    """Median, lowest and highest."""
    return {"median": statistics.median(values), "lowest": min(values), "highest": max(values)}


def summarised(found: Mapping[str, Any]) -> dict[str, Any]:
    """Every contender's medians and spreads over the rounds, and the ratios within them."""
    contenders = {}
    for name, row in found["contenders"].items():
        rounds = row["rounds"]
        if not rounds:
            continue
        figures = {column: spread([one[column] for one in rounds]) for column in COLUMNS}
        long = horizon(row["kind"])
        figures["flight-seconds per second"] = {
            key: long * value for key, value in figures["flights per second"].items()
        }
        contenders[name] = {**row, "figures": figures}
    return {**found, "contenders": contenders, "ratios": ratios(contenders)}


def _best(contenders: Mapping[str, Any], start: str) -> str | None:
    """The fastest of those whose names begin so, in seconds of flight per second."""
    named = [name for name in contenders if name.startswith(start)]
    if not named:
        return None
    return max(named, key=lambda n: contenders[n]["figures"]["flight-seconds per second"]["median"])


def ratios(contenders: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Ours over theirs, in seconds of flight per second, each within a round; then the median."""
    made = []
    for ours, start, least in WANTED:
        theirs = _best(contenders, start)
        if ours not in contenders or theirs is None:
            continue
        a, b = contenders[ours], contenders[theirs]
        scale = horizon(a["kind"]) / horizon(b["kind"])
        pairs = zip(a["rounds"], b["rounds"], strict=True)
        key = "flights per second"
        found = spread([scale * one[key] / other[key] for one, other in pairs])
        made.append(
            {"ours": ours, "theirs": theirs, **found, "wanted": least}
            | {"reached": None if least is None else found["median"] >= least}
        )
    return made


def _figure(value: float) -> str:
    """Three digits, thousands apart."""
    if value >= 1000.0:
        return f"{float(f'{value:.3g}'):,.0f}".replace(",", " ")
    return f"{value:.3g}"


def _duration(seconds: float) -> str:
    return f"{_figure(1e3 * seconds)} ms" if seconds < 1.0 else f"{_figure(seconds)} s"


def _within(found: Mapping[str, float]) -> str:
    lowest, highest = _figure(found["lowest"]), _figure(found["highest"])
    return f"{_figure(found['median'])} ({lowest} to {highest})"


KINDS = {
    "flight": "Hover, then a set-point 1 m ahead, with a pilot",
    "collision": "Run-up, impact and recovery, with a pilot",
    "impact": "Impacts, rotors at hovering thrust, equal accuracy",
}


def _table(kind: str, rows: Mapping[str, Any]) -> list[str]:
    lines = [
        f"## {KINDS[kind]}: {horizon(kind):g} s a flight",
        "",
        "| | flight-seconds per second | one flight alone | first flight of a process | "
        "memory | at once |",
        "|:---|---:|---:|---:|---:|---:|",
    ]
    key = "flight-seconds per second"
    ordered = sorted(rows.items(), key=lambda item: -item[1]["figures"][key]["median"])
    for name, row in ordered:
        f = row["figures"]
        processes, flights = row["best"]
        at_once = f"{flights}" + (f" in {processes} processes" if processes > 1 else "")
        lines.append(
            f"| {name} | {_within(f[key])} | {_duration(f['latency']['median'])} "
            f"| {_duration(f['first flight']['median'])} "
            f"| {_figure(f['memory']['median'])} MiB | {at_once} |"
        )
    return [*lines, ""]


def _ratio_table(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    lines = [
        "## Ratios", "",
        "| ours | theirs, the fastest | as many seconds of flight per second | wanted |",
        "|:---|:---|---:|---:|",
    ]  # fmt: skip
    marks = {None: "", True: "reached", False: "**missed**"}
    for row in rows:
        wanted = "" if row["wanted"] is None else f"≥ {row['wanted']:g}, {marks[row['reached']]}"
        lines.append(f"| {row['ours']} | {row['theirs']} | {_within(row)} | {wanted} |")
    return [*lines, ""]


def _accuracy(found: Mapping[str, Any]) -> list[str]:
    lines = [
        "## Accuracy of impacts",
        "",
        f"Coarsest step with which restitution, peak acceleration and contact time of the worst of "
        f"{impacts.JUDGED} hits are within {impacts.TOLERANCE:.0%} of what the program converges "
        "to:",
        "",
        "| | step | " + " | ".join(f"error of {name}" for name in impacts.METRICS) + " |",
        "|:---|---:|" + "---:|" * len(impacts.METRICS),
    ]
    for name, row in found.items():
        if "step" in row:
            errors = " | ".join(f"{100.0 * x:.2g} %" for x in row["worst errors"])
            lines.append(f"| {name} | {1e3 * row['step']:g} ms | {errors} |")
    agreed = found.get("theirs over ours, converged")
    if agreed:
        said = "; ".join(
            f"{name} {row['median']:.4f} ({row['lowest']:.2f} to {row['highest']:.2f})"
            for name, row in agreed.items()
        )
        lines += [
            "",
            f"MuJoCo's converged value over ours, median over the hits and range: {said}. Its law "
            "of contact is another one, its constants are fitted to ours.",
        ]
    return [*lines, ""]


def _sweeps(contenders: Mapping[str, Any]) -> list[str]:
    """What every number of flights and processes gave, once, before the rounds."""
    lines = ["## Numbers of flights tried", "", "| | flight-seconds per second, once each |"]
    lines.append("|:---|:---|")
    for name, row in contenders.items():
        said = []
        for tried in row["sweep"]:
            shared = f" in {tried['processes']} processes" if tried["processes"] > 1 else ""
            rate = _figure(horizon(row["kind"]) * tried["rate"])
            said.append(f"{tried['flights']}{shared}: {rate}")
        lines.append(f"| {name} | {'; '.join(said)} |")
    return [*lines, ""]


def _conditions(report: Mapping[str, Any]) -> list[str]:
    lines = ["## What differs", "", "| | rates | differs from ours | versions |"]
    lines.append("|:---|:---|:---|:---|")
    for name, row in report["contenders"].items():
        versions = ", ".join(f"{k} {v}" for k, v in row["versions"].items())
        missed = row.get("missed")
        ended = f"; ends {1e3 * missed:.0f} mm from its target" if missed is not None else ""
        outcomes = row.get("outcomes") or {}
        counted = ", ".join(f"{count} {word}" for word, count in outcomes.items())
        differs = row["differs"] + ended + (f"; outcomes: {counted}" if counted else "")
        lines.append(f"| {name} | {row['rates']} | {differs} | {versions} |")
    for name, why in report["skipped"].items():
        lines.append(f"| {name} | | **left out**: {why} | |")
    return [*lines, ""]


def markdown(report: Mapping[str, Any]) -> str:
    """The report to read."""
    lines = ["# springback and its rivals", ""]
    if report["quick"]:
        lines += ["A quick run, to see that all works: **its figures mean nothing.**", ""]
    lines += [f"- {key}: {value}" for key, value in report["machine"].items()]
    lines += [
        f"- rounds: {report['rounds']}; in each all take part one after another, in fresh "
        "processes; medians, with the lowest and highest in brackets",
        "- rivals: compiled and warm, set up before the clock runs; the fastest of the numbers of "
        "flights and processes tried; memory of all processes together",
        "",
    ]
    for kind in KINDS:
        rows = {n: row for n, row in report["contenders"].items() if row["kind"] == kind}
        if rows:
            lines += _table(kind, rows)
    if report["ratios"]:
        lines += _ratio_table(report["ratios"])
    if report["accuracy"]:
        lines += _accuracy(report["accuracy"])
    for name, cold in report["cold start"].items():
        lines.append(
            f"- {name}: with nothing compiled yet, the first flight ends after "
            f"{_duration(cold['first flight'])}"
        )
    for name, made in report["installed"].items():
        lines.append(
            f"- {name}: installing took {_duration(made['seconds'])}, {_figure(made['MiB'])} MiB"
        )
    return "\n".join([*lines, "", *_sweeps(report["contenders"]), *_conditions(report)])
