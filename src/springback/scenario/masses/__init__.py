"""Mass and inertia of a main body from a model of another program."""
