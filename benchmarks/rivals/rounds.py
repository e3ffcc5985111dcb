"""Every contender in every round, one after the other, each in fresh processes of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.rivals import impacts
from benchmarks.rivals.contenders import (
    MISS,
    Contender,
    free_flight,
    judging,
    our_impact,
    their_impact,
)
from benchmarks.rivals.environments import RECIPES, Environment, Missing, Recipe, made

PROGRAMS, ROOT = Path(__file__).with_name("programs"), Path(__file__).parents[2]
#: A program that takes longer is given up [s].
PATIENCE = 1800.0
Say = Callable[[str], None]


class Failed(Exception):
    """A program did not fly the task, and why."""


class Settings(NamedTuple):
    """How much of everything."""

    rounds: int
    threads: int
    only: tuple[str, ...] = ()
    """Parts of names of contenders; none: all."""
    quick: bool = False
    """Small numbers of flights, to see that all works; its figures mean nothing."""
    sources: tuple[tuple[str, str], ...] = ()
    """What to install in place of a recipe's bare package."""


def told_environment(contender: Contender, extra: dict[str, str]) -> dict[str, str]:
    """Variables of a program's process; nothing of ours is on the path of a rival."""
    kept = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    if not contender.environment:
        paths = [str(ROOT), os.environ.get("PYTHONPATH", "")]
        kept["PYTHONPATH"] = os.pathsep.join(path for path in paths if path)
    return kept | extra


def _only_cores(threads: int) -> Callable[[], None] | None:
    """Keep a process and its children to so many cores, where the system can do that."""
    if not hasattr(os, "sched_setaffinity"):
        return None
    cores = sorted(os.sched_getaffinity(0))[:threads]
    return lambda: os.sched_setaffinity(0, cores)


def run(
    contender: Contender,
    python: str,
    threads: int,
    tries: Sequence[Sequence[int]],
    extra: dict[str, str] | None = None,
) -> dict[str, Any]:
    """Run a contender's program once; what it says.

    Args:
        contender: Of whom.
        python: Interpreter of its environment.
        threads: Cores to use.
        tries: Processes and flights to fly.
        extra: Further variables.

    Raises:
        Failed: If it fails or says nothing.
    """
    job = {"judge": False, "kind": contender.kind, "threads": threads, "tries": tries}
    job |= contender.options
    try:
        with tempfile.TemporaryDirectory() as elsewhere:  # some leave logs where they run
            done = subprocess.run(
                [python, str(PROGRAMS / f"{contender.program}.py")],
                input=json.dumps({**job, "started": time.time()}),
                env=told_environment(contender, extra or {}),
                preexec_fn=_only_cores(threads),
                cwd=elsewhere, capture_output=True, text=True, timeout=PATIENCE,
            )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise Failed(f"took longer than {PATIENCE:g} s") from None
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode or not lines:
        said = [line for line in done.stderr.splitlines() if line.strip()]
        raise Failed(said[-1].strip() if said else f"ended with code {done.returncode}")
    found: dict[str, Any] = json.loads(lines[-1])
    missed = found.get("missed")
    if missed is not None and not missed < MISS:
        raise Failed(f"a flight ends {missed:.2f} m from its target; that is not the task")
    return found


def flights_a_second(tried: dict[str, Any]) -> float:
    """Of one try."""
    return float(tried["flights"]) / float(tried["seconds"])


class Field:
    """The contenders with their interpreters, and the reasons of those left out."""

    def __init__(self, settings: Settings, say: Say) -> None:
        """Start empty."""
        self.settings, self.say = settings, say
        self.skipped: dict[str, str] = {}
        self.environments: dict[str, Environment | None] = {}
        self.rows: dict[str, dict[str, Any]] = {}
        self.accuracy: dict[str, Any] = {}

    def wanted(self, name: str) -> bool:
        """True if a contender is selected."""
        only = self.settings.only
        return not only or any(part.lower() in name.lower() for part in only)

    def python(self, contender: Contender) -> str | None:
        """Interpreter of a contender; None if its environment cannot be made."""
        key = contender.environment
        if not key:
            return sys.executable
        if key not in self.environments:
            try:
                self.environments[key] = made(self._recipe(key), self.say)
            except Missing as why:
                self.environments[key] = None
                self.skipped[key] = f"cannot be installed here: {why}"
                self.say(f"{key}: {self.skipped[key]}")
        environment = self.environments[key]
        return environment.python if environment else None

    def _recipe(self, key: str) -> Recipe:
        given = dict(self.settings.sources).get(key)
        recipe = RECIPES[key]
        return recipe._replace(bare=(given,)) if given else recipe

    def attempt(self, contender: Contender, tries: Sequence[Sequence[int]], **extra: Any) -> Any:
        """Run a program; None, and out of the field, if it fails."""
        python = self.python(contender)
        if python is None:
            return None
        try:
            return run(contender, python, self.settings.threads, tries, **extra)
        except Failed as why:
            self.skipped[contender.name] = str(why)
            self.rows.pop(contender.name, None)
            self.say(f"{contender.name}: {why}")
            return None

    def judge(self) -> list[Contender]:
        """Find out who may take which step in impacts; the contenders that follow from it."""
        entrants: list[Contender] = []
        limits: dict[str, Any] = {}
        names = {None: "springback, impact"} | {
            i: f"MuJoCo rollout, {i}" for i in impacts.INTEGRATORS
        }
        for integrator, name in names.items():
            if not self.wanted(name):
                continue
            self.say(f"{name}: accuracy")
            found = self.attempt(judging(integrator), ())
            if found is None:
                continue
            try:
                step, errors = impacts.chosen(found)
            except ValueError as why:
                self.skipped[name] = str(why)
                continue
            limits[name] = found["converged"]
            self.accuracy[name] = {"step": step, "worst errors": errors, "steps": found["errors"]}
            if integrator is None:
                entrants.append(our_impact("coarsest step within 1 %", step))
                entrants.append(our_impact("default step", impacts.DEFAULT_STEP))
            else:
                entrants.append(their_impact(integrator, step))
        theirs = [values for name, values in limits.items() if name.startswith("MuJoCo")]
        if names[None] in limits and theirs:
            self.accuracy["theirs over ours, converged"] = impacts.agreement(
                limits[names[None]], theirs[0]
            )
        return entrants

    def enter(self, contender: Contender) -> None:
        """Find the fastest of a contender's tries; it has then taken part once, uncounted."""
        tries = contender.tries
        if self.settings.quick:
            tries = ((tries[0][0], min(tries[0][1], 64)),)
        self.say(f"{contender.name}: the fastest of {len(tries)}")
        found = self.attempt(contender, tries)
        if found is None:
            return
        best = max(found["many"], key=flights_a_second)
        self.rows[contender.name] = {
            "kind": contender.kind,
            "rates": contender.rates,
            "differs": contender.differs,
            "versions": found["versions"],
            "best": [best["processes"], best["flights"]],
            "sweep": [{**tried, "rate": flights_a_second(tried)} for tried in found["many"]],
            "rounds": [],
        }

    def fly(self, contender: Contender) -> None:
        """One round of one contender."""
        row = self.rows.get(contender.name)
        found = self.attempt(contender, [row["best"]]) if row else None
        if row is None or found is None:
            return
        row["rounds"].append(
            {
                "flights per second": flights_a_second(found["many"][0]),
                "latency": sorted(found["latency"])[len(found["latency"]) // 2],
                "import": found["imported"],
                "first flight": found["first"],
                "memory": found["memory"],
            }
        )
        row["missed"], row["outcomes"] = found.get("missed"), found.get("outcomes")


def cold_start(threads: int, contender: Contender) -> dict[str, float]:
    """Springback's start-up with an empty cache of compiled code [s]."""
    with tempfile.TemporaryDirectory() as empty:
        found = run(contender, sys.executable, threads, (), {"SPRINGBACK_CACHE_DIR": empty})
    return {"import": found["imported"], "first flight": found["first"]}


def contest(settings: Settings, say: Say) -> dict[str, Any]:
    """All rounds: what everybody took, who dropped out and why."""
    field = Field(settings, say)
    everybody = [c for c in free_flight(settings.threads) if field.wanted(c.name)]
    everybody += [c for c in field.judge() if field.wanted(c.name)]
    cold = {
        c.name: cold_start(settings.threads, c)
        for c in everybody
        if not c.environment and "complementary" in c.name and not settings.quick
    }
    for contender in everybody:
        field.enter(contender)
    for number in range(settings.rounds):
        for contender in everybody:
            field.fly(contender)
        say(f"round {number + 1} of {settings.rounds}")
    installed = {
        name: {"seconds": found.seconds, "MiB": found.size}
        for name, found in field.environments.items()
        if found
    }
    return {
        "rounds": settings.rounds,
        "threads": settings.threads,
        "quick": settings.quick,
        "contenders": field.rows,
        "accuracy": field.accuracy,
        "skipped": field.skipped,
        "installed": installed,
        "cold start": cold,
    }
