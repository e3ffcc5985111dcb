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
from typing import NamedTuple

from interfaces.interrupts import heed_interrupts


class Ending(NamedTuple):
    """How a command ended."""

    after: float  # Ctrl-C, since the start [s]; infinite if it had ended before
    code: int
    said: str
    left: tuple[str, ...]  # files that are neither there before nor whole results


def command(*words: str) -> list[str]:
    return [sys.executable, "-m", "springback", *words]


def files(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def timed(words: list[str], folder: Path) -> float:
    """How long a command takes, undisturbed and with all that it compiles kept [s]."""
    begun = time.monotonic()
    subprocess.run(command(*words), cwd=folder, capture_output=True, check=True)
    return time.monotonic() - begun


def removed(path: Path) -> None:
    """What a command wrote, a file or a folder, is gone."""
    shutil.rmtree(path, ignore_errors=True)
    path.unlink(missing_ok=True)


def interrupted(words: list[str], folder: Path, after: float) -> Ending:
    """A command and Ctrl-C after some time [s]."""
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
        return f"left {ending.left[0]}"
    if ending.code == 0:
        return ""  # it was done before it heard
    if ending.code == -signal.SIGINT:
        return ""  # before Python listens, the system's own ending
    if ending.code != 130:
        return f"exit code {ending.code}"
    return "" if "interrupted; " in ending.said.splitlines()[-1] else "no last words"


def tried(words: list[str], folder: Path, out: str, times: int, seed: int = 0) -> Counter[str]:
    """Endings of a command interrupted at random instants of its run.

    Args:
        words: Of the command, which writes to ``out``.
        folder: To run in.
        out: Removed after each run.
        times: How often.
        seed: Of the instants.
    """
    luck, found = random.Random(seed), Counter[str]()
    removed(folder / out)
    timed(words, folder)
    removed(folder / out)
    whole = timed(words, folder)
    for _ in range(times):
        removed(folder / out)
        ending = interrupted(words, folder, luck.uniform(0.0, whole))
        fault = wrong(ending)
        if fault:
            print(f"{ending.after:.3f} s of {whole:.2f}: {fault}\n{ending.said}", file=sys.stderr)
        found[fault or ("done" if ending.code == 0 else "interrupted")] += 1
    return found
