"""Peaks between two instants: the vertex of a parabola through three of them.

Accelerations and forces in contact rise and fall within a few steps, so that the largest of their
samples falls short of the peak by an error of second order in the step; the vertex, by one of third
order.  It is taken only where the three instants belong to one smooth stretch: contacts that begin
or end, arms that are locked and impulses make a new one.
"""

from __future__ import annotations

from typing import NamedTuple

from springback.kernels.compiler import kernel
from springback.kernels.trees import select


class PeakSample(NamedTuple):
    """What peaks sharply in contact, at one instant."""

    acceleration: float  # ‖v̇‖ of the main body [m/s²]
    specific_force: float  # ‖v̇ + g e_Z‖ of the main body [m/s²]
    normal_force: float  # largest f_n of one cage [N]


class Recent(NamedTuple):
    """The last two instants."""

    step: float  # from one to the other [s]; 0 where they are not of one smooth stretch
    earlier: PeakSample
    latest: PeakSample


class Peak(NamedTuple):
    """Of one quantity."""

    value: float
    time: float  # against the present instant [s]


#: Before the first instant.
NOTHING_YET = Recent(0.0, PeakSample(0.0, 0.0, 0.0), PeakSample(0.0, 0.0, 0.0))


class Spacing(NamedTuple):
    """Of three instants."""

    smooth: bool  # whether they are of one smooth stretch
    before: float  # b, from the first to the second [s]
    after: float  # a, from the second to the third [s]
    volume: float  # a b (a + b) [s³]


@kernel
def spacing(recent: Recent, step: float, smooth: bool) -> Spacing:
    """Of the last two instants and the present one.

    Args:
        recent: The last two instants.
        step: From the later of them to the present [s].
        smooth: Whether nothing jumps in between.
    """
    usable = smooth & (recent.step > 0.0)
    b, a = select(usable, recent.step, 1.0), select(usable, step, 1.0)
    return Spacing(usable, b, a, a * b * (a + b))


@kernel
def peak_of(first: float, second: float, third: float, t: Spacing) -> Peak:
    """The vertex where the second of three values is the largest, otherwise the third value.

    Args:
        first: At the earliest instant.
        second: At the next.
        third: At the present one.
        t: When they were.
    """
    rise, fall = second - first, third - second
    summit = t.smooth & (rise > 0.0) & (fall <= 0.0)
    # Slope and half the curvature at the second instant, each times a b (a + b).
    slope = rise * (t.after * t.after) + fall * (t.before * t.before)
    bend = select(summit, fall * t.before - rise * t.after, -1.0)
    half = 0.5 * slope / (bend * t.volume)
    return Peak(
        select(summit, second - 0.5 * slope * half, third),
        select(summit, -half * t.volume - t.after, 0.0),
    )
