"""Obstacles that move: prescribed, free, hanging, hinged, or as parts of a second vehicle."""
