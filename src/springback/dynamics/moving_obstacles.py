"""Obstacles that move: their equations of motion, under contact with the vehicle and the world.

Contact pushes an obstacle with the opposite of the force on the vehicle, at the same point.  Free
bodies obey the Newton–Euler equations, bodies on a pivot or a hinge those about it.  A free body
touches what is at rest in the world with a few spheres: its corners and rims, rounded like its
edges.  Moving obstacles do not touch each other.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import LANDED, BodyMotion, FaceMotion, contact_faces, lowest_gap
from springback.contact.loads import CageContact, face_contact
from springback.contact.moving.bodies import (
    ABSENT,
    CARRIED,
    FREE,
    GIVEN,
    HINGED,
    NO_BODY,
    PIVOTED,
    BodyAccelerations,
    BodyPose,
    HingeTorque,
    MovingBody,
    body_pose,
    fastest_of_body,
    hinge_angle,
    hinge_torque,
)
from springback.contact.moving.scene import MovingScene
from springback.contact.scene.faces import FACES, SceneInBodyFrame, SolidScene
from springback.contact.surfaces import elastic_energy
from springback.dynamics.crossing import NO_CROSSING, Crossing, crossing, sooner
from springback.dynamics.obstacle_views import NO_VIEW, BodyView
from springback.dynamics.stops import AHEAD
from springback.dynamics.touches import PartPush, Reaction, is_in_contact
from springback.kernels.compiler import generic, kernel
from springback.kernels.routines import Routine, call_routine, number_at
from springback.kernels.trees import replace, tree_map
from springback.kernels.vectors import Mat3, Quat, Vec, larger, norm, positive_part, quaternion_rate
from springback.vehicle.state import ArmPose, BodyState, PartMemory, Sphere

#: Flags of all contacts of a body with the world, as bits of a number.
ALL_FLAGS = 2.0**52 - 1.0
_NONE = Vec(0.0, 0.0, 0.0)


class BodyWork(NamedTuple):
    """Energies exchanged by one moving obstacle since the start."""

    driven: float  # put in by what moves it as prescribed [J]
    joint: float  # taken by closer and pivot [J]
    contact: float  # taken by damping at its contacts with the world [J]
    friction: float  # taken by friction there [J]


class BodyRates(NamedTuple):
    """Rates of one moving obstacle, and its view."""

    state: BodyState
    work: BodyWork
    seen: BodyView


class BodyTouch(NamedTuple):
    """Contacts of a body with the world, all together; vectors in its own axes."""

    force: Vec  # [N]
    moment: Vec  # about its centre of mass [N m]
    contact_loss: float  # [W]
    friction_loss: float  # [W]
    stiffness: float  # [N/m]
    damper: float  # [N s/m]
    grip: float  # [N s/m]
    per_speed: float  # [s/m]
    elastic: float  # energy stored [J]
    gap: float  # [m]
    crossing: Crossing
    engaged: float  # flags, as bits


@kernel
def _no_touch(gap: float) -> BodyTouch:
    none, never = Vec(0.0, 0.0, 0.0), Crossing(NO_CROSSING, 1.0)
    return BodyTouch(none, none, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, gap, never, 0.0)


@kernel
def _flag(flags: float, k: int) -> float:
    return 1.0 if (int(flags) >> k) & 1 == 1 else 0.0


@kernel
def _with_contact(so_far: BodyTouch, met: CageContact, k: int) -> BodyTouch:
    """Contacts of a body with one more, whose flag is bit ``k``."""
    touch, s = met.touch, so_far
    bit = 1.0 if is_in_contact(met) > 0.0 else 0.0
    return BodyTouch(
        s.force + touch.force, s.moment + touch.moment, s.contact_loss + touch.contact_loss,
        s.friction_loss + touch.friction_loss, s.stiffness + touch.press.stiffness,
        s.damper + touch.press.damper, s.grip + touch.grip.alone, s.per_speed + met.per_speed,
        s.elastic + elastic_energy(met.surface, positive_part(-met.gap)),
        met.gap if met.gap < s.gap else s.gap, sooner(s.crossing, crossing(met.gap, met.rate)),
        s.engaged + bit * float(1 << k),
    )  # fmt: skip


@kernel
def body_touch(body: MovingBody, pose: BodyPose, still: SolidScene, flags: float) -> BodyTouch:
    """Contacts of a free body with what is at rest in the world.

    Args:
        body: The obstacle.
        pose: Its place and motion.
        still: The world.
        flags: Bits of the contacts that are engaged; see `springback.contact.loads.face_contact`.
    """
    none, r, forgets = Vec(0.0, 0.0, 0.0), pose.r, PartMemory((), (), (), ())
    touch = _no_touch(1e9)
    if (body.points == 0.0) | (body.kind != FREE):
        return touch
    world = SceneInBodyFrame(still.table, still.query, (), pose.position, r, still.exact, 0.0, 0.0)
    around = lowest_gap(world, Sphere(none, body.reach), body.reach, ArmPose(none, none, none))
    if around > LANDED:
        return replace(touch, gap=around)
    velocity, spin = pose.velocity @ r, pose.spin @ r
    ahead = AHEAD * fastest_of_body(body, pose)
    motion = BodyMotion(pose.position, r, velocity, spin, Vec(r.z.x, r.z.y, r.z.z), ahead)
    for i in range(int(number_at(body.points, 0))):
        k = 1 + 4 * i
        centre = Vec(
            number_at(body.points, k), number_at(body.points, k + 1), number_at(body.points, k + 2)
        )
        radius = number_at(body.points, k + 3)
        part = ArmPose(none, centre, velocity)
        first, second, third = contact_faces(world, Sphere(centre, radius), radius, part, 1.0)
        at = FACES * i
        met = face_contact(first, _flag(flags, at), forgets, part, motion)
        touch = _with_contact(touch, met, at)
        met = face_contact(second, _flag(flags, at + 1), forgets, part, motion)
        touch = _with_contact(touch, met, at + 1)
        met = face_contact(third, _flag(flags, at + 2), forgets, part, motion)
        touch = _with_contact(touch, met, at + 2)
    return touch


class VehiclePlace(NamedTuple):
    """Where a vehicle is, to carry its reactions over."""

    position: Vec  # world [m]
    r: Mat3  # body axes to world axes


class BodyLoad(NamedTuple):
    """Force and moment on a moving obstacle, world axes."""

    force: Vec  # [N]
    moment: Vec  # about its origin [N m]


@kernel
def _load_of(reaction: Reaction, at: VehiclePlace, pose: BodyPose, touch: BodyTouch) -> BodyLoad:
    force, moment = -(at.r @ reaction.force), -(at.r @ reaction.moment)
    moment = moment + ((at.position - pose.position) ^ force)
    return BodyLoad(force + pose.r @ touch.force, moment + pose.r @ touch.moment)


@kernel
def _at_rest() -> BodyState:
    none = Vec(0.0, 0.0, 0.0)
    return BodyState(none, Quat(0.0, 0.0, 0.0, 0.0), none, none)


@kernel
def _joint(body: MovingBody, state: BodyState, pose: BodyPose) -> HingeTorque:
    """Torque of closer, stops and pivot; about the hinge, or against the spin."""
    if body.kind == HINGED:
        return hinge_torque(body, hinge_angle(body, state.attitude), pose.spin @ body.axis)
    if body.kind == PIVOTED:
        spin = pose.spin @ pose.r
        return HingeTorque(0.0, body.damping * (spin @ (body.inertia @ spin)), 0.0)
    return HingeTorque(0.0, 0.0, 0.0)


@kernel
def _next_stop(body: MovingBody, state: BodyState, pose: BodyPose) -> Crossing:
    """Crossing at which a hinge meets or leaves one of its stops."""
    if body.kind != HINGED:
        return Crossing(NO_CROSSING, 1.0)
    angle, turning = hinge_angle(body, state.attitude), pose.spin @ body.axis
    forwards = crossing(angle - body.highest, turning)
    return sooner(forwards, crossing(angle - body.lowest, turning))


@kernel
def _accelerations(
    body: MovingBody, pose: BodyPose, load: BodyLoad, joint: float, gravity: float
) -> BodyAccelerations:
    weight, spin = Vec(0.0, 0.0, -gravity * body.mass), pose.spin @ pose.r
    gyroscopic = spin ^ (body.inertia @ spin)
    if body.kind == FREE:
        linear = (load.force + weight) * (1.0 / body.mass)
        return BodyAccelerations(linear, body.inverse @ (load.moment @ pose.r - gyroscopic))
    none = Vec(0.0, 0.0, 0.0)
    if (body.kind == PIVOTED) | (body.kind == HINGED):
        lever = pose.position - body.pivot
        moment = load.moment + (lever ^ (load.force + weight))
        if body.kind == HINGED:
            about = body.axis @ (body.inertia @ body.axis)
            angular = body.axis * ((moment @ body.axis + joint) / about)
        else:
            angular = body.inverse @ (moment @ pose.r - gyroscopic) - body.damping * spin
        turning = pose.r @ angular
        linear = (turning ^ lever) + (pose.spin ^ (pose.spin ^ lever))
        return BodyAccelerations(linear, angular)
    return BodyAccelerations(none, none)


@kernel
def _state_rate(body: MovingBody, state: BodyState, a: BodyAccelerations) -> BodyState:
    none = Vec(0.0, 0.0, 0.0)
    if body.kind == GIVEN:
        return replace(_at_rest(), position=Vec(1.0, 0.0, 0.0))  # its time
    if (body.kind == PIVOTED) | (body.kind == HINGED):
        turning = quaternion_rate(state.attitude, state.angular_velocity)
        return BodyState(none, turning, none, a.angular)
    if body.kind == FREE:
        turning = quaternion_rate(state.attitude, state.angular_velocity)
        return BodyState(state.velocity, turning, a.linear, a.angular)
    return _at_rest()


class BodySituation(NamedTuple):
    """A moving obstacle at an instant, and what acts on it."""

    body: MovingBody
    state: BodyState
    motion: FaceMotion  # viewed from the vehicle
    reaction: Reaction  # of the vehicle's contacts with it
    flags: float  # as for `body_touch`
    table: float  # of what is at rest in the world
    query: float  # its search
    at: VehiclePlace
    gravity: float  # g [m/s²]


@kernel
def body_rates(s: BodySituation) -> BodyRates:
    """Rates of one moving obstacle."""
    body, state, motion, reaction = s.body, s.state, s.motion, s.reaction
    still, at, flags, gravity = SolidScene(s.table, s.query, (), 0.0), s.at, s.flags, s.gravity
    pose = body_pose(body, state)
    touch = body_touch(body, pose, still, flags)
    load, joint = _load_of(reaction, at, pose, touch), _joint(body, state, pose)
    a = _accelerations(body, pose, load, joint.torque, gravity)
    given = reaction.force @ motion.velocity + reaction.moment @ motion.spin
    work = BodyWork(
        given if (body.kind == GIVEN) | (body.kind == CARRIED) else 0.0,
        joint.loss,
        touch.contact_loss,
        touch.friction_loss,
    )
    give = body.mobility
    spring = (reaction.stiffness + touch.stiffness) * give
    damper = (reaction.damper + touch.damper) * give
    hinge = (body.closer + body.stop) * _per_inertia(body)
    contact_rate = math.sqrt(spring + hinge) + damper + _decay_rate(body)
    shaken = norm(a.linear) + body.reach * norm(a.angular)
    if body.kind == CARRIED:  # along the face: what its own vehicle found
        shaken = _shaken_along(body, at.r @ (reaction.force - reaction.friction))
    meets = sooner(touch.crossing, _next_stop(body, state, pose))
    seen = BodyView(
        touch.gap, meets, touch.engaged, fastest_of_body(body, pose), contact_rate,
        (reaction.grip + touch.grip) * give, shaken * (reaction.per_speed + touch.per_speed),
        1.0 if reaction.touches > 0.0 else 0.0, pose,
        PartPush(
            load.force, load.moment, reaction.normal, reaction.touches, -(at.r @ reaction.friction),
            -(at.r @ reaction.inward), reaction.depth / larger(reaction.touches, 1.0),
        ),
    )  # fmt: skip
    return BodyRates(_state_rate(body, state, a), work, seen)


@kernel
def _shaken_along(body: MovingBody, normal: Vec) -> float:
    """Largest acceleration along a face of a part of another vehicle [m/s²].

    Args:
        body: The part.
        normal: Force along the normal of the face, world [N].
    """
    a, pressed = body.accelerations.linear, normal @ normal
    along = a - normal * ((a @ normal) / pressed) if pressed > 0.0 else a
    return norm(along) + body.reach * norm(body.accelerations.angular)


def _blank_situation() -> BodySituation:
    none = Mat3(_NONE, _NONE, _NONE)
    rest = FaceMotion(_NONE, _NONE, 0.0)
    reaction = Reaction(_NONE, _NONE, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, _NONE, _NONE, 0.0)
    place = VehiclePlace(_NONE, none)
    start = _at_rest()
    return BodySituation(NO_BODY, start, rest, reaction, 0.0, 0.0, 0.0, place, 0.0)


#: `body_rates`, compiled once for all vehicles and worlds.
BODY_RATES = Routine(body_rates, _blank_situation())


def flown_scene(scene: MovingScene) -> MovingScene:
    """A world in which obstacles move, ready to be flown in."""
    return scene._replace(rates=BODY_RATES.address)


@kernel
def _no_rates() -> BodyRates:
    return BodyRates(_at_rest(), BodyWork(0.0, 0.0, 0.0, 0.0), NO_VIEW)


@kernel
def _rates_by_routine(
    body: MovingBody,
    state: BodyState,
    motion: FaceMotion,
    reaction: Reaction,
    flags: float,
    obstacles: MovingScene,
    at: VehiclePlace,
    gravity: float,
) -> BodyRates:
    if body.kind == ABSENT:
        return _no_rates()
    still = obstacles.still
    asked = BodySituation(
        body, state, motion, reaction, flags, still.table, still.query, at, gravity
    )
    return call_routine(obstacles.rates, asked, _no_rates())


@kernel
def _per_inertia(body: MovingBody) -> float:
    """Reciprocal of the inertia about a hinge [1/(kg m²)]."""
    if body.kind == HINGED:
        return 1.0 / (body.axis @ (body.inertia @ body.axis))
    return 0.0


@kernel
def _decay_rate(body: MovingBody) -> float:
    """Rate at which damping takes the spin on a hinge or a pivot [1/s]."""
    return body.damping if body.kind == PIVOTED else body.damping * _per_inertia(body)


@kernel
def all_flags(body: Any) -> float:
    """Flags of a moving obstacle with all contacts engaged."""
    return ALL_FLAGS


@generic
def bodies_rates(
    obstacles: Any,
    states: tuple[BodyState, ...],
    motions: tuple[FaceMotion, ...],
    reactions: tuple[Reaction, ...],
    flags: tuple[float, ...],
    at: VehiclePlace,
    gravity: float,
) -> tuple[BodyRates, ...]:
    """Rates of all moving obstacles of a world; mostly there are none.

    Args:
        obstacles: Of the world, in world axes.
        states: Of the moving ones.
        motions: Viewed from the vehicle.
        reactions: Of the vehicle's contacts.
        flags: As for `body_touch`, for each.
        at: Place of the vehicle.
        gravity: g [m/s²].
    """
    return ()


@bodies_rates.register(MovingScene)
@kernel
def _rates_in_scene(
    obstacles: MovingScene,
    states: tuple[BodyState, ...],
    motions: tuple[FaceMotion, ...],
    reactions: tuple[Reaction, ...],
    flags: tuple[float, ...],
    at: VehiclePlace,
    gravity: float,
) -> tuple[BodyRates, ...]:
    each = (obstacles.bodies, states, motions, reactions, flags)
    return tree_map(_rates_by_routine, each, (obstacles, at, gravity))


class BodyEnergy(NamedTuple):
    """Energy of a moving obstacle by its parts [J]."""

    kinetic: float
    gravity: float  # above Z = 0
    springs: float  # of closer and stops
    contact: float  # elastic part of its contacts with the world


@kernel
def _body_energy(
    body: MovingBody, state: BodyState, still: SolidScene, gravity: float
) -> BodyEnergy:
    pose = body_pose(body, state)
    if (body.kind == PIVOTED) | (body.kind == HINGED) | (body.kind == FREE):
        spin = pose.spin @ pose.r
        kinetic = 0.5 * (spin @ (body.inertia @ spin))
        if body.kind == FREE:
            kinetic += 0.5 * body.mass * (pose.velocity @ pose.velocity)
        stored = _joint(body, state, pose).energy
        touch = body_touch(body, pose, still, ALL_FLAGS)
        height = body.mass * gravity * pose.position.z
        return BodyEnergy(kinetic, height, stored, touch.elastic)
    return BodyEnergy(0.0, 0.0, 0.0, 0.0)


@generic
def bodies_energy(
    obstacles: Any, states: tuple[BodyState, ...], gravity: float
) -> tuple[BodyEnergy, ...]:
    """Energies of all moving obstacles of a world, in world axes; mostly there are none."""
    return ()


@bodies_energy.register(MovingScene)
@kernel
def _energy_in_scene(
    obstacles: MovingScene, states: tuple[BodyState, ...], gravity: float
) -> tuple[BodyEnergy, ...]:
    return tree_map(_body_energy, (obstacles.bodies, states), (obstacles.still, gravity))
