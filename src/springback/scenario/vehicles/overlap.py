"""Guards of different arms that are in each other while the arms rest.

Parts of one vehicle do not touch here, so that guards which overlap fly like ghosts.  A ring counts
as the disc within it, all else as the convex body that it is.  How deep two bodies A and B are in
each other is how far B must be moved along the line u of their middles, away from A, until a plane
is between them: the least of h_A(n) + h_B(−n) over all n with n · u = 1, where h is the support of
a body from one origin.  That is a convex function of two numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.vehicle.hulls import CIRCLE, HullForm
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Depth from which on guards that overlap are told [m] (chosen: shells may touch).
TOLD = 1e-3
#: Least share of a normal along the line of both middles (chosen: flatter planes are not tried).
LEAST_ALONG = 1e-3
#: Middles that are closer are at one place [m].
SAME_PLACE = 1e-9


class GuardOverlap(NamedTuple):
    """Two guards that are in each other."""

    first: str
    """In words, with its field."""
    second: str
    """Likewise."""
    depth: float
    """How deep they are in each other along the line of their middles [m]."""


class _Guard(NamedTuple):
    """A hull or cage at the end of an arm, arms at rest."""

    name: str
    arm: int  # from 1
    is_cage: bool
    form: HullForm
    end: Array  # of its arm, from the main body [m]

    @property
    def middle(self) -> Array:
        return self.end + self.form.middle()


def guard_overlaps(vehicle: Vehicle) -> list[GuardOverlap]:
    """Guards of different arms that are in each other at rest, the deepest first.

    Two cages are not looked at: those that overlap are refused.

    Args:
        vehicle: Its arms are at their free length.
    """
    found = []
    for one, other in combinations(_guards(vehicle), 2):
        if one.arm == other.arm or (one.is_cage and other.is_cage):
            continue
        apart = float(np.linalg.norm(one.middle - other.middle))
        if apart > one.form.around() + other.form.around() - TOLD:
            continue
        if (depth := _depth(one, other)) > TOLD:
            found.append(GuardOverlap(one.name, other.name, depth))
    return sorted(found, key=lambda pair: -pair.depth)


def overlap_warnings(vehicle: Vehicle) -> list[str]:
    """A sentence on the guards that are deepest in each other at rest, if any are."""
    found = guard_overlaps(vehicle)
    if not found:
        return []
    first, second, depth = found[0]
    more = f", and {len(found) - 1} more pairs overlap" if len(found) > 1 else ""
    return [
        f"{first} and {second} are {1e3 * depth:.3g} mm inside each other at rest{more}: parts of "
        "one vehicle do not touch here; smaller guards, longer arms or other directions keep them "
        "apart"
    ]


def _guards(vehicle: Vehicle) -> Iterator[_Guard]:
    """Hulls and cages at the ends of arms."""
    ends = [np.array(vehicle.arms.end(j)) for j in range(vehicle.arm_count)]
    for k, hull in enumerate(vehicle.hulls):
        if hull.on != "body":
            arm = int(hull.on)
            name = f"vehicle.hulls[{k}], the {hull.type} on arm {arm},"
            yield _Guard(name, arm, False, hull.form(), ends[arm - 1])
    for j, end in enumerate(ends if vehicle.arms.cages else ()):
        radius = float(vehicle.arms.at("cage_radius", j))
        form = HullForm(CIRCLE, radius, np.zeros(3), np.eye(3), np.zeros((0, 3)), [])
        yield _Guard(f"the cage of arm {j + 1}", j + 1, True, form, end)


def _depth(one: _Guard, other: _Guard) -> float:
    """How deep two guards are in each other along the line of their middles [m]; below 0: apart."""
    line = other.middle - one.middle
    size = float(np.linalg.norm(line))
    u = line / size if size > SAME_PLACE else np.array([1.0, 0.0, 0.0])
    across = np.linalg.svd(u[None])[2][1:]
    first, second = _support(one), _support(other)

    def room(n: Array) -> float:
        return first(n) + second(-n)

    def of_two(numbers: Array) -> float:
        return room(u + numbers @ across)

    normals = [*one.form.axes, *other.form.axes, *(f.normal for f in one.form.faces)]
    normals += [face.normal for face in other.form.faces]
    shares = [(n, float(n @ u)) for n in normals]
    tried = [u, *(n / share for n, share in shares if abs(share) > LEAST_ALONG)]
    best = min(tried, key=room)
    if room(best) <= 0.0:  # one plane between them is enough
        return room(best)
    found = scipy.optimize.minimize(
        of_two, across @ best, method="Nelder-Mead", options={"xatol": 1e-6, "fatol": 1e-7}
    )
    return float(min(room(best), found.fun))


def _support(guard: _Guard) -> Callable[[Array], float]:
    """Largest n · x of the points x of a guard, for a vector n of any length."""
    form, end = guard.form, guard.end

    def of_ring(n: Array) -> float:
        in_plane = form.axes[:2] @ n
        return float(n @ (end + form.centre)) + form.radius * math.hypot(*in_plane)

    def of_points(n: Array) -> float:
        return float((form.points @ n).max() + n @ end) + form.radius * float(np.linalg.norm(n))

    return of_ring if form.kind == CIRCLE else of_points
