"""Lines of keys and entries in a TOML text, also inside lists and inline tables."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from springback.errors import InputError
from springback.scenario.files import read_scenario
from springback.scenario.key_lines import line_of
from springback.scenario.source_text import toml_tables

TEXT = """\
name = "a = b, [ { #"  # [start] = {
long = '''
[vehicle]
mass = 1
'''
[[world.obstacles]]
type = "union"
shapes = [  # { ] "
  { type = "sphere", position = [0, 0, 0], motion.kind = "a" },

  { type = "box", "size" = [
      1,
      [2, 3], "]",
  ] },
]
[[world.obstacles.marks]]
at = 1
[[world.obstacles]]
type = "ground"
surface.friction = 0.5
[[world.obstacles.marks]]
at = 2
[[ "world" . obstacles . marks ]]
at = 3
[world.obstacles.motion]
rate = 1
[vehicle]
arms = { joint = { type = "slide" }, mass = 2 }
last = [0, 1]"""
SHAPES: tuple[Any, ...] = ("world", "obstacles", 0, "shapes")
PLACES: dict[int, list[tuple[str | int, ...]]] = {
    1: [("name",)],
    2: [("long",)],
    6: [("world", "obstacles", 0), ("world", "obstacles", 0, "none")],
    8: [SHAPES, (*SHAPES, 7)],
    9: [(*SHAPES, 0), (*SHAPES, 0, "radius"), (*SHAPES, 0, "motion", "kind")],
    11: [(*SHAPES, 1), (*SHAPES, 1, "type"), (*SHAPES, 1, "size")],
    12: [(*SHAPES, 1, "size", 0)],
    13: [(*SHAPES, 1, "size", 1, 1), (*SHAPES, 1, "size", 2)],
    17: [("world", "obstacles", 0, "marks", 0, "at")],
    20: [("world", "obstacles", 1, "surface", "friction")],
    22: [("world", "obstacles", 1, "marks", 0, "at")],
    24: [("world", "obstacles", 1, "marks", 1, "at")],
    26: [("world", "obstacles", 1, "motion", "rate")],
    27: [("vehicle", "body", "mass")],
    28: [("vehicle", "arms", "joint", "type"), ("vehicle", "arms", "mass")],
    29: [("vehicle", "last", 1)],
}


@pytest.mark.parametrize("line", PLACES)
def test_a_key_is_on_the_line_that_mentions_it_most_specifically(line: int) -> None:
    tomllib.loads(TEXT)
    assert {path: line_of(TEXT, path) for path in PLACES[line]} == dict.fromkeys(PLACES[line], line)


def test_a_key_without_a_mention_has_no_line() -> None:
    assert line_of(TEXT, ("start",)) is None
    assert line_of(TEXT, ("world",)) is None
    assert line_of("", ("start",)) is None


def test_what_is_inside_a_string_is_no_key() -> None:
    assert line_of(TEXT, ("mass",)) is None


@pytest.mark.parametrize(
    "text", ['a = [{ b = "', "a = ]]}", "a = {{{ = [", "a = [" * 500, "[[]]\n]="]
)
def test_a_text_that_is_no_toml_ends(text: str) -> None:
    line_of(text, ("a", 0, "b"))


UNION = """\
vehicle = "arq"
thrust = "hover"

[[world.obstacles]]
type = "union"
position = [3, 0, 1]
surface = "wall"
shapes = [
  { type = "sphere", position = [0, 0, 0], radius = "0.2 m" },
  { type = "box", position = [0, 0, 1], size = [1, 1, "-1 m"] },
  { type = "spher", position = [0, 0, 0], radius = "0.2 m" },
]
"""


def test_a_wrong_value_inside_a_list_is_blamed_on_its_own_line(tmp_path: Path) -> None:
    (tmp_path / "union.toml").write_text(UNION)
    with pytest.raises(InputError) as refused:
        read_scenario(tmp_path / "union.toml")
    found = [line.removeprefix(f"{tmp_path}/").split(": ")[:2] for line in refused.value.problems]
    assert found == [
        ["union.toml:10", "world.obstacles[0].shapes[1].size"],
        ["union.toml:11", "world.obstacles[0].shapes[2].type"],
    ]


def test_a_shape_of_a_union_that_would_move_is_refused(tmp_path: Path) -> None:
    """It was accepted, and stood still."""
    moving = UNION.replace(
        'radius = "0.2 m" },\n  { type = "box"',
        'radius = "0.2 m", motion = { type = "constant", velocity = [-1, 0, 0] } },\n  { type = "box"',
    ).replace('"-1 m"', "1")
    (tmp_path / "union.toml").write_text(moving.replace('"spher"', '"sphere"'))
    with pytest.raises(InputError, match=r"shapes\[0\]\.motion: cannot be given: .*move together"):
        read_scenario(tmp_path / "union.toml")


REPEATED = {
    "a key": (
        "[start]\nroll = 0\npitch = 1\nroll = [\n 1,\n 2]\n",
        "a.toml:6: start.roll: is given twice; the first is in line 2",
    ),
    "a table": (
        "[start]\nroll = 0\n[world]\n[start]\n",
        "a.toml:4: start: is given twice; the first is in line 1",
    ),
    "within an entry": (
        "[[hulls]]\non = 1\n[[hulls]]\non = 2\ntype = 'ring'\non = 3\n",
        "a.toml:6: hulls[1].on: is given twice; the first is in line 4",
    ),
    "a list of many": (
        "a = [1, 2]\nb = [{c = 1}, {c = 2}]\na = [1, 2]\n",
        "a.toml:3: a: is given twice; the first is in line 1",
    ),
    "inside of a value": (
        "x = 1\nvehicle = 'arq'\n[vehicle.arms]\n",
        "a.toml:3: vehicle.arms: is inside vehicle, which has a value in line 2: make that a table",
    ),
    "of an inline table": (
        "a = 1\nb = {c = 1, c = 2}\n",
        "a.toml:2: is not TOML: Duplicate inline table key 'c'",
    ),
}


@pytest.mark.parametrize("case", REPEATED)
def test_a_key_that_is_given_twice_is_named_with_both_lines(case: str) -> None:
    text, words = REPEATED[case]
    with pytest.raises(InputError) as refused:
        toml_tables(text, "a.toml")
    assert str(refused.value).startswith(words)
