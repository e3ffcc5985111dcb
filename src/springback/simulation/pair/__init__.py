"""Two vehicles in one world, that can strike each other."""
