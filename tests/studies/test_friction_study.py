"""What friction leaves of the springs, and what clipping hides."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import springback
from builders.cases import nonempty
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.figures.friction import clipping_figure, friction_figure
from springback.studies.clipping import KINDS, clipping_losses
from springback.studies.friction import (
    PRINTED_FRICTION,
    FrictionResults,
    friction_sentences,
    friction_study,
    impact_tables,
)
from springback.studies.run_ups import study_vehicles

OWN = 'name = "mine"\npreset = "arq"\nhull.offset = [0.1, 0, 0]\nhull.radius = "0.2 m"\n'
FRICTIONS, YAWS = (0.0, 0.4, 0.8), (0.0, 3.0, 10.0, 45.0)


@pytest.fixture(scope="module")
def results() -> FrictionResults:
    return friction_study(0, frictions=FRICTIONS, yaws=YAWS)


def test_friction_along_the_vertical_leaves_the_springs_alone(results: FrictionResults) -> None:
    """At level attitude a cage does not slip along the vertical until it is hit."""
    _, _, strokes = results.grid("arq", "vertical", "stroke")
    assert np.ptp(strokes, axis=0) == pytest.approx(np.zeros(len(YAWS)), abs=1e-4)


def test_friction_along_both_tangents_holds_arms_at_45_degrees(results: FrictionResults) -> None:
    """Along the arm f (1 − μ)/√2 is left of f/√2: the stroke falls with μ, the peak rises."""
    frictions, _, strokes = results.grid("arq", "both", "stroke")
    _, _, peaks = results.grid("arq", "both", "peak")
    assert all(np.diff(strokes[:, 0]) < 0.0)
    assert all(np.diff(peaks[:, 0]) > 0.0)
    held = strokes[frictions.index(PRINTED_FRICTION), 0]
    assert held < 0.3 * strokes[0, 0]
    assert results.at("arq", "both", 0.0, 0.0).stroke == pytest.approx(
        results.at("arq", "vertical", 0.0, 0.0).stroke, rel=1e-6
    )


def test_an_arm_straight_ahead_needs_no_slip(results: FrictionResults) -> None:
    ahead = [results.at("arq", axes, mu, 45.0).stroke for axes in ("vertical", "both")
             for mu in FRICTIONS]  # fmt: skip
    assert np.ptp(ahead) < 2e-4
    assert min(ahead) > 6.0 * results.at("arq", "both", PRINTED_FRICTION, 0.0).stroke


def test_a_few_degrees_of_yaw_free_the_springs(results: FrictionResults) -> None:
    one_cage = results.at("arq", "both", PRINTED_FRICTION, 10.0)
    two_cages = results.at("arq", "both", PRINTED_FRICTION, 0.0)
    assert one_cage.stroke > 5.0 * two_cages.stroke
    assert one_cage.peak < 0.5 * two_cages.peak


def test_quad_gives_nothing(results: FrictionResults) -> None:
    for axes in ("vertical", "both"):
        assert np.all(results.grid("quad", axes, "stroke")[2] == 0.0)
        assert np.all(results.grid("quad", axes, "arm_share")[2] == 0.0)


def test_an_own_vehicle_touches_with_its_foremost_point(tmp_path: Path) -> None:
    """Its hull reaches 0.3 m ahead, further than the cages of its arms, but less behind."""
    (tmp_path / "mine.toml").write_text(OWN)
    own, arq = study_vehicles([str(tmp_path / "mine.toml"), "arq"])
    assert (own.name, own.reach(), own.reach(math.pi)) == ("mine", 0.1 + 0.2, arq.reach(math.pi))
    tables = impact_tables(own, "both", 0.8, 0.0, 2.0)
    flight = springback.fly(tables)
    assert flight.measures["touch_time"] == pytest.approx(0.03 / 2.0, rel=0.01)


def test_results_are_those_of_any_robots(results: FrictionResults) -> None:
    """Drawn and said for the robots flown, in their order: those whose arms slide, if any."""
    mine = FrictionResults([i._replace(robot="mine") for i in results.impacts if i.robot == "arq"])
    mine.impacts += [i for i in results.impacts if i.robot == "quad"]
    assert (mine.robots, mine.sprung) == (("mine", "quad"), ("mine",))
    assert all(line.startswith("mine, mu 0.8") for line in nonempty(friction_sentences(mine)))
    assert friction_figure(mine).axes[0].get_title(loc="left").startswith("mine")
    rigid = FrictionResults([i for i in results.impacts if i.robot == "quad"])
    assert rigid.sprung == ("quad",)
    assert len(friction_figure(rigid).axes) == 4


@pytest.mark.parametrize("command", ["friction", "detection"])
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["quadd"], "unknown vehicle preset 'quadd'"),
        (["none.toml"], "none.toml: cannot be read"),
        (["heavy.toml"], "heavy.toml: vehicle.body.mass: must be"),
        (["arq-lumped"], "arq-lumped: vehicle.propulsion: is missing, so it cannot fly"),
        (["arq", "arq.toml"], "arq.toml has the name of another vehicle, 'arq'"),
    ],
)
def test_vehicles_that_cannot_fly_are_refused_in_a_line(
    command: str, words: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "arq.toml").write_text('preset = "quad"\n')
    (tmp_path / "heavy.toml").write_text('preset = "quad"\nbody.mass = -1\n')
    options = [part for word in words for part in ("--robot", word)]
    done = CliRunner().invoke(cli, ["study", command, *options, "--out", "out", "--quiet"])
    assert isinstance(done.exception, InputError)
    [line] = done.exception.problems
    assert line.startswith("--robot: ")
    assert said in line


def test_it_can_be_told_and_drawn(results: FrictionResults) -> None:
    assert len(friction_sentences(results)) == 3
    assert len(friction_figure(results).axes) == 4


def test_clipping_hides_more_the_harder_the_impact() -> None:
    """Quad most, ARQ with its springs free least; nothing where the range is never reached."""
    found = clipping_losses((1.0, 2.0, 3.5))
    by = {(one.robot, one.axes, one.speed): one for one in found}
    for robot, axes in KINDS:
        hidden = [by[robot, axes, speed].velocity for speed in (1.0, 2.0, 3.5)]
        assert hidden[0] == 0.0
        assert hidden[1] < hidden[2] < by[robot, axes, 3.5].change
    fast = [by[robot, axes, 3.5].velocity for robot, axes in KINDS]
    assert fast == sorted(fast, reverse=True)
    assert fast[0] == pytest.approx(2.61, abs=0.02)  # as computed independently
    assert fast[2] == pytest.approx(1.73, abs=0.02)
    assert len(clipping_figure(found).axes) == 1
    assert all(one.velocity == 0.0 for one in clipping_losses((3.5,), full_scale=2000.0))
