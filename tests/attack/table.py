"""One line of the table of attacks."""

from __future__ import annotations

from typing import NamedTuple


class Row(NamedTuple):
    """One line of the table."""

    what: str
    tried: int
    tracebacks: int = 0
    hangs: int = 0
    wrong: int = 0
    remark: str = ""
