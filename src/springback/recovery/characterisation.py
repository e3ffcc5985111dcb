"""Making out a collision: where it was, from where it came, on which arms, and how hard.

Three ways side by side, as in `springback.recovery.detection`: from the arms' lengths, from the
accelerometer, and from the external wrench; and a fourth that fuses them.  Directions f_c⁰ point
from the robot to the obstacle and are unit vectors in world axes.

The arms know only along which of them the robot was pressed, so a wall that meets one arm seems to
stand across it.  Accelerometer and wrench know the contact force, which friction turns away from
the wall's normal: by up to 22 degrees in flights against the paper's wall, whose μ is 0.8.  Only
the line of action (`springback.recovery.line_of_action`) tells the normal itself, which is where
the room is: `fused` asks which cage that line meets, and where.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import maximum, select, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Quat, Vec, norm, rotation
from springback.recovery.detection import compressions, horizontal, jolt
from springback.recovery.line_of_action import (
    MISSED,
    Pass,
    across,
    direction_of,
    level_normal,
    lever_of,
    passed,
    turned_back,
)
from springback.recovery.wrench import ExternalWrench
from springback.sensing.measurement import Estimate, Measurement
from springback.vehicle.state import Airframe, Arm, arm_direction

#: Sine of the angle between contact force and normal beyond which one arm alone cannot have been
#: hit.  Chosen: in flights against the paper's wall it is at most 0.4 for one arm, since cages
#: stick there, and 0.5 to 1.2, the length of an arm over the radius of its cage, for two.
ONE_ARM = 0.45


#: Compression from which an arm counts as pressed in [m], chosen: ten steps of the Hall sensor.
FELT = 2e-4


class Characterisation(NamedTuple):
    """How to look."""

    window: float  # after the alarm, in which to look [s]
    longer: float  # and after a clipped reading at least, where one rigid arm was hit [s]
    arms: float  # weight of the direction from the arms, 1 or 0
    acceleration: float  # from the accelerometer
    wrench: float  # from the external force
    fused: float  # from the line of action
    share: float  # an arm took part if pressed in by this share of the most pressed one
    level: float  # 1: collisions are with upright things; 0: from anywhere
    limit: float  # a reading beyond this on any axis is clipped, and says no direction [m/s²]


class CollisionObservation(NamedTuple):
    """What was seen of a collision while looking."""

    ticks: float  # so far
    pressed: tuple[float, ...]  # largest compression of each arm [m]
    jolted: Vec  # horizontal specific force where it was largest, world [m/s²]
    pushed: Vec  # external force where it was largest, world [N]
    clipped: float  # tick at which the accelerometer was last at its range, 0 before
    attitude: Quat  # at the alarm
    lengths: tuple[float, ...]  # of the arms at the alarm [m]


class Collision(NamedTuple):
    """What a robot makes out of a collision."""

    position: Vec  # p_c, of the main body at the alarm, world [m]
    velocity: Vec  # of the main body before, world [m/s]
    direction: Vec  # f_c⁰ as the robot relies on, world
    by_arms: Vec  # the same from arms' lengths; zero where they say nothing
    by_acceleration: Vec  # from the accelerometer
    by_wrench: Vec  # from the external force, summed up
    by_fusion: Vec  # the obstacle's normal, from the line of action
    contact_point: Vec  # of robot and obstacle, world [m]
    arms: tuple[float, ...]  # 1 for each arm that took part
    intensity: float  # largest external force [N]


@kernel
def no_observation(airframe: Airframe) -> CollisionObservation:
    """Nothing seen yet."""
    none, upright = Vec(0.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)
    unpressed = tree_map(_nothing, (airframe.arms,), ())
    return CollisionObservation(0.0, unpressed, none, none, 0.0, upright, unpressed)


@kernel
def _nothing(arm: Arm) -> float:
    return 0.0


def no_collision(airframe: Airframe) -> Collision:
    """Before the first collision."""
    none, arms = Vec(0.0, 0.0, 0.0), (0.0,) * len(airframe.arms)
    return Collision(none, none, none, none, none, none, none, none, arms, 0.0)


@kernel
def _more(a: float, b: float) -> float:
    return a if a > b else b


@kernel
def unclipped(limit: float, force: Vec) -> bool:
    """Whether an accelerometer's reading is within its range on every axis."""
    inside = (force.x * force.x < limit * limit) & (force.y * force.y < limit * limit)
    return inside & (force.z * force.z < limit * limit)


@kernel
def observe(
    look: Characterisation,
    airframe: Airframe,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    so_far: CollisionObservation,
) -> CollisionObservation:
    """What was seen, after one more tick."""
    pressed = tree_map(_more, (so_far.pressed, compressions(airframe.arms, seen.arm_length)), ())
    jolted, pushed = jolt(seen, at), wrench.force - wrench.steady
    stronger = (jolted @ jolted) > (so_far.jolted @ so_far.jolted)
    stronger &= unclipped(look.limit, seen.inertial.specific_force)
    harder = (pushed @ pushed) > (so_far.pushed @ so_far.pushed)
    within = unclipped(look.limit, seen.inertial.specific_force)
    new = so_far.ticks < 0.5
    return CollisionObservation(
        so_far.ticks + 1.0,
        pressed,
        select(stronger, jolted, so_far.jolted),
        select(harder, pushed, so_far.pushed),
        select(within, so_far.clipped, so_far.ticks + 1.0),
        select(new, at.attitude, so_far.attitude),
        select(new, seen.arm_length, so_far.lengths),
    )


@kernel
def looked_enough(
    look: Characterisation, so_far: CollisionObservation, arms: tuple[float, ...], elapsed: float
) -> bool:
    """Whether the window is over.

    Where the accelerometer clipped and one rigid arm was hit it lasts until motion capture has seen
    the end of the clipping, and so what was lost.  Two arms tell the normal without it; arms that
    give way lose less; and a robot that leans on the wall had better not wait.

    Args:
        look: Settings.
        so_far: What was seen.
        arms: That took part, as far as is known, 1 or 0 each.
        elapsed: Since the alarm [s].
    """
    alone = (so_far.clipped > 0.5) & (maximum(so_far.pressed) <= FELT) & (tree_sum(arms) < 1.5)
    since = elapsed * (1.0 - so_far.clipped / select(so_far.ticks > 0.5, so_far.ticks, 1.0))
    return (elapsed >= look.window) & ((not alone) | (since >= look.longer))


@kernel
def _pointing(arm: Arm, compression: float) -> Vec:
    return arm_direction(arm) * compression


@kernel
def _in_front(compression: float, sine: float) -> float:
    """Arms behind are pressed in by their own inertia, too."""
    return select(sine < MISSED, compression, 0.0)


@kernel
def _took_part(compression: float, most: float, share: float) -> float:
    return 1.0 if (compression > FELT) & (compression >= share * most) else 0.0


@kernel
def felt_arms(look: Characterisation, pressed: tuple[float, ...], met: Pass) -> tuple[float, ...]:
    """Arms in front that were pressed in, 1 or 0 each.

    Args:
        look: Settings.
        pressed: Largest compression of each arm [m].
        met: How the line of action passes the cages.
    """
    front = tree_map(_in_front, (pressed, met.sines), ())
    return tree_map(_took_part, (front,), (maximum(front), look.share))


@kernel
def _tip(arm: Arm, length: float, took_part: float) -> Vec:
    return arm_direction(arm) * (length * took_part)


@kernel
def touching_arms(
    look: Characterisation, pressed: tuple[float, ...], met: Pass
) -> tuple[float, ...]:
    """Which arms took part: those pressed in, or where none gives way, those the line meets.

    Args:
        look: Settings.
        pressed: Largest compression of each arm [m].
        met: How the line of action passes the cages.
    """
    felt = felt_arms(look, pressed, met)
    rigid = select(abs(met.sine) < ONE_ARM, met.one, met.two)
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
    """Where robot and obstacle touch: the cages' points along f_c⁰, their mean for several [m].

    p + R l_j e_j + r_0 (n − (n·b) b)/‖n − (n·b) b‖ with n = f_c⁰ and b the body's z axis.

    Args:
        airframe: As the pilot believes it to be.
        position: Of the main body [m].
        r: Its attitude.
        lengths: Of the arms [m].
        arms: 1 for each arm that took part.
        direction: f_c⁰, world.
    """
    count = tree_sum(arms)
    share = 1.0 / select(count > 0.5, count, 1.0)
    tips = tree_sum(tree_map(_tip, (airframe.arms, lengths, arms), ())) * share
    up = Vec(r.x.z, r.y.z, r.z.z)
    rim = direction_of(direction - up * (direction @ up), 0.0) * airframe.arms[0].cage_radius
    return position + r @ tips + rim * select(count > 0.5, 1.0, 0.0)


class Bearing(NamedTuple):
    """What force and moment say of a blow."""

    force: Vec  # direction from the robot against the impulse of the force, world
    normal: Vec  # of the obstacle, world; zero where there is none to be told
    met: Pass


@kernel
def bearing(
    look: Characterisation,
    airframe: Airframe,
    r: Mat3,
    lengths: tuple[float, ...],
    pressed: tuple[float, ...],
    wrench: ExternalWrench,
) -> Bearing:
    """Direction of a blow, and the normal of the face that dealt it.

    Where the line of action meets one cage at an angle that friction allows, the normal is turned
    back by that angle.  Where it passes between two, both were hit, and the normal is that of their
    common tangent.  Where obstacles are not known to be upright it is not asked for.

    Args:
        look: Settings.
        airframe: As the pilot believes it to be.
        r: Attitude.
        lengths: Of the arms [m].
        pressed: Largest compression of each arm [m].
        wrench: What the observer says.
    """
    impulse = wrench.recent.impulse
    inward, c = (-impulse) @ r, wrench.recent.carried
    ahead = direction_of(Vec(inward.x, inward.y, 0.0), 0.0)
    # While it is hit the robot turns: what met which cage is told in its axes of that time.
    carried = direction_of(Vec(-c.x, -c.y, 0.0), 0.0)
    met: Pass = passed(airframe, lengths, carried, lever_of(wrench.recent))
    felt = felt_arms(look, pressed, met)
    both = (abs(met.sine) >= ONE_ARM) | (tree_sum(felt) > 1.5)
    tangent = select(both, across(met.span, ahead), turned_back(ahead, met.sine))
    normal = level_normal(r, tangent) * look.level
    return Bearing(direction_of(-impulse, look.level), normal, met)


@kernel
def characterise(
    look: Characterisation,
    airframe: Airframe,
    seen: Measurement,
    at: Estimate,
    wrench: ExternalWrench,
    found: CollisionObservation,
    position: Vec,
    velocity: Vec,
) -> Collision:
    """A collision, at the end of the window.

    From the arms: f_c⁰ ∥ R Σ (L − l)_j e_j, after Liu and Karydis (ICRA 2021).  From the
    accelerometer: against its largest horizontal reading within its range, as McGill's flight code
    and Air Bumper do.  From the wrench: against the impulse of the external force.  Fused: the
    obstacle's normal from the line of action.  Where the way that is relied on says nothing, the
    wrench is asked, and then the velocity.

    Args:
        look: Settings.
        airframe: As the pilot believes it to be.
        seen: What the sensors say.
        at: What the estimator says.
        wrench: What the observer says.
        found: Of all ticks of the window.
        position: p_c, of the main body at the alarm [m].
        velocity: Before the collision [m/s].
    """
    r = rotation(at.attitude)
    tips = tree_sum(tree_map(_pointing, (airframe.arms, found.pressed), ()))
    by_arms = direction_of(r @ tips, look.level)
    by_acceleration = direction_of(horizontal(-found.jolted), look.level)
    told: Bearing = bearing(look, airframe, r, seen.arm_length, found.pressed, wrench)
    chosen = by_arms * look.arms + by_acceleration * look.acceleration
    chosen = chosen + told.force * look.wrench + told.normal * look.fused
    other = select(told.force @ told.force > 0.5, told.force, direction_of(velocity, look.level))
    direction = select(chosen @ chosen > 0.5, chosen, other)
    arms = touching_arms(look, found.pressed, told.met)
    first = rotation(found.attitude)
    point = contact_point(airframe, position, first, found.lengths, arms, direction)
    return Collision(
        position, velocity, direction, by_arms, by_acceleration, told.force, told.normal, point,
        arms, norm(found.pushed),
    )  # fmt: skip
