"""Writers of simulated flights in the formats of other programs."""
