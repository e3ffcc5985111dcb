"""Rotors anywhere on a craft, on the main body or on an arm: plain numbers, and Lagrange's forces.

A rotor pushes along its axis at its place and turns about that axis.  Its generalised forces follow
from the virtual work of both, by differentiating the place and the angular velocity of what it is
fixed to; nothing here knows the package's equations.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.joint_lagrangian import (
    ACROSS,
    ROTATION,
    Craft,
    Pose,
    Q,
    U,
    angular_velocity,
    place_of_end,
    turn_of_end,
)

Array = NDArray[np.float64]

#: Of a rotor: end, axis and point of its arm, offset from its end, axis of its thrust, thrust, torque,
#: and whether that axis turns with the arm.
NAMES = sp.symbols("ex ey ez ax ay az px py pz dx dy dz ux uy uz f q follows", real=True)


@dataclass(frozen=True)
class Blower:
    """One rotor; vectors in the axes of what it is on, at c = 0."""

    limb: int  # number of its arm, from 0; -1 for the main body
    offset: Array  # from the end of the arm, or from the main body [m]
    axis: Array  # unit vector of the thrust
    torque_ratio: float  # with its sign [m]
    thrust: float  # [N]
    extra: float = 0.0  # torque about its axis besides [N m]

    @property
    def torque(self) -> float:
        """About its axis [N m]."""
        return self.torque_ratio * self.thrust + self.extra


@functools.cache
def _forces(kind: str) -> Any:
    """Function of the generalised forces of a rotor on an arm of a kind, or on the main body."""
    end, axis, point, offset, up = (sp.Matrix(NAMES[k : k + 3]) for k in (0, 3, 6, 9, 12))
    f, q, follows = NAMES[15:]
    spin = angular_velocity()
    if kind == "body":
        turned, at = sp.eye(3), sp.zeros(3, 1)
    else:
        turned, at = turn_of_end(kind, axis, Q[6]), place_of_end(kind, end, axis, point, Q[6])
        spin = spin + U[6] * axis if kind == "hinge" else spin
    place = Q[:3, 0] + ROTATION * (at + turned * offset)
    along = follows * turned * up + (1 - follows) * up
    force = place.jacobian(Q).T * (f * ROTATION * along) + spin.jacobian(U).T * (q * along)
    return sp.lambdify([*Q, *U, *NAMES], force, modules="numpy", cse=True)


def generalised_forces(craft: Craft, now: Pose, blowers: tuple[Blower, ...]) -> Array:
    """Of all rotors, on x, y, z, φ, θ, ψ and c of each arm."""
    psi, theta, phi = Rotation.from_quat(now.attitude, scalar_first=True).as_euler("ZYX")
    total, none = np.zeros(6 + len(craft.limbs)), np.zeros(9)
    for one in blowers:
        limb = craft.limbs[one.limb] if one.limb >= 0 else None
        kind, c, arm, follows = "body", 0.0, none, 1.0
        if limb is not None:
            kind, c, follows = limb.kind, now.bends[one.limb], float(limb.follows)
            arm = np.concatenate([limb.end, limb.axis, limb.point])
        numbers = [*arm, *one.offset, *one.axis, one.thrust, one.torque, follows]
        state = [*now.position, phi, theta, psi, c, *np.zeros(7)]
        force = _forces(kind)(*state, *numbers)[:, 0]
        total[:6] += force[:6]
        if one.limb >= 0:
            total[6 + one.limb] += force[6]
    return total


def random_blowers(rng: np.random.Generator, craft: Craft, count: int) -> tuple[Blower, ...]:
    """Rotors on arms and on the main body, some arms without any; any axis."""
    found = []
    for k in range(count):
        axis = rng.normal(size=3)
        found.append(
            Blower(
                limb=int(rng.integers(-1, len(craft.limbs) - 1)) if k else -1,
                offset=rng.uniform(-0.1, 0.1, size=3),
                axis=axis / np.linalg.norm(axis),
                torque_ratio=rng.uniform(-0.03, 0.03),
                thrust=rng.uniform(0.5, 4.0),
                extra=rng.uniform(-0.05, 0.05),
            )
        )
    return tuple(found)


def mirrored_blowers(blowers: tuple[Blower, ...]) -> tuple[Blower, ...]:
    """Seen in a mirror, y → −y: they spin the other way."""
    return tuple(
        replace(
            one, offset=one.offset * ACROSS, axis=one.axis * ACROSS,
            torque_ratio=-one.torque_ratio, extra=-one.extra,
        )
        for one in blowers
    )  # fmt: skip
