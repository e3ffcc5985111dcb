"""Speed against others, measured side by side in one run: ``python -m benchmarks.run``.

Every program flies the same 1024 flights, one program after the other in every round, so that a
change of the machine's mood meets all of them; medians over the rounds are compared.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import os
import platform
import statistics
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba

from benchmarks import c_reference, packed, startup
from benchmarks.c_reference import Reference, disagreement
from benchmarks.job import Lanes, Single, reference_model, starts
from benchmarks.mujoco_model import Rollout
from springback.simulation.flight import LANES

FLIGHTS, WIDTHS, THREADS = 1024, (8, 16, 32), 2
UNTIL, LONG = 0.1, 2.0  # [s] of the many flights, of the single one
AGREEMENT = 1e-9

#: Name of a ratio, its programs, what it should reach.
TARGETS = (
    ("lanes / MuJoCo implicitfast", "lanes", "MuJoCo implicitfast", 40.0),
    ("lanes / MuJoCo RK4", "lanes", "MuJoCo RK4", None),
    ("lanes / C, lanes of 4", "lanes", "C, lanes of 4", 0.75),
    ("lanes / C, lanes of 8", "lanes", "C, lanes of 8", None),
    ("lanes / C, scalar", "lanes", "C, scalar", None),
)
SINGLE_TARGET = 1.0  # [µs a step]
_C_NAMES = {1: "C, scalar", 4: "C, lanes of 4", 8: "C, lanes of 8"}


def processor() -> str:
    """The processor's own name."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def machine() -> dict[str, str]:
    """What the figures were taken on."""
    described = {
        "processor": f"{processor()}, {os.cpu_count()} cores, {THREADS} threads used",
        "system": platform.platform(),
        "python": platform.python_version(),
        "numba": numba.__version__,
        "load before": ", ".join(f"{x:.2f}" for x in os.getloadavg()),
    }
    if c_reference.compiler():
        described["C compiler"] = f"{c_reference.version()} {' '.join(c_reference.FLAGS[:3])}"
    if importlib.util.find_spec("mujoco"):
        import mujoco

        described["mujoco"] = mujoco.__version__
    return described


def programs(folder: Path, say: Callable[[str], None]) -> dict[str, Callable[[], float]]:
    """What can be measured here: name and a function that gives steps a second.

    Args:
        folder: For compiled C.
        say: Told of what is missing.
    """
    model = reference_model(until=UNTIL)
    states = starts(model, FLIGHTS)
    ours = {width: Lanes(model, states, width) for width in WIDTHS}
    measured: dict[str, Callable[[], float]] = {}
    for width, lanes in ours.items():
        lanes.run(THREADS)  # compiles
        measured[f"lanes of {width}"] = lambda lanes=lanes: lanes.run(THREADS).rate  # type: ignore[misc]

    long = Single(reference_model(until=LONG), states[0])
    long.run()
    measured["single flight"] = lambda: 1.0 / long.run()

    if c_reference.compiler():
        # Longer flights with free flight after the impact, so that arms settle and are locked, too.
        whole = reference_model(until=0.3, free_step=1e-3)
        known = {
            "impact": (model, ours[LANES].run(THREADS)),
            "impact and flight": (whole, Lanes(whole, states, LANES).run(THREADS)),
        }
        for count, name in _C_NAMES.items():
            for job, (flown, expected) in known.items():
                program = Reference(count, folder, flown, states)
                error, where = disagreement(expected, program.run(THREADS))
                if error > AGREEMENT:
                    raise SystemExit(f"{name}, {job}: {where} differs by {error:.1e}; no ratios")
                say(f"{name}, {job}: the same to {error:.1e} ({where})")
            program = Reference(count, folder, model, states)
            measured[name] = lambda program=program: program.run(THREADS).rate  # type: ignore[misc]
    else:
        say("gcc is missing: no comparison with C")

    if importlib.util.find_spec("mujoco"):
        steps = round(UNTIL / model.timing.impact_step)
        for integrator in ("implicitfast", "RK4"):
            rollout = Rollout(model, states, integrator, steps, THREADS)
            measured[f"MuJoCo {integrator}"] = rollout.run
    else:
        say("mujoco is missing: no comparison with MuJoCo")
    return measured


def measure(
    measured: dict[str, Callable[[], float]], rounds: int, say: Callable[[str], None]
) -> dict[str, list[float]]:
    """Steps a second of every program in every round, interleaved."""
    samples: dict[str, list[float]] = {name: [] for name in measured}
    for k in range(rounds):
        for name, run in measured.items():
            samples[name].append(run())
        say(f"round {k + 1} of {rounds}")
    return samples


def ratios(samples: dict[str, list[float]]) -> list[dict[str, Any]]:
    """Median over the rounds of each ratio within a round, with its target."""
    best = max(
        (name for name in samples if name.startswith("lanes of")),
        key=lambda name: statistics.median(samples[name]),
    )
    default = f"lanes of {LANES}"
    rows = []
    for text, ours, theirs, target in TARGETS:
        if theirs not in samples:
            continue
        assert ours == "lanes"
        pairs = zip(samples[default], samples[theirs], strict=True)
        ratio = statistics.median(a / b for a, b in pairs)
        reached = None if target is None else ratio >= target
        rows.append({"ratio": text, "value": ratio, "target": target, "reached": reached})
    best_ratio = statistics.median(
        a / b for a, b in zip(samples[best], samples[default], strict=True)
    )
    rows.append(
        {"ratio": f"best width ({best}) / {default}", "value": best_ratio, "target": None}
        | {"reached": None}
    )
    return rows


def table(report: dict[str, Any]) -> str:
    """The report as text."""
    lines = [f"{key:14}{value}" for key, value in report["machine"].items()]
    lines += ["", f"{'':28}{'million steps/s':>16}{'lowest':>9}{'highest':>9}"]
    for name, row in report["steps per second"].items():
        note = f"   {1e6 / row['median']:.2f} us a step" if name == "single flight" else ""
        figures = (row[k] / 1e6 for k in ("median", "lowest", "highest"))
        lines.append(f"{name:28}" + "{:16.3f}{:9.3f}{:9.3f}".format(*figures) + note)
    lines += ["", f"{'':34}{'ratio':>10}{'target':>10}"]
    for row in report["ratios"]:
        target = "" if row["target"] is None else f">= {row['target']:g}"
        mark = {None: "", True: "reached", False: "MISSED"}[row["reached"]]
        lines.append(f"{row['ratio']:34}{row['value']:10.2f}{target:>10}  {mark}")
    single = report["steps per second"]["single flight"]["median"]
    mark = "reached" if 1e6 / single <= SINGLE_TARGET else "MISSED"
    lines.append(f"{'single flight, us a step':34}{1e6 / single:10.2f}{'<= 1':>10}  {mark}")
    for kind in ("cold", "warm"):
        importing, first = report["start-up"][kind]
        lines.append(f"{kind} start: import {importing:.2f} s, first flight {first:.2f} s")
    counted = report["instructions"]
    if counted:
        lines.append(
            f"lanes of {counted['width']}: {counted['total'][0]} packed and {counted['total'][1]} "
            "scalar floating-point instructions; innermost loops (packed, scalar): "
            + ", ".join(f"({a}, {b})" for a, b in counted["loops"])
        )
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.run", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="two rounds only")
    parser.add_argument("--rounds", type=int, help="rounds of all programs; 7 unless quick")
    parser.add_argument("--json", type=Path, help="also write the report to this file")
    given = parser.parse_args()

    def say(text: str) -> None:
        print(text, file=sys.stderr, flush=True)

    described = machine()
    rounds = given.rounds or (2 if given.quick else 7)
    with tempfile.TemporaryDirectory() as folder:
        samples = measure(programs(Path(folder), say), rounds, say)
    say("start-up: empty cache, then full")
    cold, warm = startup.cold_and_warm()
    counted: dict[str, Any] = {}
    if platform.machine() in ("x86_64", "AMD64"):
        say("counting instructions")
        total, inner = packed.counts(LANES)
        counted = {"width": LANES, "total": total, "loops": inner}
    report = {
        "machine": described,
        "steps per second": {
            name: {
                "median": statistics.median(values),
                "lowest": min(values),
                "highest": max(values),
                "rounds": values,
            }
            for name, values in samples.items()
        },
        "ratios": ratios(samples),
        "start-up": {"cold": cold, "warm": warm},
        "instructions": counted,
    }
    print(table(report))
    if given.json:
        given.json.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
