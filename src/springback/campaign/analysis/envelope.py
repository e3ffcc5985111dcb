"""Resilience envelope as flown: success over two parameters, and its 95 % contour."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from springback.intervals import CONFIDENCE, IntervalEstimate, Values, share
from springback.simulation.measuring.measures import Outcome
from springback.studies.trials import Scatter
from springback.version import __version__

#: Success rate at the boundary of the envelope.
LEVEL = 0.95


class Axis(NamedTuple):
    """Equally spaced values of a parameter."""

    name: str
    unit: str
    """Unit for display: deg for angles, - for plain numbers."""
    values: tuple[float, ...]

    @property
    def label(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit}]"

    def at(self, *values: float) -> str:
        """Text of a value, or of an interval."""
        numbers = " to ".join(f"{value:.3g}" for value in values)
        return f"{self.name} {numbers}" + ("" if self.unit == "-" else f" {self.unit}")


class CellIndex(NamedTuple):
    """Robot of a cell, and its indices along both axes."""

    robot: str
    column: int
    row: int


@dataclass(frozen=True)
class EnvelopeCell:
    """Outcomes of the trials of a robot at a pair of values."""

    outcomes: Mapping[str, int]
    """Number of trials by outcome; empty if the test cannot be flown."""
    reason: str = ""
    """Reason why the test cannot be flown."""

    @property
    def trials(self) -> int:
        """Number of trials flown."""
        return sum(self.outcomes.values())

    @property
    def successes(self) -> int:
        """Number of trials in which the robot recovered."""
        return self.outcomes.get(Outcome.RECOVERED.word, 0)

    @property
    def share(self) -> float | None:
        """Success rate."""
        return self.interval.value

    @property
    def interval(self) -> IntervalEstimate:
        """Success rate with its Wilson interval."""
        return share(self.successes, self.trials)


class Interval(NamedTuple):
    """Interval of a line of cells on which a level is reached.

    It ends where the level is crossed, or at the last cell that was flown.
    """

    low: float
    high: float
    crossed_low: bool
    crossed_high: bool


def spans(values: Sequence[float], shares: Values, level: float = LEVEL) -> list[Interval]:
    """Intervals in which shares, interpolated linearly between cell centres, reach a level.

    Args:
        values: Cell centres, ascending or descending.
        shares: Shares at the centres; NaN for cells not flown, which end an interval.
        level: Level to be reached.
    """
    order = np.argsort(values)
    v, s = np.asarray(values, float)[order], np.asarray(shares, float)[order]
    inside, count = s >= level, len(v)

    def end(k: int, outside: int) -> tuple[float, bool]:
        if not 0 <= outside < count or np.isnan(s[outside]):
            return float(v[k]), False
        part = (s[k] - level) / (s[k] - s[outside])
        return float(v[k] + part * (v[outside] - v[k])), True

    found, k = [], 0
    while k < count:
        first = k
        while k < count and inside[k]:
            k += 1
        if k > first:
            (low, crossed_low), (high, crossed_high) = end(first, first - 1), end(k - 1, k)
            found.append(Interval(low, high, crossed_low, crossed_high))
        k += 1
    return found


@dataclass(frozen=True)
class Envelope:
    """Success over two parameters."""

    x: Axis
    y: Axis
    robots: tuple[str, ...]
    trials: int
    """Number of trials of each cell."""
    seed: int
    settings: tuple[str, ...]
    """Common settings of all trials, as given."""
    cells: dict[CellIndex, EnvelopeCell]

    def shares(self, robot: str) -> Values:
        """Success rate of every cell, shape (values of y, values of x); NaN if not flown."""
        rows, columns = range(len(self.y.values)), range(len(self.x.values))
        found = [[self.cells[CellIndex(robot, i, j)].share for i in columns] for j in rows]
        return np.array(found, float)

    @property
    def rows_from_top(self) -> list[int]:
        """Numbers of the rows, that of the largest y first."""
        return sorted(range(len(self.y.values)), key=lambda row: -self.y.values[row])

    def along_x(self, robot: str, row: int) -> list[Interval]:
        """Intervals along x, in displayed units, in which a row of cells reaches the level."""
        return spans(self.x.values, self.shares(robot)[row])

    def along_y(self, robot: str, column: int) -> list[Interval]:
        """Intervals along y, in displayed units, in which a column of cells reaches the level."""
        return spans(self.y.values, self.shares(robot)[:, column])

    def sentence(self, robot: str) -> str:
        """Sentence on the extent of a robot's envelope through the centre of the map."""
        flown = [cell for place, cell in self.cells.items() if place.robot == robot]
        grounded = sum(not cell.trials for cell in flown)
        good = sum((cell.share or 0.0) >= LEVEL for cell in flown)
        if grounded == len(flown):
            return f"{robot}: none of {len(flown)} cells can be flown: {flown[0].reason}"
        able = len(flown) - grounded
        head = f"{robot}: at least {_percent(LEVEL)} in {good} of {able} cells that can be flown"
        column, row = len(self.x.values) // 2, len(self.y.values) // 2
        parts = [head + (f" ({grounded} cannot)" if grounded else "")]
        for line, axis, across, at in (
            (self.along_x(robot, row), self.x, self.y, row),
            (self.along_y(robot, column), self.y, self.x, column),
        ):
            parts.append(f"at {across.at(across.values[at])}: {_reach(line, axis)}")
        return "; ".join(parts)

    def table(self, robot: str) -> str:
        """Successes of a robot as a text table, a row for each value of y, the largest on top."""
        head = [f"{v:g}" for v in self.x.values]
        lines = []
        for row in self.rows_from_top:
            cells = [self.cells[CellIndex(robot, i, row)] for i in range(len(head))]
            entries = [str(cell.successes) if cell.trials else "-" for cell in cells]
            lines.append([f"{self.y.values[row]:g}", *entries])
        width = max(len(word) for line in [head, *lines] for word in line) + 2
        left = max(len(self.y.label), width)
        title = f"{robot}: successes of {self.trials} trials"
        top = f"{self.y.label:>{left}}" + "".join(f"{word:>{width}}" for word in head)
        body = [
            f"{line[0]:>{left}}" + "".join(f"{word:>{width}}" for word in line[1:])
            for line in lines
        ]
        return "\n".join([title, f"{top}  {self.x.label}", *body, *self.reasons(robot)])

    def reasons(self, robot: str) -> list[str]:
        """Reasons why cells of a robot were not flown, one line each, with an example."""
        found: dict[str, list[CellIndex]] = {}
        for place, cell in self.cells.items():
            if place.robot == robot and not cell.trials:
                found.setdefault(cell.reason, []).append(place)
        lines = []
        for reason, places in found.items():
            at = ", ".join(
                axis.at(axis.values[k])
                for axis, k in ((self.x, places[0].column), (self.y, places[0].row))
            )
            where = at if len(places) == 1 else f"{len(places)} cells, such as {at}"
            lines.append(f"- not flown: {where}: {reason}")
        return lines

    def rows(self) -> list[dict[str, Any]]:
        """Rows of a table, one for each cell."""
        known = [outcome.word for outcome in Outcome]
        seen = [word for word in known if any(word in c.outcomes for c in self.cells.values())]
        found = []
        for (robot, column, row), cell in self.cells.items():
            _, low, high = cell.interval
            head = {
                "robot": robot,
                self.x.label: self.x.values[column],
                self.y.label: self.y.values[row],
                "trials": cell.trials,
                "successes": cell.successes if cell.trials else None,
                "share": cell.share,
                "low": low,
                "high": high,
            }
            outcomes = {word: cell.outcomes.get(word, 0) if cell.trials else None for word in seen}
            found.append({**head, **outcomes, "cannot_be_flown": cell.reason})
        return found

    def as_dict(self) -> dict[str, Any]:
        """Plain data, for JSON."""
        return {
            "springback": __version__,
            "axes": {
                side: {"parameter": axis.name, "unit": axis.unit, "values": list(axis.values)}
                for side, axis in (("x", self.x), ("y", self.y))
            },
            "trials": self.trials,
            "seed": self.seed,
            "settings": list(self.settings),
            "scatter": Scatter()._asdict(),
            "level": LEVEL,
            "confidence": CONFIDENCE,
            "interval": "Wilson",
            "line": {
                robot: {
                    "along_x": [
                        {"y": y, "stretches": [part._asdict() for part in self.along_x(robot, j)]}
                        for j, y in enumerate(self.y.values)
                    ],
                    "along_y": [
                        {"x": x, "stretches": [part._asdict() for part in self.along_y(robot, i)]}
                        for i, x in enumerate(self.x.values)
                    ],
                }
                for robot in self.robots
            },
            "sentences": [self.sentence(robot) for robot in self.robots],
            "cells": self.rows(),
        }


def _percent(share: float) -> str:
    return f"{100.0 * share:g} %"


def _reach(line: list[Interval], axis: Axis) -> str:
    """Text of intervals."""
    if not line:
        return "nowhere"
    parts = []
    for low, high, crossed_low, crossed_high in line:
        ends = [e for e, crossed in (("first", crossed_low), ("last", crossed_high)) if not crossed]
        note = f" (the {' and the '.join(ends)} flown)" if ends else ""
        parts.append((axis.at(low) if low == high else axis.at(low, high)) + note)
    return " and ".join(parts)
