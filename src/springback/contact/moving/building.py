"""Moving obstacles, built from their settings."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.moving.bodies import (
    FREE,
    GIVEN,
    HINGED,
    NO_BODY,
    PIVOTED,
    GivenPath,
    MovingBody,
)
from springback.contact.moving.mass_properties import mass_properties
from springback.contact.moving.parameters import (
    ConstantMotion,
    FreeMotion,
    HingeMotion,
    PendulumMotion,
    SineMotion,
    TableMotion,
)
from springback.contact.moving.scene import MovingScene, scene_with
from springback.contact.scene.faces import FACES, SolidScene
from springback.contact.scene.solids import CAPSULE, FRUSTUM, GRID, HALF_SPACE, HEIGHTS, TORUS
from springback.contact.scene.table import ENDLESS, Solid, scene_of
from springback.contact.shapes import SolidPart, SolidShape
from springback.contact.surfaces import AnyExponent, Surface
from springback.kernels.routines import NumberTable
from springback.kernels.vectors import Mat3, Quat, Vec
from springback.settings import naming, problem
from springback.vehicle.state import BodyState

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Numbers of moving obstacles that are structures of their own to the compiler: others are filled
#: up with bodies that touch nothing.  With many, contacts always have a memory, as they have where
#: fewer move in a world whose surfaces have one: so there are two structures, not four.
FEW, MANY = 2, 8
#: Spheres with which a body touches the world: their flags are bits of one number.
MOST_POINTS = 52 // FACES
#: Points around each rim.
RIM = 6
_NONE = Vec(0.0, 0.0, 0.0)


class MovingShape(NamedTuple):
    """An obstacle that moves."""

    parts: list[SolidPart]  # its solids where they are at time 0
    motion: Any
    obstacle: int  # its number in the world, from 0

    @property
    def solids(self) -> list[SolidShape]:
        """Its solids, without surfaces."""
        return [part.body for part in self.parts]

    @property
    def surfaces(self) -> list[Surface]:
        """Surface of each solid."""
        return [part.surface.surface(AnyExponent, in_scene=True) for part in self.parts]


def moving_scene(still: SolidScene, moving: Sequence[MovingShape]) -> MovingScene:
    """World of a scene and some moving obstacles.

    Raises:
        The problem, with its key.
    """
    if len(moving) > MANY:
        raise problem(
            f"must be left out: at most {MANY} obstacles can move (got {len(moving)})",
            f"world.obstacles[{moving[MANY].obstacle}].motion",
        )
    bodies = []
    for number, shape in enumerate(moving):
        with naming(f"world.obstacles[{shape.obstacle}].motion"):
            bodies.append(_body(number, shape))
    many = len(bodies) > FEW or still.bristles > 0.0 or still.remembers > 0.0
    bodies += [_absent(number) for number in range(len(bodies), MANY if many else FEW)]
    return scene_with(still._replace(memory=1.0 if many else 0.0), tuple(bodies))


def _scene_about(shape: MovingShape, origin: Array) -> SolidScene:
    surfaces = list(dict.fromkeys(shape.surfaces))
    solids = [
        Solid(*body._replace(centre=body.centre - origin), surfaces.index(surface), 0.0, 0)
        for body, surface in zip(shape.solids, shape.surfaces, strict=True)
    ]
    return scene_of(solids, surfaces)


def _state(**known: Any) -> BodyState:
    return BodyState(_NONE, Quat(1.0, 0.0, 0.0, 0.0), _NONE, _NONE)._replace(**known)


def _absent(number: int) -> MovingBody:
    return NO_BODY._replace(number=float(number))


def _body(number: int, shape: MovingShape) -> MovingBody:
    motion = shape.motion
    if isinstance(motion, FreeMotion | PendulumMotion | HingeMotion):
        body = _with_mass(shape)
    else:
        body = _as_given(shape)
    return body._replace(number=float(number), obstacle=float(shape.obstacle))


def bodies_of(
    kind: float,
    scenes: Sequence[SolidScene | None],
    reach: Sequence[float],
    mobility: Sequence[float],
    start: Sequence[BodyState],
) -> tuple[MovingBody, ...]:
    """Moving obstacles of one kind, whose motion is known elsewhere.

    Args:
        kind: Of motion, see `springback.contact.moving.bodies`.
        scenes: Their solids, in their own axes; None if nothing touches one.
        reach: See `MovingBody`, as for the others.
        mobility: Likewise.
        start: Likewise.
    """
    given = enumerate(zip(scenes, reach, mobility, start, strict=True))
    return tuple(
        NO_BODY._replace(
            scene=scene.table if scene else 0.0,
            kind=kind,
            number=float(k),
            reach=far,
            mobility=give,
            start=first,
        )
        for k, (scene, far, give, first) in given
    )


# -- as prescribed --------------------------------------------------------------------------------


def _as_given(shape: MovingShape) -> MovingBody:
    motion = shape.motion
    origin = shape.solids[0].centre if motion.about is None else np.array(motion.about)
    if motion.about is None and (known := mass_properties(shape.solids)) is not None:
        origin = known.centre if math.isfinite(known.volume) else origin
    reach, path = _reach(shape.solids, origin), _path(motion, Vec(*origin.tolist()))
    turns = path.turning or path.swing or (isinstance(motion, TableMotion) and motion.angle)
    if reach >= ENDLESS and turns:
        raise problem("cannot turn an obstacle without end")
    return NO_BODY._replace(
        scene=_scene_about(shape, origin).table, kind=GIVEN, axis=_unit(motion.axis), path=path,
        reach=reach,
    )  # fmt: skip


def _path(motion: ConstantMotion | SineMotion | TableMotion, start: Vec) -> GivenPath:
    path = NO_BODY.path._replace(start=start)
    if isinstance(motion, ConstantMotion):
        return path._replace(velocity=Vec(*motion.velocity), turning=motion.turning)
    if isinstance(motion, SineMotion):
        rate = 2.0 * math.pi * motion.frequency
        return path._replace(
            amplitude=Vec(*motion.amplitude), swing=motion.swing, rate=rate, phase=motion.phase
        )
    return path._replace(table=_spline(motion))


def _spline(motion: TableMotion) -> NumberTable:
    """Table of cubic splines; see `springback.contact.moving.bodies.spline_point`."""
    count = len(motion.time)
    values = np.zeros((count, 4))
    if motion.position is not None:
        values[:, :3] = motion.position
    if motion.angle is not None:
        values[:, 3] = motion.angle
    spline = scipy.interpolate.CubicSpline(motion.time, values, bc_type="clamped")
    pieces = np.moveaxis(spline.c, 0, 2)  # (piece, channel, coefficient)
    return NumberTable(np.concatenate([[float(count)], motion.time, pieces.ravel()]))


# -- with mass ------------------------------------------------------------------------------------


def _with_mass(shape: MovingShape) -> MovingBody:
    motion = shape.motion
    if any(solid.kind in (GRID, HEIGHTS) for solid in shape.solids):
        raise problem(
            "must be constant, sine or table for a form from a file: what it touches with is not "
            f"known (got {motion.type!r})",
            "type",
        )
    known = None if _is_endless(shape.solids) else mass_properties(shape.solids)
    if _is_endless(shape.solids):
        raise problem(
            "must be constant, sine or table for an obstacle without an end, which has no mass "
            f"(got {motion.type!r})",
            "type",
        )
    if known is None and motion.inertia is None:
        raise problem("is missing; that of this shape is not known", "inertia")
    origin = shape.solids[0].centre if known is None else known.centre
    if motion.inertia is not None:
        a, b, c = motion.inertia
        if max(a, b, c) > a + b + c - max(a, b, c):
            raise problem(
                "must have no moment larger than the sum of the two others (got "
                f"{a:g}, {b:g} and {c:g} kg m²)",
                "inertia",
            )
        inertia = np.diag(motion.inertia)
    else:
        assert known is not None
        inertia = motion.mass / known.volume * known.inertia
    reach = _reach(shape.solids, origin)
    body = NO_BODY._replace(
        scene=_scene_about(shape, origin).table, mass=motion.mass, reach=reach,
        points=NumberTable(_points(shape.solids, origin)),
    )  # fmt: skip
    if isinstance(motion, FreeMotion):
        return _free(body, motion, origin, inertia, _corners(shape.solids))
    return _pivoted(body, motion, origin, inertia, _corners(shape.solids))


def _matrix(rows: Any) -> Mat3:
    return Mat3(*(Vec(*row) for row in rows.tolist()))


def _free(
    body: MovingBody, motion: FreeMotion, origin: Array, inertia: Array, corners: Array
) -> MovingBody:
    inverse = np.linalg.inv(inertia)
    return body._replace(
        kind=FREE, inertia=_matrix(inertia), inverse=_matrix(inverse),
        mobility=1.0 / motion.mass + _turned_by_impulse(corners - origin, inverse),
        start=_state(
            position=Vec(*origin.tolist()), velocity=Vec(*motion.velocity),
            angular_velocity=Vec(*motion.angular_velocity),
        ),
    )  # fmt: skip


def _pivoted(
    body: MovingBody, motion: PendulumMotion | HingeMotion, origin: Array, inertia: Array,
    corners: Array,
) -> MovingBody:  # fmt: skip
    lever, far = origin - np.array(motion.pivot), corners - np.array(motion.pivot)
    about = inertia + motion.mass * (lever @ lever * np.eye(3) - np.outer(lever, lever))
    inverse = np.linalg.inv(about)
    turned = body._replace(
        kind=PIVOTED, inertia=_matrix(about), inverse=_matrix(inverse),
        pivot=Vec(*motion.pivot), lever=Vec(*lever.tolist()),
        mobility=_turned_by_impulse(far, inverse),
    )  # fmt: skip
    if isinstance(motion, PendulumMotion):
        if not lever @ lever > 0.0:
            raise problem("must not be the centre of mass", "pivot")
        return turned._replace(
            damping=motion.damping / float(np.linalg.eigvalsh(about)[-1]),
            start=_state(angular_velocity=Vec(*motion.angular_velocity)),
        )
    axis = _unit(motion.axis)
    around = float(np.array(axis) @ about @ np.array(axis))
    swept = float((np.cross(np.array(axis), far) ** 2).sum(axis=1).max())
    return turned._replace(
        kind=HINGED, axis=axis, closer=motion.closer, damping=motion.damping, rest=motion.rest,
        lowest=motion.lowest, highest=motion.highest, stop=motion.stop_stiffness,
        mobility=swept / around, start=_state(angular_velocity=motion.turning * axis),
    )  # fmt: skip


def _unit(direction: Sequence[float]) -> Vec:
    length = math.hypot(*direction)
    return Vec(*(part / length for part in direction))


def _is_endless(solids: Sequence[SolidShape]) -> bool:
    return any(s.kind == HALF_SPACE or max(s.sizes) >= ENDLESS for s in solids)


def _reach(solids: Sequence[SolidShape], origin: Array) -> float:
    """Distance of the farthest point from the origin [m]; `ENDLESS` or more without an end."""
    far = []
    for solid in solids:
        if solid.kind == HALF_SPACE:
            return 1e3 * ENDLESS
        half = Solid(*solid, 0, 0.0, 0).half_lengths()
        far.append(float(np.linalg.norm(solid.centre - origin)) + math.hypot(*half))
    return max(far)


def _corners(solids: Sequence[SolidShape]) -> Array:
    """Corners of the boxes around some solids [m], shape (corners, 3)."""
    signs = np.array(np.meshgrid(*[(-1.0, 1.0)] * 3)).reshape(3, -1).T
    return np.concatenate(
        [s.centre + signs * Solid(*s, 0, 0.0, 0).half_lengths() @ s.axes for s in solids]
    )


def _turned_by_impulse(points: Array, inverse: Any) -> float:
    """Upper bound of the speed that an impulse gives its own point by turning a body [1/kg].

    The largest eigenvalue of [p]ᵀ I⁻¹ [p], with p ^ n = [p] n, is convex in p, and so largest at a
    corner.  A bound by the farthest point and the least moment of inertia would be ten thousand
    times as much for a rod.

    Args:
        points: Corners of what is struck, from what it turns about [m], shape (corners, 3).
        inverse: Inverse of the inertia about that, shape (3, 3).
    """
    none = np.zeros(len(points))
    x, y, z = points.T
    turns = np.array([[none, -z, y], [z, none, -x], [-y, x, none]]).transpose(2, 0, 1)
    return float(np.linalg.eigvalsh(turns.transpose(0, 2, 1) @ inverse @ turns).max())


def _points(solids: Sequence[SolidShape], origin: Array) -> Array:
    """Spheres with which a body touches the world, in its own axes: their number, x, y, z, r."""
    found = [point for solid in solids for point in _points_of(solid)]
    places = np.array([point[:3] for point in found]) - origin
    spheres = np.column_stack([places, [point[3] for point in found]])
    spheres = np.unique(np.round(spheres, 12), axis=0)
    if len(spheres) > MOST_POINTS:  # the outermost of many
        hull = scipy.spatial.ConvexHull(spheres[:, :3]).vertices
        far = np.linalg.norm(spheres[hull, :3], axis=1)
        spheres = spheres[hull[np.argsort(-far, kind="stable")[:MOST_POINTS]]]
    return np.concatenate([[float(len(spheres))], spheres.ravel()])


def _points_of(solid: SolidShape) -> list[tuple[float, ...]]:
    s, edge, radius = solid.sizes, solid.rounding, solid.rounding
    ring = [(math.cos(a), math.sin(a)) for a in 2.0 * math.pi / RIM * np.arange(RIM)]
    if solid.kind == CAPSULE:
        own, radius = [(0.0, 0.0, s[0]), (0.0, 0.0, -s[0])], s[1]
    elif solid.kind == FRUSTUM:
        rims = ((s[0], -s[2]), (s[1], s[2]))
        own = [(r * x, r * y, z) for r, z in rims for x, y in ring]
    elif solid.kind == TORUS:
        own, radius = [(s[0] * x, s[0] * y, 0.0) for x, y in ring], s[1] + edge
    else:
        signs = (-1.0, 1.0)
        own = [(a * s[0], b * s[1], c * s[2]) for a in signs for b in signs for c in signs]
    places = solid.centre + np.array(own) @ solid.axes
    return [(*place, radius) for place in places.tolist()]
