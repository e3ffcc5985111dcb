"""Arms on slides and hinges in MuJoCo and in Pinocchio: a free body with point masses on joints.

The engines bring the inertia: masses, centrifugal and Coriolis terms, gravity.  Springs, rotors and
a wall are forces and moments, written down here and in `oracles.loads`, which each engine maps to
its joints by itself.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import mujoco
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.blowers import Blower
from oracles.joint_lagrangian import Craft, Limb, Pose, Second
from oracles.loads import wall_force
from oracles.models import Scene

Array = NDArray[np.float64]

#: MuJoCo asks for some inertia of every moving body [kg m²]: this is far below the vehicle's.
POINT = 1e-14


class Loads(NamedTuple):
    """Everything that acts, but inertia and gravity; world axes."""

    joint: Array  # spring and damper, on c, shape (arms,) or, of arms on two joints, (arms, 2)
    force: Array  # on each arm at its end [N], shape (arms, 3)
    moment: Array  # on each arm about its end [N m], shape (arms, 3)
    point: Array  # the arms' ends [m], shape (arms, 3)
    velocity: Array  # of the arms' ends [m/s], shape (arms, 3)


def loads(craft: Craft, now: Pose, scene: Scene | None) -> Loads:
    """Springs, rotors and, with a scene, its wall against the cages."""
    r = now.rotation
    joint, forces, moments, points, velocities = [], [], [], [], []
    for limb, c, rate in zip(craft.limbs, now.bends, now.rates, strict=True):
        at_end, spin = r @ limb.turn(c), r @ now.omega
        spin = spin + r @ limb.spin(c, rate)
        lever = r @ limb.place(c)
        velocity = now.velocity + np.cross(r @ now.omega, lever) + r @ limb.motion(c, rate)
        force, moment = np.zeros(3), np.zeros(3)
        if scene is not None:
            force, moment = wall_force(
                scene, at_end, at_end[:, 0], now.position + lever, velocity, spin, limb.cage_radius
            )
        up = (at_end if limb.follows else r)[:, 2]
        joint.append(limb.spring_force(c, rate))
        velocities.append(velocity)
        forces.append(force + limb.thrust * up)
        moments.append(moment + limb.torque_ratio * limb.thrust * up)
        points.append(now.position + lever)
    arrays = (np.array(entries) for entries in (joint, forces, moments, points, velocities))
    return Loads(*arrays)


def with_springs_between(craft: Craft, acting: Loads) -> Loads:
    """Loads, with the pulls of the springs between arms on their ends."""
    between = craft.between
    if between is None:
        return acting
    force = acting.force.copy()
    for j, free in enumerate(between.distances):
        k = (j + 1) % len(craft.limbs)
        apart, away = acting.point[k] - acting.point[j], acting.velocity[k] - acting.velocity[j]
        distance = float(np.linalg.norm(apart))
        pull = between.stiffness * (distance - free) + between.damping * apart @ away / distance
        force[j] += pull * apart / distance
        force[k] -= pull * apart / distance
    return acting._replace(force=force)


# -- MuJoCo ----------------------------------------------------------------------------------------


def _numbers(of: Array) -> str:
    return " ".join(repr(float(x)) for x in of)


def _sites_xml(number: int, base: Array, end: Array, blowers: tuple[Blower, ...]) -> str:
    """Sites of the rotors on one body, z along the thrust."""
    return "".join(
        f'<site name="rotor{k}" pos="{_numbers(end - base + one.offset)}" '
        f'zaxis="{_numbers(one.axis)}"/>'
        for k, one in enumerate(blowers)
        if one.limb == number
    )


def _actuators_xml(blowers: tuple[Blower, ...]) -> str:
    """Rotors are MuJoCo's own actuators: force and torque along the z axis of a site."""
    if not blowers:
        return ""
    motors = "".join(
        f'<motor site="rotor{k}" gear="0 0 {one.thrust!r} 0 0 {one.torque!r}"/>'
        for k, one in enumerate(blowers)
    )
    return f"<actuator>{motors}</actuator>"


def _limb_xml(number: int, limb: Limb, blowers: tuple[Blower, ...]) -> str:
    base = limb.end if limb.kind == "slide" else limb.point
    joints = "".join(
        f"""
          <joint type="{one.kind}" axis="{_numbers(one.axis)}" pos="{_numbers(one.point - base)}"
                 limited="false" damping="0" stiffness="0" armature="0"/>"""
        for one in limb.chain
    )
    return f"""
        <body name="arm{number}" pos="{_numbers(base)}">{joints}
          <inertial pos="{_numbers(limb.end - base)}" mass="{limb.mass!r}"
                    diaginertia="{POINT} {POINT} {POINT}"/>
          <site name="end{number}" pos="{_numbers(limb.end - base)}"/>
          {_sites_xml(number, base, limb.end, blowers)}
        </body>"""


def _tendons_xml(craft: Craft) -> str:
    """Springs between arms are MuJoCo's own tendons."""
    between, count = craft.between, len(craft.limbs)
    if between is None:
        return ""
    tendons = "".join(
        f"""
        <spatial stiffness="{between.stiffness!r}" damping="{between.damping!r}"
                 springlength="{free!r}">
          <site site="end{j}"/><site site="end{(j + 1) % count}"/>
        </spatial>"""
        for j, free in enumerate(between.distances)
    )
    return f"<tendon>{tendons}</tendon>"


def _xml(craft: Craft, blowers: tuple[Blower, ...] = ()) -> str:
    i = craft.inertia
    full = _numbers(np.array([*i.diagonal(), i[0, 1], i[0, 2], i[1, 2]]))
    arms = "".join(_limb_xml(k, limb, blowers) for k, limb in enumerate(craft.limbs))
    return f"""
    <mujoco>
      <compiler angle="radian" autolimits="false" boundmass="0" boundinertia="0"
                balanceinertia="false"/>
      <option gravity="0 0 {-craft.gravity!r}" density="0" viscosity="0">
        <flag contact="disable" limit="disable" equality="disable" frictionloss="disable"/>
      </option>
      <worldbody>
        <body name="main" pos="0 0 0">
          <freejoint/>
          <inertial pos="0 0 0" mass="{craft.body_mass!r}" fullinertia="{full}"/>
          {_sites_xml(-1, np.zeros(3), np.zeros(3), blowers)}
          {arms}
        </body>
      </worldbody>
      {_tendons_xml(craft)}
      {_actuators_xml(blowers)}
    </mujoco>"""


class InMujoco:
    """A craft as a MuJoCo model.

    Args:
        craft: Any.
        blowers: Rotors apart from those of its arms, which follow their arms.
    """

    def __init__(self, craft: Craft, blowers: tuple[Blower, ...] = ()) -> None:
        """Compile the model."""
        self.craft = craft
        self.model = mujoco.MjModel.from_xml_string(_xml(craft, blowers))
        self.data = mujoco.MjData(self.model)
        self.data.ctrl[:] = 1.0  # thrust and torque are the gears
        self.arms = [self.model.body(f"arm{k}").id for k in range(len(craft.limbs))]

    def accelerations(self, now: Pose, scene: Scene | None = None) -> Second:
        """Second derivatives at one instant."""
        model, data, acting = self.model, self.data, loads(self.craft, now, scene)
        unit = now.attitude / np.linalg.norm(now.attitude)
        data.qpos[:] = np.concatenate([now.position, unit, now.bends.ravel()])
        data.qvel[:] = np.concatenate([now.velocity, now.omega, now.rates.ravel()])
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        applied = np.zeros(model.nv)
        applied[6:] = acting.joint.ravel()
        for k, body in enumerate(self.arms):
            mujoco.mj_applyFT(
                model, data, acting.force[k], acting.moment[k], acting.point[k], body, applied
            )
        data.qfrc_applied[:] = applied
        mujoco.mj_forward(model, data)
        bends = data.qacc[6:].copy().reshape(now.bends.shape)
        return Second(data.qacc[:3].copy(), data.qacc[3:6].copy(), bends)

    def fly(self, start: Pose, scene: Scene | None, *, until: float, step: float) -> Pose:
        """The end of a flight at equal steps of the classical Runge-Kutta method.

        Args:
            start: State at time 0.
            scene: Its wall; None for none.
            until: Duration [s]; a whole number of steps.
            step: Of the method [s].
        """
        shape, count = start.bends.shape, start.bends.size

        def pose(x: Array) -> Pose:
            bends, rates = x[13 : 13 + count].reshape(shape), x[13 + count :].reshape(shape)
            return Pose(x[:3], x[3:7], x[7:10], x[10:13], bends, rates)

        def slope(x: Array) -> Array:
            here, turning = pose(x), np.zeros(4)
            mujoco.mju_mulQuat(turning, here.attitude, np.concatenate([[0.0], here.omega]))
            linear, angular, bends = self.accelerations(here, scene)
            moving = [here.rates.ravel(), bends.ravel()]
            rates = [here.velocity, 0.5 * turning, linear, angular, *moving]
            return np.concatenate(rates)

        begin = [start.position, start.attitude, start.velocity, start.omega]
        x = np.concatenate([*begin, start.bends.ravel(), start.rates.ravel()])
        for _ in range(round(until / step)):
            k1 = slope(x)
            k2 = slope(x + 0.5 * step * k1)
            k3 = slope(x + 0.5 * step * k2)
            k4 = slope(x + step * k3)
            x = x + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            x[3:7] /= np.linalg.norm(x[3:7])
        return pose(x)


# -- Pinocchio -------------------------------------------------------------------------------------


class InPinocchio:
    """A craft as a Pinocchio model.

    Args:
        craft: Any.
    """

    def __init__(self, craft: Craft) -> None:
        """Build the tree of joints."""
        self.craft, model = craft, pin.Model()
        model.gravity.linear = np.array([0.0, 0.0, -craft.gravity])
        base = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "main body")
        body = pin.Inertia(craft.body_mass, np.zeros(3), craft.inertia)
        model.appendBodyToJoint(base, body, pin.SE3.Identity())
        self.joints, self.levers = [], []
        for k, limb in enumerate(craft.limbs):
            joint, at = base, np.zeros(3)
            for number, one in enumerate(limb.chain):
                slides = one.kind == "slide"
                placed = pin.SE3(np.eye(3), (one.end if slides else one.point) - at)
                at = one.end if slides else one.point
                kind: Any = (
                    pin.JointModelPrismaticUnaligned if slides else pin.JointModelRevoluteUnaligned
                )
                joint = model.addJoint(joint, kind(one.axis), placed, f"arm {k + 1} {number}")
            lever = limb.end - at
            mass = pin.Inertia(limb.mass, lever, np.zeros((3, 3)))
            model.appendBodyToJoint(joint, mass, pin.SE3.Identity())
            self.joints.append(joint)
            self.levers.append(lever)
        self.model, self.data = model, model.createData()

    def accelerations(self, now: Pose, scene: Scene | None = None) -> Second:
        """Second derivatives at one instant, by the articulated-body algorithm."""
        r = now.rotation
        acting = with_springs_between(self.craft, loads(self.craft, now, scene))
        x, y, z, w = Rotation.from_matrix(r).as_quat()
        q = np.concatenate([now.position, [x, y, z, w], now.bends.ravel()])
        v = np.concatenate([r.T @ now.velocity, now.omega, now.rates.ravel()])
        external: Any = pin.StdVec_Force()
        for _ in range(self.model.njoints):
            external.append(pin.Force.Zero())
        for k, (limb, joint) in enumerate(zip(self.craft.limbs, self.joints, strict=True)):
            axes = r @ limb.turn(now.bends[k])
            force, moment = axes.T @ acting.force[k], axes.T @ acting.moment[k]
            external[joint] = pin.Force(force, moment + np.cross(self.levers[k], force))
        tau = np.concatenate([np.zeros(6), acting.joint.ravel()])
        a = pin.aba(self.model, self.data, q, v, tau, external)
        # Pinocchio's velocity is in body axes: v = R v_b, so v̇ = R (a_b + ω × v_b).
        linear = r @ (a[:3] + np.cross(now.omega, v[:3]))
        return Second(linear, a[3:6], a[6:].reshape(now.bends.shape))
