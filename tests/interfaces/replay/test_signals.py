"""Signals of the replay page: every column, on its own clock, as exact as is said."""

from __future__ import annotations

import base64
import json
import zlib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from springback.frames import attitude_from_euler
from springback.interfaces.replay.scene import Scene, scene_of
from springback.interfaces.replay.signals import (
    AFTER,
    BEFORE,
    GROUPS,
    LEVELS,
    MOST_FAR,
    group_of,
    plain_signals,
    signal_tables,
)
from springback.results.flight import Flight, fly

EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.fixture(scope="module")
def recovery() -> Flight:
    """Some seconds with a pilot."""
    return fly(EXAMPLES / "collision.toml", "reference.speed=2 m/s", "simulation.duration=6 s")


@pytest.fixture(scope="module")
def scene(recovery: Flight) -> Scene:
    return scene_of(recovery)


def unpacked(table: dict[str, Any]) -> dict[str, np.ndarray]:
    """Columns of a table as the page reads them, and their instants."""
    t = np.frombuffer(base64.b64decode(table["t"]["data"]), dtype="<f8")
    planes = np.frombuffer(zlib.decompress(base64.b64decode(table["data"])), dtype=np.uint8)
    found = {"t": t}
    for head, (low, high) in zip(
        table["columns"], planes.reshape(len(table["columns"]), 2, len(t)), strict=True
    ):
        levels = np.cumsum(low.astype(int) + 256 * high.astype(int)) % 65536
        found[head["name"]] = head["low"] + head["step"] * levels
    return found


def test_every_column_is_there_within_its_rounding(recovery: Flight, scene: Scene) -> None:
    """Trajectory at the drawn instants, telemetry at its ticks; flags and phases to the bit."""
    data = json.loads(json.dumps(plain_signals(recovery, scene), allow_nan=False))
    for clock, columns in (("trajectory", recovery.columns), ("telemetry", recovery.telemetry)):
        shown = unpacked(data[clock])
        assert set(columns) <= set(shown)
        at = np.searchsorted(columns["t"], shown["t"])
        assert np.array_equal(columns["t"][at], shown["t"])
        for name in set(columns) - {"t"}:
            wanted = columns[name][at]
            half = 0.5 * np.ptp(wanted) / LEVELS
            assert np.abs(shown[name] - wanted).max() <= half * (1 + 1e-6) + 1e-300, name
    phase = unpacked(data["telemetry"])["phase"]
    assert set(phase) == set(recovery.telemetry["phase"])
    assert np.array_equal(unpacked(data["trajectory"])["t"], scene.t)


def test_units_and_groups_say_what_a_column_is(recovery: Flight, scene: Scene) -> None:
    heads = {
        head["name"]: head
        for table in ("trajectory", "telemetry")
        for head in plain_signals(recovery, scene)[table]["columns"]
    }
    assert (heads["est_vx"]["unit"], heads["est_vx"]["group"]) == ("m/s", "Estimate")
    assert (heads["ax"]["unit"], heads["ax"]["group"]) == ("m/s²", "Acceleration")
    assert heads["fn_body"]["group"] == "Normal force"
    assert heads["pitch"]["unit"] == heads["est_yaw"]["unit"] == "deg"
    for name in ("l1", "hall1"):  # as the compression
        assert (heads[name]["unit"], heads[name]["factor"]) == ("mm", 1e3)
    assert (heads["x"]["unit"], heads["x"]["factor"]) == ("m", 1.0)
    assert heads["phase"]["unit"] == ""
    assert [name for name, head in heads.items() if head["group"] == "Others"] == []
    assert group_of("thermometer") == "Others"
    assert set(GROUPS) >= {head["group"] for head in heads.values()}


def test_telemetry_has_every_tick_near_events_and_few_far_from_them(
    recovery: Flight, scene: Scene
) -> None:
    table = signal_tables(recovery, scene)["telemetry"]
    ticks = recovery.telemetry["t"]
    whens = [event.t for event in scene.events if event.kind in ("touch", "alarm", "phase")]
    assert whens
    for when in whens:
        near = ticks[(ticks >= when - BEFORE) & (ticks <= when + AFTER)]
        assert np.isin(near, table.t).all()
    near = np.any([(ticks >= w - BEFORE) & (ticks <= w + AFTER) for w in whens], axis=0)
    assert table.every == -(-int(np.sum(~near)) // MOST_FAR) == 2
    assert len(table.t) < len(ticks)
    assert table.t[-1] == ticks[-1]


def test_angles_are_those_of_the_attitude(recovery: Flight, scene: Scene) -> None:
    table = signal_tables(recovery, scene)["trajectory"]
    for i in (0, len(table.t) // 3, -1):
        angles = [np.deg2rad(table.columns[name][i]) for name in ("roll", "pitch", "yaw")]
        q = [table.columns[f"q{part}"][i] for part in "wxyz"]
        assert abs(np.dot(attitude_from_euler(*angles), q)) == pytest.approx(1.0, abs=1e-9)


def test_odd_columns_do_no_harm(recovery: Flight, scene: Scene) -> None:
    """Constants, huge and unknown numbers, an attitude not known yet: a page without NaN."""
    n = len(recovery.telemetry["t"])
    odd = {
        "flat": np.full(n, 0.1),
        "huge": 1e308 * np.cos(np.arange(n)),
        "none": np.full(n, np.nan),
    }
    odd |= {f"pose_q{part}": np.zeros(n) for part in "wxyz"}
    flight = replace(recovery, telemetry=recovery.telemetry | odd)
    shown = unpacked(
        json.loads(json.dumps(plain_signals(flight, scene), allow_nan=False))["telemetry"]
    )
    assert set(shown["flat"]) == {0.1}
    assert set(shown["none"]) == set(shown["pose_yaw"]) == {0.0}
    assert np.isfinite(shown["huge"]).all()


def test_signals_stay_small(recovery: Flight, scene: Scene) -> None:
    """A flight of 6 s adds less than half a megabyte to its page."""
    assert len(json.dumps(plain_signals(recovery, scene))) < 0.5e6
