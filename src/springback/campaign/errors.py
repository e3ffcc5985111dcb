"""A campaign that came to a halt through no fault of its plan."""

from __future__ import annotations


class CampaignError(RuntimeError):
    """Reason why a campaign stopped, in one line; the flights done by then are kept."""
