"""springback's closed loop: sensors, estimator, pilot, rotors, motion, contact; many flights.

From plain tables to measures: checking the tables, setting up, drawing noise and reading out are
all within the time.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import protocol

from springback.batch.scenarios import fly_scenarios

#: The paper's collision: speed at contact [m/s] and pitch [deg].
SPEED, PITCH = 2.0, 0.0


def flown(tables: Sequence[Mapping[str, Any]], threads: int) -> list[str]:
    """Fly scenarios as a batch; the outcome of each, in a word.

    This is all that these benchmarks ask of springback for many flights with a pilot.
    """
    return list(fly_scenarios(tables, threads=threads).outcomes)


def step_tables(job: Mapping[str, Any], places: Sequence[Sequence[float]]) -> list[dict[str, Any]]:
    """The step that everybody flies, from each of the places; one sub-table for all where equal."""
    task = job["task"]
    common: dict[str, Any] = {
        "vehicle": "quad",
        "reference": {
            "type": "steps", "positions": [task["start"], task["target"]],
            "dwell": task["step_at"],
        },
        "estimator": {"type": job["estimator"]},
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "simulation": {"duration": task["duration"]},
    }  # fmt: skip
    x, y, z = task["start"]
    return [
        common | {"start": {"position": [x + p[0], y + p[1], z]}, "seed": k}
        for k, p in enumerate(places)
    ]


def collision_tables(job: Mapping[str, Any], count: int) -> list[dict[str, Any]]:
    """Run-up, impact and recovery of ARQ, with the draws of the paper's tests.

    Args:
        job: With ``arms`` or ``obstacles``, where those are not ARQ's and the test's own.
        count: Flights.
    """
    from springback.studies.trials import Scatter, trial_tables

    changes = {
        "simulation": {"duration": job["task"]["duration"]},
        "estimator": {"type": job["estimator"]},
    }
    lucks = (Scatter().draw("arq", PITCH, SPEED, k, 0) for k in range(count))
    tables = [trial_tables("arq", PITCH, SPEED, noise_stream, changes) for noise_stream in lucks]
    for one in tables:
        if job.get("arms", 4) != 4:
            one["vehicle"] = with_arms(job["arms"])
        if "obstacles" in job:
            world = one["world"]
            one["world"] = {**world, "obstacles": obstacles(world["obstacles"], job["obstacles"])}
    first = tables[0]
    return [
        {name: first[name] if part == first[name] else part for name, part in one.items()}
        for one in tables
    ]


def with_arms(count: int) -> dict[str, Any]:
    """ARQ with another number of arms, evenly spread, a gap in front; more have smaller cages."""
    turn = 2.0 * math.pi / count
    arms: dict[str, Any] = {"directions": [(k + 0.5) * turn for k in range(count)]}
    if count > 4:
        arms["cage_radius"] = 0.44 / count
    return {"preset": "arq", "arms": arms}


def obstacles(own: Sequence[Any], count: int) -> list[Any]:
    """So many obstacles: the wall, the ground, then walls 4 m away that no flight comes near."""
    turns = [2.0 * math.pi * (k + 1) / (count + 1) for k in range(max(0, count - len(own)))]
    far = [
        {
            "type": "wall", "surface": "wall",
            "normal": [-math.cos(a), -math.sin(a), 0.0],
            "position": [4.0 * math.cos(a), 4.0 * math.sin(a), 0.0],
        }
        for a in turns
    ]  # fmt: skip
    return [*own, *far][:count]


def missed(tables: Mapping[str, Any], target: Sequence[float]) -> float:
    """How far from its target a flight ends [m]."""
    import springback

    columns = springback.fly(tables).columns
    gaps = (columns[name][-1] - goal for name, goal in zip("xyz", target, strict=True))
    return float(sum(gap * gap for gap in gaps) ** 0.5)


def main() -> None:
    job = protocol.job()
    import springback

    imported = protocol.since(job)
    collides = job["kind"] == "collision"

    def tables(count: int) -> list[dict[str, Any]]:
        if collides:
            return collision_tables(job, count)
        return step_tables(job, protocol.scatter(count))

    alone = tables(1)
    springback.fly(alone[0], trajectory=False)
    first = protocol.since(job)
    latency = protocol.repeated(lambda: springback.fly(alone[0], trajectory=False))
    many, outcomes = [], {}
    for _, flights in job["tries"]:
        given = tables(flights)
        flown(given[:8], job["threads"])  # compiles
        seconds, ended = protocol.timed(lambda given=given: flown(given, job["threads"]))
        many.append({"processes": 1, "flights": flights, "seconds": seconds})
        outcomes = {word: ended.count(word) for word in sorted(set(ended))}
    memory = protocol.peak_memory()
    protocol.answer(
        versions=protocol.versions("numba", "numpy") | {"springback": springback.__version__},
        imported=imported, first=first, latency=latency, many=many, memory=memory,
        missed=None if collides else missed(alone[0], job["task"]["target"]), outcomes=outcomes,
    )  # fmt: skip


if __name__ == "__main__":
    main()
