"""The commands `springback study`: why, choices, friction, detection, shapes and impacts."""

from __future__ import annotations

from pathlib import Path

import click

from springback.errors import InputError
from springback.interfaces.cli.common import (
    Output,
    output_options,
    robots_option,
    seed_option,
    trials_option,
)

LEAST_DURATION, MOST_DURATION = 4.0, 60.0
"""Limits of the duration of a trial, longer than the longest run-up and an impact [s]."""


@click.group()
def study() -> None:
    """Study questions that the paper leaves open."""


def _durations(text: str) -> tuple[float, ...]:
    """Durations of a trial from a list with commas.

    Raises:
        InputError: If the text is not a list of durations within their limits.
    """
    found = []
    for word in text.split(","):
        try:
            value = float(word)
        except ValueError:
            value = float("nan")
        if not LEAST_DURATION <= value <= MOST_DURATION:
            raise InputError(
                f"--durations: must be numbers from {LEAST_DURATION:g} to {MOST_DURATION:g} s with "
                f"commas between them, such as 9,11,14 (got {word.strip()!r})"
            )
        found.append(value)
    return tuple(dict.fromkeys(found))


@study.command()
@trials_option(10)
@seed_option
@click.option("--no-ranges", is_flag=True, help="Fly only the ablation and its pairs.")
@output_options("Folder for why.json, why.csv, figures.")
def why(trials: int, seed: int, no_ranges: bool, output: Output) -> None:
    """Change one assumption at a time, then two, and count the tests that each robot survives.

    The question is about the paper's two robots, and no others are flown. Assumptions are
    compliance, clipping, estimator, limits, delays, friction, contact point and recovery; pairs are
    changed at 3.5 m/s. Last come parameters that the paper does not print: the ranges of them in
    which the printed result holds.
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.studies.ablation import RANGES, why_sentences
    from springback.studies.ablation import why as explained
    from springback.studies.ablation_pairs import fly_pairs, pair_sentences

    figures = output.wants_figures()
    with output.folder() as folder:
        output.note("some variants need kernels of their own; the first run compiles for minutes")
        with output.progress_bar("what if") as show:
            ranges = () if no_ranges else RANGES
            results = explained(trials, ranges=ranges, seed=seed, progress=show)
        with output.progress_bar("two at a time") as show:
            pairs = fly_pairs(trials, seed=seed, progress=show)
        rows = [cell.as_dict() for cell in (*results.cells, *results.ranges)]
        paired = [pair._asdict() for pair in pairs.pairs]
        said = why_sentences(results, pair_sentences(pairs))
        parts = ["ablation"] * len(results.cells) + ["range"] * len(results.ranges)
        cells = [{**row, "part": part} for row, part in zip(rows, parts, strict=True)]
        drawn = {}
        if figures:
            from springback.interfaces.figures import ablation as plots

            drawn = {"pairs": plots.pairs_figure(pairs), "ablation": plots.ablation_figure(results)}
            drawn |= {"ranges": plots.ranges_figure(results)} if results.ranges else {}
        data = {"cells": cells, "pairs": paired, "sentences": said}
        write_study(folder, "why", data, {"why": cells}, drawn)
    output.print(rows + paired, "\n".join(said))
    output.note_written()


@study.command()
@trials_option(100, "Trials under each condition.")
@click.option(
    "--durations", default="9,11,14", show_default=True, metavar="S,S,...",
    help="Durations of a trial to compare [s].",
)  # fmt: skip
@seed_option
@output_options("Folder for choices.json, CSV, figures.")
def choices(trials: int, durations: str, seed: int, output: Output) -> None:
    """Recompute the resilience table with each set of choices that the paper leaves open.

    The results are compared with the paper's table, so only the paper's two robots are flown. The
    choices are friction along e_Z or along both tangents, springback's estimator or the noise that
    PX4's EKF2 assumes, and the duration of a trial: which set gives most of the printed table?
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.paper.choices import choices_data, choices_sentences, fly_choices
    from springback.studies.clipping import clipping_losses

    times, figures = _durations(durations), output.wants_figures()
    with output.folder() as folder:
        output.note("thousands of flights: minutes, or longer if kernels must be compiled")
        with output.progress_bar("sets of choices") as show:
            results = fly_choices(trials, durations=times, seed=seed, progress=show)
        with output.progress_bar("velocity lost to clipping") as show:
            hidden = clipping_losses(progress=show)
        data = choices_data(results) | {"hidden": [one.as_dict() for one in hidden]}
        said = choices_sentences(results)
        drawn = {}
        if figures:
            from springback.interfaces.figures.friction import clipping_figure
            from springback.interfaces.reproduction.figures.choices import choices_figure

            drawn = {"choices": choices_figure(results), "hidden": clipping_figure(hidden)}
        tables = {name: data[name] for name in ("agreement", "hidden")}
        tables["choices"] = data["cells"]
        write_study(folder, "choices", data | {"sentences": said}, tables, drawn)
    output.print(data, "\n".join(said))
    output.note_written()


@study.command()
@robots_option
@trials_option(40, "Trials of each straight test in flight.")
@click.option(
    "--speed", type=click.FloatRange(0.2, 10.0), default=2.0, show_default=True,
    help="Speed of the impacts over yaw and coefficient [m/s].",
)  # fmt: skip
@seed_option
@output_options("Folder for friction.json, CSV, figure.")
def friction(robots: tuple[str, ...], trials: int, speed: float, seed: int, output: Output) -> None:
    """Study the effect of friction on the springs, over its axes, its coefficient and the yaw.

    Friction along both tangents holds the two front cages, and arms at 45 degrees are compressed
    only if their cages slide.

    \b
    springback study friction --out friction
    springback study friction --robot arq --robot my_vehicle.toml --out friction
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.studies.friction import friction_sentences, friction_study

    figures = output.wants_figures()
    with output.folder() as folder:
        with output.progress_bar("impacts and trials") as show:
            results = friction_study(trials, robots=robots, speed=speed, seed=seed, progress=show)
        impacts, flown = ([x.as_dict() for x in some] for some in (results.impacts, results.flown))
        said = friction_sentences(results)
        data = {"impacts": impacts, "flown": flown, "sentences": said}
        drawn = {}
        if figures:
            from springback.interfaces.figures.friction import friction_figure

            drawn = {"stroke": friction_figure(results)}
        write_study(folder, "friction", data, {"friction": impacts, "flown": flown}, drawn)
    output.print(data, "\n".join(said))
    output.note_written()


@study.command()
@robots_option
@click.option(
    "--flights",
    type=click.IntRange(1, 1000),
    default=4,
    show_default=True,
    help="Flights of each test.",
)
@click.option(
    "--free", type=click.FloatRange(50.0, 1e5), default=1000.0, show_default=True,
    help="Seconds of free flight of each robot.",
)  # fmt: skip
@seed_option
@output_options("Folder for detection.json, CSV, figures.")
def detection(
    robots: tuple[str, ...], flights: int, free: float, seed: int, output: Output
) -> None:
    """Study the speed and reliability of collision detection, and errors of characterisation.

    Delays, misses and false alarms of every trigger, over thresholds and speeds; errors of
    direction, position and arms relative to the truth.

    \b
    springback study detection --out detection
    springback study detection --robot my_vehicle.toml --flights 1 --out detection
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.studies.detection import detection_study
    from springback.studies.detection_tables import detection_data, detection_rows

    figures = output.wants_figures()
    with output.folder() as folder:
        output.note("hundreds of flights; the first run compiles for minutes")
        with output.progress_bar("collisions and free flight") as show:
            results = detection_study(flights, robots=robots, free=free, seed=seed, progress=show)
        data, drawn = detection_data(results), {}
        if figures:
            from springback.interfaces.figures import detection as plots

            drawn = {
                "roc": plots.roc_figure(results), "delay": plots.delay_figure(results),
                "direction": plots.direction_figure(results),
            }  # fmt: skip
        write_study(folder, "detection", data, detection_rows(results), drawn)
    output.print(data, "\n".join(data["sentences"]))
    output.note_written()


@study.command()
@robots_option
@click.option(
    "--flights", type=click.IntRange(1, 1000), default=10, show_default=True,
    help="Flights with each robot, shape, speed and setting.",
)  # fmt: skip
@seed_option
@output_options("Folder for shapes.json, CSV.")
def shapes(robots: tuple[str, ...], flights: int, seed: int, output: Output) -> None:
    """Study how robots judge poles, edges, balls and leaning walls that they hit.

    Errors of the normal and of the contact point that a robot estimates, relative to the truth, at
    1, 2 and 3.5 m/s: with obstacles taken for upright faces, which is the default, and without.

    \b
    springback study shapes --out shapes
    springback study shapes --robot my_vehicle.toml --flights 2 --out shapes
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.studies.collisions.shape_collisions import (
        shape_collisions,
        shape_errors,
        shape_sentences,
    )

    with output.folder() as folder:
        output.note("hundreds of flights; the first run compiles for minutes")
        with output.progress_bar("collisions with shapes") as show:
            hits = shape_collisions(flights, robots=robots, seed=seed, progress=show)
        errors = shape_errors(hits)
        rows, said = [row.as_dict() for row in errors], shape_sentences(errors)
        write_study(folder, "shapes", {"errors": rows, "sentences": said}, {"shapes": rows}, {})
    output.print(rows, "\n".join(said))
    output.note_written()


@study.command()
@click.argument("folder", type=click.Path(path_type=Path))
@click.option("--frozen", is_flag=True, help="Use the published numbers instead of fitting.")
@output_options("Folder for impacts.json, CSV, figure.")
def impacts(folder: Path, frozen: bool, output: Output) -> None:
    """Predict recorded impacts of an ellipse on a floor, beside six models stored with them.

    FOLDER is your copy of github.com/mcubelab/planar-impact-dataset, which has no licence: nothing
    of it comes with springback, and nothing is fetched. Restitution and friction of the impulse law
    are fitted on the first fifth of the impacts, the others are predicted.

    \b
    git clone https://github.com/mcubelab/planar-impact-dataset
    springback study impacts planar-impact-dataset --out impacts
    """
    from springback.interfaces.reports.study_files import write_study
    from springback.studies.recordings.impulse_predictions import (
        FROZEN,
        impact_sentences,
        predict_impacts,
    )
    from springback.studies.recordings.planar_impacts import read_planar_impacts

    recorded, figures = read_planar_impacts(folder), output.wants_figures()
    with output.folder() as written:
        with output.spinner("impacts"):
            found = predict_impacts(recorded, FROZEN if frozen else None)
        said = impact_sentences(found)
        rows = [
            {"impacts": name, **row.as_dict()}
            for name, part in (("not fitted on", found.rest), ("last 30 %", found.blind))
            for row in part
        ]
        law = found.law._asdict()
        data = {"law": law, "unexplained spin": found.unexplained, "errors": rows}
        drawn = {}
        if figures:
            from springback.interfaces.figures.recordings import impacts_figure

            drawn = {"predicted": impacts_figure(found)}
        write_study(written, "impacts", data | {"sentences": said}, {"impacts": rows}, drawn)
    output.print(data, "\n".join(said))
    output.note_written()
