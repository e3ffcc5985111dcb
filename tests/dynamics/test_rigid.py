"""All arms locked: the rigid Newton-Euler equations (1), and the limit of stiff arms."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from oracles import models
from oracles.loads import loads
from oracles.rigid import rigid

Array = NDArray[np.float64]


def newton_euler(scene: models.Scene, now: models.Start) -> tuple[Array, Array]:
    """v̇ of the main body in world axes and ω̇ in body axes: eq. (1) about the centre of mass."""
    body, r = rigid(scene.craft, now.lengths), now.rotation
    acting = loads(scene, now)
    mass_centre = now.position + r @ body.centre
    torque = acting.moment.sum(axis=0) + acting.body_moment
    torque = torque + np.cross(now.position - mass_centre, acting.body_force)
    for force, point in zip(acting.force, acting.point, strict=True):
        torque = torque + np.cross(point - mass_centre, force)
    weight = np.array([0.0, 0.0, -body.mass * scene.gravity])
    linear = (acting.force.sum(axis=0) + acting.body_force + weight) / body.mass
    spin = np.cross(now.omega, body.inertia @ now.omega)
    angular = np.linalg.solve(body.inertia, r.T @ torque - spin)
    # The main body is off the centre of mass by −c.
    about = np.cross(angular, -body.centre)
    about += np.cross(now.omega, np.cross(now.omega, -body.centre))
    return linear + r @ about, angular


@pytest.mark.parametrize("fixed_by", ["free flight", "arms that cannot slide"])
def test_locked_arms_give_the_rigid_equations(fixed_by: str) -> None:
    """Any arms, any state, cages in the wall or not, whichever way the arms came to be locked."""
    for seed in range(60):
        rng = np.random.default_rng([3, seed])
        craft = models.random_craft(rng, stops=True, slides=fixed_by == "free flight")
        start = replace(
            models.random_start(rng, craft), rates=np.zeros(4)
        )  # arms off their free lengths, at rest
        scene = models.Scene(
            craft,
            models.Wall(models.unit_vector(rng), 0.0),
            thrust=tuple(rng.uniform(0.0, 12.0, size=4)),
            contact="ring" if seed % 2 else "tip",
        )
        scene = models.touching(scene, start, seed % 3, rng.uniform(1e-3, 15e-3))
        scene = models.with_hull(scene, start, rng) if seed % 4 == 0 else scene
        ours = models.accelerations_of(scene, start, released=fixed_by != "free flight")
        linear, angular = newton_euler(scene, start)
        assert np.abs(ours.linear - linear).max() < 1e-10 * max(1.0, np.abs(linear).max())
        assert np.abs(ours.angular - angular).max() < 1e-10 * max(1.0, np.abs(angular).max())
        assert not ours.arms.any()


def test_equal_arms_leave_the_textbook_equations() -> None:
    """With four equal arms m v̇ = f_T R e_z − m g e_Z and I ω̇ + ω × I ω = τ of eqs. (1) and (2)."""
    craft, l_star = models.compliant_craft(), 0.19 / math.sqrt(2.0)
    inertia = rigid(craft, np.full(4, 0.19)).inertia
    mixing = np.array(
        [
            [l_star, -l_star, -l_star, l_star],
            [-l_star, -l_star, l_star, l_star],
            [-0.016, 0.016, -0.016, 0.016],
        ]
    )
    for seed in range(20):
        rng = np.random.default_rng([4, seed])
        start = models.random_start(rng, craft, still_arms=True)
        thrust = rng.uniform(0.0, 12.0, size=4)
        scene = models.Scene(
            craft, models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR), tuple(thrust)
        )
        ours = models.accelerations_of(scene, start, released=False)
        linear = thrust.sum() / craft.mass * start.rotation[:, 2] - [0.0, 0.0, 9.81]
        spin = np.cross(start.omega, inertia @ start.omega)
        angular = np.linalg.solve(inertia, mixing @ thrust - spin)
        np.testing.assert_allclose(ours.linear, linear, rtol=0, atol=1e-12)
        np.testing.assert_allclose(ours.angular, angular, rtol=0, atol=1e-9)


def kept(craft: models.Craft, now: models.Start) -> list[Array]:
    """Velocity of the mass centre, angular momentum about it (world axes), energy of turning."""
    body, r = rigid(craft, now.lengths), now.rotation
    velocity = now.velocity + r @ np.cross(now.omega, body.centre)
    turning = body.inertia @ now.omega
    return [velocity, r @ turning, np.array(0.5 * now.omega @ turning)]


def test_torque_free_spinning_keeps_angular_momentum_and_energy() -> None:
    """An unequal rigid craft tumbles for one second at 15 rad/s about no principal axis.

    RK4 at 0.2 ms turns by 3 mrad a step; its error of some h⁵ a step adds up to 1e-11.
    """
    rng = np.random.default_rng(5)
    craft = models.random_craft(rng, slides=False)
    start = models.random_start(rng, craft, still_arms=True)
    start = replace(start, omega=np.array([9.0, -7.0, 10.0]))
    scene = models.Scene(
        craft, models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR), (0.0,) * 4, gravity=0.0
    )
    flown = models.fly(scene, start, until=1.0, impact_step=2e-4)
    end = models.start_of(flown.motion.state)
    assert np.abs(end.omega - start.omega).max() > 1.0
    for before, after in zip(kept(craft, start), kept(craft, end), strict=True):
        np.testing.assert_allclose(after, before, rtol=0, atol=1e-9 * np.abs(before).max())


def test_stiff_arms_approach_the_rigid_robot() -> None:
    """Through a whole oblique impact, each measure differs from the rigid one by O(1/k_l).

    A stiff, well damped arm follows the load quasi-statically, so it gives way by F/k_l.
    """

    def measures(craft: models.Craft) -> Array:
        start = models.Start(
            position=np.zeros(3),
            attitude=models.quaternion(0.05, 0.1, 0.2),
            velocity=np.array([1.8, 0.3, 0.0]),
            omega=np.array([0.5, 0.5, -1.0]),
            lengths=np.full(4, 0.19),
            rates=np.zeros(4),
        )
        wall = models.Wall(np.array([-1.0, 0.0, 0.0]), 0.0)
        scene = models.touching(models.Scene(craft, wall, (5.0,) * 4), start, 0, 1e-3)
        flown = models.fly(scene, start, until=0.05, impact_step=1e-5)
        r = flown.record
        end = np.array(flown.motion.state.velocity)
        hit, hardest = r.first_impact, r.peaks.acceleration
        return np.array([hit.separation_speed, hardest / 100.0, hit.travel * 100.0, *end])

    rigid_measures = measures(models.compliant_craft(slides=False))
    errors = []
    for stiffness in (1e5, 1e6, 1e7):
        damping = 2.0 * 0.7 * math.sqrt(stiffness * 0.05)
        stiff = measures(models.compliant_craft(stiffness=stiffness, damping=damping))
        errors.append(np.abs(stiff - rigid_measures).max())
    for coarse, fine in itertools.pairwise(errors):
        assert fine == pytest.approx(coarse / 10.0, rel=0.2)
    assert errors[-1] < 3e-3
