"""The house style of figures, and how they become files.

Figures are plain `matplotlib.figure.Figure` objects without pyplot, so they need no display and
leave no global state behind.  Colours are those of Okabe and Ito, which colour-blind readers tell
apart; curves differ in line style, too, so that they survive a black-and-white printer.
"""

from __future__ import annotations

import functools
import io
from collections.abc import Callable
from pathlib import Path
from typing import Any, ParamSpec

from matplotlib import style
from matplotlib.figure import Figure

from springback.interfaces.figures.data import csv_of

P = ParamSpec("P")
Look = tuple[str, Any]
"""Colour and line style of a curve."""

INK, BLUE, ORANGE, GREEN = "#222222", "#0072B2", "#E69F00", "#009E73"
PINK, SKY, RED, GREY = "#CC79A7", "#56B4E9", "#D55E00", "#8C8C8C"
SHADE = "#E4E8EE"
LOOKS: tuple[Look, ...] = (
    (BLUE, "-"), (ORANGE, (0, (5, 1.5))), (GREEN, (0, (5, 1.5, 1, 1.5))), (PINK, (0, (1.2, 1))),
    (SKY, (0, (8, 2))), (GREY, (0, (3, 1, 1, 1, 1, 1))),
)  # fmt: skip
"""Of curves in one panel, in this order."""
WIDTH = 4.8
"""Of a figure [in]: at this width type is 9 pt, and still 6.5 pt when set in a column of 3.5 in."""
COLUMN, TWO_COLUMNS = 3.5, 7.16
"""[in]: what figures are set in when printed; those wider than `WIDTH` span two columns."""
RESOLUTION = 200
"""Of PNG files [dots per inch]."""
STYLE = ["default", "springback.interfaces.templates.springback"]


class StyledFigure(Figure):
    """A figure that notebooks show without pyplot."""

    def _repr_png_(self) -> bytes:
        return png(self)


def as_written(text: str) -> str:
    r"""Text of the user's for a figure, in which ``$`` begins no formula.

    A scenario named ``a $\foo$ b`` would be an error of the typesetter else.
    """
    return text.replace("$", r"\$")


def styled(draw: Callable[P, Figure]) -> Callable[P, Figure]:
    """Draw in the house style, whatever the user's own settings are, and leave those untouched."""

    @functools.wraps(draw)
    def drawn(*args: P.args, **kwargs: P.kwargs) -> Figure:
        with style.context(STYLE):
            figure = draw(*args, **kwargs)
            figure.draw_without_rendering()  # ticks are made when first drawn: here, in this style
            figure.set_layout_engine("none")  # laid out now; once is enough, and it is slow
        return figure

    return drawn


def picture(draw: Callable[P, Figure], *args: P.args, **kwargs: P.kwargs) -> tuple[bytes, str]:
    """PNG file and numbers (CSV) of a figure wanted for nothing else: laid out once, not twice."""
    with style.context(STYLE):
        figure = draw.__wrapped__(*args, **kwargs)  # type: ignore[attr-defined]
        return png(figure), csv_of(figure)


def printed_width(figure: Figure) -> float:
    """How wide a figure is in print [in]."""
    return COLUMN if figure.get_size_inches()[0] <= WIDTH else TWO_COLUMNS


def png(figure: Figure) -> bytes:
    """The figure as a PNG file, the same bytes for the same figure."""
    buffer = io.BytesIO()
    with style.context(STYLE):
        figure.savefig(buffer, format="png", dpi=RESOLUTION, metadata={"Software": None})
    return buffer.getvalue()


def save(figure: Figure, path: Path, *, numbers: bool = True) -> list[Path]:
    """Write a figure as PNG and PDF, and what it shows as CSV, with no dates in them.

    The same figure gives the same files.

    Args:
        figure: Any figure.
        path: Without suffix; the folder is made if it is not there.
        numbers: Whether the CSV is wanted; not where a file of that name holds them already.

    Returns:
        The files written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    files = [path.with_name(path.name + suffix) for suffix in (".png", ".pdf")]
    files[0].write_bytes(png(figure))
    nobody = {"Creator": None, "Producer": None, "CreationDate": None}
    with style.context(STYLE):
        figure.savefig(files[1], format="pdf", metadata=nobody)
    if numbers:
        files.append(path.with_name(path.name + ".csv"))
        files[-1].write_text(csv_of(figure), encoding="utf-8")
    return files
