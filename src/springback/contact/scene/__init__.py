"""Many solids as one obstacle: shapes, the tree that finds them, and the faces met."""
