"""The commands ``springback identify ...``: recordings of real flights."""
