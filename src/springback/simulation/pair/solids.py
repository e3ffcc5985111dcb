"""What the parts of a vehicle are to another vehicle that meets them: solids.

A cage is a disc as large as its circle, with rounded edges: between its rim and its propeller
nothing passes.  Hulls are what they are, but a ring, which has no thickness, is a thin rod.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.contact.hulls.series import HullLaw, hull_law, in_series
from springback.contact.scene.faces import SolidScene
from springback.contact.scene.solids import BOX, CAPSULE, FRUSTUM, TORUS
from springback.contact.scene.table import Solid, scene_of
from springback.contact.shapes import axes_along
from springback.contact.surfaces import Surface, remembers
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, rotation
from springback.vehicle.force_laws import RIGID
from springback.vehicle.hulls import BoxHull, CapsuleHull, RingHull, SphereHull
from springback.vehicle.parameters import Hull, Vehicle

#: Height of a cage as a disc, and radius of its edges [m] (chosen: a guard with its motor); pressed
#: in deeper than half the height, it gives way across its plane.
HEIGHT, EDGE = 0.04, 0.012
#: Radius of the rod of which a ring is [m] (chosen).
ROD = 0.012


class PartSolid(NamedTuple):
    """A solid of a part of a vehicle, and the surface that it has itself."""

    solid: Solid  # in body axes, from the main body or the end of the arm
    law: HullLaw


def solids_of(vehicle: Vehicle) -> tuple[tuple[PartSolid, ...], ...]:
    """Solids of each arm of a vehicle, then of its main body if that can touch.

    The distance of a hull of points is not known: a sphere around it, which nothing may touch,
    tells how far it reaches.
    """
    rigid = hull_law(RIGID)
    parts = []
    for j in range(vehicle.arm_count):
        disc = PartSolid(_disc(vehicle.arms.at("cage_radius", j)), rigid)
        cage = (disc,) if vehicle.arms.cages else ()
        parts.append((*cage, *map(_of_hull, vehicle.hulls_on(j + 1))))
    if vehicle.has_body_hull:
        ball = () if vehicle.hull is None else (PartSolid(_ball(vehicle.hull), rigid),)
        parts.append((*ball, *map(_of_hull, vehicle.hulls_on("body"))))
    return tuple(parts)


def reach_of_part(part: tuple[PartSolid, ...]) -> float:
    """Distance of the farthest point of a part from its origin [m], or a little more."""
    reach = [
        float(np.linalg.norm(one.solid.centre) + np.linalg.norm(one.solid.half_lengths()))
        for one in part
    ]
    return max(reach, default=0.0)


def scene_of_part(part: tuple[PartSolid, ...], surface: Surface) -> SolidScene:
    """A part as a scene.

    Args:
        part: Its solids.
        surface: Of the contact between both vehicles.
    """
    solids = [one.solid._replace(surface=k) for k, one in enumerate(part)]
    return scene_of(solids, [in_series(surface, one.law) for one in part])


def remember(surface: Surface, solids: tuple[tuple[PartSolid, ...], ...]) -> bool:
    """True if a contact between two vehicles has a memory.

    Args:
        surface: Of the contact.
        solids: Of the parts that are touched.
    """
    laws = [one.law.hysteresis for part in solids for one in part]
    return remembers(surface) or any(law.shape > 0.0 or law.curve > 0.0 for law in laws)


def _solid(
    kind: float, centre: Any, axes: Any, sizes: tuple[float, ...], rounding: float = 0.0
) -> Solid:
    return Solid(kind, np.array(centre), np.array(axes), sizes, rounding, 0, 0.0, 0)


def _disc(radius: float) -> Solid:
    edge = min(EDGE, 0.5 * radius)  # of a cage of a few centimetres
    flat, half = radius - edge, 0.5 * HEIGHT - edge
    return _solid(FRUSTUM, np.zeros(3), np.eye(3), (flat, flat, half), edge)


def _ball(hull: Hull | SphereHull) -> Solid:
    centre = hull.offset if isinstance(hull, Hull) else hull.position
    return _solid(CAPSULE, centre, np.eye(3), (0.0, hull.radius))


def _of_hull(hull: Any) -> PartSolid:
    law = hull_law(RIGID if hull.surface is None else hull.surface.numbers())
    return PartSolid(_solid_of_hull(hull), law)


def _solid_of_hull(hull: Any) -> Solid:
    form = hull.form()
    if isinstance(hull, SphereHull):
        return _ball(hull)
    if isinstance(hull, RingHull):
        return _solid(TORUS, form.centre, form.axes, (hull.radius, ROD))
    if isinstance(hull, CapsuleHull):
        start, end = form.points
        half = 0.5 * float(np.linalg.norm(end - start))
        return _solid(CAPSULE, 0.5 * (start + end), axes_along(end - start), (half, hull.radius))
    if isinstance(hull, BoxHull):
        turn = rotation(Quat(*attitude_from_euler(hull.roll, hull.pitch, hull.yaw)))
        inner = tuple(0.5 * length - hull.edge_radius for length in hull.size)
        return _solid(BOX, hull.position, np.array(turn).T, inner, hull.edge_radius)
    return _solid(CAPSULE, form.middle(), np.eye(3), (0.0, form.around()))
