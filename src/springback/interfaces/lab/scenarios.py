"""Scenarios of the impact lab, one for each robot.

The lab flies the same text that it offers for download, so `springback fly` gives the same numbers.
"""

from __future__ import annotations

import math
import tomllib
from typing import Any

import numpy as np
import tomli_w

from springback.contact.cage import ArmTip, Ring, support
from springback.interfaces.lab.settings import DEFAULTS, LabSettings, digits, query_of
from springback.interfaces.output.robots import robot_label
from springback.kernels.vectors import Vec
from springback.paper.slider import MAT_THICKNESS
from springback.scenario.files import checked_scenario
from springback.scenario.model import RING_ROUNDING
from springback.scenario.scenario import Scenario
from springback.studies.run_ups import WALL_DISTANCE, run_up_scenario
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle

#: Time before and after first touch of an impact [s] (chosen: contacts last up to 0.1 s).
BEFORE, AFTER = 0.025, 0.3
#: Duration of a flight with run-up, recovery and return, and of one without recovery [s] (chosen).
DURATION, UNANSWERED = 8.0, 5.0
#: Height of all flights [m], as in the paper.
HEIGHT = 1.0
GRAVITY = 9.81

Table = dict[str, Any]


def robots_of(settings: LabSettings) -> tuple[str, ...]:
    """Names of the robots to fly."""
    return ("arq", "quad") if settings.robot == "both" else (settings.robot,)


def lab_tables(settings: LabSettings, robot: str) -> Table:
    """Scenario of some settings, as plain tables.

    Args:
        settings: Settings of the lab.
        robot: ``arq`` or ``quad``.
    """
    return _flight(settings, robot) if settings.mode == "flight" else _impact(settings, robot)


def lab_toml(settings: LabSettings, robot: str) -> str:
    """`lab_tables` as the text of a scenario file."""
    query = query_of(settings)
    head = f"# From the impact lab: {query}\n" if query else "# From the impact lab, as it opens.\n"
    return (
        f"{head}#   springback fly {file_name(settings, robot)} --out results\n"
        f"{tomli_w.dumps(lab_tables(settings, robot))}"
    )


def file_name(settings: LabSettings, robot: str) -> str:
    """File name of a downloaded scenario; it contains no text from outside."""
    return f"{settings.mode}-{robot}.toml"


def lab_scenario(settings: LabSettings, robot: str) -> Scenario:
    """Scenario read back from `lab_toml`.

    Raises:
        InputError: If it cannot be flown; one line for each problem.
    """
    text = lab_toml(settings, robot)
    return checked_scenario(tomllib.loads(text), file_name(settings, robot), text, ())


# -- impact ---------------------------------------------------------------------------------------


def _impact(s: LabSettings, robot: str) -> Table:
    """The collision alone, with its start computed backwards from first touch.

    Before it no moment acts on the robot, and its rotors, of equal thrust, accelerate it uniformly:
    it hits the wall at the requested speed, and level.
    """
    slides = s.guide == "slider"
    vehicle, pitch, yaw = VEHICLES[f"{robot}-slider" if slides else robot].vehicle, s.pitch, s.yaw
    thrust = np.zeros(3) if slides else GRAVITY * (_upward(pitch, yaw) - np.array([0.0, 0.0, 1.0]))
    touch = np.array([WALL_DISTANCE - _reach(vehicle, pitch, yaw, slides), 0.0, HEIGHT])
    velocity = np.array([s.speed, 0.0, 0.0])
    start = touch - velocity * BEFORE + 0.5 * thrust * BEFORE**2
    given: Table = {
        "name": _name(s, robot),
        "vehicle": _vehicle(s, robot, vehicle.name),
        "world": {"obstacles": [_obstacle(s, WALL_DISTANCE, slides)]},
        "start": {
            "position": [float(x) for x in start],
            "velocity": [float(x) for x in velocity - thrust * BEFORE],
            "pitch": f"{digits(pitch)} deg",
            "yaw": f"{digits(yaw)} deg",
        },
        "simulation": {"duration": BEFORE + AFTER},
    }
    if slides:
        return given | {"model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]}}
    return given | {"thrust": "hover"}


def _inward(pitch: float, yaw: float) -> Vec:
    """World X axis in body axes, at a pitch and yaw [deg]."""
    theta, psi = math.radians(pitch), math.radians(yaw)
    return Vec(math.cos(psi) * math.cos(theta), -math.sin(psi), math.cos(psi) * math.sin(theta))


def _upward(pitch: float, yaw: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Direction of the rotors' thrust in world axes, at a pitch and yaw [deg]."""
    theta, psi = math.radians(pitch), math.radians(yaw)
    tilt = math.sin(theta)
    return np.array([math.cos(psi) * tilt, math.sin(psi) * tilt, math.cos(theta)])


def _reach(vehicle: Vehicle, pitch: float, yaw: float, slides: bool) -> float:
    """Distance from the main body to the wall at first touch [m].

    On the slider by the paper's contact point, eq. (13); else by the ring, whose rounding makes it
    touch a few µm before its foremost point would.
    """
    n, model = _inward(pitch, yaw), ArmTip(0.0) if slides else Ring(RING_ROUNDING)
    ends = []
    for j, angle in enumerate(vehicle.arms.directions):
        arm = Vec(math.cos(angle), math.sin(angle), 0.0)
        at = support(model, n, arm, vehicle.arms.at("cage_radius", j))
        ends.append(n @ (arm * vehicle.arms.at("length", j) + at.point) - at.inset)
    return float(max(ends))


# -- flight ---------------------------------------------------------------------------------------


def _flight(s: LabSettings, robot: str) -> Table:
    """Run-up, collision and recovery; a yaw turns the wall, unknown to the pilot."""
    psi = math.radians(s.yaw)
    wall = _obstacle(s, WALL_DISTANCE, slides=False)
    if s.yaw != 0.0:
        del wall["distance"]
        wall["position"] = [WALL_DISTANCE, 0.0, 0.0]
        wall["normal"] = [-math.cos(psi), math.sin(psi), 0.0]
        if s.surface == "mat":  # the face stays where the robot expects it
            wall["position"][0] += MAT_THICKNESS / math.cos(psi)
    given = run_up_scenario(robot, s.pitch, s.speed)
    given |= {
        "name": _name(s, robot),
        "vehicle": _vehicle(s, robot, robot),
        "world": {"obstacles": [wall, {"type": "ground", "surface": "wall"}]},
        "simulation": {"duration": DURATION},
    }
    if s.recovery == "none":
        return given | {"simulation": {"duration": UNANSWERED}}
    return given | {"recovery": {"response": {"way": s.recovery}}}


# -- both -----------------------------------------------------------------------------------------


def _name(s: LabSettings, robot: str) -> str:
    where = {"wall": "wall", "mat": "mat", "own": "own surface"}[s.surface]
    slides = ", slider" if s.mode == "impact" and s.guide == "slider" else ""
    return f"{robot_label(robot)}, {digits(s.speed)} m/s, {digits(s.pitch)} deg, {where}{slides}"


def _vehicle(s: LabSettings, robot: str, preset: str) -> Any:
    """The preset with its changes; Quad's arms have no springs to change."""
    arms = {}
    for name, unit, key in (
        ("stiffness", "N/mm", "stiffness"), ("damping", "N s/m", "damping"),
        ("arm_mass", "g", "mass"),
    ):  # fmt: skip
        value = getattr(s, name)
        if robot == "arq" and value != getattr(DEFAULTS, name):
            arms[key] = f"{digits(value)} {unit}"
    return {"preset": preset, "arms": arms} if arms else preset


def _obstacle(s: LabSettings, face: float, slides: bool) -> Table:
    """Wall or mat whose face is at a distance [m]."""
    more: Table = {"friction_axes": "vertical"} if slides else {}
    if s.surface == "mat":
        mat, wall = ({"preset": name, **more} if more else name for name in ("mat", "wall"))
        distance = face + MAT_THICKNESS
        return {
            "type": "mat", "distance": distance, "thickness": MAT_THICKNESS, "surface": mat,
            "backing": wall,
        }  # fmt: skip
    surface: Any = {"preset": "wall", **more} if more else "wall"
    if s.surface == "own":
        surface = {
            "stiffness": 1e3 * s.contact_stiffness, "shared_by": 2, "friction": s.friction,
            "dissipation": s.dissipation, **more,
        }  # fmt: skip
    return {"type": "wall", "distance": face, "surface": surface}
