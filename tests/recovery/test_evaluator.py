"""The referee: what counts as a run, as rest, as a false alarm; all on made-up motions."""

import math
from collections.abc import Callable

import pytest

from builders.records import record_of
from builders.resting import resting_memory
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, Vec
from springback.recovery.evaluator import NOT_YET, EvaluatorMemory, between_runs, evaluator_at_start
from springback.recovery.parameters import RecoverySettings
from springback.recovery.pilot import RecoveryPilotMemory
from springback.recovery.state_machine import CRUISE, LOOK, RECOVER, RETURN
from springback.simulation.measuring.record import Contacts
from springback.simulation.onboard import AlarmReport, UserPilotMemory, evaluator_step
from springback.vehicle.state import State

STILL = Vec(0.0, 0.0, 0.0)
GOAL = Vec(2.4, 0.0, 1.0)
REFEREE = RecoverySettings().evaluator()
BY_MOTION = RecoverySettings().rest_evaluator()
TICK = 1e-3


def state(x: float, z: float = 1.0, speed: float = 0.0, pitch: float = 0.0) -> State:
    attitude = Quat(*attitude_from_euler(0.0, pitch, 0.0))
    return State(Vec(x, 0.0, z), attitude, Vec(speed, 0.0, 0.0), STILL, (0.19,) * 4, (0.0,) * 4)


def thinking(phase: float, alarm: float = NOT_YET) -> RecoveryPilotMemory:
    memory = resting_memory()
    recovery_state = memory.recovery_state
    log = recovery_state.log._replace(alarm=alarm)
    return memory._replace(
        recovery_state=recovery_state._replace(phase=phase, goal=GOAL, log=log, phase_start=alarm)
    )


def seen(
    memory: EvaluatorMemory,
    time: float,
    now: State,
    touch: Contacts,
    thought: RecoveryPilotMemory,
) -> EvaluatorMemory:
    """What the referee has seen after a tick; where no run is open, the short way says the same."""
    after: EvaluatorMemory = evaluator_step(REFEREE, time, now, touch, thought, memory)
    if memory.open == 0.0 and touch.total == memory.contacts:
        alarm = thought.recovery_state.log.alarm
        assert between_runs(time, now.position, alarm, touch, memory) == after
    return after


def seen_alone(
    memory: EvaluatorMemory,
    time: float,
    now: State,
    touch: Contacts,
    thought: UserPilotMemory | None,
) -> EvaluatorMemory:
    """What the referee of a pilot of the user's own has seen after a tick."""
    said = thought or reporting(NOT_YET)
    after: EvaluatorMemory = evaluator_step(BY_MOTION, time, now, touch, said, memory)
    if memory.open == 0.0 and touch.total == memory.contacts:
        raised = said.report.raised
        assert between_runs(time, now.position, raised, touch, memory) == after
    return after


def reporting(raised: float) -> UserPilotMemory:
    """Memory of a pilot of the user's own that raised its last alarm at some time."""
    return UserPilotMemory(0.0, AlarmReport(0.0, raised))


class Story:
    """A flight given tick by tick."""

    def __init__(self, sees: Callable[..., EvaluatorMemory] = seen) -> None:
        self.sees = sees
        self.memory, self.time, self.contacts, self.last = (
            evaluator_at_start(Vec(0.0, 0.0, 1.0)),
            0.0,
            0.0,
            -1.0,
        )

    def goes_on(
        self,
        duration: float,
        now: State,
        thought: RecoveryPilotMemory | None = None,
        touching: bool = False,
    ) -> None:
        if touching:
            self.contacts += 1.0
        for _ in range(round(duration / TICK)):
            self.time += TICK
            self.last = self.time if touching else self.last
            touch = record_of(4).contacts._replace(
                touching=1.0 if touching else 0.0, total=self.contacts, last_touch_time=self.last
            )
            self.memory = self.sees(self.memory, self.time, now, touch, thought)


def test_a_recovery() -> None:
    story = Story()
    story.goes_on(1.0, state(2.0, speed=2.0), thinking(CRUISE))
    assert story.memory.runs == 0.0
    story.goes_on(0.03, state(2.5, pitch=0.4), thinking(CRUISE), touching=True)
    story.goes_on(0.5, state(2.2, 0.8, -1.0, -0.7), thinking(RECOVER, alarm=1.01))
    m = story.memory
    assert (m.runs, m.recovered, m.run.settled) == (1.0, 0.0, NOT_YET)
    assert m.run.touch == pytest.approx(1.001)
    assert m.run.alarm == 1.01
    assert m.run.excursion == pytest.approx(0.3)
    assert (m.run.nose_down, m.run.nose_up) == pytest.approx((0.4, -0.7))
    assert m.run.lowest == 0.8
    story.goes_on(0.29, state(2.45), thinking(RECOVER, alarm=1.01))
    assert story.memory.recovered == 0.0
    story.goes_on(0.02, state(2.45), thinking(RECOVER, alarm=1.01))
    assert (story.memory.recovered, story.memory.false_alarms) == (1.0, 0.0)
    assert story.memory.run.settled == pytest.approx(1.531)


@pytest.mark.parametrize("now", [state(2.51), state(2.45, speed=0.31)], ids=["too far", "too fast"])
def test_far_or_fast_is_no_rest(now: State) -> None:
    story = Story()
    story.goes_on(0.03, state(2.5), thinking(CRUISE), touching=True)
    story.goes_on(3.0, now, thinking(RECOVER, alarm=0.01))
    assert story.memory.recovered == 0.0


def test_leaning_on_the_obstacle_is_no_rest() -> None:
    story = Story()
    story.goes_on(2.0, state(2.45), thinking(RECOVER, alarm=0.01), touching=True)
    assert (story.memory.runs, story.memory.recovered) == (1.0, 0.0)


def test_touching_again_on_the_way_undoes_the_rest() -> None:
    story = Story()
    story.goes_on(0.03, state(2.5), thinking(CRUISE), touching=True)
    story.goes_on(0.5, state(2.45), thinking(RECOVER, alarm=0.01))
    assert story.memory.recovered == 1.0
    story.goes_on(0.05, state(2.48), thinking(RETURN, alarm=0.01), touching=True)
    assert (story.memory.runs, story.memory.recovered) == (1.0, 0.0)
    story.goes_on(0.5, state(2.45), thinking(RETURN, alarm=0.01))
    assert (story.memory.runs, story.memory.recovered) == (1.0, 1.0)


def test_a_new_run_up_is_a_new_run() -> None:
    story = Story()
    for k in range(3):
        begins = story.time
        story.goes_on(0.03, state(2.5), thinking(CRUISE), touching=True)
        story.goes_on(0.5, state(2.45), thinking(RECOVER, alarm=begins + 0.02))
        assert (story.memory.runs, story.memory.recovered) == (k + 1.0, k + 1.0)


def test_an_alarm_out_of_the_blue_is_false() -> None:
    story = Story()
    story.goes_on(1.0, state(1.0), thinking(CRUISE))
    story.goes_on(0.5, state(1.0), thinking(LOOK, alarm=1.0))
    assert (story.memory.false_alarms, story.memory.runs) == (1.0, 0.0)
    story.goes_on(0.5, state(1.0), thinking(LOOK, alarm=1.0))
    assert story.memory.false_alarms == 1.0


def test_pitch_counts_beyond_the_right_angle() -> None:
    story = Story()
    story.goes_on(0.03, state(2.5), thinking(CRUISE), touching=True)
    story.goes_on(0.1, state(2.4, pitch=math.radians(-120.0)), thinking(RECOVER, alarm=0.01))
    assert story.memory.run.nose_up == pytest.approx(math.radians(-120.0))


# -- pilots of the user's own ----------------------------------------------------------------------


def test_a_pilot_of_ones_own_has_recovered_where_it_is_slow_and_touches_nothing() -> None:
    story = Story(seen_alone)
    story.goes_on(1.0, state(2.0, z=0.9))
    assert (story.memory.runs, story.memory.lowest) == (0.0, 0.9)
    story.goes_on(0.03, state(2.5, pitch=0.4), touching=True)
    story.goes_on(0.5, state(1.7, 0.8, -1.0, -0.7))
    m = story.memory
    assert (m.runs, m.recovered, m.run.settled) == (1.0, 0.0, NOT_YET)
    assert m.run.touch == pytest.approx(1.001)
    assert m.run.excursion == pytest.approx(0.8)
    assert (m.run.nose_down, m.run.nose_up, m.run.lowest) == pytest.approx((0.4, -0.7, 0.8))
    story.goes_on(0.29, state(0.3, speed=0.29))
    assert story.memory.recovered == 0.0
    story.goes_on(0.02, state(0.3, speed=0.29))
    assert (story.memory.recovered, story.memory.open) == (1.0, 0.0)
    assert story.memory.run.settled == pytest.approx(1.531)
    assert story.memory.run.path == pytest.approx(
        math.hypot(0.5, 0.1) + math.hypot(0.8, 0.2) + math.hypot(1.4, 0.2)
    )


def test_it_has_not_where_it_is_fast_or_leans() -> None:
    for now, touching in (state(0.3, speed=0.31), False), (state(2.5), True):
        story = Story(seen_alone)
        story.goes_on(0.03, state(2.5), touching=True)
        story.goes_on(3.0, now, touching=touching)
        assert (story.memory.runs, story.memory.recovered) == (1.0, 0.0)


def test_its_touch_before_rest_is_of_the_same_run_and_a_later_one_is_not() -> None:
    story = Story(seen_alone)
    for k in range(2):
        story.goes_on(0.03, state(2.5), touching=True)
        story.goes_on(0.2, state(2.4))
        story.goes_on(0.03, state(2.5), touching=True)
        story.goes_on(0.29, state(2.4))
        assert (story.memory.runs, story.memory.recovered) == (k + 1.0, float(k))
        story.goes_on(0.05, state(2.4))
        assert (story.memory.runs, story.memory.recovered) == (k + 1.0, k + 1.0)
        assert story.memory.run.contacts == 2.0


def test_its_alarm_belongs_to_the_touch_before_it_and_is_false_without_one() -> None:
    story = Story(seen_alone)
    story.goes_on(0.5, state(2.0, speed=2.0), reporting(0.2))
    assert (story.memory.false_alarms, story.memory.run.alarm) == (1.0, NOT_YET)
    story.goes_on(0.03, state(2.5), reporting(0.2), touching=True)
    assert (story.memory.false_alarms, story.memory.run.alarm) == (1.0, NOT_YET)
    for raised in (0.52, 0.55, 0.66):  # the first one counts; none is false before it rests
        story.goes_on(0.05, state(2.4), reporting(raised))
        assert (story.memory.false_alarms, story.memory.run.alarm) == (1.0, 0.52)
    story.goes_on(1.0, state(2.4), reporting(0.55))
    assert story.memory.recovered == 1.0
    story.goes_on(0.1, state(2.4), reporting(1.64))
    assert (story.memory.false_alarms, story.memory.run.alarm) == (2.0, 0.52)
