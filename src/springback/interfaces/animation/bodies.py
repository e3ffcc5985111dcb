"""Robots and obstacles of a scene as lines in a plane: from the side, or from above."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull

from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.hull_meshes import HullMesh
from springback.interfaces.replay.scene import (
    ArmShape,
    HullShape,
    JointShape,
    NeighbourShape,
    RotorShape,
    Scene,
)
from springback.interfaces.replay.tracks import BodyTrack, turned_by
from springback.kernels.vectors import Vec
from springback.vehicle.arms.paths import ArmPath
from springback.vehicle.placed.settings import disc_axes

Array = np.ndarray[Any, np.dtype[np.float64]]
Cells = np.ndarray[Any, np.dtype[np.intp]]

#: Chosen: half the width and height of the main body [m], and of the mast on top of it.
BODY, BODY_HEIGHT, MAST = 0.055, 0.018, 0.07
#: Chosen: coils of a spring, their radius [m], and their distance from the rotor [m].
COILS, COIL_RADIUS, COIL_END = 7, 0.013, 0.03
#: Chosen: radius of the coils between arms, as a share of those in arms.
NEIGHBOUR_COILS = 0.6
CIRCLE = np.linspace(0.0, 2.0 * np.pi, 49)
HELIX = np.linspace(0.0, 1.0, 16 * COILS + 1)
EDGE_ON = 0.2
"""A face is not drawn if its normal's component in the plane of the view is below this."""
TOUCHED = 0.06
"""Chosen: a contact point that is farther from all planes is on a body [m]; mats are compressed."""
LEVEL = 0.05
"""Chosen: two vehicles closer than this from above are one above the other [m]."""
BESIDE, SAME = 1.0, 1e-9
"""Chosen: outlines are of bodies within this of the plane of a view; points that are one [m]."""


class ViewPlane(NamedTuple):
    """Plane of a view: axes to the right and up, and a point in the plane, world."""

    right: Array
    up: Array
    through: Array

    def outward(self) -> Array:
        """Direction to who looks at it."""
        return np.asarray(np.cross(self.right, self.up))

    def __call__(self, points: Array) -> Array:
        """Projection of world points, shape (..., 3), onto the plane, shape (..., 2) [m]."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


class BodyPlace(NamedTuple):
    """Where a moving obstacle is at one instant."""

    origin: Array  # where it was placed [m]
    position: Array  # of that point now [m]
    rotation: Array  # its axes to the world's, shape (3, 3)
    rod: Array  # line of the rod on which it hangs, shape (2 or 0, 3) [m]


class SceneInstant(NamedTuple):
    """State of a scene at one instant."""

    position: Array  # [m]
    rotation: Array  # body to world, shape (3, 3)
    lengths: Array  # of the arms [m]
    thrust: Array  # [N]
    force: Array  # of each contact [N], shape (contacts, 3)
    point: Array  # of application [m], shape (contacts, 3)
    bodies: tuple[BodyPlace, ...]  # of the obstacles that move
    bends: Array = np.zeros(0)  # ways of the second joints of arms [m]; empty where they have none

    def bend(self, j: int) -> float:
        """Way of the second joint of arm ``j``, from 0 [m]; 0 where it has none."""
        return float(self.bends[j]) if len(self.bends) else 0.0


def pose(scene: Scene, t: float) -> SceneInstant:
    """State at an instant, interpolated linearly between those of the scene.

    Args:
        scene: Of a flight.
        t: Time [s]; the state is constant before the first and after the last instant.
    """
    k = int(np.clip(np.searchsorted(scene.t, t, "right") - 1, 0, len(scene.t) - 2))
    share = float(np.clip((t - scene.t[k]) / max(scene.t[k + 1] - scene.t[k], 1e-12), 0.0, 1.0))

    def between(values: Array) -> Array:
        return np.asarray((1.0 - share) * values[k] + share * values[k + 1])

    near = k + (share > 0.5)
    touching = np.abs(scene.force[[k, k + 1]]).max(axis=2) > 0.0
    point = np.where(
        touching.all(axis=0)[:, None], between(scene.point),
        np.where(touching[0][:, None], scene.point[k], scene.point[k + 1]),
    )  # fmt: skip
    return SceneInstant(
        between(scene.position), _mixed(scene.attitude, k, share), between(scene.arm_length),
        scene.thrust[near], between(scene.force), point,
        tuple(_place(track, between(track.position), _mixed(track.attitude, k, share))
              for track in scene.bodies),
        between(scene.bends) if len(scene.bends) else np.zeros(0),
    )  # fmt: skip


def _mixed(attitude: Array, k: int, share: float) -> Array:
    """Rotation between two quaternions of a table, body to world, shape (3, 3)."""
    one, other = attitude[k], attitude[k + 1]
    return turned_by((1.0 - share) * one + share * np.where(one @ other < 0.0, -1.0, 1.0) * other)


def _place(track: BodyTrack, position: Array, turn: Array) -> BodyPlace:
    rod = np.array([track.rod, position]) if track.rod else np.zeros((0, 3))
    return BodyPlace(np.array(track.origin), position, turn, rod)


def at_instant(thing: Drawable, now: SceneInstant) -> Drawable:
    """An obstacle where it is at an instant."""
    if thing.track < 0:
        return thing
    place = now.bodies[thing.track]

    def moved(points: Array) -> Array:
        return np.asarray(place.position + (points - place.origin) @ place.rotation.T)

    if thing.vertices is not None:
        return thing._replace(vertices=moved(thing.vertices))
    turned = (place.rotation @ np.array(v) for v in (thing.normal, thing.across, thing.along))
    normal, across, along = (tuple(v.tolist()) for v in turned)
    centre = tuple(moved(np.array(thing.centre)).tolist())
    return thing._replace(centre=centre, normal=normal, across=across, along=along)


def views(scene: Scene, beside: Scene | None = None) -> tuple[ViewPlane, ViewPlane]:
    """Side view, with the first obstacle hit, or the other vehicle, on the right, and top view.

    Args:
        scene: Of a flight.
        beside: That of a second vehicle in its world.
    """
    right, through = np.array([1.0, 0.0, 0.0]), scene.position[0]
    if beside is not None:
        return _views_of_two(scene, beside)
    touched = np.flatnonzero(np.abs(scene.force).max(axis=(1, 2)) > 0.0)
    if len(touched):
        k = touched[0]
        j = int(np.argmax(np.abs(scene.force[k]).max(axis=1)))
        through = scene.position[k]
        toward = -_normal(scene, scene.point[k, j], scene.force[k, j])
        level = float(np.hypot(*toward[:2]))
        if level > 0.5:
            right = np.array([*(toward[:2] / level), 0.0])
    return _planes(right, through)


def _views_of_two(scene: Scene, beside: Scene) -> tuple[ViewPlane, ViewPlane]:
    """Views with the second vehicle on the right of the first at the first touch, or the start."""
    when = float(scene.t[0]) if scene.first_touch is None else scene.first_touch
    here, there = (pose(one, when).position for one in (scene, beside))
    away = there - here
    level = float(np.hypot(*away[:2]))
    right = np.array([*(away[:2] / level), 0.0]) if level > LEVEL else np.array([1.0, 0.0, 0.0])
    return _planes(right, here)


def _planes(right: Array, through: Array) -> tuple[ViewPlane, ViewPlane]:
    up = np.array([0.0, 0.0, 1.0])
    return ViewPlane(right, up, through), ViewPlane(right, np.cross(up, right), through)


def _normal(scene: Scene, point: Array, force: Array) -> Array:
    """Outward normal of the face that is touched at a point, else direction of the force.

    Of a built-in body it is against the way flown, as what moves sees it: the view is along its
    axes, not the cage's.
    """
    first = int(np.argmax(np.abs(scene.force).max(axis=(1, 2)) > 0.0))
    now = pose(scene, float(scene.t[first]))
    faces = [at_instant(d, now) for d in scene.obstacles if d.normal]
    away = [abs(float(np.dot(np.subtract(point, d.centre), d.normal))) for d in faces]
    if faces and (min(away) < TOUCHED or len(faces) == len(scene.obstacles)):
        return np.array(faces[int(np.argmin(away))].normal)
    way = np.diff(scene.position[max(first - 1, 0) :][:2], axis=0)[0]
    if scene.bodies:
        near = min(scene.bodies, key=lambda one: float(np.linalg.norm(one.position[first] - point)))
        way = way - np.diff(near.position[max(first - 1, 0) :][:2], axis=0)[0]
    way = way * [1.0, 1.0, 0.0]
    is_body = any(d.vertices is not None and d.normals is None for d in scene.obstacles)
    if is_body and (length := float(np.linalg.norm(way))) > 0.0:
        return np.asarray(-way / length)
    return np.asarray(force / np.linalg.norm(force))


# -- the robot ------------------------------------------------------------------------------------


def ring(centre: Array, radius: float, turn: Array) -> Array:
    """Circle around a point in the plane of x and y of some axes, shape (points, 3)."""
    return centre + radius * np.stack([np.cos(CIRCLE), np.sin(CIRCLE)], axis=1) @ turn[:, :2].T


class EndPlace(NamedTuple):
    """Where the end of an arm is at one instant, with its cage; world axes."""

    position: Array  # [m]
    rotation: Array  # of what is there, its axes to the world's, shape (3, 3)


class RotorPlace(NamedTuple):
    """Where a rotor is at one instant; world axes."""

    position: Array  # [m]
    thrust: Array  # direction of its thrust
    disc: Array  # circle that its blades sweep, shape (points, 3); empty at the ends of arms [m]


def ends(arms: Sequence[ArmShape], now: SceneInstant, *, free: bool = False) -> Array:
    """Ends of the arms, with their cages, at present or at free length, shape (arms, 3)."""
    levers = [path.end[0] for path in _paths(arms, now, free=free)]
    return np.asarray(now.position + np.array(levers) @ now.rotation.T)


def _paths(arms: Sequence[ArmShape], now: SceneInstant, *, free: bool) -> list[ArmPath]:
    """Of each arm its path at one instant."""
    lengths = np.array([arm.length for arm in arms]) if free else now.lengths
    bends = [0.0 if free else now.bend(j) for j in range(len(arms))]
    return [arm.path(lengths[[j]], np.array([bends[j]])) for j, arm in enumerate(arms)]


def end_places(
    arms: Sequence[ArmShape], now: SceneInstant, *, free: bool = False
) -> list[EndPlace]:
    """Ends of the arms as by `ends`, and how they are turned."""
    found, tips, paths = [], ends(arms, now, free=free), _paths(arms, now, free=free)
    for arm, tip, path in zip(arms, tips, paths, strict=True):
        turn = now.rotation
        if arm.joint:
            turn = turn @ path.turn[0]
        found.append(EndPlace(tip, turn))
    return found


def rotor_places(
    rotors: Sequence[RotorShape], ends_of_arms: Sequence[EndPlace], now: SceneInstant
) -> list[RotorPlace]:
    """Where the rotors are, by the ends of the arms."""
    found = []
    for one in rotors:
        there = EndPlace(now.position, now.rotation) if one.arm < 0 else ends_of_arms[one.arm]
        aim = now.rotation if one.level else there.rotation
        place = there.position + there.rotation @ np.array(one.offset)
        turn = aim @ np.array(disc_axes(Vec(*one.axis)))
        disc = ring(place, one.radius, turn)[: None if one.listed else 0]
        found.append(RotorPlace(place, turn[:, 2], disc))
    return found


def hinges(arms: Sequence[ArmShape], now: SceneInstant) -> Array:
    """Hinges of the arms that have one and can turn, world [m], shape (hinges, 3)."""
    pairs = zip(arms, now.lengths.tolist(), strict=True)
    anchors = [pin for arm, length in pairs if is_hinged(arm) for pin in arm.pivots(length)]
    return np.asarray(now.position + np.array(anchors).reshape(-1, 3) @ now.rotation.T)


def is_hinged(arm: ArmShape) -> bool:
    """True for an arm that turns about a hinge."""
    return arm.compliant and any(joint.is_hinge for joint in arm.joint + arm.second)


class LatchPlace(NamedTuple):
    """Where the two faces of a latch are at one instant; world [m]."""

    on_body: Array  # of a second joint: on what the first one carries
    on_arm: Array
    is_open: bool


def latches(arms: Sequence[ArmShape], now: SceneInstant) -> list[LatchPlace]:
    """Faces of the latches of arms: together while their joint is free."""
    found = []
    for j, (arm, length) in enumerate(zip(arms, now.lengths.tolist(), strict=True)):
        bend = now.bend(j)
        for latch in arm.latch:
            faces = arm.faces(latch, length, bend)
            held, moving = now.position + faces @ now.rotation.T
            is_open = latch.is_open(arm.length - length, bend)
            found.append(LatchPlace(held, moving, is_open))
    return found


def neighbour_lines(
    neighbours: Sequence[NeighbourShape], arms: Sequence[ArmShape], now: SceneInstant
) -> list[Array]:
    """Lines of the springs between the ends of arms, helices with straight ends, world [m]."""
    tips, found = ends(arms, now), []
    for one in neighbours:
        begin, end = tips[one.first], tips[one.second]
        length = float(np.linalg.norm(end - begin))
        along = (end - begin) / max(length, SAME)
        aside = np.cross(now.rotation[:, 2], along)
        straight = min(COIL_END, 0.25 * length)
        reach = straight + HELIX * (length - 2.0 * straight)
        coils = NEIGHBOUR_COILS * _coils(aside, now.rotation[:, 2])
        found.append(np.vstack([begin, begin + np.outer(reach, along) + coils, end]))
    return found


def arm_line(arm: ArmShape, now: SceneInstant, length: float, bend: float = 0.0) -> Array:
    """Line of an arm from the main body to its end: a helix for a spring on a slide.

    With a second joint, of some way [m], it is drawn by way of its hinges.
    """
    if arm.second:
        end = arm.path(np.array([length]), np.array([bend])).end[0]
        places = [np.zeros(3), *(arm.pivots(length) if arm.compliant else ()), end]
        return np.asarray(now.position + np.array(places) @ now.rotation.T)
    if arm.joint:
        return _line_on_joint(arm, arm.joint[0], now, length)
    along = now.rotation @ np.array(arm.direction)
    if not arm.compliant:
        return now.position + np.outer([0.0, length], along)
    across = np.cross(now.rotation[:, 2], along)
    reach = BODY + HELIX * (length - BODY - COIL_END)
    spiral = now.position + np.outer(reach, along) + _coils(across, now.rotation[:, 2])
    return np.vstack([now.position, spiral, now.position + length * along])


def _line_on_joint(arm: ArmShape, joint: JointShape, now: SceneInstant, length: float) -> Array:
    """Line of an arm on a joint: by way of its hinge, or of the seat of its spring."""
    there = arm.path(np.array([length]))
    begin, end = np.zeros(3), there.end[0]
    places = [begin, end] if not arm.compliant else [begin, np.array(joint.anchor), end]
    if arm.compliant and not joint.is_hinge:
        _, seat, _ = places
        along, aside = there.direction[0], np.array(joint.path.inward)
        reach = HELIX * (float((end - seat) @ along) - COIL_END)
        spiral = seat + np.outer(reach, along) + _coils(np.cross(aside, along), aside)
        places = [begin, *spiral, end]
    return np.asarray(now.position + np.array(places) @ now.rotation.T)


def _coils(across: Array, up: Array) -> Array:
    """Coils of a spring about its axis, shape (points, 3) [m]."""
    turn = 2.0 * np.pi * COILS * HELIX
    around = np.outer(np.sin(turn), across) + np.outer(1.0 - np.cos(turn), up)
    return np.asarray(COIL_RADIUS * around)


def body_outline(now: SceneInstant) -> tuple[Array, Array]:
    """Upper and lower rims of the main body, shape (points, 3) each."""
    rim, lift = ring(now.position, BODY, now.rotation), BODY_HEIGHT * now.rotation[:, 2]
    return rim + lift, rim - lift


def hull_outline(hull: HullShape, now: SceneInstant, view: ViewPlane) -> Array:
    """Outlines of the main body's hulls in the plane of a view, shape (points, 2).

    Rows of NaN part them.
    """
    if hull.meshes:
        return outlines_of(hull.meshes, now.position, now.rotation, view)
    centre = view(now.position + now.rotation @ np.array(hull.centre))
    return centre + hull.radius * np.stack([np.cos(CIRCLE), np.sin(CIRCLE)], axis=1)


def outlines_of(meshes: Sequence[HullMesh], origin: Array, turn: Array, view: ViewPlane) -> Array:
    """Outlines of hulls in the plane of a view, with a row of NaN behind each, shape (points, 2).

    A ring is outlined as the plate that it is around.

    Args:
        meshes: Of the hulls.
        origin: What they are fixed to, world [m].
        turn: Axes of that, to the world's.
        view: The plane.
    """
    found = [np.zeros((0, 2))]
    for mesh in meshes:
        flat = view(origin + mesh.vertices @ turn.T)
        loop = ConvexHull(flat).vertices
        found += [flat[[*loop, loop[0]]], np.full((1, 2), np.nan)]
    return np.vstack(found)


# -- obstacles ------------------------------------------------------------------------------------


def half_plane(thing: Drawable, view: ViewPlane, depth: float, size: float) -> Array | None:
    """Quadrangle behind a face in the plane of a view [m]; None if the face is seen flat on.

    Args:
        thing: Rectangle, with a normal.
        view: The plane.
        depth: Distance behind the face at which it begins [m].
        size: Half the length of its side, and its depth [m].
    """
    normal = np.array(thing.normal)
    flat = view(normal)
    long = float(np.linalg.norm(flat))
    if long < EDGE_ON:
        return None
    flat = flat / long
    away = (float(normal @ np.subtract(thing.centre, view.through)) - depth) / long
    foot = view(view.through) + away * flat
    side = size * np.array([-flat[1], flat[0]])
    return np.array(
        [foot - side, foot + side, foot + side - size * flat, foot - side - size * flat]
    )


def plane_section(thing: Drawable, view: ViewPlane) -> Array:
    """Section of a mesh with the plane of a view, shape (pieces, 2, 2) [m].

    The body is on the left of each piece.
    """
    if thing.vertices is None or thing.triangles is None:
        return np.zeros((0, 2, 2))
    out = (thing.vertices - view.through) @ view.outward()
    height, place = out[thing.triangles], view(thing.vertices)[thing.triangles]
    crossed = np.flatnonzero((height.min(axis=1) < 0.0) & (height.max(axis=1) >= 0.0))
    pieces = []
    for h, p in zip(height[crossed], place[crossed], strict=True):
        sides = [(a, b) for a, b in ((0, 1), (1, 2), (2, 0)) if (h[a] < 0.0) != (h[b] < 0.0)]
        sides.sort(key=lambda side: h[side[0]] < 0.0)
        pieces.append([p[a] + h[a] / (h[a] - h[b]) * (p[b] - p[a]) for a, b in sides])
    return np.array(pieces).reshape(-1, 2, 2)


def section_outlines(thing: Drawable, view: ViewPlane) -> list[Array]:
    """Section of a closed mesh with the plane of a view as closed outlines [m]."""
    pieces = plane_section(thing, view)
    if not len(pieces):
        return []
    cells = np.round(pieces.reshape(-1, 2) / SAME).astype(np.int64)
    places, number = np.unique(cells, axis=0, return_inverse=True)
    ways = number.reshape(-1, 2)
    loops = _loops(ways[ways[:, 0] != ways[:, 1]])
    return [SAME * places[loop].astype(float) for loop in loops]


def silhouette(thing: Drawable, view: ViewPlane) -> list[Array]:
    """Outlines in a view of those bodies of a mesh that are near its plane [m].

    The outlines of overlapping parts wind in the same sense, those of openings in the other.
    """
    if thing.vertices is None or thing.triangles is None:
        return []
    flat, cells, count = view(thing.vertices), thing.triangles, len(thing.vertices)
    a, b, c = (flat[cells[:, k]] for k in range(3))
    u, v = b - a, c - a
    near = _near_bodies(cells, (thing.vertices - view.through) @ view.outward())
    front = cells[near & (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] > 0.0)]
    ways = np.concatenate([front[:, [k, (k + 1) % 3]] for k in range(3)])
    there, back = ways @ [count, 1], ways @ [1, count]
    return [flat[loop] for loop in _loops(ways[~np.isin(there, back)])]


def _near_bodies(cells: Cells, height: Array) -> Any:
    """True for the triangles of bodies that are near a plane.

    Args:
        cells: Triangles.
        height: Of the vertices above the plane [m].
    """
    ways = np.concatenate([cells[:, [0, 1]], cells[:, [1, 2]]])
    pairs = (np.ones(len(ways)), tuple(ways.T))
    _, body = connected_components(coo_matrix(pairs, shape=(len(height),) * 2), directed=False)
    low, high = np.full(body.max() + 1, np.inf), np.full(body.max() + 1, -np.inf)
    np.minimum.at(low, body, height)
    np.maximum.at(high, body, height)
    return ((low < BESIDE) & (high > -BESIDE))[body[cells[:, 0]]]


def _loops(ways: Cells) -> list[list[int]]:
    """Closed loops of directed edges, each an origin and an end."""
    after: dict[int, list[int]] = {}
    for origin, end in ways.tolist():
        after.setdefault(origin, []).append(end)
    loops = []
    for origin in after:
        while after[origin]:
            loop = [origin]
            while (ends := after.get(loop[-1])) and (len(loop) == 1 or loop[-1] != origin):
                loop.append(ends.pop())
            loops.append(loop)
    return loops
