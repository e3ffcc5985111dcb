"""One flight with sensors, pilot and rotors: ``python -m benchmarks.closed_loop``.

A hover of ten seconds, compiled and warm, without trajectory, with each estimator; where its time
goes; and RotorPy's loop with the same vehicle for as long, alternating with ours in one run.
RotorPy is looked for here, or in another environment::

    python -m benchmarks.closed_loop --rotorpy-python /path/to/bin/python
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numba
import numpy as np

from benchmarks.rivals.vehicle import quad
from springback.kernels.layout import Buffer
from springback.scenario.avionics import build_avionics
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import empty_log, flight_buffers, shape_of
from springback.simulation.guided import (
    GuidedFlight,
    avionics_buffers,
    fly_guided,
    ticks_of,
)
from springback.simulation.noise import noise_table
from springback.simulation.onboard import Draw
from springback.simulation.ticks import (
    GUST_NOISE,
    FlightBuffers,
    FlightLog,
    Layouts,
    drive_rotors,
    layouts_of,
    sense_and_decide,
)

ESTIMATORS = ("kalman", "complementary", "perfect")
DURATION = 10.0  # [s]
TARGET = 10.0  # [ms], with the default estimator
#: Of RotorPy's loop [Hz]: what its own examples take, and our clock.
RATES = (100.0, 1000.0)


class Job(NamedTuple):
    """A hover, ready to fly."""

    model: Any
    start: Any
    avionics: Any
    draws: tuple[Draw, ...]
    ticks: int


def job(estimator: str, duration: float = DURATION) -> Job:
    """Quad holding its place, default sensors."""
    scenario = scenario_from(
        {
            "vehicle": "quad",
            "reference": {"type": "hold"},
            "start": {"position": [0.0, 0.0, 1.0]},
            "estimator": {"type": estimator},
            "simulation": {"duration": duration},
        }
    )
    model, start = scenario.flight_model(), scenario.start_state()
    built_avionics = build_avionics(scenario, model, start)
    ticks = ticks_of(model.timing.until, built_avionics.avionics.systems.period)
    return Job(model, start, built_avionics.avionics, built_avionics.noise, ticks)


def noise_stream(job: Job) -> Any:
    return noise_table(0, 0, job.ticks, job.draws)


def whole(job: Job) -> None:
    """The flight, its noise included."""
    flight = GuidedFlight(job.model, job.start, job.avionics)
    fly_guided(flight, noise_stream(job), trace=False)


@numba.njit(nogil=True)
def _looking(layouts: Layouts, buffers: FlightBuffers, noise: Buffer, log: FlightLog) -> None:
    for k in range(noise.shape[0]):
        sense_and_decide(layouts, buffers, k, noise[k], log)


@numba.njit(nogil=True)
def _driving(
    layouts: Layouts, buffers: FlightBuffers, noise: Buffer, log: FlightLog, duration: float
) -> None:
    for k in range(noise.shape[0]):
        drive_rotors(layouts, buffers, k, noise[k], log, duration)


def parts(job: Job) -> dict[str, Callable[[], None]]:
    """Parts of the loop by themselves, over all ticks, at a constant state."""
    noise, shape = noise_stream(job), shape_of(job.model, job.start)
    timing = job.model.timing._replace(until=job.avionics.systems.period)
    short = job._replace(model=job.model._replace(timing=timing), ticks=1)
    b, g = flight_buffers(shape, [job.model], [job.start], 1), avionics_buffers([job.avionics], 1)
    layouts = layouts_of(shape, job.avionics, noise.shape[1] - GUST_NOISE)
    buffers, duration = FlightBuffers(b[0], g[0], (0,)), job.model.timing.until
    log = FlightLog(empty_log(), np.zeros((0, 1)))
    return {
        "setting up": lambda: whole(short),
        "noise table": lambda: (noise_stream(job), None)[1],
        "sensors and pilot": lambda: _looking(layouts, buffers, noise, log),
        "rotors and wind": lambda: _driving(layouts, buffers, noise, log, duration),
    }


def _milliseconds(run: Callable[[], Any]) -> float:
    began = time.perf_counter()
    run()
    return 1e3 * (time.perf_counter() - began)


def rotorpy(python: str, rate: float, rounds: int) -> dict[str, Any] | None:
    """Seconds of RotorPy's hovers in a process of its own; None if it is not there."""
    asked = {
        "vehicle": quad(), "duration": DURATION, "rate": rate, "rounds": rounds,
    }  # fmt: skip
    program = Path(__file__).with_name("rotorpy_hover.py")
    done = subprocess.run(
        [python, str(program)], input=json.dumps(asked), capture_output=True, text=True
    )
    if done.returncode:
        print(f"no RotorPy: {done.stderr.strip().splitlines()[-1]}", file=sys.stderr)
        return None
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def measure(rounds: int, python: str) -> dict[str, Any]:
    """Milliseconds of everything in every round, programs alternating."""
    jobs = {name: job(name) for name in ESTIMATORS}
    pieces = {name: parts(one) for name, one in jobs.items()}
    for name, one in jobs.items():  # compiles
        whole(one)
        for run in pieces[name].values():
            run()
    ours: dict[str, dict[str, list[float]]] = {
        name: {key: [] for key in ("total", *pieces[name])} for name in ESTIMATORS
    }
    theirs: dict[float, list[float]] = {rate: [] for rate in RATES}
    described: dict[str, Any] = {}
    for _ in range(rounds):
        for _ in range(5):  # ours are short: five of each for one of theirs
            for name, one in jobs.items():
                ours[name]["total"].append(_milliseconds(lambda one=one: whole(one)))  # type: ignore[misc]
                for key, run in pieces[name].items():
                    ours[name][key].append(_milliseconds(run))
        for rate in [*theirs]:
            found = rotorpy(python, rate, 1)
            if found is None:
                theirs.clear()
                break
            theirs[rate] += [1e3 * seconds for seconds in found["seconds"]]
            described |= {"version": found["version"], f"strayed, {rate:g} Hz": found["strayed"]}
    return {"ours": ours, "theirs": theirs, "rotorpy": described}


def table(report: dict[str, Any]) -> str:
    """The report as text."""
    lines = [f"{'hover of 10 s, milliseconds':40}{'median':>10}{'lowest':>10}"]
    compiled: dict[str, float] = {}
    for name, found in report["ours"].items():
        totals = [statistics.median(v) for v in found.values()], [min(v) for v in found.values()]
        rows = {key: (statistics.median(v), min(v)) for key, v in found.items()}
        rows["physics, by difference"] = (
            totals[0][0] - sum(totals[0][1:]), totals[1][0] - sum(totals[1][1:]),
        )  # fmt: skip
        outside = [k for k in rows if k in ("setting up", "noise table")]
        rows["compiled loop"] = tuple(
            rows["total"][k] - sum(rows[name][k] for name in outside) for k in (0, 1)
        )  # type: ignore[assignment]
        compiled[name] = rows["compiled loop"][0]
        for key, (median, lowest) in rows.items():
            lines.append(f"{name + ', ' + key:40}{median:10.2f}{lowest:10.2f}")
    default = report["ours"][ESTIMATORS[0]]["total"]
    median, lowest = statistics.median(default), min(default)
    for what, value in (("compiled loop", compiled[ESTIMATORS[0]]), ("total", median)):
        mark = "reached" if value <= TARGET else "MISSED"
        lines.append(f"{what} with {ESTIMATORS[0]}: {value:.1f} ms, target {TARGET:g} ms: {mark}")
    for rate, values in report["theirs"].items():
        theirs = statistics.median(values), min(values)
        lines.append(f"{f'RotorPy at {rate:g} Hz':40}{theirs[0]:10.0f}{theirs[1]:10.0f}")
        lines.append(
            f"{'  as many times as ours':40}{theirs[0] / median:10.0f}{theirs[1] / lowest:10.0f}"
        )
    lines += [f"RotorPy {key}: {value}" for key, value in report["rotorpy"].items()]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.closed_loop", description=__doc__)
    parser.add_argument("--rounds", type=int, default=5, help="rounds of all programs")
    parser.add_argument("--rotorpy-python", default=sys.executable, help="where RotorPy is")
    parser.add_argument("--json", type=Path, help="also write all figures to this file")
    given = parser.parse_args()
    report = measure(given.rounds, given.rotorpy_python)
    print(table(report))
    if given.json:
        given.json.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
