"""The commands `springback study friction` and `springback study choices`."""

from __future__ import annotations

from pathlib import Path

import click

from springback.errors import InputError
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

LEAST_DURATION, MOST_DURATION = 4.0, 60.0
"""[s] of a trial: less than the longest run-up and an impact makes no sense."""


def _durations(text: str) -> tuple[float, ...]:
    """Durations of a trial, written with commas.

    Raises:
        InputError: If the text is no list of durations within their range.
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


@click.command()
@click.option("--out", type=OUT, required=True, help="Folder for choices.json, CSV, figures.")
@click.option(
    "--trials", type=click.IntRange(1, 1000), default=100, show_default=True,
    help="Of each condition.",
)  # fmt: skip
@click.option(
    "--durations", default="9,11,14", show_default=True, metavar="S,S,...",
    help="How long a trial lasts [s].",
)  # fmt: skip
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of all luck.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def choices(
    out: Path,
    trials: int,
    durations: str,
    seed: int,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """The resilience table under each set of choices that the paper leaves open.

    Friction along e_Z or along both tangents, springback's estimator or the noise that PX4's EKF2
    assumes, and the time of a trial: which set gives most of the printed table?
    """
    from springback.files import write_csv, write_json
    from springback.interfaces.output.folders import output_folder
    from springback.paper.choices import choices_data, choices_sentences, fly_choices
    from springback.studies.clipping import clipping_losses

    times = _durations(durations)
    figures = not no_figures and have_figures(quiet)
    with output_folder(out, force=force) as folder:
        note("thousands of flights; minutes, and some more where kernels are to be compiled", quiet)
        with progress_bar("sets of choices", quiet) as show:
            results = fly_choices(trials, durations=times, seed=seed, progress=show)
        with progress_bar("velocity hidden by clipping", quiet) as show:
            hidden = clipping_losses(progress=show)
        data = choices_data(results) | {"hidden": [one.as_dict() for one in hidden]}
        said = choices_sentences(results)
        write_json(folder / "choices.json", data | {"sentences": said})
        write_csv(folder / "choices.csv", data["cells"])
        write_csv(folder / "agreement.csv", data["agreement"])
        write_csv(folder / "hidden.csv", data["hidden"])
        if figures:
            from springback.interfaces.figures.friction import clipping_figure
            from springback.interfaces.figures.style import save
            from springback.interfaces.reproduction.figures.choices import choices_figure

            save(choices_figure(results), folder / "choices", numbers=False)
            save(clipping_figure(hidden), folder / "hidden", numbers=False)
    print_result(data if as_json else "\n".join(said), as_json)
    note(f"written to {out}", quiet)


@click.command()
@click.option("--out", type=OUT, required=True, help="Folder for friction.json, CSV, figure.")
@click.option(
    "--trials", type=click.IntRange(1, 1000), default=40, show_default=True,
    help="Of each straight test in flight.",
)  # fmt: skip
@click.option(
    "--speed", type=click.FloatRange(0.2, 10.0), default=2.0, show_default=True,
    help="Of the impacts over yaw and coefficient [m/s].",
)  # fmt: skip
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of all luck.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def friction(
    out: Path,
    trials: int,
    speed: float,
    seed: int,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Which friction: what it leaves of the springs, over its axes, coefficient and the yaw.

    Friction along both tangents holds the two front cages, and arms at 45 degrees give way only
    where their cages slide.
    """
    from springback.files import write_csv, write_json
    from springback.interfaces.output.folders import output_folder
    from springback.studies.friction import friction_sentences, friction_study

    figures = not no_figures and have_figures(quiet)
    with output_folder(out, force=force) as folder:
        with progress_bar("impacts and trials", quiet) as show:
            results = friction_study(trials, speed=speed, seed=seed, progress=show)
        impacts = [one.as_dict() for one in results.impacts]
        flown = [one.as_dict() for one in results.flown]
        said = friction_sentences(results)
        data = {"impacts": impacts, "flown": flown, "sentences": said}
        write_json(folder / "friction.json", data)
        write_csv(folder / "friction.csv", impacts)
        write_csv(folder / "flown.csv", flown)
        if figures:
            from springback.interfaces.figures.friction import friction_figure
            from springback.interfaces.figures.style import save

            save(friction_figure(results), folder / "stroke")
    print_result(data if as_json else "\n".join(said), as_json)
    note(f"written to {out}", quiet)
