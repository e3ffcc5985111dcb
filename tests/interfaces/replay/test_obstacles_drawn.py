"""Obstacles are drawn where they are: faces, meshes of shapes, and what a user has made."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.user_obstacles import Ball
from springback.contact.obstacles import signed_distance
from springback.contact.scene.solids import solid_face
from springback.contact.scene.table import Solid
from springback.errors import InputError
from springback.interfaces.replay.geometry import (
    MOST_DRAWN,
    MOST_NAMED,
    TRUNK_SIDES,
    Drawable,
    drawables,
)
from springback.interfaces.replay.scene import load, scene_of
from springback.interfaces.reports.flight_files import write_flight
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Vec
from springback.results.contacts.stored import CONTACTS, check_contacts
from springback.results.flight import fly
from springback.results.meshes import read_surfaces, surface_of
from springback.scenario.scenario import expand_presets
from springback.scenario.tables import WorldSettings
from springback.simulation import playback


def test_walls_mats_and_ground_stand_where_they_are() -> None:
    """Faces lie in their planes; a wall reaches down to the ground."""
    world = WorldSettings.model_validate(expand_presets({"vehicle": "arq", "world": {"obstacles": [
        {"type": "mat", "distance": 2.75, "thickness": 0.05, "surface": "mat", "backing": "wall"},
        {"type": "ground", "surface": "wall", "height": 0.1},
    ]}})["world"])  # fmt: skip
    flown = np.array([[0.0, 0.0, 1.0], [2.4, 0.1, 1.1]])
    mat, ground = drawables(world.obstacles, (), flown, np.zeros((0, 3))).drawables
    assert (mat.kind, mat.thickness, ground.kind) == ("mat", 0.05, "ground")
    assert mat.centre[0] == pytest.approx(2.70)
    assert mat.normal == (-1.0, 0.0, 0.0)
    assert ground.centre[2] == 0.1
    assert mat.centre[2] - np.linalg.norm(mat.along) == pytest.approx(0.1)
    for face in (mat, ground):
        assert np.cross(face.across, face.along) @ np.array(face.normal) > 0.0


def test_obstacles_go_by_their_names() -> None:
    """Shapes of one name are one; those without go by their type, as do those beyond the most."""
    pole = {"type": "pole", "position": [2.7, 0.0, 0.0], "radius": 0.05, "surface": "wall"}
    entries = [
        {"type": "wall", "name": "east wall", "distance": 3.0, "surface": "wall"},
        pole, {**pole, "name": "column"}, {**pole, "name": "lamp"}, {**pole, "name": "column"}, pole,
    ]  # fmt: skip
    flown = np.array([[0.0, 0.0, 1.0], [2.4, 0.1, 1.1]])

    def drawn(entries: list[dict[str, Any]]) -> list[tuple[str, str]]:
        world = WorldSettings.model_validate({"obstacles": entries})
        found = drawables(world.obstacles, (), flown, np.zeros((0, 3))).drawables
        return [(one.kind, one.name) for one in found]

    entries = expand_presets({"vehicle": "arq", "world": {"obstacles": entries}})["world"][
        "obstacles"
    ]
    assert drawn(entries) == [
        ("wall", "east wall"), ("mesh", "pole"), ("mesh", "column"), ("mesh", "lamp"),
    ]  # fmt: skip
    many = [{**entries[1], "name": f"pole {k}"} for k in range(MOST_NAMED + 5)]
    assert len(drawn(many)) == MOST_NAMED + 1
    assert drawn(many)[-1] == ("mesh", "pole")


def shapes(name: str, **fields: Any) -> dict[str, Any]:
    """A flight at 2 m/s along X that begins before a shape."""
    return {
        "vehicle": "arq", "thrust": "hover", "simulation": {"duration": 0.3},
        "world": {"obstacles": [{"type": name, "surface": "wall", **fields}]},
        "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "pitch": 0.26},
    }  # fmt: skip


BUILT_IN = {
    "pole": {"position": [2.7, 0.02, 0.0], "radius": 0.05},
    "window": {"position": [2.7, 0.2, 1.2], "size": [2.4, 1.8], "opening": [0.7, 0.5]},
    "hoop": {"position": [2.6, 0.15, 1.0], "radius": 0.4, "tube_radius": 0.03},
}


@pytest.mark.parametrize("name", BUILT_IN)
def test_a_built_in_shape_is_drawn_where_the_forces_act(name: str, tmp_path: Path) -> None:
    """Contact points are at most as deep in its mesh as the cage; read back it is drawn the same."""
    flight = fly(shapes(name, **BUILT_IN[name]))
    scene = scene_of(flight)
    [thing] = scene.obstacles
    assert (thing.kind, thing.name, scene.notes) == ("mesh", name, ())
    assert thing.vertices is not None
    assert thing.triangles is not None
    touching = np.linalg.norm(scene.force, axis=2) > 1e-3
    assert touching.sum() > 50
    points = scene.point[touching]
    [body] = flight.scenario.world.obstacles[0].bodies()  # type: ignore[union-attr]
    table = NumberTable(np.array(Solid(*body, 0, 0.0, 0).row()))
    gaps = np.array([solid_face(table, 0, Vec(*p)).gap for p in points.tolist()])
    # One point stands for all of a cage's: between two of them it may be a little before the face.
    assert gaps.min() > -0.02
    assert gaps.max() < 0.01
    corners = thing.vertices[thing.triangles]
    nearest = [np.linalg.norm(corners.mean(axis=1) - p, axis=1).min() for p in points]
    assert max(nearest) < 1.0
    write_flight(flight, tmp_path, figures=False)
    [again] = scene_of(load(tmp_path)).obstacles
    assert again.vertices is not None
    assert np.array_equal(again.vertices, thing.vertices)
    assert again.key == thing.key


def things_of(*obstacles: dict[str, Any], flown: Any = ((0.0, 0.0, 1.0), (2.4, 0.1, 1.1))) -> Any:
    world = WorldSettings.model_validate(
        expand_presets({"vehicle": "arq", "world": {"obstacles": list(obstacles)}})["world"]
    )
    return drawables(world.obstacles, (), np.array(flown), np.zeros((0, 3)))


def test_what_has_no_end_is_cut_off_around_the_flight_and_stands_on_the_floor() -> None:
    """A pole from the ground to above the flight; a rail around where it is passed; a slope."""
    pole = {"type": "pole", "position": [2.7, 0, 0.5], "radius": 0.05, "surface": "wall"}
    down = pole | {"axis": [0, 0, -1]}
    rail = pole | {"axis": [0, 1, 0]}
    ground = {"type": "ground", "surface": "wall", "height": 0.1}
    slope = {"type": "slope", "position": [1, 0, 0], "angle": "30 deg", "surface": "wall"}
    for one in (pole, down):
        _, thing = things_of(one, ground).drawables
        assert thing.vertices[:, 2].min() == pytest.approx(0.1)
        assert 1.5 < thing.vertices[:, 2].max() < 3.0
    [thing] = things_of(pole).drawables
    assert thing.vertices[:, 2].min() == pytest.approx(0.55)  # a little below the flight
    [thing] = things_of(rail, flown=((0.0, 0.0, 1.0), (2.4, 0.1, 1.1), (90.0, 70.0, 1.0))).drawables
    assert -2.0 < thing.vertices[:, 1].min() < 0.0 < thing.vertices[:, 1].max() < 2.0
    face, floor = things_of(slope, ground).drawables
    assert (face.kind, floor.kind) == ("slope", "ground")
    corner = np.array(face.centre) - face.along
    assert corner[2] == pytest.approx(0.1)  # its lower side is on the ground
    assert face.normal == pytest.approx((-0.5, 0.0, math.sqrt(0.75)))
    assert np.array(face.normal) @ (np.array(face.centre) - [1, 0, 0]) == pytest.approx(
        0.0, abs=1e-12
    )


def is_on(face: Drawable, points: Any) -> Any:
    """True for points in the rectangle of a face."""
    beside = np.asarray(points) - face.centre
    halves = (np.array(face.across), np.array(face.along))
    shares = [np.abs(beside @ half) / (half @ half) for half in halves]
    assert np.abs(beside @ np.array(face.normal)).max() < 1e-9
    return np.max(shares, axis=0) <= 1.0


@pytest.mark.parametrize("angle", [0.0, 20.0, 80.0])
def test_a_face_reaches_as_far_as_a_long_flight_and_its_contacts(angle: float) -> None:
    """Bounces down 80 m: it is under each touch, those far from the path too, and under the start."""
    theta = math.radians(angle)
    slope = {"type": "slope", "angle": f"{angle} deg", "uphill": "180 deg", "surface": "wall"}
    ground = {"type": "ground", "surface": "wall"}
    along, normal = (np.array([c, 0.0, s]) for c, s in (
        (math.cos(theta), -math.sin(theta)), (math.sin(theta), math.cos(theta)),
    ))  # fmt: skip
    places = np.linspace(0.0, 80.0, 201)[:, None] * along
    flown = places + np.abs(np.sin(places[:, :1])) * normal + 0.2 * normal
    flown[0] += [0.0, 0.0, 2.0]
    some = places[::40]
    touched = np.concatenate([some, some + np.array([0.0, 3.0, 0.0])])
    entry = slope if angle else ground
    world = expand_presets({"vehicle": "arq", "world": {"obstacles": [entry]}})["world"]
    given = WorldSettings.model_validate(world).obstacles
    [face] = drawables(given, (), flown, touched).drawables
    assert is_on(face, touched).all()
    if angle < 60.0:
        below = flown[0] - [0.0, 0.0, flown[0] @ normal / normal[2]]
        assert is_on(face, [below]).all()
    assert 2.0 * np.linalg.norm(face.along if angle else face.across) < 90.0


def test_shapes_of_a_type_are_one_mesh_and_only_near_ones_of_thousands_are_drawn() -> None:
    """All of few; of 8000 trunks those around the flight, quickly, with a remark."""
    poles = [
        {"type": "pole", "position": [x, 0, 0], "radius": 0.1, "surface": "wall"} for x in (3, 5)
    ]
    ball = {"type": "sphere", "position": [4, 0, 1], "radius": 0.1, "surface": "wall"}
    few = things_of(*poles, ball)
    assert [one.name for one in few.drawables] == ["pole", "sphere"]
    assert few.drawables[0].vertices[:, 0].max() == pytest.approx(5.1)
    assert few.notes == ()
    forest = {"type": "forest", "density": 0.8, "size": [100, 100], "surface": "wall"}
    many = things_of(forest)
    [trees] = many.drawables
    assert many.notes == (
        f"of 8000 bodies of the obstacles the {MOST_DRAWN} nearest to the flight are drawn",
    )
    assert len(trees.vertices) == 2 * TRUNK_SIDES * MOST_DRAWN
    assert np.hypot(trees.vertices[:, 0] - 1.2, trees.vertices[:, 1]).max() < 25.0
    other = things_of(forest | {"seed": 1})
    assert other.drawables[0].key != trees.key
    assert things_of(forest, flown=((50.0, 0.0, 1.0),)).drawables[0].key == trees.key


def test_a_shape_of_ones_own_becomes_a_closed_mesh() -> None:
    """Its vertices lie on the shape, its triangles face outwards, every edge is shared by two."""
    ball = Ball(Vec(0.3, -0.2, 0.1), 0.4)
    mesh = surface_of(ball, np.full(3, -1.0), np.full(3, 1.0))
    assert mesh is not None
    assert mesh.vertices is not None
    assert mesh.triangles is not None
    off = [signed_distance(ball, Vec(*p)) for p in mesh.vertices.tolist()]
    assert np.abs(off).max() < 1e-6
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    outward = (a + b + c) / 3 - np.array([0.3, -0.2, 0.1])
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), outward) > 0.0).all()
    edges = np.sort(np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    _, shared = np.unique(edges, axis=0, return_counts=True)
    assert (shared == 2).all()
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(4 / 3 * math.pi * 0.4**3, rel=0.02)


def test_a_shape_of_ones_own_is_drawn_with_its_contacts_and_an_older_result_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """In plain Python: compiling for a test's own shape takes longer than flying."""
    monkeypatch.setattr(playback, "user_executor", lambda function, *_, **__: function)
    own = [(Ball(Vec(2.9, 0.0, 1.0), 0.2), springback.WALL)]
    tables = {
        "vehicle": "arq",
        "thrust": "hover",
        "start": {"position": [2.36, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": math.pi / 4},
        "simulation": {"duration": 0.04},
    }
    flight = fly(tables, own=own, executor="python")
    assert flight.contacts
    assert flight.own == tuple(own)
    write_flight(flight, tmp_path, figures=False)
    known, saved = scene_of(flight), scene_of(load(tmp_path))
    assert known.notes == ()
    assert np.abs(known.force).max() > 10.0
    # Its law is code of the user's, which no file keeps; its surface and contacts are drawn.
    assert saved.notes == ()
    assert saved.part == known.part
    np.testing.assert_allclose(saved.force, known.force, atol=1e-9)
    np.testing.assert_allclose(saved.point, known.point, atol=1e-12)
    whole = np.linalg.norm(saved.force.sum(axis=1), axis=1)
    c = {name: values[np.isin(flight.t, saved.t)] for name, values in flight.columns.items()}
    parts = [np.hypot(c[f"fn{j}"], c[f"ff{j}"]) for j in range(1, 5)]
    assert whole == pytest.approx(np.sum(parts, axis=0), rel=1e-6, abs=1e-6)  # one cage at a time
    stored = {one.name: one.values for one in saved.series if one.panel == "Energy"}
    for one in nonempty([one for one in known.series if one.panel == "Energy"]):
        np.testing.assert_allclose(stored[one.name], one.values, atol=1e-9)
    old = scene_of(replace(load(tmp_path), own_contacts={}))
    assert "come from obstacles of your own" in old.notes[0]
    for scene in (known, saved):
        [ball] = scene.obstacles
        assert (ball.kind, ball.name) == ("mesh", "Ball")
        assert ball.vertices is not None
        away = np.linalg.norm(ball.vertices - [2.9, 0.0, 1.0], axis=1)
        assert away == pytest.approx(np.full(len(away), 0.2), abs=1e-4)
    assert len(saved.obstacles[0].triangles) > 50
    again = load(tmp_path).summary()  # what was read back says the same again
    first = flight.summary()
    assert again["own_obstacles"] == first["own_obstacles"]
    [one], [other] = first["obstacle_contacts"], again["obstacle_contacts"]
    assert one["obstacle"] == other["obstacle"] == "own[0], a Ball"
    assert other["place"] == pytest.approx(one["place"], abs=1e-9)
    (tmp_path / "again").mkdir()
    write_flight(load(tmp_path), tmp_path / "again", figures=False)
    assert (tmp_path / "again" / CONTACTS).read_bytes() == (tmp_path / CONTACTS).read_bytes()


@pytest.mark.parametrize(("change", "said"), [
    ({"force9_1_x": 0.0}, "the vehicle has no such part"), ({"point2_1_x": None}, "has no column"),
    ({"t": 0.00012345}, "must be the instants of trajectory"), ({}, ""),
])  # fmt: skip
def test_contacts_of_another_flight_are_refused_in_one_line(
    change: dict[str, float | None], said: str
) -> None:
    each = [f"{kind}{j}_1_{axis}" for kind in ("force", "point") for j in "12" for axis in "xyz"]
    table = dict.fromkeys(["t", "energy_contact", *each], np.zeros(1))
    for name, value in change.items():
        table[name] = np.array([value], dtype=float)
        if value is None:
            del table[name]
    trajectory = {"t": np.array([0.0, 1.0]), "fn1": np.zeros(2), "fn2": np.array([2.0, 0.0])}
    trajectory |= {"ff1": np.zeros(2), "ff2": np.zeros(2)}
    if not said:
        check_contacts(Path("c.parquet"), table, trajectory)
        return
    with pytest.raises(InputError, match=rf"^c\.parquet: .*{said}"):
        check_contacts(Path("c.parquet"), table, trajectory)


@pytest.mark.parametrize("torn", [3, [{}], [{"name": "x", "vertices": [[0, 0, 0]], "normals": [[0, 0, 1]],
                                             "triangles": [[0, 1, 2]]}]])  # fmt: skip
def test_torn_surfaces_are_refused_in_one_line(torn: Any) -> None:
    with pytest.raises(InputError, match=r"^s\.json: must be a list of surfaces"):
        read_surfaces(torn, "s.json")
