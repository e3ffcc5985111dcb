"""Rotors that a vehicle lists, anywhere and along any axis, beside independent oracles.

SymPy differentiates their virtual work, MuJoCo has actuators at sites, NumPy sums forces and levers
by hand.  All runs in plain Python.
"""

from __future__ import annotations

import importlib
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from builders import joint_crafts
from builders.cases import nonempty
from builders.joint_crafts import BODY, at_wall, drawn, pose_of, state_of, with_springs
from builders.listed_rotors import bare, canted, model_of, of_each_arm, vehicle_with, with_rotors
from oracles import joint_lagrangian as lagrangian
from oracles import models
from oracles.blowers import Blower, generalised_forces, mirrored_blowers, random_blowers
from oracles.joint_lagrangian import Craft, Pose, Second, mirrored
from springback.dynamics.energy import energy
from springback.dynamics.motion import rates
from springback.dynamics.rigid import RigidState, flight_rates, rigid_body
from springback.kernels.trees import axpy, leaves
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.rotors import mounts_of, rotor_load, rotor_pose
from springback.vehicle.placed.settings import disc_axes
from springback.vehicle.state import Airframe, reach

Array = NDArray[np.float64]

STATES = 20
#: Measured: 5e-14, and for MuJoCo's point masses, which have some inertia, 1e-11.
RELATIVE, MUJOCO = 1e-12, 3e-9
#: Slides alone, hinges alone, both; of hinges some rotors keep the axes of the body.
NAMES = ("oblique slides", "hinges about an odd axis", "any joints")
joints = pytest.mark.parametrize("name", NAMES)


def case(name: str, seed: int) -> tuple[Craft, tuple[Blower, ...], Pose]:
    """Arms without rotors of their own, and three to six listed ones."""
    craft, pose = drawn(name, seed)
    blowers = random_blowers(np.random.default_rng([41, seed]), craft, 3 + seed % 4)
    return bare(craft), blowers, pose


def accelerations(
    craft: Craft, blowers: tuple[Blower, ...], pose: Pose, scene: models.Scene | None = None
) -> Second:
    """The package's, in the coordinates of the oracles."""
    found = rates(model_of(craft, blowers, scene), state_of(craft, pose), 1.0).motion.state
    radii = np.array([limb.radius for limb in craft.limbs])
    bends = -np.array(found.arm_rate) / radii
    return Second(np.array(found.velocity), np.array(found.angular_velocity), bends)


def error(a: Any, b: Any) -> float:
    """Largest difference, relative to the largest component (at least 1)."""
    return float(np.abs(np.asarray(a) - b).max() / max(1.0, np.abs(b).max()))


def largest_error(ours: Second, theirs: Second) -> float:
    """Of all second derivatives."""
    return max(error(a, b) for a, b in nonempty(zip(ours, theirs, strict=True)))


# -- accelerations ---------------------------------------------------------------------------------


@joints
def test_accelerations_are_those_of_virtual_work(name: str) -> None:
    """On arms and on the main body, torques of speed changes among them; arms without rotors."""
    for seed in range(STATES):
        craft, blowers, pose = case(name, seed)
        pushes = generalised_forces(craft, pose, blowers)
        theirs = lagrangian.accelerations(craft, pose, pushes)
        assert largest_error(accelerations(craft, blowers, pose), theirs) < RELATIVE


@joints
def test_accelerations_are_those_of_actuators_at_sites(name: str) -> None:
    """MuJoCo's, with a wall: rotors that turn with their arms."""
    pytest.importorskip("mujoco")
    pytest.importorskip("pinocchio")
    engines: ModuleType = importlib.import_module("oracles.joint_engines")
    for seed in range(STATES):
        craft, blowers, pose = case(name, seed)
        craft = replace(craft, limbs=tuple(replace(one, follows=True) for one in craft.limbs))
        scene = at_wall(craft, pose, seed)
        theirs = engines.InMujoco(craft, blowers).accelerations(pose, scene)
        assert largest_error(accelerations(craft, blowers, pose, scene), theirs) < MUJOCO


def planar(seed: int, **more: Any) -> tuple[Airframe, Airframe]:
    """Unequal arms that slide in the body plane, and the same on joints."""
    springs = {"stiffness": [5e3, 4e3, 6e3, 5e3], "damping": 30.0}
    slide = {"type": "slide", "direction": [-2.0, 0.0, 0.0], "travel": [0.0, 0.01], **springs}
    arms = {
        "directions": [0.7, 2.3, -2.4, -0.9], "length": [0.19, 0.2, 0.21, 0.19],
        "mass": [0.05, 0.06, 0.04, 0.05], "cage_radius": 0.1, **more,
    }  # fmt: skip
    kinds = {"stroke": 0.01, **springs}, {"joint": slide}
    built = [
        Vehicle.model_validate({"body": BODY, "arms": {**arms, **kind}}).airframe()
        for kind in kinds
    ]
    return built[0], built[1]


def test_on_planar_arms_they_do_what_they_do_on_the_same_joints() -> None:
    """Two eliminations, one vehicle: at a wall, stops pressed."""
    in_plane, jointed = planar(0)
    craft = models.craft_of(in_plane)
    for seed in range(STATES):
        rng = np.random.default_rng([42, seed])
        start = models.random_start(rng, craft)
        scene = models.Scene(craft, models.Wall(models.unit_vector(rng), 0.0), (0.0,) * 4)
        scene = models.touching(scene, start, seed % 3, 5e-3)
        limbs = (joint_crafts.drawn("oblique slides", 1)[0].limbs * 2)[:4]
        blowers = random_blowers(rng, Craft(1.0, np.eye(3), limbs), 5)
        model, state = models.model_of(scene, until=1.0), models.state_of(start)
        ours, theirs = (
            np.array(leaves(rates(with_rotors(model._replace(airframe=one), blowers),
                                  state, 1.0).motion))
            for one in (in_plane, jointed)
        )  # fmt: skip
        assert error(ours, theirs) < 1e-12


@pytest.mark.parametrize("hinged", [False, True], ids=["planar", "hinges"])
def test_a_list_of_what_there_is_without_one_changes_nothing(hinged: bool) -> None:
    """One rotor at the end of each arm, upright; with hinges they turn with their arms."""
    given = vehicle_with(of_each_arm(6))
    if hinged:
        joint = {
            "type": "hinge", "position": [0.06, 0, 0], "axis": [0.2, -1, 0.1],
            "travel": [-0.5, 0.5], "stiffness": 3.0, "damping": 0.02,
        }  # fmt: skip
        given["arms"] = {k: v for k, v in given["arms"].items() if k != "stroke"} | {"joint": joint}
    without = Vehicle.model_validate({k: v for k, v in given.items() if k != "rotors"})
    vehicles = Vehicle.model_validate(given), without
    rng, lengths = np.random.default_rng(43), vehicles[0].lengths()
    thrust = tuple(rng.uniform(0.5, 2.0, size=6).tolist())
    start = models.Start(
        np.zeros(3), models.quaternion(0.3, -0.2, 0.5), rng.normal(size=3), rng.normal(size=3),
        np.array(lengths) - rng.uniform(0.0, 0.01, size=6), rng.uniform(-0.3, 0.3, size=6),
    )  # fmt: skip
    craft = joint_crafts.drawn("oblique slides", 0)[0]
    model = joint_crafts.model_of(craft)._replace(thrust=thrust)
    for released in (1.0, 0.0):
        state = models.state_of(replace(start, rates=start.rates * released))
        ours, theirs = (
            np.array(leaves(rates(model._replace(airframe=one.airframe()), state, released).motion))
            for one in vehicles
        )
        assert error(ours, theirs) < 1e-12


@joints
def test_locked_arms_give_newton_and_euler_with_the_wrench_summed_by_hand(name: str) -> None:
    """Forces and levers by NumPy; both formulations of the package."""
    for seed in range(STATES):
        craft, blowers, pose = case(name, seed)
        pose = replace(pose, rates=np.zeros(len(craft.limbs)))
        masses = np.array([craft.body_mass, *(limb.mass for limb in craft.limbs)])
        ends = [limb.place(c) for limb, c in zip(craft.limbs, pose.bends, strict=True)]
        places = np.array([np.zeros(3), *ends])
        centre = masses @ places / craft.mass
        inertia = craft.inertia.copy()
        for mass, place in zip(masses, places - centre, strict=True):
            inertia += mass * (place @ place * np.eye(3) - np.outer(place, place))
        force, torque, omega, r = np.zeros(3), np.zeros(3), pose.omega, pose.rotation
        for one in blowers:
            turn, aim, end = np.eye(3), np.eye(3), np.zeros(3)
            if one.limb >= 0:
                limb, end = craft.limbs[one.limb], ends[one.limb]
                turn = limb.turn(pose.bends[one.limb])
                aim = turn if limb.follows else aim
            up = aim @ one.axis
            force = force + one.thrust * up
            lever = end + turn @ one.offset - centre
            torque = torque + np.cross(lever, one.thrust * up) + one.torque * up
        angular = np.linalg.solve(inertia, torque - np.cross(omega, inertia @ omega))
        about = np.cross(angular, -centre) + np.cross(omega, np.cross(omega, -centre))
        linear = r @ (force / craft.mass + about) - [0.0, 0.0, craft.gravity]

        model, state = model_of(craft, blowers), state_of(craft, pose)
        locked = rates(model, state, 0.0).motion
        assert error(np.array(locked.state.velocity), linear) < RELATIVE
        assert error(np.array(locked.state.angular_velocity), angular) < RELATIVE
        body = rigid_body(model.airframe, state.arm_length, model.thrust, model.reaction)
        whole = RigidState(*state[:4], 0.0, 0.0)
        known = flight_rates(body, model.guide, model.air, craft.gravity, whole)
        assert error(np.array(known.flight.velocity), linear) < RELATIVE
        assert error(np.array(known.flight.angular_velocity), angular) < RELATIVE
        power = force @ (r.T @ pose.velocity) + omega @ (torque + np.cross(centre, force))
        assert known.flight.thrust_work == pytest.approx(power, rel=1e-9)
        assert locked.work.thrust == pytest.approx(power, rel=1e-9)


# -- energy, symmetry ------------------------------------------------------------------------------


@pytest.mark.parametrize("released", [1.0, 0.0], ids=["moving arms", "locked arms"])
@joints
def test_power_balances_at_every_instant(name: str, released: float) -> None:
    """Ė = power of the rotors, of those on moving arms and of their torques too, − losses."""
    for seed in range(STATES):
        craft, blowers, pose = case(name, seed)
        pose = pose if released else replace(pose, rates=np.zeros(len(craft.limbs)))
        arms = tuple(with_springs(limb, seed + j) for j, limb in enumerate(craft.limbs))
        model = model_of(craft, blowers, at_wall(craft, pose, seed))
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


@joints
def test_a_mirror_makes_them_spin_the_other_way(name: str) -> None:
    for seed in range(STATES):
        craft, blowers, pose = case(name, seed)
        there, seen = mirrored(craft, pose)
        ours = accelerations(craft, blowers, pose)
        theirs = accelerations(there, mirrored_blowers(blowers), seen)
        across = lagrangian.ACROSS
        assert error(ours.linear * across, theirs.linear) < RELATIVE
        assert error(-ours.angular * across, theirs.angular) < RELATIVE
        assert error(ours.bends, theirs.bends) < RELATIVE
        assert pose_of(craft, state_of(craft, pose)).bends == pytest.approx(pose.bends)


# -- places ----------------------------------------------------------------------------------------


def test_axes_of_a_disc_are_right_handed_and_end_along_its_axis() -> None:
    rng = np.random.default_rng(44)
    ups = [*rng.normal(size=(50, 3)), [0.0, 0.0, -1.0], [1e-9, 0.0, -1.0], [0.0, 0.0, 1.0]]
    for up in nonempty(ups):
        along = np.array(up) / np.linalg.norm(up)
        turn = np.array(disc_axes(models.vec(along)))
        assert turn[:, 2] == pytest.approx(along, abs=1e-12)
        assert turn.T @ turn == pytest.approx(np.eye(3), abs=1e-12)
        assert np.linalg.det(turn) == pytest.approx(1.0)
    assert (np.array(disc_axes(models.vec(np.array([0.0, 0.0, 1.0])))) == np.eye(3)).all()


@pytest.mark.parametrize(
    "far",
    [
        {"on": "body", "position": [-0.4, 0.0, 0.1], "axis": [1, 0, 0]},
        {"on": 1, "position": [0.2, 0.0, 0.0]},
    ],
    ids=["body", "arm"],
)
def test_nothing_of_a_disc_is_beyond_the_reach(far: dict[str, Any]) -> None:
    """Of rotors on sliding arms and on the body, at any length of the arms."""
    rotors = [*canted(0.4), far]
    vehicle = Vehicle.model_validate(vehicle_with(rotors))
    airframe, rng, farthest = vehicle.airframe(), np.random.default_rng(45), 0.0
    for _ in range(50):
        lengths = tuple((np.array(vehicle.lengths()) - rng.uniform(0.0, 0.03, size=6)).tolist())
        mounts = mounts_of(airframe.rotors, airframe.arms, lengths, (0.0,) * 6)
        for one in airframe.rotors.each:
            pose = rotor_pose(one, mounts)
            turn = np.array(disc_axes(pose.up))
            angle = rng.uniform(0.0, 2.0 * np.pi, size=100)
            rim = np.outer(np.cos(angle), turn[:, 0]) + np.outer(np.sin(angle), turn[:, 1])
            place = np.array(pose.mount.end) + np.array(pose.lever) + 0.0635 * rim
            farthest = max(farthest, float(np.linalg.norm(place, axis=1).max()))
    assert 0.9 * reach(airframe) < farthest <= reach(airframe)


def test_a_newton_along_the_axis_is_a_newton() -> None:
    """An upside-down rotor pushes down; its drag turns the body about its own axis."""
    rotor = Blower(-1, np.array([0.1, 0.0, 0.0]), np.array([0.0, 0.0, -1.0]), 0.02, 1.0)
    craft = bare(drawn("oblique slides", 0)[0])
    listed = model_of(craft, (rotor,)).airframe.rotors
    (one,) = listed.each
    load = rotor_load(rotor_pose(one, ()), one, 2.0)
    assert np.array(load.wrench.push) == pytest.approx([0.0, 0.0, -2.0])
    assert np.array(load.wrench.moment) == pytest.approx([0.0, 0.2, -0.04])
    turn = Rotation.from_matrix(np.array(one.axes))
    assert turn.apply([0.0, 0.0, 1.0]) == pytest.approx([0.0, 0.0, -1.0])
