"""Wall hits by pitch: their draws, where they begin, and how shares are counted."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import Rows
from springback.scenario.scenario import scenario_from
from springback.studies.recordings.command import run_study
from springback.studies.recordings.recovery_shares import (
    CASES,
    CLEARANCE,
    EDGES,
    HEIGHT,
    PITCH,
    PRINTED,
    ROLL,
    SPEEDS,
    YAW,
    WallStart,
    draw_hits,
    hit_tables,
    in_order,
    share_lines,
    shares_of,
)
from springback.vehicle.library import VEHICLES


def test_hits_are_even_within_their_bounds_and_each_has_its_own_draw() -> None:
    hits = draw_hits(400)
    assert draw_hits(3) == hits[:3]
    speeds = np.array([hit.speed for hit in hits])
    assert SPEEDS[0] <= speeds.min() < 0.6
    assert 2.4 < speeds.max() <= SPEEDS[1]
    for name, bound in (("roll", ROLL), ("pitch", PITCH), ("yaw", YAW)):
        angles = np.degrees([getattr(hit, name) for hit in hits])
        assert bound * 0.95 < np.abs(angles).max() <= bound
        assert abs(angles.mean()) < 0.15 * bound


@pytest.mark.parametrize(
    "hit",
    [WallStart(1.0, 0.0, 0.7, 0.0), WallStart(2.0, 0.2, -0.6, 0.5), WallStart(0.5, 0.0, 0.0, 0.7)],
)
def test_bumpers_begin_just_before_the_wall(hit: WallStart) -> None:
    """The rings as points, turned by hand: none is in the wall, one is at the clearance."""
    tables = hit_tables(hit, 7)
    scenario = scenario_from(tables)
    cr, sr, cp, sp, cy, sy = (
        f(x) for x in (hit.roll, hit.pitch, hit.yaw) for f in (math.cos, math.sin)
    )
    turn_x = np.array([cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr])  # of world x
    angle = np.linspace(0.0, 2.0 * math.pi, 2001)
    reached = []
    for hull in scenario.vehicle.hulls:
        at = scenario.vehicle.arms.directions[hull.on - 1]
        end = 0.192 * np.array([math.cos(at), math.sin(at), 0.0]) + [0.0, 0.0, 0.0245]
        axis = np.array(hull.axis) / np.linalg.norm(hull.axis)
        u = np.cross(axis, [0.0, 0.0, 1.0])
        u /= np.linalg.norm(u)
        rim = end + 0.125 * (
            np.outer(np.cos(angle), u) + np.outer(np.sin(angle), np.cross(axis, u))
        )
        reached.append(float((rim @ turn_x).max()))
    distance = tables["world"]["obstacles"][0]["distance"]
    assert distance - max(reached) == pytest.approx(CLEARANCE, abs=1e-6)
    start = scenario.start_state()
    assert (start.velocity.x, start.position.z) == (hit.speed, HEIGHT)


def test_cases_differ_in_what_they_say_alone() -> None:
    """The first is the preset with its default trigger; others change trigger, rotors or both."""
    hit = WallStart(1.0, 0.0, 0.7, 0.0)
    read = {case.name: scenario_from(hit_tables(hit, 7, case)) for case in CASES}
    assert len(read) == len(CASES)
    first = read["default trigger, rotors turn on"]
    assert first.vehicle == VEHICLES["navi"].vehicle
    assert first == scenario_from(hit_tables(hit, 7))
    for name, scenario in nonempty(read.items()):
        assert scenario.recovery is not None
        assert scenario.vehicle.propulsion is not None
        stop = scenario.vehicle.propulsion.stop
        threshold = scenario.recovery.detection.acceleration.threshold
        assert threshold == pytest.approx(4.905 if "0.5 g" in name else 20.0)
        assert (stop is not None) == ("stop" in name)
        assert (stop is not None and stop.others_after == 0.04) == name.startswith("all")
        assert (scenario.start, scenario.world) == (first.start, first.world)


def test_positive_pitch_leans_into_the_wall() -> None:
    """The makers' simulator has the other sign: their worst bin is the last one here."""
    up = scenario_from(hit_tables(WallStart(1.0, 0.0, 0.6, 0.0), 0)).start.attitude()
    assert 2.0 * (up.x * up.z + up.w * up.y) == pytest.approx(math.sin(0.6))  # R e_z towards it
    assert min(PRINTED) == PRINTED[-1]
    assert EDGES[-1] == PITCH


def test_shares_are_counted_by_pitch() -> None:
    middles = [math.radians(0.5 * (a + b)) for a, b in pairwise(EDGES)]
    hits = [WallStart(1.0, 0.0, pitch, 0.0) for pitch in middles for _ in range(10)]
    good = [10, 10, 9, 10, 8, 5]
    outcomes = ["recovered" if k < count else "hit_ground" for count in good for k in range(10)]
    loss = np.arange(60.0)
    rows = Rows(outcomes, {"height_loss": loss}, [""] * 60, [""] * 60, [""] * 60)
    shares = shares_of(hits, rows)
    assert [one.recovered.value for one in shares] == [1.0, 1.0, 0.9, 1.0, 0.8, 0.5]
    assert [one.flights for one in shares] == [10] * 6
    assert shares[5].height_loss == 52.0  # of the five that recovered
    assert in_order(shares)
    turned = shares[5]._replace(recovered=shares[0].recovered)
    assert not in_order([*shares[:5], turned])


def test_a_folder_is_not_asked_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_study(share_lines, [str(tmp_path)]) == 2
    assert capsys.readouterr().err == (
        f"error: {tmp_path}: this study reads no recordings; name nothing\n"
    )
