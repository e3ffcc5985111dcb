"""Characterisation of a collision: its position, its direction, the arms hit, and its strength.

There are three ways, as in `springback.recovery.detection`: from the lengths of the arms, from the
accelerometer, and from the external wrench; a fourth combines them.  Directions f_c⁰ point from the
robot to the obstacle and are unit vectors in world axes.

The arms reveal only along which of them the robot was pressed, so a wall that touches one arm seems
to be perpendicular to it.  Accelerometer and wrench measure the contact force, which friction
deflects from the wall's normal: by up to 22 degrees in flights against the paper's wall, with its μ
of 0.8.  Only the line of action (`springback.recovery.line_of_action`) reveals the normal itself,
the direction in which there is free space: `fused` finds which cage that line passes, and where.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, select, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Quat, Vec, norm, rotation
from springback.recovery.detection import CollisionInputs, compressions, horizontal, jolt
from springback.recovery.line_of_action import (
    MISSED,
    Pass,
    direction_of,
    face_normal,
    leaning_normal,
    level_normal,
    lever_of,
    pass_of,
    tangent_normal,
)
from springback.recovery.wrench import ExternalWrench
from springback.vehicle.state import Airframe, end_place

#: Sine of the angle between contact force and normal beyond which more than one arm was hit.
#: Chosen: in flights against the paper's wall it is at most 0.4 for one arm, because cages stick
#: there, and 0.5 to 1.2, the length of an arm over the radius of its cage, for two.
ONE_ARM = 0.45
#: Compression above which an arm counts as pressed [m], chosen: ten counts of the Hall sensor.
FELT = 2e-4


class Characterisation(NamedTuple):
    """Settings of the characterisation."""

    window: float  # observation window after the alarm [s]
    longer: float  # least time after a clipped reading, if one rigid arm was hit [s]
    arms: float  # weight of the direction from the arms, 1 or 0
    acceleration: float  # from the accelerometer
    wrench: float  # from the external force
    fused: float  # from the line of action
    share: float  # an arm was hit if its compression is this share of the largest
    level: float  # 1: obstacles are upright; 0: normals have any direction
    limit: float  # a reading beyond this on any axis is clipped, and reveals no direction [m/s²]


class CollisionObservation(NamedTuple):
    """Measurements of a collision in its observation window."""

    ticks: float  # of the window so far
    pressed: tuple[float, ...]  # largest compression of each arm [m]
    jolted: Vec  # largest horizontal specific force, world [m/s²]
    pushed: Vec  # largest external force, world [N]
    clipped: float  # last tick of the window with a clipped reading, 0 before
    attitude: Quat  # at the alarm
    lengths: tuple[float, ...]  # of the arms at the alarm [m]


class Collision(NamedTuple):
    """A collision as the robot estimates it."""

    position: Vec  # p_c, of the main body at the alarm, world [m]
    velocity: Vec  # of the main body before, world [m/s]
    direction: Vec  # f_c⁰ that the recovery uses, world
    by_arms: Vec  # the same from the lengths of the arms; zero if they reveal none
    by_acceleration: Vec  # from the accelerometer
    by_wrench: Vec  # from the impulse of the external force
    by_fusion: Vec  # the obstacle's normal, from the line of action
    contact_point: Vec  # of robot and obstacle, world [m]
    arms: tuple[float, ...]  # 1 for each arm that was hit
    intensity: float  # largest external force [N]


class CollisionStart(NamedTuple):
    """Position and velocity of the main body when a collision began, and its detector's f_c⁰."""

    position: Vec  # p_c, at the alarm, world [m]
    velocity: Vec  # before the collision, world [m/s]
    direction: Vec  # f_c⁰ of a detector of the user's own, world; zero if there is none


@kernel
def no_observation(airframe: Airframe) -> CollisionObservation:
    """The observation before the first tick of the window."""
    none, upright = Vec(0.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)
    unpressed = tree_map(_nothing, (airframe.arms,), ())
    return CollisionObservation(0.0, unpressed, none, none, 0.0, upright, unpressed)


@kernel
def _nothing(arm: Any) -> float:
    return 0.0


def no_collision(airframe: Airframe) -> Collision:
    """The collision before the first one."""
    none, arms = Vec(0.0, 0.0, 0.0), (0.0,) * len(airframe.arms)
    return Collision(none, none, none, none, none, none, none, none, arms, 0.0)


@kernel
def _more(a: float, b: float) -> float:
    return a if a > b else b


@kernel
def is_within(limit: float, force: Vec) -> bool:
    """True if an accelerometer's reading is within its range on each axis."""
    inside = (force.x * force.x < limit * limit) & (force.y * force.y < limit * limit)
    return inside & (force.z * force.z < limit * limit)


@kernel
def observation_after(
    settings: Characterisation, inputs: CollisionInputs, so_far: CollisionObservation
) -> CollisionObservation:
    """Observation after one more tick of the window."""
    airframe, measurement, at, wrench = inputs
    lengths = measurement.arm_length
    pressed = tree_map(_more, (so_far.pressed, compressions(airframe.arms, lengths)), ())
    jolted, pushed = jolt(measurement, at), wrench.force - wrench.steady
    within = is_within(settings.limit, measurement.inertial.specific_force)
    stronger = ((jolted @ jolted) > (so_far.jolted @ so_far.jolted)) & within
    harder = (pushed @ pushed) > (so_far.pushed @ so_far.pushed)
    new = so_far.ticks < 0.5
    return CollisionObservation(
        so_far.ticks + 1.0,
        pressed,
        select(stronger, jolted, so_far.jolted),
        select(harder, pushed, so_far.pushed),
        select(within, so_far.clipped, so_far.ticks + 1.0),
        select(new, at.attitude, so_far.attitude),
        select(new, lengths, so_far.lengths),
    )


@kernel
def window_is_over(
    settings: Characterisation,
    so_far: CollisionObservation,
    arms: tuple[float, ...],
    elapsed: float,
) -> bool:
    """True if the observation window is over.

    If the accelerometer clipped and one rigid arm was hit, the window lasts until motion capture
    has measured the motion after the clipping, and so the velocity change that was lost.  Two arms
    reveal the normal without it, compliant arms lose less, and a robot that leans on the wall must
    not wait.

    Args:
        settings: Settings.
        so_far: Observation so far.
        arms: Arms that were hit as far as is known, 1 or 0 each.
        elapsed: Time since the alarm [s].
    """
    alone = (so_far.clipped > 0.5) & (maximum(so_far.pressed) <= FELT) & (tree_sum(arms) < 1.5)
    since = elapsed * (1.0 - so_far.clipped / select(so_far.ticks > 0.5, so_far.ticks, 1.0))
    return (elapsed >= settings.window) & ((not alone) | (since >= settings.longer))


@kernel
def _compression_vector(arm: Any, compression: float) -> Vec:
    return end_place(arm, arm.length).direction * compression


@kernel
def _in_front(compression: float, sine: float) -> float:
    """Compression of an arm in front; arms behind are compressed by their own inertia, too."""
    return select(sine < MISSED, compression, 0.0)


@kernel
def _is_pressed(compression: float, most: float, share: float) -> float:
    return 1.0 if (compression > FELT) & (compression >= share * most) else 0.0


@kernel
def pressed_arms(
    settings: Characterisation, pressed: tuple[float, ...], line: Pass
) -> tuple[float, ...]:
    """Arms in front that were pressed, 1 or 0 each.

    Args:
        settings: Settings.
        pressed: Largest compression of each arm [m].
        line: Pass of the line of action by the cages.
    """
    front = tree_map(_in_front, (pressed, line.sines), ())
    return tree_map(_is_pressed, (front,), (maximum(front), settings.share))


@kernel
def _tip(arm: Any, length: float, hit: float) -> Vec:
    at = end_place(arm, length)
    return at.direction * (at.distance * hit)


@kernel
def touching_arms(
    settings: Characterisation, pressed: tuple[float, ...], line: Pass
) -> tuple[float, ...]:
    """Arms that were hit, 1 or 0 each: those pressed or, if none is, those on the line of action.

    Args:
        settings: Settings.
        pressed: Largest compression of each arm [m].
        line: Pass of the line of action by the cages.
    """
    felt = pressed_arms(settings, pressed, line)
    rigid = select(abs(line.sine) < ONE_ARM, line.one, line.two)
    return select(tree_sum(felt) > 0.5, felt, rigid)


@kernel
def contact_point(
    airframe: Airframe,
    position: Vec,
    r: Mat3,
    lengths: tuple[float, ...],
    arms: tuple[float, ...],
    direction: Vec,
) -> Vec:
    """Contact point of robot and obstacle: the foremost point of a cage along f_c⁰, world [m].

    It is the mean for several arms:

    p + R l_j e_j + r_0 (n − (n·b) b)/‖n − (n·b) b‖ with n = f_c⁰ and b the body's z axis.

    Args:
        airframe: In the pilot's model.
        position: Of the main body [m].
        r: Its attitude.
        lengths: Of the arms [m].
        arms: 1 for each arm that was hit.
        direction: f_c⁰, world.
    """
    count = tree_sum(arms)
    share = 1.0 / select(count > 0.5, count, 1.0)
    tips = tree_sum(tree_map(_tip, (airframe.arms, lengths, arms), ())) * share
    up = Vec(r.x.z, r.y.z, r.z.z)
    rim = direction_of(direction - up * (direction @ up), 0.0) * airframe.arms[0].cage_radius
    point: Vec = position + r @ tips + rim * select(count > 0.5, 1.0, 0.0)
    return point


class Bearing(NamedTuple):
    """Directions of a collision, from force and moment."""

    force: Vec  # unit vector against the impulse of the force, world
    normal: Vec  # of the obstacle, world; zero if it cannot be found
    line: Pass


@kernel
def bearing(
    settings: Characterisation,
    airframe: Airframe,
    r: Mat3,
    lengths: tuple[float, ...],
    pressed: tuple[float, ...],
    wrench: ExternalWrench,
) -> Bearing:
    """Direction of the contact force, and normal of the obstacle's face.

    If the line of action passes one cage at an angle that friction allows, the normal is the
    direction of the force turned back by that angle.  If it passes between two cages, both were
    hit, and the normal is that of their common tangent.  That is its projection onto the plane of
    the cages: an upright obstacle has one normal with it, of another the force tells the rest.
    One that need not be upright need not be plane either: two cages on a pole or an edge have no
    common tangent, and the direction of the force is taken.

    Args:
        settings: Settings.
        airframe: In the pilot's model.
        r: Attitude.
        lengths: Of the arms [m].
        pressed: Largest compression of each arm [m].
        wrench: Estimate of the observer.
    """
    impulse = wrench.recent.impulse
    inward, c = (-impulse) @ r, wrench.recent.carried
    ahead = direction_of(Vec(inward.x, inward.y, 0.0), 0.0)
    # The robot turns during the collision: the cages are those of the body axes at that time.
    carried = direction_of(Vec(-c.x, -c.y, 0.0), 0.0)
    line: Pass = pass_of(airframe, lengths, carried, lever_of(wrench.recent))
    felt = pressed_arms(settings, pressed, line)
    both = (abs(line.sine) >= ONE_ARM) | (tree_sum(felt) > 1.5)
    common = select(settings.level > 0.5, tangent_normal(line.span, ahead), ahead)
    normal = select(both, common, face_normal(ahead, line.sine))
    free = r @ leaning_normal(normal, inward)
    whole = select(settings.level > 0.5, level_normal(r, normal), free)
    return Bearing(direction_of(-impulse, settings.level), whole, line)


@kernel
def characterise(
    settings: Characterisation,
    inputs: CollisionInputs,
    found: CollisionObservation,
    start: CollisionStart,
) -> Collision:
    """A collision from its observation window.

    From the arms: f_c⁰ ∥ R Σ (L − l)_j e_j, after Liu and Karydis (ICRA 2021).  From the
    accelerometer: against its largest horizontal reading within its range, as in McGill's flight
    code and in Air Bumper.  From the wrench: against the impulse of the external force.  Fused: the
    obstacle's normal from the line of action.  If the chosen way reveals no direction, it is that
    of the wrench, or else that of the velocity.  A direction from a detector of the user's own goes
    before all of these.

    Args:
        settings: Settings.
        inputs: At the present tick.
        found: Of all ticks of the window.
        start: Of the collision.
    """
    airframe, measurement, at, wrench = inputs
    r = rotation(at.attitude)
    tips = tree_sum(tree_map(_compression_vector, (airframe.arms, found.pressed), ()))
    by_arms = direction_of(r @ tips, settings.level)
    by_acceleration = direction_of(horizontal(-found.jolted), settings.level)
    lengths = measurement.arm_length
    by_wrench: Bearing = bearing(settings, airframe, r, lengths, found.pressed, wrench)
    force, normal = by_wrench.force, by_wrench.normal
    chosen = by_arms * settings.arms + by_acceleration * settings.acceleration
    chosen = chosen + force * settings.wrench + normal * settings.fused
    other = select(force @ force > 0.5, force, direction_of(start.velocity, settings.level))
    own = direction_of(start.direction, settings.level)
    chosen = select(own @ own > 0.5, own, chosen)
    direction = select(chosen @ chosen > 0.5, chosen, other)
    arms = touching_arms(settings, found.pressed, by_wrench.line)
    first = rotation(found.attitude)
    point = contact_point(airframe, start.position, first, found.lengths, arms, direction)
    return Collision(
        start.position, start.velocity, direction, by_arms, by_acceleration, force, normal, point,
        arms, norm(found.pushed),
    )  # fmt: skip
