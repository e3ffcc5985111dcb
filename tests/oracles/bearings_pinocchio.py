"""A body with a shell on a ball joint, or a ring on a hinge, in Pinocchio; instants and flights.

Pinocchio brings inertia and gravity, by its articulated-body algorithm; friction of the bearings is
a torque of the joint and contact a force at a point, both by formula.  What turns by itself is the
same in every position about its joint, so that the joint's coordinate stays at zero.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.models import Wall
from oracles.ring_bodies import RingCraft, RingPose, RingSecond
from oracles.shell_mujoco import ShellCraft, ShellPose, ShellSecond

Array = NDArray[np.float64]

#: Relative speed below which dry friction of bearings is viscous [rad/s].
SLIP = 0.1


class InPinocchio:
    """A craft as a Pinocchio model.

    Args:
        craft: With a shell, or with a ring.
        friction: Dry friction of its bearings, M_c [N m].
        rounding: Of a ring, as of a cage's circle on a plane.
    """

    def __init__(
        self, craft: ShellCraft | RingCraft, friction: float = 0.0, rounding: float = 0.0
    ) -> None:
        """Build the tree of joints."""
        self.craft, self.friction, self.rounding = craft, friction, rounding
        model = pin.Model()
        model.gravity.linear = np.array([0.0, 0.0, -craft.gravity])
        body = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "main body")
        own = pin.Inertia(craft.mass, craft.body_centre, craft.inertia)
        model.appendBodyToJoint(body, own, pin.SE3.Identity())
        kind: Any
        if isinstance(craft, ShellCraft):
            kind, mass, inertia = (
                pin.JointModelSpherical(), craft.shell_mass, craft.shell_inertia * np.eye(3)
            )  # fmt: skip
        else:
            kind, mass, inertia = (
                pin.JointModelRevoluteUnaligned(craft.axis), craft.ring_mass, craft.ring_inertia
            )  # fmt: skip
        self.joint = model.addJoint(body, kind, pin.SE3(np.eye(3), craft.centre), "bearings")
        turning = pin.Inertia(mass, np.zeros(3), inertia)
        model.appendBodyToJoint(self.joint, turning, pin.SE3.Identity())
        self.model, self.data = model, model.createData()
        self.still = pin.neutral(model)

    def accelerations(
        self, now: ShellPose | RingPose, force: Array, point: Array
    ) -> ShellSecond | RingSecond:
        """With a force at a point of the shell or ring, world axes, from the centre of mass."""
        craft, r = self.craft, now.rotation
        if isinstance(craft, ShellCraft):
            relative = r.T @ np.asarray(now.spin) - now.omega
        else:
            relative = np.atleast_1d(now.spin - craft.axis @ now.omega)
        q, (x, y, z, w) = self.still.copy(), Rotation.from_matrix(r).as_quat()
        q[3:7] = x, y, z, w
        v = np.concatenate([r.T @ now.velocity, now.omega, relative])
        bearings = craft.damping + self.friction / math.sqrt(relative @ relative + SLIP**2)
        tau = np.concatenate([np.zeros(6), -bearings * relative])
        external: Any = pin.StdVec_Force()
        for _ in range(self.model.njoints):
            external.append(pin.Force.Zero())
        there = r.T @ force
        external[self.joint] = pin.Force(there, np.cross(r.T @ point - craft.centre, there))
        a = pin.aba(self.model, self.data, q, v, tau, external)
        # Pinocchio's velocity is in body axes: v = R v_b, so v̇ = R (a_b + ω × v_b).
        linear, angular = r @ (a[:3] + np.cross(now.omega, v[:3])), a[3:6].copy()
        if isinstance(craft, ShellCraft):
            turned = angular + a[6:] + np.cross(now.omega, relative)
            return ShellSecond(linear, angular, r @ turned)
        return RingSecond(linear, angular, float(craft.axis @ angular + a[6]))

    def fly(
        self, start: ShellPose | RingPose, position: Array, wall: Wall, *, until: float, step: float
    ) -> tuple[Array, Any]:
        """Position of the centre of mass and motion at the end, by classical Runge-Kutta steps.

        Args:
            start: Motion at time 0.
            position: Of the centre of mass at time 0, world [m].
            wall: What the shell, or the rod of the ring, touches.
            until: Duration [s]; a whole number of steps.
            step: Of the method [s].
        """
        kind, many = type(start), isinstance(self.craft, ShellCraft)

        def moving(x: Array) -> Any:
            spin: Any = x[13:] if many else float(x[13])
            return kind(x[3:7] / np.linalg.norm(x[3:7]), x[7:10], x[10:13], spin)

        def slope(x: Array) -> Array:
            now = moving(x)
            force, point = self.pressed(now, x[:3], wall)
            second = self.accelerations(now, force, point)
            w, v = now.attitude[0], now.attitude[1:]
            turned = 0.5 * np.array([-v @ now.omega, *(w * now.omega + np.cross(v, now.omega))])
            spin = np.atleast_1d(second.spin)
            return np.concatenate([now.velocity, turned, second.linear, second.angular, spin])

        x = np.concatenate(
            [position, start.attitude, start.velocity, start.omega, np.atleast_1d(start.spin)]
        )
        for _ in range(round(until / step)):
            k1 = slope(x)
            k2 = slope(x + 0.5 * step * k1)
            k3 = slope(x + 0.5 * step * k2)
            k4 = slope(x + step * k3)
            x = x + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        return x[:3], moving(x)

    def pressed(self, now: Any, position: Array, wall: Wall) -> tuple[Array, Array]:
        """Force of a wall, and the point where it acts from the centre of mass; world axes."""
        craft, r, into = self.craft, now.rotation, -wall.normal
        if isinstance(craft, ShellCraft):
            radius = math.sqrt(1.5 * craft.shell_inertia / craft.shell_mass)
            lowest, whole, inset = radius * into, now.spin, 0.0
        else:
            axis = r @ craft.axis
            across = into - (into @ axis) * axis
            reach = math.hypot(*across, self.rounding)
            lowest, inset = craft.radius / reach * across, craft.radius / reach * self.rounding**2
            omega = r @ now.omega
            whole = omega + (now.spin - axis @ omega) * axis
        centre = r @ craft.centre
        depth = into @ (position + centre + lowest) + inset + wall.offset
        if depth <= 0.0:
            return np.zeros(3), centre + lowest
        velocity = now.velocity + np.cross(r @ now.omega, centre) + np.cross(whole, lowest)
        closing = into @ velocity
        slip = velocity - closing * into
        normal = max(0.0, float(wall.stiffness * depth**1.5 * (1.0 + wall.dissipation * closing)))
        friction = -wall.friction * normal / math.sqrt(slip @ slip + wall.slip_speed**2) * slip
        return friction - normal * into, centre + lowest
