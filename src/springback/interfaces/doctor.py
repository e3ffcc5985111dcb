"""What is installed here, and whether it works."""

from __future__ import annotations

import platform
import sys
from importlib import metadata
from typing import Any

CORE = (
    "numpy",
    "scipy",
    "numba",
    "llvmlite",
    "pydantic",
    "duckdb",
    "click",
    "rich",
    "platformdirs",
)
EXTRAS = {"matplotlib": "plot", "jinja2": "plot", "pandas": "dataframe", "xarray": "xarray"}


def _version(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def diagnosis() -> dict[str, Any]:
    """Versions, the folder of compiled kernels, and a compiled flight against plain Python."""
    from springback.experiments.result import as_scenario
    from springback.kernels.compiler import cache_folder, is_writable
    from springback.simulation.flight import fly_one
    from springback.version import __version__

    folder = cache_folder()
    tables = {
        "vehicle": "arq",
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.754, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
        "simulation": {"duration": 2e-3},
    }
    scenario = as_scenario(tables)
    model, start = scenario.flight_model(), scenario.start_state()
    compiled = fly_one(model, start, trace=False)
    plain = fly_one(model, start, trace=False, executor="python")
    return {
        "springback": __version__,
        "python": platform.python_version(),
        "platform": f"{platform.system()} {platform.machine()}",
        "executable": sys.executable,
        "core": {name: _version(name) for name in CORE},
        "extras": {
            name: {"version": _version(name), "extra": extra} for name, extra in EXTRAS.items()
        },
        "kernels": {"folder": str(folder), "writable": is_writable(folder)},
        "compiled_equals_python": compiled.motion == plain.motion
        and compiled.record == plain.record,
    }
