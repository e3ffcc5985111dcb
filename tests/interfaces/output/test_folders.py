"""Output folders: replaced whole or not at all, and nothing left by those who were killed."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from builders.interrupts import heed_interrupts
from springback.errors import InputError
from springback.interfaces.output import folders
from springback.interfaces.output.folders import file_stem, output_folder
from springback.interfaces.reports.flight_files import FLIGHT_FILES

MINE = ("summary.json", "trajectory.parquet")


def write(folder: Path, word: str, *names: str) -> None:
    for name in names or MINE:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(word)


def held(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): path.read_text()
        for path in sorted(folder.rglob("*")) if path.is_file()
    }  # fmt: skip


@pytest.fixture
def old(tmp_path: Path) -> Path:
    """A folder with a flight that had a pilot, and things of its user's."""
    folder = tmp_path / "out"
    folder.mkdir()
    write(folder, "old", *FLIGHT_FILES, "notes.txt", "deep/er/notes.txt")
    (folder / "link").symlink_to("notes.txt")
    return folder


def flown(folder: Path, **given: Any) -> None:
    with output_folder(folder, force=True, replaces=FLIGHT_FILES) as place:
        write(place, "new")


def no_exchange(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(folders, "_exchange", lambda *_: False)


def mounted(monkeypatch: pytest.MonkeyPatch) -> None:
    no_exchange(monkeypatch)

    def busy(*_: Any) -> None:
        raise OSError(errno.EBUSY, "Device or resource busy")

    monkeypatch.setattr(os, "rename", busy)


WAYS: dict[str, Callable[[pytest.MonkeyPatch], None]] = {
    "in one step": lambda _: None, "in two": no_exchange, "a mount point": mounted,
}  # fmt: skip


@pytest.mark.parametrize("way", WAYS)
def test_a_forced_flight_leaves_nothing_of_the_one_before(
    old: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    """Was: the old telemetry and impact.png stayed, and `view` showed them."""
    WAYS[way](monkeypatch)
    flown(old)
    assert held(old) == {
        "summary.json": "new", "trajectory.parquet": "new",
        "notes.txt": "old", "deep/er/notes.txt": "old", "link": "old",
    }  # fmt: skip
    assert (old / "link").is_symlink()
    assert [path.name for path in old.parent.iterdir()] == ["out"]


@pytest.mark.parametrize("error", [KeyboardInterrupt, ZeroDivisionError, SystemExit])
def test_a_failure_leaves_what_was_there(old: Path, error: type[BaseException]) -> None:
    before = held(old)

    def fail() -> None:
        with output_folder(old, force=True, replaces=FLIGHT_FILES) as place:
            write(place, "new")
            raise error

    with pytest.raises(error):
        fail()
    assert held(old) == before
    assert [path.name for path in old.parent.iterdir()] == ["out"]


@pytest.mark.parametrize("kind", ["none", "empty", "full"])
@pytest.mark.parametrize("step", range(12))
def test_a_kill_at_any_step_leaves_one_flight_or_the_other(
    old: Path, kind: str, step: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A process that dies as it puts the folder in place: all is old, or all is new."""
    if kind != "full":
        shutil.rmtree(old)
    if kind == "empty":
        old.mkdir()
    before, count = held(old), [0]

    def dying(event: str, _: Any) -> None:
        if event in ("os.rename", "os.link", "os.mkdir", "os.chmod", "os.remove", "ctypes.dlopen"):
            count[0] += 1
            if count[0] == step + 5:
                os._exit(9)

    child = os.fork()
    if not child:
        try:
            sys.addaudithook(dying)
            flown(old)
        finally:
            os._exit(0)
    os.waitpid(child, 0)
    after = held(old)
    assert after == before or {after[name] for name in MINE} == {"new"}
    if after != before:
        assert "telemetry.parquet" not in after
    monkeypatch.setattr(folders, "YOUNG", -1.0)
    flown(old)
    assert [path.name for path in old.parent.iterdir()] == ["out"]


def test_drafts_of_the_killed_are_removed_and_those_in_use_stay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    killed = tmp_path / f".out-0123abc_{folders.DRAFT}"
    others = tmp_path / ".out-0123abc_"
    for folder in (killed, others):
        folder.mkdir()
        write(folder, "half")
    flown(out)
    assert killed.exists()  # it could be of one who is just beginning
    monkeypatch.setattr(folders, "YOUNG", -1.0)
    with output_folder(out, force=True) as place:
        write(place, "slow")
        assert not killed.exists()
        flown(out)
        assert place.exists()
    assert held(out) == dict.fromkeys(MINE, "slow")
    assert others.exists()


def test_a_folder_behind_a_link_stays_behind_it(tmp_path: Path, old: Path) -> None:
    (tmp_path / "link").symlink_to(old)
    flown(tmp_path / "link")
    assert (tmp_path / "link").is_symlink()
    assert (old / "summary.json").read_text() == "new"


def test_a_folder_in_which_one_stands_stays_the_same(
    old: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(old)
    flown(Path("."))
    assert Path("summary.json").read_text() == "new"
    assert not Path("telemetry.parquet").exists()


def test_names_that_are_too_long_are_said(tmp_path: Path) -> None:
    with (
        pytest.raises(InputError, match="File name too long"),
        output_folder(tmp_path / ("x" * 300)),
    ):
        pass


def test_a_full_disk_is_said_and_nothing_is_left(old: Path) -> None:
    before = held(old)

    def fill() -> None:
        with output_folder(old, force=True) as place:
            write(place, "new")
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with pytest.raises(InputError, match=r"cannot be written \(No space left"):
        fill()
    assert held(old) == before
    assert [path.name for path in old.parent.iterdir()] == ["out"]


# -- what the program says at its end -------------------------------------------------------------

STARVED = """
import sys, errno
from springback import command
from springback.interfaces.cli import app as cli
def fail():
    {}
cli.cli.main = lambda **_: fail()
command.run()
"""


def ended(body: str, **given: Any) -> subprocess.CompletedProcess[str]:
    code = STARVED.format(body)
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, **given
    )


def test_a_file_that_ends_early_is_not_ctrl_c() -> None:
    """click makes Abort of both; every command said "interrupted; nothing was written"."""
    import click

    body = "import click\n    try: raise EOFError('Ran out of input')\n    except EOFError as e: raise click.Abort() from e"
    done = ended(body)
    assert done.returncode == 1
    assert "interrupted" not in done.stderr
    assert "EOFError: Ran out of input" in done.stderr
    assert click.Abort
    done = ended(body.replace("EOFError", "KeyboardInterrupt"))
    assert (done.returncode, done.stderr) == (130, "interrupted; nothing was written\n")


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("raise OSError(errno.ENOSPC, 'No space left on device', 'x.csv')", "error: x.csv: No space left on device\n"),
        ("raise OSError(errno.EROFS, 'Read-only file system')", "error: Read-only file system\n"),
        ("raise MemoryError('Unable to allocate 8 TiB')", "error: out of memory (Unable to allocate 8 TiB)\n"),
        ("cli.say('error: \\x1b[2Jgone \\udcff\\u202e'); sys.exit(1)", "error: \ufffd[2Jgone \ufffd\ufffd\n"),
    ],
)  # fmt: skip
def test_the_systems_troubles_are_one_line(body: str, said: str) -> None:
    done = ended(body)
    assert (done.returncode, done.stderr) == (1, said)


def test_a_mistake_of_ours_keeps_its_traceback() -> None:
    done = ended("{}['x']")
    assert done.returncode == 1
    assert "KeyError: 'x'" in done.stderr


def test_output_that_nobody_takes_is_said_in_one_line() -> None:
    words = [sys.executable, "-m", "springback", "show"]
    with Path("/dev/full").open("w") as full:
        for buffered in ({"PYTHONUNBUFFERED": "1"}, {}):  # what is buffered fails once more
            rest = {k: v for k, v in os.environ.items() if k != "PYTHONUNBUFFERED"}
            done = subprocess.run(
                words, stdout=full, stderr=subprocess.PIPE, text=True, check=False,
                env=rest | buffered,
            )  # fmt: skip
            assert done.returncode == 1
            assert done.stderr in (
                "error: stdout: No space left on device\n",
                "error: No space left on device\n",
            )
    done = subprocess.run(
        ["sh", "-c", f"{sys.executable} -m springback show >&-"], capture_output=True, text=True, check=False
    )  # fmt: skip
    assert "Traceback" not in done.stderr


def test_ctrl_c_that_python_drops_is_raised_again() -> None:
    """In a finaliser, a call-back of a library: Python prints it, and goes on."""
    body = (
        "import os, signal, time\n    class Late:\n        def __del__(self):\n"
        "            os.kill(os.getpid(), signal.SIGINT)\n            time.sleep(0.1)\n"
        "    late = Late()\n    del late\n    time.sleep(30)"
    )
    done = ended(body, timeout=60, preexec_fn=heed_interrupts)
    assert (done.returncode, done.stderr) == (130, "interrupted; nothing was written\n")


def test_files_are_named_plainly_and_once() -> None:
    taken = {"map-speed-surface"}
    named = [
        file_stem(*names, taken=taken)
        for names in (
            ("map", "vehicle.arms[0].stiffness", "world.obstacles[12].yaw"), ("map", "v", "a[0]"),
            ("map", "v", "a.0"), ("map", "v", "A[0]"), ("map", "Speed", "surface"), ("ä/b c",),
        )
    ]  # fmt: skip
    assert named == [
        "map-vehicle.arms.0.stiffness-world.obstacles.12.yaw", "map-v-a.0", "map-v-a.0-2",
        "map-v-A.0-3", "map-Speed-surface-2", "_b_c",
    ]  # fmt: skip
    assert taken >= {name.lower() for name in named}
