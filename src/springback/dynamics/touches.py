"""Contact of one part of a vehicle, a cage or the hull, summed over obstacles.

Its effect on arms and main body is in `springback.dynamics.motion`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.cage import LANDED, FaceMotion
from springback.contact.laws.hysteresis import next_corner
from springback.contact.laws.step_bounds import ContactStiffness
from springback.contact.loads import CageContact, ContactLoad
from springback.contact.surfaces import Hysteresis, Surface, slip_velocity
from springback.dynamics.crossing import NO_CROSSING, Crossing, crossing, sooner
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    minimum,
    replace,
    select,
    tree_map,
    tree_sum,
)
from springback.kernels.vectors import Mat3, Vec, larger, positive_part, smaller
from springback.vehicle.state import PressedPoint

#: A cage at a surface of the impulse law rests there while it is slower than this along the normal
#: [m/s]: it then touches without rebound (chosen: a rebound at this speed is 5 µm high).
RESTING = 1e-2
#: Where a part touches another vehicle, whose push on it has no point.
UNKNOWN = Vec(math.nan, math.nan, math.nan)
#: Rate of depth below which a contact with a memory has turned [m/s] (chosen: what is left of the
#: way is less than 1e-12 m).
TURNED = 1e-6


class Reaction(NamedTuple):
    """All contacts of a vehicle with one moving obstacle; vectors in body axes of the vehicle."""

    force: Vec  # on the vehicle [N]
    moment: Vec  # on the vehicle, about the main body [N m]
    stiffness: float  # of the normal forces [N/m]
    damper: float  # of the normal forces [N s/m]
    grip: float  # friction as a damper [N s/m]
    per_speed: float  # of friction, 1/√(v² + v_s²), all together [s/m]
    touches: float  # number of contacts
    normal: float  # sum of the normal forces [N]
    friction: Vec  # on the vehicle [N]
    inward: Vec  # sum of the normals of the contacts, into the obstacle
    depth: float  # sum of their depths [m]


class PartPush(NamedTuple):
    """Push of another vehicle on a part of this one; world axes."""

    force: Vec  # [N]
    moment: Vec  # about the end of the arm, or about the main body for its hull [N m]
    normal: float  # sum of the normal forces [N]
    touches: float  # number of contacts
    friction: Vec  # share of friction in the force [N]
    inward: Vec  # sum of the normals of the contacts, into the other vehicle
    depth: float  # mean of their depths [m]


class Pushes(NamedTuple):
    """Pushes of another vehicle on all parts of this one."""

    arms: tuple[PartPush, ...]
    hull: tuple[PartPush, ...]  # of the main body, if it has a hull
    strikers: tuple[float, ...]  # 1 for each part of the other vehicle that touches something


class Engaged(NamedTuple):
    """Contact flags: for each face, 1 if a part of the vehicle touches it."""

    arms: tuple[tuple[float, ...], ...]  # the cage of each arm
    hull: tuple[tuple[float, ...], ...]  # of the main body
    bodies: tuple[float, ...] = ()  # of moving obstacles, as bits


class Contact(NamedTuple):
    """Effect of contact on the vehicle; vectors in body axes."""

    force: Vec  # [N]
    moment: Vec  # about the main body [N m]
    contact_loss: float  # [W]
    friction_loss: float  # [W]
    on_ground: float  # number of grounds touched
    press: ContactStiffness  # of the normal forces
    reactions: tuple[Reaction, ...]  # of each moving obstacle; mostly none


class Slip(NamedTuple):
    """Point and rate of the slip of a part of the vehicle along an obstacle."""

    inward: Vec  # unit normal into the obstacle, body
    point: Vec  # from the main body, body [m]
    per_speed: float  # 1/√(v² + v_s²); 0 without friction [s/m]
    surface: Surface


@kernel
def _of_face(met: CageContact, motion: FaceMotion, number: float) -> Reaction:
    """Share of one contact in the reaction of a body, if it is with that."""
    ours = 1.0 if motion.body == number else 0.0
    touch, there = met.touch, ours * is_in_contact(met)
    return Reaction(
        ours * touch.force, ours * touch.moment, ours * touch.press.stiffness,
        ours * touch.press.damper, ours * touch.grip.alone, ours * met.per_speed,
        there, ours * touch.normal, ours * touch.friction, there * met.inward,
        there * positive_part(-met.gap),
    )  # fmt: skip


@kernel
def _of_contact(met: CageContact, number: float) -> Reaction:
    none = Vec(0.0, 0.0, 0.0)
    start = Reaction(none, none, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, none, none, 0.0)
    return fold(_summed, start, met.moving, (met, number))


@kernel
def _summed(so_far: Reaction, motion: FaceMotion, met: CageContact, number: float) -> Reaction:
    return tree_sum((so_far, _of_face(met, motion, number)))


@kernel
def reaction_of(motion: FaceMotion, met: tuple[CageContact, ...]) -> Reaction:
    """All contacts of one part of a vehicle with a moving obstacle.

    Args:
        motion: Of the obstacle, which tells its number.
        met: The faces that the part meets.
    """
    return tree_sum(tree_map(_of_contact, (met,), (motion.body,)))


@kernel
def contact_of(
    touch: ContactLoad, motions: tuple[FaceMotion, ...], met: tuple[CageContact, ...]
) -> Contact:
    """Total effect of the contacts of one part on the vehicle.

    Args:
        touch: Sum over the faces that it meets.
        motions: Of the moving obstacles.
        met: The faces.
    """
    return Contact(
        touch.force, touch.moment, touch.contact_loss, touch.friction_loss, touch.on_ground,
        touch.press, tree_map(reaction_of, (motions,), (met,)),
    )  # fmt: skip


@kernel
def _or_deepest(so_far: Crossing, point: PressedPoint, met: CageContact) -> Crossing:
    deeper = crossing(point.depth + met.gap, met.rate)
    return sooner(so_far, deeper) if point.depth > 0.0 else so_far


@kernel
def _or_corner(so_far: Crossing, law: Hysteresis, met: CageContact) -> Crossing:
    corner = next_corner(law, -met.gap, -met.rate)
    return sooner(so_far, crossing(corner + met.gap, met.rate)) if corner > 0.0 else so_far


@kernel
def crossing_of(met: CageContact) -> Crossing:
    """Crossing at which a gap closes or opens, or the force has a corner.

    That is where a contact is as deep as it was before, and at the points of a force curve.
    """
    alone = crossing(met.gap, met.rate)
    as_deep = fold(_or_deepest, alone, met.pressed, (met,))
    return fold(_or_corner, as_deep, met.surface.hysteresis, (met,))


@kernel
def is_in_contact(met: CageContact) -> float:
    """Flag, 1 in contact, from the instant of touching to that of leaving.

    At a surface of the impulse law: while the part approaches, and while it rests.
    """
    leaving = met.impulsive * RESTING  # above this speed it has left
    closing = (met.gap <= LANDED) & (met.rate < leaving)
    pressed = (met.gap < -LANDED) & (met.impulsive == 0.0)
    return 1.0 if closing | pressed else 0.0


@kernel
def strikes(met: CageContact) -> float:
    """Flag, 1 if the part approaches a surface of the impulse law."""
    closing = (met.gap <= LANDED) & (met.rate < 0.0)
    return met.impulsive if closing else 0.0


@kernel
def _normal_of(met: CageContact, nearest: float, touches: float) -> Vec:
    return met.inward * (touches if met.gap == nearest else 0.0)


@kernel
def _inward(met: tuple[CageContact, ...], nearest: float, engaged: tuple[float, ...]) -> Vec:
    """Normal into the nearest obstacle if the part touches anything, else zero.

    Args:
        met: The part against each obstacle.
        nearest: The smallest of their gaps [m].
        engaged: For each obstacle, 1 if it is touched.
    """
    return tree_sum(tree_map(_normal_of, (met,), (nearest, maximum(engaged))))


@kernel
def slip_of(met: CageContact) -> Slip:
    """Slip of a part along an obstacle."""
    return Slip(met.inward, met.rubbing_at, met.per_speed, met.surface)


@generic
def arm_pushes(pushed: Any, arms: tuple[Any, ...]) -> tuple[tuple[PartPush, ...], ...]:
    """For each arm the pushes of another vehicle on it; mostly there is none."""
    return tree_map(_no_push, (arms,), ())


@generic
def hull_pushes(pushed: Any, hull: tuple[Any, ...]) -> tuple[tuple[PartPush, ...], ...]:
    """As `arm_pushes`, for the hull of the main body."""
    return tree_map(_no_push, (hull,), ())


@kernel
def _no_push(part: Any) -> tuple[()]:
    return ()


@kernel
def _one_push(push: PartPush) -> tuple[PartPush]:
    return (push,)


@arm_pushes.register(Pushes)
@kernel
def _given_to_arms(pushed: Pushes, arms: tuple[Any, ...]) -> tuple[tuple[PartPush, ...], ...]:
    return tree_map(_one_push, (pushed.arms,), ())


@hull_pushes.register(Pushes)
@kernel
def _given_to_hull(pushed: Pushes, hull: tuple[Any, ...]) -> tuple[tuple[PartPush, ...], ...]:
    return tree_map(_one_push, (pushed.hull,), ())


@kernel
def with_push(touch: ContactLoad, push: PartPush, lever: Vec, r: Mat3) -> ContactLoad:
    """Load on a part, with the push of another vehicle.

    Args:
        touch: Load of the obstacles.
        push: Of the other vehicle.
        lever: From the main body to the point about which its moment is, body axes [m].
        r: Body axes to world axes.
    """
    force = push.force @ r
    moment = push.moment @ r + (lever ^ force)
    return replace(
        touch, force=touch.force + force, moment=touch.moment + moment,
        normal=touch.normal + push.normal, friction=touch.friction + push.friction @ r,
    )  # fmt: skip


class PartTouch(NamedTuple):
    """What one part of a vehicle touches."""

    engaged: tuple[float, ...]  # 1 for each face in contact; all, while another vehicle touches it
    gap: float  # to what is nearest [m]
    inward: Vec  # normal into what it touches, or zero; body axes
    point: Vec  # where it is nearest, from the main body, body axes [m]


@kernel
def touch_of(met: tuple[CageContact, ...], push: tuple[PartPush, ...], r: Mat3) -> PartTouch:
    """What a part touches.

    Args:
        met: The faces that it meets.
        push: Of another vehicle, if there is one.
        r: Body axes to world axes.
    """
    engaged, gap = tree_map(is_in_contact, (met,), ()), minimum(field_of(met, "gap"))
    point = fold(_nearest_point, Vec(0.0, 0.0, 0.0), met, (gap,))
    alone = PartTouch(engaged, gap, _inward(met, gap, engaged), point)
    return fold(_also_pushed, alone, push, (r,))


@kernel
def _also_pushed(touch: PartTouch, push: PartPush, r: Mat3) -> PartTouch:
    there = 1.0 if push.touches > 0.0 else 0.0
    return PartTouch(
        tree_map(larger, (touch.engaged,), (there,)),
        smaller(touch.gap, -push.depth) if there > 0.0 else touch.gap,
        touch.inward + push.inward @ r,
        UNKNOWN if there > 0.0 else touch.point,
    )


@kernel
def _nearest_point(so_far: Vec, met: CageContact, nearest: float) -> Vec:
    return select(met.gap == nearest, met.pressing_at, so_far)


@kernel
def place_in_body(touch: PartTouch, turn: Mat3) -> PartTouch:
    """What a part touches, from its own axes to those of the main body."""
    return replace(touch, inward=turn @ touch.inward, point=turn @ touch.point)


@kernel
def or_point(so_far: Vec, touch: PartTouch) -> Vec:
    """The point at which a part touches something, if it does, else one that is known so far."""
    return select(maximum(touch.engaged) > 0.0, touch.point, so_far)


class TurningPoint(NamedTuple):
    """A contact with a memory that is going in: it turns where its rate of depth is zero."""

    inward: Vec  # unit normal into the obstacle, body; zero without contact
    point: Vec  # from the main body, body [m]
    rate: float  # δ̇ [m/s]


class BodyAcceleration(NamedTuple):
    """Acceleration of the main body in its own axes."""

    linear: Vec  # [m/s²]
    angular: Vec  # [rad/s²]
    vertical: Vec  # Rᵀ e_Z


@kernel
def slip_rate(slip: Slip, body: BodyAcceleration) -> float:
    """Square of the rate of a slip, |v̇| / √(v² + v_s²), of main body and part [1/s²]."""
    change = body.linear + (body.angular ^ slip.point)
    along = slip_velocity(slip.surface, change, slip.inward, body.vertical)
    return (along @ along) * (slip.per_speed * slip.per_speed)


@kernel
def turning_point_of(point: PressedPoint, met: CageContact) -> TurningPoint:
    """TurningPoint of a contact, by what it will remember."""
    rate = -met.rate
    going_in = (point.depth > 0.0) & (rate > TURNED)
    return TurningPoint(met.inward * (1.0 if going_in else 0.0), met.pressing_at, rate)


@kernel
def turning_points_of(met: CageContact) -> tuple[TurningPoint, ...]:
    """Turns of a contact: one, if a surface has a memory."""
    return tree_map(turning_point_of, (met.pressed,), (met,))


@kernel
def or_turn(so_far: Crossing, turn: TurningPoint, body: BodyAcceleration) -> Crossing:
    """The earlier of a crossing and of the turn of a contact, of main body and part; for `fold`.

    Where a contact begins to come out its force has a kink: a step ends there.
    """
    slows = -((body.linear + (body.angular ^ turn.point)) @ turn.inward)
    ends = Crossing(turn.rate if slows > 0.0 else NO_CROSSING, slows if slows > 0.0 else 1.0)
    return sooner(so_far, ends)
