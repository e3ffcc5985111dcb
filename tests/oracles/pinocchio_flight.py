"""The vehicle in Pinocchio: a free-flying main body with four point masses on prismatic joints.

Pinocchio's articulated-body algorithm gives the accelerations; the loads come from `oracles.loads`.
Flights are integrated by a Runge-Kutta-Munthe-Kaas method of order four: within a step the attitude is
R exp(θ̂) and θ is integrated with the inverse of the exponential's derivative, so no quaternion is
ever normalised.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.loads import Flight, loads
from oracles.models import Craft, Scene, Start

Array = NDArray[np.float64]


class Vehicle:
    """A craft as a Pinocchio model.

    Args:
        craft: Masses, inertia and arm directions.
        gravity: g along −Z [m/s²].
    """

    def __init__(self, craft: Craft, gravity: float) -> None:
        """Build the tree of joints."""
        model = pin.Model()
        model.gravity.linear = np.array([0.0, 0.0, -gravity])
        base = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "main body")
        body = pin.Inertia(craft.body_mass, np.zeros(3), craft.inertia)
        model.appendBodyToJoint(base, body, pin.SE3.Identity())
        self.joints = []
        for k, arm in enumerate(craft.arms):
            e = np.array([np.cos(arm.azimuth), np.sin(arm.azimuth), 0.0])
            slide = pin.JointModelPrismaticUnaligned(e)
            joint = model.addJoint(base, slide, pin.SE3.Identity(), f"arm {k + 1}")
            mass = pin.Inertia(arm.mass, np.zeros(3), np.zeros((3, 3)))
            model.appendBodyToJoint(joint, mass, pin.SE3.Identity())
            self.joints.append(joint)
        self.base = base
        self.model, self.data = model, model.createData()

    def accelerations(self, scene: Scene, now: Start) -> tuple[Array, Array, Array]:
        """v̇ in world axes, ω̇ in body axes and l̈ at one instant."""
        q, v, r = *self._coordinates(now), now.rotation
        acting = loads(scene, now)
        external: Any = pin.StdVec_Force()
        for _ in range(self.model.njoints):
            external.append(pin.Force.Zero())
        for k, joint in enumerate(self.joints):
            external[joint] = pin.Force(r.T @ acting.force[k], r.T @ acting.moment[k])
        external[self.base] = pin.Force(r.T @ acting.body_force, r.T @ acting.body_moment)
        tau = np.concatenate([np.zeros(6), acting.joint])
        a = pin.aba(self.model, self.data, q, v, tau, external)
        # Pinocchio's velocity is in body axes: v = R v_b, so v̇ = R (a_b + ω × v_b).
        linear = r @ (a[:3] + np.cross(now.omega, v[:3]))
        return linear, a[3:6], a[6:]

    def accelerations_on_slider(
        self, scene: Scene, now: Start, axis: Array
    ) -> tuple[Array, Array, Array]:
        """The same for a main body that does not turn and moves along one world axis only.

        Gauss's principle: of all motions that the guide allows, the one nearest to the free one, by
        the mass matrix.
        """
        q, _ = self._coordinates(now)
        linear, angular, arms = self.accelerations(scene, now)
        mass = pin.crba(self.model, self.data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        turn = np.eye(len(mass))
        turn[:3, :3] = now.rotation
        mass = turn @ mass @ turn.T  # of v̇ in world axes
        allowed = np.zeros((len(mass), 1 + len(arms)))
        allowed[:3, 0] = axis
        allowed[6:, 1:] = np.eye(len(arms))
        free = np.concatenate([linear, angular, arms])
        chosen = np.linalg.solve(allowed.T @ mass @ allowed, allowed.T @ mass @ free)
        return chosen[0] * axis, np.zeros(3), chosen[1:]

    @staticmethod
    def _coordinates(now: Start) -> tuple[Array, Array]:
        r = now.rotation
        x, y, z, w = Rotation.from_matrix(r).as_quat()
        q = np.concatenate([now.position, [x, y, z, w], now.lengths])
        return q, np.concatenate([r.T @ now.velocity, now.omega, now.rates])


def _turning(theta: Array, omega: Array) -> Array:
    """θ̇ of R exp(θ̂) at body rate ω; the series is exact to the order of the method."""
    once = np.cross(theta, omega)
    return np.asarray(omega + 0.5 * once + np.cross(theta, once) / 12.0)


def fly(scene: Scene, start: Start, *, until: float, step: float) -> Flight:
    """A flight at equal steps.

    Args:
        scene: Vehicle, wall, thrust.
        start: State at time 0.
        until: Duration [s]; a whole number of steps.
        step: Of the Runge-Kutta method [s].
    """
    vehicle = Vehicle(scene.craft, scene.gravity)
    count = len(scene.craft.arms)
    peak, now = 0.0, start
    for _ in range(round(until / step)):
        r = now.rotation

        def placed(x: Array, r: Array = r) -> Start:
            turned = r @ Rotation.from_rotvec(x[3:6]).as_matrix()
            return Start(
                x[:3],
                Rotation.from_matrix(turned).as_quat(scalar_first=True),
                x[6:9],
                x[9:12],
                x[12 : 12 + count],
                x[12 + count :],
            )

        def slope(x: Array) -> Array:
            here = placed(x)
            linear, angular, arms = vehicle.accelerations(scene, here)
            turning = _turning(x[3:6], x[9:12])
            return np.concatenate([here.velocity, turning, linear, angular, here.rates, arms])

        x = np.concatenate(
            [now.position, np.zeros(3), now.velocity, now.omega, now.lengths, now.rates]
        )
        k1 = slope(x)
        k2 = slope(x + 0.5 * step * k1)
        k3 = slope(x + 0.5 * step * k2)
        k4 = slope(x + step * k3)
        peak = max(peak, float(np.linalg.norm(k1[6:9])))
        now = placed(x + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4))
    return Flight(now, peak)
