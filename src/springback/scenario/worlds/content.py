"""What is in a file of another program: elements that become obstacles, and what does not."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.contact.shapes import EDGE
from springback.errors import InputError
from springback.scenario.worlds.poses import FramePose

#: Most elements of a world (chosen: as many as obstacles of a scenario).
MOST_ELEMENTS = 10_000
#: Largest coefficient of friction that is taken over (chosen: files write 100 or 1e5 for "does not
#: slip", which no step of a regularised law can follow).
MOST_FRICTION = 2.0
#: How level a plane must be to be the ground: size of its normal's horizontal part (chosen).
LEVEL = 1e-9

Table = dict[str, Any]


class WorldElement(NamedTuple):
    """An element with a shape, as a built-in obstacle in the frame of the file."""

    name: str
    table: Table  # a raw obstacle without surface
    friction: float | None  # of the file


class WorldRemark(NamedTuple):
    """An element that cannot be represented, or is so in another way."""

    name: str
    reason: str


class WorldContent(NamedTuple):
    """All that was found in a file."""

    elements: tuple[WorldElement, ...]
    missing: tuple[WorldRemark, ...]
    """What vehicles could hit, and is not represented."""
    remarks: tuple[WorldRemark, ...]
    """What is represented in another way than the file has it, by name."""
    ignored: tuple[tuple[str, int], ...]
    """What nothing can hit, by kind, and how many."""
    files: tuple[Path, ...]
    """All that was read."""


class Collector:
    """Content of a file while it is read."""

    def __init__(self, path: Path, search: Sequence[Path], kinds: Sequence[str]) -> None:
        """Collect what is in a file.

        Args:
            path: Of the file.
            search: Folders in which what it names is sought.
            kinds: Types of built-in obstacles.
        """
        self.path = path
        self.search = (path.parent, *search)
        self.kinds = frozenset(kinds)
        self.files: list[Path] = [path]
        self._elements: list[WorldElement] = []
        self._missing: list[WorldRemark] = []
        self._remarks: list[WorldRemark] = []
        self._ignored: Counter[str] = Counter()
        self._names: Counter[str] = Counter()

    def content(self) -> WorldContent:
        """All that was found."""
        return WorldContent(
            tuple(self._elements), tuple(self._missing), tuple(self._remarks),
            tuple(self._ignored.items()), tuple(dict.fromkeys(self.files)),
        )  # fmt: skip

    def add(self, name: str, table: Table, friction: float | None = None) -> None:
        """Add an element.

        Raises:
            InputError: If there are too many.
        """
        if table["type"] not in self.kinds:
            self.leave_out(name, f"{table['type']} is no obstacle of this version of springback")
            return
        if len(self._elements) >= MOST_ELEMENTS:
            raise InputError(
                f"{self.path}: has more than {MOST_ELEMENTS} elements; no more are read"
            )
        if friction is not None and friction > MOST_FRICTION:
            what = f"friction {friction:g} of the file is taken as {MOST_FRICTION:g}"
            self.remark(name, what)
            friction = MOST_FRICTION
        self._elements.append(WorldElement(self._own_name(name), table, friction))

    def leave_out(self, name: str, reason: str) -> None:
        """Note what cannot be represented, and why."""
        self._missing.append(WorldRemark(name, reason))

    def remark(self, name: str, what: str) -> None:
        """Note what is represented in another way."""
        self._remarks.append(WorldRemark(name, what))

    def ignore(self, kind: str, count: int = 1) -> None:
        """Count what nothing can hit."""
        self._ignored[kind] += count

    def _own_name(self, name: str) -> str:
        """A name, with a number if others had it before."""
        self._names[name] += 1
        return name if self._names[name] == 1 else f"{name} ({self._names[name]})"

    # -- shapes, by the numbers that files give ---------------------------------------------------

    def box(
        self, name: str, pose: FramePose, size: Sequence[float], friction: float | None = None
    ) -> None:
        """A box of whole lengths [m]."""
        roll, pitch, yaw = pose.angles()
        table: Table = {"type": "box", "position": pose.place.tolist(), "size": list(size)}
        table |= _turned(roll, pitch, yaw) | _edge(min(size))
        self.add(name, table, friction)

    def sphere(
        self, name: str, pose: FramePose, radius: float, friction: float | None = None
    ) -> None:
        """A sphere of some radius [m]."""
        table = {"type": "sphere", "position": pose.place.tolist(), "radius": radius}
        self.add(name, table, friction)

    def cylinder(
        self, name: str, pose: FramePose, radius: float, length: float,
        friction: float | None = None,
    ) -> None:  # fmt: skip
        """A cylinder about the frame's third axis, centred [m]: a pole with flat ends."""
        table: Table = {
            "type": "pole", "position": pose.point(0.0, 0.0, -0.5 * length), "radius": radius,
            "height": length, "axis": pose.turn[:, 2].tolist(),
        }  # fmt: skip
        self.add(name, table | _edge(min(length, 2.0 * radius)), friction)

    def capsule(
        self, name: str, pose: FramePose, radius: float, length: float,
        friction: float | None = None,
    ) -> None:  # fmt: skip
        """A capsule about the frame's third axis; the length is without its round ends [m]."""
        table = {
            "type": "capsule", "start": pose.point(0.0, 0.0, -0.5 * length),
            "end": pose.point(0.0, 0.0, 0.5 * length), "radius": radius,
        }  # fmt: skip
        self.add(name, table, friction)

    def cone(
        self, name: str, pose: FramePose, radius: float, length: float,
        friction: float | None = None,
    ) -> None:  # fmt: skip
        """A cone about the frame's third axis, its origin halfway up [m]."""
        table: Table = {
            "type": "cone", "position": pose.point(0.0, 0.0, -0.5 * length), "radius": radius,
            "height": length, "axis": pose.turn[:, 2].tolist(),
        }  # fmt: skip
        self.add(name, table | _edge(0.2 * min(length, radius)), friction)

    def ellipsoid(
        self, name: str, pose: FramePose, radii: Sequence[float], friction: float | None = None
    ) -> None:
        """An ellipsoid, which is represented if it is a sphere."""
        if max(radii) - min(radii) <= LEVEL * max(radii):
            self.sphere(name, pose, radii[0], friction)
        else:
            shown = " x ".join(f"{radius:g}" for radius in radii)
            self.leave_out(name, f"is an ellipsoid of radii {shown} m")

    def plane(
        self, name: str, pose: FramePose, normal: Sequence[float], friction: float | None = None
    ) -> None:
        """A plane without end: the ground if it is level and faces up, else a wall."""
        up = pose.turn @ np.array(normal) / math.hypot(*normal)
        if up[2] > 0.0 and math.hypot(up[0], up[1]) <= LEVEL:
            self.add(name, {"type": "ground", "height": float(pose.place[2])}, friction)
            return
        table = {"type": "wall", "position": pose.place.tolist(), "normal": up.tolist()}
        self.add(name, table, friction)

    def mesh(
        self, name: str, pose: FramePose, file: Path, scale: float,
        friction: float | None = None,
    ) -> None:  # fmt: skip
        """A mesh of a file, of which a unit is ``scale`` metres."""
        roll, pitch, yaw = pose.angles()
        table: Table = {"type": "mesh", "file": str(file), "position": pose.place.tolist()}
        table |= _turned(roll, pitch, yaw) | ({} if scale == 1.0 else {"scale": scale})
        self.files.append(file)
        self.add(name, table, friction)


def _turned(roll: float, pitch: float, yaw: float) -> Table:
    """Angles that are not zero [rad]."""
    angles = {"roll": roll, "pitch": pitch, "yaw": yaw}
    return {key: angle for key, angle in angles.items() if angle}


def _edge(thinnest: float) -> Table:
    """Radius of the edges of what is too thin for the usual one [m]."""
    return {} if thinnest >= 4.0 * EDGE else {"edge_radius": 0.25 * thinnest}
