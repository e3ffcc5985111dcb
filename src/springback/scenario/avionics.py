"""Avionics of a scenario: sensors, estimator, controller, reference, rotors, weather."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from springback.control.cascade import Cascade, CascadeMemory, cascade_memory
from springback.control.demands import Limits
from springback.control.parameters import ControlSettings, Schedule
from springback.control.reference_parameters import RunUpSettings
from springback.control.runup import reach
from springback.dynamics.air import AirSettings
from springback.dynamics.gusts import NoGusts, first_gust
from springback.errors import InputError
from springback.kernels.memo import Build, plain_build
from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.vectors import ZERO, Vec
from springback.random_streams import Purpose, stream
from springback.recovery.characterisation import Characterisation
from springback.recovery.detection import Detection
from springback.recovery.detector import NoDetector, detector_memory
from springback.recovery.evaluator import evaluator_at_start
from springback.recovery.parameters import RecoverySettings
from springback.recovery.pilot import RecoveryPilot, recovery_pilot_memory
from springback.recovery.state_machine import Route
from springback.recovery.wrench import Observer
from springback.scenario.model import thrust_problem, true_airframe
from springback.scenario.tables import ScenarioTables
from springback.sensing.clock import inside
from springback.sensing.estimation import EstimatorSettings, Rhythm
from springback.sensing.measurement import Estimate
from springback.sensing.parameters import BIASES, SensorSettings
from springback.sensing.sensors import Sensors, draws_of, noise_count, sensors_at_start
from springback.settings import problem
from springback.simulation.guided import (
    NO_EVALUATION,
    AvionicsMemory,
    avionics_at_start,
)
from springback.simulation.measuring.record import Model
from springback.simulation.onboard import Avionics, Draw, NoEvaluator, OnboardSystems
from springback.simulation.ticks import GUST_NOISE
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.settings import check_allocation
from springback.vehicle.propulsion import Propulsion
from springback.vehicle.rotors import Rotors, lag_over
from springback.vehicle.state import Airframe, State

#: Normal numbers that gusts take before the first tick.
FIRST_GUST_NOISE = 5
#: Range of an accelerometer without one [m/s²]; finite, as all numbers in kernels.
UNCLIPPED = 1e6


class CompiledPilot(NamedTuple):
    """A compiled pilot of your own: its type is registered with `pilot_step`."""

    settings: Any  # a NamedTuple of floats
    memory: Any  # at the start; a tree of floats


class CompiledEstimator(NamedTuple):
    """An estimator of your own: its type is registered with `estimator_step`."""

    settings: Any  # a NamedTuple of floats
    memory: Any  # at the start; a tree of floats


class CompiledDetector(NamedTuple):
    """A detector of your own: its type is registered with `detector_step`."""

    settings: Any  # a NamedTuple of floats
    memory: Any  # at the start; a tree of floats


class UserSensing(NamedTuple):
    """Estimator and detector of the user's own, built; None where there is none."""

    estimator: CompiledEstimator | None = None
    detector: CompiledDetector | None = None


NO_USER_SENSING = UserSensing()


class BuiltAvionics(NamedTuple):
    """Avionics, and the schedule of their noise."""

    avionics: Avionics
    noise: tuple[Draw, ...]


@contextmanager
def _in_table(table: str) -> Iterator[None]:
    """Name the table of a scenario in problems within it."""
    try:
        with inside(table):
            yield
    except InputError as error:
        raise problem("; ".join(error.problems), table) from None


def propulsion_of(scenario: ScenarioTables, airframe: Airframe | None = None) -> Propulsion:
    """Rotors of the vehicle; rejected if there are none, or if they cannot lift it.

    Args:
        scenario: Scenario to be flown.
        airframe: The true one, if already known.
    """
    propulsion = scenario.vehicle.propulsion
    if propulsion is None:
        raise problem(
            "is missing: a vehicle that is flown by a pilot needs max_thrust at least",
            "vehicle.propulsion",
        )
    s = scenario
    true = airframe or true_airframe(s.vehicle, s.model_error, s.payload)
    check_allocation(s.vehicle.rotors, s.vehicle.arms, propulsion.min_thrust)
    share = true.mass * scenario.world.gravity / s.vehicle.lift
    sides = {"max_thrust": "more", "min_thrust": "less"} if share > 0.0 else {}
    for name, side in sides.items():
        given = getattr(propulsion, name)
        if (given <= share) if side == "more" else (given >= share):
            raise thrust_problem(s, true.mass, name, side)
    return propulsion


class Devices(NamedTuple):
    """Sensors before they are turned on."""

    settings: SensorSettings
    sensors: Sensors
    noise: tuple[Draw, ...]


class NominalVehicle(NamedTuple):
    """A pilot's model of its vehicle."""

    airframe: Airframe
    mass: float  # [kg]
    rotors: Rotors
    max_thrust: float  # collective, as the next [N]
    min_thrust: float
    gravity: float  # g [m/s²]


def nominal_vehicle(
    vehicle: Vehicle, propulsion: Propulsion, gravity: float, build: Build = plain_build
) -> NominalVehicle:
    """A pilot's model of a vehicle."""
    airframe, rotors = build(Vehicle.airframe, vehicle), build(Propulsion.rotors, propulsion)
    most, least = vehicle.lift * rotors.most, vehicle.lift * rotors.least
    return NominalVehicle(airframe, vehicle.mass, rotors, most, least, gravity)


def limits_of(believed: NominalVehicle, rate_limit: float) -> Limits:
    """Limits of the vehicle in its pilot's model; the limit of its rate is in rad/s."""
    return Limits(
        mass=believed.mass,
        gravity=believed.gravity,
        max_thrust=believed.max_thrust,
        min_thrust=believed.min_thrust,
        max_body_rate=rate_limit,
    )


def reference_of(
    settings: Any,
    believed: NominalVehicle,
    rate_limit: float,
    point: Any,
    advises: bool = True,
) -> Any:
    """Build a reference.

    Args:
        settings: The table.
        believed: The pilot's model of the vehicle.
        rate_limit: Limit for roll and pitch [rad/s].
        point: Contact point of a cage.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.

    Raises:
        The problem of a reference that the vehicle cannot follow.
    """
    limits = limits_of(believed, rate_limit)
    ahead = 0.0
    if isinstance(settings, RunUpSettings):  # no other depends on it
        ahead = traceable(reach)(believed.airframe, point, settings.pitch, settings.yaw)
    with _in_table("reference"):
        given = tuple(settings.__dict__.items())
        return _build_reference(type(settings), given, limits, ahead, advises)


@traceable
def _build_reference(*given: Any) -> Any:
    """Reference of a table, or the problem with it."""
    made = _search_reference(*given)
    if isinstance(made, InputError):
        raise InputError(*made.problems, path=made.path)
    return made


@functools.lru_cache(maxsize=4096)  # flights often share a reference, and some are slow to find
def _search_reference(
    table: type[Any], given: tuple[Any, ...], limits: Limits, ahead: float, advises: bool
) -> Any:
    """Reference of a table, or the problem with it, which is slowest to find."""
    settings = table.model_construct(**dict(given))
    try:
        if isinstance(settings, RunUpSettings):
            return settings.run_up(limits, lambda pitch: ahead, advises).reference
        return settings.reference(limits, lambda pitch: ahead)
    except InputError as problem_of_it:
        return problem_of_it


def devices_of(
    sensors: SensorSettings, estimator: EstimatorSettings, tick: float, vehicle: Vehicle
) -> Devices:
    """Sensors, without what differs from flight to flight.

    They reveal the exact state to a perfect estimator.
    """
    settings = sensors
    if estimator.type == "perfect":
        settings = sensors.with_checked(reveal=True)
    with _in_table("sensors"):
        return Devices(settings, *_devices(settings, tick, vehicle))


@traceable
def _devices(
    settings: SensorSettings, tick: float, vehicle: Vehicle
) -> tuple[Sensors, tuple[Draw, ...]]:
    """Sensors, and the schedule of their noise."""
    devices = settings.devices(tick, vehicle)
    return devices, draws_of(devices, vehicle.arm_count)


def normals_at_start(seed: int, gusts: bool, flight: int = 0) -> list[float]:
    """Normal numbers for the turn-on biases of sensors, and for the first gust.

    Args:
        seed: Of the flight.
        gusts: True if it has gusts.
        flight: Its number in a campaign.
    """
    normals: list[float] = stream(seed, Purpose.TURN_ON, flight).standard_normal(BIASES).tolist()
    if gusts:
        normals += stream(seed, Purpose.GUST).standard_normal(FIRST_GUST_NOISE).tolist()
    return normals


def _rhythm(sensors: SensorSettings, tick: float) -> Rhythm:
    """Timing of the sensors, for the estimator."""
    s = sensors
    return Rhythm(
        tick=tick,
        interval=tick if s.imu.perfect else 1.0 / s.imu.rate,
        pose_age=0.0 if s.motion_capture.perfect else s.motion_capture.delay,
        pose_interval=tick if s.motion_capture.perfect else 1.0 / s.motion_capture.rate,
    )


def _estimator_settings(given: EstimatorSettings, sensors: SensorSettings) -> EstimatorSettings:
    """Settings of the estimator; its position on the robot is that of the sensor."""
    if "offset" in given.kalman.model_fields_set:
        return given
    kalman = given.kalman.with_checked(offset=sensors.imu.offset)
    return given.with_checked(kalman=kalman)


def _estimator(
    scenario: ScenarioTables, own: CompiledEstimator | None, tick: float, start: Estimate
) -> CompiledEstimator:
    """Estimator, and its memory at the start."""
    s = scenario
    if s.estimator.type == "own":
        if own is None:
            raise problem("was not read, so it cannot be flown", "estimator.code")
        return own
    settings = _estimator_settings(s.estimator, s.sensors)
    with _in_table("estimator"):
        build = traceable(EstimatorSettings.estimator)
        estimator = build(settings, _rhythm(s.sensors, tick), s.world.gravity)
    memory = traceable(EstimatorSettings.memory)(settings, estimator, start)
    return CompiledEstimator(estimator, memory)


def _control_settings(given: ControlSettings, reference: Any) -> ControlSettings:
    """Settings of the controller; by default, it feeds forward if the reference is a run-up."""
    if given.feed_forward is not None:
        return given
    return given.with_checked(feed_forward=isinstance(reference, RunUpSettings))


@traceable
def _schedule(control: ControlSettings, clock: float) -> Schedule:
    try:  # contexts cost more than schedules
        return control.schedule(clock)
    except PydanticCustomError:
        with _in_table("control"):
            raise


def estimate_at(state: State) -> Estimate:
    """The exact estimate of a state."""
    return Estimate(state.position, state.attitude, state.velocity, state.angular_velocity)


_position_law = traceable(ControlSettings.position_law)
_attitude_law = traceable(ControlSettings.attitude_law)
_rate_law = traceable(ControlSettings.rate_law)


def cascade_of(
    scenario: ScenarioTables,
    model: Model,
    start: State,
    build: Build = plain_build,
    advises: bool = True,
    own: UserSensing = NO_USER_SENSING,
) -> CompiledPilot:
    """The pilot of the paper, and its memory at the start.

    Args:
        scenario: With a reference.
        model: Model of the flight.
        start: State at time 0.
        build: Builder of the parts.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.
        own: Estimator and detector of the user's own, where the scenario names them.
    """
    s, gravity, tick, at = (
        scenario,
        scenario.world.gravity,
        1.0 / scenario.clock,
        estimate_at(start),
    )
    propulsion = propulsion_of(s, model.airframe)
    believed = nominal_vehicle(s.vehicle, propulsion, gravity, build)
    estimator = _estimator(s, own.estimator, tick, at)
    control = _control_settings(s.control, s.reference)
    schedule = _schedule(control, s.clock)
    point, most = model.contact_point, believed.max_thrust
    pilot = Cascade(
        airframe=believed.airframe,
        lowest=believed.rotors.least,
        highest=believed.rotors.most,
        lift=control.lift_share * most,
        estimator=estimator.settings,
        reference=reference_of(s.reference, believed, control.rate_limit, point, advises),
        position=_position_law(control, believed.mass, gravity, most),
        attitude=_attitude_law(control),
        rate=_rate_law(control),
        schedule=schedule,
    )
    memory = cascade_memory(pilot, estimator.memory, at, model.thrust)
    if s.recovery is None:
        return CompiledPilot(pilot, memory)
    return _recovery_pilot(s, pilot, memory, believed, own.detector)


class CollisionSensing(NamedTuple):
    """Detection and characterisation of collisions."""

    observer: Observer
    detection: Detection
    characterisation: Characterisation


@traceable
def collision_sensing(
    recovery: RecoverySettings,
    vehicle: Vehicle,
    sensors: SensorSettings,
    gravity: float,
    tick: float,
) -> CollisionSensing:
    """Build the detection and characterisation of collisions."""
    propulsion, imu = vehicle.propulsion, sensors.imu
    lag = propulsion.time_constant if propulsion else 0.0
    inertial = tick if imu.perfect else 1.0 / imu.rate
    hall = tick if sensors.hall.perfect else 1.0 / sensors.hall.rate
    is_compliant = vehicle.fastest_arm_rate() > 0.0
    full_scale = UNCLIPPED if imu.perfect else imu.accelerometer.full_scale
    with _in_table("recovery"):
        return CollisionSensing(
            recovery.wrench_observer(vehicle.mass, gravity, lag, tick, inertial),
            recovery.triggers(is_compliant, inertial, hall),
            recovery.collision_characterisation(full_scale),
        )


def _recovery_pilot(
    s: ScenarioTables,
    cascade: Cascade,
    memory: CascadeMemory,
    believed: NominalVehicle,
    detector: CompiledDetector | None,
) -> CompiledPilot:
    """The pilot that recovers from collisions, around the one that flies."""
    assert s.recovery is not None  # only called for scenarios with recovery
    recovery, tick = s.recovery.among(upright=s.is_upright), 1.0 / s.clock
    sensing = collision_sensing(recovery, s.vehicle, s.sensors, believed.gravity, tick)
    route: Route = recovery.route(ZERO)
    if recovery.home is None:
        route = route._replace(home=s.start.place())
    own: Any = NoDetector()
    remembered: Any = NoDetector()
    if recovery.detection.own is not None:
        if detector is None:
            raise problem("was not read, so it cannot be flown", "recovery.detection.own.code")
        own, remembered = detector.settings, detector_memory(detector.memory)
    pilot = RecoveryPilot(cascade, *sensing, route, own)
    return CompiledPilot(pilot, traceable(recovery_pilot_memory)(pilot, memory, remembered))


#: Builds the pilot of a scenario, model and start with a builder of its parts: `cascade_of`.
MakePilot = Callable[[ScenarioTables, Model, State, Build], CompiledPilot]


def build_avionics(
    scenario: ScenarioTables,
    model: Model,
    start: State,
    pilot: CompiledPilot | MakePilot = cascade_of,
    normals: Sequence[float] | None = None,
    build: Build = plain_build,
) -> BuiltAvionics:
    """Build the avionics as they are before the first tick.

    Args:
        scenario: With a reference, or flown by a pilot of the user's own.
        model: Model of the flight.
        start: State at time 0.
        pilot: Pilot, or the function that builds it.
        normals: `normals_at_start` of the flight; by default those of the scenario's seed.
        build: Builder of the parts.
    """
    s, arms, period = scenario, len(model.airframe.arms), 1.0 / scenario.clock
    devices = devices_of(s.sensors, s.estimator, period, s.vehicle)
    drawn = normals or normals_at_start(s.seed, s.air.gusts is not None)
    sensors = devices.settings.switched_on(devices.sensors, drawn[:BIASES])
    flown_by = pilot if isinstance(pilot, CompiledPilot) else pilot(s, model, start, build)
    air = _air_of(s.air, period)
    evaluator = _evaluator(s.recovery, flown_by.settings)
    judges = not isinstance(evaluator, NoEvaluator)
    seen: Any = evaluator_at_start(start.position) if judges else NO_EVALUATION
    propulsion = propulsion_of(s, model.airframe)
    rotors = build(Propulsion.rotors, propulsion)
    lag = traceable(lag_over)(rotors.time_constant, period)
    systems = OnboardSystems(
        sensors, flown_by.settings, rotors, lag, build(Propulsion.rotor_stop, propulsion, period),
        evaluator, air.weather, air.mean_wind, period,
    )  # fmt: skip
    remembered = traceable(sensors_at_start)(sensors, start, s.world.gravity)
    gusts = _first_gust(air.weather, tuple(drawn[BIASES:]))
    memory = AvionicsMemory(remembered, flown_by.memory, seen, gusts)
    avionics = avionics_at_start(systems, memory, model, start, noise_count(arms))
    return BuiltAvionics(avionics, (*devices.noise, air.noise))


def _evaluator(recovery: RecoverySettings | None, pilot: Any) -> Any:
    """Evaluator of a pilot; none for that of the paper where it does not recover."""
    if isinstance(pilot, Cascade):
        return NoEvaluator(0.0)
    settings = recovery or RecoverySettings()
    return settings.evaluator() if isinstance(pilot, RecoveryPilot) else settings.rest_evaluator()


@traceable
def _first_gust(weather: Any, normals: tuple[float, ...]) -> Any:
    """Memory of the gust before the first tick."""
    return first_gust(weather, normals).memory


class Atmosphere(NamedTuple):
    """The air around a vehicle with a pilot."""

    weather: Any
    mean_wind: Vec  # world [m/s]
    noise: Draw


def _air_of(air: AirSettings, tick: float) -> Atmosphere:
    with _in_table("air"):
        weather = air.turbulence(tick)
    noise = Draw(GUST_NOISE, 0 if isinstance(weather, NoGusts) else 1)
    return Atmosphere(weather, Vec(*air.wind), noise)
