"""Pages as tests read them."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from typing import Any

ABOUT = {"springback": "0.1.0", "python": "3.x", "numpy": "2.x", "numba": "0.x"}


class Page(HTMLParser):
    """Tags with their attributes, headings, tables by caption, words; every tag must be closed in turn."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.tables: dict[str, list[list[dict[str, Any]]]] = {}
        self.words = ""
        self._open: list[str] = []
        self.feed(text)

    @property
    def levels(self) -> list[int]:
        """Levels of the headings, in their order."""
        return [int(tag[1]) for tag, _ in self.tags if re.fullmatch(r"h[1-6]", tag)]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag == "caption":
            self._caption, self._rows = "", []
        elif tag == "tr":
            self._rows.append([])
        elif tag in ("td", "th"):
            self._rows[-1].append({"text": "", "value": None})
        elif tag == "data":
            self._rows[-1][-1]["value"] = float(dict(attrs)["value"] or "")
        if tag not in ("meta", "img"):
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag, f"{tag} closes another element"
        if tag == "caption":
            self.tables[self._caption] = self._rows

    def handle_data(self, data: str) -> None:
        self.words += data
        if "caption" in self._open:
            self._caption += data
        elif self._open and {"td", "th"} & set(self._open):
            self._rows[-1][-1]["text"] += data
