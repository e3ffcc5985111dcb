"""Laws of contact surfaces: restitution, and friction at rest by bristles."""
