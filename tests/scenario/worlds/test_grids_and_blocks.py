"""OctoMap and RotorPy: boxes that fill what is occupied, and nothing else."""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from builders.world_files import imported, named_parts, octomap_binary, octomap_full
from springback import InputError, read_world
from springback.interfaces.cli.app import cli
from springback.scenario.worlds.imported import Imported

WRITE = {
    "w.bt": octomap_binary,
    "w.ot": octomap_full,
    "colour.ot": lambda cells, size: octomap_full(cells, size, b"abc"),
}


def cells_of(world: Imported, size: float) -> list[tuple[int, int, int]]:
    """Cells in the boxes of a world, those of several boxes several times."""
    found: list[tuple[int, int, int]] = []
    for part in world.parts:
        box = part.obstacle
        assert (box.roll, box.pitch, box.yaw) == (0.0, 0.0, 0.0)  # type: ignore[union-attr]
        middle, whole = np.array(box.position), np.array(box.size)  # type: ignore[union-attr]
        low, high = np.rint((middle - 0.5 * whole) / size), np.rint((middle + 0.5 * whole) / size)
        assert (high - low) * size == pytest.approx(whole)
        found += itertools.product(*(range(int(a), int(b)) for a, b in zip(low, high, strict=True)))
    return found


@pytest.mark.parametrize("name", WRITE)
@pytest.mark.parametrize("seed", range(3))
def test_boxes_are_the_occupied_cells(tmp_path: Path, name: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    cells = {tuple(int(x) for x in cell) for cell in rng.integers(-6, 7, (300, 3))}
    world = imported(tmp_path, name, WRITE[name](cells, 0.25))
    found = cells_of(world, 0.25)
    assert len(found) == len(set(found))
    assert set(found) == cells


def test_leaves_above_the_finest_level_are_whole_cubes(tmp_path: Path) -> None:
    """Child 0 of the root's child 7 is occupied, 4096 m of 8192 m, and nothing else."""
    word = (3 << 14).to_bytes(2, "little") + (2).to_bytes(2, "little")
    head = b"# Octomap OcTree binary file\nid OcTree\nsize 3\nres 0.25\ndata\n"
    with pytest.raises(InputError, match="16384 x 16384 x 16384 cells"):
        imported(tmp_path, "w.bt", head + word)


def test_a_solid_block_is_one_box(tmp_path: Path) -> None:
    cells = set(itertools.product(range(-2, 5), range(3), range(1, 3)))
    [part] = imported(tmp_path, "w.bt", octomap_binary(cells, 0.1)).parts
    assert part.obstacle.position == pytest.approx((0.15, 0.15, 0.2))
    assert part.obstacle.size == pytest.approx((0.7, 0.3, 0.2))


def test_too_many_boxes_become_an_occupancy_grid(tmp_path: Path) -> None:
    board = {c for c in itertools.product(range(28), range(28), range(28)) if sum(c) % 2 == 0}
    path = tmp_path / "w.bt"
    path.write_bytes(octomap_binary(board, 0.5))
    with pytest.raises(
        InputError, match=r"needs more than 10000 boxes; .* world convert .*w\.bt --out"
    ):
        read_world(path)
    out = tmp_path / "w.npz"
    done = CliRunner().invoke(cli, ["world", "convert", str(path), "--out", str(out)])
    assert done.exit_code == 0, done.output
    with np.load(out) as held:
        assert held["cell"] == 0.5
        assert held["origin"].tolist() == [0.0, 0.0, 0.0]
        assert {tuple(c) for c in np.argwhere(held["occupancy"]).tolist()} == board


@pytest.mark.parametrize("name", ["w.bt", "w.ot"])
def test_damaged_trees_are_refused(tmp_path: Path, name: str) -> None:
    whole = WRITE[name]({(0, 0, 0), (3, 1, 2)}, 0.25)
    for data, said in (
        (whole[:-3], "ends within the tree"),
        (whole + b"x", "has 1 byte after the tree"),
        (whole.replace(b"res 0.25", b"res nan"), "res: must be 1e-06 to 1000 m"),
        (whole.replace(b"res 0.25", b"ress"), r"res: must be .* \(got ''\)"),
        (whole.replace(b"id OcTree", b"id Tree"), "id: must be OcTree or ColorOcTree"),
        (b"OcTree\n", "is no OctoMap file"),
        (b"", "is no OctoMap file"),
    ):
        with pytest.raises(InputError, match=said.replace("1e-06", "1e-6")):
            imported(tmp_path, name, data)


# -- RotorPy --------------------------------------------------------------------------------------

WORLD = {
    "bounds": {"extents": [-5, 5, -4, 4, -1, 3]},
    "blocks": [{"extents": [1, 2, -0.5, 0.5, 0, 2], "color": [1, 0, 0]}, {"extents": [3, 3.2, 0, 1, 0, 3]}],
    "start": [0, 0, 0],
}  # fmt: skip


def test_blocks_are_boxes_between_their_extents(tmp_path: Path) -> None:
    parts = named_parts(imported(tmp_path, "w.json", json.dumps(WORLD)))
    assert set(parts) == {"block 0", "block 1"}
    assert parts["block 0"].position == (1.5, 0.0, 1.0)
    assert parts["block 0"].size == (1.0, 1.0, 2.0)
    assert parts["block 1"].size == pytest.approx((0.2, 1.0, 3.0))


def test_bounds_are_walls_if_they_are_wanted(tmp_path: Path) -> None:
    parts = named_parts(imported(tmp_path, "w.json", json.dumps(WORLD), bounds=True))
    assert parts["bounds least z"].height == -1.0
    walls = {name: (one.position, one.normal) for name, one in parts.items() if one.type == "wall"}
    assert walls == {
        "bounds least x": ((-5.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
        "bounds most x": ((5.0, 0.0, 0.0), (-1.0, 0.0, 0.0)),
        "bounds least y": ((0.0, -4.0, 0.0), (0.0, 1.0, 0.0)),
        "bounds most y": ((0.0, 4.0, 0.0), (0.0, -1.0, 0.0)),
        "bounds most z": ((0.0, 0.0, 3.0), (0.0, 0.0, -1.0)),
    }
    with pytest.raises(InputError, match="bounds: only worlds of RotorPy"):
        imported(tmp_path, "w.sdf", "<sdf/>", bounds=True)


WRONG = [
    (
        {"blocks": [{"extents": [1, 1, 0, 1, 0, 1]}]},
        r"w\.json: blocks\[0\]: extents: must be least",
    ),
    ({"blocks": [{"extents": [0, 1]}]}, r"blocks\[0\]: extents: must be six numbers"),
    ({"blocks": [3]}, r"must be six numbers \(got None\)"),
    ({"blocks": [{"extents": [0, 1, 0, 1, 0, True]}]}, r"must be finite numbers \(got True\)"),
    ({"blocks": {}}, "is no world of RotorPy"),
    ({"a": 1}, "is no world of RotorPy"),
    ([], "must be an object"),
]


@pytest.mark.parametrize(("given", "said"), WRONG)
def test_wrong_blocks_are_refused(tmp_path: Path, given: object, said: str) -> None:
    with pytest.raises(InputError, match=said):
        imported(tmp_path, "w.json", json.dumps(given))


def test_what_is_no_number_or_unknown(tmp_path: Path) -> None:
    text = '{"blocks": [{"extents": [0, 1, 0, 1, 0, NaN]}]}'
    with pytest.raises(InputError, match="must be finite numbers"):
        imported(tmp_path, "w.json", text)
    [line] = imported(tmp_path, "w.json", '{"blocks": [], "spheres": []}').unrepresented
    assert line.startswith("spheres: is no part of a world of RotorPy")
