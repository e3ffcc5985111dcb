"""Hulls of a vehicle against a world in which some obstacles move.

A hull is viewed from what is at rest and from each moving obstacle in turn, by the same routine as
in a scene at rest (`springback.contact.hulls.compound`), and meets the deepest faces of all.
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import ContactFace
from springback.contact.hulls.compound import SCENE_HULL_FACES
from springback.contact.hulls.contacts import HullFaces, HullPart, among, no_hull_faces
from springback.contact.hulls.faces import (
    compound_faces,
    compound_flags,
    compound_gaps,
    faces_in_scene,
    flags_on,
    gap_on,
    on_own,
    six,
)
from springback.contact.moving.bodies import ABSENT
from springback.contact.moving.scene import (
    BodyInBodyFrame,
    MovingInBodyFrame,
    MovingScene,
    at_rest,
    with_motion,
)
from springback.contact.obstacles import Obstacle
from springback.contact.rings import FAR
from springback.contact.scene.faces import EXACT_BELOW
from springback.kernels.compiler import kernel
from springback.kernels.routines import call_routine
from springback.kernels.trees import fold, one_tuple, tree_map
from springback.kernels.vectors import Vec, norm
from springback.vehicle.state import CompoundHull


def with_hulls(scene: Any, rounding: float) -> Any:
    """A scene that hulls of any kind can meet; the routine for them is compiled now.

    Args:
        scene: A `SolidScene` or a `MovingScene`.
        rounding: Of rings on planes [rad].
    """
    if isinstance(scene, MovingScene):
        return scene._replace(still=with_hulls(scene.still, rounding))
    return scene._replace(hull_query=SCENE_HULL_FACES.address, rounding=rounding)


@kernel
def _all_at_rest(f: HullFaces) -> HullFaces:
    rest = at_rest()
    return HullFaces(
        with_motion(f.first, rest), with_motion(f.second, rest), with_motion(f.third, rest),
        with_motion(f.fourth, rest), with_motion(f.fifth, rest), with_motion(f.sixth, rest),
    )  # fmt: skip


@kernel
def _with_body(
    found: HullFaces,
    one: BodyInBodyFrame,
    world: MovingInBodyFrame,
    hull: CompoundHull,
    lever: Vec,
) -> HullFaces:
    """Faces with those of a moving obstacle; one that is far gives none."""
    if (one.kind == ABSENT) | (one.scene == 0.0):  # absent, or without solids
        return found
    away = norm(one.position + one.r @ (lever + hull.centre)) - one.reach - hull.radius
    nearest = found.first.nearest.gap
    if (away > EXACT_BELOW) & (world.still.exact == 0.0) & (away > nearest):
        return found
    part = HullPart(
        one.scene, hull.table, hull.centre, hull.radius, lever, one.position, one.r,
        world.still.exact, world.still.rounding, world.still.query,
    )  # fmt: skip
    there, motion = call_routine(world.still.hull_query, part, no_hull_faces()), one.motion
    found = among(found, with_motion(there.first, motion))
    found = among(found, with_motion(there.second, motion))
    found = among(found, with_motion(there.third, motion))
    found = among(found, with_motion(there.fourth, motion))
    found = among(found, with_motion(there.fifth, motion))
    return among(found, with_motion(there.sixth, motion))


@kernel
def _all_faces(world: MovingInBodyFrame, hull: CompoundHull, lever: Vec) -> HullFaces:
    found = _all_at_rest(faces_in_scene(world.still, hull, lever))
    return fold(_with_body, found, world.bodies, (world, hull, lever))


@kernel
def _at_rest_too(face: ContactFace) -> ContactFace:
    return with_motion(face, at_rest())


@kernel
def _on_own_at_rest(
    obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> tuple[ContactFace, ...]:
    return tree_map(_at_rest_too, (on_own(obstacle, hull, lever, rounding),), ())


@compound_faces.register(MovingInBodyFrame)
@kernel
def _moving_faces(
    world: MovingInBodyFrame, hull: CompoundHull, lever: Vec, engaged: float
) -> tuple[ContactFace, ...]:
    found = _all_at_rest(no_hull_faces())
    if engaged > 0.0:
        found = _all_faces(world, hull, lever)
    rounding = world.still.rounding
    return six(found) + one_tuple(tree_map(_on_own_at_rest, (world.own,), (hull, lever, rounding)))


@compound_flags.register(MovingScene)
@kernel
def _flags_of_scene(scene: MovingScene, value: float) -> tuple[float, ...]:
    return compound_flags(scene.still, value)


@compound_flags.register(MovingInBodyFrame)
@kernel
def _flags_in_body_frame(world: MovingInBodyFrame, value: float) -> tuple[float, ...]:
    each = (value, value, value, value, value, value)
    return each + one_tuple(tree_map(flags_on, (world.own,), (value,)))


@compound_gaps.register(MovingInBodyFrame)
@kernel
def _moving_gaps(world: MovingInBodyFrame, hull: CompoundHull, lever: Vec) -> tuple[float, ...]:
    first = _all_faces(world, hull, lever).first.nearest.gap
    own = tree_map(gap_on, (world.own,), (hull, lever, world.still.rounding))
    return (first, FAR, FAR) + own  # noqa: RUF005
