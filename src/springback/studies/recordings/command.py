"""Programs that predict recordings: ``python -m springback.studies.recordings.NAME [FOLDER]``.

A result is lines on the standard output; bad input is one line for each problem, and exit code 2.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from springback.errors import InputError

Lines = Iterator[str]


def run_study(lines: Callable[[Path | None], Lines], words: Sequence[str]) -> int:
    """Write the lines of a study, each as soon as it is known; the exit code.

    Args:
        lines: Of the folder of a user's own copy of the recordings, or of None.
        words: Of the command line, without the program: none, or the folder.
    """
    try:
        if len(words) > 1 or any(word.startswith("-") for word in words):
            raise InputError("name one folder of recordings, or nothing")
        folder = Path(words[0]) if words else None
        if folder is not None and not folder.is_dir():
            raise InputError(f"{folder}: is no folder")
        for line in lines(folder):
            sys.stdout.write(line + "\n")
            sys.stdout.flush()
    except InputError as error:
        sys.stderr.writelines(f"error: {line}\n" for line in error.problems)
        return 2
    return 0
