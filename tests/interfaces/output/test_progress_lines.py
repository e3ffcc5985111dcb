"""Lines of progress where there is no terminal: soon enough, also while nothing is reported."""

from __future__ import annotations

import threading
from itertools import pairwise

import pytest

from springback.campaign.running import CampaignProgress, rate_text
from springback.interfaces.cli.common import Terminal
from springback.interfaces.output import progress_lines
from springback.interfaces.output.progress_lines import LOOK, SILENCE, CampaignLines, ProgressLines


def test_no_silence_is_longer_than_twenty_seconds() -> None:
    """Looked at each second for ten minutes, whatever is reported in between."""
    now, said = 0.0, list[tuple[float, str]]()
    lines = ProgressLines("fitting", lambda text: said.append((now, text)), lambda: now)
    for step in range(600):
        now = step * LOOK
        if step % 7 == 0:
            lines.show(step / 600.0)
        if step > 300:
            lines.tell(f"round {step}")
        lines.look()
    times = [0.0, *(at for at, _ in said), now]
    gaps = [after - before for before, after in pairwise(times)]
    assert max(gaps) <= 20.0
    assert min(gaps[:-1]) >= SILENCE  # and no log is filled
    assert said[0] == (10.0, "fitting: 1%, after 10 s")
    assert said[-1][1] == "fitting: 98%, round 590, after 590 s"


def test_a_line_has_what_is_known() -> None:
    now, said = 0.0, list[str]()
    lines = ProgressLines("drawing", said.append, lambda: now)
    lines.look()
    assert said == []  # what is done at once says nothing
    now = 12.0
    lines.look()
    lines.tell("the last page")
    now = 24.0
    lines.look()
    assert said == ["drawing, after 12 s", "drawing: the last page, after 24 s"]


def test_what_may_take_long_is_explained_once() -> None:
    at, said = [0.0], list[str]()
    lines = ProgressLines(
        "reading and flying; compiled first, for 10 s", said.append, lambda: at[0]
    )
    for _ in range(3):
        at[0] += 10.0
        lines.look()
    assert said == [
        "reading and flying; compiled first, for 10 s, after 10 s",
        "reading and flying, after 20 s",
        "reading and flying, after 30 s",
    ]


def _progress(done: int, rate: float) -> CampaignProgress:
    return CampaignProgress(done, 300, int(done > 0), 0, 0, 0, rate)


def test_a_campaign_says_how_long_its_first_flights_have_taken() -> None:
    now, said = 0.0, list[tuple[float, str]]()
    lines = CampaignLines(lambda text: said.append((now, text)), lambda: now)
    lines.show(_progress(0, 0.0))
    for step in range(1, 431):
        now = step * LOOK
        lines.look()
    lines.show(_progress(38, 0.09))
    for step in range(431, 600):
        now = step * LOOK
        lines.look()
    assert said[0][1].endswith(
        "; new kinds of flight are compiled first, which takes a minute or more"
    )
    assert [at for at, _ in said] == [0.0, 61.0, 121.0, 181.0, 241.0, 301.0, 361.0, 421.0]
    assert said[-1][1] == (
        "0 of 300 flights (0.0 %), 0 parts; compiling, and flying the first part, for 7 min 01 s "
        "so far"
    )
    lines.show(_progress(76, 0.09))
    assert said[-1][1] == "76 of 300 flights (25.3 %), 1 part, 5.4 flights/min, 41 min 29 s left"


@pytest.mark.parametrize(
    ("rate", "text"),
    [(2043.2, "2043 flights/s"), (1.44, "1.4 flights/s"), (0.99, "59 flights/min"),
     (0.0521, "3.1 flights/min"), (0.004, "14 flights/h"), (0.0011, "4 flights/h")],
)  # fmt: skip
def test_slow_rates_are_no_zero(rate: float, text: str) -> None:
    assert rate_text(rate) == text
    assert f", {text}, " in _progress(1, rate).sentence()


@pytest.mark.parametrize("how", ["progress_bar", "progress_in_words", "spinner"])
def test_a_task_that_reports_nothing_is_not_silent(
    how: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(progress_lines, "SILENCE", 0.0)
    monkeypatch.setattr(progress_lines, "LOOK", 0.001)
    said = threading.Semaphore(0)
    look = ProgressLines.look

    def watched(self: ProgressLines) -> None:
        look(self)
        said.release()

    monkeypatch.setattr(ProgressLines, "look", watched)
    with getattr(Terminal(), how)("waiting"):
        for _ in range(3):
            assert said.acquire(timeout=30.0)
    assert capsys.readouterr().err.splitlines()[:3] == ["waiting, after 0 s"] * 3
    with getattr(Terminal(quiet=True), how)("waiting"):
        pass
    assert capsys.readouterr().err == ""
