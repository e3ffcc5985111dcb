"""The impact lab as a web application: its page, its routes and its refusals.

It writes no files.  It accepts only GET requests without a body and checks all parameters of the
query; problems are reported in one line each, as on the command line.
"""

from __future__ import annotations

import functools
from typing import Any
from urllib.parse import parse_qsl

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from springback.errors import InputError
from springback.interfaces.lab.queue import Busy, NotReady, RequestQueue, Superseded
from springback.interfaces.lab.scenarios import file_name, lab_scenario, lab_toml, robots_of
from springback.interfaces.lab.settings import (
    LONGEST_QUERY,
    LabSettings,
    controls,
    settings_from,
)
from springback.interfaces.lab.sweeps import Sweep, sweep_choices, sweep_of
from springback.interfaces.web.page import Page, page_of
from springback.interfaces.web.server import App, Receive, Scope, Send

#: Header in which a page identifies itself, so that its newest request supersedes older ones, and
#: the largest length of its value.
PAGE_HEADER, LONGEST_PAGE = "x-lab-page", 40


def lab_app(queue: RequestQueue, table: type[LabSettings] = LabSettings) -> App:
    """Application to be served by `springback.interfaces.web.server.serve`.

    Args:
        queue: Queue that answers; `RequestQueue.start` may be called before or after.
        table: Table of settings; for a user's scenario, that of
            `springback.interfaces.lab.user_settings.user_settings`.
    """

    async def flight(request: Request) -> Response:
        return await answered(request, _settings(request, table))

    async def sweep(request: Request) -> Response:
        settings = _settings(request, table, beside=("of",))
        return await answered(request, sweep_of(settings, _of(request)), "/sweep")

    async def answered(request: Request, what: LabSettings | Sweep, of: str = "") -> Response:
        asker = request.headers.get(PAGE_HEADER, "")[:LONGEST_PAGE]
        body = await queue.ask(what, asker and asker + of)
        return Response(body, media_type="application/json")

    async def start(request: Request) -> Response:
        return _page(table)

    async def scenario(request: Request) -> Response:
        return _scenario(request, table)

    routes = [
        Route("/", start),
        Route("/flight", flight),
        Route("/sweep", sweep),
        Route("/scenario.toml", scenario),
    ]
    refusals: dict[Any, Any] = {
        InputError: _invalid, NotReady: _not_ready, Superseded: _overtaken, Busy: _busy,
        404: _nothing, 405: _only_get, 500: _failed,
    }  # fmt: skip
    return _modest(Starlette(routes=routes, exception_handlers=refusals))


def _modest(app: App) -> App:
    """Refuse bodies, requests of other sites and overlong queries before reading them."""

    async def checked(scope: Scope, receive: Receive, send: Send) -> None:
        refusal = _refusal(scope) if scope["type"] == "http" else None
        await (refusal or app)(scope, receive, send)

    return checked


def _refusal(scope: Scope) -> Response | None:
    """Refusal of a request by its headers alone; None if it may proceed."""
    heads = {name: value.decode("latin-1") for name, value in scope["headers"]}
    length = heads.get(b"content-length", "0")
    if length != "0" or b"transfer-encoding" in heads:
        return _error(413, "the lab accepts no request body; settings belong in the query")
    origin = heads.get(b"origin")
    if origin is not None and origin.partition("://")[2] != heads.get(b"host"):
        return _error(403, f"pages of {_short(origin)} may not query the lab")
    if heads.get(b"sec-fetch-site") == "cross-site" and heads.get(b"sec-fetch-mode") != "navigate":
        return _error(403, "pages of other sites may not query the lab")
    if len(scope["query_string"]) > LONGEST_QUERY:
        return _error(414, f"the query is longer than {LONGEST_QUERY} characters")
    return None


def _short(text: str) -> str:
    return text if len(text) <= LONGEST_PAGE else text[: LONGEST_PAGE - 1] + "…"


def _error(status: int, *lines: str, **more: Any) -> Response:
    return JSONResponse({"errors": lines, **more}, status)


def _settings(
    request: Request, table: type[LabSettings], *, beside: tuple[str, ...] = ()
) -> LabSettings:
    """Settings of a query; the parameters ``beside`` are not settings."""
    pairs = parse_qsl(request.url.query, keep_blank_values=True, errors="replace")
    return settings_from((pair for pair in pairs if pair[0] not in beside), table)


def _of(request: Request) -> str:
    """The parameter ``of``; empty if it is not given."""
    asked = request.query_params.getlist("of")
    if len(asked) > 1:
        raise InputError(f"of: is given {len(asked)} times; give it once")
    return asked[0] if asked else ""


def _scenario(request: Request, table: type[LabSettings]) -> Response:
    """Scenario file of one robot, as a download."""
    settings = _settings(request, table, beside=("of",))
    robot = _of(request) or robots_of(settings)[0]
    if robot not in robots_of(settings):
        known = " or ".join(robots_of(settings))
        raise InputError(f"of: must be {known} (got {_short(robot)!r})")
    lab_scenario(settings, robot)  # a scenario that cannot be flown is not offered
    name = file_name(settings, robot)
    heads = {"content-disposition": f'attachment; filename="{name}"'}
    return Response(lab_toml(settings, robot), media_type="application/toml", headers=heads)


def _page(table: type[LabSettings]) -> Response:
    """The page; it reads its settings from its own address."""
    ready = page(table)
    heads = {"content-security-policy": f"{ready.policy}; frame-ancestors 'none'"}
    return Response(ready.text, media_type="text/html", headers=heads)


@functools.cache
def page(table: type[LabSettings] = LabSettings) -> Page:
    """Page generated from the table of settings."""
    user = table.user
    data = {
        "controls": controls(table),
        "sweeps": sweep_choices(table),
        "file": None if user is None else user.name,
    }
    title = "springback: impact lab" if user is None else f"{user.name}: impact lab"
    return page_of(title, "lab", data, asks=True)


# -- refusals -------------------------------------------------------------------------------------


async def _invalid(request: Request, error: Exception) -> Response:
    assert isinstance(error, InputError)
    return _error(422, *error.problems)


async def _not_ready(request: Request, error: Exception) -> Response:
    assert isinstance(error, NotReady)
    line = f"compiling for {error.words}: {error.waited:.0f} s so far"
    return JSONResponse(
        {
            "errors": [line],
            "preparing": {
                "what": error.words, "waited": error.waited, "about": error.kind.about,
            },
        },
        503, {"retry-after": "1"},
    )  # fmt: skip


async def _overtaken(request: Request, error: Exception) -> Response:
    return _error(409, "superseded by a newer request of the same page", overtaken=True)


async def _busy(request: Request, error: Exception) -> Response:
    return JSONResponse({"errors": ["too many requests are waiting"]}, 503, {"retry-after": "1"})


async def _nothing(request: Request, error: Exception) -> Response:
    return _error(404, "not found")


async def _only_get(request: Request, error: Exception) -> Response:
    return _error(405, "the lab accepts GET requests only")


async def _failed(request: Request, error: Exception) -> Response:
    return _error(500, "internal error of the lab; see its terminal")
