"""Instants of a trajectory that are kept, as they come from the logs of a flight."""

from __future__ import annotations

import numpy as np

from springback.errors import InputError
from springback.kernels.layout import Buffer

#: Largest number of instants of a trajectory (chosen: some 2.5 GB with the telemetry and all
#: columns).
MOST_INSTANTS = 1_000_000


class StoredRows:
    """Rows of a trajectory: of each interval the first, and the last of the flight."""

    def __init__(self, width: int, interval: float = 0.0) -> None:
        """Begin without a row.

        Args:
            width: Number of columns, of which the first is the time [s].
            interval: Length of an interval [s]; 0: all rows are kept.
        """
        self._interval, self._last = interval, -1
        self._parts: list[Buffer] = []
        self._end = np.zeros((0, width))
        self.count = 0

    def add(self, rows: Buffer) -> None:
        """Take the next rows; those that are kept are copied if others are not."""
        if not len(rows):
            return
        if self._interval > 0.0:
            # An instant at the beginning of an interval, to rounding, is in it.
            number = np.floor(rows[:, 0] / self._interval + 1e-6).astype(np.int64)
            first = np.diff(number, prepend=self._last) > 0
            self._last, self._end = int(number[-1]), rows[len(rows) - 1 + int(first[-1]) :].copy()
            rows = rows[first]
        self._parts.append(rows)
        self.count += len(rows)

    def all(self) -> Buffer:
        """The kept rows, one for each instant."""
        return np.concatenate([*self._parts, self._end])


def check_instants(instants: int, reached: float, until: float) -> None:
    """Stop a flight whose trajectory has become too long.

    Args:
        instants: Number of instants of the trajectory so far, or expected.
        reached: Simulated time of the last [s].
        until: End of the flight [s].

    Raises:
        InputError: With the numbers, and with remedies.
    """
    if instants > MOST_INSTANTS:
        raise InputError(
            f"simulation.duration: a trajectory has at most {MOST_INSTANTS} instants, and this one "
            f"has {instants} by {reached:.4g} s of {until:g} s; keep fewer of them with "
            "simulation.record_interval, or give a shorter duration or a slower clock"
        )
