"""Many flights in buffers: one by one, or as many as differ from one in the same numbers.

Each column is that of `springback.simulation.flight.flight_buffers` and
`springback.simulation.guided.avionics_buffers`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.layout import Buffer, row_of, rows, zeros
from springback.kernels.trees import leaves
from springback.simulation.flight import flight_column, shape_of
from springback.simulation.lanes import Shape, empty_groups
from springback.simulation.measuring.record import FLYING, Model
from springback.simulation.onboard import Avionics
from springback.vehicle.state import State

Leaves = tuple[Sequence[int], Buffer]
"""Numbers of leaves, and their values in each flight, shape (flights, leaves)."""
#: Of a flight that differs from its column in nothing.
NO_LEAVES: Leaves = ((), np.zeros((1, 0)))


class _LaidFlights(NamedTuple):
    """Flights that differ in the same rows of a buffer from one column."""

    column: Buffer  # shape (rows,)
    rows: Sequence[int]
    values: Buffer  # shape (flights, rows)


class LoadedFlights(NamedTuple):
    """Flights of one kind in their buffers."""

    shape: Shape
    model: Model
    start: State
    avionics: Avionics | None
    buffers: Buffer
    onboard: Buffer | None
    """None without pilots."""


class Loader:
    """Flights of one kind, while they are collected."""

    def __init__(self, model: Model, start: State, avionics: Avionics | None, width: int) -> None:
        """No flights yet: the first one is added like all others."""
        self.model, self.start, self.avionics, self.width = model, start, avionics, width
        self.count = 0
        self._shape = shape_of(model, start)
        self._flights: list[_LaidFlights] = []
        self._onboard: list[_LaidFlights] = []

    def add(
        self,
        model: Model,
        start: State,
        avionics: Avionics | None,
        flown: Leaves = NO_LEAVES,
        onboard: Leaves = NO_LEAVES,
    ) -> None:
        """Add a flight, or several that differ from it in some leaves and begin in its phase.

        All are of the types of the first.

        Args:
            model: Of the flight.
            start: Likewise.
            avionics: Likewise.
            flown: Leaves of model and start in which several flights differ from it.
            onboard: Leaves of the avionics in which they differ.
        """
        column = flight_column(self._shape, model, start, self.width)
        self._flights.append(_LaidFlights(column, *flown))
        if avionics is not None:
            self._onboard.append(_LaidFlights(np.array(leaves(avionics)), *onboard))
        self.count += len(flown[1])

    def flights(self) -> LoadedFlights:
        """Buffers of all flights; spare lanes repeat the last flight, already ended."""
        width, buffers = self.width, empty_groups(self._shape, self.count, self.width)
        _lay(self._flights, buffers, width)
        spare = -self.count % width
        status = row_of(self._shape.record.stepping, "status") - rows(self._shape.record)
        buffers.reshape(len(buffers), -1, width)[-1, status, width - spare :] = FLYING + 1.0
        onboard = None
        if self.avionics is not None:
            onboard = zeros(len(buffers), rows(self.avionics) * width)
            _lay(self._onboard, onboard, width)
        return LoadedFlights(self._shape, self.model, self.start, self.avionics, buffers, onboard)


def _lay(pieces: Sequence[_LaidFlights], buffers: Buffer, width: int) -> None:
    """Store flights lane by lane in buffers of shape (groups, rows x width)."""
    lanes: Any = buffers.reshape(len(buffers), -1, width)
    count = 0
    for piece in pieces:
        group, lane = np.divmod(np.arange(count, count + len(piece.values)), width)
        lanes[group, :, lane] = piece.column
        places = np.array(piece.rows, dtype=np.intp)
        lanes[group[:, None], places, lane[:, None]] = piece.values
        count += len(piece.values)
    last = (count - 1) % width
    lanes[-1, :, last + 1 :] = lanes[-1, :, last, None]
