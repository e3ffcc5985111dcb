"""Evaluation of a campaign: intervals, marginals and statistics."""
