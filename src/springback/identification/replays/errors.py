"""Errors of a replay at some instants after touch, beside the uncertainty of what was measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.sensor_chain import attitude_errors
from springback.identification.replays.features import ForceRise
from springback.identification.replays.replay import Replay
from springback.logs.frame_turns import conjugate, product, rotation_vector
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    QUANTITIES,
    SPECIFIC_FORCE,
    VELOCITY,
    Array,
)
from springback.random_streams import Purpose, stream

#: Instants after touch of the table [s] (0: how well the flight was met before touch).
INSTANTS = (0.0, 0.05, 0.1, 0.2, 0.3)
#: Uncertainties beyond which an error is not one of the measurement: 95 % of a normal distribution.
BEYOND = 2.0
#: Uncertainties at touch from which it is said that the start is off (chosen).
FAR = 3.0
#: Draws of noise for numbers that are read off a curve (chosen).
DRAWS = 64
#: Quantities of the table, in its order.
COMPARED = (POSITION, VELOCITY, ATTITUDE, ANGULAR_VELOCITY, ARM_LENGTH)
TOUCH, PEAK, STROKE = "touch", "peak specific force", "largest compression of an arm"


class ErrorRow(NamedTuple):
    """One error; SI, errors are predicted less recorded."""

    what: str
    part: str
    """An axis, an arm, or ``all``: the size of the error."""
    wanted: float | None
    """Instant after touch [s]; None for what is read off a whole curve."""
    time: float
    """Of the nearest sample, after touch [s]."""
    recorded: float | None
    predicted: float | None
    error: float
    uncertainty: float
    """One standard deviation: of the sample, the start, the clocks and biases."""
    unit: str
    channel: str

    @property
    def uncertainties(self) -> float:
        """Size of the error over its uncertainty."""
        return abs(self.error) / self.uncertainty

    @property
    def is_beyond(self) -> bool:
        """True if the uncertainty does not explain it."""
        return self.uncertainties > BEYOND


class ChannelErrors(NamedTuple):
    """A channel over the whole replay."""

    reading: ChannelWindow
    recorded: Array
    """Shape (samples, width); attitudes as turns since the start, body axes [rad]."""
    predicted: Array
    errors: Array
    """Predicted less recorded."""
    uncertainties: Array
    """One standard deviation each."""
    covariance: Array
    """Of the errors, shape (samples, width, width)."""

    @property
    def parts(self) -> list[str]:
        """Names of the numbers of a sample."""
        width = self.errors.shape[1]
        if self.reading.quantity == ARM_LENGTH:
            return [f"arm {k}" for k in range(1, width + 1)]
        return list("xyz")


def unit_of(quantity: str) -> str:
    """SI unit of what is compared."""
    return "rad" if quantity == ATTITUDE else QUANTITIES[quantity].unit


def channel_errors(flown: Replay) -> list[ChannelErrors]:
    """Errors of all channels of a replay."""
    return [_of_channel(flown, one) for one in flown.readings]


def _of_channel(flown: Replay, one: ChannelWindow) -> ChannelErrors:
    predicted, (up, down) = flown.predicted[one.name], flown.changed[one.name]
    recorded = one.values[:, : predicted.shape[1]]
    if one.quantity == ATTITUDE:
        # small turns of the body from what is recorded to what is predicted
        errors = -attitude_errors(predicted, recorded)
        here = np.broadcast_to(predicted, up.shape)
        slopes = 0.5 * (attitude_errors(here, up) - attitude_errors(here, down))
        start = conjugate(flown.problem.impact.start.attitude)
        recorded, predicted = (
            rotation_vector(product(start, values)) for values in (recorded, predicted)
        )
    else:
        errors, slopes = predicted - recorded, 0.5 * (up - down)
    width = errors.shape[1]
    sigma: Any = np.broadcast_to(one.noise.stationary[:width], errors.shape)
    if one.quantity == ARM_LENGTH:
        sigma = np.hypot(
            sigma, flown.problem.resolution(one._replace(values=one.values[:, :width]))
        )
    covariance = np.einsum("dsi,dsj->sij", slopes, slopes)
    places = np.arange(width)
    covariance[:, places, places] += sigma**2
    uncertainties = np.sqrt(covariance[:, places, places])
    return ChannelErrors(one, recorded, predicted, errors, uncertainties, covariance)


def error_rows(flown: Replay, channels: Sequence[ChannelErrors]) -> list[ErrorRow]:
    """Rows of the table: touch and peaks, then all quantities at each instant."""
    found = _force_rows(flown) + _stroke_rows(flown)
    by_quantity = {one.reading.quantity: one for one in channels}
    for wanted in INSTANTS:
        for quantity in COMPARED:
            if quantity in by_quantity:
                found += _instant_rows(by_quantity[quantity], flown.touch, wanted)
    return found


def _instant_rows(one: ChannelErrors, touch: float, wanted: float) -> list[ErrorRow]:
    """Errors at the sample nearest to an instant, at touch the last before it."""
    times = one.reading.times - touch
    known = np.isfinite(one.errors).all(axis=1)
    if wanted == 0.0:
        known &= times <= 0.0
    if not known.any():
        return []
    k = int(np.argmin(np.where(known, np.abs(times - wanted), np.inf)))
    if abs(times[k] - wanted) > 1.5 * float(np.median(np.diff(times))):
        return []
    quantity = one.reading.quantity
    common = quantity, wanted, float(times[k]), unit_of(quantity), one.reading.name

    def row(part: str, recorded: Any, predicted: Any, error: Any, uncertainty: Any) -> ErrorRow:
        what, at, time, unit, channel = common
        return ErrorRow(
            what,
            part,
            at,
            time,
            recorded,
            predicted,
            float(error),
            float(uncertainty),
            unit,
            channel,
        )

    size = np.linalg.norm(one.errors[k]), np.sqrt(np.trace(one.covariance[k]))
    return [row("all", None, None, *size)] + [
        row(part, float(one.recorded[k, j]), float(one.predicted[k, j]), one.errors[k, j],
            one.uncertainties[k, j])
        for j, part in enumerate(one.parts)
    ]  # fmt: skip


def _read_off(
    flown: Replay, one: ChannelWindow, number: Callable[[Array], float]
) -> tuple[float, float, float]:
    """Recorded, predicted, and uncertainty of a number that is read off a curve."""
    predicted, (up, down) = flown.predicted[one.name], flown.changed[one.name]
    recorded = one.values[:, : predicted.shape[1]]
    here = number(predicted)
    slopes = np.array([0.5 * (number(a) - number(b)) for a, b in zip(up, down, strict=True)])
    generator = stream(0, Purpose.SCATTER)
    sigma = one.noise.stationary[: predicted.shape[1]]
    lost = np.where(np.isnan(recorded), np.nan, 0.0)
    draws = np.array([
        number(predicted + lost + sigma * generator.standard_normal(predicted.shape)) - here
        for _ in range(DRAWS)
    ])  # fmt: skip
    draws = draws[~np.isnan(draws)]
    scatter = float((draws**2).mean()) if len(draws) else np.nan  # nothing to be read off
    variance = float(np.nansum(slopes**2)) + scatter
    return number(recorded), here, float(np.sqrt(variance))


def _force_rows(flown: Replay) -> list[ErrorRow]:
    """Touch and peak of the specific force."""
    one = flown.of(SPECIFIC_FORCE)
    if one is None:
        return []
    rise = ForceRise.of_recorded(one, flown.touch, flown.impact.release - flown.impact.touch)
    rows = []
    for what, number, unit in ((TOUCH, rise.time, "s"), (PEAK, rise.peak, "m/s^2")):
        recorded, predicted, uncertainty = _read_off(flown, one, number)
        if np.isfinite([recorded, predicted, uncertainty]).all() and uncertainty > 0.0:
            off = flown.touch if what == TOUCH else 0.0
            rows.append(ErrorRow(
                what, "all", None, flown.touch - off, recorded - off, predicted - off,
                predicted - recorded, uncertainty, unit, one.name,
            ))  # fmt: skip
    return rows


def _stroke_rows(flown: Replay) -> list[ErrorRow]:
    """Largest compression of an arm."""
    one = flown.of(ARM_LENGTH)
    if one is None:
        return []

    def stroke(values: Array) -> float:
        return float(np.nanmax(-values)) if not np.isnan(values).all() else np.nan

    recorded, predicted, uncertainty = _read_off(flown, one, stroke)
    resolution = np.max(flown.problem.resolution(one))
    uncertainty = float(np.hypot(uncertainty, resolution))
    if not np.isfinite([recorded, predicted]).all() or not uncertainty > 0.0:
        return []
    return [ErrorRow(
        STROKE, "all", None, 0.0, recorded, predicted, predicted - recorded, uncertainty, "m",
        one.name,
    )]  # fmt: skip


# -- words ----------------------------------------------------------------------------------------


def verdict(rows: Sequence[ErrorRow]) -> str:
    """The answer in one sentence."""
    shown = [row for row in rows if row.part == "all"]
    beyond = [row for row in shown if row.is_beyond]
    if not shown:
        return "nothing could be compared: no channel of the log has samples after touch"
    if not beyond:
        return f"all {len(shown)} errors are within twice the uncertainty of the measurement"
    worst = max(beyond, key=lambda row: row.uncertainties)
    when = "" if worst.wanted is None else f" {1e3 * worst.wanted:.0f} ms after touch"
    return (
        f"{len(beyond)} of {len(shown)} errors are beyond twice the uncertainty of the "
        f"measurement, most of all the {worst.what}{when}: {worst.uncertainties:.1f} uncertainties"
    )


def remarks(flown: Replay, rows: Sequence[ErrorRow]) -> list[str]:
    """What the errors say before touch, where the contact has no part in them."""
    found = []
    early = [
        row for row in rows
        if row.part == "all" and row.wanted == 0.0 and row.what != ARM_LENGTH
        and row.uncertainties > FAR
    ]  # fmt: skip
    if early:
        named = ", ".join(f"{row.what} by {row.uncertainties:.1f} uncertainties" for row in early)
        found.append(
            f"already at touch the replay is off ({named}): thrusts, the order of rotors or the "
            "start, not the impact"
        )
    if flown.impact.clipped:
        found.append(
            f"{flown.impact.clipped} samples of {flown.impact.channel} are clipped: the peak is "
            "that of its range, recorded and predicted"
        )
    arms = flown.of(ARM_LENGTH)
    if arms is not None and arms.clipped is not None and arms.clipped.any():
        found.append(
            f"{int(arms.clipped.any(axis=1).sum())} samples of {arms.name} are at the end of their "
            "range: predictions beyond it are compared as what the sensor would tell"
        )
    touch = next((row for row in rows if row.what == TOUCH), None)
    if touch is not None and touch.is_beyond:
        speed = float(np.linalg.norm(flown.problem.impact.start.velocity))
        late, when = abs(touch.error), "late" if touch.error > 0.0 else "early"
        found.append(
            f"touch is {1e3 * late:.1f} ms too {when}, {1e3 * late * speed:.0f} mm at this speed: "
            "the obstacle's place or the origin of the tracks (--align moves the start)"
        )
    return found


def as_data(flown: Replay, rows: Sequence[ErrorRow]) -> dict[str, Any]:
    """A replay and its errors as plain data, SI."""
    start = flown.problem.impact.start
    return {
        "verdict": verdict(rows),
        "impact": flown.impact._asdict() | {
            "peak": flown.impact.peak if np.isfinite(flown.impact.peak) else None
        },
        "begin": flown.begin,
        "start": {
            "position": start.position.tolist(), "velocity": start.velocity.tolist(),
            "quaternion": start.attitude.tolist(),
            "angular_velocity": start.angular_velocity.tolist(), "tracked": start.tracked,
        },
        "told": list(flown.told),
        "warnings": [*flown.warnings, *remarks(flown, rows)],
        "errors": [row_data(row) for row in rows],
    }  # fmt: skip


def row_data(row: ErrorRow) -> dict[str, Any]:
    """A row as plain data, with its uncertainties."""
    return row._asdict() | {"uncertainties": row.uncertainties}
