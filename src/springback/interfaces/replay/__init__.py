"""A flight as a scene, and its replay."""
