"""An entry point and a part of it, compiled by two processes at once.

The compiler holds one core, and compiles what an entry point calls one after the other.  Where two
parts of about the same length do not need each other, such as the physics and the avionics of a
flight with a pilot, a second process compiles one of them meanwhile.  The cache has a lock for each
kernel (`springback.kernels.kernel_cache`): this process waits for what the other is compiling,
reads it from its file, and compiles it by itself should the other have failed.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numba

from springback.errors import InputError
from springback.kernels.compiler import compile_uncached, is_in_cache

#: Most processes that compile at once: 1 for this one alone.
VARIABLE = "SPRINGBACK_COMPILERS"
#: Held by the thread that compiles: others wait, and find all in the cache.
_ONE_THREAD = threading.Lock()
_PROGRAM = f"from {__name__} import compile_request; compile_request()"


#: A function and the arguments with which it will be called.
Call = tuple[Any, tuple[Any, ...]]


def compile_with_help(entries: Sequence[Call], part: Call) -> None:
    """Compile entry points while another process compiles a part, unless all are cached.

    Args:
        entries: Executors of the package, in the order in which they are compiled here.
        part: Function in a module which calls some of what they call, or them in another order.

    Raises:
        InputError: If the environment says how many processes compile, and that is no number.
    """
    wanted = [(entry, tuple(map(entry.typeof_pyval, given))) for entry, given in entries]
    with _ONE_THREAD:
        missing = [call for call in wanted if not is_in_cache(*call)]
        if not missing or not _may_have_help():
            return
        with _compiled_elsewhere(part[0], tuple(map(numba.typeof, part[1]))):
            for entry, signature in missing:
                entry.compile(signature)


@contextmanager
def compiled_meanwhile(part: Callable[..., None], arguments: tuple[Any, ...]) -> Iterator[None]:
    """Context in which another process compiles what a function calls, if it may have help.

    Args:
        part: Function in a module, which calls entry points.
        arguments: With which it would be called.

    Raises:
        InputError: If the environment says how many processes compile, and that is no number.
    """
    if not _may_have_help():
        yield
        return
    with _compiled_elsewhere(part, tuple(map(numba.typeof, arguments))):
        yield


def _may_have_help() -> bool:
    """True if this process is not one of several that compile, and may use two cores."""
    given = os.environ.get(VARIABLE, "2")
    if not given.isdecimal() or int(given) < 1:
        raise InputError(f"{VARIABLE}: must be a number of processes, at least 1 (got {given!r})")
    free = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    alone = multiprocessing.parent_process() is None
    return alone and bool(sys.executable) and min(int(given), free or 1) > 1


@contextmanager
def _compiled_elsewhere(part: Callable[..., None], signature: Any) -> Iterator[None]:
    """Context in which another process compiles a function; it is ended with the context."""
    package = str(Path(__file__).parents[3])
    folders = [package, *filter(None, [os.environ.get("PYTHONPATH")])]
    helper = subprocess.Popen(
        [sys.executable, "-c", _PROGRAM],
        stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(folders), VARIABLE: "1"},
    )  # fmt: skip
    try:
        assert helper.stdin is not None
        with suppress(OSError), helper.stdin:  # it has ended: all is compiled here
            pickle.dump((part.__module__, part.__qualname__, signature), helper.stdin)
        yield
    finally:
        helper.kill()  # a file of the cache is written whole or not at all
        helper.wait()


def compile_request() -> None:
    """Compile what another process asks for on standard input; what is called is cached."""
    module, name, signature = pickle.load(sys.stdin.buffer)
    compile_uncached(getattr(importlib.import_module(module), name), signature)
