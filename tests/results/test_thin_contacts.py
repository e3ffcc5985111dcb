"""Contacts that came deeper than forces hold where they were, edges of meshes, grazing touches."""

from __future__ import annotations

import re
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from builders.forms import beside, box_triangles, stl_bytes
from springback.contact.grids import distance_grids
from springback.errors import ContactWarning
from springback.results.flight import Flight, fly
from springback.simulation.measuring.measures import SLOWEST

#: The rim of a table top of 40 mm, met by a level ring at 2 m/s: 12.6 mm deep.
TOP = {"position": [2.4, 0.0, 1.0], "surface": "wall"}
SIZE = (0.8, 0.6, 0.04)
BOX = {"type": "box", "size": list(SIZE), **TOP}


def at_a_rim(obstacles: list[dict[str, Any]], aside: float = 0.0) -> tuple[Flight, list[str]]:
    """Flight into an obstacle, above its middle [m], and what is said of its contacts."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        flight = fly(
            {
                "vehicle": "arq", "thrust": "hover", "world": {"obstacles": obstacles},
                "start": {
                    "position": [1.2, 0.0, 1.0 + aside], "velocity": [2.0, 0.0, 0.0],
                    "touch_distance": 0.01,
                },
                "simulation": {"duration": 0.12},
            }
        )  # fmt: skip
    return flight, [str(one.message) for one in caught if one.category is ContactWarning]


Sides = tuple[float, float, float]


def mesh(path: Path, *boxes: tuple[Sides, Sides]) -> dict[str, Any]:
    """Mesh of boxes, each of a size, about a place [m]."""
    path.write_bytes(stl_bytes(beside(*((box_triangles(*size), at) for size, at in boxes))))
    return {"type": "mesh", "file": str(path), "cell": 0.005, **TOP}


def test_beside_an_edge_a_mesh_says_by_how_much_its_forces_are_too_weak(tmp_path: Path) -> None:
    """A third, 10 mm off the middle; at the middle 1 %, of which it says nothing."""
    top = mesh(tmp_path / "top.stl", (SIZE, (0.0, 0.0, 0.0))) | {"cell": 0.004}
    middle, silent = at_a_rim([top])
    aside, said = at_a_rim([top], 0.01)
    box, _ = at_a_rim([BOX], 0.01)
    assert silent == []
    [sentence] = said
    found = re.search(
        r"two sides of world.obstacles\[0\], a mesh .* some (\d+) % too weak", sentence
    )
    assert found is not None, sentence
    peaks = [one.measures["impact_peak_acceleration"] for one in (middle, aside, box)]
    assert peaks[0] == pytest.approx(259.0, rel=0.03)
    assert peaks[2] == pytest.approx(259.0, rel=0.03)
    assert 1.0 - (peaks[1] or 0.0) / (peaks[2] or 1.0) >= 0.01 * int(found[1])


@pytest.mark.parametrize("aside", [0.0, 0.006])
def test_a_rim_deeper_than_forces_hold_is_told_of_wherever_it_is_hit(
    tmp_path: Path, aside: float
) -> None:
    """Also in its middle, from where it is far to the other end, and near to both sides."""
    top = mesh(tmp_path / "top.stl", (SIZE, (0.0, 0.0, 0.0))) | {"cell": 0.01}
    flight, [said] = at_a_rim([top], aside)
    depth = flight.measures["penetration"]
    assert depth is not None
    found = re.search(r"a contact came ([\d.]+) mm deep, .* hold to some 5 mm", said)
    assert found is not None, said
    assert float(found[1]) == pytest.approx(1e3 * depth, rel=0.1)
    assert "give it smaller cells (cell, 0.00117 m or more)" in said


def test_smaller_cells_are_asked_for_only_where_there_can_be_some(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else the mesh has to be parted; so at an edge, and where forces do not hold."""
    top = mesh(tmp_path / "top.stl", (SIZE, (0.0, 0.0, 0.0)))
    for cell, aside in ((0.004, 0.01), (0.005, 0.0)):
        monkeypatch.setattr(distance_grids, "MOST_NODES", 16_000_000)
        _, [can] = at_a_rim([top | {"cell": cell}], aside)
        monkeypatch.setattr(distance_grids, "MOST_NODES", 400_000 if cell > 0.004 else 700_000)
        _, [cannot] = at_a_rim([top | {"cell": cell}], aside)
        parted = "make its thin parts a mesh of their own, which is a further obstacle, or boxes"
        assert ("give it smaller cells" in can, parted in can) == (True, False)
        assert ("smaller cells" in cannot, parted in cannot) == (False, True)


def test_what_is_doubtful_is_in_the_summary(tmp_path: Path) -> None:
    """As `springback fly` prints it, and only then."""
    top = mesh(tmp_path / "top.stl", (SIZE, (0.0, 0.0, 0.0)))
    doubtful, said = at_a_rim([top], 0.01)
    warned = doubtful.summary()["warnings"]
    assert [f"flight: {one}" for one in warned] == said
    assert at_a_rim([BOX])[0].summary()["warnings"] == []


BLOCK = {"type": "box", "size": [0.5, 0.5, 0.5], "position": [2.25, 0.0, 1.0], "surface": "wall"}


@pytest.mark.parametrize(("box", "half"), [(BOX, 0.02), (BLOCK, 0.25)])
@pytest.mark.parametrize("below", [0.010, 0.005])
def test_a_contact_that_is_pushed_out_over_an_edge_is_told_of(
    box: dict[str, Any], half: float, below: float
) -> None:
    """Below an edge by less than the 12.6 mm that it would come deep: it passes, however thick."""
    flight, [said] = at_a_rim([box], half - below)
    assert (flight.measures["restitution_at_separation"] or 0.0) < 0.0
    found = re.search(r"came ([\d.]+) mm deep into world.obstacles\[0\], a box, where", said)
    assert found is not None, said
    assert "pushed out over the edge, not back" in said
    assert 1e-3 * float(found[1]) == pytest.approx(below, rel=0.05)


@pytest.mark.parametrize(
    "there",
    [
        {"yaw": "45 deg", "position": [2.4, 0.0, 1.0]}, {"yaw": "30 deg"}, {"pitch": "30 deg"},
        {"position": [2.25, -0.116, 1.0]}, {"position": [2.25, -0.113, 1.0]},
        {"position": [2.25, -0.25, 1.0]}, {"position": [2.25, 0.0, 1.0 - 0.25 + 0.014]},
    ],
)  # fmt: skip
def test_corners_and_edges_that_throw_back_are_not(there: dict[str, Any]) -> None:
    """Met along the edge, aslant, or deeper below it than the contact comes."""
    assert at_a_rim([BLOCK | there])[1] == []


def test_a_single_board_holds_deeper_than_half_and_one_in_a_union_does_not() -> None:
    """As docs/howto/obstacle.md has it: 12.6 mm deep in 10 mm; with shelves before it, through."""

    place = {"position": [2.0, 0.0, 1.0], "surface": "wall"}

    def board(thickness: float) -> dict[str, Any]:
        return {"type": "box", "position": [0.5 * thickness, 0, 0], "size": [thickness, 2.0, 2.0]}

    def by_itself(thickness: float) -> Any:
        there = {**board(thickness), **place, "position": [2.0 + 0.5 * thickness, 0, 1.0]}
        return at_a_rim([there])[0].measures

    def with_shelves(thickness: float) -> Any:
        shelf = {"type": "box", "size": [0.3, 2.0, 0.02]}
        shelves = [{**shelf, "position": [-0.15, 0, z]} for z in (0.3, -0.3)]
        union = {"type": "union", **place, "shapes": [board(thickness), *shelves]}
        return at_a_rim([union])[0].measures

    alone, joined = (
        [measures(thickness) for thickness in (0.01, 0.5)] for measures in (by_itself, with_shelves)
    )
    peak, depth = "impact_peak_acceleration", "penetration"
    assert alone[0][peak] == pytest.approx(alone[1][peak], rel=1e-12)
    assert alone[0][depth] == pytest.approx(12.6e-3, abs=0.1e-3)
    assert joined[1][peak] == pytest.approx(alone[1][peak], rel=1e-6)
    assert joined[0][peak] > 3.0 * joined[1][peak]


#: A plate of 20 mm out of reach, and in the way.
PLATE, AWAY, AHEAD = (0.02, 0.5, 0.5), (0.5, 0.0, 0.0), (-0.41, 0.0, 0.0)


@pytest.mark.parametrize(("place", "told"), [(AWAY, False), (AHEAD, True)])
def test_a_thin_part_is_told_of_where_it_is_touched(
    tmp_path: Path, place: Sides, told: bool
) -> None:
    """In a mesh and a union: a thick block is hit as deep as the middle of the plate is."""
    block = ((0.8, 0.6, 0.4), (0.0, 0.0, 0.0))
    apart = (place[0] - (0.03 if told else 0.0), 0.0, 0.0)
    of_mesh = mesh(tmp_path / "both.stl", block, (PLATE, apart)) | {"cell": 0.004}
    shapes = [{"type": "box", "size": list(size), "position": list(at)}
              for size, at in (block, (PLATE, apart))]  # fmt: skip
    for obstacle in (of_mesh, {"type": "union", "shapes": shapes, **TOP}):
        flight, said = at_a_rim([obstacle])
        assert flight.measures["penetration"] == pytest.approx(0.0126, abs=4e-3)
        assert bool(said) == told, said


def test_a_touch_that_is_next_to_none_has_no_restitution() -> None:
    """Of a ball that falls past a wall: what moves it later is no rebound; slower than that, none."""
    flight, _ = at_a_rim([BOX])
    measures = flight.measures | {
        "restitution_at_separation": 4.0, "touch_speed": 0.1, "separation_time": None,
    }  # fmt: skip
    line = next(one for one in repr(replace(flight, measures=measures)).splitlines() if "4" in one)
    assert "than it came, which it grazed: 0.1 of 2 m/s; spin" in line
    still = {"position": [2.4 - 0.4 - 0.35, 0.0, 1.0], "velocity": [0.5 * SLOWEST, 0.0, 0.0]}
    slow = fly(
        {
            "vehicle": "quad", "thrust": "hover", "world": {"obstacles": [BOX]},
            "start": {**still, "touch_distance": 0.0}, "simulation": {"duration": 0.5},
        }
    )  # fmt: skip
    assert slow.touch_time is not None
    assert slow.separation_time is not None
    assert slow.restitution_at_separation is None
