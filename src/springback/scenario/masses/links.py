"""Links of a robot's model, which of them belong together, and what each weighs."""

from __future__ import annotations

import fnmatch
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from springback.errors import InputError
from springback.scenario.worlds.poses import Array, FramePose
from springback.scenario.worlds.xml_text import XmlNode


class LinkMass(NamedTuple):
    """Mass of a link, of a kind that `springback.vehicle.mass.parts.properties_of` adds up."""

    mass: float  # [kg]
    place: Array  # of its centre of mass [m]
    moments: Array  # about that [kg m²], shape (3, 3)

    def centre(self) -> Array:
        """Centre of mass [m]."""
        return self.place

    def own_inertia(self) -> Array:
        """About the centre of mass [kg m²]."""
        return self.moments

    def placed_at(self, pose: FramePose) -> LinkMass:
        """The same mass in the frame in which its own frame has a pose."""
        turned: Array = pose.turn @ self.moments @ pose.turn.T
        return LinkMass(self.mass, pose.turn @ self.place + pose.place, turned)


#: Of a link that weighs nothing.
MASSLESS = LinkMass(0.0, np.zeros(3), np.zeros((3, 3)))


class ModelLink(NamedTuple):
    """A link, or a body of MJCF."""

    name: str
    node: XmlNode
    pose: FramePose  # in the frame of the model
    is_fixed: bool  # to the first link, by joints that do not move
    mass: Callable[[], LinkMass]  # in its own frame, read when it is asked for


def chosen_links(
    links: Sequence[ModelLink], patterns: Sequence[str], root: XmlNode
) -> list[ModelLink]:
    """Links whose names fit, or without patterns the first and all that are fixed to it.

    Args:
        links: All of a model.
        patterns: Names, or patterns of them such as ``rotor_*``.
        root: Outermost element of the file, for errors.

    Raises:
        InputError: If a pattern fits none.
    """
    for pattern in patterns:
        if not any(fnmatch.fnmatchcase(link.name, pattern) for link in links):
            names = ", ".join(link.name for link in links[:20])
            more = ", ..." if len(links) > 20 else ""
            raise InputError(f"{root.file}: has no link {pattern!r}; there are: {names}{more}")
    if not patterns:
        return [link for link in links if link.is_fixed]
    return [
        link for link in links
        if any(fnmatch.fnmatchcase(link.name, pattern) for pattern in patterns)
    ]  # fmt: skip


def symmetric(moments: Sequence[float], products: Sequence[float]) -> Array:
    """Inertia of moments xx, yy, zz and elements xy, xz, yz [kg m²]."""
    (xx, yy, zz), (xy, xz, yz) = moments, products
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
