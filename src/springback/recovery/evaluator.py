"""The evaluator of recoveries: it knows the true motion, which the pilot never does.

A run is judged from first touch until the robot has come to rest where it should: at p_r or, where
it could rest there only against the obstacle, at home.  At rest it touches nothing, is nearer than
a tolerance and slow, and stays so for a while (`RecoverySettings`).

Of a pilot of the user's own nothing is known but the motion of its vehicle and the alarms that it
reports (`RestEvaluator`): it is at rest wherever it is slow and touches nothing for that while.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.angles import angle_of
from springback.kernels.compiler import kernel
from springback.kernels.layout import TreeLayout, load, store
from springback.kernels.trees import replace, select
from springback.kernels.vectors import Vec, norm, rotation
from springback.recovery.pilot import RecoveryPilotMemory
from springback.recovery.state_machine import HOVER, LOOK, RECOVER, RecoveryState
from springback.simulation.measuring.record import Contacts
from springback.simulation.onboard import UserPilotMemory, evaluator_step
from springback.simulation.ticks import Group, contacts_of, evaluate, evaluate_lanes
from springback.vehicle.state import State

NOT_YET = -1.0


class Evaluator(NamedTuple):
    """Bounds within which a robot has settled."""

    tolerance: float  # distance from p_r [m]
    slow: float  # speed [m/s]
    dwell: float  # time within both [s]


class RestEvaluator(NamedTuple):
    """Bounds within which a robot is at rest, anywhere."""

    slow: float  # speed [m/s]
    dwell: float  # time below it without contact [s]


class Run(NamedTuple):
    """One collision and the recovery from it, until the robot has settled."""

    touch: float  # time of the first tick in contact [s], `NOT_YET` before
    place: Vec  # position of the main body at first touch, world [m]
    alarm: float  # time of the pilot's alarm since then [s], `NOT_YET` before
    alarm_place: Vec  # position of the main body at the last alarm, world [m]
    settled: float  # time at which rest began [s], `NOT_YET` until it has lasted for the dwell time
    near: float  # time at which rest may have begun [s], `NOT_YET` if not at rest
    lowest: float  # least height of the main body [m]
    nose_down: float  # largest pitch [rad]
    nose_up: float  # smallest pitch; the largest nose-up pitch is minus this [rad]
    excursion: float  # largest horizontal distance from the place of first touch [m]
    path: float  # length of the path since then [m]
    contacts: float  # number of contacts of the vehicle on this run


class EvaluatorMemory(NamedTuple):
    """Memory of the evaluator."""

    contacts: float  # number of contacts of the vehicle so far
    open: float  # 1 while a run is judged
    position: Vec  # at the last tick [m]
    run: Run  # the last
    runs: float  # number of runs begun
    recovered: float  # number of runs that ended at rest
    false_alarms: float  # number of alarms without a contact before
    alarm_seen: float  # time of the last alarm that was counted [s]
    lowest: float  # least height over the whole flight [m]


def evaluator_at_start(position: Vec) -> EvaluatorMemory:
    """Memory of the evaluator before the flight."""
    run = Run(
        NOT_YET, position, NOT_YET, position, NOT_YET, NOT_YET, position.z, 0.0, 0.0, 0.0, 0.0, 0.0
    )
    return EvaluatorMemory(0.0, 0.0, position, run, 0.0, 0.0, 0.0, NOT_YET, position.z)


@kernel
def pitch_of(up: Vec) -> float:
    """Pitch in the X–Z plane, positive nose down, from −π to π [rad]; ``up`` is R e_z."""
    return angle_of(up.x, up.z)


@kernel
def _state_pitch(state: State) -> float:
    r = rotation(state.attitude)
    return pitch_of(Vec(r.x.z, r.y.z, r.z.z))


@kernel
def _new_run(time: float, state: State, pitch: float) -> Run:
    p = state.position
    return Run(time, p, NOT_YET, p, NOT_YET, NOT_YET, p.z, pitch, pitch, 0.0, 0.0, 0.0)


class EvaluatedMotion(NamedTuple):
    """Motion of the vehicle at a tick, and the state of its recovery."""

    time: float  # [s]
    state: State
    pitch: float  # [rad]
    touching: float  # 1 while any cage, or the hull, touches
    recovery_state: RecoveryState


@kernel
def _motion_after(
    run: Run, time: float, state: State, pitch: float, near: bool, dwell: float, last_position: Vec
) -> Run:
    """A run after one more tick, without its alarm.

    Args:
        run: Before.
        time: [s].
        state: True state of the vehicle.
        pitch: [rad].
        near: True if the robot may be at rest.
        dwell: Time after which it is [s].
        last_position: Of the main body before the tick [m].
    """
    p, way = state.position, state.position - run.place
    began = select(run.near < 0.0, time, run.near)
    near_since = select(near, began, NOT_YET)
    settled = (near_since >= 0.0) & (time - near_since >= dwell)
    away = math.sqrt(way.x * way.x + way.y * way.y)
    return replace(
        run,
        settled=select(settled, near_since, NOT_YET),
        near=near_since,
        lowest=select(p.z < run.lowest, p.z, run.lowest),
        nose_down=select(pitch > run.nose_down, pitch, run.nose_down),
        nose_up=select(pitch < run.nose_up, pitch, run.nose_up),
        excursion=select(away > run.excursion, away, run.excursion),
        path=run.path + norm(p - last_position),
    )


@kernel
def _is_slow(state: State, slow: float) -> bool:
    return state.velocity @ state.velocity < slow * slow


@kernel
def _run_after(evaluator: Evaluator, now: EvaluatedMotion, last_position: Vec, run: Run) -> Run:
    """A run after one more tick; before it, the main body was at ``last_position``."""
    recovery, time = now.recovery_state, now.time
    gap = now.state.position - recovery.goal
    near = gap @ gap < evaluator.tolerance * evaluator.tolerance
    near &= _is_slow(now.state, evaluator.slow)
    near &= (recovery.phase >= RECOVER) & (now.touching < 0.5)
    after = _motion_after(run, time, now.state, now.pitch, near, evaluator.dwell, last_position)
    # An alarm may come just before the tick of first touch.
    raised = (recovery.log.alarm >= run.touch - EARLY) & (run.alarm < 0.0)
    raised &= recovery.phase >= LOOK
    raised_now = (recovery.phase == LOOK) & (recovery.phase_start >= time - TINY)
    return replace(
        after,
        alarm=select(raised, recovery.log.alarm, run.alarm),
        alarm_place=select(raised_now, now.state.position, run.alarm_place),
    )


#: Rounding of times [s].
TINY = 1e-9
#: A contact between two ticks is seen at the later; an alarm this much earlier is not false [s].
EARLY = 2e-3


@evaluator_step.register(Evaluator)
@kernel
def _evaluator_step(
    evaluator: Evaluator,
    time: float,
    state: State,
    contacts: Contacts,
    pilot: RecoveryPilotMemory,
    memory: EvaluatorMemory,
) -> EvaluatorMemory:
    m, p, recovery = memory, state.position, pilot.recovery_state
    pitch = _state_pitch(state)
    touches = contacts.total > m.contacts
    # A new touch during a recovery belongs to it, and the robot has not come to rest after all.
    recovering = (recovery.phase > LOOK) & (recovery.phase < HOVER) & (m.runs > 0.5)
    begins = touches & (m.open < 0.5) & (not recovering)
    again = touches & (m.open < 0.5) & recovering
    run = select(begins, _new_run(time, state, pitch), m.run)
    open_now = select(begins | again, 1.0, m.open)
    motion = EvaluatedMotion(time, state, pitch, contacts.touching, recovery)
    after = select(open_now > 0.5, _run_after(evaluator, motion, m.position, run), run)
    new_contacts = select(touches, contacts.total - m.contacts, 0.0)
    after = replace(after, contacts=after.contacts + new_contacts)
    settles = (open_now > 0.5) & (after.settled >= 0.0)
    alarm = recovery.log.alarm
    caused = (open_now > 0.5) | _is_recent(contacts, time)
    return EvaluatorMemory(
        contacts=contacts.total,
        open=select(settles, 0.0, open_now),
        position=p,
        run=after,
        runs=m.runs + select(begins, 1.0, 0.0),
        recovered=m.recovered + select(settles, 1.0, 0.0) - select(again, 1.0, 0.0),
        false_alarms=_false_alarms(m, alarm, caused),
        alarm_seen=select(alarm > m.alarm_seen, alarm, m.alarm_seen),
        lowest=select(p.z < m.lowest, p.z, m.lowest),
    )


@evaluator_step.register(RestEvaluator)
@kernel
def _rest_evaluator_step(
    evaluator: RestEvaluator,
    time: float,
    state: State,
    contacts: Contacts,
    pilot: UserPilotMemory,
    memory: EvaluatorMemory,
) -> EvaluatorMemory:
    """A run lasts from a touch until rest; a touch before that belongs to it, a later one not."""
    m, p, pitch, raised = memory, state.position, _state_pitch(state), pilot.report.raised
    touches = contacts.total > m.contacts
    begins = touches & (m.open < 0.5)
    run = select(begins, _new_run(time, state, pitch), m.run)
    is_open = begins | (m.open > 0.5)
    near = _is_slow(state, evaluator.slow) & (contacts.touching < 0.5)
    moved = _motion_after(run, time, state, pitch, near, evaluator.dwell, m.position)
    is_first = (raised >= run.touch - EARLY) & (run.alarm < 0.0)
    noticed = replace(moved, alarm=select(is_first, raised, run.alarm))
    after = select(is_open, noticed, run)
    new_contacts = select(touches, contacts.total - m.contacts, 0.0)
    settles = is_open & (after.settled >= 0.0)
    return replace(
        m,
        contacts=contacts.total,
        open=select(is_open & (not settles), 1.0, 0.0),
        position=p,
        run=replace(after, contacts=after.contacts + new_contacts),
        runs=m.runs + select(begins, 1.0, 0.0),
        recovered=m.recovered + select(settles, 1.0, 0.0),
        false_alarms=_false_alarms(m, raised, is_open | _is_recent(contacts, time)),
        alarm_seen=select(raised > m.alarm_seen, raised, m.alarm_seen),
        lowest=select(p.z < m.lowest, p.z, m.lowest),
    )


@kernel
def _running(group: Group) -> int:
    """Number of lanes in which a run is open or begins."""
    avionics, g, w, once, _ = group.lanes
    memory, running = avionics.onboard.evaluator, 0
    for i in range(w * once):
        contacts, is_open = contacts_of(group, i).total, load(memory.open, g, w, i) > 0.5
        running += 1 if is_open | (contacts > load(memory.contacts, g, w, i)) else 0
    return running


@evaluate.register(RestEvaluator)
@kernel
def _evaluate_rest(evaluator: TreeLayout, group: Group) -> None:
    """Batch version of `evaluator_step`; where no run is open and none begins, little of it."""
    avionics, g, w, once, tick = group.lanes
    memory, report, running = (
        avionics.onboard.evaluator,
        avionics.onboard.pilot.report,
        _running(group),
    )
    for i in range(w * once if running == 0 else 0):
        time, m = tick * load(avionics.systems.period, g, w, i), load(memory, g, w, i)
        position = load(group.shape.motion.state.position, group.motion, w, i)
        raised, contacts_now = load(report.raised, g, w, i), contacts_of(group, i)
        store(between_runs(time, position, raised, contacts_now, m), memory, g, w, i)
    if running > 0:
        evaluate_lanes(evaluator, group)


@evaluate.register(Evaluator)
@kernel
def _evaluate(evaluator: TreeLayout, group: Group) -> None:
    """Batch version of `evaluator_step`; where no run is open and none begins, little of it."""
    avionics, g, w, once, tick = group.lanes
    memory, recovery = avionics.onboard.evaluator, avionics.onboard.pilot.recovery_state
    running = _running(group)
    for i in range(w * once if running == 0 else 0):
        time, m = tick * load(avionics.systems.period, g, w, i), load(memory, g, w, i)
        position = load(group.shape.motion.state.position, group.motion, w, i)
        alarm, contacts_now = load(recovery.log.alarm, g, w, i), contacts_of(group, i)
        store(between_runs(time, position, alarm, contacts_now, m), memory, g, w, i)
    if running > 0:
        evaluate_lanes(evaluator, group)


@kernel
def _false_alarms(m: EvaluatorMemory, alarm: float, caused: bool) -> float:
    """Number of false alarms after a tick with a last alarm, caused by a contact or not."""
    return m.false_alarms + select((alarm > m.alarm_seen) & (not caused), 1.0, 0.0)


@kernel
def _is_recent(contacts: Contacts, time: float) -> bool:
    """True if the last contact is under way or just over, so that it may cause an alarm."""
    return (contacts.last_touch_time >= 0.0) & (time - contacts.last_touch_time < LINGERING)


@kernel
def between_runs(
    time: float, position: Vec, alarm: float, contacts: Contacts, m: EvaluatorMemory
) -> EvaluatorMemory:
    """Memory of the evaluator after a tick without a run."""
    return replace(
        m,
        position=position,
        false_alarms=_false_alarms(m, alarm, _is_recent(contacts, time)),
        alarm_seen=select(alarm > m.alarm_seen, alarm, m.alarm_seen),
        lowest=select(position.z < m.lowest, position.z, m.lowest),
    )


#: Time after the last contact in which an alarm still belongs to it [s]; chosen for the delays of
#: sensors and filters.
LINGERING = 0.1
