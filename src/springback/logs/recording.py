"""A recording: channels as they were logged, each with its own clock, never resampled.

Values are in SI units, vectors in NWU (world) or FLU (body), quaternions Hamilton, scalar first,
body to world.  Readers turn other frames and units on the way in.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError

Array = np.ndarray[Any, np.dtype[np.float64]]
Flags = np.ndarray[Any, np.dtype[np.bool_]]

#: Most numbers of a recording that are held in memory (chosen: 320 MB).
MOST_NUMBERS = 40_000_000
#: Samples that are out of order by less than this are sorted [s] (chosen: what a network does);
#: a clock that goes back by more is refused.
DISORDER = 0.1
#: Largest magnitude of any number of a recording, SI, and latest instant [s] (chosen: times since
#: 1970 are below it).
LARGEST, LATEST = 1e9, 1e11
#: Share of samples that may be impossible, as where a log is damaged (chosen).
FEW = 0.01
#: Format of tables of one's own, which a mapping file describes, axes included.
MAPPED = "table with a mapping"


#: Share of a range from which a sample is at its end: the largest count of a converter of 16 bits
#: is 2⁻¹⁵ below.
AT_END = 1.0 - 2.0**-14


class QuantityKind(NamedTuple):
    """What a channel tells."""

    unit: str
    width: int | None  # numbers a sample; None: any
    frame: str  # "world", "body" or empty


SPECIFIC_FORCE, ANGULAR_VELOCITY = "specific force", "angular velocity"
POSITION, VELOCITY, ATTITUDE = "position", "velocity", "attitude"
MARKERS, ARM_LENGTH, LANDED = "markers", "arm length", "landed"
ROTOR_SPEED, ROTOR_COMMAND = "rotor speed", "rotor command"
QUANTITIES = {
    SPECIFIC_FORCE: QuantityKind("m/s^2", 3, "body"),
    ANGULAR_VELOCITY: QuantityKind("rad/s", 3, "body"),
    POSITION: QuantityKind("m", 3, "world"),
    VELOCITY: QuantityKind("m/s", 3, "world"),
    ATTITUDE: QuantityKind("", 4, "world"),
    MARKERS: QuantityKind("m", None, "world"),
    ARM_LENGTH: QuantityKind("m", None, ""),
    ROTOR_SPEED: QuantityKind("rad/s", None, ""),
    ROTOR_COMMAND: QuantityKind("", None, ""),
    LANDED: QuantityKind("", 1, ""),
}


class TimeSpan(NamedTuple):
    """Part of a log that is wanted, in seconds of its own clock; infinite: all."""

    first: float = -np.inf
    last: float = np.inf

    def has(self, time: float) -> bool:
        """True for an instant in it."""
        return self.first <= time <= self.last


@dataclass(frozen=True)
class SensorChain:
    """What stands between the motion and the numbers of a channel, as far as the log tells."""

    full_scale: float | None = None
    """Largest magnitude that it can give, in the channel's unit."""
    average: float | None = None
    """Each sample is the mean over this time before its instant [s]."""
    low_pass: float | None = None
    """Corner of a low-pass filter [Hz]."""
    low_pass_order: int | None = None
    """1, or 2 for a Butterworth filter; None if the log does not tell."""
    estimated: bool = False
    """An estimate of the autopilot from several sensors, not a measurement."""
    smoothed: bool = False
    """Smoothed by the program that recorded it, or by a model of the body."""
    note: str = ""


@dataclass(frozen=True, eq=False)
class LogChannel:
    """Samples of one quantity on one clock."""

    name: str
    """Name in the log: topic and field."""
    quantity: str
    """One of `QUANTITIES`."""
    times: Array
    """Instants [s] of its clock, never decreasing, shape (samples,)."""
    values: Array
    """SI, shape (samples, width); a lost sample is NaN."""
    clock: str = "log"
    """Channels with the same word share a clock."""
    chain: SensorChain = field(default_factory=SensorChain)
    clipped: Flags | None = None
    """Samples at the end of the range, shape (samples, width); None if the log does not tell."""
    resets: Flags | None = None
    """Samples at which an estimate jumped, shape (samples,)."""
    labels: tuple[str, ...] = ()
    """Names of the markers, or of the parts of the values."""
    disorder: tuple[int, float] = (0, 0.0)
    """Samples that came after a later one, and by how much at most [s]; they are sorted."""

    @property
    def is_lost(self) -> Flags:
        """Samples without a value, shape (samples,)."""
        return np.asarray(np.isnan(self.values).any(axis=1))

    @property
    def rate(self) -> float:
        """Samples a second between gaps: over the median of their distances [Hz]; 0 if unknown."""
        steps = np.diff(self.times)
        steps = steps[steps > 0.0]
        return float(1.0 / np.median(steps)) if len(steps) else 0.0

    @property
    def span(self) -> tuple[float, float]:
        """First and last instant [s]."""
        return float(self.times[0]), float(self.times[-1])


@dataclass(frozen=True, eq=False)
class Recording:
    """All channels that were read of one log."""

    path: Path
    format: str
    """Name of the format, in words."""
    channels: tuple[LogChannel, ...]
    dropouts: tuple[tuple[float, float], ...] = ()
    """Time [s] and duration [s] of losses that the logger itself noted."""
    parameters: Mapping[str, float | int | str] = field(default_factory=dict)
    """Settings of the autopilot or of the motion capture, as they are in the log."""
    remarks: tuple[str, ...] = ()
    """What the reader saw and did, a sentence each."""
    others: tuple[str, ...] = ()
    """Channels of bodies that are not the vehicle."""
    damage: tuple[str, ...] = ()
    """What is cut off or damaged, so that a part of the flight may be missing, a sentence each."""

    def within(self, part: TimeSpan) -> Recording:
        """The recording in a part of the time.

        Raises:
            InputError: If nothing is in it.
        """
        found = []
        for one in self.channels:
            kept = (one.times >= part.first) & (one.times <= part.last)
            if kept.any():
                clipped = None if one.clipped is None else one.clipped[kept]
                resets = None if one.resets is None else one.resets[kept]
                at, values = one.times[kept], one.values[kept]
                found.append(replace(one, times=at, values=values, clipped=clipped, resets=resets))
        if not found:
            raise InputError(f"{self.path}: has nothing between --from and --until")
        return replace(self, channels=tuple(found))

    def of(self, quantity: str) -> list[LogChannel]:
        """Channels of a quantity: measured ones first, the vehicle's, then the fastest."""
        found = [one for one in self.channels if one.quantity == quantity]
        return sorted(
            found, key=lambda one: (one.chain.estimated, one.name in self.others, -one.rate)
        )

    def best(self, quantity: str) -> LogChannel | None:
        """The fastest measured channel of a quantity, else the fastest estimate; None if none."""
        return next(iter(self.of(quantity)), None)


def log_channel(
    where: str,
    name: str,
    quantity: str,
    times: Any,
    values: Any,
    *,
    clipped: Any = None,
    resets: Any = None,
    **more: Any,
) -> LogChannel:
    """A checked channel.

    Args:
        where: The file, for messages.
        name: Name in the log.
        quantity: One of `QUANTITIES`.
        times: Instants [s], shape (samples,).
        values: SI, shape (samples, width) or (samples,); NaN where lost.
        clipped: Flags, shape (samples, width), or None.
        resets: Flags, shape (samples,), or None.
        **more: Other fields of `LogChannel`.

    Raises:
        InputError: If the clock goes back or is not finite, or a value is infinite or beyond all
            bounds.
    """
    at = np.asarray(times, dtype=float).reshape(-1)
    numbers = np.asarray(values, dtype=float).reshape(len(at), -1)
    kind = QUANTITIES[quantity]
    if not len(at):
        raise InputError(f"{where}: {name}: has no samples")
    if kind.width is not None and numbers.shape[1] != kind.width:
        raise InputError(
            f"{where}: {name}: {quantity} needs {kind.width} numbers a sample, not "
            f"{numbers.shape[1]}"
        )
    at, numbers, clipped, resets = _without_wild(
        where, name, quantity, at, numbers, clipped, resets
    )
    _check_clock(where, name, at)
    order, late = np.argsort(at, kind="stable"), np.maximum.accumulate(at) - at
    if (late > 0.0).any():
        at, numbers = at[order], numbers[order]
        clipped = None if clipped is None else np.asarray(clipped)[order]
        resets = None if resets is None else np.asarray(resets)[order]
    flags = None if clipped is None else np.asarray(clipped, dtype=bool).reshape(numbers.shape)
    jumps = None if resets is None else np.asarray(resets, dtype=bool).reshape(len(at))
    disorder = int((late > 0.0).sum()), float(late.max())
    return LogChannel(
        name, quantity, at, numbers, clipped=flags, resets=jumps, disorder=disorder, **more
    )


def _without_wild(
    where: str, name: str, quantity: str, at: Array, numbers: Array, clipped: Any, resets: Any
) -> tuple[Array, Array, Any, Any]:
    """Samples without the few impossible ones of a damaged log: such a value is lost.

    Raises:
        InputError: If they are more than a few.
    """
    unit, most = QUANTITIES[quantity].unit, max(1, int(FEW * len(at)))
    timeless = np.logical_not(np.abs(at) <= LATEST)
    if timeless.any():
        bad = int(np.flatnonzero(timeless)[0])
        if timeless.sum() > most or timeless.all():
            raise InputError(
                f"{where}: {name}: the time of sample {bad + 1} is no instant ({at[bad]})"
            )
        known = np.logical_not(timeless)
        at, numbers = at[known], numbers[known]
        clipped = None if clipped is None else np.asarray(clipped)[known]
        resets = None if resets is None else np.asarray(resets)[known]
    with np.errstate(invalid="ignore"):
        wild: Flags = np.greater(np.abs(numbers), LARGEST)
    rows = np.asarray(wild.any(axis=1))
    if rows.any():
        bad, k = map(int, np.argwhere(wild)[0])
        if rows.sum() > most or len(at) == 1:
            raise InputError(
                f"{where}: {name}: sample {bad + 1} is {numbers[bad, k]:.3g} {unit}".rstrip()
                + ", more than any vehicle does"
            )
        numbers = np.where(rows[:, None], np.nan, numbers)
    return at, numbers, clipped, resets


def _check_clock(where: str, name: str, at: Array) -> None:
    """Refuse a clock that goes back by more than a network's disorder."""
    steps = np.diff(at)
    if len(steps) and steps.min() < -DISORDER:
        k = int(np.argmin(steps))
        raise InputError(
            f"{where}: {name}: its clock goes back by {-steps[k]:.4g} s after {at[k]:.6g} s "
            f"(sample {k + 1} of {len(at)}): read the part before or after with --from and --until"
        )


class Budget:
    """Numbers that may still be held in memory."""

    def __init__(self, where: str, most: int = MOST_NUMBERS) -> None:
        """Start with all of them.

        Args:
            where: The file, for messages.
            most: How many.
        """
        self.where, self.most, self.used = where, most, 0

    def take(self, count: int) -> None:
        """Take some.

        Raises:
            InputError: If there are not so many left.
        """
        self.used += count
        if self.used > self.most:
            raise InputError(
                f"{self.where}: has more than {self.most / 1e6:g} million numbers of interest, "
                "too many to hold: read a part with --from and --until"
            )


def refuse_without_channels(
    where: str, channels: Sequence[LogChannel], known: str, remarks: Sequence[str] = ()
) -> None:
    """Refuse a log of which nothing could be used.

    Raises:
        InputError: Naming what was seen on the way and what would have been read.
    """
    if not channels:
        seen = f" ({'; '.join(remarks)[:300]})" if remarks else ""
        raise InputError(f"{where}: has nothing that can be used{seen}; known are {known}")


def refuse_several_flights(recordings: Sequence[Recording]) -> None:
    """Refuse logs that have the same channel at the same time: they are of several flights.

    Raises:
        InputError: Naming two of them, and the channel.
    """
    for k, one in enumerate(recordings):
        for other in recordings[:k]:
            known = {c.name: c for c in other.channels if c.clock == "log"}
            for channel in one.channels:
                twin = known.get(channel.name)
                if twin is None or one.format != other.format or channel.clock != "log":
                    continue
                (begin, end), (first, last) = channel.span, twin.span
                if begin < last and first < end:
                    raise InputError(
                        f"{one.path} and {other.path} both have {channel.name} from "
                        f"{max(begin, first):.3g} to {min(end, last):.3g} s: they are of two "
                        "flights; a plan has one [[flights]] for each, other commands take one"
                    )
