"""On-board systems, tick by tick: sensors, a pilot, an evaluator and rotors; and the weather.

They all run on a clock of equal ticks.  At each tick the sensors measure, the pilot decides and
the rotors follow; the equations of motion then carry the vehicle to the next tick with the mean
thrust of the rotors over it.  Sensors and pilots are functions of their type: a new one is a
NamedTuple of floats with `sensor_step` or `pilot_step` registered for it::

    class Bang(NamedTuple): ...

    @pilot_step.register(Bang)
    @kernel
    def _(pilot, time, measurement, memory):
        return PilotOutput(thrusts, memory)
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import compiler_rule, generic, kernel
from springback.kernels.trees import select
from springback.kernels.vectors import Vec
from springback.simulation.measuring.record import Contacts
from springback.vehicle.rotors import Lag, Rotors
from springback.vehicle.state import State


class Truth(NamedTuple):
    """True motion over the last tick, for sensors only."""

    before: State  # at the tick before
    now: State
    duration: float  # between the two [s]
    gravity: float  # g along −Z [m/s²]


class SensorStep(NamedTuple):
    """A measurement, and the memory of the sensors."""

    measurement: Any
    memory: Any


@generic
def sensor_step(
    sensors: Any, tick: float, truth: Truth, noise: tuple[float, ...], memory: Any
) -> SensorStep:
    """Measurement at a tick.

    Args:
        sensors: Settings of the sensors, a NamedTuple.
        tick: Number of the tick, from 0; a whole number.
        truth: True motion over the last tick.
        noise: Independent standard normal numbers, drawn for this tick; zeros for a device that
            draws none at this tick.
        memory: Memory of the sensors; a new one is returned, it is never changed in place.
    """
    raise TypeError(f"{type(sensors).__name__} is not a set of sensors; register sensor_step")


class Draw(NamedTuple):
    """Normal numbers of one device, drawn together."""

    channels: int
    every: int  # ticks from one draw to the next, the first at tick 0; 0: it draws none


class PilotOutput(NamedTuple):
    """Command and memory of a pilot, and the alarm of a detector in it."""

    thrust: tuple[float, ...]  # command to each rotor [N]
    memory: Any
    alarm: float = (
        0.0  # 1 while it reports a collision, else 0; an alarm is raised where it turns 1
    )


@generic
def pilot_step(pilot: Any, time: float, measurement: Any, memory: Any) -> PilotOutput:
    """Command of a pilot at a tick.

    Args:
        pilot: Settings of the pilot, a NamedTuple.
        time: Time since the start [s].
        measurement: Output of the sensors, `springback.sensing.measurement.Measurement`.
        memory: Memory of the pilot, which is never changed in place: a new one is returned.
    """
    raise TypeError(f"{type(pilot).__name__} is not a pilot; register pilot_step for it")


@generic
def telemetry_of(pilot: Any, memory: Any) -> Any:
    """Telemetry of a pilot at a tick, a tree of floats; a zero for pilots that register none."""
    return (0.0,)


@telemetry_of.register(object)
@kernel
def _no_telemetry(pilot: Any, memory: Any) -> Any:
    return (0.0,)


#: Time of an alarm that has not been raised yet.
NOT_YET = -1.0


class AlarmReport(NamedTuple):
    """Alarm that a pilot of the user's own reports."""

    alarm: float  # 1 while it reports a collision, else 0
    raised: float  # time at which it last turned 1 [s], `NOT_YET` before


class UserPilotMemory(NamedTuple):
    """Memory of a pilot of the user's own, and what it reports."""

    own: Any
    report: AlarmReport


def user_pilot_memory(own: Any) -> UserPilotMemory:
    """Memory before tick 0, given that of the pilot."""
    return UserPilotMemory(own, AlarmReport(0.0, NOT_YET))


class NoReport(NamedTuple):
    """Report of springback's own pilots, whose telemetry has their alarms."""


@generic
def own_memory(memory: Any) -> Any:
    """Memory of a pilot itself, without what is kept beside it."""
    return memory


@own_memory.register(object)
@kernel
def _whole_memory(memory: Any) -> Any:
    return memory


@own_memory.register(UserPilotMemory)
@kernel
def _memory_within(memory: UserPilotMemory) -> Any:
    return memory.own


@generic
def report_of(memory: Any) -> Any:
    """What a pilot of the user's own reports, from its memory; `NoReport` of others."""
    return NoReport()


@report_of.register(object)
@kernel
def _no_report(memory: Any) -> NoReport:
    return NoReport()


@report_of.register(UserPilotMemory)
@kernel
def _report(memory: UserPilotMemory) -> AlarmReport:
    return memory.report


@kernel
def report_after(alarm: float, time: float, before: AlarmReport) -> AlarmReport:
    """Report after a tick, given the pilot's alarm, the time [s] and the report before."""
    reports = alarm > 0.5
    rises = reports & (before.alarm < 0.5)
    return AlarmReport(select(reports, 1.0, 0.0), select(rises, time, before.raised))


def alarm_of(output: PilotOutput) -> float:
    """Alarm of an output; compiled code has none where the pilot left it out."""
    return output.alarm


@compiler_rule(alarm_of)
def _alarm_by_type(output: Any) -> Any:
    if len(output.types) == len(PilotOutput._fields):
        return lambda output: output.alarm
    return lambda output: 0.0


class NoEvaluator(NamedTuple):
    """No evaluator."""

    unused: float


@generic
def evaluator_step(
    evaluator: Any, time: float, state: State, contacts: Contacts, pilot: Any, memory: Any
) -> Any:
    """Memory of an evaluator after a tick.

    It knows the true state and the pilot's memory; no pilot can read it.

    Args:
        evaluator: Settings of the evaluator, a NamedTuple.
        time: Time since the start [s].
        state: True state of the vehicle.
        contacts: Contacts so far, from the record of the flight.
        pilot: Memory of the pilot after this tick.
        memory: Memory of the evaluator; a new one is returned, it is never changed in place.
    """
    raise TypeError(f"{type(evaluator).__name__} is not an evaluator; register evaluator_step")


class Relay(NamedTuple):
    """Stand-in for a pilot in plain Python, whose command and report are written from outside."""

    unused: float


class OnboardSystems(NamedTuple):
    """Settings of the avionics, constant over a flight."""

    sensors: Any
    pilot: Any
    rotors: Rotors
    lag: Lag  # of their thrust, over a tick
    stop: Any  # NoStop or RotorStop
    evaluator: Any  # NoEvaluator, or a type registered with evaluator_step
    weather: Any  # NoGusts or Dryden
    mean_wind: Vec  # world [m/s]
    period: float  # of the clock [s]


class OnboardState(NamedTuple):
    """State of the avionics, which changes from tick to tick."""

    before: State  # at the tick before
    measurement: Any
    sensors: Any  # their memory
    pilot: Any  # its memory
    command: tuple[float, ...]  # to each rotor [N]
    thrust: tuple[float, ...]  # of each rotor at the tick [N]
    stopped: tuple[float, ...]  # since when each stands; empty where hits do not stop them
    evaluator: Any  # its memory
    weather: Any  # its memory


class Avionics(NamedTuple):
    """Avionics of a flight: settings and state."""

    systems: OnboardSystems
    onboard: OnboardState
