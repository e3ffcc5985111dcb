"""A body with a ring on a hinge, in MuJoCo and as two bodies with the forces of their joint.

MuJoCo brings inertia, gravity and the viscous bearing; contact is a force at a point of the ring.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]


@dataclass(frozen=True)
class RingCraft:
    """A body without its ring, and the ring; body axes, from the centre of mass of both."""

    mass: float  # of the body alone [kg]
    inertia: Array  # of the body alone, about its own centre of mass, shape (3, 3)
    ring_mass: float
    radius: float  # of the ring [m]
    centre: Array  # of the ring
    axis: Array  # of the ring, of length 1
    damping: float  # of the bearing [N m s]
    gravity: float = 9.81

    @property
    def body_centre(self) -> Array:
        """Centre of mass of the body alone."""
        return np.asarray(-self.ring_mass / self.mass * self.centre)

    @property
    def ring_inertia(self) -> Array:
        """Of a thin ring, about its centre."""
        along = np.outer(self.axis, self.axis)
        return np.asarray(self.ring_mass * self.radius**2 * 0.5 * (np.eye(3) + along))

    @property
    def together(self) -> Array:
        """Inertia about the common centre of mass, the ring held."""
        total = self.inertia + self.ring_inertia
        for mass, at in ((self.mass, self.body_centre), (self.ring_mass, self.centre)):
            total += mass * (at @ at * np.eye(3) - np.outer(at, at))
        return np.asarray(total)


@dataclass(frozen=True)
class RingPose:
    """How it moves."""

    attitude: Array  # (w, x, y, z), body to world
    velocity: Array  # of the common centre of mass, world
    omega: Array  # of the body, body axes
    spin: float  # a·Ω of the ring

    @property
    def rotation(self) -> Array:
        """Body to world."""
        return np.asarray(Rotation.from_quat(self.attitude, scalar_first=True).as_matrix())


class RingSecond(NamedTuple):
    """Second derivatives."""

    linear: Array  # of the common centre of mass, world
    angular: Array  # of the body, body axes
    spin: float  # d(a·Ω)/dt


def in_mujoco(craft: RingCraft, now: RingPose, force: Array, point: Array) -> RingSecond:
    """Accelerations with a force on a point of the ring, world axes, from the centre of mass."""
    # Of no thickness its moments are at the edge of what MuJoCo takes: across the axis, about which
    # both turn together, a part of the body's is counted with the ring.
    across = (
        0.1 * craft.ring_mass * craft.radius**2 * (np.eye(3) - np.outer(craft.axis, craft.axis))
    )
    i, j = craft.inertia - across, craft.ring_inertia + across
    full, ring = (
        " ".join(repr(float(x)) for x in (*of.diagonal(), of[0, 1], of[0, 2], of[1, 2]))
        for of in (i, j)
    )
    at = " ".join(repr(float(x)) for x in craft.centre)
    own = " ".join(repr(float(x)) for x in craft.body_centre)
    axis = " ".join(repr(float(x)) for x in craft.axis)
    model = mujoco.MjModel.from_xml_string(
        f"""
        <mujoco>
          <compiler autolimits="false" balanceinertia="false"/>
          <option gravity="0 0 {-craft.gravity!r}">
            <flag contact="disable" limit="disable" equality="disable"/>
          </option>
          <worldbody>
            <body name="main"><freejoint/>
              <inertial pos="{own}" mass="{craft.mass!r}" fullinertia="{full}"/>
              <body name="ring" pos="{at}">
                <joint type="hinge" axis="{axis}" damping="{craft.damping!r}"/>
                <inertial pos="0 0 0" mass="{craft.ring_mass!r}" fullinertia="{ring}"/>
              </body>
            </body>
          </worldbody>
        </mujoco>"""
    )
    data: Any = mujoco.MjData(model)
    data.qpos[:] = [0.0, 0.0, 0.0, *now.attitude, 0.0]
    data.qvel[:] = [*now.velocity, *now.omega, now.spin - craft.axis @ now.omega]
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    applied = np.zeros(model.nv)
    mujoco.mj_applyFT(model, data, force, np.zeros(3), point, model.body("ring").id, applied)
    data.qfrc_applied[:] = applied
    mujoco.mj_forward(model, data)
    angular = data.qacc[3:6].copy()
    spin = float(craft.axis @ angular + data.qacc[6])
    return RingSecond(data.qacc[:3].copy(), angular, spin)


def by_joint_forces(craft: RingCraft, now: RingPose, force: Array, point: Array) -> RingSecond:
    """The same from Newton and Euler for each body, with the force and moment of the joint."""
    r = now.rotation
    axis, centre, own = r @ craft.axis, r @ craft.centre, r @ craft.body_centre
    omega = r @ now.omega
    relative = now.spin - axis @ omega
    spins = omega + relative * axis
    inertia, ring = r @ craft.inertia @ r.T, r @ craft.ring_inertia @ r.T
    arm, down = centre - own, np.array([0.0, 0.0, -craft.gravity])
    bearing = craft.damping * relative * axis
    # Unknowns: linear and angular acceleration of the body and of the ring, force and moment of the
    # joint on the ring, and the rate of the ring's turn in it.
    one, none, column = np.eye(3), np.zeros((3, 3)), np.zeros((3, 1))
    rows = [
        [craft.mass * one, none, none, none, one, none, column],
        [none, inertia, none, none, cross(arm), one, column],
        [none, none, craft.ring_mass * one, none, -one, none, column],
        [none, none, none, ring, none, -one, column],
        [one, -cross(arm), -one, none, none, none, column],
        [none, one, none, -one, none, none, axis[:, None]],
    ]
    last = np.zeros((1, 19))
    last[0, 15:18] = axis
    known = np.concatenate(
        [
            craft.mass * down,
            bearing - np.cross(omega, inertia @ omega),
            craft.ring_mass * down + force,
            np.cross(point - centre, force) - bearing - np.cross(spins, ring @ spins),
            -np.cross(omega, np.cross(omega, arm)),
            -np.cross(omega, relative * axis),
            [0.0],
        ]
    )
    found = np.linalg.solve(np.vstack([np.block(rows), last]), known)
    total = craft.mass + craft.ring_mass
    linear = (craft.mass * found[:3] + craft.ring_mass * found[6:9]) / total
    spin = float(axis @ found[9:12] + spins @ np.cross(omega, axis))
    return RingSecond(linear, r.T @ found[3:6], spin)


def cross(v: Array) -> Array:
    """Matrix of v × …"""
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
