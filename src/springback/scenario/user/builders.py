"""Functions of the user's own that build a part of a flight for a vehicle, with parameters."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.vectors import Vec
from springback.scenario.code_files import error_place, error_words
from springback.scenario.user.laws import home_of, source_text
from springback.sensing.parameters import SensorSettings
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import State


class PilotContext(NamedTuple):
    """The nominal vehicle, for which a function of your own builds a part of a flight.

    True mass and inertia, payload and model errors are not in it, as they are unknown on board.
    """

    vehicle: Vehicle
    gravity: float  # g along −Z [m/s²]
    period: float  # of the on-board clock [s]
    start: State  # at time 0
    sensors: SensorSettings  # rates, delays and ranges, as in data sheets


class CodeLabel(NamedTuple):
    """What errors say of code of the user's own."""

    table: str
    """Of the scenario that names it, such as ``estimator``."""
    word: str
    """``FILE.py:NAME``."""
    needed: str
    """What it must be, a sentence without its subject."""


def built_part(
    make: Callable[..., Any],
    called: CodeLabel,
    context: PilotContext,
    parameters: Mapping[str, Any],
) -> Any:
    """What a function of the user's own returns for a vehicle and parameters.

    Args:
        make: The function.
        called: What errors say of it.
        context: Its first argument.
        parameters: Further arguments by name: numbers, and triples, which become vectors.

    Raises:
        InputError: If it fails, or does not take them.
    """
    file, line = home_of(make)
    names = tuple(parameters)
    try:
        inspect.signature(make).bind(context, **parameters)
    except (TypeError, ValueError) as error:
        given = ", ".join(["a PilotContext", *names])
        name = called.word.rpartition(":")[2]
        raise InputError(
            f"{file}:{line}: {name} does not take {given} ({error}); it {called.needed}"
        ) from error

    def made(context: PilotContext, *values: Any) -> Any:
        vectors = (Vec(*value) if isinstance(value, tuple) else value for value in values)
        return make(context, **dict(zip(names, vectors, strict=True)))

    try:
        return traceable(made)(context, *parameters.values())
    except (Exception, SystemExit) as error:
        raise InputError(f"{error_place(error, file, line)}: {error_words(error)}") from error


def refuse_parameters(called: CodeLabel, parameters: Mapping[str, Any]) -> None:
    """Reject parameters for code that is no function of them."""
    if parameters:
        raise InputError(f"{called.table}.parameters: {called.word} is no function, and takes none")


def wrong_part(make: Callable[..., Any], what: str, built: Any) -> InputError:
    """Error of a builder that returns something else than it must."""
    file, line = home_of(make)
    return InputError(f"{file}:{line}: must return {what} (got {source_text(built)})")
