"""The folder of a campaign: parts written whole or not at all, and one process at a time.

plan.json       the plan, its scenario read in
campaign.json   when and where it was begun, with which versions
ledger.jsonl    which parts there are
parts/          rows, in Parquet
kept/           trajectories of selected flights
"""

from __future__ import annotations

import contextlib
import datetime
import errno
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

from springback.errors import InputError
from springback.experiments.campaign import ledger
from springback.experiments.campaign.columns import known_columns
from springback.experiments.campaign.design import HEAD, Design
from springback.experiments.campaign.stopped import Stopped
from springback.experiments.database import named
from springback.experiments.parquet import write_parquet
from springback.experiments.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measures import MEASURES
from springback.version import __version__

Columns = Mapping[str, Any]
PLAN, ABOUT, PARTS, ASIDE, LOCK, HOLDER = (
    "plan.json", "campaign.json", "parts", "aside", ".lock", ".holder.json",
)  # fmt: skip
#: Packages whose versions can change the last digits of a result.
NUMERICAL = ("numpy", "scipy", "numba")
#: What may lie in a folder that no campaign has begun in: what one leaves that died at once.
EARLY = {LOCK, HOLDER, PLAN, PARTS}


def versions() -> dict[str, str]:
    """Of all that decides the bits of a result."""
    return {
        "springback": __version__,
        "python": platform.python_version(),
        **{name: metadata.version(name) for name in NUMERICAL},
    }


def written(path: Path, data: bytes) -> None:
    """Write a file whole or not at all, and onto the disk."""
    draft = path.with_name(f".{path.name}.draft")
    try:
        with draft.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        _moved(draft, path)
    finally:
        draft.unlink(missing_ok=True)


def _moved(draft: Path, path: Path) -> None:
    """Rename, and have the folder say so on the disk."""
    os.replace(draft, path)
    if os.name == "posix":
        folder = os.open(path.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)


class Store:
    """The folder of a campaign that is being flown, held by one process; see `opened`."""

    def __init__(self, folder: Path, design: Design) -> None:
        """Of a folder that is there."""
        self.folder, self.design = folder, design
        self.parts: list[ledger.Part] = ledger.read(folder / ledger.NAME)

    @property
    def done(self) -> int:
        """Number of flights that are kept."""
        return ledger.held(self.parts)

    def missing(self, chunk: int) -> list[tuple[int, int]]:
        """Stretches still to be flown."""
        return ledger.missing(self.parts, self.design.flights, chunk)

    def add(self, first: int, last: int, columns: Columns) -> ledger.Part:
        """Keep the rows of a stretch of flights.

        Raises:
            Stopped: If they cannot be written; nothing half-written is left.
        """
        name = f"{PARTS}/part-{first:010d}.parquet"
        path = self.folder / name
        draft = path.with_name(f".{path.name}.draft")
        try:
            path.parent.mkdir(exist_ok=True)
            write_rows(draft, columns, self.design)
            with draft.open("rb+") as file:
                os.fsync(file.fileno())
                digest = hashlib.file_digest(file, "sha256").hexdigest()
            size = draft.stat().st_size
            _moved(draft, path)
            refused = sum(word == "refused" for word in columns["outcome"])
            wary = int(sum(value == 1.0 for value in columns["ledger_open"]))
            part = ledger.Part(first, last, name, size, digest, refused, wary)
            ledger.append(self.folder / ledger.NAME, part)
        except Exception as error:
            if not is_disk(error):
                raise
            raise Stopped(f"{name} cannot be written: {_reason(error)}") from error
        finally:
            with contextlib.suppress(OSError):
                draft.unlink(missing_ok=True)
        self.parts = sorted([*self.parts, part], key=lambda one: one.first)
        return part

    def checked_parts(self) -> list[str]:
        """Move aside what is damaged or not in the ledger; say what was moved, line by line."""
        said = []
        ledger.mend(self.folder / ledger.NAME)
        for part in [part for part in self.parts if not part.whole(self.folder)]:
            there = self._set_aside(self.folder / part.file)
            what = f"is damaged; it is now {there}" if there else "is missing"
            said.append(f"{part.file} {what}; its flights are flown again")
            withdrawn = ledger.Part(part.first, part.last, part.file, 0, "", withdrawn=True)
            ledger.append(self.folder / ledger.NAME, withdrawn)
            self.parts.remove(part)
        known = {part.file for part in self.parts}
        for path in sorted((self.folder / PARTS).glob("*")):
            if path.name.endswith(".draft"):
                path.unlink()
            elif path.is_file() and f"{PARTS}/{path.name}" not in known:
                there = self._set_aside(path)
                said.append(f"{PARTS}/{path.name} is not in the ledger; it is now {there}")
        return said

    def _set_aside(self, path: Path) -> str:
        if not path.exists():
            return ""
        aside = self.folder / ASIDE
        aside.mkdir(exist_ok=True)
        free = (aside / f"{path.name}.{k}" for k in range(10**9))
        there = next(target for target in free if not target.exists())
        os.replace(path, there)
        return str(there.relative_to(self.folder))


def write_rows(path: Path, columns: Columns, design: Design) -> None:
    """Rows as Parquet: numbers that do not exist are empty, success as the plan has it."""
    units = {name: unit for name, (unit, _) in known_columns().items()} | design.units
    about = {"springback": __version__, "plan": design.plan.digest(), "name": design.plan.name}
    write_parquet(path, arrays(columns, design), units, about, select=rows_of(design))


def arrays(columns: Columns, design: Design) -> dict[str, Any]:
    """Columns of rows as arrays of their types."""
    words = {d.column for d in design.dimensions if d.text} | {"robot", "outcome", "problem"}
    kinds = dict.fromkeys(("flight", "sample", "repeat", "seed"), np.int64)
    found = {}
    for name, values in columns.items():
        kind: Any = object if name in words else kinds.get(name, np.float64)
        found[name] = np.asarray(values, dtype=kind)
    return found


def rows_of(design: Design) -> str:
    """The rows of a campaign in SQL, from columns as they were flown."""
    head = ", ".join(named(name) for name in (*HEAD, *design.units))
    measures = ", ".join(
        f"nullif({named(name)}, 'NaN'::DOUBLE) AS {named(name)}"
        for name in (MEASURES | RECOVERY_MEASURES)
    )
    flown = f"SELECT {head}, outcome, problem, {measures} FROM given"
    won = f"CASE WHEN outcome <> 'refused' THEN ({design.success}) END"
    success = f"({won})::TINYINT AS success"  # so that both NOT success and avg(success) work
    rest = ", ".join(named(name) for name in (MEASURES | RECOVERY_MEASURES))
    return f"SELECT {head}, outcome, {success}, problem, {rest} FROM ({flown})"


def empty_rows(design: Design) -> dict[str, Any]:
    """Columns as they are flown, without rows."""
    names = (*HEAD, *design.units, "outcome", "problem", *(MEASURES | RECOVERY_MEASURES))
    return arrays({name: [] for name in names}, design)


def is_disk(error: BaseException) -> bool:
    """Whether the disk is at fault, not the program; DuckDB has errors of its own."""
    return isinstance(error, OSError) or type(error).__name__ in ("IOException", "FatalException")


def _reason(error: BaseException) -> str:
    text = str(error)
    if getattr(error, "errno", None) == errno.ENOSPC or "No space left" in text:
        return "no space is left on the disk"
    return getattr(error, "strerror", None) or text.partition("\n")[0]


# -- begin, or go on ------------------------------------------------------------------------------


@contextlib.contextmanager
def opened(folder: Path, design: Design, *, resume: bool) -> Iterator[Store]:
    """The folder of a campaign, new or begun before, held until the block ends.

    Args:
        folder: Is made if it is not there.
        design: Of the campaign.
        resume: Whether a campaign that is in it may be gone on with.

    Raises:
        InputError: If it holds another campaign or other things, or another process holds it.
        Stopped: If it cannot be written to.
    """
    if folder.exists() and not folder.is_dir():
        raise InputError(f"--out {folder}: is a file, not a folder")
    begun = (folder / ABOUT).exists()
    names = {path.name for path in folder.iterdir()} if folder.exists() else set[str]()
    others = {name for name in names - EARLY if not name.endswith(".draft")}
    if others and not begun:
        raise InputError(f"--out {folder}: is not empty, and holds no campaign; give another")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _held(folder):
            if begun and not resume:
                raise InputError(_in_the_way(folder, design))
            if begun:
                _check_same(folder, design)
            else:
                _begin(folder, design)
            yield Store(folder, design)
    except OSError as error:
        if not is_disk(error):
            raise
        raise Stopped(f"--out {folder}: cannot be written to: {_reason(error)}") from error


@contextlib.contextmanager
def _held(folder: Path) -> Iterator[None]:
    """Hold a folder; the system lets go of it when this process ends, however that comes about."""
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
        written(holder, json.dumps(who).encode())
        yield
    finally:
        with contextlib.suppress(OSError):
            holder.unlink(missing_ok=True)
        lock.release()


def _now() -> str:
    return datetime.datetime.now().astimezone().isoformat(timespec="seconds")


def _in_the_way(folder: Path, design: Design) -> str:
    done = ledger.held(ledger.read(folder / ledger.NAME))
    return (
        f"--out {folder}: holds a campaign with {done} flights; go on with it by --resume, or give "
        "another folder"
    )


def _begin(folder: Path, design: Design) -> None:
    """Write down what is flown, where, and with what."""
    plan = json.loads(design.plan.canonical())
    written(folder / PLAN, json.dumps(plan, indent=2, ensure_ascii=False).encode() + b"\n")
    about = {
        "name": design.plan.name, "seed": design.plan.seed, "plan_sha256": design.plan.digest(),
        "flights": design.flights, "robots": list(design.robots), "started": _now(),
        "versions": versions(), "host": socket.gethostname(), "cpu": _cpu(),
        "cores": os.cpu_count(), "system": platform.platform(),
        "units": design.units,
    }  # fmt: skip
    written(folder / ABOUT, json.dumps(about, indent=2, ensure_ascii=False).encode() + b"\n")


def _cpu() -> str:
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def about(folder: Path) -> dict[str, Any]:
    """What `campaign.json` says.

    Raises:
        InputError: If there is none, or it cannot be read.
    """
    path = folder / ABOUT
    try:
        found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InputError(f"{folder}: holds no campaign ({ABOUT} is missing)") from None
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read ({error})") from None
    return found


def _check_same(folder: Path, design: Design) -> None:
    """Refuse to go on with another plan, seed or version."""
    known = about(folder)
    pairs = {
        "seed": (known.get("seed"), design.plan.seed),
        "springback's version": (known["versions"].get("springback"), __version__),
        "plan": (known.get("plan_sha256"), design.plan.digest()),
    }
    told = [
        f"its {name} is {before}, not {now}"
        for name, (before, now) in pairs.items()
        if before != now and name != "plan"
    ]
    if not told and pairs["plan"][0] != pairs["plan"][1]:
        told = [_difference(folder, design)]
    if told:
        raise InputError(f"--out {folder}: holds another campaign: {'; '.join(told)}")


def _difference(folder: Path, design: Design) -> str:
    """Which entries of two plans differ."""
    before = json.loads((folder / PLAN).read_text(encoding="utf-8"))
    now = json.loads(design.plan.canonical())
    keys: Sequence[str] = [key for key in now if before.get(key) != now[key]]
    return f"its plan differs in {', '.join(keys) or 'something'} (see {folder / PLAN})"


def changed_versions(folder: Path) -> list[str]:
    """Versions other than springback's that changed since the campaign was begun, in words."""
    before, now = about(folder)["versions"], versions()
    return [
        f"{name} was {before.get(name)} and is {now[name]}; last digits may differ"
        for name in ("python", *NUMERICAL)
        if before.get(name) != now[name]
    ]
