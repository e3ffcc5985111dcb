"""Vehicles that list their rotors: of the oracles' crafts, and as users write them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from builders import joint_crafts
from oracles import models
from oracles.blowers import Blower
from oracles.joint_lagrangian import Craft
from springback.kernels.vectors import Vec
from springback.simulation.measuring.record import Model
from springback.vehicle.placed.rotors import PlacedRotor, PlacedRotors
from springback.vehicle.placed.settings import disc_axes
from springback.vehicle.state import Propeller


def bare(craft: Craft) -> Craft:
    """A craft whose arms have no rotors."""
    limbs = tuple(replace(limb, thrust=0.0, torque_ratio=0.0) for limb in craft.limbs)
    return replace(craft, limbs=limbs)


def placed(
    blowers: tuple[Blower, ...], arms: int, disc: tuple[Propeller, ...] = ()
) -> PlacedRotors:
    """The package's constants of some rotors, which pilots all use."""
    each = tuple(
        PlacedRotor(
            float(one.limb + 1), models.vec(one.offset), disc_axes(Vec(*one.axis.tolist())),
            one.torque_ratio, 1.0, disc,
        )
        for one in blowers
    )  # fmt: skip
    return PlacedRotors(each, tuple(float(j + 1) for j in range(arms)), 1.0)


def with_rotors(model: Model, blowers: tuple[Blower, ...]) -> Model:
    """A model whose vehicle has these rotors alone."""
    arms = model.airframe.arms
    silent = tuple(arm._replace(torque_ratio=0.0) for arm in arms)
    listed = placed(blowers, len(arms))
    return model._replace(
        airframe=model.airframe._replace(arms=silent, rotors=listed),
        thrust=tuple(one.thrust for one in blowers),
        reaction=(tuple(one.extra for one in blowers),),
    )


def model_of(craft: Craft, blowers: tuple[Blower, ...], scene: models.Scene | None = None) -> Model:
    """The package's model of a craft with these rotors alone."""
    return with_rotors(joint_crafts.model_of(bare(craft), scene), blowers)


# -- as users write them ---------------------------------------------------------------------------

BODY = {"mass": 0.4, "inertia": [1.2e-3, 1.2e-3, 2e-3]}


def canted(tilt: float, count: int = 6) -> list[dict[str, Any]]:
    """Rotors on evenly spaced arms, tilted by turns to either side about their arm [rad]."""
    found = []
    for j in range(count):
        azimuth, lean = math.tau / count * j, tilt if j % 2 else -tilt
        x, y = math.sin(lean) * math.sin(azimuth), -math.sin(lean) * math.cos(azimuth)
        found.append({"on": j + 1, "axis": [x, y, math.cos(lean)]})
    return found


def coaxial(count: int = 4) -> list[dict[str, Any]]:
    """Two rotors at the end of each arm, one above the other, that spin apart."""
    return [
        {"on": j + 1, "position": [0.0, 0.0, height], "spin": sign * (1 if j % 2 else -1)}
        for j in range(count)
        for height, sign in ((0.03, 1), (-0.03, -1))
    ]


def vehicle_with(
    rotors: list[dict[str, Any]], count: int = 6, legs: int = 0, **changes: Any
) -> dict[str, Any]:
    """A vehicle of evenly spaced arms, then of shorter ones in between that have no rotor."""
    step = math.tau / count
    directions = [step * j for j in range(count)] + [step * (j + 0.5) for j in range(legs)]
    return {
        "name": "listed", "body": BODY, "rotors": rotors,
        "arms": {
            "directions": directions, "length": [0.165] * count + [0.09] * legs,
            "mass": [0.03] * count + [0.005] * legs, "stroke": 0.03,
            "cage_radius": [0.07] * count + [0.01] * legs, "torque_ratio": 0.0127,
        },
        "propulsion": {"max_thrust": 2.5, "disk_radius": 0.0635},
        **changes,
    }  # fmt: skip


def of_each_arm(count: int) -> list[dict[str, Any]]:
    """The rotors that a vehicle has without a list, listed."""
    return [{"on": j + 1} for j in range(count)]


def numbers(rotors: list[dict[str, Any]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Axes of listed rotors, shape (rotors, 3)."""
    return np.array([one.get("axis", [0.0, 0.0, 1.0]) for one in rotors])
