"""What a machine may lack: the only reasons for which a test is skipped."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from llvmlite import binding

#: Programs that some tests call; all else comes with `tools/environment dev`.
PROGRAMS = ("chromedriver", "chromium", "gcc", "git", "openssl")
#: What is no program, and whether this machine has it.
FEATURES = {
    "POSIX": os.name == "posix",
    "root": hasattr(os, "getuid") and os.getuid() == 0,
    "/dev/full": Path("/dev/full").exists(),
    "a git checkout": (Path(__file__).parents[2] / ".git").exists(),
    "AVX2": bool(binding.get_host_cpu_features().get("avx2")),
    "AVX-512": bool(binding.get_host_cpu_features().get("avx512f")),
}


def missing(*names: str) -> list[str]:
    """Those of some programs and features that are not here."""
    return [name for name in names if not FEATURES.get(name, shutil.which(name) is not None)]


def needs(*names: str) -> pytest.MarkDecorator:
    """Skip a test where one of these is missing."""
    lacking = missing(*names)
    return pytest.mark.skipif(bool(lacking), reason=f"needs {', '.join(lacking)}")


def is_allowed(reason: str) -> bool:
    """Whether a test may be skipped for this: it names only what may be missing, and is."""
    start, _, named = reason.removeprefix("Skipped: ").partition(" ")
    names = named.split(", ")
    known = all(name in PROGRAMS or name in FEATURES for name in names)
    return start == "needs" and known and missing(*names) == names
