"""The command ``springback lab``."""

from __future__ import annotations

import click


@click.command()
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to serve on.")
@click.option("--port", type=int, default=0, help="Port to serve on; by default any free one.")
@click.option("--no-browser", is_flag=True, help="Open no browser.")
def lab(host: str, port: int, no_browser: bool) -> None:
    """Open the impact lab: a page with sliders for springs, surfaces and speeds.

    Every change flies the collision and redraws it: animation, acceleration, arms, energy,
    outcome. The address contains the settings; the scenario can be downloaded. It is served to
    this machine only, unless --host is given, and writes no files.

    \b
    springback lab
    springback lab --port 8080 --no-browser     # remotely: ssh -L 8080:localhost:8080
    """
    from springback.extras import needs

    for module in ("starlette", "uvicorn", "tomli_w"):
        needs(module, "web")
    from springback.interfaces.lab.app import lab_app
    from springback.interfaces.lab.queue import RequestQueue
    from springback.interfaces.web.server import serve

    queue = RequestQueue()
    app = lab_app(queue)
    queue.start()
    serve(app, host=host, port=port, what="impact lab", browser=not no_browser)
