"""Obstacles that cannot be: each is refused with its file, line, field, value and range."""

from __future__ import annotations

from pathlib import Path

import pytest

from springback.errors import InputError
from springback.scenario.files import read_scenario

START = """\
vehicle = "arq"
thrust = "hover"
[start]
position = [0, 0, "1 m"]
"""
UNION = """\
[[world.obstacles]]
type = "union"
surface = {surface}
shapes = [
  {{ type = "sphere", position = [3, 0, 0], radius = "0.2 m" }},
  {{ type = "box", position = [3, 0, 1], size = ["0.2 m", "1 m", "1 m"]{more} }},
]
"""
POLE = """\
[[world.obstacles]]
type = "pole"
position = ["3 m", {y}, 0]
radius = "0.1 m"
surface = {surface}
"""
MOVES = 'motion = { type = "constant", velocity = ["0.1 m/s", 0, 0] }\n'
IMPULSE = '{ law = "impulse", restitution = 0.5 }'
WALL = POLE.format(y=0, surface='"wall"')
TABLE = """\
[world.obstacles.motion]
type = "table"
time = ["0 s", "2 s", "1 s"]
position = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
"""

CASES = {
    "edge in a union": (
        UNION.format(surface='"wall"', more=', edge_radius = "20 cm"'),
        r":10: world\.obstacles\[0\]\.shapes\[1\]\.edge_radius: must be at most 0\.1 m, half of the "
        r"thinnest part \(got 0\.2 m\)",
    ),
    "name in a union": (
        UNION.format(surface='"wall"', more=', name = "the door"'),
        r":10: world\.obstacles\[0\]\.shapes\[1\]\.name: cannot be given: .* \(got 'the door'\)",
    ),
    "impulse that moves": (
        POLE.format(y=0, surface=IMPULSE) + MOVES,
        r":9: world\.obstacles\[0\]\.surface\.law: must not be impulse in a world where an obstacle "
        r"moves, as world\.obstacles\[0\] does",
    ),
    "impulse beside what moves": (
        WALL + MOVES + UNION.format(surface=IMPULSE, more=""),
        r":13: world\.obstacles\[1\]\.surface\.law: must not be impulse .*world\.obstacles\[0\] does",
    ),
    "nine that move": (
        "".join(POLE.format(y=k, surface='"wall"') + MOVES for k in range(9)),
        r":58: world\.obstacles\[8\]\.motion: must be left out: at most 8 obstacles can move "
        r"\(got 9\)",
    ),
    "instants that decrease": (
        WALL + TABLE,
        r":12: world\.obstacles\[0\]\.motion\.time\[2\]: must be more than 2 s, .*\(got 1 s\)",
    ),
    "hinge of a wall": (
        '[[world.obstacles]]\ntype = "wall"\ndistance = "3 m"\nsurface = "wall"\n'
        'motion = { type = "hinge", mass = "1 kg", pivot = [3, 0, 0] }\n',
        r":9: world\.obstacles\[0\]\.motion\.type: must be constant, sine or table \(got 'hinge'\); "
        r"hinge is a motion of an obstacle with an end: box, .*pole with a height",
    ),
    "hinge of a pole without end": (
        WALL + 'motion = { type = "hinge", mass = "1 kg", pivot = [3, 0, 0] }\n',
        r":10: world\.obstacles\[0\]\.motion\.type: must be constant, sine or table for an obstacle "
        r"without an end, which has no mass \(got 'hinge'\)",
    ),
    "name that is no text": (
        WALL + "name = 5\n",
        r":10: world\.obstacles\[0\]\.name: .*string \(got 5\)",
    ),
    "name that is too long": (
        WALL + f'name = "{"a" * 201}"\n',
        r":10: world\.obstacles\[0\]\.name: must have at most 200 characters \(got 201\)",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_it_is_refused_where_it_is_written(case: str, tmp_path: Path) -> None:
    given, words = CASES[case]
    (tmp_path / "scenario.toml").write_text(START + given)
    with pytest.raises(InputError, match=rf"scenario\.toml{words}") as refused:
        read_scenario(tmp_path / "scenario.toml")
    assert len(refused.value.problems) == 1
    assert "did you mean" not in str(refused.value)


def test_edges_as_wide_as_can_be_are_accepted(tmp_path: Path) -> None:
    good = UNION.format(surface='"wall"', more=', edge_radius = "9 cm"')
    (tmp_path / "scenario.toml").write_text(START + good)
    read_scenario(tmp_path / "scenario.toml")


def test_a_start_inside_is_told_by_the_obstacles_own_name(tmp_path: Path) -> None:
    near = WALL.replace('"3 m"', '"0.1 m"') + 'name = "the mast"\n'
    (tmp_path / "scenario.toml").write_text(START + near)
    with pytest.raises(InputError, match=r"inside world\.obstacles\[0\], the mast \(got"):
        read_scenario(tmp_path / "scenario.toml")
