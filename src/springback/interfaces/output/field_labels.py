"""Names of fields, short where that suffices."""

from __future__ import annotations

from collections.abc import Sequence


def short_names(names: Sequence[str]) -> list[str]:
    """Names without what precedes their last words: two, or as many as keep them distinct.

    Those of which more are needed begin with a word, not with the number of an entry.
    """
    return [_short_name(name, names) for name in names]


def _short_name(name: str, names: Sequence[str]) -> str:
    words = name.split(".")
    for count in range(2, len(words)):
        alike = sum(other.split(".")[-count:] == words[-count:] for other in names)
        if alike == 1 and (count == 2 or not words[-count].isdigit()):
            return ".".join(words[-count:])
    return name
