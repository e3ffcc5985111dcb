"""Folder of a campaign: complete parts, locked by one process at a time.

plan.json       the plan with its scenario
campaign.json   time, host and versions at its start
manifest.jsonl  manifest of the parts
parts/          rows as Parquet
kept/           trajectories of selected flights
aside/          damaged or unlisted parts
"""

from __future__ import annotations

import contextlib
import datetime
import errno
import functools
import hashlib
import json
import os
import platform
import socket
from collections.abc import Iterator, Mapping, Sequence
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
from filelock import FileLock, Timeout

from springback.campaign import manifest
from springback.campaign.columns import SECOND_OUTCOME, known_columns, measured_columns
from springback.campaign.design.layout import HEAD, Design
from springback.campaign.design.plan import Plan, plan_from
from springback.campaign.errors import CampaignError
from springback.campaign.manifest import PARTS, file_of
from springback.errors import InputError
from springback.files import DRAFT, atomic_file, json_text, write_atomically
from springback.results.database import identifier, one_expression
from springback.results.parquet import write_parquet
from springback.results.sealed_json import file_digest, is_sealed, read_object, with_digest
from springback.version import __version__

Columns = Mapping[str, Any]
PLAN, METADATA, QUARANTINE, LOCK, HOLDER = (
    "plan.json", "campaign.json", "aside", ".lock", ".holder.json",
)  # fmt: skip
#: Packages whose versions can affect the last digits of a result.
#: Columns of words of every flight.
WORDS = ("outcome", "problem", "first_obstacle")
NUMERICAL = ("numpy", "scipy", "numba")
#: Files that may be in a folder without a campaign: those of one that died at its start.
EARLY = {LOCK, HOLDER, PLAN, PARTS}


#: Packages that rows do not depend on.
SHOWING = "interfaces"


@functools.cache
def source() -> str:
    """Digest of the package's source that rows can depend on, including presets.

    Unlike the version it changes between releases.
    """
    package = Path(__file__).parents[1]
    digest = hashlib.sha256()
    for path in sorted(package.rglob("*.py")):
        name = path.relative_to(package)
        if name.parts[0] != SHOWING:
            digest.update(name.as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def versions() -> dict[str, str]:
    """Versions of everything that determines the bits of a result."""
    return {
        "springback": __version__,
        "source": source(),
        "python": platform.python_version(),
        **{name: metadata.version(name) for name in NUMERICAL},
    }


class Store:
    """Folder of a campaign that is being flown, locked by one process; see `open_store`."""

    def __init__(self, folder: Path, design: Design) -> None:
        """Store in an existing folder."""
        self.folder, self.design = folder, design
        self.parts: list[manifest.Part] = manifest.read(folder / manifest.NAME)

    @property
    def done(self) -> int:
        """Number of stored flights."""
        return manifest.flight_count(self.parts)

    def missing(self, chunk: int) -> list[tuple[int, int]]:
        """Chunks still to be flown."""
        return manifest.missing(self.parts, self.design.flights, chunk)

    def add(self, first: int, last: int, columns: Columns) -> manifest.Part:
        """Store the rows of a chunk of flights.

        Raises:
            CampaignError: If they cannot be written; no incomplete file remains.
        """
        name = file_of(first)
        path = self.folder / name
        try:
            path.parent.mkdir(exist_ok=True)
            with atomic_file(path, durable=True) as draft:
                write_rows(draft, columns, self.design)
                digest, size = file_digest(draft), draft.stat().st_size
            refused = sum(word == "refused" for word in columns["outcome"])
            open_ledgers = int(sum(value == 1.0 for value in columns["ledger_open"]))
            part = manifest.Part(first, last, name, size, digest, refused, open_ledgers)
            manifest.append(self.folder / manifest.NAME, part)
        except Exception as error:
            if not is_disk(error):
                raise
            raise CampaignError(f"{name} cannot be written: {_reason(error)}") from error
        self.parts = sorted([*self.parts, part], key=lambda one: one.first)
        return part

    def checked_parts(self) -> list[str]:
        """Rename damaged or unlisted files; returns a message for each."""
        said = []
        manifest.mend(self.folder / manifest.NAME)
        for part in manifest.damaged_parts(self.parts, self.folder):
            there = self._set_aside(self.folder / part.file)
            what = f"is damaged; it is now {there}" if there else "is missing"
            said.append(f"{part.file} {what}; its flights are flown again")
            withdrawn = manifest.Part(part.first, part.last, part.file, 0, "", withdrawn=True)
            manifest.append(self.folder / manifest.NAME, withdrawn)
            self.parts.remove(part)
        known = {part.file for part in self.parts}
        for path in sorted(self.folder.glob(f".*{DRAFT}")):
            path.unlink()
        for path in sorted((self.folder / PARTS).glob("*")):
            if path.name.endswith(DRAFT):
                path.unlink()
            elif path.is_file() and f"{PARTS}/{path.name}" not in known:
                there = self._set_aside(path)
                said.append(f"{PARTS}/{path.name} is not in the manifest; it is now {there}")
        return said

    def _set_aside(self, path: Path) -> str:
        if not path.exists():
            return ""
        quarantine = self.folder / QUARANTINE
        quarantine.mkdir(exist_ok=True)
        free = (quarantine / f"{path.name}.{k}" for k in range(10**9))
        there = next(target for target in free if not target.exists())
        os.replace(path, there)
        return str(there.relative_to(self.folder))


def write_rows(path: Path, columns: Columns, design: Design) -> None:
    """Write rows as Parquet, with NULL for missing numbers, and success as defined by the plan."""
    units = {name: unit for name, (unit, _) in known_columns().items()} | design.units
    about = {
        "springback": __version__, "source": source(), "plan": design.plan.digest(),
        "scenarios": design.digest, "name": design.plan.name,
    }  # fmt: skip
    write_parquet(path, arrays(columns, design), units, about, select=rows_of(design))


def arrays(columns: Columns, design: Design) -> dict[str, Any]:
    """Columns as arrays of their types."""
    words = {d.column for d in design.dimensions if d.text} | {"robot", *WORDS}
    words |= {*SECOND_OUTCOME}
    kinds = dict.fromkeys(("flight", "sample", "repeat", "seed"), np.int64)
    found = {}
    for name, values in columns.items():
        kind: Any = object if name in words else kinds.get(name, np.float64)
        found[name] = np.asarray(values, dtype=kind)
    return found


def rows_of(design: Design) -> str:
    """SQL of the rows of a campaign, from the columns of its flights."""
    head = ", ".join(identifier(name) for name in (*HEAD, *design.units))
    measures = ", ".join(
        f"nullif({identifier(name)}, 'NaN'::DOUBLE) AS {identifier(name)}"
        for name in measured_columns(second=design.has_second)
    )
    words = ", ".join([*WORDS, *(SECOND_OUTCOME if design.has_second else ())])
    flown = f"SELECT {head}, {words}, {measures} FROM given"
    try:
        condition = one_expression(design.success)
    except InputError as error:
        raise InputError(f"success: {error}") from None
    won = f"CASE WHEN outcome <> 'refused' THEN {condition} END"
    success = f"({won})::TINYINT AS success"  # so that both NOT success and avg(success) work
    names = (*(SECOND_OUTCOME if design.has_second else ()),
             *measured_columns(second=design.has_second))  # fmt: skip
    rest = ", ".join(map(identifier, names))
    return f"SELECT {head}, outcome, {success}, problem, first_obstacle, {rest} FROM ({flown})"


def empty_rows(design: Design) -> dict[str, Any]:
    """Columns of flights, without rows."""
    outcomes = (*WORDS, *(SECOND_OUTCOME if design.has_second else ()))
    names = (*HEAD, *design.units, *outcomes, *measured_columns(second=design.has_second))
    return arrays({name: [] for name in names}, design)


def is_disk(error: BaseException) -> bool:
    """True if an error, possibly one of DuckDB, is due to the disk and not to the program."""
    return isinstance(error, OSError) or type(error).__name__ in ("IOException", "FatalException")


def _reason(error: BaseException) -> str:
    text = str(error)
    if getattr(error, "errno", None) == errno.ENOSPC or "No space left" in text:
        return "no space is left on the disk"
    return getattr(error, "strerror", None) or text.partition("\n")[0]


# -- begin, or go on ------------------------------------------------------------------------------


@contextlib.contextmanager
def open_store(folder: Path, design: Design, *, resume: bool) -> Iterator[Store]:
    """Folder of a new or resumed campaign, locked until the block ends.

    Args:
        folder: Folder, created if it does not exist.
        design: Design of the campaign.
        resume: Continue a campaign in it.

    Raises:
        InputError: If it has another campaign or other files, or is locked by another process.
        CampaignError: If it cannot be written to.
    """
    if folder.exists() and not folder.is_dir():
        raise InputError(f"--out {folder}: is a file, not a folder")
    begun = (folder / METADATA).exists()
    names = {path.name for path in folder.iterdir()} if folder.exists() else set[str]()
    others = {name for name in names - EARLY if not name.endswith(DRAFT)}
    if others and not begun:
        raise InputError(f"--out {folder}: is not empty and has no campaign; give another")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _lock(folder):
            if begun and not resume:
                raise InputError(_in_the_way(folder))
            if begun:
                _check_same(folder, design)
            else:
                _begin(folder, design)
            yield Store(folder, design)
    except OSError as error:
        if not is_disk(error):
            raise
        raise CampaignError(f"--out {folder}: cannot be written to: {_reason(error)}") from error


@contextlib.contextmanager
def _lock(folder: Path) -> Iterator[None]:
    """Lock a folder; the system unlocks it when this process ends, however it ends."""
    lock, holder = FileLock(folder / LOCK, timeout=0), folder / HOLDER
    try:
        lock.acquire()
    except Timeout:
        who = {}
        with contextlib.suppress(OSError, ValueError):
            who = json.loads(holder.read_text())
        by = "process {pid} on {host} since {since}".format_map(who) if who else "another process"
        raise InputError(f"--out {folder}: is in use by {by}") from None
    try:
        who = {"pid": os.getpid(), "host": socket.gethostname(), "since": _now()}
        write_atomically(holder, json.dumps(who), durable=True)
        yield
    finally:
        with contextlib.suppress(OSError):
            holder.unlink(missing_ok=True)
        lock.release()


def _now() -> str:
    return datetime.datetime.now().astimezone().isoformat(timespec="seconds")


def _in_the_way(folder: Path) -> str:
    done = manifest.flight_count(manifest.read(folder / manifest.NAME))
    return (
        f"--out {folder}: contains a campaign with {done} flights; continue it with --resume, or "
        "give another folder"
    )


def _begin(folder: Path, design: Design) -> None:
    """Write plan, host and versions."""
    plan = json_text(json.loads(design.plan.canonical()))
    write_atomically(folder / PLAN, plan, durable=True)
    about = {
        "name": design.plan.name, "seed": design.plan.seed, "plan_sha256": design.plan.digest(),
        "plan_file_sha256": hashlib.sha256(plan.encode()).hexdigest(),
        "flights": design.flights, "robots": list(design.robots), "started": _now(),
        "versions": versions(), "host": socket.gethostname(), "cpu": _cpu(),
        "cores": os.cpu_count(), "system": platform.platform(),
        "units": design.units, "code": design.code, "scenarios_sha256": design.digest,
        "scenarios": dict(zip(design.robots, design.full_scenarios, strict=True)),
    }  # fmt: skip
    write_atomically(folder / METADATA, json_text(with_digest(about)), durable=True)


def _cpu() -> str:
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


#: Required entries of `campaign.json`.
_NEEDED: dict[str, type] = {
    "name": str, "flights": int, "seed": int, "host": str, "plan_sha256": str,
    "plan_file_sha256": str, "versions": dict, "units": dict, "code": dict, "robots": list,
    "scenarios_sha256": str, "cpu": str,
}  # fmt: skip


def read_metadata(folder: Path) -> dict[str, Any]:
    """Validated content of ``campaign.json``.

    Raises:
        InputError: If it is missing, cannot be read, or was altered.
    """
    path = folder / METADATA
    try:
        found = read_object(path)
    except FileNotFoundError:
        if not folder.exists():
            raise InputError(f"{folder}: there is no such folder") from None
        raise InputError(f"{folder}: has no campaign ({METADATA} is missing)") from None
    if not is_sealed(found):
        raise InputError(f"{path}: is damaged, or was written by another version or edited")
    for name, kind in _NEEDED.items():
        if type(found.get(name)) is not kind:
            raise InputError(f"{path}: {name}: is missing or of another kind")
    return found


def stored_plan(folder: Path) -> Plan:
    """Stored plan of a campaign.

    Raises:
        InputError: If it cannot be read, or was altered.
    """
    path, known = folder / PLAN, read_metadata(folder)
    try:
        given = read_object(path)
        digest = file_digest(path)
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    if digest != known["plan_file_sha256"]:
        raise InputError(f"{path}: is damaged or was edited; it is not the original plan")
    if not isinstance(given.get("scenario"), dict):
        raise InputError(f"{path}: scenario: must be a table")
    plan = plan_from(given)
    if plan.digest() != known["plan_sha256"]:
        raise InputError(f"{path}: is not the plan that {METADATA} names")
    return plan


def _check_same(folder: Path, design: Design) -> None:
    """Reject another plan, seed, version, source or preset."""
    known = read_metadata(folder)
    pairs = {
        "seed": (known["seed"], design.plan.seed),
        "springback's version": (known["versions"].get("springback"), __version__),
    }
    changes = [
        f"its {name} is {old}, not {new}" for name, (old, new) in pairs.items() if old != new
    ]
    if not changes and known["plan_sha256"] != design.plan.digest():
        changes = [_difference(folder, design)]
    if not changes and known["scenarios_sha256"] != design.digest:
        changes = ["a preset or a default that its plan uses has changed"]
    if not changes and known["code"] != design.code:
        changes = [_changed_code(known["code"], design.code)]
    if not changes and known["versions"].get("source") != source():
        changes = [
            f"springback's source ({source()}) differs from that at its start "
            f"({known['versions'].get('source')}), though the version is the same; finish it with "
            "that one, or start a new campaign"
        ]
    if changes:
        raise InputError(f"--out {folder}: contains another campaign: {'; '.join(changes)}")


def _changed_code(before: Mapping[str, Any], now: Mapping[str, str]) -> str:
    """Names of the user's own files in which a campaign and its plan differ."""
    paths = [path for path in {**before, **now} if before.get(path) != now.get(path)]
    return f"{', '.join(paths)} {'has' if len(paths) == 1 else 'have'} changed since it began"


def _difference(folder: Path, design: Design) -> str:
    """Names of the entries in which two plans differ."""
    before = json.loads(stored_plan(folder).canonical())
    now = json.loads(design.plan.canonical())
    keys: Sequence[str] = [key for key in now if before.get(key) != now[key]]
    return f"its plan differs in {', '.join(keys) or 'something'} (see {folder / PLAN})"


def changed_versions(folder: Path) -> list[str]:
    """Messages about versions and processor that have changed since the campaign was started."""
    known, now = read_metadata(folder), versions()
    before = known["versions"]
    said = [
        f"{name} was {before.get(name)} and is {now[name]}; last digits may differ"
        for name in ("python", *NUMERICAL)
        if before.get(name) != now[name]
    ]
    if known["cpu"] != _cpu():
        said.append(f"the processor was {known['cpu']} and is {_cpu()}; last digits may differ")
    return said
