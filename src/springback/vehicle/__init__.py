"""What flies: parameters, state, and the vehicles of the literature."""
