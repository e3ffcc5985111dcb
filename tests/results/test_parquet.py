"""Parquet files: broken off by Ctrl-C."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from pathlib import Path

import duckdb
import numpy as np
import pytest

from builders.campaign_folders import filled
from springback.campaign.access import Campaign
from springback.results.parquet import write_parquet

#: It takes many seconds.
LONG = "SELECT sum(a.range * b.range) AS x FROM range(100000) a, range(300000) b"


@pytest.fixture
def soon() -> Iterator[threading.Timer]:
    """Ctrl-C in a moment, once it is started; parallel runs of tests have it ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    signal.signal(signal.SIGINT, before)


def test_a_write_is_broken_off_by_ctrl_c_and_the_next_is_not(
    tmp_path: Path, soon: threading.Timer
) -> None:
    one = {"x": np.arange(3.0)}
    write_parquet(tmp_path / "before", one, {}, {})
    soon.start()
    with pytest.raises(KeyboardInterrupt):
        write_parquet(tmp_path / "broken off", one, {}, {}, select=LONG)
    write_parquet(tmp_path / "after", one, {}, {})
    assert duckdb.read_parquet(str(tmp_path / "after")).fetchall() == [(0.0,), (1.0,), (2.0,)]


def test_a_question_to_a_campaign_is_broken_off_by_ctrl_c(
    tmp_path: Path, soon: threading.Timer
) -> None:
    filled(tmp_path)
    campaign = Campaign(tmp_path)
    soon.start()
    with pytest.raises(KeyboardInterrupt):
        campaign.query(LONG)
    assert campaign.query("SELECT count(*) FROM flights").rows == [(30,)]
