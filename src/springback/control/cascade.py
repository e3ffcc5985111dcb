"""The pilot of the paper: estimate, position, attitude and rate, each at its own pace.

The position loop runs on a computer of its own and its word takes a while to reach the autopilot
(the offboard delay); attitude and rate loops run on the autopilot.  Allocation uses the arm lengths
that the vehicle measures.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.attitude import rate_setpoint
from springback.control.mixing import Mixer, mixed, mixer, wrench_of
from springback.control.parameters import Schedule
from springback.control.position import NO_MEMORY, PositionLaw, PositionMemory, aim
from springback.control.rate import RateLaw, RateMemory, inertia_at, rate_memory, turn
from springback.control.target import AttitudeTarget, Target, Wrench, target
from springback.kept import Make, afresh
from springback.kernels.compiler import kernel
from springback.kernels.trees import Seldom, each, largest, pick
from springback.kernels.vectors import ZERO, Mat, Vec
from springback.sensing.measurement import Estimate, Measurement, due, estimated
from springback.simulation.aboard import Piloted, piloted, told
from springback.vehicle.state import Airframe


class Cascade(NamedTuple):
    """Settings of the pilot."""

    airframe: Airframe  # as the pilot believes it to be
    lowest: float  # least thrust of a rotor [N]
    highest: float  # most thrust of a rotor [N]
    lift: float  # collective thrust to which roll and pitch may raise a smaller one [N]
    estimator: Any
    reference: Any
    position: PositionLaw
    attitude: Any
    rate: RateLaw
    schedule: Schedule


class Offboard(NamedTuple):
    """The position loop and its last word."""

    position: PositionMemory
    wanted: Target
    word: AttitudeTarget  # the last one, perhaps still under way
    arrival: float  # tick at which it arrives


class Built(NamedTuple):
    """What follows from the arm lengths."""

    inertia: Mat  # J(l) about the main body, body axes [kg m²]
    mixer: Mixer


class Autopilot(NamedTuple):
    """The attitude and rate loops."""

    aim: AttitudeTarget  # the last word that has arrived
    setpoint: Vec  # angular velocity to turn with, body axes [rad/s]
    rate: RateMemory
    unmet: Vec  # moment asked for less moment given [N m]
    thrust: tuple[float, ...]  # command to each rotor [N]
    built: Seldom  # Built; arms seldom change their lengths


class CascadeMemory(NamedTuple):
    """What the pilot remembers."""

    tick: float
    estimator: Any
    estimate: Estimate
    offboard: Offboard
    autopilot: Autopilot


def cascade_memory(
    pilot: Cascade,
    estimator: Any,
    estimate: Estimate,
    thrust: tuple[float, ...],
    make: Make = afresh,
) -> CascadeMemory:
    """Memory of a pilot before tick 0, at the attitude and thrust that the robot starts with.

    Args:
        pilot: Settings.
        estimator: Memory of its estimator.
        estimate: Of the start.
        thrust: Command to each rotor [N].
        make: How parts are made.
    """
    at_start = AttitudeTarget(estimate.attitude, ZERO, sum(thrust))
    wanted = make(_first_target, pilot.reference)
    offboard = Offboard(NO_MEMORY, wanted, at_start, 0.0)
    rate = rate_memory(estimate.angular_velocity)
    built = make(_first_built, pilot.airframe)
    autopilot = Autopilot(at_start, ZERO, rate, ZERO, thrust, built)
    return CascadeMemory(0.0, estimator, estimate, offboard, autopilot)


def _first_target(reference: Any) -> Target:
    return target(reference, 0.0)


def _first_built(airframe: Airframe) -> Seldom:
    return Seldom(0.0, _built(airframe, tuple(arm.length for arm in airframe.arms)))


@kernel
def _anticipated(law: PositionLaw, reference: Any, now: Target, time: float) -> Target:
    """Where to be now, and how to lean and turn by the time that the robot will.

    A word of the position loop acts late by the delays on its way, and a rate later still by the
    lag 1/k_ω of the rate loop.  The reference is known ahead, so it is read ahead.
    """
    soon = target(reference, time + law.tilt_lead)
    later = target(reference, time + law.rate_lead)
    return Target(
        now.position, now.velocity, soon.acceleration, later.jerk, now.yaw, later.yaw_rate
    )


@kernel
def steered(
    pilot: Cascade, reference: Any, tick: float, time: float, at: Estimate, before: Offboard
) -> Offboard:
    """The position loop, at its ticks.

    Args:
        pilot: Settings; its own reference is not looked at.
        reference: What to follow.
        tick: Number of the tick.
        time: [s].
        at: Where the robot believes to be.
        before: The loop's last word.
    """
    if due(tick, pilot.schedule.position):
        wanted = target(reference, time)
        ahead = _anticipated(pilot.position, reference, wanted, time)
        aimed = aim(pilot.position, ahead, at, before.position)
        return Offboard(aimed.memory, wanted, aimed.target, tick + pilot.schedule.delay)
    return before


@kernel
def _heard(tick: float, offboard: Offboard, last: AttitudeTarget) -> AttitudeTarget:
    """The last word of the position loop that has reached the autopilot."""
    return pick(tick >= offboard.arrival, offboard.word, last)


@kernel
def _pointed(pilot: Cascade, tick: float, aim: AttitudeTarget, at: Estimate, before: Vec) -> Vec:
    """The attitude loop, at its ticks."""
    if due(tick, pilot.schedule.attitude):
        return rate_setpoint(pilot.attitude, aim, at.attitude)
    return before


@kernel
def _built(airframe: Airframe, lengths: tuple[float, ...]) -> Built:
    """What follows from some arm lengths."""
    return Built(inertia_at(airframe, lengths), mixer(airframe, lengths))


@kernel
def _rebuilt(airframe: Airframe, lengths: tuple[float, ...], last: Built) -> Seldom:
    """What follows from the arm lengths, made anew where one of them has changed."""
    if largest(each(_apart, (lengths, last.mixer.lengths), ())) > 0.0:
        return Seldom(1.0, _built(airframe, lengths))
    return Seldom(0.0, last)


@kernel
def _apart(a: float, b: float) -> float:
    return abs(a - b)


@kernel
def _turned(
    pilot: Cascade,
    tick: float,
    aim: AttitudeTarget,
    setpoint: Vec,
    lengths: tuple[float, ...],
    at: Estimate,
    before: Autopilot,
) -> Autopilot:
    """The rate loop and the mixer, at their ticks."""
    if due(tick, pilot.schedule.rate):
        built = _rebuilt(pilot.airframe, lengths, before.built.tree)
        inertia, mixer = built.tree.inertia, built.tree.mixer
        asked = turn(pilot.rate, inertia, setpoint, at.angular_velocity, before.unmet, before.rate)
        wrench = Wrench(aim.thrust, asked.moment)
        thrust = mixed(mixer, pilot.lowest, pilot.highest, wrench, pilot.lift)
        unmet = asked.moment - wrench_of(pilot.airframe, lengths, thrust).moment
        return Autopilot(aim, setpoint, asked.memory, unmet, thrust, built)
    same = Seldom(0.0, before.built.tree)
    return Autopilot(aim, setpoint, before.rate, before.unmet, before.thrust, same)


@kernel
def flown(
    pilot: Cascade,
    tick: float,
    lengths: tuple[float, ...],
    at: Estimate,
    offboard: Offboard,
    memory: CascadeMemory,
) -> Autopilot:
    """The autopilot at a tick: the last word that has reached it, attitude loop, rate loop, mixer.

    Args:
        pilot: Settings.
        tick: Number of the tick.
        lengths: Of the arms, as measured [m].
        at: Where the robot believes to be.
        offboard: The position loop after this tick.
        memory: Of the whole pilot before it.
    """
    before = memory.autopilot
    earlier = _heard(tick, memory.offboard, before.aim)  # before it is overtaken by the next word
    aim = _heard(tick, offboard, earlier)
    setpoint = _pointed(pilot, tick, aim, at, before.setpoint)
    return _turned(pilot, tick, aim, setpoint, lengths, at, before)


@piloted.register(Cascade)
@kernel
def _cascaded(
    pilot: Cascade, time: float, measurement: Measurement, memory: CascadeMemory
) -> Piloted:
    tick, m = memory.tick, memory
    believed = estimated(pilot.estimator, tick, measurement, m.estimator)
    at = believed.estimate
    offboard = steered(pilot, pilot.reference, tick, time, at, m.offboard)
    autopilot = flown(pilot, tick, measurement.arm_length, at, offboard, m)
    after = CascadeMemory(tick + 1.0, believed.memory, at, offboard, autopilot)
    return Piloted(autopilot.thrust, after)


class CascadeWords(NamedTuple):
    """What the pilot tells the diary."""

    estimate: Estimate
    wanted: Target
    aim: AttitudeTarget
    setpoint: Vec


@told.register(Cascade)
@kernel
def _tells(pilot: Cascade, memory: CascadeMemory) -> CascadeWords:
    m = memory
    return CascadeWords(m.estimate, m.offboard.wanted, m.autopilot.aim, m.autopilot.setpoint)
