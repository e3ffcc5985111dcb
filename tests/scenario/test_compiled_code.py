"""Code of one's own that cannot be compiled: told in one line, before a flight where one checks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import springback
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.interfaces.cli.app import cli

TYRE = """from math import sqrt
from typing import NamedTuple

from springback import Vec, kernel, outward_normal, signed_distance


class Tyre(NamedTuple):
    x: float
    z: float
    radius: float


def no_kernel(x: float) -> float:
    return 0.0 * x


@signed_distance.register(Tyre)
@kernel
def _(tyre: Tyre, point: Vec) -> float:
    dx, dz = point.x - tyre.x, point.z - tyre.z
    BAD
    return sqrt(dx * dx + dz * dz) - tyre.radius


@outward_normal.register(Tyre)
@kernel
def _(tyre: Tyre, point: Vec) -> Vec:
    dx, dz = point.x - tyre.x, point.z - tyre.z
    k = 1.0 / sqrt(dx * dx + dz * dz)
    return Vec(dx * k, 0.0, dz * k)
"""
#: Lines that are fine in Python, and what is said of them.
BAD = {
    "text": ("label = f'{dx:.3f}'", "format spec in f-strings not supported yet"),
    "list": ("dx += len([k for k in 'ab']) - 2", "a list, set, dictionary or text cannot be comp"),
    "call": ("dx += no_kernel(dx)", "no_kernel is plain Python; mark it with @kernel"),
    "file": ("open('tyre.txt', 'w').close()", "Untyped global name 'open'"),
}
LINE = 1 + TYRE.splitlines().index("    BAD")
SCENARIO = """vehicle = "arq"
thrust = "hover"
start.velocity = ["2 m/s", 0, 0]
[[world.obstacles]]
type = "own"
shape = "tyre.py:Tyre"
parameters = { x = 1.5, z = 0.0, radius = 0.5 }
surface = "wall"
"""
PLAN = 'scenario = "tyre.toml"\nmethod = "random"\nsamples = 4\n'
PLAN += '[[vary]]\nfield = "start.velocity.0"\nfrom = 1\nto = 2\n'
PILOT = """from springback import CompiledPilot, PilotOutput, kernel, pilot_step
from typing import NamedTuple


class Lift(NamedTuple):
    share: float


@pilot_step.register(Lift)
@kernel
def _(lift, time, measurement, memory):
    return PilotOutput((lift.share,) * 4, memory)


lift = CompiledPilot(Lift(1.0), Lift(0.0))
"""


@pytest.fixture(autouse=True)
def in_a_trusted_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SPRINGBACK_TRUST", str(tmp_path))
    (tmp_path / "tyre.toml").write_text(SCENARIO)
    (tmp_path / "plan.toml").write_text(PLAN)


def write_tyre(line: str) -> str:
    """Write the tyre with a line in its distance; returns its place."""
    Path("tyre.py").write_text(TYRE.replace("BAD", line))
    return f"{Path('tyre.py').resolve()}:{LINE}: cannot be compiled: "


def refused(*words: str) -> str:
    """The only line of a command that exits with 2."""
    done = CliRunner().invoke(cli, list(words))
    assert isinstance(done.exception, InputError)
    [line] = done.exception.problems
    return line


@pytest.mark.parametrize("bad", BAD.values(), ids=BAD)
def test_the_check_of_a_shape_compiles_it(bad: tuple[str, str]) -> None:
    """Was: 3 of 3 passed."""
    place, (_, said) = write_tyre(bad[0]), bad
    line = refused("check", "tyre.py:Tyre", "x=1.5", "z=0", "radius=0.5")
    assert line.startswith(place + said)


@pytest.mark.parametrize("command", [("check", "tyre.toml"), ("check", "plan.toml")], ids="-".join)
def test_the_check_of_a_file_compiles_its_shapes(command: tuple[str, ...]) -> None:
    """Was: can be flown."""
    place = write_tyre(BAD["text"][0])
    assert refused(*command).startswith(place)


def test_a_campaign_is_refused_before_it_begins(tmp_path: Path) -> None:
    place = write_tyre(BAD["text"][0])
    assert refused("campaign", "plan.toml", "--out", "many").startswith(place)
    assert not (tmp_path / "many").exists()


def test_a_flight_names_the_place_in_a_shape() -> None:
    """Was: 368 lines of the compiler, and exit code 1."""
    place = write_tyre(BAD["text"][0])
    with pytest.raises(InputError) as caught:
        springback.fly("tyre.toml")
    assert str(caught.value).startswith(place)


def test_a_batch_names_the_place_in_a_shape() -> None:
    place = write_tyre(BAD["text"][0])
    tables: dict[str, Any] = {
        "vehicle": "arq", "thrust": "hover", "start": {"velocity": [2.0, 0.0, 0.0]},
        "world": {"obstacles": [{
            "type": "own", "shape": "tyre.py:Tyre", "surface": "wall",
            "parameters": {"x": 1.5, "z": 0.0, "radius": 0.5},
        }]},
    }  # fmt: skip
    with pytest.raises(InputError) as caught:
        fly_scenarios([tables])
    assert str(caught.value).startswith(place)


def test_the_check_of_a_scenario_compiles_its_pilot() -> None:
    Path("pilot.py").write_text(PILOT)
    Path("own.toml").write_text('vehicle = "quad"\npilot = "pilot.py:lift"\n')
    assert refused("check", "own.toml").startswith(
        f"{Path('pilot.py').resolve()}:12: cannot be compiled: the compiler has no mul("
    )


def test_a_shape_that_compiles_is_said_to() -> None:
    write_tyre("pass")
    done = CliRunner().invoke(cli, ["check", "tyre.py:Tyre", "x=1.5", "z=0", "radius=0.5"])
    assert "pass  can be compiled" in done.stdout
    assert CliRunner().invoke(cli, ["check", "tyre.toml"]).exit_code == 0


def test_errors_that_are_not_of_the_compiler_are_left_alone() -> None:
    def fails(time: float, measurement: Any, memory: Any) -> Any:
        raise KeyError("mine")

    scenario = {"vehicle": "quad", "start": {"position": [0.0, 0.0, 1.0]}}
    with pytest.raises(InputError, match="KeyError: 'mine'"):
        springback.fly(scenario, pilot=fails)
