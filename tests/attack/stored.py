"""Results and campaigns that others changed, digests made to fit, and what is promised for them.

A change whose digest does not fit is refused by that alone (``damage.py``); here the reader behind
it is attacked, too.  A folder is either read, and then says finite numbers and as many flights as it
holds, or refused in lines that a terminal can show.  Nothing else is raised, and no other file is
touched.
"""

from __future__ import annotations

import atexit
import contextlib
import functools
import hashlib
import json
import math
import shutil
import tempfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from hypothesis import strategies as st

from attack.campaigns import all_said
from attack.inputs import paths_of, plain_values, put
from builders.campaign_folders import filled
from builders.plans import THROW
from springback.campaign import manifest, store
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.design.plan import plan_from
from springback.campaign.store import open_store, stored_plan
from springback.errors import InputError
from springback.interfaces.cli.app import environment
from springback.interfaces.replay.labels import scenes_of
from springback.interfaces.replay.signals import plain_signals
from springback.interfaces.reports.flight_files import write_flight
from springback.results.flight import fly
from springback.results.parquet import write_parquet
from springback.results.saved import load
from springback.results.sealed_json import SEAL, with_digest

SUMMARY, TRAJECTORY, DIARY = "summary.json", "trajectory.parquet", "telemetry.parquet"
PART = manifest.file_of(10)
Files = dict[str, bytes]
Columns = dict[str, Any]


class Changed(NamedTuple):
    """What files of a folder become, and by what changes."""

    told: list[str]
    files: Files

    def __repr__(self) -> str:
        return f"{sorted(self.files)}: {'; '.join(self.told)}"


json_values = st.one_of(
    plain_values.filter(lambda value: not (isinstance(value, int) and abs(value) > 10**300)),
    st.lists(st.sampled_from([0, 1.5, "x", None]), max_size=3),
)


def _folder(fill: Callable[[Path], Any]) -> tuple[Path, Files]:
    folder = Path(tempfile.mkdtemp(prefix="stored-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    fill(folder)
    return folder, _contents(folder)


def _contents(folder: Path) -> Files:
    files = (path for path in folder.rglob("*") if path.is_file() and path.name[0] != ".")
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@functools.cache
def result() -> tuple[Path, Files]:
    """A folder with a short flight with a pilot, and its files."""
    flight = fly({**THROW, "reference": {"type": "hold"}, "simulation": {"duration": 0.05}})
    return _folder(lambda folder: write_flight(flight, folder, figures=False))


@functools.cache
def campaign() -> tuple[Path, Files]:
    """A folder with a campaign, and its files."""
    return _folder(filled)


# -- changes --------------------------------------------------------------------------------------


def _json(tables: Any) -> bytes:
    return json.dumps(tables).encode("utf-8", "surrogatepass")


@st.composite
def _changed(draw: st.DrawFn, tables: Any, told: list[str]) -> Any:
    """Plain data with up to three values exchanged or left out."""
    for _ in range(draw(st.integers(1, 3))):
        path = draw(st.sampled_from(paths_of(tables) or [("x",)]))
        if draw(st.integers(0, 3)):
            value = draw(json_values)
            told.append(f"{path} = {value!r}")
            tables = put(tables, path, value)
        else:
            told.append(f"without {path}")
            tables = _without(tables, path)
    return tables


def _without(node: Any, path: tuple[str | int, ...]) -> Any:
    head, *rest = path
    if isinstance(node, dict):
        kept = {key: value for key, value in node.items() if key != head}
        return kept | ({head: _without(node[head], tuple(rest))} if rest and head in node else {})
    if isinstance(node, list) and isinstance(head, int) and head < len(node):
        middle = [_without(node[head], tuple(rest))] if rest else []
        return node[:head] + middle + node[head + 1 :]
    return node


def _sealed(tables: Any) -> Any:
    """With a digest that fits, where anything can have one."""
    try:
        return with_digest({key: value for key, value in tables.items() if key != SEAL})
    except (AttributeError, TypeError, ValueError):
        return tables


@st.composite
def _bytes(draw: st.DrawFn, data: bytes, told: list[str]) -> bytes:
    """Bytes cut out, doubled, exchanged or put in."""
    first = draw(st.integers(0, len(data)))
    last = min(len(data), first + draw(st.sampled_from([0, 1, 2, 50, len(data)])))
    new = draw(st.one_of(st.binary(max_size=8), st.just(2 * data[first:last])))
    told.append(f"[{first}:{last}] = {new[:40]!r}")
    return data[:first] + new + data[last:]


@st.composite
def _tables(draw: st.DrawFn, columns: Columns, told: list[str]) -> bytes:
    """Parquet with columns left out, renamed, of another kind or length, or with odd values."""
    columns = dict(columns)
    for _ in range(draw(st.integers(1, 3))):
        name, count = draw(st.sampled_from(sorted(columns))), len(next(iter(columns.values())))
        how = draw(
            st.sampled_from(["left out", "renamed", "text", "odd", "short", "whole", "empty"])
        )
        told.append(f"{name} {how}")
        if how == "left out":
            del columns[name]
        elif how == "renamed":
            columns[draw(st.sampled_from(["flight", 'a"b', "\x1b[2J", "é"]))] = columns.pop(name)
        elif how == "text":
            columns[name] = np.array(["\x1b[31mred"] * count, dtype=object)
        elif how == "odd":
            odd = draw(st.sampled_from([math.nan, math.inf, -1e300, 0.0, 1e300]))
            columns[name] = np.full(count, odd)
        elif how == "short":
            length = draw(st.integers(0, 2))
            columns = {key: values[:length] for key, values in columns.items()}
        elif how == "whole":
            columns[name] = np.arange(count, dtype=np.int64)
        else:
            columns[name] = np.full(count, None, dtype=object)
        columns = columns or {"t": np.zeros(2)}
    about = draw(st.sampled_from([{}, {"units": "[1]"}, {"units": "x"}, {"units": '{"x": 3}'}]))
    return _parquet(columns, about)


def _parquet(columns: Columns, about: dict[str, str]) -> bytes:
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "x.parquet"
        write_parquet(path, columns, {}, about)
        return path.read_bytes()


@functools.cache
def _columns(kind: str) -> Columns:
    if kind == "part":
        answer = Campaign(campaign()[0]).query("FROM flights LIMIT 10")
        return {
            name: np.array([row[k] for row in answer.rows], dtype=object)
            if any(isinstance(row[k], str) for row in answer.rows)
            else np.array([math.nan if row[k] is None else row[k] for row in answer.rows])
            for k, name in enumerate(answer.columns)
        }
    read = load(result()[0])
    return dict(read.columns if kind == "trajectory" else read.telemetry)


@st.composite
def results(draw: st.DrawFn) -> Changed:
    """What files of a result folder become."""
    told: list[str] = []
    files = result()[1]
    summary = json.loads(files[SUMMARY])
    how = draw(st.sampled_from(["bytes", "values", "values", "columns", "bytes of columns"]))
    if how == "bytes":
        return Changed(told, {SUMMARY: draw(_bytes(files[SUMMARY], told))})
    if how == "values":
        return Changed(told, {SUMMARY: _json(_sealed(draw(_changed(summary, told))))})
    kind = draw(st.sampled_from(["trajectory", "telemetry"]))
    name = f"{kind}.parquet"
    changed = _tables(_columns(kind), told) if how == "columns" else _bytes(files[name], told)
    data = draw(changed)
    summary["files"][name] = hashlib.sha256(data).hexdigest()
    return Changed(told, {name: data, SUMMARY: _json(_sealed(summary))})


@st.composite
def ledgers(draw: st.DrawFn) -> Changed:
    """What ledger, plan or `campaign.json` of a folder become."""
    told: list[str] = []
    files = campaign()[1]
    how = draw(st.sampled_from(["bytes", "about", "plan", "lines", "lines"]))
    if how == "bytes":
        name = draw(st.sampled_from([manifest.NAME, store.METADATA, store.PLAN]))
        return Changed(told, {name: draw(_bytes(files[name], told))})
    if how == "about":
        about = draw(_changed(json.loads(files[store.METADATA]), told))
        return Changed(told, {store.METADATA: _json(_sealed(about))})
    if how == "plan":
        plan = _json(draw(_changed(json.loads(files[store.PLAN]), told)))
        about = json.loads(files[store.METADATA])
        about["plan_file_sha256"] = hashlib.sha256(plan).hexdigest()
        with contextlib.suppress(Exception):  # no plan at all: the reader is to say so
            about["plan_sha256"] = plan_from(json.loads(plan)).digest()
        return Changed(told, {store.PLAN: plan, store.METADATA: _json(_sealed(about))})
    lines = [json.loads(line) for line in files[manifest.NAME].splitlines()]
    for _ in range(draw(st.integers(1, 3))):
        k = draw(st.integers(0, len(lines) - 1))
        line = _sealed(draw(_changed(lines[k], told))) if draw(st.booleans()) else lines[k]
        how = draw(st.sampled_from(["replaced", "put in", "left out"]))
        told.append(f"line {k + 1} {how}")
        put_in = {"replaced": [line], "put in": [lines[k], line], "left out": []}[how]
        lines = [*lines[:k], *put_in, *lines[k + 1 :]] or [line]
    end = draw(st.sampled_from([b"\n", b"", b"\n{", b"\n\n"]))
    return Changed(told, {manifest.NAME: b"\n".join(map(_json, lines)) + end})


@st.composite
def parts(draw: st.DrawFn) -> Changed:
    """What a part becomes, with its digest and size in the ledger."""
    told: list[str] = []
    files = campaign()[1]
    columns = draw(st.booleans()) or draw(st.booleans())
    return _with_part(
        draw(_tables(_columns("part"), told) if columns else _bytes(files[PART], told)), told
    )


def part_with(values: dict[str, float]) -> Changed:
    """A part in which some columns hold one value throughout."""
    columns = dict(_columns("part"))
    count = len(columns["flight"])
    columns |= {name: np.full(count, value) for name, value in values.items()}
    return _with_part(
        _parquet(columns, {}), [f"{name} = {value}" for name, value in values.items()]
    )


def _with_part(data: bytes, told: list[str]) -> Changed:
    """A part, with its digest and size in the ledger."""
    files = campaign()[1]
    fitting = {"bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}
    lines = [json.loads(line) for line in files[manifest.NAME].splitlines()]
    lines = [_sealed(line | fitting) if line["file"] == PART else line for line in lines]
    return Changed(told, {PART: data, manifest.NAME: b"\n".join(map(_json, lines)) + b"\n"})


# -- what is promised -----------------------------------------------------------------------------


@contextlib.contextmanager
def _become(folder: Path, files: Files, changed: Files) -> Iterator[None]:
    """Files of a folder are others for a while; nothing but them has changed afterwards."""
    for name, data in changed.items():
        (folder / name).write_bytes(data)
    try:
        yield
        assert _contents(folder) == files | changed
    finally:
        for name in changed:
            (folder / name).write_bytes(files[name])


def result_files(changed: Changed) -> None:
    """As `springback view` does."""
    folder, files = result()
    with _become(folder, files, changed.files):
        flight = load(folder)
        assert all(value is None or math.isfinite(value) for value in flight.measures.values())
        json.dumps(flight.summary(), allow_nan=False).encode()
        repr(flight).encode()
        [scene] = scenes_of([flight], [folder])
        json.dumps(plain_signals(flight, scene), allow_nan=False)


def campaign_files(changed: Changed, *, summed: bool | None = None) -> None:
    """As `query`, `--resume` without flying and, one time in eight, `summary` do."""
    folder, files = campaign()
    with _become(folder, files, changed.files):
        try:
            if summed is None:
                summed = zlib.crc32(repr(changed).encode("utf-8", "replace")) % 8 == 0
            rows, *_ = all_said(folder, summed=summed)
        except (
            Exception
        ) as error:  # of a part that ends early DuckDB says that the disk is at fault
            said = environment(error)
            raise error if said is None else InputError(said) from error
        assert len(rows.rows) == manifest.flight_count(manifest.read(folder / manifest.NAME))
        with open_store(folder, lay_out(stored_plan(folder)), resume=True):
            pass
