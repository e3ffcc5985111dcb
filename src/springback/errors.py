"""Errors that users meet."""

from __future__ import annotations


class InputError(ValueError):
    """Something a user gave cannot be used.  Each problem is one line that says how to mend it."""

    def __init__(self, *problems: str) -> None:
        """One line for each problem."""
        super().__init__("\n".join(problems))
        self.problems = problems


class CacheWarning(UserWarning):
    """What earlier runs kept was left aside, or cannot be kept; results are the same."""
