"""Errors and warnings for users."""

from __future__ import annotations

import contextlib
import sys
import warnings
from collections.abc import Iterator
from typing import TextIO

#: Most characters of a value that are quoted in a message (chosen).
LONGEST_VALUE = 80
#: Most characters of a line of an error, and most lines (chosen).
LONGEST_LINE, MOST_PROBLEMS = 2000, 50


class FlightWarning(UserWarning):
    """Warning about a flight."""


class LedgerWarning(FlightWarning):
    """The energy balance of a flight does not close: its numbers are unreliable."""


class CommandWarning(FlightWarning):
    """A pilot commands negative thrust of a rotor, which then gives its minimum."""


class ContactWarning(FlightWarning):
    """A contact came as deep as the middle of what it met, where the other side is as near."""


class OverlapWarning(FlightWarning):
    """Cages of one vehicle came into each other, which do not touch here."""


class InputError(ValueError):
    """Invalid input.  Each problem is one line that says how to correct it."""

    def __init__(self, *problems: str, path: tuple[str | int, ...] = ()) -> None:
        """Create an error with one line for each problem.

        Args:
            *problems: The lines.
            path: Keys and indices of the invalid value, if it is known and the lines do not name
                it yet.
        """
        shown = tuple(excerpt(plain(text), LONGEST_LINE) for text in problems[:MOST_PROBLEMS])
        left = len(problems) - len(shown)
        self.problems = (*shown, f"and {left} more problems") if left else shown
        self.path = path
        super().__init__("\n".join(self.problems))


@contextlib.contextmanager
def within(*keys: str | int) -> Iterator[None]:
    """Prefix the paths of problems inside a block with the keys of its table."""
    try:
        yield
    except InputError as error:
        raise InputError(*error.problems, path=(*keys, *error.path)) from None


class CacheWarning(UserWarning):
    """A cache was ignored or cannot be written; results are the same."""


def warn_in_one_line() -> None:
    """Show this package's warnings on stderr as one line each, and others unchanged."""
    before = warnings.showwarning

    def show(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        if category.__module__.startswith("springback."):
            (file or sys.stderr).write(f"warning: {message}\n")
        else:
            before(message, category, filename, lineno, file, line)

    warnings.showwarning = show
    warnings.simplefilter("always", CacheWarning)


def plain(text: str, *, keep: str = "") -> str:
    r"""Encodable text without control characters, for terminals.

    Control characters, escape sequences, marks that reverse the direction of writing and lone
    surrogates are written as ``\x1b`` or ``\u202e``.

    Args:
        text: Untrusted text.
        keep: Characters that are left unchanged, such as the newline.
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(
        one if one.isprintable() or one in keep else one.encode("unicode_escape").decode()
        for one in text
    )


def excerpt(text: str, most: int = 2 * LONGEST_VALUE) -> str:
    """Text shortened for a message: its beginning if it is long."""
    return text if len(text) <= most else f"{text[: most - 3]}..."


def shown_value(value: object) -> str:
    """Value for a message: its `repr`, shortened to fit into a line."""
    if isinstance(value, int) and abs(value) >= 10**LONGEST_VALUE:
        return f"a whole number of more than {LONGEST_VALUE} digits"
    if isinstance(value, str):
        cut = len(value) > LONGEST_VALUE
        return f"{value[:LONGEST_VALUE]!r}{'...' if cut else ''}"
    try:
        text = repr(value)
    except (RecursionError, ValueError):  # nested too deep, or whole numbers too long to write
        text = f"a {type(value).__name__} that is too deep or too long to show"
    return excerpt(text, LONGEST_VALUE)
