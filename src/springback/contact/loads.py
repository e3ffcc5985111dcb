"""Loads of contacts: forces between a part of a vehicle and each face that it meets.

All vectors are in body axes, and all points are relative to the main body, as in
`springback.contact.cage`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import (
    AT_TOUCH,
    LANDED,
    BodyMotion,
    ContactFace,
    FaceMotion,
    face_of,
)
from springback.contact.laws.bristles import (
    BristleRate,
    RollingResistance,
    Rubbing,
    bristle_rate,
    friction_by_bristles,
    rolling_resistance,
)
from springback.contact.laws.hysteresis import (
    Pressing,
    force_of,
    hysteretic_load,
    share_of_loss,
)
from springback.contact.laws.step_bounds import (
    ContactStiffness,
    FrictionDamping,
    contact_stiffness,
    friction_damping,
)
from springback.contact.obstacles import Obstacle
from springback.contact.surfaces import (
    Surface,
    friction_force,
    normal_force,
    share_of_force,
    slip_velocity,
)
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import field_of, fold, tree_map
from springback.kernels.vectors import Vec, larger
from springback.vehicle.state import ArmPose, PartMemory, PressedPoint


class ContactLoad(NamedTuple):
    """Load on one cage from one obstacle, or the sum over obstacles."""

    force: Vec  # on the cage [N]
    moment: Vec  # about the main body [N m]
    normal: float  # f_n [N]
    friction: Vec  # f_f [N]
    contact_loss: float  # [W]
    friction_loss: float  # [W]
    on_ground: float  # number of grounds touched
    grip: FrictionDamping  # friction as a damper
    press: ContactStiffness  # the normal force as a spring and a damper


class CageContact(NamedTuple):
    """One cage against one obstacle: geometry and forces."""

    gap: float  # positive apart, negative in penetration [m]
    rate: float  # of the gap [m/s]
    inward: Vec  # unit normal into the obstacle
    impulsive: float  # 1 where the surface follows the impulse law
    pressing_at: Vec  # where the normal force acts, from the main body [m]
    rubbing_at: Vec  # where friction acts, from the main body [m]
    per_speed: float  # of friction, 1/√(v² + v_s²); 0 without friction [s/m]
    surface: Surface
    touch: ContactLoad
    moving: tuple[FaceMotion, ...]  # as of its `ContactFace`
    bristles: tuple[BristleRate, ...]  # of its part, if a surface has any
    pressed: tuple[PressedPoint, ...]  # what it remembers, if a surface does


@kernel
def cage_contact(
    obstacle: Obstacle,
    contact_point: Any,
    radius: float,
    arm: ArmPose,
    body: BodyMotion,
) -> CageContact:
    """Contact of one cage with one obstacle of any shape and orientation, eqs. (13)-(15).

    Args:
        obstacle: In the body frame.
        contact_point: `Ring` or `ArmTip`.
        radius: r_0 [m].
        arm: Pose of the arm.
        body: Motion of the main body.
    """
    none = PartMemory((), (), (), ())
    return face_contact(face_of(obstacle, contact_point, radius, arm), 1.0, none, arm, body)


@kernel
def _beside(velocity: Vec, moving: FaceMotion) -> Vec:
    return velocity - moving.velocity


@kernel
def _turning_beside(omega: Vec, moving: FaceMotion) -> Vec:
    return omega - moving.spin


class ContactMotion(NamedTuple):
    """Motion of a part relative to a face; vectors in body axes."""

    sliding: Vec  # of the end of the arm, without that of rotation [m/s]
    omega: Vec  # [rad/s]
    rate: float  # δ̇, positive in compression [m/s]


@kernel
def motion_beside(face: ContactFace, arm: ArmPose, body: BodyMotion) -> ContactMotion:
    """Motion of a part relative to a face that it meets."""
    end = arm.lever
    sliding = fold(_beside, arm.sliding, face.moving, ())
    omega = fold(_turning_beside, body.omega, face.moving, ())
    _, n, at, steepness, at_saddle, saddle_lever = face.nearest
    pressing, saddle = end + at.normal_lever, end + saddle_lever
    rate = steepness * ((sliding + (omega ^ pressing)) @ n)
    rate -= (sliding + (omega ^ saddle)) @ at_saddle
    return ContactMotion(sliding, omega, rate)


class LoadOfFace(NamedTuple):
    """Load of one contact, and what its friction does."""

    touch: ContactLoad
    per_speed: float  # as of `CageContact`, as are the others
    bristles: tuple[BristleRate, ...]
    pressed: tuple[PressedPoint, ...]


@kernel
def face_load(
    face: ContactFace,
    relative: ContactMotion,
    engaged: float,
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> LoadOfFace:
    """Load of the contact with a face; arguments as for `face_contact`."""
    surface, end = face.surface, arm.lever
    sliding, omega, rate = relative
    gap, n, at, steepness, at_saddle, saddle_lever = face.nearest
    rubbing_at, saddle = end + at.friction_lever, end + saddle_lever
    # A step ends on the face to within rounding; a law with a jump there must act at once.
    touches = (gap < -AT_TOUCH) | ((gap <= LANDED) & (rate > 0.0))
    depth = larger(-gap, AT_TOUCH) if touches & (engaged > 0.0) else 0.0
    elastic = normal_force(surface, depth, rate, body.ahead)
    pressing = Pressing(surface, end + at.normal_lever, n, depth, rate, body.ahead)
    with_memory = tree_map(hysteretic_load, (memory.pressed,), (elastic, pressing))
    pressed = fold(force_of, elastic, with_memory, ())
    pressed = fold(share_of_force, pressed, memory.stiffness, ())
    points = fold(share_of_loss, field_of(with_memory, "point"), memory.stiffness, ())
    slip = slip_velocity(surface, sliding + (omega ^ rubbing_at), n, body.vertical)
    f_n = pressed.force * steepness
    at_contact = Rubbing(surface, f_n, n, slip, omega, body.r, body.vertical)
    rubbed = friction_force(surface, f_n, slip)
    rubbed = fold(friction_by_bristles, rubbed, memory.bristles, (at_contact,))

    push = n * (-f_n)
    force = push + rubbed.force
    moment = (rubbing_at ^ force) + ((at.normal_lever - at.friction_lever) ^ push)
    back = at_saddle * pressed.force
    force, moment = force + back, moment + (saddle ^ back)
    resisted = RollingResistance(moment, rubbed.loss)
    resisted = fold(rolling_resistance, resisted, memory.bristles, (at_contact,))
    grounded = face.is_ground if gap < 0.0 else 0.0
    grip = friction_damping(rubbed.grip, n, rubbing_at, arm.direction)
    press = contact_stiffness(pressed.stiffness, pressed.damper, n, arm.direction)
    touch = ContactLoad(
        force,
        resisted.moment,
        f_n,
        rubbed.force,
        pressed.loss,
        resisted.loss,
        grounded,
        grip,
        press,
    )
    bristles = tree_map(bristle_rate, (memory.bristles,), (at_contact, face.moving))
    return LoadOfFace(touch, rubbed.per_speed, bristles, points)


@kernel
def contact_under(
    face: ContactFace, relative: ContactMotion, load: LoadOfFace, arm: ArmPose
) -> CageContact:
    """Contact of a part with a face, by its load."""
    at, surface = face.nearest.at, face.surface
    impulsive = 1.0 if surface.restitution >= 0.0 else 0.0
    return CageContact(
        face.nearest.gap, -relative.rate, face.nearest.inward, impulsive,
        arm.lever + at.normal_lever, arm.lever + at.friction_lever, load.per_speed, surface,
        load.touch, face.moving, load.bristles, load.pressed,
    )  # fmt: skip


@kernel
def face_contact(
    face: ContactFace,
    engaged: float,
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> CageContact:
    """Contact of a cage with a face that it meets, without forces if the cage is not engaged.

    The last stage of a Runge–Kutta step that ends at a touch evaluates the force beyond it.
    Contact is therefore switched on or off at the first stage of a step, and stays so until its
    end.

    Args:
        face: In the body frame.
        engaged: 0 for a cage that did not touch at the beginning of the step.
        memory: Of the cage.
        arm: Pose of the arm.
        body: Motion of the main body.
    """
    relative = motion_beside(face, arm, body)
    load = face_load(face, relative, engaged, memory, arm, body)
    return contact_under(face, relative, load, arm)


@generic
def contacts_with(
    obstacles: Any,
    faces: tuple[ContactFace, ...],
    engaged: tuple[float, ...],
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> tuple[CageContact, ...]:
    """Contact of a part with each face that it meets; see `face_contact`.

    Args:
        obstacles: Of which the faces are.
        faces: In the body frame.
        engaged: For each face, 0 if the part did not touch it at the beginning of the step.
        memory: As for `face_contact`.
        arm: As for `face_contact`.
        body: As for `face_contact`.
    """
    return tree_map(face_contact, (faces, engaged), (memory, arm, body))
