"""How kernels are compiled: the passes, and what they leave out."""
