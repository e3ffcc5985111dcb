"""The command ``springback identify fit``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from springback.interfaces.cli.common import Output, output_options
from springback.interfaces.cli.completion import ScenarioPath

if TYPE_CHECKING:
    from springback.identification.fits import FitResult


@click.command()
@click.argument("plan", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@output_options("Folder for identified.toml, posterior.parquet, fit.json and the report.")
def fit(plan: Path, overrides: tuple[str, ...], output: Output) -> None:
    """Fit fields of a scenario to recorded impacts: PLAN says which, and to what doubt.

    Values with 95 % intervals, what was not learned and why, and what does not fit.  The exit code
    is 1 if nothing was learned.

    \b
    springback identify fit fit.toml --out fitted
    springback identify fit fit.toml starts=16 scatter=none --out fitted
    springback fly scenario.toml --with fitted/identified.toml --out results
    """
    from springback.identification.fits import fit as carry_out
    from springback.identification.results_files import (
        IDENTIFIED,
        POSTERIOR,
        SUMMARY,
        as_data,
        write_files,
    )
    from springback.identification.settings import read_fit_plan

    ready = read_fit_plan(plan, overrides)
    with output.folder((IDENTIFIED, POSTERIOR, SUMMARY)) as folder:
        with output.progress_bar("fitting") as progress:
            result = carry_out(ready, plan.parent, progress=progress)
        written = write_files(result, folder)
    output.print(as_data(result), fit_text(result))
    output.note_written(written)
    if not result.learned:
        sys.exit(1)


def fit_text(result: FitResult) -> str:
    """A fit on the terminal: the answer first."""
    from springback.identification.wording import estimate_sentence

    free = [one for one in result.estimates if one.unknown.role == "free"]
    count = len(result.fits)
    lines = [f"from {count} impact{'s' if count > 1 else ''}, with 95 % intervals:"]
    lines += [f"  {estimate_sentence(one)}" for one in free]
    if result.sentences:
        lines += ["", *result.sentences]
    lines += [f"not used: {reason}" for reason in result.refused]
    seconds = sum(fit.seconds for fit in result.fits)
    flights = sum(fit.problem.flown for fit in result.fits)
    lines += ["", f"{flights} flights in {seconds:.1f} s"]
    return "\n".join(lines)
