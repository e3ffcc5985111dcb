"""Check of an obstacle of the user's own: its distance and normal, wherever it is."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy.spatial import KDTree

from springback.contact.obstacles import signed_distance
from springback.errors import InputError
from springback.kernels.vectors import Vec, norm
from springback.progress import Progress, silent
from springback.scenario.user.laws import laws_of_shape
from springback.scenario.user.obstacles import SHARE, SampledPoints, check_shape_from
from springback.studies.pilot_check import Finding

#: Distance of the points of view from the surface [m] (chosen: that of a vehicle before a contact).
AROUND = 0.3
#: Directions from the start in which a surface is looked for that is not reached along the
#: gradient, and how far, in strides of at least this [m] (chosen).
LOOKS, FARTHEST, STRIDE = 300, 30.0, 0.05
#: Distances from the nearest place at which others are looked for [m] (chosen).
SPREAD = (0.3, 1.0, 3.0)
#: Smallest distance of two places of the surface [m], and most of them (chosen: a second or two).
APART, MOST_PLACES = 0.2, 16
#: Step of finite differences, and distance within which the surface is reached [m] (chosen).
STEP, REACHED = 1e-5, 1e-3
#: Steps to the surface at most: a distance that is understated by half takes some 20.
WALK = 200
#: Farthest point of such a way from its beginning [m] (chosen).
STRAY = 1e4


def check_shape(shape: Any, start: Vec, *, progress: Progress = silent) -> list[Finding]:
    """Check the functions of a shape where a vehicle could touch it.

    From the start the surface is looked for along the gradient of the distance; where none is
    reached so, as where the distance is limited, in all directions.  From points around the nearest
    place others are looked for, up to `MOST_PLACES`.  Rays from the start, and from points around
    all places, then sample both functions
    (`springback.scenario.user.obstacles.check_shape_from`).  At all points on their ways the
    distance is compared with that from all places where the surface was met.  If nothing is wrong,
    both functions are compiled.

    Args:
        shape: A NamedTuple with `signed_distance` and `outward_normal`.
        start: Position of a vehicle, world [m].
        progress: Called with the fraction of the points done.

    Raises:
        InputError: If a function cannot be compiled, with file and line.
    """
    problems: list[str] = []
    places: list[Vec] = []
    try:
        places = _places(shape, start)
    except InputError as error:
        problems += error.problems
    views = [start, *(_around(places[0], AROUND) if places else ())]
    try:
        views += [view for place in places[1:] for view in _sides(shape, place)]
    except InputError as error:
        problems += error.problems
    seen: list[SampledPoints] = []
    for k, view in enumerate(views, start=1):
        try:
            seen.append(check_shape_from(view, shape, "shape"))
        except InputError as error:
            problems += error.problems
        progress(k / len(views))
    points = [point for one in seen for point in one.outside]
    if not problems:
        problems += _overstated(shape, points, [point for one in seen for point in one.surface])
    where = (
        f"met first at {_text(places[0])} m, along the gradient"
        if places
        else "no surface was reached"
    )
    if len(places) > 1:
        low, high = Vec(*map(min, *places)), Vec(*map(max, *places))
        where += f", sampled in {len(places)} places from {_text(low)} to {_text(high)} m"
    findings = [Finding("has a surface", bool(places), f"seen from {_text(start)} m: {where}")]
    for name, good in (
        (
            "signed_distance",
            f"finite, grows by 1 m a metre, and at the {len(points)} points looked at no more than "
            f"{100.0 * SHARE:g} % above that to where the surface was met",
        ),
        ("outward_normal", "1 long, and the gradient of signed_distance"),
    ):
        bad = [line for line in problems if line.startswith(f"shape: {name}")]
        fine = f"{good}, seen from {len(views)} points" if not problems else "no error before that"
        said = bad[0].partition(": ")[2] if bad else fine
        findings.append(Finding(name, not bad, said))
    named = tuple(f"shape: {finding.name}" for finding in findings)
    others = [line for line in problems if not line.startswith(named)]
    if others:
        findings.append(Finding("answers everywhere", False, others[0].partition(": ")[2]))
    if not problems:
        for law in laws_of_shape(shape, start):
            law.compile()
        findings.append(Finding("can be compiled", True, "as a flight needs it"))
    return findings


def _overstated(shape: Any, points: list[Vec], surface: list[Vec]) -> list[str]:
    """Problem with the point at which the returned distance is most above the true one, if any."""
    if not points or not surface:
        return []
    nearest = np.asarray(KDTree(np.array(surface)).query(np.array(points))[0])
    returned = np.array([_distance(shape, point) for point in points])
    above = returned - (1.0 + SHARE) * nearest - STEP
    worst = int(np.argmax(above))
    if above[worst] <= 0.0:
        return []
    return [
        f"shape: signed_distance at {_text(points[worst])} m is {returned[worst]:.6g} m, and its "
        f"surface is no farther than {nearest[worst]:.6g} m"
    ]


def _places(shape: Any, start: Vec) -> list[Vec]:
    """Places of the surface, none if there is none; first that which the gradient leads to.

    Where another part is nearer to the side than ahead, or the distance is a bound, this is not the
    nearest.
    """
    points = itertools.chain([start], _nearer(shape, start))
    reached = (_nearest(shape, point) for point in points)
    first = next((place for place in reached if place is not None), None)
    if first is None:
        return []
    found = [first]
    for point in (point for reach in SPREAD for point in _around(first, reach)):
        place = _nearest(shape, point)
        if place is not None and all(norm(place - other) > APART for other in found):
            found.append(place)
        if len(found) == MOST_PLACES:
            break
    return found


def _nearer(shape: Any, start: Vec) -> Iterator[Vec]:
    """Points on ways from the start at which the surface has come nearer."""
    there = abs(_distance(shape, start))
    for k in range(LOOKS):  # spread evenly over the sphere
        up, turn = 1.0 - (2.0 * k + 1.0) / LOOKS, math.pi * (3.0 - math.sqrt(5.0)) * k
        level = math.sqrt(1.0 - up * up)
        way, direction = 0.0, Vec(level * math.cos(turn), level * math.sin(turn), up)
        gap = there
        while way < FARTHEST and gap > 0.99 * there:
            way += max(gap, STRIDE)
            gap = abs(_distance(shape, start + direction * way))
        if way < FARTHEST:
            yield start + direction * way


def _sides(shape: Any, place: Vec) -> list[Vec]:
    """Points of view above and below a place of the surface; none at a ridge."""
    out = _slope(shape, place)
    if not norm(out) > 0.5:
        return []
    way = out * (AROUND / norm(out))
    return [place + way, place - way]


def _nearest(shape: Any, start: Vec) -> Vec | None:
    """Point of the surface that is reached along the gradient; None if there is none."""
    point = start
    for _ in range(WALK):
        gap = _distance(shape, point)
        if abs(gap) < REACHED:
            return point
        slope = _slope(shape, point)
        steepness = max(norm(slope), 1e-3)  # of a distance it is 1
        point = point - slope * (gap / steepness**2)
        if norm(point - start) > STRAY:
            break
    return None


def _slope(shape: Any, point: Vec) -> Vec:
    """Gradient of the distance, by central differences."""
    axes = (Vec(STEP, 0.0, 0.0), Vec(0.0, STEP, 0.0), Vec(0.0, 0.0, STEP))
    return Vec(
        *(
            (_distance(shape, point + axis) - _distance(shape, point - axis)) / (2.0 * STEP)
            for axis in axes
        )
    )


def _distance(shape: Any, point: Vec) -> float:
    try:
        value = signed_distance(shape, point)
    except Exception as error:
        what = " ".join(f"{type(error).__name__}: {error}".split())
        raise InputError(f"shape: signed_distance at {_text(point)} m raises {what}") from error
    if not isinstance(value, float) or not math.isfinite(value):
        raise InputError(f"shape: signed_distance at {_text(point)} m is {value!r}, not finite")
    return value


def _around(point: Vec, reach: float) -> Iterator[Vec]:
    """Points around another at some distance [m], along axes and diagonals."""
    for x, y, z in itertools.product((-1.0, 0.0, 1.0), repeat=3):
        if (count := abs(x) + abs(y) + abs(z)) in (1.0, 3.0):
            yield point + Vec(x, y, z) * (reach / count**0.5)


def _text(point: Vec) -> str:
    return f"[{', '.join(f'{part:.4g}' for part in point)}]"
