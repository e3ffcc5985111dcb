"""The user's own pilots: read from a file, called with checks, tested before they are compiled."""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.scenario.avionics import CompiledPilot
from springback.scenario.code_files import error_place, error_words, read_object
from springback.scenario.user.builders import (
    CodeLabel,
    PilotContext,
    built_part,
    refuse_parameters,
    wrong_part,
)
from springback.scenario.user.laws import Law, home_of, law_of, source_text
from springback.simulation.guided import Command, PlainPilot
from springback.simulation.onboard import PilotOutput, pilot_step

#: No parameters of a builder.
NO_PARAMETERS: Mapping[str, Any] = MappingProxyType({})

# -- from a file ----------------------------------------------------------------------------------


#: Builds a pilot for a vehicle, and for the parameters that a scenario gives; written as a function
#: of one argument and these.
PilotBuilder = Callable[..., PlainPilot | CompiledPilot]
AnyPilot = PlainPilot | CompiledPilot | PilotBuilder


class UserPilot(NamedTuple):
    """A pilot that a scenario names: the scenario has its parameters."""

    word: str
    """``FILE.py:NAME``."""
    pilot: AnyPilot


#: What a builder must be, for errors.
_NEEDED = "must be a function of a PilotContext and its parameters that returns a pilot"


def read_pilot(word: str, *, builds: bool = False) -> AnyPilot:
    """Read a pilot from a Python file; that of a plain one is run again each time.

    So a plain pilot has no memory of earlier flights.

    Args:
        word: ``file.py:name``; the name is that of a function ``(time, measurement, memory) ->
            (thrusts, memory)``, of a `springback.scenario.avionics.CompiledPilot`, or of a
            function that returns either for a `PilotContext`.
        builds: True if it has parameters, as only builders have.

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
    if not (isinstance(pilot, CompiledPilot) or builds or is_builder(pilot)):
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
    """True if a pilot is built for each vehicle: a function of one argument, or of two.

    Other arguments have defaults; a plain pilot has three arguments.
    """
    if isinstance(pilot, CompiledPilot):
        return False
    try:
        parameters = inspect.signature(pilot).parameters.values()
    except (TypeError, ValueError):  # of a built-in function
        return False
    needed = [one for one in parameters if one.default is one.empty]
    return 1 <= len(needed) <= 2 and needed[0].kind in (
        inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD,
    )  # fmt: skip


def built_pilot(
    pilot: AnyPilot,
    context: PilotContext,
    parameters: Mapping[str, Any] = NO_PARAMETERS,
    word: str = "",
) -> PlainPilot | CompiledPilot:
    """A pilot, or what its builder returns for a vehicle and parameters.

    Args:
        pilot: Of either kind, or a builder.
        context: Argument of the builder.
        parameters: Further arguments by name; a function that is given any is a builder.
        word: ``FILE.py:NAME`` of the pilot, for errors.

    Raises:
        InputError: If the builder fails, does not take the parameters, or returns something else.
    """
    made: Any = pilot
    called = CodeLabel("pilot", word or getattr(pilot, "__name__", "the pilot"), _NEEDED)
    if isinstance(pilot, CompiledPilot) or not (parameters or is_builder(pilot)):
        refuse_parameters(called, parameters)
        return made  # type: ignore[no-any-return]  # a plain pilot, or a compiled one
    made = built_part(pilot, called, context, parameters)
    if not isinstance(made, CompiledPilot) and (not callable(made) or isinstance(made, type)):
        forms = "a function (time, measurement, memory) -> (thrusts, memory), or a CompiledPilot"
        raise wrong_part(pilot, forms, made)
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
    def asked(time: float, measurement: Any, memory: Any) -> tuple[Command, Any, float]:
        try:
            said: Any = pilot(time, measurement, memory)
        except (Exception, SystemExit) as error:
            place = error_place(error, file, line)
            raise InputError(f"{place}: {error_words(error)}, at {time:.6g} s") from error
        problem = wrong(said, rotors)
        if problem:
            raise InputError(f"{file}:{line}: the pilot {problem}, at {time:.6g} s")
        thrusts, memory, *alarm = said
        return tuple(float(thrust) for thrust in thrusts), memory, float(alarm[0] if alarm else 0.0)

    return asked


def wrong(said: Any, rotors: int) -> str:
    """Error in the output of a pilot, a sentence without its subject; empty if none."""
    if not isinstance(said, tuple) or len(said) not in (2, 3):
        what = "(thrusts, memory), or (thrusts, memory, alarm)"
        return f"must return {what} (got {source_text(said)})"
    commanded, _, *alarm = said
    if alarm and not (
        isinstance(alarm[0], int | float | np.number | np.bool_) and alarm[0] in (0, 1)
    ):
        return f"must return 1 or 0 as alarm (got {source_text(alarm[0])})"
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
    law = law_of(pilot_step, pilot, measurement, "a pilot")
    said = law.call()
    if not isinstance(said, PilotOutput):
        law.refuse(f"must return PilotOutput(thrusts, memory) (got {source_text(said)})")
    if problem := wrong(said, rotors):
        law.refuse(problem)
    law.check_output(said.thrust, "thrusts")
    law.check_output(said.alarm, "alarm")
    law.check_memory(pilot.memory, said.memory)
    return law
