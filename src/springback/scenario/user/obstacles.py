"""Validation of the user's own obstacles before a flight, by sampling distance and normal.

Contact laws take penetration from the distance and the direction of the force from the normal.  A
shape with an error in either still flies, and the energy ledger may still close: a distance a third
of the true one is a softer surface.  So both are sampled, in plain Python, where rays from the
vehicle hit the surface, and beside it, as contacts are inside.
"""

from __future__ import annotations

import itertools
import math
import sys
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.parameters import SurfaceSettings
from springback.contact.worlds import Own
from springback.errors import InputError, shown_value
from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.vectors import Vec, norm
from springback.scenario.code_files import PACKAGE, error_place, error_words, read_object
from springback.scenario.tables import UserShape, WorldSettings
from springback.scenario.user.laws import home_of

#: Step of finite differences [m] (chosen: rounding leaves 1e-11, a radius of 10 mm 1e-6).
STEP = 1e-5
#: Tolerance for the length of a normal.
UNIT = 1e-6
#: Tolerance between gradient and normal, 0.6 deg or 1 % (chosen: room for interpolated shapes).
GRADIENT = 0.01
#: Tolerated relative excess of the distance at points on the way (chosen).
SHARE = 0.05
#: Change of a distance on a way, over its length, from which a ray may have jumped over the surface
#: (chosen: that of an implicit function over the length of its gradient may exceed 1).
STEEP = 3.0
#: Depths at which both functions are sampled beside the surface, above 0 inside [m] (chosen: few
#: contacts are deeper).
DEPTHS = (1e-4, -1e-4, 1e-3, -1e-3, 3e-3, -3e-3, 0.01, -0.01, 0.03)
#: Tolerance of the distance's growth beside the surface, and the depth down to which it is checked
#: [m] (chosen: an implicit function over the length of its gradient is no distance deep inside).
GROWTH, SHALLOW = 0.3, 3e-3
#: Distance of the points on the surface from which its curvature is taken [m] (chosen).
BESIDE = 1e-3
#: Tolerance of the normal at a depth, over depth times curvature (chosen: as above).  Where it
#: exceeds `LOOSE`, only a normal more than 60 deg off is refused, and nothing where the depth is
#: more than `FOCAL` of the radius of curvature.
BEND, LOOSE, FOCAL = 3.0, 0.3, 0.5
#: Distance of the points beside a start from which the surface is looked for where no ray from
#: itself meets it, over its distance (chosen).
ASIDE = 0.1
#: Maximum number of steps along a ray, and of the bisection that ends it.
STEPS, HALVINGS = 150, 50


def own_obstacles(world: WorldSettings) -> tuple[Own, ...]:
    """The user's own obstacles in a world, read from their files.

    Args:
        world: With entries of type ``own``.

    Raises:
        InputError: If a file or name is missing, or a shape cannot be made of its parameters.
    """
    found: list[Own] = []
    for k, entry in enumerate(world.obstacles):
        if isinstance(entry, UserShape):
            try:
                found.append((_shape(entry), entry.surface))
            except InputError as error:
                where = f"world.obstacles[{k}]"
                raise InputError(*(f"{where}.{line}" for line in error.problems)) from error
    return tuple(found)


def _shape(entry: UserShape) -> Any:
    try:
        shape = read_object(entry.shape, "a shape")
    except InputError as error:
        raise InputError(*(f"shape: {line}" for line in error.problems)) from error
    if callable(shape):
        make, names = shape, tuple(entry.parameters)

        def made(*values: Any) -> Any:
            vectors = (Vec(*value) if isinstance(value, tuple) else value for value in values)
            return make(**dict(zip(names, vectors, strict=True)))

        try:
            shape = traceable(made)(*entry.parameters.values())
        except (Exception, SystemExit) as error:
            place = error_words(error)
            does = "does not take them" if entry.parameters else "cannot be made without any"
            raise InputError(f"parameters: {entry.shape} {does}: {place}") from error
    elif entry.parameters:
        raise InputError(f"parameters: {entry.shape} is a shape, not its type, and takes none")
    if not isinstance(shape, tuple) or not hasattr(shape, "_fields"):
        raise InputError(
            f"shape: {entry.shape} must be a shape, a NamedTuple of floats and vectors, or return "
            f"one (got {shown_value(shape)})"
        )
    return shape


class _RayHit(NamedTuple):
    """Intersection of a ray and a surface."""

    point: Vec
    before: tuple[Vec, ...]  # points on the way there


def own_names(world: WorldSettings, own: Sequence[object]) -> list[str]:
    """Names of the user's own obstacles, for errors: those of the world first, by their key.

    Args:
        world: Of the scenario.
        own: Its own obstacles, and further ones, or their names: they are counted.
    """
    keys = [
        f"world.obstacles[{k}].shape"
        for k, entry in enumerate(world.obstacles)
        if isinstance(entry, UserShape)
    ]
    return [*keys, *(f"own[{k}]" for k in range(len(own) - len(keys)))]


def check_own_obstacles(own: Sequence[Own], start: Vec, names: Sequence[str] = ()) -> None:
    """Reject obstacles whose distance or normal is wrong where a vehicle could touch them.

    Rays start at the vehicle along the axes, the diagonals and the gradient of the distance; if
    none hits the surface, beside it along the gradient there.  Where they hit the surface, and up
    to 30 mm inside and 10 mm outside of it, the normal must be a unit vector and along the gradient
    of the distance, which grows by 1 m a metre (points of a crease, which has none, are excluded).
    At no point on the way may the returned distance exceed the true
    one.  Flights that start in the same cubic metre are checked once.

    Args:
        own: Pairs of a shape and its surface.
        start: Position of the vehicle at time 0, world [m].
        names: Of each, for errors; by default ``own[0]``, ...

    Raises:
        InputError: With the obstacle, the point, what was returned and what it should have been.
    """
    named = names or [f"own[{k}]" for k in range(len(own))]
    for name, entry in zip(named, own, strict=True):
        pair = entry if isinstance(entry, tuple | list) and len(entry) == 2 else (None, None)
        if not isinstance(pair[0], tuple) or not isinstance(pair[1], SurfaceSettings):
            raise InputError(
                f"{name}: must be a pair of a shape, a NamedTuple of floats and vectors, "
                f"and its SurfaceSettings (got {shown_value(entry)})"
            )
        known = (type(pair[0]), repr(pair[0]), *(round(x) for x in start))
        if known not in _SEEN:
            check_shape_from(start, pair[0], f"{name}, {type(pair[0]).__name__}")
            _SEEN.add(known)


class SampledPoints(NamedTuple):
    """Points at which a shape was looked at."""

    outside: tuple[Vec, ...]  # on the way to the surface, world [m]
    surface: tuple[Vec, ...]  # where rays met it, world [m]


def check_shape_from(start: Vec, shape: Any, name: str) -> SampledPoints:
    """Reject a shape whose distance or normal is wrong where rays from a point meet it.

    Args:
        start: Where the rays begin, world [m].
        shape: The shape.
        name: Of the shape, for errors.

    Returns:
        The points that were looked at.

    Raises:
        InputError: With the first point that is wrong.
    """
    sampled = _Sampled(name, shape)
    sampled.check(start)
    outside = (point for hit in sampled.hits for point in hit.before)
    return SampledPoints(tuple(outside), tuple(hit.point for hit in sampled.hits))


#: Validated shapes, by their numbers and the cubic metre of the start.
_SEEN: set[tuple[Any, ...]] = set()


class _Sampled:
    """A shape whose two functions are validated."""

    def __init__(self, name: str, shape: Any) -> None:
        self.name, self.shape = name, shape
        self.hits: list[_RayHit] = []

    def check(self, start: Vec) -> None:
        there = self.distance(start)
        for direction in itertools.chain([-self.gradient(start)], _directions()):
            self.check_along(start, direction, abs(there))
        if not self.hits:  # as on the axis of a ring, where the gradient is zero or through it
            for way in itertools.chain(_AXES, (-axis for axis in _AXES)):
                beside = start + way * (ASIDE * abs(there))
                self.check_along(beside, -self.gradient(beside), abs(there))
        if not self.hits:
            self.normal(start)  # no hit: check at least for a unit vector

    def check_along(self, start: Vec, direction: Vec, first: float) -> None:
        """Check where a ray hits the surface, at some distance from its start [m]."""
        if norm(direction) > UNIT:
            hit = self.ray_hit(start, direction * (1.0 / norm(direction)), first)
            if hit is not None:
                self.hits.append(hit)
                self.check_at(hit)

    def ray_hit(self, start: Vec, direction: Vec, first: float) -> _RayHit | None:
        """Intersection of a ray with the surface, at some distance from the start [m]."""
        side = self.distance(start) >= 0.0
        low, passed = 0.0, list[Vec]()
        steep: tuple[Vec, str] | None = None
        for _ in range(STEPS):
            point = start + direction * low
            passed.append(point)
            stride = max(0.25 * abs(self.distance(point)), 2e-3 * first, 1e-6)
            high = low + stride
            ahead = self.distance(start + direction * high)
            if (ahead >= 0.0) != side:
                break
            change = abs(ahead - self.distance(point))
            if change > STEEP * stride + STEP and steep is None:
                steep = (
                    point,
                    f"changes by {change:.4g} m over {stride:.4g} m; a distance changes by no more "
                    "than the length of the path: divide a function that is zero on the surface by "
                    "the length of its gradient near the surface, and farther away by the largest "
                    "that its gradient has anywhere",
                )
            low = high
            if high > 50.0 * (first + 1.0):
                break
        if low == high:  # it may have missed a surface
            if steep is not None:
                self.refuse("signed_distance", *steep)
            return None
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            same = (self.distance(start + direction * middle) >= 0.0) == side
            low, high = (middle, high) if same else (low, middle)
        return _RayHit(start + direction * high, tuple(passed[::8]))

    def check_at(self, hit: _RayHit) -> None:
        """Check a point of the surface."""
        point = hit.point
        n = self.normal(point)
        for before in hit.before:
            true, returned = norm(before - point), self.distance(before)
            if returned > true * (1.0 + SHARE) + STEP:
                self.refuse(
                    "signed_distance", before,
                    f"is {returned:.6g} m, and its surface is no farther than {true:.6g} m",
                )  # fmt: skip
        gradient = self.gradient(point)
        if not self.is_crease(point):
            size, along = norm(gradient), self.along(gradient)
            if abs(size - 1.0) > GRADIENT and norm(along - n) < 0.1:
                self.refuse_growth(point, size)
            if norm(gradient - n) > GRADIENT:
                self.refuse_normal(point, n, gradient)
        self.check_beside(point, gradient)

    def along(self, gradient: Vec) -> Vec:
        """Unit vector along a gradient; about zero if it is."""
        return gradient * (1.0 / max(norm(gradient), UNIT))

    def refuse_growth(self, point: Vec, size: float, where: str = "") -> None:
        self.refuse(
            "signed_distance", point,
            f"changes by {size:.4g} m a metre along the normal; a distance changes by 1", where,
        )  # fmt: skip

    def refuse_normal(self, point: Vec, n: Vec, gradient: Vec, where: str = "") -> None:
        self.refuse(
            "outward_normal", point,
            f"is {_text(n)}, and the gradient of signed_distance is {_text(gradient)}", where,
        )  # fmt: skip

    def check_beside(self, point: Vec, out: Vec) -> None:
        """Check both functions at some depths below a point of the surface, and above it.

        Args:
            point: Of the surface.
            out: Gradient of the distance there.
        """
        if not norm(out) > 0.5:  # at a ridge; its faces are met elsewhere
            return
        out = self.along(out)
        bend = self.curvature(point, out)
        for depth in DEPTHS:
            if abs(depth) * bend > FOCAL:
                continue
            there = point - out * depth
            n = self.normal(there)
            if self.is_crease(there):
                continue
            where = f", {1e3 * abs(depth):g} mm {'inside' if depth > 0.0 else 'outside'},"
            gradient, tolerance = self.gradient(there), GRADIENT + BEND * bend * abs(depth)
            if norm(self.along(gradient) - n) > (tolerance if tolerance < LOOSE else 1.0):
                self.refuse_normal(there, n, gradient, where)
            size = norm(gradient)
            if abs(depth) <= SHALLOW and abs(size - 1.0) > GROWTH:
                self.refuse_growth(there, size, where)

    def curvature(self, point: Vec, out: Vec) -> float:
        """Largest curvature of the surface about a point, by differences of the gradient [1/m]."""
        least = min(_AXES, key=lambda axis: abs(axis @ out))
        first = least - out * (least @ out)
        first = first * (1.0 / norm(first))
        second = Vec(
            out.y * first.z - out.z * first.y,
            out.z * first.x - out.x * first.z,
            out.x * first.y - out.y * first.x,
        )
        changes = [
            norm(self.gradient(point + way * step) - self.gradient(point)) / BESIDE
            for way in (first, second)
            for step in (-BESIDE, BESIDE)
        ]
        return float(max(changes))

    def is_crease(self, point: Vec) -> bool:
        """True if the gradient differs between both sides of a point, as at an edge."""
        here = self.distance(point)
        for axis in _AXES:
            ahead = (self.distance(point + axis * STEP) - here) / STEP
            behind = (here - self.distance(point - axis * STEP)) / STEP
            if abs(ahead - behind) > GRADIENT:
                return True
        return False

    def gradient(self, point: Vec) -> Vec:
        """Gradient of the distance, by central differences."""
        return Vec(
            *(
                (self.distance(point + axis * STEP) - self.distance(point - axis * STEP))
                / (2.0 * STEP)
                for axis in _AXES
            )
        )

    def distance(self, point: Vec) -> float:
        """Distance returned by the shape [m]."""
        returned = self.value(signed_distance, point)
        if not isinstance(returned, float) or not math.isfinite(returned):
            self.refuse(
                "signed_distance", point, f"is {shown_value(returned)}; it must be a finite float"
            )
        return float(returned)

    def normal(self, point: Vec) -> Vec:
        """Normal returned by the shape."""
        returned = self.value(outward_normal, point)
        if not isinstance(returned, Vec):
            self.refuse("outward_normal", point, f"is {shown_value(returned)}; it must be a Vec")
        if not abs(norm(returned) - 1.0) <= UNIT:
            self.refuse(
                "outward_normal",
                point,
                f"is {_text(returned)}, {norm(returned):.6g} long; it must be 1 long",
            )
        return Vec(*returned)

    def value(self, function: Any, point: Vec) -> Any:
        """Value returned by one of the functions."""
        law = function.dispatch(type(self.shape))
        if home_of(law)[0].startswith(PACKAGE) and not _is_of_package(self.shape):
            name = function.__name__
            raise InputError(
                f"{self.name}: {_class_home(self.shape)}has no {name}: register one, by "
                f"@{name}.register({type(self.shape).__name__})"
            )
        try:
            return function(self.shape, point)
        except Exception as error:
            place = error_place(error, *home_of(law))
            raise InputError(
                f"{self.name}: {place}: {type(error).__name__}: {error}, at {_text(point)} m"
            ) from error

    def refuse(self, function: str, point: Vec, what: str, where: str = "") -> None:
        raise InputError(f"{self.name}: {function} at {_text(point)} m{where} {what}")


def _is_of_package(shape: Any) -> bool:
    return type(shape).__module__.startswith("springback.")


def _class_home(shape: Any) -> str:
    """File of a shape's class before what is wrong with it; empty if it is in none."""
    file = getattr(sys.modules.get(type(shape).__module__), "__file__", None)
    return f"{file}: " if file else ""


_AXES = (Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))


def _directions() -> Iterator[Vec]:
    """Directions along the axes and the diagonals between all three, slightly off them.

    A shape is often aligned with the axes; rays beside them miss its edges.
    """
    for x, y, z in itertools.product((-1.0, 0.0, 1.0), repeat=3):
        if abs(x) + abs(y) + abs(z) in (1.0, 3.0):
            yield Vec(x + 0.013, y - 0.017, z + 0.011)


def _text(v: Vec) -> str:
    return f"[{', '.join(f'{part:.4g}' for part in v)}]"
