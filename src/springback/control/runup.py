"""Run-ups: from rest to an obstacle, arriving with a given speed and pitch.

A run-up is level and straight, so one function describes it: the acceleration a tilts the thrust
m √(g² + a²) by θ = atan(a/g), and its rate of change turns it by θ̇ = g ȧ/(g² + a²).  A pitch at
contact is an acceleration a = g tan θ there, positive (nose down) accelerating into the obstacle.

The robot does not know the obstacle: after the contact the acceleration continues for a while, then
the reference brakes to rest.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import support
from springback.control.approach import FEW, approach
from springback.control.demands import ROOM, Limits, demands
from springback.control.polynomials import as_reference, padded_reference
from springback.control.references import Polynomials
from springback.control.septics import Row, SplineCurve, septics, shares
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.vehicle.hulls import hull_reach
from springback.vehicle.state import Airframe, arm_pose


class RunUp(NamedTuple):
    """A run-up, and its demands from rest to contact."""

    reference: Polynomials
    contact_time: float  # [s]
    contact_position: Vec  # of the main body, world [m]
    largest_thrust: float  # collective [N]
    largest_tilt: float  # [rad]
    largest_tilt_rate: float  # [rad/s]


def reach(airframe: Airframe, contact_point: Any, pitch: float, yaw: float = 0.0) -> float:
    """Distance of the foremost part ahead of the main body when it touches a wall across X [m].

    For two front arms at 45° and a ring it is (L/√2 + r_0) cos θ.  The attitude is that of
    `springback.control.position.heading` with b_3 = (sin θ, 0, cos θ) and the heading ψ.

    Args:
        airframe: The vehicle, with its arms at their free length.
        contact_point: `Ring` or `ArmTip`, the model of contact.
        pitch: θ, tilt towards the wall; without yaw the pitch, positive nose down [rad].
        yaw: ψ, from −π/2 to π/2 or beyond [rad].
    """
    slope = math.tan(pitch) * math.sin(yaw)
    across = math.sqrt(1.0 + slope * slope)
    ahead, aside = math.cos(yaw) / across, math.sin(yaw) / across
    inward = Vec(math.cos(pitch) * ahead, 0.0 - aside, math.sin(pitch))  # world X in body axes
    ends = []
    for arm in airframe.arms:
        if arm.caged == 0.0:
            continue
        pose = arm_pose(arm, arm.length, 0.0, inward)  # only its position is used
        at = support(contact_point, inward, pose.direction, arm.cage_radius)
        ends.append(inward @ (pose.lever + at.point) - at.inset)
    hulls = [hull_reach(hull, inward) for hull in airframe.hull]
    for arm in airframe.arms:
        at_end = [hull_reach(hull, inward) for hull in arm.hull]
        end = arm_pose(arm, arm.length, 0.0, inward).lever
        hulls += [inward @ end + ahead for ahead in at_end]
    return max(ends + hulls)


class RunUpContact(NamedTuple):
    """End of a run-up: the contact."""

    position: Vec  # of the main body, world, at the height of the start [m]
    speed: float  # along the path [m/s]
    pitch: float  # tilt towards the obstacle; without yaw the pitch, positive nose down [rad]
    yaw: float = 0.0  # heading from the direction of flight, all along the run-up [rad]


class RunUpTiming(NamedTuple):
    """Times of a run-up [s]."""

    steady: float = 0.1
    """Before contact, at constant pitch; chosen, about one time constant of an attitude loop."""
    beyond: float = 0.3
    """After contact, until the acceleration ends; chosen."""
    begins: float = 0.0


USUAL_TIMING = RunUpTiming()


def run_up(
    start: Vec,
    contact: RunUpContact,
    limits: Limits,
    timing: RunUpTiming = USUAL_TIMING,
    advises: bool = True,
) -> RunUp:
    """A run-up from rest at ``start`` to contact.

    The simplest run-up is tried first: one minimum-snap polynomial from rest to the steady phase,
    of the duration that uses the limits least without ever moving back.  If that leaves no room for
    feedback, the knots of a spline are moved to use the limits least.

    Args:
        start: World [m].
        contact: Position, speed and pitch at contact.
        limits: Limits of the vehicle.
        timing: Of its phases.
        advises: If the distance is too short, find one that suffices; slow.

    Raises:
        InputError: Naming the limit that is exceeded and by how much: thrust, tilt, or the distance
            that keeps the tilt rate within bounds.
    """
    end, speed, pitch, turned = contact
    steady, beyond, begins = timing
    way = end - start
    distance = math.hypot(way.x, way.y)
    who = f"the run-up to {speed:g} m/s at {math.degrees(pitch):g} deg"
    if speed <= 0.0 or abs(way.z) > 1e-9 or distance == 0.0 or abs(pitch) >= 0.5 * math.pi:
        raise InputError(
            f"{who} must end level with its start, apart from it, moving, below 90 deg"
        )
    if limits.gravity == 0.0:
        raise InputError(f"{who} needs gravity: it accelerates by tilting the thrust")
    a = limits.gravity * math.tan(pitch)
    breaks, rows = approach(distance, speed, a, steady, limits, who, advises)
    touching = len(breaks)
    for duration, row in _afterwards(rows[-1], a, beyond, limits):
        breaks.append(breaks[-1] + duration)
        rows.append(row)
    direction = np.array([way.x, way.y, 0.0]) / distance
    along = np.array(rows)[:, :, None] * direction
    along[:, 0] += np.array(start)
    curve = SplineCurve(breaks, along)
    asked = demands(curve, breaks[:touching], limits)
    yaw = math.atan2(way.y, way.x) + turned
    return RunUp(
        padded_reference(as_reference(curve, breaks, yaw, begins)),
        begins + breaks[touching - 1],
        end,
        asked.max_thrust,
        asked.tilt,
        asked.tilt_rate,
    )


def _afterwards(contact: Row, a: float, beyond: float, limits: Limits) -> list[tuple[float, Row]]:
    """Durations and ends of the phases after contact: the acceleration continues, then rest."""
    x = contact[0] + contact[1] * beyond + 0.5 * a * beyond**2
    v = contact[1] + a * beyond
    going_on: list[tuple[float, Row]] = [(beyond, (x, v, a, 0.0))] if beyond > 0.0 else []
    return [*going_on, _braking((x, v, a, 0.0), limits)]


def _braking(start: Row, limits: Limits) -> tuple[float, Row]:
    """Duration and end of the shortest stop that leaves `ROOM`, or of the gentlest.

    The velocity is the quintic from v and a to rest; its integral is v T/2 + a T²/10.
    """
    x, v, a, _ = start
    durations = np.geomspace(0.05, 20.0, 120)
    places = x + 0.5 * v * durations + 0.1 * a * durations**2
    last = np.concatenate([places[None], np.zeros((3, len(durations)))])
    used = shares(septics(np.array(start)[:, None], last, durations, FEW), limits)
    best = int(np.argmax(used <= ROOM)) if used.min() <= ROOM else int(np.argmin(used))
    return float(durations[best]), (float(places[best]), 0.0, 0.0, 0.0)
