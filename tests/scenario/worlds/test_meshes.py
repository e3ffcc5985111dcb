"""Meshes and height maps that a world names become obstacles that name their file, or are listed."""

from __future__ import annotations

import itertools
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from builders.world_files import imported, sdf, sdf_model
from springback import InputError, read_world
from springback.contact.grids.measured_shapes import MeshBody
from springback.interfaces.cli.app import cli
from springback.scenario.scenario import scenario_from
from springback.scenario.worlds.content import WorldContent
from springback.scenario.worlds.files import world_content
from springback.scenario.worlds.imported import KINDS, listing_only

CORNERS = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
FACES = [
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
]  # fmt: skip


def cube(faces: list[tuple[int, int, int]] = FACES) -> bytes:
    """A cube of 1 m as a binary STL, or what is left of it."""
    facets = (struct.pack("<12fH", 0, 0, 0, *CORNERS[list(face)].ravel(), 0) for face in faces)
    return bytes(80) + struct.pack("<I", len(faces)) + b"".join(facets)


def mesh(file: str, scale: str = "1 1 1") -> str:
    return f"<mesh><uri>{file}</uri><scale>{scale}</scale></mesh>"


def content(folder: Path, text: str, name: str = "w.sdf") -> WorldContent:
    """Content of a world, whatever obstacles this version has."""
    (folder / "cube.stl").write_bytes(cube())
    (folder / "hill.png").write_bytes(b"x")
    (folder / "hill.tif").write_bytes(b"x")
    (folder / "statue.dae").write_bytes(b"x")
    (folder / name).write_text(text)
    return world_content(folder / name, (), (*KINDS, "mesh", "heightmap", "occupancy"))


def test_a_mesh_has_the_pose_and_scale_of_its_collision(tmp_path: Path) -> None:
    text = sdf(sdf_model("a", mesh("cube.stl", "2 2 2"), "1 2 3 0.1 0.2 0.3"))
    found = content(tmp_path, text)
    [one] = found.elements
    table: dict[str, Any] = one.table
    assert table.pop("file") == str(tmp_path / "cube.stl")
    assert table.pop("position") == [1.0, 2.0, 3.0]
    assert [table.pop(key) for key in ("roll", "pitch", "yaw")] == pytest.approx([0.1, 0.2, 0.3])
    assert table == {"type": "mesh", "scale": 2.0}
    assert tmp_path / "cube.stl" in found.files


def test_a_height_map_is_level_from_black_to_white(tmp_path: Path) -> None:
    hill = "<heightmap><uri>hill.png</uri><size>10 20 2</size><pos>1 0 0.5</pos></heightmap>"
    found = content(tmp_path, sdf(
        sdf_model("a", hill, "0 3 0 0 0 0.5"), sdf_model("b", hill, "0 3 0 0.1 0 0"),
        sdf_model("c", hill.replace("png", "tif")),
    ))  # fmt: skip
    [one] = found.elements
    assert one.table["position"] == pytest.approx([np.cos(0.5), 3.0 + np.sin(0.5), 0.5])
    assert one.table["yaw"] == pytest.approx(0.5)
    assert (one.table["size"], one.table["range"]) == ([10.0, 20.0], [0.0, 2.0])
    assert [(name.partition("/")[0], why) for name, why in found.missing] == [
        ("b", "is a height map that is not level"),
        ("c", "hill.tif: only height maps in .png, .npy are read"),
    ]


def test_mjcf_names_its_meshes_in_folders_of_their_own(tmp_path: Path) -> None:
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "cube.stl").write_bytes(cube())
    (tmp_path / "assets" / "hill.png").write_bytes(b"x")
    text = (
        '<mujoco><compiler meshdir="assets" assetdir="assets"/><default><mesh scale="0.5 0.5 0.5"/></default>'
        '<asset><mesh file="cube.stl"/><hfield name="h" file="hill.png" size="5 6 2 0.3"/></asset><worldbody>'
        '<geom name="a" type="mesh" mesh="cube" pos="0 0 1"/><geom name="h" type="hfield" hfield="h"/>'
        "</worldbody></mujoco>"
    )
    found = content(tmp_path, text, "m.xml")
    a, h = (one.table for one in found.elements)
    assert (a["file"], a["scale"]) == (str(tmp_path / "assets" / "cube.stl"), 0.5)
    assert (h["size"], h["range"], h["depth"]) == ([10.0, 12.0], [0.0, 2.0], 0.3)
    assert [name for name, _ in found.remarks] == ["a", "h"]


def test_meshes_that_are_not_represented_are_listed(tmp_path: Path) -> None:
    found = content(tmp_path, sdf(
        sdf_model("flat", mesh("cube.stl", "1 2 1")), sdf_model("mirror", mesh("cube.stl", "-1 -1 -1")),
        sdf_model("dae", mesh("statue.dae")), sdf_model("lost", mesh("model://x/lost.stl")),
    ))  # fmt: skip
    assert found.elements == ()
    reasons = {name.partition("/")[0]: reason for name, reason in nonempty(found.missing)}
    assert reasons["flat"] == "is scaled by 1 x 2 x 1; a mesh has one scale, above 0"
    assert reasons["mirror"] == "is scaled by -1 x -1 x -1; a mesh has one scale, above 0"
    assert reasons["dae"] == "statue.dae: Collada is not read; convert it to OBJ or STL"
    assert reasons["lost"].startswith("there is no model://x/lost.stl in ")


def test_what_an_obstacle_refuses_is_listed_with_its_reason(tmp_path: Path) -> None:
    """A closed mesh is there if this version has meshes; an open one never is, and says why."""
    (tmp_path / "cube.stl").write_bytes(cube())
    (tmp_path / "open.stl").write_bytes(cube(FACES[:-2]))
    text = sdf(sdf_model("closed", mesh("cube.stl")), sdf_model("open", mesh("open.stl")))
    world = imported(tmp_path, "w.sdf", text)
    reasons = dict(line.split(": ", 1) for line in world.unrepresented)
    if "mesh" in KINDS:
        assert [part.name for part in world.parts] == ["closed/link/collision"]
        assert "is open" in reasons["open/link/collision"]
    else:
        missing = "mesh is no obstacle of this version of springback"
        assert set(reasons.values()) == {missing}
        assert len(reasons) == 2


def test_a_mesh_alone_is_a_world(tmp_path: Path) -> None:
    (tmp_path / "cube.stl").write_bytes(cube())
    found = world_content(tmp_path / "cube.stl", (), ("mesh",))
    [one] = found.elements
    assert (one.name, one.table["type"]) == ("cube", "mesh")
    with pytest.raises(InputError, match="there is no such file"):
        read_world(tmp_path / "none.stl")


def test_a_height_map_alone_has_no_size(tmp_path: Path) -> None:
    (tmp_path / "hill.png").write_bytes(b"x")
    with pytest.raises(InputError, match='use an obstacle of type = "heightmap" with its size'):
        read_world(tmp_path / "hill.png")


def test_a_mesh_that_is_all_of_a_file_is_read_or_refused(tmp_path: Path) -> None:
    """In one line: it was listed as not represented, and `world show` succeeded."""
    (tmp_path / "good.stl").write_bytes(cube())
    assert len(read_world(tmp_path / "good.stl").parts) == 1
    (tmp_path / "picture.stl").write_bytes(b"\x89PNG" * 40)
    (tmp_path / "hole.stl").write_bytes(cube(FACES[1:]))
    (tmp_path / "cells.npz").write_bytes(b"x")
    named = {"picture.stl": "is not STL", "hole.stl": "is open: 3 of ", "cells.npz": "is"}
    for name, why in nonempty(named.items()):
        with pytest.raises(InputError) as refused:
            read_world(tmp_path / name)
        [line] = refused.value.problems
        assert line.startswith(f"{tmp_path / name}: {why}")
        entry = {"type": "import", "file": str(tmp_path / name), "surface": "wall"}
        with pytest.raises(InputError, match=r"^world\.obstacles\[0\]\.file: /"):
            scenario_from({"vehicle": "arq", "world": {"obstacles": [entry]}})
        shown = CliRunner().invoke(cli, ["world", "show", str(tmp_path / name)])
        assert isinstance(shown.exception, InputError)  # one line and exit code 2


# -- listed ---------------------------------------------------------------------------------------


@pytest.fixture
def no_grids(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where a distance grid is computed or looked up."""

    def fail(*_: Any) -> Any:
        raise AssertionError("a distance grid is made")

    monkeypatch.setattr("springback.contact.grids.measured_shapes.stored_grid", fail)


def show(*words: str) -> Any:
    """Outcome of ``springback world show``."""
    return CliRunner().invoke(cli, ["world", "show", *words], catch_exceptions=False)


@pytest.mark.usefixtures("no_grids")
def test_a_mesh_is_shown_with_its_size_and_without_its_grid(tmp_path: Path) -> None:
    """Was: two minutes without a word for a room of 7 faces."""
    path = tmp_path / "crate.stl"
    path.write_bytes(cube())
    done = show(str(path))
    assert "crate  mesh" in done.stdout
    assert "1 x 1 x 1 m" in done.stdout
    assert "warning" not in done.stderr
    [one] = json.loads(show(str(path), "--json").stdout)["elements"]
    assert (one["name"], one["extent"]) == ("crate", [1.0, 1.0, 1.0])
    text = sdf(sdf_model("a", mesh("crate.stl", "60 60 60")))
    (tmp_path / "w.sdf").write_text(text)
    assert (
        "is a mesh 60 m wide; with scale = 0.06 it would be 0.06 m"
        in show(str(tmp_path / "w.sdf")).stderr
    )


@pytest.mark.usefixtures("no_grids")
def test_what_cannot_be_a_mesh_is_listed_without_a_grid_too(tmp_path: Path) -> None:
    (tmp_path / "open.stl").write_bytes(cube(FACES[:-1]))
    (tmp_path / "w.sdf").write_text(sdf(sdf_model("a", mesh("open.stl"))))
    assert "open.stl: is open" in show(str(tmp_path / "w.sdf")).stdout
    np.savez(tmp_path / "cells.npz", occupancy=np.ones((3, 3, 3)), cell=0.1)
    assert "1 element (1 occupancy)" in show(str(tmp_path / "cells.npz")).stderr


def test_a_world_that_was_listed_is_whole_when_it_is_flown(tmp_path: Path) -> None:
    """The listing leaves nothing behind that has no grid."""
    path = tmp_path / "crate.stl"
    path.write_bytes(cube())
    with listing_only():
        [listed] = read_world(path).parts
    [flown] = read_world(path).parts
    assert type(listed.obstacle) is not type(flown.obstacle) is MeshBody


def test_elements_have_their_names_in_json(tmp_path: Path) -> None:
    """Was: an empty name each, that of the obstacle."""
    box = "<box><size>1 1 1</size></box>"
    (tmp_path / "w.sdf").write_text(sdf(sdf_model("a", box), sdf_model("b", box)))
    found = json.loads(show(str(tmp_path / "w.sdf"), "--json").stdout)["elements"]
    names = [part.name for part in read_world(tmp_path / "w.sdf").parts]
    assert [one["name"] for one in found] == names
    assert all(nonempty(names))
