"""Batch set-up of scenarios that differ in numbers only: one is traced, and its formulas evaluated.

A campaign's flights differ by some dozens of numbers each.  Where the functions that build a flight
accept traced numbers (`springback.kernels.tracing`), all flights are built by one pass through
these functions, and each gets the bits that it gets alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np

from springback.batch.validation import UNCHECKED, ready_of, scenario_with
from springback.kernels.memo import FOREVER, Build, Memo
from springback.kernels.tracing import NO_FORMULA, Evaluated, Tape, Traced
from springback.kernels.trees import leaves
from springback.scenario.build import ReadyFlight
from springback.settings import Settings
from springback.simulation.flight import first_phase

#: Indices of leaves, and their values in each flight, shape (flights, leaves).
Leaves = tuple[list[int], Any]
#: Smaller groups are built one by one (chosen: tracing takes as long as a few flights).
FEW = 8
#: Types that only match if equal, and contain no number.
PLAIN = (str, int, bool, type(None))


class Template:
    """Positions of the numbers in a value: floats within tuples and settings, nested."""

    def __init__(self, first: Any) -> None:
        """Template of the first value."""
        self.first = first
        self.is_plain: bool
        self._fields = _fields(first)
        branches = {key: Template(branch) for key, branch in self._fields.items()}
        self._floats = [key for key, one in branches.items() if type(one.first) is float]
        plain = [key for key, one in branches.items() if one.is_plain]
        self._inner = [
            (key, one) for key, one in branches.items() if key not in {*self._floats, *plain}
        ]
        self.is_plain = type(first) in PLAIN or (
            isinstance(first, tuple) and len(plain) == len(branches)
        )
        self._given = _given_names(first)
        self._floats_in, self._plain_in = _getter(self._floats), _getter(plain)
        self._same = self._plain_in(self._fields)
        #: Numbers of the first value, in order of traversal.
        self.own: list[float] = [first] if type(first) is float else []
        self.own += [self._fields[key] for key in self._floats]
        self.own += [x for _, one in self._inner for x in one.own]

    def numbers(self, other: Any) -> list[float] | None:
        """Numbers of another value, if it differs from the first in numbers only."""
        found: list[float] = []
        return found if self._takes(other, found) else None

    def _takes(self, other: Any, found: list[float]) -> bool:
        """Append the numbers of a value; True if it matches the first."""
        if other is self.first:
            found += self.own
            return True
        if type(other) is not type(self.first):
            return False
        if type(other) is float:
            found.append(other)
            return True
        if self.is_plain:
            return bool(other == self.first)
        fields = _fields(other)
        if not fields or fields.keys() != self._fields.keys() or _given_names(other) != self._given:
            return False
        floats = self._floats_in(fields)
        if {*map(type, floats)} - {float} or self._plain_in(fields) != self._same:
            return False
        found += floats
        return all(one._takes(fields[key], found) for key, one in self._inner)

    def with_numbers(self, numbers: Iterator[Any]) -> Any:
        """The first value with other numbers, in order; traced numbers are accepted."""
        if not self.own:
            return self.first
        if type(self.first) is float:
            return next(numbers)
        changed = {key: next(numbers) for key in self._floats}
        changed |= {key: one.with_numbers(numbers) for key, one in self._inner}
        if isinstance(self.first, tuple):
            return tuple((self._fields | changed).values())
        new = self.first.model_copy()
        new.__dict__.update(changed)  # without validation, and without marking fields as set
        return new


def _fields(value: Any) -> dict[Any, Any]:
    """Parts of a tuple or of settings, by index or name."""
    if isinstance(value, tuple):
        return dict(enumerate(value))
    return value.__dict__ if isinstance(value, Settings) else {}


def _given_names(value: Any) -> Any:
    """Names of the settings that were given."""
    return value.model_fields_set if isinstance(value, Settings) else None


def _getter(keys: list[Any]) -> Callable[[dict[Any, Any]], tuple[Any, ...]]:
    """Getter of several values of a dictionary."""
    if len(keys) > 1:
        return itemgetter(*keys)
    return lambda fields: tuple(fields[key] for key in keys)


class ScenarioGroup:
    """Flights whose settings differ in numbers only, while they are collected."""

    def __init__(self, number: int, first: Mapping[str, Any], build: Build) -> None:
        """Start with the first flight: its number, and its settings by the name of their table."""
        self._first, self._make = first, build
        self._templates: dict[str, Template] = {}
        self._numbers: dict[str, list[list[float]]] = {}
        self.flights = [number]

    def takes(self, number: int, settings: Mapping[str, Any]) -> bool:
        """Add a flight if it matches the others; True if it does."""
        if settings.keys() != self._first.keys():
            return False
        found: dict[str, list[float]] = {}
        for name, part in settings.items():
            first = self._first[name]
            if part is not first:
                if name not in self._templates:  # robots share the tables of a sample
                    self._templates[name] = self._make(Template, first, place=FOREVER)
                numbers = self._make(self._templates[name].numbers, part, place=FOREVER)
                if numbers is None:
                    return False
                found[name] = numbers
        for name in found.keys() - self._numbers.keys():
            self._numbers[name] = [self._templates[name].own] * len(self.flights)
        for name, rows in self._numbers.items():
            rows.append(found.get(name, self._templates[name].own))
        self.flights.append(number)
        return True

    def traced_settings(
        self, more: Sequence[Sequence[float]]
    ) -> tuple[Tape, dict[str, Any], list[Any]]:
        """Settings with traced numbers where they are not all equal.

        Args:
            more: Other numbers of each flight.

        Returns:
            The tape, one row per flight; settings as of the first flight; and traced numbers for
            `more`.
        """
        tables = [np.array(numbers) for numbers in self._numbers.values()]
        rows = np.hstack([*tables, np.array(more)])
        bits = rows.view(np.int64)  # −0 is not 0
        sheet, differs = Tape(rows), (bits != bits[0]).any(axis=0).tolist()
        cells = iter(
            [cell if one else cell.value for cell, one in zip(sheet.first, differs, strict=True)]
        )
        changed = {name: self._templates[name].with_numbers(cells) for name in self._numbers}
        return sheet, {**self._first, **changed}, [*cells]


class BuiltGroup(NamedTuple):
    """Flights built together."""

    flights: list[int]
    """Their numbers."""
    first: ReadyFlight
    """The first of them."""
    flown: Leaves
    """Leaves of model and start that differ from the first."""
    onboard: Leaves
    """Leaves of the on-board state that differ from the first."""


def build_group(
    alike: ScenarioGroup, biases: Sequence[Sequence[float]], one: Callable[[int], ReadyFlight]
) -> BuiltGroup | None:
    """Build matching flights by one pass.

    Args:
        alike: The flights.
        biases: `springback.scenario.avionics.turn_on_normals` of each.
        one: Builds a flight, by its number.

    Returns:
        Those that take the same branches as the first; None if all are to be built one by one: they
        are few, the first cannot be flown, or a traced number is not supported somewhere.
    """
    if len(alike.flights) < FEW:
        return None
    sheet, settings, normals = alike.traced_settings(biases)
    try:
        first = one(alike.flights[0])
        # The seed is not traced, so that noise cannot become a formula.
        traced = ready_of(scenario_with({**settings, "seed": object()}), Memo(), normals)
        first_phase(traced.model, traced.start)
        filled = sheet.evaluate()
        rows = np.flatnonzero(filled.holds)
        last = one(alike.flights[rows[-1]])
    except (*NO_FORMULA, *UNCHECKED):
        return None
    # A function might have used a traced number other than as a float: two flights are compared.
    if not (_agree(traced, filled, 0, first) and _agree(traced, filled, rows[-1], last)):
        return None
    flown, onboard = _trees(traced)
    numbers = [alike.flights[row] for row in rows]
    return BuiltGroup(numbers, first, _cells(flown, filled, rows), _cells(onboard, filled, rows))


def _cells(tree: Any, filled: Evaluated, rows: Any) -> Leaves:
    """Positions of traced numbers in a tree, and their values in some rows."""
    cells = {k: x for k, x in enumerate(leaves(tree)) if isinstance(x, Traced)}
    columns = [filled.of(x, rows) for x in cells.values()]
    return [*cells], np.array(columns).reshape(len(cells), len(rows)).T


def _agree(traced: ReadyFlight, filled: Evaluated, row: int, plain: ReadyFlight) -> bool:
    """True if a row of the tape gives exactly the flight built alone."""
    if any(isinstance(x, Traced) for x in leaves(pace_of(traced))):
        return False
    cells, floats = leaves(_trees(traced)), leaves(_trees(plain))
    there = np.array([filled.of(x, row) for x in cells])
    return pace_of(traced) == pace_of(plain) and there.tobytes() == np.array(floats).tobytes()


def _trees(ready: ReadyFlight) -> tuple[Any, Any]:
    """All numbers of a flight: model and start, and on-board state."""
    return (ready.model, ready.start), ready.built_avionics.avionics if ready.built_avionics else ()


def pace_of(ready: ReadyFlight) -> tuple[Any, ...]:
    """Properties common to a batch besides its types; without pilots, none."""
    if ready.built_avionics is None:
        return ()
    return (
        ready.model.timing.until,
        ready.built_avionics.avionics.systems.period,
        ready.built_avionics.noise,
    )
