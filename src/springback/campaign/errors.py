"""A campaign that came to a halt through no fault of its plan."""

from __future__ import annotations


class CampaignError(RuntimeError):
    """What halted a campaign, in one line; what was done by then is kept."""
