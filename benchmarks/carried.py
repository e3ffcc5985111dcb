"""First flights with and without a wheel's kernels: ``python -m benchmarks.carried WHEEL``.

The wheel, as `make wheel` builds it, is installed into an environment of its own.  There each
program starts with an empty cache, once with the wheel's kernels and once without, and twice more
with what that start has left; flights are compared bit for bit.  Then each executes many flights in
lanes in turn: kernels for a level of processor beside those for this processor.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import sysconfig
import tempfile
import venv
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
#: README's first flight, and those with a pilot.
FIRST = """
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
EXAMPLES = ("arq_wall", "collision")
FLIGHTS, ROUNDS = 2048, 5

_HEAD = """
import time
began = time.perf_counter()
import hashlib, json, sys
import springback
"""
_FLY = """
flight = springback.fly(sys.argv[1])
wall = time.perf_counter() - began
from springback.kernels.compiler import cache_folder, packaged_status
digest = hashlib.sha256()
for name, values in (flight.columns | flight.telemetry).items():
    digest.update(name.encode() + values.tobytes())
compiled = len(list(cache_folder().glob("*.kernel")))
print(json.dumps([wall, digest.hexdigest(), compiled, packaged_status()]))
"""
_MANY = """
from springback.batch.scenarios import fly_scenarios
from springback.campaign.common_flights import COMMON
tables = [COMMON[sys.argv[1]]] * int(sys.argv[2])
fly_scenarios(tables[:64], threads=1)
begun = time.process_time()
fly_scenarios(tables, threads=1)
print(json.dumps(time.process_time() - begun))
"""


def environment(wheel: Path, folder: Path) -> Path:
    """Interpreter of a new environment with the wheel, which finds other packages in this one."""
    venv.create(folder, with_pip=False)
    python = folder / "bin" / "python"
    words = [sys.executable, "-m", "pip", "--python", str(python), "install", "--quiet"]
    words += ["--no-index", "--no-deps", "--disable-pip-version-check", str(wheel)]
    subprocess.run(words, check=True)
    [packages] = (folder / "lib").glob("python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return python


class Installation:
    """The environment, with one cache for starts with the wheel's kernels and one for others."""

    def __init__(self, wheel: Path, folder: Path) -> None:
        """Install."""
        self.python, self.folder = environment(wheel, folder / "environment"), folder

    def said(self, program: str, used: bool, *words: str) -> Any:
        """What a program prints, with the wheel's kernels or without."""
        kept = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
        kept |= {
            "SPRINGBACK_PACKAGED_KERNELS": str(int(used)),
            "SPRINGBACK_CACHE_DIR": str(self.folder / f"cache-{used}-{Path(words[0]).stem}"),
        }
        given = [str(self.python), "-c", _HEAD + program, *words]
        done = subprocess.run(
            given, env=kept, cwd=self.folder, check=True, capture_output=True, text=True
        )
        return json.loads(done.stdout.splitlines()[-1])


def first_flights(here: Installation, scenario: Path) -> dict[str, Any]:
    """Seconds of wall time until a flight has ended, and how many kernels were compiled for it."""
    found: dict[str, Any] = {}
    digests = set()
    for used in (True, False):
        starts = [here.said(_FLY, used, str(scenario)) for _ in range(3)]
        digests |= {digest for _, digest, _, _ in starts}
        found["packaged" if used else "compiled"] = {
            "empty cache [s]": round(starts[0][0], 2),
            "later [s]": round(statistics.median(wall for wall, *_ in starts[1:]), 2),
            "kernels compiled": starts[-1][2],
            "status": starts[0][3],
        }
    found["same bits"] = len(digests) == 1
    return found


def many_flights(here: Installation, kind: str) -> dict[str, Any]:
    """Processor time of many flights in lanes: that with the wheel's kernels over that without."""
    ratios, fastest = [], {True: float("inf"), False: float("inf")}
    for _ in range(ROUNDS):
        now = {used: here.said(_MANY, used, kind, str(FLIGHTS)) for used in (True, False)}
        ratios.append(now[True] / now[False])
        fastest = {used: min(fastest[used], now[used]) for used in now}
    return {
        "ratio, median": round(statistics.median(ratios), 3),
        "ratio of the best": round(fastest[True] / fastest[False], 3),
    }


def main() -> None:
    """Measure, and print a table in JSON."""
    parser = argparse.ArgumentParser(description="First flights with a wheel's kernels.")
    parser.add_argument("wheel", type=Path)
    wheel = parser.parse_args().wheel.resolve()
    result: dict[str, Any] = {"wheel [MB]": round(wheel.stat().st_size / 1e6, 1)}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        here = Installation(wheel, folder)
        (folder / "first.toml").write_text(FIRST)
        scenarios = [folder / "first.toml", *(ROOT / f"examples/{one}.toml" for one in EXAMPLES)]
        for scenario in scenarios:
            result[scenario.stem] = first_flights(here, scenario)
        for kind in ("a throw at a wall", "a pilot's flight at a wall"):
            result[f"{FLIGHTS} of {kind}"] = many_flights(here, kind)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
