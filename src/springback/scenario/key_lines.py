"""Lines of a TOML text on which its keys and the entries of its lists are.

TOML parsers return no positions, so this follows headers, keys, and what values hold: entries of
lists and keys of inline tables, over any number of lines.
"""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from springback.problems import key_path

Key = str | int

#: Mentions of keys and entries in a file that are looked at (chosen: as of a list of 100 000
#: values), and characters of a line that may be a header (chosen).
MOST_MENTIONS, LONGEST_HEADER = 120_000, 500

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$")
_KEY = re.compile(r"[ \t]{0,500}([A-Za-z0-9_.\"'-]{1,500})[ \t]{0,500}=")
#: Strings, comments, marks and words of values.
_TOKEN = re.compile(
    r"""
      \"{3} (?: [^"\\] | \\. | "(?!"") )* "{3,5}
    | '{3} (?: [^'] | '(?!'') )* '{3,5}
    | " (?: [^"\\\n] | \\. )* "
    | ' [^'\n]* '
    | \# [^\n]*
    | [\[\]{},=\n]
    | [^\s\[\]{},=\#"']+
    """,
    re.DOTALL | re.VERBOSE,
)


def line_of(text: str, path: Sequence[Key]) -> int | None:
    """Line of the most specific mention of a key path in a TOML text; None if there is none."""
    lines = _lines(text)
    known = (lines.get(tuple(path[:length])) for length in range(len(path), 0, -1))
    return next((line for line in known if line is not None), None)


class RepeatedKey(NamedTuple):
    """A key or table of a text for which there is no place."""

    path: tuple[Key, ...]
    holder: tuple[Key, ...]
    """What is there already: the same path, or one that it would be inside."""
    line: int
    """Of that."""


def repeated_key(text: str, line: int) -> RepeatedKey | None:
    """The last key or table up to a line that was given before, or is inside of a value.

    Args:
        text: In TOML.
        line: Where a parser found it repeated.
    """
    first: dict[tuple[Key, ...], int] = {}
    found: RepeatedKey | None = None
    path: tuple[Key, ...] = ()
    here, counted = 1, 0
    for at, keys in itertools.islice(_mentions(text), MOST_MENTIONS):
        here, counted = here + text.count("\n", counted, at), at
        if here > line:
            break
        path = tuple(keys)
        before = first.setdefault(path, here)
        is_new = found is None or path[: len(found.path)] != found.path
        if before < here and is_new:
            found = RepeatedKey(path, path, before)
    if found is not None:
        return found
    for holder in (path[:length] for length in range(len(path) - 1, 0, -1)):
        if holder in first:
            return RepeatedKey(path, holder, first[holder])
    return None


@functools.lru_cache(maxsize=4)
def _lines(text: str) -> dict[tuple[Key, ...], int]:
    """Line of the first mention of each key path."""
    found: dict[tuple[Key, ...], int] = {}
    line, counted = 1, 0
    for at, here in itertools.islice(_mentions(text), MOST_MENTIONS):
        line, counted = line + text.count("\n", counted, at), at
        found.setdefault(tuple(here), line)
    return found


def _mentions(text: str) -> Iterator[tuple[int, list[Key]]]:
    """Places in a text, in order, where a table, a key or an entry of a list begins; its path."""
    counts: dict[tuple[Key, ...], int] = {}
    table: list[Key] = []
    at = 0
    while at < len(text):
        end = text.find("\n", at)
        end = len(text) if end < 0 else end
        header = _HEADER.match(text[at:end]) if end - at <= LONGEST_HEADER else None
        key = None if header else _KEY.match(text, at, end)
        if header:
            table = _table(header[2], header[1] == "[[", counts)
            yield at, table
        elif key:
            here = [*table, *key_path(_bare(key[1]))]
            yield at, here
            end = yield from _inside(text, key.end(), here)
        at = end + 1


def _table(name: str, is_entry: bool, counts: dict[tuple[Key, ...], int]) -> list[Key]:
    """Path of the table of a header; ``counts`` are of the entries of lists of tables so far."""
    path: list[Key] = []
    keys = key_path(_bare(name).replace(" ", ""))
    for depth, key in enumerate(keys, start=1):
        path.append(key)
        if is_entry and depth == len(keys):
            counts[tuple(path)] = counts.get(tuple(path), -1) + 1
        if tuple(path) in counts:
            path.append(counts[tuple(path)])
    return path


def _bare(name: str) -> str:
    return name.replace('"', "").replace("'", "")


@dataclass
class _Container:
    """A list or an inline table that is open."""

    path: list[Key]
    is_list: bool
    entry: list[Key] | None = None
    """Path of the entry or key at hand, once it has begun."""
    index: int = 0
    word: str = ""
    """Of an inline table: its key as far as it has been read."""


def _inside(text: str, at: int, here: list[Key]) -> Generator[tuple[int, list[Key]], None, int]:
    """Mentions as by `_mentions` inside the value of a key, whose text begins at a place.

    Returns:
        The place of the end of the value's last line.
    """
    holders: list[_Container] = []
    for token in _TOKEN.finditer(text, at):
        said, inner = token[0], holders[-1] if holders else None
        if said == "\n":
            if inner is None:
                return token.start()
        elif said.startswith("#"):
            continue
        elif inner is not None and said in "]}":
            holders.pop()
        elif inner is not None and said == ",":
            inner.entry, inner.word, inner.index = None, "", inner.index + 1
        elif inner is not None and inner.entry is None and not inner.is_list and said != "=":
            at = at if inner.word else token.start()
            inner.word += said
        else:
            if inner is not None and inner.entry is None:
                at = token.start() if inner.is_list else at
                keys = (inner.index,) if inner.is_list else key_path(_bare(inner.word))
                inner.entry = [*inner.path, *keys]
                yield at, inner.entry
            if said in "[{":
                path = here if inner is None or inner.entry is None else inner.entry
                holders.append(_Container(path, said == "["))
    return len(text)
