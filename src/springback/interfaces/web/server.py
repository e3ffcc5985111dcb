"""Server of pages to a browser, on this machine only unless requested otherwise."""

from __future__ import annotations

import contextlib
import ipaddress
import os
import socket
import sys
import threading
import webbrowser
from collections.abc import Awaitable, Callable, Iterable, MutableMapping
from typing import Any

import click

from springback.errors import InputError
from springback.extras import needs

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

LOOPBACK = "127.0.0.1"
#: Default headers of a response: it loads nothing, and is neither framed nor cached.
HEADERS = {
    "content-security-policy": (
        "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-store",
}
#: Time that open connections have to end by themselves [s].
PATIENCE = 1


def is_loopback(host: str) -> bool:
    """True for a name or address of the loopback interface."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


def _host_of(header: str) -> str:
    """Host header without its port, as of ``[::1]:80``."""
    if header.startswith("["):
        return header.partition("]")[0].lstrip("[").lower()
    return header.partition(":")[0].lower()


def is_welcome(header: str, host: str) -> bool:
    """True if a Host header names this server.

    A foreign page can let its own name resolve to this address and read our answers (DNS
    rebinding); its requests then carry that name.  So only known names are accepted, and addresses.

    Args:
        header: Host header of a request.
        host: Address that the server binds to.
    """
    asked = _host_of(header)
    if is_loopback(asked) or asked == host.lower():
        return True
    if is_loopback(host):
        return False
    with contextlib.suppress(ValueError):
        return bool(ipaddress.ip_address(asked))
    return asked in (socket.gethostname().lower(), socket.getfqdn().lower())


def guard_requests(app: App, host: str = LOOPBACK) -> App:
    """Application that answers only requests addressed to it, with `HEADERS` on every answer.

    Args:
        app: Any ASGI application.
        host: Address it is bound to.
    """

    async def careful(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await app(scope, receive, send)
            return
        named = {name.decode("latin-1"): value for name, value in scope["headers"]}

        async def sending(message: MutableMapping[str, Any]) -> None:
            if message["type"] == "http.response.start":
                given = list(message.get("headers", []))
                present = {name.lower() for name, _ in given}
                given += _raw((k, v) for k, v in HEADERS.items() if k.encode() not in present)
                message = {**message, "headers": given}
            await send(message)

        if not is_welcome(named.get("host", b"").decode("latin-1"), host):
            await _refuse(sending)
            return
        await app(scope, receive, sending)

    return careful


def _raw(headers: Iterable[tuple[str, str]]) -> list[tuple[bytes, bytes]]:
    return [(name.encode("latin-1"), value.encode("latin-1")) for name, value in headers]


async def _refuse(send: Send) -> None:
    text = b"This server does not answer to that name; open it as it says in the terminal.\n"
    headers = _raw({"content-type": "text/plain; charset=utf-8",
                    "content-length": str(len(text))}.items())  # fmt: skip
    await send({"type": "http.response.start", "status": 421, "headers": headers})
    await send({"type": "http.response.body", "body": text})


def bound(host: str, port: int) -> socket.socket:
    """Listening socket; port 0 takes any free one.

    Raises:
        InputError: If the host is not this machine's, or the port is in use or not permitted.
    """
    if not 0 <= port <= 65535:
        raise InputError(f"--port {port}: must be from 0 to 65535; 0 takes a free one")
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
    except (OSError, UnicodeError):
        raise InputError(f"--host {host}: is not a name or address of this machine") from None
    listening = socket.socket(family, kind, protocol)
    try:
        if sys.platform != "win32":
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind(address)
        listening.listen(128)
    except OSError as error:
        listening.close()
        where = f"--port {port}" if port else f"--host {host}"
        reason = (error.strerror or str(error)).lower()
        raise InputError(
            f"{where}: cannot be served on ({reason}); --port 0 takes a free one"
        ) from None
    return listening


def serve(
    app: App,
    *,
    host: str = LOOPBACK,
    port: int = 0,
    what: str = "page",
    path: str = "/",
    browser: bool = True,
    announce: Callable[[str], None] | None = None,
) -> None:
    """Serve an application until interrupted, which is a clean end.

    Args:
        app: Any ASGI application; guarded by `guard_requests` here.
        host: Address to bind to; a warning is printed unless it is loopback.
        port: Port; 0 takes a free one.
        what: Name of the page in messages.
        path: Path that the browser opens.
        browser: Open a browser if this machine has a display.
        announce: Called with each message; by default they go to stderr.

    Raises:
        InputError: If the address cannot be bound, or the extra ``web`` is not installed.
    """
    needs("uvicorn", "web")
    say = announce or (lambda line: click.echo(line, err=True))
    with bound(host, port) as listening:
        port = listening.getsockname()[1]
        url = url_of(host, port, path)
        if not is_loopback(host):
            say(f"warning: anyone who can reach {host} can open this, without a password")
        say(f"{what}: {url}")
        say(f"from elsewhere: ssh -L {port}:localhost:{port} {socket.gethostname()}, same address")
        say("press Ctrl-C to stop")
        if browser and _has_display():
            threading.Timer(0.3, _open, (url,)).start()
        with contextlib.suppress(KeyboardInterrupt):
            server_of(app, host).run(sockets=[listening])


def server_of(app: App, host: str = LOOPBACK, patience: float | None = None) -> Any:
    """Server of an application, guarded by `guard_requests`.

    Args:
        app: Any ASGI application.
        host: Address it is bound to.
        patience: Time limit for the head of a request [s]; `HEAD_PATIENCE` by default.
    """
    uvicorn = needs("uvicorn", "web")
    from springback.interfaces.web.protocol import HEAD_PATIENCE, PatientProtocol

    patient = type("Patient", (PatientProtocol,), {"patience": patience or HEAD_PATIENCE})
    settings = uvicorn.Config(
        guard_requests(app, host), log_level="error", access_log=False, server_header=False,
        timeout_graceful_shutdown=PATIENCE, lifespan="auto", ws="none", http=patient,
    )  # fmt: skip
    return uvicorn.Server(settings)


def url_of(host: str, port: int, path: str = "/") -> str:
    """Address at which a browser on this machine finds a host and port."""
    name = LOOPBACK if host in ("", "0.0.0.0") else "::1" if host == "::" else host.strip("[]")
    return f"http://{f'[{name}]' if ':' in name else name}:{port}{path}"


def _has_display() -> bool:
    """True if a browser would open a window; otherwise one in the terminal might start."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _open(url: str) -> None:
    with contextlib.suppress(webbrowser.Error):
        webbrowser.open(url)
