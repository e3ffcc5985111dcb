"""Error of a campaign that stops for reasons other than its plan."""

from __future__ import annotations


class CampaignError(RuntimeError):
    """Reason why a campaign stopped, in one line; completed parts are stored."""
