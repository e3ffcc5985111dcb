"""Do the intervals of fits cover, and are errors of the model said?  Synthetic slider impacts.

    python studies/identification.py --sets 200 [--rows quad,arq] [--processes 2]

Every set is flown with springback's sensors, recorded, cut, and fitted as a log would be; priors
are displaced as often as they say.  The noise is white and the law the true one unless a row says
otherwise: this is the best case.
"""

from __future__ import annotations

import argparse
import copy
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from typing import Any, NamedTuple

import numpy as np

from springback.batch.workers import end_with_parent, single_threads
from springback.identification.design.coverage import (
    SyntheticFit,
    coverage_of,
    displaced_fields,
    fitted_set,
    synthetic_fits,
)
from springback.identification.estimates import field_estimates
from springback.identification.fits import fields_of_plan, result_of
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import ImpactFit
from springback.logs.recording import ARM_LENGTH, POSITION, SPECIFIC_FORCE, Recording
from springback.scenario.scenario import scenario_from

STIFFNESS, LOSS = "world.obstacles.0.surface.stiffness", "world.obstacles.0.surface.dissipation"
#: Reach of the front cages along X, level, and free way to the wall [m].
REACH, WAY = 0.30 * 2.0**-0.5, 0.6
IMPACTS, SCATTER = 5, 0.10


class Row(NamedTuple):
    """One row of the table."""

    vehicle: str
    speed: float  # [m/s]
    text: str
    corrupt: str = ""
    plan: dict[str, Any] | None = None
    noise: float = 0.5 / 500.0**0.5  # of the accelerometer: 0.5 m/s² a sample at 1 kHz
    drag: float = 0.0  # of the true rail at that speed, linear in it [m/s²]


ROWS = {
    "quad": Row("quad", 1.85, "clip modelled"),
    "quad-ignored": Row(
        "quad", 1.85, "clip ignored", plan={"sensors": {"accelerometer": {"full_scale": 1e4}}}
    ),
    "quad-mocap": Row("quad", 1.85, "motion capture only", "no imu"),
    "quad-imu": Row("quad", 1.85, "accelerometer only", "no mocap"),
    "arq": Row("arq", 1.85, "accelerometer and motion capture"),
    "arq-fast": Row("arq", 3.5, "clips, modelled"),
    "arq-ignored": Row(
        "arq", 3.5, "clip ignored", plan={"sensors": {"accelerometer": {"full_scale": 1e4}}}
    ),
    "arq-rotors": Row("arq", 1.85, "rotors on: coloured noise of 5 m/s²", "rotors"),
    "arq-lost": Row("arq", 1.85, "every fifth frame lost", "lost"),
    "arq-arms": Row("arq", 1.85, "with arm lengths, 1 kHz, exact", "arms"),
    "average": Row("arq", 1.85, "5 ms average, not told", "average"),
    "scale": Row("arq", 1.85, "accelerometer 3 % too large", "scale"),
    "clocks": Row("arq", 1.85, "clocks 3 ms apart, taken for one", "clocks"),
    "drag": Row("arq", 1.85, "drag of the rail, 0.5 m/s², not told", drag=0.5),
}


def tables(row: Row) -> dict[str, Any]:
    """Scenario of a slider impact."""
    return {
        "vehicle": {"preset": f"{row.vehicle}-slider"},
        "world": {"obstacles": [{
            "type": "wall", "distance": 2.0,
            "surface": {"preset": "wall", "shared_by": 2, "dissipation": 0.432,
                        "friction_axes": "vertical"},
        }]},
        "start": {"position": [2.0 - REACH - WAY, 0.0, 1.0], "velocity": [row.speed, 0.0, 0.0]},
        "model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": WAY / row.speed + 0.3},
        "sensors": {
            "imu": {"accelerometer": {"noise": row.noise}},
            "motion_capture": {"position_noise": 5e-4},
            "hall": {"perfect": True},
        },
    }  # fmt: skip


def plan_of(row: Row) -> FitPlan:
    """Plan of a row: two fields of Quad, four of ARQ, each to a factor of 4."""
    free = {STIFFNESS: "factor 4", LOSS: "factor 4"}
    exact = {"vehicle.body.mass": "exact", "vehicle.arms.directions": "exact"}
    if row.vehicle == "arq":
        free |= {"vehicle.arms.stiffness": "factor 4", "vehicle.arms.damping": "factor 4"}
        exact["vehicle.arms.mass"] = "exact"
    return FitPlan.model_validate(
        {"scenario": "rig.toml", "free": free, "known": exact, **(row.plan or {})}
    )


def corrupted(recording: Recording, how: str, seed: int) -> Recording:
    """A recording as a sensor that the plan does not know would give it."""
    channels = []
    generator = np.random.default_rng(seed)
    for one in recording.channels:
        force, track = one.quantity == SPECIFIC_FORCE, one.quantity == POSITION
        if one.quantity == ARM_LENGTH and how != "arms":
            continue
        aboard = one.clock == "log"
        if (how == "no imu" and aboard) or (how == "no mocap" and not aboard):
            continue
        if how == "average" and force:
            means = [np.convolve(x, np.full(5, 0.2))[: len(x)] for x in one.values.T]
            one = replace(one, values=np.stack(means, axis=1))
        if how == "scale" and force:
            one = replace(one, values=1.03 * one.values)
        if how == "clocks" and one.clock != "log":
            one = replace(one, clock="log", times=one.times + 3e-3)
        if how == "rotors" and force:
            one = replace(one, values=one.values + _rotor_noise(one.times, generator))
        if how == "lost" and track:
            lost = generator.random(len(one.times)) < 0.2
            one = replace(one, values=np.where(lost[:, None], np.nan, one.values))
        channels.append(one)
    return replace(recording, channels=tuple(channels))


def _rotor_noise(times: Any, generator: np.random.Generator) -> Any:
    """Two lines of rotors at 90 and 97 Hz, and noise between 50 and 150 Hz, of 5 m/s² in all."""
    phases = generator.uniform(0.0, 2.0 * np.pi, (2, 3))
    lines = sum(
        np.sin(2.0 * np.pi * f * times[:, None] + phase) * 2.0
        for f, phase in zip((90.0, 97.0), phases, strict=True)
    )
    white = generator.standard_normal((len(times), 3))
    spectrum = np.fft.rfft(white, axis=0)
    f = np.fft.rfftfreq(len(times), float(np.median(np.diff(times))))
    spectrum[(f < 50.0) | (f > 150.0)] = 0.0
    band = np.fft.irfft(spectrum, len(times), axis=0)
    return lines + band / band.std() * (25.0 - 4.0) ** 0.5


def one_set(given: tuple[str, int]) -> SyntheticFit:
    """One set of a row."""
    name, seed = given
    row = ROWS[name]
    base, plan = tables(row), plan_of(row)
    fields = fields_of_plan(plan, scenario_from(copy.deepcopy(base)))
    truth = copy.deepcopy(base)
    if row.drag:
        mass = scenario_from(copy.deepcopy(base)).vehicle.mass
        truth["air"] = {"rotor_drag": [row.drag * mass / row.speed, 0.0, 0.0]}
    return fitted_set(plan, base, fields, seed, truth=truth,
                      corrupt=lambda r: corrupted(r, row.corrupt, seed))  # fmt: skip


def scattered_set(seed: int) -> dict[str, float]:
    """Five impacts of Quad whose stiffness differs by 10 %, fitted as one plan would be."""
    row, generator = ROWS["quad"], np.random.default_rng(seed)
    base, plan = tables(row), plan_of(row)
    fields = fields_of_plan(plan, scenario_from(copy.deepcopy(base)))
    displaced, fits = displaced_fields(fields, generator), list[ImpactFit]()
    for k, logarithm in enumerate(np.log(2e5) + SCATTER * generator.standard_normal(IMPACTS)):
        truth = copy.deepcopy(base) | {"seed": IMPACTS * seed + k}
        truth["world"]["obstacles"][0]["surface"]["stiffness"] = float(np.exp(logarithm))
        truth["start"]["offset"] = [-0.01 * float(generator.random()), 0.0, 0.0]
        fits += synthetic_fits(plan, base, displaced, truth, f"impact {k}",
                               corrupt=lambda r: corrupted(r, "", 0))  # fmt: skip
    result = result_of(plan, fits)
    [found] = [one for one in result.estimates if one.unknown.name == STIFFNESS]
    [without] = [
        one for one in field_estimates(fits, scatter=False) if one.unknown.name == STIFFNESS
    ]
    assert found.pooled is not None
    return {
        "impacts": float(len(fits)),
        "covered": float(found.low <= 2e5 <= found.high),
        "covered_without": float(without.low <= 2e5 <= without.high),
        "warned": float(any(f"{STIFFNESS} differs" in text for text in result.sentences)),
        "half_width": 0.5 * float(np.log(found.high / found.low)),
        "half_width_without": 0.5 * float(np.log(without.high / without.low)),
        "scatter": found.pooled.scatter * found.unknown.deviation,
        "misfit": float(any(one.is_misfit for one in result.misfits)),
    }  # fmt: skip


def print_row(name: str, outcomes: Sequence[SyntheticFit]) -> None:
    """Print a row of the table."""
    row = ROWS[name]
    fields = fields_of_plan(plan_of(row), scenario_from(tables(row)))
    found = coverage_of(fields, outcomes)
    cells = []
    for one in found.fields:
        errors = [o.errors[one.name] for o in outcomes if not o.problem]
        deviation = next(f.deviation for f in fields if f.name == one.name)
        bias = 100.0 * (np.exp(float(np.median(errors)) * deviation) - 1.0)
        cells.append(
            f"{one.name.rpartition('.')[2]} {51.0 * one.half_width:.2f} "
            f"({100.0 * one.share:.1f}; {bias:+.2f}; {one.spread:.2f})"
        )
    clock = 1e3 * found.latents.get("clock offset", float("nan"))
    print(
        f"| {row.vehicle} {row.speed:g} m/s | {row.text} | {', '.join(cells)} | {clock:.3f} | "
        f"{100.0 * found.alarms / found.sets:.1f} | {len(found.failed)} | "
        f"{found.seconds / found.sets:.1f} |", flush=True,
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sets", type=int, default=200)
    parser.add_argument("--rows", default=",".join(ROWS))
    parser.add_argument("--scattered", type=int, default=60, help="sets of five impacts")
    parser.add_argument("--processes", type=int, default=1)
    given = parser.parse_args()
    print("se in % (cover of 95 % in %; median error in %; scatter over se); clocks' se in ms; "
          "misfits said in %; without a fit; seconds each")  # fmt: skip
    begun = time.time()
    pool = ProcessPoolExecutor(given.processes, get_context("spawn"), end_with_parent)
    with single_threads(), pool:
        for name in filter(None, given.rows.split(",")):
            jobs = [(name, seed) for seed in range(given.sets)]
            print_row(name, list(pool.map(one_set, jobs)))
        if given.scattered:
            sets = list(pool.map(scattered_set, range(given.scattered)))
            means = {key: float(np.mean([one[key] for one in sets])) for key in sets[0]}
            print(f"five impacts, scatter of 10 %, {len(sets)} sets:", means)
    print(f"{time.time() - begun:.0f} s")


if __name__ == "__main__":
    main()
