"""Arms in the equations of motion."""
