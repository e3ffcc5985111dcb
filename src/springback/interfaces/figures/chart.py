"""Axes that draw tidy columns, and record them in the table of their figure.

A column is named by the label of its axis, with the unit.  Where a position stands for a word, as
on an axis of names, ``columns`` holds the word.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import FuncNorm, LinearSegmentedColormap, ListedColormap
from matplotlib.figure import Figure

from springback.interfaces.figures.style import StyledFigure, escape
from springback.interfaces.output.robots import GREY, INK, SHADE

LOW, HIGH = ", low", ", high"
"""Suffixes of the column names of bounds."""
RULE: dict[str, Any] = {"color": GREY, "lw": 0.9, "ls": (0, (3, 2)), "zorder": 1.5}
"""Look of a line across a panel."""
AREA: dict[str, Any] = {"color": SHADE, "lw": 0.0, "zorder": 0.1}
#: Light to dark with failures: one hue, distinguishable in grey.
SHADES = ListedColormap(np.linspace((0.55, 0.16, 0.05), (0.97, 0.97, 0.97), 11).tolist())
Columns = Mapping[str, Any]
"""Values by column name: an array, or one value for all rows."""


#: From failure to success, dark to light, so that the order is visible in black and white.
SCALE = LinearSegmentedColormap.from_list("success", ["#3B1F4F", "#33638D", "#6FB7C4", "#F4F7E8"])
#: Shares, and their places on that scale: half of it shows those from `FINER` (chosen).
FINER = 0.8
SHARES, PLACES = (0.0, 0.5, FINER, 0.9, 1.0), (0.0, 0.25, 0.5, 0.7, 1.0)
SHARE_TICKS = (0.0, 0.25, 0.5, 0.8, 0.9, 0.95, 1.0)
#: Largest place whose colour is dark enough for white letters.
DARK = 0.47


def share_place(shares: Any) -> Any:
    """Places of shares on the colour scale, from 0 to 1."""
    return np.interp(shares, SHARES, PLACES)


def ink(place: float) -> str:
    """Colour of letters on a place of the colour scale, from 0 to 1."""
    return "white" if place < DARK else INK


def draw_shares(ax: Axes, x: Any, y: Any, shares: Any) -> Any:
    """Colour cells by shares from 0 to 1, finer near 1 so that 0.9 and 1 differ.

    Args:
        ax: Axes to draw on.
        x: Bounds of the cells along x.
        y: Bounds of the cells along y.
        shares: Shape (rows, columns); NaN for missing ones.

    Returns:
        The mesh, for `add_share_bar`.
    """
    ax.grid(visible=False)
    norm = FuncNorm((share_place, lambda at: np.interp(at, PLACES, SHARES)), vmin=0.0, vmax=1.0)
    return ax.pcolormesh(
        x, y, np.ma.masked_invalid(shares), cmap=SCALE, norm=norm, edgecolors="white",
        linewidth=0.4,
    )  # fmt: skip


def add_share_bar(figure: Figure, mesh: Any, axes: Any, label: str, **look: Any) -> Axes:
    """Add the colour bar of `draw_shares` beside axes; its label says that it is not linear."""
    bar = figure.colorbar(mesh, ax=axes, pad=0.02, ticks=SHARE_TICKS, **look)
    bar.set_label(f"{label},\ncolours finer above {FINER:g}")
    bar.ax.grid(visible=False)
    return bar.ax


class Chart:
    """A panel whose axis labels, with units, are the column names of its table.

    Every drawing method takes the name of the series first, and keywords of matplotlib last;
    without ``key`` the series is in the table, but not in the legend.
    """

    def __init__(self, ax: Axes, x: str, y: str, panel: str = "", *, titled: bool = True) -> None:
        """Label the axes whose ticks are numbers, and set the title."""
        self.ax, self.x, self.y, self.panel = ax, x, y, panel
        for axis, label, which in ((ax.xaxis, x, "labelbottom"), (ax.yaxis, y, "labelleft")):
            if label.endswith("]") and axis.get_tick_params().get(which, True):
                axis.set_label_text(label)
        if panel and titled:
            ax.set_title(escape(panel))

    def record(self, series: str, columns: Columns) -> None:
        """Add rows to the figure's table."""
        figure = self.ax.get_figure(root=True)
        if isinstance(figure, StyledFigure):
            figure.table.append({"panel": self.panel, "series": series, **columns})

    def curve(
        self, series: str, x: Any, y: Any, *, key: bool = True, columns: Columns | None = None,
        **look: Any,
    ) -> Any:  # fmt: skip
        """Draw a line or marks; ``columns`` replace or extend those of x and y in the table."""
        self.record(series, {self.x: x, self.y: y, **(columns or {})})
        return self.ax.plot(x, y, label=_label(series, key), **look)[0]

    def errorbars(
        self, series: str, x: Any, y: Any, low: Any, high: Any, *, across: bool = False,
        columns: Columns | None = None, **look: Any,
    ) -> Any:  # fmt: skip
        """Draw marks with bounds, along y or, if ``across``, along x."""
        head, middle = (self.x, x) if across else (self.y, y)
        bounds = {head + LOW: low, head + HIGH: high}
        self.record(series, {self.x: x, self.y: y, **bounds, **(columns or {})})
        reach = np.clip([np.subtract(middle, low), np.subtract(high, middle)], 0.0, None)
        look["xerr" if across else "yerr"] = reach.reshape(2, -1)
        return self.ax.errorbar(x, y, label=_label(series), **look)

    def band(self, series: str, x: Any, low: Any, high: Any, **look: Any) -> None:
        """Shade between two curves."""
        self.record(series, {self.x: x, self.y + LOW: low, self.y + HIGH: high})
        self.ax.fill_between(x, low, high, lw=0.0, label=_label(series, False), **look)

    def vline(self, series: str, x: float, *, key: bool = False, **look: Any) -> None:
        """Draw a line across the panel at an x."""
        self.record(series, {self.x: x})
        self.ax.axvline(x, label=_label(series, key), **RULE | look)

    def hline(self, series: str, y: float, *, key: bool = False, **look: Any) -> None:
        """Draw a line across the panel at a y."""
        self.record(series, {self.y: y})
        self.ax.axhline(y, label=_label(series, key), **RULE | look)

    def span(self, series: str, low: float, high: float, *, key: bool = False, **look: Any) -> None:
        """Shade the panel between two x."""
        self.record(series, {self.x + LOW: low, self.x + HIGH: high})
        self.ax.axvspan(low, high, label=_label(series, key), **AREA | look)

    def key(self, name: str, **look: Any) -> None:
        """Add a look to the legend."""
        self.ax.plot([], [], label=escape(name), **look)

    def heat_map(
        self, head: str, shares: Any, words: Sequence[Sequence[str]], rows: Sequence[str],
        columns: Sequence[str],
    ) -> None:  # fmt: skip
        """Draw shares as colours with a word in each cell.

        Args:
            head: Column name of the shares, which are in percent if it contains ``%``.
            shares: From 0 to 1, shape (rows, columns); NaN for missing ones.
            words: Text of each cell.
            rows: Names of the rows, from the top.
            columns: Names of the columns.
        """
        shares, scale = np.asarray(shares), 100.0 if head.endswith("[%]") else 1.0
        self.ax.imshow(shares, cmap=SHADES, vmin=0.0, vmax=1.0, aspect="auto")
        across, down = np.meshgrid(columns, rows)
        known = np.isfinite(shares)
        cells = {self.x: across[known], self.y: down[known], head: scale * shares[known]}
        self.record("", cells)
        for (i, j), share in np.ndenumerate(shares):
            self.ax.text(
                j, i, words[i][j], ha="center", va="center", size=8,
                color="white" if share < 0.5 else INK,
            )  # fmt: skip
        self.ax.set_yticks(range(len(rows)), rows, size=8)
        self.ax.set_xticks(range(len(columns)), columns, size=8)
        self.ax.tick_params(length=0)
        self.ax.grid(visible=False)
        for edge in self.ax.spines.values():
            edge.set_visible(False)


def _label(series: str, key: bool = True) -> str:
    """Label of an artist; matplotlib leaves those with an underscore out of legends."""
    return escape(series) if key else f"_{series}"
