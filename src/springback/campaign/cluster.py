"""Flying on a Dask cluster: chunks go to its workers, rows come back to the one who writes.

Dask flies the chunk of a worker that dies again on another, three times; the rows are the same
wherever they fly, given the same versions, which is checked.
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

#: Seconds to wait for a scheduler to answer, and between looks at who is there (chosen).
PATIENCE, LOOK = 10.0, 1.0
#: Chunks handed out ahead for each thread of the cluster (chosen): none waits for the next, and
#: few rows wait for the writer.
AHEAD = 2
_one_at_a_time = threading.Lock()
#: Versions on this side.
here = versions


def fly_remotely(text: str, chunk: Chunk) -> tuple[dict[str, str], ChunkRows]:
    """Fly a stretch on a worker; with the versions there.  Threads of a worker take turns."""
    with _one_at_a_time:
        return versions(), fly_chunk(text, chunk)


@dataclass(frozen=True)
class Tls:
    """Certificates for a cluster that speaks TLS, as PEM files."""

    authority: Path
    """Whose signature all of the cluster carry."""
    certificate: Path
    key: Path
    """Of the certificate, private."""

    def __post_init__(self) -> None:
        """Refuse files that are not there."""
        for name, path in vars(self).items():
            if not path.is_file():
                raise InputError(f"TLS {name} {path}: there is no such file")


@contextlib.contextmanager
def cluster_client(
    address: str, tls: Tls | None = None, remark: Remark | None = None
) -> Iterator[Any]:
    """A client of a cluster that can fly what we would.

    Without TLS Dask neither asks who speaks to it nor hides what is said, and runs what it is sent:
    whoever reaches its ports runs programs on its machines.

    Args:
        address: Of the scheduler.
        tls: Certificates; None leaves it to Dask's own configuration, which usually has none.
        remark: Told of a connection that others could use.

    Raises:
        InputError: If there is no scheduler, or its workers have other versions.
    """
    distributed = needs("distributed", "cluster")
    if tls is not None and not address.startswith("tls://"):
        raise InputError(f"--scheduler {address}: certificates belong to tls://HOST:PORT")
    if remark is not None and is_open(address):
        remark(
            f"{address} is neither encrypted nor asks who speaks: whoever reaches it runs programs "
            "there; use tls:// with --tls-ca, --tls-cert and --tls-key, or a tunnel"
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
    """Fly chunks on a cluster; results come in the order in which they are ready.

    Args:
        text: The plan, as `springback.campaign.design.plan.Plan.canonical` has it.
        chunks: To be flown.
        client: From `cluster_client`.
        remark: Told of workers that come and go.

    Raises:
        CampaignError: If the scheduler is lost, or a worker that joins has other versions.
    """
    distributed = needs("distributed", "cluster")
    crew = _Crew(client, remark)
    waiting, flying = deque(chunks), dict[Any, Chunk]()
    stem = f"springback-{uuid.uuid4().hex[:8]}"
    try:
        while waiting or flying:
            while waiting and len(flying) < AHEAD * max(1, crew.threads):
                chunk = waiting.popleft()
                key = f"{stem}-{chunk[0]}"
                flying[client.submit(fly_remotely, text, chunk, key=key, pure=False)] = chunk
            for future in _completed(distributed, client, list(flying)):
                yield _answer(distributed, future, flying.pop(future))
            crew.look()
    finally:
        for future in flying:
            future.release()  # nobody waits for it any more


def is_open(address: str) -> bool:
    """Whether others than this machine's own users can use what listens at an address."""
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
    except (OSError, TimeoutError, TypeError, ValueError) as error:  # also: no certificates
        said = str(error).partition("\n")[0] or type(error).__name__
        raise InputError(f"--scheduler {address}: cannot be reached ({said})") from None


class _Crew:
    """Who is there to fly."""

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
        """See who left, now and then."""
        if time.monotonic() - self.looked < LOOK:
            return
        self.looked = time.monotonic()
        try:
            now: dict[str, int] = self.client.nthreads()
        except (OSError, TimeoutError):
            raise CampaignError("the connection to the scheduler is lost") from None
        for lost in self.known.keys() - now.keys():
            self.remark(f"worker {lost} is gone; what it was flying is flown again by another")
        if self.known and not now:
            self.remark("no worker is left; waiting for one")
        self.known = now


def _completed(distributed: Any, client: Any, futures: list[Any]) -> list[Any]:
    """Futures that have ended, perhaps none yet."""
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
    """What came of a chunk."""
    if future.status == "finished":
        theirs, rows = future.result()
        if told := version_difference(theirs):
            raise CampaignError(f"a worker that joined has other versions: {told}")
        return ChunkRows(*rows)
    if future.status != "error":
        raise CampaignError(f"the cluster dropped flights {chunk[0]} to {chunk[1] - 1}")
    error = future.exception()
    if isinstance(error, distributed.KilledWorker):
        return GivenUp(chunk, "worker after worker was lost over them")
    return GivenUp(chunk, f"{type(error).__name__}: {str(error).partition(chr(10))[0]}")


def _check_versions(client: Any, address: str) -> None:
    """Refuse workers whose rows could differ from ours."""
    try:
        theirs: dict[str, Any] = client.run(versions)
    except Exception as error:  # whatever a worker without springback raises
        said = f"{type(error).__name__}: {str(error).partition(chr(10))[0]}"
        raise InputError(f"--scheduler {address}: a worker cannot fly ({said})") from None
    for worker, found in theirs.items():
        if told := version_difference(found):
            raise InputError(f"--scheduler {address}: worker {worker} has other versions: {told}")


def version_difference(theirs: dict[str, str]) -> str:
    """Versions there that are not those here, in words; of Python only major and minor count."""
    ours = here()
    told = []
    for name, this in ours.items():
        there = theirs.get(name, "none")
        length = 2 if name == "python" else None
        if there.split(".")[:length] != this.split(".")[:length]:
            told.append(f"{name} {there} there, {this} here")
    return ", ".join(told)
