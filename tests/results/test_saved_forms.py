"""Flights into forms of files, saved: they are read back without the files, and campaigns notice changes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.forms import ball_triangles, box_triangles, stl_bytes
from springback.campaign.design.plan import Plan, Source, with_scenario
from springback.contact.grids import data_files
from springback.errors import InputError
from springback.interfaces.replay.scene import scene_of
from springback.results.flight import fly
from springback.scenario.files import read_scenario

TEXT = """
vehicle = "arq"
[[world.obstacles]]
type = "union"
position = [3, 0, 1]
surface = "wall"
shapes = [{ type = "mesh", file = "crate.stl", scale = 1.0 }, { type = "net", tension = 50, position = [2, 0, 0] }]
[start]
position = [2, 0, 1]
velocity = [2, 0, 0]
[simulation]
duration = 0.02
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A scenario and its mesh."""
    monkeypatch.setattr(data_files, "_ELSEWHERE", {})
    (tmp_path / "crate.stl").write_bytes(stl_bytes(box_triangles(0.6, 0.5, 0.4)))
    (tmp_path / "scenario.toml").write_text(TEXT, encoding="utf-8")
    return tmp_path


def test_paths_are_relative_to_the_scenario_and_overrides_to_where_they_are_typed(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Within a union, too; the content is noted."""
    shapes: Any = read_scenario(folder / "scenario.toml").world.obstacles[0]
    assert shapes.shapes[0].file == str(folder / "crate.stl")
    assert len(shapes.shapes[0].content) == 64
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "ball.stl").write_bytes(stl_bytes(ball_triangles(0.2)))
    monkeypatch.chdir(tmp_path / "other")
    changed: Any = read_scenario(
        folder / "scenario.toml", ["world.obstacles.0.shapes.0.file=ball.stl"]
    )
    assert changed.world.obstacles[0].shapes[0].file == str(tmp_path / "other" / "ball.stl")
    with pytest.raises(InputError, match=r"shapes\[0\].cell: must be more than 0 m"):
        read_scenario(folder / "scenario.toml", ["world.obstacles.0.shapes.0.cell=0"])


def test_a_saved_flight_needs_no_other_file(folder: Path) -> None:
    """Its forms are beside it: scenario, gaps and drawing are the same once the file is gone."""
    flight = fly(folder / "scenario.toml", executor="python")
    flight.save(folder / "out", figures=False)
    (folder / "crate.stl").unlink()
    again = springback.load(folder / "out")
    assert again.scenario == flight.scenario
    assert np.array_equal(again.gap(), flight.gap())
    drawn = scene_of(again).obstacles
    assert [one.name for one in drawn] == ["union"]
    assert drawn[0].vertices is not None
    assert float(np.ptp(drawn[0].vertices[:, 1])) == pytest.approx(2.0, abs=0.05)
    data = (folder / "out" / "forms.zip").read_bytes()
    (folder / "out" / "forms.zip").write_bytes(data[:-3] + b"xyz")
    with pytest.raises(InputError, match=r"forms.zip: is damaged, or belongs to another flight"):
        springback.load(folder / "out")


def test_so_does_one_into_an_imported_world(folder: Path) -> None:
    """Meshes that a world names are beside it, too."""
    (folder / "lab.urdf").write_text(
        '<robot name="lab"><link name="lab"><collision><geometry>'
        '<mesh filename="crate.stl"/></geometry></collision></link></robot>',
        encoding="utf-8",
    )
    imports = '[[world.obstacles]]\ntype = "import"\nfile = "lab.urdf"\n'
    start = TEXT[TEXT.index("[start]") :]
    text = f'vehicle = "arq"\n{imports}position = [3, 0, 1]\nsurface = "wall"\n{start}'
    (folder / "scenario.toml").write_text(text, encoding="utf-8")
    flight = fly(folder / "scenario.toml", executor="python")
    flight.save(folder / "out", figures=False)
    (folder / "crate.stl").unlink()
    (folder / "lab.urdf").unlink()
    again = springback.load(folder / "out")
    assert again.scenario == flight.scenario
    assert np.array_equal(again.gap(), flight.gap())


def test_a_plan_notes_the_content(folder: Path) -> None:
    """A file that changes later is refused, where it was written."""
    plan = Plan(
        scenario="scenario.toml",
        method="grid",
        vary=[{"field": "start.velocity.0", "values": [1.0, 2.0]}],
    )
    tables: Any = with_scenario(plan, folder, Source()).scenario
    shape = tables["world"]["obstacles"][0]["shapes"][0]
    assert len(shape["content"]) == 64
    (folder / "crate.stl").write_bytes(stl_bytes(box_triangles(0.6, 0.5, 0.5)))
    with pytest.raises(InputError, match=r"obstacles\[0\].shapes\[0\].file: .*was changed"):
        fly(tables, executor="python")
