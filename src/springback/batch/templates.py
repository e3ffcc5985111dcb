"""Batch set-up of scenarios that differ in numbers only: one is traced, and its formulas evaluated.

A campaign's flights differ by some dozens of numbers each.  Where the functions that read and build
a flight accept traced numbers (`springback.kernels.tracing`), all flights are built by one pass
through these functions, and each gets the bits that it gets alone.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.kernels.memo import Memo
from springback.kernels.tracing import NO_FORMULA, Tape, Traced
from springback.kernels.trees import leaves
from springback.scenario.build import ReadyFlight, build_flight, named_parts
from springback.scenario.presets import expand_presets
from springback.scenario.tables import ScenarioTables
from springback.simulation.flight import first_phase
from springback.simulation.loading import NO_LEAVES, Leaves

#: Smaller groups are built one by one (chosen: tracing takes as long as a few flights).
FEW = 8
#: Groups of fewer that may take branches of their own before the rest is built one by one (chosen).
MOST_SMALL = 4
#: Most formulas that are kept for later flights (chosen).
MOST_FORMULAS = 4


class Template:
    """Positions of the numbers in a table: floats in tables and lists, nested."""

    def __init__(self, first: Any) -> None:
        """Template of the first table."""
        self.first = first
        self._branches = {key: Template(branch) for key, branch in _branches(first)}
        #: Numbers of the first table, in order of traversal.
        self.own: list[float] = [first] if type(first) is float else []
        self.own += [x for branch in self._branches.values() for x in branch.own]

    def takes(self, other: Any, found: list[float]) -> bool:
        """Append the numbers of a table; True if it differs from the first in numbers only."""
        if other is self.first:
            found += self.own
            return True
        if type(other) is not type(self.first):
            return False
        if type(other) is float:
            found.append(other)
            return True
        if not isinstance(other, dict | list | tuple):
            return bool(other == self.first)
        if len(other) != len(self._branches):
            return False
        if isinstance(other, dict) and other.keys() != self._branches.keys():
            return False
        for key, branch in self._branches.items():  # a hundred thousand in a fit: mostly the same
            part = other[key]
            if part is branch.first:
                found += branch.own
            elif not branch.takes(part, found):
                return False
        return True

    def with_numbers(self, numbers: Iterator[Any]) -> Any:
        """The first table with other numbers, in order; traced numbers are accepted."""
        if not self.own:
            return self.first
        if type(self.first) is float:
            return next(numbers)
        changed = {key: branch.with_numbers(numbers) for key, branch in self._branches.items()}
        return changed if isinstance(self.first, dict) else type(self.first)(changed.values())


def _branches(table: Any) -> Iterator[tuple[Any, Any]]:
    """Parts of a table or list, by key or index."""
    if isinstance(table, dict):
        return iter(table.items())
    return enumerate(table if isinstance(table, list | tuple) else ())


class ScenarioGroup:
    """Flights whose scenarios differ only in numbers, and in seeds, while they are collected."""

    def __init__(self, number: int, first: Mapping[str, Any]) -> None:
        """Start with the first flight: its number and its tables."""
        self._times = _times(first)
        self.template = Template(_without_seed(first))
        self.rows: list[list[float]] = [self.template.own]
        self.flights = [number]

    def like(self, number: int, first: Mapping[str, Any]) -> ScenarioGroup | None:
        """Another group that begins with a flight; None if that does not match those of this."""
        other = copy.copy(self)
        other.rows, other.flights = [], []
        return other if other.takes(number, first) else None

    def drop(self, flights: Sequence[int]) -> None:
        """Remove some flights."""
        dropped = set(flights)
        kept = [k for k, number in enumerate(self.flights) if number not in dropped]
        self.rows, self.flights = [self.rows[k] for k in kept], [self.flights[k] for k in kept]

    def takes(self, number: int, tables: Mapping[str, Any]) -> bool:
        """Add a flight if it matches the others; True if it does."""
        found: list[float] = []
        if _times(tables) != self._times or not self.template.takes(_without_seed(tables), found):
            return False
        self.rows.append(found)
        self.flights.append(number)
        return True


def _times(tables: Mapping[str, Any]) -> tuple[Any, Any]:
    """Clock and duration, which flights of one batch share."""
    simulation = tables.get("simulation")
    duration = simulation.get("duration") if isinstance(simulation, Mapping) else None
    return tables.get("clock"), duration


def _without_seed(tables: Mapping[str, Any]) -> dict[str, Any]:
    return {name: table for name, table in tables.items() if name != "seed"}


class BuiltGroup(NamedTuple):
    """Flights built together, or one alone."""

    flights: list[int]
    """Their numbers."""
    first: ReadyFlight
    """The first of them."""
    flown: Leaves = NO_LEAVES
    """Leaves of model and start that differ from the first."""
    onboard: Leaves = NO_LEAVES
    """Leaves of the on-board state that differ from the first."""
    formulas: FlightFormulas | None = None
    """By which they were built."""


class FlightFormulas:
    """Formulas of a traced flight."""

    def __init__(self, tape: Tape, moving: Any, first: ReadyFlight, trees: Sequence[Any]) -> None:
        """Formulas on a tape.

        Args:
            tape: Of the flight.
            moving: True for the numbers of its tables that were traced.
            first: The flight of its first row, built alone.
            trees: The traced flight and its on-board state.
        """
        self._tape, self._moving, self._first = tape, moving, first
        self._fixed = np.array([x.value for x in tape.first])[~moving]
        found: list[list[Any]] = [leaves(tree) for tree in trees]
        self._cells = [
            [(k, x.number) for k, x in enumerate(cells) if isinstance(x, Traced)] for cells in found
        ]

    def build(self, group: ScenarioGroup) -> BuiltGroup | None:
        """Flights of a group that take the same branches; None if there are none."""
        rows = np.array(group.rows)
        if rows[:, ~self._moving].tobytes() != np.tile(self._fixed, (len(rows), 1)).tobytes():
            return None
        columns, holds = self._tape.replay(rows)
        return self.group_of(np.array(group.flights), columns, np.flatnonzero(holds))

    def group_of(self, flights: Any, columns: Sequence[Any], held: Any) -> BuiltGroup | None:
        """Group of some flights, by what a tape has for them; None of none.

        Args:
            flights: Their numbers, and those of others.
            columns: Of the tape, by number.
            held: Rows of those that take the same branches.
        """
        if not len(held):
            return None
        flown, onboard = (
            ([k for k, _ in cells],
             np.array([columns[n][held] for _, n in cells]).reshape(len(cells), len(held)).T)
            for cells in self._cells
        )  # fmt: skip
        return BuiltGroup(flights[held].tolist(), self._first, flown, onboard, self)


class KnownFormulas:
    """Formulas by which flights were built: later ones of the same template need no tables read."""

    def __init__(self) -> None:
        """None yet."""
        self._group: ScenarioGroup | None = None
        self._found: list[FlightFormulas] = []

    def group(self, number: int, first: Mapping[str, Any]) -> ScenarioGroup:
        """Group that begins with a flight; if it is of another template, all is forgotten."""
        group = None if self._group is None else self._group.like(number, first)
        if group is None:
            self._group = group = ScenarioGroup(number, first)
            self._found.clear()
        return group

    def add(self, formulas: FlightFormulas | None) -> None:
        """Add formulas, unless there are many: then flights take ever other branches."""
        if formulas is not None and len(self._found) < MOST_FORMULAS:
            self._found.append(formulas)

    def build(self, group: ScenarioGroup) -> Iterator[BuiltGroup]:
        """Flights of a group that can be built by known formulas; they are taken from it."""
        for formulas in self._found:
            if group.flights and (built := formulas.build(group)) is not None:
                group.drop(built.flights)
                yield built


def built_groups(
    group: ScenarioGroup,
    normals: Callable[[int], Sequence[float]],
    one: Callable[[int], ReadyFlight],
) -> Iterator[BuiltGroup]:
    """Build matching flights: those that take the same branches by one pass.

    Flights that are left out are to be built one by one: few take the same branches, they cannot be
    flown, or a traced number is not supported somewhere.

    Args:
        group: The flights.
        normals: `springback.scenario.avionics.normals_at_start` of a flight, by its number.
        one: Builds a flight, by its number, or raises `InputError`.
    """
    if len(group.flights) < FEW:
        return
    drawn = [normals(number) for number in group.flights]
    numbers, flights = np.hstack([group.rows, drawn]), np.array(group.flights)
    small = 0
    while len(flights) >= FEW and small < MOST_SMALL:
        try:
            first = one(int(flights[0]))
        except InputError:
            numbers, flights = numbers[1:], flights[1:]
            continue
        if first.plain is not None:  # flown one by one
            return
        built = _built(group.template, first, flights, numbers, one)
        if built is None:
            return
        yield built
        small += len(built.flights) < FEW
        others = ~np.isin(flights, built.flights)
        numbers, flights = numbers[others], flights[others]


def _built(
    template: Template,
    first: ReadyFlight,
    flights: Any,
    numbers: Any,
    one: Callable[[int], ReadyFlight],
) -> BuiltGroup | None:
    """Flights that take the same branches as the first of some; None if they cannot be traced."""
    bits = numbers.view(np.int64)  # −0 is not 0
    tape, differs = Tape(numbers), (bits != bits[0]).any(axis=0)
    cells = iter(
        [cell if d else cell.value for cell, d in zip(tape.first, differs.tolist(), strict=True)]
    )
    try:
        traced = _traced_flight(template.with_numbers(cells), [*cells])
        held = np.flatnonzero(tape.holds)
        last = one(int(flights[held[-1]]))
    except (*NO_FORMULA, ValueError):  # of tables that no flight has, too
        return None
    # A function might have used a traced number other than as a float: two flights are compared.
    if not (_agree(traced, 0, first) and _agree(traced, held[-1], last)):
        return None
    formulas = FlightFormulas(tape, differs, first, _trees(traced))
    return formulas.group_of(flights, tape.columns, held)


def _traced_flight(tables: dict[str, Any], normals: Sequence[Any]) -> ReadyFlight:
    """A flight read and built from tables with traced numbers."""
    # The seed is not traced, so that noise cannot become a formula.
    scenario = ScenarioTables.model_validate(expand_presets(tables)).with_checked(seed=object())
    traced = build_flight(scenario, named_parts(scenario), Memo(), normals, advises=False)
    first_phase(traced.model, traced.start)
    return traced


def _agree(traced: ReadyFlight, row: int, plain: ReadyFlight) -> bool:
    """True if a row of the tape gives exactly the flight built alone."""
    if any(isinstance(x, Traced) for x in leaves(pace_of(traced))):
        return False
    cells: list[Any] = leaves(_trees(traced))
    floats = leaves(_trees(plain))
    there = np.array([x.column[row] if isinstance(x, Traced) else x for x in cells])
    return pace_of(traced) == pace_of(plain) and there.tobytes() == np.array(floats).tobytes()


def _trees(ready: ReadyFlight) -> tuple[Any, Any]:
    """All numbers of a flight: model and start, and on-board state."""
    return (ready.model, ready.start), ready.built_avionics.avionics if ready.built_avionics else ()


def pace_of(ready: ReadyFlight) -> tuple[Any, ...]:
    """Properties common to a batch besides its types; without pilots, thrusts over time."""
    if ready.built_avionics is None:
        return () if ready.thrusts is None else (ready.thrusts,)
    return (
        ready.model.timing.until,
        ready.built_avionics.avionics.systems.period,
        ready.built_avionics.noise,
    )
