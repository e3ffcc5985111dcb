"""Contacts with the faces of a scene, of which few touch: loads are computed only of those.

Faces of planes are computed for all lanes alike, without branches.  Those of a scene come from a
routine, one lane after the other, and most of a vehicle's fifteen are out of reach.
"""

from __future__ import annotations

from springback.contact.cage import LANDED, BodyMotion, ContactFace
from springback.contact.laws.bristles import BristleRate
from springback.contact.laws.hysteresis import no_point
from springback.contact.laws.jumps import with_jumps
from springback.contact.laws.step_bounds import ContactStiffness, FrictionDamping
from springback.contact.loads import (
    CageContact,
    ContactLoad,
    ContactMotion,
    LoadOfFace,
    contact_under,
    contacts_with,
    face_load,
    motion_beside,
)
from springback.contact.scene.faces import SceneInBodyFrame
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.trees import replace, tree_map
from springback.kernels.vectors import Vec
from springback.vehicle.state import (
    ArmPose,
    Bristles,
    PartMemory,
    PressedPoint,
    PressedPoints,
)


@kernel
def _none_held(bristles: Bristles) -> BristleRate:
    none = Vec(0.0, 0.0, 0.0)
    return BristleRate(none, none, 0.0, 0.0, 0.0)


@kernel
def _nothing_pressed(pressed: PressedPoints) -> PressedPoint:
    return no_point()


@kernel
def _no_load(face: ContactFace, memory: PartMemory) -> LoadOfFace:
    """Load of a face that is not touched."""
    none = Vec(0.0, 0.0, 0.0)
    grip = FrictionDamping(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    press = ContactStiffness(0.0, 0.0, 0.0, 0.0)
    grounded = face.is_ground if face.nearest.gap < 0.0 else 0.0
    touch = ContactLoad(none, none, 0.0, none, 0.0, 0.0, grounded, grip, press)
    bristles = tree_map(_none_held, (memory.bristles,), ())
    return LoadOfFace(touch, 0.0, bristles, tree_map(_nothing_pressed, (memory.pressed,), ()))


@called_kernel
def _load(
    face: ContactFace,
    relative: ContactMotion,
    engaged: float,
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> LoadOfFace:
    return face_load(face, relative, engaged, memory, arm, body)


@kernel
def scene_contact(
    face: ContactFace,
    engaged: float,
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> CageContact:
    """Contact of a part with a face, as `springback.contact.loads.face_contact`."""
    relative = motion_beside(face, arm, body)
    load = _no_load(face, memory)
    if (face.nearest.gap <= LANDED) & (engaged > 0.0):
        load = _load(face, relative, engaged, memory, arm, body)
    return contact_under(face, relative, load, arm)


@contacts_with.register(SceneInBodyFrame)
@kernel
def contacts_in_scene(
    obstacles: SceneInBodyFrame,
    faces: tuple[ContactFace, ...],
    engaged: tuple[float, ...],
    memory: PartMemory,
    arm: ArmPose,
    body: BodyMotion,
) -> tuple[CageContact, ...]:
    """Contact of a part with each face of a scene, or of the user's own shapes beside it."""
    return tree_map(
        scene_contact, (faces, engaged), (after_jumps(memory, faces, arm, body), arm, body)
    )


@kernel
def after_jumps(
    memory: PartMemory, faces: tuple[ContactFace, ...], arm: ArmPose, body: BodyMotion
) -> PartMemory:
    """Memory of a part whose contacts may have jumped to other faces."""
    return replace(memory, pressed=tree_map(with_jumps, (memory.pressed,), (faces, arm, body)))
