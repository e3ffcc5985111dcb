"""Threads of worker processes."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator

#: Numbers of threads of the libraries of linear algebra.
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


@contextlib.contextmanager
def single_threads() -> Iterator[None]:
    """Processes that are spawned within use one thread for linear algebra.

    The cores are full of other workers; with more threads, small matrices wait for each other.
    """
    before = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
