"""Drawable obstacles: rectangles for walls, mats, slopes and the ground, else meshes.

Those that move are drawn where they were placed, one by one, with the number of their track.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.forest import Forest
from springback.contact.grids.measured_shapes import HeightMap, MeshBody, OccupancyGrid
from springback.contact.nets import Net
from springback.contact.parameters import Ground, Mat, Wall
from springback.contact.scene.solids import HALF_SPACE
from springback.contact.scene.table import ENDLESS, Solid
from springback.contact.shapes import (
    ShapeSettings,
    Slope,
    SolidShape,
    Stairs,
    distance_around,
)
from springback.contact.unions import ShapeUnion
from springback.contact.worlds import BuiltIn, Own
from springback.interfaces.replay.form_meshes import (
    cells_mesh,
    heights_mesh,
    in_place,
    mesh_body_mesh,
    net_mesh,
)
from springback.interfaces.replay.part_labels import part_names
from springback.interfaces.replay.shape_meshes import (
    EndSpan,
    ShapeMesh,
    as_one,
    mesh_of,
    mesh_of_body,
    sides_of,
    trunks,
)
from springback.interfaces.replay.tracks import BodyTrack, relative_to, way_of
from springback.results.meshes import Mesh, surfaces_of
from springback.scenario.tables import UserShape
from springback.scenario.worlds.imported import single_obstacles

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Margin of a drawn face around the flight near it, and its smallest side [m]; height above a slope
#: up to which a flight is near it, where there is no ground [m] (chosen).
ROOM, LEAST_SIDE, ABOVE = 0.6, 1.6, 5.0
#: Largest extension of a face to what is beside the flight, the floor or other obstacles [m]
#: (chosen: a piece of wall, not all of it).
LARGEST_SIDE = 20.0
#: A face counts as horizontal if the vertical component of its normal exceeds this; a slope, this.
LYING, LEVEL = 0.9, 1.0 - 1e-9
#: A wall, or a pole, reaches down to the floor if its way up rises by more than this per metre.
UPRIGHT, STEEP = 0.5, 0.2
#: Contact points no farther than this from a face are on it [m] (chosen: deeper than any contact).
ON_FACE = 0.1
#: Without ground, distance of the foot of an endless pole below the flight [m], as of the shadows.
FOOT = 0.45
#: Most solids that are drawn, sides of each of so many trunks, and instants at which distances
#: from the flight are compared (chosen: a page of 1 MB).
MOST_DRAWN, TRUNK_SIDES, COMPARED = 400, 16, 64
#: Most names of shapes at rest in a legend, and of parts of imported worlds in it (chosen).
MOST_NAMED, MOST_PARTS = 16, 8


class Drawable(NamedTuple):
    """A rectangle or a mesh to draw.

    A rectangle has a centre, an outward normal and its half sides, and the material behind it is
    ``thickness`` deep, or unlimited if that is 0.  A mesh has vertices and triangles, anticlockwise
    as seen from outside.
    """

    kind: str  # wall, mat, slope, ground or mesh
    name: str  # for a legend: the user's, or its type
    centre: tuple[float, ...] = ()  # world [m]
    normal: tuple[float, ...] = ()  # unit vector, world
    across: tuple[float, ...] = ()  # half a side, world [m]
    along: tuple[float, ...] = ()  # half the other side, upwards if the face is upright, world [m]
    thickness: float = 0.0  # [m]
    vertices: Array | None = None  # world [m], shape (vertices, 3)
    triangles: Cells | None = None  # shape (triangles, 3)
    normals: Array | None = None  # at the vertices, shape (vertices, 3); else of exact faces
    key: str = ""  # of a mesh: the same for the same obstacles of two flights
    track: int = -1  # number of its track in the scene; −1 at rest


class DrawnWorld(NamedTuple):
    """Drawable obstacles, and remarks about them."""

    drawables: tuple[Drawable, ...]
    notes: tuple[str, ...]


def drawables(
    obstacles: Sequence[Any],
    own: Sequence[Own],
    flown: Array,
    near: Array,
    stored: Sequence[Mesh] = (),
    tracks: Sequence[BodyTrack] = (),
) -> DrawnWorld:
    """All obstacles as drawables.

    Args:
        obstacles: Entries of the scenario's world.
        own: The user's own shapes, with their surfaces.
        flown: Positions of the vehicle, world [m], shape (instants, 3).
        near: Contact points, world [m], shape (touches, 3), possibly none.
        stored: Meshes of the user's own shapes read from a file, used if ``own`` is empty.
        tracks: Of the obstacles that move, at the instants of ``flown``.
    """
    entries, follow = obstacles, {track.obstacle for track in tracks}
    at_rest = single_obstacles([one for k, one in enumerate(entries) if k not in follow])
    obstacles = [one for one in at_rest if not isinstance(one, UserShape)]
    levels = [entry.height for entry in obstacles if isinstance(entry, Ground)]
    floor = max((z for z in levels if z <= flown[:, 2].min()), default=None)
    planes: list[Wall | Ground | Mat | Slope | SolidShape] = [
        one for one in obstacles if isinstance(one, Wall | Ground | Mat | Slope)
    ]
    planes += [
        body
        for one in obstacles
        if isinstance(one, ShapeUnion)
        for body in one.bodies()
        if body.kind == HALF_SPACE
    ]
    shapes = [one for one in obstacles if isinstance(one, ShapeSettings)]
    chosen = _near(shapes, np.concatenate([_sample(flown), _sample(near)]))
    names = _names(chosen.parts, part_names(entries), _sample(near if len(near) else flown))
    bodies, notes = list(_meshes(chosen.parts, names, flown, floor)), list(chosen.notes)
    moving = [
        one._replace(track=k)
        for k, track in enumerate(tracks)
        for one in _moving(entries[track.obstacle], track, flown, floor)
    ]
    ways = [way_of(tracks[one.track], one.vertices, (0, len(flown) // 2, -1))
            for one in moving if one.vertices is not None]  # fmt: skip
    around = _under(bodies, np.concatenate([flown, *ways]), flown)
    things = (
        [
            _face(entry, around if isinstance(entry, Ground) else flown, floor, near)
            for entry in planes
        ]
        + bodies
        + moving
    )
    own_meshes = list(surfaces_of(own, near if len(near) else flown) if own else stored)
    given = [one.name for one in at_rest if isinstance(one, UserShape)]
    for k, one in enumerate(own_meshes):
        one = one._replace(name=given[k]) if k < len(given) and given[k] else one
        if len(one.triangles):
            things.append(Drawable("mesh", one.name, vertices=one.vertices,
                                   triangles=one.triangles, normals=one.normals,
                                   key=str(k)))  # fmt: skip
        else:
            notes.append(f"{one.name} is not drawn: none of its surface was found near the flight")
    return DrawnWorld(tuple(things), tuple(notes))


def _face(
    entry: Wall | Ground | Mat | Slope | SolidShape,
    flown: Array,
    floor: float | None,
    touched: Array,
) -> Drawable:
    """Rectangle of a face around the flight near it; a steep one extends down to the floor.

    Args:
        entry: The face.
        flown: Points of the flight, world [m], shape (points, 3).
        floor: Height of the ground [m]; None without any.
        touched: Contact points with any obstacle, world [m], shape (touches, 3).
    """
    thickness, close, slopes = 0.0, flown, isinstance(entry, Slope | SolidShape)
    if isinstance(entry, Ground):
        n, offset = np.array([0.0, 0.0, 1.0]), entry.height
    else:
        if isinstance(entry, Slope | SolidShape):
            [body] = [entry] if isinstance(entry, SolidShape) else entry.bodies()
            n, offset = body.axes[2], float(body.axes[2] @ body.centre)
        else:
            thickness = entry.thickness if isinstance(entry, Mat) else 0.0
            face = entry.plane(thickness)
            n, offset = np.array(face.normal), face.offset
        heights = flown @ n - offset
        close = flown[heights <= heights.min() + ROOM]
        if slopes and floor is None and n[2] > UPRIGHT:  # under what flies above it, too
            below = flown - np.outer(heights / n[2], [0.0, 0.0, 1.0])
            close = np.concatenate([close, below[np.abs(heights) <= ABOVE]])
    close = np.concatenate([close, touched[np.abs(touched @ n - offset) <= ON_FACE]])
    centre, halves = n * offset, []
    for axis in _axes(n, LEVEL if slopes else LYING):
        places = close @ axis
        low, high = float(places.min()) - ROOM, float(places.max()) + ROOM
        side = max(high - low, LEAST_SIDE)
        middle = 0.5 * (low + high)
        if floor is not None and axis[2] > (0.0 if slopes else UPRIGHT):
            foot = (floor - n[2] * offset) / axis[2]
            down = middle + 0.5 * side - foot
            if down <= side + LARGEST_SIDE:
                side = max(side, down)
                middle = foot + 0.5 * side
        centre = centre + middle * axis
        halves.append(_floats(0.5 * side * axis))
    across, along = halves
    word = "slope" if isinstance(entry, SolidShape) else entry.type
    name = "" if isinstance(entry, SolidShape) else entry.name
    return Drawable(word, name or word, _floats(centre), _floats(n), across, along, thickness)


def _floats(v: Array) -> tuple[float, ...]:
    return tuple(map(float, v))


def _axes(n: Array, lying: float) -> tuple[Array, Array]:
    """Two unit vectors in a face: horizontal and upwards; in a horizontal face, near X and Y."""
    up = np.array([0.0, 0.0, 1.0]) if abs(n[2]) < lying else np.array([0.0, 1.0, 0.0])
    across = np.cross(up, n)
    across /= np.linalg.norm(across)
    return across, np.cross(n, across)


# -- shapes ---------------------------------------------------------------------------------------


_Parts = list[tuple[ShapeSettings, list[SolidShape]]]


class _NearShapes(NamedTuple):
    """Shapes near a flight with those of their solids that are drawn."""

    parts: _Parts
    notes: tuple[str, ...]


def _sample(points: Array) -> Array:
    """Some of many points, the first and last among them."""
    if len(points) <= COMPARED:
        return points
    return points[np.linspace(0, len(points) - 1, COMPARED).astype(np.intp)]


def _near(shapes: Sequence[ShapeSettings], flown: Array) -> _NearShapes:
    """At most `MOST_DRAWN` solids, those nearest to a flight."""
    bounded = [
        (shape, [body for body in shape.bodies() if body.kind != HALF_SPACE]) for shape in shapes
    ]
    parts = [(shape, found) for shape, found in bounded if found]
    bodies = [body for _, found in parts for body in found]
    if len(bodies) <= MOST_DRAWN:
        return _NearShapes(parts, ())
    away = _distances(bodies, flown)
    limit = float(np.partition(away, MOST_DRAWN - 1)[MOST_DRAWN - 1])
    chosen, first = [], 0
    for shape, found in parts:
        near = [one for one, d in zip(found, away[first:], strict=False) if d <= limit]
        first += len(found)
        chosen += [(shape, near)] if near else []
    drawn = sum(len(near) for _, near in chosen)
    note = f"of {len(bodies)} bodies of the obstacles the {drawn} nearest to the flight are drawn"
    return _NearShapes(chosen, (note,))


def _distances(bodies: Sequence[SolidShape], points: Array) -> Array:
    """Distances of the boxes around bodies from the nearest of some points [m]."""
    centres = np.array([body.centre for body in bodies])
    axes = np.array([body.axes for body in bodies])
    halves = np.array([Solid(*body, 0, 0.0, 0).half_lengths() for body in bodies])
    nearest = np.full(len(bodies), np.inf)
    for point in points:
        local = np.einsum("kij,kj->ki", axes, point - centres)
        outside = np.maximum(np.abs(local) - halves, 0.0)
        nearest = np.minimum(nearest, np.linalg.norm(outside, axis=1))
    return nearest


def _names(parts: _Parts, imported: dict[int, str], places: Array) -> dict[int, str]:
    """Names of shapes by their identity, at most `MOST_NAMED`: others go by their types.

    Those of imported worlds are of the parts that are nearest to some places [m].
    """
    given = [(id(shape), shape.name or imported.get(id(shape), "")) for shape, _ in parts]
    users = list(dict.fromkeys(shape.name for shape, _ in parts if shape.name))
    away = dict[str, float]()
    for shape, found in parts:
        if (name := imported.get(id(shape), "")) and not shape.name:
            here = min(float(distance_around(one, places).min()) for one in found)
            away[name] = min(here, away.get(name, np.inf))
    nearest = sorted(away, key=lambda name: away[name])[:MOST_PARTS]
    known = {*users[:MOST_NAMED], *nearest[: max(MOST_NAMED - len(users), 0)]}
    return {key: name for key, name in given if name in known}


def _meshes(
    parts: _Parts, names: Mapping[int, str], flown: Array, floor: float | None
) -> Iterable[Drawable]:
    """One mesh for all shapes of a name, or of a type for those without."""
    kinds: dict[str, list[tuple[ShapeSettings, list[SolidShape]]]] = {}
    for shape, bodies in parts:
        word = names.get(id(shape)) or str(getattr(shape, "type", ""))
        kinds.setdefault(word, []).append((shape, bodies))
    for name, group in kinds.items():
        mesh = as_one([_mesh(shape, bodies, flown, floor) for shape, bodies in group])
        yield Drawable(
            "mesh", name, vertices=mesh.vertices, triangles=mesh.triangles,
            key=_key(shape for shape, _ in group),
        )  # fmt: skip


def _moving(
    entry: BuiltIn, track: BodyTrack, flown: Array, floor: float | None
) -> Iterable[Drawable]:
    """A moving obstacle where it was placed, as far as it comes near a flight."""
    seen = relative_to(track, flown)
    level = floor if float(np.ptp(track.position[:, 2])) == 0.0 else None
    if isinstance(entry, Wall | Ground | Mat | Slope):
        yield _face(entry, seen, level, np.zeros((0, 3)))
    else:
        parts = _near([entry], _sample(seen)).parts
        yield from _meshes(parts, {id(entry): entry.name}, seen, level)


def _under(meshes: Sequence[Drawable], ways: Array, flown: Array) -> Array:
    """A flight, and the feet of what is near it: what the ground is drawn under.

    Args:
        meshes: Obstacles at rest.
        ways: Points of the flight and of what moves [m], shape (points, 3).
        flown: Those of the flight.
    """
    found = [ways] + [one.vertices for one in meshes if one.vertices is not None]
    low, high = flown.min(axis=0), flown.max(axis=0)
    room = np.maximum(0.5 * (LARGEST_SIDE - (high - low)) - ROOM, 0.0)
    return np.clip(np.concatenate(found), low - room, high + room)


def _key(shapes: Iterable[ShapeSettings]) -> str:
    """Digest of some shapes, without their surfaces."""
    text = "\n".join(shape.model_dump_json(exclude={"surface"}) for shape in shapes)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _mesh(
    shape: ShapeSettings, bodies: Sequence[SolidShape], flown: Array, floor: float | None
) -> ShapeMesh:
    if isinstance(shape, ShapeUnion):
        return _union_mesh(shape, bodies, flown, floor)
    if isinstance(shape, HeightMap):
        return in_place(heights_mesh(shape), bodies[0])
    if isinstance(shape, MeshBody):
        return in_place(mesh_body_mesh(shape), bodies[0])
    if isinstance(shape, OccupancyGrid):
        return in_place(cells_mesh(shape), bodies[0])
    if isinstance(shape, Net):
        return net_mesh(bodies[0])
    if isinstance(shape, Stairs):
        return mesh_of(shape)
    if isinstance(shape, Forest):
        sides = MOST_DRAWN * TRUNK_SIDES // (4 * len(bodies)) * 4
        span = _span(bodies[0], flown, floor, everywhere=True)
        return trunks(bodies, span, min(sides, sides_of(shape.radius)))
    return as_one([
        mesh_of_body(body, _span(body, flown, floor) if ENDLESS in body.sizes else None)
        for body in bodies
    ])  # fmt: skip


def _union_mesh(
    shape: ShapeUnion, bodies: Sequence[SolidShape], flown: Array, floor: float | None
) -> ShapeMesh:
    """Meshes of the bodies of a union, those of measured forms by their shapes."""
    owners = [one for one in shape.shapes for _ in one.bodies()]
    chosen = {_place(body) for body in bodies}
    found = []
    for one, body in zip(owners, shape.bodies(), strict=True):
        if _place(body) not in chosen:
            continue
        if isinstance(one, HeightMap | MeshBody | OccupancyGrid | Net):
            found.append(_mesh(one, [body], flown, floor))
        else:
            span = _span(body, flown, floor) if ENDLESS in body.sizes else None
            found.append(mesh_of_body(body, span))
    return as_one(found)


def _place(body: SolidShape) -> tuple[Any, ...]:
    """Numbers that tell a body from others."""
    return (body.kind, *body.centre.tolist(), *body.axes.ravel().tolist(), *body.sizes)


def _span(
    body: SolidShape, flown: Array, floor: float | None, *, everywhere: bool = False
) -> EndSpan:
    """Where a pole without end is cut: around the flight near it, or everywhere, and at the floor.

    Args:
        body: The pole.
        flown: Positions of the vehicle, world [m].
        floor: Height of the ground [m]; None without any.
        everywhere: True for the whole flight.
    """
    axis, relative = body.axes[2], flown - body.centre
    places = relative @ axis
    aside = np.linalg.norm(relative - np.outer(places, axis), axis=1)
    close = places if everywhere else places[aside <= aside.min() + ROOM]
    low, high = float(close.min()) - ROOM, float(close.max()) + ROOM
    most = max(high - low, LARGEST_SIDE)
    short = max(LEAST_SIDE - (high - low), 0.0)
    low, high = low - 0.5 * short, high + 0.5 * short
    if abs(axis[2]) > STEEP:
        level = float(flown[:, 2].min()) - FOOT if floor is None else floor
        foot = float((level - body.centre[2]) / axis[2])
        low, high = (foot, max(high, foot)) if axis[2] > 0.0 else (min(low, foot), foot)
    if axis[2] >= 0.0:
        return EndSpan(max(low, high - most), high)
    return EndSpan(low, min(high, low + most))
