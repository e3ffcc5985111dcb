"""The impact lab as it is served, without a browser: one after another, many at once, hostile ones."""

# what is optional is asked for before what needs it

import asyncio
import contextlib
import http.client
import json
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="the lab needs the extra web")
pytest.importorskip("uvicorn", reason="the lab needs the extra web")

from interfaces.lab.lab_served import WRONG, served_lab
from springback.errors import InputError
from springback.interfaces.lab.queue import (
    AT_START,
    Busy,
    NotReady,
    RequestQueue,
    Superseded,
    kind_of,
)
from springback.interfaces.lab.responses import answer
from springback.interfaces.lab.scenarios import lab_toml
from springback.interfaces.lab.settings import (
    DEFAULTS,
    LabSettings,
    settings_from,
)


def setting(**words: Any) -> LabSettings:
    return settings_from((name, str(value)) for name, value in words.items())


# -- the queue -------------------------------------------------------------------------------------


def asked(queue: RequestQueue, *requests: tuple[LabSettings, str]) -> list[Any]:
    async def all_of_them() -> list[Any]:
        tasks = [asyncio.ensure_future(queue.ask(*one)) for one in requests]
        return list(await asyncio.gather(*tasks, return_exceptions=True))

    return asyncio.run(all_of_them())


def test_of_one_page_only_the_newest_request_is_flown() -> None:
    flown, gate = [], threading.Event()

    def give(one: LabSettings) -> dict[str, Any]:
        gate.wait(5.0)
        flown.append(one.speed)
        return {"speed": one.speed}

    queue = RequestQueue(give, threads=1)
    queue._ready.add(kind_of(DEFAULTS))
    threading.Timer(0.3, gate.set).start()
    found = asked(
        queue, *((setting(speed=1 + k), "page") for k in range(4)), (setting(speed=5.5), "other")
    )
    # the first is under way when the others come; of these the last counts
    assert [type(one) for one in found] == [bytes, Superseded, Superseded, bytes, bytes]
    assert flown == [1.0, 4.0, 5.5]


def test_the_queue_has_an_end() -> None:
    gate = threading.Event()

    def give(one: LabSettings) -> dict[str, Any]:
        gate.wait(5.0)
        return {}

    queue = RequestQueue(give, threads=1)
    queue._ready.add(kind_of(DEFAULTS))
    threading.Timer(0.3, gate.set).start()
    found = asked(queue, *((DEFAULTS, "") for _ in range(103)))
    assert [type(one) for one in found].count(Busy) == 3
    assert [type(one) for one in found].count(bytes) == 100


def test_kinds_are_prepared_aside_and_what_is_asked_for_comes_next() -> None:
    order, gates = [], threading.Semaphore(0)

    def give(one: LabSettings) -> dict[str, Any]:
        gates.acquire(timeout=5.0)
        order.append(kind_of(one))
        return {}

    queue = RequestQueue(give, threads=1, prepared=AT_START)
    queue.start()
    wanted = setting(mode="flight", recovery="staged", speed=6, pitch=-60)
    (refusal,) = asked(queue, (wanted, ""))
    assert isinstance(refusal, NotReady)
    assert "staged" in refusal.kind.words
    for _ in range(6):
        gates.release()
    assert queue.wait(wanted, 5.0)
    assert order.index(kind_of(wanted)) <= 1  # at most one was under way before it
    assert queue.wait(AT_START[-1], 5.0)
    assert order[0] == kind_of(AT_START[0]) or order[0] == kind_of(wanted)


@pytest.mark.parametrize(("words", "said"), [
    ({"obstacle": "window"}, "impacts on a window, free"),
    ({"obstacle": "door"}, "impacts on a door, free"),
    ({"obstacle": "door", "mode": "flight"}, "flights into a door, recovery by a quintic"),
    ({"obstacle": "ball", "mode": "flight"}, "hits on a hovering robot by a ball, recovery by a quintic"),
    ({"surface": "mat"}, "impacts on a mat, on the slider"),
])  # fmt: skip
def test_while_it_compiles_the_chosen_obstacle_is_named(words: dict[str, str], said: str) -> None:
    """All shapes are one kind to the compiler; who chose a window is not told of poles."""
    (refusal,) = asked(RequestQueue(lambda one: {}, threads=1, prepared=()), (setting(**words), ""))
    assert isinstance(refusal, NotReady)
    assert refusal.words == said


# -- served ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def port() -> Iterator[int]:
    with served_lab() as number:
        yield number


def get(
    port: int, path: str, method: str = "GET", body: str | None = None, **headers: str
) -> tuple[int, dict[str, str], bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    try:
        connection.request(
            method, path, body, {name.replace("_", "-"): value for name, value in headers.items()}
        )
        response = connection.getresponse()
        return response.status, {k.lower(): v for k, v in response.getheaders()}, response.read()
    finally:
        connection.close()


def test_the_page_may_load_nothing_from_elsewhere(port: int) -> None:
    status, heads, body = get(port, "/?speed=2")
    assert (status, heads["content-type"]) == (200, "text/html; charset=utf-8")
    assert heads["content-security-policy"].startswith("default-src 'none'")
    assert heads["x-content-type-options"] == "nosniff"
    assert b'<link rel="stylesheet"' not in body
    assert b"src=" not in body.split(b'id="data"')[0]


def test_twenty_clients_at_once_get_each_their_own_answer(port: int) -> None:
    queries = [
        f"robot={('arq', 'quad', 'both')[k % 3]}&speed={1 + 0.2 * k:.2f}&pitch={k}&stiffness={1 + k}"
        for k in range(20)
    ]

    def told(query: str) -> Any:
        for _ in range(200):
            status, _, body = get(port, f"/flight?{query}", x_lab_page=query[:38])
            if status != 503:
                break
        assert status == 200, body[:300]
        found = json.loads(body)
        return {name: found[name] for name in ("query", "settings", "flights", "measures")}

    alone = [told(query) for query in queries]
    with ThreadPoolExecutor(20) as pool:
        together = list(pool.map(told, queries))
    assert together == alone
    assert len({json.dumps(one["measures"]) for one in alone}) == 20


@pytest.mark.parametrize("query", WRONG)
def test_wrong_settings_are_refused_with_the_line(port: int, query: str) -> None:
    status, _, body = get(port, "/flight?" + query.replace(" ", "%20"))
    assert status == 422
    assert json.loads(body)["errors"][0].startswith(WRONG[query])
    assert b"Traceback" not in body
    assert get(port, "/scenario.toml?" + query.replace(" ", "%20"))[0] == 422


@pytest.mark.parametrize(("path", "how", "status", "words"), [
    ("/flight", {"Host": "evil.example"}, 421, b"name"),
    ("/flight", {"Host": "evil.example:80"}, 421, b"name"),
    ("/flight", {"Origin": "http://evil.example"}, 403, b"evil.example may not query"),
    ("/flight", {"Origin": "null"}, 403, b"may not query"),
    ("/flight", {"Origin": "http://["}, 403, b"may not query"),
    ("/flight", {"Origin": ""}, 403, b"may not query"),
    ("/flight", {"Sec_Fetch_Site": "cross-site", "Sec_Fetch_Mode": "no-cors"}, 403, b"other sites"),
    ("/flight?" + "speed=2&" * 200, {}, 414, b"characters"),
    ("/flight", {"method": "POST"}, 405, b"GET"),
    ("/flight", {"method": "POST", "body": "x" * 1_000_000}, 413, b"no request body"),
    ("/flight", {"method": "GET", "body": "speed=2"}, 413, b"no request body"),
    ("/flight", {"method": "DELETE"}, 405, b"GET"),
    ("/../../../etc/passwd", {}, 404, b"not found"),
    ("/%2e%2e/%2e%2e/etc/passwd", {}, 404, b"not found"),
    ("/scenario.toml?of=../arq", {}, 422, b"of: must be arq or quad"),
    ("/scenario.toml?of=arq&of=quad", {}, 422, b"of: is given 2 times"),
    ("/scenario.toml?robot=quad&of=arq", {}, 422, b"of: must be quad"),
    ("/flight?of=arq", {}, 422, b"of: unknown key"),
    ("/sweep?of=../stiffness", {}, 422, b"of: cannot be swept"),
    ("/sweep?of=speed&of=yaw", {}, 422, b"of: is given 2 times"),
    ("/sweep?of=speed&mode=flight", {}, 422, b"a campaign can"),
    ("/sweep?of=speed", {"Origin": "http://evil.example"}, 403, b"may not query"),
    ("/sweep?of=speed", {"method": "POST"}, 405, b"GET"),
])  # fmt: skip
def test_hostile_requests_are_refused(
    port: int, path: str, how: dict[str, str], status: int, words: bytes
) -> None:
    found = get(port, path, **how)
    assert found[0] == status, found[2][:300]
    assert words in found[2]


def test_a_long_first_line_does_not_hurt_it(port: int) -> None:
    with contextlib.suppress(ConnectionError):  # it may hang up on us before it is all said
        assert get(port, "/flight?" + "a" * 200_000)[0] in (400, 414, 431)
    assert get(port, "/flight?robot=quad")[0] == 200


def test_run_ups_that_cannot_be_flown_are_told_as_such(port: int) -> None:
    with pytest.raises(InputError, match=r"run-up to 6 m/s .* needs a distance"):
        answer(setting(mode="flight", speed=6))


def test_a_scenario_can_be_taken_away(port: int) -> None:
    status, heads, body = get(port, "/scenario.toml?stiffness=2.6&of=arq")
    assert status == 200
    assert heads["content-disposition"] == 'attachment; filename="impact-arq.toml"'
    assert body.decode() == lab_toml(setting(stiffness=2.6), "arq")
    assert 'stiffness = "2.6 N/mm"' in body.decode()


def test_the_command_serves_until_interrupted_and_writes_nothing(tmp_path: Path) -> None:
    work = tmp_path / "here"
    work.mkdir()
    process = subprocess.Popen(
        [sys.executable, "-m", "springback", "lab", "--no-browser"], cwd=work,
        stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    try:
        assert process.stderr is not None
        line = process.stderr.readline()
        found = re.fullmatch(r"impact lab: http://127\.0\.0\.1:(\d+)/\n", line)
        assert found, line
        assert get(int(found[1]), "/")[0] == 200
        assert get(int(found[1]), "/flight?speed=7")[0] == 422
        process.send_signal(signal.SIGINT)
        out, rest = process.communicate(timeout=30)
    finally:
        process.kill()
        process.wait()
    assert process.returncode == 0
    assert out == ""
    assert "Traceback" not in rest
    assert list(work.iterdir()) == []


@pytest.mark.parametrize(("words", "line"), [
    (["--port", "99999"], "error: --port 99999: must be from 0 to 65535; 0 takes a free one"),
    (["--host", "no.such.host.invalid"], "error: --host no.such.host.invalid: is not a name or address of this machine"),
])  # fmt: skip
def test_where_it_cannot_be_served_is_told_in_one_line(
    words: list[str], line: str, tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "springback", "lab", "--no-browser", *words], cwd=tmp_path,
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr.strip()) == (2, line)
