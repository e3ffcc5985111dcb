"""Hulls of a vehicle: user input, and the table of numbers that contact reads.

A hull is a body without mass, fixed to the main body or to the end of an arm.  All but rings are
*rounded*: the convex hull of some points, made larger by a radius on all sides.  A sphere has one
point, a capsule two, a box eight.  Several hulls on one part are one row of blocks in a table
(`springback.vehicle.state.CompoundHull`).
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use
from pydantic import BeforeValidator, Field, model_validator

from springback.errors import shown_value
from springback.frames import attitude_from_euler
from springback.kernels.routines import NumberTable, number_at
from springback.kernels.vectors import Quat, Vec, rotation
from springback.quantities import Angle, Length, Triple, Unit
from springback.settings import Settings, naming, none_for_false, problem
from springback.vehicle.force_laws import (
    HULL_CURVE,
    HULL_SURFACE,
    REMEMBERING,
    RIGID,
    HullSurface,
)
from springback.vehicle.mass.bearings import AxisBearing, Bearings, Gimbal
from springback.vehicle.state import CompoundHull, Shell, Sphere

Array = np.ndarray[Any, np.dtype[np.float64]]

#: A table begins with the number of its blocks, and where each begins.
BLOCKS = 0
#: Columns of a block: kind, radius, centre, the three axes in body axes, surface, middle and radius
#: of a sphere around it, numbers of points and faces, and where these begin.
KIND, RADIUS, CENTRE, AXES, SURFACE, MIDDLE, AROUND = 0, 1, 2, 5, 14, 24, 27
POINTS, FACES_OF_HULL, POINTS_AT, FACES_AT, BLOCK = 28, 29, 30, 31, 32
#: Kinds: all around one point, a circle, or around several points.
BALL, CIRCLE, ROUNDED = 0.0, 1.0, 2.0
#: Numbers of a point: place, where its neighbours are listed, and how many there are.
POINT = 5
#: Numbers of a face: outward normal, two axes along it, middle, radius of a circle around it, where
#: its corners are listed, and how many there are.
FACE = 15
#: Most points of a hull, and most hulls of a part (chosen).
MOST_POINTS, MOST_HULLS = 256, 32
#: Faces and edges whose directions differ by less are one [1] (chosen: rounding).
SAME = 1e-9
#: Least thickness of points, over their greatest distance (chosen: less is a plane).
THINNEST = 1e-6

Place = Annotated[Triple, Unit("m")]
NotNegative = Annotated[float, Unit("m", least=0.0)]


def owner(value: Any) -> str | int:
    """Validate what a hull is fixed to: the body, or an arm by its number from 1."""
    if value == "body":
        return "body"
    if isinstance(value, int) and not isinstance(value, bool) and value >= 1:
        return value
    raise problem(f'must be "body", or the number of an arm from 1 (got {shown_value(value)})')


class HullFace(NamedTuple):
    """A flat face of a hull before it is rounded."""

    normal: Array  # out of the hull
    corners: list[int]  # counterclockwise around the normal


class HullForm(NamedTuple):
    """Geometry of a hull; body axes, from the main body or the end of its arm [m]."""

    kind: float  # BALL, CIRCLE or ROUNDED
    radius: float
    centre: Array
    axes: Array  # of a circle, one a row, in body axes
    points: Array  # shape (points, 3); empty for a circle
    faces: list[HullFace]

    def middle(self) -> Array:
        """Middle of a sphere around it."""
        if not len(self.points):
            return self.centre
        return np.asarray(0.5 * (self.points.min(axis=0) + self.points.max(axis=0)))

    def around(self) -> float:
        """Radius of a sphere around it [m]."""
        if not len(self.points):
            return self.radius
        away = np.linalg.norm(self.points - self.middle(), axis=1)
        return float(away.max()) + self.radius

    def edges(self) -> set[tuple[int, int]]:
        """Pairs of points that are joined, the lower number first."""
        if len(self.points) == 2:
            return {(0, 1)}
        found = set()
        for face in self.faces:
            for a, b in zip(face.corners, face.corners[1:] + face.corners[:1], strict=True):
                found.add((min(a, b), max(a, b)))
        return found


class _Hull(Settings):
    """What all hulls have."""

    on: Annotated[str | int, BeforeValidator(owner)] = "body"
    """`body`, or the number of the arm, from 1, to whose end it is fixed, moving with it."""
    surface: HullSurface | None = None
    """Surface; without one the hull is rigid, and the law of contact is the obstacle's alone."""

    @property
    def remembers(self) -> bool:
        """True if its surface has a memory."""
        return self.surface is not None and self.surface.law in REMEMBERING

    @property
    def bearings(self) -> Bearings | None:
        """Those in which it turns by itself about the main body, if it does."""
        return None

    def in_bearings(self, touching: CompoundHull) -> Shell | CompoundHull:
        """The hull as it touches, in its bearings if it has any."""
        return touching

    @abstractmethod
    def form(self) -> HullForm:
        """Its geometry."""


def _around(points: Sequence[Any] | Array, radius: float, faces: list[HullFace]) -> HullForm:
    """Form around some points."""
    at = np.array(points, dtype=np.float64)
    kind = BALL if len(at) == 1 else ROUNDED
    return HullForm(kind, radius, at[0], np.eye(3), at, faces)


class SphereHull(_Hull):
    """A sphere."""

    type: Literal["sphere"]
    position: Place = (0.0, 0.0, 0.0)
    radius: Length
    gimbal: Annotated[Gimbal | None, BeforeValidator(none_for_false)] = None
    """Bearings in which the sphere turns by itself; it is then the only hull of the main body."""

    @property
    def bearings(self) -> Gimbal | None:
        """Those in which it turns."""
        return self.gimbal

    def in_bearings(self, touching: CompoundHull) -> Shell | CompoundHull:
        """As it touches, in its gimbal if it has one."""
        if (of := self.gimbal) is None:
            return touching
        inertia = 2.0 / 3.0 * of.shell_mass * self.radius * self.radius
        centre = Vec(*self.position)
        return Shell(touching, centre, self.radius, inertia, of.damping, of.friction)

    def form(self) -> HullForm:
        """Its geometry."""
        return _around([self.position], self.radius, [])


class RingHull(_Hull):
    """A circle of thin rod, at any tilt: a guard around a propeller, a roll cage's hoop."""

    type: Literal["ring"]
    position: Place = (0.0, 0.0, 0.0)
    axis: Annotated[Triple, Unit("")] = (0.0, 0.0, 1.0)
    """Direction normal to its plane, of any length."""
    radius: Length
    bearing: AxisBearing | None = None
    """Bearing in which the ring turns about its axis; it is then the only hull of the main body."""

    @property
    def bearings(self) -> AxisBearing | None:
        """Those in which it turns."""
        return self.bearing

    def in_bearings(self, touching: CompoundHull) -> Shell | CompoundHull:
        """As it touches, in its bearing if it has one."""
        if (of := self.bearing) is None:
            return touching
        centre, axis = Vec(*self.position), Vec(*_axes_along(np.array(self.axis))[2].tolist())
        inertia = of.ring_mass * self.radius * self.radius
        return Shell(touching, centre, self.radius, inertia, of.damping, of.friction, (axis,))

    @model_validator(mode="after")
    def _has_direction(self) -> RingHull:
        if not math.hypot(*self.axis) > 0.0:
            raise problem(f"must not be zero (got {shown_value(list(self.axis))})", "axis")
        return self

    def form(self) -> HullForm:
        """Its geometry."""
        axes = _axes_along(np.array(self.axis))
        return HullForm(CIRCLE, self.radius, np.array(self.position), axes, np.zeros((0, 3)), [])


class CapsuleHull(_Hull):
    """A rod with round ends: a skid, a leg, a battery."""

    type: Literal["capsule"]
    start: Place
    """One end of its axis."""
    end: Place
    """The other end."""
    radius: Length

    @model_validator(mode="after")
    def _has_length(self) -> CapsuleHull:
        if self.start == self.end:
            raise problem("must differ from start; for a ball use type sphere", "end")
        return self

    def form(self) -> HullForm:
        """Its geometry."""
        return _around([self.start, self.end], self.radius, [])


class BoxHull(_Hull):
    """A box: a frame, a battery, electronics in a case."""

    type: Literal["box"]
    position: Place = (0.0, 0.0, 0.0)
    """Position of its centre."""
    size: Annotated[Triple, Unit("m", above=0.0)]
    """Full lengths along its own x, y and z."""
    edge_radius: NotNegative = 0.0
    """Radius of its edges, within its size."""
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0

    @model_validator(mode="after")
    def _is_rounded(self) -> BoxHull:
        if not self.edge_radius < 0.5 * min(self.size):
            raise problem(
                f"must be less than {0.5 * min(self.size):g} m, half of the shortest side "
                f"(got {self.edge_radius:g} m)",
                "edge_radius",
            )
        return self

    def form(self) -> HullForm:
        """Its geometry."""
        turn = np.array(rotation(Quat(*attitude_from_euler(self.roll, self.pitch, self.yaw))))
        half = [0.5 * length - self.edge_radius for length in self.size]
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        points = np.array(self.position) + (signs * half) @ turn.T
        faces = []
        for axis in range(3):
            for sign in (-1, 1):
                normal = sign * turn[:, axis]
                corners = [k for k in range(8) if signs[k, axis] == sign]
                faces.append(HullFace(normal, _in_order(points, corners, normal)))
        return _around(points, self.edge_radius, faces)


class PointsHull(_Hull):
    """The convex hull of some points, rounded if a radius is given."""

    type: Literal["points"]
    points: tuple[Any, ...]
    """At least four points that are not in one plane; those inside do not count [m]."""
    radius: NotNegative = 0.0
    """Radius by which the hull of the points is enlarged on all sides."""

    @model_validator(mode="before")
    @classmethod
    def _numbers(cls, given: Any) -> Any:
        if isinstance(given, dict) and isinstance(given.get("points"), list | tuple):
            unit, found = Unit("m"), []
            for k, point in enumerate(given["points"]):
                with naming(f"points[{k}]"):
                    found.append(unit.triple(point))
            return {**given, "points": tuple(found)}
        return given

    @model_validator(mode="after")
    def _is_solid(self) -> PointsHull:
        count = len(self.points)
        if not 4 <= count <= MOST_POINTS:
            raise problem(
                f"must be at least 4 points and at most {MOST_POINTS} (got {count})", "points"
            )
        self.form()
        return self

    def form(self) -> HullForm:
        """Its geometry."""
        at = np.array(self.points, dtype=np.float64)
        centred = at - at.mean(axis=0)
        thickness = np.linalg.svd(centred, compute_uv=False)
        if not thickness[2] > THINNEST * thickness[0]:
            raise problem(
                f"must not all be in one plane (got {len(at)} points, {thickness[2]:.3g} m thick)",
                "points",
            )
        try:
            found = scipy.spatial.ConvexHull(at)
        except scipy.spatial.QhullError:
            raise problem("make no body that has an inside", "points") from None
        kept = [int(k) for k in found.vertices]
        number = {k: i for i, k in enumerate(kept)}
        scale = float(np.abs(centred).max())
        planes: list[tuple[Array, float]] = []
        for row in found.equations:
            normal, offset = row[:3], float(row[3])
            if not any(
                float(n @ normal) > 1.0 - SAME and abs(d - offset) < SAME * scale for n, d in planes
            ):
                planes.append((normal, offset))
        faces = []
        for normal, offset in planes:
            flat = [k for k in kept if abs(float(at[k] @ normal) + offset) < 10.0 * SAME * scale]
            corners = [number[k] for k in _in_order(at, flat, normal)]
            faces.append(HullFace(normal, corners))
        return _around(at[kept], self.radius, faces)


HullSettings = Annotated[
    SphereHull | RingHull | CapsuleHull | BoxHull | PointsHull, Field(discriminator="type")
]


def _axes_along(direction: Array) -> Array:
    """Right-handed axes, one a row, of which the third is along a direction."""
    z = direction / np.linalg.norm(direction)
    helper = np.eye(3)[0 if abs(z[0]) < 0.9 else 1]
    x = helper - (helper @ z) * z
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def _in_order(points: Array, corners: list[int], normal: Array) -> list[int]:
    """Corners of a convex face counterclockwise around its outward normal."""
    x, y, _ = _axes_along(normal)
    away = points[corners] - points[corners].mean(axis=0)
    angles = np.arctan2(away @ y, away @ x)
    return [corners[k] for k in np.argsort(angles)]


def compound_hull(hulls: Sequence[_Hull]) -> CompoundHull:
    """Hulls of one part of a vehicle as numbers for contact; at least one.

    Raises:
        The problem, if there are too many.
    """
    if len(hulls) > MOST_HULLS:
        raise problem(f"must be at most {MOST_HULLS} on one part (got {len(hulls)})", "hulls")
    forms = [one.form() for one in hulls]
    numbers: list[float] = [float(len(hulls)), *(0.0 for _ in hulls)]
    curves: dict[int, NumberTable] = {}
    for k, (one, form) in enumerate(zip(hulls, forms, strict=True)):
        numbers[1 + k] = float(len(numbers))
        surface = RIGID if one.surface is None else one.surface.numbers()
        if isinstance(curve := surface[HULL_CURVE], NumberTable):
            curves[len(numbers) + SURFACE + HULL_CURVE] = curve
        numbers += _block(form, surface, len(numbers))
    low = np.min([form.middle() - form.around() for form in forms], axis=0)
    high = np.max([form.middle() + form.around() for form in forms], axis=0)
    middle = 0.5 * (low + high)
    radius = max(float(np.linalg.norm(f.middle() - middle)) + f.around() for f in forms)
    return CompoundHull(NumberTable(np.array(numbers), curves), Vec(*middle.tolist()), radius)


def hull_reach(hull: Sphere | CompoundHull | Shell, direction: Vec) -> float:
    """Largest distance of a hull's points along a unit vector, from what it is fixed to [m].

    A hull without parts, which an arm may have, reaches nowhere.
    """
    if isinstance(hull, Sphere | Shell):
        found: float = direction @ hull.centre + hull.radius
        return found
    table, n = hull.table, direction
    reached = -math.inf
    for k in range(int(number_at(table, BLOCKS))):
        block = int(number_at(table, 1 + k))
        kind, radius = number_at(table, block + KIND), number_at(table, block + RADIUS)
        places, ahead = [block + CENTRE], radius
        if kind == CIRCLE:
            axis = Vec(*(number_at(table, block + AXES + 6 + i) for i in range(3)))
            ahead = radius * math.sqrt(max(1.0 - (axis @ n) ** 2, 0.0))
        elif kind == ROUNDED:
            first = int(number_at(table, block + POINTS_AT))
            places = [first + POINT * i for i in range(int(number_at(table, block + POINTS)))]
        for at in places:
            point = Vec(*(number_at(table, at + i) for i in range(3)))
            reached = max(reached, n @ point + ahead)
    return reached


def no_hull() -> CompoundHull:
    """Hull of an arm that has none, beside others that have."""
    return CompoundHull(NumberTable(np.zeros(1)), Vec(0.0, 0.0, 0.0), 0.0)


def _block(form: HullForm, surface: list[float], begin: int) -> list[float]:
    """Numbers of one hull, which begin at a position of the table."""
    block = [0.0] * BLOCK
    block[KIND], block[RADIUS] = form.kind, form.radius
    block[CENTRE : CENTRE + 3] = form.centre.tolist()
    block[AXES : AXES + 9] = form.axes.ravel().tolist()
    block[SURFACE : SURFACE + HULL_SURFACE] = surface
    block[MIDDLE : MIDDLE + 3], block[AROUND] = form.middle().tolist(), form.around()
    if form.kind != ROUNDED:
        return block
    neighbours: list[list[int]] = [[] for _ in form.points]
    for a, b in sorted(form.edges()):
        neighbours[a].append(b)
        neighbours[b].append(a)
    points_at = begin + BLOCK
    listed_at = points_at + POINT * len(form.points)
    faces_at = listed_at + sum(map(len, neighbours))
    corners_at = faces_at + FACE * len(form.faces)
    block[POINTS], block[FACES_OF_HULL] = float(len(form.points)), float(len(form.faces))
    block[POINTS_AT], block[FACES_AT] = float(points_at), float(faces_at)
    for place, joined in zip(form.points, neighbours, strict=True):
        block += [*place.tolist(), float(listed_at), float(len(joined))]
        listed_at += len(joined)
    block += [float(k) for joined in neighbours for k in joined]
    for face in form.faces:
        at = form.points[face.corners]
        along, middle = at[1] - at[0], at.mean(axis=0)
        x = along / np.linalg.norm(along)
        y = np.cross(face.normal, x)
        reach = float(np.linalg.norm(at - middle, axis=1).max())
        block += [*face.normal.tolist(), *x.tolist(), *y.tolist(), *middle.tolist(), reach]
        block += [float(corners_at), float(len(face.corners))]
        corners_at += len(face.corners) + 1
    for face in form.faces:  # behind each list of corners, where the points are
        block += [*(float(k) for k in face.corners), float(points_at)]
    return block
