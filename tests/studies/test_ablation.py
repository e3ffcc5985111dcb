"""One thing at a time: what a change does to both robots, and over which range a result holds."""

import math

import pytest
from click.testing import CliRunner

from builders.cases import nonempty
from springback.interfaces.cli.app import cli
from springback.interfaces.figures.ablation import ablation_figure, ranges_figure
from springback.studies.ablation import (
    RANGES,
    ROBOTS,
    VARIANTS,
    Range,
    WhyResults,
    why,
    why_sentences,
)

TESTS = ((0.0, 2.0), (-45.0, 2.0))
NAMED = {(v.cause, v.name): v for v in VARIANTS}
DEFAULT, DEAF = VARIANTS[0], NAMED["detection", "none"]
SLOW, WEAK = NAMED["rate limit", "110 deg/s"], NAMED["thrust limit", "rotors 15 % weaker"]
THRUST = next(one for one in RANGES if one.name == "most thrust over default")
NARROW = Range(THRUST.name, THRUST.unit, (0.8, 1.0, 1.5), 1.0, THRUST.changes)


@pytest.fixture(scope="module")
def results() -> WhyResults:
    return why(3, variants=(DEFAULT, DEAF, SLOW, WEAK), ranges=(NARROW,), conditions=TESTS)


def test_names_are_unique_and_defaults_are_among_the_values() -> None:
    assert len(NAMED) == len(VARIANTS)
    assert all(
        one.default in one.values and sorted(one.values) == list(one.values) for one in RANGES
    )


def test_whoever_notices_nothing_does_not_recover(results: WhyResults) -> None:
    for robot in nonempty(ROBOTS):
        default, deaf = (results.successes(v, robot) for v in (DEFAULT, DEAF))
        assert default[0.0, 2.0].successes == 3
        assert all(cell.successes == 0 for cell in deaf.values())
        assert set(deaf[0.0, 2.0].outcomes) <= {"hit_ground", "not_detected"}


def test_a_test_that_cannot_be_flown_has_no_cell(results: WhyResults) -> None:
    """At 110 deg/s no robot can arrive at −45°: that is no failure."""
    for robot in nonempty(ROBOTS):
        assert set(results.successes(SLOW, robot)) == {(0.0, 2.0)}
        unflown = {v.name: tests for v, _, tests in results.moves(robot)}
        assert unflown[SLOW.name] == [(-45.0, 2.0)]


def test_changes_reach_the_vehicle(results: WhyResults) -> None:
    """Weaker rotors come nearer to the ground after the hardest hit."""
    for robot in nonempty(ROBOTS):
        weak, default = (results.successes(v, robot)[-45.0, 2.0] for v in (WEAK, DEFAULT))
        low, usual = (cell.medians["lowest_height"] or 0.0 for cell in (weak, default))
        assert low < usual - 0.05


def test_a_range_holds_about_its_default(results: WhyResults) -> None:
    shares = [results.share(NARROW, value, "arq") for value in NARROW.values]
    assert shares[0] < 1.0
    assert shares[2] == 1.0
    if shares[1] == 1.0:
        assert results.holds(NARROW) == (1.0, 1.5)
    assert math.isnan(results.share(NARROW, 7.0, "arq"))


def test_the_luck_is_the_same_in_every_variant(results: WhyResults) -> None:
    again = why(3, variants=(DEFAULT,), ranges=(), conditions=TESTS)
    for robot in nonempty(ROBOTS):
        assert again.successes(DEFAULT, robot) == results.successes(DEFAULT, robot)


def test_it_can_be_told_and_drawn(results: WhyResults) -> None:
    told = "\n".join(why_sentences(results))
    assert "arq, all as documented: +0 deg 2 m/s 3/3" in told
    assert "rate limit, 110 deg/s" in told
    assert "run-up cannot be flown: -45 deg 2 m/s" in told
    assert len(ablation_figure(results).axes) == 2
    ranges_figure(results)


def test_the_command_refuses_what_cannot_be(tmp_path) -> None:
    for words in (["--trials", "0"], ["--seed", "-1"], ["--trials", "many"]):
        done = CliRunner().invoke(cli, ["study", "why", "--out", str(tmp_path / "out"), *words])
        assert done.exit_code == 2
        assert not (tmp_path / "out").exists()
