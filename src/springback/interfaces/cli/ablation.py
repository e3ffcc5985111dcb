"""The command `springback study why`: what explains the difference between the robots."""

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
)


@click.command()
@click.option("--out", type=OUT, required=True, help="Folder for why.json, why.csv, figures.")
@click.option(
    "--trials", type=click.IntRange(1, 1000), default=10, show_default=True, help="Of each test."
)
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of all luck.")
@click.option("--no-ranges", is_flag=True, help="Only the ablation and its pairs.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def why(
    out: Path,
    trials: int,
    seed: int,
    no_ranges: bool,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Switch one thing at a time, then two, and see which robot still survives which test.

    Compliance, clipping, estimator, limits, delays, friction, contact point, recovery; pairs of
    changes at 3.5 m/s; then, along numbers that the paper does not print, over which range the
    printed result holds.
    """
    from springback.interfaces.output.folders import output_folder
    from springback.studies.ablation import RANGES
    from springback.studies.ablation import why as explained
    from springback.studies.ablation_pairs import fly_pairs

    figures = not no_figures and have_figures(quiet)
    with output_folder(out, force=force) as folder:
        note("some variants are of a kind of their own; the first run compiles for minutes", quiet)
        ranges = () if no_ranges else RANGES
        with progress_bar("what if", quiet) as show:
            results = explained(trials, ranges=ranges, seed=seed, progress=show)
        with progress_bar("two at a time", quiet) as show:
            pairs = fly_pairs(trials, seed=seed, progress=show)
        _written(results, pairs, folder, figures)
    rows = [cell.as_dict() for cell in (*results.cells, *results.ranges)]
    rows += [pair.as_dict() for pair in pairs.pairs]
    print_result(rows if as_json else "\n".join(sentences(results, pairs)), as_json)
    note(f"written to {out}", quiet)


def _written(results: Any, pairs: Any, folder: Path, figures: bool) -> None:
    from springback.files import write_csv, write_json

    rows = [{**cell.as_dict(), "part": part}
            for part, cells in (("ablation", results.cells), ("range", results.ranges))
            for cell in cells]  # fmt: skip
    paired = [pair.as_dict() for pair in pairs.pairs]
    said = sentences(results, pairs)
    write_json(folder / "why.json", {"cells": rows, "pairs": paired, "sentences": said})
    write_csv(folder / "why.csv", rows)
    if figures:
        from springback.interfaces.figures.ablation import (
            ablation_figure,
            pairs_figure,
            ranges_figure,
        )
        from springback.interfaces.figures.style import save

        save(pairs_figure(pairs), folder / "pairs")
        save(ablation_figure(results), folder / "ablation")
        if results.ranges:
            save(ranges_figure(results), folder / "ranges")


def sentences(results: Any, pairs: Any = None) -> list[str]:
    """What the study says, a line each."""
    from springback.studies.ablation import RANGES, ROBOTS, VARIANTS
    from springback.studies.ablation_pairs import pair_sentences

    told = []
    for robot in ROBOTS:
        cells = results.successes(VARIANTS[0], robot)
        counts = ", ".join(f"{p:+g} deg {v:g} m/s {c.successes}/{c.trials}"
                           for (p, v), c in cells.items())  # fmt: skip
        told.append(f"{robot}, all as documented: {counts}")
        for variant, more, unflown in results.moves(robot):
            cannot = ", ".join(f"{p:+g} deg {v:g} m/s" for p, v in unflown)
            why = f"; run-up cannot be flown: {cannot}" if unflown else ""
            told.append(f"  {variant.cause}, {variant.name}: {more:+d} successes{why}")
    found = results.printed_by()
    names = ", ".join(f"{v.cause} {v.name}" for v in found) or "none of these changes"
    told.append(f"ARQ always and Quad never at 3.5 m/s, as printed: {names}")
    if pairs is not None:
        told.append("two changes at a time, 0 deg 3.5 m/s, that tell the robots apart:")
        told += [f"  {sentence}" for sentence in pair_sentences(pairs)]
    for one in RANGES if results.ranges else ():
        held = results.holds(one)
        unit = f" {one.unit}" if one.unit else ""
        what = f"{held[0]:.4g} to {held[1]:.4g}{unit}" if held else "not even at its default"
        told.append(f"ARQ survives every trial with {one.name} {what} (default {one.default:.4g})")
    return told
