"""A body with a round shell on a ball joint in MuJoCo, and by the momenta of two bodies.

MuJoCo brings inertia, gravity and the viscous bearing; contact is a force at a point of the shell.
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
class ShellCraft:
    """A body without its shell, and the shell; body axes, from the centre of mass of both."""

    mass: float  # of the body alone [kg]
    inertia: Array  # of the body alone, about its own centre of mass, shape (3, 3)
    shell_mass: float
    shell_inertia: float
    centre: Array  # of the shell
    damping: float  # of the bearings [N m s]
    gravity: float = 9.81

    @property
    def body_centre(self) -> Array:
        """Centre of mass of the body alone."""
        return np.asarray(-self.shell_mass / self.mass * self.centre)

    @property
    def together(self) -> Array:
        """Inertia about the common centre of mass, the shell as a point mass."""
        total = self.inertia.copy()
        for mass, at in ((self.mass, self.body_centre), (self.shell_mass, self.centre)):
            total += mass * (at @ at * np.eye(3) - np.outer(at, at))
        return total


@dataclass(frozen=True)
class ShellPose:
    """How it moves."""

    attitude: Array  # (w, x, y, z), body to world
    velocity: Array  # of the common centre of mass, world
    omega: Array  # of the body, body axes
    spin: Array  # of the shell, world

    @property
    def rotation(self) -> Array:
        """Body to world."""
        return np.asarray(Rotation.from_quat(self.attitude, scalar_first=True).as_matrix())


class ShellSecond(NamedTuple):
    """Second derivatives."""

    linear: Array  # of the common centre of mass, world
    angular: Array  # of the body, body axes
    spin: Array  # of the shell, world


def in_mujoco(craft: ShellCraft, now: ShellPose, force: Array, point: Array) -> ShellSecond:
    """Accelerations with a force on a point of the shell, world axes, from the centre of mass."""
    i = craft.inertia
    full = " ".join(repr(float(x)) for x in (*i.diagonal(), i[0, 1], i[0, 2], i[1, 2]))
    at = " ".join(repr(float(x)) for x in craft.centre)
    own = " ".join(repr(float(x)) for x in craft.body_centre)
    ball = " ".join([repr(craft.shell_inertia)] * 3)
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
              <body name="shell" pos="{at}">
                <joint type="ball" damping="{craft.damping!r}"/>
                <inertial pos="0 0 0" mass="{craft.shell_mass!r}" diaginertia="{ball}"/>
              </body>
            </body>
          </worldbody>
        </mujoco>"""
    )
    data: Any = mujoco.MjData(model)
    r = now.rotation
    data.qpos[:] = [0.0, 0.0, 0.0, *now.attitude, 1.0, 0.0, 0.0, 0.0]
    data.qvel[:] = [*now.velocity, *now.omega, *(r.T @ now.spin - now.omega)]
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    applied = np.zeros(model.nv)
    shell = model.body("shell").id
    mujoco.mj_applyFT(model, data, force, np.zeros(3), point, shell, applied)
    data.qfrc_applied[:] = applied
    mujoco.mj_forward(model, data)
    omega, angular = now.omega, data.qacc[3:6].copy()
    # The joint's rate is Ω − ω in axes of the shell, here those of the body: Ω̇ = R (ω̇ + j + ω × …).
    joint = data.qacc[6:9].copy()
    relative = r.T @ now.spin - omega
    spin = r @ (angular + joint + np.cross(omega, relative))
    return ShellSecond(data.qacc[:3].copy(), angular, spin)


def by_momenta(craft: ShellCraft, now: ShellPose, force: Array, point: Array) -> ShellSecond:
    """The same by the momenta of both bodies: about the common centre of mass nothing but the force
    changes their sum, and about its own centre the shell feels the force and the bearing."""
    r = now.rotation
    total = craft.mass + craft.shell_mass
    linear = force / total - [0.0, 0.0, craft.gravity]
    bearing = craft.damping * (now.spin - r @ now.omega)
    spin = (np.cross(point - r @ craft.centre, force) - bearing) / craft.shell_inertia
    moment = r.T @ (np.cross(point, force) - craft.shell_inertia * spin)
    own = np.cross(now.omega, craft.together @ now.omega)
    return ShellSecond(linear, np.linalg.solve(craft.together, moment - own), spin)
