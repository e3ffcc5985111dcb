"""Flights laid into buffers, fast: only what differs from the first of their kind is laid anew.

Flights that were made ready together share most branches of their trees, the very objects.  So a
tree is compared with that of the first flight branch by branch, and only the leaves that are not
shared are written.  `springback.simulation.flight.loaded` and
`springback.simulation.guided.cabins_loaded` say the same slowly.
"""

from __future__ import annotations

from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.layout import Buffer, row_of, rows
from springback.simulation.aboard import Cabin
from springback.simulation.flight import first_phase, loaded, shape_of
from springback.simulation.guided import cabins_loaded
from springback.simulation.lanes import Shape, empty_groups
from springback.simulation.record import FLYING, Model
from springback.vehicle.state import State

#: Rows of a branch: those of its leaves, or what its branches are.
Places = tuple[Any, ...]


class Unlike(Exception):  # it says what is so, and nobody meets it
    """A flight is of another kind than the first."""


def places_of(tree: tuple[Any, ...], first: int) -> tuple[Places, int]:
    """Rows of all leaves of a tree from a row on, nested as they are, and the row after it."""
    places: list[Any] = []
    for branch in tree:
        if isinstance(branch, tuple):
            inner, first = places_of(branch, first)
            places.append(inner)
        else:
            places.append(first)
            first += 1
    return tuple(places), first


def gather(
    tree: tuple[Any, ...],
    like: tuple[Any, ...],
    places: Places,
    found: list[int],
    values: list[float],
) -> None:
    """Rows and values of the leaves of a tree that are not those of another.

    Args:
        tree: Of a flight.
        like: Of the first flight.
        places: Of the first flight's leaves.
        found: Gets the rows.
        values: Gets the values.

    Raises:
        Unlike: If the trees are of different types.
    """
    if type(tree) is not type(like) or len(tree) != len(like):
        raise Unlike
    for branch, same, place in zip(tree, like, places, strict=True):
        if branch is not same:
            if place.__class__ is tuple:
                gather(branch, same, place, found, values)
                continue
            if branch.__class__ is not float and isinstance(branch, tuple):
                raise Unlike
            found.append(place)
            values.append(branch)


class Differences:
    """What differs from the first flight's column, flight by flight, for one kind of buffer."""

    def __init__(self, column: Buffer) -> None:
        """Of flights that are like the one of this column, shape (rows,), but for what is added."""
        self._column = column
        self._patterns: list[list[int]] = []
        self._of: list[int] = []
        self._values: list[list[float]] = []

    def add(self, found: list[int], values: list[float]) -> None:
        """One more flight: rows and values of the leaves that are not those of the first."""
        if not self._patterns or self._patterns[-1] != found:
            self._patterns.append(found)
        self._of.append(len(self._patterns) - 1)
        self._values.append(values)

    def buffers(self, out: Buffer, width: int) -> None:
        """Lay all flights into buffers of shape (groups, rows x width); spare lanes as the last."""
        count, lanes = len(self._of), out.reshape(len(out), -1, width)
        lanes[:] = self._column[None, :, None]
        flights = np.arange(len(out) * width)
        flights[count:] = count - 1
        of = np.array(self._of)[flights]
        for number, pattern in enumerate(self._patterns):
            mine = np.flatnonzero(of == number)
            given = [self._values[k] for k in flights[mine].tolist()]
            values = np.fromiter(chain.from_iterable(given), np.float64, len(given) * len(pattern))
            group, lane = np.divmod(mine, width)
            lanes[group[:, None], np.array(pattern, dtype=np.intp), lane[:, None]] = values.reshape(
                len(given), len(pattern)
            )


class Laid(NamedTuple):
    """Flights of one kind in their buffers."""

    shape: Shape
    model: Model
    start: State
    cabin: Cabin | None
    buffers: Buffer
    aboard: Buffer | None
    """None without pilots."""


class Loader:
    """Takes flights of one kind, and lays them into buffers."""

    def __init__(self, model: Model, start: State, cabin: Cabin | None, width: int) -> None:
        """Of the first flight, which is to be added like all others."""
        self.model, self.start, self.cabin, self.width = model, start, cabin, width
        self.count = 0
        self._shape = shape_of(model, start)
        column = loaded(self._shape, [model], [start], width).reshape(-1, width)[:, 0]
        self._flights = Differences(column)
        self._model, after = places_of(model, 0)
        self._start, _ = places_of(start, after)
        self._phase = len(column) - rows(self._shape.record) + row_of(self._shape.record, "phase")
        self._phase_of_first = column[self._phase]
        self._status = self._phase - row_of(self._shape.record, "phase")
        self._status += row_of(self._shape.record, "status")
        if cabin is not None:
            self._cabins = Differences(cabins_loaded([cabin], 1)[0])
            self._cabin, _ = places_of(cabin, 0)

    def add(self, model: Model, start: State, cabin: Cabin | None) -> None:
        """One more flight.

        Raises:
            Unlike: If it is of another kind; nothing is added then.
        """
        found: list[int] = []
        values: list[float] = []
        gather(model, self.model, self._model, found, values)
        gather(start, self.start, self._start, found, values)
        if (cabin is None) != (self.cabin is None):
            raise Unlike
        if cabin is not None and self.cabin is not None:
            rows_aboard: list[int] = []
            values_aboard: list[float] = []
            gather(cabin, self.cabin, self._cabin, rows_aboard, values_aboard)
            self._cabins.add(rows_aboard, values_aboard)
        phase = first_phase(model, start)
        if phase != self._phase_of_first:
            found.append(self._phase)
            values.append(phase)
        self._flights.add(found, values)
        self.count += 1

    def laid(self) -> Laid:
        """All flights in their buffers; spare lanes repeat the last flight, already ended."""
        width, buffers = self.width, empty_groups(self._shape, self.count, self.width)
        self._flights.buffers(buffers, width)
        groups = len(buffers)
        spare = groups * width - self.count
        if spare:
            buffers[-1].reshape(-1, width)[self._status, width - spare :] = FLYING + 1.0
        aboard = None
        if self.cabin is not None:
            aboard = np.zeros((groups, rows(self.cabin) * width))
            self._cabins.buffers(aboard, width)
        return Laid(self._shape, self.model, self.start, self.cabin, buffers, aboard)
