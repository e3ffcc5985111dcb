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
    fly_on,
    hear,
    steered,
)
from springback.control.target import Target
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import Buffer, Like, got, put
from springback.kernels.memo import Make, afresh
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
from springback.recovery.response import Staged
from springback.recovery.stages import staged
from springback.recovery.state_machine import (
    LOOK,
    RECOVER,
    STAGES,
    Calm,
    Departed,
    Journey,
    Route,
    journey_at_start,
    leaving,
    passes,
    struck,
    turned,
)
from springback.recovery.wrench import (
    ExternalWrench,
    Observer,
    no_wrench,
    observed_wrench,
    renewed_wrench,
)
from springback.sensing.measurement import Estimate, Measurement, any_due, believe, due
from springback.simulation.onboard import told
from springback.simulation.ticks import decide


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
    alarm: float  # 1 while a flight has something to consider at this tick, else 0


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
        0.0,
    )


class Worded(NamedTuple):
    """The position loop after a tick, and the stage of a staged response."""

    offboard: Offboard
    stage: float


@kernel
def _followed(
    pilot: Resilient, tick: float, time: float, at: Estimate, journey: Journey, before: Offboard
) -> Offboard:
    """The way of the leg."""
    c, leg = pilot.cascade, journey.leg
    if leg <= LOOK:
        return steered(c, Departed(c.reference, journey.away), tick, time, at, before)
    if leg <= RECOVER:
        return steered(c, Calm(journey.recovery), tick, time, at, before)
    return steered(c, Calm(journey.homeward), tick, time, at, before)


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
    if journey.leg == STAGES:
        now = staged(response, c.position, hit, at, before.wanted.yaw, journey.stage)
        arrival = tick + c.schedule.delay
        return Worded(Offboard(before.position, before.wanted, now.word, arrival), now.stage)
    return Worded(_followed(pilot, tick, time, at, journey, before), journey.stage)


@generic
def steer(
    response: Like, pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float
) -> None:
    """The position loops of all lanes follow the ways of their legs.

    Args:
        response: Like its settings, by whose type it is chosen.
        pilot: Where the settings of the pilot lie.
        cabin: What lies in ``g``.
        g: Buffer of what is aboard.
        w: Lanes.
        once: As for `springback.simulation.ticks.look`.
        tick: Number of the tick.
    """
    memory, flight, cascade = cabin.aboard.pilot, cabin.aboard.pilot.flight, pilot.cascade
    journey, cruising, recovering, returning = memory.journey, 0, 0, 0
    for i in range(w * once):
        leg = got(journey.leg, g, w, i)
        cruising += 1 if leg <= LOOK else 0
        recovering += 1 if (leg > LOOK) & (leg <= RECOVER) else 0
        returning += 1 if leg > RECOVER else 0
    # Ways are long to follow, and all lanes are nearly always on the same: so one way at a time.
    for i in range(w * once if cruising > 0 else 0):
        way = Departed(got(cascade.reference, g, w, i), got(journey.away, g, w, i))
        now = _steered(pilot, cabin, way, g, w, i, tick)
        mine, before = got(journey.leg, g, w, i) <= LOOK, got(flight.offboard, g, w, i)
        put(pick(mine, now, before), flight.offboard, g, w, i)
    for i in range(w * once if recovering > 0 else 0):
        now = _steered(pilot, cabin, Calm(got(journey.recovery, g, w, i)), g, w, i, tick)
        leg, before = got(journey.leg, g, w, i), got(flight.offboard, g, w, i)
        put(pick((leg > LOOK) & (leg <= RECOVER), now, before), flight.offboard, g, w, i)
    for i in range(w * once if returning > 0 else 0):
        now = _steered(pilot, cabin, Calm(got(journey.homeward, g, w, i)), g, w, i, tick)
        mine, before = got(journey.leg, g, w, i) > RECOVER, got(flight.offboard, g, w, i)
        put(pick(mine, now, before), flight.offboard, g, w, i)


@kernel
def _steered(
    pilot: Like, cabin: Like, way: Any, g: Buffer, w: int, i: int, tick: float
) -> Offboard:
    """The position loop of one lane on some way."""
    flight, time = cabin.aboard.pilot.flight, tick * got(cabin.guidance.period, g, w, i)
    at, before = got(flight.estimate, g, w, i), got(flight.offboard, g, w, i)
    return steered(got(pilot.cascade, g, w, i), way, tick, time, at, before)


@steer.register(Staged)
@kernel
def _steer_in_stages(
    response: Like, pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float
) -> None:
    memory, flight = cabin.aboard.pilot, cabin.aboard.pilot.flight
    for i in range(w):
        settings, time = got(pilot, g, w, i), tick * got(cabin.guidance.period, g, w, i)
        at, hit = got(flight.estimate, g, w, i), got(memory.collision, g, w, i)
        journey, before = got(memory.journey, g, w, i), got(flight.offboard, g, w, i)
        if due(tick, settings.cascade.schedule.position):
            plan = settings.route.response
            said = _worded_in_stages(plan, settings, tick, time, at, hit, journey, before)
            put(said.offboard, flight.offboard, g, w, i)
            put(said.stage, memory.journey.stage, g, w, i)


@kernel
def _remembered(pilot: Resilient, tick: float, at: Estimate, before: History) -> History:
    now = History(at.velocity, before.newer)
    return pick(due(tick, pilot.cascade.schedule.position), now, before)


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
    if looked_enough(pilot.look, impression, hit.arms, time - journey.since):
        return leaving(pilot.route, journey, hit, at, time, wanted.yaw)
    return journey


class Considered(NamedTuple):
    """What a pilot that looks at a collision makes of it."""

    impression: Impression
    collision: Collision
    journey: Journey


@kernel
def _considered(
    pilot: Resilient,
    time: float,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    m: ResilientMemory,
) -> Considered:
    airframe = pilot.cascade.airframe
    journey = _begun(m.journey, m.alarm, time)
    fresh = pick((journey.leg == LOOK) & (m.journey.leg == LOOK), 1.0, 0.0)
    so_far = pick(fresh > 0.5, m.impression, no_impression(airframe))
    impression = impressed(pilot.look, airframe, seen, at, wrench, so_far)
    hit = _made_out(pilot, time, seen, at, impression, wrench, m.journey, journey, m)
    gone = _gone(pilot, time, at, impression, hit, journey, m.flight.offboard.wanted)
    return Considered(impression, hit, gone)


@kernel
def _observing(pilot: Like, cabin: Like, g: Buffer, w: int, i: int) -> Any:
    """What the observer of one lane goes by: arguments of `observed_wrench`."""
    memory, flight = cabin.aboard.pilot, cabin.aboard.pilot.flight
    return (
        got(pilot.observer, g, w, i),
        got(pilot.cascade.airframe, g, w, i),
        got(flight.autopilot.built.tree.inertia, g, w, i),
        got(cabin.aboard.measurement, g, w, i),
        got(flight.estimate, g, w, i),
        got(flight.autopilot.thrust, g, w, i),
        got(memory.wrench, g, w, i),
    )


@kernel
def _watch(pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float) -> int:
    """The observers and triggers of all lanes; how many lanes have something to consider."""
    memory, seen = cabin.aboard.pilot, cabin.aboard.measurement
    waiting, stirred = 0, 0
    for i in range(w * once):
        waiting += 0 if got(seen.inertial.fresh, g, w, i) > 0.5 else 1
    for i in range(w * once if waiting == 0 else 0):  # the same, without a choice
        x = _observing(pilot, cabin, g, w, i)
        put(renewed_wrench(*x), memory.wrench, g, w, i)
    for i in range(w * once if waiting > 0 else 0):
        x = _observing(pilot, cabin, g, w, i)
        put(observed_wrench(*x), memory.wrench, g, w, i)
    for i in range(w * once):
        airframe, said = got(pilot.cascade.airframe, g, w, i), got(seen, g, w, i)
        at, wrench = got(memory.flight.estimate, g, w, i), got(memory.wrench, g, w, i)
        time = tick * got(cabin.guidance.period, g, w, i)
        triggers, so_far = got(pilot.detection, g, w, i), got(memory.detection, g, w, i)
        noticed = detected(triggers, airframe.arms, time, said, at, wrench, so_far)
        put(noticed.memory, memory.detection, g, w, i)
        put(noticed.alarm, memory.alarm, g, w, i)
        looks = (noticed.alarm > 0.5) | (got(memory.journey.leg, g, w, i) == LOOK)
        stirred += 1 if looks else 0
    return stirred


@kernel
def _travel(pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float) -> None:
    """The journeys of all lanes that have nothing to consider: mostly, time goes by."""
    memory, arrived = cabin.aboard.pilot, 0
    for i in range(w * once):
        time = tick * got(cabin.guidance.period, g, w, i)
        alarm, journey = got(memory.alarm, g, w, i), got(memory.journey, g, w, i)
        calm = (alarm < 0.5) & (journey.leg != LOOK)
        route, at = got(pilot.route, g, w, i), got(memory.flight.estimate, g, w, i)
        passed = passes(route, journey, at, time)
        put(pick(calm, passed.near, journey.near), memory.journey.near, g, w, i)
        put(pick(calm, passed.turns, 0.0), memory.alarm, g, w, i)
        arrived += 1 if calm & (passed.turns > 0.5) else 0
    for i in range(w if arrived > 0 else 0):
        if got(memory.alarm, g, w, i) > 0.5:
            time = tick * got(cabin.guidance.period, g, w, i)
            route, journey = got(pilot.route, g, w, i), got(memory.journey, g, w, i)
            at, hit = got(memory.flight.estimate, g, w, i), got(memory.collision, g, w, i)
            yaw = got(memory.flight.offboard.wanted.yaw, g, w, i)
            put(turned(route, journey, hit, at, time, yaw), memory.journey, g, w, i)


@decide.register(Resilient)
@kernel
def _decide(pilot: Like, cabin: Like, g: Buffer, w: int, once: int, tick: float) -> None:
    """`piloted`, step by step for all lanes; collisions are considered one by one."""
    memory, seen = cabin.aboard.pilot, cabin.aboard.measurement
    flight, cascade = memory.flight, pilot.cascade
    believe(cascade.estimator, seen, flight.estimator, flight.estimate, flight.tick, g, w, once)
    stirred = _watch(pilot, cabin, g, w, once, tick)
    for i in range(w if stirred > 0 else 0):
        m = got(memory, g, w, i)
        if m.alarm > 0.5 or m.journey.leg == LOOK:
            settings, said = got(pilot, g, w, i), got(seen, g, w, i)
            time = tick * got(cabin.guidance.period, g, w, i)
            now = _considered(settings, time, said, m.flight.estimate, m.wrench, m)
            put(now.impression, memory.impression, g, w, i)
            put(now.collision, memory.collision, g, w, i)
            put(now.journey, memory.journey, g, w, i)
            put(1.0, memory.alarm, g, w, i)  # it has travelled
    _travel(pilot, cabin, g, w, once, tick)
    if any_due(cascade.schedule.position, g, w, once, tick):
        hear(flight, g, w, once)  # before it is overtaken by the next word
        steer(pilot.route.response, pilot, cabin, g, w, once, tick)
        for i in range(w * once):
            settings, at = got(pilot, g, w, i), got(flight.estimate, g, w, i)
            past = _remembered(settings, tick, at, got(memory.history, g, w, i))
            put(past, memory.history, g, w, i)
    fly_on(cascade, flight, seen.arm_length, cabin.aboard.command, g, w, once, tick)


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
