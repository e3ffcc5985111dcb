"""Two vehicles in one world that can hit each other."""
