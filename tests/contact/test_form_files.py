"""Files of forms: what is read, what is refused in one line, and what is kept on disk."""

from __future__ import annotations

import functools
import multiprocessing
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.forms import ball_triangles, box_triangles, obj_text, stl_bytes
from springback.contact.grids import data_files
from springback.contact.grids.closed_meshes import closed_mesh, inside, signed_volume
from springback.contact.grids.data_files import content_digest, file_bytes, place_content
from springback.contact.grids.distance_grids import DistanceGrid, cell_of, grid_of_mesh
from springback.contact.grids.height_maps import height_file
from springback.contact.grids.images import grey_image
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.grids.mesh_distance import SurfacePoints, squares_to
from springback.contact.grids.mesh_files import Triangles, triangles_of
from springback.contact.grids.occupancy import occupancy_file
from springback.contact.grids.stored_forms import form_folder, stored_grid
from springback.contact.library import WALL
from springback.errors import CacheWarning, InputError

Array = np.ndarray[Any, np.dtype[Any]]
BOX = box_triangles(0.5, 0.4, 0.3)


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Grids are kept in a folder of the test."""
    monkeypatch.setenv("SPRINGBACK_CACHE_DIR", str(tmp_path / "cache"))


# -- meshes -----------------------------------------------------------------------------------------


def ascii_stl(mesh: Triangles) -> bytes:
    """An STL in text."""
    lines = ["solid box"]
    for corners in mesh.corners.tolist():
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x} {y} {z}" for x, y, z in corners] + ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid box"]).encode()


def test_all_formats_give_the_same_triangles() -> None:
    """Vertices in one place are one: a box has eight."""
    given = {"a.stl": stl_bytes(BOX), "b.stl": ascii_stl(BOX), "c.obj": obj_text(BOX).encode()}
    for file, data in nonempty(given.items()):
        found = triangles_of(file, data)
        assert len(found.vertices) == 8
        assert len(found.faces) == 12
        assert signed_volume(found) == pytest.approx(0.5 * 0.4 * 0.3, rel=1e-6)


def test_a_mesh_inside_out_is_turned() -> None:
    """All faces clockwise from outside: they are turned, and the volume is positive."""
    turned = closed_mesh("x", Triangles(BOX.vertices, BOX.faces[:, ::-1]))
    assert signed_volume(turned) == pytest.approx(0.06)


def nodes(count: int, half: float) -> tuple[Array, Array, Array]:
    """Coordinates of the nodes of a cube."""
    along = np.linspace(-half, half, count)
    return along, along, along


def test_nodes_inside_are_those_of_the_body() -> None:
    """Also where lines pass exactly through edges and corners, and in a second body within reach."""
    along, _, _ = axes = nodes(41, 0.5)  # 2.5 cm: nodes on the box's edges
    q = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    box = box_triangles(0.51, 0.41, 0.31)
    assert np.array_equal(inside(box, axes), (np.abs(q) < [0.255, 0.205, 0.155]).all(axis=-1))
    through = inside(box_triangles(0.5, 0.4, 0.35), axes)
    outer = (np.abs(q) <= np.array([0.25, 0.2, 0.175]) + 1e-9).all(axis=-1)
    inner = (np.abs(q) < np.array([0.25, 0.2, 0.175]) - 1e-9).all(axis=-1)
    assert (through <= outer).all()
    assert (inner <= through).all()
    two = Triangles(
        np.concatenate([box.vertices, box.vertices + np.array([0.1, 0.0, 0.0])]),
        np.concatenate([box.faces, box.faces + 8]),
    )
    both = inside(two, axes)
    assert (inside(box, axes) <= both).all()
    assert both.sum() > inside(box, axes).sum()
    assert len(along) == 41


def test_distances_are_those_to_the_nearest_of_all_triangles() -> None:
    """All of them, one by one; near the surface exactly, outside more by less than 1 %, inside by 3 %."""
    mesh, chance = ball_triangles(0.3, 24), np.random.default_rng(1)
    cell = cell_of(mesh, 20_000)
    grid = grid_of_mesh(closed_mesh("x", mesh), cell)
    flat = chance.integers(0, grid.values.size, size=400)
    index = np.stack(np.unravel_index(flat, grid.values.shape), axis=1)
    points = grid.low + grid.cell * index
    corners = mesh.corners
    for point, value in nonempty(zip(points, grid.values.ravel()[flat], strict=True)):
        true = np.sqrt(squares_to(np.broadcast_to(point, (len(corners), 3)), corners).min())
        assert abs(value) >= true - 1e-12
        assert abs(value) <= true * (1.01 if value > 0.0 else 1.03) + 1e-12
        if true < 2.0 * cell:
            assert abs(value) == pytest.approx(true, abs=1e-12)
        if abs(np.linalg.norm(point) - 0.295) > 0.006:  # its faces are within 5 mm of the sphere
            assert (value < 0.0) == (np.linalg.norm(point) < 0.295)


def test_distances_to_one_triangle() -> None:
    """Face, edges and corners, against a search over its points."""
    chance = np.random.default_rng(2)
    shares = SurfacePoints(Triangles(BOX.vertices, BOX.faces[:1]), 0.004).tree.data
    corners = BOX.corners[:1]
    for point in nonempty(chance.uniform(-0.6, 0.6, size=(100, 3))):
        dense = np.linalg.norm(shares - point, axis=1).min()
        found = float(np.sqrt(squares_to(point[None], corners)[0]))
        assert dense - 0.004 <= found <= dense + 1e-12


def mesh_file(tmp_path: Path, data: bytes, name: str = "m.stl") -> MeshBody:
    """A mesh of a file."""
    path = tmp_path / name
    path.write_bytes(data)
    return MeshBody(type="mesh", file=str(path), surface=WALL)


def without_a_face(mesh: Triangles) -> Triangles:
    return Triangles(mesh.vertices, mesh.faces[:-1])


def with_one_turned(mesh: Triangles) -> Triangles:
    faces = mesh.faces.copy()
    faces[3] = faces[3, ::-1]
    return Triangles(mesh.vertices, faces)


def moved(mesh: Triangles, value: float) -> Triangles:
    vertices = mesh.vertices.copy()
    vertices[2, 1] = value
    return Triangles(vertices, mesh.faces)


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("m.stl", stl_bytes(without_a_face(BOX)), r"is open: 3 of 18 edges have a face on one side"),
        ("m.stl", stl_bytes(with_one_turned(BOX)), r"inverted faces: at 3 of 18 edges two faces"),
        ("m.stl", stl_bytes(moved(BOX, np.nan)), r"vertex \d+ is not finite"),
        ("m.stl", stl_bytes(Triangles(BOX.vertices * [1, 1, 0], BOX.faces)), "a size along each axis"),
        ("m.stl", stl_bytes(BOX)[:-7], r"is damaged: a binary STL of 12 triangles has 684 bytes"),
        ("m.stl", b"nothing", "is not STL"),
        ("m.glb", b"this is no GLB file", "is not GLB"),
        ("m.ply", b"nothing", "is not PLY"),
        ("m.stl", ascii_stl(BOX)[:-30], "is damaged"),
        ("m.stl", stl_bytes(Triangles(BOX.vertices, BOX.faces[:0])), "has no triangles"),
        ("m.obj", b"v 0 0\n", "m.obj:1: is not OBJ"),
        ("m.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "m.obj:4: is not OBJ"),
        ("m.obj", b"", "has no triangles"),
        ("m.dae", b"", r"must end in .stl, .obj, .ply"),
    ],
)  # fmt: skip
def test_meshes_that_bound_nothing_are_refused(
    tmp_path: Path, name: str, data: bytes, words: str
) -> None:
    """In one line with the file and what is wrong."""
    with pytest.raises(InputError, match=words) as raised:
        mesh_file(tmp_path, data, name)
    assert len(raised.value.problems) == 1
    assert raised.value.problems[0].startswith("file: ")


def test_a_file_too_large_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Half a gigabyte on paper, none on disk."""
    path = tmp_path / "large.stl"
    with path.open("wb") as file:
        file.truncate(500_000_000)
    monkeypatch.setattr(data_files, "_bytes", functools.partial(pytest.fail, "it was read"))
    with pytest.raises(InputError, match=r"is too large, 500 MB; a file of at most 100 MB is read"):
        MeshBody(type="mesh", file=str(path), surface=WALL)


def test_a_grid_too_fine_says_how_fine_it_may_be(tmp_path: Path) -> None:
    """By its memory, before anything is computed."""
    path = tmp_path / "box.stl"
    path.write_bytes(stl_bytes(BOX))
    with pytest.raises(
        InputError, match=r"cell: gives a grid of .* MB; the most is 128 MB: cells of"
    ):
        MeshBody(type="mesh", file=str(path), cell=1e-4, surface=WALL)


# -- content ----------------------------------------------------------------------------------------


def test_a_changed_file_is_noticed(tmp_path: Path) -> None:
    """By its content, even if it is as long as before; a copy elsewhere stands in for it."""
    shape = mesh_file(tmp_path, stl_bytes(BOX))
    assert shape.content == content_digest(shape.file)
    old = Path(shape.file).read_bytes()
    Path(shape.file).write_bytes(stl_bytes(box_triangles(0.5, 0.4, 0.31)))
    again = {name: getattr(shape, name) for name in ("type", "file", "surface")}
    with pytest.raises(InputError, match=r"file: .*was changed: its content is"):
        MeshBody(**again, content=shape.content)
    with pytest.raises(Exception, match="was changed while it was read"):
        file_bytes(shape.file, shape.content)
    place_content(shape.content, lambda: old)
    assert MeshBody(**again, content=shape.content).form().half == shape.form().half


# -- height maps and cells --------------------------------------------------------------------------


def png(pixels: Array, kinds: str = "01234") -> bytes:
    """A grey PNG whose lines have the filters of PNG in turn."""
    depth = pixels.dtype.itemsize
    raw = pixels.astype(f">u{depth}").view(np.uint8).reshape(len(pixels), -1).astype(int)
    lines, before = [], np.zeros(raw.shape[1], dtype=int)
    for k, line in enumerate(raw):
        kind = int(kinds[k % len(kinds)])
        left = np.concatenate([np.zeros(depth, dtype=int), line[:-depth]])
        corner = np.concatenate([np.zeros(depth, dtype=int), before[:-depth]])
        guess = left + before - corner
        away = [abs(guess - left), abs(guess - before), abs(guess - corner)]
        nearest = np.where(
            (away[0] <= away[1]) & (away[0] <= away[2]), left,
            np.where(away[1] <= away[2], before, corner),
        )  # fmt: skip
        predicted = [0 * line, left, before, (left + before) // 2, nearest][kind]
        lines.append(bytes([kind]) + ((line - predicted) % 256).astype(np.uint8).tobytes())
        before = line

    def chunk(name: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        )

    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8 * depth, 0, 0, 0, 0)
    body = zlib.compress(b"".join(lines))
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", body[:9])
        + chunk(b"IDAT", body[9:]) + chunk(b"IEND", b"")
    )  # fmt: skip


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_grey_images_are_read_whatever_their_lines_are_predicted_from(kind: type) -> None:
    """Bit for bit, by all five filters."""
    most = np.iinfo(kind).max
    pixels = np.random.default_rng(3).integers(0, most, size=(11, 7), endpoint=True).astype(kind)
    assert np.array_equal(grey_image("x.png", png(pixels), 100), pixels / most)


def test_an_image_is_ground_between_two_heights(tmp_path: Path) -> None:
    """Columns along x, the upper row at the largest y."""
    path = tmp_path / "ground.png"
    path.write_bytes(png(np.array([[0, 0, 0, 255]] + 3 * [[0, 0, 0, 0]], dtype=np.uint8)))
    shape = HeightMap(type="heightmap", file=str(path), spacing=0.5, range=(-0.1, 0.3), position=(0, 0, 0),
                      surface=WALL)  # fmt: skip
    same = np.full((4, 4), -0.1)
    same[3, 3] = 0.3
    other = height_file(same, tmp_path / "same.npy")
    form = HeightMap(
        type="heightmap", file=other, spacing=0.5, position=(0, 0, 0), surface=WALL
    ).form()
    assert np.allclose(shape.form().spline, form.spline, atol=1e-15)


def npy(path: Path, values: Any) -> str:
    """A file of NumPy."""
    np.save(path, values, allow_pickle=True)
    return str(path)


@pytest.mark.parametrize(
    ("make", "given", "words"),
    [
        (lambda p: npy(p / "h.npy", np.zeros((5, 5))), {}, "needs either size or spacing"),
        (lambda p: npy(p / "h.npy", np.zeros((5, 5))), {"size": (1, 1), "spacing": 0.1}, "size or spacing, not both"),
        (lambda p: npy(p / "h.npy", np.zeros((5, 5, 5))), {"spacing": 0.1}, r"two axes, along x and y \(got 5 x 5 x 5"),
        (lambda p: npy(p / "h.npy", np.zeros((5, 3))), {"spacing": 0.1}, r"at least 4 x 4 heights \(got 5 x 3"),
        (lambda p: npy(p / "h.npy", np.full((5, 5), np.nan)), {"spacing": 0.1}, r"height \[0, 0\] is not finite"),
        (lambda p: npy(p / "h.npy", np.array(["a", {}], dtype=object)), {"spacing": 0.1}, "must hold numbers"),
        (lambda p: npy(p / "h.npy", np.array([["a"] * 5] * 5)), {"spacing": 0.1}, r"^[^(]*h\.npy: must hold numbers \(got text\)$"),
        (lambda p: npy(p / "h.npy", np.zeros((5, 5))), {"spacing": 0.1, "range": (0, 1)}, "range: is for images"),
        (lambda p: npy(p / "h.npy", np.zeros((5, 5))), {"spacing": 0.0}, "spacing: must be more than 0 m"),
        (lambda p: str(p / "none.npy"), {"spacing": 0.1}, "cannot be read"),
        (lambda p: str(p), {"spacing": 0.1}, "is not a regular file"),
    ],
)  # fmt: skip
def test_heights_that_are_none_are_refused(
    tmp_path: Path, make: Callable[[Path], str], given: dict[str, Any], words: str
) -> None:
    """In one line."""
    with pytest.raises(InputError, match=words) as raised:
        HeightMap(type="heightmap", file=make(tmp_path), position=(0, 0, 0), surface=WALL, **given)
    assert len(raised.value.problems) == 1


def test_images_that_are_none_are_refused(tmp_path: Path) -> None:
    """Truncated, of another kind, without heights."""
    good = png(np.zeros((5, 5), dtype=np.uint8))
    colour = good[:25] + b"\x02" + good[26:]
    for data, words in (
        (good[:-40], "is damaged"), (b"GIF89a", "is not PNG"), (colour, "must be grey"),
        (good[:28] + b"\x01" + good[29:], "must not be interlaced"),
        (good[:16] + struct.pack(">II", 60_000, 60_000) + good[24:], "must have at most 4000000 pixels"),
    ):  # fmt: skip
        (tmp_path / "x.png").write_bytes(data)
        with pytest.raises(InputError, match=words):
            HeightMap(type="heightmap", file=str(tmp_path / "x.png"), spacing=0.1, range=(0, 1),
                      position=(0, 0, 0), surface=WALL)  # fmt: skip
    (tmp_path / "x.png").write_bytes(good)
    with pytest.raises(InputError, match="range: is missing: heights of black and white"):
        HeightMap(type="heightmap", file=str(tmp_path / "x.png"), spacing=0.1, position=(0, 0, 0),
                  surface=WALL)  # fmt: skip


@pytest.mark.parametrize(
    ("make", "given", "words"),
    [
        (lambda p: npy(p / "o.npy", np.zeros((3, 3, 3), bool)), {"cell": 0.1}, "has no occupied cell"),
        (lambda p: npy(p / "o.npy", np.ones((3, 3, 3), bool)), {}, "cell: is missing"),
        (lambda p: npy(p / "o.npy", np.ones((3, 3))), {"cell": 0.1}, r"must have three axes \(got 3 x 3"),
        (lambda p: npy(p / "o.npy", np.full((3, 3, 3), 7)), {"cell": 0.1}, "probabilities must be at most 1"),
        (lambda p: occupancy_file(np.ones((2, 2, 2)), -1.0, path=p / "o.npz"), {}, "cell must be a length above 0"),
    ],
)  # fmt: skip
def test_cells_that_are_none_are_refused(
    tmp_path: Path, make: Callable[[Path], str], given: dict[str, Any], words: str
) -> None:
    """In one line."""
    with pytest.raises(InputError, match=words) as raised:
        OccupancyGrid(type="occupancy", file=make(tmp_path), surface=WALL, **given)
    assert len(raised.value.problems) == 1


def test_probabilities_and_unknown_cells() -> None:
    """At the threshold a cell is occupied; unknown ones are what the user says."""
    values = np.zeros((3, 3, 3))
    values[1, 1, 1], values[0, 0, 0], values[2, 2, 2] = 0.6, np.nan, -1.0
    file = occupancy_file(values, 0.1, origin=(1.0, 2.0, 3.0))
    for given, count in (
        ({}, 1),
        ({"threshold": 0.61, "unknown": "occupied"}, 2),
        ({"unknown": "occupied"}, 3),
    ):
        shape = OccupancyGrid(type="occupancy", file=file, surface=WALL, **given)
        assert int(np.asarray(shape.cells().occupied).sum()) == count
    assert np.allclose(shape.cells().low, [1.0, 2.0, 3.0])


# -- what is kept -----------------------------------------------------------------------------------


def grid(value: float = 1.0) -> DistanceGrid:
    """A small grid."""
    return DistanceGrid(np.zeros(3), 0.1, np.full((3, 3, 3), value), np.zeros(2), 0.0)


def test_a_grid_is_made_once_and_again_if_its_file_is_damaged() -> None:
    """Absent, there, damaged, truncated, unreadable."""
    made = list[int]()

    def make() -> DistanceGrid:
        made.append(1)
        return grid()

    assert np.array_equal(stored_grid("a", make).values, grid().values)
    assert np.array_equal(stored_grid("a", make).values, grid().values)
    assert len(made) == 1
    [path] = form_folder().glob("*.grid")
    whole = path.read_bytes()
    for k, damaged in enumerate(
        (whole[:50], whole[:-1] + b"?", b"", whole[:32] + bytes(len(whole)))
    ):
        path.write_bytes(damaged)
        with pytest.warns(CacheWarning, match="kept grid ignored"):
            assert np.array_equal(stored_grid("a", make).values, grid().values)
        assert len(made) == k + 2
        assert path.read_bytes() == whole
    assert len(stored_grid("b", make).values) == 3
    assert len(made) == 6


def test_where_nothing_can_be_written_grids_are_made_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a warning, and the same numbers."""
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("SPRINGBACK_CACHE_DIR", str(tmp_path / "file"))
    with pytest.warns(CacheWarning, match="grids cannot be kept"):
        assert np.array_equal(stored_grid("a", grid).values, grid().values)


def _in_process(folder: str, number: int) -> int:
    """Grids made by a process that asks for one, as others do."""
    import os

    os.environ["SPRINGBACK_CACHE_DIR"] = folder
    made = list[int]()

    def make() -> DistanceGrid:
        made.append(number)
        return grid()

    found = stored_grid("shared", make)
    assert np.array_equal(found.values, grid().values)
    return len(made)


def test_of_many_processes_one_makes_a_grid(tmp_path: Path) -> None:
    """The others wait for its file."""
    with multiprocessing.get_context("spawn").Pool(3) as pool:
        made = pool.starmap(_in_process, [(str(tmp_path / "shared"), k) for k in range(6)])
    assert sum(made) == 1
