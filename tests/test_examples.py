"""Examples and README do what they say."""

import re
import runpy
import shutil
from pathlib import Path

import numpy as np
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


def test_steps_and_run_up_fly_from_an_empty_folder(tmp_path: Path) -> None:
    for name in ("steps", "run_up"):
        shutil.copy(ROOT / f"examples/{name}.toml", tmp_path)
    steps = springback.fly(tmp_path / "steps.toml")
    last = [steps.columns[axis][-1] for axis in "xyz"]
    assert last == pytest.approx([1.0, 1.0, 2.0], abs=0.02)
    run_up = springback.fly(tmp_path / "run_up.toml")
    # The rotors' lag, sensors and gains leave this much of the 2 m/s to chance.
    assert run_up.touch_speed == pytest.approx(2.0, abs=0.05)


def test_own_pilots_hover_alike_plain_and_compiled(tmp_path: Path) -> None:
    flights = []
    for name in ("own_pilot", "own_pilot_compiled"):
        shutil.copy(ROOT / f"examples/{name}.py", tmp_path)
        flights.append(runpy.run_path(str(tmp_path / f"{name}.py"))["main"]())
    for flight in flights:
        last = [flight.columns[axis][-1] for axis in "xyz"]
        assert last == pytest.approx([0.0, 0.0, 1.0], abs=0.01)
    # NumPy sums in another order than the formulas do: a few rounding errors, which feedback damps.
    for axis in "xyz":
        assert np.abs(flights[0].columns[axis] - flights[1].columns[axis]).max() < 1e-9


def test_own_pilots_keep_to_what_every_pilot_should() -> None:
    findings = springback.check_pilot(f"{ROOT / 'examples/own_pilot_compiled.py'}:hover")
    assert [finding.name for finding in findings if not finding.passed] == []
    assert findings[-1].name == "compiles to the same flight"


def test_tables_of_the_guide_are_valid(tmp_path: Path) -> None:
    """docs/own.md: its vehicle and its surface fly together."""
    blocks = re.findall(r"```toml\n(.*?)```", (ROOT / "docs/own.md").read_text(), re.S)
    path = tmp_path / "own.toml"
    path.write_text("\n".join(blocks))
    scenario = springback.read_scenario(path)
    assert scenario.vehicle.arm_count == 3
    assert scenario.vehicle.arms.at("compliant", 2) is False
