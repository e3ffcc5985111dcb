"""Kernels that came with the package: used where all fits, else compiled as if there were none."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numba
import pytest

from builders.missing import needs
from springback.errors import CacheWarning
from springback.kernels import kernel_cache
from springback.kernels.compiler import (
    STRICT,
    _entry,
    compiler_target,
    is_in_cache,
    packaged_kinds,
)
from springback.kernels.packaged import manifest
from springback.kernels.packaged.manifest import (
    MANIFEST,
    VARIABLE,
    PackagedKernels,
    compiler_versions,
    packaged_kernels,
    status_text,
    write_manifest,
)

SOURCE = "0123456789abcdef"
NEEDS = tuple(one[1:] for one in compiler_target()[2].split(",") if one[:1] == "+")[:3]


def doubled(x: float) -> float:
    return 2.0 * x


@pytest.fixture
def level(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[PackagedKernels]:
    """One packaged kernel, which fits."""
    kernel_cache._said.clear()
    folder = tmp_path / "packaged" / "level"
    assert _entry(doubled, tmp_path / "built", STRICT)(1.5) == 3.0
    [path] = (tmp_path / "built").glob("*.kernel")
    kernel_cache.pack_kernel(path, folder)
    given = PackagedKernels(
        folder, compiler_target(), NEEDS, SOURCE, compiler_versions(), ("a kind",)
    )
    write_manifest(given)
    monkeypatch.setattr(manifest, "FOLDER", tmp_path / "packaged")
    monkeypatch.delenv(VARIABLE, raising=False)
    packaged_kernels.cache_clear()
    yield given
    packaged_kernels.cache_clear()


def rewritten(level: PackagedKernels, **changes: Any) -> None:
    write_manifest(level._replace(**changes))
    packaged_kernels.cache_clear()


def flown(tmp_path: Path) -> tuple[bool, int]:
    """Of a new process: whether it loaded the kernel, and how many are in its own folder."""
    own = tmp_path / "own"
    entry = _entry(doubled, own, STRICT, SOURCE)
    assert entry(1.5) == 3.0
    return bool(sum(entry.stats.cache_hits.values())), len(list(own.glob("*.kernel")))


def test_a_packaged_kernel_is_loaded_and_nothing_written(
    tmp_path: Path, level: PackagedKernels
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert flown(tmp_path) == (True, 0)
    assert not (tmp_path / "own").exists()
    assert status_text(SOURCE, compiler_target()) == f"1 for {level.target[1]}, used"


def test_no_second_process_is_started_for_what_is_packaged(
    tmp_path: Path, level: PackagedKernels
) -> None:
    """A flight with a pilot has two processes compile it, unless it need not be compiled."""
    entry, types = _entry(doubled, tmp_path / "own", STRICT, SOURCE), (numba.float64,)
    assert is_in_cache(entry, types)
    rewritten(level, source="another")
    assert not is_in_cache(entry, types)


def test_ones_own_kernel_comes_first(tmp_path: Path, level: PackagedKernels) -> None:
    [path] = level.folder.glob("*.kernel")
    (tmp_path / "built").rename(tmp_path / "own")
    path.write_bytes(b"damaged, and not looked at")
    assert flown(tmp_path) == (True, 1)


TRIPLE, NAME, FEATURES = compiler_target()
MISFITS = {
    "another source": ({"source": "another"}, "compiled from another source"),
    "another numba": (
        {"versions": compiler_versions() | {"numba": "0.0.1"}},
        f"compiled with numba 0.0.1, this is {compiler_versions()['numba']}",
    ),
    "another option": (
        {"versions": compiler_versions() | {"option OPT": "9"}}, "with option OPT 9, this is 3",
    ),
    "a version more": ({"versions": compiler_versions() | {"libm": "9"}}, "libm 9, this is unknown"),
    "another system": (
        {"target": ("sparc-sun-solaris", NAME, FEATURES)}, "compiled for sparc-sun-solaris",
    ),
    "a greater processor": (
        {"target": (TRIPLE, "greater", ""), "needs": (*NEEDS, "avx4096")},
        "greater: this processor lacks avx4096",
    ),
}  # fmt: skip


@pytest.mark.parametrize("why", MISFITS)
def test_what_does_not_fit_is_compiled_as_if_it_were_not_there(
    tmp_path: Path, level: PackagedKernels, why: str
) -> None:
    changes, words = MISFITS[why]
    rewritten(level, **changes)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert flown(tmp_path) == (False, 1)
    text = status_text(SOURCE, compiler_target())
    assert text.startswith("not used: ")
    assert words in text


@pytest.mark.parametrize("how", ["switched off", "no manifest", "a damaged manifest", "no kernel"])
def test_without_them_kernels_are_compiled(
    tmp_path: Path, level: PackagedKernels, how: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if how == "switched off":
        monkeypatch.setenv(VARIABLE, "0")
    elif how == "no manifest":
        (level.folder / MANIFEST).unlink()
    elif how == "a damaged manifest":
        content = json.loads((level.folder / MANIFEST).read_text())
        (level.folder / MANIFEST).write_text(json.dumps(content | {"target": [1, 2]}))
    else:
        next(level.folder.glob("*.kernel")).unlink()
    packaged_kernels.cache_clear()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert flown(tmp_path) == (False, 1)
    expected = {"switched off": f"not used: {VARIABLE} is 0", "no kernel": f"0 for {NAME}, used"}
    told = status_text(SOURCE, compiler_target())
    assert told == expected.get(how, "none in this installation")


def test_kinds_are_those_of_the_kernels_that_fit(
    level: PackagedKernels, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("springback.kernels.compiler.source_digest", lambda: SOURCE)
    assert packaged_kinds() == ("a kind",)
    rewritten(level, source="another")
    assert packaged_kinds() == ()


def test_of_several_levels_the_greatest_that_fits_is_used(
    tmp_path: Path, level: PackagedKernels
) -> None:
    """It has more features; that a greater one is there, too, does not matter."""
    for name, features in {"least": (), "too great": (*NEEDS, "avx4096")}.items():
        folder = tmp_path / "packaged" / name
        folder.mkdir()
        write_manifest(level._replace(folder=folder, needs=features, target=(TRIPLE, name, "")))
    packaged_kernels.cache_clear()
    assert [one.target[1] for one in packaged_kernels()] == ["too great", NAME, "least"]
    assert flown(tmp_path) == (True, 0)


HARMS = (
    "cut off", "one bit of code", pytest.param("of another user", marks=needs("root")), "by others",
)  # fmt: skip


@pytest.mark.parametrize("how", HARMS)
def test_a_packaged_kernel_that_cannot_be_believed_is_said_and_compiled(
    tmp_path: Path, level: PackagedKernels, how: str
) -> None:
    [path] = level.folder.glob("*.kernel")
    data = bytearray(path.read_bytes())
    if how == "cut off":
        path.write_bytes(data[: len(data) // 2])
    elif how == "one bit of code":
        data[len(data) // 2] ^= 1
        path.write_bytes(data)
    elif how == "by others":
        path.chmod(0o646)
    else:
        os.chown(path, 65534, 65534)
    with pytest.warns(CacheWarning, match="ignored") as told:
        assert flown(tmp_path) == (False, 1)
    assert len(told) == 1
    assert "\n" not in str(told[0].message)
    assert flown(tmp_path) == (True, 1)  # its own


@needs("POSIX")
@pytest.mark.parametrize("mode", [0o664, 0o644])
def test_who_can_write_the_modules_may_write_kernels_and_no_one_else(
    tmp_path: Path, level: PackagedKernels, mode: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Many systems install with files that a user's own group can write."""
    module = tmp_path / "kernel_cache.py"
    module.touch()
    module.chmod(mode)
    monkeypatch.setattr(kernel_cache, "__file__", str(module))
    [path] = level.folder.glob("*.kernel")
    path.chmod(0o664)
    if mode == 0o664:
        assert flown(tmp_path) == (True, 0)
    else:
        with pytest.warns(CacheWarning, match="other users can write to it"):
            assert flown(tmp_path) == (False, 1)


def test_a_link_of_a_package_manager_is_followed(tmp_path: Path, level: PackagedKernels) -> None:
    [path] = level.folder.glob("*.kernel")
    path.rename(tmp_path / "stored")
    path.symlink_to(tmp_path / "stored")
    assert flown(tmp_path) == (True, 0)


def test_kernels_name_no_file_of_the_machine_that_compiled_them(level: PackagedKernels) -> None:
    [path] = (level.folder.parents[1] / "built").glob("*.kernel")
    assert str(Path(__file__).parent).encode() not in path.read_bytes()
