"""Do the intervals of a plan cover?  Synthetic flights through the scenario's own sensors, fitted.

Each set is flown with the scenario's numbers as truth, the middle of each prior displaced by what
the prior allows, the start displaced a little, and new noise; its readings go the way of a log's:
impacts are found, noise is estimated, the fit searches from its starts.  A start too near to the
obstacle for that is moved back in time.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.batch.sampled import sampled_flights
from springback.batch.workers import end_with_parent, single_threads
from springback.errors import InputError
from springback.identification.fits import result_of, scenario_with_fields
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import impact_window
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.identification.unknowns import Unknown, at_centres
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
#: Draws of displaced middles at most, until they are of a vehicle that can be (chosen).
MOST_DRAWS = 100
#: Time before touch that sets are flown for, at least: noise is estimated in it [s]; and that over
#: which the acceleration of a start is taken [s] (chosen).
LEAD, SHORT = 0.55, 0.01
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
    lead: float = 0.0  # time by which the start was moved back [s]


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
    scenario, tables, fields = scenario_with_fields(plan, Path(folder))
    flown, lead = with_lead(plan, at_centres(tables, fields, scenario))
    outcomes = [fitted_set(plan, tables, fields, 0, truth=flown)]
    count = processes or os.cpu_count() or 1
    with ProcessPoolExecutor(count, get_context("spawn"), end_with_parent) as pool:
        jobs = [(plan, tables, fields, seed, flown) for seed in range(1, sets)]
        with single_threads():  # all processes start with the first jobs
            fitted = pool.map(_job, jobs, chunksize=1)
        for one in fitted:
            outcomes.append(one)
            progress(len(outcomes) / sets)
    return coverage_of(fields, outcomes)._replace(lead=lead)


def _job(given: tuple[FitPlan, dict[str, Any], list[Unknown], int, Any]) -> SyntheticFit:
    plan, tables, fields, seed, flown = given
    return fitted_set(plan, tables, fields, seed, truth=flown)


def with_lead(plan: FitPlan, tables: Mapping[str, Any]) -> tuple[dict[str, Any], float]:
    """Tables whose flight has time enough before touch, and how far its start was moved back [s].

    Without turning and under a constant thrust a vehicle is where it was with the acceleration that
    it begins with; any other start is left as it is.

    Args:
        plan: Of the fit.
        tables: Of the scenario, plain.
    """
    tables = dict(tables)
    scenario = scenario_from(dict(tables))
    start, given = scenario.start, tables.get("start", {})
    moving = {"shell_spin", "compression", "second_compression"}
    turns = any(start.angular_velocity) or not moving.isdisjoint(given)
    piloted = scenario.reference is not None or scenario.pilot is not None
    varies = isinstance(tables.get("thrust"), Mapping)
    if plan.experiment == "drop" or turns or piloted or varies:
        return tables, 0.0
    found = find_impacts([_recorded(tables | {"sensors": tables.get("sensors", {})}, "start")])
    touch = found[0].touch if found else LEAD
    if not SHORT < touch < LEAD:
        return tables, 0.0
    bare = {key: value for key, value in tables.items() if key != "sensors"}
    state = scenario.start_state()
    position, velocity = np.array(state.position), np.array(state.velocity)
    later = sampled_flights([bare], [0.0, SHORT]).vectors("velocity")[0, 1]
    pull, lead = (later - velocity) / SHORT, LEAD - touch
    moved = position - lead * velocity + 0.5 * lead**2 * pull - np.array(start.offset)
    at = {key: value for key, value in given.items() if key != "touch_distance"}
    at |= {"position": moved.tolist(), "velocity": (velocity - lead * pull).tolist()}
    simulation = dict(tables.get("simulation", {}))
    simulation["duration"] = scenario.simulation.duration + lead
    return tables | {"start": at, "simulation": simulation}, lead


def _recorded(tables: Mapping[str, Any], name: str) -> Recording:
    return flight_recording(fly(scenario_from(dict(tables))), Path(name))


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
    displaced = _believed_fields(tables, fields, generator)
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
    recording = _recorded(flown, name)
    recording = recording if corrupt is None else corrupt(recording)
    drops = plan.experiment == "drop"
    seen = find_impacts([recording], drops=drops)
    found = [one for one in seen if not one.refused]
    if not found:
        refused = (f"impact at {one.touch:.3f} s: {one.refused}" for one in seen)
        why = "; ".join(refused) or "no impact was found: the scenario's start hits nothing"
        raise InputError(f"{name}: {why}")
    believed: Scenario = scenario_from(dict(tables))
    fits = []
    for impact in found:
        readings = impact_window(plan, believed, [recording], impact)
        problem = ImpactProblem(plan, believed, tables, fields, readings)
        fits.append(fit_impact(problem, starts=plan.starts, seed=plan.seed))
    return fits


def _believed_fields(
    tables: Mapping[str, Any], fields: Sequence[Unknown], generator: np.random.Generator
) -> list[Unknown]:
    """Fields by `displaced_fields`, drawn anew where together they are of no vehicle.

    Nobody believes in moments of inertia that no body has, however uncertain each of them is.
    """
    scenario = scenario_from(dict(tables))
    for _ in range(MOST_DRAWS):
        found = displaced_fields(fields, generator)
        with suppress(InputError):
            scenario_from(at_centres(tables, found, scenario))
            break
    return found


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
