"""What a page of the documentation says to type."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple


class Typed(NamedTuple):
    """Something a reader would type."""

    kind: str  # python, toml, shell, text (an answer), words (a command in a sentence)
    text: str
    saved_as: str  # of a file, "" if the page does not say
    line: int


def typed(page: Path) -> Iterator[Typed]:
    """Code of a page in its order; an indented block and one in fences without a language are for a shell."""
    lines = [*page.read_text().splitlines(), ""]
    said, last, k = "", "", 0
    while k < len(lines):
        fence = re.match(r"```(\S*)", lines[k])
        if fence:
            end = next(j for j in range(k + 1, len(lines)) if lines[j].startswith("```"))
            body = "\n".join(lines[k + 1 : end])
            name = re.search(r"Save as `(.+?)`", last)
            if fence[1] in ("python", "toml", "sh", "text"):
                kind = "shell" if fence[1] == "sh" else fence[1]
                yield Typed(kind, body, name[1] if name else "", k + 1)
            said, last, k = "", "", end + 1
        elif lines[k].startswith("    ") and not said.strip():
            if lines[k].strip():
                yield Typed("shell", lines[k].strip(), "", k + 1)
            k += 1
        else:
            said, last = lines[k].strip() and lines[k], lines[k].strip() or last
            if lines[k].strip():
                for command in re.findall(r"`(springback [a-z][^`]*)`", lines[k]):
                    yield Typed("words", command, "", k + 1)
            k += 1
