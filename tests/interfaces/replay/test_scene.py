"""A scene shows the flight and nothing else: its numbers are those of the trajectory."""

from __future__ import annotations

import base64
import contextlib
import json
import math
import re
from dataclasses import replace
from pathlib import Path

import duckdb
import numpy as np
import pytest

from springback.errors import InputError
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
from springback.results.flight import Flight, fly
from springback.results.sealed_json import file_digest, with_digest

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
