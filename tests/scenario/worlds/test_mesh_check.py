"""Meshes of a size that is seldom meant are told of: as of millimetres, or thinner than two cells."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.forms import box_file
from builders.world_files import sdf, sdf_model
from springback.contact.grids import distance_grids
from springback.contact.grids.distance_grids import MOST_NODES, least_cell, node_counts
from springback.errors import InputError
from springback.scenario.files import read_scenario
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.warnings import scenario_warnings


def _scenario(tmp_path: Path, **obstacle: Any) -> Scenario:
    lines = [f"{key} = {value!r}" for key, value in obstacle.items()]
    path = tmp_path / "s.toml"
    path.write_text(
        "\n".join(['vehicle = "arq"', "[[world.obstacles]]", 'surface = "wall"', *lines])
        + "\n[start]\nposition = [0, 0, 1]\n"
    )
    return read_scenario(path)


def _plate(tmp_path: Path, **more: Any) -> Scenario:
    file = box_file(0.02, 0.5, 0.4)
    return _scenario(tmp_path, type="mesh", file=file, position=[3.0, 0.0, 1.0], **more)


def test_a_mesh_of_which_coarse_cells_leave_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError) as refused:
        _plate(tmp_path, cell=0.05)
    [line] = refused.value.problems
    assert line.endswith(
        "s.toml:7: world.obstacles[0].cell: leaves nothing of the mesh of 0.02 x 0.5 x 0.4 m: parts "
        "thinner than two cells are lost; must be at most 0.01 m (got 0.05 m)"
    )
    part = {"type": "mesh", "file": box_file(0.02, 0.5, 0.4), "cell": 0.05}
    union = {"type": "union", "surface": "wall", "position": [3.0, 0.0, 1.0], "shapes": [part]}
    with pytest.raises(InputError, match=r"^world\.obstacles\[0\]\.shapes\[0\]\.cell: leaves"):
        scenario_from({"vehicle": "arq", "world": {"obstacles": [union]}})


def test_a_mesh_whose_parts_are_thin_for_its_cells_is_warned_of(tmp_path: Path) -> None:
    """Whatever its size is: of a frame, its bars count.  Of itself a mesh gets cells that do."""
    begin = "world.obstacles[0]: cells of {} m are coarse for a mesh whose thinnest parts are 0.02 m thick"
    [warning] = scenario_warnings(_plate(tmp_path, cell=0.013))
    assert warning == (
        f"{begin.format(0.013)}: forces on them are up to 40 % too weak or too strong, and parts "
        "thinner than two cells are lost; give a cell of at most 0.0025 m"
    )
    [warning] = scenario_warnings(_plate(tmp_path, cell=0.009))
    wrong = "forces on them are up to 40 % too weak or too strong; give"
    assert warning.startswith(f"{begin.format(0.009)}: {wrong}")
    assert scenario_warnings(_plate(tmp_path, cell=0.0033)) == []
    assert scenario_warnings(_plate(tmp_path)) == []


def test_advice_on_cells_can_be_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Cells of 5 mm were asked for where 15.7 mm are the smallest; a refusal named refused ones."""
    monkeypatch.setattr(distance_grids, "MOST_NODES", 50_000)
    begin = "forces on them are up to"
    board = {"type": "mesh", "position": [3.0, 0.0, 1.0], "cell": 0.03}
    small = {**board, "file": box_file(0.1, 0.4, 0.4)}
    [warning] = scenario_warnings(_scenario(tmp_path, **small))
    assert warning.endswith(f"{begin} 30 % too weak or too strong; give a cell of at most 0.0125 m")
    middle = {**board, "file": box_file(0.1, 0.7, 0.6)}
    [warning] = scenario_warnings(_scenario(tmp_path, **middle))
    [least] = re.findall(r"; give a cell of ([\d.]+) m, the smallest for a mesh so large", warning)
    assert scenario_warnings(_scenario(tmp_path, **{**middle, "cell": float(least)})) == []
    wide = {**board, "file": box_file(0.1, 1.2, 0.9)}
    [warning] = scenario_warnings(_scenario(tmp_path, **wide))
    [least] = re.findall(
        r"its box of 0.1 x 1.2 x 0.9 m allows no cell below ([\d.]+) m: m", warning
    )
    assert scenario_warnings(_scenario(tmp_path, **{**wide, "cell": float(least)}))
    for cell in nonempty((0.001, 0.99 * float(least))):
        with pytest.raises(InputError, match=rf"cells of {least} m or more \(got {cell:.3g} m\)"):
            _scenario(tmp_path, **{**wide, "cell": cell})


def test_the_least_cell_is_accepted_and_a_percent_less_is_not() -> None:
    for extent in nonempty(np.random.default_rng(1).uniform(0.01, 20.0, (200, 3))):
        least = least_cell(extent)
        assert float(f"{least:.3g}") == least
        assert node_counts(extent, least).prod() <= MOST_NODES
        assert node_counts(extent, 0.985 * least).prod() > MOST_NODES


def test_a_mesh_of_millimetres_is_warned_of_with_its_scale(tmp_path: Path) -> None:
    file = box_file(250.0, 200.0, 100.0)
    large = {"type": "mesh", "file": file, "position": [150.0, 0.0, 1.0]}
    wide = "250 m wide; with scale = 0.001 it would be 0.25 m"
    assert scenario_warnings(_scenario(tmp_path, **large)) == [
        f"world.obstacles[0]: is a mesh {wide}"
    ]
    assert scenario_warnings(_scenario(tmp_path, **large, scale=0.001)) == []
    with pytest.raises(InputError, match=rf"inside world\.obstacles\[0\], a mesh {wide} \(got"):
        _scenario(tmp_path, **{**large, "position": [0.0, 0.0, 0.0]})


def test_so_is_one_that_a_world_names(tmp_path: Path) -> None:
    shutil.copy(box_file(250.0, 200.0, 100.0), tmp_path / "hall.stl")
    mesh = "<mesh><uri>hall.stl</uri></mesh>"
    (tmp_path / "w.sdf").write_text(sdf(sdf_model("a", mesh, "150 0 0 0 0 0")))
    [warning] = scenario_warnings(_scenario(tmp_path, type="import", file="w.sdf"))
    assert warning.startswith("world.obstacles[0], a/link/collision: is a mesh 250 m wide; with ")
