"""Thickness of the thinnest parts of meshes, the cells that they get, and forces on them."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.forms import ball_triangles, beside, box_triangles, stl_bytes
from springback.contact.grids.distance_grids import NODES_IF_THIN, cell_of, fitting_cell
from springback.contact.grids.mesh_files import Triangles
from springback.contact.grids.occupancy import occupancy_file
from springback.contact.grids.thickness import thinnest_part
from springback.errors import ContactWarning
from springback.results.flight import Flight, fly

#: A seat on four legs, which are thinner.
CHAIR = beside(
    (box_triangles(0.45, 0.45, 0.04), (0.0, 0.0, 0.45)),
    *(
        (box_triangles(0.03, 0.03, 0.44), (x, y, 0.21))
        for x in (-0.2, 0.2) for y in (-0.2, 0.2)
    ),
)  # fmt: skip
BODIES = {
    "cube": (box_triangles(0.3, 0.3, 0.3), 0.3),
    "plate": (box_triangles(0.02, 0.5, 0.4), 0.02),
    "sheet": (box_triangles(0.002, 0.5, 0.4), 0.002),
    "bar": (box_triangles(0.01, 0.01, 1.0), 0.01),
    "ball": (ball_triangles(0.15), 0.3),
    "chair": (CHAIR, 0.03),
}


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize("turned", [False, True])
def test_the_thinnest_part_is_found_however_a_body_is_turned(name: str, turned: bool) -> None:
    """To 5 %: of plates, square bars, balls, and legs below a thicker seat."""
    mesh, expected = BODIES[name]
    if turned:
        turn = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
        mesh = Triangles(mesh.vertices @ turn.T, mesh.faces)
    assert thinnest_part(mesh, 0.5 * cell_of(mesh)) == pytest.approx(expected, rel=0.05)


def test_thin_parts_get_smaller_cells_and_no_more_nodes_than_that() -> None:
    assert fitting_cell(BODIES["cube"][0]) == cell_of(BODIES["cube"][0])
    assert fitting_cell(CHAIR) == pytest.approx(0.03 / 8.0, rel=0.02)
    sheet = BODIES["sheet"][0]
    assert fitting_cell(sheet) == pytest.approx(max(0.002 / 8.0, cell_of(sheet, NODES_IF_THIN)))


def edge_on(obstacle: dict[str, Any], speed: float = 2.0) -> Flight:
    """ARQ, nose ahead, at the middle of the narrow side of a board 40 mm thick."""
    return fly(
        {
            "vehicle": "arq", "thrust": "hover",
            "world": {"obstacles": [{"surface": "wall", **obstacle}]},
            "start": {
                "position": [1.2, 0.0, 1.0], "velocity": [speed, 0.0, 0.0], "touch_distance": 0.01,
            },
            "simulation": {"duration": 0.12},
        },
        trajectory=False,
    )  # fmt: skip


PLACE = {"position": [2.0, 0.0, 1.0]}
MEASURES = ("impact_peak_normal_force", "impact_penetration", "restitution_at_separation")


@pytest.fixture(scope="module")
def board(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    path = tmp_path_factory.mktemp("board") / "board.stl"
    path.write_bytes(stl_bytes(box_triangles(0.5, 0.8, 0.04)))
    return {"type": "mesh", "file": str(path), **PLACE}


def test_a_board_of_a_mesh_is_as_stiff_as_a_box(board: dict[str, Any]) -> None:
    """With its default cells, nine of them across it: peak, depth and rebound to 2 %."""
    theirs = edge_on({"type": "box", "size": [0.5, 0.8, 0.04], **PLACE}).measures
    ours = edge_on(board).measures
    for name in MEASURES:
        assert ours[name] == pytest.approx(theirs[name], rel=0.02), name
    assert abs(ours["ledger_residual"] or 0.0) < 1e-6


def test_what_comes_deeper_than_forces_hold_is_told(board: dict[str, Any]) -> None:
    """At 3 m/s, or with coarse cells, of which `springback check` warns, too."""
    with pytest.warns(ContactWarning, match=r"a mesh with cells of 4.38 mm, hold to some 13.4 mm"):
        edge_on(board, 3.5)
    with pytest.warns(ContactWarning, match=r"a mesh with cells of 6.5 mm, hold to some 10.2 mm"):
        edge_on({**board, "cell": 0.0065})


def test_so_it_is_of_one_in_a_union(board: dict[str, Any]) -> None:
    """A mesh among its shapes counts: it was left out."""
    union = {
        "type": "union",
        "surface": "wall",
        **PLACE,
        "shapes": [board | {"position": [0, 0, 0]}],
    }
    part = r"parts of world.obstacles\[0\].shapes\[0\], a mesh with cells of 4.38 mm, hold to some 13.4"
    with pytest.warns(ContactWarning, match=part):
        edge_on(union, 3.5)


COARSE = 0.0279


def test_with_fewer_than_three_cells_across_every_contact_is_told(board: dict[str, Any]) -> None:
    """Of a board of 1.4 cells the peak is a fifth too low, and nothing said so."""
    with pytest.warns(ContactWarning, match=r"wrong at any depth, as they are 40 mm thick: fewer"):
        coarse = edge_on({**board, "cell": COARSE})
    peak = edge_on({"type": "box", "size": [0.5, 0.8, 0.04], **PLACE}).impact_peak_normal_force
    assert coarse.impact_peak_normal_force is not None
    assert peak is not None
    assert coarse.impact_peak_normal_force < 0.85 * peak
    assert coarse.penetration is not None
    assert coarse.penetration < 0.018  # less than half its thickness


def test_one_that_is_not_touched_is_not_told_of(board: dict[str, Any]) -> None:
    """Beside another obstacle, which is."""
    box = {"type": "box", "size": [0.5, 0.8, 0.04], **PLACE, "surface": "wall"}
    beside = {**board, "position": [2.0, 0.0, 1.4], "cell": COARSE, "surface": "wall"}
    with warnings.catch_warnings():
        warnings.simplefilter("error", ContactWarning)
        flight = fly(
            {
                "vehicle": "arq", "thrust": "hover", "world": {"obstacles": [box, beside]},
                "start": {"position": [1.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
                "simulation": {"duration": 0.4},
            }
        )  # fmt: skip
    [met] = flight.obstacle_contacts
    assert met.obstacle.startswith("world.obstacles[0], ")


def test_a_wall_of_one_cell_of_a_map_is_a_wall(tmp_path: Path) -> None:
    """A spline through distances leaves all of it: peak and rebound to 15 % of a box's."""
    cells = np.zeros((3, 30, 30), dtype=bool)
    cells[1] = True
    file = occupancy_file(cells, 0.05, path=tmp_path / "wall.npz")
    theirs = edge_on({"type": "box", "size": [0.05, 1.5, 1.5], "position": [1.825, 0.0, 1.0]})
    ours = edge_on({"type": "occupancy", "file": file, "position": [1.75, -0.75, 0.25]})
    for name in MEASURES:
        assert ours.measures[name] == pytest.approx(theirs.measures[name], rel=0.15), name
