"""The server itself: connections that never ask anything do not keep others out."""

from __future__ import annotations

import http.client
import socket
import threading
import time
from collections.abc import Iterator
from typing import Any

import pytest

from springback.interfaces.web.server import bound, server_of

PATIENCE = 0.5
ANSWER = b"here I am"


async def hello(scope: Any, receive: Any, send: Any) -> None:
    if scope["type"] != "http":
        return
    if scope["path"] == "/slow":
        import asyncio

        await asyncio.sleep(3.0 * PATIENCE)
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": ANSWER})


@pytest.fixture(scope="module")
def port() -> Iterator[int]:
    server = server_of(hello, patience=PATIENCE)
    server.config.lifespan = "off"
    with bound("127.0.0.1", 0) as listening:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        while not server.started:
            time.sleep(0.01)
        yield listening.getsockname()[1]
        server.should_exit = True
        thread.join(10.0)


def answer(port: int, path: str = "/") -> bytes:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    try:
        connection.request("GET", path)
        return connection.getresponse().read()
    finally:
        connection.close()


def is_closed(client: socket.socket, within: float) -> bool:
    client.settimeout(within)
    try:
        return client.recv(100) == b""
    except ConnectionResetError:
        return True
    except TimeoutError:
        return False


@pytest.mark.parametrize("begun", [b"", b"GET / HTTP/1.1\r\n", b"GET / HTTP/1.1\r\nHost: local"])
def test_half_requests_are_given_up(port: int, begun: bytes) -> None:
    """All of 50 are gone in time, and others are answered meanwhile."""
    clients = [socket.create_connection(("127.0.0.1", port)) for _ in range(50)]
    for client in clients:
        client.sendall(begun)
    assert answer(port) == ANSWER
    time.sleep(2.0 * PATIENCE)
    assert all(is_closed(client, 5.0) for client in clients)
    for client in clients:
        client.close()


def test_a_letter_now_and_then_gains_no_time(port: int) -> None:
    with socket.create_connection(("127.0.0.1", port)) as client:
        begun = time.monotonic()
        try:
            for letter in b"GET / HTTP/1.1\r\nHost: " + b"x" * 200:
                client.sendall(bytes([letter]))
                time.sleep(0.05)
                if time.monotonic() - begun > 10.0 * PATIENCE:
                    break
        except OSError:
            pass
        assert time.monotonic() - begun < 10.0 * PATIENCE


def test_slow_answers_and_later_requests_have_their_time(port: int) -> None:
    """The limit is for the head of a request only, on a connection that is kept as well."""
    assert answer(port, "/slow") == ANSWER
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    for path in ("/", "/slow", "/"):
        connection.request("GET", path)
        assert connection.getresponse().read() == ANSWER
        time.sleep(1.5 * PATIENCE)
    connection.close()
