"""Obstacles of a world, built from their settings: planes one by one, or all solids as a scene.

One plane and two of them are structures of their own to the compiler, and the fastest; a scene is
one structure whatever it holds (docs/decisions/0027).  A world is a scene with its first obstacle
that is not plane, with its third plane, and with a law that is not of exponent 3/2.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Annotated, Any

from pydantic import Field

from springback.contact.moving.building import MovingShape, moving_scene
from springback.contact.moving.parameters import FreeMotion
from springback.contact.moving.scene import MovingScene
from springback.contact.obstacles import Obstacle, Plane, SecondContact
from springback.contact.parameters import Ground, Mat, SurfaceSettings, Wall, faces
from springback.contact.scene.faces import SCENE_FACES, SolidScene
from springback.contact.scene.table import MOST_SOLIDS, Solid, scene_of
from springback.contact.shapes import ShapeSettings, SolidPart, half_space
from springback.contact.surfaces import AnyExponent, ThreeHalves, remembers
from springback.contact.unions import ShapeUnion, SingleShape
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Vec
from springback.settings import problem
from springback.vehicle.force_laws import REMEMBERING

#: Any shape, of one body or several.
Shape = SingleShape | ShapeUnion
#: Any obstacle of springback's own.
BuiltIn = Wall | Ground | Mat | Shape
ObstacleSettings = Annotated[BuiltIn, Field(discriminator="type")]

#: Most planes that are no scene: a wall and the ground, or a mat and what is behind it (chosen:
#: each number is compiled ahead, `springback.campaign.common_flights`).
MOST_PLANES = 2
#: Scenes that are remembered (chosen: one of 10 000 trunks takes 3 MB).
LATEST = 16

#: A user's own shape, registered with `signed_distance` and `outward_normal`, and its surface.
Own = tuple[Any, SurfaceSettings]


def _is_common(law: SurfaceSettings) -> bool:
    """True for the laws of planes that are no scene: forces with the exponent 3/2."""
    return law.law != "impulse" and law.exponent_value() == 1.5


def _has_memory(law: SurfaceSettings) -> bool:
    """True for a law whose contacts have a state of their own, which only scenes keep."""
    return law.friction_law == "bristle" or law.law in REMEMBERING


def obstacles(
    settings: Sequence[BuiltIn],
    own: Sequence[Own] = (),
    *,
    as_scene: bool = False,
    numbers: Sequence[int] = (),
    hull_memory: bool = False,
) -> tuple[Obstacle, ...] | SolidScene | MovingScene:
    """Numbers of all obstacles; if there are none, a face out of reach.

    Args:
        settings: Obstacles of springback's own.
        own: The user's own shapes.
        as_scene: True makes a scene of planes alone, too.
        numbers: Number in the world of each, from 0; by default in their order.
        hull_memory: True if a hull that meets them has a surface with a memory.

    Raises:
        The problem, if there are too many.
    """
    if any(_moves(entry) for entry in settings):
        return _moving_scene(settings, own, numbers or range(len(settings)), hull_memory)
    laws = [law for entry in settings for law in surfaces_of(entry)] + [law for _, law in own]
    planes = [entry for entry in settings if not isinstance(entry, ShapeSettings)]
    all_faces: list[tuple[Any, SurfaceSettings, float]] = []
    all_faces += [face for entry in planes for face in faces(entry)]
    few = len(planes) == len(settings) and len(all_faces) <= MOST_PLANES
    known = bool(own) or all(map(_is_common, laws))
    if as_scene or not few or not known or any(map(_has_memory, laws)):
        built = _scene(settings, own)
        return built._replace(remembers=1.0) if hull_memory else built
    all_faces += _own_faces(own)
    common = all(surface.exponent_value() == 1.5 for _, surface, _ in all_faces)
    exponent = ThreeHalves if common else AnyExponent
    if not all_faces:
        nowhere = SurfaceSettings(law="hertz").surface(ThreeHalves)
        return (Obstacle(Plane(Vec(0.0, 0.0, 1.0), -1e9), nowhere, 0.0),)
    return tuple(
        Obstacle(shape, surface.surface(exponent), ground) for shape, surface, ground in all_faces
    )


def alone(entry: BuiltIn, number: int) -> SolidScene | MovingScene:
    """World of one of the obstacles of another, as a scene.

    Args:
        entry: The obstacle.
        number: Its number in the other world, from 0.
    """
    built = obstacles((entry,), as_scene=True)
    assert isinstance(built, SolidScene | MovingScene)
    if isinstance(built, SolidScene):
        return built
    body, *absent = built.bodies
    return built._replace(bodies=(body._replace(obstacle=float(number)), *absent))


def _moves(entry: BuiltIn) -> bool:
    return getattr(entry, "motion", None) is not None


def _moving_scene(
    settings: Sequence[BuiltIn], own: Sequence[Own], numbers: Sequence[int], hulls: bool
) -> MovingScene:
    """World in which some obstacles move; ``hulls``: a hull that meets them has a memory."""
    still = _scene([entry for entry in settings if not _moves(entry)], own)
    moves = next(k for k, entry in zip(numbers, settings, strict=True) if _moves(entry))
    for k, entry in zip(numbers, settings, strict=True):
        for key, law in laws_by_key(entry):
            if law.law == "impulse":
                raise problem(
                    "must not be impulse in a world where an obstacle moves, as "
                    f"world.obstacles[{moves}] does: use a law of force, such as hunt-crossley",
                    f"world.obstacles[{k}].{key}.law",
                )
    free = any(isinstance(getattr(entry, "motion", None), FreeMotion) for entry in settings)
    for k, entry in zip(numbers, settings, strict=True):
        for law in surfaces_of(entry) if free and not _moves(entry) else ():
            if law.law in REMEMBERING:
                raise problem(
                    f"must not have a surface of law {law.law} beside an obstacle that moves "
                    "freely, whose contacts with it have no memory",
                    f"world.obstacles[{k}]",
                )
    moving = []
    for k, entry in zip(numbers, settings, strict=True):
        if isinstance(entry, Wall | ShapeSettings) and _moves(entry):
            moving.append(MovingShape(_parts_of(entry), entry.motion, k))
    surfaces = [surface for one in moving for surface in one.surfaces]
    if any(surface.presliding > 0.0 for surface in surfaces):
        still = still._replace(bristles=1.0)
    if hulls or any(map(remembers, surfaces)):
        still = still._replace(remembers=1.0)
    return moving_scene(still, moving)


def surfaces_of(entry: BuiltIn) -> list[SurfaceSettings]:
    """Surfaces of an obstacle."""
    return [law for _, law in laws_by_key(entry)]


def laws_by_key(entry: BuiltIn) -> list[tuple[str, SurfaceSettings]]:
    """Surfaces of an obstacle, each with its key in the obstacle's table."""
    if isinstance(entry, ShapeUnion):
        laws = [shape.law() for shape in entry.shapes]
        keys = ["surface" if law == entry.surface else "" for law in laws]
        keys = [key or f"shapes[{k}].surface" for k, key in enumerate(keys)]
        return list(zip(keys, laws, strict=True))
    if isinstance(entry, ShapeSettings):
        return [("surface", entry.law())]
    behind = [("backing", entry.backing)] if isinstance(entry, Mat) else []
    return [("surface", entry.surface), *behind]


def _parts_of(entry: Wall | ShapeSettings) -> list[SolidPart]:
    if isinstance(entry, ShapeSettings):
        return entry.parts()
    [(plane, law, _)] = faces(entry)
    return [SolidPart(half_space(plane.normal, plane.offset), law)]


def _own_faces(own: Sequence[Own]) -> list[tuple[Any, SurfaceSettings, float]]:
    """Shapes of the user's own; a ring can touch one that is not plane at two points."""
    found = [(shape, surface, 0.0) for shape, surface in own]
    curved = [(s, surface) for s, surface in own if not isinstance(s, Plane)]
    return found + [(SecondContact(s), surface, 0.0) for s, surface in curved]


def _scene(settings: Sequence[BuiltIn], own: Sequence[Own]) -> SolidScene:
    """All obstacles as a scene."""
    beside = tuple(
        Obstacle(shape, law.surface(AnyExponent, in_scene=True), ground)
        for shape, law, ground in _own_faces(own)
    )
    built = _scene_of_built_in(tuple(settings))
    if isinstance(built.table, NumberTable):
        built.table.hold()  # it may be of an earlier batch, and soon be forgotten here
    if any(one.surface.presliding > 0.0 for one in beside):
        built = built._replace(bristles=1.0)
    if any(remembers(one.surface) for one in beside):
        built = built._replace(remembers=1.0)
    # Its routine may not have been compiled when it was built (`routines_deferred`).
    return built._replace(query=SCENE_FACES.address, own=beside)


@lru_cache(maxsize=LATEST)
def _scene_of_built_in(settings: tuple[BuiltIn, ...]) -> SolidScene:
    """Scene of obstacles of springback's own; a campaign mostly flies the same again."""
    laws: dict[SurfaceSettings, int] = {}
    solids: list[Solid] = []
    for owner, entry in enumerate(settings):
        if isinstance(entry, ShapeSettings):
            for body, law in entry.parts():
                solids.append(Solid(*body, laws.setdefault(law, len(laws)), 0.0, owner))
            continue
        for plane, law, ground in faces(entry):
            surface = laws.setdefault(law, len(laws))
            solids.append(Solid(*half_space(plane.normal, plane.offset), surface, ground, owner))
    if len(solids) > MOST_SOLIDS:
        raise problem(f"hold {len(solids)} solids; the most is {MOST_SOLIDS}", "world.obstacles")
    surfaces = [law.surface(AnyExponent, in_scene=True) for law in laws]
    return scene_of(solids, surfaces)
