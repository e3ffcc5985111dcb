"""A wheel with kernels, installed where nothing else is: it flies without compiling, to the bit."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import springback
from builders.missing import needs

ROOT = Path(__file__).parents[1]
LEVEL = "x86-64-v3"
#: README's first flight.
TEXT = """
vehicle = "arq"
thrust = "hover"
[[world.obstacles]]
type = "wall"
distance = "2.75 m"
surface = "wall"
[start]
position = ["2.3 m", 0, "1 m"]
velocity = ["2 m/s", 0, 0]
pitch = "15 deg"
"""
#: Flies it, and says what came out, where from, and what is used.
PROGRAM = """
import hashlib, json, sys
import springback
from springback.kernels.compiler import packaged_status
flight = springback.fly(sys.argv[1])
digest = hashlib.sha256()
for name, values in (flight.columns | flight.telemetry).items():
    digest.update(name.encode() + values.tobytes())
print(json.dumps([springback.__file__, packaged_status(), digest.hexdigest()]))
"""


@pytest.fixture(scope="module")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("wheel") / "scenario.toml"
    path.write_text(TEXT)
    return path


@pytest.fixture(scope="module")
def wheel(scenario: Path) -> Path:
    """A wheel with the kernels of that flight only."""
    words = [sys.executable, "tools/wheel.py", "--out", str(scenario.parent / "dist")]
    words += ["--level", LEVEL, "--scenario", str(scenario)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return Path(done.stdout.strip())


def installed(wheel: Path, folder: Path) -> Path:
    """Interpreter of a new environment with the wheel, without a network.

    It sees what the wheel depends on where this process does, but no package of a checkout: `.pth`
    files there are not read.
    """
    venv.create(folder, with_pip=False)
    python = folder / "bin" / "python"
    words = [sys.executable, "-m", "pip", "--python", str(python), "install", "--quiet"]
    words += ["--no-index", "--no-deps", "--disable-pip-version-check", str(wheel)]
    subprocess.run(words, check=True, capture_output=True)
    [packages] = (folder / "lib").glob("python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return python


def flown(python: Path, scenario: Path, **settings: str) -> Any:
    """What the program says in an environment without any other setting of springback's."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith("SPRINGBACK_")}
    kept.pop("PYTHONPATH", None)
    words = [str(python), "-W", "error", "-c", PROGRAM, str(scenario)]
    done = subprocess.run(
        words, env=kept | settings, cwd=scenario.parent, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@needs("AVX2", "POSIX")
def test_an_installed_wheel_flies_without_compiling_and_to_the_bit(
    wheel: Path, scenario: Path, tmp_path: Path
) -> None:
    """Its kernels are of a level of processor; those of this process, of this processor."""
    python = installed(wheel, tmp_path / "environment")
    file, status, digest = flown(python, scenario, SPRINGBACK_CACHE_DIR=str(tmp_path / "cache"))
    assert Path(file).is_relative_to(tmp_path / "environment")
    assert status.endswith(f"for {LEVEL}, used")
    assert not list((tmp_path / "cache").rglob("*.kernel")), "something was compiled"
    flight = springback.fly(scenario)
    own = flight.columns | flight.telemetry
    mine = hashlib.sha256()
    for name, values in own.items():
        mine.update(name.encode() + np.asarray(values).tobytes())
    assert digest == mine.hexdigest()


@needs("AVX2", "POSIX")
def test_the_wheel_is_for_one_version_and_platform(wheel: Path) -> None:
    version = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    assert f"-{version}-{version}-" in wheel.name
    assert not wheel.name.endswith("-any.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        kernels = [name for name in names if name.endswith(".kernel")]
        assert len(kernels) >= 3  # alone and in lanes
        for name in kernels:
            assert name.startswith(f"springback/kernels/packaged/{LEVEL}/")
            assert str(ROOT).encode() not in zlib.decompress(archive.read(name)[32:])
        [about] = [name for name in names if name.endswith(".dist-info/WHEEL")]
        assert b"Root-Is-Purelib: false" in archive.read(about)
