"""Which impact to fly next: the one that tells most of what is free (Fisher information).

The likelihood of each candidate is that of a fit, with the scenario's sensors; its latents are
taken out, what is left is information about the fields, and tests are chosen one after another for
the smallest volume of uncertainty (D-optimal; Fedorov, Theory of Optimal Experiments, 1972).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError
from springback.identification.design.assumptions import (
    ImpactPoint,
    planned_assumptions,
)
from springback.identification.design.drops import (
    DropWindow,
    drop_candidates,
    planned_drop,
)
from springback.identification.estimates import NOT_LEARNED
from springback.identification.fits import scenario_with_fields
from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.initial_state import InitialState
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.noise import (
    ChannelNoise,
    filtered_noise,
    white_noise,
)
from springback.identification.observations.sensor_chain import ChannelChain, noise_covariances
from springback.identification.observations.windows import FLOORS, ImpactWindow
from springback.identification.sensitivity import (
    FieldSensitivity,
    field_sensitivities,
    reason_untold,
)
from springback.identification.settings import FitPlan
from springback.identification.solving.fitting import ImpactFit
from springback.identification.solving.least_squares import jacobians
from springback.identification.unknowns import Unknown
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    SPECIFIC_FORCE,
    Array,
    SensorChain,
)
from springback.progress import Progress, silent
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import Scenario, scenario_from

#: Time after touch that a test records [s] (chosen).
AFTER = 0.2
#: Factor by which an interval narrows for a test to be worth a sentence (chosen).
HELPS = 1.1
_HALF = float(scipy.stats.norm.ppf(0.975))


class CandidateExperiment(NamedTuple):
    """A test that could be flown."""

    name: str
    information: Array  # about the fields, in u, shape (fields, fields)
    told: tuple[FieldSensitivity, ...]  # of each field; empty if it cannot be flown
    problem: str  # why it cannot be flown; empty if it can
    likelihood: ImpactProblem | None = None
    jacobian: Array | None = None


class ChosenExperiment(NamedTuple):
    """A test that was chosen, and what is known after it."""

    name: str
    half_widths: tuple[float, ...]  # of 95 % intervals of the free fields, relative or SI
    gain: float  # of ln of the volume of uncertainty


class ExperimentPlan(NamedTuple):
    """Which tests to fly."""

    fields: tuple[Unknown, ...]  # free ones
    before: tuple[float, ...]  # half widths now
    alone: tuple[tuple[str, tuple[float, ...]], ...]  # of each candidate, half widths after it
    chosen: tuple[ChosenExperiment, ...]
    refused: tuple[tuple[str, str], ...]  # candidates that cannot be flown, and why
    untold: tuple[str, ...] = ()  # free fields that no candidate tells, and why
    assumed: tuple[str, ...] = ()  # fields taken as exact, and how far each moves the result

    @property
    def sentence(self) -> str:
        """What to fly next, and what it changes most."""
        if not self.chosen:
            return "no test can be flown: " + "; ".join(f"{a}: {b}" for a, b in self.refused)
        best = self.chosen[0]
        ratio = [b / a for a, b in zip(best.half_widths, self.before, strict=True)]
        k = int(np.argmax(ratio))
        field = self.fields[k]
        if ratio[k] < HELPS:
            return "no candidate tells more than is known already: fly others (candidates.others)"
        return (
            f"next best: {best.name}: {field.name} from ± {width_text(field, self.before[k])} to "
            f"± {width_text(field, best.half_widths[k])}"
        )


def width_text(field: Unknown, half_width: float) -> str:
    """Half a width in words."""
    if field.logarithmic:
        percent = 100.0 * half_width
        return f"{percent:.0f} %" if percent >= 99.5 else f"{percent:.2g} %"
    return f"{half_width:.2g} {field.unit}".strip()


def plan_experiments(
    plan: FitPlan,
    folder: str | Path = ".",
    *,
    fits: Sequence[ImpactFit] = (),
    progress: Progress = silent,
) -> ExperimentPlan:
    """Tests that tell most.

    Args:
        plan: Of the fit; its ``candidates`` are the candidates.
        folder: That its paths are relative to.
        fits: Of impacts that were flown already.
        progress: Called from time to time with the share done.

    Raises:
        InputError: If the scenario cannot be used.
    """
    scenario, tables, fields = scenario_with_fields(plan, Path(folder))
    given = _candidates(plan, scenario, tables)
    found = []
    for k, (name, change) in enumerate(given):
        found.append(_candidate(plan, tables, fields, name, change))
        progress((k + 1) / len(given))
    known = np.eye(len(fields)) + sum(
        (_told_by(fit, len(fields)) for fit in fits), np.zeros((len(fields), len(fields)))
    )
    free = np.array([one.role == "free" for one in fields])
    usable = [one for one in found if not one.problem]
    chosen: list[ChosenExperiment] = []
    flown = [ImpactPoint(fit.problem, fit.point, fit.jacobian) for fit in fits]
    total = known
    for _ in range(plan.candidates.count if usable else 0):
        volumes = [_volume(total + one.information, free) for one in usable]
        best = usable[int(np.argmin(volumes))]
        gain = _volume(total, free) - min(volumes)
        total = total + best.information
        chosen.append(ChosenExperiment(best.name, _half_widths(fields, total), gain))
        assert best.likelihood is not None
        assert best.jacobian is not None
        middle = np.zeros(len(best.likelihood.unknowns))
        flown.append(ImpactPoint(best.likelihood, middle, best.jacobian))
    alone = [(one.name, _half_widths(fields, known + one.information)) for one in usable]
    return ExperimentPlan(
        tuple(one for one in fields if one.role == "free"),
        _half_widths(fields, known),
        tuple(alone),
        tuple(chosen),
        tuple((one.name, one.problem) for one in found if one.problem),
        _untold(fields, usable, known, total, scenario),
        tuple(planned_assumptions(flown, total)) if chosen else (),
    )


def _untold(
    fields: Sequence[Unknown],
    usable: Sequence[CandidateExperiment],
    known: Array,
    total: Array,
    scenario: Scenario,
) -> tuple[str, ...]:
    """Free fields that are not told after all chosen tests either, by the reason."""
    found: dict[str, list[str]] = {}
    before, after = (np.diag(np.linalg.inv(one)) ** 0.5 for one in (known, total))
    for k, field in enumerate(fields):
        if field.role != "free" or not usable or after[k] < NOT_LEARNED * before[k]:
            continue
        most = max((one.told[k] for one in usable), key=lambda told: told.told)
        now, then = (
            width_text(field, _HALF * field.deviation * float(x[k])) for x in (before, after)
        )
        reason = reason_untold(field, most, scenario)
        found.setdefault(reason, []).append(f"{field.name} (± {now} now, ± {then} after all)")
    return tuple(f"no candidate tells {' and '.join(them)}: {why}" for why, them in found.items())


def _candidates(
    plan: FitPlan, scenario: Scenario, tables: dict[str, Any]
) -> list[tuple[str, list[str]]]:
    """Names and overrides of all candidates."""
    given, found = plan.candidates, list[tuple[str, list[str]]]()
    others = [(one.name, list(one.change)) for one in given.others]
    if plan.experiment == "drop":
        return [*drop_candidates(plan, scenario, tables), *others]
    velocity = np.array(scenario.start.velocity)
    speed = float(np.linalg.norm(velocity))
    if speed > 0.0:
        on_slider = scenario.model.slider is not None
        pitches, yaws = ((0.0,), (0.0,)) if on_slider else (given.pitches, given.yaws)
        for fast, pitch, yaw in itertools.product(given.speeds, pitches, yaws):
            turned = "" if on_slider else (
                f", pitch {math.degrees(pitch):g} deg, yaw {math.degrees(yaw):g} deg"
            )  # fmt: skip
            change = [f"start.velocity={(velocity * fast / speed).tolist()}"]
            if not on_slider:
                change += [f"start.pitch={pitch!r}", f"start.yaw={yaw!r}"]
            distance = fast * plan.window.before
            found.append((f"{fast:g} m/s{turned}", [*change, f"start.touch_distance={distance!r}"]))
    found += others
    if not found:
        raise InputError(
            "candidates: there is none: the scenario's start.velocity is zero, and "
            "candidates.others is empty"
        )
    return found


def _candidate(
    plan: FitPlan, tables: dict[str, Any], fields: Sequence[Unknown], name: str, change: list[str]
) -> CandidateExperiment:
    size = len(fields)
    try:
        changed = apply_overrides(tables, change)
        scenario = scenario_from(changed)
        drop = None
        if plan.experiment == "drop":
            drop = planned_drop(plan, scenario, changed, _after(plan))
        impact = planned_window(plan, scenario, name, drop)
        problem = ImpactProblem(plan, scenario, changed, fields, impact)
        middle = np.zeros(len(problem.unknowns))
        values = problem.predictions(middle)
        readings = tuple(one._replace(values=values[one.name]) for one in problem.readings)
        problem.readings = list(readings)
        _, [slopes] = jacobians(problem, middle[None], np.ones(len(middle), dtype=bool))
    except InputError as error:
        return CandidateExperiment(name, np.zeros((size, size)), (), "; ".join(error.problems))
    told = tuple(field_sensitivities(problem.unknowns, slopes, size))
    information = _about_fields(slopes.T @ slopes, size)
    return CandidateExperiment(name, information, told, "", problem, slopes)


def _about_fields(square: Array, size: int) -> Array:
    """Information about the fields, the latents taken out, without the fields' own priors."""
    fields, across, latents = square[:size, :size], square[:size, size:], square[size:, size:]
    told = fields - across @ np.linalg.solve(latents, across.T) - np.eye(size)
    return 0.5 * (told + told.T)


def _told_by(fit: ImpactFit, size: int) -> Array:
    return _about_fields(fit.jacobian.T @ fit.jacobian, size)


def _volume(information: Array, free: Any) -> float:
    """Logarithm of the volume of uncertainty of the free fields, the known ones taken out."""
    covariance = np.linalg.inv(information)[np.ix_(free, free)]
    return 0.5 * float(np.linalg.slogdet(covariance)[1])


def _half_widths(fields: Sequence[Unknown], information: Array) -> tuple[float, ...]:
    deviations = np.sqrt(np.diag(np.linalg.inv(information)))
    return tuple(
        float(_HALF * one.deviation * sigma)
        for one, sigma in zip(fields, deviations, strict=True) if one.role == "free"
    )  # fmt: skip


def _after(plan: FitPlan) -> float:
    """Time after touch that a test records [s]."""
    return AFTER if plan.window.after is None else plan.window.after + 0.05


def planned_window(
    plan: FitPlan, scenario: Scenario, name: str, drop: DropWindow | None = None
) -> ImpactWindow:
    """Readings, without values yet, that the scenario's sensors would make of a test.

    Args:
        plan: Of the fit.
        scenario: Of the test; it begins ``window.before`` before touch.
        name: Of the test.
        drop: Part of a drop that is used, for which the scenario begins where it is let go.
    """
    sensors, before = scenario.sensors, plan.window.before if drop is None else drop.before
    until = before + (_after(plan) if drop is None else drop.after)
    readings: list[ChannelWindow] = []

    def add(quantity: str, rate: float, noise: ChannelNoise, other: bool, width: int) -> None:
        times = np.arange(0.0, until, 1.0 / rate)
        starts = np.arange(len(times)) == 0
        values, chain = np.zeros((len(times), width)), SensorChain()
        readings.append(
            ChannelWindow(quantity, quantity, times, values, noise, starts, chain, other)
        )

    if "imu" in plan.candidates.sensors:
        imu = sensors.imu
        rate = scenario.clock if imu.perfect else imu.rate
        for quantity, part, planned in (
            (SPECIFIC_FORCE, imu.accelerometer, plan.sensors.accelerometer),
            (ANGULAR_VELOCITY, imu.gyroscope, plan.sensors.gyroscope),
        ):
            given = planned.noise
            deviation = part.noise * math.sqrt(0.5 * scenario.clock)
            share = -math.expm1(-2.0 * math.pi * part.bandwidth / scenario.clock)
            noise = _filtered_noise(deviation, share, FLOORS[quantity])
            own = None if imu.perfect else part.bandwidth
            chain = ChannelChain(None, planned.low_pass, None, planned.low_pass_order or 1, own)
            if (behind := noise_covariances(chain, rate)) is not None:
                noise = filtered_noise(max(deviation, FLOORS[quantity]), behind, 3)
            noise = noise if given is None else white_noise(given, 3)
            add(quantity, rate, noise, False, 3)
    if "motion-capture" in plan.candidates.sensors:
        capture, told = sensors.motion_capture, plan.sensors.motion_capture
        rate = scenario.clock if capture.perfect else capture.rate
        for quantity, noise_of, given, width in (
            (POSITION, capture.position_noise, told.noise, 3),
            (ATTITUDE, capture.attitude_noise, told.attitude_noise, 4),
        ):
            deviation = given or max(noise_of, FLOORS[quantity])
            add(quantity, rate, white_noise(deviation, 3), "imu" in plan.candidates.sensors, width)
    if "arm-length" in plan.candidates.sensors:
        deviation = plan.sensors.arm_length.noise or FLOORS[ARM_LENGTH]
        rate = scenario.clock if sensors.hall.perfect else sensors.hall.rate
        add(ARM_LENGTH, rate, white_noise(deviation, 1), False, scenario.vehicle.arm_count)
    state = scenario.start_state()
    guess = InitialState(
        np.array(state.position), np.array(state.velocity), np.array(state.attitude),
        np.array(state.angular_velocity), "motion-capture" in plan.candidates.sensors,
    )  # fmt: skip
    guess = guess if drop is None else drop.start
    uncertainty = plan.clocks.uncertainty
    return ImpactWindow(name, before, until, until, guess, tuple(readings), uncertainty, None)


def _filtered_noise(deviation: float, share: float, floor: float) -> ChannelNoise:
    """White noise of a converter behind a first-order low-pass, which is autoregressive."""
    inner = max(share * deviation, floor)
    stationary = inner / math.sqrt(1.0 - (1.0 - share) ** 2)
    return ChannelNoise(np.array([1.0 - share]), np.full(3, inner), np.full(3, stationary))
