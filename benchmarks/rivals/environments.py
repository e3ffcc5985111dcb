"""A virtual environment for each rival, made when first asked for and kept."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
import venv
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from platformdirs import user_cache_path

#: Names the folder that keeps the environments, in place of the user's cache folder.
VARIABLE = "SPRINGBACK_RIVALS_DIR"
#: PyTorch without graphics processors, a tenth of the other; elsewhere the index has the rest.
TORCH_INDEX = ("--extra-index-url", "https://download.pytorch.org/whl/cpu")
PIP = (
    "-m", "pip", "--disable-pip-version-check", "--no-input", "install", "--quiet",
    "--retries", "1",
)  # fmt: skip


class Missing(Exception):
    """A rival cannot be installed here, and why."""


class Recipe(NamedTuple):
    """What an environment holds.

    Versions of what decides the speed are pinned; pip chooses the rest.
    """

    name: str
    packages: tuple[str, ...]
    bare: tuple[str, ...] = ()
    """Installed after them, without what they ask for themselves."""
    options: tuple[str, ...] = ()


class Environment(NamedTuple):
    """A rival's own."""

    python: str
    seconds: float
    """That installing took."""
    size: float
    """On disk [MiB]."""


RECIPES = {
    recipe.name: recipe
    for recipe in (
        Recipe(
            "rotorpy",
            ("rotorpy==3.0.0", "torch==2.13.0", "torchdiffeq==0.2.5", "roma", "opt-einsum"),
            options=TORCH_INDEX,
        ),
        Recipe("crazyflow", ("crazyflow==0.4.0", "jax==0.10.1", "mujoco-mjx==3.17.0")),
        Recipe(
            "gym-pybullet-drones",
            (
                "pybullet==3.2.7", "gymnasium", "matplotlib", "numpy", "pillow", "scipy",
                "setuptools<81", "transforms3d",
            ),
            # Not among the packages of the index; its learning library is not needed to fly.
            bare=(
                "gym-pybullet-drones @ git+https://github.com/learnsyslab/gym-pybullet-drones"
                "@90b178aba69b09085dd70e7a1e88bb58ca00b4c9",
            ),
        ),
        Recipe("mujoco", ("mujoco==4.0.0", "numpy")),
    )
}  # fmt: skip


def folder() -> Path:
    """Where environments are kept."""
    given = os.environ.get(VARIABLE)
    return Path(given) if given else user_cache_path("springback") / "rivals"


def made(recipe: Recipe, say: Callable[[str], None]) -> Environment:
    """The environment of a recipe, installed if it is not there or was made by another recipe.

    Args:
        recipe: What it holds.
        say: Called before something that takes long.

    Raises:
        Missing: If it cannot be installed; nothing half-made is left.
    """
    home = folder() / recipe.name
    stamp, wanted = home / "made.json", [sys.version, *recipe.packages, *recipe.bare]
    if stamp.is_file():
        known = json.loads(stamp.read_text())
        if known["recipe"] == wanted:
            return Environment(str(_python(home)), known["seconds"], known["size"])
    say(f"installing {recipe.name} into {home}")
    shutil.rmtree(home, ignore_errors=True)
    began = time.perf_counter()
    try:
        venv.create(home, with_pip=True)
        _install(home, [*recipe.options, *recipe.packages])
        if recipe.bare:
            _install(home, ["--no-deps", *recipe.bare])
    except (OSError, subprocess.CalledProcessError) as error:
        shutil.rmtree(home, ignore_errors=True)
        raise Missing(_reason(error)) from error
    seconds = time.perf_counter() - began
    size = sum(f.lstat().st_size for f in home.rglob("*") if not f.is_dir()) / 2**20
    stamp.write_text(json.dumps({"recipe": wanted, "seconds": seconds, "size": size}))
    return Environment(str(_python(home)), seconds, size)


def _python(home: Path) -> Path:
    return home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def _install(home: Path, wanted: list[str]) -> None:
    subprocess.run([_python(home), *PIP, *wanted], capture_output=True, text=True, check=True)


def _reason(error: Exception) -> str:
    """The line of what pip says that names the error, or the error itself."""
    said = error.stderr if isinstance(error, subprocess.CalledProcessError) else ""
    lines = [line.strip() for line in (said or str(error)).splitlines() if line.strip()]
    named = [line for line in lines if line.lower().startswith(("error", "fatal"))]
    return (named or lines or [type(error).__name__])[-1]
