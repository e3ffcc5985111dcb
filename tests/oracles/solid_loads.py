"""Forces of built-in shapes on rings, contact points and spheres, by formula and dense sampling.

The geometry is that of `oracles.distances`: a ring is sampled all around, its minima are found by
golden sections, gradients by differences.  The law is Hunt and Crossley's with the exponent 3/2, and
regularised Coulomb friction.  A shape may move: gaps and slips change by the relative velocity.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from oracles import distances
from oracles.distances import Field, Rings
from oracles.models import Craft, Placed, Solid, Start

Array = NDArray[np.float64]

#: Samples of a ring, and steps of a golden section: minima are found to 1e-8 rad.
SAMPLES, SEARCH = 720, 30
STILL = Placed(np.zeros(3), np.eye(3), np.zeros(3), np.zeros(3))


class Part(NamedTuple):
    """A part of a vehicle; world axes."""

    centre: Array  # of the ring or sphere, the end of the arm [m]
    velocity: Array  # of that point [m/s]
    omega: Array  # of the vehicle [rad/s]
    turn: Array  # of the vehicle, body to world
    arm: Array  # direction of the arm
    radius: float  # [m]
    kind: str  # ring, tip or sphere


class Touch(NamedTuple):
    """A place at which a part is inside a shape; world axes."""

    depth: float  # [m]
    gradient: Array  # of the gap, by a motion of the part; at a kink shorter than 1
    press: Array  # where the normal force acts, from the part's centre [m]
    rub: Array  # where friction acts, from the part's centre [m]
    back: Array  # gradient at the saddle from which the depth counts; zeros if it does not
    back_at: Array  # where that is, from the part's centre [m]


@lru_cache(maxsize=64)
def _field(solid: Solid) -> Field:
    return distances.least(distances.bodies_of(solid.shape))


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def _moved(field: Field, at: Placed) -> Field:
    """A distance after the shape has been turned about the origin of its motion, and moved."""
    return lambda points: field((points - at.position) @ at.turn)


def _ring_touches(field: Field, part: Part) -> list[Touch]:
    """At the two lowest minima inside the shape, if the ring is outside on the way between them."""
    if field(part.centre[None])[0] > part.radius:
        return []
    x, y = part.turn[:, 0], part.turn[:, 1]
    ring = Rings(part.centre[None], x[None], y[None], part.radius)
    angles = 2.0 * math.pi * np.arange(SAMPLES) / SAMPLES
    if field(ring.at(angles[None]))[0].min() > 1e-3:
        return []
    low = distances.ring_minima(field, ring, SAMPLES, SEARCH)
    none, found = np.zeros(3), []
    for k in (0, 1):
        if low.gap[0, k] < 0.0:
            normal, _ = distances.ring_normals(field, ring, low.angle[:, k])
            lever = ring.at(low.angle[:, k : k + 1])[0, 0] - part.centre
            found.append(Touch(-float(low.gap[0, k]), normal[0], lever, lever, none, none))
    if len(found) == 2:
        found[1] = _from_saddle(field, ring, low.angle[0], found[1])
    return found


def _from_saddle(field: Field, ring: Rings, angles: Array, touch: Touch) -> Touch:
    """A second touch, whose depth counts from the way out to the first if that is inside."""
    opposite: Field = lambda points: -field(points)  # noqa: E731
    first, second = angles
    best = math.inf, 0.0
    for start, span in (
        (first, (second - first) % math.tau),
        (second, (first - second) % math.tau),
    ):
        way = start + span * np.arange(1, SAMPLES) / SAMPLES
        gaps = field(ring.at(way[None]))[0]
        if gaps.max() < best[0]:
            best = float(gaps.max()), float(way[int(np.argmax(gaps))])
    if best[0] >= 0.0:
        return touch
    a, b = best[1] - math.tau / SAMPLES, best[1] + math.tau / SAMPLES
    for _ in range(SEARCH):
        c, d = b - distances.GOLDEN * (b - a), a + distances.GOLDEN * (b - a)
        there = opposite(ring.at(np.array([[c, d]])))[0]
        a, b = (a, d) if there[0] < there[1] else (c, b)
    at = np.array([0.5 * (a + b)])
    gradient, _ = distances.ring_normals(opposite, ring, at)
    saddle = float(field(ring.at(at[None]))[0, 0])
    lever = ring.at(at[None])[0, 0] - ring.centre[0]
    return touch._replace(depth=touch.depth + saddle, back=-gradient[0], back_at=lever)


def _touches(field: Field, part: Part) -> list[Touch]:
    none = np.zeros(3)
    if part.kind == "ring":
        return _ring_touches(field, part)
    n = _unit(distances.gradient(field, part.centre[None])[0])
    if part.kind == "sphere":
        lever = -part.radius * n
        gap = float(field(part.centre[None])[0]) - part.radius
        return [Touch(-gap, n, lever, lever, none, none)] if gap < 0.0 else []
    tip = part.radius * part.arm
    press = (tip @ n) * n
    gap = float(field((part.centre + press)[None])[0])
    return [Touch(-gap, n, tip, none, none, none)] if gap < 0.0 else []


def _force(solid: Solid, at: Placed, part: Part, touch: Touch) -> tuple[Array, Array]:
    """Force of one touch and its moment about the part's centre."""
    law = solid.shape.surface
    stiffness, dissipation = law.stiffness / law.shared_by, 1.5 * law.dissipation_value()

    def relative(lever: Array) -> Array:
        own = part.velocity + np.cross(part.omega, lever)
        return np.asarray(own - at.velocity - np.cross(at.omega, part.centre + lever - at.position))

    steepness = float(np.linalg.norm(touch.gradient))
    n = touch.gradient / steepness
    rate = -(touch.gradient @ relative(touch.press)) + touch.back @ relative(touch.back_at)
    pressed = max(0.0, stiffness * touch.depth**1.5 * (1.0 + dissipation * rate))
    slip = relative(touch.rub)
    slip = slip - n * (n @ slip)
    f_n = pressed * steepness
    rubbed = -law.friction * f_n * slip / math.sqrt(slip @ slip + law.slip_speed**2)
    back = -pressed * touch.back
    moment = np.cross(touch.press, f_n * n) + np.cross(touch.rub, rubbed)
    return f_n * n + rubbed + back, moment + np.cross(touch.back_at, back)


def solids_force(solids: tuple[Solid, ...], part: Part, time: float) -> tuple[Array, Array]:
    """Force of all solids on a part, and its moment about the part's centre [N, N m]."""
    force, moment = np.zeros(3), np.zeros(3)
    for solid in solids:
        at = STILL if solid.motion is None else solid.motion(time)
        push, turn = solid_force(solid, at, part)
        force, moment = force + push, moment + turn
    return force, moment


def solid_force(solid: Solid, at: Placed, part: Part) -> tuple[Array, Array]:
    """Force of one solid that is somewhere, and its moment about the part's centre [N, N m]."""
    force, moment = np.zeros(3), np.zeros(3)
    for touch in _touches(_moved(_field(solid), at), part):
        push, turn = _force(solid, at, part, touch)
        force, moment = force + push, moment + turn
    return force, moment


def clearance(solid: Solid, now: Start, craft: Craft) -> float:
    """Gap between a shape at its place and the nearest ring of a vehicle, or its hull [m]."""
    field, r = _field(solid), now.rotation
    gaps = []
    for arm, length in zip(craft.arms, now.lengths, strict=True):
        e = math.cos(arm.azimuth) * r[:, 0] + math.sin(arm.azimuth) * r[:, 1]
        centre = (now.position + length * e)[None]
        ring = Rings(centre, r[None, :, 0], r[None, :, 1], arm.cage_radius)
        gaps.append(float(distances.ring_minima(field, ring, SAMPLES).gap[0, 0]))
    if craft.hull is not None:
        gaps.append(
            float(field((now.position + r @ craft.hull.centre)[None])[0]) - craft.hull.radius
        )
    return min(gaps)


def in_front(solid: Solid, start: Start, craft: Craft, gap: float) -> Start:
    """The start moved along its velocity to some gap before the first touch [m]."""
    ahead, way = _unit(start.velocity), -1.0
    for _ in range(200):
        now = replace(start, position=start.position + way * ahead)
        room = clearance(solid, now, craft) - gap
        if room < 1e-6:
            return now
        way += room
    raise AssertionError("the shape is not in the way")
