"""Untrusted XML: read into plain nodes that know their line, within limits.

Document types are refused, and with them all entities of one's own, so that no file can name other
files or grow as it is read.
"""

from __future__ import annotations

import math
import xml.parsers.expat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from springback.errors import InputError, shown_value
from springback.scenario.worlds.paths import file_bytes

#: Deepest nesting of elements (chosen: a robot of forty links in a chain has 43 in MJCF), most
#: nodes of a file (chosen: 10 000 boxes in SDF have 120 000) and largest magnitude of a number.
MOST_LEVELS, MOST_NODES, MOST_SIZE = 200, 3_000_000, 1e9


class XmlNode:
    """An element of a file."""

    __slots__ = ("attributes", "file", "line", "nodes", "tag", "words")

    def __init__(self, tag: str, attributes: dict[str, str], file: str, line: int) -> None:
        """An element without content."""
        self.tag, self.attributes, self.file, self.line = tag, attributes, file, line
        self.nodes: list[XmlNode] = []
        self.words: list[str] = []

    @property
    def text(self) -> str:
        """Its text, without blanks around it."""
        return "".join(self.words).strip()

    def all(self, *tags: str) -> Iterator[XmlNode]:
        """Nodes directly in it with one of some tags."""
        return (node for node in self.nodes if node.tag in tags)

    def first(self, *path: str) -> XmlNode | None:
        """The node at a path of tags, the first of each; None if there is none."""
        found: XmlNode | None = self
        for tag in path:
            found = None if found is None else next(found.all(tag), None)
        return found

    def get(self, key: str, default: str = "") -> str:
        """An attribute without blanks around it."""
        return self.attributes.get(key, default).strip()

    def problem(self, what: str) -> InputError:
        """Error that names file and line."""
        is_named = what.startswith((f"{self.tag} [", f"{self.tag}: "))
        return InputError(f"{self.file}:{self.line}: {'' if is_named else f'{self.tag}: '}{what}")

    def numbers(
        self, text: str, what: str, count: int | range, *, above: float | None = None
    ) -> list[float]:
        """Numbers of a text.

        Args:
            text: Numbers with blanks between them.
            what: Name of them, for errors, such as ``size``.
            count: How many there must be.
            above: Bound of each, not included.

        Raises:
            InputError: Naming file and line, if there are others, or something else.
        """
        wanted = range(count, count + 1) if isinstance(count, int) else count
        try:
            found = [float(word) for word in text.split()]
        except ValueError:
            raise self.problem(f"{what}: must be numbers (got {shown_value(text)})") from None
        if len(found) not in wanted:
            several = f"{wanted.start}" if len(wanted) == 1 else f"{wanted.start} to {wanted[-1]}"
            raise self.problem(f"{what}: must be {several} numbers (got {shown_value(text)})")
        for value in found:
            if not math.isfinite(value) or abs(value) > MOST_SIZE:
                raise self.problem(
                    f"{what}: must be finite, at most {MOST_SIZE:g} in size (got {value:g})"
                )
            if above is not None and not value > above:
                raise self.problem(f"{what}: must be above {above:g} (got {value:g})")
        return found

    def number(
        self, text: str, what: str, *, above: float | None = None, least: float | None = None
    ) -> float:
        """The one number of a text; see `numbers`."""
        [found] = self.numbers(text, what, 1, above=above)
        if least is not None and found < least:
            raise self.problem(f"{what}: must be at least {least:g} (got {found:g})")
        return found


def xml_root(path: Path) -> XmlNode:
    """The outermost element of a file.

    Raises:
        InputError: If it cannot be read, is not XML, has a document type, or is too deep or large.
    """
    data = file_bytes(path)
    name = str(path)
    parser: Any = xml.parsers.expat.ParserCreate()
    parser.buffer_text = True
    open_nodes: list[XmlNode] = []
    roots: list[XmlNode] = []
    count = 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        node = XmlNode(tag, attributes, name, parser.CurrentLineNumber)
        if count > MOST_NODES:
            raise node.problem(f"is one of more than {MOST_NODES} elements; no more are read")
        if len(open_nodes) >= MOST_LEVELS:
            raise node.problem(f"is nested more than {MOST_LEVELS} deep")
        (open_nodes[-1].nodes if open_nodes else roots).append(node)
        open_nodes.append(node)

    def end(tag: str) -> None:
        open_nodes.pop()

    def words(text: str) -> None:
        if open_nodes and not text.isspace():
            open_nodes[-1].words.append(text)

    def document_type(*_: Any) -> None:
        raise InputError(
            f"{name}:{parser.CurrentLineNumber}: has a document type (DOCTYPE), which is not read: "
            "take it out"
        )

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = words, document_type
    try:
        parser.Parse(data, True)
    except xml.parsers.expat.ExpatError as error:
        what = xml.parsers.expat.errors.messages.get(error.code, "a syntax error")
        raise InputError(f"{name}:{error.lineno}: is not XML: {what}") from None
    except (LookupError, ValueError) as error:  # an unknown encoding
        raise InputError(f"{name}: is not XML: {error}") from None
    return roots[0]
