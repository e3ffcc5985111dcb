"""Style of figures, and their files.

Figures are plain `matplotlib.figure.Figure` objects without pyplot, so they need no display and
leave no global state.  Curves differ in colour and in line style.
"""

from __future__ import annotations

import functools
import io
import math
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any, ParamSpec, cast

import numpy as np
from matplotlib import style
from matplotlib.figure import Figure

from springback.files import csv_text
from springback.interfaces.output.robots import BLUE, GREEN, GREY, INK, ORANGE, PINK, SKY

P = ParamSpec("P")
Look = dict[str, Any]
"""Colour and line style of a curve, as keywords."""

LOOKS: tuple[Look, ...] = (
    {"color": BLUE, "ls": "-"}, {"color": ORANGE, "ls": (0, (5, 1.5))},
    {"color": GREEN, "ls": (0, (5, 1.5, 1, 1.5))}, {"color": PINK, "ls": (0, (1.2, 1))},
    {"color": SKY, "ls": (0, (8, 2))}, {"color": GREY, "ls": (0, (3, 1, 1, 1, 1, 1))},
    {"color": INK, "ls": (0, (6, 1, 1, 1))},
)  # fmt: skip
"""Looks of the curves of a panel, in order."""
WIDTH = 4.8
"""Width of a figure [in]: type of 9 pt remains 6.5 pt in a column of 3.5 in."""
RESOLUTION = 200
"""Resolution of PNG files [dots per inch]."""
STYLE = ["default", "springback.interfaces.templates.springback"]
DIGITS = 10
"""Significant digits of numbers in CSV files."""


class StyledFigure(Figure):
    """A figure with the table it was drawn from; notebooks show it without pyplot."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        """Create a figure of matplotlib with an empty table."""
        super().__init__(*args, **kwargs)
        self.table: list[Mapping[str, Any]] = []
        """Blocks of rows: values by column name, each an array, or one value for all rows."""

    def rows(self) -> Iterator[dict[str, Any]]:
        """Rows of the table, without those with a number that is not finite."""
        for block in self.table:
            columns = np.broadcast_arrays(*map(np.atleast_1d, block.values()))
            for values in zip(*(column.tolist() for column in columns), strict=True):
                if all(math.isfinite(v) for v in values if isinstance(v, float)):
                    yield dict(zip(block, map(_plain, values), strict=True))

    def csv(self) -> str:
        """The table as comma-separated values; missing values are empty."""
        heads = list(dict.fromkeys(head for block in self.table for head in block))
        return csv_text([heads, *([*map(row.get, heads)] for row in self.rows())])

    def _repr_png_(self) -> bytes:
        return png(self)


def _plain(value: Any) -> Any:
    if isinstance(value, float):
        return f"{value + 0.0:.{DIGITS}g}"  # no negative zero
    return " ".join(value.split()).replace("−", "-") if isinstance(value, str) else value


def escape(text: str) -> str:
    r"""User text with ``$`` escaped, so that it does not start a formula.

    Otherwise the typesetter would fail on a scenario named ``a $\foo$ b``.
    """
    return text.replace("$", r"\$")


def in_style(draw: Callable[P, Figure]) -> Callable[P, StyledFigure]:
    """Draw in springback's style, independent of the user's settings, and restore those."""

    @functools.wraps(draw)
    def drawn(*args: P.args, **kwargs: P.kwargs) -> StyledFigure:
        with style.context(STYLE):
            figure = cast("StyledFigure", draw(*args, **kwargs))
            figure.draw_without_rendering()  # ticks are created here, in this style
            figure.set_layout_engine("none")  # layout now, once: it is slow
        return figure

    return drawn


def picture(
    draw: Callable[P, StyledFigure], *args: P.args, **kwargs: P.kwargs
) -> tuple[bytes, str]:
    """PNG and CSV of a figure that is not used otherwise, with a single layout."""
    with style.context(STYLE):
        figure = draw.__wrapped__(*args, **kwargs)  # type: ignore[attr-defined]
        return png(figure), figure.csv()


def png(figure: Figure) -> bytes:
    """Figure as a PNG file, the same bytes for the same figure."""
    buffer = io.BytesIO()
    with style.context(STYLE):
        figure.savefig(buffer, format="png", dpi=RESOLUTION, metadata={"Software": None})
    return buffer.getvalue()


def save(
    figure: StyledFigure, path: Path, *, numbers: bool = True, image: bytes = b""
) -> list[Path]:
    """Write a figure as PNG and PDF, and its table as CSV.

    The files contain no dates: the same figure gives the same files.

    Args:
        figure: Any figure.
        path: Path without suffix; the folder is created if it does not exist.
        numbers: Write the CSV, too; False where a file of that name has the numbers already.
        image: The figure as PNG, if it was drawn before.

    Returns:
        The files written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    files = [path.with_name(path.name + suffix) for suffix in (".png", ".pdf")]
    files[0].write_bytes(image or png(figure))
    undated = {"Creator": None, "Producer": None, "CreationDate": None}
    with style.context(STYLE):
        figure.savefig(files[1], format="pdf", metadata=undated)
    if numbers:
        files.append(path.with_name(path.name + ".csv"))
        files[-1].write_text(figure.csv(), encoding="utf-8")
    return files
