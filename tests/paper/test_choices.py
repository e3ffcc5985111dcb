"""What the resilience table depends on: friction, estimator, time; and how agreement is counted."""

from __future__ import annotations

import csv
import json
import runpy
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.reproduction.figures.choices import choices_figure
from springback.paper.choices import (
    CHOICES,
    EKF2,
    MEDIANS,
    OURS,
    ROBOTS,
    VERTICAL,
    ChoiceResults,
    ConditionOutcome,
    choices_sentences,
    fly_choices,
    is_plausible,
)
from springback.paper.printed import SUCCESS, SUCCESS_WORDS
from springback.results.flight import fly
from springback.scenario.presets import expand_presets
from springback.scenario.scenario import scenario_from
from springback.sensing.library import ESTIMATORS, PX4_EKF2, SOURCES
from springback.studies.run_ups import CONDITIONS, run_up_scenario
from springback.studies.trials import Condition, Scatter, fly_trials, tally, trial_tables

FAST = (0.0, 3.5)
PAPERS = {(c.friction, c.estimator): c for c in CHOICES}
NOISE = {"estimator": "px4-ekf2"}


def made_up(shares: dict[tuple[str, float, float], float], trials: int = 100) -> ChoiceResults:
    """Results of one set of choices, of shares where all others are 1."""
    results = ChoiceResults(trials)
    for robot in ROBOTS:
        for pitch, speed in CONDITIONS:
            won = round(trials * shares.get((robot, pitch, speed), 1.0))
            ends = {"recovered": won, "not_settled": trials - won}
            results.cells.append(
                ConditionOutcome(
                    robot, pitch, speed, trials, won, ends, dict.fromkeys(MEDIANS, 0.5),
                    CHOICES[0], 11.0,
                )
            )  # fmt: skip
    return results


# -- the presets ----------------------------------------------------------------------------------


def test_the_papers_flights_have_the_papers_friction() -> None:
    for robot in nonempty(ROBOTS):
        scenario = scenario_from(run_up_scenario(robot, 0.0, 2.0))
        surface = scenario.world.obstacles[0].surface
        assert (surface.friction_axes, surface.friction) == ("vertical", 0.8)
        trial = scenario_from(trial_tables(robot, 0.0, 2.0, Scatter().draw(robot, 0.0, 2.0, 0, 0)))
        assert trial.world.obstacles[0].surface.friction_axes == "vertical"


def test_the_preset_of_ekf2_has_its_published_defaults() -> None:
    kalman = PX4_EKF2.kalman
    assert (kalman.position_noise, kalman.attitude_noise) == (0.1, 0.05)
    assert (kalman.inflation, kalman.distrust_clipped) == (24.0, False)
    for name, sources in SOURCES.items():
        for path in sources:
            value: object = ESTIMATORS[name]
            for part in path.split("."):
                value = getattr(value, part)


def test_a_preset_leaves_what_it_does_not_say_to_the_user() -> None:
    tables = {"estimator": {"preset": "px4-ekf2", "kalman": {"inflation": 10.0}}}
    told = expand_presets(tables)["estimator"]["kalman"]
    assert (told["inflation"], told["position_noise"]) == (10.0, 0.1)
    assert "offset" not in told  # which the sensors know better
    with pytest.raises(InputError, match=r"unknown estimator preset 'px4-ekf'.*did you mean"):
        expand_presets({"estimator": "px4-ekf"})


def test_a_preset_flies_the_same_alone_and_among_many() -> None:
    tables = trial_tables("arq", 0.0, 2.0, Scatter().draw("arq", 0.0, 2.0, 0, 0), NOISE)
    alone, many = fly(tables, trajectory=False), fly_scenarios([tables])
    for name in ("recovery_time", "height_loss", "impact_peak_acceleration"):
        assert many.measures[name][0] == alone.measures[name]


# -- what the choices do --------------------------------------------------------------------------


def test_springs_give_and_peaks_fall_with_the_papers_friction() -> None:
    """Medians of 40, as computed independently: 8.2 mm and 194 m/s² at 2 m/s, Quad 290 m/s²."""
    trials = fly_trials([Condition(robot, 0.0, 2.0) for robot in ROBOTS], 40)
    flown = dict(zip(ROBOTS, trials, strict=True))

    def median(robot: str, name: str) -> float:
        values = sorted(t.measures[name] or 0.0 for t in flown[robot])
        found = tally(flown[robot]).medians[name]
        assert found == 0.5 * (values[19] + values[20])
        return found

    assert median("arq", "impact_arm_stroke") == pytest.approx(8.2e-3, abs=1e-4)
    assert median("arq", "impact_peak_acceleration") == pytest.approx(194.0, abs=1.5)
    assert median("quad", "impact_peak_acceleration") == pytest.approx(290.0, abs=1.5)


def test_clipping_and_trust_together_lose_quad_and_neither_alone() -> None:
    """At 3.5 m/s within 11 s; ARQ, whose springs spare the accelerometer, comes back."""
    kalman = {"position_noise": 0.1, "attitude_noise": 0.05}
    unlimited = {
        "sensors": {"imu": {"accelerometer": {"full_scale": 2000.0}}},
        "estimator": {"preset": "px4-ekf2", "kalman": {"accelerometer_range": 2000.0}},
    }
    changes = {
        "both": NOISE,
        "noise alone": {"estimator": {"kalman": kalman}},
        "trust alone": {"estimator": {"kalman": {"distrust_clipped": False}}},
        "range": unlimited,
    }
    tests = {(name, robot): Condition(robot, *FAST, changes[name])
             for name in changes for robot in ROBOTS}  # fmt: skip
    flown = fly_trials([*tests.values()], 10)
    won = {of: tally(some).successes for of, some in zip(tests, flown, strict=True)}
    assert won["both", "quad"] <= 4
    assert won["both", "arq"] >= 9
    for name in ("noise alone", "trust alone", "range"):
        assert won[name, "quad"] >= 9, name


def test_durations_change_what_counts_and_not_the_flight() -> None:
    """A trial is the same, however long it is watched: only its end moves."""
    choice = PAPERS[VERTICAL, EKF2]
    results = fly_choices(3, choices=(choice,), durations=(9.0, 14.0), conditions=(FAST,))
    for robot in nonempty(ROBOTS):
        short, long = (results.table(choice, d)[robot, *FAST] for d in (9.0, 14.0))
        assert short.successes <= long.successes
        assert short.medians["impact_peak_acceleration"] == long.medians["impact_peak_acceleration"]


# -- counting -------------------------------------------------------------------------------------


def test_ten_trials_give_a_printed_count_often_enough_or_not() -> None:
    """(1 − p)^10 ≥ 5 % for a printed 0 %, p^10 ≥ 5 % for 100 %: p up to 0.2589, from 0.7411 on."""
    assert is_plausible(0.25, 0.0)
    assert not is_plausible(0.27, 0.0)
    assert is_plausible(0.75, 1.0)
    assert not is_plausible(0.73, 1.0)


def test_agreement_counts_numbers_and_words() -> None:
    all_well = made_up({}).agreement(CHOICES[0], 11.0)
    assert (all_well.plausible, all_well.numbers) == (len(SUCCESS) - 1, len(SUCCESS))
    assert (all_well.words, all_well.phrases) == (len(SUCCESS_WORDS) - 1, len(SUCCESS_WORDS))
    printed = made_up({("quad", *FAST): 0.0, ("quad", -45.0, 2.0): 0.6})
    entire = printed.agreement(CHOICES[0], 11.0)
    assert entire.total == len(SUCCESS) + len(SUCCESS_WORDS)
    assert entire.close == len(SUCCESS)
    poor = made_up({("quad", 0.0, 2.0): 0.5}).agreement(CHOICES[0], 11.0)
    assert poor.words == all_well.words - 1


def test_the_best_set_is_the_one_that_gives_most() -> None:
    results = made_up({})
    better = [replace(cell, choice=CHOICES[1]) for cell in made_up({("quad", *FAST): 0.1}).cells]
    results.cells += better
    assert results.best().choice == CHOICES[1]
    assert CHOICES[1].name in choices_sentences(results)[-1]
    assert len(choices_figure(results).axes) == 2


# -- the command and the page ---------------------------------------------------------------------


@pytest.mark.parametrize("durations", ["9,eleven", "", "2", "9,1e3", "nan"])
def test_durations_that_cannot_be_are_refused(durations: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = CliRunner().invoke(
        cli, ["study", "choices", "--out", str(out), "--durations", durations]
    )
    assert isinstance(done.exception, InputError)
    assert "--durations: must be numbers from 4 to 60 s" in str(done.exception)
    assert not out.exists()


def test_the_study_writes_what_it_says(tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ["study", "choices", "--out", str(out), "--trials", "1", "--durations", "9", "-q"]
    done = CliRunner().invoke(cli, words)
    assert done.exit_code == 0, done.output
    data = json.loads((out / "choices.json").read_text(encoding="utf-8"))
    assert len(data["cells"]) == len(CHOICES) * len(ROBOTS) * len(CONDITIONS)
    with (out / "choices.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["successes"]) for row in rows] == [cell["successes"] for cell in data["cells"]]
    assert {path.name for path in out.iterdir()} >= {"choices.png", "hidden.png", "hidden.csv"}
    tool = runpy.run_path(str(Path(__file__).parents[2] / "tools/readme.py"))
    again = tool["read_choices"](out)
    assert [cell.successes for cell in again.cells] == [cell["successes"] for cell in data["cells"]]
    assert OURS in tool["agreement_table"](again)
