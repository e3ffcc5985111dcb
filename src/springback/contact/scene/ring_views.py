"""A solid, viewed from a ring: its lowest points, found with few evaluations.

Around a smooth solid the search goes in strides as long as the distance allows, and looks closely
only where the ring is near: some 25 looks instead of 70.  That is what a pole needs, on which most
flights among obstacles end, and a grid or a height map, of which a look takes ten times as long.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.rings import (
    ARCS,
    ASIDE,
    CLOSE,
    FAR,
    FLAT,
    STEPS,
    TRIES,
    TRUNCATION,
    Direction,
    LowPoint,
    LowPoints,
    between,
    direction_of,
    has_ridges,
    lower_beside,
    rotate,
    turn_of,
    turning_point,
    with_saddle,
)
from springback.contact.scene.grid_face import CELL, grid_face
from springback.contact.scene.height_face import PER_CELL, Probe, height_face, height_probe
from springback.contact.scene.sections import FARTHEST, Face, vector_at
from springback.contact.scene.solids import (
    AXES,
    CAPSULE,
    CENTRE,
    GRID,
    HEIGHTS,
    ROUND_WINDOW,
    WINDOW,
    SolidForm,
    capsule_face,
    form_at,
    form_face,
)
from springback.kernels.compiler import called_kernel, kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Mat3, Vec


class AlongRing(NamedTuple):
    """A solid, viewed from a ring: points in the ring's plane, from its centre, in body axes."""

    form: SolidForm
    centre: Vec  # of the ring, in the solid's axes [m]
    x: Vec  # body axes in the solid's axes
    y: Vec
    z: Vec


@kernel
def along_ring(table: float, row: int, centre: Vec, r: Mat3) -> AlongRing:
    """View of a solid.

    Args:
        table: Of the world.
        row: Position of the solid's numbers.
        centre: Of the ring, world [m].
        r: Body axes to world axes.
    """
    relative = centre - vector_at(table, row + CENTRE)
    ex, ey = vector_at(table, row + AXES), vector_at(table, row + AXES + 3)
    ez = vector_at(table, row + AXES + 6)
    ax, ay, az = ex @ r, ey @ r, ez @ r  # the solid's axes in body axes
    return AlongRing(
        form_at(table, row),
        Vec(ex @ relative, ey @ relative, ez @ relative),
        Vec(ax.x, ay.x, az.x),
        Vec(ax.y, ay.y, az.y),
        Vec(ax.z, ay.z, az.z),
    )


@kernel
def _face_along_ring(view: AlongRing, point: Vec) -> Face:
    return form_face(view.form, view.centre + view.x * point.x + view.y * point.y, FARTHEST)


@signed_distance.register(AlongRing)
@kernel
def _distance_along_ring(view: AlongRing, point: Vec) -> float:
    return _face_along_ring(view, point).gap


@outward_normal.register(AlongRing)
@kernel
def _normal_along_ring(view: AlongRing, point: Vec) -> Vec:
    n = _face_along_ring(view, point).normal
    return Vec(view.x @ n, view.y @ n, view.z @ n)


@kernel
def _in_body(view: AlongRing, normal: Vec) -> Vec:
    return Vec(view.x @ normal, view.y @ normal, view.z @ normal)


@has_ridges.register(AlongRing)
@kernel
def _form_has_ridges(view: AlongRing) -> bool:
    return (view.form.kind == WINDOW) | (view.form.kind == ROUND_WINDOW)


class FormAlongRing(NamedTuple):
    """A smooth solid, viewed from a ring: a grid, a height map or a capsule."""

    seen: AlongRing


@kernel
def _form_face(view: AlongRing, point: Vec) -> Face:
    form = view.form
    q, half = view.centre + view.x * point.x + view.y * point.y, Vec(form.a, form.b, form.c)
    if form.kind == CAPSULE:
        return capsule_face(q, form.a, form.b)
    if form.kind == GRID:
        return grid_face(q, half, form.d)
    return height_face(q, half, form.d, form.e, form.f, FARTHEST)


@signed_distance.register(FormAlongRing)
@kernel
def _distance_of_form(one: FormAlongRing, point: Vec) -> float:
    return _form_face(one.seen, point).gap


@outward_normal.register(FormAlongRing)
@kernel
def _normal_of_form(one: FormAlongRing, point: Vec) -> Vec:
    return _in_body(one.seen, _form_face(one.seen, point).normal)


#: Strides around a ring in steps of 2.8 deg, and the turns that they are.
WHOLE = ARCS * STEPS
_ONE, _TWO, _FOUR = turn_of(1.0 / STEPS), turn_of(2.0 / STEPS), turn_of(4.0 / STEPS)
_EIGHT, _SIXTEEN, _THIRTY_TWO = turn_of(8.0 / STEPS), turn_of(16.0 / STEPS), turn_of(32.0 / STEPS)
#: A distance changes by no more than this per metre: a spline beside a hollow edge by a little more
#: than 1 (chosen).
STEEPEST = 1.1
#: Length of a step on a ring of radius 1.
STEP = STEEPEST * 2.0 * math.pi / WHOLE
#: Looks at the true distance, once the place of a minimum is nearly known, and the slope along the
#: ring at which it is found (chosen: the place is then known to some 1e-11 m).
LOOKS, LEVEL = 6, 1e-10
#: Steps beside the lowest point in which another one is looked for, outside the box of a grid.
BESIDE = 2


@kernel
def _look(view: AlongRing, radius: float, towards: Direction) -> Probe:
    form, point = view.form, Vec(radius * towards.x, radius * towards.y, 0.0)
    q, half = view.centre + view.x * point.x + view.y * point.y, Vec(form.a, form.b, form.c)
    if form.kind == CAPSULE:
        face = capsule_face(q, form.a, form.b)
        return Probe(face.gap, face.gap, face.normal)
    if form.kind == GRID:
        face = grid_face(q, half, form.d)
        return Probe(face.gap, face.gap, face.normal)
    return height_probe(q, half, form.d, form.e, form.f)


@kernel
def _slope(view: AlongRing, towards: Direction, normal: Vec) -> float:
    """Slope along the ring, by the gradient in the solid's axes."""
    return (view.y @ normal) * towards.x - (view.x @ normal) * towards.y + FLAT


@kernel
def _level_between(
    view: AlongRing, radius: float, a: Direction, b: Direction, falls: float, rises: float
) -> Direction:
    """Direction between two where the slope turns, as `springback.contact.rings` finds it."""
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
        towards = between(a, b, share)
        slope = _slope(view, towards, _look(view, radius, towards).normal)
        if slope < 0.0:
            low, falls = share, slope
        else:
            high, rises = share, slope
    return between(a, b, (rises * low - falls * high) / (rises - falls))


@kernel
def _shortest_stride(view: AlongRing, radius: float) -> float:
    """Steps in half a cell of the form, which has no two minima within that."""
    if view.form.kind == CAPSULE:
        return 1.0
    if view.form.kind == GRID:
        cell = 0.5 * number_at(view.form.d, CELL)
    else:
        per = max(number_at(view.form.d, PER_CELL), number_at(view.form.d, PER_CELL + 1))
        cell = 0.5 / per
    return STEEPEST * cell * WHOLE / (2.0 * math.pi * radius)


class Minimum(NamedTuple):
    """A minimum of the distance along a ring."""

    low: LowPoint
    is_level: bool  # false if it was not found in so many looks


@kernel
def _true_minimum(view: AlongRing, radius: float, guess: Direction, bend: float) -> Minimum:
    """Minimum of the distance near a direction.

    Args:
        view: The solid.
        radius: Of the ring [m].
        guess: Where it nearly is.
        bend: Change of the slope per angle there [1/rad].
    """
    towards, turn, before, is_level = guess, 0.0, 0.0, False
    face = _form_face(view, Vec(radius * guess.x, radius * guess.y, 0.0))
    for k in range(LOOKS):
        slope = _slope(view, towards, face.normal)
        if abs(slope) <= LEVEL:
            is_level = True
            break
        if k > 0:
            change = (slope - before) / turn if turn != 0.0 else bend
            bend = change if change > 0.0 else bend
        turn, before = -slope / bend, slope
        most = 2.0 * math.pi / WHOLE
        turn = most if turn > most else (-most if turn < -most else turn)
        towards = direction_of(towards.x - turn * towards.y, towards.y + turn * towards.x)
        face = _form_face(view, Vec(radius * towards.x, radius * towards.y, 0.0))
    return Minimum(LowPoint(towards, face.gap, _in_body(view, face.normal)), is_level)


@called_kernel
def _at_kink(view: AlongRing, radius: float, a: Direction, b: Direction, low: LowPoint) -> LowPoint:
    """Minimum of the true distance between two directions, as where two sides meet.

    Args:
        view: The solid.
        radius: Of the ring [m].
        a: The first direction ...
        b: ... and the second.
        low: What is said if the distance does not turn from falling to rising between them.
    """
    one, middle = FormAlongRing(view), Vec(0.0, 0.0, 0.0)
    at_a = _form_face(view, Vec(radius * a.x, radius * a.y, 0.0))
    at_b = _form_face(view, Vec(radius * b.x, radius * b.y, 0.0))
    falls, rises = _slope(view, a, at_a.normal), _slope(view, b, at_b.normal)
    if falls < 0.0 <= rises:
        found = turning_point(one, middle, radius, a, b, falls, rises)
        return found if found.gap < low.gap else low
    return low


@kernel
def _is_beyond_grid(view: AlongRing, radius: float, towards: Direction, rim: float) -> bool:
    """True for a point of a ring outside the box of a grid, or within a rim of it [m].

    The distance has kinks there.
    """
    q = view.centre + view.x * (radius * towards.x) + view.y * (radius * towards.y)
    x, y, z = abs(q.x) + rim, abs(q.y) + rim, abs(q.z) + rim
    outside = (x > view.form.a) | (y > view.form.b) | (z > view.form.c)
    return (view.form.kind == GRID) & outside


@kernel
def is_smooth(form: SolidForm) -> bool:
    """True for a solid that `lowest_by_strides` takes."""
    if form.kind == CAPSULE:
        return form.rounding == 0.0
    return (form.kind == GRID) | (form.kind == HEIGHTS)


@called_kernel
def lowest_by_strides(view: AlongRing, radius: float, outward: Vec) -> LowPoints:
    """The two lowest minima along a ring, as `springback.contact.rings.lowest_on_ring`.

    Args:
        view: A grid, a height map or a capsule.
        radius: Of the ring [m].
        outward: The direction that counts as lowest if the ring lies flat.
    """
    shortest, middle = _shortest_stride(view, radius), Vec(0.0, 0.0, 0.0)
    n = _in_body(view, _form_face(view, Vec(0.0, 0.0, 0.0)).normal)
    guess = direction_of(ASIDE * outward.x - n.x, ASIDE * outward.y - n.y)
    face = _form_face(view, Vec(radius * guess.x, radius * guess.y, 0.0))
    level = LowPoint(guess, face.gap, _in_body(view, face.normal))
    first = second = LowPoint(guess, FAR, level.normal)
    lowest, step = level.gap, STEP * radius
    a, gone = Direction(1.0, 0.0), 0
    here = _look(view, radius, a)
    falls = _slope(view, a, here.normal)
    while gone < WHOLE:
        far, left = (here.least - max(lowest, 0.0)) / step, WHOLE - gone
        least = shortest
        if shortest >= 2.0 and _is_beyond_grid(view, radius, a, shortest * step):
            least = 1.0
        room = far if far > least else least
        stride, by = 1, _ONE
        if (room >= 32.0) & (left >= 32):
            stride, by = 32, _THIRTY_TWO
        elif (room >= 16.0) & (left >= 16):
            stride, by = 16, _SIXTEEN
        elif (room >= 8.0) & (left >= 8):
            stride, by = 8, _EIGHT
        elif (room >= 4.0) & (left >= 4):
            stride, by = 4, _FOUR
        elif (room >= 2.0) & (left >= 2):
            stride, by = 2, _TWO
        b = rotate(a, by)
        here = _look(view, radius, b)
        rises = _slope(view, b, here.normal)
        lowest = min(lowest, here.most)
        if (stride >= far) & (falls < 0.0) & (rises >= 0.0):
            bend = (rises - falls) * WHOLE / (2.0 * math.pi * stride)
            near = between(a, b, falls / (falls - rises))
            found = _true_minimum(view, radius, near, bend)
            low = found.low
            if not found.is_level:
                if view.form.kind == CAPSULE:  # the ring may run through its axis
                    low = turning_point(FormAlongRing(view), middle, radius, a, b, falls, rises)
                else:
                    near = _level_between(view, radius, a, b, falls, rises)
                    found = _true_minimum(view, radius, near, bend)
                    low = found.low if found.is_level else _at_kink(view, radius, a, b, found.low)
            if low.gap < first.gap:
                first, second = low, first
            elif low.gap < second.gap:
                second = low
        a, falls, gone = b, rises, gone + stride
    if first.gap < FAR and _is_beyond_grid(view, radius, first.towards, BESIDE * step):
        first = lower_beside(FormAlongRing(view), middle, radius, first, BESIDE)
    return with_saddle(
        FormAlongRing(view), middle, radius, first if first.gap < FAR else level, second
    )
