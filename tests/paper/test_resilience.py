"""Collisions in flight: counts, intervals, marks, noise, and measures read from a flight."""

from __future__ import annotations

import csv
import json
import math
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from springback.frames import attitude_from_euler
from springback.interfaces.reproduction.report import Results, write_report
from springback.intervals import wilson
from springback.paper import resilience
from springback.paper.choices import EKF2
from springback.paper.printed import RECOVERY_PITCH, SUCCESS, SUCCESS_WORDS
from springback.paper.resilience import (
    FASTEST,
    RETURN_TOLERANCE,
    ROBOTS,
    SAMPLES,
    SLOWEST,
    ResilienceResults,
    command_extremes,
    motion,
    pitch_of,
    rate_mark,
    resilience_experiments,
)
from springback.simulation.measuring.measures import Outcome
from springback.studies.comparison import Mark
from springback.studies.run_ups import CONDITIONS
from springback.studies.trials import HOME, Scatter


@pytest.fixture(scope="module")
def results() -> ResilienceResults:
    return resilience_experiments(trials=2, repeats=1, collisions=2, compared=2, mapped=0)


# -- what was flown -------------------------------------------------------------------------------


def test_both_robots_fly_all_conditions(results: ResilienceResults) -> None:
    flown = Counter((t.robot, t.pitch, t.speed) for t in results.flown)
    assert flown == {(robot, *c): 2 for robot in ROBOTS for c in CONDITIONS}
    slower = Counter((t.robot, t.pitch, t.speed) for t in results.slower)
    assert slower == {(robot, *SLOWEST): 2 for robot in ROBOTS}
    assert all((trial.measures["touch_time"] or 0.0) > 0.0 for trial in results.flown)


def test_arq_recovers_everywhere(results: ResilienceResults) -> None:
    """Printed: 100 %; asked of the model: the same, with one set of parameters."""
    for tally in nonempty(results.tallies()):
        if tally.robot == "arq":
            assert tally.share == 1.0, tally


def test_print_has_a_number_or_words_for_every_condition() -> None:
    asked = {(robot, *condition) for robot in ROBOTS for condition in CONDITIONS}
    assert set(SUCCESS) | set(SUCCESS_WORDS) == asked
    assert not set(SUCCESS) & set(SUCCESS_WORDS)


def test_both_robots_are_dealt_the_same_luck(results: ResilienceResults) -> None:
    for condition in CONDITIONS:
        for trial in range(3):
            first, second = (Scatter().draw(robot, *condition, trial, 0) for robot in ROBOTS)
            assert first == second
    arq, quad = (results.sample(robot, 0.0, 2.0) for robot in ROBOTS)
    assert arq is not None
    assert quad is not None
    assert arq.noise_stream == quad.noise_stream
    for name in ("x", "y", "z", "vx", "vy", "vz"):
        assert arq.flight.columns[name][0] == quad.flight.columns[name][0]
    assert arq.noise_stream != Scatter().draw("arq", 0.0, 2.0, 1, 0)


def test_a_sample_is_the_first_trial_once_more(results: ResilienceResults) -> None:
    """Flown alone and with its trajectory kept, a trial ends as among the others."""
    assert [(s.robot, s.pitch, s.speed) for s in results.samples] == list(SAMPLES)
    for s in results.samples:
        first = next(
            t for t in results.flown
            if (t.robot, t.pitch, t.speed, t.number) == (s.robot, s.pitch, s.speed, 0)
        )  # fmt: skip
        assert first.outcome is s.flight.outcome
        for name in ("touch_time", "recovery_time", "nose_up", "detection_delay", "loss_contact"):
            assert first.measures[name] == s.flight.measures[name], name


def test_the_repeated_test_comes_home_every_time(results: ResilienceResults) -> None:
    for robot in nonempty(ROBOTS):
        (repeat,) = results.repeats_of(robot)
        assert (repeat.collisions, repeat.recovered, repeat.success) == (2, 2, True)
        assert len(repeat.returns) == 2
        assert max(repeat.returns) < RETURN_TOLERANCE
        assert repeat.flight is not None
        c = repeat.flight.columns
        end = math.dist([c[axis][-1] for axis in "xyz"], HOME)
        assert end == pytest.approx(repeat.returns[-1], abs=0.02)  # it hovers there since
        assert not replace(repeat, returns=repeat.returns[:1]).success
        assert not replace(repeat, returns=(0.0, 1.01 * RETURN_TOLERANCE)).success
        assert not replace(repeat, outcome=Outcome.HIT_GROUND).success


# -- ours beside print ----------------------------------------------------------------------------


def test_every_printed_number_has_its_row_and_mark(results: ResilienceResults) -> None:
    rows = {(row.robot, row.reading, row.quantity): row for row in results.rows()}
    given = [row for row in results.rows() if row.mark is Mark.GIVEN]
    assert {row.printed for row in given} == {2.75, 0.1}  # D and L_c
    beside = [row for row in results.rows() if row.reading.endswith(f"; {EKF2}")]
    assert {row.robot for row in beside} == set(ROBOTS)
    assert len(beside) == len(SUCCESS)
    assert len(rows) == len(results.rows()) == 2 * len(SUCCESS) + 4 + len(given)
    tallies = {tally.condition: tally for tally in results.tallies()}
    for of, printed in SUCCESS.items():
        row, rate = (
            rows[of[0], resilience.condition_name(*of[1:]), "success rate"],
            tallies[of].share,
        )
        assert (row.printed, row.ours) == (printed, rate)
        assert (row.mark is Mark.PREDICTED) == (abs(rate - printed) <= 0.05 * printed)
        assert row.mark in (Mark.PREDICTED, Mark.CONTRADICTED)
        assert f"{tallies[of].successes} of 2" in row.note
    where = ("arq", resilience.condition_name(*FASTEST))
    for side, printed in zip(("nose up", "nose down"), RECOVERY_PITCH, strict=True):
        flown, asked = rows[(*where, f"pitch, {side}")], rows[(*where, f"commanded pitch, {side}")]
        assert flown.printed == asked.printed == printed
        assert (flown.mark is Mark.PREDICTED) == (abs(flown.deviation or 0.0) <= 0.05)
        assert asked.mark is (Mark.FITTED if side == "nose up" else Mark.PREDICTED)


def test_ten_in_a_row_are_compared_with_ten_only(results: ResilienceResults) -> None:
    assert not [row for row in results.rows() if row.quantity == "recovered in a row"]
    more = [replace(repeat, asked=10, recovered=9) for repeat in results.repeats]
    (row,) = [
        row for row in replace(results, repeats=more).rows() if row.quantity == "recovered in a row"
    ]
    assert (row.ours, row.printed, row.mark) == (9.0, 10.0, Mark.CONTRADICTED)


def test_a_failed_trial_counts_and_is_named(results: ResilienceResults) -> None:
    flown = [
        replace(t, outcome=Outcome.HIT_GROUND) if t.robot == "quad" and t.speed == 3.5 else t
        for t in results.flown
    ]
    worse = replace(results, flown=flown)
    (tally,) = [t for t in worse.tallies() if t.condition == ("quad", *FASTEST)]
    assert (tally.share, tally.interval[0]) == (0.0, 0.0)
    assert tally.outcomes == {Outcome.HIT_GROUND.word: 2}
    (row,) = [r for r in worse.rows() if r.robot == "quad" and "; " not in r.reading]
    assert row.mark is Mark.PREDICTED  # none printed, none ours


@pytest.mark.parametrize(("won", "of"), [(10, 10), (0, 10), (7, 10), (1, 3), (95, 100)])
def test_wilson_by_its_formula(won: int, of: int) -> None:
    """(p + z²/2n ± z √(p(1-p)/n + z²/4n²)) / (1 + z²/n), z = 1.959964."""
    z, p = 1.959963984540054, won / of
    middle, half = p + z * z / (2 * of), z * math.sqrt(p * (1 - p) / of + (z / (2 * of)) ** 2)
    expected = [(middle + sign * half) / (1.0 + z * z / of) for sign in (-1.0, 1.0)]
    assert wilson(won, of) == pytest.approx(expected, abs=1e-12)


def test_a_share_printed_as_none_is_met_by_none_only() -> None:
    assert rate_mark(0.0, 0.0) is Mark.PREDICTED
    assert rate_mark(0.1, 0.0) is Mark.CONTRADICTED
    assert rate_mark(0.9, 1.0) is Mark.CONTRADICTED
    assert rate_mark(1.0, 1.0) is Mark.PREDICTED


# -- what is read from a flight -------------------------------------------------------------------


@pytest.mark.parametrize("degrees", [-120.0, -66.0, 0.0, 49.0, 100.0])
def test_pitch_is_positive_nose_down_and_goes_past_upright(degrees: float) -> None:
    """As seen from the side: turned by a yaw, e_z leans along X by its cosine."""
    for yaw in (0.0, 0.7):
        pitch = math.radians(degrees)
        q = attitude_from_euler(0.0, pitch, yaw)
        seen = float(pitch_of(*(np.array(part) for part in q)))
        expected = math.atan2(math.sin(pitch) * math.cos(yaw), math.cos(pitch))
        assert seen == pytest.approx(expected, abs=1e-12)


def test_the_way_back_asks_for_the_pitch_of_its_quintic(results: ResilienceResults) -> None:
    """a(s) = (D (60s - 180s² + 120s³) + v₀T (-36s + 96s² - 60s³)) / T², tan(pitch) = a/g.

    The position loop samples it a hundred times a second, and speed and direction are estimated.
    """
    for sample in nonempty(results.samples):
        v, s = sample.flight.measures["touch_speed"] or 0.0, np.linspace(0.0, 1.0, 1001)
        duration = 0.19 * v
        a = -0.1 * (60 * s - 180 * s**2 + 120 * s**3)
        a += v * duration * (-36 * s + 96 * s**2 - 60 * s**3)
        pitch = np.degrees(np.arctan(a / duration**2 / 9.81))
        assert command_extremes(sample.flight) == pytest.approx((pitch.min(), pitch.max()), abs=1.0)


def test_time_counts_from_first_touch(results: ResilienceResults) -> None:
    for sample in nonempty(results.samples):
        curves = motion(sample.flight)
        before, after = (np.interp(t, curves["t"], curves["vx"]) for t in (-0.005, 0.04))
        assert before == pytest.approx(sample.speed, rel=0.05)
        assert after < 0.0
        assert np.interp(0.0, curves["t"], curves["pitch"]) == pytest.approx(0.0, abs=0.05)
        assert np.interp(-0.1, curves["t"], curves["asked_vx"]) == pytest.approx(
            sample.speed, rel=0.05
        )


# -- the report -----------------------------------------------------------------------------------


def test_the_report_holds_the_numbers(results: ResilienceResults, tmp_path: Path) -> None:
    written = write_report(Results(resilience=results), tmp_path, about={})
    figures = {path.stem for path in written if path.parent.name == "figures"}
    assert figures == {
        "overview", "resilience", "collision", "orientation", "robots", "orientations",
        "repeated", "choices",
    }  # fmt: skip
    data = json.loads((tmp_path / "comparison.json").read_text(encoding="utf-8"))
    assert [row["ours"] for row in data["rows"]] == [row.ours for row in results.rows()]
    found = data["resilience"]
    assert len(found["trials"]) == len(results.flown) + len(results.slower)
    assert [cell["successes"] for cell in found["success"]] == [
        tally.successes for tally in results.tallies()
    ]
    with (tmp_path / "trials.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["outcome"] for row in rows] == [t["outcome"] for t in found["trials"]]
    assert [float(row["nose_up"]) for row in rows] == [t["nose_up"] for t in found["trials"]]
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "study why" in page  # where Quad's printed failures are asked after
    assert page.count("(2 of 2)") == sum(tally.successes == 2 for tally in results.tallies())


def test_what_was_not_flown_is_left_out(results: ResilienceResults, tmp_path: Path) -> None:
    bare = replace(results, samples=[], repeats=[], slower=[], choices=None)
    write_report(Results(resilience=bare), tmp_path, about={})
    assert {path.stem for path in (tmp_path / "figures").iterdir()} == {"overview", "resilience"}
    empty = ResilienceResults(0)
    assert write_report(Results(resilience=empty), tmp_path / "none", about={})
