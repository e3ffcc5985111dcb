"""Studies of what a robot makes of its collisions."""
