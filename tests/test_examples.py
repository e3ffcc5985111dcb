"""Examples and README do what they say."""

import re
import runpy
from pathlib import Path

import pytest

import springback

ROOT = Path(__file__).parents[1]


def test_own_obstacle_example_hits_the_pole() -> None:
    flight = runpy.run_path(str(ROOT / "examples/own_obstacle.py"))["main"]()
    assert flight.outcome is springback.Outcome.SEPARATED
    assert flight.touch_speed == pytest.approx(2.0, rel=1e-6)


def test_scenario_of_the_readme_flies_as_shown(tmp_path: Path) -> None:
    text = (ROOT / "README.md").read_text()
    scenario = re.search(r"```toml\n(.*?)```", text, re.S)
    assert scenario is not None
    path = tmp_path / "scenario.toml"
    path.write_text(scenario[1])
    softer = ("vehicle.arms.stiffness=2 N/mm", "start.yaw=45 deg")
    plain, soft = springback.fly(path), springback.fly(path, *softer)
    rigid = springback.fly(path, "vehicle.arms.compliant=false")
    assert plain.outcome is soft.outcome is rigid.outcome is springback.Outcome.SEPARATED
    assert soft.peak_acceleration < plain.peak_acceleration < rigid.peak_acceleration
    assert len(plain.to_dataframe()) == len(plain.to_xarray()["t"]) == len(plain.t)


def test_example_scenario_flies() -> None:
    flight = springback.fly(ROOT / "examples/arq_wall.toml")
    assert "hit an obstacle" in repr(flight)


def test_tables_of_the_guide_are_valid(tmp_path: Path) -> None:
    """docs/own.md: its vehicle and its surface fly together."""
    blocks = re.findall(r"```toml\n(.*?)```", (ROOT / "docs/own.md").read_text(), re.S)
    path = tmp_path / "own.toml"
    path.write_text("\n".join(blocks))
    scenario = springback.read_scenario(path)
    assert scenario.vehicle.arm_count == 3
    assert scenario.vehicle.arms.at("compliant", 2) is False
