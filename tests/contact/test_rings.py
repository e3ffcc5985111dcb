"""Rings against thin and edged shapes: the nearest points, against independent searches."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.polynomial import polynomial

from contact.own_obstacles import Ball, Pole
from springback.contact.cage import Ring, facing
from springback.contact.obstacles import (
    Again,
    Obstacle,
    Plane,
    Seen,
    obstacle_seen,
    outward_normal,
    signed_distance,
)
from springback.contact.parameters import SurfaceSettings, obstacles
from springback.contact.rings import FAR
from springback.experiments.result import fly
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Mat, Quat, Vec, positive_part, rotation
from springback.vehicle.state import ArmPose

RADIUS = 0.11
EXACT = Ring(0.0)


class Box(NamedTuple):
    """A box around the origin, sides along the axes."""

    half: Vec  # [m]


@kernel
def _outside(box: Box, point: Vec) -> Vec:
    return Vec(abs(point.x) - box.half.x, abs(point.y) - box.half.y, abs(point.z) - box.half.z)


@signed_distance.register(Box)  # type: ignore[attr-defined]
@kernel
def box_distance(box: Box, point: Vec) -> float:
    """Distance from the box [m]."""
    u = _outside(box, point)
    out = Vec(positive_part(u.x), positive_part(u.y), positive_part(u.z))
    return math.sqrt(out @ out) + min(max(u.x, max(u.y, u.z)), 0.0)


@outward_normal.register(Box)  # type: ignore[attr-defined]
@kernel
def box_normal(box: Box, point: Vec) -> Vec:
    """Gradient of the distance."""
    u = _outside(box, point)
    most = max(u.x, max(u.y, u.z))
    inside = most <= 0.0
    x = (1.0 if u.x == most else 0.0) if inside else positive_part(u.x)
    y = (1.0 if u.y == most else 0.0) if inside else positive_part(u.y)
    z = (1.0 if u.z == most else 0.0) if inside else positive_part(u.z)
    n = Vec(math.copysign(x, point.x), math.copysign(y, point.y), math.copysign(z, point.z))
    return n * (1.0 / math.sqrt(n @ n))


class Slab(NamedTuple):
    """A half-space below z = 0 that does not say that it is a plane."""

    unused: float


@signed_distance.register(Slab)  # type: ignore[attr-defined]
@kernel
def slab_distance(slab: Slab, point: Vec) -> float:
    """Height [m]."""
    return point.z


@outward_normal.register(Slab)  # type: ignore[attr-defined]
@kernel
def slab_normal(slab: Slab, point: Vec) -> Vec:
    """Up."""
    return Vec(0.0, 0.0, 1.0)


def turn(chance: np.random.Generator) -> Mat:
    """A random attitude."""
    q = chance.normal(size=4)
    return rotation(Quat(*map(float, q / np.linalg.norm(q))))


def ring_at(shape: Any, centre: Vec, r: Mat) -> tuple[float, float]:
    """Gaps of the two nearest points of a ring about a centre, in a plane turned by r."""
    pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))
    gaps = []
    for wrapped in (shape, Again(shape)):
        there = obstacle_seen(Obstacle(wrapped, None, 0.0), centre, r)  # type: ignore[arg-type]
        gaps.append(facing(there, EXACT, RADIUS, pose).gap)
    return gaps[0], gaps[1]


def sampled(shape: Any, centre: Vec, r: Mat, count: int = 4_000) -> float:
    """The least distance by dense sampling, then once more around the best."""
    view = Seen(shape, centre, r)

    def at(angle: float) -> float:
        return float(
            signed_distance(view, Vec(RADIUS * math.cos(angle), RADIUS * math.sin(angle), 0.0))
        )

    angles = np.linspace(0.0, 2.0 * math.pi, count)
    best = min(angles, key=at)
    width = angles[1]
    return min(at(a) for a in np.linspace(best - width, best + width, 400))


@pytest.mark.parametrize("pole_radius", [0.005, 0.015, 0.03, 0.05, 0.1])
def test_a_tilted_ring_meets_a_pole_where_the_quartic_says(pole_radius: float) -> None:
    """To 1e-6 m, at any attitude: where the circle's tangent is square to the way to the axis.

    For an axis along z the distance from it is that of the projected ellipse from a point: with
    t = tan(θ/2) its stationary points are the roots of a quartic.
    """
    chance = np.random.default_rng(4)
    for _ in range(60):
        r = turn(chance)
        away = chance.uniform(0.9, 1.1) * (pole_radius + RADIUS)
        angle = chance.uniform(0.0, 2.0 * math.pi)
        centre = Vec(away * math.cos(angle), away * math.sin(angle), 0.3)
        a, b = np.array([r.x.x, r.y.x]), np.array([r.x.y, r.y.y])  # of the ring's axes
        c = np.array([centre.x, centre.y])
        # d/dθ |c + ρ (a cos θ + b sin θ)|² / 2ρ = p sin θ + q cos θ + s sin 2θ + u cos 2θ
        p, q = -(a @ c), b @ c
        s, u = 0.5 * RADIUS * (b @ b - a @ a), RADIUS * (a @ b)
        roots = polynomial.polyroots([q + u, 2 * p + 4 * s, -6 * u, 2 * p - 4 * s, u - q])
        angles = [2.0 * math.atan(t.real) for t in roots if abs(t.imag) < 1e-6] + [math.pi]
        lows = [
            float(np.linalg.norm(c + RADIUS * (a * math.cos(x) + b * math.sin(x)))) for x in angles
        ]
        found, _ = ring_at(Pole(0.0, 0.0, pole_radius), centre, r)
        assert found == pytest.approx(min(lows) - pole_radius, abs=1e-6)


def test_a_ring_meets_edges_and_corners_of_a_box() -> None:
    """To 1e-4 m in random attitudes, where one fixed-point step erred by 0.1 m."""
    chance, box = np.random.default_rng(5), Box(Vec(0.2, 0.1, 0.05))
    for _ in range(80):
        r = turn(chance)
        n = chance.normal(size=3)
        centre = Vec(*map(float, n / np.linalg.norm(n) * chance.uniform(0.1, 0.35)))
        found, _ = ring_at(box, centre, r)
        assert found == pytest.approx(sampled(box, centre, r), abs=1e-4)


def test_a_ring_meets_a_ball_where_the_closed_form_says() -> None:
    """Nearest point of a circle to a point: the point's shadow in the plane, pushed to the circle."""
    chance = np.random.default_rng(6)
    for _ in range(60):
        r = turn(chance)
        centre = Vec(*map(float, 0.2 * chance.normal(size=3)))
        seen_at = -(centre @ r)  # the ball at the origin, from the ring, in its axes
        flat = math.hypot(seen_at.x, seen_at.y)
        found, _ = ring_at(Ball(Vec(0.0, 0.0, 0.0), 0.02), centre, r)
        assert found == pytest.approx(math.hypot(flat - RADIUS, seen_at.z) - 0.02, abs=1e-9)


def test_a_ring_that_lies_on_a_pole_touches_it_twice() -> None:
    """On either side; and on one side only where the ring hangs over its end of the pole."""
    level = Mat(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, -1.0), Vec(0.0, 1.0, 0.0))  # ring plane on edge
    across = ring_at(Pole(0.0, 0.0, 0.01), Vec(0.0, -0.009, 0.0), level)
    assert across[0] == pytest.approx(-0.001, abs=1e-9)
    assert across[1] == pytest.approx(-0.001, abs=1e-9)
    beside = ring_at(Pole(0.0, 0.0, 0.01), Vec(0.0, -0.15, 0.0), turn(np.random.default_rng(1)))
    assert beside[0] < beside[1]


def test_planes_are_what_they_were() -> None:
    """A plane goes the exact way, a shape that is flat without saying so the general one: the same."""
    chance = np.random.default_rng(7)
    plane = Plane(Vec(0.0, 0.0, 1.0), 0.0)
    for _ in range(40):
        r, centre = turn(chance), Vec(0.0, 0.0, float(chance.uniform(-0.1, 0.2)))
        pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))
        exact = facing(obstacle_seen(Obstacle(plane, None, 0.0), centre, r), EXACT, RADIUS, pose)  # type: ignore[arg-type]
        found, second = ring_at(Slab(0.0), centre, r)
        assert found == pytest.approx(exact.gap, abs=1e-12)
        assert second == FAR


def test_own_shapes_stand_twice_in_the_world_and_planes_once() -> None:
    """The second one is for the second point at which a ring touches."""
    wood = SurfaceSettings(law="hertz")
    world = obstacles((), [(Pole(0.0, 0.0, 0.05), wood), (Plane(Vec(0.0, 0.0, 1.0), -9.0), wood)])
    kinds = [type(entry.shape) for entry in world]
    assert kinds == [Pole, Plane, Again]


def test_a_flight_into_a_thin_pole_closes_its_ledger() -> None:
    """Pitched by 30 deg into a pole of 3 cm, which the cage used to miss by up to 30 mm."""
    scenario = {
        "vehicle": "quad",
        "world": {"gravity": 0.0},
        "start": {"position": [0.0, 0.0, 0.0], "velocity": [2.0, 0.0, 0.0], "pitch": "30 deg"},
        "simulation": {"duration": 0.25},
    }
    wood = SurfaceSettings(law="hertz", stiffness=1e5, friction=0.3)
    flight = fly(scenario, own=[(Pole(0.4, 0.12, 0.03), wood)], trajectory=False)
    assert flight.measures["contacts"] is not None
    assert flight.measures["contacts"] >= 1.0
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6
