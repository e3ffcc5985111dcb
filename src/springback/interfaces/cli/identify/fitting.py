"""The commands ``springback identify fit``, ``check`` and ``plan``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from springback.errors import InputError
from springback.interfaces.cli.common import Output, output_options
from springback.interfaces.cli.completion import ScenarioPath

if TYPE_CHECKING:
    from springback.identification.design.coverage import Coverage
    from springback.identification.design.experiments import ExperimentPlan
    from springback.identification.fits import FitResult
    from springback.identification.law_comparison import LawComparison
    from springback.identification.report.assumptions import Assumption
    from springback.identification.solving.fitting import ImpactFit

#: Files of a check, and of a plan of tests.
CHECK_FILES, PLAN_FILES = ("check.json", "check.csv"), ("plan.json", "plan.csv")
#: Cover of a 95 % interval below which it is too narrow.
LEAST = 0.9


@click.command()
@click.argument("plan", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@output_options("Folder for identified.toml, posterior.parquet, fit.json and the report.")
def fit(plan: Path, overrides: tuple[str, ...], output: Output) -> None:
    """Fit fields of a scenario to recorded impacts; PLAN names them and their uncertainty.

    It gives values with 95 % intervals, what was not learned and why, and what does not fit.  The
    exit code is 1 if nothing was learned.

    \b
    springback identify fit fit.toml --out fitted
    springback identify fit fit.toml starts=16 scatter=none --out fitted
    springback fly scenario.toml --with fitted/identified.toml --out results
    """
    from springback.identification.fits import fit as carry_out
    from springback.identification.law_comparison import compare_laws
    from springback.identification.report.assumptions import assumptions
    from springback.identification.results_files import (
        IDENTIFIED,
        POSTERIOR,
        REPORT,
        SUMMARY,
        as_data,
        write_files,
    )
    from springback.identification.settings import naming_places, read_fit_plan

    ready = read_fit_plan(plan, overrides)
    with naming_places(plan), output.folder((IDENTIFIED, POSTERIOR, SUMMARY, REPORT)) as folder:
        with output.progress_in_words("fitting") as (progress, tell):
            result = carry_out(ready, plan.parent, progress=progress, tell=tell)
        with output.progress_bar("comparing laws") as progress:
            compared = compare_laws(result, progress=progress)
        with output.progress_bar("drawing from the posterior") as progress:
            written = write_files(result, folder, compared, progress=progress)
        data = as_data(result, compared)
        with output.spinner("assessing the assumptions"):
            assumed = assumptions(result.fits)
        text = fit_text(result, compared, assumed)
        if output.wants_figures():
            from springback.identification.design.experiments import plan_experiments
            from springback.interfaces.reports.fit_page import write_report

            with output.progress_bar("comparing further tests") as progress:
                try:
                    further = plan_experiments(
                        ready, plan.parent, fits=result.fits, progress=progress
                    )
                except InputError:  # the scenario's start hits nothing: the logs tell the start
                    further = None
            with output.spinner("drawing the report"):
                written.append(write_report(result, folder, further, compared))
    output.print(data, text)
    output.note_written(written)
    if not result.is_informative:
        sys.exit(1)


def fit_text(
    result: FitResult,
    compared: LawComparison | None = None,
    assumed: Sequence[Assumption] = (),
) -> str:
    """A fit on the terminal: the answer first.

    Args:
        result: The fit.
        compared: Laws, by impacts left out.
        assumed: Fields that were taken as exact.
    """
    from springback.identification.report.assumptions import assumption_sentences
    from springback.identification.wording import estimate_sentence

    free = [one for one in result.estimates if one.unknown.role == "free"]
    count = len(result.fits)
    lines = [f"from {count} impact{'s' if count > 1 else ''}, with 95 % intervals:"]
    lines += [f"  {estimate_sentence(one)}" for one in free]
    if result.sentences:
        lines += ["", *result.sentences]
    if assumed:
        lines += ["", "assumed to be exact:"]
        lines += [f"  {text}" for text in assumption_sentences(assumed, result.estimates)]
    if compared is not None:
        lines += ["", "laws compared:", *(f"  {text}" for text in compared.sentences)]
    lines += [f"not used: {reason}" for reason in result.refused]
    seconds = sum(fit.seconds for fit in result.fits)
    flights = sum(fit.problem.flown for fit in result.fits)
    lines += ["", f"{flights} flights in {seconds:.1f} s"]
    return "\n".join(lines)


@click.command()
@click.argument("plan", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@click.option("--sets", type=click.IntRange(10, 10_000), default=200, show_default=True,
              help="Number of synthetic sets of flights.")  # fmt: skip
@output_options("Folder for check.json and check.csv.", "force", "as_json", "quiet", required=False)
def check(plan: Path, overrides: tuple[str, ...], sets: int, output: Output) -> None:
    """Check that the intervals of a PLAN cover the truth, by fitting synthetic flights.

    The flights are seen through the scenario's sensors. The scenario's numbers are the truth, and
    the plan's priors are off by as much, and as often, as they say. The exit code is 1 if an
    interval covers the truth less often than it should.

    \b
    springback identify check fit.toml
    springback identify check fit.toml --sets 1000 --out checked
    """
    from springback.identification.design.coverage import check_coverage
    from springback.identification.settings import naming_places, read_fit_plan
    from springback.interfaces.reports.study_files import write_study

    ready = read_fit_plan(plan, overrides)
    progress_bar = output.progress_bar("flying and fitting synthetic sets")
    written = list[Path]()
    is_kept = output.out is not None
    with output.folder(CHECK_FILES) if is_kept else nullcontext() as folder:
        with naming_places(plan), progress_bar as progress:
            found = check_coverage(ready, plan.parent, sets=sets, progress=progress)
        rows = [one._asdict() | {"share": one.share} for one in found.fields]
        data = found._asdict() | {"fields": rows}
        if folder is not None:
            written = write_study(folder, "check", data, {"check": rows}, {})
    output.print(data, coverage_text(found))
    if is_kept:
        output.note_written(written)
    if any(one.high < LEAST for one in found.fields):
        sys.exit(1)


def coverage_text(found: Coverage) -> str:
    """Coverage on the terminal."""
    lines = [f"{found.sets} synthetic sets, 95 % intervals:"]
    for one in found.fields:
        half = f"{100.0 * one.half_width:.2g} %" if one.relative else (
            f"{one.half_width:.2g} {one.unit}".strip()
        )  # fmt: skip
        lines.append(
            f"  {one.name}: {100.0 * one.share:.1f} % contain the truth ({100.0 * one.low:.0f} to "
            f"{100.0 * one.high:.0f} %), half width {half}, median error {one.bias:+.2f} standard "
            f"errors, scatter {one.spread:.2f} of what the intervals say"
        )
    lines.append(
        f"  a misfit was wrongly reported in {found.alarms} sets: {found.alarms / found.sets:.1%}"
    )
    lines += [f"  {len(found.failed)} sets could not be fitted, such as: {found.failed[0]}"
              ] if found.failed else []  # fmt: skip
    lines.append(f"  {found.seconds / found.sets:.1f} s for each fit")
    if found.lead:
        lines.append(
            f"  flown from {found.lead:.2f} s before the scenario's start, which is near to touch"
        )
    return "\n".join(lines)


@click.command("plan")
@click.argument("plan", type=ScenarioPath())
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@output_options("Folder for plan.json and plan.csv.", "force", "as_json", "quiet", required=False)
def plan_tests(plan: Path, overrides: tuple[str, ...], output: Output) -> None:
    """Choose the impacts to fly next for a PLAN: those that tell most about its free fields.

    They are chosen from the plan's candidates: speeds, pitches and yaws of the scenario's start,
    and others. If the plan has logs, these are fitted first, and what they tell is counted.

    \b
    springback identify plan fit.toml
    springback identify plan fit.toml candidates.speeds='["1 m/s", "3 m/s"]' candidates.count=2
    springback identify plan fit.toml --out planned
    """
    from springback.identification.design.experiments import plan_experiments
    from springback.identification.fits import fit as carry_out
    from springback.identification.settings import naming_places, read_fit_plan
    from springback.interfaces.reports.study_files import write_study

    ready = read_fit_plan(plan, overrides)
    fits: Sequence[ImpactFit] = ()
    written = list[Path]()
    is_kept = output.out is not None
    with output.folder(PLAN_FILES) if is_kept else nullcontext() as folder:
        if ready.flights:
            with naming_places(plan), output.progress_in_words("fitting") as (progress, tell):
                fits = carry_out(ready, plan.parent, progress=progress, tell=tell).fits
        with naming_places(plan), output.progress_bar("comparing tests") as progress:
            found = plan_experiments(ready, plan.parent, fits=fits, progress=progress)
        data = found._asdict() | {
            "fields": [one.name for one in found.fields], "sentence": found.sentence,
            "chosen": [one._asdict() for one in found.chosen],
        }  # fmt: skip
        if folder is not None:
            written = write_study(folder, "plan", data, {"plan": experiments_rows(found)}, {})
    output.print(data, experiments_text(found))
    if is_kept:
        output.note_written(written)
    if not found.chosen:
        sys.exit(1)


def experiments_rows(found: ExperimentPlan) -> list[dict[str, str | float | bool]]:
    """Half widths of 95 % intervals now, with each test alone, and with those chosen so far."""
    steps = [("now", "", found.before), *(("alone", *one) for one in found.alone)]
    steps += [
        (f"chosen {k}", one.name, one.half_widths) for k, one in enumerate(found.chosen, start=1)
    ]
    return [
        {
            "step": step, "test": test, "field": field.name, "half_width": width,
            "relative": field.logarithmic, "unit": field.unit,
        }
        for step, test, widths in steps
        for field, width in zip(found.fields, widths, strict=True)
    ]  # fmt: skip


def experiments_text(found: ExperimentPlan) -> str:
    """Tests that tell most, on the terminal: half widths of 95 % intervals."""
    from springback.identification.design.experiments import width_text
    from springback.interfaces.output.field_labels import short_names

    def row(name: str, widths: tuple[float, ...]) -> list[str]:
        return [name, *(width_text(f, w) for f, w in zip(found.fields, widths, strict=True))]

    rows = [["half widths", *short_names([one.name for one in found.fields])]]
    rows += [row("now", found.before), *(row(f"with {a}", widths) for a, widths in found.alone)]
    rows += [row(f"{k}. {one.name}", one.half_widths)
             for k, one in enumerate(found.chosen, start=1)]  # fmt: skip
    sizes = [max(len(one[k]) for one in rows) for k in range(len(rows[0]))]
    lines = [found.sentence, *found.untold, ""]
    for name, *cells in rows:
        aligned = (f"{cell:>{size}}" for cell, size in zip(cells, sizes[1:], strict=True))
        lines.append("  ".join([f"{name:{sizes[0]}}", *aligned]))
    lines += [f"cannot be flown: {name}: {why}" for name, why in found.refused]
    if found.assumed:
        lines += ["", "assumed to be exact, and what that does to all chosen tests together:"]
        lines += [f"  {text}" for text in found.assumed]
    return "\n".join(lines)
