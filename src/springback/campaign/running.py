"""Execution of a campaign: distribution of chunks, storage of parts, and progress."""

from __future__ import annotations

import contextlib
import os
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from springback.batch.scenarios import GPU_BLOCK, Device
from springback.campaign.access import Campaign
from springback.campaign.design.layout import Design, lay_out
from springback.campaign.design.plan import Plan
from springback.campaign.errors import CampaignError
from springback.campaign.flying import Chunk, ChunkRows, try_code
from springback.campaign.limits_check import unreached_success
from springback.campaign.plan_check import check_conditions
from springback.campaign.store import Store, changed_versions, open_store
from springback.campaign.workers import GivenUp, Remark, fly_locally
from springback.errors import InputError
from springback.scenario.user.laws import source_text
from springback.scenario.warnings import missing_elements

if TYPE_CHECKING:
    from springback.campaign.cluster import Tls

#: Flights of a chunk (chosen: seconds of work, and some 1.5 MB of rows).
CHUNK = 2000
#: The same on a GPU.
GPU_CHUNK = GPU_BLOCK
#: Smallest number of chunks per worker, if there are too few flights for full ones (chosen).
SHARES = 4
#: Number of last parts from which the rate is computed (chosen).
RECENT = 40


@dataclass(frozen=True)
class CampaignProgress:
    """Progress of a campaign."""

    done: int
    """Number of stored flights, including earlier runs."""
    flights: int
    parts: int
    refused: int
    ledger_open: int
    """Flights whose energy ledger does not close to 1e-4."""
    given_up: int
    rate: float
    """Recent flights per second; 0 while unknown."""

    @property
    def time_left(self) -> float | None:
        """Time left [s]; None while unknown."""
        return (self.flights - self.done - self.given_up) / self.rate if self.rate > 0.0 else None

    def sentence(self) -> str:
        """Text of one line."""
        share = 100.0 * self.done / self.flights
        count = "1 part" if self.parts == 1 else f"{self.parts} parts"
        parts = [f"{self.done} of {self.flights} flights ({share:.1f} %), {count}"]
        if self.rate > 0.0:
            parts.append(rate_text(self.rate))
        if self.time_left:
            parts.append(f"{duration_text(self.time_left)} left")
        if self.refused:
            parts.append(f"{self.refused} refused")
        if self.ledger_open:
            parts.append(f"warning: {self.ledger_open} with an energy balance that does not close")
        return ", ".join(parts)


def rate_text(rate: float) -> str:
    """Flights per second as text, slow ones per minute or per hour."""
    factor, unit = (3600.0, "h") if 60.0 * rate < 1.0 else (60.0, "min")
    factor, unit = (factor, unit) if rate < 1.0 else (1.0, "s")
    value = factor * rate
    return f"{value:.0f} flights/{unit}" if value >= 10.0 else f"{value:.2g} flights/{unit}"


def duration_text(seconds: float) -> str:
    """Time as text."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    if hours:
        return f"{hours} h {minutes:02d} min"
    return f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


@dataclass
class _Counter:
    """Counter of stored flights."""

    store: Store
    given_up: int = 0
    warm: bool = False
    """False if the first part, which may include compilation, is excluded from the rate."""
    recent: deque[tuple[float, int]] = field(default_factory=lambda: deque(maxlen=RECENT))
    """Times [s] and flights stored by then."""

    def progress(self) -> CampaignProgress:
        done = self.store.done
        self.recent.append((time.monotonic(), done))
        if len(self.recent) == 3 and not self.warm:
            self.recent.popleft()
            self.warm = True
        (then, before), (last, _) = self.recent[0], self.recent[-1]
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
    """Fly a campaign, or the rest of it, into a folder.

    The rows depend on the plan alone, bit for bit, not on the other arguments.  A script must call
    this under ``if __name__ == "__main__"``, as its workers import it, too.

    Args:
        plan: Plan of the campaign.
        folder: Folder of plan, parts and manifest, created if it does not exist.
        resume: Continue a campaign in the folder.
        workers: Number of processes; by default that of the cores.
        chunk: Flights flown and stored together; by default 2000, or fewer so that all workers have
            some.
        scheduler: Address of a Dask scheduler to use instead of processes.
        tls: Certificates for it, if it uses TLS.
        device: Device of the workers: ``cpu``, or ``gpu`` for an NVIDIA GPU that they share.
        progress: Called with the progress after each part.
        remark: Called with a message about each problem that was handled, and each warning.

    Returns:
        The campaign, to be queried.

    Raises:
        InputError: If the plan or the folder cannot be used.
        CampaignError: If the disk is full, workers keep dying, or the cluster is lost; stored parts
            remain, and ``resume`` continues from them.
    """
    if not isinstance(plan, Plan | Design):
        raise InputError(f"plan must be a springback.Plan (got {source_text(plan)})")
    design = plan if isinstance(plan, Design) else lay_out(plan)
    workers = _at_least_one("workers", workers, os.cpu_count() or 1)
    on_gpu = device == "gpu"
    wanted = _at_least_one("chunk", chunk, GPU_CHUNK if on_gpu else CHUNK)
    folder, remark, progress = Path(folder), remark or _silent, progress or _silent
    check_conditions(design)
    try_code(design, device)
    if on_gpu:
        _check_gpu(scheduler)
    flyer = _chunk_flyer(scheduler, workers, device, tls, remark)
    with flyer as fly, open_store(folder, design, resume=resume) as store:
        found = unreached_success(design) + missing_elements(design.full_scenarios)
        warned = [f"warning: {line}" for line in found]
        for line in [*warned, *changed_versions(folder), *store.checked_parts()]:
            remark(line)
        fair = -(-(design.flights - store.done) // ((1 if on_gpu else SHARES) * workers))
        size = wanted if chunk else max(1, min(wanted, fair))
        chunks = store.missing(size)
        counter, failed = _Counter(store), list[GivenUp]()
        progress(counter.progress())
        with contextlib.closing(fly(design.plan.canonical(), chunks, remark)) as results:
            for result in results:
                if isinstance(result, ChunkRows):
                    _check_code(design, result.code)
                    store.add(*result.chunk, result.columns)
                else:
                    failed.append(result)
                    first, last = result.chunk
                    counter.given_up += last - first
                    remark(f"flights {first} to {last - 1} are given up: {result.why}")
                    _log_failure(folder, result)
                progress(counter.progress())
        if failed:
            raise CampaignError(
                f"{counter.given_up} flights were given up: {failed[0].why}; {store.done} of "
                f"{design.flights} are kept, and --resume tries the others again"
            )
        campaign = Campaign(folder)
        campaign.keep(remark)
    return campaign


def _check_code(design: Design, flown: Mapping[str, str]) -> None:
    """Reject rows that were flown with other files of the user's own than those here."""
    if flown != design.code:
        changed = sorted({path for path, _ in set(flown.items()) ^ set(design.code.items())})
        raise CampaignError(
            f"{', '.join(changed)}: differs between this process and the one that flew, or was "
            "changed during the flights"
        )


Fly = Callable[[str, list[Chunk], Remark], Generator[ChunkRows | GivenUp]]
"""Function from a plan and its chunks to their rows, as they become ready."""


@contextlib.contextmanager
def _chunk_flyer(
    scheduler: str | None, workers: int, device: Device, tls: Tls | None, remark: Remark
) -> Iterator[Fly]:
    """Function that flies chunks, by processes of this machine or on a cluster."""
    if scheduler is None:
        yield lambda text, chunks, remark: fly_locally(text, chunks, workers, remark, device)
        return
    from springback.campaign.cluster import cluster_client, fly_on_cluster

    with cluster_client(scheduler, tls, remark) as client:
        yield lambda text, chunks, remark: fly_on_cluster(text, chunks, client, remark)


def _check_gpu(scheduler: str | None) -> None:
    """Raise InputError if no GPU is available, before every worker does."""
    from springback.kernels.gpu.cuda import device

    if scheduler is not None:
        raise InputError("--device: gpu is for this machine; without --scheduler")
    device()


def _at_least_one(name: str, given: int | None, default: int) -> int:
    if given is not None and given < 1:
        raise InputError(f"--{name}: must be at least 1 (got {given})")
    return given or default


def _silent(_: Any) -> None:
    """Discard progress and messages."""


def _log_failure(folder: Path, lost: GivenUp) -> None:
    """Store the traceback of a chunk that was given up."""
    if lost.details:
        with (folder / "problems.log").open("a", encoding="utf-8") as file:
            file.write(f"flights {lost.chunk[0]} to {lost.chunk[1] - 1}\n{lost.details}\n")
