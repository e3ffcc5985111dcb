"""The user's own pilots: read from a file, called with checks, tested before they are compiled."""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.kernels.tracing import traceable  # for batch set-up
from springback.scenario.avionics import CompiledPilot
from springback.scenario.code_files import error_place, error_words, read_object
from springback.scenario.user.laws import Law, home_of, law_of, source_text
from springback.sensing.parameters import SensorSettings
from springback.simulation.guided import Command, PlainPilot
from springback.simulation.onboard import PilotOutput, pilot_step
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import State

# -- from a file ----------------------------------------------------------------------------------


class PilotContext(NamedTuple):
    """What a pilot is built from, if its name is that of a function of this: the nominal vehicle.

    True mass and inertia, payload and model errors are not in it, as they are unknown on board.
    """

    vehicle: Vehicle
    gravity: float  # g along −Z [m/s²]
    period: float  # of the on-board clock [s]
    start: State  # at time 0
    sensors: SensorSettings  # rates, delays and ranges, as in data sheets


#: Builds a pilot for a vehicle; written as a function of one argument.
PilotBuilder = Callable[[PilotContext], PlainPilot | CompiledPilot]


AnyPilot = PlainPilot | CompiledPilot | PilotBuilder


def read_pilot(word: str) -> AnyPilot:
    """Read a pilot from a Python file; that of a plain one is run again each time.

    So a plain pilot has no memory of earlier flights.

    Args:
        word: ``file.py:name``; the name is that of a function ``(time, measurement, memory) ->
            (thrusts, memory)``, of a `springback.scenario.avionics.CompiledPilot`, or of a
            function that returns either for a `PilotContext`.

    Raises:
        InputError: If there is no such file or name, if it is not a pilot, or if the file fails.
    """
    pilot = read_object(word, "a pilot")
    if not isinstance(pilot, CompiledPilot) and (not callable(pilot) or isinstance(pilot, type)):
        file, _, name = word.rpartition(":")
        raise InputError(
            f"{file}: {name} must be a function (time, measurement, memory) -> (thrusts, memory), "
            f"or a CompiledPilot, or a function of a PilotContext that returns one (got "
            f"{source_text(pilot)})"
        )
    if not isinstance(pilot, CompiledPilot) and not is_builder(pilot):
        pilot = read_object(word, "a pilot", anew=True)
    chosen: AnyPilot = pilot
    return chosen


def chosen_pilot(pilot: Any) -> AnyPilot | None:
    """The requested pilot, read from its file if it is in one.

    Raises:
        InputError: If it is not a pilot.
    """
    if isinstance(pilot, str):
        return read_pilot(pilot)
    if pilot is None or isinstance(pilot, CompiledPilot):
        return pilot
    if isinstance(pilot, type) or not callable(pilot):
        raise InputError(
            "pilot must be a function (time, measurement, memory) -> (thrusts, memory), a "
            f"CompiledPilot, or 'file.py:name' (got {source_text(pilot)})"
        )
    plain: AnyPilot = pilot
    return plain


def is_builder(pilot: AnyPilot) -> bool:
    """True if a pilot is built for each vehicle: a function of one argument."""
    if isinstance(pilot, CompiledPilot):
        return False
    try:
        parameters = inspect.signature(pilot).parameters.values()
    except (TypeError, ValueError):  # of a built-in function
        return False
    needed = [one for one in parameters if one.default is one.empty]
    return len(needed) == 1 and needed[0].kind in (
        inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD,
    )  # fmt: skip


def built_pilot(pilot: AnyPilot, context: PilotContext) -> PlainPilot | CompiledPilot:
    """A pilot, or what its builder returns for a vehicle.

    Raises:
        InputError: If the builder fails, or returns something else.
    """
    made: Any = pilot
    if not is_builder(pilot):
        return made  # type: ignore[no-any-return]  # a plain pilot, or a compiled one
    file, line = home_of(pilot)
    try:
        made = traceable(made)(context)
    except (Exception, SystemExit) as error:
        raise InputError(f"{error_place(error, file, line)}: {error_words(error)}") from error
    if not isinstance(made, CompiledPilot) and (not callable(made) or isinstance(made, type)):
        raise InputError(
            f"{file}:{line}: must return a function (time, measurement, memory) -> (thrusts, "
            f"memory), or a CompiledPilot (got {source_text(made)})"
        )
    return made


# -- in plain Python ------------------------------------------------------------------------------


def guarded_pilot(pilot: PlainPilot, rotors: int) -> PlainPilot:
    """A plain pilot whose errors are reported in one line, with its file and line and the time.

    Args:
        pilot: ``(time, measurement, memory) -> (thrusts, memory)``.
        rotors: Number of thrusts that it must return.
    """
    file, line = home_of(pilot)

    @functools.wraps(pilot)
    def asked(time: float, measurement: Any, memory: Any) -> tuple[Command, Any]:
        try:
            said: Any = pilot(time, measurement, memory)
        except (Exception, SystemExit) as error:
            place = error_place(error, file, line)
            raise InputError(f"{place}: {error_words(error)}, at {time:.6g} s") from error
        problem = wrong(said, rotors)
        if problem:
            raise InputError(f"{file}:{line}: the pilot {problem}, at {time:.6g} s")
        return tuple(float(thrust) for thrust in said[0]), said[1]

    return asked


def wrong(said: Any, rotors: int) -> str:
    """Error in the command of a pilot, a sentence without its subject; empty if none."""
    if not isinstance(said, tuple) or len(said) != 2:
        return f"must return (thrusts, memory) (got {source_text(said)})"
    commanded = said[0]
    if isinstance(commanded, str | bytes | Mapping | Set) or not isinstance(commanded, Iterable):
        return f"must command a list or tuple of numbers in N (got {source_text(commanded)})"
    if isinstance(commanded, Iterator):  # it could be read only once
        return f"must command a list or tuple of numbers in N (got {source_text(commanded)})"
    try:
        if any(isinstance(thrust, str | bytes | bool | np.bool_) for thrust in commanded):
            return f"must command numbers in N (got {source_text(commanded)})"
        thrusts = [float(thrust) for thrust in commanded]
    except (TypeError, ValueError, OverflowError):
        return f"must command numbers in N (got {source_text(commanded)})"
    if len(thrusts) != rotors:
        return f"commands {len(thrusts)} thrusts for {rotors} rotors"
    for k, thrust in enumerate(thrusts, start=1):
        if not math.isfinite(thrust):
            return f"must command finite thrusts (got {thrust:g} N for rotor {k})"
    return ""


# -- compiled -------------------------------------------------------------------------------------


def check_compiled_pilot(pilot: CompiledPilot, measurement: Any, rotors: int) -> Law:
    """Call a pilot that is to be compiled once, as plain Python; returns its law.

    Its result must have the layout that the flight stores: compiled code does not check again.

    Raises:
        InputError: The error, with file and line if known.
    """
    law = law_of(pilot_step, pilot, "a pilot")
    said = law.call(pilot.settings, 0.0, measurement, pilot.memory)
    if not isinstance(said, PilotOutput):
        law.refuse(f"must return PilotOutput(thrusts, memory) (got {source_text(said)})")
    if problem := wrong(said, rotors):
        law.refuse(problem)
    law.check_output(said.thrust, "thrusts")
    law.check_memory(pilot.memory, said.memory)
    return law
