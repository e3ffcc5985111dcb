"""Rings against thin and edged shapes: the nearest points, against independent searches."""

from __future__ import annotations

import itertools
import math
import warnings
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.polynomial import polynomial
from scipy.optimize import minimize_scalar

from builders.bodies import body
from builders.scenes import surface
from builders.user_obstacles import Ball, Box, Pole
from springback.contact.cage import ArmTip, ContactFace, Ring, face_of, nearest_face
from springback.contact.loads import face_contact
from springback.contact.obstacles import (
    InBodyFrame,
    Obstacle,
    Plane,
    SecondContact,
    obstacle_in_body_frame,
    outward_normal,
    signed_distance,
)
from springback.contact.parameters import SurfaceSettings
from springback.contact.rings import ARCS, FAR, STEPS, TRIES, lowest_on_ring
from springback.contact.worlds import obstacles
from springback.kernels.compiler import kernel
from springback.kernels.vectors import (
    Mat3,
    Quat,
    Vec,
    exponential_map,
    quaternion_of,
    quaternion_product,
    rotation,
)
from springback.results.flight import fly
from springback.vehicle.state import ArmPose, PartMemory

with warnings.catch_warnings():  # it compiles something of its own at once, and says so
    warnings.simplefilter("ignore")
    from distance3d.distance import line_to_circle, point_to_circle

RADIUS = 0.11
EXACT = Ring(0.0)


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


def turn(chance: np.random.Generator) -> Mat3:
    """A random attitude."""
    q = chance.normal(size=4)
    return rotation(Quat(*map(float, q / np.linalg.norm(q))))


def ring_at(shape: Any, centre: Vec, r: Mat3) -> tuple[float, float]:
    """Gaps of the two nearest points of a ring about a centre, in a plane turned by r."""
    pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))
    there = obstacle_in_body_frame(Obstacle(shape, None, 0.0), centre, r)  # type: ignore[arg-type]
    if isinstance(shape, Plane):
        return nearest_face(there.shape, EXACT, RADIUS, pose).gap, FAR
    found = lowest_on_ring(there.shape, pose.lever, RADIUS, pose.direction)
    first = nearest_face(there.shape, EXACT, RADIUS, pose).gap
    assert first == found.first.gap
    second = obstacle_in_body_frame(Obstacle(SecondContact(shape), None, 0.0), centre, r)  # type: ignore[arg-type]
    less = found.saddle.gap if found.saddle.gap < 0.0 else 0.0
    assert nearest_face(second.shape, EXACT, RADIUS, pose).gap == pytest.approx(
        min(found.second.gap - less, 0.0) if less < 0.0 else found.second.gap, abs=1e-15
    )
    return first, found.second.gap


def touching_at(point: Vec, r: Mat3, chance: np.random.Generator) -> Vec:
    """The centre of a ring of some attitude that passes through a point."""
    angle = chance.uniform(0.0, 2.0 * math.pi)
    return point - r @ Vec(RADIUS * math.cos(angle), RADIUS * math.sin(angle), 0.0)


def sampled(shape: Any, centre: Vec, r: Mat3, count: int = 2_000) -> float:
    """The least distance by dense sampling, then ever closer around the best."""
    view = InBodyFrame(shape, centre, r)

    def at(angle: float) -> float:
        return float(
            signed_distance(view, Vec(RADIUS * math.cos(angle), RADIUS * math.sin(angle), 0.0))
        )

    angles = np.linspace(0.0, 2.0 * math.pi, count)
    best, width = min(angles, key=at), angles[1]
    for _ in range(4):
        best = min(np.linspace(best - width, best + width, 81), key=at)
        width /= 40.0
    return at(best)


def minima_by_quartic(centre: Vec, r: Mat3) -> list[tuple[float, bool]]:
    """Distances of a ring from the z axis at their minima, the least first.

    They are those of an ellipse, the ring's shadow along the axis, from a point: with t = tan(θ/2)
    the stationary points are the roots of a quartic.  Beside each: whether one step along the ring
    leads to a point that is nearer.
    """
    a, b = np.array([r.x.x, r.y.x]), np.array([r.x.y, r.y.y])  # of the ring's axes
    c = np.array([centre.x, centre.y])
    # d/dθ |c + ρ (a cos θ + b sin θ)|² / 2ρ = p sin θ + q cos θ + s sin 2θ + u cos 2θ
    p, q = -(a @ c), b @ c
    s, u = 0.5 * RADIUS * (b @ b - a @ a), RADIUS * (a @ b)
    roots = polynomial.polyroots([q + u, 2 * p + 4 * s, -6 * u, 2 * p - 4 * s, u - q])

    def at(x: float) -> float:
        return float(np.linalg.norm(c + RADIUS * (a * math.cos(x) + b * math.sin(x))))

    def bend(x: float) -> float:
        flat, bent = math.cos(2 * x), math.sin(2 * x)
        return float(p * math.cos(x) - q * math.sin(x) + 2 * s * flat - 2 * u * bent)

    step = 2.0 * math.pi / (ARCS * STEPS)
    angles = [2.0 * math.atan(t.real) for t in roots if abs(t.imag) < 1e-6]
    lows = [x for x in angles if bend(x) > 0.0]
    return sorted((at(x), min(at(x + step), at(x - step)) < at(x)) for x in lows)


POLES = [0.005, 0.015, 0.03, 0.05, 0.1]


@pytest.mark.parametrize("pole_radius", POLES)
def test_a_tilted_ring_meets_a_pole_where_the_quartic_says(pole_radius: float) -> None:
    """To 1e-9 m at any attitude, pressed in by 3 mm or as far away: both points of 500 rings."""
    chance, seen_twice = np.random.default_rng(4), 0
    for _ in range(500):
        r, angle = turn(chance), chance.uniform(0.0, 2.0 * math.pi)
        away = pole_radius + chance.uniform(-0.003, 0.003)
        at = Vec(away * math.cos(angle), away * math.sin(angle), chance.uniform(-1.0, 1.0))
        centre = touching_at(at, r, chance)
        (nearest, _), *others = minima_by_quartic(centre, r)
        first, second = ring_at(Pole(0.0, 0.0, pole_radius), centre, r)
        assert first == pytest.approx(nearest - pole_radius, abs=1e-9)
        if others and others[0][0] < pole_radius:
            if second < FAR:
                assert second == pytest.approx(others[0][0] - pole_radius, abs=1e-9)
                seen_twice += 1
            else:  # a dip that is narrower than a step
                assert others[0][1]
        else:  # apart, it may be left out
            assert second > 0.0
    assert seen_twice > 5


@pytest.mark.parametrize("pole_radius", POLES)
def test_another_library_knows_no_nearer_point_of_a_pole(pole_radius: float) -> None:
    """distance3d's line and circle, 200 rings.

    It bisects eight times only, and for one ring in ten takes the other of two roots: what it says
    is never less, and mostly the same.
    """
    chance, same = np.random.default_rng(8), 0
    for _ in range(200):
        r = turn(chance)
        away = chance.uniform(0.3, 1.5) * (pole_radius + RADIUS)
        centre = Vec(away, 0.0, 0.3)
        normal = np.array([r.x.z, r.y.z, r.z.z])
        axis = np.array([0.0, 0.0, 1.0])
        far, *_ = line_to_circle(np.zeros(3), axis, np.array(centre), RADIUS, normal)
        first, _ = ring_at(Pole(0.0, 0.0, pole_radius), centre, r)
        assert first < far - pole_radius + 1e-9
        same += first > far - pole_radius - 1e-5
    assert same >= 170


BOX = Box(Vec(0.2, 0.1, 0.05))


def test_a_ring_meets_edges_and_corners_of_a_box() -> None:
    """To 1e-6 m in 300 random attitudes, where one fixed-point step erred by 0.1 m."""
    chance = np.random.default_rng(5)
    for _ in range(300):
        r = turn(chance)
        n = chance.normal(size=3)
        centre = Vec(*map(float, n / np.linalg.norm(n) * chance.uniform(0.1, 0.35)))
        found, _ = ring_at(BOX, centre, r)
        assert found == pytest.approx(sampled(BOX, centre, r), abs=1e-6)


def on_an_edge(chance: np.random.Generator) -> Vec:
    """A random point of a random edge of the box."""
    along = int(chance.integers(3))
    at = [h * float(chance.choice([-1.0, 1.0])) for h in BOX.half]
    at[along] *= float(chance.random())
    return Vec(*at)


def test_a_ring_that_passes_by_an_edge_is_where_a_search_along_the_edges_says() -> None:
    """To 1e-6 m for 100 rings that do not reach in: along edges instead of along the ring.

    distance3d says how far a point is from a circle, SciPy where on an edge it is least; a face is
    met where its plane is, if that point lies in it.
    """
    chance, counted = np.random.default_rng(9), 0
    corners = [np.array(c) for c in itertools.product(*((-h, h) for h in BOX.half))]
    edges = [(a, b) for a, b in itertools.combinations(corners, 2) if np.sum(a != b) == 1]
    shares = np.linspace(0.0, 1.0, 41)
    assert len(edges) == 12
    while counted < 100:
        r, edge = turn(chance), on_an_edge(chance)
        out = Vec(*(0.003 * float(chance.random()) * math.copysign(1.0, x) for x in edge))
        centre = touching_at(edge + out, r, chance)
        first, _ = ring_at(BOX, centre, r)
        if first < 1e-4:
            continue
        normal, c = np.array([r.x.z, r.y.z, r.z.z]), np.array(centre)
        far = []
        for a, b in edges:

            def away(share: float, a: Any = a, b: Any = b, c: Any = c, n: Any = normal) -> float:
                return float(point_to_circle(a + share * (b - a), c, RADIUS, n)[0])

            best = shares[int(np.argmin([away(x) for x in shares]))]
            near = (max(best - 0.025, 0.0), min(best + 0.025, 1.0))
            far.append(minimize_scalar(away, bounds=near, options={"xatol": 1e-9}).fun)
            far += [away(0.0), away(1.0)]
        for axis, side in itertools.product(range(3), (-1.0, 1.0)):
            down = np.zeros(3)
            down[axis] = -side
            flat = down - (down @ normal) * normal
            at = c + RADIUS * flat / np.linalg.norm(flat)
            if all(abs(at[k]) <= BOX.half[k] for k in range(3) if k != axis):
                far.append(abs(side * at[axis] - BOX.half[axis]))
        assert first == pytest.approx(min(far), abs=1e-6)
        counted += 1


class Counted(NamedTuple):
    """A pole that counts how often it is asked."""

    pole: Pole
    asked: Any


@signed_distance.register(Counted)  # type: ignore[attr-defined]
def counted_distance(shape: Counted, point: Vec) -> float:
    """That of the pole [m]."""
    shape.asked.append(point)
    return float(signed_distance(shape.pole, point))


@outward_normal.register(Counted)  # type: ignore[attr-defined]
def counted_normal(shape: Counted, point: Vec) -> Vec:
    """That of the pole."""
    shape.asked.append(point)
    normal: Vec = outward_normal(shape.pole, point)
    return normal


def test_a_search_asks_a_shape_less_often_than_golden_sections_did() -> None:
    """Which took 93 questions for one contact; for both, 200 rings that touch poles take 85 in the mean.

    Two more than before for each point: the normals on both sides of it, for its mean (there were 79,
    and the bound was 85).
    """
    chance, asked = np.random.default_rng(10), list[int]()
    for _ in range(200):
        r, radius = turn(chance), float(chance.choice(POLES))
        centre = touching_at(Vec(radius, 0.0, 0.0), r, chance)
        shape = Counted(Pole(0.0, 0.0, radius), [])
        lowest_on_ring(
            InBodyFrame(shape, centre, r), Vec(0.0, 0.0, 0.0), RADIUS, Vec(1.0, 0.0, 0.0)
        )
        asked.append(len(shape.asked))
    assert len(asked) == 200
    assert np.mean(asked) < 90
    assert max(asked) < 1 + 2 + ARCS * (STEPS + 2) + 4 * TRIES


class Step(NamedTuple):
    """Two half-planes of different slope: the distance of a wedge's inner corner, from inside."""

    left: float
    right: float


@signed_distance.register(Step)  # type: ignore[attr-defined]
def step_distance(step: Step, point: Vec) -> float:
    """Rises on both sides of y = 1 cm [m]."""
    return max(-step.left * (point.y - 0.01), step.right * (point.y - 0.01)) + point.x * 0.0


@outward_normal.register(Step)  # type: ignore[attr-defined]
def step_normal(step: Step, point: Vec) -> Vec:
    """Jumps from one side to the other."""
    return Vec(0.0, -step.left if point.y < 0.01 else step.right, 0.0)


@pytest.mark.parametrize("share", [1.0, 1e-3, 1e-6])
def test_a_kink_is_found_however_uneven_its_sides_are(share: float) -> None:
    """There a secant alone creeps; held near the middle it needs one try more than bisection."""
    for step in (Step(1.0, share), Step(share, 1.0)):
        found = lowest_on_ring(step, Vec(0.0, 0.0, 0.0), RADIUS, Vec(1.0, 0.0, 0.0))
        for low in (found.first, found.second):  # the line is crossed twice
            assert RADIUS * low.towards.y == pytest.approx(0.01, abs=1e-11)


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
    level = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, -1.0), Vec(0.0, 1.0, 0.0))  # ring plane on edge
    across = ring_at(Pole(0.0, 0.0, 0.01), Vec(0.0, -0.009, 0.0), level)
    assert across[0] == pytest.approx(-0.001, abs=1e-9)
    assert across[1] == pytest.approx(-0.001, abs=1e-9)
    beside = ring_at(Pole(0.0, 0.0, 0.01), Vec(0.0, -0.15, 0.0), turn(np.random.default_rng(1)))
    assert beside[0] < beside[1]


def test_a_ring_that_lies_flat_rests_on_one_point_outward_along_its_arm() -> None:
    """Rounding makes no minima of what is level: a slab below, turned by 1e-16."""
    level = rotation(Quat(1.0, 3e-17, -2e-17, 0.0))
    first, second = ring_at(Slab(0.0), Vec(0.0, 0.0, -0.002), level)
    assert first == pytest.approx(-0.002, abs=1e-12)
    assert second == FAR
    slanted = Vec(0.6, -0.8, 0.0)
    view = InBodyFrame(Slab(0.0), Vec(0.0, 0.0, -0.002), level)
    found = lowest_on_ring(view, Vec(0.0, 0.0, 0.0), RADIUS, slanted)
    assert found.first.towards == pytest.approx(slanted[:2], abs=1e-6)


@pytest.mark.parametrize("model", [Ring(0.0), Ring(5e-3), ArmTip(0.0)])
def test_planes_are_met_by_the_closed_form_to_the_bit(model: Any) -> None:
    """Eq. (13) written out: the bits of 2000 contacts from before other shapes were searched.

    No search may come between a plane and them.
    """
    chance = np.random.default_rng(11)
    for _ in range(2000):
        r, at = turn(chance), Vec(*map(float, 0.05 * chance.normal(size=3)))
        n = Vec(*map(float, chance.normal(size=3)))
        n = n * (1.0 / math.sqrt(n @ n))
        offset = float(n @ at - chance.uniform(-0.05, 0.35))
        angle, length = chance.uniform(-math.pi, math.pi), float(chance.uniform(0.14, 0.19))
        e = Vec(math.cos(angle), math.sin(angle), 0.0)
        pose = ArmPose(e, Vec(e.x * length, e.y * length, 0.0), Vec(0.0, 0.0, 0.0))
        there = obstacle_in_body_frame(Obstacle(Plane(n, offset), None, 0.0), at, r)  # type: ignore[arg-type]
        found = nearest_face(there.shape, model, RADIUS, pose)

        bx = n.x * r.x.x + n.y * r.y.x + n.z * r.z.x
        by = n.x * r.x.y + n.y * r.y.y + n.z * r.z.y
        bz = n.x * r.x.z + n.y * r.y.z + n.z * r.z.z
        if isinstance(model, Ring):
            eps = model.rounding
            inverse = 1.0 / math.sqrt(bx * bx + by * by + 0.0 + eps * eps)
            lever = (-bx * inverse * RADIUS, -by * inverse * RADIUS, 0.0)
            inset = -eps * eps * inverse * RADIUS
        else:
            along = RADIUS * e.x * -bx + RADIUS * e.y * -by + 0.0
            lever, inset = (-bx * along, -by * along, -bz * along), 0.0
        x, y, z = (p + q for p, q in zip(pose.lever, lever, strict=True))
        height = offset - (n.x * at.x + n.y * at.y + n.z * at.z)
        assert found.gap == bx * x + by * y + bz * z - height + inset
        assert found.inward == (-bx, -by, -bz)
        assert found.at.point == lever


def test_what_is_flat_without_saying_so_is_met_like_a_plane() -> None:
    """A plane goes the exact way, such a shape the general one: the same gap, and no second."""
    chance = np.random.default_rng(7)
    plane = Plane(Vec(0.0, 0.0, 1.0), 0.0)
    for _ in range(100):
        r, centre = turn(chance), Vec(0.0, 0.0, float(chance.uniform(-0.1, 0.2)))
        exact, _ = ring_at(plane, centre, r)
        found, second = ring_at(Slab(0.0), centre, r)
        assert found == pytest.approx(exact, abs=1e-15)
        assert second == FAR


def test_own_shapes_stand_twice_in_the_world_and_planes_once() -> None:
    """The second one is for the second point at which a ring touches."""
    wood = SurfaceSettings(law="hertz")
    world = obstacles((), [(Pole(0.0, 0.0, 0.05), wood), (Plane(Vec(0.0, 0.0, 1.0), -9.0), wood)])
    kinds = [type(entry.shape) for entry in world]
    assert kinds == [Pole, Plane, SecondContact]


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


def test_the_gap_of_a_second_contact_has_the_rate_that_its_force_works_at() -> None:
    """Minus the saddle's height where the ring is inside between both points: against differences."""
    chance, inside, tiny = np.random.default_rng(12), 0, 1e-7

    def second(centre: Vec, r: Mat3) -> Any:
        pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))
        there = obstacle_in_body_frame(Obstacle(SecondContact(BOX), None, 0.0), centre, r)  # type: ignore[arg-type]
        return nearest_face(there.shape, EXACT, RADIUS, pose)

    for _ in range(3000):
        r = turn(chance)
        centre = Vec(*map(float, chance.uniform(-1.3, 1.3, size=3) * 0.2))
        face = second(centre, r)
        if not -0.05 < face.gap < -1e-4 or face.saddle_inward @ face.saddle_inward == 0.0:
            continue
        move = chance.normal(size=3)
        v = Vec(*map(float, move / np.linalg.norm(move)))
        ahead, behind = (second(centre + v * (s * tiny), r).gap for s in (1.0, -1.0))
        in_body = v @ r
        rate = -face.steepness * (in_body @ face.inward) + in_body @ face.saddle_inward
        if abs(ahead - 2.0 * face.gap + behind) > 1e-10:  # another point or saddle takes over
            continue
        inside += 1
        assert (ahead - behind) / (2.0 * tiny) == pytest.approx(rate, abs=2e-5)
    assert inside > 30


def test_the_power_of_a_contact_is_that_of_its_spring() -> None:
    """Beneath edges, and with a saddle: no friction, no damping, so no energy is made or lost."""
    chance, edges, saddles, tiny = np.random.default_rng(13), 0, 0, 1e-7
    rubber = surface(stiffness=1e5)
    pose = ArmPose(Vec(1.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0))

    def face(shape: Any, centre: Vec, r: Mat3) -> ContactFace:
        there = obstacle_in_body_frame(Obstacle(shape, rubber, 0.0), centre, r)
        return face_of(there, EXACT, RADIUS, pose)

    for k in range(4000):
        shape = (BOX, SecondContact(BOX))[k % 2]
        r, centre = turn(chance), Vec(*map(float, chance.uniform(-0.26, 0.26, size=3)))
        met = face(shape, centre, r)
        if not -0.05 < met.nearest.gap < -1e-4:
            continue
        v, omega = (Vec(*map(float, chance.normal(size=3))) for _ in range(2))
        moving = ArmPose(pose.direction, pose.lever, v)
        contact = face_contact(met, 1.0, PartMemory((), ()), moving, body(r, v, omega))
        gaps = []
        for sign in (1.0, -1.0):
            spin = quaternion_product(quaternion_of(r), exponential_map(omega * (sign * tiny)))
            gaps.append(face(shape, centre + r @ v * (sign * tiny), rotation(spin)).nearest.gap)
        if abs(gaps[0] - 2.0 * met.nearest.gap + gaps[1]) > 1e-10:  # another point takes over
            continue
        assert (gaps[0] - gaps[1]) / (2.0 * tiny) == pytest.approx(contact.rate, abs=5e-5)
        depth = -met.nearest.gap
        spring = 1e5 * depth**1.5
        power = contact.touch.force @ v + contact.touch.moment @ omega
        assert power == pytest.approx(spring * contact.rate, rel=1e-9, abs=1e-9)
        edges += met.nearest.steepness < 0.99
        saddles += met.nearest.saddle_inward @ met.nearest.saddle_inward > 0.0
    assert edges > 30
    assert saddles > 30
