"""The pilot of the paper: estimate, position, attitude and rate, each at its own rate.

The position loop runs on a separate computer and its commands reach the autopilot late (the
offboard delay); attitude and rate loops run on the autopilot.  Allocation uses the measured arm
lengths.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.attitude import rate_setpoint
from springback.control.mixing import Mixer, fits, free_thrusts, limited_thrusts, mixer, wrench_of
from springback.control.parameters import Schedule
from springback.control.position import NO_MEMORY, PositionLaw, PositionMemory, aim
from springback.control.rate import RateLaw, RateMemory, inertia_at, rate_memory, turn
from springback.control.target import AttitudeTarget, Target, Wrench, target
from springback.kernels.compiler import kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.tree_code import Rarely
from springback.kernels.trees import maximum, select, tree_map
from springback.kernels.vectors import ZERO, Mat3, Vec
from springback.sensing.measurement import (
    Estimate,
    any_due,
    believe,
    due,
    how_many_due,
)
from springback.simulation.onboard import telemetry_of
from springback.simulation.ticks import Lanes, decide
from springback.vehicle.state import Airframe


class Cascade(NamedTuple):
    """Settings of the pilot."""

    airframe: Airframe  # the pilot's model of it
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
    """The position loop and its last command."""

    position: PositionMemory
    wanted: Target
    word: AttitudeTarget  # the last command, possibly in transit
    arrival: float  # tick at which it arrives


class LengthDependent(NamedTuple):
    """Quantities that depend on the arm lengths."""

    inertia: Mat3  # J(l) about the main body, body axes [kg m²]
    mixer: Mixer


class Autopilot(NamedTuple):
    """The attitude and rate loops."""

    aim: AttitudeTarget  # the last command that has arrived
    setpoint: Vec  # desired angular velocity, body axes [rad/s]
    rate: RateMemory
    unmet: Vec  # moment asked for minus moment given [N m]
    thrust: tuple[float, ...]  # command to each rotor [N]
    built: Rarely  # Built; arms seldom change their lengths


class CascadeMemory(NamedTuple):
    """Memory of the pilot."""

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
) -> CascadeMemory:
    """Memory of a pilot before tick 0, at the attitude and thrust of the start.

    Args:
        pilot: Settings.
        estimator: Memory of its estimator.
        estimate: Estimate at the start.
        thrust: Command to each rotor [N].
    """
    at_start = AttitudeTarget(estimate.attitude, ZERO, sum(thrust))
    wanted = _first_target(pilot.reference)
    offboard = Offboard(NO_MEMORY, wanted, at_start, 0.0)
    rate = rate_memory(estimate.angular_velocity)
    built = _initial(pilot.airframe)
    autopilot = Autopilot(at_start, ZERO, rate, ZERO, thrust, built)
    return CascadeMemory(0.0, estimator, estimate, offboard, autopilot)


@traceable
def _first_target(reference: Any) -> Target:
    return target(reference, 0.0)


@traceable
def _initial(airframe: Airframe) -> Rarely:
    return Rarely(0.0, _length_dependent(airframe, tuple(arm.length for arm in airframe.arms)))


@kernel
def _anticipated_target(law: PositionLaw, reference: Any, now: Target, time: float) -> Target:
    """Target position now, and acceleration and jerk at the times at which they take effect.

    A command of the position loop takes effect after the delays on its way, and a rate later still
    by the lag 1/k_ω of the rate loop.  The reference is known in advance, so it is evaluated ahead.
    """
    soon = target(reference, time + law.tilt_lead)
    later = target(reference, time + law.rate_lead)
    return Target(
        now.position, now.velocity, soon.acceleration, later.jerk, now.yaw, later.yaw_rate
    )


@kernel
def position_loop(
    pilot: Cascade, reference: Any, tick: float, time: float, at: Estimate, before: Offboard
) -> Offboard:
    """Run the position loop at its ticks.

    Args:
        pilot: Settings; the pilot's own reference is not used.
        reference: Reference to follow.
        tick: Number of the tick.
        time: Time [s].
        at: Estimated state of the robot.
        before: Last state of the loop.
    """
    wanted = target(reference, time)
    ahead = _anticipated_target(pilot.position, reference, wanted, time)
    aimed = aim(pilot.position, ahead, at, before.position)
    now = Offboard(aimed.memory, wanted, aimed.target, tick + pilot.schedule.delay)
    return select(due(tick, pilot.schedule.position), now, before)


@kernel
def _latest(tick: float, offboard: Offboard, last: AttitudeTarget) -> AttitudeTarget:
    """Last command of the position loop that has reached the autopilot."""
    return select(tick >= offboard.arrival, offboard.word, last)


@kernel
def _length_dependent(airframe: Airframe, lengths: tuple[float, ...]) -> LengthDependent:
    """Quantities that depend on the arm lengths, for given lengths."""
    return LengthDependent(inertia_at(airframe, lengths), mixer(airframe, lengths))


@kernel
def _apart(a: float, b: float) -> float:
    return abs(a - b)


@kernel
def hear(memory: TreeLayout, lanes: Lanes) -> None:
    """Deliver the position loops' last commands to the autopilots where they arrive now."""
    _, g, w, once, _ = lanes
    coming = 0
    for i in range(w * once):
        since = load(memory.tick, g, w, i) - load(memory.offboard.arrival, g, w, i)
        coming += 1 if (since >= 0.0) & (since < 1.0) else 0
    for i in range(w if coming > 0 else 0):
        offboard, last = load(memory.offboard, g, w, i), load(memory.autopilot.aim, g, w, i)
        store(_latest(load(memory.tick, g, w, i), offboard, last), memory.autopilot.aim, g, w, i)


@kernel
def _point(pilot: TreeLayout, memory: TreeLayout, lanes: Lanes) -> None:
    """Run the attitude loops at their ticks, which nearly always coincide in all lanes."""
    _, g, w, once, tick = lanes
    own, pace = memory.autopilot, pilot.schedule.attitude
    turns = how_many_due(pace, lanes)
    for i in range(w * once if turns == w else 0):
        law, at = load(pilot.attitude, g, w, i), load(memory.estimate.attitude, g, w, i)
        store(rate_setpoint(law, load(own.aim, g, w, i), at), own.setpoint, g, w, i)
    for i in range(w if (turns > 0) & (turns < w) else 0):
        if due(tick, load(pace, g, w, i)):
            law, at = load(pilot.attitude, g, w, i), load(memory.estimate.attitude, g, w, i)
            store(rate_setpoint(law, load(own.aim, g, w, i), at), own.setpoint, g, w, i)


@kernel
def fly_on(
    pilot: TreeLayout, memory: TreeLayout, lengths: TreeLayout, command: TreeLayout, lanes: Lanes
) -> None:
    """Run the autopilots of all lanes: arriving commands, attitude, rate loop and mixer.

    Args:
        pilot: Layout of the settings, a `Cascade`.
        memory: Layout of its memory, a `CascadeMemory`; changed.
        lengths: Layout of the measured arm lengths.
        command: Layout of the command to the rotors; written.
        lanes: Of a group.
    """
    hear(memory, lanes)
    _, g, w, once, _ = lanes
    own = memory.autopilot
    _point(pilot, memory, lanes)
    if any_due(pilot.schedule.rate, lanes):
        _rebuild(pilot, own.built.tree, lengths, lanes)
        _turn(pilot, memory, lengths, lanes)
    for i in range(w * once):
        store(load(own.thrust, g, w, i), command, g, w, i)
        store(load(memory.tick, g, w, i) + 1.0, memory.tick, g, w, i)


@kernel
def _rebuild(pilot: TreeLayout, built: TreeLayout, lengths: TreeLayout, lanes: Lanes) -> None:
    """Recompute quantities that depend on the arm lengths where one has changed."""
    _, g, w, once, tick = lanes
    changed = 0
    for i in range(w * once):
        now, last = load(lengths, g, w, i), load(built.mixer.lengths, g, w, i)
        changed += 1 if maximum(tree_map(_apart, (now, last), ())) > 0.0 else 0
    for i in range(w if changed > 0 else 0):
        now, last = load(lengths, g, w, i), load(built.mixer.lengths, g, w, i)
        if maximum(tree_map(_apart, (now, last), ())) > 0.0 and due(
            tick, load(pilot.schedule.rate, g, w, i)
        ):
            store(_length_dependent(load(pilot.airframe, g, w, i), now), built, g, w, i)


@kernel
def _turn(pilot: TreeLayout, memory: TreeLayout, lengths: TreeLayout, lanes: Lanes) -> None:
    """Run rate loop and mixer; where a moment is saturated, ``unmet`` first holds all of it."""
    _, g, w, once, tick = lanes
    own, built, tight = memory.autopilot, memory.autopilot.built.tree, 0
    for i in range(w * once):
        omega = load(memory.estimate.angular_velocity, g, w, i)
        setpoint, unmet = load(own.setpoint, g, w, i), load(own.unmet, g, w, i)
        before, law = load(own.rate, g, w, i), load(pilot.rate, g, w, i)
        asked = turn(law, load(built.inertia, g, w, i), setpoint, omega, unmet, before)
        wrench = Wrench(load(own.aim.thrust, g, w, i), asked.moment)
        wanted = free_thrusts(load(built.mixer, g, w, i), wrench)
        lowest, highest = load(pilot.lowest, g, w, i), load(pilot.highest, g, w, i)
        now, fitting = due(tick, load(pilot.schedule.rate, g, w, i)), fits(wanted, lowest, highest)
        tight += 0 if fitting else 1
        store(select(now, asked.memory, before), own.rate, g, w, i)
        store(select(now, select(fitting, ZERO, asked.moment), unmet), own.unmet, g, w, i)
        store(select(now, wanted, load(own.thrust, g, w, i)), own.thrust, g, w, i)
    for i in range(w if tight > 0 else 0):
        wanted, lift = load(own.thrust, g, w, i), load(pilot.lift, g, w, i)
        lowest, highest = load(pilot.lowest, g, w, i), load(pilot.highest, g, w, i)
        if due(tick, load(pilot.schedule.rate, g, w, i)) and not fits(wanted, lowest, highest):
            wrench = Wrench(load(own.aim.thrust, g, w, i), load(own.unmet, g, w, i))
            thrust = limited_thrusts(load(built.mixer, g, w, i), lowest, highest, wrench, lift)
            store(thrust, own.thrust, g, w, i)
            given = wrench_of(load(pilot.airframe, g, w, i), load(lengths, g, w, i), thrust)
            store(wrench.moment - given.moment, own.unmet, g, w, i)


@decide.register(Cascade)
@kernel
def _decide(pilot: TreeLayout, lanes: Lanes) -> None:
    """Batch version of `pilot_step`."""
    avionics, g, w, once, tick = lanes
    memory, seen = avionics.onboard.pilot, avionics.onboard.measurement
    believe(pilot.estimator, seen, memory.estimator, memory.estimate, memory.tick, lanes)
    if any_due(pilot.schedule.position, lanes):
        hear(memory, lanes)  # before the next command replaces it
        for i in range(w * once):
            time, at = tick * load(avionics.systems.period, g, w, i), load(memory.estimate, g, w, i)
            settings, before = load(pilot, g, w, i), load(memory.offboard, g, w, i)
            offboard = position_loop(settings, settings.reference, tick, time, at, before)
            store(offboard, memory.offboard, g, w, i)
    fly_on(pilot, memory, seen.arm_length, avionics.onboard.command, lanes)


class CascadeTelemetry(NamedTuple):
    """Telemetry of the pilot."""

    estimate: Estimate
    wanted: Target
    aim: AttitudeTarget
    setpoint: Vec


@telemetry_of.register(Cascade)
@kernel
def _tells(pilot: Cascade, memory: CascadeMemory) -> CascadeTelemetry:
    m = memory
    return CascadeTelemetry(m.estimate, m.offboard.wanted, m.autopilot.aim, m.autopilot.setpoint)
