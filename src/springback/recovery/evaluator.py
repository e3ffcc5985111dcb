"""Who judges a recovery: a witness that sees the truth, which the pilot never does.

A run is judged from first touch until the robot has come to rest where it wants to be, at p_r or,
where it could rest there only against the obstacle, at home: touching nothing, less than a distance
away, slow, and for a while (`RecoverySettings`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.angles import angle_of
from springback.kernels.compiler import kernel
from springback.kernels.layout import Buffer, TreeLayout, load, store
from springback.kernels.trees import replace, select
from springback.kernels.vectors import Vec, norm, rotation
from springback.recovery.pilot import RecoveryPilotMemory
from springback.recovery.state_machine import HOVER, LOOK, RECOVER
from springback.simulation.onboard import ContactReport, evaluated
from springback.simulation.ticks import evaluate, evaluate_lanes, touch_of
from springback.vehicle.state import State

NOT_YET = -1.0


class Evaluator(NamedTuple):
    """What counts as settled."""

    tolerance: float  # from p_r [m]
    slow: float  # [m/s]
    dwell: float  # for so long [s]


class Run(NamedTuple):
    """One collision and what followed, until it settled."""

    touch: float  # first tick in contact [s], `NOT_YET` before
    place: Vec  # of the main body at first touch, world [m]
    alarm: float  # of the pilot, `NOT_YET` if there was none since [s]
    alarm_place: Vec  # of the main body at the last alarm, world [m]
    settled: float  # rest began [s], `NOT_YET` until it has lasted
    near: float  # rest may have begun [s]
    lowest: float  # height of the main body [m]
    nose_down: float  # largest pitch [rad]
    nose_up: float  # smallest pitch, so the largest nose up is minus this [rad]
    excursion: float  # largest level distance from the place of touch [m]
    path: float  # length of the way flown since [m]
    contacts: float  # of the vehicle on this run


class EvaluatorMemory(NamedTuple):
    """What the referee has seen."""

    contacts: float  # of the vehicle, counted so far
    open: float  # 1 while a run is judged
    position: Vec  # at the last tick [m]
    run: Run  # the last
    runs: float  # begun
    recovered: float  # settled
    false_alarms: float  # without any contact before
    alarm_seen: float  # time of the last alarm that was counted [s]
    lowest: float  # height over the whole flight [m]


def evaluator_at_start(position: Vec) -> EvaluatorMemory:
    """Before the flight."""
    run = Run(
        NOT_YET, position, NOT_YET, position, NOT_YET, NOT_YET, position.z, 0.0, 0.0, 0.0, 0.0, 0.0
    )
    return EvaluatorMemory(0.0, 0.0, position, run, 0.0, 0.0, 0.0, NOT_YET, position.z)


@kernel
def pitch_of(up: Vec) -> float:
    """Pitch in the X–Z plane, positive nose down, over the whole turn [rad]; ``up`` is R e_z."""
    return angle_of(up.x, up.z)


@kernel
def _new_run(time: float, state: State, pitch: float) -> Run:
    p = state.position
    return Run(time, p, NOT_YET, p, NOT_YET, NOT_YET, p.z, pitch, pitch, 0.0, 0.0, 0.0)


@kernel
def _followed(
    evaluator: Evaluator,
    time: float,
    state: State,
    pitch: float,
    since: Vec,
    touching: float,
    m: RecoveryPilotMemory,
    run: Run,
) -> Run:
    """A run after one more tick."""
    p, recovery_state = state.position, m.recovery_state
    gap, way = p - recovery_state.goal, p - run.place
    near = gap @ gap < evaluator.tolerance * evaluator.tolerance
    near &= state.velocity @ state.velocity < evaluator.slow * evaluator.slow
    near &= (recovery_state.phase >= RECOVER) & (touching < 0.5)
    began = select(run.near < 0.0, time, run.near)
    near_since = select(near, began, NOT_YET)
    settled = (near_since >= 0.0) & (time - near_since >= evaluator.dwell)
    away = math.sqrt(way.x * way.x + way.y * way.y)
    # An alarm a touch before the tick of first touch belongs to it, too.
    heard = (
        (recovery_state.log.alarm >= run.touch - EARLY)
        & (run.alarm < 0.0)
        & (recovery_state.phase >= LOOK)
    )
    alarmed_now = (recovery_state.phase == LOOK) & (recovery_state.since >= time - TINY)
    return replace(
        run,
        alarm=select(heard, recovery_state.log.alarm, run.alarm),
        alarm_place=select(alarmed_now, p, run.alarm_place),
        settled=select(settled, near_since, NOT_YET),
        near=near_since,
        lowest=select(p.z < run.lowest, p.z, run.lowest),
        nose_down=select(pitch > run.nose_down, pitch, run.nose_down),
        nose_up=select(pitch < run.nose_up, pitch, run.nose_up),
        excursion=select(away > run.excursion, away, run.excursion),
        path=run.path + norm(p - since),
    )


#: Rounding of times [s].
TINY = 1e-9
#: A contact between two ticks is seen at the later one; an alarm so much earlier is not false [s].
EARLY = 2e-3


@evaluated.register(Evaluator)
@kernel
def _judged(
    evaluator: Evaluator,
    time: float,
    state: State,
    touch: ContactReport,
    thought: RecoveryPilotMemory,
    memory: EvaluatorMemory,
) -> EvaluatorMemory:
    m, p = memory, state.position
    r = rotation(state.attitude)
    pitch = pitch_of(Vec(r.x.z, r.y.z, r.z.z))
    came = touch.contacts > m.contacts
    phase = thought.recovery_state.phase
    # Touching again on the way from a collision is part of it, and undoes its rest.
    under_way = (phase > LOOK) & (phase < HOVER) & (m.runs > 0.5)
    begins = came & (m.open < 0.5) & (not under_way)
    again = came & (m.open < 0.5) & under_way
    fresh = _new_run(time, state, pitch)
    run = select(begins, fresh, m.run)
    open_now = select(begins | again, 1.0, m.open)
    watched = _followed(evaluator, time, state, pitch, m.position, touch.touching, thought, run)
    judged = select(open_now > 0.5, watched, run)
    counted = judged.contacts + select(came, touch.contacts - m.contacts, 0.0)
    judged = replace(judged, contacts=counted)
    settles = (open_now > 0.5) & (judged.settled >= 0.0)
    alarm = thought.recovery_state.log.alarm
    caused = (open_now > 0.5) | _lingers(touch, time)
    return EvaluatorMemory(
        contacts=touch.contacts,
        open=select(settles, 0.0, open_now),
        position=p,
        run=judged,
        runs=m.runs + select(begins, 1.0, 0.0),
        recovered=m.recovered + select(settles, 1.0, 0.0) - select(again, 1.0, 0.0),
        false_alarms=_counted_alarms(m, alarm, caused),
        alarm_seen=select(alarm > m.alarm_seen, alarm, m.alarm_seen),
        lowest=select(p.z < m.lowest, p.z, m.lowest),
    )


@evaluate.register(Evaluator)
@kernel
def _judge(
    evaluator: TreeLayout,
    shape: TreeLayout,
    avionics: TreeLayout,
    b: Buffer,
    g: Buffer,
    w: int,
    once: int,
    tick: float,
) -> None:
    """`evaluated` for all lanes; where no run is open and none begins, little of it."""
    memory, recovery_state, running = (
        avionics.onboard.evaluator,
        avionics.onboard.pilot.recovery_state,
        0,
    )
    for i in range(w * once):
        contacts = touch_of(shape, b, w, i).contacts
        is_open = load(memory.open, g, w, i) > 0.5
        running += 1 if is_open | (contacts > load(memory.contacts, g, w, i)) else 0
    for i in range(w * once if running == 0 else 0):
        time, m = tick * load(avionics.systems.period, g, w, i), load(memory, g, w, i)
        position = load(shape.motion.state.position, b, w, i)
        alarm, touch = load(recovery_state.log.alarm, g, w, i), touch_of(shape, b, w, i)
        kept = between_runs(time, position, alarm, touch, m)
        store(kept, memory, g, w, i)
    if running > 0:
        evaluate_lanes(evaluator, shape, avionics, b, g, w, once, tick)


@kernel
def _counted_alarms(m: EvaluatorMemory, alarm: float, caused: bool) -> float:
    """False alarms, this one included."""
    return m.false_alarms + select((alarm > m.alarm_seen) & (not caused), 1.0, 0.0)


@kernel
def _lingers(touch: ContactReport, time: float) -> bool:
    """Whether the last contact answers for an alarm: just over, or still under way."""
    return (touch.last >= 0.0) & (time - touch.last < LINGERING)


@kernel
def between_runs(
    time: float, position: Vec, alarm: float, touch: ContactReport, m: EvaluatorMemory
) -> EvaluatorMemory:
    """What the referee has seen after a tick without a run."""
    return replace(
        m,
        position=position,
        false_alarms=_counted_alarms(m, alarm, _lingers(touch, time)),
        alarm_seen=select(alarm > m.alarm_seen, alarm, m.alarm_seen),
        lowest=select(position.z < m.lowest, position.z, m.lowest),
    )


#: An alarm this long after the last contact is still of it [s], chosen: sensors, filters, delays.
LINGERING = 0.1
