"""Obstacles of measured or drawn form: height maps, meshes and occupancy grids, and their files."""
