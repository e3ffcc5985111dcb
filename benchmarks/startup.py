"""How long until the first flight, with an empty cache of compiled code and with a full one."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from typing import NamedTuple

_PROGRAM = """
import json, time
began = time.perf_counter()
import springback
from benchmarks.job import Single, reference_model, starts
imported = time.perf_counter()
model = reference_model(until=0.05)
Single(model, starts(model, 1)[0]).run()
print(json.dumps([imported - began, time.perf_counter() - imported]))
"""


class Startup(NamedTuple):
    """Seconds of a fresh process."""

    importing: float
    first_flight: float


def _once(folder: str) -> Startup:
    said = subprocess.run(
        [sys.executable, "-c", _PROGRAM],
        env={**os.environ, "SPRINGBACK_CACHE_DIR": folder},
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    return Startup(*json.loads(said.splitlines()[-1]))


def cold_and_warm() -> tuple[Startup, Startup]:
    """Start-up with an empty cache, then with what that start has left in it."""
    with tempfile.TemporaryDirectory() as folder:
        return _once(folder), _once(folder)
