"""The protocol of the programs: the job as JSON in, the cost as one line of JSON out.

Only the standard library, so that it runs in every environment.
"""

from __future__ import annotations

import functools
import importlib.metadata
import json
import math
import multiprocessing
import os
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

T = TypeVar("T")
Work = Callable[[Any], Any]


def job() -> dict[str, Any]:
    """What to fly."""
    job: dict[str, Any] = json.load(sys.stdin)
    return job


def answer(**found: Any) -> None:
    """Say what it took."""
    sys.stdout.write("\n" + json.dumps(found) + "\n")


def since(job: dict[str, Any]) -> float:
    """Seconds since this process was started by the one that gave it the job."""
    return time.time() - float(job["started"])


def timed(run: Callable[[], T]) -> tuple[float, T]:
    """Seconds that something takes, and what it gives."""
    began = time.perf_counter()
    given = run()
    return time.perf_counter() - began, given


def repeated(run: Callable[[], Any], least: float = 0.5, most: int = 20) -> list[float]:
    """Seconds of several runs: until they have taken so long together, or so many were made."""
    taken: list[float] = []
    while not taken or (sum(taken) < least and len(taken) < most):
        taken.append(timed(run)[0])
    return taken


def peak_memory(children: int = 0) -> float:
    """Largest resident memory of this process so far [MiB], that of its children added.

    Args:
        children: How many there were at a time; the largest counts for each.
    """
    import resource

    unit = 2**20 if sys.platform == "darwin" else 2**10
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    theirs = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss if children else 0
    return (own + children * theirs) / unit


def scatter(count: int) -> list[tuple[float, float]]:
    """Where flights start beside the common place [m], each elsewhere: points of a sunflower."""
    golden = math.pi * (3.0 - math.sqrt(5.0))
    radii = (0.1 * math.sqrt((k + 0.5) / count) for k in range(count))
    return [(r * math.cos(k * golden), r * math.sin(k * golden)) for k, r in enumerate(radii)]


def versions(*packages: str) -> dict[str, str]:
    """Of installed packages."""
    return {name: importlib.metadata.version(name) for name in packages}


def _member(number: int, size: int, work: Work, pipe: Any) -> None:
    """One process of a crew, alone on its core where the system can do that."""
    if hasattr(os, "sched_setaffinity"):
        cores = sorted(os.sched_getaffinity(0))
        os.sched_setaffinity(0, {cores[number % len(cores)]})
    for task in iter(pipe.recv, None):
        pipe.send(work(task))


class Crew:
    """Processes side by side, for programs that make little use of more than one core.

    Args:
        size: How many.
        work: A function of the program, done on every task.
    """

    def __init__(self, size: int, work: Work) -> None:
        """Start them."""
        fresh = multiprocessing.get_context("spawn")
        self.pipes, self.members = [], []
        for number in range(size):
            ours, theirs = fresh.Pipe()
            member = fresh.Process(target=_member, args=(number, size, work, theirs), daemon=True)
            member.start()
            theirs.close()
            self.pipes.append(ours)
            self.members.append(member)

    def each(self, tasks: Sequence[Any]) -> list[Any]:
        """Give every member its task, all at once, and wait for all."""
        for pipe, task in zip(self.pipes, tasks, strict=True):
            pipe.send(task)
        return [pipe.recv() for pipe in self.pipes]

    def close(self) -> None:
        """End the processes; only then does the system tell how much memory they took."""
        for pipe, member in zip(self.pipes, self.members, strict=True):
            pipe.send(None)
            member.join()


def many(job: dict[str, Any], work: Work, first: bool = True) -> tuple[list[dict[str, Any]], Any]:
    """Fly many flights at once, in each of the ways that are asked for.

    Args:
        job: ``tries`` are numbers of processes and of flights, all together.
        work: Flies; given the job and the starts of the flights, returns the largest miss [m].
        first: Do it once before the clock runs, as whatever compiles has then compiled; else
            every process flies one flight before.

    Returns:
        Seconds of each try, and the largest miss of all.
    """
    found, missed = [], 0.0
    for processes, flights in job["tries"]:
        places = scatter(flights)
        tasks = [(job, places[k::processes]) for k in range(processes)]
        crew = Crew(processes, work) if processes > 1 else None
        run = functools.partial(crew.each, tasks) if crew else lambda: [work(tasks[0])]  # noqa: B023
        if first:
            run()
        elif crew:  # whatever is imported late has then been
            crew.each([(job, places[:1])] * processes)
        seconds, misses = timed(run)
        if crew:
            crew.close()
        found.append({"processes": processes, "flights": flights, "seconds": seconds})
        missed = max(missed, *misses)
    return found, missed
