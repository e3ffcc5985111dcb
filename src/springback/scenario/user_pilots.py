"""The user's own pilots: read from a file, called with checks, tested before they are compiled."""

from __future__ import annotations

import functools
import hashlib
import importlib.util
import inspect
import math
import os
import re
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.kernels.compiler import CompilerError
from springback.scenario.avionics import CompiledPilot
from springback.simulation.guided import Command, PlainPilot
from springback.simulation.onboard import PilotOutput, pilot_step

#: Folder of the package: its frames are not the user's.
PACKAGE = str(Path(__file__).parents[1]) + os.sep


# -- from a file ----------------------------------------------------------------------------------


def read_pilot(word: str) -> PlainPilot | CompiledPilot:
    """Read a pilot from a Python file.

    Args:
        word: ``file.py:name``; the name is that of a function ``(time, measurement, memory) ->
            (thrusts, memory)`` or of a
            `springback.scenario.avionics.CompiledPilot`.

    Raises:
        InputError: If there is no such file or name, if it is not a pilot, or if the file fails.
    """
    file, _, name = word.rpartition(":")
    if not file or not name.isidentifier():
        raise InputError(f"{word!r} is not a pilot; write file.py:name")
    path = Path(file)
    if not path.is_file():
        raise InputError(f"{file}: there is no such file")
    module = _import_file(path.resolve(), file)
    if not hasattr(module, name):
        mine = [key for key, value in vars(module).items() if _is_pilot(value, module)]
        known = f"; there are: {', '.join(mine)}" if mine else ""
        raise InputError(f"{file}: has no {name!r}{known}")
    pilot = getattr(module, name)
    if not isinstance(pilot, CompiledPilot) and not callable(pilot):
        raise InputError(
            f"{file}: {name} must be a function (time, measurement, memory) -> (thrusts, memory), "
            f"or a CompiledPilot (got {pilot!r})"
        )
    chosen: PlainPilot | CompiledPilot = pilot
    return chosen


def _is_pilot(value: Any, module: ModuleType) -> bool:
    written = getattr(value, "__module__", None) == module.__name__
    a_function = callable(value) and getattr(value, "__name__", "_") != "_"
    a_function = a_function and not isinstance(value, type)
    return isinstance(value, CompiledPilot) or (written and a_function)


def _import_file(path: Path, shown: str) -> ModuleType:
    """Import a file as a module; its folder is searched for its imports.

    Its name depends on its path only, so that cached kernels find its types.
    """
    name = f"springback_pilot_{hashlib.sha256(str(path).encode()).hexdigest()[:8]}_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise InputError(f"{shown}: is not a Python file; its name must end in .py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    if str(path.parent) not in sys.path:
        sys.path.insert(0, str(path.parent))
    try:
        spec.loader.exec_module(module)
    except SyntaxError as error:
        raise InputError(f"{error.filename}:{error.lineno}: is not Python: {error.msg}") from error
    except SystemExit as error:
        raise InputError(
            f"{_place(error, str(path))}: leaves the program (sys.exit) when it is imported; put "
            'what it does as a script under if __name__ == "__main__":'
        ) from error
    except Exception as error:
        raise InputError(f"{_place(error, str(path))}: {_words(error)}") from error
    return module


# -- errors, in one line --------------------------------------------------------------------------


def _words(error: BaseException) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())


def _place(error: BaseException, file: str, line: int = 1) -> str:
    """File and line of an error: the last that is in a file, else the last of the user's.

    Args:
        error: Error that was raised.
        file: File of the user.
        line: Line of the called function, for an error that was raised before it was entered.
    """
    frames = traceback.extract_tb(error.__traceback__)
    mine = [frame for frame in frames if frame.filename == file]
    others = [frame for frame in frames if not frame.filename.startswith((PACKAGE, "<"))]
    if not mine and not others:  # it was not even entered: its signature is wrong
        return f"{file}:{line}"
    last = (mine or others)[-1]
    return f"{last.filename}:{last.lineno}"


def failure_place(error: BaseException) -> str:
    """File and line of an error that came from the user's own functions."""
    return _place(error, "")


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
            place = _place(error, file, line)
            raise InputError(f"{place}: {_words(error)}, at {time:.6g} s") from error
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
        raise InputError(f"{_place(error, file, line)}: {_words(error)}, at 0 s") from error
    where = f"{file}:{line}: the pilot"
    if not isinstance(said, PilotOutput):
        raise InputError(f"{where} must return Piloted(thrusts, memory) (got {source_text(said)})")
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
