"""Elements of an imported world that are not there: told by every command on a campaign."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from builders.campaign_folders import rows
from builders.plans import THROW, plan
from springback.campaign.access import Campaign
from springback.campaign.analysis.statistics import summary
from springback.campaign.design.layout import Design, lay_out
from springback.campaign.running import run_campaign
from springback.campaign.store import open_store
from springback.interfaces.cli.app import cli
from springback.interfaces.reports.campaign import summary_text, write_summary

GROVE = """<sdf version="1.9"><world name="grove">
<model name="tree"><static>true</static><pose>2.5 0.3 1.5 0 0 0</pose><link name="l">
<collision name="c"><geometry><cylinder><radius>0.12</radius><length>3</length></cylinder>
</geometry></collision></link></model>
<model name="rock"><static>true</static><link name="l"><collision name="c"><geometry>
<ellipsoid><radii>0.3 0.2 0.2</radii></ellipsoid></geometry></collision></link></model>
</world></sdf>"""
SAID = "world.obstacles[0]: 1 of 2 elements of grove.sdf cannot be represented and are not there: "


class _Said(Exception):
    """Raised in place of a flight."""


def _design(folder: Path, robots: list[str] | None = None) -> Design:
    path = folder / "grove.sdf"
    path.write_text(GROVE)
    world = {"obstacles": [{"type": "import", "file": str(path), "surface": "wall"}]}
    vary = [{"field": "start.velocity.0", "name": "speed", "from": "1 m/s", "to": "3 m/s"}]
    scenario = {**THROW, "world": world}
    return lay_out(plan(samples=4, robots=robots or ["arq"], vary=vary, scenario=scenario))


def _campaign(folder: Path) -> Campaign:
    design = _design(folder)
    columns = rows(design, 0, 4)
    columns["outcome"], columns["problem"] = ["separated"] * 4, [""] * 4
    with open_store(folder / "many", design, resume=False) as store:
        store.add(0, 4, columns)
    return Campaign(folder / "many")


def test_a_campaign_warns_before_it_flies(tmp_path: Path) -> None:
    """Was: said by fly and check alone.  The two robots fly in one world: it is said once."""
    lines: list[str] = []

    def remark(line: str) -> None:
        lines.append(line)
        raise _Said

    with pytest.raises(_Said):
        run_campaign(_design(tmp_path, ["arq", "quad"]), tmp_path / "many", remark=remark)
    assert lines[0].startswith(f"warning: {SAID}rock")


def test_a_summary_warns(tmp_path: Path) -> None:
    """In text, page and JSON."""
    known = _campaign(tmp_path)
    found = summary(known)
    assert [line.startswith(f"{SAID}rock") for line in found.warnings] == [True]
    assert f"\nwarning: {SAID}rock" in summary_text(found)
    write_summary(found, tmp_path)
    assert json.loads((tmp_path / "summary.json").read_text())["warnings"] == list(found.warnings)
    page = (tmp_path / "summary.html").read_text()
    assert f"Warning: {SAID}rock" in page
    told = CliRunner().invoke(cli, ["summary", str(tmp_path / "many"), "--json"])
    assert json.loads(told.stdout)["warnings"] == list(found.warnings)


def test_a_world_that_is_all_there_is_not_warned_of(tmp_path: Path) -> None:
    design = lay_out(plan(samples=4, robots=["arq"], scenario=THROW))
    columns = rows(design, 0, 4)
    columns["outcome"], columns["problem"] = ["separated"] * 4, [""] * 4
    with open_store(tmp_path / "many", design, resume=False) as store:
        store.add(0, 4, columns)
    assert summary(Campaign(tmp_path / "many")).warnings == ()
