"""The user's own pilots: read from a file, called with checks, tested before they are compiled."""

from __future__ import annotations

import functools
import inspect
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.kernels.compiler import CompilerError
from springback.kernels.tracing import traceable  # for batch set-up
from springback.scenario.avionics import CompiledPilot
from springback.scenario.code_files import PACKAGE, error_place, error_words, read_object
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
    file, line = _home(pilot)
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


def _home(pilot: Any) -> tuple[str, int]:
    """File and line of a pilot."""
    function = inspect.unwrap(getattr(pilot, "py_func", pilot))
    method = getattr(type(function), "__call__")  # noqa: B004, B009
    code = getattr(function, "__code__", None) or getattr(method, "__code__", None)
    return (code.co_filename, code.co_firstlineno) if code else (f"pilot {pilot!r}", 0)


# -- in plain Python ------------------------------------------------------------------------------


def guarded_pilot(pilot: PlainPilot, rotors: int) -> PlainPilot:
    """A plain pilot whose errors are reported in one line, with its file and line and the time.

    Args:
        pilot: ``(time, measurement, memory) -> (thrusts, memory)``.
        rotors: Number of thrusts that it must return.
    """
    file, line = _home(pilot)

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


def source_text(value: Any) -> str:
    """A value as Python source, on one line and not too long, for messages."""
    try:
        text = " ".join(repr(value).split())
    except Exception:  # in the user's own class
        text = f"a {type(value).__name__}"
    return text if len(text) <= 60 else f"{text[:57]}..."


# -- compiled -------------------------------------------------------------------------------------


def validate(pilot: CompiledPilot, measurement: Any, rotors: int) -> None:
    """Call a pilot that is to be compiled once, as plain Python.

    Its result must have the layout that the flight stores: compiled code does not check again.

    Raises:
        InputError: The error, with file and line if known.
    """
    _check_floats(pilot.settings, "settings")
    _check_floats(pilot.memory, "memory")
    law: Callable[..., Any] = pilot_step.dispatch(type(pilot.settings))
    file, line = _home(law)
    if file.startswith(PACKAGE) and not type(pilot.settings).__module__.startswith("springback."):
        raise InputError(
            f"{type(pilot.settings).__name__} is not a pilot yet: register pilot_step for it"
        )
    try:
        said = law(pilot.settings, 0.0, measurement, pilot.memory)
    except (Exception, SystemExit) as error:
        raise InputError(
            f"{error_place(error, file, line)}: {error_words(error)}, at 0 s"
        ) from error
    where = f"{file}:{line}: the pilot"
    if not isinstance(said, PilotOutput):
        raise InputError(
            f"{where} must return PilotOutput(thrusts, memory) (got {source_text(said)})"
        )
    if problem := wrong(said, rotors):
        raise InputError(f"{where} {problem}")
    _check_floats(said.thrust, f"{where}: thrusts")
    _check_floats(said.memory, f"{where}: memory")
    before, after = _layout(pilot.memory), _layout(said.memory)
    if before != after:
        raise InputError(f"{where} must return a memory like the first, {before} (got {after})")


def _check_floats(tree: Any, stem: str) -> None:
    """Reject anything but a tree of floats, and name the leaf."""
    if isinstance(tree, tuple):
        fields = getattr(tree, "_fields", [str(k) for k in range(1, len(tree) + 1)])
        for field, branch in zip(fields, tree, strict=True):
            _check_floats(branch, f"{stem}.{field}")
    elif not isinstance(tree, float):
        kind = type(tree).__name__
        hint = f"; write {float(tree)!r}" if isinstance(tree, int) else ""
        raise InputError(
            f"{stem} must be a float, or a NamedTuple or tuple of floats, to be compiled "
            f"(got {source_text(tree)}, {kind}){hint}"
        )


def _layout(tree: Any) -> str:
    """Types of a tree in words, such as ``Memory(float, Vec(float, float, float))``."""
    if not isinstance(tree, tuple):
        return "float"
    kind = type(tree).__name__ if hasattr(tree, "_fields") else ""
    return f"{kind}({', '.join(_layout(branch) for branch in tree)})"


@contextmanager
def in_words(pilot: CompiledPilot | None) -> Iterator[None]:
    """Report errors of the compiler in one line, with the place in the user's file."""
    try:
        yield
    except CompilerError as error:
        if pilot is None:
            raise
        text = re.sub(r"\x1b\[[0-9;]*m", "", str(error))
        file, line = _home(pilot_step.dispatch(type(pilot.settings)))
        # The compiler reports the innermost place and reason first.
        places = re.findall(rf"at {re.escape(file)} \((\d+)\)", text)
        messages = re.findall(r"\w+Error: (.+)", text) or text.strip().splitlines()
        reasons = [reason for reason in messages if not reason.startswith("Failed in ")] or messages
        at = places[0] if places else line
        raise InputError(f"{file}:{at}: cannot be compiled: {reasons[0].strip()}") from error
