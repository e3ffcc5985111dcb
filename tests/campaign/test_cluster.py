"""A campaign on Dask, with a scheduler and workers that are processes of their own."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from builders.missing import needs
from builders.plans import plan
from springback.campaign import cluster
from springback.campaign.cluster import Tls, cluster_client, is_open
from springback.campaign.running import run_campaign
from springback.errors import InputError

distributed = pytest.importorskip("distributed", reason="needs the extra springback[cluster]")
pytestmark = pytest.mark.filterwarnings("default")  # Dask's own warnings are its own business
LOCAL = ("--host", "127.0.0.1", "--no-dashboard")


def process(word: str, *options: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", f"distributed.cli.dask_{word}", *options],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip


class Crew:
    """A scheduler and workers on loopback."""

    def __init__(self, folder: Path) -> None:
        self.file = folder / "scheduler.json"
        options = ("--port", "0", "--scheduler-file", str(self.file))
        self.processes = [process("scheduler", *LOCAL, *options)]
        end = time.monotonic() + 60.0
        while not self.address:
            assert time.monotonic() < end
            time.sleep(0.05)

    @property
    def address(self) -> str:
        try:
            return str(json.loads(self.file.read_text())["address"])
        except (OSError, ValueError):
            return ""

    def add_worker(self) -> subprocess.Popen[bytes]:
        options = ("--nworkers", "1", "--nthreads", "1", "--no-nanny")
        self.processes.append(process("worker", self.address, *LOCAL, *options))
        return self.processes[-1]


@pytest.fixture(scope="module")
def crew(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Crew]:
    crew = Crew(tmp_path_factory.mktemp("dask"))
    yield crew
    for one in crew.processes:
        one.kill()
    for one in crew.processes:
        one.wait()


def test_rows_of_a_cluster_whose_worker_is_killed_are_those_of_one_process(
    crew: Crew, tmp_path: Path
) -> None:
    given = plan(samples=60)
    local = run_campaign(given, tmp_path / "local", workers=1)
    first, _ = crew.add_worker(), crew.add_worker()
    said: list[str] = []

    def kill_one_midway(now: object) -> None:
        if getattr(now, "done", 0) >= 12 and first.poll() is None:
            first.kill()

    spread = run_campaign(
        given, tmp_path / "spread", chunk=3, scheduler=crew.address, progress=kill_one_midway,
        remark=said.append,
    )  # fmt: skip
    assert first.wait(10) == -9
    rows = "FROM flights ORDER BY flight"
    assert spread.query(rows) == local.query(rows)
    assert (len(spread.parts), spread.done) == (40, 120)
    assert any("is gone" in line for line in said)


def test_other_versions_are_refused(
    crew: Crew, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours = cluster.versions() | {"springback": "9.9", "python": "3.99.1"}
    crew.add_worker()
    with distributed.Client(crew.address, set_as_default=False) as client:
        client.wait_for_workers(1, timeout=60)
    monkeypatch.setattr(cluster, "here", lambda: ours)
    told = r"worker tcp://.* has other versions: springback .* there, 9.9 here, python"
    with pytest.raises(InputError, match=told):
        run_campaign(plan(), tmp_path / "a", scheduler=crew.address)
    assert not (tmp_path / "a").exists()


def test_a_scheduler_that_is_not_there_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    with pytest.raises(InputError, match=r"--scheduler tcp://127.0.0.1:9: cannot be reached"):
        run_campaign(plan(), tmp_path / "a", scheduler="tcp://127.0.0.1:9")
    assert not (tmp_path / "a").exists()


def test_versions_differ_where_it_matters() -> None:
    ours = cluster.versions()
    major, minor, _ = ours["python"].split(".")
    assert cluster.version_difference(ours | {"python": f"{major}.{minor}.99"}) == ""
    assert cluster.version_difference(ours | {"numba": "0.1"}).startswith("numba 0.1 there, ")


# -- who may speak to it --------------------------------------------------------------------------


def certificates(folder: Path) -> Tls:
    """A certificate that signed itself: authority, certificate and key of a cluster of one."""
    key, certificate = folder / "key.pem", folder / "cert.pem"
    words = "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=localhost"
    subprocess.run(
        [*words.split(), "-keyout", str(key), "-out", str(certificate)],
        check=True, capture_output=True,
    )  # fmt: skip
    return Tls(certificate, certificate, key)


@needs("openssl")
def test_certificates_reach_a_cluster_that_asks_for_them(tmp_path: Path) -> None:
    tls = certificates(tmp_path)
    file = tmp_path / "scheduler.json"
    options = (
        "--port", "0", "--protocol", "tls", "--scheduler-file", str(file),
        "--tls-ca-file", str(tls.authority), "--tls-cert", str(tls.certificate),
        "--tls-key", str(tls.key),
    )  # fmt: skip
    scheduler = process("scheduler", *LOCAL, *options)
    try:
        end = time.monotonic() + 60.0
        while not file.exists() or not file.read_text():
            assert time.monotonic() < end
            time.sleep(0.05)
        address = json.loads(file.read_text())["address"]
        assert address.startswith("tls://127.0.0.1")
        said: list[str] = []
        with cluster_client(address, tls, said.append) as client:
            assert client.scheduler_info()["address"] == address
        assert said == []
        with pytest.raises(InputError, match="cannot be reached"), cluster_client(address):
            pass
    finally:
        scheduler.kill()
        scheduler.wait()


def test_certificates_that_are_not_there_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"TLS authority .*: there is no such file"):
        Tls(tmp_path / "a", tmp_path / "b", tmp_path / "c")


@pytest.mark.parametrize(
    ("address", "open_to_others"),
    [
        ("tcp://127.0.0.1:8786", False), ("tcp://localhost:8786", False), ("tcp://[::1]:8786", False),
        ("tls://node7:8786", False), ("inproc://1", False), ("tcp://node7:8786", True),
        ("tcp://10.0.0.1:8786", True), ("10.0.0.1:8786", True), ("tcp://0.0.0.0:8786", True),
    ],
)  # fmt: skip
def test_addresses_that_others_can_use_are_known(address: str, open_to_others: bool) -> None:
    assert is_open(address) is open_to_others
