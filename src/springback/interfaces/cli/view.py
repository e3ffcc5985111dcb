"""The command ``springback view``."""

from __future__ import annotations

from pathlib import Path

import click

from springback.interfaces.cli.common import FIRST, PATH, Terminal, terminal_options


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
    help="Address to serve on; others than the default are public.",
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

    RESULT is a folder that springback fly wrote, or a SCENARIO.toml, which is flown.

    \b
    springback view results
    springback view arq quad softer
    springback view examples/collision.toml --twin --export collision.html
    """
    from springback.extras import needs
    from springback.interfaces.replay.viewer import export_page, flights_of, replay_app, replay_of

    if export is None:
        needs("uvicorn", "web")
        needs("starlette", "web")
    with terminal.spinner(f"reading and {FIRST}"):
        page = replay_of(flights_of(results, twin=twin), results)
    if export is not None:
        export_page(page, export, force=force)
        size = len(page.text) / 1e6
        terminal.note(f"written: {export} ({size:.1f} MB); open it in any browser")
        return
    from springback.interfaces.web.server import serve

    serve(replay_app(page), host=host, port=port, what="replay", browser=not no_browser)
