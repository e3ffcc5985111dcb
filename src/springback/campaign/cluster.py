"""Flights on a Dask cluster, whose workers fly chunks and return rows to the writing process.

Dask repeats the chunk of a worker that dies on another one, up to three times; rows do not depend
on the worker, given the same versions, which is checked.
"""

from __future__ import annotations

import contextlib
import ipaddress
import threading
import time
import uuid
from collections import deque
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from springback.campaign.errors import CampaignError
from springback.campaign.flying import Chunk, ChunkRows, fly_chunk
from springback.campaign.store import versions
from springback.campaign.workers import GivenUp, Remark
from springback.errors import InputError
from springback.extras import needs

#: Time limit for a scheduler to answer, and interval of checks for lost workers [s] (chosen).
PATIENCE, LOOK = 10.0, 1.0
#: Chunks submitted in advance per thread of the cluster (chosen): no thread waits for the next, and
#: few rows wait for the writer.
AHEAD = 2
_one_at_a_time = threading.Lock()
#: Versions of this process.
here = versions


def fly_remotely(text: str, chunk: Chunk) -> tuple[dict[str, str], ChunkRows]:
    """Fly a chunk on a worker, one thread at a time; returns the worker's versions, too."""
    with _one_at_a_time:
        return versions(), fly_chunk(text, chunk)


@dataclass(frozen=True)
class Tls:
    """Certificates for a cluster with TLS, as PEM files."""

    authority: Path
    """Certificate of the authority that has signed those of the cluster."""
    certificate: Path
    key: Path
    """Private key of the certificate."""

    def __post_init__(self) -> None:
        """Reject missing files."""
        for name, path in vars(self).items():
            if not path.is_file():
                raise InputError(f"TLS {name} {path}: there is no such file")


@contextlib.contextmanager
def cluster_client(
    address: str, tls: Tls | None = None, remark: Remark | None = None
) -> Iterator[Any]:
    """Client of a cluster whose workers give the same rows as this process.

    Without TLS Dask neither authenticates nor encrypts, and runs any code it receives: anyone who
    can reach its ports can run programs on its machines.

    Args:
        address: Address of the scheduler.
        tls: Certificates; None uses Dask's own configuration, which usually has none.
        remark: Called with a warning about an open connection.

    Raises:
        InputError: If there is no scheduler, or its workers have other versions.
    """
    distributed = needs("distributed", "cluster")
    if tls is not None and not address.startswith("tls://"):
        raise InputError(f"--scheduler {address}: certificates belong to tls://HOST:PORT")
    if remark is not None and is_open(address):
        remark(
            f"{address} is neither encrypted nor authenticated: anyone who can reach it can run "
            "programs there; use tls:// with --tls-ca, --tls-cert and --tls-key, or a tunnel"
        )
    client = _client(distributed, address, tls)
    try:
        _check_versions(client, address)
        yield client
    finally:
        client.close(timeout=2.0)


def fly_on_cluster(
    text: str, chunks: Iterable[Chunk], client: Any, remark: Remark
) -> Generator[ChunkRows | GivenUp]:
    """Fly chunks on a cluster; yields results as they become ready.

    Args:
        text: The plan, from `springback.campaign.design.plan.Plan.canonical`.
        chunks: Chunks to fly.
        client: Client from `cluster_client`.
        remark: Called with messages about workers that join or leave.

    Raises:
        CampaignError: If the scheduler is lost, or a worker that joins has other versions.
    """
    distributed = needs("distributed", "cluster")
    workers = _Workers(client, remark)
    waiting, flying = deque(chunks), dict[Any, Chunk]()
    stem = f"springback-{uuid.uuid4().hex[:8]}"
    try:
        while waiting or flying:
            while waiting and len(flying) < AHEAD * max(1, workers.threads):
                chunk = waiting.popleft()
                key = f"{stem}-{chunk[0]}"
                flying[client.submit(fly_remotely, text, chunk, key=key, pure=False)] = chunk
            for future in _done_futures(distributed, client, list(flying)):
                yield _answer(distributed, future, flying.pop(future))
            workers.look()
    finally:
        for future in flying:
            future.release()  # it is no longer needed


def is_open(address: str) -> bool:
    """True if users of other machines can connect to an address."""
    protocol, sign, rest = address.rpartition("://")
    if sign and protocol not in ("tcp", "ws"):
        return False
    host = rest.rpartition(":")[0].strip("[]")
    try:
        return not ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host != "localhost"


def _client(distributed: Any, address: str, tls: Tls | None) -> Any:
    security = None
    if tls is not None:
        security = distributed.Security(
            tls_ca_file=str(tls.authority), tls_client_cert=str(tls.certificate),
            tls_client_key=str(tls.key), require_encryption=True,
        )  # fmt: skip
    try:
        return distributed.Client(
            address, timeout=PATIENCE, set_as_default=False, security=security
        )
    except (OSError, TimeoutError, TypeError, ValueError) as error:  # also without certificates
        said = str(error).partition("\n")[0] or type(error).__name__
        raise InputError(f"--scheduler {address}: cannot be reached ({said})") from None


class _Workers:
    """Workers of a cluster."""

    def __init__(self, client: Any, remark: Remark) -> None:
        self.client, self.remark = client, remark
        self.known: dict[str, int] = client.nthreads()
        self.looked = time.monotonic()
        if not self.known:
            remark("the scheduler has no workers yet; waiting for some")

    @property
    def threads(self) -> int:
        return sum(self.known.values())

    def look(self) -> None:
        """Report workers that have left, at intervals."""
        if time.monotonic() - self.looked < LOOK:
            return
        self.looked = time.monotonic()
        try:
            now: dict[str, int] = self.client.nthreads()
        except (OSError, TimeoutError):
            raise CampaignError("the connection to the scheduler is lost") from None
        for lost in self.known.keys() - now.keys():
            self.remark(f"worker {lost} is gone; its chunk is flown again by another")
        if self.known and not now:
            self.remark("no worker is left; waiting for one")
        self.known = now


def _done_futures(distributed: Any, client: Any, futures: list[Any]) -> list[Any]:
    """Futures that are done, possibly none."""
    if client.status not in ("running", "connecting"):
        raise CampaignError("the connection to the scheduler is lost")
    try:
        with client.as_current():
            some = distributed.wait(futures, timeout=LOOK, return_when="FIRST_COMPLETED")
        return list(some.done)
    except (TimeoutError, distributed.TimeoutError):
        return []
    except (distributed.CancelledError, OSError):
        raise CampaignError("the connection to the scheduler is lost") from None


def _answer(distributed: Any, future: Any, chunk: Chunk) -> ChunkRows | GivenUp:
    """Rows of a chunk, or the reason for giving it up."""
    if future.status == "finished":
        theirs, rows = future.result()
        if difference := version_difference(theirs):
            raise CampaignError(f"a worker that joined has other versions: {difference}")
        return ChunkRows(*rows)
    if future.status != "error":
        raise CampaignError(f"the cluster dropped flights {chunk[0]} to {chunk[1] - 1}")
    error = future.exception()
    if isinstance(error, distributed.KilledWorker):
        return GivenUp(chunk, "several workers in succession were lost while flying them")
    return GivenUp(chunk, f"{type(error).__name__}: {str(error).partition(chr(10))[0]}")


def _check_versions(client: Any, address: str) -> None:
    """Reject workers whose rows could differ from ours."""
    try:
        theirs: dict[str, Any] = client.run(versions)
    except Exception as error:  # any error of a worker without springback
        said = f"{type(error).__name__}: {str(error).partition(chr(10))[0]}"
        raise InputError(f"--scheduler {address}: a worker cannot fly ({said})") from None
    for worker, found in theirs.items():
        if difference := version_difference(found):
            raise InputError(
                f"--scheduler {address}: worker {worker} has other versions: {difference}"
            )


def version_difference(theirs: dict[str, str]) -> str:
    """Differing versions, as text; of Python only major and minor count."""
    ours = here()
    changes = []
    for name, this in ours.items():
        there = theirs.get(name, "none")
        length = 2 if name == "python" else None
        if there.split(".")[:length] != this.split(".")[:length]:
            changes.append(f"{name} {there} there, {this} here")
    return ", ".join(changes)
