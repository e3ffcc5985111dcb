"""Chords of the flat faces of a hull."""

from __future__ import annotations

from typing import NamedTuple

from springback.contact.scene.sections import vector_at
from springback.kernels.compiler import kernel, rare_kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Vec
from springback.vehicle.hulls import FACE, POINT, POINTS_AT

#: Sides of a face that are this nearly parallel to its chords bound none of them [1].
PARALLEL = 1e-12


class Chord(NamedTuple):
    """A chord of a face, along its second axis, and the face's extent along its first [m]."""

    low: float
    high: float
    low_slope: float  # change of the ends from chord to chord
    high_slope: float
    first: float
    last: float


@kernel
def corner_at(table: float, block: int, k: int) -> Vec:
    """Place of a point of a hull whose numbers begin at a position of a table [m]."""
    return vector_at(table, int(number_at(table, block + POINTS_AT)) + POINT * k)


@rare_kernel
def chord_at(table: float, row: int, s: float) -> Chord:
    """Chord of a face.

    Args:
        table: Of the hulls.
        row: Position of the face's numbers.  Behind its list of corners is where the points are.
        s: Its place along the face's first axis, from the middle [m].
    """
    x, y = vector_at(table, row + 3), vector_at(table, row + 6)
    middle = vector_at(table, row + 9)
    listed, count = int(number_at(table, row + FACE - 2)), int(number_at(table, row + FACE - 1))
    points = int(number_at(table, listed + count))
    low, high, low_slope, high_slope, first, last = -1e9, 1e9, 0.0, 0.0, 1e9, -1e9
    before = vector_at(table, points + POINT * int(number_at(table, listed + count - 1))) - middle
    before_s, before_t = before @ x, before @ y
    for k in range(count):
        here = vector_at(table, points + POINT * int(number_at(table, listed + k))) - middle
        here_s, here_t = here @ x, here @ y
        first = here_s if here_s < first else first
        last = here_s if here_s > last else last
        ahead = here_s - before_s
        if abs(ahead) > PARALLEL:
            slope = (here_t - before_t) / ahead
            there = before_t + slope * (s - before_s)
            # Counterclockwise: sides towards +x bound chords from below.
            if (ahead > 0.0) & (there > low):
                low, low_slope = there, slope
            if (ahead < 0.0) & (there < high):
                high, high_slope = there, slope
        before_s, before_t = here_s, here_t
    return Chord(low, high, low_slope, high_slope, first, last)
