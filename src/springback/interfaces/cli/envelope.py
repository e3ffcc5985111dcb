"""The command ``springback map``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from springback.interfaces.cli.common import (
    OUT,
    force_option,
    have_figures,
    json_option,
    note,
    print_result,
    progress_bar,
    quiet_option,
    spinner,
)


@click.command(name="map")
@click.argument("x", default="speed=1:5:9", metavar="[X=FROM:TO:COUNT]")
@click.argument("y", required=False, metavar="[Y=FROM:TO:COUNT]")
@click.option(
    "--robot", "robots", multiple=True, default=("arq", "quad"), show_default=True,
    help="Vehicle preset; may be given several times.",
)  # fmt: skip
@click.option("--trials", type=int, default=10, show_default=True, help="Flights of each cell.")
@click.option("--seed", type=int, default=0, show_default=True, help="Of all luck.")
@click.option(
    "--set", "settings", multiple=True, metavar="KEY=VALUE", help="The same in all trials."
)
@click.option("--out", type=OUT, help="Folder for map.html, .json, .csv, .png, .pdf.")
@click.option("--dry-run", is_flag=True, help="Only say what would be flown.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def map_command(
    x: str,
    y: str | None,
    robots: tuple[str, ...],
    trials: int,
    seed: int,
    settings: tuple[str, ...],
    out: Path | None,
    dry_run: bool,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Map how often robots recover from a collision, over two parameters.

    speed and pitch are those at contact; any other parameter is a number that a campaign can vary:
    the dotted path of a number in the scenario, friction, "wall angle". By default speed from 1 to
    5 m/s over pitch from -60 to 60 deg, positive nose down.

    \b
    springback map --out map
    springback map speed=1:5:9 pitch=-60deg:60deg:9 --robot arq --trials 20 --out map
    springback map recovery.response.pace=0.1:0.3:5 vehicle.arms.stiffness="2 N/mm:8 N/mm:4" \\
        --set speed=3.5 --out map
    """
    from springback.campaign.envelope import envelope_cost, fly_envelope, plan_envelope
    from springback.errors import InputError
    from springback.interfaces.output.folders import output_folder

    with spinner("reading", quiet):
        plan = plan_envelope(x, y, robots=robots, trials=trials, seed=seed, settings=settings)
    if dry_run:
        coming = envelope_cost(plan)
        print_result(coming._asdict() if as_json else coming.sentence(), as_json)
        return
    if out is None:
        raise InputError("--out is missing: the folder to write to (or --dry-run)")
    with output_folder(out, force=force) as folder:
        note(envelope_cost(plan).sentence(), quiet)
        with progress_bar("flying the map", quiet) as show:
            envelope = fly_envelope(plan, show)
        with spinner("writing", quiet):
            written = _write(envelope, folder, not no_figures and have_figures(quiet))
        names = [path.name for path in written]
    text = "\n\n".join(envelope.table(robot) for robot in envelope.robots)
    sentences = "\n".join(envelope.sentence(robot) for robot in envelope.robots)
    print_result(envelope.as_dict() if as_json else f"{text}\n\n{sentences}", as_json)
    note(f"written to {out}: {', '.join(names)}", quiet)


def _write(envelope: Any, folder: Path, figures: bool) -> list[Path]:
    """Write ``map.json``, ``map.csv`` and, if wanted, the figure and the page ``map.html``."""
    import csv
    from importlib.util import find_spec

    from springback.files import write_json

    written = [folder / "map.json", folder / "map.csv"]
    write_json(written[0], envelope.as_dict())
    rows = envelope.rows()
    with written[1].open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    if figures:
        from springback.interfaces.figures import style
        from springback.interfaces.figures.envelope import map_figure
        from springback.paper.printed import printed_success

        written += style.save(map_figure(envelope, printed_success), folder / "map", numbers=False)
        if find_spec("jinja2") is not None:
            from springback.interfaces.reports.envelope import map_page

            written.append(folder / "map.html")
            written[-1].write_text(map_page(envelope, printed_success), encoding="utf-8")
    return written
