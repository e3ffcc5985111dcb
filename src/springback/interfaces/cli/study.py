"""The command `springback study`: questions that the paper leaves open, each a study of its own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from springback.interfaces.cli.ablation import why
from springback.interfaces.cli.choices import choices, friction
from springback.interfaces.cli.common import (
    OUT,
    force_option,
    have_figures,
    json_option,
    note,
    print_result,
    progress_bar,
    quiet_option,
)


@click.group()
def study() -> None:
    """Studies of what the paper leaves open."""


for command in (why, choices, friction):
    study.add_command(command)


@study.command()
@click.option("--out", type=OUT, required=True, help="Folder for detection.json, CSV, figures.")
@click.option(
    "--flights", type=click.IntRange(1, 1000), default=4, show_default=True, help="Of each test."
)
@click.option(
    "--free", type=click.FloatRange(50.0, 1e5), default=1000.0, show_default=True,
    help="Seconds of free flight of each robot.",
)  # fmt: skip
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of all noise.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def detection(
    out: Path,
    flights: int,
    free: float,
    seed: int,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """How soon and how surely a collision is noticed, and how well it is made out.

    Delays, misses and false alarms of every trigger, over thresholds and speeds; errors of
    direction, place and arms against the truth.
    """
    from springback.interfaces.output.folders import output_folder
    from springback.studies.detection import detection_study
    from springback.studies.detection_tables import detection_data

    figures = not no_figures and have_figures(quiet)
    with output_folder(out, force=force) as folder:
        note("hundreds of flights; the first run compiles for minutes", quiet)
        with progress_bar("collisions and free flight", quiet) as show:
            results = detection_study(flights, free=free, seed=seed, progress=show)
        data = detection_data(results)
        _written(results, data, folder, figures)
    print_result(data if as_json else "\n".join(data["sentences"]), as_json)
    note(f"written to {out}", quiet)


def _written(results: Any, data: dict[str, Any], folder: Path, figures: bool) -> None:
    from springback.files import write_csv, write_json
    from springback.studies import detection_tables as tables

    write_json(folder / "detection.json", data)
    write_csv(folder / "roc.csv", tables.roc_rows(results))
    write_csv(folder / "delays.csv", tables.delay_rows(results))
    write_csv(folder / "characterisation.csv", tables.characterisation_rows(results))
    if figures:
        from springback.interfaces.figures import detection as plots
        from springback.interfaces.figures.style import save

        save(plots.roc_figure(results), folder / "roc", numbers=False)
        save(plots.delay_figure(results), folder / "delay")
        save(plots.direction_figure(results), folder / "direction")
