"""Lanes: the layout of a group of flights in a buffer, and swaps of flights between lanes.

A group of flights is one flat buffer, lane by lane within each row: model, motion, weighted sum,
rate, for a single flight the view, and record.  It is flat, with constant offsets, so that the
compiler can vectorise.

A step costs a group the same however many of its lanes take it.  So flights are swapped with those
of other groups until all flights of a group take the same kind of step; their results do not depend
on it.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.dynamics.motion import Motion, View
from springback.kernels.compiler import kernel
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows, zeros
from springback.simulation.measuring.record import (
    ARRIVED,
    CRUISING,
    FLYING,
    MAY_LOOK,
    STEERED,
    Model,
    Record,
)

#: Next action of a lane. By its record: a full step, a step as one rigid body, or a check of the
#: clearance for one; or it waits for its neighbours at a tick, or has ended.
STEERS, CRUISES, LOOKS, WAITS, ENDED = STEERED, CRUISING, MAY_LOOK, 3.0, -1.0


class Shape(NamedTuple):
    """Trees whose structure is the layout of a buffer; their numbers do not matter."""

    model: Model
    motion: Motion
    seen: View
    record: Record


class SingleFlight(NamedTuple):
    """Lanes of a flight that is flown alone on a processor.

    The compiler knows from its type that there are no others.
    """

    lane: int = 0


class SplitFlight(NamedTuple):
    """Lanes of a single flight whose physics is compiled apart from the loop over its steps.

    Two processes compile them side by side.
    """

    physics: int
    """Address of `springback.simulation.stages.rates_apart`; 0 where only its type matters."""


def lanes_of(width: int) -> tuple[int, ...]:
    """Lanes of a group of ``width``."""
    return SingleFlight() if width == 1 else (0,) * width


class Places(NamedTuple):
    """First rows of the parts of a buffer."""

    motion: int
    total: int  # weighted sum of the stages' rates
    rate: int  # of the state, at the stage before; of a single flight that of its whole motion
    seen: int  # the view, of a single flight only
    mark: int  # next action of each lane
    home: int  # of several lanes, the first lane of each flight, counted through the groups
    kept: int  # of several lanes, copy of motion and record during a full step
    record: int  # it begins with `springback.simulation.measuring.record.Stepping`
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
    """First rows of the parts of a buffer of ``w`` lanes; the model is the first part."""
    motion = rows(shape.model)
    total = motion + rows(shape.motion)
    rate = total + rows(shape.motion)
    view = rate + (rows(shape.motion) if w == 1 else rows(shape.motion.state))
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
        r + row_of(shape.record, "contacts") + row_of(shape.record.contacts, "engaged"),
        end,
    )


def buffer_rows(shape: Shape, width: int) -> int:
    """Number of rows of a buffer of some width."""
    return places(shape, width).end


def empty_groups(shape: Shape, flights: int, width: int) -> Buffer:
    """Zeroed buffers for a number of flights in groups of ``width``."""
    return zeros(-(-flights // width), buffer_rows(shape, width) * width)


@kernel
def next_of(shape: TreeLayout, b: Buffer, w: int, i: int, early: float) -> float:
    """Next action of a lane.

    With ``early``, a flight that has reached the end of a tick waits for its neighbours: for a
    flight alone, too, the next check comes after the new tick has begun.
    """
    at, until = places(shape, w), row_of(shape.model, "timing")  # its first field
    far = b[until * w + i] - b[at.record * w + i] > ARRIVED
    there = WAITS if early > 0.0 else STEERS
    does = b[at.cruising * w + i] if far else there
    return does if b[at.status * w + i] == FLYING else ENDED


class LaneCounts(NamedTuple):
    """Number of lanes of a group by their next action; the others have ended."""

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
    """Mark each lane with its next action, and count."""
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
    """Swap the flights in two lanes."""
    at = places(shape, w)
    for k in range(at.total):  # model and motion
        b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]
    for k in range(at.record, at.end):
        b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]
    k = at.home
    b[k * w + i], other[k * w + j] = other[k * w + j], b[k * w + i]


@kernel
def number_lanes(shape: TreeLayout, buffers: Buffer, w: int) -> None:
    """Number the flights by their lanes, for `restore_order`."""
    home = places(shape, w).home
    for n in range(buffers.shape[0] * w):
        buffers[n // w][home * w + n % w] = n


@kernel
def restore_order(shape: TreeLayout, buffers: Buffer, w: int) -> None:
    """Swap the flights back to their first lanes."""
    home = places(shape, w).home
    for n in range(buffers.shape[0] * w):
        b, i = buffers[n // w], n % w
        while b[home * w + i] != n:
            m = int(b[home * w + i])
            swap(shape, b, i, buffers[m // w], m % w, w)


@kernel
def farthest_from_end(
    shape: TreeLayout, buffers: Buffer, first: int, w: int, wanted: float, early: float
) -> int:
    """Lane, from some group on, of the flight with most time left and the wanted next action.

    Args:
        shape: Layout of the buffers.
        buffers: One row for each group.
        first: Index of the first group.
        w: Lanes of a group.
        wanted: `STEERS` or `CRUISES`.
        early: As for `springback.simulation.executor.advance`.

    Returns:
        Its group, times ``w``, plus its lane; −1 if there is none.
    """
    at, until = places(shape, w), row_of(shape.model, "timing")
    found, most = -1, -1.0
    for group in range(first, buffers.shape[0]):
        b = buffers[group]
        for i in range(w):
            left = b[until * w + i] - b[at.record * w + i]
            if left > most and next_of(shape, b, w, i, early) == wanted:
                found, most = group * w + i, left
    return found


@kernel
def refill(
    shape: TreeLayout, buffers: Buffer, group: int, w: int, wanted: float, early: float
) -> bool:
    """Fill the lanes of a group that have another next action with flights of later groups.

    Returns:
        True if later groups may have more such flights.
    """
    b = buffers[group]
    for i in range(w):
        if next_of(shape, b, w, i, early) != wanted:
            found = farthest_from_end(shape, buffers, group + 1, w, wanted, early)
            if found < 0:
                return False
            swap(shape, b, i, buffers[found // w], found % w, w)
    return True


@kernel
def stash(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Copy motion and record of all lanes before a full step, which not all of them take."""
    at, moving = places(shape, w), rows(shape.motion)
    for k in range(moving * w):
        b[at.kept * w + k] = b[at.motion * w + k]
    for k in range(rows(shape.record) * w):
        b[(at.kept + moving) * w + k] = b[at.record * w + k]


@kernel
def unstash(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Restore motion and record of the lanes that do not take the full step."""
    at, moving = places(shape, w), rows(shape.motion)
    for k in range(moving):
        for i in range(w):
            old, place = b[(at.kept + k) * w + i], (at.motion + k) * w + i
            b[place] = old if b[at.mark * w + i] > 0.0 else b[place]
    for k in range(rows(shape.record)):
        for i in range(w):
            old, place = b[(at.kept + moving + k) * w + i], (at.record + k) * w + i
            b[place] = old if b[at.mark * w + i] > 0.0 else b[place]
