"""Text files of numbers, read line by line into columns."""

from __future__ import annotations

import csv
import math
from array import array
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TextIO

import numpy as np

from springback.errors import InputError, shown_value
from springback.logs.recording import Array, Budget

#: Longest line that is read [characters] (chosen).
LONGEST_LINE = 1_000_000
#: Cells that say that there is no value.
BLANK = frozenset({"", "nan", "null", "none", "n/a"})
#: Most lines of a header that are looked through (chosen).
MOST_HEADER = 200


def open_text(path: Path) -> TextIO:
    """A text file, without byte order mark; bytes that are no UTF-8 are replaced."""
    return path.open(encoding="utf-8-sig", errors="replace", newline="")


def table_lines(file: TextIO, where: str, delimiter: str) -> Iterator[tuple[int, list[str]]]:
    """Number and cells of each line.

    Raises:
        InputError: For a line that is too long, or quotes that do not end.
    """

    def lines() -> Iterator[str]:
        number = 0
        while line := file.readline(LONGEST_LINE):
            number += 1
            if len(line) == LONGEST_LINE:
                raise InputError(f"{where}:{number}: has more than {LONGEST_LINE:,} characters")
            yield line.replace("\0", "")

    rows = csv.reader(lines(), delimiter=delimiter)
    try:
        for cells in rows:
            yield rows.line_num, cells
    except csv.Error as error:
        raise InputError(f"{where}:{rows.line_num}: cannot be read ({error})") from None


def number(cell: str, where: str, line: int, column: str) -> float:
    """Number of a cell; NaN if it is blank.

    Raises:
        InputError: If it is neither.
    """
    text = cell.strip()
    if text.lower() in BLANK:
        return math.nan
    try:
        if "_" in text:
            raise ValueError
        return float(text)
    except ValueError:
        raise InputError(
            f"{where}:{line}: {column}: must be a number (got {shown_value(cell)})"
        ) from None


class NumberColumns:
    """Some columns of a file, filled line by line."""

    def __init__(
        self, where: str, names: Sequence[str], places: Sequence[int], budget: Budget
    ) -> None:
        """Start without lines.

        Args:
            where: The file, for messages.
            names: Of the columns, for messages.
            places: Their numbers in a line, from 0.
            budget: Of numbers in memory.
        """
        self.where, self.names, self.places, self.budget = where, names, places, budget
        self.data = array("d")
        self.lines = 0

    def add(self, line: int, cells: Sequence[str]) -> None:
        """Add a line; cells that it has not are lost.

        Raises:
            InputError: If a cell is no number.
        """
        self.budget.take(len(self.places))
        width = len(cells)
        try:
            self.data.extend([
                float(cells[k]) if k < width and cells[k] and "_" not in cells[k]
                else self._slow(line, cells, k)
                for k in self.places
            ])  # fmt: skip
        except ValueError as error:
            if isinstance(error, InputError):
                raise
            self.data.extend([self._slow(line, cells, k) for k in self.places])
        self.lines += 1

    def _slow(self, line: int, cells: Sequence[str], place: int) -> float:
        if place >= len(cells):
            return math.nan
        name = self.names[self.places.index(place)]
        return number(cells[place], self.where, line, name)

    def values(self) -> Array:
        """All lines, shape (lines, columns)."""
        flat = np.frombuffer(self.data, dtype=float) if self.lines else np.empty(0)
        return flat.reshape(self.lines, len(self.places))


def positive(text: str, where: str, what: str) -> float:
    """A positive, finite number of a header.

    Raises:
        InputError: If it is none.
    """
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0.0):
        raise InputError(f"{where}: {what}: must be a positive number (got {shown_value(text)})")
    return value


#: Metres in units of length, by their names in headers.
LENGTHS = {
    "m": 1.0, "meters": 1.0, "metres": 1.0, "cm": 1e-2, "centimeters": 1e-2, "mm": 1e-3,
    "millimeters": 1e-3, "millimetres": 1e-3,
}  # fmt: skip


def metres(word: str, where: str) -> float:
    """Metres in a unit of length.

    Raises:
        InputError: If it is not known.
    """
    size = LENGTHS.get(word.strip().lower())
    if size is None:
        raise InputError(
            f"{where}: the unit of length {shown_value(word)} is not known; known are "
            f"{', '.join(LENGTHS)}"
        )
    return size
