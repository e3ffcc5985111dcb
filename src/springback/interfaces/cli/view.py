"""The command ``springback view``."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import FIRST, PATH, Terminal, say, terminal_options

READING = "reading the flight, computing its contact forces again, and drawing it"
"""Label of the spinner where all results are folders of flights: nothing is flown."""
#: Most digits of a word that is read as the number of a row.
MOST_DIGITS = 18


@click.command()
@click.argument("results", nargs=-1, required=True, metavar="RESULT...", type=PATH)
@click.option("--twin", is_flag=True, help="Also fly the rigid or compliant twin of a SCENARIO.")
@click.option(
    "--export", metavar="FILE.html", type=PATH,
    help="Write a self-contained page instead of serving one.",
)  # fmt: skip
@click.option(
    "--port", type=int, default=0, show_default=True, help="Port to serve on; 0 takes a free one."
)
@click.option(
    "--host", default="127.0.0.1", show_default=True,
    help="Address to serve on; any but the default makes the page public.",
)  # fmt: skip
@click.option("--no-browser", is_flag=True, help="Open no browser.")
@click.option("--force", is_flag=True, help="Replace the exported page.")
@terminal_options("quiet")
def view(
    results: tuple[Path, ...],
    twin: bool,
    export: Path | None,
    port: int,
    host: str,
    no_browser: bool,
    force: bool,
    terminal: Terminal,
) -> None:
    """Replay one flight, or up to eight at a time, in the browser.

    RESULT is a folder that springback fly wrote, a SCENARIO.toml, which is flown, or the folder of
    a campaign and the number of a row, which is flown again.

    \b
    springback view results
    springback view campaign 1711
    springback view arq quad softer
    springback view examples/collision.toml --twin --export collision.html
    """
    from springback.extras import needs
    from springback.interfaces.replay.viewer import export_page, replay_app, replay_of

    if export is None:
        needs("uvicorn", "web")
        needs("starlette", "web")
    with terminal.spinner(spinner_label(results)):
        page = replay_of(*_flights(results, twin, terminal))
    if export is not None:
        export_page(page, export, force=force)
        size = len(page.text) / 1e6
        terminal.note(f"written: {export} ({size:.1f} MB); open it in any browser")
        return
    from springback.interfaces.web.server import serve

    serve(replay_app(page), host=host, port=port, what="replay", browser=not no_browser)


def spinner_label(results: Sequence[Path]) -> str:
    """Label of the spinner, by what is to be flown: scenario files, and rows of campaigns."""
    stored = all(one.is_dir() and one.suffix.lower() != ".toml" for one in results)
    return READING if stored else f"reading and {FIRST}"


def _flights(
    results: Sequence[Path], twin: bool, terminal: Terminal
) -> tuple[list[Any], list[str | Path]]:
    """Flights of results, and of rows of campaigns; and where each is from."""
    from springback.campaign.access import Campaign
    from springback.interfaces.replay.viewer import MOST, flights_of

    asked = _rows(results)
    if not any(rows for _, rows in asked):
        return flights_of(results, twin=twin), list(results)
    if twin:
        raise InputError("--twin: needs a single SCENARIO.toml; a campaign flies both robots")
    count = sum(len(rows) or 1 for _, rows in asked)
    if count > MOST:
        raise InputError(f"RESULT: give one to {MOST} (got {count})")
    flights: list[Any] = []
    origins: list[str | Path] = []
    for path, rows in asked:
        if not rows:
            flights += flights_of([path])
            origins.append(path)
        for row in rows:
            flights.append(_flown_again(Campaign(path), row, terminal))
            origins.append(f"row {row} of {path.absolute().name}")
    return flights, origins


def _flown_again(known: Any, row: int, terminal: Terminal) -> Any:
    """A flight of a campaign, flown again."""
    again = known.refly(row)
    if not again.differences:
        terminal.note(f"identical to row {row}: every number, to the last bit")
    for line in again.differences:
        say(f"differs from row {row}: {line}")
    return again.flight


def _rows(results: Sequence[Path]) -> list[tuple[Path, list[int]]]:
    """Results, each with the rows that follow it if it is the folder of a campaign.

    Raises:
        InputError: If no row follows a campaign.
    """
    from springback.campaign.access import KEPT, is_campaign

    found: list[tuple[Path, list[int]]] = []
    for path in results:
        number = str(path).isdecimal() and len(str(path)) <= MOST_DIGITS
        if number and found and is_campaign(found[-1][0]):
            found[-1][1].append(int(str(path)))
        else:
            found.append((path, []))
    for path, rows in found:
        near = (path, *(one.parent for one in (path, path.parent) if one.name == KEPT))
        whole = next((one for one in near if is_campaign(one)), None)
        if whole is not None and not rows:
            raise InputError(f"{path}: {_which_row(whole, path)}")
    return found


def _which_row(folder: Path, path: Path) -> str:
    """Advice on how to name a row of a campaign."""
    from springback.campaign.access import Campaign
    from springback.campaign.analysis.failures import failures

    known = Campaign(folder)
    shown = shlex.quote(str(folder))
    stored = known.stored_flights()
    if path != folder and stored:
        some = ", ".join(map(str, stored[:5])) + (" ..." if len(stored) > 5 else "")
        return f"holds the kept flights {some}; replay one: springback view {shown} {stored[0]}"
    found = failures(known, 1)
    listed = found.rows or found.kept
    first = listed[0]["flight"] if listed else 0
    last = known.metadata["flights"] - 1
    return (
        f"holds a campaign of flights 0 to {last}; name one: springback view {shown} {first} "
        f"({found.failed} flew without success; springback summary {shown} lists some)"
    )
