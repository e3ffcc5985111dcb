"""Forces on a compliant vehicle, written down in NumPy for engines that know nothing of them.

Spring, damper and end stops of each arm, rotor thrust and torque, and the cage against a plane wall, or
against solids (`oracles.solid_loads`).
The engines bring the inertia: masses, centrifugal and Coriolis terms, gravity.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from oracles.models import ArmSpec, Scene, Start
from oracles.solid_loads import Part, solids_force

Array = NDArray[np.float64]


class Loads(NamedTuple):
    """Everything that acts, but inertia and gravity."""

    joint: Array  # along each arm, positive lengthens [N], shape (arms,)
    force: Array  # on each arm's end, world [N], shape (arms, 3)
    moment: Array  # on each arm, about its end, world [N m], shape (arms, 3)
    point: Array  # the arms' ends, world [m], shape (arms, 3)
    body_force: Array  # on the main body, world [N], shape (3,)
    body_moment: Array  # on the main body, about its centre, world [N m], shape (3,)


def arm_force(arm: ArmSpec, length: float, rate: float) -> float:
    """Spring, damper and end stops; the stops press like k δ (1 + d δ̇) and never pull [N]."""
    force = -arm.stiffness * (length - arm.length) - arm.damping * rate
    if length < arm.shortest:
        depth, depth_rate = arm.shortest - length, -rate
        force += max(0.0, arm.stop_stiffness * depth * (1 + arm.stop_dissipation * depth_rate))
    elif length > arm.length:
        depth, depth_rate = length - arm.length, rate
        force -= max(0.0, arm.stop_stiffness * depth * (1 + arm.stop_dissipation * depth_rate))
    return force


def wall_force(
    scene: Scene, r: Array, e: Array, end: Array, end_velocity: Array, omega: Array, r_0: float
) -> tuple[Array, Array]:
    """Force of the wall on one cage and its moment about the arm's end; all in world axes.

    Args:
        scene: Wall and contact point model.
        r: Attitude.
        e: Direction of the arm.
        end: The arm's end [m].
        end_velocity: Of the arm's end [m/s].
        omega: Angular velocity, world [rad/s].
        r_0: Cage radius [m].
    """
    wall = scene.wall
    n = -np.asarray(wall.normal)  # into the wall
    if scene.contact == "ring":
        # Support point of the circle: of all r_0 (cos s, sin s, 0) the one farthest along n.
        in_plane = r.T @ n
        reach = math.hypot(in_plane[0], in_plane[1], scene.rounding)
        pressed_at = r_0 / reach * (r @ np.array([in_plane[0], in_plane[1], 0.0]))
        rubbed_at = pressed_at
        depth = n @ end + r_0 * reach + wall.offset
    else:
        pressed_at, rubbed_at = r_0 * e, np.zeros(3)
        depth = n @ end + r_0 * (e @ n) + wall.offset
    if depth <= 0.0:
        return np.zeros(3), np.zeros(3)
    depth_rate = n @ (end_velocity + np.cross(omega, pressed_at))
    f_n = max(0.0, float(wall.stiffness * depth**1.5 * (1 + wall.dissipation * depth_rate)))
    slip = end_velocity + np.cross(omega, rubbed_at)
    slip = slip - n * (n @ slip)
    if scene.friction_axes == "vertical":
        up = np.array([0.0, 0.0, 1.0]) - n * n[2]
        up /= np.linalg.norm(up)
        slip = up * (up @ slip)
    f_f = -wall.friction * f_n * slip / math.sqrt(slip @ slip + wall.slip_speed**2)
    return f_f - f_n * n, np.cross(pressed_at, -f_n * n) + np.cross(rubbed_at, f_f)


def hull_force(scene: Scene, now: Start) -> tuple[Array, Array]:
    """Force of the wall on the hull and its moment about the main body; all in world axes."""
    wall, hull, r = scene.wall, scene.craft.hull, now.rotation
    if hull is None:
        return np.zeros(3), np.zeros(3)
    into = -np.asarray(wall.normal)
    lowest = r @ hull.centre + hull.radius * into  # the sphere's point nearest to the wall
    depth = into @ (now.position + lowest) + wall.offset
    if depth <= 0.0:
        return np.zeros(3), np.zeros(3)
    velocity = now.velocity + np.cross(r @ now.omega, lowest)
    closing, slip = into @ velocity, velocity - into * (into @ velocity)
    if scene.friction_axes == "vertical":
        up = np.array([0.0, 0.0, 1.0]) - into * into[2]
        slip = up * (up @ slip) / (up @ up)
    f_n = max(0.0, float(wall.stiffness * depth**1.5 * (1 + wall.dissipation * closing)))
    rubbing = -wall.friction * f_n / math.sqrt(slip @ slip + wall.slip_speed**2) * slip
    force = rubbing - f_n * into
    return force, np.cross(lowest, force)


def loads(scene: Scene, now: Start, time: float = 0.0) -> Loads:
    """All loads at one instant; those of solids instead of the wall's if there are any."""
    r, omega = now.rotation, now.rotation @ now.omega
    joint, forces, moments, points = [], [], [], []
    for arm, length, rate, thrust in zip(
        scene.craft.arms, now.lengths, now.rates, scene.thrust, strict=True
    ):
        e = r @ np.array([math.cos(arm.azimuth), math.sin(arm.azimuth), 0.0])
        end = now.position + length * e
        velocity = now.velocity + rate * e + np.cross(omega, length * e)
        if scene.solids:
            part = Part(end, velocity, omega, r, e, arm.cage_radius, scene.contact)
            force, moment = solids_force(scene.solids, part, time)
        else:
            force, moment = wall_force(scene, r, e, end, velocity, omega, arm.cage_radius)
        joint.append(arm_force(arm, length, rate))
        forces.append(force + thrust * r[:, 2])
        moments.append(moment + arm.torque_ratio * thrust * r[:, 2])
        points.append(end)
    arrays = (np.array(entries) for entries in (joint, forces, moments, points))
    return Loads(*arrays, *_on_body(scene, now, time))


def _on_body(scene: Scene, now: Start, time: float) -> tuple[Array, Array]:
    """Force on the main body's hull, and its moment about the main body; all in world axes."""
    hull, r = scene.craft.hull, now.rotation
    if not scene.solids or hull is None:
        return hull_force(scene, now)
    omega, lever = r @ now.omega, r @ hull.centre
    centre, velocity = now.position + lever, now.velocity + np.cross(omega, lever)
    part = Part(centre, velocity, omega, r, r[:, 0], hull.radius, "sphere")
    force, moment = solids_force(scene.solids, part, time)
    return force, moment + np.cross(lever, force)


class Flight(NamedTuple):
    """A flight of an oracle at equal steps."""

    end: Start
    peak_acceleration: float  # largest ‖v̇‖ of the main body at the steps [m/s²]
