"""Report on the paper: its numbers and ours."""
