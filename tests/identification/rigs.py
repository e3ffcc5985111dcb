"""Slider impacts with springback's own sensors, for tests of fits."""

from __future__ import annotations

import copy
from dataclasses import replace
from pathlib import Path
from typing import Any

from springback.identification.fits import fields_of_plan
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import impact_window
from springback.identification.settings import FitPlan
from springback.logs.recording import ARM_LENGTH, Recording
from springback.logs.segments import find_impacts
from springback.logs.writing.flight_recording import flight_recording
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from

STIFFNESS, LOSS = "world.obstacles.0.surface.stiffness", "world.obstacles.0.surface.dissipation"
SPRING, DAMPER = "vehicle.arms.stiffness", "vehicle.arms.damping"
#: What the rigs have.
TRUE = {STIFFNESS: 2e5, LOSS: 0.432, SPRING: 5000.0, DAMPER: 90.0}
#: Exact, by hand, so that few numbers are fitted.
EXACT = {
    "vehicle.body.mass": "exact", "vehicle.arms.mass": "exact",
    "vehicle.arms.directions": "exact",
}  # fmt: skip


def rig(vehicle: str = "quad", speed: float = 1.85, **sensors: Any) -> dict[str, Any]:
    """Scenario of a slider impact after 0.3 s, accelerometer of 0.5 m/s² a sample."""
    surface = {"preset": "wall", "shared_by": 2, "dissipation": 0.432, "friction_axes": "vertical"}
    return {
        "vehicle": {"preset": f"{vehicle}-slider"},
        "world": {"obstacles": [{"type": "wall", "distance": 2.0, "surface": surface}]},
        "start": {"position": [2.0 - 0.3 * (2.0**-0.5 + speed), 0.0, 1.0], "velocity": [speed, 0.0, 0.0]},
        "model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": 0.55},
        "seed": 1,
        "sensors": {
            "imu": {"accelerometer": {"noise": 0.0224}},
            "motion_capture": {"position_noise": 5e-4},
            "hall": {"perfect": True},
        } | sensors,
    }  # fmt: skip


def recorded(tables: dict[str, Any], *, arms: bool = False) -> Recording:
    """What the sensors of a flight gave."""
    found = flight_recording(fly(scenario_from(copy.deepcopy(tables))), Path("rig"))
    kept = [one for one in found.channels if arms or one.quantity != ARM_LENGTH]
    return replace(found, channels=tuple(kept))


def problem_of(
    tables: dict[str, Any], recording: Recording, free: dict[str, str], **plan: Any
) -> ImpactProblem:
    """Likelihood of the first impact of a recording."""
    known = {
        name: uncertainty
        for name, uncertainty in EXACT.items()
        if name not in plan.get("known", {})
    }
    ready = FitPlan.model_validate(
        {"scenario": "rig.toml", "free": free, **plan, "known": known | plan.get("known", {})}
    )
    scenario = scenario_from(copy.deepcopy(tables))
    [impact] = [one for one in find_impacts([recording]) if not one.refused][:1]
    readings = impact_window(ready, scenario, [recording], impact)
    return ImpactProblem(ready, scenario, tables, fields_of_plan(ready, scenario), readings)
