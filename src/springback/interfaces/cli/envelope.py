"""The command ``springback map``."""

from __future__ import annotations

import click

from springback.interfaces.cli.common import Output, output_options, robots_option


@click.command(name="map")
@click.argument("x", default="speed=1:5:9", metavar="[X=FROM:TO:COUNT]")
@click.argument("y", required=False, metavar="[Y=FROM:TO:COUNT]")
@robots_option
@click.option("--trials", type=int, default=10, show_default=True, help="Flights in each cell.")
@click.option("--seed", type=int, default=0, show_default=True, help="Seed of all random numbers.")
@click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="KEY=VALUE",
    help="Setting for all trials; may be repeated.",
)
@click.option("--dry-run", is_flag=True, help="Only estimate the number of flights and the time.")
@output_options("Folder for map.html, .json, .csv, .png, .pdf.", required=False)
def map_command(
    x: str,
    y: str | None,
    robots: tuple[str, ...],
    trials: int,
    seed: int,
    settings: tuple[str, ...],
    dry_run: bool,
    output: Output,
) -> None:
    """Map how often robots recover from a collision, over two parameters.

    speed and pitch are those at contact; any other parameter is a number that a campaign can vary:
    the dotted path of a number in the scenario, friction, "wall angle". By default speed runs from
    1 to 5 m/s and pitch from -60 to 60 deg, positive nose down.

    \b
    springback map --out map
    springback map speed=1:5:9 pitch=-60deg:60deg:9 --robot arq --trials 20 --out map
    springback map recovery.response.pace=0.1:0.3:5 vehicle.arms.stiffness="2 N/mm:8 N/mm:4" \\
        --set speed=3.5 --out map
    """
    from importlib.util import find_spec

    from springback.campaign.envelope_plan import envelope_cost, fly_envelope, plan_envelope
    from springback.interfaces.reports.study_files import write_study

    with output.spinner("reading"):
        plan = plan_envelope(x, y, robots=robots, trials=trials, seed=seed, settings=settings)
    cost = envelope_cost(plan)
    if dry_run:
        output.print(cost._asdict(), cost.sentence())
        return
    with output.folder() as folder:
        output.note(cost.sentence())
        with output.progress_bar("flying the map") as show:
            envelope = fly_envelope(plan, show)
        with output.spinner("writing"):
            drawn, page = {}, ""
            if output.wants_figures():
                from springback.interfaces.figures.envelope import map_figure
                from springback.paper.printed import printed_success

                drawn["map"] = map_figure(envelope, printed_success)
                if find_spec("jinja2") is not None:
                    from springback.interfaces.reports.envelope import map_page

                    page = map_page(envelope, drawn["map"])
            data = envelope.as_dict()
            written = write_study(folder, "map", data, {"map": envelope.rows()}, drawn)
            if page:
                written.append(folder / "map.html")
                written[-1].write_text(page, encoding="utf-8")
    tables = [envelope.table(robot) for robot in envelope.robots]
    sentences = "\n".join(envelope.sentence(robot) for robot in envelope.robots)
    output.print(data, "\n\n".join([*tables, sentences]))
    output.note_written(written)
