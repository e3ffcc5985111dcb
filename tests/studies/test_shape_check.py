"""Shapes of the user's own are checked from all sides, the hidden one included."""

import importlib.util
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from builders.cases import nonempty
from builders.user_obstacles import Ball, Box, Pole, pole_distance, pole_normal
from springback.contact.obstacles import outward_normal, signed_distance
from springback.kernels.compiler import kernel
from springback.kernels.vectors import Vec, norm
from springback.studies.shape_check import check_shape

START = Vec(0.0, 0.0, 1.0)


@pytest.mark.parametrize(
    "shape",
    [
        Pole(2.75, 0.0, 0.05),
        Ball(Vec(1.5, 0.3, 0.8), 0.4),
        Box(Vec(0.2, 0.3, 0.4), Vec(2.0, 0.0, 1.0)),
    ],
)
def test_a_good_shape_passes(shape: Any) -> None:
    assert [finding.sentence for finding in check_shape(shape, START) if not finding.passed] == []


class Implicit(NamedTuple):
    """Waves x > X + a cos(k y), their function over the length of its gradient everywhere."""

    x: float
    amplitude: float
    number: float
    band: float = 0.0


@signed_distance.register(Implicit)
def _(wave: Implicit, point: Vec) -> float:
    f = wave.x + wave.amplitude * math.cos(wave.number * point.y) - point.x
    return f / math.hypot(1.0, wave.amplitude * wave.number * math.sin(wave.number * point.y))


@outward_normal.register(Implicit)
def _(wave: Implicit, point: Vec) -> Vec:
    slope = wave.amplitude * wave.number * math.sin(wave.number * point.y)
    inverse = 1.0 / math.hypot(1.0, slope)
    return Vec(-inverse, -slope * inverse, 0.0)


def documented(folder: Path) -> Any:
    """The type of the recipe for implicit functions in docs/howto/obstacle.md."""
    text = (Path(__file__).parents[2] / "docs/howto/obstacle.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    path = folder / "documented_wave.py"
    path.write_text(next(one for one in blocks if "class Wavy" in one), encoding="utf-8")
    spec = importlib.util.spec_from_file_location("documented_wave", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.Wavy


def test_the_recipe_for_implicit_functions_passes_where_the_plain_one_fails(
    tmp_path: Path,
) -> None:
    """The message tells both gradients; what passes is nowhere above the distance by more than 1 %."""
    start = Vec(1.5, 0.0, 1.0)
    plain = [one for one in check_shape(Implicit(3.0, 0.5, 6.0), start) if not one.passed]
    assert re.search(
        r"signed_distance at \[[^]]*\] m changes by \S+ m over \S+ m; .* the largest that",
        plain[0].sentence,
    )
    wave = documented(tmp_path)(3.0, 0.5, 6.0, 0.025)
    assert [one.sentence for one in check_shape(wave, start) if not one.passed] == []
    y = np.linspace(-1.6, 1.6, 20_001)
    x = 3.0 + 0.5 * np.cos(6.0 * y)
    for across in nonempty(np.linspace(-0.6, 0.6, 25)):
        for ahead in nonempty(np.linspace(1.0, 3.5, 126)):
            returned = signed_distance(wave, Vec(float(ahead), float(across), 1.0))
            if returned > 1e-3:
                assert returned < 1.01 * np.hypot(x - ahead, y - across).min()


def test_it_says_at_how_many_points_it_looked() -> None:
    """Waves so flat that 5 % hide what is too much: nothing is said of other points."""
    found = {one.name: one for one in check_shape(Implicit(3.0, 0.1, 4.0), START)}
    assert found["signed_distance"].passed
    said = found["signed_distance"].sentence
    assert re.search(r"at the [0-9]{4} points looked at no more than 5 % above that to where", said)


class Wrong(NamedTuple):
    """A pole with an error."""

    x: float
    y: float
    radius: float
    kind: float


DISTANCES: list[Callable[[Any, Vec], Any]] = [
    lambda pole, point: 0.3 * pole_distance(pole, point),
    lambda pole, point: math.nan if point.x > 2.2 else pole_distance(pole, point),
    lambda pole, point: 1.0 / (point.x - point.x),
    lambda pole, point: (
        pole_distance(pole, point) * (1.0 if pole_distance(pole, point) > 0.0 else 0.3)
    ),
]
NORMALS: list[Callable[[Any, Vec], Vec]] = [
    lambda pole, point: pole_normal(pole, point) * (1.1 if point.x > 2.0 else 1.0),
    lambda pole, point: pole_normal(pole, point) * (-1.0 if point.x > 2.0 else 1.0),
    lambda pole, point: pole_normal(pole, point) * (1.1 if abs(point.z - 3.0) < 0.9 else 1.0),
    lambda pole, point: _near_only(pole, point, Vec(1.0, 0.0, 0.0)),
    lambda pole, point: pole_normal(pole, point) * (norm(pole_from(pole, point)) / pole.radius),
]


def pole_from(pole: Any, point: Vec) -> Vec:
    return Vec(point.x - pole.x, point.y - pole.y, 0.0)


def _near_only(pole: Any, point: Vec, elsewhere: Vec) -> Vec:
    """The normal on the surface, and another one beside it."""
    return pole_normal(pole, point) if abs(pole_distance(pole, point)) < 1e-5 else elsewhere


@signed_distance.register(Wrong)
def _(pole: Wrong, point: Vec) -> Any:
    if pole.kind < len(DISTANCES):
        return DISTANCES[int(pole.kind)](pole, point)
    return pole_distance(pole, point)


@outward_normal.register(Wrong)
def _(pole: Wrong, point: Vec) -> Any:
    if pole.kind >= len(DISTANCES):
        return NORMALS[int(pole.kind) - len(DISTANCES)](pole, point)
    return pole_normal(pole, point)


@pytest.mark.parametrize(
    ("kind", "name", "words"),
    [
        (0, "signed_distance", "changes by 0.3 m a metre"),
        (1, "signed_distance", "nan"),
        (2, "signed_distance", "ZeroDivisionError"),
        (3, "signed_distance", "mm inside, changes by 0.3 m a metre"),
        (4, "outward_normal", "1.1 long"),  # on the side that the start does not see
        (5, "outward_normal", "gradient of signed_distance is"),
        (6, "outward_normal", "1.1 long"),  # two metres above the start
        (7, "outward_normal", "0.1 mm inside, is [1, 0, 0]"),
        (8, "outward_normal", "1 long"),  # of a length that is right on the surface only
    ],
)
def test_an_error_is_found_and_named(kind: int, name: str, words: str) -> None:
    failed = {
        finding.name: finding.sentence
        for finding in check_shape(Wrong(2.0, 0.0, 0.05, kind), START)
        if not finding.passed
    }
    assert words in failed.pop(name)
    assert failed.keys() <= {"has a surface", "answers everywhere"}


def test_a_shape_without_a_surface_is_said_to_have_none() -> None:
    found = check_shape(Pole(2.0, 0.0, -1.0), START)
    assert not found[0].passed


class Limited(NamedTuple):
    """A ball of which the distance is told within half a metre only."""

    centre: Vec
    radius: float


@signed_distance.register(Limited)
def _(ball: Limited, point: Vec) -> float:
    return min(norm(point - ball.centre) - ball.radius, 0.5)


@outward_normal.register(Limited)
def _(ball: Limited, point: Vec) -> Vec:
    away = point - ball.centre
    return away * (1.0 / norm(away))


def test_a_shape_is_found_where_it_is_though_its_distance_is_limited() -> None:
    found = check_shape(Limited(Vec(2.0, -3.0, 5.0), 0.3), START)
    assert [finding.name for finding in found if not finding.passed] == []
    assert "sampled in" in found[0].sentence


class Egg(NamedTuple):
    """An ellipsoid by an implicit function over the length of its gradient, as the guide has it."""

    centre: Vec
    half: Vec


@kernel
def _slope_of(egg: Egg, point: Vec) -> tuple[float, Vec]:
    d, h = point - egg.centre, egg.half
    value = (d.x / h.x) ** 2 + (d.y / h.y) ** 2 + (d.z / h.z) ** 2 - 1.0
    return value, Vec(d.x / h.x**2, d.y / h.y**2, d.z / h.z**2) * 2.0


@signed_distance.register(Egg)
@kernel
def _(egg: Egg, point: Vec) -> float:
    value, slope = _slope_of(egg, point)
    return value / (norm(slope) + 1e-12)


@outward_normal.register(Egg)
@kernel
def _(egg: Egg, point: Vec) -> Vec:
    slope = _slope_of(egg, point)[1]
    return slope * (1.0 / norm(slope))


@pytest.mark.parametrize("half", [Vec(0.2, 0.1, 0.05), Vec(1.0, 0.5, 0.7), Vec(0.1, 0.1, 0.4)])
def test_an_implicit_function_over_the_length_of_its_gradient_passes(half: Vec) -> None:
    found = check_shape(Egg(Vec(2.0, 0.3, 0.6), half), START)
    assert [finding.sentence for finding in found if not finding.passed] == []
