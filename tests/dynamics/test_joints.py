"""Arms on slides in any direction and on hinges about any axis, beside independent oracles.

SymPy's Lagrange equations, MuJoCo and Pinocchio share no line with the package.  State by state
they agree to rounding, amplified by the condition of the mass matrix.  All runs in plain Python.
"""

from __future__ import annotations

import math
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.interpolate import PchipInterpolator

from builders.cases import nonempty
from builders.joint_crafts import (
    BODY,
    JOINTS,
    airframe_of,
    arm_of,
    at_wall,
    drawn,
    model_of,
    pose_of,
    relative_error,
    settings_of,
    state_of,
    with_springs,
)
from oracles import joint_lagrangian as lagrangian
from oracles import models
from oracles.joint_lagrangian import Cloud, Craft, Pose, Second, about_z, random_limb
from springback.dynamics.energy import angular_momentum, energy, locked_state, spring_energy
from springback.dynamics.motion import Rates, rates
from springback.dynamics.rigid import RigidState, flight_rates, rigid_body
from springback.kernels.trees import axpy, leaves
from springback.vehicle.arms.joints import joint_spring
from springback.vehicle.parameters import Vehicle

Array = NDArray[np.float64]

STATES = 25
#: Measured: 8e-15 and, at a wall, 3e-13 for Pinocchio; MuJoCo's point masses have some inertia, which
#: is felt by arms that tendons throw about at 10⁶ rad/s²: 1.5e-9.
RELATIVE, MUJOCO = 1e-12, 3e-9
joints = pytest.mark.parametrize("name", JOINTS)


def rates_of(craft: Craft, pose: Pose, scene: models.Scene | None = None) -> Rates:
    """The package's rates, run by Python."""
    return rates(model_of(craft, scene), state_of(craft, pose), 1.0)


def accelerations_of(craft: Craft, pose: Pose, scene: models.Scene | None = None) -> Second:
    """The package's accelerations, in the coordinates of the oracles."""
    found = rates_of(craft, pose, scene).motion.state
    radii = np.array([limb.radius for limb in craft.limbs])
    return Second(
        np.array(found.velocity),
        np.array(found.angular_velocity),
        -np.array(found.arm_rate) / radii,
    )


def largest_error(ours: Second, theirs: Second) -> float:
    """Of all second derivatives."""
    return max(relative_error(a, b) for a, b in nonempty(zip(ours, theirs, strict=True)))


# -- state by state --------------------------------------------------------------------------------


@joints
def test_accelerations_are_those_of_the_lagrangian(name: str) -> None:
    """With rotors that follow their arms and that do not, springs, dampers and preload."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        theirs = lagrangian.accelerations(craft, pose)
        assert largest_error(accelerations_of(craft, pose), theirs) < RELATIVE


@pytest.mark.parametrize("engine", ["InMujoco", "InPinocchio"])
@joints
def test_accelerations_at_a_wall_are_those_of_the_engine(
    engines: ModuleType, engine: str, name: str
) -> None:
    """Cages that turn with their arms press on a wall and rub along it."""
    pressed = 0
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        scene = at_wall(craft, pose, seed)
        theirs = getattr(engines, engine)(craft).accelerations(pose, scene)
        within = MUJOCO if engine == "InMujoco" else RELATIVE
        assert largest_error(accelerations_of(craft, pose, scene), theirs) < within
        arms = rates_of(craft, pose, scene).seen.arms
        pressed += sum(arm.normal > 0.0 for arm in arms)
    assert pressed >= STATES / 2


def joined(craft: Craft, now: Pose) -> tuple[float, Array, Array]:
    """Mass, centre of mass and inertia about it, arms locked; body axes."""
    masses = np.array([craft.body_mass, *(limb.mass for limb in craft.limbs)])
    bent = zip(craft.limbs, now.bends, strict=True)
    places = np.array([np.zeros(3), *(limb.place(c) for limb, c in bent)])
    centre = masses @ places / craft.mass
    inertia = craft.inertia.copy()
    for mass, place in zip(masses, places - centre, strict=True):
        inertia += mass * (place @ place * np.eye(3) - np.outer(place, place))
    return craft.mass, centre, inertia


@joints
def test_locked_arms_give_the_rigid_equations(name: str) -> None:
    """Newton and Euler about the centre of mass, rotors leaning with arms; both formulations."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        pose = replace(pose, rates=np.zeros(len(craft.limbs)))
        mass, centre, inertia = joined(craft, pose)
        force, torque, omega, r = np.zeros(3), np.zeros(3), pose.omega, pose.rotation
        for limb, c in zip(craft.limbs, pose.bends, strict=True):
            push = limb.thrust * limb.turn(c if limb.follows else 0.0)[:, 2]
            force = force + push
            torque += np.cross(limb.place(c) - centre, push) + limb.torque_ratio * push
        angular = np.linalg.solve(inertia, torque - np.cross(omega, inertia @ omega))
        about = np.cross(angular, -centre) + np.cross(omega, np.cross(omega, -centre))
        linear = r @ (force / mass + about) - [0.0, 0.0, craft.gravity]

        model, state = model_of(craft), state_of(craft, pose)
        locked = rates(model, state, 0.0).motion.state
        assert relative_error(np.array(locked.velocity), linear) < RELATIVE
        assert relative_error(np.array(locked.angular_velocity), angular) < RELATIVE
        assert not any(locked.arm_rate)
        body = rigid_body(model.airframe, state.arm_length, model.thrust, ())
        whole = RigidState(*state[:4], 0.0, 0.0)
        known = flight_rates(body, model.guide, model.air, craft.gravity, whole)
        assert relative_error(np.array(known.flight.velocity), linear) < RELATIVE
        assert relative_error(np.array(known.flight.angular_velocity), angular) < RELATIVE
        velocity = Cloud(craft, pose).momentum / mass
        assert relative_error(np.array(known.mass_centre_velocity), velocity) < RELATIVE
        power = force @ (r.T @ pose.velocity) + omega @ (torque + np.cross(centre, force))
        assert known.flight.thrust_work == pytest.approx(power, rel=1e-9)


# -- energy and momentum, instant by instant -------------------------------------------------------


@pytest.mark.parametrize("released", [1.0, 0.0], ids=["moving arms", "locked arms"])
@joints
def test_power_balances_at_every_instant(name: str, released: float) -> None:
    """Ė = thrust power − losses, with all springs, stops, a wall, friction and rotors.

    Ė is a difference of order four along the rate of change: 1.2e-9 of the power at most.
    """
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        pose = pose if released else replace(pose, rates=np.zeros(len(craft.limbs)))
        arms = tuple(with_springs(limb, seed + j) for j, limb in enumerate(craft.limbs))
        model = model_of(craft, at_wall(craft, pose, seed))
        model = model._replace(airframe=model.airframe._replace(arms=arms))
        state = state_of(craft, pose)
        known = rates(model, state, released).motion
        h, power = 5e-7, known.work
        there = [axpy(state, known.state, h * way) for way in (1, -1, 2, -2)]
        e = [energy(model.airframe, model.world, model.contact_point, one).total for one in there]
        change = (8.0 * (e[0] - e[1]) - (e[2] - e[3])) / (12.0 * h)
        losses = power.arm + power.stop + power.contact + power.friction
        scale = max(1.0, abs(power.thrust), abs(change), losses)
        assert abs(change - power.thrust + losses) < 1e-8 * scale
        assert min(power.arm, power.stop, power.friction) >= 0.0


@joints
def test_momentum_and_energy_are_those_of_a_cloud_of_masses(name: str) -> None:
    """Angular momentum, kinetic energy, and the velocity of the centre of mass."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        model, state, cloud = model_of(craft), state_of(craft, pose), Cloud(craft, pose)
        spin = np.array(angular_momentum(model.airframe, state))
        assert relative_error(spin, cloud.angular_momentum) < 1e-12
        held = energy(model.airframe, model.world, model.contact_point, state)
        assert held.kinetic == pytest.approx(cloud.kinetic, rel=1e-12)
        assert held.gravity == pytest.approx(craft.gravity * cloud.masses @ cloud.places[:, 2])
        seen = rates(model, state, 1.0).seen
        assert (
            relative_error(np.array(seen.mass_centre_velocity), cloud.momentum / craft.mass) < 1e-12
        )


@joints
def test_locking_keeps_momenta_and_loses_energy(name: str) -> None:
    """What is lost is the kinetic energy of the velocities that vanish (Carnot)."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        airframe, state = airframe_of(craft), state_of(craft, pose)
        after = locked_state(airframe, state)
        before, then = Cloud(craft, pose), Cloud(craft, pose_of(craft, after))
        assert not any(after.arm_rate)
        assert after.position == state.position
        assert after.arm_length == state.arm_length
        assert relative_error(then.momentum, before.momentum) < 1e-12
        assert relative_error(then.angular_momentum, before.angular_momentum) < 1e-12
        lost = replace(before_less(pose, pose_of(craft, after)), rates=pose.rates)
        assert before.kinetic - then.kinetic == pytest.approx(Cloud(craft, lost).kinetic, rel=1e-9)


def before_less(pose: Pose, after: Pose) -> Pose:
    """A state with the differences of velocities."""
    return replace(pose, velocity=pose.velocity - after.velocity, omega=pose.omega - after.omega)


# -- springs ---------------------------------------------------------------------------------------

LIMB = random_limb(np.random.default_rng(7), 0.6, "hinge", [0.3, -0.5, 0.8])
LIMB = replace(LIMB, stiffness=10.0, quadratic=4.0, preload=0.0, damping=0.0)
POINTS = [[0.0, 0.0], [0.1, 2.0], [0.3, 3.0], [0.4, 9.0]]


def torque(c: float, change: dict[str, Any]) -> float:
    """Torque of the springs by which `LIMB` resists an angle, in closed form."""
    play, preload = change.get("play", 0.0), change.get("preload", 0.0)
    if change.get("one_sided") and c < 0.0:
        return float(preload)
    size = max(abs(c) - play, 0.0)
    linear = 10.0 * size
    if "table" in change:
        linear = float(PchipInterpolator(*np.transpose(POINTS))(size))
    held = 0.0
    if "latch" in change:
        holds, opens = change["latch"]["torque"], change["latch"]["travel"]
        u = c / (math.sqrt(3.0) * opens)
        held = 16.0 / math.sqrt(27.0) * holds * u / (1.0 + u * u) ** 2
    return float(preload + held + math.copysign(linear + 4.0 * size * size, c))


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"travel": [0.0, 0.5], "preload": 1.5},
        {"play": 0.05},
        {"travel": [0.0, 0.5], "one_sided": True, "preload": 0.5},
        {"table": POINTS, "stiffness": None},
        {"travel": [0.0, 0.5], "table": POINTS, "stiffness": None, "play": 0.05, "preload": 0.5},
        {"travel": [0.0, 0.5], "latch": {"torque": 1.2, "travel": 0.03}},
    ],
    ids=["linear and quadratic", "preload", "play", "one-sided", "table", "all", "latch"],
)
def test_springs_are_closed_forms_and_conserve_energy(change: dict[str, Any]) -> None:
    """The force along the path is torque over radius, and the derivative of the energy."""
    arm, radius = arm_of(LIMB, **change), LIMB.radius
    at_rest = joint_spring(arm, arm.length).energy
    assert at_rest == spring_energy(arm, arm.length) == 0.0
    for c in (-0.35, -0.12, -0.01, 0.01, 0.07, 0.21, 0.38):
        length, h = arm.length - radius * c, 1e-6
        spring = joint_spring(arm, length)
        assert spring.force * radius == pytest.approx(torque(c, change), rel=1e-12)
        above, below = (joint_spring(arm, length + way).energy for way in (h, -h))
        assert spring.force == pytest.approx(-(above - below) / (2.0 * h), rel=1e-6, abs=1e-8)
        assert spring.energy == spring_energy(arm, length)
        work = quad(torque, 0.0, c, args=(change,), points=[0.05, -0.05], limit=200)[0]
        assert spring.energy == pytest.approx(work, rel=1e-7)


# -- slides in the body plane are the planar arms --------------------------------------------------


def planar_arms(**more: Any) -> dict[str, Any]:
    """Unequal planar arms with stops that are near."""
    return {
        "directions": [0.7, 2.3, -2.4, -0.9], "length": [0.19, 0.2, 0.21, 0.19],
        "mass": [0.05, 0.06, 0.04, 0.05], "cage_radius": 0.1, "torque_ratio": 0.016,
        "neighbours": {"stiffness": 2e3, "damping": 8.0}, **more,
    }  # fmt: skip


SPRINGS = {"stiffness": [5e3, 4e3, 6e3, 5e3], "damping": 30.0}


@pytest.mark.parametrize("rotors", ["arm", "body"])
def test_a_slide_inwards_is_a_planar_arm(rotors: str) -> None:
    """At random states at a wall with stops pressed, everything but bounds on rates."""
    slide = {"type": "slide", "direction": [-2.0, 0.0, 0.0], "travel": [0.0, 0.01], **SPRINGS}
    kinds = {"stroke": 0.01, **SPRINGS}, {"joint": {**slide, "rotors": rotors}}
    planar, jointed = (
        Vehicle.model_validate({"body": BODY, "arms": planar_arms(**kind)}).airframe()
        for kind in kinds
    )
    craft = models.craft_of(planar)
    for seed in range(STATES):
        rng = np.random.default_rng([33, seed])
        start = models.random_start(rng, craft)
        wall = models.Wall(models.unit_vector(rng), 0.0)
        scene = models.Scene(craft, wall, tuple(rng.uniform(0.0, 12.0, size=4)))
        scene = models.touching(scene, start, seed % 3, 5e-3)
        model, state = models.model_of(scene, until=1.0), models.state_of(start)
        ours, theirs = (
            np.array(leaves(rates(model._replace(airframe=airframe), state, 1.0).motion))
            for airframe in (jointed, planar)
        )
        assert relative_error(ours, theirs) < 1e-12


def test_lists_of_numbers_give_each_arm_its_own() -> None:
    """Vectors of a joint are in the axes of each arm, its numbers one for each arm."""
    rng, axis = np.random.default_rng(34), [0.3, -0.5, 0.8]
    limbs = [random_limb(rng, azimuth, "hinge", axis) for azimuth in (0.7, 2.7, -1.5)]
    point = about_z(0.7).T @ limbs[0].point
    limbs = [
        replace(limb, point=about_z(azimuth) @ point, preload=0.0, cage_radius=0.05, follows=True)
        for limb, azimuth in zip(limbs, (0.7, 2.7, -1.5), strict=True)
    ]
    tables = [settings_of(limb) for limb in limbs]
    numbers = ("stiffness", "quadratic", "damping")
    joint = {key: [table["joint"][key] for table in tables] for key in numbers}
    whole = {
        **{key: [t[key] for t in tables] for key in ("length", "height", "mass", "torque_ratio")},
        **{key: [t[key][0] for t in tables] for key in ("directions", "spin")},
        "cage_radius": 0.05,
        "joint": {**tables[0]["joint"], **joint},
    }
    built = Vehicle.model_validate({"body": BODY, "arms": whole}).airframe().arms
    for arm, limb in nonempty(zip(built, limbs, strict=True)):
        assert leaves(arm) == pytest.approx(leaves(arm_of(limb)), rel=1e-12, abs=1e-15)
