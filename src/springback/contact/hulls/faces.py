"""Hulls of one part of a vehicle against everything: a scene, and the user's own shapes beside it.

The latter are kernels of their own, so their contacts are searched for by code that is compiled for
each shape (`own_hull_faces`); shapes of a scene are looked up by the routine.
"""

from __future__ import annotations

from typing import Any

from springback.contact.cage import ContactFace
from springback.contact.hulls.contacts import HullFaces, HullPart, no_hull_faces
from springback.contact.hulls.user_shapes import own_hull_faces
from springback.contact.obstacles import Obstacle, SecondContact
from springback.contact.rings import FAR
from springback.contact.scene.faces import SceneInBodyFrame, SolidScene
from springback.kernels.compiler import generic, kernel
from springback.kernels.routines import call_routine
from springback.kernels.trees import one_tuple, tree_map
from springback.kernels.vectors import Vec
from springback.vehicle.state import CompoundHull


@generic
def compound_faces(
    obstacles: Any, hull: CompoundHull, lever: Vec, engaged: float
) -> tuple[ContactFace, ...]:
    """The faces that the hulls of a part can meet, as many at every instant.

    Args:
        obstacles: A scene, in the body frame.
        hull: All hulls of the part.
        lever: To what they are fixed to, from the main body, body axes [m].
        engaged: 0 where no force of theirs will act: they are then not looked for.
    """
    raise TypeError("hulls of this kind meet scenes only")


@generic
def compound_flags(obstacles: Any, value: float) -> tuple[float, ...]:
    """The same number for every face of `compound_faces`."""
    raise TypeError("hulls of this kind meet scenes only")


@generic
def compound_gaps(obstacles: Any, hull: CompoundHull, lever: Vec) -> tuple[float, ...]:
    """Gaps of the hulls of a part, as many as a cage has faces: three of the scene, then others.

    Far from all obstacles of a scene the first may be less than it is.

    Args:
        obstacles: As for `compound_faces`.
        hull: As for `compound_faces`.
        lever: As for `compound_faces`.
    """
    raise TypeError("hulls of this kind meet scenes only")


@kernel
def six(found: HullFaces) -> tuple[ContactFace, ...]:
    """The faces as a tuple."""
    return (found.first, found.second, found.third, found.fourth, found.fifth, found.sixth)


@kernel
def faces_in_scene(scene: SceneInBodyFrame, hull: CompoundHull, lever: Vec) -> HullFaces:
    """The faces of a scene that the hulls of a part meet; arguments as for `compound_faces`."""
    part = HullPart(
        scene.table, hull.table, hull.centre, hull.radius, lever, scene.position, scene.r,
        scene.exact, scene.rounding, scene.query,
    )  # fmt: skip
    return call_routine(scene.hull_query, part, no_hull_faces())


@kernel
def on_own(
    obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> tuple[ContactFace, ...]:
    """The faces of one of the user's own shapes; arguments as for `own_faces`."""
    return own_faces(obstacle.shape, obstacle, hull, lever, rounding)


@generic
def own_faces(
    shape: Any, obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> tuple[ContactFace, ...]:
    """The faces of a shape of the user's own that hulls can meet.

    Args:
        shape: Of the obstacle.
        obstacle: In the body frame.
        hull: All hulls of the part.
        lever: As for `compound_faces`.
        rounding: Of rings on planes [rad].
    """
    return six(own_hull_faces(obstacle, hull, lever, rounding))


@own_faces.register(SecondContact)
@kernel
def _no_second(
    shape: SecondContact, obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> tuple[ContactFace, ...]:
    return ()


@generic
def own_flags(shape: Any, value: float) -> tuple[float, ...]:
    """The same number for every face of `own_faces`."""
    return (value, value, value, value, value, value)


@own_flags.register(SecondContact)
@kernel
def _no_flags(shape: SecondContact, value: float) -> tuple[float, ...]:
    return ()


@kernel
def flags_on(obstacle: Obstacle, value: float) -> tuple[float, ...]:
    """The same number for every face of one of the user's own shapes."""
    return own_flags(obstacle.shape, value)


@generic
def own_gap(
    shape: Any, obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> float:
    """Gap of the hulls of a part to a shape of the user's own [m]; arguments as for `own_faces`."""
    return own_hull_faces(obstacle, hull, lever, rounding).first.nearest.gap


@own_gap.register(SecondContact)
@kernel
def _far_second(
    shape: SecondContact, obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float
) -> float:
    return FAR


@kernel
def gap_on(obstacle: Obstacle, hull: CompoundHull, lever: Vec, rounding: float) -> float:
    """Gap to one of the user's own shapes [m]; arguments as for `own_faces`."""
    return own_gap(obstacle.shape, obstacle, hull, lever, rounding)


@compound_faces.register(SceneInBodyFrame)
@kernel
def _faces_in_scene(
    scene: SceneInBodyFrame, hull: CompoundHull, lever: Vec, engaged: float
) -> tuple[ContactFace, ...]:
    found = no_hull_faces()
    if engaged > 0.0:
        found = faces_in_scene(scene, hull, lever)
    return six(found) + one_tuple(tree_map(on_own, (scene.own,), (hull, lever, scene.rounding)))


@compound_flags.register(SolidScene)
@kernel
def _flags_of_scene(scene: SolidScene, value: float) -> tuple[float, ...]:
    six = (value, value, value, value, value, value)
    return six + one_tuple(tree_map(flags_on, (scene.own,), (value,)))


@compound_flags.register(SceneInBodyFrame)
@kernel
def _flags_in_body_frame(scene: SceneInBodyFrame, value: float) -> tuple[float, ...]:
    six = (value, value, value, value, value, value)
    return six + one_tuple(tree_map(flags_on, (scene.own,), (value,)))


@compound_gaps.register(SceneInBodyFrame)
@kernel
def _gaps_in_scene(scene: SceneInBodyFrame, hull: CompoundHull, lever: Vec) -> tuple[float, ...]:
    first = faces_in_scene(scene, hull, lever).first.nearest.gap
    return (first, FAR, FAR) + tree_map(gap_on, (scene.own,), (hull, lever, scene.rounding))  # noqa: RUF005
