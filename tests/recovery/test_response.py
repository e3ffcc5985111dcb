"""Ways back from a collision: what they promise at their ends and in between."""

import math

import numpy as np
import pytest

from springback.control.target import target
from springback.kernels.vectors import Quat, Vec
from springback.recovery.characterisation import Collision
from springback.recovery.parameters import ResponseSettings
from springback.recovery.response import Staged, TimeOptimal, homeward, recovery_plan, rush
from springback.sensing.measurement import Estimate

G = 9.81
STILL = Vec(0.0, 0.0, 0.0)
NORTH = Vec(1.0, 0.0, 0.0)


PLACE = Vec(2.5, 0.0, 1.0)


def hit(speed: float) -> Collision:
    return Collision(
        PLACE, Vec(speed, 0.0, 0.0), NORTH, STILL, STILL, STILL, STILL, PLACE,
        (1.0, 1.0, 0.0, 0.0), 50.0,
    )  # fmt: skip


def believed(position: Vec, velocity: Vec) -> Estimate:
    return Estimate(position, Quat(1.0, 0.0, 0.0, 0.0), velocity, STILL)


def sampled(reference: object, begins: float, ends: float) -> tuple[np.ndarray, list]:
    t = np.linspace(begins, ends, 2001)
    return t, [target(reference, float(x)) for x in t]


def test_pre_impact_asks_for_the_printed_pitch() -> None:
    """From 3.5 m/s to rest 0.1 m back in 0.19 s²/m · v: −66° and +49.6° (printed −66°, +49°)."""
    struck = hit(3.5)
    goal = struck.position - NORTH * 0.1
    plan = recovery_plan(
        ResponseSettings().response(), struck, goal, believed(struck.position, STILL), 2.0, 0.0
    )
    assert plan.ends == pytest.approx(2.0 + 0.19 * 3.5)
    _, way = sampled(plan.reference, 2.0, plan.ends)
    pitch = np.degrees([math.atan2(w.acceleration.x, G) for w in way])
    assert pitch.min() == pytest.approx(-66.0, abs=0.5)
    assert pitch.max() == pytest.approx(49.6, abs=0.5)


@pytest.mark.parametrize("way", ["pre-impact", "post-impact"])
def test_a_quintic_begins_as_named_and_ends_at_rest(way: str) -> None:
    struck, goal = hit(2.0), Vec(2.4, 0.1, 0.9)
    here = believed(Vec(2.48, 0.05, 0.97), Vec(-0.8, 0.2, 0.1))
    plan = recovery_plan(ResponseSettings(way=way).response(), struck, goal, here, 3.0, 0.3)
    first, last = target(plan.reference, 3.0), target(plan.reference, plan.ends + 1e-9)
    begins = (
        (struck.position, struck.velocity)
        if way == "pre-impact"
        else (here.position, here.velocity)
    )
    np.testing.assert_allclose((first.position, first.velocity), begins, atol=1e-12)
    np.testing.assert_allclose((last.position, last.velocity), (goal, STILL), atol=1e-9)
    assert first.yaw == last.yaw == 0.3


def test_a_set_point_is_there_at_once() -> None:
    struck, goal = hit(2.0), Vec(2.4, 0.0, 1.0)
    plan = recovery_plan(
        ResponseSettings(way="set-point").response(), struck, goal, believed(goal, STILL), 3.0, 0.0
    )
    soon = target(plan.reference, 3.002)
    assert (soon.position, soon.velocity, soon.acceleration) == (goal, STILL, STILL)


def test_the_fastest_way_from_rest_to_rest_is_the_textbooks() -> None:
    """Time 2 √(d/a), half of it at +a and half at −a."""
    for distance in (0.5, -2.0):
        way = rush(1.0, 0.0, 1.0 + distance, 4.0)
        assert way.switch == pytest.approx(math.sqrt(abs(distance) / 4.0))
        assert way.brake == pytest.approx(way.switch)
        assert way.push == math.copysign(4.0, distance)


def test_the_fastest_way_from_any_motion() -> None:
    """Continuous in position and speed, never beyond the acceleration, at rest at the goal; and no
    bang-bang way that brakes with less, or switches at another time, stops there earlier.
    """
    noise_stream = np.random.default_rng(0)
    for _ in range(50):
        p, v, goal = noise_stream.uniform(-2.0, 2.0, 3)
        response = TimeOptimal(6.0, 3.0)
        here = believed(Vec(p, 0.0, 1.0), Vec(v, 0.0, 0.0))
        plan = recovery_plan(response, hit(2.0), Vec(goal, 0.0, 1.0), here, 1.0, 0.0)
        t, way = sampled(plan.reference, 1.0, plan.ends)
        x, u, a = (
            np.array([getattr(w, n).x for w in way])
            for n in ("position", "velocity", "acceleration")
        )
        assert (x[0], u[0]) == pytest.approx((p, v))
        assert (x[-1], u[-1]) == pytest.approx((goal, 0.0), abs=1e-9)
        assert np.abs(a).max() <= 6.0 + 1e-12
        step = t[1] - t[0]
        assert np.abs(np.diff(x) - 0.5 * step * (u[1:] + u[:-1])).max() < 6.0 * step**2
        assert np.abs(np.diff(u)).max() <= 6.0 * step * (1.0 + 1e-9)
        # Acceleration is the slope of the speed, but where it is switched and where all ends.
        slopes = np.abs(np.diff(u) / step - a[:-1]) > 1e-6 * 6.0
        assert slopes.sum() <= 3
        # Lower bound by the speed that must be shed and the distance that must be made good.
        assert plan.ends - 1.0 >= abs(v) / 6.0 - 1e-9
        assert plan.ends - 1.0 >= _least_time(p, v, goal, 6.0) - 1e-3


def _least_time(p: float, v: float, goal: float, a: float) -> float:
    """By search over the switch time of both signs: an independent answer."""
    best = math.inf
    for sign in (1.0, -1.0):
        switch = np.linspace(0.0, 4.0, 40_001)
        top = v + sign * a * switch
        brake = -top / (-sign * a)
        end = p + v * switch + 0.5 * sign * a * switch**2 + top * brake - 0.5 * sign * a * brake**2
        good = (brake >= 0.0) & (np.abs(end - goal) < 2e-3)
        if good.any():
            best = min(best, float((switch + brake)[good].min()))
    return best


def test_homeward_is_as_fast_as_told_and_no_faster() -> None:
    plan = homeward(Vec(2.0, 0.0, 1.0), Vec(0.0, 0.0, 1.0), 0.8, 5.0, 0.0)
    _, way = sampled(plan.reference, 5.0, plan.ends)
    speeds = [math.sqrt(w.velocity @ w.velocity) for w in way]
    assert max(speeds) == pytest.approx(0.8, rel=1e-4)
    np.testing.assert_allclose(way[-1].position, (0.0, 0.0, 1.0), atol=1e-9)


def test_what_is_no_response_is_refused() -> None:
    with pytest.raises(TypeError, match="not a response"):
        recovery_plan(Vec(0.0, 0.0, 0.0), hit(1.0), STILL, believed(STILL, STILL), 0.0, 0.0)


def test_staged_holds_where_it_is_after_its_stages() -> None:
    response, here = ResponseSettings(way="staged").response(), Vec(2.2, 0.3, 0.8)
    assert isinstance(response, Staged)
    plan = recovery_plan(response, hit(2.0), here, believed(here, Vec(-1.0, 0.0, 0.0)), 4.0, 0.0)
    held = target(plan.reference, 4.5)
    assert (held.position, held.velocity) == (here, STILL)
