"""Rates and delays of devices, as whole ticks of the clock."""

from __future__ import annotations

import contextlib
import functools
import math
from collections.abc import Iterator
from typing import Any

from pydantic_core import PydanticCustomError

from springback.sensing.memory import MOST_PERIODS
from springback.settings import problem
from springback.simulation.onboard import Draw

#: Largest deviation of a period or delay from a whole number of ticks: rounding of decimals.
WHOLE = 1e-6


def period(rate: float, tick: float) -> float:
    """Period of a device in whole ticks.

    Args:
        rate: Rate of the device [Hz].
        tick: Duration of a tick of the clock [s].

    Raises:
        The problem, with the nearest rates that divide the clock's.
    """
    exact = 1.0 / (rate * tick)
    every = round(exact)
    if every >= 1 and abs(exact - every) < WHOLE:
        return float(every)
    below, above = math.floor(exact), math.ceil(exact)
    near = sorted({1.0 / (count * tick) for count in (below, above) if count >= 1})
    words = " or ".join(f"{entry:.6g} Hz" for entry in near)
    raise problem(
        f"must divide the clock's rate of {1.0 / tick:.6g} Hz (got {rate:.6g} Hz); nearest: {words}"
    )


def lateness(delay: float, every: float, tick: float) -> float:
    """Delay of a device in whole ticks.

    Args:
        delay: Delay [s].
        every: Period of the device [ticks].
        tick: Duration of a tick of the clock [s].

    Raises:
        The problem, if the delay is not a whole number of ticks or exceeds four periods.
    """
    exact = delay / tick
    ticks = round(exact)
    most = MOST_PERIODS * every
    if abs(exact - ticks) >= WHOLE:
        raise problem(f"must be a whole number of ticks of {tick:.6g} s (got {delay:.6g} s)")
    if ticks > most:
        raise problem(
            f"must be at most {MOST_PERIODS} sampling periods, {most * tick:.6g} s "
            f"(got {delay:.6g} s)"
        )
    return float(ticks)


@functools.singledispatch
def draws(device: Any, channels: int) -> tuple[Draw, ...]:
    """Schedule of a device's normal numbers; between its draws it gets zeros.

    Devices that are not registered get new numbers at every tick.

    Args:
        device: Settings of the device.
        channels: Number of its noise channels.
    """
    return (Draw(channels, 1),)


@contextlib.contextmanager
def inside(table: str) -> Iterator[None]:
    """Prefix the table's name to the key in problems of checks that only know the key."""
    try:
        yield
    except PydanticCustomError as error:
        field = (error.context or {}).get("field", "")
        raise problem(error.message(), f"{table}.{field}" if field else table) from None
