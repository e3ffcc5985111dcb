"""Nearest points of a ring to a shape that is given by its signed distance alone.

The distance along a ring can have several minima: a ring straddles an edge, or lies across a pole.
At each, the slope changes from negative to positive.  The slope is the component of the outward
normal along the ring, so a minimum is found as a bracketed root, which cannot diverge, and to the
last digits, which a search on distances cannot reach: near a minimum they vary with the square of
the offset.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.obstacles import InBodyFrame, outward_normal, signed_distance
from springback.kernels.compiler import called_kernel, generic, kernel
from springback.kernels.vectors import Vec

#: Gap to a shape that cannot be touched [m].
FAR = 1e9
#: Arcs of a ring, each sampled at one distance, and steps in which the slope is followed along the
#: relevant ones: 2.8 deg (chosen: in 300 000 random rings at poles of 0.5 to 5 mm, steps of 7.5 deg
#: miss a lower minimum beside another one 20 times, by up to 0.5 mm).
ARCS, STEPS = 32, 4
#: A distance changes by no more than the path length, here from the middle of an arc to its end;
#: 5 % more, as a shape's own functions may be inexact (`springback.scenario.user.obstacles`).
REACH = 1.05 * math.pi / ARCS
#: Slopes below this count as zero: those of a ring that lies flat are rounding (chosen).
FLAT = 1e-12
#: A minimum is bracketed to this fraction of a step, some 5e-12 m ...
CLOSE = 1e-9
#: ... in at most this many evaluations: one more than bisection takes.
TRIES = math.ceil(math.log2(1.0 / CLOSE)) + 1
#: Truncation of the method of Oliveira and Takahashi (chosen: theirs).
TRUNCATION = 0.2
#: Steps of each kind towards the point of a disc that is nearest to a shape (chosen: hits are then
#: seen, and other gaps known to 2 mm; tests/contact/test_propellers.py).
PROJECTIONS = 16
#: Preference for the arm's end, where the distance is constant.
ASIDE = 1e-9


class Direction(NamedTuple):
    """A unit vector in the plane of the arms."""

    x: float
    y: float


def turn_of(arcs: float) -> Direction:
    """Direction at some number of arcs from the first axis."""
    angle = 2.0 * math.pi * arcs / ARCS
    return Direction(math.cos(angle), math.sin(angle))


#: Steps around a ring in which a saddle is looked for.
SHORTS = 64
_SHORT = turn_of(ARCS / SHORTS)
_STEP, _HALF, _ARC = turn_of(1.0 / STEPS), turn_of(0.5), turn_of(1.0)
#: Parts of a step in which the slope is followed beside the lowest point, and how much lower
#: another one is [m] (chosen: a window's frame has two within one step in 1 of 10 000 poses).
PARTS, LOWER = 4, 1e-9
_PART, _BACK = turn_of(1.0 / (STEPS * PARTS)), turn_of(-1.0 / STEPS)


class LowPoint(NamedTuple):
    """A point of a ring by its direction from the centre, and its distance from the shape.

    Beneath an outward edge the distance has a kink: the point is then the lowest where two faces
    are equally far.  As the ring moves, that distance changes by a mean of both normals, weighted
    so that its slope along the ring is zero; it is shorter than 1.
    """

    towards: Direction
    gap: float  # [m]
    normal: Vec  # outward: gradient of the lowest distance by the ring's motion


class LowPoints(NamedTuple):
    """The two lowest minima of a distance along a ring; a gap of `FAR` if there is no second.

    Between two points inside the shape the ring may stay inside, as where it lies almost flat on a
    face.  The second then touches as deep as it is below the saddle: as both merge, it fades out.
    """

    first: LowPoint
    second: LowPoint
    saddle: LowPoint  # the highest point on the way from one to the other, if inside; else `FAR`


class InverseShape(NamedTuple):
    """A shape with its inside out: its lowest points are the highest of the shape."""

    shape: Any


@signed_distance.register(InverseShape)
@kernel
def _opposite_distance(opposite: InverseShape, point: Vec) -> float:
    return -signed_distance(opposite.shape, point)


@outward_normal.register(InverseShape)
@kernel
def _opposite_normal(opposite: InverseShape, point: Vec) -> Vec:
    return -outward_normal(opposite.shape, point)


@kernel
def direction_of(x: float, y: float) -> Direction:
    """Direction of a vector in the plane of the arms."""
    scale = 1.0 / math.sqrt(x * x + y * y)
    return Direction(x * scale, y * scale)


@kernel
def rotate(towards: Direction, by: Direction) -> Direction:
    """Direction turned by the angle of another one."""
    return Direction(towards.x * by.x - towards.y * by.y, towards.x * by.y + towards.y * by.x)


@kernel
def on_ring(centre: Vec, radius: float, towards: Direction) -> Vec:
    """Point of a ring in some direction from its centre [m]."""
    return Vec(centre.x + radius * towards.x, centre.y + radius * towards.y, centre.z)


@kernel
def _distance(shape: Any, centre: Vec, radius: float, towards: Direction) -> float:
    return signed_distance(shape, on_ring(centre, radius, towards))


@kernel
def _rise(shape: Any, centre: Vec, radius: float, towards: Direction) -> float:
    """Slope of the distance along the ring; positive where it is flat."""
    n = outward_normal(shape, on_ring(centre, radius, towards))
    return n.y * towards.x - n.x * towards.y + FLAT


@kernel
def between(a: Direction, b: Direction, share: float) -> Direction:
    """Direction between two, at some share of the way from the first to the second."""
    return direction_of(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))


@called_kernel
def turning_point(
    shape: Any, centre: Vec, radius: float, a: Direction, b: Direction, falls: float, rises: float
) -> LowPoint:
    """Point of a ring, between two directions, where the distance turns from falling to rising.

    Method of I. F. D. Oliveira and R. H. C. Takahashi, "An enhancement of the bisection method
    average performance preserving minmax optimality", ACM Trans. Math. Softw. 47 (2020): a secant,
    held so close to the middle that bisection's bound is preserved.

    Args:
        shape: As for `lowest_on_ring`.
        centre: As for `lowest_on_ring`.
        radius: As for `lowest_on_ring`.
        a: The first direction ...
        b: ... and the second one, less than half a turn farther.
        falls: The slope at the first, below zero.
        rises: The slope at the second, not below zero.
    """
    low, high, allowed = 0.0, 1.0, 1.0
    for _ in range(TRIES):
        width = high - low
        if width <= CLOSE:
            break
        middle = 0.5 * (low + high)
        secant = (rises * low - falls * high) / (rises - falls)
        inward = TRUNCATION * width * width
        aside = middle - secant
        tried = secant + math.copysign(inward, aside) if inward <= abs(aside) else middle
        room = max(allowed - 0.5 * width, 0.0)
        share = min(max(tried, middle - room), middle + room)
        allowed *= 0.5
        slope = _rise(shape, centre, radius, between(a, b, share))
        if slope < 0.0:
            low, falls = share, slope
        else:
            high, rises = share, slope
    before, after = rises / (rises - falls), falls / (falls - rises)
    there = between(a, b, low * before + high * after)
    n_low = outward_normal(shape, on_ring(centre, radius, between(a, b, low)))
    n_high = outward_normal(shape, on_ring(centre, radius, between(a, b, high)))
    gap = signed_distance(shape, on_ring(centre, radius, there))
    return LowPoint(there, gap, before * n_low + after * n_high)


@kernel
def _is_before(a: Direction, b: Direction) -> bool:
    """True if the first angle, from 0 to a full turn, is less than the second."""
    lower, other = a.y < 0.0, b.y < 0.0
    return other if lower != other else a.x * b.y - a.y * b.x > 0.0


@called_kernel
def _highest_between(
    shape: Any, centre: Vec, radius: float, first: Direction, last: Direction
) -> LowPoint:
    """Highest point inside a shape along a ring, counterclockwise from one direction to another.

    Its gap is `FAR` if the ring is outside somewhere.
    """
    end = rotate(last, Direction(first.x, -first.y))
    ahead, best, highest, before, after = _SHORT, first, -FAR, first, last
    there = first
    for _ in range(SHORTS):
        if not _is_before(ahead, end) or highest >= 0.0:
            break
        earlier, there = there, rotate(first, ahead)
        gap = _distance(shape, centre, radius, there)
        ahead = rotate(ahead, _SHORT)
        if gap > highest:
            best, highest, before = there, gap, earlier
            after = rotate(there, _SHORT) if _is_before(ahead, end) else last
    if highest >= 0.0 or highest == -FAR:
        return LowPoint(first, FAR if highest >= 0.0 else highest, Vec(0.0, 0.0, 1.0))
    # At a minimum the slope has no sign: the bracket ends halfway to it.
    opposite, a, b = InverseShape(shape), before, after
    if (a.x == first.x) & (a.y == first.y):
        a = between(first, best, 0.5)
    if (b.x == last.x) & (b.y == last.y):
        b = between(best, last, 0.5)
    falls, rises = _rise(opposite, centre, radius, a), _rise(opposite, centre, radius, b)
    if falls < 0.0 <= rises:
        found = turning_point(opposite, centre, radius, a, b, falls, rises)
        return LowPoint(found.towards, min(-found.gap, 0.0), -found.normal)
    return LowPoint(best, highest, outward_normal(shape, on_ring(centre, radius, best)))


@generic
def has_ridges(shape: Any) -> bool:
    """True if points outside a shape can be as near to two parts of it: it is not convex.

    The distance then has ridges, across which its slope falls, and so two minima within a step.
    Of the user's own shapes nothing is known; they are taken for convex.
    """
    return False


@has_ridges.register(InBodyFrame)
@kernel
def _seen_has_ridges(view: InBodyFrame) -> bool:
    return has_ridges(view.shape)


@called_kernel
def lower_beside(shape: Any, centre: Vec, radius: float, lowest: LowPoint, steps: int) -> LowPoint:
    """A minimum within some steps of the lowest one that is lower still; else that one.

    Args:
        shape: As for `lowest_on_ring`.
        centre: As for `lowest_on_ring`.
        radius: As for `lowest_on_ring`.
        lowest: The lowest that is known.
        steps: How many to either side.
    """
    best, a = lowest, lowest.towards
    for _ in range(steps):
        a = rotate(a, _BACK)
    falls = _rise(shape, centre, radius, a)
    for _ in range(2 * PARTS * steps):
        b = rotate(a, _PART)
        rises = _rise(shape, centre, radius, b)
        if falls < 0.0 <= rises:
            found = turning_point(shape, centre, radius, a, b, falls, rises)
            if found.gap < best.gap - LOWER:
                best = found
        a, falls = b, rises
    return best


@called_kernel
def lowest_on_ring(shape: Any, centre: Vec, radius: float, outward: Vec) -> LowPoints:
    """The two lowest minima of a signed distance along a ring in the plane of the arms.

    The slope is followed only along arcs that can hold the lowest point, or touch: a distance
    changes by no more than the path length.  A second minimum may be omitted if a lower point is
    within one step of it.

    Args:
        shape: In the body frame.
        centre: Centre of the ring [m].
        radius: Radius of the ring [m].
        outward: The direction that counts as lowest if the ring lies flat: that of the arm.
    """
    n = outward_normal(shape, centre)
    guess = direction_of(ASIDE * outward.x - n.x, ASIDE * outward.y - n.y)
    there = on_ring(centre, radius, guess)
    level = LowPoint(guess, signed_distance(shape, there), outward_normal(shape, there))
    first = second = LowPoint(guess, FAR, level.normal)
    lowest = level.gap
    begin = Direction(1.0, 0.0)
    for _ in range(ARCS):
        middle = _distance(shape, centre, radius, rotate(begin, _HALF))
        lowest = min(lowest, middle)
        if middle - REACH * radius <= max(lowest, 0.0):
            a, falls = begin, _rise(shape, centre, radius, begin)
            for _ in range(STEPS):
                b = rotate(a, _STEP)
                rises = _rise(shape, centre, radius, b)
                if falls < 0.0 <= rises:
                    found = turning_point(shape, centre, radius, a, b, falls, rises)
                    if found.gap < first.gap:
                        first, second = found, first
                    elif found.gap < second.gap:
                        second = found
                a, falls = b, rises
        begin = rotate(begin, _ARC)
    if has_ridges(shape) and first.gap < FAR:
        first = lower_beside(shape, centre, radius, first, 1)
    return with_saddle(shape, centre, radius, first if first.gap < FAR else level, second)


@kernel
def lowest_in_disc(shape: Any, centre: Vec, radius: float) -> float:
    """Least signed distance within a disc in the plane of the arms [m].

    For convex shapes it is 0 or less wherever the disc meets them, and else nearly the least: steps
    to where the distance would be 0 on a straight slope lead there (B. T. Polyak, "Minimization of
    unsmooth functionals", 1969), and projections on shape and disc, one after the other, to their
    nearest points (W. Cheney and A. A. Goldstein, "Proximity maps for convex sets", 1959).  For
    other shapes it is a distance within the disc, which may not be the least.

    Args:
        shape: In the body frame.
        centre: Of the disc [m].
        radius: Of the disc [m].
    """
    least = lowest_on_ring(shape, centre, radius, Vec(1.0, 0.0, 0.0)).first.gap
    x, y, best_x, best_y, nearest = 0.0, 0.0, 0.0, 0.0, FAR
    for k in range(2 * PROJECTIONS):
        point = Vec(centre.x + x, centre.y + y, centre.z)
        gap, n = signed_distance(shape, point), outward_normal(shape, point)
        if gap < nearest:
            nearest, best_x, best_y = gap, x, y
        stride = gap
        if k < PROJECTIONS:
            stride = gap / max(n.x * n.x + n.y * n.y, FLAT)
        elif k == PROJECTIONS:
            x, y, stride = best_x, best_y, 0.0
        x, y = x - stride * n.x, y - stride * n.y
        away = math.sqrt(x * x + y * y)
        inward = radius / away if away > radius else 1.0
        x, y = x * inward, y * inward
    return min(least, nearest)


@kernel
def with_saddle(
    shape: Any, centre: Vec, radius: float, first: LowPoint, second: LowPoint
) -> LowPoints:
    """The two lowest minima, and the saddle between them if both are inside.

    Args:
        shape: As for `lowest_on_ring`.
        centre: As for `lowest_on_ring`.
        radius: As for `lowest_on_ring`.
        first: The lowest.
        second: The next one; a gap of `FAR` if there is none.
    """
    saddle = LowPoint(first.towards, FAR, first.normal)
    if second.gap < 0.0:
        one = _highest_between(shape, centre, radius, first.towards, second.towards)
        other = _highest_between(shape, centre, radius, second.towards, first.towards)
        saddle = one if one.gap < other.gap else other
    return LowPoints(first, second, saddle)
