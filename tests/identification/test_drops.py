"""Drop tests: the first touch fitted, from a known height; replayed; and told by the log."""

from __future__ import annotations

import copy
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.identification.fits import fields_of_plan
from springback.identification.observations.drop_start import fall_of
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import impact_window
from springback.identification.replays.errors import channel_errors, error_rows
from springback.identification.replays.replay import replay
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import fit_impact
from springback.logs.overview import overview
from springback.logs.recording import SPECIFIC_FORCE, Recording
from springback.logs.segments import find_impacts
from springback.logs.writing.flight_recording import flight_recording
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from

STIFFNESS, SPRING = "world.obstacles.0.surface.stiffness", "vehicle.arms.stiffness"
#: Gravity of a scenario [m/s²].
G = 9.81
TRUE = {STIFFNESS: 2e5, SPRING: 5000.0}
#: One arm first onto the ground, which is 0.757 m below it.
DROP: dict[str, Any] = {
    "vehicle": "arq",
    "thrust": 0.0,
    "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
    "start": {"position": [0.0, 0.0, 1.0], "roll": "45 deg", "pitch": "45 deg"},
    "simulation": {"duration": 1.2},
    "seed": 2,
    "sensors": {"imu": {"rate": "1 kHz", "accelerometer": {"full_scale": "200 gn"}}},
}
RAIL = DROP | {
    "start": {"position": [0.0, 0.0, 0.8]},
    "model": {"slider": [0, 0, 1]},
}


def recorded(tables: dict[str, Any]) -> Recording:
    return flight_recording(fly(scenario_from(copy.deepcopy(tables))), Path("drop"))


def felt(log: Recording) -> Recording:
    """The accelerometer alone."""
    return replace(log, channels=tuple(log.of(SPECIFIC_FORCE)))


@pytest.fixture(scope="module")
def log() -> Recording:
    return recorded(DROP)


def problem_of(
    tables: dict[str, Any], log: Recording, free: dict[str, str], **plan: Any
) -> ImpactProblem:
    known = {
        "vehicle.body.mass": "exact", "vehicle.arms.mass": "exact",
        "vehicle.arms.directions": "exact", "vehicle.body.inertia": "exact",
    }  # fmt: skip
    given = {"scenario": "drop.toml", "experiment": "drop", "free": free, "known": known}
    ready = FitPlan.model_validate(given | plan)
    scenario = scenario_from(copy.deepcopy(tables))
    [impact] = [one for one in find_impacts([log], drops=True) if not one.refused]
    readings = impact_window(ready, scenario, [log], impact)
    return ImpactProblem(ready, scenario, tables, fields_of_plan(ready, scenario), readings)


def test_the_first_touch_of_a_drop_counts_and_its_bounces_do_not(log: Recording) -> None:
    first, *later = find_impacts([log], drops=True)
    fall = fall_of(scenario_from(copy.deepcopy(DROP)))
    assert fall.duration == pytest.approx(np.sqrt(2.0 * fall.height / G))
    assert fall.speed == pytest.approx(np.sqrt(2.0 * fall.height * G))
    assert first.refused == ""
    assert first.touch == pytest.approx(fall.duration, abs=0.003)
    assert first.following == later[0].touch
    for one in nonempty(later):
        assert one.refused == (
            f"a bounce of the impact at {first.touch:.3f} s: a drop's first touch is fitted"
        )
    touches = [one.touch for one in (first, *later)]
    assert np.diff(touches).min() > 0.02
    window = problem_of(DROP, log, {SPRING: "factor 3"}).impact
    assert window.until - window.touch < later[0].touch - first.touch


def test_the_jerk_of_a_release_does_not_make_a_bounce_of_the_touch(log: Recording) -> None:
    [force] = log.of(SPECIFIC_FORCE)
    jerk = np.where(np.abs(force.times - 0.05) < 0.003, 30.0, 0.0)
    jerked = replace(force, values=force.values + jerk[:, None] * [0.0, 0.0, 1.0])
    first, second, *_ = find_impacts([replace(log, channels=(jerked,))], drops=True)
    assert first.touch == pytest.approx(0.05, abs=0.005)
    assert second.touch == pytest.approx(0.39, abs=0.01)
    assert second.refused == ""


def test_the_accelerometer_alone_and_a_known_height_tell_the_truth(log: Recording) -> None:
    """With an attitude of rest, and the height to 5 mm."""
    start = {"height": "5 mm", "attitude": "1 deg", "angular_velocity": "0.05 rad/s"}
    problem = problem_of(DROP, felt(log), {STIFFNESS: "factor 3", SPRING: "factor 3"}, start=start)
    latents = {one.name: one.deviation for one in problem.unknowns if one.role == "latent"}
    fall = fall_of(problem.scenario)
    assert latents["start velocity z"] == pytest.approx(G * 0.005 / fall.speed)
    assert latents["start attitude x"] == pytest.approx(np.radians(1.0))  # not three times
    found = fit_impact(problem, starts=2, seed=0)
    for name, true in TRUE.items():
        profile = found.profiles[name]
        unknown = problem.unknowns[problem.place[name]]
        assert unknown.value(profile.low) < true < unknown.value(profile.high)
        assert found.deviation(name) < 0.3


def test_a_drop_on_a_rail_falls_along_it() -> None:
    log = felt(recorded(RAIL))
    problem = problem_of(RAIL, log, {STIFFNESS: "factor 3"})
    fall = fall_of(problem.scenario)
    assert fall.acceleration == pytest.approx([0.0, 0.0, -G])
    start = problem.impact.start
    left = fall.duration - problem.impact.touch
    assert start.velocity == pytest.approx([0.0, 0.0, -G * left], abs=1e-6)
    found = fit_impact(problem, starts=2, seed=0)
    assert problem.unknowns[0].value(found.point[0]) == pytest.approx(2e5, rel=0.05)


def test_a_height_that_the_fall_in_the_log_contradicts_is_refused(log: Recording) -> None:
    low = DROP | {"start": DROP["start"] | {"position": [0.0, 0.0, 0.7]}}
    said = r"drop: accelerometer: falls for 0\.39\d s .* but 0\.30\d s from the scenario's start"
    with pytest.raises(InputError, match=said):
        problem_of(low, felt(log), {SPRING: "factor 3"})


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"thrust": 2.0}, r"^thrust: must be 0 .* \(got 2\.0\)$"),
        (
            {"world": {"obstacles": [{"type": "wall", "distance": 3.0, "surface": "wall"}]}},
            "^start.position: straight",
        ),
        ({"model": {"slider": [1, 0, 0]}}, "^model.slider: is level"),
    ],
)
def test_a_scenario_that_drops_onto_nothing_is_refused(change: Any, said: str) -> None:
    tables = DROP | {"start": {"position": [0.0, 0.0, 1.0]}} | change
    with pytest.raises(InputError, match=said):
        fall_of(scenario_from(copy.deepcopy(tables)))


def test_a_log_of_a_drop_is_no_wrong_gravity_and_names_the_experiment(log: Recording) -> None:
    found = overview([log])
    assert all(one.passed for one in found.findings)
    assert found.verdict.endswith(
        'a landing; if this is a drop test, experiment = "drop" in a plan takes it'
    )
    level = recorded(DROP | {"start": {"position": [0.0, 0.0, 1.0]}})
    assert find_impacts([level]) == []
    assert overview([level]).verdict.startswith("no impact from the side, but from above; if")


@pytest.mark.parametrize("alone", [False, True])
def test_a_drop_is_replayed(log: Recording, alone: bool) -> None:
    scenario = scenario_from(copy.deepcopy(DROP))
    flown = replay(scenario, DROP, [felt(log) if alone else log])
    rows = error_rows(flown, channel_errors(flown))
    [peak] = [row for row in rows if row.what == "peak specific force"]
    assert abs(peak.error) < 0.02 * 174.0
    assert not peak.is_beyond
    assert "a drop: impacts from above count, and bounces do not" in flown.told
