"""`springback new vehicle` with answers: the file says where its numbers are from, and flies."""

from __future__ import annotations

import math
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner

import springback
from springback.errors import InputError
from springback.interfaces.cli import examples
from springback.interfaces.cli.app import cli
from springback.interfaces.cli.design.answers import QUESTIONS
from springback.interfaces.cli.design.sizes import DAMPING_RATIO, ratio_of_peak
from springback.scenario.warnings import scenario_warnings
from springback.studies.scenario_check import check_warnings

HEXA = ("--mass", "600g", "--arms", "6", "--propeller", "5in")


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def new(*words: str, typed: str | None = None) -> str:
    """Remarks of the command."""
    done = CliRunner().invoke(cli, ["new", "vehicle", *words], standalone_mode=False, input=typed)
    if done.exception:
        raise done.exception
    return done.stderr


def vehicle_of(*words: str) -> springback.Vehicle:
    new("mine", "--force", *words)
    return springback.read_scenario("mine.toml").vehicle


def test_the_vehicle_has_what_was_asked_for() -> None:
    hexa = vehicle_of(*HEXA, "--span", "0.4 m", "--guard", "75mm", "--spring", "20mm at 3m/s")
    assert hexa.mass == pytest.approx(0.6)
    assert hexa.arm_count == 6
    assert (hexa.arms.length, hexa.arms.cage_radius) == (0.2, 0.075)
    assert hexa.propulsion is not None
    assert hexa.propulsion.disk_radius == pytest.approx(0.0635)
    assert hexa.arms.stroke == pytest.approx(0.025)
    assert 6.0 * hexa.propulsion.max_thrust == pytest.approx(2.0 * 0.6 * 9.81, rel=5e-3)


def test_the_spring_stops_the_vehicle_within_the_way() -> None:
    """The peak of x'' + 2 ζ ω x' + ω² x = 0 from x' = v is the way; flown, to a tenth."""
    new("mine", "--spring", "15 mm at 1.5 m/s")
    arms = springback.read_scenario("mine.toml").vehicle.arms
    pushed = 0.6 - float(arms.at("mass", 0))
    omega = math.sqrt(arms.at("stiffness", 0) / pushed)
    assert omega == pytest.approx(1.5 / 0.015 * ratio_of_peak(), rel=5e-3)
    assert arms.at("damping", 0) == pytest.approx(2.0 * DAMPING_RATIO * pushed * omega, rel=1e-2)
    turned = omega * math.sqrt(1.0 - DAMPING_RATIO**2)
    time = math.acos(DAMPING_RATIO) / turned
    peak = 1.5 / turned * math.exp(-DAMPING_RATIO * omega * time) * math.sin(turned * time)
    assert peak == pytest.approx(0.015, rel=5e-3)
    flight = springback.fly("mine.toml", "simulation.duration=0.2")
    assert flight.outcome is springback.Outcome.SEPARATED
    assert flight.impact_arm_stroke == pytest.approx(0.015, rel=0.1)
    assert flight.measures["propellers_hit"] == 0.0


def test_rigid_and_without_guards_it_flies_too() -> None:
    """Circles touch nothing then; motors do, and all the mass is in the main body."""
    flight_of = ("--mass", "80g", "--propeller", "2in", "--guard", "none", "--spring", "none")
    mini = vehicle_of(*flight_of)
    assert mini.body.mass == pytest.approx(0.08)
    assert not mini.is_compliant
    assert not mini.arms.cages
    assert len(mini.hulls) == 4
    flight = springback.fly("mine.toml", "simulation.duration=0.01", executor="python")
    assert flight.scenario.vehicle == mini


@pytest.mark.parametrize("arms", ["4", "6", "8", "12"])
@pytest.mark.parametrize(
    "rest", [(), ("--spring", "none", "--guard", "none")], ids=["soft", "bare"]
)
def test_any_vehicle_is_read_and_nothing_is_said_against_it(arms: str, rest: Any) -> None:
    """Parts balance, the mass is that which was asked for, and one arm points ahead."""
    made = vehicle_of("--arms", arms, "--mass", "1.7 kg", "--propeller", "7 in", *rest)
    assert made.mass == pytest.approx(1.7)
    assert made.arm_count == int(arms)
    scenario = springback.read_scenario("mine.toml")
    assert scenario_warnings(scenario) == []
    ahead = made.arms.directions[0] + scenario.start.yaw
    assert ahead == pytest.approx(0.0, abs=1e-12)


def test_every_number_says_where_it_is_from() -> None:
    """Given, derived or chosen; beside it, or in the line above or below."""
    new("mine", *HEXA)
    text = Path("mine.toml").read_text()
    assert max(map(len, text.splitlines())) <= 100
    head, vehicle = text.split("[vehicle]\n")
    assert re.findall(r"#   (\w+) .*: (given|chosen)", head) == [
        ("mass", "given"), ("arms", "given"), ("propeller", "given"), ("guard", "chosen"),
        ("spring", "chosen"), ("span", "chosen"),
    ]  # fmt: skip
    lines = vehicle.split("[[world.obstacles]]")[0].splitlines()
    for k, line in enumerate(lines):
        if re.match(
            r"(mass|size|length|cage_radius|stiffness|damping|stroke|torque_ratio|"
            r"max_thrust|time_constant|disk_radius|radius|figure|battery|elec)",
            line,
        ):
            said = " ".join(lines[max(k - 1, 0) : k + 2])
            assert re.search("given|derived|chosen", said), line


def test_lines_for_a_pilot_are_a_run_up_with_recovery() -> None:
    new("mine", *HEXA)
    lines = re.sub(r"^thrust.*\n", "", Path("mine.toml").read_text(), flags=re.M)
    head, tail = lines.split("[start]\n", 1)
    Path("piloted.toml").write_text(head + "\n".join(re.findall(r"^#~ (.*)", tail, re.M)))
    scenario = springback.read_scenario("piloted.toml")
    assert scenario.reference is not None
    assert scenario.recovery is not None
    ahead = scenario.vehicle.arms.directions[0] + scenario.reference.yaw
    assert ahead == pytest.approx(0.0, abs=1e-12)
    assert [one.type for one in scenario.world.obstacles] == ["wall", "ground"]
    assert scenario_warnings(scenario) == check_warnings(scenario) == []


def test_without_answers_and_terminal_it_is_the_example_with_every_key() -> None:
    new("plain")
    assert "stop_dissipation" in Path("plain.toml").read_text()


# -- at a terminal ---------------------------------------------------------------------------------


@pytest.fixture
def at_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(examples, "is_asking", lambda: True)


@pytest.mark.usefixtures("at_a_terminal")
def test_questions_are_asked_in_order_and_enter_takes_the_usual() -> None:
    said = new("mine", typed="600 g\n6\n\n\n20 mm at 2 m/s\n\n")
    places = [said.index(question.text) for question in QUESTIONS.values()]
    assert places == sorted(places)
    by_hand = Path("mine.toml").read_text()
    new(
        "mine",
        "--force",
        "--mass",
        "600 g",
        "--arms",
        "6",
        "--spring",
        "20 mm at 2 m/s",
        typed="\n\n\n",
    )
    assert tomllib.loads(Path("mine.toml").read_text()) == tomllib.loads(by_hand)
    assert "#   propeller 5 in: chosen" in by_hand


@pytest.mark.usefixtures("at_a_terminal")
def test_a_wrong_answer_is_one_line_and_asked_for_again() -> None:
    said = new("mine", typed="600\n-1 kg\n600 g\n\n\n\n\n\n")
    assert "--mass: has no unit (got '600'); expected kg\n" in said
    assert said.count("--mass: ") == 2
    with pytest.raises(InputError, match="--mass: must be at least"):
        new("other", typed="-1 kg\n-1 kg\n-1 kg\n")
    assert not Path("other.toml").exists()


@pytest.mark.usefixtures("at_a_terminal")
def test_the_template_is_written_without_questions() -> None:
    assert "Mass" not in new("mine", "--template")
    assert "stop_dissipation" in Path("mine.toml").read_text()


# -- what is refused -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--mass", "heavy"], "--mass: is not a number with a unit"),
        (["--mass", "600 m"], "--mass: has the wrong unit (got '600 m'); expected kg"),
        (["--mass", "3 g"], "--mass: must be at least 0.02 kg (got '3 g')"),
        (["--arms", "5"], "--arms: must be 4, 6, 8, 10 or 12: an even number"),
        (["--propeller", "5"], "--propeller: "),
        (["--guard", "40 mm"], "--guard: must be at least the radius of the propeller, 63.5 mm"),
        (["--spring", "25 mm"], "--spring: must be a way and a speed, such as 25 mm at 2 m/s"),
        (["--spring", "25 mm at 2 m"], "--spring: has the wrong unit (got '2 m'); expected m/s"),
        (["--span", "100 mm"], "--span: must be at least 280 mm, so that 4 guards of 147 mm"),
        (["--mass", "20 kg"], "--propeller: must be larger for this mass: 5 in gives 15 N"),
        (["--template", "--mass", "1 kg"], "--template and --mass: give only one"),
    ],
)  # fmt: skip
def test_a_bad_answer_is_one_line_and_nothing_is_written(words: list[str], message: str) -> None:
    with pytest.raises(InputError) as caught:
        new("mine", *words)
    assert len(caught.value.problems) == 1
    assert message in caught.value.problems[0]
    assert list(Path().iterdir()) == []


def test_a_bad_answer_ends_with_exit_code_2() -> None:
    words = ["new", "vehicle", "mine", "--arms", "three"]
    done = subprocess.run(
        [sys.executable, "-m", "springback", *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert done.stderr.startswith("error: --arms: must be 4, 6, 8, 10 or 12")
    assert done.stderr.count("\n") == 1
    assert done.stdout == ""


def test_answers_belong_to_a_vehicle() -> None:
    for words in (["--mass", "1 kg"], ["--template"]):
        with pytest.raises(InputError, match="belongs to a vehicle, not to a pilot"):
            CliRunner().invoke(
                cli, ["new", "pilot", "mine", *words], standalone_mode=False, catch_exceptions=False
            )
    context = click.Context(cli)
    assert {f"--{name}" for name in QUESTIONS} <= {
        word for option in cli.get_command(context, "new").params for word in option.opts
    }
