"""Diagnosis of an installation."""

from __future__ import annotations

import platform
import sys
from importlib import metadata
from typing import Any

#: Version shown for a package that is not installed.
MISSING = "missing"


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return MISSING


def extras_found() -> dict[str, dict[str, str]]:
    """Extras with the versions of their packages and, for incomplete ones, how to install them."""
    from springback.extras import install_line, packages

    found = {}
    for extra, names in packages().items():
        if extra:
            found[extra] = {name: _version(name) for name in names}
            if MISSING in found[extra].values():
                found[extra]["to install"] = install_line(extra)
    return found


def diagnosis() -> dict[str, Any]:
    """Versions, folder of kernels, and comparison of a compiled flight with plain Python."""
    from springback.extras import packages
    from springback.kernels.compiler import cache_folder, is_writable, packaged_status
    from springback.results.flight import as_scenario
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
        "core": {name: _version(name) for name in packages()[""]},
        "extras": extras_found(),
        "kernels": {
            "folder": str(folder),
            "writable": is_writable(folder),
            "packaged": packaged_status(),
        },
        "compiled_equals_python": compiled.motion == plain.motion
        and compiled.record == plain.record,
    }
