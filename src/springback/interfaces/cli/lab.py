"""The command ``springback lab``."""

from __future__ import annotations

from pathlib import Path

import click

from springback.interfaces.cli.completion import ScenarioPath, complete_setting


@click.command()
@click.argument("scenario", type=ScenarioPath(), required=False)
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...", shell_complete=complete_setting())
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to serve on.")
@click.option("--port", type=int, default=0, help="Port to serve on; by default any free one.")
@click.option("--no-browser", is_flag=True, help="Open no browser.")
def lab(
    scenario: Path | None, overrides: tuple[str, ...], host: str, port: int, no_browser: bool
) -> None:
    """Open the impact lab: a page with sliders for vehicles, springs, surfaces and speeds.

    Every change flies the collision and redraws it: animation, acceleration, arms, energy,
    outcome. The address contains the settings; the scenario can be downloaded. The lab is served
    to this machine only, unless --host is given, and writes no files.

    With a SCENARIO it opens with your vehicle, walls and start; any value can be overridden.

    \b
    springback lab
    springback lab my.toml
    springback lab my.toml vehicle.arms.length="0.3 m"
    springback lab --port 8080 --no-browser     # remotely: ssh -L 8080:localhost:8080
    """
    from springback.extras import needs

    for module in ("starlette", "uvicorn", "tomli_w"):
        needs(module, "web")
    from springback.interfaces.lab.app import lab_app
    from springback.interfaces.lab.queue import RequestQueue
    from springback.interfaces.lab.settings import LabSettings
    from springback.interfaces.lab.user_scenario import read_user_scenario
    from springback.interfaces.lab.user_settings import user_settings
    from springback.interfaces.web.server import serve
    from springback.scenario.build import user_parts
    from springback.scenario.files import as_input

    table, queue = LabSettings, RequestQueue()
    if scenario is not None:
        user = read_user_scenario(scenario, overrides)
        with as_input(scenario, overrides):
            user_parts(user.scenario)  # its code is there, and trusted
        table = user_settings(user)
        queue = RequestQueue(prepared=(table(),))
    app = lab_app(queue, table)
    queue.start()
    serve(app, host=host, port=port, what="impact lab", browser=not no_browser)
