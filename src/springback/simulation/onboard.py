"""What flies along: sensors, a pilot, rotors, and the weather around them, tick by tick.

Everything aboard lives on a clock of equal ticks.  At each tick the sensors look, the pilot
decides, the rotors follow, and the equations of motion carry the vehicle to the next tick with the
thrust that the rotors give on average.  The flight knows sensors and pilots only as functions of
their type; a new one is a NamedTuple of floats with `sensed` or `pilot_step` registered for it::

    class Bang(NamedTuple): ...

    @pilot_step.register(Bang)
    @kernel
    def _(pilot, time, measurement, memory):
        return Piloted(thrusts, memory)
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Vec
from springback.vehicle.rotors import Lag, Rotors
from springback.vehicle.state import State


class Truth(NamedTuple):
    """The motion over the last tick, for sensors only."""

    before: State  # at the tick before
    now: State
    duration: float  # between the two [s]
    gravity: float  # g along −Z [m/s²]


class Sensed(NamedTuple):
    """A measurement, and what the sensors remember."""

    measurement: Any
    memory: Any


@generic
def sensed(
    sensors: Any, tick: float, truth: Truth, noise: tuple[float, ...], memory: Any
) -> Sensed:
    """What the sensors say at a tick.

    Args:
        sensors: Settings of the sensors, a NamedTuple.
        tick: Number of the tick, from 0; a whole number.
        truth: The motion over the last tick.
        noise: Independent standard normal numbers, drawn for this tick; zeros for a device that
            takes none now.
        memory: What the sensors remember; returned anew, never changed in place.
    """
    raise TypeError(f"{type(sensors).__name__} is no set of sensors; register sensed for it")


class Draw(NamedTuple):
    """Normal numbers of one device, drawn together."""

    channels: int
    every: int  # ticks from one draw to the next, the first at tick 0; 0: it takes none


class PilotOutput(NamedTuple):
    """What a pilot commands, and what it remembers."""

    thrust: tuple[float, ...]  # command to each rotor [N]
    memory: Any


@generic
def pilot_step(pilot: Any, time: float, measurement: Any, memory: Any) -> PilotOutput:
    """What a pilot does at a tick.

    Args:
        pilot: Settings of the pilot, a NamedTuple.
        time: Since the start [s].
        measurement: What the sensors say, `springback.sensing.measurement.Measurement`.
        memory: What the pilot remembers; returned anew, never changed in place.
    """
    raise TypeError(f"{type(pilot).__name__} is no pilot; register pilot_step for it")


@generic
def telemetry_of(pilot: Any, memory: Any) -> Any:
    """A pilot's telemetry at a tick: a tree of floats, for people to look at.

    Pilots that are not registered tell nothing.
    """
    return (0.0,)


@telemetry_of.register(object)
@kernel
def _tells_nothing(pilot: Any, memory: Any) -> Any:
    return (0.0,)


class ContactReport(NamedTuple):
    """What a witness is told of contacts."""

    touching: float  # 1 while any cage touches
    contacts: float  # times that the vehicle came into contact
    last: float  # instant of the last touch, −1 before the first [s]
    ground: float  # instant at which a cage touched the ground, −1 if none did [s]


class NoEvaluator(NamedTuple):
    """Nobody looks on."""

    unused: float


@generic
def evaluated(
    evaluator: Any, time: float, state: State, touch: ContactReport, thought: Any, memory: Any
) -> Any:
    """What a witness remembers after a tick.

    A witness sees the truth and the pilot's memory, keeps account, and is seen by nobody: no pilot
    can read it.

    Args:
        evaluator: Settings of the witness, a NamedTuple.
        time: Since the start [s].
        state: Of the vehicle.
        touch: Contacts so far.
        thought: What the pilot remembers after this tick.
        memory: Of the witness; returned anew.
    """
    raise TypeError(f"{type(evaluator).__name__} is no witness; register witnessed for it")


@evaluated.register(NoEvaluator)
@kernel
def _nobody(
    evaluator: NoEvaluator,
    time: float,
    state: State,
    touch: ContactReport,
    thought: Any,
    memory: Any,
) -> Any:
    return memory


class Relay(NamedTuple):
    """A pilot that sits outside: plain Python puts its commands aboard, tick by tick."""

    unused: float


@pilot_step.register(Relay)
@kernel
def _relayed(pilot: Relay, time: float, measurement: Any, memory: Any) -> PilotOutput:
    return PilotOutput(memory, memory)


class OnboardSystems(NamedTuple):
    """Everything aboard that does not change during a flight."""

    sensors: Any
    pilot: Any
    rotors: Rotors
    lag: Lag  # of their thrust, over a tick
    evaluator: Any  # NoWitness, or a type registered with witnessed
    weather: Any  # Calm or Dryden
    mean_wind: Vec  # world [m/s]
    period: float  # of the clock [s]


class OnboardState(NamedTuple):
    """Everything aboard that changes from tick to tick."""

    before: State  # at the tick before
    measurement: Any
    sensors: Any  # what they remember
    pilot: Any  # what it remembers
    command: tuple[float, ...]  # to each rotor [N]
    thrust: tuple[float, ...]  # of each rotor at the tick [N]
    evaluator: Any  # what it remembers
    weather: Any  # what it remembers


class Avionics(NamedTuple):
    """What is aboard."""

    systems: OnboardSystems
    onboard: OnboardState
