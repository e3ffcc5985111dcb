"""Figures in the Python interface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from springback.extras import needs
from springback.results.flight import Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot(
    flight: Flight,
    columns: str | Sequence[str | Sequence[str]] | None = None,
    *,
    width: float | str = "one column",
    height: float | str | None = None,
    window: tuple[float, float] | None = None,
) -> Figure:
    """Figure of a flight over time.

    Args:
        flight: With a trajectory.
        columns: Columns to draw, as for `springback.Flight.plot`; by default position, velocity,
            acceleration, arms and forces, in a figure of one size.
        width: As there.
        height: As there.
        window: As there.

    Raises:
        InputError: If matplotlib is not installed, the flight has no trajectory, or an argument is
            invalid.
    """
    flight.need_trajectory()
    needs("matplotlib", "plot")
    if columns is None:
        from springback.interfaces.figures.flight import flight_figure

        return flight_figure(flight)
    from springback.interfaces.figures.columns import columns_figure

    return columns_figure(flight, columns, width=width, height=height, window=window)
