"""Recorded drops of a flexible frame and of its rigid twin, read from the user's own copy.

The recordings are those of R. de Azambuja, H. Fouad, Y. Bouteiller, C. Sol and G. Beltrame, "When
Being Soft Makes You Tough" (2021), repository ``thecognifly/CrashLandingExperiments``: CogniFly
let go above concrete, with an accelerometer of 200 g.  It has no licence, so nothing of it is part
of this package but the medians and quartiles below, and nothing is fetched: the user names the
folder of a copy.

A file is one drop: rows of 10 bytes, little endian, of the time [µs] and the readings of x, y and z
in counts of 12 bits, 1000 a second.  The zero of each axis is taken from the fall itself.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.vehicle.endurance import GRAVITY

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Counts per g along z: 6.5 mV/g at 3 V, ratiometric, 12 bits (the sensor's data sheet); along x
#: and y that share of it, which its self-test suggests, as the authors say.
SENSITIVITY, ACROSS = 6.5e-3 / 3.0 * 4096.0, 0.96
#: Bytes of a row, counts of the converter, interval between rows [s], and largest file [bytes].
ROW, COUNTS, PERIOD, LARGEST = 10, 4096, 1e-3, 10_000_000
ROWS = np.dtype([("t", "<u4"), ("x", "<u2"), ("y", "<u2"), ("z", "<u2")])
#: A touch is a reading above this [g]; a vehicle flies again once it has been below it for so long
#: [s] (chosen, as is the time in which the largest reading is looked for).
TOUCH, FLIES, IMPACT = 3.0, 0.030, 0.100


class DropCase(NamedTuple):
    """A vehicle and a height, recorded many times."""

    folder: str
    vehicle: str  # preset
    height: float  # [m]


CASES = (
    DropCase("SoftBottom_50cm", "cognifly", 0.5),
    DropCase("SoftBottom_100cm", "cognifly", 1.0),
    DropCase("SoftBottom_150cm", "cognifly", 1.5),
    DropCase("RigidBottom_30cm", "cognifly-rigid", 0.3),
)


class DropSpread(NamedTuple):
    """Median and quartiles."""

    median: float
    low: float
    high: float

    def holds(self, value: float) -> bool:
        """True between the quartiles."""
        return self.low <= value <= self.high


class DropStatistics(NamedTuple):
    """What many drops from one height gave."""

    peak: DropSpread  # of the specific force [g]
    rise: DropSpread  # from touch to peak [s]
    restitution: DropSpread
    drops: int


def _ms(median: float, low: float, high: float) -> DropSpread:
    return DropSpread(1e-3 * median, 1e-3 * low, 1e-3 * high)


#: Medians and quartiles of the recordings, by folder: all that is kept of them here.
RECORDED = {
    "SoftBottom_50cm": DropStatistics(
        DropSpread(89.7, 79.0, 101.0), _ms(7.0, 5.0, 10.0), DropSpread(0.19, 0.13, 0.25), 101
    ),
    "SoftBottom_100cm": DropStatistics(
        DropSpread(127.0, 113.0, 139.0), _ms(6.0, 2.0, 7.0), DropSpread(0.20, 0.15, 0.28), 96
    ),
    "SoftBottom_150cm": DropStatistics(
        DropSpread(137.0, 122.0, 148.0), _ms(7.0, 6.0, 9.0), DropSpread(0.22, 0.18, 0.28), 89
    ),
    "RigidBottom_30cm": DropStatistics(
        DropSpread(160.0, 137.0, 183.0), _ms(1.0, 1.0, 2.0), DropSpread(0.23, 0.17, 0.28), 88
    ),
}


class DropMeasures(NamedTuple):
    """Of one drop."""

    peak: float  # [g]
    rise: float  # from the first reading of the touch to the largest [s]
    restitution: float  # by the time to the next touch; NaN if there is none


def fall_time(height: float) -> float:
    """Time of a fall from rest [s], in no air."""
    return math.sqrt(2.0 * height / GRAVITY)


def drop_measures(reading: Array, height: float) -> DropMeasures:
    """Largest reading, its time and the restitution of a drop.

    The same for recordings and for flights here.  The restitution is that of the speeds at which a
    body rises to fall for as long as no touch is read, and at which it came down.

    Args:
        reading: Specific force, 1000 a second [g].
        height: From which it was let go [m].

    Raises:
        InputError: If nothing is touched.
    """
    touched = np.flatnonzero(reading > TOUCH)
    if not len(touched):
        raise InputError("no reading above 3 g: nothing was touched")
    first = int(touched[0])
    peak = first + int(np.argmax(reading[first : first + round(IMPACT / PERIOD)]))
    after = touched[touched >= peak]
    gaps = np.diff(after) - 1
    long = np.flatnonzero(gaps >= round(FLIES / PERIOD))
    flight = float(gaps[long[0]]) * PERIOD if len(long) else math.nan
    return DropMeasures(
        float(reading[peak]), (peak - first) * PERIOD, flight / (2.0 * fall_time(height))
    )


def read_drop(path: Path, height: float) -> Array | None:
    """Specific force of a recorded drop [g], 1000 a second; None if it begins within the fall.

    Raises:
        InputError: If it is too large, or no such recording.
    """
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: has more than {LARGEST / 1e6:g} MB")
    given = path.read_bytes()
    if not given or len(given) % ROW:
        raise InputError(f"{path}: must hold rows of {ROW} bytes (got {len(given)} bytes)")
    rows = np.frombuffer(given, ROWS)
    if (np.diff(rows["t"].astype(np.int64)) != round(1e6 * PERIOD)).any():
        raise InputError(f"{path}: must have a row every {1e3 * PERIOD:g} ms")
    counts = np.stack([rows[axis] for axis in "xyz"], axis=1).astype(float)
    if (counts >= COUNTS).any():
        raise InputError(f"{path}: readings must be below {COUNTS} counts")
    scale = SENSITIVITY * np.array([ACROSS, ACROSS, 1.0])

    def size(zero: Array) -> Array:
        return np.asarray(np.linalg.norm((counts - zero) / scale, axis=1))

    above = np.flatnonzero(size(np.median(counts, axis=0)) > TOUCH)
    if not len(above):
        raise InputError(f"{path}: has no reading above {TOUCH:g} g: nothing was touched")
    touch, falls = int(above[0]), round(fall_time(height) / PERIOD)
    if touch < falls:
        return None
    # From the middle of the fall to just before the touch.
    return size(np.median(counts[touch - falls // 2 : max(touch - 5, 1)], axis=0))


def read_drops(folder: Path, case: DropCase) -> list[DropMeasures]:
    """All recorded drops of a case, but those that begin within the fall.

    Args:
        folder: Of a copy of the repository.
        case: One of `CASES`.

    Raises:
        InputError: If there are none, or one cannot be read.
    """
    paths = sorted((folder / case.folder).glob("*.bin"))
    if not paths:
        raise InputError(
            f"{folder}: has no {case.folder}/*.bin; name a copy of "
            "github.com/thecognifly/CrashLandingExperiments"
        )
    read = [read_drop(path, case.height) for path in paths]
    found = [drop_measures(reading, case.height) for reading in read if reading is not None]
    if not found:
        raise InputError(f"{folder}/{case.folder}: no recording has the whole fall")
    return found


def statistics_of(drops: list[DropMeasures]) -> DropStatistics:
    """Medians and quartiles of some drops; of the restitution, those with a second touch."""

    def spread(values: list[float]) -> DropSpread:
        known = np.array([value for value in values if not math.isnan(value)])
        if not len(known):
            return DropSpread(math.nan, math.nan, math.nan)
        low, median, high = np.quantile(known, [0.25, 0.5, 0.75]).tolist()
        return DropSpread(median, low, high)

    return DropStatistics(
        spread([one.peak for one in drops]),
        spread([one.rise for one in drops]),
        spread([one.restitution for one in drops]),
        len(drops),
    )
