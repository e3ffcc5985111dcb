"""The report on the paper: its numbers beside ours."""
