"""Checks of the arguments that Python callers pass besides a scenario."""

from __future__ import annotations

from typing import Any, get_args

from springback.errors import InputError
from springback.scenario.avionics import CompiledPilot
from springback.scenario.user_pilots import AnyPilot, read_pilot, source_text
from springback.simulation.flight import Executor


def check_executor(executor: str) -> None:
    """Reject an unknown executor.

    Raises:
        InputError: With the names of the known ones.
    """
    known = get_args(Executor)
    if executor not in known:
        names = " or ".join(map(repr, known))
        raise InputError(f"executor must be {names} (got {source_text(executor)})")


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
