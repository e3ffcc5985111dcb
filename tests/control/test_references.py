"""References: kinematics, consistency of derivatives, waiting and switching, and compiled twins."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from springback.control.demands import Limits
from springback.control.polynomials import LENGTHS, set_points, through
from springback.control.reference_parameters import CircleSettings, ReferenceSettings, StepsSettings
from springback.control.references import Circle, Switch
from springback.control.target import Target, target
from springback.kernels.layout import structure
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec, norm

LIMITS = Limits(mass=1.41, gravity=9.81, max_thrust=27.5)
HOLD = set_points([Vec(0.5, -1.0, 2.0)], yaw=0.3)
STEPS = set_points([Vec(0.0, 0.0, 1.0), Vec(1.0, 0.0, 1.0)], dwell=5.0, yaw=0.2)
CIRCLE = Circle(Vec(0.1, 0.2, 1.0), 1.0, 2.0, 0.4, 0.5, 0.0, 0.1)
RAMPED = CIRCLE._replace(ramp=1.5, rate=-2.0)
WAYPOINTS = through(
    [[0, 0, 1], [1, 0, 1.5], [1, 2, 2], [0, 1, 1]], LIMITS, duration=6.0, yaw=0.7, begins=0.5
)
ALL = {
    "hold": HOLD,
    "steps": STEPS,
    "circle": CIRCLE,
    "ramped circle": RAMPED,
    "polynomials": WAYPOINTS,
    "nested switches": Switch(RAMPED, 2.0, Switch(HOLD, 3.0, WAYPOINTS)),
}


@pytest.mark.parametrize("name", ["ramped circle", "circle", "polynomials"])
def test_each_derivative_is_the_rate_of_the_one_before(name: str) -> None:
    reference, h = ALL[name], 1e-4
    for t in np.linspace(0.553, 6.0, 110):
        before, now, after = (target(reference, float(t + k * h)) for k in (-1, 0, 1))
        for value, rate in (
            ("position", "velocity"),
            ("velocity", "acceleration"),
            ("acceleration", "jerk"),
        ):
            slope = (getattr(after, value) - getattr(before, value)) * (0.5 / h)
            # Central differences leave h²/6 of a derivative below 1e3 here, and rounding 1e-15/h.  The
            # grid keeps off the end of the ramp, where snap jumps.
            assert norm(slope - getattr(now, rate)) < 2e-6


@pytest.mark.parametrize("clockwise", [False, True])
@pytest.mark.parametrize("period", [2.0 * math.pi, math.pi])
def test_circles_of_the_paper(period: float, clockwise: bool) -> None:
    circle = CircleSettings(type="circle", period=period, clockwise=clockwise)
    reference, w = circle.reference(LIMITS, lambda _: 0.0), 2.0 * math.pi / period
    assert np.allclose(target(reference, 0.0).position, [1.0, 0.0, 1.0])
    for t in np.linspace(0.0, 3.0 * period, 37):
        now = target(reference, float(t))
        out = now.position - Vec(0.0, 0.0, 1.0)
        assert norm(out) == pytest.approx(1.0, abs=1e-14)
        assert norm(now.velocity) == pytest.approx(w)
        assert np.allclose(now.acceleration, out * (-w * w))  # centripetal v²/r
        assert np.allclose(now.jerk, now.velocity * (-w * w))
        assert (out ^ now.velocity).z == pytest.approx(-w if clockwise else w)
        assert np.allclose(target(reference, float(t + period)).position, now.position)


def test_ramped_circle_starts_from_rest_and_loses_half_the_ramp() -> None:
    start, eps = RAMPED.begins, 1e-6
    first = target(RAMPED, start)
    assert leaves(first.velocity) == leaves(first.acceleration) == leaves(first.jerk) == [0.0] * 3
    at_once = target(RAMPED._replace(ramp=0.0), start + 3.0)
    assert np.allclose(leaves(target(RAMPED, start + 3.75)), leaves(at_once), atol=1e-12)
    for seam in (start, start + RAMPED.ramp):
        jump = np.subtract(leaves(target(RAMPED, seam + eps)), leaves(target(RAMPED, seam - eps)))
        assert np.abs(jump).max() < 2e-6 * 200  # continuous up to jerk; snap is below 200 here


def test_polynomials_wait_at_both_ends() -> None:
    for t, corner in ((-3.0, [0, 0, 1]), (0.49, [0, 0, 1]), (6.51, [0, 1, 1]), (99.0, [0, 1, 1])):
        now = target(WAYPOINTS, t)
        assert np.allclose(now.position, corner, atol=1e-9)
        assert leaves(now.velocity) == leaves(now.acceleration) == leaves(now.jerk) == [0.0] * 3
        assert now.yaw == 0.7


def test_steps_change_at_their_times() -> None:
    steps = StepsSettings(type="steps").reference(LIMITS, lambda _: 0.0)
    seen = [target(steps, t).position for t in (-1.0, 4.999, 5.0, 9.999, 10.0, 15.0, 1e3)]
    places = [Vec(0, 0, 1), Vec(0, 0, 2), Vec(1, 0, 2), Vec(1, 1, 2)]
    assert seen == [places[k] for k in (0, 0, 1, 1, 2, 3, 3)]


@pytest.mark.parametrize("count", [1, 2, LENGTHS[0], LENGTHS[0] + 1, 100])
def test_set_points_are_exact_at_rest_and_for_ever(count: int) -> None:
    """As what they replace was: position and yaw as given, to the last bit, and no motion."""
    places = [Vec(0.1 * k, -0.3 * k, 1.0 + 0.7 * k) for k in range(count)]
    reference = set_points(places, dwell=0.3, yaw=0.7)
    for t in np.linspace(-1.0, 0.3 * count + 3.0, 4001):
        now = target(reference, float(t))
        passed = sum(1 for k in range(count) if k * 0.3 <= t)
        assert now.position == places[max(passed - 1, 0)]
        assert leaves(now._replace(position=Vec(0, 0, 0))) == [0.0] * 12 + [0.7, 0.0]


def test_references_have_few_structures() -> None:
    """Whatever they are: holds, steps, way-points and run-ups, up to twelve segments, are one."""
    few = [set_points([Vec(0.0, 0.0, 1.0)] * count) for count in range(1, LENGTHS[0] + 1)]
    corners = [[k, k % 2, 1] for k in range(LENGTHS[0] + 1)]
    few += [through(corners[:count], LIMITS, duration=20.0) for count in range(2, len(corners) + 1)]
    run_up = {"type": "run-up", "speed": "2 m/s", "pitch": "-45 deg"}
    few.append(SETTINGS.validate_python(run_up).reference(LIMITS, lambda _: 0.3))
    assert len({structure(one) for one in few}) == 1
    many = {structure(set_points([Vec(0.0, 0.0, 1.0)] * count)) for count in range(13, 101)}
    assert len(many) == len(LENGTHS) - 1


def test_then_switches_at_its_time() -> None:
    both = Switch(HOLD, 2.0, CIRCLE)
    assert target(both, 1.9999) == target(HOLD, 0.0)
    assert target(both, 2.0) == target(CIRCLE, 2.0)


def test_what_is_no_reference_says_so() -> None:
    with pytest.raises(TypeError, match="float is not a reference"):
        target(1.0, 0.0)


@pytest.mark.parametrize("name", ["steps", "nested switches"])  # between them every kind
def test_compiled_references_give_the_same_bits(name: str) -> None:
    @numba.njit(error_model="numpy")
    def compiled(reference, time):
        return target(reference, time)

    for t in np.linspace(-1.0, 8.0, 181):
        plain: Target = target(ALL[name], float(t))
        # Sines and cosines may come from another library than Python's: an ulp, times a jerk of 8.
        tolerance = 8 * 2.3e-16 if name == "nested switches" and t < 2.0 else 0.0
        difference = np.subtract(leaves(plain), leaves(compiled(ALL[name], float(t))))
        assert np.abs(difference).max() <= tolerance


SETTINGS = TypeAdapter(ReferenceSettings)
BAD = {
    "no such type": ({"type": "spiral"}, "spiral"),
    "unknown key": ({"type": "circle", "radios": 1.0}, "did you mean radius"),
    "radius": ({"type": "circle", "radius": "-1 m"}, "more than 0 m"),
    "period": ({"type": "circle", "period": "3 m"}, "wrong unit"),
    "begins": ({"type": "circle", "begins": -1.0}, "at least 0 s"),
    "no steps": ({"type": "steps", "positions": []}, "at least one position"),
    "one way-point": ({"type": "waypoints", "positions": [[0, 0, 1]]}, "at least two"),
    "twice": ({"type": "waypoints", "positions": [[0, 0, 1], [0, 0, 1]]}, "neighbours distinct"),
    "times": (
        {"type": "waypoints", "positions": [[0, 0, 1], [1, 0, 1]], "times": [0, 1, 2]},
        "3 entries for 2 positions",
    ),
    "falling times": (
        {"type": "waypoints", "positions": [[0, 0, 1], [1, 0, 1]], "times": ["1 s", "0 s"]},
        "must increase from 0 s",
    ),
    "both": (
        {"type": "waypoints", "positions": [[0, 0, 1], [1, 0, 1]], "times": [0, 1], "duration": 1},
        "give only one",
    ),
    "pitch": ({"type": "run-up", "speed": 2, "pitch": "85 deg"}, "at most 80.2141 deg"),
    "speed": ({"type": "run-up", "speed": "-2 m/s"}, "more than 0 m/s"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_settings_are_refused_in_words(name: str) -> None:
    given, words = BAD[name]
    with pytest.raises(ValidationError, match=words):
        SETTINGS.validate_python(given)


def test_settings_give_references_of_the_right_kind() -> None:
    given = {"type": "hold", "position": ["10 cm", 0, "1 m"], "yaw": "90 deg"}
    hold = SETTINGS.validate_python(given).reference(LIMITS, lambda _: 0.0)
    assert hold == set_points([Vec(0.1, 0.0, 1.0)], yaw=math.pi / 2)
