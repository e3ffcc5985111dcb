"""Headlines of papers whose numbers are not public, as ratios of two flights each.

A headline is no validation: what was hit, and how, is not known, and most of each vehicle is
chosen.  Asked is the direction, and a factor of two where the headline has a number.

- s-ARQ (arXiv:2305.14680): one compliant arm, 4 % heavier, some 40 % less peak acceleration than
  its rigid frame in drops and wall hits at 3 m/s.  Here: the preset `quad`, whose front left arm
  slides as an arm of `arq`; that arm ahead, or below.
- XPLORER (arXiv:2105.12273): rebounds slower than a rigid vehicle of its size.  Here: the preset
  `xplorer` and the same with its hinges locked, both front cages at a wall.
- FlexiQuad (arXiv:2511.05426): 405 g, a glancing hit with 1/39 of a rigid frame's force; best with
  frames of up to 0.77 N/mm, three orders of magnitude softer than a conventional frame.  Here: the
  preset `quad` of that mass against a wall that is as soft as the soft frame, and as the rigid one:
  frame and wall are springs in series, and the wall is the stiffer by far.

    python -m springback.studies.recordings.printed_ratios
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.results.flight import Flight, fly
from springback.studies.recordings.command import run_study
from springback.vehicle.library import VEHICLES

#: Speed of both hits of s-ARQ [m/s], its peak over that of its rigid frame, and its mass over that.
SPEED, PEAK_RATIO, MASS_RATIO = 3.0, 0.6, 1.04
#: Speeds at which XPLORER hits a wall [m/s] (chosen).
SPEEDS = (1.0, 2.0, 3.0)
#: A number is met within this factor.
FACTOR = 2.0
#: Gap before a touch [m], time flown [s] (chosen: both vehicles are off again by then).
GAP, DURATION = 0.01, 0.3
#: Mass of FlexiQuad [kg], force of its glancing hit over that of a rigid frame, stiffness of a
#: frame [N/m], and how much stiffer a conventional one is, all from the abstract.
FLEXIQUAD, FORCE_RATIO, FRAME_STIFFNESS, STIFFER = 0.405, 1.0 / 39.0, 770.0, 1000.0
#: Angles between its way and the wall [rad] (chosen: "glancing"), at `SPEED`, and restitution at
#: that speed (chosen, the same of both).
GLANCING, RESTITUTION = (math.radians(15.0), math.radians(30.0), math.radians(45.0)), 0.6
#: Ratios that are printed.
PRINTED = {"s-ARQ": PEAK_RATIO, "FlexiQuad": FORCE_RATIO}


class VehicleRatio(NamedTuple):
    """Of a compliant and a rigid vehicle in the same hit."""

    name: str
    compliant: float
    rigid: float
    unit: str

    @property
    def value(self) -> float:
        """The compliant over the rigid."""
        return self.compliant / self.rigid


def one_arm_vehicle(compliant: bool) -> dict[str, Any]:
    """The preset `quad`, and the same with one arm of `arq` and 4 % of mass more."""
    tables, other = VEHICLES["quad"].vehicle.model_dump(), VEHICLES["arq"].vehicle
    if compliant:
        mass, count = float(other.arms.at("mass", 0)), len(other.arms.directions)
        tables["body"]["mass"] = MASS_RATIO * tables["body"]["mass"] - mass
        tables["arms"] |= {
            "compliant": [True] + [False] * (count - 1),
            "mass": [mass] + [0.0] * (count - 1),
        }
    return tables


def locked_vehicle(name: str) -> dict[str, Any]:
    """A preset with its arms locked."""
    tables = VEHICLES[name].vehicle.model_dump()
    tables["arms"] |= {"compliant": False}
    return tables


def glancing_tables(stiffness: float, angle: float) -> dict[str, Any]:
    """A glancing hit of FlexiQuad, level and without gravity.

    Args:
        stiffness: Of frame and wall together [N/m].
        angle: Between its way and the wall [rad].
    """
    vehicle = VEHICLES["quad"].vehicle.model_dump()
    scale = FLEXIQUAD / VEHICLES["quad"].vehicle.mass
    vehicle["body"]["mass"] *= scale
    vehicle["body"]["inertia"] = [[scale * x for x in row] for row in vehicle["body"]["inertia"]]
    surface = {
        "law": "hunt-crossley", "stiffness": stiffness, "exponent": 1.0, "friction": 0.3,
        "restitution": RESTITUTION, "restitution_speed": SPEED,
    }  # fmt: skip
    tables = hit_tables(vehicle, SPEED * math.sin(angle), False, 0.0)
    tables["start"]["velocity"][1] = SPEED * math.cos(angle)
    tables["world"]["obstacles"][0]["surface"] = surface
    return tables


def hit_tables(vehicle: dict[str, Any], speed: float, down: bool, yaw: float) -> dict[str, Any]:
    """A hit of a wall, level and without gravity, or of the ground with the first arm below.

    Args:
        vehicle: Tables.
        speed: At the start, just before the touch [m/s].
        down: At the ground.
        yaw: At the wall [rad].
    """
    if down:
        first = float(vehicle["arms"]["directions"][0])
        # About body z until the arm points ahead, then nose down by a quarter turn.
        c, s, half = math.cos(-0.5 * first), math.sin(-0.5 * first), math.sqrt(0.5)
        start: dict[str, Any] = {"quaternion": [half * c, half * s, half * c, half * s]}
        start |= {"position": [0.0, 0.0, 5.0], "velocity": [0.0, 0.0, -speed]}
        obstacle: dict[str, Any] = {"type": "ground", "surface": "wall"}
    else:
        start = {"yaw": yaw, "velocity": [speed, 0.0, 0.0]}
        obstacle = {"type": "wall", "distance": 2.0, "surface": "wall"}
    return {
        "vehicle": vehicle,
        "thrust": 0.0,
        "world": {"obstacles": [obstacle], "gravity": 9.81 if down else 0.0},
        "start": start | {"touch_distance": GAP},
        "simulation": {"duration": DURATION},
    }


def hit_flight(vehicle: dict[str, Any], speed: float, down: bool, yaw: float) -> Flight:
    """Fly a hit; arguments as for `hit_tables`."""
    return fly(hit_tables(vehicle, speed, down, yaw), trajectory=False)


def _measure(flight: Flight, name: str) -> float:
    value = flight.measures[name]
    return math.nan if value is None else float(value)


def ratios() -> Iterator[VehicleRatio]:
    """Fly all pairs."""
    for down, where in ((False, "wall"), (True, "drop")):
        yaw = -float(VEHICLES["quad"].vehicle.arms.directions[0])
        soft, hard = (
            _measure(hit_flight(one_arm_vehicle(one), SPEED, down, yaw), "impact_peak_acceleration")
            for one in (True, False)
        )
        yield VehicleRatio(
            f"s-ARQ, {where} at {SPEED:g} m/s, peak acceleration", soft, hard, "m/s^2"
        )
    for speed in SPEEDS:
        vehicles = VEHICLES["xplorer"].vehicle.model_dump(), locked_vehicle("xplorer")
        soft, hard = (
            speed * _measure(hit_flight(one, speed, False, 0.0), "restitution_of_mass_centre")
            for one in vehicles
        )
        yield VehicleRatio(
            f"XPLORER, wall at {speed:g} m/s, speed of the rebound", soft, hard, "m/s"
        )
    for angle in GLANCING:
        soft, hard = (
            _measure(fly(glancing_tables(one, angle), trajectory=False), "impact_peak_normal_force")
            for one in (FRAME_STIFFNESS, STIFFER * FRAME_STIFFNESS)
        )
        yield VehicleRatio(
            f"FlexiQuad, glancing at {math.degrees(angle):.0f} deg, peak normal force",
            soft, hard, "N",
        )  # fmt: skip


def ratio_lines(folder: Path | None = None) -> Iterator[str]:
    """What each pair gave.

    Raises:
        InputError: If a folder is named: there is none to read.
    """
    if folder is not None:
        raise InputError(f"{folder}: this study reads no recordings; name nothing")
    for one in ratios():
        said = (
            f"{one.name}: {one.compliant:.3g} against {one.rigid:.3g} {one.unit}: {one.value:.2g}"
        )
        printed = next((value for key, value in PRINTED.items() if one.name.startswith(key)), None)
        if printed is not None:
            near = printed / FACTOR <= one.value <= printed * FACTOR
            said += f", {printed:.2g} printed: within a factor of {FACTOR:g}: {_yes(near)}"
        yield f"{said}; less: {_yes(one.value < 1.0)}"


def _yes(true: bool) -> str:
    return "yes" if true else "no"


if __name__ == "__main__":
    sys.exit(run_study(ratio_lines, sys.argv[1:]))
