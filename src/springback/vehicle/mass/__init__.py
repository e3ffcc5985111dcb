"""Mass and inertia of a main body from its parts."""
