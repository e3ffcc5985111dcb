"""The pilot that recovers from collisions: it detects, characterises and answers them.

It is the cascade of `springback.control.cascade` with an observer and triggers: estimator and loops
are the same, and the phase of the recovery decides which reference they follow.  It acts only on
measurements and estimates.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.control.cascade import (
    Cascade,
    CascadeMemory,
    Offboard,
    fly_on,
    hear,
    position_loop,
)
from springback.control.target import Target
from springback.kernels.compiler import generic, kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.trees import select
from springback.kernels.vectors import Vec
from springback.recovery.characterisation import (
    Characterisation,
    Collision,
    CollisionObservation,
    CollisionStart,
    characterise,
    no_collision,
    no_observation,
    observation_after,
    window_is_over,
)
from springback.recovery.detection import (
    NOT_DETECTED,
    CollisionInputs,
    Detection,
    DetectionMemory,
    detection_step,
)
from springback.recovery.detector import (
    NoDetector,
    detected_direction,
    detector_alarm,
)
from springback.recovery.response import Staged
from springback.recovery.stages import stage_command
from springback.recovery.state_machine import (
    CRUISE,
    LOOK,
    RECOVER,
    STAGES,
    DelayedReference,
    JerkFreeReference,
    RecoveryState,
    Route,
    on_alarm,
    on_characterisation,
    on_phase_end,
    phase_end,
    recovery_at_start,
)
from springback.recovery.wrench import (
    ExternalWrench,
    Observer,
    WrenchInputs,
    no_wrench,
    sampled_wrench,
    wrench_after,
)
from springback.sensing.measurement import Estimate, Measurement, any_due, believe, due
from springback.simulation.onboard import telemetry_of
from springback.simulation.ticks import Lanes, decide


class RecoveryPilot(NamedTuple):
    """Settings of the pilot."""

    cascade: Cascade  # its reference is the run-up
    observer: Observer
    detection: Detection
    characterisation: Characterisation
    route: Route
    detector: Any  # of the user's own, registered with detector_step; or NoDetector


class History(NamedTuple):
    """Estimated velocity at the last two ticks of the position loop.

    The older one is at least a period old.  As a collision is detected later than it begins, it is
    the velocity before the collision.
    """

    newer: Vec  # world [m/s]
    older: Vec


class RecoveryPilotMemory(NamedTuple):
    """Memory of the pilot."""

    flight: CascadeMemory
    wrench: ExternalWrench
    detection: DetectionMemory
    observation: CollisionObservation
    collision: Collision  # the last
    history: History
    recovery_state: RecoveryState
    alarm: float
    """1 while a lane has an event to process at this tick, an alarm or the end of a phase."""
    detector: Any  # DetectorMemory or NoDetector


def recovery_pilot_memory(
    pilot: RecoveryPilot, flight: CascadeMemory, detector: Any
) -> RecoveryPilotMemory:
    """Memory of a pilot before tick 0.

    Args:
        pilot: Settings.
        flight: Memory of the cascade, from `springback.control.cascade.cascade_memory`.
        detector: From `springback.recovery.detector.detector_memory`, or `NoDetector`.
    """
    start, airframe = flight.estimate, pilot.cascade.airframe
    nothing = no_collision(airframe)
    return RecoveryPilotMemory(
        flight,
        no_wrench(pilot.observer, airframe, start, flight.autopilot.thrust),
        NOT_DETECTED,
        no_observation(airframe),
        nothing,
        History(start.velocity, start.velocity),
        recovery_at_start(pilot.route, nothing),
        0.0,
        detector,
    )


class StagedCommand(NamedTuple):
    """Position loop after a tick, and the stage of a staged response."""

    offboard: Offboard
    stage: float


@kernel
def _phase_command(
    pilot: RecoveryPilot, tick: float, time: float, m: RecoveryPilotMemory
) -> Offboard:
    """Position loop on the reference of the phase, or while LOOK of that before it."""
    c, at, before, state = pilot.cascade, m.flight.estimate, m.flight.offboard, m.recovery_state
    if state.followed == CRUISE:
        reference = DelayedReference(c.reference, state.run_start)
        return position_loop(c, reference, tick, time, at, before)
    if state.followed <= RECOVER:
        return position_loop(c, JerkFreeReference(state.recovery_reference), tick, time, at, before)
    return position_loop(c, JerkFreeReference(state.return_reference), tick, time, at, before)


@kernel
def _staged_command(
    response: Staged, pilot: RecoveryPilot, tick: float, time: float, m: RecoveryPilotMemory
) -> StagedCommand:
    c, before, state = pilot.cascade, m.flight.offboard, m.recovery_state
    if state.phase == STAGES:
        yaw, at = before.wanted.yaw, m.flight.estimate
        now = stage_command(response, c.position, m.collision, at, yaw, state.stage)
        arrival = tick + c.schedule.delay
        return StagedCommand(Offboard(before.position, before.wanted, now.word, arrival), now.stage)
    if state.followed == STAGES:  # while LOOK: its direction is being found again
        return StagedCommand(before, state.stage)
    return StagedCommand(_phase_command(pilot, tick, time, m), state.stage)


@generic
def steer(response: TreeLayout, pilot: TreeLayout, lanes: Lanes) -> None:
    """Run the position loops of all lanes on the references of their phases.

    While LOOK a lane keeps the reference of the phase in which the alarm was raised.

    Args:
        response: Layout of its settings, on whose type it dispatches.
        pilot: Layout of the pilot's settings.
        lanes: Of a group.
    """
    avionics, g, w, once, _ = lanes
    memory, flight, cascade = avionics.onboard.pilot, avionics.onboard.pilot.flight, pilot.cascade
    state, cruising, recovering, returning = memory.recovery_state, 0, 0, 0
    for i in range(w * once):
        followed = load(state.followed, g, w, i)
        cruising += 1 if followed == CRUISE else 0
        recovering += 1 if (followed > LOOK) & (followed <= RECOVER) else 0
        returning += 1 if followed > RECOVER else 0
    # References take long to evaluate, and nearly always all lanes have the same: one at a time.
    for i in range(w * once if cruising > 0 else 0):
        start = load(state.run_start, g, w, i)
        reference = DelayedReference(load(cascade.reference, g, w, i), start)
        now, before = _steer_lane(pilot, reference, lanes, i), load(flight.offboard, g, w, i)
        mine = load(state.followed, g, w, i) == CRUISE
        store(select(mine, now, before), flight.offboard, g, w, i)
    for i in range(w * once if recovering > 0 else 0):
        way = JerkFreeReference(load(state.recovery_reference, g, w, i))
        now, before = _steer_lane(pilot, way, lanes, i), load(flight.offboard, g, w, i)
        followed = load(state.followed, g, w, i)
        mine = (followed > LOOK) & (followed <= RECOVER)
        store(select(mine, now, before), flight.offboard, g, w, i)
    for i in range(w * once if returning > 0 else 0):
        way = JerkFreeReference(load(state.return_reference, g, w, i))
        now, before = _steer_lane(pilot, way, lanes, i), load(flight.offboard, g, w, i)
        mine = load(state.followed, g, w, i) > RECOVER
        store(select(mine, now, before), flight.offboard, g, w, i)


@kernel
def _steer_lane(pilot: TreeLayout, reference: Any, lanes: Lanes, i: int) -> Offboard:
    """Position loop of one lane on a reference."""
    avionics, g, w, _, tick = lanes
    flight, time = avionics.onboard.pilot.flight, tick * load(avionics.systems.period, g, w, i)
    at, before = load(flight.estimate, g, w, i), load(flight.offboard, g, w, i)
    return position_loop(load(pilot.cascade, g, w, i), reference, tick, time, at, before)


@steer.register(Staged)
@kernel
def _steer_in_stages(response: TreeLayout, pilot: TreeLayout, lanes: Lanes) -> None:
    avionics, g, w, _, tick = lanes
    memory = avionics.onboard.pilot
    for i in range(w):
        settings, time = load(pilot, g, w, i), tick * load(avionics.systems.period, g, w, i)
        if due(tick, settings.cascade.schedule.position):
            m = load(memory, g, w, i)
            now = _staged_command(settings.route.response, settings, tick, time, m)
            store(now.offboard, memory.flight.offboard, g, w, i)
            store(now.stage, memory.recovery_state.stage, g, w, i)


@kernel
def _history_after(pilot: RecoveryPilot, tick: float, at: Estimate, before: History) -> History:
    now = History(at.velocity, before.newer)
    return select(due(tick, pilot.cascade.schedule.position), now, before)


@kernel
def _state_after_alarm(state: RecoveryState, alarm: float, time: float) -> RecoveryState:
    """State of the recovery; an alarm during the observation window is of the same collision."""
    if (alarm > 0.5) & (state.phase != LOOK):
        return on_alarm(state, time)
    return state


@kernel
def _collision(
    pilot: RecoveryPilot,
    measurement: Measurement,
    observation: CollisionObservation,
    m: RecoveryPilotMemory,
) -> Collision:
    """The last collision, with the place of its alarm, as far as it is observed."""
    new, at = m.recovery_state.phase != LOOK, m.flight.estimate
    before = CollisionStart(
        select(new, at.position, m.collision.position),
        select(new, m.history.older, m.collision.velocity),
        detected_direction(m.detector),
    )
    inputs = CollisionInputs(pilot.cascade.airframe, measurement, at, m.wrench)
    return characterise(pilot.characterisation, inputs, observation, before)


@kernel
def _state_after_window(
    pilot: RecoveryPilot,
    time: float,
    observation: CollisionObservation,
    hit: Collision,
    state: RecoveryState,
    flight: CascadeMemory,
) -> RecoveryState:
    if window_is_over(pilot.characterisation, observation, hit.arms, time - state.phase_start):
        yaw = flight.offboard.wanted.yaw
        return on_characterisation(pilot.route, state, hit, flight.estimate, time, yaw)
    return state


class WindowStep(NamedTuple):
    """Observation, collision and state of the recovery after a tick of the observation window."""

    observation: CollisionObservation
    collision: Collision
    recovery_state: RecoveryState


@kernel
def _window_step(
    pilot: RecoveryPilot, time: float, measurement: Measurement, m: RecoveryPilotMemory
) -> WindowStep:
    airframe, before = pilot.cascade.airframe, m.recovery_state
    state = _state_after_alarm(before, m.alarm, time)
    goes_on = select((state.phase == LOOK) & (before.phase == LOOK), 1.0, 0.0)
    so_far = select(goes_on > 0.5, m.observation, no_observation(airframe))
    inputs = CollisionInputs(airframe, measurement, m.flight.estimate, m.wrench)
    observation = observation_after(pilot.characterisation, inputs, so_far)
    hit = _collision(pilot, measurement, observation, m)
    after = _state_after_window(pilot, time, observation, hit, state, m.flight)
    return WindowStep(observation, hit, after)


@kernel
def _wrench_inputs(pilot: TreeLayout, lanes: Lanes, i: int) -> WrenchInputs:
    """Inputs of one lane's observer."""
    avionics, g, w, _, _ = lanes
    flight = avionics.onboard.pilot.flight
    return WrenchInputs(
        load(pilot.cascade.airframe, g, w, i),
        load(flight.autopilot.built.tree.inertia, g, w, i),
        load(avionics.onboard.measurement, g, w, i),
        load(flight.estimate, g, w, i),
        load(flight.autopilot.thrust, g, w, i),
    )


@kernel
def _collision_inputs(pilot: TreeLayout, lanes: Lanes, i: int) -> CollisionInputs:
    """Inputs of one lane's detection."""
    avionics, g, w, _, _ = lanes
    memory = avionics.onboard.pilot
    return CollisionInputs(
        load(pilot.cascade.airframe, g, w, i),
        load(avionics.onboard.measurement, g, w, i),
        load(memory.flight.estimate, g, w, i),
        load(memory.wrench, g, w, i),
    )


@generic
def _detect_otherwise(detector: TreeLayout, pilot: TreeLayout, lanes: Lanes) -> int:
    """Run the users' own detectors of all lanes; returns the number of lanes with an alarm."""
    return _detect_one_by_one(detector, pilot, lanes)


@_detect_otherwise.register(NoDetector)
@kernel
def _detect_nothing(detector: TreeLayout, pilot: TreeLayout, lanes: Lanes) -> int:
    return 0


@kernel
def _detect_one_by_one(detector: TreeLayout, pilot: TreeLayout, lanes: Lanes) -> int:
    avionics, g, w, _, tick = lanes
    memory, alarms = avionics.onboard.pilot, 0
    for i in range(w):
        time = tick * load(avionics.systems.period, g, w, i)
        alarm, before = load(memory.alarm, g, w, i), load(memory.detector, g, w, i)
        looks, inputs = (
            load(memory.recovery_state.phase, g, w, i) == LOOK,
            _collision_inputs(pilot, lanes, i),
        )
        now = detector_alarm(load(detector, g, w, i), time, inputs, alarm, looks, before)
        store(now.memory, memory.detector, g, w, i)
        store(now.alarm, memory.alarm, g, w, i)
        alarms += 1 if now.alarm > 0.5 else 0
    return alarms


@kernel
def _detect(pilot: TreeLayout, lanes: Lanes) -> int:
    """Run observers and detectors of all lanes; returns 0 if none of them has a collision."""
    avionics, g, w, once, tick = lanes
    memory, measured = avionics.onboard.pilot, avionics.onboard.measurement
    waiting, collisions = 0, 0
    for i in range(w * once):
        waiting += 0 if load(measured.inertial.fresh, g, w, i) > 0.5 else 1
    for i in range(w * once if waiting == 0 else 0):  # all lanes, so without a selection
        observer, before = load(pilot.observer, g, w, i), load(memory.wrench, g, w, i)
        after = sampled_wrench(observer, _wrench_inputs(pilot, lanes, i), before)
        store(after, memory.wrench, g, w, i)
    for i in range(w * once if waiting > 0 else 0):
        observer, before = load(pilot.observer, g, w, i), load(memory.wrench, g, w, i)
        after = wrench_after(observer, _wrench_inputs(pilot, lanes, i), before)
        store(after, memory.wrench, g, w, i)
    for i in range(w * once):
        inputs = _collision_inputs(pilot, lanes, i)
        time = tick * load(avionics.systems.period, g, w, i)
        triggers, before = load(pilot.detection, g, w, i), load(memory.detection, g, w, i)
        now = detection_step(triggers, time, inputs, before)
        store(now.memory, memory.detection, g, w, i)
        store(now.alarm, memory.alarm, g, w, i)
        looks = (now.alarm > 0.5) | (load(memory.recovery_state.phase, g, w, i) == LOOK)
        collisions += 1 if looks else 0
    return collisions + _detect_otherwise(pilot.detector, pilot, lanes)


@kernel
def _end_phases(pilot: TreeLayout, lanes: Lanes) -> None:
    """Begin the next phase in lanes without a collision whose phase is over, which is rare."""
    avionics, g, w, once, tick = lanes
    memory, ending = avionics.onboard.pilot, 0
    for i in range(w * once):
        time = tick * load(avionics.systems.period, g, w, i)
        alarm, state = load(memory.alarm, g, w, i), load(memory.recovery_state, g, w, i)
        calm = (alarm < 0.5) & (state.phase != LOOK)
        route, at = load(pilot.route, g, w, i), load(memory.flight.estimate, g, w, i)
        end = phase_end(route, state, at, time)
        store(
            select(calm, end.near_since, state.near_since),
            memory.recovery_state.near_since,
            g,
            w,
            i,
        )
        store(select(calm, end.is_over, 0.0), memory.alarm, g, w, i)
        ending += 1 if calm & (end.is_over > 0.5) else 0
    for i in range(w if ending > 0 else 0):
        if load(memory.alarm, g, w, i) > 0.5:
            time = tick * load(avionics.systems.period, g, w, i)
            route, state = load(pilot.route, g, w, i), load(memory.recovery_state, g, w, i)
            at, hit = load(memory.flight.estimate, g, w, i), load(memory.collision, g, w, i)
            yaw = load(memory.flight.offboard.wanted.yaw, g, w, i)
            after = on_phase_end(route, state, hit, at, time, yaw)
            store(after, memory.recovery_state, g, w, i)


@decide.register(RecoveryPilot)
@kernel
def _decide(pilot: TreeLayout, lanes: Lanes) -> None:
    """Batch version of `pilot_step`; collisions are processed lane by lane."""
    avionics, g, w, once, tick = lanes
    memory, measured = avionics.onboard.pilot, avionics.onboard.measurement
    flight, cascade = memory.flight, pilot.cascade
    believe(cascade.estimator, measured, flight.estimator, flight.estimate, flight.tick, lanes)
    collisions = _detect(pilot, lanes)
    for i in range(w if collisions > 0 else 0):
        m = load(memory, g, w, i)
        if m.alarm > 0.5 or m.recovery_state.phase == LOOK:
            settings, measurement = load(pilot, g, w, i), load(measured, g, w, i)
            time = tick * load(avionics.systems.period, g, w, i)
            now = _window_step(settings, time, measurement, m)
            store(now.observation, memory.observation, g, w, i)
            store(now.collision, memory.collision, g, w, i)
            store(now.recovery_state, memory.recovery_state, g, w, i)
            store(1.0, memory.alarm, g, w, i)  # processed: its phase does not end as well
    _end_phases(pilot, lanes)
    if any_due(cascade.schedule.position, lanes):
        hear(flight, lanes)  # before the next command replaces it
        steer(pilot.route.response, pilot, lanes)
        for i in range(w * once):
            settings, at = load(pilot, g, w, i), load(flight.estimate, g, w, i)
            after = _history_after(settings, tick, at, load(memory.history, g, w, i))
            store(after, memory.history, g, w, i)
    fly_on(cascade, flight, measured.arm_length, avionics.onboard.command, lanes)


class RecoveryTelemetry(NamedTuple):
    """Telemetry of the pilot."""

    estimate: Estimate
    wanted: Target
    aim: Any
    setpoint: Vec
    phase: float
    goal: Vec  # p_r, or the goal of another phase [m]
    pressed: float  # signal of the Hall sensors [m]
    jolt: float  # signal of the accelerometer [m/s²]
    push: float  # signal of the wrench [N]
    alarms: tuple[float, float, float]  # of each trigger so far
    force: Vec  # external, world [N]
    moment: Vec  # external, body axes [N m]
    direction: Vec  # f_c⁰ of the last collision


@telemetry_of.register(RecoveryPilot)
@kernel
def _telemetry(pilot: RecoveryPilot, memory: RecoveryPilotMemory) -> RecoveryTelemetry:
    m, w, d = memory.flight, memory.wrench, memory.detection
    return RecoveryTelemetry(
        m.estimate, m.offboard.wanted, m.autopilot.aim, m.autopilot.setpoint,
        memory.recovery_state.phase, memory.recovery_state.goal,
        d.hall.filtered, d.acceleration.filtered, d.wrench.filtered,
        (d.hall.alarms, d.acceleration.alarms, d.wrench.alarms),
        w.force, w.moment, memory.collision.direction,
    )  # fmt: skip
