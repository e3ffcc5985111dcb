"""The impact lab: a page whose sliders fly collisions."""
