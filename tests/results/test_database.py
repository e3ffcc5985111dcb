"""DuckDB: Ctrl-C at any instant ends a query, and no thread is left with a closed connection."""

from __future__ import annotations

import threading
import time
from typing import Any

import pytest

from springback.results.database import in_database, sandbox

LONG = "SELECT sum(hash(a.range + b.range)) FROM range(10000000) a, range(100000) b"


@pytest.mark.parametrize("runs", [True, False])
def test_ctrl_c_while_the_thread_is_being_started(
    monkeypatch: pytest.MonkeyPatch, runs: bool
) -> None:
    """Was: the thread used a connection that the ``with`` had closed, and DuckDB's error came up."""
    real, asked, errors = threading.Thread.start, list[str](), list[Any]()
    late: list[threading.Thread] = []

    def starting(thread: threading.Thread) -> None:
        if thread.name == "springback database":
            if runs:
                real(thread)
            else:
                late.append(thread)
            raise KeyboardInterrupt
        real(thread)

    def work(connection: Any) -> None:
        asked.append("begun")
        try:
            connection.execute(LONG).fetchall()
        except BaseException as error:
            errors.append(type(error).__name__)
            raise

    monkeypatch.setattr(threading.Thread, "start", starting)
    monkeypatch.setattr(threading, "excepthook", lambda given: errors.append(given))
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        in_database(work)
    assert time.monotonic() - begun < 10.0
    for thread in late:  # it starts only now, when it has been called off
        real(thread)
        thread.join()
    assert asked in ([], ["begun"])
    assert errors in ([], ["InterruptException"], ["RuntimeError"])
    if not runs:
        assert asked == []


def test_ctrl_c_during_a_query(monkeypatch: pytest.MonkeyPatch) -> None:
    real = threading.Event.wait

    def pressed(event: threading.Event, timeout: float | None = None) -> bool:
        if timeout is None and threading.current_thread() is threading.main_thread():
            time.sleep(0.3)
            raise KeyboardInterrupt
        return real(event, timeout)

    before = threading.active_count()
    connection = sandbox()

    def interrupted() -> None:
        with monkeypatch.context() as patch:
            patch.setattr(threading.Event, "wait", pressed)
            in_database(lambda opened: opened.execute(LONG).fetchall(), connection)

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert threading.active_count() == before
    with pytest.raises(Exception, match="closed"):
        connection.execute("SELECT 1")


def test_what_the_work_raises_comes_up_and_the_connection_is_closed() -> None:
    connection = sandbox()
    with pytest.raises(ZeroDivisionError):
        in_database(lambda _: 1 / 0, connection)
    with pytest.raises(Exception, match="closed"):
        connection.execute("SELECT 1")
    assert in_database(lambda opened: opened.execute("SELECT 41 + 1").fetchall()) == [(42,)]
