"""A slider rig whose hit at a wall was flown with sensors, and the plan that fits it."""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path

from springback.identification.fits import FitResult, fit
from springback.identification.settings import FitPlan
from springback.interfaces.reports.flight_files import save_flight
from springback.results.flight import fly
from springback.scenario.files import read_scenario

RIG = """
name = "slider rig"
vehicle = "arq-slider"
[[world.obstacles]]
type = "wall"
distance = "1 m"
surface = {preset = "wall", shared_by = 2, dissipation = "0.432 s/m", friction_axes = "vertical"}
[start]
position = ["0.25 m", 0, "1 m"]
velocity = ["1.85 m/s", 0, 0]
[model]
contact_point = "paper"
slider = [1, 0, 0]
[sensors.imu.accelerometer]
noise = "0.022 m/s^2/Hz^0.5"
[sensors.motion_capture]
position_noise = "0.5 mm"
[simulation]
duration = "0.6 s"
"""
FREE = {
    "world.obstacles.0.surface.stiffness": "2e5 factor 4",
    "world.obstacles.0.surface.dissipation": "factor 4",
    "vehicle.arms.stiffness": "factor 4",
    "vehicle.arms.damping": "factor 4",
}


def rig_folder(folder: Path, hits: tuple[str, ...] = ("1.85 m/s",)) -> Path:
    """Write the scenario, and the flight of a hit for each speed: ``hit0`` and so on."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "rig.toml").write_text(RIG)
    for k, speed in enumerate(hits):
        changes = [f'start.velocity.0="{speed}"', f"seed={k}"]
        flight = fly(read_scenario(folder / "rig.toml", changes))
        save_flight(flight, folder / f"hit{k}", figures=False)
    return folder


def rig_plan(hits: int = 1, starts: int = 2) -> FitPlan:
    """Plan of a fit to the hits of a folder."""
    flights = [{"logs": [f"hit{k}"]} for k in range(hits)]
    plan = {"name": "rig", "scenario": "rig.toml", "flights": flights, "free": FREE}
    known = {"vehicle.arms.directions": "exact"}  # what a degree of them moves is what is tested
    return FitPlan.model_validate(plan | {"starts": starts, "known": known})


@functools.cache
def rig_fit(*hits: str) -> FitResult:
    """Fit of hits at some speeds, flown once for all tests."""
    with tempfile.TemporaryDirectory() as folder:
        rig_folder(Path(folder), hits or ("1.85 m/s",))
        return fit(rig_plan(max(len(hits), 1)), folder)
