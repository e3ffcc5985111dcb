"""Settings of the whole suite."""

from __future__ import annotations

from hypothesis import settings

# Property tests draw the same examples on every machine, and the first call of a function may be slow.
settings.register_profile("suite", deadline=None, derandomize=True, max_examples=100)
settings.load_profile("suite")
