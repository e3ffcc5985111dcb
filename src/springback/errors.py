"""Errors and warnings that users meet."""

from __future__ import annotations

import contextlib
import sys
import warnings
from collections.abc import Iterator
from typing import TextIO

#: Characters of a given value that are shown in a message (chosen).
LONGEST_VALUE = 80
#: Characters of a line of an error, and lines (chosen).
LONGEST_LINE, MOST_PROBLEMS = 2000, 50


class FlightWarning(UserWarning):
    """What to be wary of in a flight."""


class LedgerWarning(FlightWarning):
    """The energy ledger of a flight does not close: its numbers are not to be trusted."""


class CommandWarning(FlightWarning):
    """A pilot commands less than nothing of a rotor, which then gives its least."""


class InputError(ValueError):
    """Something a user gave cannot be used.  Each problem is one line that says how to mend it."""

    def __init__(self, *problems: str, path: tuple[str | int, ...] = ()) -> None:
        """One line for each problem.

        Args:
            *problems: The lines.
            path: Keys and indices of the value at fault, where it is known and the lines do not
                name it yet.
        """
        shown = tuple(excerpt(plain(text), LONGEST_LINE) for text in problems[:MOST_PROBLEMS])
        left = len(problems) - len(shown)
        self.problems = (*shown, f"and {left} more problems") if left else shown
        self.path = path
        super().__init__("\n".join(self.problems))


@contextlib.contextmanager
def within(*keys: str | int) -> Iterator[None]:
    """Put the keys of a table in front of the path of problems found inside it."""
    try:
        yield
    except InputError as error:
        raise InputError(*error.problems, path=(*keys, *error.path)) from None


class CacheWarning(UserWarning):
    """What earlier runs kept was left aside, or cannot be kept; results are the same."""


def warn_in_one_line() -> None:
    """Show this package's warnings on stderr as one line each, for programs; others as they are."""
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
    r"""Text that a terminal shows and does nothing else with, and that can be encoded.

    Control characters, escape sequences, marks that reverse the direction of writing and lone
    surrogates are written as ``\x1b`` or ``\u202e``.

    Args:
        text: That may come from a stranger.
        keep: Characters that are left as they are, such as the newline.
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(
        one if one.isprintable() or one in keep else one.encode("unicode_escape").decode()
        for one in text
    )


def excerpt(text: str, most: int = 2 * LONGEST_VALUE) -> str:
    """Text as a message quotes it: its beginning, where it is long."""
    return text if len(text) <= most else f"{text[: most - 3]}..."


def shown_value(value: object) -> str:
    """A value as a message shows it: `repr`, no longer than fits into a line."""
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
