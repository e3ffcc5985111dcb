"""Avionics of a scenario: sensors, estimator, controller, reference, rotors, weather."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from springback.control.cascade import Cascade, cascade_memory
from springback.control.demands import Demands, Limits, shortfalls
from springback.control.linear import warnings_for
from springback.control.parameters import ControlSettings, Schedule
from springback.control.reference_parameters import CircleSettings, RunUpSettings
from springback.control.runup import reach
from springback.dynamics.air import AirSettings
from springback.dynamics.gusts import NoGusts
from springback.errors import InputError
from springback.kernels.memo import FOREVER, Build, plain_build
from springback.kernels.vectors import ZERO, Vec
from springback.recovery.characterisation import Characterisation
from springback.recovery.detection import Detection
from springback.recovery.evaluator import evaluator_at_start
from springback.recovery.parameters import RecoverySettings
from springback.recovery.pilot import RecoveryPilot, recovery_pilot_memory
from springback.recovery.state_machine import Route
from springback.recovery.wrench import Observer
from springback.scenario.model import true_airframe
from springback.scenario.tables import ScenarioTables
from springback.sensing.clock import inside
from springback.sensing.estimation import EstimatorSettings, Rhythm
from springback.sensing.measurement import Estimate
from springback.sensing.parameters import BIASES, SensorSettings
from springback.sensing.sensors import Sensors, draws_of, noise_count, sensors_at_start
from springback.settings import problem
from springback.simulation.guided import NO_EVALUATION, AvionicsMemory, avionics_at_start
from springback.simulation.noise import Purpose, stream
from springback.simulation.onboard import Avionics, Draw, NoEvaluator, OnboardSystems
from springback.simulation.record import Model
from springback.simulation.ticks import GUST_NOISE
from springback.vehicle.parameters import Vehicle
from springback.vehicle.rotors import Propulsion, Rotors, lag_over
from springback.vehicle.state import Airframe, State

#: Range of an accelerometer without one [m/s²]; finite, as all numbers in kernels.
UNCLIPPED = 1e6


class CompiledPilot(NamedTuple):
    """A pilot of the user's own that is compiled: its type is registered with `pilot_step`."""

    settings: Any  # a NamedTuple of floats
    memory: Any  # at the start; a tree of floats


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
    share = true.mass * scenario.world.gravity / len(true.arms)
    sides = {"max_thrust": "more", "min_thrust": "less"} if share > 0.0 else {}
    for name, side in sides.items():
        given = getattr(propulsion, name)
        if (given <= share) if side == "more" else (given >= share):
            raise problem(
                f"must be {side} than {share:.4g} N, each rotor's share of the true weight, "
                f"payload and model_error included (got {given:g} N)",
                f"vehicle.propulsion.{name}",
            )
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
    max_thrust: float  # collective [N]
    gravity: float  # g [m/s²]


def nominal_vehicle(
    vehicle: Vehicle, propulsion: Propulsion, gravity: float, build: Build = plain_build
) -> NominalVehicle:
    """A pilot's model of a vehicle."""
    airframe, rotors = build(Vehicle.airframe, vehicle), build(Propulsion.rotors, propulsion)
    most = vehicle.arm_count * rotors.most
    return NominalVehicle(airframe, vehicle.mass, rotors, most, gravity)


def limits_of(believed: NominalVehicle, rate_limit: float) -> Limits:
    """Limits of the vehicle in its pilot's model; the limit of its rate is in rad/s."""
    return Limits(
        mass=believed.mass,
        gravity=believed.gravity,
        max_thrust=believed.max_thrust,
        min_thrust=len(believed.airframe.arms) * believed.rotors.least,
        max_body_rate=rate_limit,
    )


def reference_of(
    settings: Any,
    believed: NominalVehicle,
    rate_limit: float,
    point: Any,
    build: Build = plain_build,
    advises: bool = True,
) -> Any:
    """Build a reference.

    Args:
        settings: The table.
        believed: The pilot's model of the vehicle.
        rate_limit: Limit for roll and pitch [rad/s].
        point: Contact point of a cage.
        build: Builder of the parts.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.

    Raises:
        The problem of a reference that the vehicle cannot follow.
    """
    limits = build(limits_of, believed, rate_limit)
    made = build(_build_reference, settings, limits, believed.airframe, point, advises)
    if isinstance(made, InputError):
        with _in_table("reference"):
            raise made
    return made


def _build_reference(
    settings: Any, limits: Limits, airframe: Airframe, point: Any, advises: bool
) -> Any:
    """Reference, or the problem with it."""
    if isinstance(settings, RunUpSettings):
        return _build_run_up(settings, limits, reach(airframe, point, settings.pitch), advises)
    return _build_other(settings, limits)


@functools.lru_cache(maxsize=4096)  # used twice per scenario; many vehicles reach equally far
def _build_run_up(settings: RunUpSettings, limits: Limits, ahead: float, advises: bool) -> Any:
    """Reference of a run-up, or the problem with it, which is slowest to find."""
    try:
        return settings.run_up(limits, lambda pitch: ahead, advises).reference
    except InputError as problem_of_it:
        return problem_of_it


@functools.lru_cache(maxsize=64)  # some are optimised, and every scenario asks twice
def _build_other(settings: Any, limits: Limits) -> Any:
    """Reference other than a run-up, or the problem with it."""
    try:
        return settings.reference(limits, lambda pitch: 0.0)  # only run-ups depend on the reach
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
        devices = settings.devices(tick, vehicle)
    return Devices(settings, devices, draws_of(devices, vehicle.arm_count))


def turn_on_normals(seeds: Sequence[int], flight: int = 0) -> list[list[float]]:
    """Normal numbers for the turn-on biases of sensors, for many flights.

    Args:
        seeds: One for each flight.
        flight: Number of the flight in a campaign.
    """
    streams = (stream(seed, Purpose.TURN_ON, flight) for seed in seeds)
    return [one.standard_normal(BIASES).tolist() for one in streams]


def _tick(clock: float) -> float:
    return 1.0 / clock


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
    given: EstimatorSettings, sensors: SensorSettings, tick: float, gravity: float
) -> tuple[EstimatorSettings, Any]:
    """Settings of the estimator, and the estimator built from them."""
    settings = _estimator_settings(given, sensors)
    with _in_table("estimator"):
        return settings, settings.estimator(_rhythm(sensors, tick), gravity)


def _control_settings(given: ControlSettings, reference: Any) -> ControlSettings:
    """Settings of the controller; by default, it feeds forward if the reference is a run-up."""
    if given.feed_forward is not None:
        return given
    return given.with_checked(feed_forward=isinstance(reference, RunUpSettings))


def _schedule(control: ControlSettings, clock: float) -> Schedule:
    try:  # contexts cost more than schedules
        return control.schedule(clock)
    except PydanticCustomError:
        with _in_table("control"):
            raise


def estimate_at(state: State) -> Estimate:
    """The exact estimate of a state."""
    return Estimate(state.position, state.attitude, state.velocity, state.angular_velocity)


def cascade_of(
    scenario: ScenarioTables,
    model: Model,
    start: State,
    build: Build = plain_build,
    advises: bool = True,
) -> CompiledPilot:
    """The pilot of the paper, and its memory at the start."""
    s, gravity, tick = scenario, scenario.world.gravity, build(_tick, scenario.clock)
    propulsion = propulsion_of(s, model.airframe)
    believed = build(nominal_vehicle, s.vehicle, propulsion, gravity, build)
    settings, estimator = build(_estimator, s.estimator, s.sensors, tick, gravity)
    control = build(_control_settings, s.control, s.reference, place=FOREVER)
    schedule = build(_schedule, control, s.clock)
    point, most = model.contact_point, believed.max_thrust
    pilot = Cascade(
        airframe=believed.airframe,
        lowest=believed.rotors.least,
        highest=believed.rotors.most,
        lift=control.lift_share * most,
        estimator=estimator,
        reference=reference_of(s.reference, believed, control.rate_limit, point, build, advises),
        position=build(ControlSettings.position_law, control, believed.mass, gravity, most),
        attitude=build(ControlSettings.attitude_law, control),
        rate=build(ControlSettings.rate_law, control),
        schedule=schedule,
    )
    at = estimate_at(start)
    memory = cascade_memory(pilot, settings.memory(estimator, at), at, model.thrust, build)
    if s.recovery is None:
        return CompiledPilot(pilot, memory)
    resilient = recovery_pilot(s, pilot, believed, build)
    return CompiledPilot(resilient, recovery_pilot_memory(resilient, memory, build))


class CollisionSensing(NamedTuple):
    """Detection and characterisation of collisions."""

    observer: Observer
    detection: Detection
    look: Characterisation


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
            recovery.looks(full_scale),
        )


def recovery_pilot(
    scenario: ScenarioTables, cascade: Cascade, believed: NominalVehicle, build: Build = plain_build
) -> RecoveryPilot:
    """The pilot that recovers from collisions, around the one that flies."""
    s, recovery, tick = scenario, scenario.recovery, build(_tick, scenario.clock)
    assert recovery is not None  # only called for scenarios with recovery
    eyes = build(collision_sensing, recovery, s.vehicle, s.sensors, believed.gravity, tick)
    route: Route = build(RecoverySettings.route, recovery, ZERO)
    if recovery.home is None:
        route = route._replace(home=Vec(*s.start.position))
    return RecoveryPilot(cascade, *eyes, route)


#: Builds the pilot of a scenario, model and start with a builder of its parts: `cascade_of`.
MakePilot = Callable[[ScenarioTables, Model, State, Build], CompiledPilot]


def build_avionics(
    scenario: ScenarioTables,
    model: Model,
    start: State,
    pilot: CompiledPilot | MakePilot = cascade_of,
    biases: Sequence[float] | None = None,
    build: Build = plain_build,
) -> BuiltAvionics:
    """Build the avionics as they are before the first tick.

    Args:
        scenario: With a reference, or flown by a pilot of the user's own.
        model: Model of the flight.
        start: State at time 0.
        pilot: Pilot, or the function that builds it.
        biases: `turn_on_normals` of the flight; by default those of the scenario's seed.
        build: Builder of the parts.
    """
    s, arms, period = scenario, len(model.airframe.arms), build(_tick, scenario.clock)
    devices = build(devices_of, s.sensors, s.estimator, period, s.vehicle)
    drawn = turn_on_normals([s.seed])[0] if biases is None else biases
    sensors = devices.settings.switched_on(devices.sensors, drawn)
    flown_by = pilot if isinstance(pilot, CompiledPilot) else pilot(s, model, start, build)
    air = build(_air_of, s.air, period)
    judged = isinstance(flown_by.settings, RecoveryPilot) and s.recovery is not None
    evaluator: Any = build(RecoverySettings.evaluator, s.recovery) if judged else NoEvaluator(0.0)
    seen: Any = evaluator_at_start(start.position) if judged else NO_EVALUATION
    rotors = build(Propulsion.rotors, propulsion_of(s, model.airframe))
    systems = OnboardSystems(
        sensors=sensors,
        pilot=flown_by.settings,
        rotors=rotors,
        lag=build(lag_over, rotors.time_constant, period),
        evaluator=evaluator,
        weather=air.weather,
        mean_wind=air.mean_wind,
        period=period,
    )
    remembered = sensors_at_start(sensors, start, s.world.gravity, build)
    memory = AvionicsMemory(remembered, flown_by.memory, seen)
    avionics = avionics_at_start(systems, memory, model, start, noise_count(arms), s.seed)
    return BuiltAvionics(avionics, (*devices.noise, air.noise))


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


#: Tables that only the pilot of the paper reads, and those that apply to every pilot.
_PAPERS = ("reference", "control", "estimator", "recovery")
_PILOTS = ("sensors", "clock", "seed")


def scenario_warnings(scenario: ScenarioTables, *, own: bool = False) -> list[str]:
    """Warnings for this scenario, one sentence each.

    Args:
        scenario: Scenario to be flown.
        own: True if a pilot of the user's own flies it.
    """
    given = scenario.model_fields_set
    if own:
        unread = [name for name in _PAPERS if name in given]
        return _unread(unread, "a pilot of your own flies, which does not read it")
    if scenario.reference is None or scenario.vehicle.propulsion is None:
        unread = [name for name in (*_PAPERS[1:], *_PILOTS) if name in given]
        return _unread(unread, "no pilot flies without a [reference]")
    lag = scenario.vehicle.propulsion.time_constant
    gains = warnings_for(scenario.control, scenario.vehicle.mass, lag)
    return gains + _circle_shortfalls(scenario)


def _unread(names: list[str], why: str) -> list[str]:
    return [f"{name} is not used: {why}" for name in names]


def _circle_shortfalls(scenario: ScenarioTables) -> list[str]:
    """Demands of a circle at full speed beyond the limits.

    The thrust tilts inwards by atan(R ω²/g) and turns about the vertical with ω.
    """
    circle = scenario.reference
    if not isinstance(circle, CircleSettings):
        return []
    believed = nominal_vehicle(scenario.vehicle, propulsion_of(scenario), scenario.world.gravity)
    limits = limits_of(believed, scenario.control.rate_limit)
    rate = 2.0 * math.pi / circle.period
    inwards = circle.radius * rate**2
    thrust, tilt = math.hypot(inwards, limits.gravity), math.atan2(inwards, limits.gravity)
    asked = Demands(limits.mass * thrust, limits.mass * thrust, tilt, rate * math.sin(tilt))
    return shortfalls(asked, limits, "the circle")
