"""What callers in Python hand over beside a scenario, checked before anything is flown."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, get_args

from springback.contact.obstacles import outward_normal, signed_distance
from springback.contact.parameters import Own, SurfaceSettings
from springback.errors import InputError
from springback.experiments.guidance import OwnPilot
from springback.experiments.pilots import read_pilot, shortened
from springback.simulation.flight import Executor
from springback.simulation.guided import PlainPilot


def check_executor(executor: str) -> None:
    """Refuse an executor that there is not.

    Raises:
        InputError: With the names of those that there are.
    """
    known = get_args(Executor)
    if executor not in known:
        names = " or ".join(map(repr, known))
        raise InputError(f"executor must be {names} (got {shortened(executor)})")


def chosen_pilot(pilot: Any) -> PlainPilot | OwnPilot | None:
    """The pilot that was asked for, read from its file if it is in one.

    Raises:
        InputError: If it is no pilot.
    """
    if isinstance(pilot, str):
        return read_pilot(pilot)
    if pilot is None or isinstance(pilot, OwnPilot):
        return pilot
    if isinstance(pilot, type) or not callable(pilot):
        raise InputError(
            "pilot must be a function (time, measurement, memory) -> (thrusts, memory), an "
            f"OwnPilot, or 'file.py:name' (got {shortened(pilot)})"
        )
    plain: PlainPilot = pilot
    return plain


def check_own(own: Sequence[Own]) -> None:
    """Refuse what is no pair of a shape, registered as an obstacle, and its surface.

    Raises:
        InputError: With the number of the entry, from 0.
    """
    if not isinstance(own, Sequence) or isinstance(own, str):
        raise InputError(f"own must be a list of pairs (shape, surface) (got {shortened(own)})")
    for k, entry in enumerate(own):
        if not isinstance(entry, tuple | list) or len(entry) != 2:
            raise InputError(f"own[{k}] must be a pair (shape, surface) (got {shortened(entry)})")
        shape, surface = entry
        for function, name in (
            (signed_distance, "signed_distance"),
            (outward_normal, "outward_normal"),
        ):
            if function.dispatch(type(shape)) is function.dispatch(object):
                raise InputError(
                    f"own[{k}]: {type(shape).__name__} is no obstacle yet: register {name} for it"
                )
        if not isinstance(surface, SurfaceSettings):
            raise InputError(
                f"own[{k}]: the surface must be a SurfaceSettings, such as springback.WALL "
                f"(got {shortened(surface)})"
            )
