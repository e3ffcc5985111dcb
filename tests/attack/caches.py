"""States of the kernel cache and of HOME that a command may meet."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from attack.interrupting import EXAMPLES, command
from attack.table import Row


def caches(folder: Path) -> Row:
    """States of the kernel cache and of HOME, each met by `springback fly`."""
    scenario = folder / "s.toml"
    scenario.write_text((EXAMPLES / "arq_wall.toml").read_text())
    home = folder / "home"
    words = ["fly", "s.toml", "--out", "o", "--no-figures", "--force"]

    def flown(**environment: str) -> subprocess.CompletedProcess[str]:
        given = {**os.environ, "HOME": str(home), **environment}
        given = {name: value for name, value in given.items() if value != "unset"}
        given.setdefault("XDG_CACHE_HOME", "")
        return subprocess.run(
            command(*words), cwd=folder, env=given, capture_output=True, text=True, check=False,
            timeout=600,
        )  # fmt: skip

    home.mkdir()
    before = os.environ.pop("SPRINGBACK_CACHE_DIR", None)
    first = flown()
    assert first.returncode == 0, first.stderr
    kept = sorted(home.rglob("*.kernel"))
    original = {path: path.read_bytes() for path in kept}
    bad: list[str] = []
    count = 0

    def meet(name: str, **environment: str) -> None:
        nonlocal count
        count += 1
        done = flown(**environment)
        print(f"{name}: {done.returncode}", file=sys.stderr, flush=True)
        lines = [line for line in done.stderr.splitlines() if line]
        if done.returncode or done.stdout != first.stdout or "Traceback" in done.stderr:
            bad.append(name)
            print("cache", name, done.returncode, done.stderr[-400:])
        elif len([line for line in lines if line.startswith("warning")]) > len(kept) + 1:
            bad.append(name)
            print("cache", name, "says too much", lines)

    def mended() -> None:
        for path, data in original.items():
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)
            path.unlink(missing_ok=True)
            path.write_bytes(data)
            path.chmod(0o644)

    noise_stream = random.Random(3)
    harms: dict[str, Callable[[Path, bytes], Any]] = {
        "empty": lambda path, _: path.write_bytes(b""),
        "one byte": lambda path, _: path.write_bytes(b"\0"),
        "cut off": lambda path, data: path.write_bytes(data[: len(data) // 2]),
        "garbage": lambda path, data: path.write_bytes(noise_stream.randbytes(len(data))),
        "garbage at the end": lambda path, data: path.write_bytes(data[:-100] + bytes(100)),
        "a bit of the code": lambda path, data: path.write_bytes(
            data[: len(data) // 2] + bytes([data[len(data) // 2] ^ 1]) + data[len(data) // 2 + 1 :]
        ),
        "missing": lambda path, _: path.unlink(),
        "a folder": lambda path, _: (path.unlink(), path.mkdir()),
        "a dangling link": lambda path, _: (path.unlink(), path.symlink_to("nowhere")),
        "writable by all": lambda path, _: path.chmod(0o666),
    }  # fmt: skip
    if os.getuid() == 0:
        harms["another's"] = lambda path, _: os.chown(path, 65534, 65534)
    else:
        harms["not readable"] = lambda path, _: path.chmod(0)
    for name, harm in harms.items():
        for path, data in original.items():
            harm(path, data)
        meet(name)
        mended()
    folders = {"kernels": kept[0].parent.parent, "springback": kept[0].parents[2]}
    for name, path in folders.items():
        aside = path.with_name("aside")
        path.rename(aside)
        path.write_text("a file in the way")
        meet(f"a file in place of {name}")
        path.unlink()
        aside.rename(path)
    meet("a cache that is a device", SPRINGBACK_CACHE_DIR="/dev/null")
    meet("a cache with ~", SPRINGBACK_CACHE_DIR="~/other")
    meet("a cache with ~ of nobody", SPRINGBACK_CACHE_DIR=str(folder / "~nobody"))
    meet("an empty name of a cache", SPRINGBACK_CACHE_DIR="")
    meet("a cache that is full", SPRINGBACK_CACHE_DIR="/proc")
    for name, value in {
        "HOME missing": str(folder / "nohome"), "HOME a device": "/dev/null", "HOME unset": "unset",
        "HOME empty": "", "HOME a file": str(scenario), "HOME not writable": "/proc",
        "HOME not a path": "\x01",
    }.items():  # fmt: skip
        meet(name, HOME=value, SPRINGBACK_CACHE_DIR=str(folders["springback"]))
    if before is not None:
        os.environ["SPRINGBACK_CACHE_DIR"] = before
    return Row(
        "states of caches and HOME", count, len(bad), 0, 0, f"{count - len(bad)} of {count} fine"
    )
