"""What a scenario puts aboard: sensors, estimator, controller, reference, rotors, weather."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from springback.control.cascade import Cascade, cascade_memory
from springback.control.demands import Demands, Limits, shortfalls
from springback.control.linear import warnings_for
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import CircleSettings, RunUpSettings
from springback.control.runup import reach
from springback.dynamics.gusts import Calm
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.recovery.pilot import Resilient, resilient_memory
from springback.recovery.referee import referee_at_start
from springback.sensing.clock import inside
from springback.sensing.estimation import EstimatorSettings, Rhythm
from springback.sensing.measurement import Estimate
from springback.sensing.sensors import Sensors, draws_of, noise_count, sensors_at_start
from springback.settings import problem
from springback.simulation.aboard import Cabin, Draw, Guidance, NoWitness, Relay
from springback.simulation.guided import NOBODY, cabin_of
from springback.simulation.record import Model
from springback.simulation.ticks import GUST_NOISE
from springback.vehicle.rotors import Propulsion
from springback.vehicle.state import Airframe, State

if TYPE_CHECKING:
    from springback.experiments.scenario import Scenario

#: Streams of a flight's luck beside that of its ticks (`springback.simulation.guided`).
TURN_ON = 2
#: Range of an accelerometer that has none [m/s²]; finite, as all numbers in kernels.
UNCLIPPED = 1e6


class OwnPilot(NamedTuple):
    """A pilot of the user's own that is compiled: its type is registered with `piloted`."""

    settings: Any  # a NamedTuple of floats
    memory: Any  # at the start; a tree of floats


class Board(NamedTuple):
    """What is aboard, and the normal numbers that it takes."""

    cabin: Cabin
    noise: tuple[Draw, ...]


@contextmanager
def _in_table(table: str) -> Iterator[None]:
    """Name the table of a scenario that a problem is in."""
    try:
        with inside(table):
            yield
    except InputError as error:
        raise problem("; ".join(error.problems), table) from None


def propulsion_of(scenario: Scenario) -> Propulsion:
    """Rotors of the vehicle; refused where there are none, or where they cannot lift it."""
    propulsion = scenario.vehicle.propulsion
    if propulsion is None:
        raise problem(
            "is missing: a vehicle that is flown by a pilot needs most_thrust at least",
            "vehicle.propulsion",
        )
    vehicle = scenario.true_vehicle()
    share = vehicle.mass * scenario.world.gravity / vehicle.arm_count
    sides = {"most_thrust": "more", "least_thrust": "less"} if share > 0.0 else {}
    for name, side in sides.items():
        given = getattr(propulsion, name)
        if (given <= share) if side == "more" else (given >= share):
            raise problem(
                f"must be {side} than {share:.4g} N, each rotor's share of the true weight, "
                f"payload and model_error included (got {given:g} N)",
                f"vehicle.propulsion.{name}",
            )
    return propulsion


def limits_of(scenario: Scenario) -> Limits:
    """What the vehicle can do, as its pilot believes."""
    rotors, count = propulsion_of(scenario).rotors(), scenario.vehicle.arm_count
    return Limits(
        mass=scenario.vehicle.mass,
        gravity=scenario.world.gravity,
        most_thrust=count * rotors.most,
        least_thrust=count * rotors.least,
        most_body_rate=scenario.control.rate_limit,
    )


def reference_of(scenario: Scenario, model: Model) -> Any:
    """Numbers of the reference.

    Raises:
        The problem of a reference that the vehicle cannot follow.
    """
    with _in_table("reference"):
        made = _made_reference(
            scenario.reference,
            limits_of(scenario),
            scenario.vehicle.airframe(),
            model.contact_point,
        )
        if isinstance(made, InputError):
            raise made
        return made


@functools.lru_cache(maxsize=64)  # some are optimised, and every scenario asks twice
def _made_reference(settings: Any, limits: Limits, airframe: Airframe, point: Any) -> Any:
    """Numbers of the reference, or the problem with it: finding that out takes longest."""
    try:
        return settings.reference(limits, lambda pitch: reach(airframe, point, pitch))
    except InputError as problem_of_it:
        return problem_of_it


def sensors_of(scenario: Scenario, flight: int) -> Sensors:
    """Numbers of the sensors, their turn-on biases drawn for one flight."""
    luck = np.random.SFC64(np.random.SeedSequence(scenario.seed, spawn_key=(flight, TURN_ON)))
    told = scenario.sensors
    if scenario.estimator.type == "perfect":
        told = told.model_copy(update={"reveal": True})
    with _in_table("sensors"):
        return told.sensors(1.0 / scenario.clock, scenario.vehicle, np.random.Generator(luck))


def _rhythm(scenario: Scenario) -> Rhythm:
    """The pace of the sensors, as the estimator must know it."""
    tick, s = 1.0 / scenario.clock, scenario.sensors
    return Rhythm(
        tick=tick,
        interval=tick if s.imu.perfect else 1.0 / s.imu.rate,
        pose_age=0.0 if s.motion_capture.perfect else s.motion_capture.delay,
        pose_interval=tick if s.motion_capture.perfect else 1.0 / s.motion_capture.rate,
    )


def _estimator_settings(scenario: Scenario) -> EstimatorSettings:
    """Settings of the estimator; where it stands on the robot it knows from the sensors."""
    given = scenario.estimator
    if "offset" in given.kalman.model_fields_set:
        return given
    kalman = given.kalman.model_copy(update={"offset": scenario.sensors.imu.offset})
    return given.model_copy(update={"kalman": kalman})


def _control_settings(scenario: Scenario) -> ControlSettings:
    """Settings of the controller; unless told, it feeds forward where the reference is a run-up."""
    given = scenario.control
    if given.feed_forward is not None:
        return given
    return given.model_copy(update={"feed_forward": isinstance(scenario.reference, RunUpSettings)})


def estimate_at(state: State) -> Estimate:
    """The exact estimate of a state."""
    return Estimate(state.position, state.attitude, state.velocity, state.angular_velocity)


def cascade_of(scenario: Scenario, model: Model, start: State) -> OwnPilot:
    """The pilot of the paper, and its memory at the start."""
    gravity, rotors = scenario.world.gravity, propulsion_of(scenario).rotors()
    settings, rhythm = _estimator_settings(scenario), _rhythm(scenario)
    with _in_table("estimator"):
        estimator = settings.estimator(rhythm, gravity)
    control = _control_settings(scenario)
    with _in_table("control"):
        schedule = control.schedule(scenario.clock)
    pilot = Cascade(
        airframe=scenario.vehicle.airframe(),
        lowest=rotors.least,
        highest=rotors.most,
        lift=control.lift_share * rotors.most * scenario.vehicle.arm_count,
        estimator=estimator,
        reference=reference_of(scenario, model),
        position=control.position_law(
            scenario.vehicle.mass, gravity, rotors.most * scenario.vehicle.arm_count
        ),
        attitude=control.attitude_law(),
        rate=control.rate_law(),
        schedule=schedule,
    )
    at = estimate_at(start)
    memory = cascade_memory(pilot, settings.memory(estimator, at), at, model.thrust)
    if scenario.recovery is None:
        return OwnPilot(pilot, memory)
    resilient = resilient_of(scenario, pilot)
    return OwnPilot(resilient, resilient_memory(resilient, memory))


def resilient_of(scenario: Scenario, cascade: Cascade) -> Resilient:
    """The pilot that recovers from collisions, around the one that flies."""
    told, vehicle, sensors = scenario.recovery, scenario.vehicle, scenario.sensors
    assert told is not None  # asked only of scenarios that recover
    rotors, tick, imu = propulsion_of(scenario).rotors(), 1.0 / scenario.clock, sensors.imu
    inertial = tick if imu.perfect else 1.0 / imu.rate
    hall = tick if sensors.hall.perfect else 1.0 / sensors.hall.rate
    compliant = vehicle.fastest_arm_rate() > 0.0
    with _in_table("recovery"):
        return Resilient(
            cascade=cascade,
            observer=told.wrench_observer(
                vehicle.mass, scenario.world.gravity, rotors.time_constant, tick, inertial
            ),
            detection=told.triggers(compliant, inertial, hall),
            look=told.looks(UNCLIPPED if imu.perfect else imu.accelerometer.full_scale),
            route=told.route(Vec(*scenario.start.position)),
        )


def board_of(
    scenario: Scenario,
    model: Model,
    start: State,
    *,
    flight: int = 0,
    pilot: OwnPilot | None = None,
    relay: bool = False,
) -> Board:
    """What is aboard before the first tick.

    Args:
        scenario: With a reference, or flown by a pilot of the user's own.
        model: Of the flight.
        start: State at time 0.
        flight: Its number in a campaign, for its luck.
        pilot: In place of the paper's.
        relay: The pilot is in plain Python, and sits outside.
    """
    sensors = sensors_of(scenario, flight)
    if relay:
        pilot = OwnPilot(Relay(0.0), model.thrust)
    flown_by = pilot or cascade_of(scenario, model, start)
    period = 1.0 / scenario.clock
    judged = isinstance(flown_by.settings, Resilient) and scenario.recovery is not None
    witness: Any = scenario.recovery.referee() if judged else NoWitness(0.0)  # type: ignore[union-attr]
    seen: Any = referee_at_start(start.position) if judged else NOBODY
    with _in_table("air"):
        weather = scenario.air.turbulence(period)
    guidance = Guidance(
        sensors=sensors,
        pilot=flown_by.settings,
        rotors=propulsion_of(scenario).rotors(),
        witness=witness,
        weather=weather,
        mean_wind=Vec(*scenario.air.wind),
        period=period,
    )
    remembered = sensors_at_start(sensors, start, scenario.world.gravity)
    arms = scenario.vehicle.arm_count
    cabin = cabin_of(
        guidance, remembered, flown_by.memory, model, start, noise_count(arms), scenario.seed, seen
    )
    gusts = Draw(GUST_NOISE, 0 if isinstance(weather, Calm) else 1)
    return Board(cabin, (*draws_of(sensors, arms), gusts))


#: Tables that only the pilot of the paper reads, and those that every pilot flies with.
_PAPERS = ("reference", "control", "estimator", "recovery")
_PILOTS = ("sensors", "clock", "seed")


def uneasy(scenario: Scenario, *, own: bool = False) -> list[str]:
    """What a user had better know before the flight: one sentence each.

    Args:
        scenario: To be flown.
        own: By a pilot of the user's own, who takes the place of the paper's.
    """
    given = scenario.model_fields_set
    if own:
        unread = [name for name in _PAPERS if name in given]
        return _unread(unread, "a pilot of your own flies, who is not told of it")
    if scenario.reference is None or scenario.vehicle.propulsion is None:
        unread = [name for name in (*_PAPERS[1:], *_PILOTS) if name in given]
        return _unread(unread, "no pilot flies without a [reference]")
    lag = scenario.vehicle.propulsion.time_constant
    gains = warnings_for(scenario.control, scenario.vehicle.mass, lag)
    return gains + _circle_shortfalls(scenario)


def _unread(names: list[str], why: str) -> list[str]:
    return [f"{name} is not used: {why}" for name in names]


def _circle_shortfalls(scenario: Scenario) -> list[str]:
    """What a circle at full speed asks for beyond the limits.

    The thrust leans inwards by atan(R ω²/g) and turns about the vertical with ω.
    """
    circle, limits = scenario.reference, limits_of(scenario)
    if not isinstance(circle, CircleSettings):
        return []
    rate = 2.0 * math.pi / circle.period
    inwards = circle.radius * rate**2
    thrust, tilt = math.hypot(inwards, limits.gravity), math.atan2(inwards, limits.gravity)
    asked = Demands(limits.mass * thrust, limits.mass * thrust, tilt, rate * math.sin(tilt))
    return shortfalls(asked, limits, "the circle")
