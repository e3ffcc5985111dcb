"""What a campaign found: intervals, marginals and statistics."""
