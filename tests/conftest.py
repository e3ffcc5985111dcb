"""Settings of the whole suite."""

from __future__ import annotations

import gc
import os
from pathlib import Path

import pytest
from hypothesis import settings

from builders.marks import BROWSER, DOCS, FIRST, PAPER, RARE, SLOW
from builders.missing import is_allowed

# Property tests draw the same examples on every machine, and the first call of a function may be slow.
settings.register_profile("suite", deadline=None, derandomize=True, max_examples=100)
settings.load_profile("suite")
HERE = Path(__file__).parent
# Collections that walk all kernels of a worker would take a tenth of the suite.
gc.set_threshold(200_000)
# The workers of the suite hold all cores.
os.environ.setdefault("SPRINGBACK_COMPILERS", "1")


@pytest.hookimpl(tryfirst=True)  # before tests are chosen by their marks
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark tests by their place, and begin with the longest files; `builders/marks.py` says which."""
    rank = {name: k for k, name in enumerate(FIRST)}
    items.sort(key=lambda item: rank.get(item.path.name, len(rank)))
    for item in items:
        file, _, name = item.nodeid.partition("::")
        place = item.path.relative_to(HERE).as_posix() if item.path.is_relative_to(HERE) else file
        whole = f"{place}::{name}"
        for mark, places in (
            ("slow", SLOW),
            ("browser", BROWSER),
            ("paper", PAPER),
            ("docs", DOCS),
            ("rare", RARE),
        ):
            if any(whole.startswith(one) for one in places):
                item.add_marker(mark)


def skipped(config: pytest.Config) -> list[str]:
    """Reasons of the tests that were skipped although nothing that may be missing is."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    reports = reporter.stats.get("skipped", []) if reporter else []
    reasons = [(report.nodeid, report.longrepr[-1]) for report in reports]
    return [f"{test}: {reason}" for test, reason in reasons if not is_allowed(reason)]


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A test may be skipped for want of a program, and for nothing else."""
    if skipped(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say which tests were skipped without need."""
    for line in skipped(terminalreporter.config):
        terminalreporter.line(f"ERROR skipped, but nothing is missing: {line}", red=True)
