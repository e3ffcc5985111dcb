"""Shapes of the user's own are checked from all sides, the hidden one included."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest

from builders.user_obstacles import Ball, Box, Pole, pole_distance, pole_normal
from springback.contact.obstacles import outward_normal, signed_distance
from springback.kernels.vectors import Vec
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
]
NORMALS: list[Callable[[Any, Vec], Vec]] = [
    lambda pole, point: pole_normal(pole, point) * (1.1 if point.x > 2.0 else 1.0),
    lambda pole, point: pole_normal(pole, point) * (-1.0 if point.x > 2.0 else 1.0),
]


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
        (3, "outward_normal", "1.1 long"),  # on the side that the start does not see
        (4, "outward_normal", "gradient of signed_distance is"),
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
