"""Fits of impacts: truth recovered, widths as designed, mistakes said."""

import copy
import json
import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from identification.rigs import (
    DAMPER,
    EXACT,
    LOSS,
    SPRING,
    STIFFNESS,
    TRUE,
    problem_of,
    recorded,
    rig,
)
from springback.errors import InputError
from springback.identification.design.coverage import coverage_of, fitted_set
from springback.identification.fits import FitResult, fields_of_plan, fit, result_of
from springback.identification.report.assumptions import assumptions
from springback.identification.results_files import (
    as_data,
    draws,
    overlay_text,
)
from springback.identification.settings import FitPlan, read_fit_plan
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.identification.wording import SHARES
from springback.interfaces.cli.app import cli
from springback.interfaces.cli.identify.fitting import fit_text
from springback.scenario.overrides import overlay_words
from springback.scenario.scenario import scenario_from

EXAMPLES = Path(__file__).parents[2] / "examples"
QUAD = {STIFFNESS: "factor 4", LOSS: "factor 4"}
ARQ = QUAD | {SPRING: "factor 4", DAMPER: "factor 4"}


def fitted(
    free: dict[str, str], *, corrupt=None, starts: int = 4, vehicle="quad", speed=1.85, **plan
):
    tables = rig(vehicle, speed)
    recording = recorded(tables)
    problem = problem_of(tables, recording if corrupt is None else corrupt(recording), free, **plan)
    return fit_impact(problem, starts=starts, seed=0)


def result(found: ImpactFit) -> FitResult:
    return result_of(found.problem.plan, [found])


@pytest.fixture(scope="module")
def quad() -> FitResult:
    return result(fitted(QUAD, starts=8))


@pytest.fixture(scope="module")
def arq() -> FitResult:
    return result(fitted(ARQ, vehicle="arq", starts=8))


@pytest.mark.parametrize("name", ["quad", "arq"])
def test_truth_is_within_narrow_intervals(name: str, request: pytest.FixtureRequest) -> None:
    """Widths of the design: Quad 0.6 and 0.35 %, ARQ 2.2 % each, one standard error."""
    found: FitResult = request.getfixturevalue(name)
    for one in found.estimates:
        true = TRUE[one.unknown.name]
        error = 0.25 * np.log(one.high / one.low)
        assert abs(np.log(one.value / true)) < 3.0 * error
        assert one.verdict == "learned"
        most = {STIFFNESS: 0.006, LOSS: 0.0035} if name == "quad" else {}
        assert error < most.get(one.unknown.name, 0.022)
    assert not any(one.is_misfit for one in found.misfits)
    assert found.fits[0].agreeing >= 4
    assert found.is_informative


def test_profiles_rise_by_what_the_ends_say(arq: FitResult) -> None:
    profiles = arq.fits[0].profiles
    assert len(profiles) == 4
    for name, profile in profiles.items():
        at = arq.fits[0].point[arq.fits[0].problem.place[name]]
        assert profile.low < at < profile.high
        rises = [rise for u, rise in profile.points if u != at]
        assert min(rises) > 0.0
        assert any(abs(np.sqrt(rise / 3.8415) - 1.0) < 0.02 for rise in rises)


def test_a_clip_that_is_ignored_ruins_what_one_modelled_does_not() -> None:
    """At 3.5 m/s the accelerometer of ARQ clips."""
    ignored = {"sensors": {"accelerometer": {"full_scale": 1e4}}}
    kept = result(fitted(ARQ, vehicle="arq", speed=3.5))
    ruined = result(fitted(ARQ, vehicle="arq", speed=3.5, **ignored))
    errors = [abs(one.value / TRUE[one.unknown.name] - 1.0) for one in ruined.estimates]
    assert max(errors) > 0.3
    assert any(one.is_misfit for one in ruined.misfits)
    assert max(abs(one.value / TRUE[one.unknown.name] - 1.0) for one in kept.estimates) < 0.08
    assert not any(one.is_misfit for one in kept.misfits)


def test_errors_of_the_model_are_said(arq: FitResult) -> None:
    from dataclasses import replace

    from springback.logs.recording import SPECIFIC_FORCE

    def larger(recording):
        channels = [
            replace(one, values=1.03 * one.values) if one.quantity == SPECIFIC_FORCE else one
            for one in recording.channels
        ]
        return replace(recording, channels=tuple(channels))

    found = result(fitted(ARQ, vehicle="arq", corrupt=larger))
    assert any(text.startswith("misfit") for text in found.sentences)
    assert not any(text.startswith("misfit") for text in arq.sentences)


def test_what_a_camera_alone_cannot_tell_is_not_learned() -> None:
    """A track at 200 Hz tells the loss of a 31 ms contact, but hardly its stiffness."""
    from dataclasses import replace

    def track_only(recording):
        kept = [one for one in recording.channels if one.clock != "log"]
        return replace(recording, channels=tuple(kept))

    found = result(fitted({STIFFNESS: "factor 1.4", LOSS: "factor 4"}, corrupt=track_only))
    verdicts = {one.unknown.name: one.verdict for one in found.estimates}
    assert verdicts[LOSS] == "learned"
    assert verdicts[STIFFNESS] != "learned"
    [why] = [text for text in found.sentences if text.startswith(STIFFNESS)]
    assert "no accelerometer" in why
    assert why.endswith("a track of 200 Hz does not show the contact itself")  # not "of 0 ms"


def test_stiffness_inherits_the_uncertainty_of_mass() -> None:
    narrow = result(fitted(QUAD))
    wide = result(fitted(QUAD, known={"vehicle.body.mass": "+- 2 %"}))
    error = {one.unknown.name: 0.25 * np.log(one.high / one.low) for one in wide.estimates}
    assert error[STIFFNESS] == pytest.approx(0.02, rel=0.15)  # k / m is what is seen
    assert error[LOSS] < 0.005  # the loss is not
    [said] = [text for text in wide.sentences if "vehicle.body.mass was assumed" in text]
    named, total = (
        re.fullmatch(
            rf".* not measured: its share of the variance is (\d+) % of that of {STIFFNESS}", said
        ),
        error[STIFFNESS] ** 2,
    )
    assert named
    # Known exactly, it would leave the variance that the data alone have.
    alone = {one.unknown.name: 0.25 * np.log(one.high / one.low) for one in narrow.estimates}
    left = 1.0 - float(named[1]) / 100.0
    assert left * total == pytest.approx(alone[STIFFNESS] ** 2, abs=0.01 * total)
    assert SHARES in wide.sentences
    assert SHARES not in narrow.sentences
    assert not any("was assumed" in text for text in narrow.sentences)
    over_mass = (
        f"of {STIFFNESS} only the ratio to mass is measured: each contains the uncertainty of mass"
    )
    assert over_mass in wide.sentences
    told = result(fitted(QUAD, known={"vehicle.body.mass": "+- 0.02 %"}))  # the data's is more
    assert any("vehicle.body.mass was assumed" in text for text in told.sentences)
    assert not any("ratio to mass" in text for text in told.sentences)


def test_intervals_of_synthetic_sets_cover() -> None:
    """Few, for time: studies/identification.py has 200 a row."""
    tables = rig("quad")
    plan = FitPlan.model_validate(
        {"scenario": "rig.toml", "free": QUAD, "known": EXACT, "starts": 2}
    )
    fields = fields_of_plan(plan, scenario_from(copy.deepcopy(tables)))
    found = coverage_of(fields, [fitted_set(plan, tables, fields, seed) for seed in range(12)])
    assert not found.failed
    for one in found.fields:
        assert one.covered >= 9  # of 12 at 95 %: less has a probability of 2e-4
        assert one.spread < 2.0


def test_files_of_a_fit_say_what_was_found(arq: FitResult, tmp_path: Path) -> None:
    path = tmp_path / "identified.toml"
    path.write_text(overlay_text(arq), encoding="utf-8")
    assert f'# N/m^1.5; learned\n"{STIFFNESS}" = ' in path.read_text(encoding="utf-8")
    words = dict(word.split("=") for word in overlay_words(path))
    for one in arq.estimates:
        assert float(words[one.unknown.name]) == one.value
    told = draws(arq)
    assert told.shape == (1000, 4)
    for k, one in enumerate(arq.estimates):
        assert np.median(told[:, k]) == pytest.approx(one.value, rel=0.01)
    json.dumps(as_data(arq), allow_nan=False)
    again = json.loads(json.dumps(as_data(arq)))
    assert [entry["verdict"] for entry in again["estimates"]] == ["learned"] * 4


def test_the_example_tells_the_numbers_that_its_log_was_made_with() -> None:
    plan = read_fit_plan(EXAMPLES / "fit.toml", ["starts=2"])
    found = fit(plan, EXAMPLES)
    true = TRUE | {"world.obstacles.0.surface.friction": 0.8}
    assert len(found.estimates) == 5 + 2 + 4 + 3  # free, masses, directions, moments
    for one in found.estimates:
        if one.unknown.role == "free":
            assert one.low <= true[one.unknown.name] <= one.high
            assert one.high / one.low < 1.1


def test_the_terminal_lists_what_was_assumed_exactly(arq: FitResult) -> None:
    """The exponent is part of the law; a length moves a result; most numbers move none."""
    text = fit_text(arq, None, assumptions(arq.fits))
    told = text.split("assumed to be exact:\n")[1]
    assert "world.obstacles.0.surface.exponent = 1.5: another value makes another law" in told
    assert "moving no result by a quarter of its uncertainty: " in told
    assert STIFFNESS not in told.split(": another")[0]


def test_a_mistake_in_a_plan_is_named_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "fit.toml"
    lines = ['scenario = "arq_wall.toml"', "[free]", '"vehicle.arms.dampin" = "factor 3"']
    path.write_text("\n".join(lines))
    (tmp_path / "arq_wall.toml").write_bytes((EXAMPLES / "arq_wall.toml").read_bytes())
    done = CliRunner().invoke(cli, ["identify", "plan", str(path)])
    assert isinstance(done.exception, InputError)
    [line] = done.exception.problems
    assert line.startswith(f"{path}:3: free.vehicle.arms.dampin: unknown parameter")
    with pytest.raises(InputError, match=r"accelerometer\.bandwidth: is called low_pass in a plan"):
        read_fit_plan(path, ['sensors.accelerometer.bandwidth="30 Hz"'])


def test_an_order_of_arms_that_is_plainly_wrong_is_refused_with_the_right_one(
    tmp_path: Path,
) -> None:
    for name in ("fit.toml", "arq_wall.toml", "impact_log.toml", "impact_log.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    mapping = (tmp_path / "impact_log.toml").read_text()
    names = [f'"arm_lengths.{j}"' for j in (1, 2, 3, 4)]
    turned = mapping.replace(", ".join(names), ", ".join([*names[1:], names[0]]))
    assert turned != mapping
    (tmp_path / "impact_log.toml").write_text(turned)
    with pytest.raises(InputError, match=r"order = \[2, 3, 4, 1\]"):
        fit(read_fit_plan(tmp_path / "fit.toml"), tmp_path)


def test_a_plan_is_checked_before_it_is_fitted() -> None:
    done = CliRunner().invoke(cli, ["check", str(EXAMPLES / "fit.toml"), "--json"])
    told = json.loads(done.output)
    assert len(told["impacts"]) == 1
    assert told["fields"]["vehicle.body.inertia.2"] == "known, +- 5 %"
    assert told["fields"][SPRING] == "free, factor 3"


def test_what_follows_from_parts_is_not_uncertain_by_itself() -> None:
    tables = rig()
    box = {"type": "box", "mass": "1 kg", "size": [0.2, 0.2, 0.1]}
    tables["vehicle"]["body"] = {"parts": [box]}
    plan = FitPlan.model_validate({"scenario": "rig.toml", "free": QUAD})
    names = [one.name for one in fields_of_plan(plan, scenario_from(tables))]
    assert names == [STIFFNESS, LOSS, *(
        f"vehicle.arms.directions.{j}" for j in range(4)
    )]  # fmt: skip


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"free": {}}, "needs at least one field"),
        ({"free": {"vehicle.body.mas": "factor 2"}}, "mass"),
        ({"logs": ["none.ulg"]}, "none.ulg"),
        ({"logs": None}, "flights: is missing"),
        ({"scenario": "none.toml"}, "none.toml"),
        ({"known": {STIFFNESS: "exact"}, "free": {STIFFNESS: "factor 2"}}, "is free as well"),
        ({"flights": [{"logs": ["impact_log.toml"], "at": [3.0]}], "logs": None}, "no impact at 3"),
        ({"windows": {}}, "did you mean window"),
        ({"starts": 0}, "starts"),
    ],
)  # fmt: skip
def test_a_wrong_plan_is_refused_in_one_line(
    tmp_path: Path, change: dict, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    base = {"scenario": "arq_wall.toml", "logs": ["impact_log.toml"], "free": {SPRING: "factor 2"}}
    given = {key: value for key, value in (base | change).items() if value is not None}
    for name in ("arq_wall.toml", "impact_log.toml", "impact_log.csv"):
        (tmp_path / name).write_bytes((EXAMPLES / name).read_bytes())
    lines = []
    for key, value in given.items():
        lines.append(f"{key} = {_toml(value)}")
    (tmp_path / "fit.toml").write_text("\n".join(lines))
    words = ["identify", "fit", str(tmp_path / "fit.toml"), "--out", str(tmp_path / "out")]
    done = CliRunner().invoke(cli, words)
    assert isinstance(done.exception, InputError)
    assert said in str(done.exception)
    assert not (tmp_path / "out").exists()


def _toml(value: object) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f'"{k}" = {_toml(v)}' for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value)
