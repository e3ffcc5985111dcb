"""Obstacles of one's own are sampled: a wrong distance or normal is refused before it is flown."""

from __future__ import annotations

import math
import time
from typing import Any, NamedTuple

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from builders.user_obstacles import Ball, Box, Pole
from springback import WALL, fly
from springback.contact.obstacles import outward_normal, signed_distance
from springback.errors import InputError
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec, norm
from springback.scenario.user.obstacles import check_own_obstacles, check_shape_from

START = Vec(2.2, 0.0, 1.0)
SCENARIO = {
    "vehicle": "arq",
    "thrust": "hover",
    "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
}


class Face(NamedTuple):
    """A wall at X = 2.75 m whose two functions are spoilt."""

    stretch: float  # of the distance
    length: float  # of the normal
    turn: float  # of the normal about Z [rad]


@signed_distance.register(Face)  # type: ignore[attr-defined]
@kernel
def face_distance(face: Face, point: Vec) -> float:
    return face.stretch * (2.75 - point.x)


@outward_normal.register(Face)  # type: ignore[attr-defined]
@kernel
def face_normal(face: Face, point: Vec) -> Vec:
    return Vec(-math.cos(face.turn) * face.length, -math.sin(face.turn) * face.length, 0.0)


class Egg(NamedTuple):
    """An ellipsoid by F/|∇F|: a distance near its surface only."""

    centre: Vec
    a: float
    b: float


@signed_distance.register(Egg)  # type: ignore[attr-defined]
@kernel
def egg_distance(egg: Egg, point: Vec) -> float:
    d = point - egg.centre
    x, y, z = d.x / egg.a, d.y / egg.b, d.z / egg.b
    f = math.sqrt(x * x + y * y + z * z)
    gx, gy, gz = x / egg.a, y / egg.b, z / egg.b
    return f * (f - 1.0) / math.sqrt(gx * gx + gy * gy + gz * gz)


@outward_normal.register(Egg)  # type: ignore[attr-defined]
@kernel
def egg_normal(egg: Egg, point: Vec) -> Vec:
    d = point - egg.centre
    g = Vec(d.x / egg.a**2, d.y / egg.b**2, d.z / egg.b**2)
    return g * (1.0 / math.sqrt(g @ g))


class Blown(NamedTuple):
    """A ball of 0.3 m whose distance is a multiple of the true one."""

    centre: Vec
    stretch: float


@signed_distance.register(Blown)  # type: ignore[attr-defined]
@kernel
def blown_distance(ball: Blown, point: Vec) -> float:
    return ball.stretch * (norm(point - ball.centre) - 0.3)


@outward_normal.register(Blown)  # type: ignore[attr-defined]
@kernel
def blown_normal(ball: Blown, point: Vec) -> Vec:
    d = point - ball.centre
    return d * (1.0 / norm(d))


RIGHT = Face(1.0, 1.0, 0.0)
#: Spoilt, and words of what is said.
WRONG: dict[str, tuple[Any, tuple[str, ...]]] = {
    "normal of length 2": (RIGHT._replace(length=2.0), ("outward_normal", "2 long", "1 long")),
    "normal of length 1/2": (RIGHT._replace(length=0.5), ("outward_normal", "0.5 long")),
    "normal 127 deg off": (RIGHT._replace(turn=2.2), ("outward_normal", "gradient")),
    "normal 1 deg off": (RIGHT._replace(turn=math.radians(1.0)), ("outward_normal", "gradient")),
    "normal NaN": (RIGHT._replace(length=math.nan), ("outward_normal", "nan")),
    "normal zero": (RIGHT._replace(length=0.0), ("outward_normal", "0 long")),
    "normal inwards": (RIGHT._replace(length=-1.0), ("outward_normal", "gradient")),
    "distance times 3": (RIGHT._replace(stretch=3.0), ("signed_distance", "no farther than")),
    "distance times 0.3": (RIGHT._replace(stretch=0.3), ("signed_distance", "0.3 m a metre")),
    "distance NaN": (RIGHT._replace(stretch=math.nan), ("signed_distance", "nan", "finite")),
}


@pytest.mark.parametrize(("shape", "words"), WRONG.values(), ids=WRONG.keys())
def test_what_is_wrong_is_refused(shape: Any, words: tuple[str, ...]) -> None:
    """All but one of these flew, and nothing said that the result was another surface's."""
    with pytest.raises(InputError) as caught:
        fly(SCENARIO, own=[(Pole(9.0, 9.0, 0.1), WALL), (shape, WALL)], executor="python")
    said = str(caught.value)
    assert said.startswith("own[1], Face: ")
    for word in words:
        assert word in said


def test_a_distance_over_whose_surface_rays_jump_is_too_steep() -> None:
    """Eight times the true one: a stride goes beyond the ball, and no ray meets it."""
    start = Vec(0.0, 0.0, 0.0)
    with pytest.raises(
        InputError, match=r"signed_distance at .* changes by .* over .*; a distance"
    ):
        check_shape_from(start, Blown(Vec(1.0, 0.1, 0.0), 8.0), "shape")
    check_shape_from(start, Blown(Vec(1.0, 0.1, 0.0), 1.0), "shape")


place = st.builds(Vec, st.floats(-5.0, 5.0), st.floats(-5.0, 5.0), st.floats(-5.0, 5.0))
size = st.floats(0.02, 2.0)
shapes = st.one_of(
    st.builds(Pole, st.floats(-5.0, 5.0), st.floats(-5.0, 5.0), st.floats(0.02, 2.0)),
    st.builds(Ball, place, st.floats(0.02, 2.0)),
    st.builds(Box, st.builds(Vec, size, size, size), place),
    st.builds(Egg, place, st.floats(0.1, 0.3), st.floats(0.1, 0.3)),
    st.just(RIGHT),
)


@settings(max_examples=150, deadline=None)
@given(shapes, place)
def test_what_is_right_is_left_alone(shape: Any, start: Vec) -> None:
    """Curved, edged and implicit shapes anywhere, from any start outside."""
    assume(not isinstance(shape, Egg) or norm(start - shape.centre) > 0.3)
    if signed_distance(shape, start) > 0.05:
        check_own_obstacles([(shape, WALL)], start)


class Tube(NamedTuple):
    """A torus about the X axis, with its distance times a factor."""

    x: float
    stretch: float


@signed_distance.register(Tube)  # type: ignore[attr-defined]
@kernel
def tube_distance(tube: Tube, point: Vec) -> float:
    away = math.sqrt(point.y**2 + (point.z - 1.0) ** 2) - 0.15
    return tube.stretch * (math.sqrt(away * away + (point.x - tube.x) ** 2) - 0.03)


@outward_normal.register(Tube)  # type: ignore[attr-defined]
@kernel
def tube_normal(tube: Tube, point: Vec) -> Vec:
    q = math.sqrt(point.y**2 + (point.z - 1.0) ** 2) + 1e-12
    away = q - 0.15
    n = 1.0 / (math.sqrt(away * away + (point.x - tube.x) ** 2) + 1e-12)
    return Vec((point.x - tube.x) * n, away * n * point.y / q, away * n * (point.z - 1.0) / q)


@pytest.mark.parametrize("start", [START, Vec(2.7, 0.0, 1.0)])
def test_a_ring_is_looked_at_from_its_axis_too(start: Vec) -> None:
    """Every ray along an axis or a diagonal misses it, and its gradient points through it."""
    assert len(check_shape_from(start, Tube(2.75, 1.0), "ring").surface) > 2
    with pytest.raises(InputError, match="its surface is no farther than"):
        check_shape_from(start, Tube(2.75, 1.5), "ring")


def test_it_costs_milliseconds_once() -> None:
    """Flights from the same place do not pay again."""
    pole = Pole(2.75, 0.0, 0.05)
    check_own_obstacles([(pole, WALL)], START)
    begun = time.perf_counter()
    for _ in range(1000):
        check_own_obstacles([(pole, WALL)], START)
    assert time.perf_counter() - begun < 0.1


@pytest.mark.parametrize("entry", [3, (RIGHT,), (RIGHT, "wall"), (object(), WALL), None])
def test_what_is_no_obstacle_is_refused(entry: Any) -> None:
    """A pair is asked for, in words."""
    with pytest.raises(InputError, match=r"own\[0\]: must be a pair"):
        fly(SCENARIO, own=[entry], executor="python")


class Nothing(NamedTuple):
    """Nothing is registered for it."""

    x: float


class HalfDone(NamedTuple):
    """Only its distance is registered."""

    x: float


def test_errors_of_the_users_functions_are_told_with_their_place() -> None:
    """A shape without functions, in one line."""
    with pytest.raises(InputError, match=r"own\[0\], Nothing: .*has no signed_distance"):
        fly(SCENARIO, own=[(Nothing(1.0), WALL)], executor="python")


@signed_distance.register(HalfDone)  # type: ignore[attr-defined]
@kernel
def half_distance(half: HalfDone, point: Vec) -> float:
    return half.x - point.x


def test_a_shape_without_a_normal_is_named_with_its_file() -> None:
    """Was: ':1: TypeError', without a file."""
    with pytest.raises(InputError) as caught:
        check_own_obstacles([(HalfDone(3.0), WALL)], START)
    assert str(caught.value) == (
        f"own[0], HalfDone: {__file__}: has no outward_normal: register one, by "
        "@outward_normal.register(HalfDone)"
    )
