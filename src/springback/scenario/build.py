"""Build a flight from a scenario, which is checked while it is built."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from springback.contact.worlds import Own
from springback.kernels.memo import Build, plain_build
from springback.kernels.vectors import Vec
from springback.recovery.detector import NoDetector
from springback.scenario.avionics import (
    BuiltAvionics,
    CompiledDetector,
    CompiledEstimator,
    CompiledPilot,
    MakePilot,
    UserSensing,
    build_avionics,
    cascade_of,
)
from springback.scenario.checks import (
    blaming_the_clock,
    check_clock,
    check_start,
    check_start_beside,
    check_tables,
    check_without_pilot,
)
from springback.scenario.model import flight_model, start_state
from springback.scenario.tables import ScenarioTables, ThrustSettings
from springback.scenario.user.builders import PilotContext
from springback.scenario.user.obstacles import check_own_obstacles, own_names, own_obstacles
from springback.scenario.user.pilots import (
    AnyPilot,
    UserPilot,
    built_pilot,
    read_pilot,
)
from springback.scenario.user.sensing import SensingCode, built_sensing, read_sensing
from springback.scenario.user.trust import check_trusted
from springback.scenario.vehicles.thrusts import hover_thrusts, thrust_table
from springback.sensing.perfect import PerfectMemory, PerfectState
from springback.settings import problem
from springback.simulation.guided import PlainPilot
from springback.simulation.measuring.record import Model
from springback.simulation.onboard import Relay
from springback.simulation.thrusts import ThrustTable
from springback.user_code import UserCode
from springback.vehicle.state import State


def pilot_context(scenario: ScenarioTables, start: State) -> PilotContext:
    """What a pilot of the user's own is built from; ``start`` is the state at time 0."""
    s = scenario
    return PilotContext(s.vehicle, s.world.gravity, 1.0 / s.clock, start, s.sensors)


class UserParts(NamedTuple):
    """Parts of a flight that are the user's own code."""

    obstacles: tuple[Own, ...] = ()
    """Obstacles besides the scenario's walls, with their surfaces."""
    pilot: AnyPilot | UserPilot | None = None
    """Pilot in place of the paper's."""
    estimator: SensingCode | None = None
    """Estimator of the paper's pilot."""
    detector: SensingCode | None = None
    """Detector of the paper's pilot, beside its triggers."""


#: Keys that name an estimator and a detector.
_ESTIMATOR_AT, _DETECTOR_AT = "estimator.code", "recovery.detection.own.code"
#: No part of the user's own.
NO_PARTS = UserParts()


class ReadyFlight(NamedTuple):
    """A built flight; without a pilot it has no avionics."""

    seed: int
    model: Model
    start: State
    built_avionics: BuiltAvionics | None
    plain: PlainPilot | None = None
    """Pilot in plain Python, if such a one flies it; the avionics then have a `Relay`."""
    thrusts: ThrustTable | None = None
    """Thrusts over time, without a pilot."""
    compiled: tuple[CompiledPilot | CompiledEstimator | CompiledDetector, ...] = ()
    """Parts of the avionics that are the user's own."""
    obstacles: tuple[Own, ...] = ()
    """Obstacles that are the user's own, with their surfaces."""


def user_parts(
    scenario: ScenarioTables,
    own: Sequence[Own] = (),
    pilot: AnyPilot | None = None,
) -> UserParts:
    """The user's own parts of a flight, those that its scenario names included; runs their files.

    Args:
        scenario: Any.
        own: Obstacles besides the scenario's.
        pilot: Pilot in place of the scenario's.

    Raises:
        InputError: If a file cannot be used, or if the distance or the normal of an obstacle is
            wrong where the vehicle could touch it.
    """
    parts = named_parts(scenario)
    obstacles = (*parts.obstacles, *own)
    names = own_names(scenario.world, obstacles)
    check_own_obstacles(obstacles, Vec(*scenario.start.position), names)
    return parts._replace(obstacles=obstacles, pilot=parts.pilot if pilot is None else pilot)


def named_parts(scenario: ScenarioTables) -> UserParts:
    """The user's own parts that a scenario names, unchecked; runs their files.

    Raises:
        InputError: If a file cannot be used, or is in a folder that is not trusted.
    """
    named = dict(scenario.code)
    for path, word in named.items():
        check_trusted(word, path)
    pilot = None if scenario.pilot is None else _named_pilot(scenario.pilot)
    estimator = _named_sensing(named, _ESTIMATOR_AT, CompiledEstimator)
    detector = _named_sensing(named, _DETECTOR_AT, CompiledDetector)
    return UserParts(own_obstacles(scenario.world), pilot, estimator, detector)


def _named_pilot(given: UserCode) -> UserPilot:
    return UserPilot(given.code, read_pilot(given.code, builds=bool(given.parameters)))


def _named_sensing(
    named: Mapping[str, str], path: str, kind: type[CompiledEstimator] | type[CompiledDetector]
) -> SensingCode | None:
    return read_sensing(path, named[path], kind) if path in named else None


def build_flight(
    scenario: ScenarioTables,
    parts: UserParts = NO_PARTS,
    build: Build = plain_build,
    normals: Sequence[float] | None = None,
    advises: bool = True,
) -> ReadyFlight:
    """Check a scenario across its tables, and build its flight.

    Args:
        scenario: Tables validated one by one.
        parts: The user's own, from `user_parts`.
        build: Builder of the parts.
        normals: `normals_at_start` of its seed, if already known.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.

    Raises:
        The first problem, with its key.
    """
    s, pilot = scenario, parts.pilot
    check_tables(s, build)
    model = build(flight_model, s, parts.obstacles, build)
    start = start_state(s.start, s.vehicle, model, build)
    check_start(s, model, start)
    if parts.obstacles:
        names = own_names(s.world, parts.obstacles)
        check_start_beside(s, model, start, zip(names, parts.obstacles, strict=True))
    if s.reference is None and pilot is None:
        check_without_pilot(s)
        thrusts = thrust_table(s.thrust)
        return ReadyFlight(s.seed, model, start, None, thrusts=thrusts, obstacles=parts.obstacles)
    if isinstance(s.thrust, ThrustSettings):
        raise problem("must not be a table where a pilot flies, who commands it", "thrust")
    if pilot is not None and s.model.slider is not None:
        raise problem("cannot be given to a pilot: no pilot flies on a slider", "model.slider")
    check_clock(s)
    if s.reference is None and not any(model.thrust):
        model = model._replace(thrust=build(hover_thrusts, s.vehicle, s.world.gravity))
    with blaming_the_clock(s):
        chosen = _chosen_pilot(s, parts, start, model.thrust, advises)
        avionics = build_avionics(s, model, start, chosen.flown_by, normals, build)
    return ReadyFlight(
        s.seed, model, start, avionics, chosen.plain,
        compiled=chosen.compiled, obstacles=parts.obstacles,
    )  # fmt: skip


class _ChosenPilot(NamedTuple):
    """Pilot of a flight, and the user's own parts in it."""

    flown_by: CompiledPilot | MakePilot
    plain: PlainPilot | None = None
    compiled: tuple[CompiledPilot | CompiledEstimator | CompiledDetector, ...] = ()


def _chosen_pilot(
    scenario: ScenarioTables,
    parts: UserParts,
    start: State,
    thrust: tuple[float, ...],
    advises: bool,
) -> _ChosenPilot:
    """The user's own pilot or, with the user's own estimator and detector, the paper's."""
    s = scenario
    if parts.pilot is None:
        own = _user_sensing(s, parts, start)
        compiled = tuple(part for part in own if part is not None)
        return _ChosenPilot(partial(cascade_of, advises=advises, own=own), None, compiled)
    chosen = _built_pilot(s, parts.pilot, start)
    if isinstance(chosen, CompiledPilot):
        return _ChosenPilot(chosen, None, (chosen,))
    return _ChosenPilot(CompiledPilot(Relay(0.0), Relay(0.0)), chosen)


def _built_pilot(
    scenario: ScenarioTables, pilot: AnyPilot | UserPilot, start: State
) -> PlainPilot | CompiledPilot:
    """The user's own pilot, built for the vehicle and, if the scenario names it, its parameters."""
    context = pilot_context(scenario, start)
    if not isinstance(pilot, UserPilot):
        return built_pilot(pilot, context)
    assert scenario.pilot is not None  # that is how it was named
    return built_pilot(pilot.pilot, context, scenario.pilot.parameters, pilot.word)


def _user_sensing(scenario: ScenarioTables, parts: UserParts, start: State) -> UserSensing:
    """The user's own estimator and detector, built for the vehicle."""
    recovery, context = scenario.recovery, pilot_context(scenario, start)
    detector = None if recovery is None else recovery.detection.own
    given = {
        "estimator": (parts.estimator, scenario.estimator.parameters),
        "detector": (parts.detector, {} if detector is None else detector.parameters),
    }
    return UserSensing(**{
        name: None if code is None else built_sensing(code, context, parameters)
        for name, (code, parameters) in given.items()
    })  # fmt: skip


# -- stand-ins, for checks that do not run the user's files ---------------------------------------


def unread_parts(scenario: ScenarioTables, *, pilot: bool) -> UserParts:
    """Stand-ins for the user's own parts, which are never flown, but no obstacles.

    Args:
        scenario: Any.
        pilot: True if a pilot of the user's own flies.
    """
    named = dict(scenario.code)
    estimator = SensingCode("", "", CompiledEstimator, _no_estimator)
    detector = SensingCode("", "", CompiledDetector, _no_detector)
    return UserParts(
        (), no_pilot if pilot else None,
        estimator if _ESTIMATOR_AT in named else None,
        detector if _DETECTOR_AT in named else None,
    )  # fmt: skip


def no_pilot(time: float, measurement: Any, memory: Any) -> Any:
    """Stand-in for a pilot that is not known yet, in checks; it is never called."""
    raise NotImplementedError


def _no_estimator(context: PilotContext, **parameters: Any) -> CompiledEstimator:
    return CompiledEstimator(PerfectState(0.0), PerfectMemory(0.0))


def _no_detector(context: PilotContext, **parameters: Any) -> CompiledDetector:
    return CompiledDetector(NoDetector(), NoDetector())
