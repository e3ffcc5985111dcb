"""What vehicles touched, from recorded flights: forces, distances, obstacles by name."""
