"""Problems of tables that a file of their own holds: that file and its line are named."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from click.testing import CliRunner

from springback.contact.forest import Forest
from springback.errors import InputError
from springback.interfaces.cli.app import cli
from springback.scenario.files import read_scenario

SURFACE = {"law": "hertz", "stiffness": 1e5}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def problem_of(file: Path, *overrides: str) -> str:
    with pytest.raises(InputError) as caught:
        read_scenario(file, overrides)
    return str(caught.value)


BARE = 'preset = "arq"\n[arms]\nstiffness = "-5 N/mm"\n'
WITHIN = '# mine\n[vehicle]\npreset = "arq"\n[vehicle.arms]\nstiffness = "-5 N/mm"\n'


@pytest.mark.parametrize(("text", "line"), [(BARE, 3), (WITHIN, 5)])
def test_the_file_of_a_vehicle_and_its_line_are_named(folder: Path, text: str, line: int) -> None:
    (folder / "v.toml").write_text(text)
    (folder / "s.toml").write_text('name = "mine"\nvehicle = "v.toml"\n')
    said = problem_of(folder / "s.toml")
    assert said.startswith(f"v.toml:{line}: vehicle.arms.stiffness: must be more than 0 N/m")


def test_what_a_scenario_sets_itself_is_its_own(folder: Path) -> None:
    (folder / "v.toml").write_text(BARE)
    (folder / "s.toml").write_text('[vehicle]\npreset = "v.toml"\narms.stiffness = -1\n')
    assert problem_of(folder / "s.toml").startswith(f"{folder / 's.toml'}:3: vehicle.arms")
    assert problem_of(folder / "s.toml", "vehicle.arms.stiffness=-2").startswith("override ")


def test_a_chain_of_files_is_followed_to_the_one_that_sets_the_value(folder: Path) -> None:
    """Also that of a second vehicle, which is a scenario's."""
    (folder / "v.toml").write_text(BARE)
    (folder / "w.toml").write_text('name = "w"\npreset = "v.toml"\nbody.mass = "1 kg"\n')
    (folder / "s.toml").write_text('vehicle = "w.toml"\n')
    (folder / "both.toml").write_text('vehicle = "arq"\nsecond = "s.toml"\n')
    assert problem_of(folder / "s.toml").startswith("v.toml:3: vehicle.arms.stiffness: ")
    assert problem_of(folder / "both.toml").startswith("v.toml:3: second.vehicle.arms.stiffness: ")


def test_a_vehicle_is_no_scenario_but_can_be_checked(folder: Path) -> None:
    (folder / "v.toml").write_text('preset = "arq"\nbody.mass = "1.1 kg"\n')
    said = problem_of(folder / "v.toml")
    assert "holds a vehicle, not a scenario" in said
    assert 'vehicle = "v.toml"' in said
    checked = CliRunner().invoke(cli, ["check", "v.toml"])
    assert checked.exit_code == 0
    assert "1.3" in checked.output.split("\n")[0]
    refused = CliRunner().invoke(cli, ["check", "v.toml", "body.mass=-1"])
    assert isinstance(refused.exception, InputError)
    assert "vehicle.body.mass: must be more than 0 kg" in str(refused.exception)


def test_a_syntax_error_has_its_line(folder: Path) -> None:
    (folder / "s.toml").write_text('vehicle = "arq"\nname = "x\n')
    assert problem_of(folder / "s.toml").startswith(f"{folder / 's.toml'}:2: is not TOML: ")


def test_a_forest_that_cannot_be_planted_is_refused() -> None:
    """Refused before it is planted, or after; one that fits is planted whole, and keeps distances."""
    given = {"type": "forest", "size": [6.0, 6.0], "surface": SURFACE}
    for density in (50.0, 1.6):
        with pytest.raises(ValueError, match=r"only some 1\.\d+ 1/m\^2 fit"):
            Forest(**given, density=density)
    forest = Forest(**given, density=1.0)
    trunks = forest.trunks()
    assert len(trunks) == 36
    apart = [
        math.hypot(a[0] - b[0], a[1] - b[1]) - a[2] - b[2]
        for k, a in enumerate(trunks)
        for b in trunks[:k]
    ]
    assert min(apart) >= 0.5
