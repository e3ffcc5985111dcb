"""Making out a collision: where it was, from where it pushed, on which arms, and how hard.

Three ways side by side, as in `springback.recovery.detection`: from the arms' lengths, from the
accelerometer, and from the external wrench.  Directions f_c⁰ point from the robot to the obstacle,
against the force that the robot feels, and are unit vectors in world axes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import each, largest, pick, total
from springback.kernels.vectors import Mat, Vec, norm, rotation
from springback.recovery.detection import compressions, horizontal, jolt
from springback.recovery.wrench import ExternalWrench
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Airframe, Arm, arm_direction

#: Squared length below which a vector has no direction (chosen: far below any reading).
NO_DIRECTION = 1e-12


class Characterisation(NamedTuple):
    """How to look."""

    window: float  # after the alarm, in which to look [s]
    arms: float  # weight of the direction from the arms, 1 or 0
    acceleration: float  # from the accelerometer
    wrench: float  # from the external force
    share: float  # an arm took part if pressed in by this share of the most pressed one
    level: float  # 1: collisions are with upright things; 0: from anywhere
    limit: float  # a reading beyond this on any axis is clipped, and says no direction [m/s²]


class Impression(NamedTuple):
    """What was seen of a collision while looking."""

    pressed: tuple[float, ...]  # largest compression of each arm [m]
    jolted: Vec  # horizontal specific force where it was largest, world [m/s²]
    pushed: Vec  # external force where it was largest, world [N]


class Collision(NamedTuple):
    """What a robot makes out of a collision."""

    position: Vec  # p_c, of the main body at the alarm, world [m]
    velocity: Vec  # of the main body before, world [m/s]
    direction: Vec  # f_c⁰ as the robot relies on, world
    by_arms: Vec  # the same from arms' lengths; zero where they say nothing
    by_acceleration: Vec  # from the accelerometer
    by_wrench: Vec  # from the external wrench
    contact_point: Vec  # of robot and obstacle, world [m]
    arms: tuple[float, ...]  # 1 for each arm that took part
    intensity: float  # largest external force [N]


@kernel
def no_impression(airframe: Airframe) -> Impression:
    """Nothing seen yet."""
    none = Vec(0.0, 0.0, 0.0)
    return Impression(each(_nothing, (airframe.arms,), ()), none, none)


@kernel
def _nothing(arm: Arm) -> float:
    return 0.0


def no_collision(airframe: Airframe) -> Collision:
    """Before the first collision."""
    none = Vec(0.0, 0.0, 0.0)
    return Collision(none, none, none, none, none, none, none, (0.0,) * len(airframe.arms), 0.0)


@kernel
def _more(a: float, b: float) -> float:
    return a if a > b else b


@kernel
def unclipped(limit: float, force: Vec) -> bool:
    """Whether an accelerometer's reading is within its range on every axis."""
    inside = (force.x * force.x < limit * limit) & (force.y * force.y < limit * limit)
    return inside & (force.z * force.z < limit * limit)


@kernel
def impressed(
    look: Characterisation,
    airframe: Airframe,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    so_far: Impression,
) -> Impression:
    """What was seen, after one more tick."""
    pressed = each(_more, (so_far.pressed, compressions(airframe.arms, seen.arm_length)), ())
    jolted, pushed = jolt(seen, at), wrench.force - wrench.steady
    stronger = (jolted @ jolted) > (so_far.jolted @ so_far.jolted)
    stronger &= unclipped(look.limit, seen.inertial.specific_force)
    harder = (pushed @ pushed) > (so_far.pushed @ so_far.pushed)
    return Impression(
        pressed,
        pick(stronger, jolted, so_far.jolted),
        pick(harder, pushed, so_far.pushed),
    )


@kernel
def direction_of(a: Vec, level: float) -> Vec:
    """Unit vector along a vector or its horizontal part; zero where there is none."""
    kept = Vec(a.x, a.y, a.z * (1.0 - level))
    square = kept @ kept
    there = square > NO_DIRECTION
    return kept * pick(there, 1.0 / math.sqrt(pick(there, square, 1.0)), 0.0)


@kernel
def _pointing(arm: Arm, compression: float) -> Vec:
    return arm_direction(arm) * compression


@kernel
def _took_part(compression: float, most: float, share: float) -> float:
    return 1.0 if (compression > 0.0) & (compression >= share * most) else 0.0


@kernel
def _foremost(arm: Arm, length: float, ahead: Vec) -> float:
    """How far an arm's cage reaches along a direction in body axes [m]."""
    return length * (arm_direction(arm) @ ahead)


@kernel
def _tip(arm: Arm, length: float, took_part: float) -> Vec:
    return arm_direction(arm) * (length * took_part)


@kernel
def _abreast(reach: float, most: float, margin: float) -> float:
    return 1.0 if reach > most - margin else 0.0


@kernel
def touching_arms(
    look: Characterisation,
    airframe: Airframe,
    pressed: tuple[float, ...],
    lengths: tuple[float, ...],
    ahead: Vec,
) -> tuple[float, ...]:
    """Which arms took part: those pressed in, or where none gives way, those foremost.

    Args:
        look: Settings.
        airframe: As the pilot believes it to be.
        pressed: Largest compression of each arm [m].
        lengths: Of the arms [m].
        ahead: f_c⁰ in body axes.
    """
    most = largest(pressed)
    felt = each(_took_part, (pressed,), (most, look.share))
    reach = each(_foremost, (airframe.arms, lengths), (ahead,))
    front = each(_abreast, (reach,), (largest(reach), ABREAST))
    return pick(most > FELT, felt, front)


#: Compression from which an arm counts as pressed in [m], chosen: ten steps of the Hall sensor.
FELT = 2e-4
#: Arms that reach within this of the foremost touch together [m], chosen.
ABREAST = 0.02


@kernel
def contact_point(
    airframe: Airframe,
    at: Estimate,
    r: Mat,
    lengths: tuple[float, ...],
    arms: tuple[float, ...],
    direction: Vec,
) -> Vec:
    """Where robot and obstacle touch: the cages' points along f_c⁰, their mean for several [m].

    p + R l_j e_j + r_0 (n − (n·b) b)/‖n − (n·b) b‖ with n = f_c⁰ and b the body's z axis.

    Args:
        airframe: As the pilot believes it to be.
        at: Where the robot believes to be.
        r: Its attitude.
        lengths: Of the arms [m].
        arms: 1 for each arm that took part.
        direction: f_c⁰, world.
    """
    count = total(arms)
    share = 1.0 / pick(count > 0.5, count, 1.0)
    tips = total(each(_tip, (airframe.arms, lengths, arms), ())) * share
    up = Vec(r.x.z, r.y.z, r.z.z)
    rim = direction_of(direction - up * (direction @ up), 0.0) * airframe.arms[0].cage_radius
    return at.position + r @ tips + rim * pick(count > 0.5, 1.0, 0.0)


@kernel
def characterised(
    look: Characterisation,
    airframe: Airframe,
    seen: Measurement,
    at: Estimate,
    found: Impression,
    position: Vec,
    velocity: Vec,
) -> Collision:
    """A collision, at the end of the window.

    From the arms: f_c⁰ ∥ R Σ (L − l)_j e_j, after Liu and Karydis (ICRA 2021).  From the
    accelerometer: against its largest horizontal reading within its range, as McGill's flight code
    and Air Bumper do.  From the wrench: against the external force.  Where the way that is relied
    on says nothing, the wrench is asked, and then the velocity.

    Args:
        look: Settings.
        airframe: As the pilot believes it to be.
        seen: What the sensors say.
        at: What the estimator says.
        found: Of all ticks of the window.
        position: p_c, of the main body at the alarm [m].
        velocity: Before the collision [m/s].
    """
    r = rotation(at.attitude)
    tips = total(each(_pointing, (airframe.arms, found.pressed), ()))
    by_arms = direction_of(r @ tips, look.level)
    by_acceleration = direction_of(horizontal(-found.jolted), look.level)
    by_wrench = direction_of(-found.pushed, look.level)
    chosen = by_arms * look.arms + by_acceleration * look.acceleration + by_wrench * look.wrench
    other = pick(by_wrench @ by_wrench > 0.5, by_wrench, direction_of(velocity, look.level))
    direction = pick(chosen @ chosen > 0.5, chosen, other)
    arms = touching_arms(look, airframe, found.pressed, seen.arm_length, direction @ r)
    point = contact_point(airframe, at, r, seen.arm_length, arms, direction)
    return Collision(
        position, velocity, direction, by_arms, by_acceleration, by_wrench, point, arms,
        norm(found.pushed),
    )  # fmt: skip
