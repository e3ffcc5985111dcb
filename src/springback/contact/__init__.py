"""Contact: surfaces, obstacles, and the cages that touch them."""
