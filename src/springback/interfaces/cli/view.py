"""The command ``springback view``."""

from __future__ import annotations

from pathlib import Path

import click

from springback.interfaces.cli.common import note, quiet_option, spinner


@click.command()
@click.argument(
    "results", nargs=-1, required=True, metavar="RESULT [RESULT2]", type=click.Path(path_type=Path)
)
@click.option("--twin", is_flag=True, help="Fly a SCENARIO's rigid or compliant twin beside it.")
@click.option(
    "--export", "export", metavar="FILE.html", type=click.Path(path_type=Path),
    help="Write one page that needs no network, and serve nothing.",
)  # fmt: skip
@click.option("--port", type=int, default=0, show_default=True, help="0 takes a free one.")
@click.option(
    "--host", default="127.0.0.1", show_default=True,
    help="Address to serve on; anything else than this machine's own is open to others.",
)  # fmt: skip
@click.option("--no-browser", is_flag=True, help="Open no browser.")
@click.option("--force", is_flag=True, help="Replace the exported page.")
@quiet_option
def view(
    results: tuple[Path, ...],
    twin: bool,
    export: Path | None,
    port: int,
    host: str,
    no_browser: bool,
    force: bool,
    quiet: bool,
) -> None:
    """Replay a flight in the browser, or two beside one another.

    RESULT is a folder that springback fly wrote, or a SCENARIO.toml, which is flown.

    \b
    springback view results
    springback view arq quad
    springback view examples/collision.toml --twin --export collision.html
    """
    from springback.extras import needs
    from springback.interfaces.replay.viewer import export_page, flights_of, replay_app, replay_of

    if export is None:
        needs("uvicorn", "web")
        needs("starlette", "web")
    with spinner(
        "reading; the first flight of a kind is compiled: some 15 s, with a pilot a minute or two",
        quiet,
    ):
        page = replay_of(flights_of(results, twin=twin), results)
    if export is not None:
        export_page(page, export, force=force)
        note(f"written: {export} ({len(page.text) / 1e6:.1f} MB); open it in any browser", quiet)
        return
    from springback.interfaces.web.server import serve

    serve(replay_app(page), host=host, port=port, what="replay", browser=not no_browser)
