"""What a reader of a printed figure would complain about: for tests of figures, whatever they show."""

from collections.abc import Iterator
from itertools import combinations
from typing import Any

from matplotlib import style
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import FixedLocator

from springback.interfaces.figures import style as canvas

COLUMN, TWO_COLUMNS = 3.5, 7.16
"""Widths in print [in]: figures wider than `canvas.WIDTH` span two columns."""
LEAST = 6.5
"""Size of type in print [pt]."""


def _ticks(axis: Any) -> Iterator[Text]:
    """Labels of the ticks that are within the panel."""
    low, high = sorted(axis.get_view_interval())
    room = 1e-9 * (high - low)
    for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
        if low - room <= tick.get_loc() <= high + room:
            yield from (tick.label1, tick.label2)


def _texts(figure: Figure) -> list[Text]:
    found: list[Text] = [*figure.texts]
    for legend in figure.legends:
        found += legend.get_texts()
    for part in figure.subfigs:
        found += _texts(part)  # type: ignore[arg-type]
        found += [text for legend in part.legends for text in legend.get_texts()]
    for ax in figure.axes:
        for axis in (ax.xaxis, ax.yaxis):
            found += [axis.label, *_ticks(axis)]
        found += [*ax.texts, ax.title, ax._left_title, ax._right_title]  # type: ignore[attr-defined]
        if ax.get_legend() is not None:
            found += ax.get_legend().get_texts()  # type: ignore[union-attr]
    unique = {id(text): text for text in found}.values()
    return [t for t in unique if t.get_visible() and t.get_text().strip() and _panel_shown(t)]


def _panel_shown(text: Text) -> bool:
    return text.axes is None or text.axes.get_visible()


def complaints(figure: Figure) -> list[str]:
    """Small, clipped or overlapping words; axes without a unit."""
    found = list(_unlabelled(figure))
    agg = FigureCanvasAgg(figure)
    with style.context(canvas.STYLE):  # ticks that are new are made when drawn
        agg.draw()
    renderer = agg.get_renderer()
    width = figure.get_size_inches()[0]
    printed = (COLUMN if width <= canvas.WIDTH else TWO_COLUMNS) / width
    whole, texts = figure.bbox, _texts(figure)
    boxes = []
    for text in texts:
        box, size = text.get_window_extent(renderer), text.get_fontsize() * printed
        boxes.append(box)
        if size < LEAST:
            found.append(f"{text.get_text()!r} is {size:.2f} pt in print")
        if box.x0 < -1 or box.y0 < -1 or box.x1 > whole.x1 + 1 or box.y1 > whole.y1 + 1:
            found.append(f"{text.get_text()!r} is cut off")
    for (one, a), (other, b) in combinations(zip(texts, boxes, strict=True), 2):
        across = min(a.x1, b.x1) - max(a.x0, b.x0)
        up = min(a.y1, b.y1) - max(a.y0, b.y0)
        if min(across, up) > 1.5:
            found.append(f"{one.get_text()!r} lies on {other.get_text()!r}")
    return found


def _unlabelled(figure: Figure) -> Iterator[str]:
    for ax in figure.axes:
        if not ax.get_visible() or not ax.axison or ax.get_label() == "<colorbar>":
            continue
        for which in ("x", "y"):
            label = axis_label(ax, which)
            if not label.endswith("]") and not _worded(ax, which):
                yield f"{which} of {ax.get_title(loc='left')!r} has no unit: {label!r}"


def axis_label(ax: Axes, which: str) -> str:
    """The label along x or y: of a panel, of one that shares the axis, or a title with a unit."""
    group = ax.get_shared_x_axes() if which == "x" else ax.get_shared_y_axes()
    shared = [other for other in ax.figure.axes if other in group.get_siblings(ax)]
    lines = [str(getattr(a, f"get_{which}label")()) for a in (ax, *shared)]
    labels = [text.replace("\n.", ".").replace("\n", " ") for text in lines]
    title = ax.get_title(loc="left")
    labels.append(title if which == "y" and title.endswith("]") else "")
    return next(filter(None, labels), "")


def _worded(ax: Axes, which: str) -> bool:
    axis = getattr(ax, f"{which}axis")
    if not isinstance(axis.get_major_locator(), FixedLocator):
        return False
    words = axis.get_major_formatter().format_ticks(axis.get_major_locator()())
    return any(letter.isalpha() for word in words for letter in word)
