"""``springback view`` as a newcomer meets it: pages, a server on this machine, clear errors."""

from __future__ import annotations

import base64
import contextlib
import hashlib
import json
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest

from springback.errors import InputError
from springback.interfaces.cli.view import spinner_label
from springback.interfaces.replay.labels import difference, labels_of, scenes_of
from springback.interfaces.replay.viewer import flights_of, replay_of, twin_words
from springback.interfaces.reports.flight_files import write_flight
from springback.interfaces.web.page import in_script, page_of, part
from springback.interfaces.web.server import bound, is_welcome
from springback.results.flight import Flight, fly
from springback.results.saved import load

ROOT = Path(__file__).parents[3]
TABLES = {
    "vehicle": "arq",
    "thrust": "hover",
    "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
    "start": {"position": [2.3, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
    "simulation": {"duration": 0.1},
}


@pytest.fixture(scope="module")
def flight() -> Flight:
    return fly(TABLES)


@pytest.fixture(scope="module")
def folder(flight: Flight, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("result")
    write_flight(flight, folder, figures=False)
    return folder


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "springback", "view", *words],
        cwd=cwd, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


def refused(done: subprocess.CompletedProcess[str], *words: str) -> None:
    """Exit code 2, one line on stderr with all the words, nothing on stdout, no traceback."""
    assert done.returncode == 2, done.stderr
    lines = done.stderr.strip().splitlines()
    assert len(lines) == 1, done.stderr
    assert lines[0].startswith("error: ")
    for word in words:
        assert word in lines[0], f"{word!r} not in {lines[0]!r}"


# -- the page -------------------------------------------------------------------------------------


def test_export_writes_one_page_that_loads_nothing(folder: Path, tmp_path: Path) -> None:
    """No address of another place in an attribute or a style sheet; its policy forbids them, too."""
    done = run(str(folder), "--export", "flight.html", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "flight.html").read_text()
    markup = re.sub(r"<(script|style)\b.*?</\1>", "", text, flags=re.S)
    assert not re.search(r"""(src|href|action)\s*=\s*["']?\s*(https?:)?//""", markup)
    assert "url(" not in part("springback.css")
    assert "@import" not in part("springback.css")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)
    assert policy
    assert "default-src &#x27;none&#x27;" in policy[1]
    assert "connect-src &#x27;none&#x27;" in policy[1]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["flight.html"]


def test_the_policy_lets_the_pages_own_script_run_and_no_other(flight: Flight) -> None:
    page = replay_of([flight])
    scripts = re.findall(r"<script>(.*?)</script>", page.text, flags=re.S)
    assert len(scripts) == 1
    digest = base64.b64encode(hashlib.sha256(scripts[0].encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}';" in page.policy


def test_the_same_flight_makes_the_same_page(flight: Flight) -> None:
    assert replay_of([flight]).text == replay_of([flight]).text


def test_names_cannot_break_out_of_the_page(flight: Flight) -> None:
    evil = "</script><script>alert(1)</script><!--{{script}}"  # U+2028 is refused in names
    scenario = flight.scenario.model_copy(update={"name": evil})
    text = replay_of([replace(flight, scenario=scenario)]).text
    assert "<script>alert(1)" not in text
    assert text.count("</script>") == 2
    data = re.search(r'id="data">(.*?)</script>', text, flags=re.S)
    assert data
    assert json.loads(data[1])["flights"][0]["scenario"] == evil
    assert "\u2028" not in in_script({"a": "\u2028"})


def test_a_lab_page_may_ask_its_own_server_only() -> None:
    assert "connect-src 'self'" in page_of("lab", "lab", {}, asks=True).policy


def test_the_bundle_is_that_of_the_sources() -> None:
    """The digest in its first line is that of web/: run make web after a change there."""
    web = ROOT / "web"
    names = ["build.mjs", "package-lock.json", *(f"src/{p.name}" for p in (web / "src").iterdir())]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(f"{name}\n".encode() + (web / name).read_bytes())
    for name in ("springback.js", "springback.css"):
        assert f"sources {digest.hexdigest()}" in part(name)[:300], f"{name} is stale: make web"


def test_page_and_guide_both_tell_what_the_mouse_does_in_a_plot() -> None:
    """A click, a drag, and the way back: each told one of them and left out the others."""
    guide = (ROOT / "docs/howto/replay.md").read_text()
    for text in (guide, part("springback.js")):
        for word in ("a click", "a drag", "a double click"):
            assert word in text, word


def test_the_bundle_carries_its_licences() -> None:
    """Beside it and in it, so that an exported page has them."""
    told = (resources.files("springback.interfaces") / "web" / "LICENSES.txt").read_text()
    for text in (told, part("springback.js")):
        assert "three.js authors" in text
        assert "Leon Sorokin" in text
        assert text.count("Permission is hereby granted") >= 2


# -- flights --------------------------------------------------------------------------------------


def test_while_it_waits_it_says_what_it_does(folder: Path) -> None:
    """A stored flight is read and drawn; only what is flown is compiled for."""
    assert "compiled" not in spinner_label([folder])
    assert spinner_label([folder]).startswith("reading the flight")
    assert "compiled" in spinner_label([folder, Path("scenario.toml")])
    assert "compiled" in spinner_label(
        [folder, Path("17")]
    )  # the number of a row, which is flown again


def test_a_twin_differs_in_its_arms(flight: Flight) -> None:
    assert twin_words(flight) == ["vehicle=quad"]
    own = flight.scenario.vehicle.model_copy(update={"name": "mine"})
    mine = replace(flight, scenario=flight.scenario.model_copy(update={"vehicle": own}))
    assert "vehicle.arms.compliant=false" in twin_words(mine)


def test_flights_are_told_apart(flight: Flight) -> None:
    assert labels_of([flight]) == ["ARQ"]
    assert labels_of([flight, flight]) == ["ARQ 1", "ARQ 2"]
    other = replace(flight, scenario=flight.scenario.model_copy(update={"name": "softer"}))
    assert labels_of([flight, other]) == ["flight", "softer"]


def test_flights_of_one_robot_go_by_their_folders(flight: Flight) -> None:
    assert labels_of([flight, flight], ["out/plain", "out/softer"]) == [
        "ARQ (plain)",
        "ARQ (softer)",
    ]
    assert labels_of([flight, flight], ["a/out", "b/out"]) == ["ARQ (a/out)", "ARQ (b/out)"]
    assert labels_of([flight, flight], ["out", "out"]) == ["ARQ 1", "ARQ 2"]
    far = ["/runs/a/mon/out", "/runs/b/mon/out", "/runs/b/tue/out"]
    assert labels_of([flight] * 3, far) == [
        "ARQ (a/mon/out)",
        "ARQ (b/mon/out)",
        "ARQ (b/tue/out)",
    ]


def test_the_command_labels_flights_by_the_folders_it_was_given(
    folder: Path, tmp_path: Path
) -> None:
    for name in ("plain", "softer"):
        shutil.copytree(folder, tmp_path / name)
    done = run("plain", "softer", "--export", "two.html", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    data = re.search(r'id="data">(.*?)</script>', (tmp_path / "two.html").read_text(), re.S)
    assert data
    labels = [flight["label"] for flight in json.loads(data[1])["flights"]]
    assert labels == ["ARQ (plain)", "ARQ (softer)"]


def test_other_flights_say_in_what_they_differ_from_the_first(flight: Flight) -> None:
    """The settings that were overridden, in SI, with the value of the first flight."""
    arms = flight.scenario.vehicle.arms.model_copy(update={"stiffness": "2 N/mm"})
    vehicle = flight.scenario.vehicle.model_copy(update={"arms": arms})
    softer = replace(flight, scenario=flight.scenario.model_copy(update={"vehicle": vehicle}))
    said = "vehicle.arms.stiffness (2000 instead of 5000)"
    assert difference(flight, softer) == said
    assert difference(flight, flight) == ""
    first, *others = scenes_of([flight, softer, flight, softer], ["plain", "a", "b", "c"])
    assert not any("differs" in note for note in first.notes)
    notes = [scene.notes[-1:] for scene in others]
    assert notes == [(f"differs from ARQ (plain) in {said}",), (), notes[0]]


def test_a_scenario_is_flown_with_its_twin(tmp_path: Path, folder: Path) -> None:
    path = tmp_path / "s.toml"
    path.write_text(
        'vehicle = "arq"\nthrust = "hover"\n[start]\nposition = [2.3, 0, 1]\n'
        "velocity = [2, 0, 0]\n[simulation]\nduration = 0.1\n[[world.obstacles]]\n"
        'type = "wall"\ndistance = 2.75\nsurface = "wall"\n'
    )
    arq, quad = flights_of([path], twin=True)
    assert (arq.scenario.vehicle.name, quad.scenario.vehicle.name) == ("arq", "quad")
    assert arq.measures == load(folder).measures
    with pytest.raises(InputError, match="--twin"):
        flights_of([folder], twin=True)
    with pytest.raises(InputError, match="one to 8"):
        flights_of([folder] * 9)


# -- errors ---------------------------------------------------------------------------------------


def test_bad_input_is_one_line_and_leaves_everything_as_it_was(
    folder: Path, tmp_path: Path
) -> None:
    there = tmp_path / "there.html"
    there.write_text("mine")
    refused(run(str(folder), "--export", "there.html", cwd=tmp_path), "there.html", "--force")
    refused(run(str(folder), "--export", "no/such/x.html", cwd=tmp_path), "--export")
    refused(run("nothing", "--export", "x.html", cwd=tmp_path), "nothing", "no such folder")
    assert there.read_text() == "mine"
    assert [p.name for p in tmp_path.iterdir()] == ["there.html"]
    assert run(str(folder), "--export", "there.html", "--force", cwd=tmp_path).returncode == 0
    assert there.read_text().startswith("<!doctype html>")


def test_a_port_that_is_taken_or_no_port_is_refused() -> None:
    with bound("127.0.0.1", 0) as mine:
        port = mine.getsockname()[1]
        with pytest.raises(InputError, match=f"--port {port}"):
            bound("127.0.0.1", port)
    for wrong in (-1, 65536):
        with pytest.raises(InputError, match="65535"):
            bound("127.0.0.1", wrong)
    with pytest.raises(InputError, match="--host"):
        bound("no such host", 0)


# -- the server -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("header", "host", "welcome"),
    [
        ("127.0.0.1:8080", "127.0.0.1", True), ("localhost", "127.0.0.1", True),
        ("[::1]:80", "::1", True), ("LOCALHOST:1", "127.0.0.1", True),
        ("evil.example", "127.0.0.1", False), ("127.0.0.1.evil.example", "127.0.0.1", False),
        ("", "127.0.0.1", False), ("192.168.0.7:80", "127.0.0.1", False),
        ("192.168.0.7:80", "0.0.0.0", True), ("evil.example:80", "0.0.0.0", False),
        ("lab.example", "lab.example", True), ("[::1", "127.0.0.1", True),
    ],
)  # fmt: skip
def test_only_requests_meant_for_this_server_are_answered(
    header: str, host: str, welcome: bool
) -> None:
    """Else a page elsewhere could read ours under a name of its own (DNS rebinding)."""
    assert is_welcome(header, host) is welcome


@pytest.fixture
def server(folder: Path, tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A served replay and its address."""
    words = [sys.executable, "-m", "springback", "view", str(folder), "--no-browser"]
    with subprocess.Popen(words, cwd=tmp_path, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr
        timer = threading.Timer(240, process.kill)
        timer.start()
        try:
            line = process.stderr.readline()
            assert line.startswith("replay: http://127.0.0.1:"), line
            assert "ssh -L" in process.stderr.readline()
            yield process, line.split(": ", 1)[1].strip()
        finally:
            timer.cancel()
            with contextlib.suppress(ProcessLookupError):
                process.kill()


def test_view_serves_on_loopback_and_ends_cleanly(
    server: tuple[subprocess.Popen[str], str],
) -> None:
    """The page with strict headers; other hosts, paths and verbs get nothing; Ctrl-C is exit 0."""
    process, url = server
    with urllib.request.urlopen(url, timeout=30) as answer:
        text, headers = answer.read().decode(), answer.headers
    assert 'data-app="replay"' in text
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"
    for asked, code in (
        (urllib.request.Request(url, headers={"Host": "evil.example"}), 421),
        (urllib.request.Request(f"{url}../../etc/passwd"), 404),
        (urllib.request.Request(url, data=b"x"), 405),
    ):
        with pytest.raises(urllib.error.HTTPError) as caught:
            urllib.request.urlopen(asked, timeout=30)
        assert caught.value.code == code
        caught.value.close()
    port = int(url.rsplit(":", 1)[1].strip("/"))
    with socket.socket() as other:  # the machine's other addresses are closed
        other.settimeout(5)
        assert other.connect_ex(("127.0.0.2", port)) != 0
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=60) == 0
