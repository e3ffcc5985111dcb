"""The compute core: one scalar source for several executors."""
