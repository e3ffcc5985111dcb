"""Flights that touch nothing, where there is something to touch, are told of with what to change."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.campaign_folders import rows
from builders.forms import box_file
from builders.plans import THROW, plan
from springback import fly
from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary
from springback.campaign.design.layout import lay_out
from springback.campaign.store import open_store
from springback.interfaces.output.no_contact import (
    idle_suction,
    missed_lines,
    pierced_lines,
    pressing_line,
    untouched_flight,
    untouched_line,
)
from springback.interfaces.reports.campaign import summary_text, write_summary

SHORT = {**THROW, "simulation": {"duration": 0.01}}


def _campaign(folder: Path, untouched: int, pressing: int = 0, **given: Any) -> Campaign:
    """A campaign of 20 flights, the first of which touch nothing, and the last still press."""
    design = lay_out(plan(samples=20, **given))
    columns = rows(design, 0, 20)
    columns["outcome"] = ["no_contact" if k < untouched else "separated" for k in range(20)]
    columns["outcome"][20 - pressing :] = ["in_contact"] * pressing
    columns["problem"] = [""] * 20
    with open_store(folder, design, resume=False) as store:
        store.add(0, 20, columns)
    return Campaign(folder)


def test_a_flight_past_its_obstacle_says_what_to_change() -> None:
    line = untouched_flight(fly(SHORT, executor="python"))
    away = fly(SHORT, executor="python").gap(0).min()
    assert line.startswith(
        f"nothing was touched (no_contact): world.obstacles[0] was nearest, {away:.3g} m away at "
        "0.01 s, the end; start nearer to an obstacle (start.pos"
    )
    assert "simulation.duration" in line
    assert "start.touch_distance" in line
    free = {**SHORT, "world": {"obstacles": THROW["world"]["obstacles"][1:]}}
    # Besides the ground there is nothing.
    assert untouched_flight(fly(free, executor="python")) == ""
    touching = {**SHORT, "start": {**THROW["start"], "touch_distance": 0.001}}
    assert untouched_flight(fly(touching, executor="python")) == ""


BALL = {
    "type": "sphere", "position": [1.0, 0.6, 1.0], "radius": 0.1, "surface": "wall",
    "motion": {"type": "free", "mass": 1.0, "velocity": [-4.0, 0.0, 1.0]},
}  # fmt: skip


def _passed_by(duration: float, **given: Any) -> Any:
    """A flight of a vehicle that falls from rest beside a ball that is thrown past it."""
    return fly({
        "vehicle": "arq", "start": {"position": [0, 0, 1]}, "simulation": {"duration": duration},
        "world": {"obstacles": [{"type": "ground", "height": -5.0, "surface": "wall"}, BALL]},
        **given,
    })  # fmt: skip


def test_a_ball_that_misses_says_how_near_it_came_and_what_to_change() -> None:
    flight = _passed_by(0.4)
    away = flight.gap(1).min(axis=1)
    at = int(away.argmin())
    assert 0 < at < len(away) - 1
    assert untouched_flight(flight) == (
        f"nothing was touched (no_contact): world.obstacles[1] was nearest, {away[at]:.3g} m away "
        f"at {flight.t[at]:.3g} s; change where it starts (world.obstacles[1].position), how it "
        "moves (world.obstacles[1].motion.velocity) or where the vehicle is (start.position), or "
        "fly longer (simulation.duration)"
    )
    assert "s, the end; fly longer (simulation.duration), or" in untouched_flight(_passed_by(0.1))


def test_the_nearest_is_named_though_another_moves() -> None:
    """Keys are named that the motion has, and that the obstacle has: a rod has no position."""
    far = {**BALL, "position": [4.0, 3.0, 1.0], "motion": {"type": "free", "mass": 1.0}}
    post = {"type": "box", "name": "post", "position": [1.1, 0, 1], "size": [0.2, 1, 4],
            "surface": "wall"}  # fmt: skip
    rod = {"type": "capsule", "name": "rod", "start": [0.7, 0, 1], "end": [0.7, 0, 2],
           "radius": 0.02, "surface": "wall", "motion": {"type": "free", "mass": 1.0}}  # fmt: skip
    flight = _passed_by(0.1, world={"obstacles": [far, post]})
    away = flight.gap(1).min()
    line = untouched_flight(flight)
    assert away < flight.gap(0).min()
    assert f"): world.obstacles[1], post, was nearest, {away:.3g} m away at" in line
    assert "start nearer to an obstacle (start.position)" in line
    assert "motion" not in line
    line = untouched_flight(_passed_by(0.1, world={"obstacles": [far, post, rod]}))
    assert "): world.obstacles[2], rod, was nearest, " in line
    assert "where it starts (world.obstacles[2].start, world.obstacles[2].end)" in line
    assert "how it moves" not in line


def test_a_wall_that_stays_beyond_its_reach_is_told_of() -> None:
    vehicle = {"preset": "arq", "propulsion": {"surface_effect": {"wall_suction": 0.09}}}
    far = {**SHORT, "vehicle": vehicle, "start": {"position": [0.0, 0.0, 1.0]}, "thrust": 0.0}
    flight = fly(far, executor="python")
    away = flight.gap(0).min()
    assert idle_suction(flight).endswith(
        "did nothing: it reaches 0.254 m (wall_reach), and world.obstacles[0], the nearest but for "
        f"the ground, came no nearer than {away:.3g} m"
    )
    assert idle_suction(fly({**far, "vehicle": "arq"}, executor="python")) == ""
    near = {**far, "start": {"position": [0.5, 0.0, 1.0]}}
    assert idle_suction(fly(near, executor="python")) == ""


def test_a_campaign_most_of_whose_flights_touch_nothing_says_so(tmp_path: Path) -> None:
    found = _campaign(tmp_path / "rows", 15)
    line = untouched_line(found)
    assert line.startswith("15 of 20 flights touched nothing (no_contact): start nearer to an obst")
    assert line in summary_text(summary(found)).splitlines()
    pytest.importorskip("matplotlib")
    write_summary(summary(found), tmp_path)
    assert "15 of 20 flights touched nothing" in (tmp_path / "summary.html").read_text("utf-8")


def test_one_with_few_such_flights_says_nothing(tmp_path: Path) -> None:
    assert untouched_line(_campaign(tmp_path / "few", 9)) == ""


def test_misses_are_told_of_beside_the_share_of_successes(tmp_path: Path) -> None:
    """Of each robot's 10 flights 2 touch nothing; of the last 3 of both, 1 and 2 press on."""
    known = _campaign(tmp_path / "rows", 4, 3, success=["separated"])
    found = summary(known)
    arq, quad = found.robots
    assert (arq.misses, arq.touches, arq.touch_successes) == (2, 8, 7)
    assert (quad.misses, quad.touches, quad.touch_successes) == (2, 8, 6)
    assert arq.success.value == 0.7
    assert arq.touch_success.value == 7 / 8
    text = summary_text(found)
    said = (
        "arq: 2 of 10 flights touched nothing (no_contact), none of which is a success; of the 8 "
    )
    assert said + "that touched something, 7 succeed\n" in text
    command = f'springback summary {known.folder} --where "not no_contact"'
    assert f"those that touch alone: {command}\n" in text
    assert "of those that touch (95 %)" in text
    assert "70.00 % (" in text
    assert "87.50 % (" in text
    data = found.as_dict()["robots"][0]
    assert data["no_contact"] == 2
    assert data["touch_success"]["value"] == 7 / 8
    write_summary(found, tmp_path)
    page = (tmp_path / "summary.html").read_text("utf-8")
    assert "of the 8 that touched something 87.50 %" in page
    assert "ARQ: 2 of 10 flights touched nothing" in page
    assert "--where &#34;not no_contact&#34;" in page
    assert "Flights that touch nothing are among them." in page
    chosen = summary_text(summary(known.where("not no_contact")))
    assert "87.50 % (" in chosen
    assert "70.00 % (" not in chosen
    assert "touched nothing" not in chosen
    assert "of those that touch" not in chosen


def test_misses_that_are_successes_by_the_rule_are_called_so(tmp_path: Path) -> None:
    """Without a rule of its own a flight without a pilot that touches nothing is a success."""
    found = summary(_campaign(tmp_path / "rows", 4))
    assert "(no_contact), all of them successes by the rule; of the 8 that" in summary_text(found)


@pytest.mark.parametrize("untouched", [0, 20])
def test_without_misses_or_without_touches_there_is_one_share(
    tmp_path: Path, untouched: int
) -> None:
    text = summary_text(summary(_campaign(tmp_path / "rows", untouched)))
    assert "of those that touch" not in text


def test_one_whose_flights_succeed_so_says_nothing(tmp_path: Path) -> None:
    """As through a window: not to touch it is what is wanted."""
    found = _campaign(tmp_path / "won", 15, success="outcome = 'no_contact'")
    assert untouched_line(found) == ""
    assert missed_lines(summary(found)) == []


def test_successes_that_end_in_contact_are_told_of(tmp_path: Path) -> None:
    found = _campaign(tmp_path / "rows", 2, 5)
    assert found.query("SELECT sum(success) FROM flights").rows == [(20,)]
    line = pressing_line(found)
    assert line.startswith("5 of 20 successes ended in contact with an obstacle (in_contact), ")
    assert line in summary_text(summary(found)).splitlines()
    write_summary(summary(found), tmp_path)
    assert "5 of 20 successes ended in contact" in (tmp_path / "summary.html").read_text("utf-8")
    assert pressing_line(_campaign(tmp_path / "none", 2)) == ""
    rule = ["separated or no_contact"]
    strict = _campaign(tmp_path / "strict", 2, 5, success=rule)
    assert strict.query("SELECT sum(success) FROM flights").rows == [(15,)]
    assert pressing_line(strict) == ""


def test_contacts_with_a_mesh_of_coarse_cells_are_counted(tmp_path: Path) -> None:
    """Forces on a sheet of 40 mm in cells of 28 mm hold to no depth: every touch counts."""
    sheet = {
        "type": "mesh", "file": box_file(0.04, 0.8, 0.8), "position": [1.0, 0.0, 1.0],
        "surface": "wall", "cell": 0.028,
    }  # fmt: skip
    vary = [{"field": "start.velocity.0", "name": "speed", "from": "1 m/s", "to": "3 m/s"}]
    design = lay_out(
        plan(
            samples=5,
            robots=["arq"],
            vary=vary,
            scenario={**SHORT, "world": {"obstacles": [sheet]}},
        )
    )
    columns = rows(design, 0, 5)
    columns["outcome"], columns["problem"] = ["separated"] * 5, [""] * 5
    columns["penetration"] = np.array([0.0, 1e-4, 0.013, 0.0, 0.002])
    with open_store(tmp_path / "rows", design, resume=False) as store:
        store.add(0, 5, columns)
    line, command = pierced_lines(Campaign(tmp_path / "rows"))
    assert line.startswith(
        "3 flights came up to 13 mm deep, and forces on the thinnest parts of world.obstacles[0], a "
        "mesh with cells of 28 mm, are wrong at any depth, as they are 40 mm thick: fewer than three"
    )
    assert "give a cell of at most 0.005 m" in line
    assert command.endswith('--where "not (penetration > 0 mm)"')
