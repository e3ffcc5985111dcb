"""A scene shows the flight and nothing else: its numbers are those of the trajectory."""

from __future__ import annotations

import base64
import contextlib
import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pytest

import springback
from builders.user_obstacles import Ball
from springback.contact.obstacles import signed_distance
from springback.contact.scene.solids import solid_face
from springback.contact.scene.table import Solid
from springback.errors import InputError
from springback.interfaces.replay.geometry import MOST_DRAWN, TRUNK_SIDES, drawables
from springback.interfaces.replay.instants import (
    ACCELERATION_BOUND,
    APART,
    ARM_BOUND,
    BOUNDS,
    FORCE_BOUND,
    MOST_NEAR,
    NEAR,
    SHARE,
    departure,
    drawn_instants,
)
from springback.interfaces.replay.scene import Scene, load, plain, scene_of
from springback.interfaces.reports.flight_files import write_flight
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Vec
from springback.results.flight import Flight, fly
from springback.results.meshes import read_surfaces, surface_of
from springback.results.sealed_json import file_digest, with_digest
from springback.scenario.scenario import expand_presets
from springback.scenario.tables import WorldSettings
from springback.simulation import playback

EXAMPLES = Path(__file__).parents[3] / "examples"
NORMAL = np.array([-1.0, 0.0, 0.6]) / math.hypot(1.0, 0.6)
TILTED = {
    "vehicle": "arq",
    "thrust": "hover",
    "world": {"obstacles": [
        {"type": "wall", "position": [2.75, 0.0, 1.0], "normal": [-1.0, 0.0, 0.6],
         "surface": "wall"},
    ]},
    "start": {"position": [2.3, 0.0, 1.0], "velocity": [2.0, 0.4, 0.0], "pitch": 0.3, "yaw": 0.2},
    "simulation": {"duration": 0.2},
}  # fmt: skip


@pytest.fixture(scope="module")
def flight() -> Flight:
    """A skew impact on a tilted wall, with friction."""
    return fly(TILTED)


@pytest.fixture(scope="module")
def scene(flight: Flight) -> Scene:
    return scene_of(flight)


@pytest.fixture(scope="module")
def recovery() -> Flight:
    """Some seconds with a pilot."""
    return fly(EXAMPLES / "collision.toml", "reference.speed=2 m/s", "simulation.duration=6 s")


def places(flight: Flight, scene: Scene) -> np.ndarray:
    return np.searchsorted(flight.columns["t"], scene.t)


# -- forces ---------------------------------------------------------------------------------------


def test_forces_are_those_of_the_columns(flight: Flight, scene: Scene) -> None:
    """Along the wall's normal f_n, across it f_f, for every cage and instant."""
    at = places(flight, scene)
    assert max(flight.columns[f"fn{j}"].max() for j in (1, 2, 3, 4)) > 50.0
    for j in range(4):
        normal = scene.force[:, j] @ NORMAL
        across = np.linalg.norm(scene.force[:, j] - np.outer(normal, NORMAL), axis=1)
        np.testing.assert_allclose(normal, flight.columns[f"fn{j + 1}"][at], atol=1e-9)
        np.testing.assert_allclose(across, flight.columns[f"ff{j + 1}"][at], atol=1e-9)


def test_forces_over_time_are_the_impulse(flight: Flight, scene: Scene) -> None:
    """Their directions are right: their integral is what the flight kept books of."""
    impulse = np.trapezoid(scene.force.sum(axis=1), scene.t, axis=0)
    told = [flight.measures[f"impulse_{axis}"] for axis in "xyz"]
    np.testing.assert_allclose(impulse, told, atol=2e-3 * np.linalg.norm(told))


def test_forces_act_on_the_cage_and_at_the_wall(scene: Scene) -> None:
    """The point is on the cage's circle, and as deep in the wall as the cage."""
    touching = np.linalg.norm(scene.force, axis=2) > 1e-3
    assert touching.any()
    for i, j in np.argwhere(touching):
        arm, r = scene.arms[j], rotation(scene.attitude[i])
        centre = scene.position[i] + r @ np.array(arm.direction) * scene.arm_length[i, j]
        spoke = scene.point[i, j] - centre
        assert np.linalg.norm(spoke) == pytest.approx(arm.cage_radius, rel=1e-3)
        assert spoke @ r[:, 2] == pytest.approx(0.0, abs=1e-9)
        depth = -(scene.point[i, j] - np.array([2.75, 0.0, 1.0])) @ NORMAL
        assert -1e-4 < depth < 0.02


def rotation(q: np.ndarray) -> np.ndarray:
    w, x, y, z = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def test_forces_are_felt_where_cages_reach_into_the_wall(flight: Flight, scene: Scene) -> None:
    """A cage's centre is nearer than its tilted, rounded circle reaches, or feels nothing."""
    rounding = flight.scenario.flight_model().contact_point.rounding
    pressed = 0
    for i in range(len(scene.t)):
        r = rotation(scene.attitude[i])
        for j, arm in enumerate(scene.arms):
            centre = scene.position[i] + r @ np.array(arm.direction) * scene.arm_length[i, j]
            lean = NORMAL @ r[:, 2]
            reach = arm.cage_radius * math.sqrt(1.0 - lean**2 + rounding**2)
            gap = (centre - np.array([2.75, 0.0, 1.0])) @ NORMAL - reach
            feels = np.linalg.norm(scene.force[i, j]) > 1e-6
            pressed += feels
            assert feels == (gap < 0.0) or abs(gap) < 3e-5, (scene.t[i], j, gap)
    assert pressed > 100


def test_energies_end_where_the_ledger_ends(flight: Flight, scene: Scene) -> None:
    energy = {one.name: one.values for one in scene.series if one.panel == "Energy"}
    assert energy["motion"][-1] == pytest.approx(flight.measures["energy_kinetic"], rel=1e-9)
    assert energy["height"][-1] == pytest.approx(flight.measures["energy_gravity"], abs=1e-9)


# -- instants -------------------------------------------------------------------------------------


def test_lines_between_instants_stay_within_the_stated_bounds(recovery: Flight) -> None:
    """Every step that was left out is within the bounds of the line across it."""
    scene = scene_of(recovery)
    c = recovery.columns
    bounds = dict.fromkeys("xyz", BOUNDS["m"]) | {f"q{p}": BOUNDS[""] for p in "wxyz"}
    bounds |= {f"v{a}": BOUNDS["m/s"] for a in "xyz"}
    bounds |= {f"l{j}": ARM_BOUND for j in (1, 2, 3, 4)}
    hardest = max(np.abs(c[f"a{a}"]).max() for a in "xyz")
    bounds |= {f"a{a}": max(ACCELERATION_BOUND, SHARE * hardest) for a in "xyz"}
    forces = [f"{kind}{j}" for kind in ("fn", "ff") for j in (1, 2, 3, 4)]
    peak = max(np.abs(c[name]).max() for name in forces)
    bounds |= dict.fromkeys(forces, max(FORCE_BOUND, SHARE * peak))
    at = places(recovery, scene)
    for name, bound in bounds.items():
        off = np.abs(np.interp(c["t"], scene.t, c[name][at]) - c[name]).max()
        assert off <= bound * (1 + 1e-9), name
    assert scene.departure["position"] == pytest.approx(
        max(np.abs(np.interp(c["t"], scene.t, c[a][at]) - c[a]).max() for a in "xyz")
    )
    assert len(scene.t) < 0.4 * len(c["t"])
    assert np.diff(scene.t).max() <= APART * (1 + 1e-6)


def test_every_step_near_a_contact_is_kept(recovery: Flight) -> None:
    t, scene = recovery.columns["t"], scene_of(recovery)
    begin, end = scene.impacts[0]
    near = t[(t >= begin - NEAR) & (t <= end + NEAR)]
    assert len(near) > 200
    assert np.isin(near, scene.t).all()


def test_leaning_on_a_wall_does_not_make_a_scene_grow_without_end() -> None:
    """Three seconds of contact at steps of 0.1 ms: some are left out, within the bounds."""
    t = np.arange(30_000) * 1e-4
    zero = np.zeros_like(t)
    columns = {"t": t, "x": 1e-3 * np.sin(t), "y": zero, "z": zero, "qw": zero + 1.0}
    columns |= dict.fromkeys(("qx", "qy", "qz", "vy", "vz", "ax", "ay", "az"), zero)
    columns |= {"vx": 1e-3 * np.cos(t), "l1": zero + 0.19, "fn1": 5.0 + np.sin(t), "ff1": zero}
    at = drawn_instants(columns, 1)
    assert len(at) < MOST_NEAR + 1000
    off = departure(columns, 1, at)
    assert off["position"] <= BOUNDS["m"]
    assert off["force"] <= FORCE_BOUND
    assert at[0] == 0
    assert at[-1] == len(t) - 1


def test_what_moves_fast_away_from_contacts_is_followed() -> None:
    """An arm that rings at 150 Hz has bends that lines of 5 ms would cut off."""
    t = np.arange(4096) * 1e-4
    zero = np.zeros_like(t)
    columns = dict.fromkeys([*"xyz", "qx", "qy", "qz"], zero)
    columns |= {"t": t, "qw": zero + 1.0, "fn1": zero, "ff1": zero}
    columns |= {f"{kind}{axis}": zero for kind in "va" for axis in "xyz"}
    columns["l1"] = 0.19 - 1e-3 * np.sin(2 * math.pi * 150.0 * t)
    at = drawn_instants(columns, 1)
    assert len(at) < 0.5 * len(t)
    assert departure(columns, 1, at)["arm_length"] <= ARM_BOUND


def test_thrust_is_the_last_word_of_the_telemetry(recovery: Flight) -> None:
    scene, telemetry = scene_of(recovery), recovery.telemetry
    for i in (0, len(scene.t) // 2, len(scene.t) - 1):
        page = np.flatnonzero(telemetry["t"] <= scene.t[i])[-1]
        assert scene.thrust[i].tolist() == [telemetry[f"thrust{j}"][page] for j in (1, 2, 3, 4)]


def test_events_are_where_the_measures_say(recovery: Flight) -> None:
    scene = scene_of(recovery)
    when = {event.label: event.t for event in scene.events}
    m = recovery.measures
    assert when["touch"] == pytest.approx(m["touch_time"], abs=1e-9)
    assert when["off"] == pytest.approx(m["separation_time"], abs=1e-9)
    assert when["detected"] == pytest.approx(m["alarm_time"], abs=1.1e-3)
    assert when["way back"] == pytest.approx(m["planned_time"], abs=1.1e-3)
    assert [event.t for event in scene.events] == sorted(event.t for event in scene.events)
    assert scene.events[-1].text == recovery.message


# -- things to hit --------------------------------------------------------------------------------


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


def test_a_shape_of_ones_own_is_drawn_and_what_is_not_drawn_is_said(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """In plain Python: compiling for a test's own shape takes longer than flying."""
    monkeypatch.setattr(playback, "user_executor", lambda function, *_, **__: function)
    own = [(Ball(Vec(2.9, 0.0, 1.0), 0.2), springback.WALL)]
    tables = {key: value for key, value in TILTED.items() if key != "world"} | {
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
    # Its law is code of the user's, which no file keeps; its surface is drawn all the same.
    assert "come from obstacles of your own" in saved.notes[0]
    for scene in (known, saved):
        [ball] = scene.obstacles
        assert (ball.kind, ball.name) == ("mesh", "Ball")
        assert ball.vertices is not None
        away = np.linalg.norm(ball.vertices - [2.9, 0.0, 1.0], axis=1)
        assert away == pytest.approx(np.full(len(away), 0.2), abs=1e-4)
    assert len(saved.obstacles[0].triangles) > 50
    again = load(tmp_path).summary()  # what was read back says the same again
    assert again["own_obstacles"] == flight.summary()["own_obstacles"]


@pytest.mark.parametrize("torn", [3, [{}], [{"name": "x", "vertices": [[0, 0, 0]], "normals": [[0, 0, 1]],
                                             "triangles": [[0, 1, 2]]}]])  # fmt: skip
def test_torn_surfaces_are_refused_in_one_line(torn: Any) -> None:
    with pytest.raises(InputError, match=r"^s\.json: must be a list of surfaces"):
        read_surfaces(torn, "s.json")


# -- as JSON --------------------------------------------------------------------------------------


def unpacked(packed: dict) -> np.ndarray:
    data = base64.b64decode(packed["data"])
    return np.frombuffer(data, dtype=f"<{packed['type']}").reshape(packed["shape"])


def test_json_holds_the_numbers_and_stays_small(recovery: Flight) -> None:
    """Instants to the bit, places to a micrometre, a flight of 6 s in less than 1.5 MB."""
    scene = scene_of(recovery)
    text = json.dumps(plain(scene), allow_nan=False)
    assert len(text) < 1.5e6
    told = json.loads(text)
    assert np.array_equal(unpacked(told["t"]), scene.t)
    np.testing.assert_allclose(unpacked(told["position"]), scene.position, atol=1e-6)
    np.testing.assert_allclose(unpacked(told["attitude"]), scene.attitude, atol=1e-7)
    force = np.zeros_like(scene.force)
    force[unpacked(told["force"]["at"])] = unpacked(told["force"]["of"])
    np.testing.assert_allclose(force, scene.force, rtol=1e-6, atol=1e-6)
    assert told["arms"][0]["length"] == 0.19
    assert next(one["panel"] for one in told["series"]) == "Velocity"


def test_a_flight_without_trajectory_has_no_scene(flight: Flight) -> None:
    with pytest.raises(InputError, match="trajectory"):
        scene_of(replace(flight, columns={}))


# -- read back ------------------------------------------------------------------------------------


@pytest.fixture
def folder(recovery: Flight, tmp_path: Path) -> Path:
    folder = tmp_path / "a [1] b's*"
    folder.mkdir()
    write_flight(recovery, folder, figures=False)
    return folder


def test_what_was_written_is_read_back(recovery: Flight, folder: Path) -> None:
    """Scenario, outcome and measures equal, every column to the bit, and the same scene."""
    read = load(folder)
    assert read.scenario == recovery.scenario
    assert (read.outcome, read.measures) == (recovery.outcome, recovery.measures)
    assert read.units == recovery.units
    for ours, theirs in ((read.columns, recovery.columns), (read.telemetry, recovery.telemetry)):
        assert list(ours) == list(theirs)
        assert all(np.array_equal(ours[name], theirs[name]) for name in ours)
    assert plain(scene_of(read)) == plain(scene_of(recovery))


def edited(folder: Path, **changes: object) -> None:
    """Of a summary something else, with the digest that belongs to it."""
    summary = json.loads((folder / "summary.json").read_text()) | changes
    with contextlib.suppress(ValueError):  # infinity has no digest
        summary = with_digest(summary)
    (folder / "summary.json").write_text(json.dumps(summary))


def entered(folder: Path, name: str) -> None:
    """A file as if the flight had been written with it."""
    files = json.loads((folder / "summary.json").read_text())["files"]
    edited(folder, files=files | {name: file_digest(folder / name)})


def parquet(folder: Path, select: str) -> None:
    """The trajectory as a query over itself."""
    path = folder / "trajectory.parquet"
    duckdb.execute(f"CREATE OR REPLACE TEMP TABLE given AS SELECT * FROM read_parquet($${path}$$)")
    duckdb.execute(f"COPY ({select}) TO $${path}$$ (FORMAT parquet)")
    entered(folder, "trajectory.parquet")


def replaced(folder: Path, name: str, data: bytes) -> None:
    (folder / name).write_bytes(data)
    entered(folder, name)


HOSTILE = {
    "no summary": (lambda f: (f / "summary.json").unlink(), "summary.json"),
    "torn summary": (lambda f: (f / "summary.json").write_text('{"scenario": {'), "JSON"),
    "binary summary": (lambda f: (f / "summary.json").write_bytes(b"\xff\xfe\x00"), "JSON"),
    "deep summary": (lambda f: (f / "summary.json").write_text("[" * 200_000), "JSON"),
    "a list": (lambda f: (f / "summary.json").write_text("[1, 2]"), "object"),
    "a campaign's": (lambda f: (f / "summary.json").write_text('{"flights": 3}'), "scenario"),
    "other scenario": (lambda f: edited(f, scenario={"vehicle": "ornithopter"}), "ornithopter"),
    "other outcome": (lambda f: edited(f, outcome="exploded"), "exploded"),
    "outcome of another kind": (lambda f: edited(f, outcome=["recovered"]), "outcome"),
    "a measure in words": (lambda f: edited(f, measures={"touch_time": "soon"}), "touch_time"),
    "a measure without end": (lambda f: edited(f, measures={"touch_time": 1e999}), "damaged or was edited"),
    "no trajectory": (lambda f: (f / "trajectory.parquet").unlink(), "trajectory.parquet"),
    "torn trajectory": (
        lambda f: replaced(
            f, "trajectory.parquet", (f / "trajectory.parquet").read_bytes()[:5000]
        ),
        "Parquet",
    ),
    "foreign trajectory": (lambda f: parquet(f, "SELECT t, x AS longitude FROM given"), "column x"),
    "text": (lambda f: parquet(f, "SELECT * REPLACE ('far' AS x) FROM given"), "column x"),
    "missing values": (
        lambda f: parquet(f, "SELECT * REPLACE (CASE WHEN t > 1 THEN x END AS x) FROM given"),
        "column x",
    ),
    "infinite": (lambda f: parquet(f, "SELECT * REPLACE (1e308 * 10 * (1 + t) AS x) FROM given"), "x"),
    "backwards": (lambda f: parquet(f, "SELECT * REPLACE (-t AS t) FROM given"), "column t"),
    "one instant": (lambda f: parquet(f, "SELECT * FROM given LIMIT 1"), "1 instants"),
    "torn telemetry": (lambda f: replaced(f, "telemetry.parquet", b"PAR1"), "telemetry.parquet"),
    "a telemetry of another flight": (
        lambda f: (f / "telemetry.parquet").write_bytes(b"PAR1"), "belongs to another flight"
    ),
    "no telemetry": (lambda f: (f / "telemetry.parquet").unlink(), "telemetry.parquet"),
    "an edited number": (
        lambda f: (f / "summary.json").write_text(
            re.sub(r'("touch_\w+": )([0-9])', r"\g<1>1\g<2>", (f / "summary.json").read_text())
        ),
        "damaged or was edited",
    ),
    "deep objects": (lambda f: (f / "summary.json").write_text('{"a":' * 100_000), "JSON"),
}  # fmt: skip


@pytest.mark.parametrize(("spoil", "word"), HOSTILE.values(), ids=HOSTILE.keys())
def test_what_is_no_result_is_refused_in_one_line(folder: Path, spoil, word: str) -> None:
    spoil(folder)
    with pytest.raises(InputError) as caught:
        load(folder)
    assert len(caught.value.problems) == 1
    assert "\n" not in caught.value.problems[0]
    assert word in caught.value.problems[0]


def test_no_folder_and_a_file_are_told_apart(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such folder"):
        load(tmp_path / "nothing")
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="is a file"):
        load(tmp_path / "file")
