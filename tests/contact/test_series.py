"""Two surfaces in series, against the equilibrium of two springs and against each alone."""

from __future__ import annotations

import itertools
import math

import pytest
from scipy.optimize import brentq

from builders.scenes import surface
from springback.contact.hulls.series import HullLaw, in_series
from springback.contact.surfaces import AnyExponent, Surface, normal_force

RIGID = HullLaw(0.0, 0.0, 0.0, -1.0, -1.0, 0.0)


def law(stiffness: float, exponent: float, **numbers: float) -> HullLaw:
    """Surface of a hull."""
    given = {"dissipation": 0.0, "viscosity": 0.0, "friction": -1.0, "slip_speed": -1.0} | numbers
    return HullLaw(stiffness ** (-1.0 / exponent), **given, exponent=exponent)


def obstacle(stiffness: float, exponent: float, **numbers: float) -> Surface:
    """Surface of an obstacle."""
    made = surface(stiffness=stiffness, **numbers)
    return made._replace(exponent=AnyExponent(exponent))


def share_of_first(here: float, there: float, exponent: float, depth: float) -> float:
    """Compression of the first of two springs at which both carry the same force [m]."""

    def surplus(x: float) -> float:
        return float(here * x**exponent - there * (depth - x) ** exponent)

    return float(brentq(surplus, 0.0, depth, xtol=1e-18))


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.2])
def test_two_springs_in_series_carry_the_same_force(exponent: float) -> None:
    """The depth between both is where their forces are equal."""
    for here, there in itertools.product((1e4, 3e5), (2e3, 8e4)):
        both, depth = in_series(obstacle(here, exponent), law(there, exponent)), 3e-3
        first = share_of_first(here, there, exponent, depth)
        assert normal_force(both, depth, 0.0, 0.0).force == pytest.approx(
            here * first**exponent, rel=1e-10
        )
        assert both.stiffness < min(here, there)
    if exponent == 1.0:
        both = in_series(obstacle(3e4, 1.0), law(6e4, 1.0))
        assert both.stiffness == pytest.approx(2e4, rel=1e-14)


def test_a_rigid_hull_leaves_the_obstacles_law() -> None:
    """All numbers are the obstacle's, to the last bit."""
    rubber = obstacle(1e5, 1.5, dissipation=0.4, friction=0.7, slip_speed=0.02)
    assert in_series(rubber, RIGID) == rubber
    near = in_series(rubber, law(1e30, 1.5, dissipation=9.0))
    assert near.stiffness == pytest.approx(1e5, rel=1e-12)
    assert near.dissipation == pytest.approx(0.4, rel=1e-12)


def test_dampers_lose_what_both_would_lose() -> None:
    """Power Σ d_i F δ̇_i², and Σ b_i δ̇_i², with the shares that the springs give."""
    one = obstacle(2e5, 1.5, dissipation=0.2)
    both = in_series(one, law(4e4, 1.5, dissipation=0.5))
    share = 2e5 ** (-2.0 / 3.0) / (2e5 ** (-2.0 / 3.0) + 4e4 ** (-2.0 / 3.0))
    force, rate = both.stiffness * 2e-3**1.5, 0.3
    lost = force * (0.2 * (share * rate) ** 2 + 0.5 * ((1.0 - share) * rate) ** 2)
    assert normal_force(both, 2e-3, rate, 0.0).loss == pytest.approx(lost, rel=1e-12)
    dampers = in_series(obstacle(3e4, 1.0, viscosity=10.0), law(6e4, 1.0, viscosity=40.0))
    assert dampers.viscosity == pytest.approx(10.0 * (2.0 / 3.0) ** 2 + 40.0 / 9.0, rel=1e-12)


def test_equal_bodies_rebound_as_each_from_a_rigid_plane_at_half_the_speed() -> None:
    """d is half of each one's, for the same d · v."""
    both = in_series(obstacle(1e5, 1.5, dissipation=0.6), law(1e5, 1.5, dissipation=0.6))
    assert both.dissipation == pytest.approx(0.3, rel=1e-14)


def test_friction_is_the_geometric_mean_and_slip_speed_the_larger() -> None:
    """Unless the hull names none; also where the springs are those of the impulse law."""
    wall = obstacle(1e5, 1.5, friction=0.8, slip_speed=0.03)
    found = in_series(wall, law(1e5, 1.5, friction=0.2, slip_speed=0.05))
    assert found.friction == pytest.approx(math.sqrt(0.8 * 0.2))
    assert found.slip_speed == 0.05
    assert in_series(wall, law(1e5, 1.5)).friction == 0.8
    assert in_series(wall, law(1e5, 1.5, slip_speed=0.01)).slip_speed == 0.03
    impulse = wall._replace(stiffness=0.0, restitution=0.5)
    struck = in_series(impulse, law(1e5, 1.5, friction=0.2))
    assert struck.restitution == 0.5
    assert struck.friction == pytest.approx(0.4)
