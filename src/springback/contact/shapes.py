"""Built-in obstacles besides walls, mats and the ground: user input, converted to solids."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from typing import Annotated, Any, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field, model_validator

from springback.contact.moving.parameters import MotionSettings
from springback.contact.parameters import SurfaceSettings
from springback.contact.scene.solids import (
    BOX,
    CAPSULE,
    FRUSTUM,
    HALF_SPACE,
    ROUND_WINDOW,
    TORUS,
    WINDOW,
)
from springback.contact.scene.table import ENDLESS, Solid
from springback.errors import shown_value
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, rotation
from springback.quantities import Angle, Length, Pair, Triple, Unit
from springback.settings import Name, Settings, problem

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Radius of edges unless one is given [m] (chosen: planed wood, a door frame).
EDGE = 1e-3
#: Most steps of a flight of stairs (chosen).
MOST_STEPS = 200

Sizes = Annotated[Triple, Unit("m", above=0.0)]
Place = Annotated[Triple, Unit("m")]
Direction = Annotated[Triple, Unit("")]
Widths = Annotated[Pair, Unit("m", above=0.0)]
NotNegative = Annotated[float, Unit("m", least=0.0)]


class SolidShape(NamedTuple):
    """A solid before it has a surface."""

    kind: float
    centre: Array  # world [m]
    axes: Array  # its own axes, one a row, in world axes
    sizes: tuple[float, ...]  # [m]
    rounding: float  # [m]


class SolidPart(NamedTuple):
    """A solid with its surface."""

    body: SolidShape
    surface: SurfaceSettings


def _middle_depth(body: SolidShape) -> float:
    """Depth of the middle of a solid below its surface [m]; infinite if it has no other side."""
    sizes, edge = body.sizes, body.rounding
    if body.kind == BOX:
        return min(sizes) + edge
    if body.kind == CAPSULE:
        return sizes[1]
    if body.kind == FRUSTUM:
        return min(max(sizes[:2]), sizes[2]) + edge
    if body.kind == TORUS:
        return sizes[1]
    return sizes[2] + edge if body.kind in (WINDOW, ROUND_WINDOW) else math.inf


def distance_around(body: SolidShape, points: Array) -> Array:
    """Distance of points from a box around a solid [m], shape (n,); 0 from a half-space.

    Args:
        body: The solid.
        points: World [m], shape (n, 3).
    """
    sizes, kind = body.sizes, body.kind
    if kind == HALF_SPACE:
        return np.zeros(len(points))
    wide = max(sizes[:2]) if kind == FRUSTUM else sum(sizes[:2]) if kind == TORUS else sizes[1]
    round_ones = {CAPSULE: sizes[0], FRUSTUM: sizes[-1], TORUS: sizes[1]}
    half = (wide, wide, round_ones[kind]) if kind in round_ones else sizes[:3]
    beyond = np.abs((points - body.centre) @ body.axes.T) - np.array(half) - body.rounding
    return np.asarray(np.linalg.norm(np.maximum(beyond, 0.0), axis=1))


class ShapeSettings(Settings):
    """What all built-in shapes have."""

    name: Name = ""
    """Name for messages and drawings."""
    motion: MotionSettings | None = None
    """How it moves; by default it is at rest."""

    @model_validator(mode="after")
    def _edges_fit(self) -> Self:
        """Reject edges rounded by more than half of what they round."""
        edge, thinnest = getattr(self, "edge_radius", 0.0), self.thinnest()
        if thinnest > 0.0 and edge > 0.5 * thinnest:
            raise problem(
                f"must be at most {0.5 * thinnest:g} m, half of the thinnest part (got {edge:g} m)",
                "edge_radius",
            )
        return self

    def thinnest(self) -> float:
        """Thickness of the thinnest part that has edges [m]; infinite without any."""
        return math.inf

    @abstractmethod
    def bodies(self) -> list[SolidShape]:
        """Its solids."""

    @abstractmethod
    def law(self) -> SurfaceSettings:
        """Its surface."""

    def middle_depth(self) -> float:
        """Depth of its middle below its surface, at its thinnest solid [m].

        What is pressed in deeper is nearer to the other side, and pushed out there.
        """
        return min(map(_middle_depth, self.bodies()), default=math.inf)

    def parts(self) -> list[SolidPart]:
        """Its solids, each with its surface."""
        law = self.law()
        return [SolidPart(body, law) for body in self.bodies()]


class SurfacedShape(ShapeSettings):
    """A shape of which the user gives the surface."""

    surface: SurfaceSettings

    def law(self) -> SurfaceSettings:
        """Its surface."""
        return self.surface


class AttitudeSettings(Settings):
    """Attitude of a shape that can be turned."""

    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0

    def axes(self) -> Array:
        """Its own axes in world axes, one a row."""
        turn = rotation(Quat(*attitude_from_euler(self.roll, self.pitch, self.yaw)))
        return np.array(turn).T


class AttitudeShape(AttitudeSettings, SurfacedShape):
    """A shape that can be turned."""


def axes_along(direction: Triple) -> Array:
    """Axes of which the third is along a direction."""
    z = np.array(direction) / math.hypot(*direction)
    helper = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    x = helper - (helper @ z) * z
    x /= np.linalg.norm(x)
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    return np.array([x, y, z])  # np.cross takes ten times as long, for each trunk of a forest


class AxisShape(SurfacedShape):
    """A shape around an axis."""

    axis: Direction = (0.0, 0.0, 1.0)
    """Direction of the axis, of any length; by default upwards."""

    @model_validator(mode="after")
    def _has_direction(self) -> AxisShape:
        if not math.hypot(*self.axis) > 0.0:
            raise problem(f"must not be zero (got {shown_value(list(self.axis))})", "axis")
        return self


class Box(AttitudeShape):
    """A box: furniture, a ledge, a pillar."""

    type: Literal["box"]
    position: Place
    """Position of its centre."""
    size: Sizes
    """Full lengths along its own x, y and z."""
    edge_radius: NotNegative = EDGE
    """Radius of its edges, within its size."""

    def thinnest(self) -> float:
        """Its shortest side [m]."""
        return min(self.size)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        edge = self.edge_radius
        half = tuple(0.5 * length - edge for length in self.size)
        return [SolidShape(BOX, np.array(self.position), self.axes(), half, edge)]


class Edge(AttitudeShape):
    """An outward edge: two faces at right angles, each of some width."""

    type: Literal["edge"]
    position: Place
    """Position of the middle of the edge."""
    length: Length = 10.0
    """Length of the edge, along its own z: upright unless it is turned."""
    width: Length = 2.0
    """Of both faces; the edge points along the shape's own −x."""
    edge_radius: NotNegative = EDGE

    def thinnest(self) -> float:
        """Width of a face, or its length [m]."""
        return min(self.width, self.length)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        edge, w, axes = self.edge_radius, self.width, self.axes()
        x, y, z = axes
        root = math.sqrt(0.5)
        turned = np.array([root * (x + y), root * (y - x), z])
        # The rounded corner touches where the sharp one would be less (√2 − 1) of the radius.
        centre = np.array(self.position) + x * (root * w)
        half = 0.5 * w - edge
        return [SolidShape(BOX, centre, turned, (half, half, 0.5 * self.length - edge), edge)]


class Ball(SurfacedShape):
    """A sphere."""

    type: Literal["sphere"]
    position: Place
    radius: Length

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        return [SolidShape(CAPSULE, np.array(self.position), np.eye(3), (0.0, self.radius), 0.0)]


class Pole(AxisShape):
    """A round pole: endless, or of a given height with flat ends."""

    type: Literal["pole"]
    position: Place
    """A point on its axis; the foot, if it has a height."""
    radius: Length
    height: Length | None = None
    """Height; without it the pole is endless."""
    edge_radius: NotNegative = EDGE
    """Radius of the edges of its flat ends."""

    def thinnest(self) -> float:
        """Its height or diameter [m]."""
        return math.inf if self.height is None else min(self.height, 2.0 * self.radius)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        foot, axes, edge = np.array(self.position), axes_along(self.axis), self.edge_radius
        if self.height is None:
            return [SolidShape(CAPSULE, foot, axes, (ENDLESS, self.radius), 0.0)]
        centre, r = foot + 0.5 * self.height * axes[2], self.radius - edge
        return [SolidShape(FRUSTUM, centre, axes, (r, r, 0.5 * self.height - edge), edge)]


class Capsule(SurfacedShape):
    """A rod with round ends: a branch, a cable, a rail."""

    type: Literal["capsule"]
    start: Place
    """One end of its axis."""
    end: Place
    """The other end."""
    radius: Length

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        a, b = np.array(self.start), np.array(self.end)
        length = float(np.linalg.norm(b - a))
        axes = axes_along(tuple((b - a).tolist())) if length > 0.0 else np.eye(3)
        return [SolidShape(CAPSULE, 0.5 * (a + b), axes, (0.5 * length, self.radius), 0.0)]


class Cone(AxisShape):
    """A cone, whole or cut off: a traffic cone, a tapered trunk."""

    type: Literal["cone"]
    position: Place
    """Centre of its base."""
    height: Length
    radius: Length
    """Radius of the base."""
    top_radius: NotNegative = 0.0
    edge_radius: NotNegative = EDGE
    """Radius of its edges and tip, within its size."""

    def thinnest(self) -> float:
        """Its height or larger diameter [m]."""
        return min(self.height, 2.0 * max(self.radius, self.top_radius))

    @model_validator(mode="after")
    def _outline_fits(self) -> Cone:
        self._inner_outline()
        return self

    def _inner_outline(self) -> tuple[float, float, float, float]:
        """Outline moved inwards by the radius of the edges, which rounds it outwards again.

        Returns:
            Heights of its base and top above the base, and its radii there [m].
        """
        edge, base, top, height = self.edge_radius, self.radius, self.top_radius, self.height
        slant = math.hypot(height, base - top)
        low, high = edge, height - edge
        inner_low = base + (top - base) * low / height - edge * slant / height
        inner_high = base + (top - base) * high / height - edge * slant / height
        if inner_high < 0.0:  # the tip of the inner outline is lower than the top
            high = low + (high - low) * inner_low / (inner_low - inner_high)
            inner_high = 0.0
        if not (inner_low >= 0.0 and high > low):
            raise problem(f"is too large for this cone (got {edge:g} m)", "edge_radius")
        return low, high, inner_low, inner_high

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        axes, (low, high, *radii) = axes_along(self.axis), self._inner_outline()
        centre, sizes = 0.5 * (low + high) * axes[2], (*radii, 0.5 * (high - low))
        return [
            SolidShape(FRUSTUM, np.array(self.position) + centre, axes, sizes, self.edge_radius)
        ]


class Hoop(AxisShape):
    """A ring of a round tube: a racing gate."""

    type: Literal["hoop"]
    position: Place
    """Position of its centre."""
    axis: Direction = (1.0, 0.0, 0.0)
    """Direction in which to fly through it."""
    radius: Length
    """Radius of the circle along the middle of the tube."""
    tube_radius: Length

    @model_validator(mode="after")
    def _is_open(self) -> Hoop:
        if self.tube_radius >= self.radius:
            raise problem(
                f"must be less than radius, {self.radius:g} m (got {self.tube_radius:g} m)",
                "tube_radius",
            )
        return self

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        axes = axes_along(self.axis)
        return [
            SolidShape(TORUS, np.array(self.position), axes, (self.radius, self.tube_radius), 0.0)
        ]


class Slope(SurfacedShape):
    """Endless inclined ground."""

    type: Literal["slope"]
    position: Place = (0.0, 0.0, 0.0)
    """A point on its face."""
    angle: Annotated[float, Unit("rad", least=0.0, most=0.5 * math.pi)]
    """Angle of its face from the horizontal."""
    uphill: Angle = 0.0
    """Heading uphill, from X towards Y."""

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        s, c, heading = math.sin(self.angle), math.cos(self.angle), self.uphill
        normal = (-s * math.cos(heading), -s * math.sin(heading), c)
        return [SolidShape(HALF_SPACE, np.array(self.position), axes_along(normal), (), 0.0)]


class Stairs(SurfacedShape):
    """A flight of stairs, each step a box from the floor up."""

    type: Literal["stairs"]
    position: Place
    """Middle of the foot of the first riser, on the floor."""
    yaw: Angle = 0.0
    """Heading up the stairs, from X towards Y."""
    steps: Annotated[int, Field(ge=1, le=MOST_STEPS)] = 10
    rise: Length = 0.17
    tread: Length = 0.29
    width: Length = 1.0
    edge_radius: NotNegative = EDGE

    def thinnest(self) -> float:
        """Its rise, tread or width [m]."""
        return min(self.rise, self.tread, self.width)

    def bodies(self) -> list[SolidShape]:
        """Its solids."""
        edge = self.edge_radius
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        axes = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        end, found = self.steps * self.tread, []
        for k in range(self.steps):
            length, height = end - k * self.tread, (k + 1) * self.rise
            centre = np.array(self.position) + axes.T @ [end - 0.5 * length, 0.0, 0.5 * height]
            half = (0.5 * length - edge, 0.5 * self.width - edge, 0.5 * height - edge)
            found.append(SolidShape(BOX, centre, axes, half, edge))
        return found


def half_space(normal: Sequence[float], offset: float) -> SolidShape:
    """The half-space behind a face.

    Args:
        normal: Unit vector out of it, world.
        offset: normal · x of the face [m].
    """
    axes = axes_along((normal[0], normal[1], normal[2]))
    axes[2] = normal
    return SolidShape(HALF_SPACE, offset * np.array(normal), axes, (), 0.0)


def solids_of(shape: ShapeSettings, surface: int, owner: int) -> list[Solid]:
    """Solids of a shape.

    Args:
        shape: The settings.
        surface: Number of its surface in the table.
        owner: Number of the obstacle.
    """
    return [Solid(*body, surface, 0.0, owner) for body in shape.bodies()]
