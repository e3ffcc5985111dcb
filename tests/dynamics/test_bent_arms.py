"""Arms on two joints beside independent oracles, as arms on one are in test_joints.py.

SymPy's Lagrange equations, MuJoCo and Pinocchio share no line with the package.  All runs in plain
Python.
"""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.bent_crafts import (
    airframe_of,
    model_of,
    pose_of,
    radii,
    state_of,
    with_springs,
)
from builders.cases import nonempty
from builders.joint_crafts import at_wall, relative_error
from oracles import bent_limbs as lagrangian
from oracles import models
from oracles.bent_limbs import PAIRS, drawn
from oracles.joint_lagrangian import Between, Cloud, Craft, Pose, Second
from springback.contact.hull_contact import body_sight
from springback.contact.laws.memory import arm_memory
from springback.dynamics.energy import angular_momentum, energy, locked_state
from springback.dynamics.limbs.arms import ArmMotion, Surroundings, acceleration_at_end, arm_state
from springback.dynamics.motion import Rates, rates
from springback.dynamics.rigid import RigidState, flight_rates, rigid_body
from springback.dynamics.touches import BodyAcceleration
from springback.kernels.trees import axpy, leaves
from springback.kernels.vectors import Mat3, Vec, rotation
from springback.simulation.pair.parts import part_accelerations, parts_of
from springback.vehicle.arms.bent import BentCoordinates
from springback.vehicle.placed.rotors import PlacedRotor, PlacedRotors
from springback.vehicle.state import coordinates_of_arms, farthest_of_arm, fastest_of_arm

STATES = 12
#: Measured: 3e-14, with a wall, too; MuJoCo's point masses have some inertia: 1.9e-9.
RELATIVE, MUJOCO = 1e-12, 3e-9
pairs = pytest.mark.parametrize("name", PAIRS)


def rates_of(craft: Craft, pose: Pose, scene: models.Scene | None = None) -> Rates:
    """The package's rates, run by Python."""
    return rates(model_of(craft, scene), state_of(craft, pose), 1.0)


def accelerations_of(craft: Craft, pose: Pose, scene: models.Scene | None = None) -> Second:
    """The package's accelerations, in the coordinates of the oracles."""
    found = rates_of(craft, pose, scene).motion.state
    both = np.stack([np.array(found.arm_rate), np.array(found.bends)[:, 1]], axis=1)
    return Second(np.array(found.velocity), np.array(found.angular_velocity), -both / radii(craft))


def largest_error(ours: Second, theirs: Second) -> float:
    """Of all second derivatives."""
    return max(relative_error(a, b) for a, b in nonempty(zip(ours, theirs, strict=True)))


@pairs
def test_accelerations_are_those_of_the_lagrangian(name: str) -> None:
    """With rotors that follow their arms and that do not, springs, dampers, preload, latches."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        theirs = lagrangian.accelerations(craft, pose)
        assert largest_error(accelerations_of(craft, pose), theirs) < RELATIVE


@pytest.mark.parametrize("engine", ["InMujoco", "InPinocchio"])
@pairs
def test_accelerations_at_a_wall_are_those_of_the_engine(
    engines: ModuleType, engine: str, name: str
) -> None:
    """Cages that turn with both joints press on a wall and rub along it."""
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


@pairs
def test_locked_arms_are_one_body(name: str) -> None:
    """Both formulations of locked arms, and the momentum of a cloud of masses."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        pose = replace(pose, rates=0.0 * pose.rates)
        model, state = model_of(craft), state_of(craft, pose)
        locked = rates(model, state, 0.0)
        assert not any(locked.motion.state.arm_rate)
        assert not any(bend.rate for bend in locked.motion.state.bends)
        arms = model.airframe.arms
        ways = coordinates_of_arms(arms[0], state)
        body = rigid_body(model.airframe, ways, model.thrust, ())
        whole = RigidState(*state[:4], 0.0, 0.0)
        known = flight_rates(body, model.guide, model.air, craft.gravity, whole)
        for one in ("velocity", "angular_velocity"):
            ours, theirs = getattr(locked.motion.state, one), getattr(known.flight, one)
            assert relative_error(np.array(ours), np.array(theirs)) < RELATIVE
        assert known.flight.thrust_work == pytest.approx(locked.motion.work.thrust, rel=1e-9)
        velocity = Cloud(craft, pose).momentum / craft.mass
        assert relative_error(np.array(known.mass_centre_velocity), velocity) < RELATIVE


@pytest.mark.parametrize("released", [1.0, 0.0], ids=["moving arms", "locked arms"])
@pairs
def test_power_balances_at_every_instant(name: str, released: float) -> None:
    """Ė = thrust power − losses: springs, stops, latches, a wall, springs between arms, rotors.

    Rotors of arms and a listed one on an arm in turn.
    """
    stopped = 0
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        free = tuple(0.2 for _ in craft.limbs)
        craft = replace(craft, between=Between(800.0, 6.0, free) if seed % 2 else None)
        pose = pose if released else replace(pose, rates=0.0 * pose.rates)
        arms = tuple(with_springs(limb, seed + j) for j, limb in enumerate(craft.limbs))
        model = model_of(craft, at_wall(craft, pose, seed))
        airframe = model.airframe._replace(arms=arms)
        if seed % 3 == 0:
            airframe = airframe._replace(rotors=listed(seed, len(arms)))
            model = model._replace(thrust=(5.0, 3.0, 2.0))
        model, state = model._replace(airframe=airframe), state_of(craft, pose)
        known = rates(model, state, released).motion
        stopped += known.work.stop > 0.0
        h, power = 5e-7, known.work
        there = [axpy(state, known.state, h * way) for way in (1, -1, 2, -2)]
        e = [energy(model.airframe, model.world, model.contact_point, one).total for one in there]
        change = (8.0 * (e[0] - e[1]) - (e[2] - e[3])) / (12.0 * h)
        losses = power.arm + power.stop + power.contact + power.friction
        scale = max(1.0, abs(power.thrust), abs(change), losses)
        assert abs(change - power.thrust + losses) < 1e-8 * scale
        assert min(power.arm, power.stop, power.friction) >= 0.0
    assert stopped > STATES / 3 * released - 1


def listed(seed: int, arms: int) -> PlacedRotors:
    """Three rotors: on the main body, and two on one arm, anywhere and at any angle."""
    rng = np.random.default_rng([43, seed])
    each = []
    for number in (0.0, 1.0 + seed % arms, 1.0 + seed % arms):
        turn = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
        axes = Mat3(*(models.vec(row) for row in turn))
        each.append(PlacedRotor(number, models.vec(rng.normal(size=3) * 0.03), axes, 0.01, 1.0))
    return PlacedRotors(tuple(each), tuple(float(j + 1) for j in range(arms)), 0.5)


@pairs
def test_rotors_that_are_listed_at_the_ends_are_those_of_the_arms(name: str) -> None:
    """All accelerations and the power."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        limbs = tuple(replace(limb, follows=True) for limb in craft.limbs)
        model, state = model_of(replace(craft, limbs=limbs)), state_of(craft, pose)
        one, none = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0)), Vec(0, 0, 0)
        numbers = tuple(float(j + 1) for j in range(len(limbs)))
        each = [
            PlacedRotor(number, none, one, arm.torque_ratio, 1.0)
            for number, arm in zip(numbers, model.airframe.arms, strict=True)
        ]
        rotors = PlacedRotors(tuple(each), numbers, 0.5)
        airframe = model.airframe._replace(rotors=rotors)
        ours, theirs = (
            rates(model._replace(airframe=frame), state, 1.0).motion
            for frame in (airframe, model.airframe)
        )
        assert relative_error(np.array(leaves(ours)), np.array(leaves(theirs))) < 1e-11


@pairs
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
        centre = cloud.momentum / craft.mass
        assert relative_error(np.array(seen.mass_centre_velocity), centre) < 1e-12


@pairs
def test_locking_keeps_momenta_and_loses_energy(name: str) -> None:
    """What is lost is the kinetic energy of the velocities that vanish (Carnot)."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        airframe, state = airframe_of(craft), state_of(craft, pose)
        after = locked_state(airframe, state)
        then = pose_of(craft, after)
        assert not any(after.arm_rate)
        assert [(bend.way, 0.0) for bend in state.bends] == [tuple(bend) for bend in after.bends]
        before, left = Cloud(craft, pose), Cloud(craft, then)
        assert relative_error(left.momentum, before.momentum) < 1e-12
        assert relative_error(left.angular_momentum, before.angular_momentum) < 1e-12
        lost = replace(pose, velocity=pose.velocity - then.velocity, omega=pose.omega - then.omega)
        share = Cloud(craft, lost).kinetic
        assert before.kinetic - left.kinetic == pytest.approx(share, rel=1e-9)


# -- as moving obstacles of another vehicle --------------------------------------------------------


@pairs
def test_parts_move_as_the_limbs_do(name: str) -> None:
    """Place, turn and velocity of what is at the end, and its accelerations by differences."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        model, state = model_of(craft), state_of(craft, pose)
        now = rates(model, state, 1.0).motion.state
        parts = parts_of(model.airframe, state)
        r, omega = pose.rotation, pose.omega
        for part, limb, c, rate in nonempty(
            zip(parts, craft.limbs, pose.bends, pose.rates, strict=True)
        ):
            lever = limb.place(c)
            velocity = pose.velocity + r @ (np.cross(omega, lever) + limb.motion(c, rate))
            turn = np.array(rotation(part.attitude))
            np.testing.assert_allclose(part.position, pose.position + r @ lever, atol=1e-13)
            np.testing.assert_allclose(turn, r @ limb.turn(c), atol=1e-13)
            np.testing.assert_allclose(part.velocity, velocity, atol=1e-12)
            spin = limb.turn(c).T @ (omega + limb.spin(c, rate))
            np.testing.assert_allclose(part.angular_velocity, spin, atol=1e-12)
        found = part_accelerations(model.airframe, state, now)
        h = 1e-6
        ahead, behind = (parts_of(model.airframe, axpy(state, now, way)) for way in (h, -h))
        for one, after, before in zip(found, ahead, behind, strict=True):
            linear = (np.array(after.velocity) - before.velocity) / (2.0 * h)
            angular = (np.array(after.angular_velocity) - before.angular_velocity) / (2.0 * h)
            assert relative_error(np.array(one.linear), linear) < 1e-6
            assert relative_error(np.array(one.angular), angular) < 1e-6


# -- what steps need to know -----------------------------------------------------------------------


@pairs
def test_what_is_at_the_end_accelerates_as_one_body(name: str) -> None:
    """Any point of it, from rest: main body, angular acceleration and both joints."""
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        rng = np.random.default_rng([45, seed])
        model, state = model_of(craft), state_of(craft, pose)
        a, alpha, up, at = rng.uniform(-9.0, 9.0, size=(4, 3))
        ways = coordinates_of_arms(model.airframe.arms[0], state)
        for j, (limb, c) in enumerate(nonempty(zip(craft.limbs, pose.bends, strict=True))):
            second, turn = rng.uniform(-50.0, 50.0, size=2), limb.turn(c)
            point = limb.place(c) + turn @ at
            swing = limb.motion(c, second) + np.cross(limb.spin(c, second), turn @ at)
            expected = turn.T @ (a + np.cross(alpha, point) + swing)
            along = BentCoordinates(*(-radii(craft)[j] * second).tolist())
            moves = ArmMotion(ways[j], BentCoordinates(0.0, 0.0), along)
            body = BodyAcceleration(models.vec(a), models.vec(alpha), models.vec(up))
            found = acceleration_at_end(model.airframe.arms[j], moves, body)
            there = np.array(found.linear) + np.cross(found.angular, turn.T @ point)
            np.testing.assert_allclose(there, expected, rtol=0, atol=1e-10)


@pairs
def test_bounds_on_rates_hold(name: str) -> None:
    """Springs and dampers of contacts per mass, by the largest eigenvalue; speeds and distances."""
    seen = 0
    for seed in range(STATES):
        craft, pose = drawn(name, seed)
        scene = replace(at_wall(craft, pose, seed), rounding=0.0)
        model, state = model_of(craft, scene), state_of(craft, pose)
        sight = body_sight(model.world.obstacles, state, 0.0)
        around, into = Surroundings(sight, model.contact_point, 1.0), -scene.wall.normal
        memory = arm_memory(state.memory, model.airframe.arms)
        ways = coordinates_of_arms(model.airframe.arms[0], state)
        for j, (arm, limb) in enumerate(zip(model.airframe.arms, craft.limbs, strict=True)):
            c, radius = pose.bends[j], radii(craft)[j]
            rate = BentCoordinates(*(-radius * pose.rates[j]).tolist())
            known = arm_state(arm, ways[j], rate, limb.thrust, (1.0,), (), (), memory[j], around)
            axes, inward = limb.turn(c), pose.rotation.T @ into
            flat = axes.T @ inward * [1.0, 1.0, 0.0]
            rim = axes @ flat * (limb.cage_radius / np.linalg.norm(flat))
            unit = np.eye(2) / radius[:, None]
            ends = np.array([limb.motion(c, one) for one in unit])
            rims = ends + np.array([np.cross(limb.spin(c, one), rim) for one in unit])
            assert np.linalg.norm(limb.place(c)) <= farthest_of_arm(arm)
            moved = np.linalg.norm(rims.T @ (radius * pose.rates[j]))
            assert moved <= fastest_of_arm(arm, rate)
            press, grip = known.share.contact.press, known.share.grip.alone
            if press.stiffness == 0.0:
                continue
            seen += 1
            mass = limb.mass * ends @ ends.T
            normal, across = rims @ inward, rims @ (np.eye(3) - np.outer(inward, inward))
            rigid = np.linalg.eigvals(np.linalg.solve(mass, np.outer(normal, normal))).real.max()
            rubs = np.linalg.eigvals(np.linalg.solve(mass, across @ across.T)).real.max()
            assert known.slide.spring == pytest.approx(press.stiffness * rigid, rel=1e-8)
            assert known.slide.damper == pytest.approx(press.damper * rigid, rel=1e-8)
            assert grip * rubs <= known.grip.any_way * (1.0 + 1e-9) <= 2.0 * grip * rubs
    assert seen >= STATES / 2
