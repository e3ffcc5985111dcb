"""The compute core: one scalar source, several executors."""
