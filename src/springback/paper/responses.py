"""Responses of flights: rise time and mean square error of steps, errors on circles.

Trajectories come with instants that are not equally far apart; means over time are therefore taken
by the trapezoidal rule, and crossings by linear interpolation.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np

from springback.errors import InputError
from springback.results.flight import Flight

Array = np.ndarray[Any, np.dtype[np.float64]]
Axis = Literal["x", "y", "z"]

SETTLED = 0.5
"""[s], chosen: the steady state that a response attains is its mean over this end of the dwell."""


def mean_over_time(time: Array, values: Array) -> float:
    """Mean of values over the time that they span; trapezoidal rule."""
    return float(np.trapezoid(values, time) / (time[-1] - time[0]))


def steady_state(time: Array, response: Array) -> float:
    """The steady state that a response attains: its mean over the last `SETTLED` seconds."""
    end = time >= time[-1] - SETTLED
    return mean_over_time(time[end], response[end])


def crossing(time: Array, response: Array, level: float) -> float:
    """Time at which a response first reaches a level above its start [s].

    Raises:
        InputError: If it never does, or starts there.
    """
    k = int(np.argmax(response >= level))
    if k == 0:
        raise InputError(f"the response does not rise through {level:.4g}")
    share = (level - response[k - 1]) / (response[k] - response[k - 1])
    return float(time[k - 1] + share * (time[k] - time[k - 1]))


def rise_time(time: Array, response: Array) -> float:
    """Time from 10 to 90 % of the attained steady state [s]; section IV-C.

    Args:
        time: Instants [s].
        response: To a step from 0, to any value.
    """
    end = steady_state(time, response)
    return crossing(time, response, 0.9 * end) - crossing(time, response, 0.1 * end)


def mean_square_error(time: Array, response: Array, wanted: float = 1.0) -> float:
    """Mean over time of the square of wanted less attained."""
    return mean_over_time(time, (wanted - response) ** 2)


def window(flight: Flight, column: str, begins: float, ends: float) -> tuple[Array, Array]:
    """Instants and values of a column between two times, both ends included [s].

    Values at the ends are interpolated.
    """
    inside = flight.t[(flight.t > begins) & (flight.t < ends)]
    time = np.concatenate([[begins], inside, [ends]])
    return time, np.interp(time, flight.t, flight.columns[column])


def step_response(
    flight: Flight, axis: Axis, begins: float, dwell: float, origin: float
) -> tuple[Array, Array]:
    """Time since a step [s] and way along its axis since then [m], until the dwell is over."""
    time, position = window(flight, axis, begins, begins + dwell)
    return time - begins, position - origin


def circle_errors(
    flight: Flight, period: float, radius: float, begins: float, ends: float, late: float = 0.0
) -> dict[str, float]:
    """Mean square errors on a circle about [0, 0] that starts at [radius, 0] at time 0.

    The circle runs counter-clockwise: p = r (cos ω t, sin ω t), v = ω r (−sin ω t, cos ω t).

    Args:
        flight: With a trajectory.
        period: 2π/ω [s].
        radius: r [m].
        begins: Of the time that counts [s].
        ends: Of the time that counts [s].
        late: Delay of the reference against the flight in a record of both [s].

    Returns:
        Of ``px`` and ``py`` [m²], ``vx`` and ``vy`` [m²/s²].
    """
    rate = 2.0 * math.pi / period
    time, _ = window(flight, "x", begins, ends)
    angle = rate * np.maximum(time - late, 0.0)
    cosine, sine = np.cos(angle), np.sin(angle)
    speed = rate * radius
    wanted = {
        "px": ("x", radius * cosine),
        "py": ("y", radius * sine),
        "vx": ("vx", -speed * sine),
        "vy": ("vy", speed * cosine),
    }
    errors = {}
    for name, (column, path) in wanted.items():
        flown = window(flight, column, begins, ends)[1]
        errors[name] = mean_over_time(time, (path - flown) ** 2)
    return errors
