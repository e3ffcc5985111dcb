"""The impulse–momentum law of the planning literature: an instant, no force.

The vehicle is taken as one rigid body.  Newton's restitution acts along each touched normal and a
Coulomb impulse against the slip, all cages that touch at that instant together (projected
Gauss–Seidel).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import meeting, slip_velocity, support
from springback.contact.obstacles import Obstacle, World, obstacle_seen
from springback.contact.surfaces import Surface
from springback.dynamics.energy import about_mass_centre, energy, spread
from springback.dynamics.motion import LANDED, Motion, Work
from springback.kernels.compiler import rare_kernel
from springback.kernels.trees import each, total
from springback.kernels.vectors import Mat, Vec, positive_part, rotation, solve_symmetric
from springback.vehicle.state import Airframe, Arm, State, arm_pose, arms_inertia

SWEEPS = 100


class Hit(NamedTuple):
    """One cage at one obstacle at the instant of an impulse."""

    active: float  # 1 where it touches and closes in
    normal: Vec  # out of the obstacle, world
    lever: Vec  # from the main body to the contact point, world [m]
    gap: float  # [m]
    surface: Surface


@rare_kernel
def _hit_obstacle(
    obstacle: Obstacle, contact_point: Any, radius: float, arm: Any, r: Mat, omega: Vec
) -> Hit:
    met = meeting(obstacle, contact_point, radius, arm, omega, Vec(r.z.x, r.z.y, r.z.z))
    at = support(contact_point, met.inward, arm.direction, radius)
    closing = (met.gap <= LANDED) & (met.rate < 0.0) & (met.impulsive > 0.0)
    lever = r @ (arm.lever + at.normal_lever)
    return Hit(1.0 if closing else 0.0, -(r @ met.inward), lever, met.gap, obstacle.surface)


@rare_kernel
def _hits_of_arm(
    arm: Arm,
    length: float,
    rate: float,
    obstacles: tuple[Obstacle, ...],
    contact_point: Any,
    state: State,
    r: Mat,
) -> tuple[Hit, ...]:
    pose = arm_pose(arm, length, rate, state.velocity @ r)
    shared = (contact_point, arm.cage_radius, pose, r, state.angular_velocity)
    return each(_hit_obstacle, (obstacles,), shared)


@rare_kernel
def struck(airframe: Airframe, world: World, contact_point: Any, motion: Motion) -> Motion:
    """The motion just after the impulses of all cages that touch and close in.

    Along each normal v⁺ = −e v⁻; tangentially the impulse opposes the slip and is at most μ times
    the normal one.  A cage that has sunk in is put back on the face.  The energy lost is booked,
    the work of the tangential impulses as friction, the rest as contact loss.
    """
    state, work = motion.state, motion.work
    r, m = rotation(state.attitude), airframe.mass
    arms = total(each(spread, (airframe.arms, state.arm_length, state.arm_rate), ()))
    centre = arms.first * (1.0 / m)
    inertia = about_mass_centre(airframe.inertia + arms_inertia(arms.second), m, centre)
    omega = r @ state.angular_velocity
    velocity = state.velocity + (omega ^ (r @ centre)) + r @ (arms.drift * (1.0 / m))
    obstacles = each(obstacle_seen, (world.obstacles,), (state.position, r))
    vertical = Vec(0.0, 0.0, 1.0)
    hits = each(
        _hits_of_arm,
        (airframe.arms, state.arm_length, state.arm_rate),
        (obstacles, contact_point, state, r),
    )
    count = len(hits) * len(hits[0])
    normal_impulse = [0.0] * count
    friction_impulse = [Vec(0.0, 0.0, 0.0)] * count
    target = [0.0] * count
    slip_before = [Vec(0.0, 0.0, 0.0)] * count
    sunk = Vec(0.0, 0.0, 0.0)
    v, w = velocity, omega
    for sweep in range(SWEEPS + 2):
        for k in range(count):
            hit = hits[k // len(hits[0])][k % len(hits[0])]
            if hit.active == 0.0:
                continue
            n, rho = hit.normal, hit.lever - r @ centre
            u = v + (w ^ rho)
            slip = slip_velocity(hit.surface, u, n, vertical)
            if sweep == 0:
                target[k] = -hit.surface.restitution * (u @ n)
                slip_before[k] = slip
                push = n * (positive_part(-hit.gap) - sunk @ n)
                sunk = sunk + push if push @ n > 0.0 else sunk
                continue
            if sweep == SWEEPS + 1:
                slip_before[k] = slip_before[k] + slip
                continue
            turn = r @ solve_symmetric(inertia, (rho ^ n) @ r)
            give = 1.0 / m + n @ (turn ^ rho)
            pressed = positive_part(normal_impulse[k] + (target[k] - u @ n) / give)
            impulse = n * (pressed - normal_impulse[k])
            normal_impulse[k] = pressed
            v = v + impulse * (1.0 / m)
            w = w + r @ solve_symmetric(inertia, (rho ^ impulse) @ r)

            slip = slip_velocity(hit.surface, v + (w ^ rho), n, vertical)
            speed = math.sqrt(slip @ slip)
            if speed > 0.0:
                t = slip * (1.0 / speed)
                turn = r @ solve_symmetric(inertia, (rho ^ t) @ r)
                give = 1.0 / m + t @ (turn ^ rho)
                rubbed = friction_impulse[k] - t * (speed / give)
                limit = hit.surface.friction * pressed
                size = math.sqrt(rubbed @ rubbed)
                rubbed = rubbed * (limit / size) if size > limit else rubbed
                impulse = rubbed - friction_impulse[k]
                friction_impulse[k] = rubbed
                v = v + impulse * (1.0 / m)
                w = w + r @ solve_symmetric(inertia, (rho ^ impulse) @ r)

    given, rubbed_off = Vec(0.0, 0.0, 0.0), 0.0
    for k in range(count):
        hit = hits[k // len(hits[0])][k % len(hits[0])]
        given = given + hit.normal * normal_impulse[k] + friction_impulse[k]
        rubbed_off -= 0.5 * (friction_impulse[k] @ slip_before[k])
    after = State(
        state.position + sunk,
        state.attitude,
        v - (w ^ (r @ centre)) - r @ (arms.drift * (1.0 / m)),
        w @ r,
        state.arm_length,
        state.arm_rate,
    )
    before = energy(airframe, world, contact_point, state)
    left = energy(airframe, world, contact_point, after)
    lost = before.kinetic + before.gravity - left.kinetic - left.gravity
    booked = Work(
        work.thrust,
        work.arm,
        work.stop,
        work.contact + lost - rubbed_off,
        work.friction + rubbed_off,
        work.settling,
        work.impulse + given,
    )
    return Motion(after, booked)
