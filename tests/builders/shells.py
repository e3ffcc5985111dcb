"""Vehicles whose shell turns by itself, some millimetres in a wall; laws and obstacles for them."""

from __future__ import annotations

from typing import Any

import numpy as np

from oracles.models import vec
from springback.contact.obstacles import Plane
from springback.kernels.vectors import Mat3, Quat
from springback.results.flight import as_scenario
from springback.simulation.flight import model_state, with_spin
from springback.simulation.measuring.record import Model
from springback.vehicle.state import Shell, State, build_airframe

Array = np.ndarray[Any, np.dtype[np.float64]]

SURFACES: dict[str, dict[str, Any]] = {
    "hunt-crossley": {"preset": "wall", "friction": 0.5},
    "kelvin-voigt": {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 20.0, "friction": 0.5},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.4, "friction": 0.5},
    "bristle": {"preset": "wall", "friction": 0.5, "friction_law": "bristle"},
}


def obstacles_around(height: float) -> dict[str, dict[str, Any]]:
    """A wall, a pole, and a ball that moves freely, whose centre is at a height [m]."""
    return {
        "wall": {"type": "wall", "distance": 1.0},
        "pole": {"type": "pole", "position": [1.1, 0.6, 1.0], "radius": 0.1},
        "ball": {
            "type": "sphere", "position": [1.1, 0.6, height], "radius": 0.1,
            "motion": {"type": "free", "mass": 0.5},
        },
    }  # fmt: skip


def in_a_wall(
    given: dict[str, Any], shell: Shell, craft: Any, pose: Any, spin: Array, into: Array,
    depth: float,
) -> tuple[Model, State]:  # fmt: skip
    """Model and state of a vehicle with a shell, pressed into a wall.

    Arms are without mass, their cages within the shell: the main body is everything.

    Args:
        given: Tables of a vehicle at a wall.
        shell: Its shell, which touches as a sphere.
        craft: Of an oracle: its inertia ``together``, ``centre`` of the shell, ``gravity``.
        pose: Of an oracle: attitude, velocity, omega.
        spin: Of the shell, world [rad/s].
        into: Normal into the wall, world.
        depth: Of the contact [m].
    """
    given["vehicle"] |= {"hulls": [], "arms": {"cages": True}}  # without hulls there is no scene
    model = as_scenario(given).build().model
    inertia = Mat3(*(vec(row) for row in craft.together))
    arms = tuple(arm._replace(mass=0.0, cage_radius=0.01) for arm in model.airframe.arms)
    airframe = build_airframe(model.airframe.mass, inertia, arms, (shell,))
    reach = into @ (pose.rotation @ craft.centre) + shell.radius - depth
    [wall] = model.world.obstacles
    assert isinstance(wall.shape, Plane)
    plane = wall.shape._replace(normal=vec(-into), offset=-reach)
    world = model.world._replace(obstacles=(wall._replace(shape=plane),), gravity=craft.gravity)
    model = model._replace(airframe=airframe, world=world, thrust=(0.0,) * len(arms))
    still = model_state(model)
    state = still._replace(
        attitude=Quat(*map(float, pose.attitude)), velocity=vec(pose.velocity),
        angular_velocity=vec(pose.omega), memory=with_spin(still.memory, vec(spin)),
        arm_length=tuple(arm.length for arm in arms),
    )  # fmt: skip
    return model, state
