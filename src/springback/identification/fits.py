"""A plan carried out: logs read, impacts found and fitted, and what they tell together."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.identification.estimates import FieldEstimate, field_estimates
from springback.identification.misfit import ChannelMisfit, filter_sentences, misfits
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import ImpactWindow, impact_window
from springback.identification.settings import EXACT, FitPlan, LoggedFlight, refuse_second_vehicle
from springback.identification.solving.fitting import ImpactFit, fit_impact
from springback.identification.solving.search_progress import Tell, ignore_words
from springback.identification.unknowns import (
    Unknown,
    field_unknown,
    number_of_all,
    refuse_centres,
    refuse_twice,
)
from springback.identification.wording import force_sentences, sentences
from springback.logs.axes_options import refuse_unused_axes, refuse_wrong_axes
from springback.logs.clock_jumps import refuse_clock_jumps
from springback.logs.filter_check import untold_filter
from springback.logs.frame_check import refuse_units
from springback.logs.overview import damages
from springback.logs.reading import LogOptions
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    POSITION,
    SPECIFIC_FORCE,
    Recording,
)
from springback.logs.segments import LogImpact, find_impacts
from springback.logs.time_units import refuse_time_units
from springback.logs.vehicle_track import with_vehicle
from springback.logs.writing.flight_recording import log_or_flight
from springback.progress import Progress, silent, stage
from springback.scenario.code_files import with_absolute_names
from springback.scenario.files import read_scenario
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import with_contents
from springback.scenario.scenario import Scenario
from springback.scenario.source_text import source_text, toml_tables

#: Lists whose name stands for all of their numbers, and how many there are: on a slider nothing
#: turns, and a body of parts has the inertia of these.
LISTS: dict[str, Callable[[Scenario], int]] = {
    "vehicle.arms.directions": lambda scenario: scenario.vehicle.arm_count,
    "vehicle.body.inertia": lambda scenario: (
        0 if scenario.model.slider is not None or _is_derived(scenario) else 3
    ),
}
#: Distance within which a touch that a plan names is one that was found [s] (chosen).
NEAR = 0.05
#: Most arms whose order is looked at, and the share of the squares below which another order is
#: plainly the right one (chosen).
MOST_ORDERED, PLAINLY = 6, 0.2
#: Largest sample over the end of its range: noise and rounding of the number (chosen).
BEYOND_RANGE = 1.05


class ReadFlight(NamedTuple):
    """A flight of a plan: its scenario and its impacts."""

    scenario: Scenario
    tables: dict[str, Any]
    impacts: tuple[ImpactWindow, ...]
    refused: tuple[str, ...]  # impacts that cannot be used, with the reason
    warnings: tuple[str, ...]  # what the logs say of their own frames and units


class FitResult(NamedTuple):
    """What a plan's logs tell."""

    plan: FitPlan
    fits: tuple[ImpactFit, ...]
    estimates: tuple[FieldEstimate, ...]
    misfits: tuple[ChannelMisfit, ...]
    sentences: tuple[str, ...]
    refused: tuple[str, ...]

    @property
    def is_informative(self) -> bool:
        """True if any free field was learned, at least partly."""
        return any(
            one.verdict not in ("not learned", "not settled")
            for one in self.estimates if one.unknown.role == "free"
        )  # fmt: skip


def base_scenario(plan: FitPlan, folder: Path) -> tuple[Scenario, dict[str, Any]]:
    """Scenario of a plan, and its plain tables.

    Args:
        plan: Of the fit.
        folder: That its paths are relative to.

    Raises:
        InputError: If it cannot be read.
    """
    path = folder / plan.scenario
    scenario = read_scenario(path)
    refuse_second_vehicle(scenario)
    return scenario, with_contents(with_absolute_names(
        toml_tables(source_text(path), str(path)), path.parent
    ))  # fmt: skip


def scenario_with_fields(
    plan: FitPlan, folder: Path
) -> tuple[Scenario, dict[str, Any], list[Unknown]]:
    """Scenario of a plan, its plain tables, and the fields of the plan.

    Args:
        plan: Of the fit.
        folder: That its paths are relative to.

    Raises:
        InputError: As `base_scenario` and `fields_of_plan`, or if the scenario cannot have the
            middle of a prior.
    """
    scenario, tables = base_scenario(plan, folder)
    fields = fields_of_plan(plan, scenario)
    refuse_centres(tables, fields, scenario)
    return scenario, tables, fields


def read_flights(plan: FitPlan, folder: Path) -> list[ReadFlight]:
    """Flights of a plan: logs read, impacts found.

    Args:
        plan: Of the fit.
        folder: That its paths are relative to.

    Raises:
        InputError: If a log cannot be read, or if no impact can be used, with all reasons.
    """
    if not plan.flights:
        raise InputError('flights: is missing: the logs to fit, as logs = ["flight.ulg"]')
    _, tables = base_scenario(plan, folder)
    flights = [_read_flight(plan, one, tables, folder) for one in plan.flights]
    if not any(flight.impacts for flight in flights):
        raise InputError(*(reason for flight in flights for reason in flight.refused))
    return flights


def _read_flight(
    plan: FitPlan, given: LoggedFlight, tables: dict[str, Any], folder: Path
) -> ReadFlight:
    changed = apply_overrides(tables, given.change)
    scenario = read_scenario(folder / plan.scenario, given.change)
    recordings = [_recording(folder / name, given) for name in given.logs]
    refuse_unused_axes(recordings, given.world, given.body)
    refuse_time_units(recordings)
    recordings = with_vehicle(recordings, given.track)
    refuse_clock_jumps(recordings)
    for log in recordings:
        refuse_units(log, max(scenario.start_state().arm_length, default=None))
    doubts = refuse_wrong_axes(recordings, given.world, given.body, goes_on=given.no_check)
    names = ", ".join(str(one.path) for one in recordings)
    found = find_impacts(recordings, drops=plan.experiment == "drop")
    wanted, refused = list[LogImpact](), list[str]()
    for time in given.at:
        near = [one for one in found if abs(one.touch - time) <= NEAR]
        if not near:
            known = ", ".join(f"{one.touch:.3f} s" for one in found) or "none"
            refused.append(f"{names}: has no impact at {time:g} s; found: {known}")
        wanted += near
    reasons = dict[str, list[str]]()
    for one in wanted if given.at else found:
        if one.refused:
            reasons.setdefault(one.refused, []).append(f"{one.touch:.3f} s")
    for why, times in reasons.items():
        many = "impacts" if len(times) > 1 else "impact"
        refused.append(f"{names}: {many} at {', '.join(times)}: {why}")
    if not found:
        refused.append(f"{names}: no impact was found; springback identify inspect tells more")
    used = [one for one in (wanted if given.at else found) if not one.refused]
    impacts = tuple(impact_window(plan, scenario, recordings, one) for one in used)
    warnings = (*damages(recordings), *doubts)
    if plan.sensors.accelerometer.low_pass is None:
        warnings += tuple(
            f"{one.path}: {hint}" for one in recordings for channel in one.of(SPECIFIC_FORCE)
            if (hint := untold_filter(channel))
        )  # fmt: skip
    return ReadFlight(scenario, changed, impacts, tuple(refused), warnings)


def _recording(path: Path, given: LoggedFlight) -> Recording:
    options = LogOptions(first=given.first, last=given.last, world=given.world, body=given.body)
    return log_or_flight(path, options)


def fields_of_plan(plan: FitPlan, scenario: Scenario) -> list[Unknown]:
    """Free and known fields of a plan.

    Raises:
        InputError: If one is no number of the scenario, or its uncertainty cannot be read.
    """
    for name in (*plan.free, *plan.known):
        if name.startswith("vehicle.body.mass") and _is_derived(scenario):
            table = "free" if name in plan.free else "known"
            raise InputError(
                f'{table}."{name}": follows from the parts of the body; give the uncertainty of '
                'theirs, such as "vehicle.body.parts.0.mass" = "+- 2 %"'
            )
    given = [
        name for name, text in (plan.free | plan.known).items()
        if name not in LISTS and text.strip() != EXACT
    ]  # fmt: skip
    refuse_twice(given)
    fields = [field_unknown(name, text, "free", scenario) for name, text in plan.free.items()]
    for name, text in plan.uncertainties().items():
        if name in LISTS:
            names = [f"{name}.{k}" for k in range(LISTS[name](scenario))]
        elif name in plan.known:
            names = [name]
        else:
            apart = any(one.startswith(f"{name}.") for one in given)
            names = _usually_known(scenario, name, apart=apart)
        fields += [
            field_unknown(one, text, "known", scenario) for one in names
            if one == name or not plan.is_given(one)
        ]  # fmt: skip
    return fields


def _is_derived(scenario: Scenario) -> bool:
    """True if mass and inertia of the body follow from parts, or from a model."""
    return bool(scenario.vehicle.body.parts or scenario.vehicle.body.model)


def _usually_known(scenario: Scenario, name: str, *, apart: bool) -> list[str]:
    """Names of a field that usually is uncertain, if it is above zero.

    Args:
        scenario: That has it.
        name: Of one number, or of a list that is one number of all arms unless they differ.
        apart: True if a plan has a number of one arm.
    """
    if name == "vehicle.body.mass" and _is_derived(scenario):
        return []
    value, each = number_of_all(scenario, tuple(name.split(".")))
    if len(set(each)) > 1 or (each and apart):
        return [f"{name}.{k}" for k, one in enumerate(each) if one > 0.0]
    return [name] if value is not None and value > 0.0 else []


def fit(
    plan: FitPlan,
    folder: str | Path = ".",
    *,
    progress: Progress = silent,
    tell: Tell = ignore_words,
) -> FitResult:
    """Fit a plan.

    Args:
        plan: From `springback.identification.settings.read_fit_plan`.
        folder: That its paths are relative to.
        progress: Called from time to time with the share done.
        tell: Called from time to time with what is being done, in words.

    Raises:
        InputError: If a log or the scenario cannot be used.
    """
    folder = Path(folder)
    tell("reading the logs")
    fields = scenario_with_fields(plan, folder)[2]
    flights = read_flights(plan, folder)
    problems = [
        ImpactProblem(plan, flight.scenario, flight.tables, fields, impact)
        for flight in flights for impact in flight.impacts
    ]  # fmt: skip
    for problem in problems:
        _check_arm_order(problem)
        check_chain(problem)
    fits = []
    for k, problem in enumerate(problems):
        part = stage(progress, k / len(problems), 1.0 / len(problems))
        fits.append(fit_impact(
            problem, starts=plan.starts, seed=plan.seed, progress=part,
            tell=_numbered(tell, k + 1, len(problems)),
        ))  # fmt: skip
        part(1.0)
    refused = [reason for flight in flights for reason in flight.refused]
    return result_of(plan, fits, refused, [text for flight in flights for text in flight.warnings])


def _numbered(tell: Tell, number: int, count: int) -> Tell:
    """Tells of an impact of several."""
    return (lambda doing: tell(f"{number} of {count}, {doing}")) if count > 1 else tell


def check_chain(problem: ImpactProblem) -> None:
    """Refuse what a sensor cannot have done to the samples that are there.

    Raises:
        InputError: If a range ends below a sample, or poses were smoothed above half their rate.
    """
    sensors = problem.plan.sensors
    for one in problem.readings:
        where = f"{problem.impact.name}: {one.name}"
        if one.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
            is_force = one.quantity == SPECIFIC_FORCE
            word, unit = ("accelerometer", "m/s^2") if is_force else ("gyroscope", "rad/s")
            full, most = problem.chain(one).full_scale, float(np.nanmax(np.abs(one.values)))
            if full is not None and most > BEYOND_RANGE * full:
                given = (sensors.accelerometer if is_force else sensors.gyroscope).full_scale
                key = f"sensors.{word}.full_scale" if given is not None else (
                    f"sensors.imu.{word}.full_scale of the scenario, as nothing else tells it"
                )  # fmt: skip
                raise InputError(
                    f"{key}: must be at least the largest sample of {where}, {most:.4g} {unit} "
                    f"(got {full:.4g} {unit})"
                )
        corner = sensors.motion_capture.smoothing
        if one.quantity == POSITION and corner is not None and len(one.times) > 3:
            half = 0.5 / float(np.median(np.diff(one.times)))
            if corner >= half:
                raise InputError(
                    f"sensors.motion_capture.smoothing: must be below half the rate of {where}, "
                    f"{half:.4g} Hz (got {corner:g} Hz)"
                )


def _check_arm_order(problem: ImpactProblem) -> None:
    """Refuse arm lengths that are plainly those of other arms.

    Raises:
        InputError: With the order in which they would be those that the scenario predicts.
    """
    window = problem.impact.of(ARM_LENGTH)
    given = problem.plan.sensors.arm_length.order
    if window is None or given or not 1 < window.values.shape[1] <= MOST_ORDERED:
        return
    told = problem.predictions(np.zeros(len(problem.unknowns)))[window.name]
    seen = np.nan_to_num(window.values[:, : told.shape[1]])
    here = float(((seen - told) ** 2).sum())
    orders = itertools.permutations(range(told.shape[1]))
    least, best = min((float(((seen - told[:, order]) ** 2).sum()), order) for order in orders)
    if least < PLAINLY * here and here > 0.0:
        raise InputError(
            f"{problem.impact.name}: {window.name}: its columns look like those of arms "
            f"{', '.join(str(k + 1) for k in best)} of vehicle.arms.directions: give "
            f"sensors.arm_length.order = {[k + 1 for k in best]}, or "
            f"{list(range(1, len(best) + 1))} if they are in order"
        )


def result_of(
    plan: FitPlan,
    fits: Sequence[ImpactFit],
    refused: Sequence[str] = (),
    warnings: Sequence[str] = (),
) -> FitResult:
    """What fits of impacts tell together.

    Args:
        plan: Of the fit.
        fits: Of all impacts.
        refused: Impacts that were not used, with the reason.
        warnings: What the logs say of their own frames and units.
    """
    estimates = field_estimates(fits, scatter=plan.scatter == "impact")
    tested = [one for fit_ in fits for one in misfits(fit_)]
    forces = force_sentences(fits, scatter=plan.scatter == "impact")
    filters = filter_sentences(fits, tested)
    said = [*warnings, *forces, *filters, *sentences(fits, estimates, tested)]
    return FitResult(
        plan, tuple(fits), tuple(estimates), tuple(tested), tuple(said), tuple(refused)
    )  # fmt: skip
