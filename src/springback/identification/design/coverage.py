"""Do the intervals of a plan cover?  Synthetic flights through the scenario's own sensors, fitted.

Each set is flown with the scenario's numbers as truth, the middle of each prior displaced by what
the prior allows, the start displaced a little, and new noise; its readings go the way of a log's:
impacts are found, noise is estimated, the fit searches from its starts.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.identification.fits import base_scenario, fields_of_plan, result_of
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import impact_window
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.identification.unknowns import Unknown
from springback.intervals import wilson
from springback.logs.recording import Recording
from springback.logs.segments import find_impacts
from springback.logs.writing.flight_recording import flight_recording
from springback.progress import Progress, silent
from springback.random_streams import Purpose, stream
from springback.results.flight import fly
from springback.scenario.overrides import with_value
from springback.scenario.scenario import Scenario, scenario_from

#: Displacement of the start along its velocity, at most [m] (chosen: several ticks), and bounds of
#: the displacement of a prior's middle, in its deviations (chosen: nineteen of twenty truths).
DISPLACED, WITHIN = 0.01, 2.0
#: Share of the nominal cover of 95 % (chosen as in the acceptance of the design: 90 to 98 %).
LEAST_COVER, MOST_COVER = 0.90, 0.98

Corruption = Callable[[Recording], Recording]
"""Change of a recording before it is fitted, such as what a sensor does that a plan ignores."""


class FieldCoverage(NamedTuple):
    """How well the intervals of one field cover."""

    name: str
    sets: int
    covered: int
    low: float  # 95 % interval of the share that is covered
    high: float
    bias: float  # median error, in standard errors
    spread: float  # standard deviation of the errors over the mean standard error
    half_width: float  # median of half the interval, relative if the prior is
    relative: bool
    unit: str

    @property
    def share(self) -> float:
        """Share of intervals with the truth."""
        return self.covered / self.sets if self.sets else float("nan")


class Coverage(NamedTuple):
    """Result of a check."""

    fields: tuple[FieldCoverage, ...]
    sets: int
    failed: tuple[str, ...]  # sets without a fit, with the reason
    alarms: int  # sets with a misfit
    seconds: float  # of all fits
    latents: dict[str, float]  # median standard deviation [SI]


class SyntheticFit(NamedTuple):
    """One set."""

    errors: dict[str, float]  # of a field, u found less u true
    ends: dict[str, tuple[float, float]]  # interval less u true
    deviations: dict[str, float]
    latents: dict[str, float]
    alarm: bool
    seconds: float
    problem: str


def check_coverage(
    plan: FitPlan,
    folder: str | Path = ".",
    *,
    sets: int = 200,
    processes: int | None = None,
    progress: Progress = silent,
) -> Coverage:
    """Coverage of a plan's intervals.

    Args:
        plan: Of the fit; its logs are not read.
        folder: That its paths are relative to.
        sets: Number of synthetic sets.
        processes: Defaults to the number of processors.
        progress: Called from time to time with the share done.

    Raises:
        InputError: If the scenario cannot be flown, or no set could be fitted.
    """
    scenario, tables = base_scenario(plan, Path(folder))
    fields = fields_of_plan(plan, scenario)
    outcome = fitted_set(plan, tables, fields, 0)
    outcomes = [outcome]
    count = processes or os.cpu_count() or 1
    with ProcessPoolExecutor(count, mp_context=get_context("spawn")) as pool:
        jobs = [(plan, tables, fields, seed) for seed in range(1, sets)]
        for one in pool.map(_job, jobs, chunksize=1):
            outcomes.append(one)
            progress(len(outcomes) / sets)
    return coverage_of(fields, outcomes)


def _job(given: tuple[FitPlan, dict[str, Any], list[Unknown], int]) -> SyntheticFit:
    return fitted_set(*given)


def coverage_of(fields: Sequence[Unknown], outcomes: Sequence[SyntheticFit]) -> Coverage:
    """Coverage of some sets.

    Raises:
        InputError: If none could be fitted.
    """
    fine = [one for one in outcomes if not one.problem]
    failed = tuple(one.problem for one in outcomes if one.problem)
    if not fine:
        raise InputError(f"no synthetic set could be fitted: {failed[0]}")
    found = []
    for field in fields:
        if field.role != "free":
            continue
        errors = np.array([one.errors[field.name] for one in fine])
        deviations = np.array([one.deviations[field.name] for one in fine])
        ends = np.array([one.ends[field.name] for one in fine])
        covered = int(((ends[:, 0] <= 0.0) & (ends[:, 1] >= 0.0)).sum())
        low, high = wilson(covered, len(fine))
        half = 0.5 * (ends[:, 1] - ends[:, 0])
        found.append(FieldCoverage(
            field.name, len(fine), covered, low, high,
            float(np.median(errors / deviations)),
            float(errors.std() / deviations.mean()),
            float(np.median(half)) * field.deviation, field.logarithmic, field.unit,
        ))  # fmt: skip
    latents = {
        name: float(np.median([one.latents[name] for one in fine])) for name in fine[0].latents
    }
    return Coverage(
        tuple(found), len(outcomes), failed, sum(one.alarm for one in fine),
        sum(one.seconds for one in fine), latents,
    )  # fmt: skip


def fitted_set(
    plan: FitPlan,
    tables: Mapping[str, Any],
    fields: Sequence[Unknown],
    seed: int,
    *,
    truth: Mapping[str, Any] | None = None,
    corrupt: Corruption | None = None,
) -> SyntheticFit:
    """Fly, record and fit one set.

    Args:
        plan: Of the fit.
        tables: Of the scenario, plain.
        fields: Of the plan.
        seed: Of the set.
        truth: Tables that are flown in place of those that are fitted, with the same fields.
        corrupt: Change of the recording.
    """
    generator = stream(plan.seed, Purpose.TRIAL, seed)
    displaced = displaced_fields(fields, generator)
    flown = _flown_tables(dict(tables if truth is None else truth), seed, generator)
    try:
        fits = synthetic_fits(plan, tables, displaced, flown, f"set {seed}", corrupt=corrupt)
        result = result_of(plan, fits)
    except InputError as error:
        return SyntheticFit({}, {}, {}, {}, False, 0.0, "; ".join(error.problems))
    errors, ends, deviations = {}, {}, {}
    for estimate, original in zip(result.estimates, fields, strict=True):
        unknown = estimate.unknown
        true = unknown.coordinate(float(original.value(0.0)))
        at = unknown.coordinate(estimate.value)
        low = unknown.coordinate(estimate.low) if np.isfinite(estimate.low) else -np.inf
        high = unknown.coordinate(estimate.high) if np.isfinite(estimate.high) else np.inf
        errors[unknown.name], deviations[unknown.name] = at - true, estimate.deviation
        ends[unknown.name] = (low - true, high - true)
    last = fits[-1]
    latents = {
        one.name: last.deviation(one.name) * one.deviation
        for one in last.problem.unknowns if one.role == "latent"
    }  # fmt: skip
    alarm = any(one.is_misfit for one in result.misfits)
    return SyntheticFit(
        errors, ends, deviations, latents, alarm, sum(fit.seconds for fit in fits), ""
    )


def synthetic_fits(
    plan: FitPlan,
    tables: Mapping[str, Any],
    fields: Sequence[Unknown],
    flown: Mapping[str, Any],
    name: str,
    *,
    corrupt: Corruption | None = None,
) -> list[ImpactFit]:
    """Fly one flight, record it and fit its impacts, as those of a log.

    Args:
        plan: Of the fit.
        tables: Of the scenario that is believed, plain.
        fields: With their priors.
        flown: Tables of what is flown, with sensors and a seed of their own.
        name: Of the recording.
        corrupt: Change of the recording.

    Raises:
        InputError: If it cannot be flown, has no impact, or cannot be fitted.
    """
    recording = flight_recording(fly(scenario_from(dict(flown))), Path(name))
    recording = recording if corrupt is None else corrupt(recording)
    drops = plan.experiment == "drop"
    found = [one for one in find_impacts([recording], drops=drops) if not one.refused]
    if not found:
        raise InputError(f"{name}: no impact was found")
    believed: Scenario = scenario_from(dict(tables))
    fits = []
    for impact in found:
        readings = impact_window(plan, believed, [recording], impact)
        problem = ImpactProblem(plan, believed, tables, fields, readings)
        fits.append(fit_impact(problem, starts=plan.starts, seed=plan.seed))
    return fits


def displaced_fields(fields: Sequence[Unknown], generator: np.random.Generator) -> list[Unknown]:
    """Fields whose priors have other middles, as often as the priors say."""
    found = []
    for one in fields:
        shift = float(np.clip(generator.standard_normal(), -WITHIN, WITHIN)) * one.deviation
        found.append(one._replace(centre=one.centre + shift))
    return found


def _flown_tables(
    tables: dict[str, Any], seed: int, generator: np.random.Generator
) -> dict[str, Any]:
    """Tables of a set's flight: sensors, a seed, and a start displaced along its velocity."""
    tables.setdefault("sensors", {})
    tables["seed"] = seed
    shift = DISPLACED * float(generator.random())
    start = scenario_from(tables).start
    speed = float(np.linalg.norm(start.velocity))
    if speed > 0.0:
        offset = [a - shift * b / speed for a, b in zip(start.offset, start.velocity, strict=True)]
        tables = with_value(tables, ("start", "offset"), offset, "start.offset")
    return tables
