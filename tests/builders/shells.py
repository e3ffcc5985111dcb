"""Vehicles whose shell turns by itself, some millimetres in a wall; laws and obstacles for them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from oracles.models import vec
from springback.contact.obstacles import Plane
from springback.contact.parameters import SurfaceSettings
from springback.contact.surfaces import AnyExponent
from springback.dynamics.impulse import apply_impulses
from springback.dynamics.motion import Free, Motion
from springback.kernels.vectors import Mat3, Quat
from springback.results.flight import as_scenario
from springback.simulation.flight import model_state, still_work, with_spin
from springback.simulation.measuring.record import Model
from springback.vehicle.state import Shell, State, build_airframe

Array = np.ndarray[Any, np.dtype[np.float64]]

SURFACES: dict[str, dict[str, Any]] = {
    "hunt-crossley": {"preset": "wall", "friction": 0.5},
    "kelvin-voigt": {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 20.0, "friction": 0.5},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.4, "friction": 0.5},
    "bristle": {"preset": "wall", "friction": 0.5, "friction_law": "bristle"},
    "impulse": {"law": "impulse", "restitution": 0.4, "friction": 0.5},
}

#: Every law meets every one of `obstacles_around`, but for impulses, which nothing that moves takes.
MEETINGS = [
    (law, obstacle)
    for law in SURFACES
    for obstacle in ("wall", "pole", "ball")
    if (law, obstacle) != ("impulse", "ball")
]


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


class Struck(NamedTuple):
    """Jumps by an impulse, world axes, and what an oracle says of that impulse."""

    friction: float  # μ
    given: Array  # the impulse [N s]
    found: tuple[Array, ...]  # Δv, Δω (body axes) and jump of the spin
    expected: tuple[Array, ...]
    lost: float  # energy, as booked [J]

    def check(self, into: Array, before: Array, after: Array) -> bool:
        """Within the cone, and all work done is booked; True if it sticks.

        Args:
            into: Normal into the wall, world.
            before: Velocity of the point that touches, world [m/s].
            after: Likewise, after the impulse.
        """
        for mine, other in zip(self.found, self.expected, strict=True):
            scale = max(1.0, np.abs(other).max())
            assert np.abs(mine - other).max() < 1e-11 * scale
        pressed = -(self.given @ into)
        rubbed = np.linalg.norm(self.given + pressed * into)
        assert pressed > 0.0
        assert rubbed <= self.friction * pressed * (1.0 + 1e-12)
        assert after @ into < 0.0
        work = self.given @ (before + after) / 2.0
        assert abs(self.lost + work) < 1e-9 * max(1.0, abs(work))
        left = np.linalg.norm(after - (after @ into) * into)
        # To an increment of the impulse: 200 of them make up the compression.
        return bool(left < 0.01 * np.linalg.norm(before))


def struck(
    model: Model, state: State, friction: float,
    accelerations: Callable[[Array], tuple[Array, ...]],
) -> Struck:  # fmt: skip
    """Impulses of a vehicle that approaches a wall, beside an oracle.

    Args:
        model: With a wall, of any law.
        state: Before.
        friction: μ of the wall.
        accelerations: Of the oracle under a force at the point of contact: v̇, ω̇ and the rate of
            the spin.  They are linear in the force, so that an impulse is their difference to those
            without.
    """
    [wall] = model.world.obstacles
    law = SurfaceSettings(**{**SURFACES["impulse"], "friction": friction}).surface(AnyExponent)
    world = model.world._replace(obstacles=(wall._replace(surface=law),), gravity=0.0)
    before = Motion(state, still_work())
    after = apply_impulses(model.airframe, world, model.contact_point, Free(0.0), before)
    given, new = np.array(after.work.impulse), after.state
    found = tuple(
        np.array(then) - np.array(now)
        for then, now in (
            (new.velocity, state.velocity),
            (new.angular_velocity, state.angular_velocity),
            (new.memory.hull[0].spin[0], state.memory.hull[0].spin[0]),
        )
    )
    none = accelerations(np.zeros(3))
    expected = tuple(a - b for a, b in zip(accelerations(given), none, strict=True))
    return Struck(friction, given, found, expected, after.work.contact + after.work.friction)
