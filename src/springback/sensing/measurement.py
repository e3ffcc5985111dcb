"""Measurements for a pilot, and estimates from them.

All devices run on a clock of equal ticks.  Those that are slower than the clock flag a new sample
by `fresh`; in between their last sample is repeated.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.angles import floor
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.vectors import Quat, Vec
from springback.simulation.onboard import SensorStep as SensorStep
from springback.simulation.onboard import Truth as Truth
from springback.simulation.onboard import sensor_step as sensor_step
from springback.simulation.ticks import Lanes


class Inertial(NamedTuple):
    """One sample of accelerometer and gyroscope, body axes, at the position of the sensor."""

    specific_force: Vec  # [m/s²]; a robot at rest reads +g along body z
    angular_velocity: Vec  # [rad/s]
    fresh: float  # 1 at the tick at which it arrives, else 0


class Pose(NamedTuple):
    """One sample of a motion capture system."""

    position: Vec  # of the main body, world [m]
    attitude: Quat  # body to world
    fresh: float  # 1 at the tick at which it arrives, else 0
    age: float  # time since the exposure [s]


class Estimate(NamedTuple):
    """A pilot's estimate of its own motion."""

    position: Vec  # world [m]
    attitude: Quat  # body to world
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # body [rad/s]


class Measurement(NamedTuple):
    """Input of a pilot at one tick."""

    inertial: Inertial
    pose: Pose
    arm_length: tuple[float, ...]  # [m]
    arm_length_fresh: float
    exact: Estimate  # the exact state if sensors reveal it, else zeros


class Pace(NamedTuple):
    """Period of a periodic task, in ticks of the clock."""

    ticks: float  # period, a whole number
    share: float  # 1/ticks, stored: a division would take longer than the rest of `due`


def task_pace(ticks: float) -> Pace:
    """Pace of a task with a period in ticks."""
    return Pace(ticks, 1.0 / ticks)


@kernel
def due(tick: float, pace: Pace) -> bool:
    """True if a task is due at a tick, a whole number; tick 0 is due.

    Half a tick is added, so that rounding cannot matter: less than 1/ticks of a period has passed.
    """
    rounds = (tick + 0.5) * pace.share
    return rounds - floor(rounds) < pace.share


@kernel
def how_many_due(pace: TreeLayout, lanes: Lanes) -> int:
    """Number of lanes in which a device is due at a tick.

    Args:
        pace: Layout of its `Pace`.
        lanes: Of a group.
    """
    _, g, w, once, tick = lanes
    count = 0
    for i in range(w * once):
        count += 1 if due(tick, load(pace, g, w, i)) else 0
    return count


@kernel
def any_due(pace: TreeLayout, lanes: Lanes) -> bool:
    """True if a device of any lane is due at a tick; arguments as for `how_many_due`."""
    return how_many_due(pace, lanes) > 0


class EstimatorStep(NamedTuple):
    """An estimate, and the memory of the estimator."""

    estimate: Estimate
    memory: Any


@generic
def estimator_step(estimator: Any, tick: float, seen: Measurement, memory: Any) -> EstimatorStep:
    """Estimate from a measurement.

    Args:
        estimator: Settings of the estimator, a NamedTuple.
        tick: Number of the tick, from 0; a whole number.
        seen: The measurement.
        memory: Memory of the estimator, never changed in place: a new one is returned.
    """
    raise TypeError(
        f"{type(estimator).__name__} is not an estimator; register estimator_step for it"
    )


@generic
def believe(
    estimator: TreeLayout,
    seen: TreeLayout,
    memory: TreeLayout,
    estimate: TreeLayout,
    ticks: TreeLayout,
    lanes: Lanes,
) -> None:
    """Run the estimators of all lanes on their measurements.

    Args:
        estimator: Layout of the settings, on whose type it dispatches.
        seen: Layout of the measurement.
        memory: Layout of the estimator's memory; changed.
        estimate: Layout of the estimate; written.
        ticks: Layout of the number of the tick.
        lanes: Of a group.
    """
    _, g, w, _, _ = lanes
    for i in range(w):
        said, remembered = load(seen, g, w, i), load(memory, g, w, i)
        known = estimator_step(load(estimator, g, w, i), load(ticks, g, w, i), said, remembered)
        store(known.estimate, estimate, g, w, i)
        store(known.memory, memory, g, w, i)
