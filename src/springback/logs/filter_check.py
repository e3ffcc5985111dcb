"""Is an accelerometer behind a low-pass that its log does not tell?  Its own noise says so.

Noise of a sensor is nearly white up to half its rate; behind a filter it stops short of that.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.logs.recording import SPECIFIC_FORCE, LogChannel

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Samples of a piece, and fewest pieces, of which half overlap (chosen).
PIECE, FEWEST = 128, 4
#: Density that no accelerometer of a vehicle is below [m/s²/√Hz] (chosen: 10 µg/√Hz; the quietest
#: of them have 20, those of autopilots 70 and more: data sheets of ADXL355 and ICM-42688-P).
QUIETEST = 1e-4
#: Factors by which power falls for a filter to be seen: from its plateau, from one octave to the
#: next and within the last (chosen: a filter of second order has 1/16 and 1/5, white noise 1).
PLATEAU, OCTAVE, LAST = 1e-3, 1.0 / 8.0, 1.0 / 2.5
#: Times the quietest density that there must be for noise to tell anything (chosen).
SOME = 10.0
#: Share of the power below the frequency that is said (chosen).
EDGE = 0.999


def untold_filter(channel: LogChannel) -> str:
    """That an accelerometer stops short of half its rate, and what to tell; empty if it does not.

    Args:
        channel: Of a log.  One of which the log tells a low-pass or a mean is not looked at.
    """
    chain = channel.chain
    if channel.quantity != SPECIFIC_FORCE or chain.low_pass is not None:
        return ""
    if chain.average is not None or chain.smoothed or not channel.rate:
        return ""
    values = channel.values[~channel.is_lost]
    if len(values) < (FEWEST + 1) * PIECE // 2:
        return ""
    frequencies, density = _density(values, channel.rate)
    if not _stops(frequencies / (0.5 * channel.rate), density):
        return ""
    power = np.cumsum(density)
    edge = float(frequencies[int(np.searchsorted(power, EDGE * power[-1]))])
    return (
        f"{channel.name} has {100.0 * EDGE:g} % of its noise below {edge:.0f} Hz and none near "
        f"{0.5 * channel.rate:.0f} Hz: it is behind a low-pass that the log does not tell; give "
        'its corner to a plan as sensors.accelerometer.low_pass = "30 Hz +- 20 %", with '
        "low_pass_order = 2 if it is an autopilot's"
    )


def _density(values: Array, rate: float) -> tuple[Array, Array]:
    """Frequencies [Hz] and density of the quietest axis at quiet times, without the mean.

    Medians over pieces leave out what is short, such as an impact.
    """
    starts = range(0, len(values) - PIECE + 1, PIECE // 2)
    line = np.linspace(-1.0, 1.0, PIECE)
    basis = np.stack([np.ones(PIECE), line, line**2, line**3], axis=1)
    smoothing = np.eye(PIECE) - basis @ np.linalg.pinv(basis)  # takes the motion out
    window = np.hanning(PIECE)
    pieces = np.array([window[:, None] * (smoothing @ values[k : k + PIECE]) for k in starts])
    power = np.abs(np.fft.rfft(pieces, axis=1)) ** 2 * 2.0 / (rate * float(window @ window))
    # The median of χ² of two degrees of freedom is ln 2 of its mean.
    density = np.asarray(np.median(power, axis=0) / np.log(2.0), dtype=float)
    quiet = int(np.argmin(density.sum(axis=0)))
    frequencies = np.asarray(np.fft.rfftfreq(PIECE, 1.0 / rate), dtype=float)
    return frequencies[1:], density[1:, quiet]


def _stops(shares: Array, density: Array) -> bool:
    """True if there is power, but next to none near half the rate.

    Args:
        shares: Frequencies over half the rate.
        density: At these [(m/s²)²/Hz].
    """

    def of(low: float, high: float) -> float:
        return float(np.mean(density[(shares >= low) & (shares < high)]))

    most = float(np.max(density))
    last, before = of(0.5, 0.95), of(0.25, 0.5)
    if last > PLATEAU * most or most < SOME * QUIETEST**2:
        return False
    falls = of(0.75, 0.95) < LAST * of(0.5, 0.65)
    return last < QUIETEST**2 or (last < OCTAVE * before and falls)
