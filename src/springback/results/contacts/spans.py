"""When the parts of a vehicle were in contact, from the columns of a recorded flight."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from springback.results.result import FlightResult
from springback.simulation.playback import NO_FORCE

Array = np.ndarray[Any, np.dtype[np.float64]]

#: A step lands within a nanometre of a touch: forces below this are not yet contact [N] (chosen).
AT_TOUCH = 1e-6


class ContactSpan(NamedTuple):
    """A contact of one part, from its touch until it separates."""

    part: int  # number of the cage from 0, then of the hull
    arm: int | None  # number of the arm from 1; None: the hull
    begin: float  # instant of the touch [s]
    end: float  # instant of the separation [s]
    first: int  # row of the first instant with a force
    last: int  # of the last one
    hardest: int  # row of the largest normal force
    hardest_time: float  # its instant [s]
    force: float  # the largest normal force [N]
    guard: str = "cage"  # what an arm touches with, in words

    @property
    def name(self) -> str:
        """Of the part, in words."""
        return part_name(str(self.arm) if self.arm else "", self.guard)


def parts_of(columns: Mapping[str, Array]) -> list[str]:
    """Suffixes of the columns of forces: one for each cage, and one for a main body with a hull."""
    return [name[2:] for name in columns if name.startswith("fn")]


def part_name(part: str, guard: str) -> str:
    """A part in words.

    Args:
        part: Suffix of its columns, as of `parts_of`.
        guard: What an arm touches with, in words.
    """
    return f"{guard} {part}" if part.isdigit() else "the main body"


def contact_mask(columns: Mapping[str, Array]) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """True for instants with a contact."""
    felt = [columns[f"fn{k}"] + columns[f"ff{k}"] > NO_FORCE for k in parts_of(columns)]
    none = np.zeros(len(columns["t"]), dtype=np.bool_)
    return np.asarray(np.logical_or.reduce([none, *felt]), dtype=np.bool_)


def intervals(t: Array, felt: Any, apart: float = 0.0) -> list[tuple[int, int]]:
    """First and last index of every contact; contacts closer than ``apart`` are merged.

    Args:
        t: Instants [s].
        felt: True for instants with a contact.
        apart: Shortest time between two contacts [s].
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(felt, dtype=int), [0]])))
    found: list[tuple[int, int]] = []
    for first, last in zip(edges[0::2].tolist(), (edges[1::2] - 1).tolist(), strict=True):
        if found and t[first] - t[found[-1][1]] < apart:
            found[-1] = (found[-1][0], last)
        else:
            found.append((first, last))
    return found


def spans(flight: FlightResult, holds: Any) -> Iterator[tuple[int, int, float, float]]:
    """First and last index of every span of instants, and its beginning and end [s].

    Steps land on touches, separations and stops, where a force or depth is still zero: the instants
    before and after the span.  A law whose force jumps at the touch begins one step later.

    Args:
        flight: With its trajectory.
        holds: True for the instants of a span.
    """
    t = flight.t
    for first, last in intervals(t, holds):
        yield first, last, float(t[max(first - 1, 0)]), float(t[min(last + 1, len(t) - 1)])


def contact_spans(flight: FlightResult) -> Iterator[ContactSpan]:
    """Contacts of each cage, then of the hull, in order of time for each."""
    c, guard = flight.columns, flight.scenario.vehicle.guard_word
    for number, part in enumerate(parts_of(c)):
        arm = int(part) if part.isdigit() else None
        normal = c[f"fn{part}"]
        for first, last, begin, end in spans(flight, normal + c[f"ff{part}"] > AT_TOUCH):
            hardest = first + int(np.argmax(normal[first : last + 1]))
            when, force = float(c["t"][hardest]), float(normal[hardest])
            yield ContactSpan(number, arm, begin, end, first, last, hardest, when, force, guard)
