"""A scenario and a vehicle of a user's, and what the lab makes of them."""

from pathlib import Path
from typing import Any

from springback.interfaces.lab.settings import LabSettings, settings_from
from springback.interfaces.lab.user_scenario import read_user_scenario
from springback.interfaces.lab.user_settings import user_settings

VEHICLE = """
[vehicle]
name = "Mine"
hull = {radius = "50 mm"}
[vehicle.body]
mass = "1.1 kg"
inertia = [9e-3, 9.5e-3, 1.6e-2]
[vehicle.arms]
directions = ["45 deg", "-45 deg", "-135 deg", "135 deg"]
length = "0.22 m"
mass = "40 g"
stiffness = "4 N/mm"
damping = "60 N s/m"
stroke = "30 mm"
cage_radius = "0.1 m"
torque_ratio = 0.016
"""
FILE = """
name = "own"
thrust = "hover"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = {preset = "wall", friction = 0.4}
[start]
position = ["2.3 m", 0, "1 m"]
velocity = ["2.5 m/s", 0, 0]
pitch = "10 deg"
[simulation]
duration = "0.2 s"
"""


def table_of(path: Path, *overrides: str) -> type[LabSettings]:
    return user_settings(read_user_scenario(path, overrides))


def setting(table: type[LabSettings], **words: Any) -> LabSettings:
    return settings_from(((name, str(value)) for name, value in words.items()), table)
