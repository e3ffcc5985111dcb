"""The vehicle in MuJoCo: a free body with four point masses on slide joints.

MuJoCo gives the accelerations (`mj_forward`, its own contacts and limits off); the loads come from
`oracles.loads` and are mapped to joints by MuJoCo's own Jacobians (`mj_applyFT`).  Flights are
integrated by the classical Runge-Kutta method with the quaternion's components among the unknowns.
"""

from __future__ import annotations

import math

import mujoco
import numpy as np
from numpy.typing import NDArray

from oracles.loads import Flight, Loads, loads
from oracles.models import ArmSpec, Craft, Scene, Start

Array = NDArray[np.float64]

#: MuJoCo asks for some inertia of every moving body [kg m²]; this is nine orders below the vehicle's.
POINT = 1e-14


def _arm_xml(number: int, arm: ArmSpec) -> str:
    """A mass on a slide joint; of an arm that does not slide, a massless body where its end is."""
    x, y = math.cos(arm.azimuth), math.sin(arm.azimuth)
    if not arm.slides:
        assert arm.mass == 0.0
        return f'<body name="arm{number}" pos="{arm.length * x!r} {arm.length * y!r} 0"/>'
    return f"""
        <body name="arm{number}" pos="0 0 0">
          <joint type="slide" axis="{x!r} {y!r} 0"
                 limited="false" damping="0" stiffness="0" armature="0"/>
          <inertial pos="0 0 0" mass="{arm.mass!r}" diaginertia="{POINT} {POINT} {POINT}"/>
        </body>"""


def _xml(craft: Craft, gravity: float) -> str:
    i = craft.inertia
    full = " ".join(repr(float(x)) for x in (*i.diagonal(), i[0, 1], i[0, 2], i[1, 2]))
    arms = "".join(_arm_xml(k, arm) for k, arm in enumerate(craft.arms))
    return f"""
    <mujoco>
      <compiler angle="radian" autolimits="false" boundmass="0" boundinertia="0"
                balanceinertia="false"/>
      <option gravity="0 0 {-gravity!r}" density="0" viscosity="0">
        <flag contact="disable" limit="disable" equality="disable" frictionloss="disable"/>
      </option>
      <worldbody>
        <body name="main" pos="0 0 0">
          <freejoint/>
          <inertial pos="0 0 0" mass="{craft.body_mass!r}" fullinertia="{full}"/>
          {arms}
        </body>
      </worldbody>
    </mujoco>"""


class Vehicle:
    """A craft as a MuJoCo model.

    Args:
        craft: Masses, inertia and arm directions.
        gravity: g along −Z [m/s²].
    """

    def __init__(self, craft: Craft, gravity: float) -> None:
        """Compile the model."""
        self.model = mujoco.MjModel.from_xml_string(_xml(craft, gravity))
        self.data = mujoco.MjData(self.model)
        self.main = self.model.body("main").id
        self.sliding = np.array([arm.slides for arm in craft.arms])
        self.arms = [self.model.body(f"arm{k}").id for k in range(len(craft.arms))]

    def accelerations(
        self, scene: Scene, now: Start, time: float = 0.0
    ) -> tuple[Array, Array, Array]:
        """v̇ in world axes, ω̇ in body axes and l̈ at one instant."""
        return self.accelerations_under(loads(scene, now, time), now)

    def accelerations_under(self, acting: Loads, now: Start) -> tuple[Array, Array, Array]:
        """The same under given loads; 0 for arms that do not slide."""
        model, data = self.model, self.data
        unit = now.attitude / np.linalg.norm(now.attitude)
        sliding = self.sliding
        data.qpos[:] = np.concatenate([now.position, unit, now.lengths[sliding]])
        data.qvel[:] = np.concatenate([now.velocity, now.omega, now.rates[sliding]])
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        applied = np.zeros(model.nv)
        applied[6:] = acting.joint[sliding]
        for k, body in enumerate(self.arms):
            mujoco.mj_applyFT(
                model, data, acting.force[k], acting.moment[k], acting.point[k], body, applied
            )
        mujoco.mj_applyFT(
            model, data, acting.body_force, acting.body_moment, now.position, self.main, applied
        )
        data.qfrc_applied[:] = applied
        mujoco.mj_forward(model, data)
        arms = np.zeros(len(sliding))
        arms[sliding] = data.qacc[6:]
        return data.qacc[:3].copy(), data.qacc[3:6].copy(), arms


def unknowns(start: Start) -> Array:
    """Position, attitude, velocity, angular velocity, lengths and rates in a row."""
    return np.concatenate(
        [start.position, start.attitude, start.velocity, start.omega, start.lengths, start.rates]
    )


def state_at(x: Array) -> Start:
    """The state of a row of `unknowns`."""
    lengths, rates = np.split(x[13:], 2)
    return Start(x[:3], x[3:7], x[7:10], x[10:13], lengths, rates)


def slope_of(now: Start, accelerations: tuple[Array, Array, Array]) -> Array:
    """Rates of `unknowns`; that of the attitude is ½ q ⊗ (0, ω)."""
    turning = np.zeros(4)
    mujoco.mju_mulQuat(turning, now.attitude, np.concatenate([[0.0], now.omega]))
    linear, angular, arms = accelerations
    return np.concatenate([now.velocity, 0.5 * turning, linear, angular, now.rates, arms])


def fly(scene: Scene, start: Start, *, until: float, step: float) -> Flight:
    """A flight at equal steps.

    Args:
        scene: Vehicle, wall, thrust.
        start: State at time 0.
        until: Duration [s]; a whole number of steps.
        step: Of the Runge-Kutta method [s].
    """
    vehicle = Vehicle(scene.craft, scene.gravity)

    def slope(x: Array, time: float) -> Array:
        here = state_at(x)
        return slope_of(here, vehicle.accelerations(scene, here, time))

    x = unknowns(start)
    peak = 0.0
    for k in range(round(until / step)):
        t = k * step
        k1 = slope(x, t)
        k2 = slope(x + 0.5 * step * k1, t + 0.5 * step)
        k3 = slope(x + 0.5 * step * k2, t + 0.5 * step)
        k4 = slope(x + step * k3, t + step)
        peak = max(peak, float(np.linalg.norm(k1[7:10])))
        x = x + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        x[3:7] /= np.linalg.norm(x[3:7])
    peak = max(peak, float(np.linalg.norm(slope(x, until)[7:10])))
    return Flight(state_at(x), peak)
