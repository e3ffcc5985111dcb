"""Friction: against the slip, inside the cone, along the axes that were asked for."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from builders.scenes import surface
from springback.contact import surfaces
from springback.contact.surfaces import Surface
from springback.contact.surfaces import friction_force as friction_of
from springback.kernels.vectors import Vec, norm

MU = 0.8
BOTH = surface(friction=MU)
VERTICAL = surface(friction=MU, vertical_only=True)
component = st.floats(-5.0, 5.0)
velocities = st.builds(Vec, component, component, component)
loads = st.floats(0.0, 500.0)


def slip_velocity(law: Surface, velocity: Vec, normal: Vec) -> Vec:
    """Slip in world axes."""
    return surfaces.slip_velocity(law, velocity, normal, Vec(0.0, 0.0, 1.0))


def friction_force(law: Surface, load: float, slip: Vec) -> Vec:
    """The force alone, after a look at its heat."""
    now = friction_of(law, load, slip)
    assert now.loss == pytest.approx(-(now.force @ slip), rel=1e-12, abs=1e-300)
    assert now.loss >= 0.0
    return now.force


def _unit(v: Vec) -> Vec:
    return v * (1.0 / norm(v))


normals = velocities.filter(lambda v: norm(v) > 0.1).map(_unit)


@given(velocity=velocities, normal=normals, load=loads)
def test_opposes_slip_inside_the_cone(velocity: Vec, normal: Vec, load: float) -> None:
    """‖f‖ ≤ μ f_n, antiparallel to the tangential velocity, with nothing along the normal."""
    slip = slip_velocity(BOTH, velocity, normal)
    force = friction_force(BOTH, load, slip)
    assert abs(slip @ normal) < 1e-12
    assert force @ slip <= 0.0
    assert norm(force ^ slip) <= 1e-12 * (1.0 + norm(force) * norm(slip))
    assert norm(force) <= MU * load
    assert abs(force @ normal) <= 1e-12 * (1.0 + load)


def test_full_coulomb_force_well_above_the_slip_speed() -> None:
    """Fifty times the slip speed: μ f_n to 2e-4; at the slip speed: 1/√2 of it; at rest: none."""
    assert norm(friction_force(BOTH, 100.0, Vec(0.0, 5.0, 0.0))) == pytest.approx(80.0, rel=2e-4)
    at_slip_speed = norm(friction_force(BOTH, 100.0, Vec(0.0, 0.1, 0.0)))
    assert at_slip_speed == pytest.approx(80.0 / math.sqrt(2.0))
    assert friction_force(BOTH, 100.0, Vec(0.0, 0.0, 0.0)) == (0.0, 0.0, 0.0)


@given(velocity=velocities)
def test_vertical_only_leaves_horizontal_slip_alone(velocity: Vec) -> None:
    """Eq. (14) on a wall across X: along e_Z, blind to motion along Y."""
    normal = Vec(-1.0, 0.0, 0.0)
    force = friction_force(VERTICAL, 100.0, slip_velocity(VERTICAL, velocity, normal))
    only_up = friction_force(BOTH, 100.0, Vec(0.0, 0.0, velocity.z))
    assert (force.x, force.y) == (0.0, 0.0)
    assert force.z == pytest.approx(only_up.z, abs=1e-9)


@given(velocity=velocities, normal=normals)
def test_vertical_only_acts_along_the_steepest_tangent(velocity: Vec, normal: Vec) -> None:
    """On a leaning wall the axis is e_Z less its normal part, and the cone still holds."""
    up = Vec(0.0, 0.0, 1.0) - normal.z * normal
    if norm(up) < 0.05:
        return  # a floor has no such axis
    force = friction_force(VERTICAL, 100.0, slip_velocity(VERTICAL, velocity, normal))
    assert norm(force ^ _unit(up)) < 1e-9 * (1.0 + norm(force))
    assert norm(force) <= 80.0
    assert force @ velocity <= 1e-9


@given(velocity=velocities)
def test_vertical_only_on_a_floor_is_none(velocity: Vec) -> None:
    """There is no vertical tangent on the ground."""
    slip = slip_velocity(VERTICAL, velocity, Vec(0.0, 0.0, 1.0))
    assert norm(friction_force(VERTICAL, 100.0, slip)) < 1e-9
