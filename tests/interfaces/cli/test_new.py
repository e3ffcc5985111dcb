"""`springback new`: what it writes works at once, and nothing is overwritten."""

import math
import re
import shlex
import tomllib
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

import springback
from builders.cases import nonempty
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.contact.obstacles import signed_distance
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.interfaces.cli.examples import TEMPLATES
from springback.scenario.avionics import CompiledPilot
from springback.scenario.build import user_parts
from springback.scenario.code_files import read_object
from springback.scenario.fields import fields_of
from springback.scenario.user.compiled import check_user_code
from springback.scenario.user.obstacles import check_own_obstacles
from springback.scenario.user.pilots import read_pilot
from springback.scenario.warnings import scenario_warnings
from springback.studies.sensing_check import sensing_kind
from springback.vehicle.parameters import Vehicle


@pytest.fixture(autouse=True)
def in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))


def new(*words: str) -> str:
    """Remarks of the command."""
    done = CliRunner().invoke(cli, ["new", *words], standalone_mode=False)
    if done.exception:
        raise done.exception
    return done.stderr


def test_a_vehicle_flies_into_its_wall_with_one_spring_at_work() -> None:
    new("vehicle", "hexa")
    flight = springback.fly("hexa.toml")
    assert flight.outcome is springback.Outcome.SEPARATED
    assert flight.scenario.vehicle.name == "hexa"
    assert 0.01 < flight.impact_arm_stroke < 0.03
    assert springback.fly("hexa.toml", "start.yaw=0").impact_arm_stroke < 0.006


def test_a_vehicle_file_has_every_number_that_a_vehicle_has() -> None:
    new("vehicle", "hexa")
    text = Path("hexa.toml").read_text()
    given = tomllib.loads(text)["vehicle"]
    for name, field in nonempty(fields_of(Vehicle).items()):
        if name in ("hulls", "limits", "rotors"):  # mostly none
            assert f"[vehicle.{name}]" in text
            continue
        assert name in given
        for table in field.tables:
            others = {"stop", "joint", "neighbours", "parts", "model", "links", "measured"}
            others |= {"surface_effect"}
            assert given[name].keys() == fields_of(table).keys() - others
    assert "[vehicle.propulsion.stop]" in text
    assert "surface_effect = true" in text
    assert "[vehicle.arms.joint]" in text
    assert "[vehicle.arms.neighbours]" in text
    assert "[[vehicle.body.parts]]" in text
    assert 'model = "robot.sdf"' in text


def test_a_vehicle_file_with_its_lines_for_a_pilot_is_a_run_up_with_recovery() -> None:
    new("vehicle", "hexa")
    lines = Path("hexa.toml").read_text()
    lines = re.sub(r"^thrust.*\n", "", lines, flags=re.M)
    head, tail = lines.split("[start]\n", 1)
    piloted = "\n".join(re.findall(r"^#~ (.*)", tail, re.M))
    Path("piloted.toml").write_text(f"{head}\n{piloted}\n")
    scenario = springback.read_scenario("piloted.toml")
    assert scenario.reference.type == "run-up"
    assert scenario.recovery is not None
    assert scenario_warnings(scenario) == []
    assert scenario.reference.yaw == scenario.start.yaw == pytest.approx(math.pi / 4)
    assert [one.type for one in scenario.world.obstacles][-1] == "ground"


@pytest.mark.parametrize("compiled", [False, True])
def test_a_pilot_is_one_and_its_scenario_can_be_flown_by_it(compiled: bool) -> None:
    new("pilot", "mine", *(["--compiled"] if compiled else []))
    pilot = read_pilot("mine.py:hover")
    assert isinstance(pilot, CompiledPilot) is compiled
    scenario = springback.read_scenario("mine.toml")
    assert scenario.simulation.duration == 3.0
    assert scenario.code == [("pilot", f"{Path.cwd() / 'mine.py'}:hover")]
    assert scenario.build().built_avionics is not None
    assert "own_pilot" not in Path("mine.py").read_text()


def test_an_obstacle_is_a_distance_with_its_gradient() -> None:
    new("obstacle", "tree")
    names: dict[str, object] = {"__name__": "tree"}
    exec(compile(Path("tree.py").read_text(), "tree.py", "exec"), names)
    check_own_obstacles([(names["POLE"], springback.WALL)], springback.Vec(2.2, 0.0, 1.0))
    assert signed_distance(names["POLE"], springback.Vec(2.75, 0.0, 7.0)) == -0.05
    [(pole, _)] = user_parts(springback.read_scenario("tree.toml")).obstacles
    assert pole == names["POLE"]


@pytest.mark.parametrize(("kind", "name"), [("estimator", "blend"), ("detector", "jolt")])
def test_an_estimator_and_a_detector_are_built_and_answer(kind: str, name: str) -> None:
    new(kind, "mine")
    assert f"own_{kind}" not in Path("mine.py").read_text() + Path("mine.toml").read_text()
    scenario = springback.read_scenario("mine.toml")
    assert [word for _, word in scenario.code] == [f"{Path.cwd() / 'mine.py'}:{name}"]
    [law] = check_user_code(scenario.build())
    assert law.home[0] == str(Path.cwd() / "mine.py")
    assert sensing_kind(read_object(scenario.code[0][1], kind), {}) is not None


def test_a_campaign_is_laid_out_with_the_scenario_beside_it() -> None:
    new("campaign", "study")
    design = lay_out(*read_plan("study.toml"))
    assert design.flights == 512
    assert design.robots == ("study_vehicle",)
    assert design.units.keys() >= {"stiffness", "damping"}


@pytest.mark.parametrize("kind", TEMPLATES)
def test_the_next_commands_exist_with_their_options(kind: str) -> None:
    said = new(kind, "mine")
    lines = re.findall(r"^  (\w+) (.*)", said, re.M)
    assert len(lines) == len(TEMPLATES[kind].next)
    context = click.Context(cli, info_name="springback")
    for program, rest in lines:
        words = shlex.split(rest)
        if program == "python":
            assert Path(words[0]).is_file()
            continue
        name, command, words = cli.resolve_command(context, words)
        command.make_context(name, words, parent=context)


def test_nothing_is_overwritten_but_by_force() -> None:
    Path("study_vehicle.toml").write_text("mine")
    with pytest.raises(InputError, match=r"study_vehicle\.toml: already exists"):
        new("campaign", "study")
    assert not Path("study.toml").exists()
    assert Path("study_vehicle.toml").read_text() == "mine"
    new("campaign", "study", "--force")
    assert "stiffness" in Path("study_vehicle.toml").read_text()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["pilot", "math"], "Python's own"),
        (["pilot", "class"], "Python's own"),
        (["obstacle", "a-b"], "without -"),
        (["vehicle", "a b"], "must be letters"),
        (["vehicle", "7"], "must be letters"),
        (["vehicle", "x.y"], "must be letters"),
        (["vehicle", "--out", "x.py"], "must end in .toml"),
        (["vehicle", "x", "--out", "y.toml"], "only one"),
        (["vehicle", "--compiled"], "belongs to a pilot"),
    ],
)
def test_a_bad_name_is_refused(words: list[str], message: str) -> None:
    with pytest.raises(InputError, match=message):
        new(*words)
    assert list(Path().iterdir()) == []


def test_a_folder_that_cannot_be_written_is_one_line() -> None:
    Path("file").write_text("")
    with pytest.raises(InputError, match="cannot be written"):
        new("vehicle", "--out", "file/x.toml")
