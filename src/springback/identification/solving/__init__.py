"""Solving fits: least squares in lanes, starts, profiles, several impacts together."""
