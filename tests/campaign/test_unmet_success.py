"""Plans that ask for what no flight can do, and files that are no plans."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from builders.plans import PITCH, THROW, plan
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import read_plan
from springback.campaign.limits_check import unreached_success
from springback.errors import InputError
from springback.interfaces.cli.app import cli

HOVERS = {"vehicle": "arq", "reference": {"type": "hold"}, "start": {"position": [0.0, 0.0, 1.0]}}
SAID = "success asks for recovered, and no flight can be: the scenario has no [recovery]"


def warned(success: Any, scenario: dict[str, Any]) -> list[str]:
    given = {
        "samples": 4,
        "vary": [PITCH],
        "robots": ["arq"],
        "success": success,
        "scenario": scenario,
    }
    return unreached_success(lay_out(plan(**given)))


@pytest.mark.parametrize("scenario", [THROW, HOVERS], ids=["thrown", "piloted"])
@pytest.mark.parametrize("success", [["recovered"], ["not hit_ground", " recovered "]], ids=str)
def test_a_recovery_that_cannot_be_is_warned_of(
    success: list[str], scenario: dict[str, Any]
) -> None:
    """Was: 60 of 60 flights failed without a word."""
    [line] = warned(success, scenario)
    assert line.startswith(SAID)


def test_what_can_be_is_not_warned_of() -> None:
    assert warned(["recovered"], {**HOVERS, "recovery": {}}) == []
    assert warned(["recovered or separated"], THROW) == []
    assert warned(["not recovered"], THROW) == []
    assert warned(None, THROW) == []


def test_the_check_of_a_plan_prints_it(tmp_path: Path) -> None:
    text = 'scenario = "throw.toml"\nmethod = "random"\nsamples = 4\nsuccess = ["recovered"]\n'
    text += '[[vary]]\nfield = "start.velocity.0"\nfrom = "1 m/s"\nto = "2 m/s"\n'
    (tmp_path / "plan.toml").write_text(text)
    scenario = 'vehicle = "arq"\nthrust = "hover"\nstart.velocity = [2.0, 0.0, 0.0]\n'
    wall = '[[world.obstacles]]\ntype = "wall"\ndistance = 1.5\nsurface = "wall"\n'
    (tmp_path / "throw.toml").write_text(scenario + wall)
    done = CliRunner().invoke(cli, ["check", str(tmp_path / "plan.toml")], catch_exceptions=False)
    assert f"warning: {SAID}" in done.stderr


def test_a_scenario_in_place_of_a_plan_is_recognised(tmp_path: Path) -> None:
    """Was: vehicle: unknown key; did you mean vehicles?"""
    path = tmp_path / "ok.toml"
    path.write_text('vehicle = "arq"\nthrust = "hover"\n')
    with pytest.raises(InputError) as caught:
        read_plan(path)
    [line] = caught.value.problems
    assert line.startswith(f"{path}: is a scenario, not a plan of a campaign")
    assert 'scenario = "ok.toml"' in line
