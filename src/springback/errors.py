"""Errors that users meet."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator


class InputError(ValueError):
    """Something a user gave cannot be used.  Each problem is one line that says how to mend it."""

    def __init__(self, *problems: str, path: tuple[str | int, ...] = ()) -> None:
        """One line for each problem.

        Args:
            *problems: The lines.
            path: Keys and indices of the value at fault, where it is known and the lines do not
                name it yet.
        """
        super().__init__("\n".join(problems))
        self.problems = problems
        self.path = path


@contextlib.contextmanager
def within(*keys: str | int) -> Iterator[None]:
    """Put the keys of a table in front of the path of problems found inside it."""
    try:
        yield
    except InputError as error:
        raise InputError(*error.problems, path=(*keys, *error.path)) from None
