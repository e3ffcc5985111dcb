"""Compilation of the kernels that flights need: whether it was done before, and how long it takes.

A kind of flight is a set of types; its kernels are compiled once and cached.  The cache does not
tell for which flights its files are, so the time that each kind took and the files that it left are
recorded beside them, in processor time, which other work does not slow down.  The record is advice:
one that is missing, damaged or out of date costs an estimate and nothing else.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.files import json_text, write_atomically
from springback.kernels.compiler import (
    cache_folder,
    is_writable,
    packaged_kinds,
    state_digest,
)
from springback.kernels.layout import structure
from springback.results.flight import fly
from springback.results.sealed_json import digest_of
from springback.scenario.scenario import Scenario, scenario_from

RECORD = "compiler_times.json"
#: Processor time to compile a kind of flight that was not recorded yet, without a pilot and with
#: one [s] (measured for README's first flight and examples/collision.toml, whose figures it gives).
TYPICAL = {False: 20.0, True: 60.0}
#: Most kinds that are recorded, the last ones (chosen).
MOST_RECORDED = 200


class FlightKind(NamedTuple):
    """A kind of flight that is compiled."""

    key: str
    """Digest of its types."""
    guided: bool
    """True if it has avionics."""
    tables: Mapping[str, Any]
    """Scenario of one such flight."""
    alone: bool = False
    """True if it is flown alone with its trajectory, as kept flights are, not in lanes."""


class CompilerTime(NamedTuple):
    """What is known about the compilation of a kind of flight."""

    seconds: float
    """Processor time that it took the last time, or typically takes [s]."""
    recorded: bool
    """False if it is a typical time."""
    cached: bool
    """True if its kernels are in the cache, as far as the record says, or came with the package."""


def flight_kinds(tables: Sequence[Mapping[str, Any]], *, alone: bool = False) -> list[FlightKind]:
    """Kinds of some flights, without those that cannot be flown or have a pilot in plain Python.

    Args:
        tables: Scenarios of the flights.
        alone: See `FlightKind`.
    """
    found: dict[str, FlightKind] = {}
    for given in tables:
        with contextlib.suppress(InputError):
            scenario = scenario_from(given, False, advises=False)
            ready = scenario.build(advises=False)
            if ready.plain is not None:
                continue
            avionics = ready.built_avionics.avionics if ready.built_avionics else None
            beside = () if scenario.second is None else _types_of(scenario.beside())
            own = structure(ready.model), structure(ready.start), structure(avionics)
            types = repr((*own, alone, *beside))
            key = hashlib.sha256(types.encode()).hexdigest()[:32]
            found.setdefault(key, FlightKind(key, avionics is not None, given, alone))
    return list(found.values())


def _types_of(scenario: Scenario) -> tuple[Any, ...]:
    """Types of a second vehicle and its pilot."""
    ready = scenario.build(advises=False)
    avionics = ready.built_avionics.avionics if ready.built_avionics else None
    return structure(ready.model), structure(ready.start), structure(avionics)


def kernel_files() -> set[Path]:
    """Files of compiled kernels, those of users' own code included."""
    folder = cache_folder()
    return {*folder.glob("*.kernel"), *_root().glob("own/*/*.kernel")}


def is_packaged(kind: FlightKind) -> bool:
    """True if all kernels of a kind of flight came with the package, and fit."""
    return kind.key in packaged_kinds()


def compiler_time(kind: FlightKind, code: Mapping[str, str]) -> CompilerTime:
    """What the record says about a kind of flight, without compiling anything.

    Args:
        kind: The kind.
        code: SHA-256 of the user's own files that its flights need, by path.
    """
    entry, packaged = _record().get(kind.key), is_packaged(kind)
    if entry is None:
        return CompilerTime(TYPICAL[kind.guided], False, packaged)
    files = [_root() / name for name in entry["files"]]
    there = all(map(_exists, files)) if files else bool(kernel_files() or packaged_kinds())
    cached, seconds = packaged or (there and entry["state"] == _state(code)), entry["seconds"]
    known = seconds is not None
    return CompilerTime(seconds if known else TYPICAL[kind.guided], known, cached)


def compile_kind(kind: FlightKind, code: Mapping[str, str]) -> float:
    """Fly one flight of a kind, so that its kernels are compiled or loaded, and record the time.

    Args:
        kind: The kind.
        code: As for `compiler_time`.

    Returns:
        Processor time of the compilation; 0 if the kernels were in the cache.
    """
    before, begun = kernel_files(), time.process_time()
    if kind.alone:
        fly(dict(kind.tables))
    else:
        fly_scenarios([kind.tables])
    took, new = time.process_time() - begun, kernel_files() - before
    loaded = not new and (is_packaged(kind) or is_writable(cache_folder()))
    known = _record()
    earlier = known.pop(kind.key, None)
    entry = {
        "seconds": round(took, 2) if not loaded else earlier["seconds"] if earlier else None,
        "state": _state(code),
        "files": sorted(path.relative_to(_root()).as_posix() for path in new),
    }
    if loaded and earlier and earlier["state"] == entry["state"]:
        entry["files"] = earlier["files"]
    with contextlib.suppress(OSError):
        rest = list(known.items())[1 - MOST_RECORDED :]
        write_atomically(_root() / RECORD, json_text(dict(rest) | {kind.key: entry}))
    return 0.0 if loaded else took


_compiled: set[str] = set()
"""Kinds compiled or loaded in this process, with the state of the user's own code."""


def compile_kinds(tables: Sequence[Mapping[str, Any]], code: Mapping[str, str]) -> None:
    """Compile the kinds of some flights one by one, once in this process, and record the times.

    Args:
        tables: Scenarios of the flights.
        code: As for `compiler_time`.
    """
    for kind in flight_kinds(tables):
        if (name := f"{kind.key} {_state(code)}") not in _compiled:
            _compiled.add(name)
            if not compiler_time(kind, code).cached:
                compile_kind(kind, code)


def _root() -> Path:
    """Folder of the cache, over all states of the source."""
    return cache_folder().parents[1]


def _state(code: Mapping[str, str]) -> str:
    """Digest of the source that compiled code follows from."""
    return f"{state_digest()} {digest_of(dict(code))}"


def _record() -> dict[str, dict[str, Any]]:
    """Valid entries of the record, in the order of their age."""
    try:
        given = json.loads((_root() / RECORD).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return dict(_valid_entries(given)) if isinstance(given, dict) else {}


def _valid_entries(given: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    for key, entry in given.items():
        if (
            isinstance(entry, dict)
            and (entry.get("seconds") is None or _is_time(entry["seconds"]))
            and isinstance(entry.get("state"), str)
            and isinstance(entry.get("files"), list)
            and all(isinstance(name, str) and "\0" not in name for name in entry["files"])
        ):
            yield key, {"seconds": None} | entry


def _exists(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name that is too long
        return False


def _is_time(given: Any) -> bool:
    return isinstance(given, int | float) and 0.0 <= given < 1e6
