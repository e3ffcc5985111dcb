"""Design of tests: which impact to fly next, and whether intervals cover."""
