"""Built-in obstacles besides walls, mats and the ground: user input, converted to solids."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from pydantic import Field, model_validator

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
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, rotation
from springback.quantities import Angle, Length, Pair, Triple, Unit
from springback.settings import Settings, problem

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Radius of edges unless one is given [m] (chosen: planed wood, a door frame).
EDGE = 1e-3
#: Most steps of a flight of stairs, and most trunks of a forest (chosen).
MOST_STEPS, MOST_TRUNKS = 200, 20_000
#: Trials to place a trunk that keeps its distance from the others (chosen: as usual).
TRIALS = 30

Sizes = Annotated[Triple, Unit("m", above=0.0)]
Place = Annotated[Triple, Unit("m")]
Direction = Annotated[Triple, Unit("")]
Widths = Annotated[Pair, Unit("m", above=0.0)]
NotNegative = Annotated[float, Unit("m", least=0.0)]


class Body(NamedTuple):
    """A solid before it has a surface."""

    kind: float
    centre: Array  # world [m]
    axes: Array  # its own axes, one a row, in world axes
    sizes: tuple[float, ...]  # [m]
    rounding: float  # [m]


class ShapeSettings(Settings):
    """What all built-in shapes have."""

    surface: SurfaceSettings

    def bodies(self) -> list[Body]:
        """Its solids."""
        raise NotImplementedError

    def _check_edge(self, edge: float, thinnest: float) -> None:
        """Reject edges rounded by more than half of what they round."""
        if edge > 0.5 * thinnest:
            raise problem(
                f"must be at most {0.5 * thinnest:g} m, half of the thinnest part (got {edge:g} m)",
                "edge_radius",
            )


class TurnedShape(ShapeSettings):
    """A shape that can be turned."""

    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0

    def axes(self) -> Array:
        """Its own axes in world axes, one a row."""
        turn = rotation(Quat(*attitude_from_euler(self.roll, self.pitch, self.yaw)))
        return np.array(turn).T


def _axes_along(direction: Triple) -> Array:
    """Axes of which the third is along a direction."""
    z = np.array(direction) / math.hypot(*direction)
    helper = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    x = helper - (helper @ z) * z
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


class AxisShape(ShapeSettings):
    """A shape around an axis."""

    axis: Direction = (0.0, 0.0, 1.0)
    """Direction of the axis, of any length; upwards unless it is given."""

    @model_validator(mode="after")
    def _has_direction(self) -> AxisShape:
        if not math.hypot(*self.axis) > 0.0:
            raise problem("must not be zero", "axis")
        return self


class Box(TurnedShape):
    """A box: furniture, a ledge, a pillar."""

    type: Literal["box"]
    position: Place
    """Of its centre."""
    size: Sizes
    """Whole lengths along its own x, y and z."""
    edge_radius: NotNegative = EDGE
    """Radius of its edges, within its size."""

    def bodies(self) -> list[Body]:
        """Its solids."""
        edge = self.edge_radius
        self._check_edge(edge, min(self.size))
        half = tuple(0.5 * length - edge for length in self.size)
        return [Body(BOX, np.array(self.position), self.axes(), half, edge)]


class Edge(TurnedShape):
    """An outward edge: two faces at right angles, each of some width."""

    type: Literal["edge"]
    position: Place
    """A point of the edge, its middle."""
    length: Length = 10.0
    """Of the edge, along its own z: upright unless it is turned."""
    width: Length = 2.0
    """Of both faces; the edge points along the shape's own −x."""
    edge_radius: NotNegative = EDGE

    def bodies(self) -> list[Body]:
        """Its solids."""
        edge, w, axes = self.edge_radius, self.width, self.axes()
        self._check_edge(edge, min(w, self.length))
        x, y, z = axes
        root = math.sqrt(0.5)
        turned = np.array([root * (x + y), root * (y - x), z])
        # The rounded corner touches where the sharp one would be less (√2 − 1) of the radius.
        centre = np.array(self.position) + x * (root * w)
        half = 0.5 * w - edge
        return [Body(BOX, centre, turned, (half, half, 0.5 * self.length - edge), edge)]


class Ball(ShapeSettings):
    """A sphere."""

    type: Literal["sphere"]
    position: Place
    radius: Length

    def bodies(self) -> list[Body]:
        """Its solids."""
        return [Body(CAPSULE, np.array(self.position), np.eye(3), (0.0, self.radius), 0.0)]


class Pole(AxisShape):
    """A round pole: without end, or of some height with flat ends."""

    type: Literal["pole"]
    position: Place
    """A point of its axis; the foot, if it has a height."""
    radius: Length
    height: Length | None = None
    """Without it the pole has no end."""
    edge_radius: NotNegative = EDGE
    """Of the edges of its flat ends."""

    def bodies(self) -> list[Body]:
        """Its solids."""
        foot, axes, edge = np.array(self.position), _axes_along(self.axis), self.edge_radius
        if self.height is None:
            return [Body(CAPSULE, foot, axes, (ENDLESS, self.radius), 0.0)]
        self._check_edge(edge, min(self.height, 2.0 * self.radius))
        centre, r = foot + 0.5 * self.height * axes[2], self.radius - edge
        return [Body(FRUSTUM, centre, axes, (r, r, 0.5 * self.height - edge), edge)]


class Capsule(ShapeSettings):
    """A rod with round ends: a branch, a cable, a rail."""

    type: Literal["capsule"]
    start: Place
    """One end of its axis."""
    end: Place
    """The other end."""
    radius: Length

    def bodies(self) -> list[Body]:
        """Its solids."""
        a, b = np.array(self.start), np.array(self.end)
        length = float(np.linalg.norm(b - a))
        axes = _axes_along(tuple((b - a).tolist())) if length > 0.0 else np.eye(3)
        return [Body(CAPSULE, 0.5 * (a + b), axes, (0.5 * length, self.radius), 0.0)]


class Cone(AxisShape):
    """A cone, whole or cut off: a traffic cone, a tapered trunk."""

    type: Literal["cone"]
    position: Place
    """Centre of its base."""
    height: Length
    radius: Length
    """Of the base."""
    top_radius: NotNegative = 0.0
    edge_radius: NotNegative = EDGE
    """Of its edges and tip, within its size."""

    def bodies(self) -> list[Body]:
        """Its solids."""
        axes, edge = _axes_along(self.axis), self.edge_radius
        base, top, height = self.radius, self.top_radius, self.height
        self._check_edge(edge, min(height, 2.0 * max(base, top)))
        # The outline is moved inwards by the radius; it is then rounded outwards again.
        slant = math.hypot(height, base - top)
        low, high = edge, height - edge
        inner_low = base + (top - base) * low / height - edge * slant / height
        inner_high = base + (top - base) * high / height - edge * slant / height
        if inner_high < 0.0:  # the tip of the inner outline is lower than the top
            high = low + (high - low) * inner_low / (inner_low - inner_high)
            inner_high = 0.0
        if not (inner_low >= 0.0 and high > low):
            raise problem(f"is too large for this cone (got {edge:g} m)", "edge_radius")
        centre = np.array(self.position) + 0.5 * (low + high) * axes[2]
        return [Body(FRUSTUM, centre, axes, (inner_low, inner_high, 0.5 * (high - low)), edge)]


class Hoop(AxisShape):
    """A ring of a round tube: a racing gate."""

    type: Literal["hoop"]
    position: Place
    """Of its centre."""
    axis: Direction = (1.0, 0.0, 0.0)
    """Direction to fly through it."""
    radius: Length
    """Of the circle along the middle of the tube."""
    tube_radius: Length

    @model_validator(mode="after")
    def _is_open(self) -> Hoop:
        if self.tube_radius >= self.radius:
            raise problem(
                f"must be less than radius, {self.radius:g} m (got {self.tube_radius:g} m)",
                "tube_radius",
            )
        return self

    def bodies(self) -> list[Body]:
        """Its solids."""
        axes = _axes_along(self.axis)
        return [Body(TORUS, np.array(self.position), axes, (self.radius, self.tube_radius), 0.0)]


class Panel(TurnedShape):
    """An upright wall with an opening; it faces along its own x."""

    size: Widths = (4.0, 3.0)
    thickness: Length = 0.1
    edge_radius: NotNegative = EDGE

    def _panel_axes(self) -> Array:
        """Axes of the solid: to the left, upwards, and through the wall."""
        x, y, z = self.axes()
        return np.array([y, z, x])

    def _halves(self) -> tuple[float, float, float]:
        """Half width, height and thickness before the edges are rounded."""
        edge = self.edge_radius
        self._check_edge(edge, min(*self.size, self.thickness))
        width, height = self.size
        return 0.5 * width - edge, 0.5 * height - edge, 0.5 * self.thickness - edge


class Window(Panel):
    """A wall with a window, rectangular or round."""

    type: Literal["window"]
    position: Place
    """Centre of the wall, halfway through it."""
    opening: Widths | None = None
    """Width and height of a rectangular window."""
    opening_height: Annotated[float, Unit("m")] = 0.0
    """Height of the centre of a rectangular window above that of the wall."""
    opening_radius: Length | None = None
    """Radius of a round window, in the middle of the wall."""

    @model_validator(mode="after")
    def _one_opening(self) -> Window:
        if (self.opening is None) == (self.opening_radius is None):
            raise problem("needs either opening, width and height, or opening_radius")
        width, height = self.size
        if self.opening is not None:
            w, h = self.opening
            room = 0.5 * (height - h) - abs(self.opening_height)
            if w >= width or room <= 0.0:
                raise problem(
                    f"must lie within the wall, {width:g} m x {height:g} m (got {w:g} m x {h:g} m, "
                    f"{self.opening_height:g} m above its centre)",
                    "opening",
                )
        elif 2.0 * (self.opening_radius or 0.0) >= min(width, height):
            raise problem(
                f"must be less than {0.5 * min(width, height):g} m, half of the wall (got "
                f"{self.opening_radius:g} m)",
                "opening_radius",
            )
        return self

    def bodies(self) -> list[Body]:
        """Its solids."""
        halves, edge = self._halves(), self.edge_radius
        centre, axes = np.array(self.position), self._panel_axes()
        if self.opening is not None:
            w, h = self.opening
            hole = (0.5 * w + edge, 0.5 * h + edge, self.opening_height)
            return [Body(WINDOW, centre, axes, (*halves, *hole), edge)]
        radius = (self.opening_radius or 0.0) + edge
        return [Body(ROUND_WINDOW, centre, axes, (*halves, radius), edge)]


class Doorway(Panel):
    """A wall with an open door."""

    type: Literal["doorway"]
    position: Place
    """Middle of the threshold: on the floor, halfway through the wall."""
    opening: Widths = (0.9, 2.0)
    """Width and height."""

    @model_validator(mode="after")
    def _is_within(self) -> Doorway:
        (width, height), (w, h) = self.size, self.opening
        if w >= width or h >= height:
            raise problem(
                f"must be smaller than the wall, {width:g} m x {height:g} m "
                f"(got {w:g} m x {h:g} m)",
                "opening",
            )
        return self

    def bodies(self) -> list[Body]:
        """Its solids."""
        halves, edge = self._halves(), self.edge_radius
        axes, (w, h), height = self._panel_axes(), self.opening, self.size[1]
        centre = np.array(self.position) + 0.5 * height * axes[1]
        # The opening goes on below the floor.
        hole = (0.5 * w + edge, h + edge, -0.5 * height)
        return [Body(WINDOW, centre, axes, (*halves, *hole), edge)]


class Slope(ShapeSettings):
    """Inclined ground without end."""

    type: Literal["slope"]
    position: Place = (0.0, 0.0, 0.0)
    """A point of its face."""
    angle: Annotated[float, Unit("rad", least=0.0, most=0.5 * math.pi)]
    """Of its face from the horizontal."""
    uphill: Angle = 0.0
    """Heading of the way up, from X towards Y."""

    def bodies(self) -> list[Body]:
        """Its solids."""
        s, c, heading = math.sin(self.angle), math.cos(self.angle), self.uphill
        normal = (-s * math.cos(heading), -s * math.sin(heading), c)
        return [Body(HALF_SPACE, np.array(self.position), _axes_along(normal), (), 0.0)]


class Stairs(ShapeSettings):
    """A flight of stairs, each step a box from the floor up."""

    type: Literal["stairs"]
    position: Place
    """Middle of the foot of the first riser, on the floor."""
    yaw: Angle = 0.0
    """Heading of the way up, from X towards Y."""
    steps: Annotated[int, Field(ge=1, le=MOST_STEPS)] = 10
    rise: Length = 0.17
    tread: Length = 0.29
    width: Length = 1.0
    edge_radius: NotNegative = EDGE

    def bodies(self) -> list[Body]:
        """Its solids."""
        edge = self.edge_radius
        self._check_edge(edge, min(self.rise, self.tread, self.width))
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        axes = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        end, found = self.steps * self.tread, []
        for k in range(self.steps):
            length, height = end - k * self.tread, (k + 1) * self.rise
            centre = np.array(self.position) + axes.T @ [end - 0.5 * length, 0.0, 0.5 * height]
            half = (0.5 * length - edge, 0.5 * self.width - edge, 0.5 * height - edge)
            found.append(Body(BOX, centre, axes, half, edge))
        return found


class Forest(ShapeSettings):
    """Upright trunks without end, at random places that keep a distance from each other."""

    type: Literal["forest"]
    position: Place = (0.0, 0.0, 0.0)
    """Middle of the nearer side of the area."""
    size: Widths = (20.0, 20.0)
    """Depth along X and width along Y."""
    density: Annotated[float, Unit("1/m^2", least=0.0)]
    """Trunks per area; where no more fit, fewer."""
    radius: Length = 0.1
    """Mean radius of a trunk."""
    radius_spread: Annotated[float, Unit("", least=0.0, most=0.9)] = 0.0
    """Radii are even between 1 − this and 1 + this times the mean."""
    spacing: NotNegative = 0.5
    """Least distance between the bark of two trunks."""
    seed: Annotated[int, Field(ge=0)] = 0

    @model_validator(mode="after")
    def _countable(self) -> Forest:
        count = self.density * self.size[0] * self.size[1]
        if count > MOST_TRUNKS:
            raise problem(
                f"must be at most {MOST_TRUNKS / (self.size[0] * self.size[1]):g} 1/m^2 for this "
                f"area (got {self.density:g} 1/m^2, {count:.0f} trunks)",
                "density",
            )
        return self

    def bodies(self) -> list[Body]:
        """Its solids."""
        random = np.random.default_rng(self.seed)
        depth, width = self.size
        count = round(self.density * depth * width)
        trunks = _spread_out(random, count, (depth, width), self)
        found = []
        for x, y, radius in trunks:
            foot = np.array(self.position) + np.array([x, y - 0.5 * width, 0.0])
            found.append(Body(CAPSULE, foot, np.eye(3), (ENDLESS, radius), 0.0))
        return found


def _spread_out(
    random: np.random.Generator, count: int, area: tuple[float, float], forest: Forest
) -> list[tuple[float, float, float]]:
    """Places and radii by dart throwing: a trial too close to an earlier trunk is dropped."""
    low, high = 1.0 - forest.radius_spread, 1.0 + forest.radius_spread
    cell = 2.0 * forest.radius * high + forest.spacing
    cells: dict[tuple[int, int], list[tuple[float, float, float]]] = {}
    found: list[tuple[float, float, float]] = []
    for _ in range(count * TRIALS):
        if len(found) == count:
            break
        x, y = float(random.uniform(0.0, area[0])), float(random.uniform(0.0, area[1]))
        radius = forest.radius * float(random.uniform(low, high))
        i, j = int(x // cell), int(y // cell)
        near = (
            one for a in (-1, 0, 1) for b in (-1, 0, 1) for one in cells.get((i + a, j + b), ())
        )
        if all(math.hypot(x - u, y - v) >= radius + r + forest.spacing for u, v, r in near):
            found.append((x, y, radius))
            cells.setdefault((i, j), []).append((x, y, radius))
    return found


Shape = (
    Box | Edge | Ball | Pole | Capsule | Cone | Hoop | Window | Doorway | Slope | Stairs | Forest
)


def half_space(normal: Sequence[float], offset: float) -> Body:
    """The half-space behind a face.

    Args:
        normal: Unit vector out of it, world.
        offset: normal · x of the face [m].
    """
    axes = _axes_along((normal[0], normal[1], normal[2]))
    axes[2] = normal
    return Body(HALF_SPACE, offset * np.array(normal), axes, (), 0.0)


def solids_of(shape: Shape, surface: int, owner: int) -> list[Solid]:
    """Solids of a shape.

    Args:
        shape: The settings.
        surface: Number of its surface in the table.
        owner: Number of the obstacle.
    """
    return [Solid(*body, surface, 0.0, owner) for body in shape.bodies()]
