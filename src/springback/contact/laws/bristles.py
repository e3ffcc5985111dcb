"""Bristles: friction that holds what lies still, and resistance to rolling.

A contact sticks elastically and slides once it is stretched to the most.  All contacts of one part
of a vehicle, a cage or a hull, share one stretch: a vector of the world, of which each contact
feels the part along its own surface.  On an obstacle that turns it turns along.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.surfaces import Friction, Surface, slip_velocity
from springback.kernels.compiler import kernel
from springback.kernels.trees import fold
from springback.kernels.vectors import Mat3, Vec, larger, norm, positive_part, smaller
from springback.vehicle.state import Bristles

#: Share of the largest stretch up to which bristles are elastic (chosen, as Dupont et al. did).
ELASTIC_SHARE = 0.7
#: Angle at which rolling resistance is overcome [rad], and rate at which, without any angle, it is
#: as large [rad/s] (chosen: a sphere of 2 kg comes to rest in a second).
ROLLING_ANGLE, ROLLING_RATE = 0.01, 0.05


class BristleLoad(NamedTuple):
    """Bristles of one contact, or of its resistance to rolling."""

    load: Vec  # force or moment per its largest
    rate: Vec  # of the stretch [m/s] or [rad/s]
    damper: float  # share of the largest force or moment per speed [s/m] or [s/rad]


@kernel
def bristle_load(stretch: Vec, velocity: Vec, most: float, slip_speed: float) -> BristleLoad:
    """Bristles that hold elastically, and slide where they are stretched to the most.

    The elastoplastic model of Dupont, Hayward, Armstrong & Altpeter (IEEE Transactions on Automatic
    Control 47, 2002): with u = z/z_s + v/v_s, the load is −u/max(1, |u|), and ż = v − α |v| z/z_s,
    where α is 0 up to |u| = 0.7, so that what is held does not creep, and 1 from |u| = 1.  Faster
    than 2 v_s, where all slides, ż is as at that speed: z turns no faster than steps can follow.

    Args:
        stretch: z [m] or [rad].
        velocity: v [m/s] or [rad/s].
        most: z_s, the largest stretch, likewise.
        slip_speed: v_s: a speed that damps as much as the largest stretch holds, likewise.
    """
    per_most, per_speed = 1.0 / most, 1.0 / slip_speed
    u = stretch * per_most + velocity * per_speed
    size = norm(u)
    share = 1.0 / larger(size, 1.0)
    slides = smaller(positive_part(size - ELASTIC_SHARE) * (1.0 / (1.0 - ELASTIC_SHARE)), 1.0)
    speed = norm(velocity)
    rate = velocity - stretch * (slides * speed * per_most)
    rate = rate * (2.0 * slip_speed / larger(speed, 2.0 * slip_speed))
    return BristleLoad(u * -share, rate, share * per_speed)


class BristleRate(NamedTuple):
    """Bristles of one contact, or the sum over contacts; rates are times the normal force."""

    slip: Vec  # f_n ż [N m/s]
    roll: Vec  # f_n ζ̇ [N rad/s]
    weight: float  # f_n [N]
    turning: float  # rolling resistance as a damper [N m s]
    recovery: float  # rate at which bristles come to rest [1/s]


@kernel
def bristle_friction(surface: Surface, normal_force: float, slip: Vec, held: Vec) -> Friction:
    """Friction by bristles, −μ f_n times their load, in place of `friction_force`.

    What the bristles store is counted as lost, until they give it back.  Their spring limits steps
    as a damper half as large more does, with half their rate of recovery v_s/z_s; their sliding
    does with twice that rate.

    Args:
        surface: With bristles.
        normal_force: f_n [N].
        slip: As for `friction_force`.
        held: z, of the part, along the surface [m].
    """
    most = surface.friction * normal_force
    bent = bristle_load(held, slip, surface.presliding, surface.slip_speed)
    force = bent.load * most
    per_speed = 1.0 / math.sqrt(slip @ slip + surface.slip_speed * surface.slip_speed)
    return Friction(
        force, -(force @ slip), 1.5 * most * bent.damper, per_speed if most > 0.0 else 0.0
    )


class Rubbing(NamedTuple):
    """Motion of a contact along what it touches; vectors in body axes."""

    surface: Surface
    normal_force: float  # f_n [N]
    inward: Vec  # unit normal into the obstacle
    slip: Vec  # along the surface [m/s]
    omega: Vec  # of the vehicle, relative to the obstacle [rad/s]
    r: Mat3  # body axes to world axes
    vertical: Vec  # Rᵀ e_Z


@kernel
def friction_by_bristles(regularised: Friction, bristles: Bristles, at: Rubbing) -> Friction:
    """Friction of a contact, by bristles if its surface has any; else as it was."""
    surface = at.surface
    if surface.presliding > 0.0:
        held = slip_velocity(surface, bristles.slip @ at.r, at.inward, at.vertical)
        return bristle_friction(surface, at.normal_force, at.slip, held)
    return regularised


class RollingResistance(NamedTuple):
    """Moment of a contact and its heat, with that against turning in any direction."""

    moment: Vec  # body axes [N m]
    loss: float  # of friction [W]


@kernel
def rolling_resistance(
    so_far: RollingResistance, bristles: Bristles, at: Rubbing
) -> RollingResistance:
    """Moment and heat of a contact with its resistance to rolling and spinning."""
    most = at.surface.rolling * at.normal_force
    bent = bristle_load(bristles.roll @ at.r, at.omega, ROLLING_ANGLE, ROLLING_RATE)
    moment = bent.load * most
    return RollingResistance(so_far.moment + moment, so_far.loss - moment @ at.omega)


@kernel
def _carried_round(rate: Vec, moving: Any, held: Vec) -> Vec:
    turned: Vec = moving.spin ^ held
    return rate + turned


@kernel
def bristle_rate(bristles: Bristles, at: Rubbing, moving: tuple[Any, ...]) -> BristleRate:
    """Rate of a part's bristles by one of its contacts; without bristles it has no weight.

    Args:
        bristles: Of the part.
        at: The contact.
        moving: `springback.contact.cage.FaceMotion` of the obstacle, if obstacles move.
    """
    none, surface = Vec(0.0, 0.0, 0.0), at.surface
    if surface.presliding == 0.0 or at.normal_force == 0.0:
        return BristleRate(none, none, 0.0, 0.0, 0.0)
    weight, slip, roll = at.normal_force, bristles.slip @ at.r, bristles.roll @ at.r
    held = slip_velocity(surface, slip, at.inward, at.vertical)
    slipped = bristle_load(held, at.slip, surface.presliding, surface.slip_speed)
    rolled = bristle_load(roll, at.omega, ROLLING_ANGLE, ROLLING_RATE)
    slip_rate = fold(_carried_round, slipped.rate, moving, (slip,))
    roll_rate = fold(_carried_round, rolled.rate, moving, (roll,))
    return BristleRate(
        weight * slip_rate, weight * roll_rate, weight, surface.rolling * weight * rolled.damper,
        surface.slip_speed / surface.presliding,
    )  # fmt: skip
