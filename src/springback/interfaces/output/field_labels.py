"""Names of fields, short where that suffices."""

from __future__ import annotations

from collections.abc import Sequence


def short_names(names: Sequence[str]) -> list[str]:
    """Names without what precedes their last two words, where they remain distinct."""
    found = [".".join(name.split(".")[-2:]) for name in names]
    return [
        short if found.count(short) == 1 else name
        for short, name in zip(found, names, strict=True)
    ]  # fmt: skip
