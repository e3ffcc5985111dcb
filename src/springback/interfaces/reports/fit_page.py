"""Page of a fit to recorded impacts; its text and layout are in ``templates/fit.toml``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from springback.identification.design.experiments import ExperimentPlan
from springback.identification.estimates import FieldEstimate, correlations
from springback.identification.fits import FitResult
from springback.identification.law_comparison import LawComparison
from springback.identification.misfit import UNLIKELY
from springback.identification.report.assumptions import MATTERS, assumptions, words_of_laws
from springback.identification.report.profiles import profile_curves
from springback.identification.report.replays import replays
from springback.identification.results_files import DRAWS, REPORT
from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.profiles import PROFILE_RISE
from springback.interfaces.figures.fits.likelihood import (
    correlations_figure,
    profiles_figure,
    values_figure,
)
from springback.interfaces.figures.fits.readings import impact_figure
from springback.interfaces.output.field_labels import short_names
from springback.interfaces.reports.fit_tables import (
    assumption_rows,
    channel_rows,
    estimate_cells,
    experiment_rows,
    field_rows,
    impact_head,
    impact_rows,
    interval_alone,
    interval_of,
    latent_rows,
    law_rows,
    misfit_rows,
    narrower_rows,
    search_rows,
    source_words,
    value_text,
)
from springback.interfaces.reports.page import (
    Content,
    FigureBlock,
    Table,
    Wording,
    join,
    page,
    table,
)
from springback.logs.recording import Array
from springback.version import __version__

WORDS = Wording.of("fit")
#: Correlation with a free field from which a latent is shown, and most latents (chosen).
RELATED, MOST_LATENTS = 0.5, 6
#: Most assumed fields that are listed (chosen).
MOST_ASSUMED = 12


def write_report(
    result: FitResult,
    folder: Path,
    further: ExperimentPlan | None = None,
    compared: LawComparison | None = None,
) -> Path:
    """Write the page ``report.html`` of a fit; see `fit_page`."""
    path = folder / REPORT
    path.write_text(fit_page(result, further, compared), encoding="utf-8")
    return path


def fit_page(
    result: FitResult, further: ExperimentPlan | None = None, compared: LawComparison | None = None
) -> str:
    """Self-contained HTML page of a fit; some hundred flights are flown for it.

    Args:
        result: With its fits.
        further: Tests that tell most next.
        compared: Laws, by impacts left out.
    """
    fits = result.fits
    flights, seconds = sum(fit.problem.flown for fit in fits), sum(fit.seconds for fit in fits)
    count, method = len(fits), _method(result, flights)  # counted before more are flown
    impacts = WORDS.say("one_impact" if count == 1 else "more_impacts", count=count)
    content: dict[str, Content] = {
        "overview": {
            "impacts": impacts, "answer": _answer(result), "trust": _trust(result),
            "fields": [table(
                WORDS.say("fields", source=source_words(result)), WORDS.head("fields"),
                field_rows(result),
            )],
        },
        "warnings": {
            "sentences": [_sentence(text) for text in result.sentences],
            "refused": [[reason] for reason in result.refused],
            "refused_caption": WORDS.text["refused"],
        },
        "data": {"pictures": [_impact(k, fit, count) for k, fit in enumerate(fits, start=1)]},
        "misfit": {"unlikely": UNLIKELY, "tables": _misfits(result)},
        "profiles": {"pictures": _profiles(fits)},
        "correlations": {"pictures": _correlations(fits)},
        "impacts": _impacts(result),
        "laws": _laws(compared),
        "assumed": _assumed(result),
        "next": _next(result, further),
        "method": method,
    }  # fmt: skip
    shown = {name: held for name, held in content.items() if any(held.values())}
    lead = WORDS.say(
        "lead", scenario=result.plan.scenario, version=__version__, flights=flights, seconds=seconds
    )
    title = WORDS.say("title", name=result.plan.name, impacts=impacts)
    return page(title, WORDS.sections(shown), lead=lead)


def _sentence(text: str) -> str:
    ended = text if text.endswith(".") else f"{text}."
    is_name = "." in text.partition(" ")[0]
    return ended if is_name else ended[:1].upper() + ended[1:]


def _free(result: FitResult) -> list[FieldEstimate]:
    return [one for one in result.estimates if one.unknown.role == "free"]


def _answer(result: FitResult) -> str:
    """The answer in one sentence."""
    free = _free(result)
    if not all(one.settled for one in free):
        return WORDS.say("unsettled")
    learned = [one for one in free if one.verdict == "learned"]
    part = [one for one in free if one.verdict not in ("learned", "not learned")]
    if not learned and not part:
        return WORDS.say("nothing")
    said = []
    names = short_names([one.unknown.name for one in [*learned, *part]])
    for name, one in zip(names, [*learned, *part], strict=True):
        value, ends = estimate_cells(one.unknown, interval_of(one))
        around = f" ({ends.detail})" if ends.detail else f", {ends.text}"
        said.append(f"{name} {value.text}{around}")
    partly = WORDS.say("partly", count=len(part)) if part else ""
    return WORDS.say(
        "learned", learned=len(learned), free=len(free), partly=partly, values="; ".join(said)
    )


def _trust(result: FitResult) -> str:
    channels = dict.fromkeys(one.channel for one in result.misfits if one.is_misfit)
    return WORDS.say("misfit", channels=join(channels)) if channels else WORDS.say("clean")


def _impact(number: int, fit: ImpactFit, count: int) -> FigureBlock:
    impact, channels = fit.problem.impact, replays(fit)
    rest = "".join(
        WORDS.say("rest", quantity=one.reading.quantity, where=one.at_rest)
        for one in channels if one.at_rest
    )  # fmt: skip
    if any(one.clipped.any() for one in channels):
        rest += WORDS.say("clipped")
    name = f"Impact {number}" if count > 1 else "The impact"
    said = WORDS.say("impact", number=name, name=fit.name, rest=rest)
    figure = impact_figure(channels, impact.release - impact.touch)
    return FigureBlock(f"impact-{number}", said, figure)


def _misfits(result: FitResult) -> list[Table]:
    found = []
    for fit in result.fits:
        rows = misfit_rows([one for one in result.misfits if one.impact == fit.name])
        caption = WORDS.text["misfits"]
        if len(result.fits) > 1:
            caption = f"{fit.name}. {caption}"
        found.append(table(caption, WORDS.head("misfits"), rows))
    return found


def _profiles(fits: Sequence[ImpactFit]) -> list[FigureBlock]:
    curves = [found for fit in fits if (found := profile_curves(fit))]
    if not curves:
        return []
    key = "profiles_one" if len(curves) == 1 else "profiles_more"
    said = WORDS.say(key, rise=PROFILE_RISE)
    return [FigureBlock("profiles", said, profiles_figure(curves))]


def mean_correlations(fits: Sequence[ImpactFit]) -> tuple[list[str], Array]:
    """Correlations of the fields, means over the impacts: names and matrix."""
    names, _ = correlations(fits[0])
    return names, np.mean([correlations(fit)[1] for fit in fits], axis=0)


def _correlations(fits: Sequence[ImpactFit]) -> list[FigureBlock]:
    names, matrix = mean_correlations(fits)
    if len(fits) == 1:  # latents of one impact are not those of another
        [fit] = fits
        scale = 1.0 / np.sqrt(np.diag(fit.covariance))
        whole = fit.covariance * scale[:, None] * scale[None]
        free = [k for k, one in enumerate(fit.problem.unknowns) if one.role == "free"]
        related = np.abs(whole[free]).max(axis=0)
        latents = [
            k for k, one in enumerate(fit.problem.unknowns)
            if one.role == "latent" and related[k] > RELATED
        ]  # fmt: skip
        latents = sorted(latents, key=lambda k: -related[k])[:MOST_LATENTS]
        which = [*range(len(names)), *latents]
        names = [fit.problem.unknowns[k].name for k in which]
        matrix = whole[np.ix_(which, which)]
    if len(names) < 2:
        return []
    said = WORDS.say("correlations", mean=WORDS.say("mean") if len(fits) > 1 else "") + "."
    return [FigureBlock("correlations", said, correlations_figure(names, matrix))]


def _impacts(result: FitResult) -> Content:
    """Values of each impact, and of all without it; nothing for one impact."""
    estimates = [one for one in _free(result) if one.pooled is not None]
    if not estimates:
        return {}
    alone = [[interval_alone(fit, one.unknown.name) for fit in result.fits] for one in estimates]
    rows = impact_rows(estimates, alone)
    figure = FigureBlock("values", WORDS.text["values"] + ".", values_figure(estimates, alone))
    common = "" if result.plan.scatter == "impact" else "; here as if nothing differed, as asked"
    return {
        "pictures": [figure], "common": common,
        "tables": [table(WORDS.text["values_table"], impact_head(estimates), rows)],
    }  # fmt: skip


def _laws(compared: LawComparison | None) -> Content:
    if compared is None:
        return {}
    rows = law_rows(compared)
    return {
        "sentences": [_sentence(text) for text in compared.sentences],
        "tables": [table(WORDS.text["laws_table"], WORDS.head("laws"), rows)],
    }


def _assumed(result: FitResult) -> Content:
    fits, found = result.fits, assumptions(result.fits)
    matter = [one for one in found if one.weight >= MATTERS][:MOST_ASSUMED]
    quiet = len(found) - len(matter)
    said = [WORDS.say("quiet", count=quiet)] if quiet else []
    laws = words_of_laws(fits[0].problem.scenario)
    said += [WORDS.say("laws", laws="; ".join(laws))] if laws else []
    held = [
        str(k) for k, fit in enumerate(fits, start=1)
        if fit.problem.impact.thrust is None and "thrust factor" in fit.problem.place
    ]  # fmt: skip
    if held:
        which = "this impact" if len(fits) == 1 else f"impact {join(held)}"
        uncertainty = f"{100.0 * result.plan.thrust:g} %"
        said.append(WORDS.say("hovering", impacts=which, thrust=uncertainty))
    rows = assumption_rows(matter, result.estimates)
    tables = [table(WORDS.text["assumed"], WORDS.head("assumed"), rows)] if rows else []
    return {"tables": tables, "sentences": said}


def _next(result: FitResult, further: ExperimentPlan | None) -> Content:
    rows = narrower_rows(result.estimates, *mean_correlations(result.fits))
    tables = [table(WORDS.text["narrower"], WORDS.head("narrower"), rows)] if rows else []
    said = list[str]()
    if further is not None:
        said += [further.sentence, *further.untold]
        head = [WORDS.text["candidate"], *short_names([one.name for one in further.fields])]
        rows = experiment_rows(further)
        tables.insert(0, table(WORDS.text["experiments"], head, rows))
    return {"advice": tuple(said), "tables": tables, "always": True}


def _method(result: FitResult, flights: int) -> Content:
    plan, fits = result.plan, result.fits
    tables = [table(WORDS.text["searches"], WORDS.head("searches"), search_rows(fits))]
    for fit in fits:
        for key, rows in (("channels", channel_rows(fit)), ("latents", latent_rows(fit))):
            caption = WORDS.say(key, name=fit.name)
            tables.append(table(caption, WORDS.head(key), rows, folded=True))
    after = plan.window.after
    known: dict[str, Any] = {
        one.unknown.name: one.unknown.uncertainty for one in result.estimates
        if one.unknown.role == "known"
    }  # fmt: skip
    return {
        "starts": plan.starts, "seed": plan.seed, "lanes": flights, "before": plan.window.before,
        "after": WORDS.text["usual"] if after is None else value_text(after, "s"),
        "known": ", ".join(f"{name} {text}" for name, text in known.items()) or "nothing",
        "draws": DRAWS, "tables": tables,
    }  # fmt: skip
