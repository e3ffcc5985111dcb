"""Figures over time: stacked panels with shaded contacts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import cycle
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes

from springback.interfaces.figures.chart import AREA, Chart
from springback.interfaces.figures.style import LOOKS, WIDTH, Look, StyledFigure
from springback.results.flight import Flight
from springback.results.joints.hinges import has_hinges, hinge_histories

Array = np.ndarray[Any, np.dtype[np.float64]]
Curves = list[tuple[str, Array]]
ROUNDING = 1e-6
"""A curve that varies less than this is drawn as a flat line, not magnified."""

POINTS = 800
"""Chosen: groups of points along the time axis, about as many as a figure has pixels."""


class Curve(NamedTuple):
    """A curve over time; without a look it takes the next of `LOOKS`."""

    name: str
    t: Array
    values: Array
    look: Look | None = None


class Panel(NamedTuple):
    """Curves on one vertical axis."""

    label: str
    curves: Sequence[Curve]
    min_span: float = 2.0
    """Span of the vertical axis if the curves are flat."""
    flat: float = ROUNDING
    """Curves that vary less count as flat."""
    explained: bool = True
    """True for a panel with a legend."""


def stacked_panels(
    panels: Sequence[Panel],
    time: str,
    shades: Iterable[tuple[float, float]],
    height: float = 1.4,
    size: tuple[float, float] | None = None,
) -> StyledFigure:
    """Panels over a common time axis.

    Args:
        panels: Panels from the top.
        time: Label of the time axis.
        shades: Shaded intervals, in the unit of that axis.
        height: Height of a panel [in].
        size: Width and height of the figure instead [in].
    """
    figure = StyledFigure(figsize=size or (WIDTH, 0.45 + height * len(panels)))
    axes = list(figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0])
    charts = [Chart(ax, time, panel.label) for ax, panel in zip(axes, panels, strict=True)]
    for start, end in shades:
        charts[0].span("contact", start, end)
        for ax in axes[1:]:
            ax.axvspan(start, end, **AREA)
    if axes[0].patches:
        axes[0].text(0.0, 1.03, "contact shaded", transform=axes[0].transAxes)
    for chart, panel in zip(charts, panels, strict=True):
        _draw(chart, panel)
    begin = min(float(curve.t[0]) for panel in panels for curve in panel.curves)
    end = max(float(curve.t[-1]) for panel in panels for curve in panel.curves)
    axes[-1].set_xlim(begin, end if end > begin else begin + 1.0)
    figure.align_ylabels(axes)
    return figure


def _draw(chart: Chart, panel: Panel) -> None:
    looks = cycle(LOOKS)
    for curve in panel.curves:
        chart.curve(curve.name, *thin_curve(curve.t, curve.values), **(curve.look or next(looks)))
    widen_flat_axis(chart.ax, panel.min_span, panel.flat)
    if panel.explained:
        chart.ax.legend(
            loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=5, borderpad=0.0, borderaxespad=0.3,
            columnspacing=1.0, handletextpad=0.5, handlelength=2.0,
        )  # fmt: skip


def thin_curve(t: Array, values: Array) -> tuple[Array, Array]:
    """A long curve reduced to as many points as can be distinguished, keeping its extremes.

    Of each group of neighbouring points the minimum and the maximum are kept, in order.
    """
    size = len(t) // POINTS
    if size < 4:
        return t, values
    whole = len(t) // size * size
    groups = values[:whole].reshape(-1, size)
    ends = np.stack([groups.argmin(axis=1), groups.argmax(axis=1)], axis=1)
    kept = (np.arange(len(groups))[:, None] * size + np.sort(ends, axis=1)).ravel()
    kept = np.unique(np.concatenate([[0], kept, np.arange(whole, len(t)), [len(t) - 1]]))
    return t[kept], values[kept]


def widen_flat_axis(ax: Axes, least: float, flat: float = ROUNDING) -> None:
    """Widen the vertical axis to at least ``least`` if its curves are flat."""
    low, high = ax.get_ylim()
    if high - low < flat:
        middle = 0.5 * (low + high)
        ax.set_ylim(middle - 0.5 * least, middle + 0.5 * least)


def arms_of(columns: Mapping[str, Array]) -> list[int]:
    """Numbers of the arms, starting from 1."""
    return sorted(int(name[2:]) for name in columns if name[:2] == "fn" and name[2:].isdigit())


def body_curves(columns: Mapping[str, Array], kinds: Mapping[str, str]) -> list[tuple[str, Array]]:
    """Curves of the forces on the main body, if it touched anything.

    Args:
        columns: Columns of a trajectory.
        kinds: ``fn``, ``ff`` or both, with the names of their curves.
    """
    if not np.any(columns.get("fn_body", np.zeros(1)) > 0.0):
        return []
    return [(label, columns[f"{kind}_body"]) for kind, label in kinds.items()]


def contacts(columns: Mapping[str, Array]) -> list[tuple[float, float]]:
    """Time intervals with contact [s]."""
    t = columns["t"]
    touching = np.zeros(len(t) + 2, dtype=int)
    for name in columns:
        if name.startswith("fn"):
            touching[1:-1] |= columns[name] > 0.0
    starts, ends = (np.flatnonzero(np.diff(touching) == change) for change in (1, -1))
    last = len(t) - 1
    return [(float(t[i]), float(t[min(int(k), last)])) for i, k in zip(starts, ends, strict=True)]


def alike(what: str, curves: list[tuple[int, Array]]) -> list[tuple[str, Array]]:
    """Curves of arms, equal ones merged, so that no curve hides behind another."""
    groups: list[tuple[list[int], Array]] = []
    for arm, values in curves:
        scale = 1e-6 * float(np.max(np.abs(values), initial=0.0))
        twin = next((g for g in groups if np.allclose(g[1], values, rtol=0.0, atol=scale)), None)
        if twin is None:
            groups.append(([arm], values))
        else:
            twin[0].append(arm)
    return [(f"{what} {', '.join(map(str, names))}", values) for names, values in groups]


def short(name: str, most: int = 24) -> str:
    """Name shortened to fit into a legend."""
    return name if len(name) <= most else name[: most - 1] + "…"


def hinge_curves(flight: Flight) -> list[tuple[str, Curves]]:
    """Labels of panels and their curves: angles and torques of arms; none where none can turn.

    Args:
        flight: With its trajectory.
    """
    if not has_hinges(flight.scenario.vehicle):
        return []
    found = hinge_histories(flight)
    panels = []
    for joint, name in {1: "Hinge", 2: "2nd hinge"}.items():
        own = [one for one in found if one.joint == joint]
        if own:
            angles = alike("arm", [(one.arm, np.degrees(one.angle)) for one in own])
            torques = alike("arm", [(one.arm, one.torque) for one in own])
            panels += [(f"{name} [deg]", angles), (f"{name} [N m]", torques)]
    return panels
