"""Tables of numbers that share others: one copy in memory, alive as long as any that names it."""

from __future__ import annotations

import gc
import pickle

import numpy as np

from builders.cases import nonempty
from builders.forms import box_file
from springback.contact.grids.measured_shapes import MeshBody
from springback.contact.library import WALL
from springback.contact.scene.faces import SolidScene
from springback.contact.shapes import Ball
from springback.contact.worlds import LATEST, obstacles
from springback.kernels import routines
from springback.kernels.routines import NumberTable, number_at, tables_held


def test_a_part_is_found_through_the_table_that_names_it() -> None:
    """Also when pickled and read again, where it lies elsewhere, and once nobody else holds it."""
    part = NumberTable(np.arange(5.0))
    whole = NumberTable(np.zeros(3), {1: part})
    assert number_at(number_at(whole, 1), 3) == 3.0
    assert NumberTable(np.zeros(3), {1: part}) == whole
    data = pickle.dumps(whole)
    del part, whole
    gc.collect()
    again = pickle.loads(data)
    assert number_at(number_at(again, 1), 4) == 4.0
    assert number_at(again, 0) == 0.0


def mesh(x: float) -> SolidScene:
    """A scene of one mesh."""
    shape = MeshBody(type="mesh", file=box_file(0.5, 0.4, 0.3), position=(x, 0, 0), surface=WALL)
    built = obstacles((shape,))
    assert isinstance(built, SolidScene)
    return built


def test_scenes_of_one_mesh_at_many_places_share_its_numbers() -> None:
    """The scenes' own tables are small."""
    scenes = [mesh(0.01 * k) for k in range(20)]
    tables = [scene.table for scene in scenes]
    parts = {float(part) for table in tables for part in table.parts.values()}  # type: ignore[attr-defined]
    assert len(parts) == 1
    assert len({float(table) for table in tables}) == 20
    for table in nonempty(tables):
        assert table.numbers.size < 200  # type: ignore[attr-defined]


def test_a_scene_made_before_a_batch_lives_until_its_end() -> None:
    """It is asked for within, and then forgotten by the memory of scenes."""

    def ball(k: int) -> SolidScene:
        built = obstacles((Ball(type="sphere", position=(k, 7, 7), radius=0.1, surface=WALL),))
        assert isinstance(built, SolidScene)
        return built

    ball(-1)
    with tables_held():
        address = float(ball(-1).table)
        for k in range(2 * LATEST):
            ball(k)
        gc.collect()
        assert address in routines._TABLES
    gc.collect()
    assert address not in routines._TABLES
