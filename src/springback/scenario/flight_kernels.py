"""Kernels of a flight, compiled by another process while this one reads the scenario.

A scene, or a hull, is searched by routines that are compiled when a scenario with one is read for
the first time, as its checks need them.  The flight's own kernels only name them: their types are
known before, and they take as long to compile.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from contextvars import ContextVar
from typing import Any

from springback.kernels.concurrent.compilation import compiled_meanwhile
from springback.kernels.layout import TreeLayout
from springback.kernels.routines import routines_deferred
from springback.scenario.checks import check_tables
from springback.scenario.model import flight_model, start_state
from springback.scenario.tables import ScenarioTables, UserShape
from springback.simulation.flight import SLICE, empty_log, flight_buffers, fly_to_end, shape_of
from springback.simulation.guided import fly_between_ticks
from springback.simulation.lanes import SplitFlight
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State

#: Ends the processes of the present context; None outside, or where one has been started.
_HELP: ContextVar[ExitStack | None] = ContextVar("_HELP", default=None)


@contextmanager
def flights_compiled_early() -> Iterator[None]:
    """Context in which the first scenario that is read is to be flown at once.

    Its flight is compiled by another process from `compile_early` on, until the context ends.
    """
    with ExitStack() as helpers:
        before = _HELP.set(helpers)
        try:
            yield
        finally:
            _HELP.reset(before)


def compile_early(scenario: ScenarioTables, *, guided: bool) -> None:
    """Let another process compile a flight, if this one has yet to compile routines for it.

    Args:
        scenario: Tables validated one by one.
        guided: True if a pilot will fly it.

    Raises:
        The first problem across its tables, with its key.
    """
    helpers, s = _HELP.get(), scenario
    own = any(isinstance(entry, UserShape) for entry in s.world.obstacles)
    if helpers is None or own or s.second is not None:
        return
    if guided and not s.vehicle.hulls:  # its pilot takes longest, and is compiled afterwards
        return
    check_tables(s)
    with routines_deferred() as missing:
        model = flight_model(s)
        start = start_state(s.start.model_copy(update={"touch_distance": None}), s.vehicle, model)
    if missing:
        part = fly_between_ticks if guided else fly_to_end
        helpers.enter_context(compiled_meanwhile(part, _arguments(model, start)))
        _HELP.set(None)


def _arguments(model: Model, start: State) -> tuple[Any, ...]:
    """Arguments of both parts for one flight: only their types matter."""
    shape = shape_of(model, start)
    buffers = flight_buffers(shape, [model], [start], 1)
    return TreeLayout(shape), buffers, SplitFlight(0), empty_log(), SLICE, 0.0
