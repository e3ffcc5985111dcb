"""Dynamics: one set of equations for rigid and compliant vehicles, and the energy balance."""
