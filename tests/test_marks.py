"""Marks are of tests that exist, and a test is skipped only for what this machine lacks."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from builders import marks
from builders.missing import FEATURES, PROGRAMS, is_allowed, missing

HERE = Path(__file__).parent


@pytest.mark.parametrize(
    "place", sorted({*marks.SLOW, *marks.BROWSER, *marks.PAPER, *marks.DOCS, *marks.RARE})
)
def test_marks_are_of_tests_that_exist(place: str) -> None:
    file, _, case = place.partition("::")
    name = case.partition("[")[0]
    assert (HERE / file).exists()
    assert not name or re.search(rf"^def {name}\(", (HERE / file).read_text("utf-8"), re.M)


def run(text: str, folder: Path, path: str) -> subprocess.CompletedProcess[str]:
    """A file of tests under the settings of the suite, with programs from one folder only."""
    (folder / "test_it.py").write_text(text)
    return subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "conftest", "-p", "no:cacheprovider", "test_it.py"],
        cwd=folder, env={"PYTHONPATH": str(HERE), "PATH": path}, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_a_skip_for_nothing_that_is_missing_fails_the_run(tmp_path: Path) -> None:
    one = "import pytest\ndef test_it():\n    pytest.skip('{}')\ndef test_other(): pass\n"
    done = run(one.format("not today"), tmp_path, "")
    assert done.returncode == 1, done.stdout
    assert "skipped, but nothing is missing: test_it.py::test_it: Skipped: not today" in done.stdout
    done = run(one.format("needs openssl"), tmp_path, "")
    assert done.returncode == 0, done.stdout
    whole = "import pytest\npytest.importorskip('no_such_package', reason='needs an extra')\n"
    done = run(whole, tmp_path, "")
    assert done.returncode != 0
    assert "skipped, but nothing is missing: test_it.py: Skipped: needs an extra" in done.stdout


def test_only_what_is_missing_may_be_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    assert missing(*PROGRAMS) == list(PROGRAMS)
    assert is_allowed("Skipped: needs chromium, chromedriver")
    assert not is_allowed("needs selenium")
    assert not is_allowed("chromium")
    monkeypatch.setitem(FEATURES, "root", True)
    assert not is_allowed("needs root")
    monkeypatch.setitem(FEATURES, "root", False)
    assert is_allowed("needs root")
