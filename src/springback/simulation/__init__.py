"""Let it happen: the hybrid flight, step by step, and what is remembered of it."""
