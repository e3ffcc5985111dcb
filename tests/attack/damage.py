"""Damage to files: what is said of them afterwards."""

from __future__ import annotations

import random
import shutil
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from springback.errors import InputError


def one_byte(
    whole: Path, file: str, ask: Callable[[Path], Any], cases: int, seed: int = 17
) -> Counter[str]:
    """One byte of a file changed, and then all asked that the folder says.

    Args:
        whole: Folder, undamaged.
        file: In it.
        ask: Everything that a folder says, as something that can be compared by its text.
        cases: How many bytes are tried; the first and the last are.
        seed: Of places and values.

    Returns:
        How many were ``noticed`` (refused in one line), ``without effect``, ``wrong`` (another
        answer without a word), or ended in a ``traceback``.
    """
    noise_stream, before = random.Random(seed), repr(ask(whole))
    data = (whole / file).read_bytes()
    places = [0, len(data) - 1, *(noise_stream.randrange(len(data)) for _ in range(cases - 2))]
    found = Counter[str]()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "damaged"
        shutil.copytree(whole, folder)
        for place in places:
            harmed = bytearray(data)
            harmed[place] ^= noise_stream.randrange(1, 256)
            (folder / file).write_bytes(harmed)
            found[_outcome(folder, ask, before, (file, place, harmed[place]))] += 1
    return found


def cut_off(whole: Path, file: str, ask: Callable[[Path], Any], cases: int) -> Counter[str]:
    """A file cut off at many lengths, and then all asked that the folder says."""
    noise_stream, before = random.Random(18), repr(ask(whole))
    data = (whole / file).read_bytes()
    found = Counter[str]()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "damaged"
        shutil.copytree(whole, folder)
        for _ in range(cases):
            length = noise_stream.randrange(len(data))
            (folder / file).write_bytes(data[:length])
            found[_outcome(folder, ask, before, (file, length))] += 1
    return found


def _outcome(folder: Path, ask: Callable[[Path], Any], before: str, case: tuple[Any, ...]) -> str:
    try:
        said = repr(ask(folder))
    except InputError as error:
        return "noticed" if len("\n".join(error.problems).splitlines()) == 1 else "several lines"
    except Exception as error:
        print("traceback", case, type(error).__name__, error)
        return "traceback"
    if said == before:
        return "without effect"
    print("wrong", case)
    return "wrong"
