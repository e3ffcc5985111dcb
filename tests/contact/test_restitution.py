"""Exact restitution of a Hunt–Crossley contact: in closed form, by direct integration, and in flight."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from builders.scenes import FACE, approaching, one_arm, surface
from springback.contact.laws.restitution import dissipation_for, restitution
from springback.errors import InputError
from springback.simulation.flight import fly_one

EXPONENTS = (1.0, 1.5, 2.0)


def flown_restitution(
    n: float, dissipation: float, speed: float, mass: float, stiffness: float
) -> float:
    """Restitution of a rigid vehicle flown head-on into a wall at the default step."""
    wall = surface(stiffness=stiffness, dissipation=1.5 * dissipation, exponent=n)
    model = one_arm(FACE, wall, mass=mass, until=0.2)
    record = fly_one(model, approaching(speed, 1e-3), trace=False, executor="python").record
    assert record.contacts.total == 1.0
    assert record.first_impact.touch_speed == pytest.approx(speed, rel=1e-8)
    return -record.first_impact.separation_speed / record.first_impact.touch_speed


def integrated_restitution(
    n: float, dissipation: float, speed: float, mass: float, stiffness: float
) -> float:
    """Restitution of m δ̈ = −k δⁿ (1 + d δ̇) by an adaptive integrator of high order."""
    d = 1.5 * dissipation

    def rate(t: float, y: np.ndarray) -> list[float]:
        depth = max(y[0], 0.0)
        return [y[1], -stiffness / mass * depth**n * (1.0 + d * y[1])]

    def apart(t: float, y: np.ndarray) -> float:
        return float(y[0])

    apart.terminal, apart.direction = True, -1.0  # type: ignore[attr-defined]
    solved = solve_ivp(
        rate, (0.0, 2.0), [0.0, speed], method="DOP853", rtol=1e-12, atol=1e-14, events=apart,
        max_step=1e-3,
    )  # fmt: skip
    return float(-solved.y_events[0][0][1] / speed)


@pytest.mark.parametrize("n", EXPONENTS)
def test_relation_holds_in_flight(n: float) -> None:
    """A rigid vehicle leaves the wall with the e of ln[(1 + h)/(1 − e h)] = h (1 + e), h = d v."""
    c_a, speed = 0.432, 1.85
    stiffness = {1.0: 2e4, 1.5: 2e5, 2.0: 2e6}[n]
    e = flown_restitution(n, c_a, speed, 1.892, stiffness)
    h = 1.5 * c_a * speed
    assert math.log((1.0 + h) / (1.0 - e * h)) == pytest.approx(h * (1.0 + e), rel=1e-6)
    assert e == pytest.approx(restitution(c_a, speed), abs=1e-6)


@pytest.mark.parametrize("n", EXPONENTS)
def test_relation_holds_for_an_adaptive_integrator(n: float) -> None:
    """The closed form is the law's own: a second integrator of the scalar equation agrees."""
    stiffness = {1.0: 2e4, 1.5: 2e5, 2.0: 2e6}[n]
    e = integrated_restitution(n, 0.432, 1.85, 1.892, stiffness)
    assert e == pytest.approx(restitution(0.432, 1.85), abs=1e-9)


@pytest.mark.parametrize(
    ("mass", "stiffness"), [(0.4, 2e5), (6.0, 2e5), (1.892, 4e4), (1.892, 4e5)]
)
def test_mass_and_stiffness_have_no_say(mass: float, stiffness: float) -> None:
    """Restitution depends on damping and speed alone."""
    e = flown_restitution(1.5, 0.3, 2.5, mass, stiffness)
    assert e == pytest.approx(restitution(0.3, 2.5), abs=1e-6)


def test_slow_touch_is_elastic_and_the_textbook_line_is_its_tangent() -> None:
    """e → 1 − c_a v at small speed, and clearly above it at real speeds."""
    assert restitution(0.4, 1e-4) == pytest.approx(1.0 - 0.4e-4, abs=1e-8)
    assert restitution(0.0, 3.0) == 1.0
    assert restitution(0.432, 1.85) == pytest.approx(0.547, abs=5e-4)
    assert restitution(0.432, 1.85) > 1.0 - 0.432 * 1.85 + 0.3


@given(e=st.floats(0.01, 0.999), speed=st.floats(0.05, 10.0))
def test_fit_is_the_inverse(e: float, speed: float) -> None:
    """`dissipation_for` and `restitution` undo each other."""
    assert restitution(dissipation_for(e, speed), speed) == pytest.approx(e, abs=1e-9)


@given(c_a=st.floats(0.01, 2.0), speed=st.floats(0.1, 5.0))
def test_fit_is_the_inverse_the_other_way(c_a: float, speed: float) -> None:
    """From damping to restitution and back, wherever the restitution can be asked for."""
    e = restitution(c_a, speed)
    if e >= 0.01:
        assert dissipation_for(e, speed) == pytest.approx(c_a, rel=1e-6)


@given(c_a=st.floats(0.01, 2.0), speed=st.floats(0.1, 5.0), more=st.floats(1.01, 3.0))
def test_faster_or_more_damped_means_less_rebound(c_a: float, speed: float, more: float) -> None:
    """e falls with damping and with speed, and only their product counts."""
    e = restitution(c_a, speed)
    assert restitution(more * c_a, speed) < e
    assert restitution(c_a, more * speed) == pytest.approx(
        restitution(more * c_a, speed), abs=1e-10
    )


@pytest.mark.parametrize(
    ("target", "speed"), [(0.0, 1.0), (1.2, 1.0), (0.5, 0.0), (float("nan"), 1.0)]
)
def test_impossible_targets_are_refused(target: float, speed: float) -> None:
    """A Hunt–Crossley surface cannot have them."""
    with pytest.raises(InputError):
        dissipation_for(target, speed)
