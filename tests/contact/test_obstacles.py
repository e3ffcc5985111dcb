"""Obstacles: the normal is the gradient of the distance, and users may bring their own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.scenes import CAGE, LENGTH, approaching, one_arm, surface
from builders.user_obstacles import Ball, Pole
from springback.contact.cage import Ring
from springback.contact.obstacles import Plane, in_body_frame, outward_normal, signed_distance
from springback.dynamics.motion import Free
from springback.kernels.compiler import cache_folder
from springback.kernels.vectors import Mat3, Vec, norm
from springback.simulation.flight import fly_one
from springback.simulation.measuring.measures import measures_of
from springback.simulation.measuring.record import Model

coordinate = st.floats(-3.0, 3.0)
points = st.builds(Vec, coordinate, coordinate, coordinate)
directions = points.filter(lambda v: norm(v) > 0.1).map(lambda v: v * (1.0 / norm(v)))
shapes = st.one_of(
    st.builds(Plane, directions, coordinate),
    st.builds(Pole, coordinate, coordinate, st.floats(0.01, 1.0)),
    st.builds(Ball, points, st.floats(0.01, 1.0)),
)


@given(shape=shapes, point=points)
def test_normal_is_the_gradient_of_the_distance(shape: Any, point: Vec) -> None:
    """At random points, inside and outside, with the gradient taken numerically."""
    if isinstance(shape, Pole) and np.hypot(point.x - shape.x, point.y - shape.y) < 0.05:
        return  # the axis has no nearest surface point
    if isinstance(shape, Ball) and norm(point - shape.centre) < 0.05:
        return
    h, slopes = 1e-6, []
    for step in (Vec(h, 0.0, 0.0), Vec(0.0, h, 0.0), Vec(0.0, 0.0, h)):
        there, back = signed_distance(shape, point + step), signed_distance(shape, point - step)
        slopes.append((there - back) / (2.0 * h))
    normal = outward_normal(shape, point)
    assert norm(normal) == pytest.approx(1.0, abs=1e-12)
    assert np.allclose(normal, slopes, atol=1e-7)


@given(shape=shapes, point=points)
def test_distance_leads_to_the_surface(shape: Any, point: Vec) -> None:
    """Going back along the normal by the distance ends on the surface."""
    if isinstance(shape, Ball) and norm(point - shape.centre) < 0.05:
        return
    if isinstance(shape, Pole) and np.hypot(point.x - shape.x, point.y - shape.y) < 0.05:
        return
    foot = point - signed_distance(shape, point) * outward_normal(shape, point)
    assert signed_distance(shape, foot) == pytest.approx(0.0, abs=1e-9)


def test_a_shape_without_functions_says_what_is_missing() -> None:
    """The error names the one of the two functions that is missing."""
    with pytest.raises(TypeError, match="signed_distance; register one"):
        signed_distance((1.0,), Vec(0.0, 0.0, 0.0))
    with pytest.raises(TypeError, match="outward_normal; register one"):
        outward_normal((1.0,), Vec(0.0, 0.0, 0.0))


def towards(shape: Any) -> Model:
    """A rigid vehicle in free flight, on its way to an obstacle that begins at x = 0."""
    material = surface(stiffness=1e5, dissipation=0.6, friction=0.8)
    return one_arm(shape, material, guide=Free(0.0), contact_point=Ring(1e-3), until=0.06)


OWN = {"pole": Pole(0.2, 0.0, 0.2), "ball": Ball(Vec(0.15, 0.0, 0.0), 0.15)}


@pytest.mark.parametrize("shape", OWN.values(), ids=OWN.keys())
def test_own_obstacle_is_hit_and_the_ledger_closes(shape: Any) -> None:
    """A central hit in plain Python: rebound straight back, energy accounted for to 1e-6."""
    flown = fly_one(towards(shape), approaching(2.0, 1e-3), executor="python")
    record, measured = flown.record, measures_of(flown)
    assert record.contacts.total == 1.0
    assert record.first_impact.separation_speed < 0.0
    # The point of a ring that is nearest to a shape is searched for, to some 1e-8 m.
    assert record.first_impact.inward == pytest.approx((1.0, 0.0, 0.0), abs=1e-7)
    assert abs(measured["ledger_residual"] or 0.0) < 1e-6
    assert flown.motion.state.position.y == pytest.approx(0.0, abs=1e-8)
    assert flown.motion.state.position.z == 0.0


def test_own_obstacle_hit_centrally_is_a_wall_there() -> None:
    """A central hit on a pole, a ball and a wall are one and the same impact."""
    flat = fly_one(
        towards(Plane(Vec(-1.0, 0.0, 0.0), 0.0)), approaching(2.0, 1e-3), executor="python"
    )
    for shape in OWN.values():
        curved = fly_one(towards(shape), approaching(2.0, 1e-3), executor="python")
        assert curved.record.first_impact.separation_speed == pytest.approx(
            flat.record.first_impact.separation_speed, abs=1e-9
        )
        assert curved.record.peaks.penetration == pytest.approx(
            flat.record.peaks.penetration, abs=1e-9
        )


def test_own_obstacle_compiles_and_gives_the_same_bits() -> None:
    """Registered with `signed_distance.register`, a pole flies in compiled code, too."""
    model, start = towards(OWN["pole"]), approaching(2.0, 1e-3)
    compiled = fly_one(model, start)
    plain = fly_one(model, start, executor="python")
    assert compiled.motion == plain.motion
    assert compiled.record == plain.record


def test_own_obstacle_stays_out_of_the_kernels_on_disk() -> None:
    """Kernels kept on disk must load where the user's module is unknown, and follow its edits."""
    fly_one(towards(OWN["pole"]), approaching(2.0, 1e-3))
    for index in nonempty(cache_folder().rglob("*.kernel")):
        assert b"user_obstacles" not in index.read_bytes()


def test_body_axes_change_neither_distance_nor_normal() -> None:
    """A shape seen from a body is the same shape: planes by formula, others by going back."""
    rng = np.random.default_rng(3)
    for shape in (Plane(Vec(0.36, -0.48, 0.8), 0.3), Pole(0.5, 0.1, 0.08)):
        turn, place = Rotation.random(random_state=rng), rng.normal(size=3)
        r = Mat3(*(Vec(*(float(x) for x in row)) for row in turn.as_matrix()))
        position = Vec(*(float(x) for x in place))
        from_body, point = in_body_frame(shape, position, r), Vec(0.3, -0.2, 0.1)
        there = position + r @ point
        apart = signed_distance(shape, there)
        assert signed_distance(from_body, point) == pytest.approx(apart, abs=1e-14)
        assert outward_normal(from_body, point) == pytest.approx(outward_normal(shape, there) @ r)


def test_touch_is_where_the_gap_closes() -> None:
    """First touch comes at the time the cage needs for the gap."""
    flown = fly_one(towards(OWN["pole"]), approaching(2.0, 1e-3), executor="python")
    # The rounded corner of the ring sticks out by ε² r_0 / 2.
    assert flown.record.first_impact.touch_time == pytest.approx(1e-3 / 2.0, abs=1e-7)
    assert flown.record.first_impact.touch_depth == pytest.approx(-(LENGTH + CAGE), abs=1e-7)
