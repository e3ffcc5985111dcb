"""A measure of a campaign in detail: distribution, over each field, sensitivity."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.campaign.access import Campaign
from springback.campaign.analysis.distribution import MeasureDistribution, distribution
from springback.campaign.analysis.marginals import SUCCESS, Marginal, fields_of, marginal
from springback.campaign.analysis.sensitivity import Sensitivity, sensitivity


class MeasureReport(NamedTuple):
    """A measure, or success: its distribution, marginals and sensitivity."""

    distribution: MeasureDistribution | None
    """None for success."""
    marginals: tuple[Marginal, ...]
    sensitivity: Sensitivity

    @property
    def name(self) -> str:
        """Name of the column."""
        return self.sensitivity.measure.name

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        own = self.distribution.as_dict() if self.distribution else {}
        along = [one.as_dict() for one in self.marginals]
        return {**own, "marginals": along, "sensitivity": self.sensitivity.as_dict()}


def measure_report(
    campaign: Campaign, name: str = SUCCESS, *, scatter: bool = False
) -> MeasureReport:
    """A measure over all flights, and over each field.

    Args:
        campaign: Any.
        name: Name of the measure's column.
        scatter: Include the scattered parameters.

    Raises:
        InputError: If there is no such measure, or no flight has it.
    """
    fields = [field for field in fields_of(campaign, scatter=scatter) if field != name]
    return MeasureReport(
        None if name == SUCCESS else distribution(campaign, name),
        tuple(marginal(campaign, field, measure=name) for field in fields),
        sensitivity(campaign, name, fields),
    )
