"""Errors and warnings that users meet."""

from __future__ import annotations

import sys
import warnings
from typing import TextIO


class InputError(ValueError):
    """Something a user gave cannot be used.  Each problem is one line that says how to mend it."""

    def __init__(self, *problems: str) -> None:
        """One line for each problem."""
        super().__init__("\n".join(problems))
        self.problems = problems


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
