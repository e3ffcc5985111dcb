"""Impulse–momentum law of the planning literature: a jump of velocity without force.

The vehicle is taken as one rigid body.  Normal impulses of all cages that touch at that instant
grow together, in small increments, with a Coulomb impulse against the slip of each (Routh).  A cage
is done when the work returned by its normal impulse is e² times that of compression (Stronge).  For
central or frictionless impacts that is Newton's v⁺ = −e v⁻; where friction and lever arms couple,
Newton's law can add energy and this one cannot.

A cage that approaches more slowly than `RESTING` does not rebound.  Without this threshold a
bouncing vehicle would come to rest through infinitely many impacts in a finite time.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
)
from springback.contact.hull_contact import (
    BodySight,
    arm_faces,
    arm_sight,
    body_sight,
    hull_contact,
    hull_faces,
)
from springback.contact.laws.memory import hull_memory
from springback.contact.loads import CageContact, face_contact
from springback.contact.obstacles import World
from springback.contact.surfaces import Surface, slip_velocity
from springback.dynamics.energy import about_mass_centre, energy_without_contact, mass_moments
from springback.dynamics.limbs.shell_impulse import (
    ShellImpulse,
    jumps_of_spin,
    memory_with_spins,
    shells_hit,
    spin_moment,
    spun,
    velocity_at,
)
from springback.dynamics.motion import LANDED, RESTING, Free, Motion, Slider, Work
from springback.kernels.compiler import generic, list_kernel, rare_kernel
from springback.kernels.trees import fold, one_tuple, tree_map
from springback.kernels.vectors import Mat3, Vec, positive_part, solve_symmetric
from springback.vehicle.state import (
    Airframe,
    PartMemory,
    State,
    arms_inertia,
    coordinates_of_arms,
    rates_of_arms,
)

#: Speeds below this are rounding [m/s].
STILL = 1e-12
#: A cage that others push in faster than this receives an impulse as well [m/s] ...
STRUCK_AGAIN = 1e-9
#: ... and where cages rest, which the next step handles, if faster than this.
RESTING_STRUCK_AGAIN = 1e-6
#: Increments into which the impulse of compression is divided ...
PARTS = 200
#: ... where a cage rests, which takes an impulse per step.
RESTING_PARTS = 10
#: Maximum number of increments, in case cages strike repeatedly.
MOST_PARTS = 100 * PARTS


class ImpulseContact(NamedTuple):
    """One cage, or the hull, at one face at the instant of an impulse."""

    near: float  # 1 if it touches and its surface follows the impulse law
    closing: float  # 1 if it also approaches
    normal: Vec  # out of the obstacle, world
    lever: Vec  # from the main body to the contact point, world [m]
    gap: float  # [m]
    surface: Surface
    on_hull: float  # 1 for the hull, 0 for a cage


@rare_kernel
def _hit_by_arm(face: ContactFace, arm: Any, body: BodyMotion) -> ImpulseContact:
    return _hit(face_contact(face, 1.0, PartMemory((), (), (), ()), arm, body), body.r, 0.0)


@rare_kernel
def _hit_by_hull(face: ContactFace, hull: Any, body: BodyMotion) -> ImpulseContact:
    return _hit(hull_contact(face, 1.0, PartMemory((), (), (), ()), hull, body), body.r, 1.0)


@rare_kernel
def _hit(met: CageContact, r: Mat3, on_hull: float) -> ImpulseContact:
    near = (met.gap <= LANDED) & (met.impulsive > 0.0)
    closing = near & (met.rate < 0.0)
    lever = r @ met.pressing_at
    return ImpulseContact(
        1.0 if near else 0.0,
        1.0 if closing else 0.0,
        -(r @ met.inward),
        lever,
        met.gap,
        met.surface,
        on_hull,
    )


@rare_kernel
def _hits_of_arm(
    arm: Any, length: float, rate: float, contact_point: Any, around: BodySight
) -> tuple[ImpulseContact, ...]:
    pose, obstacles, body = arm_sight(arm, length, rate, around)
    faces = arm_faces(arm, obstacles, contact_point, pose, 1.0)
    return tree_map(_hit_by_arm, (faces,), (pose, body))


@rare_kernel
def _hits_of_hull(hull: Any, obstacles: Any, body: BodyMotion) -> tuple[ImpulseContact, ...]:
    return tree_map(_hit_by_hull, (hull_faces(hull, obstacles, 1.0),), (hull, body))


class ImpulseEffect(NamedTuple):
    """Jump of the motion of a rigid body."""

    linear: Vec  # of the velocity of the centre of mass, world [m/s]
    angular: Vec  # world [rad/s]


@generic
def jump_of_motion(
    guide: Any, mass: float, inertia: Mat3, r: Mat3, moment: Vec, impulse: Vec
) -> ImpulseEffect:
    """Effect of an impulse [N s] and its moment about the centre of mass [N m s], world axes."""
    raise TypeError(f"{type(guide).__name__} is not a guide")


@jump_of_motion.register(Free)
@rare_kernel
def _free_jump(
    guide: Free, mass: float, inertia: Mat3, r: Mat3, moment: Vec, impulse: Vec
) -> ImpulseEffect:
    turn = r @ solve_symmetric(inertia, moment @ r)
    return ImpulseEffect(impulse * (1.0 / mass), turn)


@jump_of_motion.register(Slider)
@rare_kernel
def _slider_jump(
    guide: Slider, mass: float, inertia: Mat3, r: Mat3, moment: Vec, impulse: Vec
) -> ImpulseEffect:
    """Along the slider alone: the rail takes the rest, and all moments."""
    along = guide.axis @ impulse
    return ImpulseEffect(guide.axis * (along / mass), Vec(0.0, 0.0, 0.0))


@generic
def mobility(guide: Any, mass: float, inertia: Mat3, r: Mat3, lever: Vec, along: Vec) -> float:
    """Velocity of a point along a direction per unit impulse there along it [1/kg]."""
    raise TypeError(f"{type(guide).__name__} is not a guide")


@mobility.register(Free)
@rare_kernel
def _free_mobility(
    guide: Free, mass: float, inertia: Mat3, r: Mat3, lever: Vec, along: Vec
) -> float:
    turn = r @ solve_symmetric(inertia, (lever ^ along) @ r)
    return 1.0 / mass + along @ (turn ^ lever)


@mobility.register(Slider)
@rare_kernel
def _slider_mobility(
    guide: Slider, mass: float, inertia: Mat3, r: Mat3, lever: Vec, along: Vec
) -> float:
    share = guide.axis @ along
    return share * share / mass


@rare_kernel
def _yields(
    guide: Any, mass: float, inertia: Mat3, r: Mat3, lever: Vec, along: Vec, on_hull: float,
    shells: tuple[ShellImpulse, ...],
) -> float:  # fmt: skip
    """As `mobility`, of a point that may be on a shell."""
    as_body = mobility(guide, mass, inertia, r, lever, along)
    return fold(_yields_on_shell, as_body, shells, (guide, mass, inertia, r, lever, along, on_hull))


@rare_kernel
def _yields_on_shell(
    as_body: float, shell: ShellImpulse, guide: Any, mass: float, inertia: Mat3, r: Mat3,
    lever: Vec, along: Vec, on_hull: float,
) -> float:  # fmt: skip
    turned = spin_moment(lever, along, on_hull, (shell,))
    jump = jump_of_motion(guide, mass, inertia, r, (lever ^ along) - turned, along)
    spins = jumps_of_spin((shell,), turned)
    return along @ velocity_at(jump.linear, jump.angular, lever, on_hull, spins)


@rare_kernel
def _part(closing: float) -> float:
    """Increment of a closing speed [m/s]."""
    return closing / (PARTS if closing > RESTING else RESTING_PARTS)


@list_kernel
def apply_impulses(
    airframe: Airframe, world: World, contact_point: Any, guide: Any, motion: Motion
) -> Motion:
    """Motion just after the impulses of all parts that touch and approach.

    The tangential impulse opposes the slip and is at most μ times the normal one.  A cage that has
    penetrated is moved back to the face.  The lost energy is booked: the work of tangential
    impulses as friction, the rest as contact loss.
    """
    state, work = motion.state, motion.work
    around, m = body_sight(world.obstacles, state, 0.0), airframe.mass
    body, r = around.body, around.body.r
    arms = mass_moments(airframe, state)
    centre, drift = r @ (arms.first * (1.0 / m)), r @ (arms.drift * (1.0 / m))
    inertia = airframe.inertia + arms_inertia(arms.second)
    inertia = about_mass_centre(inertia, m, arms.first * (1.0 / m))
    up, arm_rates = Vec(0.0, 0.0, 1.0), rates_of_arms(airframe.arms[0], state)
    of_cages = tree_map(
        _hits_of_arm,
        (airframe.arms, coordinates_of_arms(airframe.arms[0], state), arm_rates),
        (contact_point, around),
    )
    hits = one_tuple(of_cages + tree_map(_hits_of_hull, (airframe.hull,), (around.obstacles, body)))
    count = len(hits)
    w = r @ state.angular_velocity
    v = state.velocity + (w ^ centre) + drift
    memories = hull_memory(state.memory, airframe.hull)
    shells = one_tuple(tree_map(shells_hit, (airframe.hull, memories), (r, centre)))

    part, rebound, open_ = [0.0] * count, [0.0] * count, [False] * count
    active, sunk, tolerated = 0, Vec(0.0, 0.0, 0.0), RESTING_STRUCK_AGAIN
    taken, given_back, rubbed_off, given = [0.0] * count, [0.0] * count, 0.0, Vec(0.0, 0.0, 0.0)
    for k in range(count):
        hit = hits[k]
        if hit.near > 0.0:
            n, rho = hit.normal, hit.lever - centre
            closing = -(velocity_at(v, w, rho, hit.on_hull, shells) @ n)
            if (hit.closing > 0.0) & (closing > STILL):
                part[k] = _part(closing) / mobility(guide, m, inertia, r, rho, n)
                rebound[k] = hit.surface.restitution if closing > RESTING else 0.0
                tolerated = STRUCK_AGAIN if closing > RESTING else tolerated
                open_[k], active = True, active + 1
            push = n * (positive_part(-hit.gap) - sunk @ n)
            sunk = sunk + push if push @ n > 0.0 else sunk

    for _ in range(MOST_PARTS):
        if active == 0:
            break
        # Effect of one whole increment: all cages push at once, so their order is irrelevant.
        dv, dw, turned = Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0), Vec(0.0, 0.0, 0.0)
        rub = [Vec(0.0, 0.0, 0.0)] * count
        for k in range(count):
            if open_[k]:
                hit = hits[k]
                n, rho = hit.normal, hit.lever - centre
                moves = velocity_at(v, w, rho, hit.on_hull, shells)
                slip = slip_velocity(hit.surface, moves, n, up)
                speed = math.sqrt(slip @ slip)
                if speed > 0.0:
                    t = slip * (1.0 / speed)
                    yields = _yields(guide, m, inertia, r, rho, t, hit.on_hull, shells) * active
                    limit = hit.surface.friction * part[k]
                    rub[k] = t * -(limit if speed > limit * yields else speed / yields)
                impulse = n * part[k] + rub[k]
                own = spin_moment(rho, impulse, hit.on_hull, shells)
                jump = jump_of_motion(guide, m, inertia, r, (rho ^ impulse) - own, impulse)
                dv, dw, turned = dv + jump.linear, dw + jump.angular, turned + own
        spins = jumps_of_spin(shells, turned)
        # The fraction of it up to the next end of a compression or of a restitution.
        share, next_ = 1.0, -1
        for k in range(count):
            if open_[k]:
                hit = hits[k]
                n, rho = hit.normal, hit.lever - centre
                speed = velocity_at(v, w, rho, hit.on_hull, shells) @ n
                gain = velocity_at(dv, dw, rho, hit.on_hull, spins) @ n
                if speed < -STILL and speed + gain > 0.0 and -speed / gain < share:
                    share, next_ = -speed / gain, -1
                if speed >= -STILL:
                    speed = positive_part(speed)
                    e = rebound[k]
                    owed = positive_part(e * e * taken[k] - given_back[k]) / part[k]
                    root = math.sqrt(speed * speed + 2.0 * positive_part(gain) * owed)
                    ends = 2.0 * owed / (speed + root) if speed + root > 0.0 else 0.0
                    if owed == 0.0 or ends < share:
                        share, next_ = (ends if owed > 0.0 else 0.0), k
        new_v, new_w, new_shells = v + dv * share, w + dw * share, spun(shells, spins, share)
        for k in range(count):
            if open_[k]:
                hit = hits[k]
                n, rho = hit.normal, hit.lever - centre
                before_it = velocity_at(v, w, rho, hit.on_hull, shells)
                mean = (before_it + velocity_at(new_v, new_w, rho, hit.on_hull, new_shells)) * 0.5
                done = share * part[k] * (mean @ n)
                taken[k] -= done if done < 0.0 else 0.0
                given_back[k] += done if done > 0.0 else 0.0
                rubbed_off -= share * (rub[k] @ mean)
                given = given + (n * part[k] + rub[k]) * share
        v, w, shells = new_v, new_w, new_shells
        if next_ >= 0:
            open_[next_], active = False, active - 1
        for k in range(count):  # a cage that another one pushes in strikes, or strikes again
            hit = hits[k]
            n, rho = hit.normal, hit.lever - centre
            closing = -(velocity_at(v, w, rho, hit.on_hull, shells) @ n)
            if hit.near > 0.0 and not open_[k] and closing > tolerated:
                if part[k] == 0.0:
                    part[k] = _part(closing) / mobility(guide, m, inertia, r, rho, n)
                rebound[k] = hit.surface.restitution if closing > RESTING else 0.0
                open_[k], active, taken[k], given_back[k] = True, active + 1, 0.0, 0.0

    after = State(
        state.position + sunk,
        state.attitude,
        v - (w ^ centre) - drift,
        w @ r,
        state.arm_length,
        state.arm_rate,
        state.bodies,
        memory_with_spins(state.memory, shells),
        state.bends,
    )
    before = energy_without_contact(airframe, world, state)
    left = energy_without_contact(airframe, world, after)
    lost = before.kinetic + before.gravity - left.kinetic - left.gravity
    booked = Work(
        work.thrust,
        work.arm,
        work.stop,
        work.contact + lost - rubbed_off,
        work.friction + rubbed_off,
        work.settling,
        work.air,
        work.impulse + given,
        work.bodies,
    )
    return Motion(after, booked)
