"""What one instant makes of the next step and of the measures, rule by rule, in plain Python."""

from __future__ import annotations

from typing import Any

import pytest

from builders.records import record_of, record_with
from springback.contact.laws import step_bounds
from springback.dynamics.crossing import Crossing
from springback.dynamics.motion import Engaged, Motion
from springback.kernels.trees import field_of
from springback.kernels.vectors import Quat, Vec
from springback.scenario.model import flight_model
from springback.scenario.scenario import scenario_from
from springback.simulation.executor import rates_of
from springback.simulation.flight import still_work
from springback.simulation.measuring import record as rules
from springback.simulation.measuring.peaks import Peaks
from springback.simulation.measuring.record import (
    APPLY_IMPULSE,
    FREE_FLIGHT,
    IMPACT,
    LOCK_ARMS,
    NOTHING,
    Model,
    Record,
    View,
)

#: Nothing is nearer [m].
ROOM = 100.0


def scene() -> tuple[Model, Motion, View, Record]:
    """ARQ in free flight at 1 m/s towards a wall 100 m away, and the record of its beginning."""
    scenario = scenario_from(
        {
            "vehicle": "arq",
            "world": {"obstacles": [{"type": "wall", "distance": ROOM, "surface": "wall"}]},
            "start": {"velocity": [1.0, 0.0, 0.0]},
            "simulation": {"duration": 10.0},
        }
    )
    model = flight_model(scenario)
    motion = Motion(scenario.start_state(), still_work())
    view = rates_of(model, motion.state, FREE_FLIGHT, 1.0).seen
    return model, motion, view, record_of(4, 1, 1, 4)


def record_after(model: Model, motion: Motion, view: View, m: Record) -> Record:
    """The record after an instant at which faces were looked for."""
    after: Record = rules.record_after(
        model, motion, view, m, rules.search_of(model, motion.state, m)
    )
    return after


def armed(view: View, j: int, **changes: Any) -> View:
    """A view in which one arm is otherwise."""
    arms = list(view.arms)
    arms[j] = arms[j]._replace(**changes)
    return view._replace(arms=tuple(arms))


def bodied(view: View, **changes: Any) -> View:
    """A view in which the hull is otherwise."""
    return view._replace(hull=(view.hull[0]._replace(**changes),))


TOUCHES: dict[str, Any] = {"engaged": (1.0,), "gap": -1e-4}
EITHER = pytest.mark.parametrize("part", [armed, bodied], ids=["cage", "hull"])


def with_(part: Any, view: View, **changes: Any) -> View:
    """A view in which a cage, or the hull, is otherwise; what it touches lies along x."""
    view = view._replace(touched=Vec(1.0 if "engaged" in changes else 0.0, 0.0, 0.0))
    return armed(view, 2, **changes) if part is armed else bodied(view, **changes)


# -- steps -----------------------------------------------------------------------------------------


def test_free_flight_takes_free_steps_and_cruises() -> None:
    """Far from everything, with locked arms at rest."""
    model, motion, view, m = scene()
    after = record_after(model, motion, view, m)
    assert after.stepping.step == model.timing.free_step
    assert after.stepping.cruising == rules.CRUISING
    assert (after.stepping.phase, after.stepping.request, after.contacts.touching) == (
        FREE_FLIGHT,
        NOTHING,
        0.0,
    )


@EITHER
def test_a_touch_begins_an_impact_and_makes_steps_short(part: Any) -> None:
    """The instant of the touch takes no step, the next one an impact step."""
    model, motion, view, m = scene()
    touch = with_(part, view, **TOUCHES)
    first = record_after(model, motion, touch, m)
    assert (
        first.stepping.step,
        first.stepping.phase,
        first.contacts.touching,
        first.contacts.total,
    ) == (0.0, IMPACT, 1.0, 1.0)
    assert first.contacts.impacts == first.contacts.impact_open == 1.0
    assert first.first_impact.touch_speed == pytest.approx(1.0)
    assert first.stepping.cruising == rules.STEERED
    second = record_after(model, motion, touch, first)
    assert 0.0 < second.stepping.step <= model.timing.impact_step
    assert second.contacts.total == 1.0
    assert sum(second.contacts.hull) == (part is bodied)
    assert sum(second.contacts.arms) == (part is armed)


def test_arms_settle_in_longer_steps_but_not_on_a_stop() -> None:
    """A pressed stop is contact, whatever the cages do."""
    model, motion, view, m = scene()
    swings = armed(view, 1, unbalance=25.0)
    settling = record_after(model, motion, swings, record_with(m, stepping={"phase": IMPACT}))
    assert settling.stepping.step == model.timing.settle_step > 2.0 * model.timing.impact_step
    stopped = record_after(
        model, motion, armed(swings, 3, stopped=1.0), record_with(m, stepping={"phase": IMPACT})
    )
    assert stopped.stepping.step == model.timing.impact_step
    assert settling.stepping.cruising == rules.STEERED


@pytest.mark.parametrize(
    ("rate", "share"),
    [
        ("friction_rate", step_bounds.FRICTION_SHARE),
        ("contact_rate", step_bounds.CONTACT_SHARE),
        ("slip_rate", step_bounds.SLIP_SHARE),
    ],
)
def test_steps_follow_every_rate(rate: str, share: float) -> None:
    """Each alone bounds the step, and the tighter bound holds."""
    model, motion, view, m = scene()
    fast = 5.0 * share / model.timing.free_step
    bound = record_after(model, motion, view._replace(**{rate: fast}), m).stepping.step
    assert bound == pytest.approx(share / fast, rel=1e-12)
    slow = record_after(
        model, motion, view._replace(**{rate: 0.5 * share / model.timing.free_step}), m
    )
    assert slow.stepping.step == model.timing.free_step
    endless = record_after(model, motion, view._replace(**{rate: 1e12}), m).stepping.step
    assert endless == pytest.approx(rules.SHORTEST * model.timing.impact_step)


@EITHER
def test_steps_land_on_crossings(part: Any) -> None:
    """On one within reach exactly, half an impact step before one farther off, never too short."""
    model, motion, view, m = scene()
    short = model.timing.impact_step
    near = record_after(
        model, motion, with_(part, view, crossing=Crossing(0.7 * short, 1.0)), m
    ).stepping.step
    assert near == pytest.approx(0.7 * short, rel=1e-12)
    far = record_after(
        model, motion, with_(part, view, crossing=Crossing(3.0 * short, 1.0)), m
    ).stepping.step
    assert far == pytest.approx(2.5 * short, rel=1e-12)
    now = record_after(
        model, motion, with_(part, view, crossing=Crossing(1e-9 * short, 1.0)), m
    ).stepping.step
    assert now == pytest.approx(rules.SHORTEST * short)


@EITHER
def test_no_step_passes_what_is_near(part: Any) -> None:
    """At most so long as the fastest point takes to what is nearest, but an impact step at least."""
    model, motion, view, m = scene()
    gap = 0.4 * model.timing.free_step  # at 1 m/s
    bounded = record_after(model, motion, with_(part, view, gap=gap), m)
    assert bounded.stepping.step == pytest.approx(gap, rel=1e-9)
    assert bounded.stepping.cruising == rules.STEERED
    assert bounded.stepping.room == gap
    least = record_after(model, motion, with_(part, view, gap=1e-9), m)
    assert least.stepping.step == model.timing.impact_step


def test_a_spinning_vehicle_is_as_fast_as_its_farthest_point() -> None:
    """ω times the reach of a cage adds to the speed, and an arm's own rate does."""
    model, motion, view, m = scene()
    reach, gap = 0.19 + 0.11, 0.4 * model.timing.free_step
    spinning = motion.state._replace(angular_velocity=Vec(0.0, 0.0, -2.0))
    spun = record_after(
        model, Motion(spinning, motion.work), armed(view, 0, gap=gap), m
    ).stepping.step
    assert spun == pytest.approx(gap / (1.0 + 2.0 * reach), rel=1e-9)
    sliding = motion.state._replace(arm_rate=(0.0, -3.0, 0.0, 0.0))
    slid = record_after(
        model, Motion(sliding, motion.work), armed(view, 0, gap=gap), m
    ).stepping.step
    assert slid == pytest.approx(model.timing.impact_step)  # of gap / 4 m/s, the longer one


def test_the_last_step_ends_in_time() -> None:
    """Not past the end, and a flight that is there has finished."""
    model, motion, view, m = scene()
    left = 0.3 * model.timing.free_step
    assert record_after(
        model, motion, view, record_with(m, stepping={"time": 10.0 - left})
    ).stepping.step == pytest.approx(left)
    there = record_after(model, motion, view, record_with(m, stepping={"time": 10.0}))
    assert (there.stepping.step, there.stepping.status) == (0.0, rules.FINISHED)


@EITHER
def test_an_impulse_is_asked_for_once(part: Any) -> None:
    """Where a part closes in on a surface of the impulse law; then time goes on."""
    model, motion, view, m = scene()
    closing = with_(part, view, impulsive=1.0, **TOUCHES)
    first = record_after(model, motion, closing, m)
    assert (first.stepping.request, first.stepping.step) == (APPLY_IMPULSE, 0.0)
    second = record_after(model, motion, closing, first)
    assert second.stepping.request != APPLY_IMPULSE
    assert second.stepping.step > 0.0


# -- when an impact is over, and what is measured of it --------------------------------------------


def test_settled_arms_are_locked_when_nothing_touches() -> None:
    """By distance from balance and by rate; the instant of locking takes no step."""
    model, motion, view, m = scene()
    hit = record_with(
        m, stepping={"phase": IMPACT}, contacts={"impact_open": 1.0, "impacts": 1.0, "total": 1.0}
    )
    done = record_after(model, motion, view, hit)
    assert (done.stepping.phase, done.stepping.request, done.stepping.step) == (
        FREE_FLIGHT,
        LOCK_ARMS,
        0.0,
    )
    assert record_after(model, motion, armed(view, 0, unbalance=-0.1), hit).stepping.phase == IMPACT
    moving = motion.state._replace(arm_rate=(0.0, 0.0, -2e-3, 0.0))
    assert record_after(model, Motion(moving, motion.work), view, hit).stepping.phase == IMPACT
    # Held out by spin it is at rest all the same.
    held = armed(view, 0, compression=-5e-3, unbalance=0.0)
    assert record_after(model, motion, held, hit).stepping.phase == FREE_FLIGHT


def test_an_impact_is_over_a_dwell_after_its_last_touch() -> None:
    """And a later touch begins another."""
    model, motion, view, m = scene()
    dwell = model.timing.dwell
    hit = record_with(
        m, contacts={"impact_open": 1.0, "impacts": 1.0, "total": 1.0, "last_touch_time": 0.0}
    )
    assert (
        record_after(
            model, motion, view, record_with(hit, stepping={"time": 0.9 * dwell})
        ).contacts.impact_open
        == 1.0
    )
    over = record_after(model, motion, view, record_with(hit, stepping={"time": 1.1 * dwell}))
    assert over.contacts.impact_open == 0.0
    again = record_after(model, motion, armed(view, 0, **TOUCHES), over)
    assert (again.contacts.impacts, again.contacts.total) == (2.0, 2.0)
    soon = record_after(
        model, motion, armed(view, 0, **TOUCHES), record_with(hit, stepping={"time": 0.9 * dwell})
    )
    assert (soon.contacts.impacts, soon.contacts.total) == (1.0, 2.0)


def test_first_impact_measures_stop_with_it() -> None:
    """Peaks of the whole flight grow on; travel ends with the last separation."""
    model, motion, view, m = scene()
    hard = view._replace(acceleration=Vec(-300.0, 0.0, 0.0), specific_force=Vec(-301.0, 0.0, 0.0))
    hard = armed(hard, 0, normal=200.0, depth=2e-3, compression=9e-3)
    in_first = record_with(m, stepping={"phase": IMPACT}, contacts={"impact_open": 1.0, "impacts": 1.0, "total": 1.0, "touching": 1.0}, first_impact={"inward": Vec(1.0, 0.0, 0.0), "touch_time": 0.0})  # fmt: skip
    moved = Motion(motion.state._replace(position=Vec(0.013, 0.0, 0.0)), motion.work)

    def peaks(values: Peaks) -> list[float]:
        return [
            values.acceleration, values.specific_force, values.normal_force, values.penetration,
            values.compression,
        ]  # fmt: skip

    within = record_after(model, moved, armed(hard, 1, **TOUCHES), in_first)
    assert peaks(within.impact_peaks) == peaks(within.peaks) == [300.0, 301.0, 200.0, 2e-3, 9e-3]
    assert within.first_impact.travel == pytest.approx(0.013)
    later = record_with(in_first, contacts={"impacts": 2.0})
    beyond = record_after(model, moved, armed(hard, 1, **TOUCHES), later)
    assert peaks(beyond.impact_peaks) == [0.0] * 5
    assert peaks(beyond.peaks) == [300.0, 301.0, 200.0, 2e-3, 9e-3]
    assert beyond.first_impact.travel == 0.0
    # After the last separation, while arms settle: peaks of the impact still, no travel.
    swings = armed(hard, 1, unbalance=25.0)
    left = record_after(model, moved, swings, record_with(in_first, contacts={"touching": 0.0}))
    assert peaks(left.impact_peaks)[0] == 300.0
    assert left.first_impact.travel == 0.0
    leaves = record_after(model, moved, swings, in_first)
    assert leaves.first_impact.travel == pytest.approx(0.013)
    assert leaves.first_impact.separation_speed == pytest.approx(1.0)
    assert left.first_impact.separation_time == -1.0
    # The separation of another impact is none of the first.
    again = record_after(model, moved, swings, later)
    assert again.contacts.touching == 0.0
    assert again.first_impact.separation_time == -1.0


def test_peaks_between_instants_need_three_of_one_contact() -> None:
    """The last two instants follow each other; a contact that begins or ends breaks the stretch."""
    model, motion, view, m = scene()

    def at(acceleration: float, seen: View) -> View:
        return seen._replace(acceleration=Vec(-acceleration, 0.0, 0.0))

    touch = armed(view, 2, **TOUCHES)
    pressed = record_with(m, stepping={"phase": IMPACT, "step": 1e-4}, contacts={"impact_open": 1.0, "impacts": 1.0, "total": 1.0, "touching": 1.0, "engaged": Engaged(field_of(touch.arms, "engaged"), field_of(touch.hull, "engaged"))}, first_impact={"inward": Vec(1.0, 0.0, 0.0), "touch_time": 0.0})  # fmt: skip
    first = record_after(model, motion, at(100.0, touch), pressed)
    second = record_after(
        model, motion, at(104.0, touch), record_with(first, stepping={"step": 1e-4})
    )
    assert [s.acceleration for s in (second.recent.earlier, second.recent.latest)] == [100.0, 104.0]
    assert second.recent.step == 1e-4
    third = record_after(
        model, motion, at(102.0, touch), record_with(second, stepping={"step": 1e-4})
    )
    # The parabola through 100, 104, 102 has its vertex at 104 + 1/12.
    assert third.peaks.acceleration == pytest.approx(104.0 + 1.0 / 12.0, abs=1e-9)
    # The same samples, but the contact ends at the third.
    apart = record_after(
        model, motion, at(102.0, view), record_with(second, stepping={"step": 1e-4})
    )
    assert apart.peaks.acceleration == 104.0
    assert apart.recent.step == 0.0


def test_the_return_is_where_the_first_touch_was() -> None:
    """Moving out, behind the plane of the first touch; predicted, so that a step lands on it."""
    model, motion, view, m = scene()
    hit = record_with(m, contacts={"impacts": 1.0, "impact_open": 1.0, "total": 1.0}, first_impact={"inward": Vec(1.0, 0.0, 0.0), "touch_time": 0.0}, stepping={"time": 0.01})  # fmt: skip
    out = motion.state._replace(velocity=Vec(-2.0, 0.0, 0.0))
    ahead = Motion(out._replace(position=Vec(1e-4, 0.0, 0.0)), motion.work)
    coming = record_after(model, ahead, view, hit)
    assert coming.first_impact.return_time == -1.0
    assert coming.stepping.step == pytest.approx(0.5e-4, rel=1e-9)
    there = record_after(model, Motion(out, motion.work), view, hit)
    assert (there.first_impact.return_time, there.first_impact.return_speed) == (0.01, -2.0)


def test_a_view_sums_the_normals_of_what_touches() -> None:
    """Of a robot lowered onto the ground those of its cages, or of its body; far from it, of none."""
    scenario = scenario_from(
        {"vehicle": "arq", "world": {"obstacles": [{"type": "ground", "surface": "mat"}]}}
    )
    model = flight_model(scenario)
    state = scenario.start_state()
    on_its_belly = state._replace(position=Vec(0.0, 0.0, 0.0599))
    on_a_cage = state._replace(attitude=Quat(0.8, 0.0, 0.6, 0.0), position=Vec(0.0, 0.0, 0.1))
    for placed in (on_its_belly, on_a_cage):
        seen = rates_of(model, placed, FREE_FLIGHT, 1.0).seen
        touching = [part.engaged[0] for part in (*seen.arms, *seen.hull)]
        assert sum(touching) > 0.0
        assert seen.touched == pytest.approx((0.0, 0.0, -sum(touching)), abs=1e-12)
    assert [h.engaged for h in rates_of(model, on_its_belly, FREE_FLIGHT, 1.0).seen.hull] == [
        (1.0,)
    ]
    assert rates_of(model, state, FREE_FLIGHT, 1.0).seen.touched == pytest.approx((0.0, 0.0, 0.0))
