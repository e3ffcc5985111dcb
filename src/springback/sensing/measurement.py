"""What sensors tell a pilot, and what an estimator makes of it.

Everything lives on a clock of equal ticks.  Devices that run slower than the clock say in `fresh`
whether they have spoken at this tick; in between their last word stands.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.angles import rounded_down
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import Buffer, TreeLayout, load, store
from springback.kernels.vectors import Quat, Vec
from springback.simulation.onboard import Sensed as Sensed
from springback.simulation.onboard import Truth as Truth
from springback.simulation.onboard import sensed as sensed


class Inertial(NamedTuple):
    """One sample of accelerometer and gyroscope, body axes, at the place of the sensor."""

    specific_force: Vec  # [m/s²]; a robot at rest reads +g along body z
    angular_velocity: Vec  # [rad/s]
    fresh: float  # 1 at the tick at which it arrives, else 0


class Pose(NamedTuple):
    """One sample of a motion capture system."""

    position: Vec  # of the main body, world [m]
    attitude: Quat  # body to world
    fresh: float  # 1 at the tick at which it arrives, else 0
    age: float  # time since the pose was that of the robot [s]


class Estimate(NamedTuple):
    """What a pilot believes about its own motion."""

    position: Vec  # world [m]
    attitude: Quat  # body to world
    velocity: Vec  # world [m/s]
    angular_velocity: Vec  # body [rad/s]


class Measurement(NamedTuple):
    """All that a pilot is given at one tick."""

    inertial: Inertial
    pose: Pose
    arm_length: tuple[float, ...]  # [m]
    arm_length_fresh: float
    exact: Estimate  # the truth where sensors are asked to reveal it, else zeros


class Pace(NamedTuple):
    """How often something is done on the clock."""

    ticks: float  # from one time to the next, a whole number
    share: float  # of all ticks, 1/ticks: kept, since dividing takes longer than the rest of `due`


def paced(ticks: float) -> Pace:
    """The pace of what is done every so many ticks."""
    return Pace(ticks, 1.0 / ticks)


@kernel
def due(tick: float, pace: Pace) -> bool:
    """Whether something is done at a tick, a whole number: it is at tick 0.

    Half a tick past it, so that rounding decides nothing, less than 1/ticks of a round is over.
    """
    rounds = (tick + 0.5) * pace.share
    return rounds - rounded_down(rounds) < pace.share


@kernel
def how_many_due(pace: TreeLayout, g: Buffer, w: int, once: int, tick: float) -> int:
    """In how many lanes a device speaks at a tick.

    Args:
        pace: Where its `Pace` lies.
        g: Buffer of what is aboard.
        w: Lanes.
        once: As for `springback.simulation.ticks.look`.
        tick: Number of the tick.
    """
    count = 0
    for i in range(w * once):
        count += 1 if due(tick, load(pace, g, w, i)) else 0
    return count


@kernel
def any_due(pace: TreeLayout, g: Buffer, w: int, once: int, tick: float) -> bool:
    """Whether a device of any lane speaks at a tick; arguments as for `how_many_due`."""
    return how_many_due(pace, g, w, once, tick) > 0


class EstimatorStep(NamedTuple):
    """An estimate, and what the estimator remembers."""

    estimate: Estimate
    memory: Any


@generic
def estimated(estimator: Any, tick: float, seen: Measurement, memory: Any) -> EstimatorStep:
    """What an estimator makes of a measurement.

    Args:
        estimator: Settings of the estimator, a NamedTuple.
        tick: Number of the tick, from 0; a whole number.
        seen: What the sensors say.
        memory: What the estimator remembers; returned anew, never changed in place.
    """
    raise TypeError(f"{type(estimator).__name__} is no estimator; register estimated for it")


@generic
def believe(
    estimator: TreeLayout, seen: TreeLayout, memory: TreeLayout, estimate: TreeLayout,
    ticks: TreeLayout, g: Buffer, w: int,
    once: int,
) -> None:  # fmt: skip
    """The estimators of all lanes make what they can of a measurement.

    Args:
        estimator: Like its settings, by whose type it is chosen.
        seen: Where the measurement lies.
        memory: Where the estimator's memory lies; changed.
        estimate: Where the estimate goes.
        ticks: Where the number of the tick lies.
        g: Buffer of what is aboard.
        w: Lanes.
        once: As for `springback.simulation.ticks.look`.
    """
    for i in range(w):
        said, remembered = load(seen, g, w, i), load(memory, g, w, i)
        known = estimated(load(estimator, g, w, i), load(ticks, g, w, i), said, remembered)
        store(known.estimate, estimate, g, w, i)
        store(known.memory, memory, g, w, i)
