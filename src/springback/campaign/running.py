"""Running a campaign: chunks out, parts in, and what happened told as it goes."""

from __future__ import annotations

import contextlib
import os
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from springback.batch.scenarios import GPU_BLOCK, Device
from springback.campaign.access import Campaign, check_conditions
from springback.campaign.design.layout import Design, lay_out
from springback.campaign.design.plan import Plan
from springback.campaign.errors import CampaignError
from springback.campaign.flying import Chunk, ChunkRows
from springback.campaign.store import Store, changed_versions, open_store
from springback.campaign.workers import GivenUp, Remark, fly_locally
from springback.errors import InputError
from springback.scenario.user_pilots import source_text

if TYPE_CHECKING:
    from springback.campaign.cluster import Tls

#: Flights of a chunk (chosen): seconds of work, and some 1.5 MB of rows.
CHUNK = 2000
#: The same on a GPU.
GPU_CHUNK = GPU_BLOCK
#: Fewest chunks for each worker, where there are not enough flights for full ones (chosen).
SHARES = 4
#: The rate is that of so many last parts (chosen).
RECENT = 40


@dataclass(frozen=True)
class CampaignProgress:
    """How far a campaign has come."""

    done: int
    """Flights that are kept, from before as well."""
    flights: int
    parts: int
    refused: int
    ledger_open: int
    """Flights whose energy ledger does not close to 1e-4."""
    given_up: int
    rate: float
    """Flights per second, lately; 0 while unknown."""

    @property
    def time_left(self) -> float | None:
        """Time left [s]; None while unknown."""
        return (self.flights - self.done - self.given_up) / self.rate if self.rate > 0.0 else None

    def sentence(self) -> str:
        """In one line."""
        share = 100.0 * self.done / self.flights
        parts = [f"{self.done} of {self.flights} flights ({share:.1f} %), {self.parts} parts"]
        if self.rate > 0.0:
            parts.append(f"{self.rate:.0f} flights/s")
        if self.time_left:
            parts.append(f"{in_time(self.time_left)} left")
        if self.refused:
            parts.append(f"{self.refused} refused")
        if self.ledger_open:
            parts.append(f"warning: {self.ledger_open} with an energy ledger that does not close")
        return ", ".join(parts)


def in_time(seconds: float) -> str:
    """A time as one says it."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    if hours:
        return f"{hours} h {minutes:02d} min"
    return f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


@dataclass
class _Watch:
    """Counts what comes in."""

    store: Store
    given_up: int = 0
    warm: bool = False
    """Whether the first part, which may have waited for a compiler, is left out of the rate."""
    came: deque[tuple[float, int]] = field(default_factory=lambda: deque(maxlen=RECENT))

    def now(self) -> CampaignProgress:
        done = self.store.done
        self.came.append((time.monotonic(), done))
        if len(self.came) == 3 and not self.warm:
            self.came.popleft()
            self.warm = True
        (then, before), (last, _) = self.came[0], self.came[-1]
        rate = (done - before) / (last - then) if last > then else 0.0
        parts = self.store.parts
        refused = sum(part.refused for part in parts)
        return CampaignProgress(
            done, self.store.design.flights, len(parts), refused,
            sum(part.ledger_open for part in parts), self.given_up, rate,
        )  # fmt: skip


def run_campaign(
    plan: Plan | Design,
    folder: str | Path,
    *,
    resume: bool = False,
    workers: int | None = None,
    chunk: int | None = None,
    scheduler: str | None = None,
    tls: Tls | None = None,
    device: Device = "cpu",
    progress: Callable[[CampaignProgress], None] | None = None,
    remark: Remark | None = None,
) -> Campaign:
    """Fly a campaign into a folder, or what is left of it.

    The rows depend on the plan alone, bit for bit, and on none of the other arguments.  A script
    that calls this must do so under ``if __name__ == "__main__"``, as its workers read it, too.

    Args:
        plan: What to fly.
        folder: For plan, parts and ledger; is made if it is not there.
        resume: Whether a campaign in the folder may be gone on with.
        workers: Processes; by default as many as there are cores.
        chunk: Flights that are flown together and kept together; by default 2000, or fewer so that
            all workers have some.
        scheduler: Address of a Dask scheduler to fly on, in place of processes.
        tls: Certificates for it, if it speaks TLS.
        device: Where the workers' flights fly: ``cpu``, or ``gpu`` for an NVIDIA GPU that they
            share.
        progress: Told how far it is, after each part.
        remark: Told of what went wrong and was mended, in one line each.

    Returns:
        The campaign, to be asked questions of.

    Raises:
        InputError: If the plan or the folder cannot be used.
        CampaignError: If the disk is full, workers keep dying, the cluster is lost; all parts that
            were kept stay, and ``resume`` goes on from them.
    """
    if not isinstance(plan, Plan | Design):
        raise InputError(f"plan must be a springback.Plan (got {source_text(plan)})")
    design = plan if isinstance(plan, Design) else lay_out(plan)
    crew = _at_least_one("workers", workers, os.cpu_count() or 1)
    on_gpu = device == "gpu"
    wanted = _at_least_one("chunk", chunk, GPU_CHUNK if on_gpu else CHUNK)
    if on_gpu:
        _check_gpu(scheduler)
    folder, say = Path(folder), remark or _silent
    check_conditions(design)
    team = _team(scheduler, crew, device, tls, say)
    with team as fly, open_store(folder, design, resume=resume) as store:
        for line in [*changed_versions(folder), *store.checked_parts()]:
            say(line)
        fair = -(-(design.flights - store.done) // ((1 if on_gpu else SHARES) * crew))
        size = wanted if chunk else max(1, min(wanted, fair))
        chunks = store.missing(size)
        watch, failed = _Watch(store), list[GivenUp]()
        tell = progress or _silent
        tell(watch.now())
        with contextlib.closing(fly(design.plan.canonical(), chunks, say)) as coming:
            for one in coming:
                if isinstance(one, ChunkRows):
                    store.add(*one.chunk, one.columns)
                else:
                    failed.append(one)
                    watch.given_up += one.chunk[1] - one.chunk[0]
                    say(f"flights {one.chunk[0]} to {one.chunk[1] - 1} are given up: {one.why}")
                    _note(folder, one)
                tell(watch.now())
        if failed:
            raise CampaignError(
                f"{watch.given_up} flights were given up: {failed[0].why}; {store.done} of "
                f"{design.flights} are kept, and --resume tries the others again"
            )
        campaign = Campaign(folder)
        campaign.keep(say)
    return campaign


Fly = Callable[[str, list[Chunk], Remark], Generator[ChunkRows | GivenUp]]
"""A plan and chunks of it to their rows, as they come."""


@contextlib.contextmanager
def _team(
    scheduler: str | None, crew: int, device: Device, tls: Tls | None, remark: Remark
) -> Iterator[Fly]:
    """Who flies: processes of this machine, or a cluster that answers."""
    if scheduler is None:
        yield lambda text, chunks, say: fly_locally(text, chunks, crew, say, device)
        return
    from springback.campaign.cluster import cluster_client, fly_on_cluster

    with cluster_client(scheduler, tls, remark) as client:
        yield lambda text, chunks, say: fly_on_cluster(text, chunks, client, say)


def _check_gpu(scheduler: str | None) -> None:
    """Raises InputError where no GPU can be had: better now than in every worker."""
    from springback.kernels.gpu.cuda import device

    if scheduler is not None:
        raise InputError("--device: gpu is for this machine; without --scheduler")
    device()


def _at_least_one(name: str, given: int | None, default: int) -> int:
    if given is not None and given < 1:
        raise InputError(f"--{name}: must be at least 1 (got {given})")
    return given or default


def _silent(_: Any) -> None:
    """Nobody wants to know."""


def _note(folder: Path, one: GivenUp) -> None:
    """Keep what Python said of a chunk that failed."""
    if one.details:
        with (folder / "problems.log").open("a", encoding="utf-8") as file:
            file.write(f"flights {one.chunk[0]} to {one.chunk[1] - 1}\n{one.details}\n")
