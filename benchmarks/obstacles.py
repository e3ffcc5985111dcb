"""What obstacles cost, as ratios in one run: ``python -m benchmarks.obstacles``.

The same flights of ARQ end at a wall that is a half-space, a box, a mesh or a height map, at a
pole, or at a pole with many trunks around.  Every kind flies in every round, one after the other,
on one thread; ratios are those within a round, and their medians are shown.  Each world is set up
once for all its flights: that is left out of the time of a flight, and shown beside it.

Two vehicles are flown one pair at a time, so they are compared with one vehicle alone, once with
and once without a trajectory (a pair records 420 columns for each vehicle).
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import trimesh

import springback
from benchmarks.run import machine
from springback.batch.scenarios import fly_scenarios

Table = dict[str, Any]

AT = 2.75  # distance of all surfaces [m]
SPEED, SCATTER = 2.0, 0.3  # [m/s]
BARE, GUIDED = 0.3, 6.0  # duration [s]
#: Ratio of a kind to another one that the project wants at most; guided flights.
WANTED = (
    ("mesh", "planes", 2.0),
    ("height map", "planes", 2.0),
    ("mesh", "plane in a scene", 2.0),
    ("height map", "plane in a scene", 2.0),
    ("200 trunks", "pole", 1.5),
    ("10 000 trunks", "pole", 3.0),
)
NEW_SCENE = 2.0  # [s], from a new file to its first result

_PROGRAM = "import sys, springback; print(springback.fly(sys.argv[1]).outcome, flush=True)"
_SCENE = """
vehicle = "arq"
simulation.duration = 6.0
reference = {{type = "run-up", speed = {speed}}}
recovery = {{}}
[[world.obstacles]]
type = "pole"
position = [2.85, 0.05, 1.0]
radius = "{radius} mm"
surface = "wall"
[[world.obstacles]]
type = "ground"
surface = "wall"
"""


class Kind(NamedTuple):
    """Scene of a kind of flight."""

    name: str
    obstacles: list[Table]


class Spent(NamedTuple):
    """Processor time in a round [ms]."""

    flight: float  # of one more flight
    setup: float  # of the world, once


def _trunks(count: int) -> list[Table]:
    """Poles on a square grid beyond the one that is hit."""
    side = round(count**0.5)
    places = [(4.0 + k // side, k % side - 0.5 * side) for k in range(count)]
    return [
        {"type": "pole", "position": [x, y, 1.0], "radius": 0.1, "surface": "wall"}
        for x, y in places
    ]


def kinds(folder: Path) -> list[Kind]:
    """All scenes; their files are written to a folder."""
    mesh, heights = folder / "box.stl", folder / "level.npy"
    trimesh.creation.box((1.0, 4.0, 4.0)).export(mesh)
    np.save(heights, np.zeros((41, 41)))
    ground = {"type": "ground", "surface": "wall"}
    wall = {"type": "wall", "distance": AT, "surface": "wall"}
    afar = {"type": "sphere", "position": [60.0, 0, 1.0], "radius": 0.1, "surface": "wall"}
    box = {"position": [AT + 0.5, 0, 1.0], "surface": "wall"}
    pole = {"type": "pole", "position": [AT + 0.1, 0, 1.0], "radius": 0.1, "surface": "wall"}
    form = {
        "type": "heightmap", "file": str(heights), "spacing": 0.1, "position": [AT, 0, 1.0],
        "roll": "90 deg", "yaw": "-90 deg", "surface": "wall",
    }  # fmt: skip
    return [
        Kind("planes", [wall, ground]),
        Kind("plane in a scene", [wall, ground, afar]),
        Kind("box", [{"type": "box", "size": [1.0, 4.0, 4.0], **box}, ground]),
        Kind("mesh", [{"type": "mesh", "file": str(mesh), **box}, ground]),
        Kind("height map", [form, ground]),
        Kind("pole", [pole, ground]),
        Kind("200 trunks", [pole, ground, *_trunks(199)]),
        Kind("10 000 trunks", [pole, ground, *_trunks(9_990)]),
    ]


def flight(kind: Kind, number: int, guided: bool) -> Table:
    """One flight: with a pilot that runs up and recovers, or thrown at constant thrust."""
    random = np.random.default_rng(number)
    speed, pitch = SPEED + random.uniform(-SCATTER, SCATTER), random.uniform(-0.1, 0.3)
    thrown = {
        "thrust": "hover",
        "start": {"position": [AT - 0.45, 0, 1.0], "velocity": [speed, 0, 0], "pitch": pitch},
    }
    table: Table = {"vehicle": "arq", "world": {"obstacles": kind.obstacles}}
    table["simulation"] = {"duration": GUIDED if guided else BARE}
    if not guided:
        return table | thrown
    table["reference"] = {"type": "run-up", "speed": speed, "pitch": pitch}
    table["recovery"] = {"characterisation": {"level": False}}
    return table


def _busy(tables: list[Table]) -> float:
    """Processor time of some flights [ms]."""
    began = time.process_time()
    fly_scenarios(tables)
    return (time.process_time() - began) * 1e3


def times(scenes: list[Kind], flights: int, rounds: int, guided: bool) -> dict[str, list[Spent]]:
    """Processor time of each kind in each round, by so many flights and twice as many."""
    found: dict[str, list[Spent]] = {kind.name: [] for kind in scenes}
    tables = {kind.name: [flight(kind, k, guided) for k in range(2 * flights)] for kind in scenes}
    for some in tables.values():
        fly_scenarios(some[:8])  # compiles, and reads the files
    for _ in range(rounds):
        for name, some in tables.items():
            few, many = _busy(some[::2]), _busy(some)
            each = (many - few) / flights
            found[name].append(Spent(each, few - flights * each))
    return found


def ratio(found: dict[str, list[Spent]], kind: str, base: str) -> float:
    """Median over the rounds of the ratio of two kinds."""
    both = zip(found[kind], found[base], strict=True)
    return statistics.median(a.flight / b.flight for a, b in both)


def hovering(duration: float, second: Table | None = None) -> Table:
    """A robot with a pilot that hovers for some seconds, alone or beside a second one."""
    table: Table = {
        "vehicle": "arq", "start": {"position": [0, 0, 2.0]}, "recovery": {},
        "reference": {"type": "hold", "position": [0, 0, 2.0]},
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "simulation": {"duration": duration},
    }  # fmt: skip
    return table if second is None else {**table, "second": second}


def _single(table: Table, trajectory: bool) -> float:
    """Processor time of a single flight [ms]."""
    began = time.process_time()
    springback.fly(table, trajectory=trajectory)
    return (time.process_time() - began) * 1e3


def pairs(rounds: int, trajectory: bool) -> dict[str, list[float]]:
    """Processor time of a second of flight, of one vehicle and of two, in each round [ms]."""
    there = {"position": [1.0, 0.05, 2.0], "yaw": "180 deg"}
    beside = {
        "vehicle": "arq", "start": there, "recovery": {},
        "reference": {"type": "hold", "position": [1.0, 0.05, 2.0]},
    }  # fmt: skip
    kinds: dict[str, Table | None] = {"one": None, "two": beside}
    found: dict[str, list[float]] = {name: [] for name in kinds}
    for second in kinds.values():
        _single(hovering(11.0 * GUIDED, second), trajectory)  # compiles, and takes memory
    for _ in range(rounds):
        for name, second in kinds.items():
            long, short = (_single(hovering(d, second), trajectory) for d in (11 * GUIDED, GUIDED))
            found[name].append((long - short) / (10.0 * GUIDED))
    return found


def new_scene(folder: Path) -> list[tuple[float, float]]:
    """Seconds from a new file to its outcome and to the end of its process; the first compiles."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    spent = []
    for k in range(4):
        file = folder / f"scene{k}.toml"
        file.write_text(_SCENE.format(speed=2.0 + 0.01 * k, radius=60 + k))
        command = [sys.executable, "-c", _PROGRAM, str(file)]
        began = time.perf_counter()
        with subprocess.Popen(
            command, env=environment, stdout=subprocess.PIPE, text=True
        ) as process:
            assert process.stdout is not None
            told = process.stdout.readline()
            first = time.perf_counter() - began
            if process.wait() or not told.startswith("Outcome"):
                raise RuntimeError(f"no outcome of {file}")
        spent.append((first, time.perf_counter() - began))
    return spent[1:]


def main() -> None:
    """Fly all, and print the tables."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--flights", type=int, default=64)
    options.add_argument("--rounds", type=int, default=5)
    given = options.parse_args()
    print(*(f"{k}: {v}" for k, v in machine().items()), sep="\n", flush=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        scenes = kinds(folder)
        both = {what: times(scenes, given.flights, given.rounds, what == "pilot")
                for what in ("thrown", "pilot")}  # fmt: skip
        print(
            "\n| | thrown, 0.3 s [ms] | / planes | with a pilot, 6 s [ms] | / planes | world [ms] |"
        )
        print("|---|---|---|---|---|---|")
        for kind in scenes:
            cells = [kind.name]
            for found in both.values():
                each = statistics.median(one.flight for one in found[kind.name])
                cells += [f"{each:.2f}", f"{ratio(found, kind.name, 'planes'):.2f}"]
            world = statistics.median(one.setup for one in both["thrown"][kind.name])
            print("|", " | ".join([*cells, f"{world:.0f}"]), "|")
        print("\nWith a pilot:\n")
        for kind, base, most in WANTED:
            found = ratio(both["pilot"], kind, base)
            verdict = "met" if found <= most else "missed"
            print(f"- {kind} / {base}: {found:.2f} (wanted at most {most:g}: {verdict})")
        for trajectory, how in ((False, "measures only"), (True, "with its trajectory")):
            one, two = pairs(given.rounds, trajectory).values()
            found = statistics.median(b / a for a, b in zip(one, two, strict=True))
            print(
                f"- two vehicles / one, in hover, one flight, {how}: {found:.2f} (wanted about 2); "
                f"{statistics.median(two):.2f} ms a second of flight"
            )
        first, ended = zip(*new_scene(folder), strict=True)
        verdict = "met" if max(first) <= NEW_SCENE else "missed"
        said, after = (", ".join(f"{x:.2f}" for x in each) for each in (first, ended))
        print(
            f"- a new scene file to its result: {said} s (wanted at most {NEW_SCENE:g}: {verdict}),"
            f" to the end of its process {after} s"
        )


if __name__ == "__main__":
    main()
