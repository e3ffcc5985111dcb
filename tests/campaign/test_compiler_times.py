"""What is known of compiling: recorded by kind of flight, true to the cache, and never trusted."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from builders.plans import THROW
from springback.campaign import compiler_times, cost_estimate
from springback.campaign.compiler_times import (
    RECORD,
    TYPICAL,
    FlightKind,
    compile_kind,
    compile_kinds,
    compiler_time,
    flight_kinds,
)

HOVER: dict[str, Any] = {
    "vehicle": "arq", "reference": {"type": "hold"}, "simulation": {"duration": 0.1},
}  # fmt: skip


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache, in which flying a kind writes a file of its own unless it is there."""
    monkeypatch.setenv("SPRINGBACK_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(compiler_times, "_compiled", set())

    def fly(tables: list[Any]) -> None:
        [kind] = flight_kinds(tables)
        path = compiler_times.cache_folder() / f"{kind.key}-0.kernel"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()

    monkeypatch.setattr(compiler_times, "fly_scenarios", fly)
    return tmp_path


def test_kinds_differ_in_types_not_in_numbers() -> None:
    other = {**THROW, "start": {**THROW["start"], "velocity": [1.0, 0, 0]}}
    locked = {**THROW, "vehicle": "quad"}
    kinds = flight_kinds([THROW, other, HOVER, locked, {"vehicle": "nothing"}])
    assert [kind.guided for kind in kinds[:2]] == [False, True]
    assert len({kind.key for kind in kinds}) == len(kinds) <= 3
    [alone] = flight_kinds([THROW], alone=True)
    assert alone.key != kinds[0].key  # another kernel


def test_the_record_knows_what_was_compiled_and_how_long_it_took(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    [kind] = flight_kinds([THROW])
    assert compiler_time(kind, {}) == (TYPICAL[False], False, False)
    times = iter([1.0, 13.5, 20.0, 20.5])
    monkeypatch.setattr(compiler_times.time, "process_time", lambda: next(times))
    assert compile_kind(kind, {}) == 12.5
    assert compiler_time(kind, {}) == (12.5, True, True)
    assert compile_kind(kind, {}) == 0.0  # loaded
    assert compiler_time(kind, {}) == (12.5, True, True)
    assert compiler_time(kind, {"mine.py": "1"}) == (12.5, True, False)  # the user's file changed
    shutil.rmtree(cache / "kernels")
    assert compiler_time(kind, {}) == (12.5, True, False)


def test_kernels_that_something_else_compiled_are_known_once_loaded(cache: Path) -> None:
    [kind] = flight_kinds([THROW])
    compiler_times.fly_scenarios([THROW])  # as `springback fly` does
    assert not compiler_time(kind, {}).cached
    assert compile_kind(kind, {}) == 0.0
    assert compiler_time(kind, {}) == (TYPICAL[False], False, True)


def test_kinds_that_came_with_the_package_are_not_compiled(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where nothing can be cached; nothing is in the cache then."""
    [kind], [other] = flight_kinds([THROW]), flight_kinds([HOVER])
    monkeypatch.setattr(compiler_times, "packaged_kinds", lambda: (kind.key,))
    monkeypatch.setattr(compiler_times, "fly_scenarios", lambda tables: None)
    monkeypatch.setattr(compiler_times, "is_writable", lambda folder: False)
    for _ in range(2):
        assert compiler_time(kind, {}) == (TYPICAL[False], False, True)
        assert compile_kind(kind, {}) == 0.0
    assert not compiler_time(other, {}).cached


def test_a_kind_is_compiled_once_in_a_process(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[str] = []
    monkeypatch.setattr(compiler_times, "compile_kind", lambda kind, code: seen.append(kind.key))
    for _ in range(3):
        compile_kinds([THROW, HOVER, THROW], {})
    assert len(seen) == len(set(seen)) == 2


@pytest.mark.parametrize(
    "content",
    ["", "[]", "{", "[" * 100_000, '{"KEY": 3}', '{"KEY": {"seconds": -1, "state": "", "files": []}}',
     '{"KEY": {"seconds": 1, "state": "", "files": [3]}}',
     '{"KEY": {"seconds": "1", "state": "", "files": []}}',
     '{"KEY": {"seconds": NaN, "state": "", "files": []}}',
     '{"KEY": {"seconds": 1, "state": "", "files": ["\\u0000"]}}'],
)  # fmt: skip
def test_a_record_that_cannot_be_read_is_no_record(cache: Path, content: str) -> None:
    [kind] = flight_kinds([THROW])
    (cache / RECORD).write_text(content.replace("KEY", kind.key))
    assert compiler_time(kind, {}) == (TYPICAL[False], False, False)
    compile_kind(kind, {})
    assert compiler_time(kind, {}).recorded
    assert list(json.loads((cache / RECORD).read_text())) == [kind.key]


def test_names_in_a_record_are_only_looked_up(cache: Path) -> None:
    [kind] = flight_kinds([THROW])
    compile_kind(kind, {})
    known = json.loads((cache / RECORD).read_text())
    for name in ("x" * 5000, "\ud800", "no such file"):
        known[kind.key]["files"] = [name]
        (cache / RECORD).write_text(json.dumps(known))
        assert not compiler_time(kind, {}).cached


def test_what_compiling_will_take_is_said_before(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cost_estimate.os, "getloadavg", lambda: (5.0, 0.0, 0.0))
    monkeypatch.setattr(cost_estimate.os, "cpu_count", lambda: 2)
    kinds = [FlightKind("a", False, THROW), FlightKind("b", True, THROW)]
    assert cost_estimate.compiling_text(kinds, {}) == (
        "kernels: those of 2 of 2 kinds of flight are not in the cache, as far as is known; compiling "
        "takes 1 min 20 s of processor time (typically); at the present load of 5.0 processes about "
        "4 min 00 s"
    )
    [kind] = flight_kinds([THROW])
    compile_kind(kind, {})
    assert cost_estimate.compiling_text([kind], {}) == "kernels: in the cache"
