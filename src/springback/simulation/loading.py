"""Fast loading of flights into buffers: only their differences from a similar flight are written.

Flights that are built together share most branches of their trees as objects.  So each tree is
compared branch by branch with that of an earlier flight, and only the leaves of branches that are
not shared are written.  `springback.simulation.flight.flight_buffers` and
`springback.simulation.guided.avionics_buffers` are the slow equivalents.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.layout import Buffer, row_of, rows, zeros
from springback.kernels.trees import function_of
from springback.simulation.flight import first_phase, flight_buffers, shape_of
from springback.simulation.guided import avionics_buffers
from springback.simulation.lanes import Shape, buffer_rows, empty_groups
from springback.simulation.onboard import Avionics
from springback.simulation.record import FLYING, Model
from springback.vehicle.state import State

#: If a flight differs from the one it is compared with in a larger share of its leaves, later ones
#: are compared with this one (chosen) ...
MOST_DIFFERENT = 0.25
#: ... but at most once in so many flights, because its column takes long (chosen).
PATIENCE = 16


class DifferentStructure(Exception):  # internal: it is always caught
    """A flight has another structure than the first."""


class Comparison:
    """Comparison of trees with a first one of their type, by a generated function.

    A loop over branches would take three times as long.
    """

    def __init__(self, tree: tuple[Any, ...]) -> None:
        """Comparison with a tree; its function is generated on first use."""
        self._rows: list[range] = []
        self._row, self._names = 0, 0
        self._scope: dict[str, Any] = {"Unlike": DifferentStructure}
        self._lines: list[str] = []
        self._tree = tree
        self._differing: Callable[..., None] | None = None

    def gather(self, tree: tuple[Any, ...], found: list[int], values: list[float]) -> None:
        """Append the differences from the first tree.

        Args:
            tree: Of another flight.
            found: Numbers of the parts that differ; appended to.
            values: Their leaves; appended to.

        Raises:
            DifferentStructure: If the trees are of different types.
        """
        if tree is self._tree:
            return
        if self._differing is None:
            self._compare(self._tree, "tree", "like", "")
            self._differing = function_of("tree, like, found, values", self._lines, self._scope)
        self._differing(tree, self._tree, found, values)

    def begin(self, tree: tuple[Any, ...]) -> None:
        """Compare with another first tree of the same type from now on."""
        self._tree = tree

    def rows(self, found: Sequence[int]) -> list[int]:
        """Rows of the leaves of some parts."""
        return [row for number in found for row in self._rows[number]]

    def _compare(self, tree: tuple[Any, ...], mine: str, first: str, indent: str) -> None:
        """Append lines that compare one branch, which is not the same object as the first's."""
        kind = type(tree)
        self._scope[f"{kind.__name__}_{id(kind)}"] = kind
        wrong = f"{mine}.__class__ is not {kind.__name__}_{id(kind)}"
        wrong += f" or len({mine}) != {len(tree)}" if kind is tuple else ""
        self._lines.append(f"{indent}if {wrong}: raise Unlike")
        if not any(isinstance(branch, tuple) for branch in tree):
            self._take(mine, len(tree), indent)
            return
        names = [(f"a{self._names + k}", f"b{self._names + k}") for k in range(len(tree))]
        self._names += len(tree)
        self._lines.append(f"{indent}{', '.join(a for a, _ in names)}, = {mine}")
        self._lines.append(f"{indent}{', '.join(b for _, b in names)}, = {first}")
        for branch, (a, b) in zip(tree, names, strict=True):
            self._lines.append(f"{indent}if {a} is not {b}:")
            if isinstance(branch, tuple):
                self._compare(branch, a, b, indent + "    ")
            else:
                self._lines.append(f"{indent}    if isinstance({a}, tuple): raise Unlike")
                self._take(f"({a},)", 1, indent + "    ")

    def _take(self, values: str, count: int, indent: str) -> None:
        """Append lines that take the leaves of one part."""
        self._lines.append(f"{indent}found.append({len(self._rows)}); values += {values}")
        self._rows.append(range(self._row, self._row + count))
        self._row += count


class _Alike(NamedTuple):
    """Flights that differ from a column in the same rows."""

    column: int
    flights: Any  # their numbers, shape (flights,)
    rows: Any  # shape (rows,)
    values: Buffer  # shape (flights, rows)


class Differences:
    """Differences of flights from the column of one of them, for one kind of buffer."""

    def __init__(self) -> None:
        """No flights yet; a column must come first."""
        self._columns: list[Buffer] = []
        self._alike: list[_Alike] = []
        self._patterns: dict[tuple[int, ...], int] = {}
        self._of: list[int] = []
        self._values: list[list[float]] = []

    def begin(self, column: Buffer) -> None:
        """Take the differences of later flights from this column, shape (rows,)."""
        self._columns.append(column)

    def add(self, found: list[int], values: list[float]) -> None:
        """Add a flight: the parts that differ from the column, and their leaves."""
        pattern = (len(self._columns) - 1, *found)
        self._of.append(self._patterns.setdefault(pattern, len(self._patterns)))
        self._values.append(values)

    def add_alike(self, rows: Sequence[int], values: Buffer) -> None:
        """Add many flights that differ from the column in the same rows.

        Args:
            rows: Rows in which they differ.
            values: Their values there, shape (flights, rows).
        """
        numbers = np.arange(len(self._of), len(self._of) + len(values))
        self._alike.append(_Alike(len(self._columns) - 1, numbers, np.array(rows, int), values))
        self._of += [-1] * len(values)
        self._values += [[]] * len(values)

    def buffers(
        self, out: Buffer, width: int, rows_of: Callable[[Sequence[int]], list[int]]
    ) -> None:
        """Write all flights to buffers, shape (groups, rows x width); spare lanes as the last."""
        count, lanes = len(self._of), out.reshape(len(out), -1, width)
        of, pieces = np.array(self._of), [*self._alike]
        for (column, *pattern), number in self._patterns.items():
            mine, places = np.flatnonzero(of == number), rows_of(pattern)
            values = chain.from_iterable(self._values[k] for k in mine.tolist())
            shape = len(mine), len(places)
            new = np.fromiter(values, np.float64, shape[0] * shape[1]).reshape(shape)
            pieces.append(_Alike(column, mine, np.array(places, dtype=np.intp), new))
        for piece in pieces:
            group, lane = np.divmod(piece.flights, width)
            lanes[group, :, lane] = self._columns[piece.column]
            lanes[group[:, None], piece.rows, lane[:, None]] = piece.values
        lanes[-1, :, (count - 1) % width + 1 :] = lanes[-1, :, (count - 1) % width, None]


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
    """Flights of one kind, to be written to buffers."""

    def __init__(self, model: Model, start: State, avionics: Avionics | None, width: int) -> None:
        """No flights yet: the first one is added like all others."""
        self.model, self.start, self.avionics, self.width = model, start, avionics, width
        self.count = 0
        self._shape = shape_of(model, start)
        end = buffer_rows(self._shape, width)
        record = end - rows(self._shape.record)
        self._status = record + row_of(self._shape.record.stepping, "status")
        self._phase = record + row_of(self._shape.record.stepping, "phase")
        self._phases: list[float] = []
        self._flights, self._both = Differences(), Comparison((model, start))
        self._onboard, self._avionics = (
            Differences(),
            Comparison(avionics if avionics is not None else ()),
        )
        self._few = MOST_DIFFERENT * (end + (rows(avionics) if avionics is not None else 0))
        self._begin(model, start, avionics)

    def _begin(self, model: Model, start: State, avionics: Avionics | None) -> None:
        """Compare with another flight from now on."""
        column = flight_buffers(self._shape, [model], [start], self.width).reshape(-1, self.width)[
            :, 0
        ]
        self._flights.begin(column)
        self._both.begin((model, start))
        if avionics is not None:
            self._onboard.begin(avionics_buffers([avionics], 1)[0])
            self._avionics.begin(avionics)
        self._begun = self.count

    def add(self, model: Model, start: State, avionics: Avionics | None) -> None:
        """Add a flight.

        Raises:
            DifferentStructure: If it is of another kind; nothing is added then.
        """
        found: tuple[list[int], list[int]] = [], []
        values: tuple[list[float], list[float]] = [], []
        self._both.gather((model, start), found[0], values[0])
        if (avionics is None) != (self.avionics is None):
            raise DifferentStructure
        if avionics is not None:
            self._avionics.gather(avionics, found[1], values[1])
        if len(values[0]) + len(values[1]) > self._few and self.count - self._begun >= PATIENCE:
            self._begin(model, start, avionics)
            self.add(model, start, avionics)
            return
        self._flights.add(found[0], values[0])
        if avionics is not None:
            self._onboard.add(found[1], values[1])
        self._phases.append(first_phase(model, start))
        self.count += 1

    def add_alike(
        self,
        model: Model,
        start: State,
        avionics: Avionics | None,
        flights: tuple[Sequence[int], Buffer],
        onboard: tuple[Sequence[int], Buffer],
    ) -> None:
        """Add many flights that differ in the same leaves from one of this kind.

        Args:
            model: Of that flight.
            start: Likewise; they all begin in the same phase.
            avionics: Likewise.
            flights: Numbers of the leaves of model and start in which they differ, and their
                values, shape (flights, leaves).
            onboard: The same for the avionics.
        """
        self._begin(model, start, avionics)
        self._flights.add_alike(*flights)
        if avionics is not None:
            self._onboard.add_alike(*onboard)
        count = len(flights[1])
        self._phases += [first_phase(model, start)] * count
        self.count += count

    def flights(self) -> LoadedFlights:
        """Buffers of all flights; spare lanes repeat the last flight, already ended."""
        width, buffers = self.width, empty_groups(self._shape, self.count, self.width)
        self._flights.buffers(buffers, width, self._both.rows)
        groups, spare = len(buffers), -self.count % width
        lanes = buffers.reshape(groups, -1, width)
        phases = np.array([*self._phases, *self._phases[-1:] * spare])
        lanes[:, self._phase] = phases.reshape(groups, width)
        lanes[-1, self._status, width - spare :] = FLYING + 1.0
        onboard = None
        if self.avionics is not None:
            onboard = zeros(groups, rows(self.avionics) * width)
            self._onboard.buffers(onboard, width, self._avionics.rows)
        return LoadedFlights(self._shape, self.model, self.start, self.avionics, buffers, onboard)
