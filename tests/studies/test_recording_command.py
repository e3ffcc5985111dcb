"""``python -m springback.studies.recordings.NAME FOLDER``: bad input is one line, and exit code 2."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from springback.studies.recordings.arm_release import release_lines
from springback.studies.recordings.command import run_study
from springback.studies.recordings.cube_tosses import toss_lines
from springback.studies.recordings.frame_identification import identification_lines
from springback.studies.recordings.printed_ratios import ratio_lines

Lines = Callable[[Path | None], Iterator[str]]


def test_lines_are_written_as_they_come(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_study(lambda _: iter(["one", "two"]), []) == 0
    assert capsys.readouterr().out == "one\ntwo\n"


@pytest.mark.parametrize(
    ("lines", "words", "message"),
    [
        (release_lines, ["--help"], "name one folder of recordings, or nothing"),
        (release_lines, ["a", "b"], "name one folder of recordings, or nothing"),
        (release_lines, ["nowhere"], "nowhere: is no folder"),
        (release_lines, [], "no folder was named; name a copy of github.com/ntnu-arl/"),
        (release_lines, ["."], ".: has no joint_step.csv; name a copy of github.com/ntnu-arl/"),
        (toss_lines, [], "no folder was named; name a copy of github.com/DAIRLab/contact-nets"),
        (toss_lines, ["."], ".: has no tosses; name a copy of github.com/DAIRLab/contact-nets"),
        (identification_lines, [], "no folder was named; name a copy of github.com/thecognifly/"),
        (ratio_lines, ["."], ".: this study reads no recordings; name nothing"),
    ],
)
def test_bad_input_is_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    lines: Lines, words: list[str], message: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert run_study(lines, words) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1


def test_the_module_is_a_program(tmp_path: Path) -> None:
    module = "springback.studies.recordings.drop_predictions"
    done = subprocess.run(
        [sys.executable, "-m", module, str(tmp_path / "none")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"error: {tmp_path / 'none'}: is no folder\n"
