"""Files of a fit: values and uncertainties as an overlay, and draws of the posterior."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from springback.identification.estimates import FieldEstimate
from springback.identification.fits import FitResult
from springback.identification.law_comparison import LawComparison
from springback.identification.solving.pooled_fields import pooled_posterior
from springback.identification.solving.sampling import posterior_sample
from springback.identification.unknowns import DIRECTIONS, FARTHEST, INERTIA
from springback.logs.recording import Array
from springback.progress import Progress, silent, stage
from springback.random_streams import Purpose, stream
from springback.results.parquet import write_parquet

#: Names of the files.
IDENTIFIED, POSTERIOR, SUMMARY = "identified.toml", "posterior.parquet", "fit.json"
REPORT = "report.html"
#: Draws of the posterior (chosen).
DRAWS = 1000


def finite(number: float) -> float | None:
    """A number for JSON, which has no infinity."""
    return float(number) if np.isfinite(number) else None


def as_data(result: FitResult, comparison: LawComparison | None = None) -> dict[str, Any]:
    """A fit as plain data.

    Args:
        result: The fit.
        comparison: Of laws, if the plan asks for one.
    """
    compared = {} if comparison is None else {"comparison": comparison.as_data()}
    return {
        "name": result.plan.name,
        "learned": result.is_informative,
        "estimates": [
            {
                "field": one.unknown.name, "role": one.unknown.role, "value": one.value,
                "low": finite(one.low), "high": finite(one.high), "unit": one.unknown.unit,
                "prior": list(one.prior), "uncertainty": one.unknown.uncertainty,
                "verdict": one.verdict,
                "share_of_prior": one.deviation,
                "scatter": None if one.pooled is None else one.pooled.scatter
                * one.unknown.deviation,
            }
            for one in result.estimates
        ],
        "impacts": [
            {
                "name": fit.name, "cost": fit.cost, "rows": len(fit.jacobian),
                "agreeing_starts": fit.agreeing, "starts": fit.starts, "seconds": fit.seconds,
                "flights": fit.problem.flown,
                "values": {
                    one.name: float(one.value(u))
                    for one, u in zip(fit.problem.unknowns, fit.point, strict=True)
                },
            }
            for fit in result.fits
        ],
        "misfits": [one._asdict() | {"correlated": finite(one.correlated)}
                    for one in result.misfits],
        "sentences": list(result.sentences),
        "refused": list(result.refused),
        **compared,
    }  # fmt: skip


def write_files(
    result: FitResult,
    folder: Path,
    comparison: LawComparison | None = None,
    *,
    progress: Progress = silent,
) -> list[Path]:
    """Write the overlay, the posterior and all numbers of a fit; the paths.

    Args:
        result: The fit.
        folder: For the files.
        comparison: Of laws, if the plan asks for one.
        progress: Called from time to time with the share done.
    """
    paths = [folder / name for name in (IDENTIFIED, POSTERIOR, SUMMARY)]
    paths[0].write_text(overlay_text(result), encoding="utf-8")
    drawn = zip(result.estimates, draws(result, progress=progress).T, strict=True)
    # Entries of lists that are known to some uncertainty are left out: campaigns do not draw them.
    kept = [
        (one.unknown, column) for one, column in drawn
        if one.unknown.role == "free" or one.unknown.path[:3] not in (DIRECTIONS, INERTIA)
    ]  # fmt: skip
    columns = {unknown.name: column for unknown, column in kept}
    units = {unknown.name: unknown.unit for unknown, _ in kept}
    about = {
        "name": result.plan.name,
        "draws": f"{DRAWS} draws, of a next impact, {result.plan.method}",
    }
    write_parquet(paths[1], columns, units, about)
    text = json.dumps(as_data(result, comparison), indent=1, allow_nan=False)
    paths[2].write_text(text + "\n", encoding="utf-8")
    return paths


def draws(result: FitResult, count: int = DRAWS, *, progress: Progress = silent) -> Array:
    """Draws of all fields for a next impact [SI], shape (draws, fields), correlations included.

    One impact: the posterior by Laplace, or by Monte Carlo if the plan's method says so.  Several:
    what they tell together of what is common and of what they share, and the scatter from impact to
    impact; by Monte Carlo, mean and covariance of each impact are those of its draws.

    Args:
        result: The fit.
        count: Draws.
        progress: Called from time to time with the share done.

    Raises:
        InputError: If Monte Carlo is asked for and cannot be done.
    """
    names, fits = [one.unknown.name for one in result.estimates], list(result.fits)
    if result.plan.method == "emcee":
        for k, fit in enumerate(fits):
            part = stage(progress, k / len(fits), 1.0 / len(fits))
            seed = result.plan.seed + k
            drawn = posterior_sample(fit, seed=seed, count=count, progress=part).draws
            if len(fits) == 1:
                u = drawn[:, [fit.problem.place[name] for name in names]]
                return _values(result, u)
            covariance = np.cov(drawn.T)
            fits[k] = fit._replace(point=drawn.mean(axis=0), covariance=covariance, profiles={})
    if len(fits) == 1:
        [fit] = fits
        which = [fit.problem.place[name] for name in names]
        mean, covariance = fit.point[which], fit.covariance[np.ix_(which, which)]
    else:
        pooled = pooled_posterior(fits, scatter=result.plan.scatter == "impact")
        which = [pooled.names.index(name) for name in names]
        mean = pooled.mean[which]
        covariance = (pooled.covariance + pooled.scatter)[np.ix_(which, which)]
    generator = stream(result.plan.seed, Purpose.SCATTER)
    normal = generator.standard_normal((count, len(names)))
    return _values(result, mean + normal @ np.linalg.cholesky(covariance).T)


def _values(result: FitResult, u: Array) -> Array:
    """Values in SI of numbers u of all fields."""
    u = np.clip(u, -FARTHEST, FARTHEST)
    values = [one.unknown.value(u[:, k]) for k, one in enumerate(result.estimates)]
    return np.stack(values, axis=1)


def overlay_text(result: FitResult) -> str:
    """``identified.toml``: values to lay over a scenario, and their uncertainty."""
    lines = [
        f"# What {len(result.fits)} impact{'s' if len(result.fits) > 1 else ''} told "
        "(springback identify fit); lay it over a scenario:",
        f"#   springback fly SCENARIO.toml --with {IDENTIFIED}",
        f"name = {json.dumps(result.plan.name)}",
        "",
        "[values]",
    ]
    told = [one for one in result.estimates if one.unknown.role == "free"]
    for one in told:
        lines.append(f"# {one.unknown.unit or 'no unit'}; {one.verdict}")
        lines.append(f"{json.dumps(one.unknown.name)} = {one.value!r}")
    lines += [
        "",
        "# One standard deviation, in the words of [known] of a further fit.",
        "[uncertainty]",
    ]
    lines += [
        f"{json.dumps(one.unknown.name)} = {json.dumps(uncertainty_text(one))}" for one in told
    ]
    return "\n".join(lines) + "\n"


def uncertainty_text(one: FieldEstimate) -> str:
    """Value and standard deviation of a field, as a plan reads them."""
    deviation = one.unknown.deviation * one.deviation
    value = f"{one.value!r} {one.unknown.unit}".strip()
    if one.unknown.logarithmic:
        return f"{value} +- {100.0 * deviation:.3g} %"
    return f"{value} +- {deviation:.3g} {one.unknown.unit}".strip()
