"""The figure of a flight in the Python interface."""

from __future__ import annotations

from typing import TYPE_CHECKING

from springback.errors import InputError
from springback.extras import needs
from springback.results.flight import Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def plot(flight: Flight) -> Figure:
    """Figure of position, velocity, acceleration, arms and forces over time.

    Args:
        flight: With a trajectory.

    Raises:
        InputError: If matplotlib is not installed, or the flight has no trajectory.
    """
    if not flight.columns:
        raise InputError("this flight has no trajectory: fly it with trajectory=True")
    needs("matplotlib", "plot")
    from springback.interfaces.figures.flight import flight_figure

    return flight_figure(flight)
