"""Ctrl-C at random instants: how commands end, and what they leave."""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any, NamedTuple

from builders.interrupts import heed_interrupts
from springback.campaign import store
from springback.campaign.access import Campaign
from springback.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"


class Long(NamedTuple):
    """A command that takes a while."""

    words: tuple[str, ...]
    out: str = "out"
    """The file or folder that it writes."""
    serves: float = 0.0
    """Of a server, which ends with Ctrl-C only: how long one waits at most [s]."""


#: Every command that takes a while; what it needs is put there by `prepared`.
COMMANDS = {
    "fly": Long(("fly", "s.toml", "--out", "out")),
    "campaign": Long(("campaign", "plan.toml", "--out", "out", "--chunk", "40")),
    "query": Long(("query", "w", "FROM flights", "--out", "q.csv"), "q.csv"),
    "summary": Long(("summary", "w", "--out", "out")),
    "refly": Long(("refly", "w", "3", "--out", "out")),
    "view": Long(("view", "A", "--export", "v.html"), "v.html"),
    "animate": Long(("animate", "A", "--out", "a.gif", "--size", "320x240", "--fps", "8"), "a.gif"),
    "map": Long(("map", "speed=2:3:2", "pitch=0:10deg:2", "--robot", "arq", "--trials", "4", "--out", "out")),
    "study": Long(("study", "friction", "--trials", "1", "--out", "out")),
    "reproduce": Long(("reproduce", "slider", "--out", "out")),
    "check": Long(("check", "own_pilot.py:hover"), ""),
    "doctor": Long(("doctor",), ""),
    "lab": Long(("lab", "--no-browser"), "", serves=4.0),
    "view, served": Long(("view", "A", "--no-browser"), "", serves=4.0),
}  # fmt: skip


class Ending(NamedTuple):
    """How a command ended."""

    after: float  # Ctrl-C, since the start [s]; infinite if it had ended before
    code: int
    said: str
    left: tuple[str, ...]  # drafts, which are not to be seen


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "springback", *words]


def files(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def timed(words: tuple[str, ...], folder: Path) -> float:
    """How long a command takes, undisturbed and with all that it compiles kept [s]."""
    begun = time.monotonic()
    subprocess.run(command(*words), cwd=folder, capture_output=True, check=True)
    return time.monotonic() - begun


def removed(path: Path) -> None:
    """What a command wrote, a file or a folder, is gone."""
    shutil.rmtree(path, ignore_errors=True)
    path.unlink(missing_ok=True)


def interrupted(words: tuple[str, ...], folder: Path, after: float) -> Ending:
    """A command and Ctrl-C after some time [s].

    Raises:
        subprocess.TimeoutExpired: If it hangs.
    """
    before = files(folder)
    with subprocess.Popen(
        command(*words), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        preexec_fn=heed_interrupts, start_new_session=True,
    ) as process:  # fmt: skip
        try:
            process.wait(after)
            after = float("inf")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGINT)
        try:
            _, said = process.communicate(timeout=120)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
    left = sorted(
        name for name in files(folder) - before
        if "draft" in name or (Path(name).name.startswith(".") and not name.endswith(".lock"))
    )  # fmt: skip
    return Ending(after, process.returncode, said, tuple(left))


def wrong(ending: Ending) -> str:
    """What is not as it should be; empty if all is."""
    if "Traceback" in ending.said:
        return "traceback" if "springback" in ending.said else ""  # Python itself was starting
    if ending.left:
        return f"left {Path(ending.left[0]).suffix}"
    if ending.code == 0:
        return ""  # it was done before it heard, or served, which ends so
    if ending.code == -signal.SIGINT:
        return ""  # before Python listens, the system's own ending
    if ending.code != 130:
        return f"exit code {ending.code}"
    return "" if "interrupted" in ending.said.splitlines()[-1] else "no last words"


def written(path: Path) -> Any:
    """What a command wrote, as something that can be compared; None if it wrote nothing.

    Of a campaign only whether it can be read, part by part: it is to be gone on with.
    """
    if path.is_file():
        return path.read_bytes()
    if (path / store.PLAN).exists() and (path / store.METADATA).exists():
        Campaign(path).query("FROM flights")
        return store.PLAN
    return sorted(files(path)) if path.is_dir() and any(path.iterdir()) else None


def tried(given: Long, folder: Path, times: int, seed: int = 0) -> Counter[str]:
    """Endings of a command interrupted at random instants of its run.

    Args:
        given: The command.
        folder: To run in.
        times: How often.
        seed: Of the instants.
    """
    noise_stream, found, out = random.Random(seed), Counter[str](), folder / (given.out or "none")
    whole, result = given.serves, None
    removed(out)
    if not given.serves:
        timed(given.words, folder)
        removed(out)
        whole, result = timed(given.words, folder), written(out)
    for _ in range(times):
        removed(out)
        after = noise_stream.uniform(0.0, whole)
        try:
            ending = interrupted(given.words, folder, after)
        except subprocess.TimeoutExpired:
            found["hang"] += 1
            continue
        fault = wrong(ending)
        if not fault and not given.serves:
            fault = _torn(out, result, done=ending.code == 0)
        if fault:
            print(f"{ending.after:.3f} s of {whole:.2f}: {fault}\n{ending.said}", file=sys.stderr)
        found[fault or ("done" if ending.code == 0 else "interrupted")] += 1
    return found


def _torn(out: Path, whole: Any, *, done: bool) -> str:
    """What is not as it should be of what a command wrote; empty if all is."""
    try:
        found = written(out)
    except InputError as error:
        print(error, file=sys.stderr)
        return "half-written"
    if done and found != whole:
        return "nothing written, and said to be done"
    return "" if found in (None, whole) else "half-written"


def prepared(folder: Path, plan: str) -> Path:
    """A folder with what the commands need."""
    shutil.copy(EXAMPLES / "arq_wall.toml", folder / "s.toml")
    shutil.copy(EXAMPLES / "own_pilot.py", folder)
    (folder / "plan.toml").write_text(plan)
    timed(("fly", "s.toml", "--out", "A", "-q"), folder)
    timed(("campaign", "plan.toml", "--out", "w", "-q"), folder)
    return folder
