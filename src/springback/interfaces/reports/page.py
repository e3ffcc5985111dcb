"""Reports: self-contained pages of sections, which consist of blocks.

A block is a paragraph, a table or a picture; one template lays them out.  Text and order of blocks
are in ``templates/*.toml``; code computes the numbers, by name.
"""

from __future__ import annotations

import base64
import functools
import re
import string
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from typing import Any, NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from springback.interfaces.figures import style
from springback.studies.comparison import Mark


@dataclass(frozen=True)
class TableCell:
    """A cell of a table: a text and, if it shows a number, the number itself."""

    text: str
    value: float | None = None
    detail: str = ""
    mark: Mark | None = None
    links: tuple[tuple[str, str], ...] = ()
    """Texts and anchors of links after the text."""
    code: bool = False
    """True for a command to type."""


Entry = TableCell | str | float | None
"""Entry of a table: a cell, or a text or number to convert; None becomes a dash."""


def table_cell(entry: Entry) -> TableCell:
    """Entry as a cell; None becomes a dash."""
    if isinstance(entry, TableCell):
        return entry
    return TableCell(entry) if isinstance(entry, str) else TableCell(plain(entry), entry)


@dataclass(frozen=True)
class Table:
    """A table; the first cell of a row names the row."""

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[TableCell, ...], ...]
    folded: bool = False
    """True for a long table that is initially folded."""


def table(
    caption: str, head: Sequence[str], rows: Iterable[Sequence[Entry]], *, folded: bool = False
) -> Table:
    """A table of entries; see `table_cell`."""
    return Table(caption, tuple(head), tuple(tuple(map(table_cell, row)) for row in rows), folded)


@dataclass(frozen=True)
class FigureBlock:
    """A figure embedded in the page."""

    name: str
    text: str
    figure: style.StyledFigure

    @property
    def anchor(self) -> str:
        """Anchor on the page."""
        return f"figure-{self.name}"

    @functools.cached_property
    def image(self) -> bytes:
        """The PNG file."""
        return style.png(self.figure)

    @property
    def source(self) -> str:
        """The PNG file as a data URI."""
        return "data:image/png;base64," + base64.b64encode(self.image).decode("ascii")

    @property
    def size(self) -> tuple[int, int]:
        """Width and height on the page [CSS px]."""
        width, height = self.figure.get_size_inches()
        return round(150 * width), round(150 * height)


class KeyPoint(NamedTuple):
    """Answer of a section in a sentence."""

    anchor: str
    name: str
    text: str


@dataclass(frozen=True)
class KeyPoints:
    """Answers of sections, with links to them."""

    points: tuple[KeyPoint, ...]


Blocks = tuple[str | Table | FigureBlock | KeyPoints, ...]


@dataclass(frozen=True)
class Section:
    """A section of the page: paragraphs (plain text), tables and pictures, in order."""

    anchor: str
    title: str
    blocks: Blocks
    part: str = ""
    """Title of the part of the page that begins here, if any."""
    summary: bool = False
    """True for a section at the top, before the contents."""
    answers: bool = False
    """True if the section begins with a question and its answer, the second paragraph."""

    @property
    def answer(self) -> str:
        """Answer, if there is one."""
        words = [block for block in self.blocks if isinstance(block, str)]
        return words[1] if self.answers and len(words) > 1 else ""


Content = Mapping[str, Any]
"""Numbers, texts, rows of tables and figures, by the names used in the blocks of a section."""


class _PageFormatter(string.Formatter):
    """Formatter with a typographic minus; numbers without a format are shown as they are."""

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, int | float | None):
            if value is None or not format_spec:
                return plain(value)
            return format(value, format_spec).replace("-", "−")
        return str(format(value, format_spec))


@dataclass(frozen=True)
class Wording:
    """Texts of a part of the report, by key, and its sections."""

    text: dict[str, Any]

    @classmethod
    def of(cls, name: str) -> Wording:
        """Texts in a file of ``templates``, named without suffix."""
        path = files("springback.interfaces") / "templates" / f"{name}.toml"
        return cls(tomllib.loads(path.read_text("utf-8")))

    def say(self, key: str, **values: Any) -> str:
        """Text of a key with its numbers filled in."""
        return _fill(self.text[key], values)

    def head(self, key: str) -> tuple[str, ...]:
        """Column heads of a table."""
        return tuple(self.text["heads"][key])

    def title(self, key: str) -> str:
        """Title of a section."""
        return str(self.text["titles"][key])

    def sections(self, content: Mapping[str, Content]) -> list[Section]:
        """Sections of a part, as laid out by its file.

        A block of a section is a paragraph; ``table``, the name of its rows, with ``caption`` and
        ``head`` (the first row by default); ``figure``, its name, with ``caption``; ``text``; or
        ``blocks``, the name of finished blocks.  A block that names content, also by ``when``, is
        left out if that is missing or empty.

        Args:
            content: Numbers, rows of tables and figures named by the blocks of each section, by
                its anchor.  A section that is missing here, or empty, is left out.
        """
        found: list[Section] = []
        for entry in self.text["sections"]:
            values = content.get(entry["anchor"])
            if values:
                blocks = (block for each in entry["blocks"] for block in _blocks(each, values))
                part = "" if found else self.text.get("part", "")
                flags = {name: entry.get(name, False) for name in ("summary", "answers")}
                title = entry["title"]
                found.append(Section(entry["anchor"], title, tuple(blocks), part, **flags))
        return found


def _fill(words: str, values: Mapping[str, Any]) -> str:
    return _PageFormatter().vformat(words.strip("\n").replace("\n", " "), (), values)


def _blocks(entry: str | Mapping[str, Any], values: Mapping[str, Any]) -> Blocks:
    """Blocks described by an entry of a section's file."""
    if isinstance(entry, str):
        return (_fill(entry, values),)
    kind = next(key for key in ("text", "table", "figure", "blocks") if key in entry)
    needed = [entry[key] for key in ("when", kind) if key in entry and key != "text"]
    if not all(values.get(name) for name in needed):
        return ()
    if kind == "text":
        return (_fill(entry["text"], values),)
    if kind == "blocks":
        return tuple(values[entry["blocks"]])
    caption = _fill(entry["caption"], values)
    if kind == "figure":
        return (FigureBlock(entry["figure"], caption, values[entry["figure"]]),)
    lines = values[entry["table"]]
    if "head" in entry:
        lines = [[_fill(word, values) for word in entry["head"]], *lines]
    return (table(caption, lines[0], lines[1:], folded=entry.get("folded", False)),)


def page(title: str, sections: Sequence[Section], lead: str) -> str:
    """Self-contained HTML page of sections.

    Args:
        title: Title of the page.
        sections: Sections in order.
        lead: Line below the title.
    """
    environment = Environment(
        loader=PackageLoader("springback.interfaces"), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
    )  # fmt: skip
    environment.filters["symbols"] = _symbols
    environment.filters["breakable"] = _breakable
    template = environment.get_template("report.html.j2")
    return template.render(title=title, lead=lead, sections=sections)


def _symbols(text: str) -> Markup:
    """Escaped text, with typographic minus signs and the symbols of the paper as such."""
    known = r"\b([abceklmpvI])_(a|b|c|l|n|r|max|rigid|x|y|z|xx|yy|zz)\b"
    signed = re.sub(r"(?<![\w.)-])-(?=\d)", "−", str(escape(text)))
    return Markup(re.sub(known, r"<var>\1<sub>\2</sub></var>", signed))


def _breakable(text: str) -> Markup:
    """Escaped text whose lines may end after a dot, which copying does not show."""
    return Markup("<wbr>".join(str(escape(part)) for part in re.split(r"(?<=\w\.)(?=[a-z])", text)))


def decimal(value: float | None, decimals: int) -> str:
    """Number rounded half away from zero, as in print."""
    return "–" if value is None else f"{value:.{decimals}f}".replace("-", "−")


def number(value: float, decimals: int) -> str:
    """Rounded number, without a negative zero."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}".replace("-", "−")


def plain(value: float | None) -> str:
    """Given or printed number with no more digits than it has; a count with all of them."""
    if isinstance(value, int):
        return str(value)
    return "–" if value is None else f"{value:.6g}".replace("e+0", "e")


def percent(share: float | None) -> str:
    """Signed share in percent."""
    if share is None:
        return ""
    return f"{round(100.0 * share, 1) + 0.0:+.1f} %".replace("-", "−")


def join(words: Iterable[str]) -> str:
    """Enumeration of words: a, b and c."""
    *most, last = [*words] or ["none"]
    return f"{', '.join(most)} and {last}" if most else last


def words_of_power(value: float) -> str:
    """Small number with a power of ten, such as 3 · 10⁻⁸."""
    digit, power = f"{max(value, 1e-16):.0e}".split("e")
    raised = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{digit} · 10{raised}"
