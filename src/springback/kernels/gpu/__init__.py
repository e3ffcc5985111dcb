"""The same kernels on NVIDIA GPUs."""
