"""Lanes: where the parts of a flight lie in a buffer, and how flights change their lanes.

A group of flights lies in one flat buffer, lane by lane within each row: model, motion, weighted
sum, rate, for a single flight the view, record.  Flat, with constant offsets, because that is what
compilers vectorise.

A step costs a group the same however many of its lanes take it.  So flights change lanes with those
of other groups, that those abreast take the same kind of step; no number of theirs depends on it.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.dynamics.motion import Motion, View
from springback.kernels.compiler import kernel
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows, zeros
from springback.simulation.record import (
    ARRIVED,
    CRUISING,
    FLYING,
    MAY_LOOK,
    STEERED,
    Model,
    Record,
)

#: What a lane does next. As its record says, it is steered, it flies as one body, or it looks about
#: for room to; it waits for its neighbours at a tick; it has ended.
STEERS, CRUISES, LOOKS, WAITS, ENDED = STEERED, CRUISING, MAY_LOOK, 3.0, -1.0


class Shape(NamedTuple):
    """Trees that tell the executor what lies in a buffer; their numbers do not matter."""

    model: Model
    motion: Motion
    seen: View
    record: Record


class Places(NamedTuple):
    """Rows of a buffer at which its parts begin."""

    motion: int
    total: int  # weighted sum of the stages' rates
    rate: int  # of the state, at the stage before
    seen: int  # the view, of a single flight only
    mark: int  # what each lane does next
    home: int  # of several lanes, the lane in which each flight began, counted through the groups
    kept: int  # of several lanes, motion and record of those that are not to be steered
    record: int  # it begins with time, step, status, phase, request, cruising, room
    step: int
    status: int
    phase: int
    request: int
    cruising: int
    room: int
    engaged: int
    end: int


@kernel
def places(shape: TreeLayout | Shape, w: int) -> Places:
    """Rows at which the parts of a buffer of ``w`` lanes begin; the model is the first."""
    motion = rows(shape.model)
    total = motion + rows(shape.motion)
    rate = total + rows(shape.motion)
    view = rate + rows(shape.motion.state)
    mark = view + (rows(shape.seen) if w == 1 else 0)
    home = mark + 1
    kept = home + (1 if w > 1 else 0)
    r = kept + (rows(shape.motion) + rows(shape.record) if w > 1 else 0)
    end = r + rows(shape.record)
    return Places(
        motion,
        total,
        rate,
        view,
        mark,
        home,
        kept,
        r,
        r + 1,
        r + 2,
        r + 3,
        r + 4,
        r + 5,
        r + 6,
        r + row_of(shape.record, "engaged"),
        end,
    )


def buffer_rows(shape: Shape, width: int) -> int:
    """Number of rows that one flight takes in a buffer of some width."""
    return places(shape, width).end


def empty_groups(shape: Shape, flights: int, width: int) -> Buffer:
    """Zeroed buffers for a number of flights in groups of ``width``."""
    return zeros(-(-flights // width), buffer_rows(shape, width) * width)


@kernel
def next_of(shape: TreeLayout, b: Buffer, w: int, i: int, early: float) -> float:
    """What a lane does next.

    A flight that is to be left as it arrives is not to be looked at while its neighbours fly on: a
    flight alone is next looked at when its new tick has begun.
    """
    at, until = places(shape, w), row_of(shape.model, "timing")  # its first field
    far = b[until * w + i] - b[at.record * w + i] > ARRIVED
    there = WAITS if early > 0.0 else STEERS
    does = b[at.cruising * w + i] if far else there
    return does if b[at.status * w + i] == FLYING else ENDED


class LaneCounts(NamedTuple):
    """How many lanes of a group do what next; the others have ended."""

    steering: int
    cruising: int
    waiting: int
    looking: int


@kernel
def _number(b: Buffer, row: int, w: int, wanted: float) -> int:
    found = 0
    for i in range(w):
        found += 1 if b[row * w + i] == wanted else 0
    return found


@kernel
def classify(shape: TreeLayout, b: Buffer, w: int, early: float) -> LaneCounts:
    """Mark every lane with what it does next, and count."""
    mark = places(shape, w).mark
    for i in range(w):
        b[mark * w + i] = next_of(shape, b, w, i, early)
    return LaneCounts(
        _number(b, mark, w, STEERS),
        _number(b, mark, w, CRUISES),
        _number(b, mark, w, WAITS),
        _number(b, mark, w, LOOKS),
    )


@kernel
def swap(shape: TreeLayout, b: Buffer, i: int, other: Buffer, j: int, w: int) -> None:
    """Let the flights in two lanes change places."""
    at = places(shape, w)
    for k in range(at.total):  # model and motion
        b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]
    for k in range(at.record, at.end):
        b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]
    k = at.home
    b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]


@kernel
def number_lanes(shape: TreeLayout, buffers: Buffer, first: int, last: int, w: int) -> None:
    """Give every flight the number of its lane, so that it finds home again."""
    home = places(shape, w).home
    for n in range((last - first) * w):
        buffers[first + n // w][home * w + n % w] = n


@kernel
def restore_order(shape: TreeLayout, buffers: Buffer, first: int, last: int, w: int) -> None:
    """Bring every flight back to the lane in which it began."""
    home = places(shape, w).home
    for n in range((last - first) * w):
        b, i = buffers[first + n // w], n % w
        while b[home * w + i] != n:
            m = int(b[home * w + i])
            swap(shape, b, i, buffers[first + m // w], m % w, w)


@kernel
def farthest_from_end(
    shape: TreeLayout, buffers: Buffer, first: int, last: int, w: int, wanted: float, early: float
) -> int:
    """Of the flights in some groups that do next what is wanted, the one with most time left.

    Args:
        shape: What lies in the buffers.
        buffers: One group a row.
        first: Index of the first group.
        last: Index past the last group.
        w: Lanes of a group.
        wanted: `STEERS` or `CRUISES`.
        early: As for `springback.simulation.executor.advance`.

    Returns:
        Its group, times ``w``, plus its lane; −1 if there is none.
    """
    at, until = places(shape, w), row_of(shape.model, "timing")
    found, most = -1, -1.0
    for group in range(first, last):
        b = buffers[group]
        for i in range(w):
            left = b[until * w + i] - b[at.record * w + i]
            if left > most and next_of(shape, b, w, i, early) == wanted:
                found, most = group * w + i, left
    return found


@kernel
def refill(
    shape: TreeLayout, buffers: Buffer, group: int, last: int, w: int, wanted: float, early: float
) -> bool:
    """Fill the lanes of a group that do something else next with flights of later groups.

    Returns:
        Whether later groups may have more of what is wanted.
    """
    b = buffers[group]
    for i in range(w):
        if next_of(shape, b, w, i, early) != wanted:
            found = farthest_from_end(shape, buffers, group + 1, last, w, wanted, early)
            if found < 0:
                return False
            swap(shape, b, i, buffers[found // w], found % w, w)
    return True


@kernel
def stash(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Put motion and record of all lanes aside: marked lanes are not to be steered."""
    at, moving = places(shape, w), rows(shape.motion)
    for k in range(moving * w):
        b[at.kept * w + k] = b[at.motion * w + k]
    for k in range(rows(shape.record) * w):
        b[(at.kept + moving) * w + k] = b[at.record * w + k]


@kernel
def unstash(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Give the lanes that do not steer their motion and record back."""
    at, moving = places(shape, w), rows(shape.motion)
    for k in range(moving):
        for i in range(w):
            old, place = b[(at.kept + k) * w + i], (at.motion + k) * w + i
            b[place] = old if b[at.mark * w + i] > 0.0 else b[place]
    for k in range(rows(shape.record)):
        for i in range(w):
            old, place = b[(at.kept + moving + k) * w + i], (at.record + k) * w + i
            b[place] = old if b[at.mark * w + i] > 0.0 else b[place]
