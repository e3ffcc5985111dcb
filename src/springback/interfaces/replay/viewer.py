"""Replay of one flight or several, as a served page or a file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from springback.errors import InputError
from springback.extras import needs
from springback.files import write_atomically
from springback.interfaces.output.python_wording import python_words
from springback.interfaces.replay.labels import scenes_of, vehicles_of
from springback.interfaces.replay.scene import plain
from springback.interfaces.replay.signals import plain_signals
from springback.interfaces.web.page import Page, page_of
from springback.interfaces.web.server import App, serve
from springback.results.flight import Flight, fly
from springback.results.hooks import NotebookPage, in_notebook
from springback.results.saved import load
from springback.scenario.files import read_scenario

#: Most flights on one page (chosen: as many as there are colours that can be distinguished).
MOST = 8
TWINS = {"arq": "quad", "quad": "arq", "arq-slider": "quad-slider", "quad-slider": "arq-slider"}


def flights_of(paths: Sequence[Path], *, twin: bool = False) -> list[Flight]:
    """Flights read from result folders, or flown from scenario files.

    Args:
        paths: Folders that `springback fly` wrote, or TOML files.
        twin: Also fly the rigid twin of a compliant vehicle, or the compliant twin of a rigid one.

    Raises:
        InputError: If a path is neither, there are too many, or a twin is requested for a folder
            or several flights.
    """
    if not 1 <= len(paths) <= MOST:
        raise InputError(f"RESULT: give one to {MOST} (got {len(paths)})")
    if twin and (len(paths) != 1 or paths[0].is_dir()):
        raise InputError("--twin: needs a single SCENARIO.toml; for results give both folders")
    flights = []
    for path in paths:
        if path.suffix.lower() == ".toml" and not path.is_dir():
            flights.append(fly(read_scenario(path)))
        else:
            flights.append(load(path))
    if twin:
        flights.append(fly(read_scenario(paths[0], twin_words(flights[0]))))
    return flights


def twin_words(flight: Flight) -> list[str]:
    """Overrides that turn a vehicle into its twin: the preset's, else arms locked or released.

    Args:
        flight: A flight of the vehicle.
    """
    vehicle = flight.scenario.vehicle
    if vehicle.name in TWINS:
        return [f"vehicle={TWINS[vehicle.name]}"]
    free = "false" if vehicle.is_compliant else "true"
    return [f"vehicle.arms.compliant={free}", f"vehicle.name={vehicle.name} twin"[:60]]


def replay_of(flights: Sequence[Flight], origins: Sequence[str | Path] = ()) -> Page:
    """Replay page of flights.

    Args:
        flights: One or several, each with its trajectory.
        origins: Folder or file that each was read from, if any.
    """
    if (count := sum(map(vehicles_of, flights))) > MOST:
        raise InputError(f"a replay shows at most {MOST} vehicles (got {count})")
    scenes = scenes_of(flights, origins)
    named = list(dict.fromkeys(f"{scene.label}, {scene.scenario}" for scene in scenes))
    names = " and ".join(named) if len(named) < 3 else f"{len(scenes)} flights"
    each = [one for flight in flights for one in (flight, flight.second) if one is not None]
    drawn = [plain(scene) | {"signals": plain_signals(flight, scene)}
             for scene, flight in zip(scenes, each, strict=True)]  # fmt: skip
    return page_of(f"{names} – springback", "replay", {"flights": drawn})


def export_page(page: Page, path: Path, *, force: bool = False) -> None:
    """Write a page to a file, completely or not at all.

    Raises:
        InputError: If the file exists without ``force``, or cannot be written.
    """
    if path.is_dir():
        raise InputError(f"--export {path}: is a folder; give a file such as flight.html")
    if path.exists() and not force:
        raise InputError(f"--export {path}: already exists; --force replaces it")
    try:
        write_atomically(path, page.text)
    except OSError as error:
        raise InputError(f"--export {path}: cannot be written ({error.strerror})") from None


def view_flights(
    *flights: Flight,
    export: str | Path | None = None,
    force: bool = False,
    browser: bool = True,
) -> NotebookPage:
    """Replay flights from Python: `springback.Flight.view`."""
    with python_words():
        if len(flights) > MOST:
            raise InputError(f"a replay shows at most {MOST} flights (got {len(flights)})")
        page = replay_of(flights)
        if export is not None:
            export_page(page, Path(export), force=force)
        elif not in_notebook():
            needs("uvicorn", "web")
            needs("starlette", "web")
            serve(replay_app(page), what="replay", browser=browser)
    return NotebookPage(page.text)


def replay_app(page: Page) -> App:
    """Application that serves a page and nothing else."""
    from starlette.applications import Starlette
    from starlette.requests import Request
    from starlette.responses import HTMLResponse, Response
    from starlette.routing import Route

    policy = f"{page.policy}; frame-ancestors 'none'"

    async def show(request: Request) -> Response:
        return HTMLResponse(page.text, headers={"content-security-policy": policy})

    return Starlette(routes=[Route("/", show)])
