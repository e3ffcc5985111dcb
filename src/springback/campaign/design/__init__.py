"""The design of a campaign: its plan, laid out flight by flight."""
