"""Two processes compile one flight: each kernel is compiled once, and nothing hangs on the other."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numba
import pytest

from builders import nested_entries
from springback.errors import InputError
from springback.kernels.concurrent import compilation
from springback.kernels.concurrent.compilation import compile_with_help

TESTS = Path(__file__).parents[1]
#: An entry point, and the part of it with which another process is to help.
CALLS = [(nested_entries.tripled_and_one, (2.0,))], (nested_entries.only_tripled, (2.0,))
#: In a process of its own, with an empty cache: waits until the other one has compiled its part.
PROGRAM = """
import time, numba
from builders.nested_entries import only_tripled, tripled, tripled_and_one
from springback.kernels.compiler import is_in_cache
from springback.kernels.concurrent.compilation import _compiled_elsewhere
types = (numba.float64,)
with _compiled_elsewhere(only_tripled, types):
    until = time.monotonic() + 100.0
    while not is_in_cache(tripled, types) and time.monotonic() < until:
        time.sleep(0.05)
    tripled_and_one.compile(types)
assert tripled_and_one(2.0) == 7.0
print(sum(tripled.stats.cache_hits.values()), sum(tripled.stats.cache_misses.values()))
"""


def test_what_another_process_compiles_is_not_compiled_here(tmp_path: Path) -> None:
    folders = os.pathsep.join([str(TESTS), os.environ.get("PYTHONPATH", "")])
    given = {**os.environ, "SPRINGBACK_CACHE_DIR": str(tmp_path), "PYTHONPATH": folders}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], env=given, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["1", "0"]


def started(monkeypatch: pytest.MonkeyPatch, program: str) -> list[subprocess.Popen[bytes]]:
    """Processes that `compile_with_help` will have started; they run another program."""
    processes: list[subprocess.Popen[bytes]] = []

    class Kept(subprocess.Popen):  # type: ignore[type-arg]
        def __init__(self, command: list[str], **given: object) -> None:
            super().__init__([*command[:-1], program], **given)  # type: ignore[call-overload]
            processes.append(self)

    monkeypatch.setattr(compilation.subprocess, "Popen", Kept)
    monkeypatch.setattr(compilation, "is_in_cache", lambda *_: False)
    monkeypatch.setattr(compilation, "_may_have_help", lambda: True)
    return processes


@pytest.mark.parametrize("program", ["raise SystemExit(3)", "import time; time.sleep(600)"])
def test_a_helper_that_fails_or_hangs_is_done_without(
    monkeypatch: pytest.MonkeyPatch, program: str
) -> None:
    """And it has ended when the entry point is compiled."""
    processes = started(monkeypatch, program)
    compile_with_help(*CALLS)
    assert nested_entries.tripled_and_one(2.0) == 7.0
    [helper] = processes
    assert helper.returncode is not None


def test_what_is_compiled_needs_no_help(monkeypatch: pytest.MonkeyPatch) -> None:
    nested_entries.tripled_and_one.compile((numba.float64,))
    monkeypatch.setattr(compilation, "_compiled_elsewhere", pytest.fail)
    compile_with_help(*CALLS)


def test_one_process_alone_compiles_where_so_set(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilation, "is_in_cache", lambda *_: False)
    monkeypatch.setattr(compilation, "_compiled_elsewhere", pytest.fail)
    monkeypatch.setenv("SPRINGBACK_COMPILERS", "1")
    compile_with_help(*CALLS)


@pytest.mark.parametrize("given", ["0", "-1", "two", ""])
def test_a_number_of_processes_that_is_none_is_refused(
    monkeypatch: pytest.MonkeyPatch, given: str
) -> None:
    monkeypatch.setenv("SPRINGBACK_COMPILERS", given)
    monkeypatch.setattr(compilation, "is_in_cache", lambda *_: False)
    with pytest.raises(InputError, match="SPRINGBACK_COMPILERS: must be a number of processes"):
        compile_with_help(*CALLS)
