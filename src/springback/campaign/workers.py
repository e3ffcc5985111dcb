"""Flights on the cores of this machine: processes that each fly one chunk at a time.

The parent assigns chunks to workers, so that the chunk of a killed worker is known.  Workers are
started by ``spawn`` and share nothing.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import signal
import sys
import traceback
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterable, Iterator
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any, NamedTuple

from springback.batch.scenarios import Device
from springback.batch.workers import end_with_parent, single_threads
from springback.campaign.errors import CampaignError
from springback.campaign.flying import Chunk, ChunkRows, fly_chunk
from springback.campaign.store import source
from springback.errors import warn_in_one_line

Remark = Callable[[str], None]
#: Number of lost workers after which a chunk is given up (chosen).
STRIKES = 3


class GivenUp(NamedTuple):
    """A chunk of flights that could not be flown, and the reason."""

    chunk: Chunk
    why: str
    details: str = ""


class _Worker:
    """A process, and the chunk that it is flying."""

    def __init__(self, text: str, device: Device) -> None:
        context = multiprocessing.get_context("spawn")
        self.line, theirs = context.Pipe()
        self.process: SpawnProcess = context.Process(
            target=SERVED, args=(theirs, text, device), daemon=True, name="springback worker"
        )
        with single_threads(), _ctrl_c_blocked():
            self.process.start()
        theirs.close()
        self.chunk: Chunk | None = None
        self.ready = False

    def fly(self, chunk: Chunk) -> None:
        self.chunk = chunk
        with contextlib.suppress(OSError):  # it is dead, as its closed pipe will show
            self.line.send(chunk)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.line.close()


@contextlib.contextmanager
def _ctrl_c_blocked() -> Iterator[None]:
    """Block Ctrl-C in child processes from their start; this process handles it afterwards."""
    if sys.platform == "win32":
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # it unblocks signals when it is first started
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def serve(line: Connection, text: str, device: Device) -> None:
    """Worker loop: fly chunks from the pipe until the parent closes it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is handled by the parent
    warn_in_one_line()
    end_with_parent()
    with contextlib.suppress(EOFError, OSError):
        line.send(source())
        while True:
            chunk: Chunk = line.recv()
            answer: ChunkRows | GivenUp
            try:
                answer = fly_chunk(text, chunk, device)
            except Exception as error:
                why = f"{type(error).__name__}: {str(error).partition(chr(10))[0]}"
                answer = GivenUp(chunk, why, traceback.format_exc())
            line.send(answer)


#: Program of a worker.
SERVED = serve


def fly_locally(
    text: str, chunks: Iterable[Chunk], workers: int, remark: Remark, device: Device = "cpu"
) -> Generator[ChunkRows | GivenUp]:
    """Fly chunks on this machine; yields results as they become ready.

    Args:
        text: The plan, from `springback.campaign.design.plan.Plan.canonical`.
        chunks: Chunks to fly.
        workers: Number of processes.
        remark: Called with messages about lost workers.
        device: Device on which they fly.

    Raises:
        CampaignError: If workers cannot start.
    """
    waiting, strikes = deque(chunks), Counter[Chunk]()
    running = [_Worker(text, device) for _ in range(min(workers, len(waiting)))]
    for worker in running:
        worker.fly(waiting.popleft())
    try:
        while running:
            heard: list[Any] = wait([worker.line for worker in running])
            for worker in [worker for worker in running if worker.line in heard]:
                try:
                    answer = worker.line.recv()
                except (EOFError, OSError):
                    running.remove(worker)
                    lost = _record_loss(worker, strikes, remark)
                    if lost is None:
                        assert worker.chunk is not None
                        waiting.appendleft(worker.chunk)
                    if waiting:
                        running.append(_Worker(text, device))
                        running[-1].fly(waiting.popleft())
                    if lost is not None:
                        yield lost
                    continue
                if isinstance(answer, str):
                    worker.ready = True
                    if answer != source():
                        raise CampaignError("springback's source was changed during the flights")
                    continue
                if waiting:
                    worker.fly(waiting.popleft())
                else:
                    running.remove(worker)
                    worker.end()
                yield answer
    finally:
        for worker in running:
            worker.end()


def _record_loss(worker: _Worker, strikes: Counter[Chunk], remark: Remark) -> GivenUp | None:
    """Record the loss of a worker; returns its chunk if that is given up."""
    worker.end()
    pid, how, chunk = worker.process.pid, _ending(worker.process.exitcode), worker.chunk
    if not worker.ready:
        raise CampaignError(
            f"a worker could not start ({how}); a script that flies campaigns must do so under "
            "if __name__ == '__main__'"
        )
    assert chunk is not None
    strikes[chunk] += 1
    whose = f"flights {chunk[0]} to {chunk[1] - 1}"
    if strikes[chunk] < STRIKES:
        remark(f"worker {pid} was lost ({how}); {whose} are flown again by a new one")
        return None
    return GivenUp(chunk, f"{STRIKES} workers in a row were lost over them ({how})")


def _ending(code: int | None) -> str:
    """Text about the end of a process."""
    if code is not None and code < 0:
        with contextlib.suppress(ValueError):
            name = signal.Signals(-code).name
            return f"{name}, perhaps out of memory" if name == "SIGKILL" else name
    return f"exit code {code}"
