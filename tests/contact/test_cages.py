"""Where a cage touches: the ring's support point, and the paper's contact point.

Cages are computed in body axes; here they are looked at in the world.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from builders.bodies import LEVEL, STILL, body
from builders.scenes import CAGE, FACE, LENGTH, surface
from builders.user_obstacles import Ball, Pole
from springback.contact.cage import ArmTip, Ring, support
from springback.contact.loads import CageContact, cage_contact
from springback.contact.obstacles import Obstacle, Plane, obstacle_in_body_frame
from springback.kernels.vectors import Mat3, Vec, norm
from springback.vehicle.state import ArmPose

Array = NDArray[np.float64]
ROUNDING = 1e-3
EXACT, ROUNDED, PAPER = Ring(0.0), Ring(ROUNDING), ArmTip(0.0)
GRIPPY = surface(friction=0.8, dissipation=0.65)
seeds = st.integers(0, 2**32 - 1)


def vec(values: Array) -> Vec:
    """A vector of an array."""
    return Vec(*(float(x) for x in values))


def random_unit(rng: np.random.Generator) -> Array:
    """A random direction."""
    v = rng.normal(size=3)
    return np.asarray(v / np.linalg.norm(v))


class Moving:
    """An arm on a vehicle in uniform motion: position, turning and sliding at any time."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.place, self.velocity = rng.normal(size=3) * 0.3, rng.normal(size=3)
        self.turn, self.omega = Rotation.random(random_state=rng), rng.normal(size=3) * 4.0
        angle = rng.uniform(-np.pi, np.pi)
        self.arm = np.array([np.cos(angle), np.sin(angle), 0.0])
        self.length, self.rate = rng.uniform(0.14, 0.19), rng.normal()

    def met(self, shape: Any, model: Any, t: float) -> CageContact:
        """The meeting with an obstacle at time t; ω is constant in the world."""
        turn = Rotation.from_rotvec(self.omega * t) * self.turn
        length, e = self.length + self.rate * t, self.arm
        sliding = turn.inv().apply(self.velocity) + self.rate * e
        pose = ArmPose(vec(e), vec(length * e), vec(sliding))
        r = Mat3(*(vec(row) for row in turn.as_matrix()))
        position = vec(self.place + self.velocity * t)
        there = obstacle_in_body_frame(Obstacle(shape, GRIPPY, 0.0), position, r)
        return cage_contact(
            there, model, CAGE, pose, body(r, omega=vec(turn.inv().apply(self.omega)))
        )


@given(seed=seeds)
def test_ring_touches_at_its_deepest_point(seed: int) -> None:
    """No point of the tilted circle lies deeper in the wall, by brute force over the angle."""
    rng = np.random.default_rng(seed)
    turn, inward = Rotation.random(random_state=rng), random_unit(rng)
    angles = np.linspace(0.0, 2.0 * np.pi, 3601)
    rim = CAGE * np.stack([np.cos(angles), np.sin(angles), 0.0 * angles], axis=1)
    at = support(EXACT, vec(turn.inv().apply(inward)), Vec(1.0, 0.0, 0.0), CAGE)
    lever = turn.apply(np.array(at.point))
    axis = turn.apply([0.0, 0.0, 1.0])
    assert np.linalg.norm(lever) == pytest.approx(CAGE)
    assert lever @ axis == pytest.approx(0.0, abs=1e-12)
    deepest = float((turn.apply(rim) @ inward).max())
    assert deepest <= lever @ inward + 1e-12
    assert lever @ inward == pytest.approx(deepest, abs=CAGE * 2e-6)
    assert at.normal_lever == at.friction_lever == at.point


@given(seed=seeds)
def test_rounding_moves_the_support_point_by_next_to_nothing(seed: int) -> None:
    """A rounding ε changes the depth by at most ε r_0, and by ε² r_0 over the tilt away from flat."""
    inward = vec(random_unit(np.random.default_rng(seed)))
    tilt = math.hypot(inward.x, inward.y)
    exact = support(EXACT, inward, Vec(1.0, 0.0, 0.0), CAGE)
    rounded = support(ROUNDED, inward, Vec(1.0, 0.0, 0.0), CAGE)
    depth_change = (rounded.point @ inward - rounded.inset) - exact.point @ inward
    assert 0.0 <= depth_change <= min(ROUNDING, ROUNDING**2 / tilt) * CAGE


@pytest.mark.parametrize(
    "shape", [FACE, Plane(Vec(0.36, -0.48, 0.8), 0.3)], ids=["wall", "leaning"]
)
@pytest.mark.parametrize("model", [ROUNDED, PAPER], ids=["ring", "paper"])
@given(seed=seeds)
def test_gap_changes_at_its_rate(shape: Plane, model: Any, seed: int) -> None:
    """The rate of the gap is the time derivative of the gap, for a turning vehicle with sliding arms.

    So the normal force does work exactly on the depth, and the energy ledger can close.
    """
    moving, h = Moving(np.random.default_rng(seed)), 1e-6
    now = moving.met(shape, model, 0.0)
    slope = (moving.met(shape, model, h).gap - moving.met(shape, model, -h).gap) / (2.0 * h)
    assert now.rate == pytest.approx(slope, abs=2e-6)


@given(seed=seeds)
def test_paper_point_is_eq_13(seed: int) -> None:
    """p_c = p_j + ((r_0 R e_j)·e_X) e_X; pushed at the cage tip, rubbed at the arm's end."""
    rng = np.random.default_rng(seed)
    turn, arm = Rotation.random(random_state=rng), random_unit(rng)
    at = support(PAPER, vec(turn.inv().apply([1.0, 0.0, 0.0])), vec(arm), CAGE)
    assert np.allclose(turn.apply(at.point), [CAGE * turn.apply(arm)[0], 0.0, 0.0], atol=1e-15)
    assert np.allclose(at.normal_lever, CAGE * arm)
    assert at.friction_lever == (0.0, 0.0, 0.0)
    assert at.inset == 0.0


@given(depth=st.floats(1e-4, 0.02), speed=st.floats(-1.0, 3.0), slide=st.floats(-1.0, 1.0))
def test_both_points_agree_for_a_level_vehicle_hit_along_an_arm(
    depth: float, speed: float, slide: float
) -> None:
    """Same gap, same rate, same normal force, and no moment from it."""
    ahead = Vec(1.0, 0.0, 0.0)
    pose = ArmPose(ahead, LENGTH * ahead, Vec(speed + slide, 0.0, 0.0))
    place = Vec(depth - LENGTH - CAGE, 0.0, 0.0)
    wall = obstacle_in_body_frame(Obstacle(FACE, GRIPPY, 0.0), place, LEVEL)
    ring, paper = (cage_contact(wall, model, CAGE, pose, body()) for model in (EXACT, PAPER))
    assert ring.gap == pytest.approx(-depth, abs=1e-14)
    assert paper.gap == pytest.approx(-depth, abs=1e-14)
    assert ring.rate == paper.rate == -(speed + slide)
    assert ring.touch.force == pytest.approx(paper.touch.force)
    assert norm(ring.touch.moment) == norm(paper.touch.moment) == 0.0


def test_flat_cage_on_the_ground_is_carried_at_its_centre() -> None:
    """A level cage touches all around, so the force acts at the arm's end, not at some rim point."""
    below = Obstacle(Plane(Vec(0.0, 0.0, 1.0), 0.0), GRIPPY, 1.0)
    ground = obstacle_in_body_frame(below, Vec(0.0, 0.0, -0.002), LEVEL)
    ahead = Vec(1.0, 0.0, 0.0)
    pose = ArmPose(ahead, LENGTH * ahead, STILL)
    met = cage_contact(ground, ROUNDED, CAGE, pose, body())
    # The rounded corner lets a flat cage sink by ε r_0 more, 0.11 mm.
    assert met.gap == pytest.approx(-0.002, abs=1.2e-4)
    assert met.touch.on_ground == 1.0
    lever = LENGTH * ahead
    assert norm(met.touch.moment - (lever ^ met.touch.force)) < 1e-12
    assert met.touch.force.x == met.touch.force.y == 0.0


@given(seed=seeds)
def test_losses_are_never_negative(seed: int) -> None:
    """Whatever the motion, contact damping and friction take energy, they do not give it."""
    moving = Moving(np.random.default_rng(seed))
    for model in (ROUNDED, PAPER):
        touch = moving.met(FACE, model, 0.0).touch
        assert touch.contact_loss >= 0.0
        assert touch.friction_loss >= 0.0
        assert touch.normal >= 0.0


@pytest.mark.parametrize(
    "shape", [Pole(0.5, 0.1, 0.08), Ball(Vec(0.5, 0.1, 0.0), 0.15)], ids=["pole", "ball"]
)
def test_central_gap_on_a_curved_obstacle(shape: Any) -> None:
    """Hit centrally by a level vehicle, the gap is the distance of the nearest points."""
    towards = np.array([0.5, 0.1, 0.0])
    e = towards / np.linalg.norm(towards)
    pose = ArmPose(vec(e), vec(LENGTH * e), vec(2.0 * e))
    there = obstacle_in_body_frame(Obstacle(shape, GRIPPY, 0.0), STILL, LEVEL)
    met = cage_contact(there, EXACT, CAGE, pose, body())
    assert met.gap == pytest.approx(math.hypot(0.5, 0.1) - shape.radius - LENGTH - CAGE)
    assert met.rate == pytest.approx(-2.0)
