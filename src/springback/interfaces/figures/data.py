"""The numbers that a figure shows, read back from the figure itself.

One table for any figure: a row for each point, bar or cell, with its panel, its series, and a
column for each labelled axis, units in the head.  What stands on an axis with words is given by its
word.  Names that a figure does not show, but its data need, begin with an underscore: matplotlib
keeps such artists out of legends.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.collections import LineCollection, PolyCollection, QuadMesh
from matplotlib.container import BarContainer, ErrorbarContainer
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.ticker import FixedLocator

from springback.interfaces.output.tables import as_csv

Row = dict[str, Any]
NUMBERS, VALUE = 10, "value [-]"
"""Significant digits; the head of colours that have no label."""
UNNAMED = re.compile(r"_child\d+|_container\d+|_nolegend_|<colorbar>")
CATEGORY = "category"
"""Head of an axis with words and no label."""
LOW, HIGH = ", low", ", high"
"""Ends of the heads of bounds."""


def as_table(figure: Figure) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Heads and rows of everything a figure shows.

    Args:
        figure: Any whose axes have labels.

    Returns:
        Heads, ``panel`` and ``series`` first, and rows; what a row has not is None.
    """
    rows = [row for ax in figure.axes if ax.get_label() != "<colorbar>" for row in _panel(ax)]
    heads = dict.fromkeys(("panel", "series"))
    for row in rows:
        heads |= dict.fromkeys(row)
    return list(heads), [tuple(row.get(head) for head in heads) for row in rows]


def csv_of(figure: Figure) -> str:
    """`as_table` as comma-separated values, numbers with ten digits.

    Args:
        figure: Any whose axes have labels.
    """
    heads, rows = as_table(figure)
    return as_csv(heads, [tuple(map(_cell, row)) for row in rows])


def _cell(value: Any) -> Any:
    if isinstance(value, float):
        return f"{value:.{NUMBERS}g}" if math.isfinite(value) else None
    return value


# -- names ----------------------------------------------------------------------------------------


def axis_label(ax: Axes, which: str) -> str:
    """What stands along an axis: its label, that of a panel sharing it, or a title with a unit.

    Args:
        ax: The panel.
        which: ``x`` or ``y``.
    """
    group = ax.get_shared_x_axes() if which == "x" else ax.get_shared_y_axes()
    shared = [other for other in ax.figure.axes if other in group.get_siblings(ax)]
    labels = [str(getattr(a, f"get_{which}label")()) for a in (ax, *shared)]
    title = ax.get_title(loc="left")
    labels.append(title if which == "y" and title.endswith("]") else "")
    return _words(next(filter(None, labels), ""))


def panel_name(ax: Axes) -> str:
    """The name of a panel: one given to it for data, its title, or that of the panel on its top."""
    own = str(ax.get_label()) or ax.get_title(loc="left")
    if own:
        return _words(own)
    place = ax.get_subplotspec()
    if place is None:
        return ""
    column = [
        other.get_title(loc="left")
        for other in ax.figure.axes
        if (spec := other.get_subplotspec()) is not None
        and spec.get_gridspec() is place.get_gridspec()
        and spec.colspan == place.colspan
    ]
    return _words(column[0]) if column else ""


def _words(text: str) -> str:
    return " ".join(text.split()).replace("−", "-")


def _series(artist: Any, ax: Axes) -> str:
    """The name of what is drawn: its own, or that of something drawn alike which has one."""
    label = str(artist.get_label())
    if not UNNAMED.fullmatch(label):
        return _words(label.removeprefix("_"))
    if not isinstance(artist, Line2D):
        return ""
    for other in (line for panel in ax.figure.axes for line in panel.lines):
        name = str(other.get_label())
        if not UNNAMED.fullmatch(name) and _look(other) == _look(artist):
            return _words(name.removeprefix("_"))
    return ""


def _look(line: Line2D) -> tuple[Any, ...]:
    return line.get_color(), line.get_linestyle(), line.get_marker(), line.get_markerfacecolor()


class _Places:
    """How places along an axis are told: numbers as they are, places of words by their word."""

    def __init__(self, ax: Axes, which: str) -> None:
        axis: Axis = getattr(ax, f"{which}axis")
        locator: Any = axis.get_major_locator()
        fixed = isinstance(locator, FixedLocator)
        self.at: list[float] = [float(v) for v in locator()] if fixed else []
        words = axis.get_major_formatter().format_ticks(self.at) if self.at else []
        self.words = [_words(word) for word in words]
        self.worded = any(not _is_number(word) for word in self.words)
        self.head = axis_label(ax, which) or (CATEGORY if self.worded else which)

    def __call__(self, value: Any) -> Any:
        return self.snapped(value) if self.worded else float(value)

    def snapped(self, value: Any) -> Any:
        """The nearest tick that was set, by its word if ticks have words."""
        if not self.at:
            return float(value)
        nearest = int(np.argmin(np.abs(np.array(self.at) - float(value))))
        return self.words[nearest] if self.worded else self.at[nearest]


def _is_number(word: str) -> bool:
    try:
        float(word or "0")
    except ValueError:
        return False
    return True


# -- what is drawn --------------------------------------------------------------------------------


def _panel(ax: Axes) -> Iterator[Row]:
    x, y, name, parts = _Places(ax, "x"), _Places(ax, "y"), panel_name(ax), set[int]()
    for container in ax.containers:
        parts |= {id(part) for part in _flat(container)}
        head = {"panel": name, "series": _series(container, ax)}
        yield from (head | row for row in _contained(container, x, y))
    for artist in ax.get_children():
        if id(artist) not in parts and artist.get_visible():
            head = {"panel": name, "series": _series(artist, ax)}
            yield from (head | row for row in _drawn(artist, ax, x, y))


def _flat(parts: Iterable[Any]) -> Iterator[Artist]:
    for part in parts:
        if isinstance(part, Artist):
            yield part
        elif part is not None:
            yield from _flat(part)


def _contained(container: Any, x: _Places, y: _Places) -> Iterator[Row]:
    if isinstance(container, BarContainer):
        for bar in container.patches:
            yield _bar(bar, x, y, upright=container.orientation == "vertical")
    elif isinstance(container, ErrorbarContainer):
        line, _, bars = container.lines
        spans = [np.asarray(path.vertices) for bar in bars for path in bar.get_paths()]
        points = np.column_stack([line.get_xdata(), line.get_ydata()])
        sideways = bool(container.has_xerr)
        for (at_x, at_y), span in zip(points, spans, strict=True):
            ends = span[:, 0 if sideways else 1]
            head = (x if sideways else y).head
            yield {x.head: x(at_x), y.head: y(at_y)} | {
                head + LOW: float(min(ends)), head + HIGH: float(max(ends)),
            }  # fmt: skip


def _bar(bar: Rectangle, x: _Places, y: _Places, *, upright: bool) -> Row:
    """A bar's place, that of its group if it stands in one, its size, and from where to where."""
    across, size = (
        (bar.get_width(), bar.get_height()) if upright else (bar.get_height(), bar.get_width())
    )
    edge, base = (bar.get_x(), bar.get_y()) if upright else (bar.get_y(), bar.get_x())
    along, up = (x, y) if upright else (y, x)
    row = {along.head: along.snapped(edge + 0.5 * across), up.head: float(size)}
    return row | (_bounds(up.head, base, size) if base else {})


def _drawn(artist: Artist, ax: Axes, x: _Places, y: _Places) -> Iterator[Row]:
    if isinstance(artist, Line2D):
        yield from _line(artist, ax, x, y)
    elif isinstance(artist, QuadMesh):
        yield from _mesh(artist, x, y)
    elif isinstance(artist, AxesImage):
        yield from _image(artist, x, y)
    elif isinstance(artist, ContourSet | LineCollection):
        for path in artist.get_paths():
            yield from _points(np.asarray(path.vertices), x, y)
    elif isinstance(artist, PolyCollection):
        for path in artist.get_paths():
            yield from _band(np.asarray(path.vertices), x, y)
    elif isinstance(artist, Rectangle) and artist is not ax.patch:
        yield from _span(artist, ax, x, y)


def _points(points: Any, x: _Places, y: _Places) -> Iterator[Row]:
    for at_x, at_y in points:
        if math.isfinite(at_x) and math.isfinite(at_y):
            yield {x.head: x(at_x), y.head: y(at_y)}


def _line(line: Line2D, ax: Axes, x: _Places, y: _Places) -> Iterator[Row]:
    """Points; of a line across the panel the one place where it stands."""
    data: Any = line.get_transform()
    across, up = data.contains_branch_seperately(ax.transData)
    xs, ys = np.asarray(line.get_xdata(), float), np.asarray(line.get_ydata(), float)
    if across and up:
        yield from _points(np.column_stack([xs, ys]), x, y)
    elif across and len(xs):
        yield {x.head: x(xs[0])}
    elif up and len(ys):
        yield {y.head: y(ys[0])}


def _mesh(mesh: QuadMesh, x: _Places, y: _Places) -> Iterator[Row]:
    corners = np.asarray(mesh.get_coordinates())
    values: Any = np.ma.atleast_2d(np.ma.asarray(mesh.get_array()))
    middles = 0.25 * (corners[1:, 1:] + corners[:-1, 1:] + corners[1:, :-1] + corners[:-1, :-1])
    head = _colour_head(mesh)
    for (row, column), value in np.ndenumerate(np.ma.filled(values.astype(float), np.nan)):
        if math.isfinite(value):
            at_x, at_y = middles[row, column]
            yield {x.head: x(at_x), y.head: y(at_y), head: float(value)}


def _image(image: AxesImage, x: _Places, y: _Places) -> Iterator[Row]:
    values = np.ma.filled(np.ma.asarray(image.get_array()).astype(float), np.nan)
    head = _colour_head(image)
    for (row, column), value in np.ndenumerate(values):
        if math.isfinite(value):
            yield {x.head: x(column), y.head: y(row), head: float(value)}


def _colour_head(image: Any) -> str:
    """The label of colours: their own, or that of the figure's colour bar."""
    own = str(image.get_label())
    if own and not UNNAMED.fullmatch(own):
        return own.removeprefix("_")
    bars = (ax.get_ylabel() for ax in image.axes.figure.axes if ax.get_label() == "<colorbar>")
    return next(bars, VALUE)


def _band(vertices: Any, x: _Places, y: _Places) -> Iterator[Row]:
    """Lower and upper bounds, as `fill_between` lays out its outline: there, and back again."""
    count = (len(vertices) - 3) // 2
    there, back = vertices[1 : count + 1], vertices[count + 2 : 2 * count + 2][::-1]
    for (at, one), (_, other) in zip(there, back, strict=True):
        if math.isfinite(one) and math.isfinite(other):
            low, high = sorted((float(one), float(other)))
            yield {x.head: x(at), y.head + LOW: low, y.head + HIGH: high}


def _span(patch: Rectangle, ax: Axes, x: _Places, y: _Places) -> Iterator[Row]:
    """Bounds of a shaded part of an axis, or of a rectangle."""
    across, up = patch.get_data_transform().contains_branch_seperately(ax.transData)
    row: Row = {}
    if across:
        row |= _bounds(x.head, patch.get_x(), patch.get_width())
    if up:
        row |= _bounds(y.head, patch.get_y(), patch.get_height())
    if row:
        yield row


def _bounds(head: str, begin: float, size: float) -> Row:
    low, high = sorted((float(begin), float(begin + size)))
    return {head + LOW: low, head + HIGH: high}
