"""The same kernels on NVIDIA's GPUs."""
