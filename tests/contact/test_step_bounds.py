"""How fast friction brings a cage to rest: a bound that is never below the truth, and hardly above it.

The truth is the largest eigenvalue of the Jacobian of the accelerations by the velocities, from the
equations of motion by differences, with everything else that depends on velocity switched off.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest

from builders.cases import nonempty
from builders.scenes import surface
from springback.contact.cage import Ring
from springback.contact.laws.step_bounds import (
    friction_damping,
    friction_rate_bound,
    inverse_inertia,
)
from springback.contact.obstacles import Forces, Obstacle, Plane, World, signed_distance
from springback.dynamics.air import Still
from springback.dynamics.motion import Free, Rates, rates
from springback.kernels.trees import leaves, rebuilt
from springback.kernels.vectors import Mat3, Quat, Vec, norm, normalise, rotation
from springback.vehicle.library import VEHICLES
from springback.vehicle.state import Airframe, Sphere, State

RUBBER = surface(stiffness=2e4, friction=0.5, slip_speed=0.03)
OFF = (0.0,) * 4
POINT, FREE, STILL = Ring(1e-6), Free(0.0), Still(0.0)


@dataclass(frozen=True)
class Pressed:
    """A vehicle pressed into a wall, standing still."""

    airframe: Airframe
    world: World
    state: State
    released: float
    contact_point: Ring = POINT
    guide: Free = FREE
    air: Still = STILL
    thrust: tuple[float, ...] = OFF
    pushes: tuple[()] = ()
    reaction: tuple[()] = ()
    surface_effect: tuple[()] = ()

    @property
    def bound(self) -> float:
        """λ as the steps take it [1/s]."""
        return self._rates(self.state).seen.friction_rate

    @property
    def truth(self) -> float:
        """The largest rate at which velocities die out [1/s], of numbers from differences."""
        moving = (*range(7, 13), *range(17, 21)) if self.released else range(7, 13)
        x, step = np.array(leaves(self.state)), 1e-6
        columns = []
        for k in moving:
            up, down = x.copy(), x.copy()
            up[k] += step
            down[k] -= step
            columns.append((self._accelerations(up) - self._accelerations(down)) / (2.0 * step))
        jacobian = np.array(columns).T[list(moving)]
        return float(-np.linalg.eigvals(jacobian).real.min())

    def _accelerations(self, x: np.ndarray) -> np.ndarray:
        known = self._rates(rebuilt(self.state, [float(v) for v in x]))
        return np.array(leaves(known.motion.state))

    def _rates(self, state: State) -> Rates:
        return rates(self, state, self.released)


def pressed(robot: str, attitude: Quat, depths: tuple[float, float], released: float) -> Pressed:
    """The two foremost cages pressed into a wall ahead by two depths [m], by their arms' lengths."""
    airframe = VEHICLES[robot].vehicle.airframe()
    airframe = airframe._replace(
        arms=tuple(arm._replace(damping=0.0, stop_stiffness=0.0) for arm in airframe.arms), hull=()
    )
    r = rotation(attitude)
    reach = []
    for arm in airframe.arms:
        e = Vec(arm.cosine, arm.sine, 0.0)
        across = math.hypot(r.x.x, r.x.y)
        reach.append(arm.length * (r.x @ e) + arm.cage_radius * across)
    order = sorted(range(4), key=reach.__getitem__)
    face = reach[order[-1]] - depths[0]
    lengths = [arm.length for arm in airframe.arms]
    j = order[-2]
    e = r.x @ Vec(airframe.arms[j].cosine, airframe.arms[j].sine, 0.0)
    lengths[j] += (face + depths[1] - reach[j]) / e
    wall = Obstacle(Plane(Vec(-1.0, 0.0, 0.0), -face), RUBBER, 0.0)
    zero = Vec(0.0, 0.0, 0.0)
    state = State(zero, attitude, zero, zero, tuple(lengths), OFF)
    return Pressed(airframe, World((wall,), Forces(0.0), 9.81), state, released)


def attitudes() -> list[Quat]:
    """Upright, and up to 40 degrees off in every direction."""
    generator, out = np.random.default_rng(5), [Quat(1.0, 0.0, 0.0, 0.0)]
    for _ in range(30):
        x, y, z = (0.35 * generator.uniform(-1.0, 1.0, 3)).tolist()
        out.append(normalise(Quat(1.0, x, y, z)))
    return out


@pytest.mark.parametrize("robot", ["arq", "quad"])
def test_the_bound_is_never_below_the_truth(robot: str) -> None:
    released = 1.0 if robot == "arq" else 0.0
    for attitude in nonempty(attitudes()):
        for depths in ((3e-3, 3e-3), (6e-3, 1e-3)):
            contact = pressed(robot, attitude, depths, released)
            assert contact.truth > 500.0
            assert (1.0 - 1e-6) * contact.truth < contact.bound < 1.8 * contact.truth


def test_it_is_the_truth_for_a_rigid_vehicle_that_meets_a_wall_upright() -> None:
    for depths, near in (((3e-3, 3e-3), 1e-8), ((4e-3, 3e-3), 2e-3)):
        contact = pressed("quad", Quat(1.0, 0.0, 0.0, 0.0), depths, 0.0)
        assert contact.bound == pytest.approx(contact.truth, rel=near)


def test_the_bound_holds_out_of_the_plane_of_the_arms() -> None:
    """Hulls of arms touch anywhere: λ of a rigid body with a damper at any point, on any surface."""
    chance, mass, moments = np.random.default_rng(8), 1.2, np.array([0.009, 0.011, 0.018])
    inertia = Mat3(*(Vec(*row) for row in np.diag(moments).tolist()))
    for _ in range(300):
        n, p = chance.normal(size=3), chance.uniform(-0.3, 0.3, size=3)
        n /= np.linalg.norm(n)
        slip = np.hstack([np.eye(3), -np.cross(np.eye(3), p).T])  # v + ω × p
        k = slip.T @ (np.eye(3) - np.outer(n, n)) @ slip
        truth = np.linalg.eigvals(k / np.array([mass] * 3 + moments.tolist())[:, None]).real.max()
        grip = friction_damping(1.0, Vec(*n.tolist()), Vec(*p.tolist()), Vec(1.0, 0.0, 0.0))
        bound = friction_rate_bound(
            grip, (0.0,), (0.0,), 1.0 / mass, inertia, inverse_inertia(inertia)
        )
        assert truth * (1.0 - 1e-9) < bound < 5.0 * truth
        assert grip.alone == 1.0


def test_without_contact_there_is_none() -> None:
    contact = pressed("arq", Quat(1.0, 0.0, 0.0, 0.0), (-1e-2, -1e-2), 1.0)
    assert contact.bound == 0.0


def hulled(contact: Pressed, centre: Vec, depth: float) -> Pressed:
    """The same with a hull about some point, pressed into the wall by a depth [m]."""
    r, [wall] = rotation(contact.state.attitude), contact.world.obstacles
    away = signed_distance(wall.shape, r @ centre)
    hull = (Sphere(centre, away + depth),)
    return replace(contact, airframe=contact.airframe._replace(hull=hull))


@pytest.mark.parametrize("robot", ["arq", "quad"])
def test_with_a_hull_the_bound_is_never_below_the_truth_either(robot: str) -> None:
    """Alone, where the bound is coarse, and beside cages."""
    released, chance = 1.0 if robot == "arq" else 0.0, np.random.default_rng(8)
    for attitude in nonempty(attitudes()):
        for depths in ((3e-3, 1e-3), (-2e-2, -2e-2)):
            centre = Vec(*chance.uniform(-0.03, 0.03, 3).tolist())
            cages = pressed(robot, attitude, depths, released)
            cages = replace(cages, state=cages.state._replace(arm_length=(0.19,) * 4))
            contact = hulled(cages, centre, 2e-3)
            assert contact.truth > 100.0
            assert (1.0 - 1e-6) * contact.truth < contact.bound < 1.8 * contact.truth
            assert contact.bound > cages.bound


def test_rates_of_contacts_and_slips_count_the_hull() -> None:
    """√(3/2 k (√δ + √Δ) (1/m + r²/J)) of a sphere pressed in by δ, Δ = 0.1 ms at its speed ahead."""
    flat = Quat(math.sqrt(0.5), 0.0, math.sqrt(0.5), 0.0)
    alone = pressed("quad", flat, (-2e-2, -2e-2), 0.0)
    contact = hulled(alone, Vec(0.0, 0.0, 0.0), 2e-3)
    slides = replace(contact, state=contact.state._replace(velocity=Vec(0.0, 0.0, 0.4)))
    seen = slides._rates(slides.state).seen
    spin = norm(slides.state.angular_velocity)
    far = 0.19 + 0.11
    ahead = 1e-4 * (0.4 + far * spin + max(map(abs, slides.state.arm_rate)))
    stiffness = 1.5 * 2e4 * (math.sqrt(2e-3) + math.sqrt(ahead))
    j = slides.airframe.inertia
    inertia = min(j.x.x, j.y.y, j.z.z)
    mass = slides.airframe.mass
    assert seen.contact_rate >= math.sqrt(1.5 * 2e4 * math.sqrt(2e-3) / mass)
    assert seen.contact_rate <= math.sqrt(stiffness * (1.0 / mass + far * far / inertia)) * (
        1 + 1e-9
    )
    change = math.hypot(seen.acceleration.y, seen.acceleration.z)
    # Its moment turns the point of contact, too, which so slows down faster.
    assert seen.slip_rate > change / math.hypot(0.4, 0.03)
    assert alone._rates(alone.state).seen.contact_rate == 0.0
