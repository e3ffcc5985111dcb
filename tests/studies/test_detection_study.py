"""What the study of detection promises, on a small version of it."""

import csv
import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from interfaces.legible import complaints
from springback.interfaces.cli.app import cli
from springback.interfaces.figures.detection import delay_figure, direction_figure, roc_figure
from springback.studies import detection
from springback.studies.detection import (
    IN_TIME,
    SPEEDS,
    Approach,
    DetectionResults,
    approach_tables,
    contact_position,
    detection_study,
    fly_ready_trial,
)
from springback.studies.detection_tables import (
    characterisation_rows,
    default_threshold,
    delay_rows,
    roc_rows,
    sentences,
    sizes,
)
from springback.studies.run_ups import ROBOTS, study_vehicles

LONG = "hexarotor with long arms and a heavy battery"


@pytest.fixture(scope="module")
def study() -> DetectionResults:
    return detection_study(1, free=50.0, askew=((0, 0), (20, 0), (0, -20)))


def test_every_collision_is_noticed_by_the_trigger_in_use_at_the_papers_speeds(
    study: DetectionResults,
) -> None:
    for robot, trigger in (("arq", "hall"), ("quad", "acceleration")):
        for speed in (1.0, 2.0, 3.5):
            delays = study.delays(robot, trigger, speed)
            assert all(x is not None and 0.0 < x < IN_TIME for x in delays)


def test_the_harder_the_sooner_and_arms_notice_last(study: DetectionResults) -> None:
    def median(trigger: str, speed: float) -> float:
        return float(np.median([x for x in study.delays("arq", trigger, speed) if x is not None]))

    for trigger in study.triggers("arq"):
        assert median(trigger, 3.5) < median(trigger, 1.0)
    assert median("acceleration", 2.0) < median("wrench", 2.0) < median("hall", 2.0)


def test_no_false_alarm_in_free_flight_and_no_threshold_is_near(study: DetectionResults) -> None:
    for robot in nonempty(ROBOTS):
        assert set(study.alarms[robot].values()) == {0.0}
        for trigger in study.triggers(robot):
            name = "wrench" if trigger == "momentum" else trigger
            most = max(float(one[name].signal.max()) for one in study.free[robot])
            assert most < 0.7 * default_threshold(trigger)


@pytest.mark.parametrize("robot", ROBOTS)
def test_direction_within_five_degrees_and_place_within_two_centimetres(
    study: DetectionResults, robot: str
) -> None:
    found = study.characterisation_error(robot)
    assert len(found) == 9
    # With friction along both tangents 216 of 216 hits were within 5 degrees.  With the paper's,
    # along the vertical, two of Quad's nine are put down to a wrong arm, up to 13 degrees off.
    right = [one for one in found if one.arms_right]
    assert len(right) >= (9 if robot == "arq" else 7)
    for name, truth in (("fused", "normal"), ("wrench", "impulse")):
        assert max(sizes(right, name, truth)) < 5.0
        assert max(sizes(found, name, truth)) < 13.0
    assert max(one.position for one in right) < 0.02
    assert max(one.contact_point for one in right) < 0.02


def test_curves_judge_as_the_triggers_aboard_did(study: DetectionResults) -> None:
    """At its default threshold the signal that was kept gives the delay that was flown."""
    from springback.studies.roc import delay

    for one in nonempty(study.collisions):
        for name in ("hall", "acceleration", "wrench"):
            onboard, threshold = one.delays[name], default_threshold(name)
            after = delay(one.signals[name], one.touch, threshold, 1, 0.09)
            if onboard is not None and onboard < 0.09:
                assert after == pytest.approx(onboard, abs=1.5e-3)


def test_curves_fall_with_the_threshold(study: DetectionResults) -> None:
    for robot in nonempty(ROBOTS):
        for trigger in nonempty(study.triggers(robot)):
            points = study.curve(robot, trigger)
            rates = [p.rate for p in points]
            assert points[0].probability == 1.0
            assert points[-1].probability < 1.0
            assert rates[-1] == 0.0
            assert max(rates) <= 3600.0  # one a second, the refractory time


def test_robot_and_wall_stand_as_asked() -> None:
    tables = approach_tables(Approach("arq", 2.0, 20.0, -30.0, 0), *study_vehicles(["arq"]), 0)
    (wall, _), yaw = tables["world"]["obstacles"], tables["start"]["yaw"]
    assert math.degrees(math.atan2(-wall["normal"][1], -wall["normal"][0])) == pytest.approx(
        20.0, abs=4.0
    )
    assert math.degrees(yaw) == pytest.approx(-30.0, abs=8.0)
    _, guided = fly_ready_trial(tables)
    assert guided.flown.record.first_impact.touch_speed == pytest.approx(2.0 * math.cos(math.radians(20)), abs=0.15)  # fmt: skip


def test_a_robot_of_one_s_own_flies_at_the_wall_and_is_drawn(
    study: DetectionResults, tmp_path: Path
) -> None:
    """Presets touch where the paper's robots do; a vehicle of another size, as far off."""
    own = tmp_path / "mine.toml"
    own.write_text('preset = "arq"\nhull = { radius = "0.15 m", offset = ["0.18 m", 0, 0] }\n')
    arq, quad, mine = study_vehicles(["arq", "quad", str(own)])
    assert [contact_position(one) for one in (arq, quad, mine)] == [2.5, 2.5, 2.4]
    tables = approach_tables(Approach("mine", 2.0, 0.0, 0.0, 0), mine, 0)
    assert tables["vehicle"]["hull"]["radius"] == "0.15 m"
    assert tables["reference"]["positions"][0][0] == pytest.approx(2.4 - 2.4)
    named = [one._replace(name=LONG) for one in study.vehicles if one.name == "arq"]
    flown = (
        [
            replace(one, approach=one.approach._replace(robot=LONG))
            for one in flights if one.approach.robot == "arq"
        ]
        for flights in (study.collisions, study.on_momentum)
    )  # fmt: skip
    found = DetectionResults(
        1, 0, tuple(named), *flown, free={LONG: study.free["arq"]},
        alarms={LONG: study.alarms["arq"]}, free_on_momentum={LONG: study.free_on_momentum["arq"]},
    )  # fmt: skip
    assert found.triggers(LONG) == study.triggers("arq")
    assert {row["robot"] for row in nonempty(delay_rows(found))} == {LONG}
    assert direction_figure(found).axes[0].get_title(loc="left").startswith(LONG[:9])
    for drawn in (roc_figure, delay_figure):
        assert complaints(drawn(found)) == []
    assert len(direction_figure(study).legends) == 1


def test_tables_hold_every_flight(study: DetectionResults) -> None:
    assert len(characterisation_rows(study)) == 2 * 3 * 3
    assert len(delay_rows(study)) == len(SPEEDS) * (3 * 3 + 3 * 2 + 2)
    rows = roc_rows(study)
    assert {row["robot"] for row in rows if row["trigger"] == "hall"} == {"arq"}
    assert all(0.0 <= row["probability"] <= 1.0 for row in rows)
    assert "0 false alarms in 50 s" in "\n".join(sentences(study))


def test_the_command_writes_what_it_says(
    study: DetectionResults, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(detection, "detection_study", lambda *_, **__: study)
    out = tmp_path / "out"
    done = CliRunner().invoke(cli, ["study", "detection", "--out", str(out), "--json", "--quiet"])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["false_alarms"]["quad"]["acceleration"] == 0.0
    names = {path.name for path in out.iterdir()}
    assert {"detection.json", "roc.csv", "delays.csv", "characterisation.csv"} <= names
    assert {f"{stem}.{end}" for stem in ("roc", "delay", "direction") for end in ("png", "pdf")} <= names  # fmt: skip
    with (out / "characterisation.csv").open(newline="") as file:
        assert len(list(csv.DictReader(file))) == 18
