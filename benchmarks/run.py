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
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numba

from benchmarks import c_reference, packed, startup
from benchmarks.c_reference import Reference, disagreement
from benchmarks.job import Lanes, Single, reference_model, starts
from benchmarks.mujoco_model import Rollout
from springback.simulation.flight import LANES

FLIGHTS, WIDTHS, THREADS = 1024, (8, 16, 32), 2
UNTIL, LONG = 0.1, 2.0  # [s] of the many flights, of the single one
AGREEMENT = 1e-9

#: What our lanes are compared with, and the ratio that they should reach.
TARGETS = {
    "MuJoCo implicitfast": 40.0,
    "MuJoCo implicitfast, measuring": 40.0,
    "MuJoCo implicitfast, spheres": None,
    "MuJoCo RK4": None,
    "C, lanes of 4": 0.75,
    "C, lanes of 8": None,
    "C, scalar": None,
    **{f"lanes of {width}": None for width in WIDTHS if width != LANES},
}
SINGLE_TARGET = 1.0  # [µs a step]
_C_NAMES = {1: "C, scalar", 4: "C, lanes of 4", 8: "C, lanes of 8"}


class Speed(NamedTuple):
    """Of a program in one round."""

    wall: float  # steps a second
    busy: float  # steps a second of processor time, all threads together


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
        say: Called with what is missing.
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
        measuring = Rollout(model, states, "implicitfast", steps, THREADS, measuring=True)
        measured["MuJoCo implicitfast, measuring"] = measuring.run
        spheres = Rollout(model, states, "implicitfast", steps, THREADS, "sphere")
        measured["MuJoCo implicitfast, spheres"] = spheres.run
    else:
        say("mujoco is missing: no comparison with MuJoCo")
    return measured


def measure(
    measured: dict[str, Callable[[], float]], rounds: int, say: Callable[[str], None]
) -> dict[str, list[Speed]]:
    """Speeds of every program in every round, interleaved.

    Steps per second of processor time are what is left of the speed when others use the machine.
    """
    samples: dict[str, list[Speed]] = {name: [] for name in measured}
    for k in range(rounds):
        for name, run in measured.items():
            wall, busy = time.perf_counter(), time.process_time()
            speed = run()
            wall, busy = time.perf_counter() - wall, time.process_time() - busy
            samples[name].append(Speed(speed, speed * wall / busy))
        say(f"round {k + 1} of {rounds}")
    return samples


def _ratio(samples: dict[str, list[Speed]], ours: str, theirs: str) -> Speed:
    """Median over the rounds of the ratio within a round."""
    pairs = list(zip(samples[ours], samples[theirs], strict=True))
    return Speed(
        statistics.median(a.wall / b.wall for a, b in pairs),
        statistics.median(a.busy / b.busy for a, b in pairs),
    )


def ratios(samples: dict[str, list[Speed]]) -> list[dict[str, Any]]:
    """Ours over theirs, each with its target."""
    default = f"lanes of {LANES}"
    rows: list[dict[str, Any]] = []
    for theirs, target in TARGETS.items():
        if theirs in samples:
            ratio = _ratio(samples, default, theirs)
            reached = None if target is None else ratio.wall >= target
            rows.append(
                {"ratio": f"{default} / {theirs}", "wall": ratio.wall, "busy": ratio.busy}
                | {"target": target, "reached": reached}
            )
    return rows


def table(report: dict[str, Any]) -> str:
    """The report as text."""
    lines = [f"{key:14}{value}" for key, value in report["machine"].items()]
    lines += [
        "",
        f"{'':32}{'million steps/s':>16}{'lowest':>9}{'highest':>9}{'per busy second':>17}",
    ]
    for name, row in report["steps per second"].items():
        note = f"   {1e6 / row['median']:.2f} us a step" if name == "single flight" else ""
        figures = (row[k] / 1e6 for k in ("median", "lowest", "highest", "busy"))
        lines.append(f"{name:32}" + "{:16.3f}{:9.3f}{:9.3f}{:17.3f}".format(*figures) + note)
    lines += ["", f"{'':44}{'ratio':>8}{'per busy second':>17}{'target':>9}"]
    for row in report["ratios"]:
        target = "" if row["target"] is None else f">= {row['target']:g}"
        mark = {None: "", True: "reached", False: "MISSED"}[row["reached"]]
        values = f"{row['wall']:8.2f}{row['busy']:17.2f}"
        lines.append(f"{row['ratio']:44}{values}{target:>9}  {mark}")
    single = report["steps per second"]["single flight"]["median"]
    mark = "reached" if 1e6 / single <= SINGLE_TARGET else "MISSED"
    lines.append(f"{'single flight, us a step':44}{1e6 / single:8.2f}{'<= 1':>26}  {mark}")
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
                "median": statistics.median(speed.wall for speed in values),
                "lowest": min(speed.wall for speed in values),
                "highest": max(speed.wall for speed in values),
                "busy": statistics.median(speed.busy for speed in values),
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
