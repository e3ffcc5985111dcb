"""Lowest points of straight edges and flat faces of a hull above a shape, by its distance alone.

Along an edge the slope of the distance is the component of the outward normal; its zero is found as
a bracketed root, as along a ring (`springback.contact.rings`).  On a face the lowest point of each
chord is found so, and then the lowest of all chords.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from springback.contact.hulls.chords import Chord, chord_at
from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.rings import CLOSE, FAR, LOWER, PARTS, TRIES, TRUNCATION
from springback.contact.scene.sections import Face
from springback.kernels.compiler import generic, kernel, rare_kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec, within
from springback.vehicle.hulls import FACE

#: Slopes closer to zero count as level: those of an edge that lies flat are rounding (chosen).
LEVEL = 1e-9
#: Parts of an edge in which a lowest point is looked for above a shape that is not convex, and
#: points between two places at which a way that leaves the shape is looked for (chosen).
PIECES, WAYPOINTS = 16, 8
#: A distance changes by no more than this per metre: a spline by a little more than 1 (chosen).
STEEPEST = 1.1
#: Chords of a face, and points on each, above a shape that is not convex (chosen).
GRID = 12
#: Steps of the grid within which there is one lowest point (chosen).
BASIN = 1.0
#: Times that the lowest of these points is looked for again on a grid half as wide (chosen).
ZOOMS = 4
#: Times that they are followed out of the part of a face in which they were looked for, which then
#: is twice as wide, and the share of it that counts as its rim (chosen).
MOVES, RIM = 8, 1e-3
#: Chords begin and end this share of a face's width inside it: at a corner they have no length.
INSIDE = 1e-9


@generic
def near_face(shape: Any, point: Vec) -> Face:
    """Distance of a point from a shape, and the outward normal there."""
    return Face(signed_distance(shape, point), outward_normal(shape, point))


class EdgePoint(NamedTuple):
    """A point of an edge or a face, and its distance from a shape.

    Beneath an outward edge of the shape the distance has a kink: the normal is then a mean of those
    of both faces, shorter than 1, as at a `springback.contact.rings.LowPoint`.
    """

    point: Vec  # [m]
    gap: float  # [m]
    normal: Vec


@kernel
def no_point(point: Vec) -> EdgePoint:
    """No lowest point inside an edge."""
    return EdgePoint(point, FAR, Vec(0.0, 0.0, 1.0))


class Bracket(NamedTuple):
    """Where a slope turns from falling to rising: shares of a way, and slopes there."""

    low: float
    high: float
    falls: float  # < 0
    rises: float  # ≥ 0
    allowed: float


@kernel
def narrower(b: Bracket, share: float, slope: float) -> Bracket:
    """A bracket after one more slope is known."""
    if slope < 0.0:
        return Bracket(share, b.high, slope, b.rises, 0.5 * b.allowed)
    return Bracket(b.low, share, b.falls, slope, 0.5 * b.allowed)


@kernel
def next_share(b: Bracket) -> float:
    """Where to look next, by the method of Oliveira and Takahashi; see `rings`."""
    width, middle = b.high - b.low, 0.5 * (b.low + b.high)
    secant = (b.rises * b.low - b.falls * b.high) / (b.rises - b.falls)
    inward = TRUNCATION * width * width
    aside = middle - secant
    tried = secant + math.copysign(inward, aside) if inward <= abs(aside) else middle
    room = max(b.allowed - 0.5 * width, 0.0)
    return min(max(tried, middle - room), middle + room)


@rare_kernel
def turning_point(shape: Any, a: Vec, b: Vec, falls: float, rises: float) -> EdgePoint:
    """Point between two at which the distance from a shape turns from falling to rising.

    Args:
        shape: In the axes of the points.
        a: The first point ...
        b: ... and the second [m].
        falls: Slope at the first, times the length between them, below zero [m].
        rises: Slope at the second, likewise, not below zero [m].
    """
    along = b - a
    bracket = Bracket(0.0, 1.0, falls, rises, 1.0)
    for _ in range(TRIES):
        if bracket.high - bracket.low <= CLOSE:
            break
        share = next_share(bracket)
        slope = near_face(shape, a + share * along).normal @ along
        bracket = narrower(bracket, share, slope)
    total = bracket.rises - bracket.falls
    before, after = bracket.rises / total, -bracket.falls / total
    at = a + (bracket.low * before + bracket.high * after) * along
    n_low = near_face(shape, a + bracket.low * along).normal
    n_high = near_face(shape, a + bracket.high * along).normal
    return EdgePoint(at, near_face(shape, at).gap, before * n_low + after * n_high)


class EdgePoints(NamedTuple):
    """The two lowest points inside an edge; a gap of `FAR` where there is none."""

    first: EdgePoint
    second: EdgePoint


@rare_kernel
def lowest_inside(shape: Any, a: Vec, b: Vec, n_a: Vec, n_b: Vec, is_convex: bool) -> EdgePoints:
    """Lowest points of an edge above a shape, without its ends.

    Args:
        shape: In the axes of the points.
        a: One end ...
        b: ... and the other [m].
        n_a: Outward normal at the first ...
        n_b: ... and at the second.
        is_convex: True if the distance has one lowest point at most.
    """
    along = b - a
    level = LEVEL * math.sqrt(along @ along)
    first = second = no_point(a)
    if is_convex:
        falls, rises = n_a @ along, n_b @ along
        if (falls < -level) & (rises > level):
            first = turning_point(shape, a, b, falls, rises)
        return EdgePoints(first, second)
    here, falls, low = a, n_a @ along, near_face(shape, a).gap
    lowest = low
    for k in range(PIECES):
        there = a + ((k + 1.0) / PIECES) * along
        face = near_face(shape, there)
        rises = face.normal @ along
        lowest = face.gap if face.gap < lowest else lowest
        if (falls < -level) & (rises > level):
            found = turning_point(shape, here, there, falls, rises)
            if found.gap < first.gap:
                first, second = found, first
            elif found.gap < second.gap:
                second = found
        # A level piece belongs to the slope before it.
        if (rises < -level) | (rises > level):
            here, falls = there, rises
    lowest = first.gap if first.gap < lowest else lowest
    reach = 0.5 * STEEPEST / PIECES * math.sqrt(along @ along)
    for k in range(PIECES):
        there = a + ((k + 1.0) / PIECES) * along
        high = near_face(shape, there).gap
        if 0.5 * (low + high) - reach < lowest:
            found = _lowest_in_piece(shape, a + (k / PIECES) * along, there, level)
            if found.gap < min(first.gap, lowest) - LOWER:
                first, second, lowest = found, first, found.gap
        low = high
    return EdgePoints(first, second)


@rare_kernel
def _lowest_in_piece(shape: Any, a: Vec, b: Vec, level: float) -> EdgePoint:
    """Lowest point inside a piece of an edge, of which slopes at its ends do not tell.

    Args:
        shape: In the axes of the points.
        a: One end of the piece ...
        b: ... and the other [m].
        level: Slopes closer to zero count as level, for the whole edge [m].
    """
    along, best = b - a, no_point(a)
    here, falls = a, near_face(shape, a).normal @ along
    for k in range(PARTS):
        there = a + ((k + 1.0) / PARTS) * along
        rises = near_face(shape, there).normal @ along
        if (falls < -level / PIECES) & (rises > level / PIECES):
            found = turning_point(shape, here, there, falls, rises)
            if found.gap < best.gap:
                best = found
        if (rises < -level / PIECES) | (rises > level / PIECES):
            here, falls = there, rises
    return best


@rare_kernel
def is_parted(shape: Any, a: Vec, b: Vec, radius: float) -> bool:
    """True if the straight way between two points is somewhere a radius away from a shape."""
    outside = False
    for k in range(WAYPOINTS):
        share = (k + 1.0) / (WAYPOINTS + 1.0)
        if near_face(shape, a + share * (b - a)).gap >= radius:
            outside = True
    return outside


# -- faces ----------------------------------------------------------------------------------------


class FlatFace(NamedTuple):
    """A flat face of a hull: axes along it and its middle, in the axes of the hull's points."""

    table: float
    row: int  # position of its numbers
    x: Vec
    y: Vec
    middle: Vec


class Strip(NamedTuple):
    """Part of a face between two lines along its first axis: places along its second [m]."""

    low: float
    high: float


@kernel
def _within_strip(chord: Chord, strip: Strip) -> Chord:
    """The part of a chord in a strip; of one beside the strip, its end that is nearer."""
    low, low_slope = chord.low, chord.low_slope
    if low < strip.low:
        low, low_slope = strip.low, 0.0
        if low > chord.high:
            low, low_slope = chord.high, chord.high_slope
    high, high_slope = chord.high, chord.high_slope
    if high > strip.high:
        high, high_slope = strip.high, 0.0
        if high < chord.low:
            high, high_slope = chord.low, chord.low_slope
    return Chord(low, high, low_slope, high_slope, chord.first, chord.last)


@rare_kernel
def _along_chord(shape: Any, face: FlatFace, s: float, strip: Strip) -> EdgePoint:
    """Lowest point of a chord of a face above a shape, `FAR` if the chord is none.

    The normal's component along the chord is zero inside it.  At its end it is that along the
    boundary: the slope of the lowest distance from chord to chord is then n · x.

    Args:
        shape: In the axes of the hull's points.
        face: The face.
        s: Place of the chord, along the face's first axis from its middle [m].
        strip: The part of the face.
    """
    chord = _within_strip(chord_at(face.table, face.row, s), strip)
    a = face.middle + s * face.x + chord.low * face.y
    b = face.middle + s * face.x + chord.high * face.y
    along = b - a
    at_a, at_b = near_face(shape, a), near_face(shape, b)
    falls, rises = at_a.normal @ along, at_b.normal @ along
    if (falls < 0.0) & (rises >= 0.0):
        return turning_point(shape, a, b, falls, rises)
    if falls >= 0.0:
        slope = at_a.normal @ face.y
        return EdgePoint(a, at_a.gap, at_a.normal + (chord.low_slope * slope) * face.x)
    slope = at_b.normal @ face.y
    return EdgePoint(b, at_b.gap, at_b.normal + (chord.high_slope * slope) * face.x)


class Patch(NamedTuple):
    """Part of a face around a point: place, and half its extent, along the face's axes [m]."""

    s: float
    t: float
    wide: float
    high: float
    gap: float  # there


@kernel
def _lower(shape: Any, face: FlatFace, patch: Patch, s: float, t: float) -> Patch:
    """The patch around another point, if that is lower."""
    gap = near_face(shape, face.middle + s * face.x + t * face.y).gap
    return Patch(s, t, patch.wide, patch.high, gap) if gap < patch.gap else patch


@rare_kernel
def _lowest_patch(shape: Any, face: FlatFace, first: float, last: float, known: EdgePoint) -> Patch:
    """Small part of a face around its lowest point above a shape: the lowest of some points.

    A grid over the face, finer where the distance can be lower, is followed by finer ones, each
    around the lowest point so far.  Points near one that is known do not count.
    """
    wide, best = (last - first) / GRID, Patch(0.0, 0.0, 0.0, 0.0, FAR)
    away = known.point - face.middle
    known_s, known_t = away @ face.x, away @ face.y
    for i in range(GRID):
        s = first + (i + 0.5) * wide
        chord = chord_at(face.table, face.row, s)
        high = (chord.high - chord.low) / GRID
        reach = 0.5 * STEEPEST * math.sqrt(wide * wide + high * high)
        for k in range(GRID):
            t = chord.low + (k + 0.5) * high
            far = (abs(s - known_s) > BASIN * wide) | (abs(t - known_t) > BASIN * high)
            if far or known.gap == FAR:
                gap = near_face(shape, face.middle + s * face.x + t * face.y).gap
                if gap < best.gap:
                    best = Patch(s, t, 0.5 * wide, 0.5 * high, gap)
                if gap - reach < best.gap:  # a lower point may be in this cell
                    for j in range(4):
                        part_s = s + (0.25 if j < 2 else -0.25) * wide
                        part_t = t + (0.25 if j % 2 == 0 else -0.25) * high
                        best = _lower(shape, face, best, part_s, part_t)
                        if best.s == part_s and best.t == part_t:
                            best = Patch(part_s, part_t, 0.5 * wide, 0.5 * high, best.gap)
    for _ in range(ZOOMS):
        around = best
        for i in range(-2, 3):
            s = within(around.s + 0.5 * i * around.wide, first, last)
            chord = chord_at(face.table, face.row, s)
            for k in range(-2, 3):
                t = within(around.t + 0.5 * k * around.high, chord.low, chord.high)
                best = _lower(shape, face, best, s, t)
        best = Patch(best.s, best.t, 0.5 * best.wide, 0.5 * best.high, best.gap)
    return Patch(best.s, best.t, 2.0 * best.wide, 2.0 * best.high, best.gap)


class ChordsPoint(NamedTuple):
    """Lowest point of some chords of a face, each as low as its lowest point."""

    low: EdgePoint
    beside: float  # −1 or 1: it is on the first or the last chord, and others beyond are lower


@rare_kernel
def _lowest_of_chords(
    shape: Any, face: FlatFace, first: float, last: float, strip: Strip
) -> ChordsPoint:
    """Lowest point of the chords between two, found as a bracketed root of the slope across them.

    Args:
        shape: In the axes of the hull's points.
        face: The face.
        first: Place of the first chord, along the face's first axis from its middle [m].
        last: Place of the last one [m].
        strip: The part of the face.
    """
    low, high = _along_chord(shape, face, first, strip), _along_chord(shape, face, last, strip)
    falls, rises = low.normal @ face.x, high.normal @ face.x
    if falls >= 0.0:
        return ChordsPoint(low, -1.0)
    if rises < 0.0:
        return ChordsPoint(high, 1.0)
    bracket = Bracket(0.0, 1.0, falls, rises, 1.0)
    for _ in range(TRIES):
        if bracket.high - bracket.low <= CLOSE:
            break
        share = next_share(bracket)
        middle = _along_chord(shape, face, first + share * (last - first), strip)
        slope = middle.normal @ face.x
        if slope < 0.0:
            low = middle
        else:
            high = middle
        bracket = narrower(bracket, share, slope)
    total = bracket.rises - bracket.falls
    before, after = bracket.rises / total, -bracket.falls / total
    at = before * low.point + after * high.point
    normal = before * low.normal + after * high.normal
    return ChordsPoint(EdgePoint(at, near_face(shape, at).gap, normal), 0.0)


@rare_kernel
def lowest_on_face(shape: Any, face: FlatFace, is_convex: bool, known: EdgePoint) -> EdgePoint:
    """Lowest point inside a face above a shape; `FAR` if there is none.

    Args:
        shape: In the axes of the hull's points.
        face: Whose lowest point is not on its boundary.
        is_convex: As for `lowest_inside`; else the lowest of some points tells where to look.
        known: A lowest point that is known, where another one is looked for; else `no_point`.
    """
    whole = chord_at(face.table, face.row, 0.0)
    inside = INSIDE * (whole.last - whole.first)
    first, last = whole.first + inside, whole.last - inside
    if is_convex:
        found = _lowest_of_chords(shape, face, first, last, Strip(-FAR, FAR))
        return found.low if found.beside == 0.0 else no_point(face.middle)
    # Of the boundary, where a lowest point ends the search, edges tell.
    patch = _lowest_patch(shape, face, first, last, known)
    for _ in range(MOVES):
        begin, end = max(first, patch.s - patch.wide), min(last, patch.s + patch.wide)
        strip = Strip(patch.t - patch.high, patch.t + patch.high)
        found = _lowest_of_chords(shape, face, begin, end, strip)
        if ((found.beside < 0.0) & (begin == first)) | ((found.beside > 0.0) & (end == last)):
            break
        away = found.low.point - face.middle
        s, t = away @ face.x, away @ face.y
        chord, rim = chord_at(face.table, face.row, s), RIM * patch.high
        is_below = (t < strip.low + rim) & (chord.low < strip.low)
        is_above = (t > strip.high - rim) & (chord.high > strip.high)
        if (found.beside == 0.0) & (not is_below) & (not is_above):
            edge = INSIDE * (chord.high - chord.low)
            if (t < chord.low + edge) | (t > chord.high - edge):
                break
            return found.low
        # A narrow valley, oblique to the grid, leads out of the patch.
        patch = Patch(s, t, 2.0 * patch.wide, 2.0 * patch.high, found.low.gap)
    return no_point(face.middle)


@kernel
def face_reach(table: float, row: int) -> float:
    """Radius of a circle around a face [m]."""
    return number_at(table, row + FACE - 3)
