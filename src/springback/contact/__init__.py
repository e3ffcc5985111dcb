"""What it hits: surfaces, obstacles, and the cages that touch them."""
