"""springback: simulation of micro aerial vehicles that survive collisions.

The public names, in the order of the documentation; each is loaded on first use.
"""

from __future__ import annotations

from springback.results.hooks import provide as _provide
from springback.version import __version__ as __version__

# Not imported from typing: until Ctrl-C is handled, it shows a traceback.  The annotation keeps
# Jedi (IPython, Jupyter, editors) from taking what follows for dead code.
TYPE_CHECKING: bool = False
if TYPE_CHECKING:
    from springback.batch.pair import PairOfFlights as PairOfFlights
    from springback.batch.pair import fly_pair as fly_pair
    from springback.campaign.access import Campaign as Campaign
    from springback.campaign.design.plan import Plan as Plan
    from springback.campaign.errors import CampaignError as CampaignError
    from springback.campaign.running import run_campaign as run_campaign
    from springback.contact.laws.restitution import dissipation_for as dissipation_for
    from springback.contact.laws.restitution import restitution as restitution
    from springback.contact.library import MAT as MAT
    from springback.contact.library import WALL as WALL
    from springback.contact.obstacles import outward_normal as outward_normal
    from springback.contact.obstacles import signed_distance as signed_distance
    from springback.contact.parameters import Ground as Ground
    from springback.contact.parameters import Mat as Mat
    from springback.contact.parameters import SurfaceSettings as SurfaceSettings
    from springback.contact.parameters import Wall as Wall
    from springback.errors import InputError as InputError
    from springback.interfaces.figures.plot import plot as plot
    from springback.kernels.compiler import kernel as kernel
    from springback.kernels.vectors import Quat as Quat
    from springback.kernels.vectors import Vec as Vec
    from springback.kernels.vectors import rotation as rotation
    from springback.paper.slider import Interpretation as Interpretation
    from springback.paper.slider import slider_experiments as slider_experiments
    from springback.recovery.detection import CollisionInputs as CollisionInputs
    from springback.recovery.detector import DetectorStep as DetectorStep
    from springback.recovery.detector import detector_step as detector_step
    from springback.results.flight import Flight as Flight
    from springback.results.flight import fly as fly
    from springback.results.saved import load as load
    from springback.scenario.avionics import CompiledDetector as CompiledDetector
    from springback.scenario.avionics import CompiledEstimator as CompiledEstimator
    from springback.scenario.avionics import CompiledPilot as CompiledPilot
    from springback.scenario.files import read_scenario as read_scenario
    from springback.scenario.scenario import Scenario as Scenario
    from springback.scenario.user.builders import PilotContext as PilotContext
    from springback.scenario.worlds.toml_text import read_world as read_world
    from springback.sensing.measurement import Estimate as Estimate
    from springback.sensing.measurement import EstimatorStep as EstimatorStep
    from springback.sensing.measurement import Measurement as Measurement
    from springback.sensing.measurement import estimator_step as estimator_step
    from springback.simulation.flight import fly_many as fly_many
    from springback.simulation.measuring.measures import MEASURES as MEASURES
    from springback.simulation.measuring.measures import Outcome as Outcome
    from springback.simulation.onboard import PilotOutput as PilotOutput
    from springback.simulation.onboard import pilot_step as pilot_step
    from springback.simulation.onboard import telemetry_of as telemetry_of
    from springback.studies.pilot_check import Finding as Finding
    from springback.studies.pilot_check import check_pilot as check_pilot
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
    "restitution": "contact.laws.restitution", "dissipation_for": "contact.laws.restitution",
    "signed_distance": "contact.obstacles", "outward_normal": "contact.obstacles",
    "kernel": "kernels.compiler", "Vec": "kernels.vectors", "Quat": "kernels.vectors",
    "rotation": "kernels.vectors",
    "Measurement": "sensing.measurement", "Estimate": "sensing.measurement",
    "estimator_step": "sensing.measurement", "EstimatorStep": "sensing.measurement",
    "CompiledEstimator": "scenario.avionics", "CompiledDetector": "scenario.avionics",
    "detector_step": "recovery.detector", "DetectorStep": "recovery.detector",
    "CollisionInputs": "recovery.detection",
    "pilot_step": "simulation.onboard", "PilotOutput": "simulation.onboard",
    "telemetry_of": "simulation.onboard",
    "CompiledPilot": "scenario.avionics", "PilotContext": "scenario.user.builders",
    "check_pilot": "studies.pilot_check", "Finding": "studies.pilot_check",
    "Scenario": "scenario.scenario", "read_scenario": "scenario.files",
    "fly_pair": "batch.pair", "PairOfFlights": "batch.pair",
    "read_world": "scenario.worlds.toml_text",
    "fly": "results.flight", "Flight": "results.flight", "load": "results.saved",
    "fly_many": "simulation.flight", "plot": "interfaces.figures.plot",
    "Plan": "campaign.design.plan", "run_campaign": "campaign.running",
    "Campaign": "campaign.access", "CampaignError": "campaign.errors",
    "Outcome": "simulation.measuring.measures", "MEASURES": "simulation.measuring.measures",
    "slider_experiments": "paper.slider", "Interpretation": "paper.slider",
    "InputError": "errors",
}  # fmt: skip

_provide({
    "Flight.save": ("springback.interfaces.reports.flight_files", "save_flight"),
    "Flight.view": ("springback.interfaces.replay.viewer", "view_flights"),
    "Flight.animate": ("springback.interfaces.animation.film", "save_film"),
    "Flight.plot": ("springback.interfaces.figures.plot", "plot"),
    "Flight.html": ("springback.interfaces.reports.notebook", "flight_html"),
    "Campaign.plot": ("springback.interfaces.figures.plot", "plot_campaign"),
    "Campaign.html": ("springback.interfaces.reports.notebook", "campaign_html"),
})  # fmt: skip

__all__ = [*_PUBLIC, "__version__"]


def __getattr__(name: str) -> object:
    if name not in _PUBLIC:
        raise AttributeError(f"module 'springback' has no attribute {name!r}")
    import importlib

    value: object = getattr(importlib.import_module(f"springback.{_PUBLIC[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
