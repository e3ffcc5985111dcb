"""Worker processes: their threads for linear algebra, and their end."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import threading
from collections.abc import Iterator
from multiprocessing.connection import wait

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


def own_threads() -> int:
    """Threads that this process may use: one if it is a worker, else as many as cores are free."""
    if multiprocessing.parent_process() is not None:
        return 1
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return cores or 1


def end_with_parent() -> None:
    """End this worker process as soon as the process that started it has ended, however it did.

    A worker of a pool whose parent was killed would otherwise wait for work for ever, with all its
    memory.
    """
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
