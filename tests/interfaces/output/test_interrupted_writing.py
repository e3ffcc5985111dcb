"""Ctrl-C at every line of what writes results: they are there whole, or what was there before."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

from springback.files import atomic_file
from springback.interfaces.output import folders
from springback.interfaces.output.folders import output_folder

pytestmark = [
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
]
#: Whose lines are interrupted: ours, and what they call in Python.
MODULES = ("files.py", "drafts.py", "tempfile.py", "shutil.py", "pathlib.py")


def interrupted(work: Callable[[], None], after: int) -> bool:
    """Do something, with Ctrl-C at a line or return of it; False if it was done before.

    Where Python drops it, in what it takes apart, the program raises it again (`last_words`), and
    whatever it leads to in a library counts as it.
    """
    left = after

    def trace(frame: FrameType, event: str, _: Any) -> Any:
        nonlocal left
        if not frame.f_code.co_filename.endswith(MODULES):
            return None
        if event in ("line", "return"):
            left -= 1
            if left == 0:
                raise KeyboardInterrupt
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        work()
    except (KeyboardInterrupt, OSError):
        assert left <= 0
    finally:
        sys.settrace(before)
    return left <= 0


def found(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.mark.parametrize("exchange", [True, False])
@pytest.mark.parametrize("there", [{}, {"a": "old", "b": "old", "mine": "mine"}])
def test_a_folder_is_replaced_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, there: dict[str, str], exchange: bool
) -> None:
    """Also where the system cannot exchange two folders; the next command clears up."""
    monkeypatch.setattr(folders, "YOUNG", -1.0)
    if not exchange:
        monkeypatch.setattr(folders, "_exchange", lambda *_: False)
    whole = {"a": "new", "c": "new"} | ({"mine": "mine"} if there else {})
    out, place = tmp_path / "results" / "out", tmp_path / "results"

    def write() -> None:
        with output_folder(out, force=True, replaces=["a", "b"]) as draft:
            for name in ("a", "c"):
                (draft / name).write_text("new")

    instants = 0
    while True:
        folders._remove(place)
        (out if there else place).mkdir(parents=True)
        for name, text in there.items():
            (out / name).write_text(text)
        instants += 1
        if not interrupted(write, instants):
            break
        assert (found(out) if out.exists() else {}) in (there, whole), instants
        write()
        assert found(out) == whole
        assert [path.name for path in place.iterdir()] == ["out"], instants
    assert instants > 30


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    path = tmp_path / "x"

    def write() -> None:
        with atomic_file(path) as draft, draft.open("w") as file:
            file.write("new")
            file.flush()
            file.write(" and whole")

    instants = 0
    while True:
        path.write_text("old")
        instants += 1
        if not interrupted(write, instants):
            break
        assert path.read_text() in ("old", "new and whole")
    assert instants > 10


def test_nothing_is_loaded_before_ctrl_c_is_listened_for() -> None:
    """Was: a traceback from `typing`, 50 ms after the start."""
    code = (
        "import sys; before = set(sys.modules); import springback.command; "
        "print(*sorted(set(sys.modules) - before))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == [
        "__future__", "springback", "springback.command",
        "springback.results", "springback.results.hooks",  # names of functions, which import nothing
        "springback.version",
    ]  # fmt: skip
