"""springback: micro aerial vehicles that survive hitting things, simulated.

The public names, in the order of the story; each is loaded when first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from springback.version import __version__ as __version__

if TYPE_CHECKING:
    from springback.contact.library import MAT as MAT
    from springback.contact.library import WALL as WALL
    from springback.contact.obstacles import outward_normal as outward_normal
    from springback.contact.obstacles import signed_distance as signed_distance
    from springback.contact.parameters import Ground as Ground
    from springback.contact.parameters import Mat as Mat
    from springback.contact.parameters import SurfaceSettings as SurfaceSettings
    from springback.contact.parameters import Wall as Wall
    from springback.contact.restitution import dissipation_for as dissipation_for
    from springback.contact.restitution import restitution as restitution
    from springback.errors import InputError as InputError
    from springback.experiments.campaign.plan import Plan as Plan
    from springback.experiments.campaign.reading import Campaign as Campaign
    from springback.experiments.campaign.running import run_campaign as run_campaign
    from springback.experiments.campaign.stopped import Stopped as Stopped
    from springback.experiments.guidance import OwnPilot as OwnPilot
    from springback.experiments.paper.slider import Reading as Reading
    from springback.experiments.paper.slider import slider_experiments as slider_experiments
    from springback.experiments.pilot_check import Finding as Finding
    from springback.experiments.pilot_check import check_pilot as check_pilot
    from springback.experiments.result import Flight as Flight
    from springback.experiments.result import fly as fly
    from springback.experiments.scenario import Scenario as Scenario
    from springback.experiments.scenario_file import read_scenario as read_scenario
    from springback.kernels.compiler import kernel as kernel
    from springback.kernels.vectors import Quat as Quat
    from springback.kernels.vectors import Vec as Vec
    from springback.kernels.vectors import rotation as rotation
    from springback.sensing.measurement import Measurement as Measurement
    from springback.simulation.aboard import Piloted as Piloted
    from springback.simulation.aboard import piloted as piloted
    from springback.simulation.aboard import told as told
    from springback.simulation.flight import fly_many as fly_many
    from springback.simulation.measures import MEASURES as MEASURES
    from springback.simulation.measures import Outcome as Outcome
    from springback.vehicle.library import ARQ as ARQ
    from springback.vehicle.library import QUAD as QUAD
    from springback.vehicle.library import VEHICLES as VEHICLES
    from springback.vehicle.parameters import Arms as Arms
    from springback.vehicle.parameters import Body as Body
    from springback.vehicle.parameters import Hull as Hull
    from springback.vehicle.parameters import Vehicle as Vehicle

_PUBLIC = {
    "Vehicle": "vehicle.parameters", "Body": "vehicle.parameters", "Arms": "vehicle.parameters",
    "Hull": "vehicle.parameters",
    "ARQ": "vehicle.library", "QUAD": "vehicle.library", "VEHICLES": "vehicle.library",
    "SurfaceSettings": "contact.parameters", "Wall": "contact.parameters",
    "Ground": "contact.parameters", "Mat": "contact.parameters",
    "WALL": "contact.library", "MAT": "contact.library",
    "restitution": "contact.restitution", "dissipation_for": "contact.restitution",
    "signed_distance": "contact.obstacles", "outward_normal": "contact.obstacles",
    "kernel": "kernels.compiler", "Vec": "kernels.vectors", "Quat": "kernels.vectors",
    "rotation": "kernels.vectors",
    "Measurement": "sensing.measurement",
    "piloted": "simulation.aboard", "Piloted": "simulation.aboard", "told": "simulation.aboard",
    "OwnPilot": "experiments.guidance",
    "check_pilot": "experiments.pilot_check", "Finding": "experiments.pilot_check",
    "Scenario": "experiments.scenario", "read_scenario": "experiments.scenario_file",
    "fly": "experiments.result", "Flight": "experiments.result",
    "fly_many": "simulation.flight",
    "Plan": "experiments.campaign.plan", "run_campaign": "experiments.campaign.running",
    "Campaign": "experiments.campaign.reading", "Stopped": "experiments.campaign.stopped",
    "Outcome": "simulation.measures", "MEASURES": "simulation.measures",
    "slider_experiments": "experiments.paper.slider", "Reading": "experiments.paper.slider",
    "InputError": "errors",
}  # fmt: skip

__all__ = [*_PUBLIC, "__version__"]


def __getattr__(name: str) -> object:
    if name not in _PUBLIC:
        raise AttributeError(f"module 'springback' has no attribute {name!r}")
    value: object = getattr(importlib.import_module(f"springback.{_PUBLIC[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
