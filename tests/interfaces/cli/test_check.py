"""`springback check` of scenarios and plans."""

import json
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from springback.errors import InputError
from springback.interfaces.cli.app import cli

EXAMPLES = Path(__file__).parents[3] / "examples"


def check(*words: str) -> Result:
    done = CliRunner().invoke(cli, ["check", *words], standalone_mode=False)
    if done.exception:
        raise done.exception
    return done


def test_a_scenario_shows_numbers_and_warnings() -> None:
    done = check(str(EXAMPLES / "own_vehicle.toml"), "start.yaw=0")
    assert "natural frequency" in done.stdout
    assert "43.59 Hz" in done.stdout
    assert "warning: arm 1 meets world.obstacles[0], a wall, at 45 deg" in done.stderr
    assert "can be flown" in done.stderr


def test_both_vehicles_of_a_pair_are_shown() -> None:
    heavy = ("second.vehicle.body.mass=2 kg", "second.vehicle.body.inertia=[1, 1, 1]")
    words = (str(EXAMPLES / "pair.toml"), *heavy)
    data = json.loads(check(*words, "--json", "--quiet").stdout)
    masses = [one["derived"][0]["value"] for one in (data, data["second"])]
    assert masses[0] == pytest.approx(1.404)
    assert masses[1] > 2.0
    assert any(one.startswith("second: ") and "inertia" in one for one in data["warnings"])
    shown = check(*words).stdout
    assert shown.index("arq, the first vehicle:") < shown.index("arq, the second vehicle:")
    assert shown.count("natural frequency") == 2


def test_a_plan_shows_its_flights_and_the_numbers_of_each_robot() -> None:
    done = check(str(EXAMPLES / "campaign.toml"), "--json", "--quiet")
    data = json.loads(done.stdout)
    assert (data["kind"], data["flights"], data["samples"]) == ("plan", 2048, 1024)
    columns = {one["column"]: one["values"] for one in data["fields"]}
    assert columns["speed"] == "1 to 3.5"
    assert columns["surface"] == "wall, mat (2 values)"
    assert columns["stiffness_factor"] == "0.5 to 2 times its own"
    assert data["robots"].keys() == {"arq", "quad"}
    masses = [data["robots"][robot]["derived"][0]["value"] for robot in ("arq", "quad")]
    assert masses == pytest.approx([1.404, 1.214])


def test_values_of_a_plan_are_in_the_units_of_its_file(tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / "arq_wall.toml", tmp_path)
    fields = {
        "start.pitch": 'from = "-30 deg"\nto = "30 deg"', "start.roll": "from = -0.1\nto = 0.1",
        "start.angular_velocity.0": 'from = "0 deg/s"\nto = "90 deg/s"',
        "start.yaw": 'values = ["0 deg", "22.5 deg"]',
        "start.position.1": 'normal = { deviation = "5 mm" }',
        "start.position.2": "from = 1\nto = 2", "surface": 'values = ["wall", "mat"]',
    }  # fmt: skip
    varied = "".join(f'[[vary]]\nfield = "{name}"\n{law}\n' for name, law in fields.items())
    plan = 'scenario = "arq_wall.toml"\nmethod = "random"\nsamples = 2\nscatter = "trials"\n'
    (tmp_path / "plan.toml").write_text(plan + varied)
    done = check(str(tmp_path / "plan.toml"))
    shown = dict(line.split("  ", 1) for line in done.stdout.splitlines() if "  " in line)
    wanted = {
        "start.pitch": "-30 to 30 deg", "start.roll": "-5.72958 to 5.72958 deg",
        "start.angular_velocity[0]": "0 to 90 deg/s", "yaw": "0, 22.5 deg (2 values)",
        "start.position[1]": "normal, mean 0 mm, deviation 5 mm, added to its own",
        "start.position[2]": "1 to 2 m", "surface": "wall, mat (2 values)",
        "scatter_heading": "normal, mean 0 deg, deviation 2 deg, added to its own",
    }  # fmt: skip
    assert {name: shown[name].strip() for name in wanted} == wanted
    data = json.loads(check(str(tmp_path / "plan.toml"), "--json", "--quiet").stdout)
    assert [(one["values"], one["unit"]) for one in data["fields"][:3]] == [
        ("-30 to 30", "deg"), ("-5.72958 to 5.72958", "deg"), ("0 to 90", "deg/s"),
    ]  # fmt: skip


def test_what_flying_would_refuse_is_refused(tmp_path: Path) -> None:
    for name in ("own_campaign.toml", "own_vehicle.toml"):
        shutil.copy(EXAMPLES / name, tmp_path)
    with pytest.raises(InputError, match=r"start\.pitch"):
        check(str(tmp_path / "own_vehicle.toml"), "start.pitch=400 deg")
    with pytest.raises(InputError, match="sucess"):
        check(str(tmp_path / "own_campaign.toml"), "success=sucess > 1")
    with pytest.raises(InputError, match="there is no such file"):
        check("none.py:hover")


@pytest.mark.parametrize("name", ["POLE", "Pole"])
def test_an_obstacle_is_checked_by_name_or_by_its_type(name: str) -> None:
    words = ["x=2.75", "y=0", "radius=0.05"] if name == "Pole" else []
    done = check(f"{EXAMPLES / 'own_obstacle.py'}:{name}", *words, str(EXAMPLES / "arq_wall.toml"))
    assert "pass  outward_normal" in done.stdout
    assert "4 of 4 passed" in done.stderr


def test_a_wrong_obstacle_fails_with_its_reason(tmp_path: Path) -> None:
    text = (EXAMPLES / "own_obstacle.py").read_text()
    path = tmp_path / "own_obstacle.py"
    path.write_text(text.replace("return Vec(dx * inverse", "return Vec(-dx * inverse"))
    done = CliRunner().invoke(cli, ["check", f"{path}:POLE", "--json"])
    assert done.exit_code == 1
    found = {one["name"]: one["passed"] for one in json.loads(done.stdout)}
    assert found == {"has a surface": True, "signed_distance": True, "outward_normal": False}


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["Pole", "x=2"], "does not take them"),
        (["Pole"], r"cannot be made without any: .*own_obstacle\.py:Pole radius=0\.1$"),
        (["Pole", "x=2", "y=[1, 2]", "radius=1"], "y"),
        (["POLE", "x=2"], "takes none"),
        (["main", "x=2"], "main does not take a PilotContext, x"),
        (["nothing"], "has no 'nothing'"),
        (["POLE", "a.toml", "b.toml"], "one scenario"),
    ],
)
def test_code_that_cannot_be_checked_is_one_line(words: list[str], message: str) -> None:
    with pytest.raises(InputError, match=message):
        check(f"{EXAMPLES / 'own_obstacle.py'}:{words[0]}", *words[1:])


def test_what_is_no_scenario_is_called_neither_code(tmp_path: Path) -> None:
    """A name without a colon is a file; it was refused as code that lacks its name."""
    (tmp_path / "notes.md").write_text("Notes on impacts\n")
    with pytest.raises(InputError, match="is not TOML"):
        check(str(tmp_path / "notes.md"))
    with pytest.raises(InputError, match="Is a directory"):
        check(str(tmp_path))


def test_a_scenario_whose_code_cannot_be_used_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "s.toml"
    path.write_text((EXAMPLES / "own_obstacle.toml").read_text())
    with pytest.raises(InputError, match="not trusted"):
        check(str(path))
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    with pytest.raises(InputError, match="there is no such file"):
        check(str(path))


def test_a_plan_says_which_limit_no_spring_can_keep_to(tmp_path: Path) -> None:
    shutil.copy(EXAMPLES / "own_vehicle.toml", tmp_path)
    plan = tmp_path / "plan.toml"
    plan.write_text(
        'method = "grid"\nscenario = "own_vehicle.toml"\n'
        'success = ["impact_peak_specific_force < 10 gn", "impact_arm_stroke < 30 mm"]\n'
        '[[vary]]\nfield = "start.velocity.0"\nfrom = 1.0\nto = 3.0\ncount = 3\n'
    )
    said = check(str(plan)).stderr
    assert "below 98.07 m/s², and in 1 of 3 flights no spring can stop the body so gently" in said
    assert (
        "flight 2 meets world.obstacles[0], a wall, at 3 m/s, and with s = 35 mm v²/(2 s) is 128.6 m/s²"
        in said
    )
    for words in ("< 128.7 m/s^2", "> 10 gn"):
        condition = f'success=["impact_peak_specific_force {words}"]'
        assert "no spring" not in check(str(plan), condition).stderr
    numbers = json.loads(check(str(tmp_path / "own_vehicle.toml"), "--json").stdout)["derived"]
    [least] = [one["value"] for one in numbers if one["name"] == "least peak deceleration"]
    assert least == pytest.approx(2.0**2 / (2.0 * 0.035))


PLAIN = """
from __future__ import annotations
import springback
from springback import DetectorStep, Estimate, PilotContext, Vec
ZERO = Vec(0.0, 0.0, 0.0)

def jolt(time, inputs, memory):
    force = inputs.measurement.inertial.specific_force
    return DetectorStep(1.0 if force.x < -20.0 else 0.0, ZERO, memory)

def law(detector, time, inputs, memory) -> springback.DetectorStep:
    return DetectorStep(0.0, ZERO, memory)

def blend(time, measurement, memory):
    pose = measurement.pose
    return Estimate(pose.position, pose.attitude, ZERO, ZERO)

def hover(context: PilotContext, thrust):
    return lambda time, measurement, memory: ((thrust,) * 4, memory)
"""


@pytest.mark.parametrize(
    ("name", "line", "what", "compiled"),
    [
        ("jolt", 7, "a detector", "CompiledDetector"),
        ("law", 11, "a detector", "CompiledDetector"),
        ("blend", 14, "an estimator", "CompiledEstimator"),
    ],
)
def test_a_plain_detector_or_estimator_is_told_to_be_compiled(
    tmp_path: Path, name: str, line: int, what: str, compiled: str
) -> None:
    """Was: checked as a pilot, of which eight properties failed."""
    path = tmp_path / "mine.py"
    path.write_text(PLAIN)
    with pytest.raises(InputError) as caught:
        check(f"{path}:{name}")
    [said] = caught.value.problems
    assert said.startswith(f"{path}:{line}: {name} is {what} in plain Python; it runs within ")
    assert f"name a {compiled}, as springback new {what.split()[1]} writes one" in said


def test_a_pilot_is_checked_with_its_parameters(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text(PLAIN)
    (tmp_path / "short.toml").write_text('vehicle = "quad"\n')
    words = ["check", f"{path}:hover", "thrust=3", str(tmp_path / "short.toml")]
    done = CliRunner().invoke(cli, words)
    assert "its 4 thrusts in hover are 3 to 3 N" in done.stdout
    with pytest.raises(InputError, match="hover does not take a PilotContext, gain"):
        check(f"{path}:hover", "gain=3")


def test_a_wrong_field_of_a_fits_plan_is_named_with_its_line(tmp_path: Path) -> None:
    """As by `identify fit`."""
    text = (EXAMPLES / "fit.toml").read_text(encoding="utf-8")
    (tmp_path / "arq_wall.toml").write_text((EXAMPLES / "arq_wall.toml").read_text())
    wrong = text.replace('"vehicle.body.mass" = "+- 0.5 %"', '"vehicle.body.masss" = "+- 0.5 %"')
    (tmp_path / "fit.toml").write_text(wrong, encoding="utf-8")
    line = 1 + wrong[: wrong.index("masss")].count("\n")
    with pytest.raises(InputError) as refused:
        check(str(tmp_path / "fit.toml"))
    [problem] = refused.value.problems
    assert f"fit.toml:{line}: known.vehicle.body.masss: unknown parameter" in problem
