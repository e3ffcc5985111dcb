"""Figures in the Python interface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from springback.campaign.access import Campaign
from springback.campaign.analysis.distribution import distribution
from springback.campaign.analysis.marginals import SUCCESS, field_map, marginal
from springback.campaign.analysis.worst_case import worst_case, worst_case_map
from springback.errors import InputError
from springback.extras import needs
from springback.results.flight import Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure


#: Size of a figure of one panel [in].
ALONE = (4.8, 3.4)


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
        flight: Flight with a trajectory.
        columns: Columns to draw, as for `springback.Flight.plot`; by default position, velocity,
            acceleration, arms and forces, in a figure of one size.
        width: As for `springback.Flight.plot`.
        height: As for `springback.Flight.plot`.
        window: As for `springback.Flight.plot`.

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


def plot_campaign(
    campaign: Campaign,
    measure: str = SUCCESS,
    by: str | tuple[str, str] | None = None,
    *,
    limits: Sequence[str] = (),
    share: float | None = None,
) -> Figure:
    """Figure of a measure over a campaign: `springback.Campaign.plot`."""
    needs("matplotlib", "plot")
    from springback.interfaces.figures.campaign import field_map_figure, marginals_figure
    from springback.interfaces.figures.measures import distribution_figure

    if limits or share is not None:
        from springback.interfaces.figures.worst_case import (
            worst_case_figure,
            worst_case_map_figure,
        )

        own = None if measure == SUCCESS else measure
        whole = 1.0 if share is None else share
        if by is None or (not isinstance(by, str) and (len(by) != 2 or not limits)):
            raise InputError("by: a limit needs the name of a field, or two; a share alone one")
        if not isinstance(by, str):
            return worst_case_map_figure(worst_case_map(campaign, by, limits, share=whole))
        return worst_case_figure(worst_case(campaign, by, limits, measure=own, share=whole))
    if by is None:
        if measure == SUCCESS:
            raise InputError("by: name the field, or two, over which success is drawn")
        return distribution_figure(distribution(campaign, measure))
    if isinstance(by, str):
        figure = marginals_figure([marginal(campaign, by, measure=measure)])
        figure.set_size_inches(*ALONE)  # its panel is small, as one of many
        return figure
    if len(by) != 2:
        raise InputError(f"by: must be the name of a field, or two (got {len(by)})")
    return field_map_figure(field_map(campaign, *by, measure=measure))
