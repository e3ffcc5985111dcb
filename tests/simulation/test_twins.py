"""Executors are twins: plain Python, one compiled flight, and lanes give the same bits.

One scalar source, every operation rounded as IEEE 754 says: so the comparison is for equality.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.impacts import towards_wall
from springback.kernels.layout import TreeLayout
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec, normalise
from springback.results.flight import as_scenario
from springback.simulation.executor import advance
from springback.simulation.flight import (
    FlightRecord,
    empty_log,
    flight_buffers,
    flight_records,
    fly_buffers,
    fly_many,
    fly_one,
    shape_of,
)
from springback.simulation.lanes import lanes_of, places
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State

#: Arms count as settled early, so that a short flight has all phases.
SHORT = (
    "simulation.duration=0.06",
    "simulation.impact_step=4e-4",
    "simulation.arm_tolerance=2 mm",
    "simulation.rate_tolerance=0.2 m/s",
    "world.obstacles[0].surface.stiffness=8e5",
    "world.obstacles[0].surface.slip_speed=1",
    "vehicle.arms.stiffness=20 N/mm",
    "vehicle.arms.damping=30",
)
VARIANTS = {
    "compliant, hybrid": (),
    "compliant, always free": ("model.arms=always-free",),
    "rigid": ("vehicle.arms.compliant=false",),
    "half rigid": ("vehicle.arms.compliant=[true, false, true, false]",),
}


def scene(speed: float, tilt: float, *overrides: str) -> tuple[Model, State]:
    """Model and start of a short tilted, spinning impact; the slow ones are the longer on their way."""
    start = {
        "position": [0.697, 0.0, 0.0],
        "pitch": tilt,
        "yaw": 0.4,
        "angular_velocity": [1, 2, 3],
    }
    scenario = as_scenario(towards_wall("arq", speed, **start), (*SHORT, *overrides))
    return scenario.flight_model(), scenario.start_state()


def same(a: FlightRecord, b: FlightRecord) -> bool:
    """Whether motion and record are the same, bit for bit."""
    return bool(
        np.array_equal(leaves(a.motion), leaves(b.motion))
        and np.array_equal(leaves(a.record), leaves(b.record))
    )


@pytest.mark.parametrize("overrides", VARIANTS.values(), ids=VARIANTS.keys())
def test_plain_python_is_the_compiled_flight(overrides: tuple[str, ...]) -> None:
    """Motion, ledger, record and the whole trajectory."""
    model, start = scene(2.5, 0.2, *overrides)
    plain, compiled = fly_one(model, start, executor="python"), fly_one(model, start)
    assert plain.record.contacts.total >= 1.0
    assert plain.record.first_impact.separation_time > 0.0
    assert same(plain, compiled)
    assert plain.trace is not None
    assert compiled.trace is not None
    assert np.array_equal(plain.trace.values, compiled.trace.values)


def fleet() -> tuple[list[Model], list[State]]:
    """Twenty flights of different speed and tilt, of all variants."""
    variants = list(VARIANTS.values())
    scenes = [scene(1.5 + 0.2 * k, -0.4 + 0.05 * k, *variants[k % 4]) for k in range(20)]
    models, starts = zip(*scenes, strict=True)
    return list(models), list(starts)


@pytest.fixture(scope="module")
def alone() -> list[FlightRecord]:
    """Each flight of the fleet by itself."""
    return [fly_one(model, start, trace=False) for model, start in zip(*fleet(), strict=True)]


@pytest.mark.parametrize("width", [1, 4, 16])
def test_a_flight_in_lanes_is_the_flight_alone(width: int, alone: list[FlightRecord]) -> None:
    """Whatever flies beside it, whenever that ends, and with lanes to spare."""
    models, starts = fleet()
    abreast = fly_many(models, starts, width=width)
    assert len(abreast) == len(alone)
    assert len({flown.record.stepping.steps for flown in alone}) > 10
    for one, other in zip(alone, abreast, strict=True):
        assert same(one, other)


def test_a_finished_flight_keeps_its_bits_while_others_fly_on() -> None:
    """Not even its quaternion is normalised again; that would move it by a rounding now and then."""
    rng = np.random.default_rng(5)
    models, starts = [], []
    for k in range(64):
        model, start = scene(2.0, 0.0)
        q = Quat(*(float(x) for x in rng.normal(size=4)))
        until = 0.06 if k % 4 == 0 else 2e-3
        timing = model.timing._replace(until=until, free_step=5e-4)
        away = start._replace(attitude=normalise(q), position=Vec(-5.0, 0.0, 0.0))
        models.append(model._replace(timing=timing))
        starts.append(away)
    for k, flown in nonempty(enumerate(fly_many(models, starts, width=4))):
        assert same(flown, fly_one(models[k], starts[k], trace=False))


@pytest.mark.parametrize("width", [1, 4])
def test_nothing_is_read_before_it_is_written(width: int, alone: list[FlightRecord]) -> None:
    """Rates, sums and views are outputs: filled with infinity beforehand, they change no bit."""
    models, starts = fleet()
    shape = shape_of(models[0], starts[0])
    buffers = flight_buffers(shape, models, starts, width)
    at = places(shape, width)
    lanes = buffers.reshape(len(buffers), -1, width)
    lanes[:, at.total : at.record] = np.inf
    fly_buffers(shape, buffers, width)
    for one, other in nonempty(
        zip(alone, flight_records(shape, models, starts, buffers, width), strict=True)
    ):
        assert same(one, other)


def test_lanes_in_plain_python() -> None:
    """The loop over lanes itself, uncompiled, flies each lane as if it were alone."""
    models, starts = (part[:2] for part in fleet())
    shape = shape_of(models[0], starts[0])
    buffers = flight_buffers(shape, models, starts, 2)
    loop: Any = getattr(advance, "py_func", advance)
    assert loop(TreeLayout(shape), buffers, (0, 0), empty_log(), 100_000, 0.0) == 0
    for k, flown in enumerate(flight_records(shape, models, starts, buffers, 2)):
        assert same(flown, fly_one(models[k], starts[k], trace=False))


def test_interrupted_and_continued_is_the_same_flight() -> None:
    """A flight advanced a few steps at a time ends with the same bits: nothing hides between calls."""
    model, start = scene(2.0, 0.1)
    shape = shape_of(model, start)
    buffers = flight_buffers(shape, [model], [start], 1)
    calls = 1
    while advance(TreeLayout(shape), buffers, lanes_of(1), empty_log(), 7, 0.0):
        calls += 1
    assert calls > 10
    again = flight_records(shape, [model], [start], buffers, 1)[0]
    assert same(again, fly_one(model, start, trace=False))


@pytest.mark.parametrize("budget", [100_000, 37])
def test_flights_that_change_lanes_come_home_with_the_same_bits(
    budget: int, alone: list[FlightRecord]
) -> None:
    """Groups lend each other flights, also when they are interrupted; each ends where it began."""
    models, starts = fleet()
    shape = shape_of(models[0], starts[0])
    buffers = flight_buffers(shape, models, starts, 4)
    while advance(TreeLayout(shape), buffers, (0,) * 4, empty_log(), budget, 0.0):
        pass
    for one, other in nonempty(
        zip(alone, flight_records(shape, models, starts, buffers, 4), strict=True)
    ):
        assert same(one, other)


def test_lanes_are_kept_full() -> None:
    """Flights that end early make room for those of other groups.

    Each group has one flight that is by far the longest; without changes of lanes each would take
    that flight's steps.  Five long flights in four lanes need two fifths of all those.
    """
    models, starts = fleet()
    brief = [m._replace(timing=m.timing._replace(until=0.004)) for m in models]
    mixed = [m if k % 4 == 0 else b for k, (m, b) in enumerate(zip(models, brief, strict=True))]
    longest = [
        fly_one(mixed[k], starts[k], trace=False).record.stepping.steps for k in range(0, 20, 4)
    ]
    shape = shape_of(mixed[0], starts[0])
    buffers = flight_buffers(shape, mixed, starts, 4)
    half = int(sum(longest)) // 2
    assert len(longest) == len(buffers) == 5
    assert advance(TreeLayout(shape), buffers, (0,) * 4, empty_log(), half, 0.0) == 0
