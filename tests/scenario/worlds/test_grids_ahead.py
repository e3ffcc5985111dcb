"""Before grids of meshes are made it is said which, and how large they are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from springback.contact.grids.distance_grids import node_counts
from springback.scenario.files import read_scenario
from springback.scenario.worlds.mesh_check import tell_of_grids, telling

#: A tetrahedron with edges of 10 cm.
MESH = """v 0 0 0
v 0.1 0 0
v 0 0.1 0
v 0 0 0.1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""
SCENARIO = """vehicle = "arq"
[[world.obstacles]]
name = "the rock"
type = "mesh"
file = "rock.obj"
position = [3, 0, 1]
cell = "5 mm"
surface = "wall"
"""


def said_of(*obstacles: Any) -> list[str]:
    found: list[str] = []
    with telling(found.append):
        tell_of_grids({"world": {"obstacles": list(obstacles)}})
    return found


def test_a_scenario_with_a_mesh_tells_its_name_file_and_nodes(tmp_path: Path) -> None:
    (tmp_path / "rock.obj").write_text(MESH)
    (tmp_path / "s.toml").write_text(SCENARIO)
    found: list[str] = []
    with telling(found.append):
        scenario = read_scenario(tmp_path / "s.toml")
    rock: Any = scenario.world.obstacles[0]
    nodes = rock.form().nodes
    assert node_counts(0.1, 0.005) ** 3 == nodes
    [said] = found
    assert f"world.obstacles[0], the rock (rock.obj): {1e-6 * nodes:.2g} million nodes" in said
    assert "a larger cell makes a grid coarser" in said


def test_without_a_cell_the_usual_numbers_are_told_and_a_union_is_looked_into() -> None:
    mesh = {"type": "mesh", "file": "shelf.stl"}
    [said] = said_of({"type": "union", "shapes": [mesh, {"type": "box"}]}, *[mesh] * 3)
    assert "world.obstacles[0] (shelf.stl): 0.4 million nodes, up to 3 million if parts" in said
    assert "world.obstacles[2]" in said
    assert "and 1 more" in said
    assert "0.4 million nodes" in said_of({**mesh, "cell": "5 mm"})[0]  # there is no such file


def test_nothing_is_told_without_meshes_or_to_nobody() -> None:
    assert said_of({"type": "wall"}, "mesh", 3) == []
    tell_of_grids({"world": {"obstacles": [{"type": "mesh", "file": "a.stl"}]}})
