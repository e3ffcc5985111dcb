"""The pilot that survives: cruise, notice a collision, make it out, recover, return, hover.

It is the cascade of `springback.control.cascade` with eyes for collisions: estimator, position,
attitude and rate loops are the same, and only the reference is that of the journey.  Everything it
acts on is a measurement or an estimate.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.cascade import (
    Cascade,
    CascadeMemory,
    CascadeWords,
    Offboard,
    flown,
    steered,
)
from springback.control.target import Target
from springback.kept import Make, afresh
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import pick
from springback.kernels.vectors import Vec
from springback.recovery.characterisation import (
    Characterisation,
    Collision,
    Impression,
    characterised,
    impressed,
    looked_enough,
    no_collision,
    no_impression,
)
from springback.recovery.detection import (
    NOT_DETECTED,
    Detection,
    DetectionMemory,
    detected,
)
from springback.recovery.journey import (
    LOOK,
    STAGES,
    Itinerary,
    Journey,
    Route,
    journey_at_start,
    leaving,
    struck,
    travelled,
)
from springback.recovery.response import Staged
from springback.recovery.stages import staged
from springback.recovery.wrench import ExternalWrench, Observer, no_wrench, observed_wrench
from springback.sensing.measurement import Estimate, Measurement, due, estimated
from springback.simulation.aboard import Piloted, piloted, told


class Resilient(NamedTuple):
    """Settings of the pilot."""

    cascade: Cascade  # its reference is the run-up
    observer: Observer
    detection: Detection
    look: Characterisation
    route: Route


class History(NamedTuple):
    """Velocity at the last ticks of the position loop, by which that before a collision is known.

    The older one is at least a period old: a collision is noticed later than it begins.
    """

    newer: Vec  # world [m/s]
    older: Vec


class ResilientMemory(NamedTuple):
    """What the pilot remembers."""

    flight: CascadeMemory
    wrench: ExternalWrench
    detection: DetectionMemory
    impression: Impression
    collision: Collision  # the last
    history: History
    journey: Journey


def resilient_memory(
    pilot: Resilient, flight: CascadeMemory, make: Make = afresh
) -> ResilientMemory:
    """Memory of a pilot before tick 0.

    Args:
        pilot: Settings.
        flight: Memory of the cascade, from `springback.control.cascade.cascade_memory`.
        make: How parts are made.
    """
    start, airframe = flight.estimate, pilot.cascade.airframe
    nothing = make(no_collision, airframe)
    return ResilientMemory(
        flight,
        no_wrench(pilot.observer, airframe, start, flight.autopilot.thrust, make),
        NOT_DETECTED,
        make(no_impression, airframe),
        nothing,
        History(start.velocity, start.velocity),
        journey_at_start(pilot.route, nothing, make),
    )


class Worded(NamedTuple):
    """The position loop after a tick, and the stage of a staged response."""

    offboard: Offboard
    stage: float


@generic
def worded(
    response: Any,
    pilot: Resilient,
    tick: float,
    time: float,
    at: Estimate,
    hit: Collision,
    journey: Journey,
    before: Offboard,
) -> Worded:
    """What the offboard computer asks of the autopilot: to follow the way of the leg."""
    raise TypeError(f"{type(response).__name__} is no response")


@kernel
def _followed(
    pilot: Resilient, tick: float, time: float, at: Estimate, journey: Journey, before: Offboard
) -> Offboard:
    j = journey
    way = Itinerary(pilot.cascade.reference, j.away, j.recovery, j.homeward, j.leg)
    return steered(pilot.cascade, way, tick, time, at, before)


@worded.register(object)
@kernel
def _worded(
    response: Any,
    pilot: Resilient,
    tick: float,
    time: float,
    at: Estimate,
    hit: Collision,
    journey: Journey,
    before: Offboard,
) -> Worded:
    return Worded(_followed(pilot, tick, time, at, journey, before), journey.stage)


@worded.register(Staged)
@kernel
def _worded_in_stages(
    response: Staged,
    pilot: Resilient,
    tick: float,
    time: float,
    at: Estimate,
    hit: Collision,
    journey: Journey,
    before: Offboard,
) -> Worded:
    c = pilot.cascade
    if (journey.leg == STAGES) & due(tick, c.schedule.position):
        now = staged(response, c.position, hit, at, before.wanted.yaw, journey.stage)
        arrival = tick + c.schedule.delay
        return Worded(Offboard(before.position, before.wanted, now.word, arrival), now.stage)
    if journey.leg == STAGES:
        return Worded(before, journey.stage)
    return Worded(_followed(pilot, tick, time, at, journey, before), journey.stage)


@kernel
def _remembered(pilot: Resilient, tick: float, at: Estimate, before: History) -> History:
    if due(tick, pilot.cascade.schedule.position):
        return History(at.velocity, before.newer)
    return before


@kernel
def _begun(journey: Journey, alarm: float, time: float) -> Journey:
    """An alarm while the robot looks is of the same collision."""
    if (alarm > 0.5) & (journey.leg != LOOK):
        return struck(journey, time)
    return journey


@kernel
def _made_out(
    pilot: Resilient,
    time: float,
    seen: Measurement,
    at: Estimate,
    impression: Impression,
    wrench: ExternalWrench,
    before: Journey,
    journey: Journey,
    m: ResilientMemory,
) -> Collision:
    """The last collision: where it was noticed, and once the window is over what it was."""
    if journey.leg != LOOK:
        return m.collision
    new = before.leg != LOOK
    position = pick(new, at.position, m.collision.position)
    velocity = pick(new, m.history.older, m.collision.velocity)
    return characterised(
        pilot.look, pilot.cascade.airframe, seen, at, wrench, impression, position, velocity
    )


@kernel
def _gone(
    pilot: Resilient,
    time: float,
    at: Estimate,
    impression: Impression,
    hit: Collision,
    journey: Journey,
    wanted: Target,
) -> Journey:
    elapsed = time - journey.since
    if (journey.leg == LOOK) & looked_enough(pilot.look, impression, hit.arms, elapsed):
        return leaving(pilot.route, journey, hit, at, time, wanted.yaw)
    return travelled(pilot.route, journey, hit, at, time, wanted.yaw)


@piloted.register(Resilient)
@kernel
def _resilient(
    pilot: Resilient, time: float, measurement: Measurement, memory: ResilientMemory
) -> Piloted:
    m, cascade, seen = memory, pilot.cascade, measurement
    tick, airframe = m.flight.tick, cascade.airframe
    believed = estimated(cascade.estimator, tick, seen, m.flight.estimator)
    at = believed.estimate
    given = m.flight.autopilot.thrust
    inertia = m.flight.autopilot.built.tree.inertia
    wrench = observed_wrench(pilot.observer, airframe, inertia, seen, at, given, m.wrench)
    noticed = detected(pilot.detection, airframe.arms, time, seen, at, wrench, m.detection)

    journey = _begun(m.journey, noticed.alarm, time)
    fresh = pick((journey.leg == LOOK) & (m.journey.leg == LOOK), 1.0, 0.0)
    so_far = pick(fresh > 0.5, m.impression, no_impression(airframe))
    impression = impressed(pilot.look, airframe, seen, at, wrench, so_far)
    hit = _made_out(pilot, time, seen, at, impression, wrench, m.journey, journey, m)
    gone = _gone(pilot, time, at, impression, hit, journey, m.flight.offboard.wanted)

    said = worded(pilot.route.response, pilot, tick, time, at, hit, gone, m.flight.offboard)
    autopilot = flown(cascade, tick, seen.arm_length, at, said.offboard, m.flight)
    flight = CascadeMemory(tick + 1.0, believed.memory, at, said.offboard, autopilot)
    g = gone
    after = Journey(
        g.leg, g.since, said.stage, g.away, g.recovery, g.homeward, g.ends, g.goal, g.near, g.log
    )
    history = _remembered(pilot, tick, at, m.history)
    return Piloted(
        autopilot.thrust,
        ResilientMemory(flight, wrench, noticed.memory, impression, hit, history, after),
    )


class ResilientWords(NamedTuple):
    """What the pilot tells the diary."""

    estimate: Estimate
    wanted: Target
    aim: Any
    setpoint: Vec
    leg: float
    goal: Vec  # p_r, or where the leg leads [m]
    pressed: float  # the Hall sensors' signal [m]
    jolt: float  # the accelerometer's [m/s²]
    push: float  # the wrench's [N]
    alarms: tuple[float, float, float]  # of each trigger so far
    force: Vec  # external, world [N]
    moment: Vec  # external, body axes [N m]
    direction: Vec  # f_c⁰ of the last collision


@told.register(Resilient)
@kernel
def _tells(pilot: Resilient, memory: ResilientMemory) -> ResilientWords:
    m, w, d = memory.flight, memory.wrench, memory.detection
    words = CascadeWords(m.estimate, m.offboard.wanted, m.autopilot.aim, m.autopilot.setpoint)
    return ResilientWords(
        words.estimate, words.wanted, words.aim, words.setpoint,
        memory.journey.leg, memory.journey.goal,
        d.hall.filtered, d.acceleration.filtered, d.wrench.filtered,
        (d.hall.alarms, d.acceleration.alarms, d.wrench.alarms),
        w.force, w.moment, memory.collision.direction,
    )  # fmt: skip
