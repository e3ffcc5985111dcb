"""The impact lab with a vehicle whose arms are on joints: what can be changed, where it begins."""

from pathlib import Path

import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")

from springback.interfaces.lab.controls import NoControl, SliderControl
from springback.interfaces.lab.scenarios import BEFORE, lab_scenario
from springback.interfaces.lab.settings import LabSettings, control_of, settings_from
from springback.interfaces.lab.user_scenario import read_user_scenario
from springback.interfaces.lab.user_settings import user_settings
from springback.interfaces.lab.vehicle_controls import why_fixed_count
from springback.interfaces.lab.vehicles import is_balanced
from springback.results.flight import fly

FILE = """
thrust = 2.6
[[world.obstacles]]
type = "wall"
distance = 1.0
surface = "wall"
[start]
position = [0.6, 0, 1]
velocity = [2.0, 0, 0]
pitch = "12 deg"
[simulation]
duration = 0.2
[vehicle]
name = "Mine"
hulls = [{type = "sphere", on = 1, position = [0.12, 0, 0], radius = 0.02}]
[vehicle.body]
mass = 0.86
inertia = [8e-3, 9e-3, 1.6e-2]
[vehicle.arms]
directions = ["45 deg", "135 deg", "225 deg", "315 deg"]
length = 0.19
height = 0.04
mass = 0.05
cage_radius = 0.11
joint = {type = "hinge", position = [0.06, 0, 0], axis = [0, 1, 0], \
travel = ["-60 deg", "60 deg"], stiffness = STIFFNESS}
"""


def table_of(folder: Path, stiffness: str) -> type[LabSettings]:
    path = folder / "own.toml"
    path.write_text(FILE.replace("STIFFNESS", stiffness), encoding="utf-8")
    return user_settings(read_user_scenario(path))


def test_springs_of_joints_have_no_sliders(tmp_path: Path) -> None:
    table = table_of(tmp_path, "5.0")
    for name in ("stiffness", "damping", "stroke"):
        control = control_of(name, table)
        assert isinstance(control, NoControl), name
        assert "hinge" in control.explains
    for name in ("length", "cage_radius", "arm_mass", "stop_stiffness"):
        assert isinstance(control_of(name, table), SliderControl), name


def test_arms_that_differ_in_their_joints_keep_their_number(tmp_path: Path) -> None:
    for stiffness, fixed in (("5.0", False), ("[5.0, 6.0, 5.0, 6.0]", True)):
        path = tmp_path / "own.toml"
        path.write_text(FILE.replace("STIFFNESS", stiffness), encoding="utf-8")
        vehicle = read_user_scenario(path).vehicle
        assert bool(why_fixed_count(vehicle)) == fixed
        assert is_balanced(vehicle)


def test_an_impact_begins_where_raised_cages_and_their_hulls_are_near_the_wall(
    tmp_path: Path,
) -> None:
    table = table_of(tmp_path, "5.0")
    settings = settings_from({"mode": "impact", "pitch": "20", "yaw": "10"}.items(), table)
    flight = fly(lab_scenario(settings, "mine"))
    assert flight.measures["touch_time"] == pytest.approx(BEFORE, abs=1e-6)
