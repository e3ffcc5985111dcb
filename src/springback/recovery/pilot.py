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
    CascadeTelemetry,
    Offboard,
    fly_on,
    hear,
    position_loop,
)
from springback.control.target import Target
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import Buffer, TreeLayout, load, store
from springback.kernels.memo import Build, plain_build
from springback.kernels.trees import select
from springback.kernels.vectors import Vec
from springback.recovery.characterisation import (
    Characterisation,
    Collision,
    CollisionObservation,
    characterise,
    looked_enough,
    no_collision,
    no_observation,
    observe,
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
    Departed,
    RecoveryState,
    Route,
    SmoothReturn,
    on_alarm,
    on_characterised,
    on_phase_end,
    phase_end,
    recovery_at_start,
)
from springback.recovery.wrench import (
    ExternalWrench,
    Observer,
    no_wrench,
    observed_wrench,
    renewed_wrench,
)
from springback.sensing.measurement import Estimate, Measurement, any_due, believe, due
from springback.simulation.onboard import telemetry_of
from springback.simulation.ticks import decide


class RecoveryPilot(NamedTuple):
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


class RecoveryPilotMemory(NamedTuple):
    """What the pilot remembers."""

    flight: CascadeMemory
    wrench: ExternalWrench
    detection: DetectionMemory
    observation: CollisionObservation
    collision: Collision  # the last
    history: History
    recovery_state: RecoveryState
    alarm: float  # 1 while a flight has something to consider at this tick, else 0


def recovery_pilot_memory(
    pilot: RecoveryPilot, flight: CascadeMemory, build: Build = plain_build
) -> RecoveryPilotMemory:
    """Memory of a pilot before tick 0.

    Args:
        pilot: Settings.
        flight: Memory of the cascade, from `springback.control.cascade.cascade_memory`.
        build: How parts are made.
    """
    start, airframe = flight.estimate, pilot.cascade.airframe
    nothing = build(no_collision, airframe)
    return RecoveryPilotMemory(
        flight,
        no_wrench(pilot.observer, airframe, start, flight.autopilot.thrust, build),
        NOT_DETECTED,
        build(no_observation, airframe),
        nothing,
        History(start.velocity, start.velocity),
        recovery_at_start(pilot.route, nothing, build),
        0.0,
    )


class Worded(NamedTuple):
    """The position loop after a tick, and the stage of a staged response."""

    offboard: Offboard
    stage: float


@kernel
def _followed(
    pilot: RecoveryPilot,
    tick: float,
    time: float,
    at: Estimate,
    recovery_state: RecoveryState,
    before: Offboard,
) -> Offboard:
    """The way of the leg."""
    c, phase = pilot.cascade, recovery_state.phase
    if phase <= LOOK:
        return position_loop(c, Departed(c.reference, recovery_state.away), tick, time, at, before)
    if phase <= RECOVER:
        return position_loop(c, SmoothReturn(recovery_state.recovery), tick, time, at, before)
    return position_loop(c, SmoothReturn(recovery_state.homeward), tick, time, at, before)


@kernel
def _worded_in_stages(
    response: Staged,
    pilot: RecoveryPilot,
    tick: float,
    time: float,
    at: Estimate,
    hit: Collision,
    recovery_state: RecoveryState,
    before: Offboard,
) -> Worded:
    c = pilot.cascade
    if recovery_state.phase == STAGES:
        now = staged(response, c.position, hit, at, before.wanted.yaw, recovery_state.stage)
        arrival = tick + c.schedule.delay
        return Worded(Offboard(before.position, before.wanted, now.word, arrival), now.stage)
    return Worded(_followed(pilot, tick, time, at, recovery_state, before), recovery_state.stage)


@generic
def steer(
    response: TreeLayout,
    pilot: TreeLayout,
    avionics: TreeLayout,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    """The position loops of all lanes follow the ways of their legs.

    Args:
        response: Like its settings, by whose type it is chosen.
        pilot: Where the settings of the pilot lie.
        avionics: What lies in ``g``.
        g: Buffer of what is aboard.
        w: Lanes.
        once: As for `springback.simulation.ticks.look`.
        tick: Number of the tick.
    """
    memory, flight, cascade = avionics.onboard.pilot, avionics.onboard.pilot.flight, pilot.cascade
    recovery_state, cruising, recovering, returning = memory.recovery_state, 0, 0, 0
    for i in range(w * once):
        phase = load(recovery_state.phase, g, w, i)
        cruising += 1 if phase <= LOOK else 0
        recovering += 1 if (phase > LOOK) & (phase <= RECOVER) else 0
        returning += 1 if phase > RECOVER else 0
    # Ways are long to follow, and all lanes are nearly always on the same: so one way at a time.
    for i in range(w * once if cruising > 0 else 0):
        way = Departed(load(cascade.reference, g, w, i), load(recovery_state.away, g, w, i))
        now = _steered(pilot, avionics, way, g, w, i, tick)
        mine, before = load(recovery_state.phase, g, w, i) <= LOOK, load(flight.offboard, g, w, i)
        store(select(mine, now, before), flight.offboard, g, w, i)
    for i in range(w * once if recovering > 0 else 0):
        now = _steered(
            pilot, avionics, SmoothReturn(load(recovery_state.recovery, g, w, i)), g, w, i, tick
        )
        phase, before = load(recovery_state.phase, g, w, i), load(flight.offboard, g, w, i)
        store(select((phase > LOOK) & (phase <= RECOVER), now, before), flight.offboard, g, w, i)
    for i in range(w * once if returning > 0 else 0):
        now = _steered(
            pilot, avionics, SmoothReturn(load(recovery_state.homeward, g, w, i)), g, w, i, tick
        )
        mine, before = load(recovery_state.phase, g, w, i) > RECOVER, load(flight.offboard, g, w, i)
        store(select(mine, now, before), flight.offboard, g, w, i)


@kernel
def _steered(
    pilot: TreeLayout, avionics: TreeLayout, way: Any, g: Buffer, w: int, i: int, tick: float
) -> Offboard:
    """The position loop of one lane on some way."""
    flight, time = avionics.onboard.pilot.flight, tick * load(avionics.systems.period, g, w, i)
    at, before = load(flight.estimate, g, w, i), load(flight.offboard, g, w, i)
    return position_loop(load(pilot.cascade, g, w, i), way, tick, time, at, before)


@steer.register(Staged)
@kernel
def _steer_in_stages(
    response: TreeLayout,
    pilot: TreeLayout,
    avionics: TreeLayout,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    memory, flight = avionics.onboard.pilot, avionics.onboard.pilot.flight
    for i in range(w):
        settings, time = load(pilot, g, w, i), tick * load(avionics.systems.period, g, w, i)
        at, hit = load(flight.estimate, g, w, i), load(memory.collision, g, w, i)
        recovery_state, before = (
            load(memory.recovery_state, g, w, i),
            load(flight.offboard, g, w, i),
        )
        if due(tick, settings.cascade.schedule.position):
            plan = settings.route.response
            said = _worded_in_stages(plan, settings, tick, time, at, hit, recovery_state, before)
            store(said.offboard, flight.offboard, g, w, i)
            store(said.stage, memory.recovery_state.stage, g, w, i)


@kernel
def _remembered(pilot: RecoveryPilot, tick: float, at: Estimate, before: History) -> History:
    now = History(at.velocity, before.newer)
    return select(due(tick, pilot.cascade.schedule.position), now, before)


@kernel
def _begun(recovery_state: RecoveryState, alarm: float, time: float) -> RecoveryState:
    """An alarm while the robot looks is of the same collision."""
    if (alarm > 0.5) & (recovery_state.phase != LOOK):
        return on_alarm(recovery_state, time)
    return recovery_state


@kernel
def _made_out(
    pilot: RecoveryPilot,
    time: float,
    seen: Measurement,
    at: Estimate,
    observation: CollisionObservation,
    wrench: ExternalWrench,
    before: RecoveryState,
    recovery_state: RecoveryState,
    m: RecoveryPilotMemory,
) -> Collision:
    """The last collision: where it was noticed, and once the window is over what it was."""
    new = before.phase != LOOK
    position = select(new, at.position, m.collision.position)
    velocity = select(new, m.history.older, m.collision.velocity)
    return characterise(
        pilot.look, pilot.cascade.airframe, seen, at, wrench, observation, position, velocity
    )


@kernel
def _gone(
    pilot: RecoveryPilot,
    time: float,
    at: Estimate,
    observation: CollisionObservation,
    hit: Collision,
    recovery_state: RecoveryState,
    wanted: Target,
) -> RecoveryState:
    if looked_enough(pilot.look, observation, hit.arms, time - recovery_state.since):
        return on_characterised(pilot.route, recovery_state, hit, at, time, wanted.yaw)
    return recovery_state


class Considered(NamedTuple):
    """What a pilot that looks at a collision makes of it."""

    observation: CollisionObservation
    collision: Collision
    recovery_state: RecoveryState


@kernel
def _considered(
    pilot: RecoveryPilot,
    time: float,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    m: RecoveryPilotMemory,
) -> Considered:
    airframe = pilot.cascade.airframe
    recovery_state = _begun(m.recovery_state, m.alarm, time)
    fresh = select((recovery_state.phase == LOOK) & (m.recovery_state.phase == LOOK), 1.0, 0.0)
    so_far = select(fresh > 0.5, m.observation, no_observation(airframe))
    observation = observe(pilot.look, airframe, seen, at, wrench, so_far)
    hit = _made_out(pilot, time, seen, at, observation, wrench, m.recovery_state, recovery_state, m)
    gone = _gone(pilot, time, at, observation, hit, recovery_state, m.flight.offboard.wanted)
    return Considered(observation, hit, gone)


@kernel
def _observing(pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, i: int) -> Any:
    """What the observer of one lane goes by: arguments of `observed_wrench`."""
    memory, flight = avionics.onboard.pilot, avionics.onboard.pilot.flight
    return (
        load(pilot.observer, g, w, i),
        load(pilot.cascade.airframe, g, w, i),
        load(flight.autopilot.built.tree.inertia, g, w, i),
        load(avionics.onboard.measurement, g, w, i),
        load(flight.estimate, g, w, i),
        load(flight.autopilot.thrust, g, w, i),
        load(memory.wrench, g, w, i),
    )


@kernel
def _watch(
    pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, once: int, tick: float
) -> int:
    """The observers and triggers of all lanes; how many lanes have something to consider."""
    memory, seen = avionics.onboard.pilot, avionics.onboard.measurement
    waiting, stirred = 0, 0
    for i in range(w * once):
        waiting += 0 if load(seen.inertial.fresh, g, w, i) > 0.5 else 1
    for i in range(w * once if waiting == 0 else 0):  # the same, without a choice
        x = _observing(pilot, avionics, g, w, i)
        store(renewed_wrench(*x), memory.wrench, g, w, i)
    for i in range(w * once if waiting > 0 else 0):
        x = _observing(pilot, avionics, g, w, i)
        store(observed_wrench(*x), memory.wrench, g, w, i)
    for i in range(w * once):
        airframe, said = load(pilot.cascade.airframe, g, w, i), load(seen, g, w, i)
        at, wrench = load(memory.flight.estimate, g, w, i), load(memory.wrench, g, w, i)
        time = tick * load(avionics.systems.period, g, w, i)
        triggers, so_far = load(pilot.detection, g, w, i), load(memory.detection, g, w, i)
        noticed = detected(triggers, airframe.arms, time, said, at, wrench, so_far)
        store(noticed.memory, memory.detection, g, w, i)
        store(noticed.alarm, memory.alarm, g, w, i)
        looks = (noticed.alarm > 0.5) | (load(memory.recovery_state.phase, g, w, i) == LOOK)
        stirred += 1 if looks else 0
    return stirred


@kernel
def _travel(
    pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, once: int, tick: float
) -> None:
    """The journeys of all lanes that have nothing to consider: mostly, time goes by."""
    memory, arrived = avionics.onboard.pilot, 0
    for i in range(w * once):
        time = tick * load(avionics.systems.period, g, w, i)
        alarm, recovery_state = load(memory.alarm, g, w, i), load(memory.recovery_state, g, w, i)
        calm = (alarm < 0.5) & (recovery_state.phase != LOOK)
        route, at = load(pilot.route, g, w, i), load(memory.flight.estimate, g, w, i)
        passed = phase_end(route, recovery_state, at, time)
        store(select(calm, passed.near, recovery_state.near), memory.recovery_state.near, g, w, i)
        store(select(calm, passed.turns, 0.0), memory.alarm, g, w, i)
        arrived += 1 if calm & (passed.turns > 0.5) else 0
    for i in range(w if arrived > 0 else 0):
        if load(memory.alarm, g, w, i) > 0.5:
            time = tick * load(avionics.systems.period, g, w, i)
            route, recovery_state = load(pilot.route, g, w, i), load(memory.recovery_state, g, w, i)
            at, hit = load(memory.flight.estimate, g, w, i), load(memory.collision, g, w, i)
            yaw = load(memory.flight.offboard.wanted.yaw, g, w, i)
            store(
                on_phase_end(route, recovery_state, hit, at, time, yaw),
                memory.recovery_state,
                g,
                w,
                i,
            )


@decide.register(RecoveryPilot)
@kernel
def _decide(
    pilot: TreeLayout, avionics: TreeLayout, g: Buffer, w: int, once: int, tick: float
) -> None:
    """`pilot_step`, step by step for all lanes; collisions are considered one by one."""
    memory, seen = avionics.onboard.pilot, avionics.onboard.measurement
    flight, cascade = memory.flight, pilot.cascade
    believe(cascade.estimator, seen, flight.estimator, flight.estimate, flight.tick, g, w, once)
    stirred = _watch(pilot, avionics, g, w, once, tick)
    for i in range(w if stirred > 0 else 0):
        m = load(memory, g, w, i)
        if m.alarm > 0.5 or m.recovery_state.phase == LOOK:
            settings, said = load(pilot, g, w, i), load(seen, g, w, i)
            time = tick * load(avionics.systems.period, g, w, i)
            now = _considered(settings, time, said, m.flight.estimate, m.wrench, m)
            store(now.observation, memory.observation, g, w, i)
            store(now.collision, memory.collision, g, w, i)
            store(now.recovery_state, memory.recovery_state, g, w, i)
            store(1.0, memory.alarm, g, w, i)  # it has travelled
    _travel(pilot, avionics, g, w, once, tick)
    if any_due(cascade.schedule.position, g, w, once, tick):
        hear(flight, g, w, once)  # before it is overtaken by the next word
        steer(pilot.route.response, pilot, avionics, g, w, once, tick)
        for i in range(w * once):
            settings, at = load(pilot, g, w, i), load(flight.estimate, g, w, i)
            past = _remembered(settings, tick, at, load(memory.history, g, w, i))
            store(past, memory.history, g, w, i)
    fly_on(cascade, flight, seen.arm_length, avionics.onboard.command, g, w, once, tick)


class RecoveryTelemetry(NamedTuple):
    """What the pilot tells the telemetry."""

    estimate: Estimate
    wanted: Target
    aim: Any
    setpoint: Vec
    phase: float
    goal: Vec  # p_r, or where the leg leads [m]
    pressed: float  # the Hall sensors' signal [m]
    jolt: float  # the accelerometer's [m/s²]
    push: float  # the wrench's [N]
    alarms: tuple[float, float, float]  # of each trigger so far
    force: Vec  # external, world [N]
    moment: Vec  # external, body axes [N m]
    direction: Vec  # f_c⁰ of the last collision


@telemetry_of.register(RecoveryPilot)
@kernel
def _tells(pilot: RecoveryPilot, memory: RecoveryPilotMemory) -> RecoveryTelemetry:
    m, w, d = memory.flight, memory.wrench, memory.detection
    words = CascadeTelemetry(m.estimate, m.offboard.wanted, m.autopilot.aim, m.autopilot.setpoint)
    return RecoveryTelemetry(
        words.estimate, words.wanted, words.aim, words.setpoint,
        memory.recovery_state.phase, memory.recovery_state.goal,
        d.hall.filtered, d.acceleration.filtered, d.wrench.filtered,
        (d.hall.alarms, d.acceleration.alarms, d.wrench.alarms),
        w.force, w.moment, memory.collision.direction,
    )  # fmt: skip
