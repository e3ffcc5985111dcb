"""Kernels on disk: read only where they are whole and one's own, and never in the way."""

from __future__ import annotations

import errno
import os
import pickle
import subprocess
import sys
import time
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from filelock import FileLock

from builders.missing import needs
from springback.errors import CacheWarning
from springback.kernels import compiler, kernel_cache
from springback.kernels.compiler import STRICT, _entry
from springback.kernels.frozen import frozen_digest
from springback.kernels.gpu import ptx
from springback.kernels.gpu.private_memory import array_view


def doubled(x: float) -> float:
    return 2.0 * x


@pytest.fixture(autouse=True)
def _unsaid() -> None:
    kernel_cache._said.clear()


def started(folder: Path, function: Any = doubled) -> Any:
    """The entry point of a new process."""
    return _entry(function, folder, STRICT)


def loaded(entry: Any) -> bool:
    """Whether it flew with a kept kernel."""
    return bool(sum(entry.stats.cache_hits.values()))


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """The file of a kept kernel."""
    assert started(tmp_path)(1.5) == 3.0
    [path] = tmp_path.glob("*.kernel")
    return path


def test_a_kept_kernel_is_loaded_also_where_nothing_can_be_written(kept: Path) -> None:
    kept.parent.chmod(0o500)
    again = started(kept.parent)
    assert again(1.5) == 3.0
    assert loaded(again)
    kept.parent.chmod(0o700)


def harm(kept: Path, how: str) -> None:
    data = bytearray(kept.read_bytes())
    if how == "empty":
        kept.write_bytes(b"")
    elif how == "cut off":
        kept.write_bytes(data[: len(data) // 2])
    elif how == "garbage":
        kept.write_bytes(os.urandom(len(data)))
    elif how == "one bit of code":
        data[len(data) // 2] ^= 1
        kept.write_bytes(data)
    elif how == "one bit of the digest":
        data[3] ^= 1
        kept.write_bytes(data)
    elif how == "writable by others":
        kept.chmod(0o666)
    elif how == "of another user":
        os.chown(kept, 65534, 65534)
    elif how == "a folder in the way":
        kept.unlink()
        kept.mkdir()
    elif how == "a link":
        kept.rename(kept.with_name("elsewhere"))
        kept.symlink_to(kept.with_name("elsewhere"))
    else:
        raise ValueError(how)


STATES = (
    "empty", "cut off", "garbage", "one bit of code", "one bit of the digest", "writable by others",
    pytest.param("of another user", marks=needs("root")), "a folder in the way", "a link",
)  # fmt: skip


@pytest.mark.parametrize("how", STATES)
def test_a_kernel_that_cannot_be_believed_is_left_aside_and_said(kept: Path, how: str) -> None:
    harm(kept, how)
    again = started(kept.parent)
    with pytest.warns(CacheWarning) as told:
        assert again(1.5) == 3.0
    assert not loaded(again)
    assert "ignored" in str(told[0].message)
    assert "\n" not in str(told[0].message)
    if how != "a folder in the way":  # which stays, and is said again at every start
        mended = started(kept.parent)
        assert mended(1.5) == 3.0
        assert loaded(mended)


def test_a_pickle_of_somebody_elses_does_not_run(kept: Path, tmp_path: Path) -> None:
    """The digest is no secret; what protects is who may write."""

    class Evil:
        def __reduce__(self) -> tuple[Any, ...]:
            return os.mkdir, (str(tmp_path / "pwned"),)

    data = pickle.dumps((Evil(), ()))
    kept.write_bytes(kernel_cache.hashlib.sha256(data).digest() + data)
    kept.chmod(0o622)
    with pytest.warns(CacheWarning, match="other users can write to it"):
        assert started(tmp_path)(1.5) == 3.0
    assert not (tmp_path / "pwned").exists()


@pytest.mark.parametrize("why", ["full", "in the way", "missing home"])
def test_a_folder_that_takes_no_kernels_is_said_and_flies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, why: str
) -> None:
    folder = tmp_path / "kernels"
    if why == "full":

        def full(*_: Any) -> None:
            raise OSError(errno.ENOSPC, "No space left on device")

        monkeypatch.setattr(kernel_cache.os, "replace", full)
    elif why == "in the way":
        folder.write_text("a file")
    else:
        folder = Path("/dev/null/.cache/springback")
    with pytest.warns(CacheWarning, match="SPRINGBACK_CACHE_DIR") as told:
        assert started(folder)(1.5) == 3.0
    assert len([one for one in told if "cannot be cached" in str(one.message)]) == 1
    assert not [path for path in tmp_path.rglob("*") if path.name.endswith(".draft")]


def test_kernels_of_other_types_stay_apart_and_both_are_kept(tmp_path: Path) -> None:
    first = started(tmp_path)
    assert (first(1.5), first(3)) == (3.0, 6.0)
    again = started(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert (again(1.5), again(3)) == (3.0, 6.0)
    assert sum(again.stats.cache_hits.values()) == 2
    assert len(list(tmp_path.glob("*.kernel"))) == 2


def test_a_kernel_under_anothers_name_is_not_taken_for_it(tmp_path: Path) -> None:
    entry = started(tmp_path)
    entry(1.5)
    [of_float] = tmp_path.glob("*.kernel")
    entry(3)
    [of_int] = set(tmp_path.glob("*.kernel")) - {of_float}
    of_float.write_bytes(of_int.read_bytes())
    again = started(tmp_path)
    assert again(1.5) == 3.0
    assert not loaded(again)


# -- one process compiles, others wait ------------------------------------------------------------

#: Compiles an entry point once all processes are ready, and says whether it was kept already; the
#: compiler takes a second longer than it would.
WAITING = """
import sys, time
from pathlib import Path
from springback.kernels.compiler import STRICT, _entry
def halved(x):
    return 0.5 * x
folder, me, others = Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
entry = _entry(halved, folder / "kernels", STRICT)
compiling = entry._compiler.compile
def slowly(*signature):
    (folder / f"{me} compiles").touch()
    time.sleep(float(sys.stdin.readline()))
    return compiling(*signature)
entry._compiler.compile = slowly
(folder / me).touch()
while not all((folder / other).exists() for other in others):
    time.sleep(0.005)
assert entry(3.0) == 1.5
print(sum(entry.stats.cache_hits.values()), sum(entry.stats.cache_misses.values()))
"""


def waiting(folder: Path, me: str, *others: str, takes: float = 1.0) -> subprocess.Popen[str]:
    done = subprocess.Popen(
        [sys.executable, "-c", WAITING, str(folder), me, *others],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    assert done.stdin is not None
    done.stdin.write(f"{takes}\n")
    done.stdin.flush()
    return done


def test_of_two_processes_that_need_a_kernel_one_compiles_it(tmp_path: Path) -> None:
    """Was: both did, side by side."""
    both = [waiting(tmp_path, "a", "b"), waiting(tmp_path, "b", "a")]
    assert sorted(one.communicate(timeout=100)[0] for one in both) == ["0 1\n", "1 0\n"]
    assert len(list(tmp_path.glob("* compiles"))) == 1


def test_a_process_that_is_killed_while_it_compiles_holds_no_one_up(tmp_path: Path) -> None:
    killed = waiting(tmp_path, "a", takes=1000.0)
    while not (tmp_path / "a compiles").exists():
        assert killed.poll() is None
        time.sleep(0.01)
    second = waiting(tmp_path, "b", takes=0.0)
    time.sleep(0.5)
    killed.kill()
    killed.communicate()
    assert second.communicate(timeout=100)[0] == "0 1\n"


def test_a_kernel_that_cannot_be_compiled_is_not_left_locked(tmp_path: Path) -> None:
    def nonsense(x: float) -> Any:
        return x.no_such_thing  # type: ignore[attr-defined]

    entry = started(tmp_path, nonsense)
    for _ in range(2):
        with pytest.raises(compiler.CompilerError):
            entry(1.5)
    [lock] = tmp_path.glob(".*.lock")
    with FileLock(lock, timeout=0):
        assert entry._cache._locks == []


# -- kernels of a GPU, which need none to be written ----------------------------------------------


def scaled(data: Any, count: int, thread: int) -> None:
    values = array_view(data, 1, count)
    values[0, thread] = values[0, thread] * 2.5


def ptx_of(entry: Any) -> str:
    """PTX of an entry point, as a process that starts has it."""
    given = [ptx.parameter(np.zeros(1)), ptx.parameter(1)]
    return ptx.kernel_of(ptx.program(entry, given, dict), given).text


@pytest.fixture
def compiled_for_a_gpu(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> tuple[Path, list[str], str]:
    """Folder of what is kept, a list of what is compiled from here on, and what was."""
    monkeypatch.setenv("SPRINGBACK_CACHE_DIR", str(tmp_path))
    before = ptx_of(scaled)
    compiled: list[str] = []
    lower, optimise = ptx._bitcode, ptx._optimise
    monkeypatch.setattr(ptx, "_bitcode", lambda *a: (compiled.append("bc"), lower(*a))[1])
    monkeypatch.setattr(ptx, "_optimise", lambda *a: (compiled.append("ptx"), optimise(*a))[1])
    return compiler.cache_folder() / "ptx", compiled, before


@pytest.mark.parametrize("ending", ["bc", "ptx"])
@pytest.mark.parametrize("how", STATES)
def test_a_gpus_kernel_that_cannot_be_believed_is_left_aside_and_said(
    compiled_for_a_gpu: tuple[Path, list[str], str], ending: str, how: str
) -> None:
    """Was: whatever lay there was flown."""
    folder, compiled, before = compiled_for_a_gpu
    [file] = folder.glob(f"*.{ending}")
    harm(file, how)
    with pytest.warns(CacheWarning, match="ignored|cannot be cached") as told:
        assert ptx_of(scaled) == before
    assert "\n" not in str(told[0].message)
    assert compiled == [ending]
    if how != "a folder in the way":
        assert ptx_of(scaled) == before
        assert compiled == [ending]


def test_a_gpus_kernels_are_found_again_also_where_nothing_can_be_written(
    compiled_for_a_gpu: tuple[Path, list[str], str],
) -> None:
    folder, compiled, before = compiled_for_a_gpu
    folder.chmod(0o500)
    assert ptx_of(scaled) == before
    assert compiled == []
    folder.chmod(0o700)


def test_a_gpus_kernel_under_anothers_name_is_not_taken_for_it(
    compiled_for_a_gpu: tuple[Path, list[str], str], tmp_path: Path
) -> None:
    folder, _, before = compiled_for_a_gpu
    [file] = folder.glob("*.ptx")
    kernel_cache.save_program(tmp_path / "another.ptx", b"// another")
    file.write_bytes((tmp_path / "another.ptx").read_bytes())
    with pytest.warns(CacheWarning, match="it holds another key"):
        assert ptx_of(scaled) == before


def test_a_gpus_kernels_that_cannot_be_kept_are_said_and_fly(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("SPRINGBACK_CACHE_DIR", "/dev/null")
    with pytest.warns(CacheWarning, match="cannot be cached"), ptx.one_at_a_time():
        assert ".entry scaled" in ptx_of(scaled)


# -- what is frozen into a user's kernels ---------------------------------------------------------

GAIN, TABLE, NAMES = 5.0, np.array([1.0, 2.0]), ("a", "b")


class Pair(NamedTuple):
    k: float
    c: float = 2.0


def helper(x: float) -> float:
    return GAIN * x


def law(x: float) -> float:
    return helper(x) + TABLE[0] + len(NAMES) + Pair(1.0).c + np.pi


def values(**changed: Any) -> str | None:
    before = {name: globals()[name] for name in changed}
    globals().update(changed)
    try:
        return frozen_digest([law])
    finally:
        globals().update(before)


def test_the_digest_follows_every_value_the_code_takes_from_outside() -> None:
    told = {
        values(), values(GAIN=1.0), values(TABLE=np.array([1.0, 2.5])), values(NAMES=("a", "c")),
        values(GAIN=-5.0), values(GAIN=np.float32(5.0)), values(helper=lambda x: 5.0 * x),
    }  # fmt: skip
    assert len(told) == 7
    assert None not in told
    assert values() == values(GAIN=5.0)


def test_what_no_digest_can_stand_for_is_not_kept() -> None:
    assert values(GAIN=object()) is None
    assert values(TABLE=np.array([object()])) is None


def test_values_of_modules_elsewhere_and_closures_count(monkeypatch: pytest.MonkeyPatch) -> None:
    import types

    module = types.ModuleType("gains")
    monkeypatch.setitem(globals(), "gains", module)

    def made(k: float) -> Any:
        def scaled(x: float) -> float:
            return k * x * gains.k  # noqa: F821

        return scaled

    told = set()
    for k, mine in ((1.0, 1.0), (2.0, 1.0), (1.0, 3.0)):
        module.k = k
        told.add(frozen_digest([made(mine)]))
    assert len(told) == 3


SCRIPT = """
import importlib.util, sys, json
spec = importlib.util.spec_from_file_location(sys.argv[1], sys.argv[2])
module = importlib.util.module_from_spec(spec)
sys.modules[sys.argv[1]] = module
spec.loader.exec_module(module)
from springback.kernels.compiler import user_executor
from springback.simulation.flight import sources
entry = user_executor(module.entry, sources({module.Spring}))
print(json.dumps([entry(module.Spring(1.0)), sum(entry.stats.cache_hits.values())]))
"""
MODULE = """
import json, pathlib
from typing import NamedTuple
from springback import Vec, kernel
from springback.contact.obstacles import signed_distance
K = json.loads(pathlib.Path(__file__).with_name("gains.json").read_text())["k"]
class Spring(NamedTuple):
    x: float
@signed_distance.register(Spring)
@kernel
def _(spring: Spring, point: Vec) -> float:
    return K * spring.x
def entry(spring):
    return signed_distance(spring, Vec(0.0, 0.0, 0.0))
"""


def test_own_kernels_follow_names_and_gains(tmp_path: Path) -> None:
    """One cache, a file imported under two names, then with other gains beside it."""
    (tmp_path / "own_law.py").write_text(MODULE)
    os.utime(tmp_path / "own_law.py", (1e9, 1e9))
    environment = {**os.environ, "SPRINGBACK_CACHE_DIR": str(tmp_path / "cache")}

    def run(name: str, k: float) -> list[float]:
        (tmp_path / "gains.json").write_text(f'{{"k": {k}}}')
        words = [sys.executable, "-W", "error", "-c", SCRIPT, name, str(tmp_path / "own_law.py")]
        done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        found: list[float] = __import__("json").loads(done.stdout)
        return found

    assert run("springback_pilot_0123_own_law", 5.0) == [5.0, 0]
    assert run("own_law", 5.0) == [5.0, 0]  # was ModuleNotFoundError
    assert run("own_law", 1.0) == [1.0, 0]  # was 5.0
    assert run("own_law", 5.0) == [5.0, 1]
