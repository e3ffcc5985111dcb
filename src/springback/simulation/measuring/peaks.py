"""Peaks of a flight, also between two instants: the vertex of a parabola through three of them.

Accelerations and forces in contact rise and fall within a few steps, so that the largest of their
samples is too small by an error of second order in the step; the vertex, by one of third order.  It
is used only if the three instants belong to one smooth stretch: contacts that begin or end, arms
that are locked and impulses begin a new one.  So do steps much shorter than their neighbours, as up
to a tick: what gusts and rounding change within one is no slope of the long one.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.dynamics.limbs.arms import ArmView
from springback.dynamics.motion import View
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, maximum, select, tree_map
from springback.kernels.vectors import Vec, larger, norm


class Peaks(NamedTuple):
    """Largest values."""

    acceleration: float  # ‖v̇‖ of the main body [m/s²]
    acceleration_time: float  # its time [s]
    specific_force: float  # ‖v̇ + g e_Z‖ of the main body [m/s²]
    angular_rate: float  # ‖ω‖ [rad/s]
    normal_force: float  # f_n of one cage, or of the hull [N]
    penetration: float  # δ [m]
    compression: float  # L − l [m]
    extension: float  # l − L [m]


class PeakSample(NamedTuple):
    """Values that peak sharply in contact, at one instant."""

    acceleration: float  # ‖v̇‖ of the main body [m/s²]
    specific_force: float  # ‖v̇ + g e_Z‖ of the main body [m/s²]
    normal_force: float  # largest f_n of one cage [N]


class Recent(NamedTuple):
    """The last two instants."""

    step: float  # from one to the other [s]; 0 if they are not of one smooth stretch
    earlier: PeakSample
    latest: PeakSample


class Peak(NamedTuple):
    """Peak of one quantity."""

    value: float
    time: float  # relative to the present instant [s]


#: Shortest of two steps through which a parabola goes, relative to the other (chosen).
ALIKE = 0.1
#: Before the first instant.
NOTHING_YET = Recent(0.0, PeakSample(0.0, 0.0, 0.0), PeakSample(0.0, 0.0, 0.0))


@kernel
def _change(now: float, before: float) -> float:
    return (now - before) * (now - before)


@kernel
def largest_change(now: tuple[float, ...], before: tuple[float, ...]) -> float:
    """The largest square of a change among several numbers, such as flags of contact."""
    return maximum(tree_map(_change, (now, before), ()))


class Spacing(NamedTuple):
    """Spacing of three instants."""

    smooth: bool  # True if they are of one smooth stretch
    before: float  # b, from the first to the second [s]
    after: float  # a, from the second to the third [s]
    volume: float  # a b (a + b) [s³]


@kernel
def spacing(recent: Recent, step: float, smooth: bool) -> Spacing:
    """Spacing of the last two instants and the present one.

    Args:
        recent: The last two instants.
        step: From the later of them to the present [s].
        smooth: True if nothing jumps in between.
    """
    usable = smooth & (recent.step > ALIKE * step) & (step > ALIKE * recent.step)
    b, a = select(usable, recent.step, 1.0), select(usable, step, 1.0)
    return Spacing(usable, b, a, a * b * (a + b))


@kernel
def peak_of(first: float, second: float, third: float, t: Spacing) -> Peak:
    """The vertex if the second of three values is the largest, otherwise the third value.

    Args:
        first: At the earliest instant.
        second: At the next.
        third: At the present one.
        t: Their spacing.
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


@kernel
def largest_so_far(counts: bool, value: float, so_far: float) -> float:
    """Largest value so far, if this one counts."""
    return select(counts, larger(value, so_far), so_far)


@kernel
def peaks_after(before: Peaks, now: Peaks, counts: bool) -> Peaks:
    """Peaks after an instant, if it counts."""
    grew = counts & (now.acceleration > before.acceleration)
    return Peaks(
        select(grew, now.acceleration, before.acceleration),
        select(grew, now.acceleration_time, before.acceleration_time),
        largest_so_far(counts, now.specific_force, before.specific_force),
        largest_so_far(counts, now.angular_rate, before.angular_rate),
        largest_so_far(counts, now.normal_force, before.normal_force),
        largest_so_far(counts, now.penetration, before.penetration),
        largest_so_far(counts, now.compression, before.compression),
        largest_so_far(counts, now.extension, before.extension),
    )


@kernel
def _extension(arm: ArmView) -> float:
    return -arm.compression


@kernel
def peaks_now(
    spin: Vec, view: View, sample: PeakSample, recent: Recent, stepping: Any, smooth: bool
) -> Peaks:
    """Values at an instant, or between the last two where those rise and fall within steps.

    Args:
        spin: Angular velocity [rad/s].
        view: Of the vehicle.
        sample: Of this instant.
        recent: The last two instants.
        stepping: `springback.simulation.measuring.record.Stepping` of this instant.
        smooth: True if nothing has jumped since the last.
    """
    apart = spacing(recent, stepping.step, smooth)
    earlier, latest = recent.earlier, recent.latest
    hardest = peak_of(earlier.acceleration, latest.acceleration, sample.acceleration, apart)
    felt = peak_of(earlier.specific_force, latest.specific_force, sample.specific_force, apart)
    normal = peak_of(earlier.normal_force, latest.normal_force, sample.normal_force, apart)
    return Peaks(
        hardest.value,
        stepping.time + hardest.time,
        felt.value,
        norm(spin),
        normal.value,
        maximum(field_of(view.arms, "depth") + field_of(view.hull, "depth")),
        maximum(field_of(view.arms, "compression")),
        maximum(tree_map(_extension, (view.arms,), ())),
    )
