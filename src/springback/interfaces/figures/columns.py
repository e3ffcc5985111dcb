"""Figures of any columns of a flight, as wide as a column of a paper."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib import style
from matplotlib.figure import Figure

from springback.errors import InputError
from springback.interfaces.figures.chart import Chart
from springback.interfaces.figures.panels import (
    Array,
    Curve,
    Panel,
    contacts,
    stacked_panels,
)
from springback.interfaces.figures.style import STYLE, StyledFigure, in_style
from springback.interfaces.output.robots import BLUE, INK, RED
from springback.results.flight import Flight
from springback.units import UnitError, read_number

#: Widths by name [m]: those of a column and of the page of most two-column journals.
WIDTHS = {"one column": 0.088, "two columns": 0.180}
#: Height of a panel and of the time axis, and range of sizes [m] (chosen).
PANEL, AXIS, LEAST, MOST = 0.030, 0.012, 0.03, 1.0
INCH = 0.0254
#: Type and lines for figures that a paper prints without scaling [points].
PRINTED: dict[str, Any] = {
    **dict.fromkeys(
        ("font.size", "axes.titlesize", "axes.labelsize", "xtick.labelsize", "ytick.labelsize",
         "legend.fontsize"), 7.0,
    ),
    "lines.linewidth": 1.1, "axes.linewidth": 0.5, "grid.linewidth": 0.4, "figure.dpi": 300.0,
}  # fmt: skip

#: Quantity of a column by the beginning of its name; N is the number of an arm.
_QUANTITIES = (
    (r"[xyz]|(pose|est|ref|goal)_[xyz]", "Position"),
    (r"v[xyz]|(est|ref)_v[xyz]", "Velocity"),
    (r"a[xyz]|ref_a[xyz]", "Acceleration"),
    (r"imu_a[xyz]", "Specific force"),
    (r"w[xyz]|(est|imu|aim)_w[xyz]", "Angular velocity"),
    (r"q[wxyz]|(pose|est|aim)_q[wxyz]", "Quaternion"),
    (r"l\d+|hall\d+", "Arm length"),
    (r"dl\d+", "Arm rate"),
    (r"fn(\d+|_body)", "Normal force"),
    (r"ff(\d+|_body)", "Friction"),
    (r"(thrust|command)\d+|aim_thrust", "Thrust"),
    (r"force_[xyz]", "External force"),
    (r"moment_[xyz]", "External moment"),
    (r"alarms_.*", "Alarm"),
)


def metres(size: float | str, name: str) -> float:
    """A size [m] from a number, a text with a unit, or a name of `WIDTHS`.

    Raises:
        InputError: If it is none of these, or out of range.
    """
    try:
        found = WIDTHS[size] if size in WIDTHS else _number(size)
    except (UnitError, TypeError, ValueError):
        names = ", ".join(map(repr, WIDTHS))
        raise InputError(f"{name}: must be {names}, a number in m, or '120 mm' (got {size!r})"
                         ) from None  # fmt: skip
    if not LEAST <= found <= MOST:
        raise InputError(f"{name}: must be from {LEAST} to {MOST} m (got {found:g} m)")
    return found


def _number(size: float | str) -> float:
    return read_number(size, "m") if isinstance(size, str) else float(size)


def columns_figure(
    flight: Flight,
    columns: str | Sequence[str | Sequence[str]],
    *,
    width: float | str = "one column",
    height: float | str | None = None,
    window: tuple[float, float] | None = None,
) -> StyledFigure:
    """Columns over time, in type of 7 pt.

    Args:
        flight: With its trajectory.
        columns: As for `springback.Flight.plot`.
        width: As there.
        height: As there.
        window: As there.

    Raises:
        InputError: If a column does not exist, or a size or the window is invalid.
    """
    groups = list(_groups([columns] if isinstance(columns, str) else list(columns)))
    if not groups:
        raise InputError("columns: name at least one")
    begin, end = window or (float(flight.t[0]), float(flight.t[-1]))
    if not (begin < end and begin < flight.t[-1] and end > flight.t[0]):
        raise InputError(
            f"window: must be two instants within {flight.t[0]:g} to {flight.t[-1]:g} s "
            f"(got {begin:g}, {end:g})"
        )
    panels = [_panel(flight, group, begin, end) for group in groups]
    wide = metres(width, "width")
    high = AXIS + PANEL * len(panels) if height is None else metres(height, "height")
    shades = [(a, b) for a, b in contacts(flight.columns) if a < end and b > begin]
    with style.context([*STYLE, PRINTED]):
        figure = stacked_panels(panels, "Time [s]", shades, size=(wide / INCH, high / INCH))
        for ax in figure.axes:
            ax.set_xlim(begin, end)
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
    return figure


def _groups(columns: list[str | Sequence[str]]) -> Iterator[list[str]]:
    """Columns of each panel: neighbours of one quantity, and what is given as a list."""
    group: list[str] = []
    for entry in columns:
        if not isinstance(entry, str):
            if group:
                yield group
            group = []
            yield list(entry)
        elif group and quantity_of(group[0]) != quantity_of(entry):
            yield group
            group = [entry]
        else:
            group.append(entry)
    if group:
        yield group


def quantity_of(column: str) -> str:
    """Name of the quantity of a column, its own if it has no other."""
    found = (words for names, words in _QUANTITIES if re.fullmatch(names, column))
    return next(found, column)


def _panel(flight: Flight, names: list[str], begin: float, end: float) -> Panel:
    """Panel of columns, with quantity and unit; an extra instant on either side of the window."""
    if not names:
        raise InputError("columns: a panel must have at least one")
    curves = []
    for name in names:
        t, values = _column(flight, name)
        inside = slice(max(np.searchsorted(t, begin) - 1, 0), np.searchsorted(t, end, "right") + 1)
        curves.append(Curve(name, t[inside], values[inside]))
    units = list(dict.fromkeys(flight.units[name] for name in names))
    if len(units) > 1:
        raise InputError(f"columns: {', '.join(names)} have different units: {', '.join(units)}")
    quantities = list(dict.fromkeys(map(quantity_of, names)))
    label = ", ".join(quantities)
    return Panel(f"{label} [{units[0].replace('^2', '²') or '-'}]", curves, 1e-6, 1e-12)


def _column(flight: Flight, name: str) -> tuple[Array, Array]:
    """Instants and values of a column."""
    for table in (flight.columns, flight.telemetry):
        if name in table and name != "t":
            return table["t"], table[name]
    known = ", ".join(sorted({*flight.columns, *flight.telemetry} - {"t"}))
    raise InputError(f"columns: there is no column {name!r}; there are {known}")


@in_style
def path_figure(flight: Flight) -> Figure:
    """Path of the main body from above and from the side, contacts marked.

    Args:
        flight: With its trajectory.
    """
    c = flight.columns
    figure = StyledFigure(figsize=(4.8, 2.2))
    axes = figure.subplots(1, 2)
    touched, thin = np.zeros(len(c["t"]), dtype=bool), slice(None, None, len(c["t"]) // 2000 + 1)
    for begin, end in contacts(c):
        touched |= (c["t"] >= begin) & (c["t"] <= end)
    half = 0.55 * max(0.05, *(float(np.ptp(c[axis])) for axis in "xyz"))
    for ax, (name, up) in zip(axes, {"from above": "y", "from the side": "z"}.items(), strict=True):
        chart = Chart(ax, "x [m]", f"{up} [m]", name)
        chart.curve("path", c["x"][thin], c[up][thin], color=BLUE)
        chart.curve("start", c["x"][:1], c[up][:1], color=INK, marker="o", ls="none", ms=4.0)
        if touched.any():
            gaps = np.where(touched, c[up], np.nan)
            chart.curve("contact", c["x"][thin], gaps[thin], color=RED, lw=3.0)
        ax.set(xlim=_span(c["x"], half), ylim=_span(c[up], half), aspect="equal")
    return figure


def _span(values: Array, half: float) -> tuple[float, float]:
    """Range of an axis around some values."""
    middle = 0.5 * float(np.min(values) + np.max(values))
    return middle - half, middle + half
