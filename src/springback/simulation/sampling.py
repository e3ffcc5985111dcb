"""States of flights in lanes, without avionics, at given instants: the loop over them, compiled.

A step ends at each instant, as at a tick of sensors, so that nothing is interpolated.
"""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from springback.kernels.compiler import Origin, executor, user_executor, with_globals
from springback.kernels.layout import Buffer, TreeLayout
from springback.simulation.executor import TrajectoryLog, advance
from springback.simulation.flight import own_types, sources
from springback.simulation.measuring.record import FLYING, Model

_LOST = float("nan")


class Instants(NamedTuple):
    """When states are read, and what changes then."""

    times: Buffer  # [s], increasing, shape (instants,)
    thrusts: Buffer  # at them, linear between them [N], (instants, rotors); without rows: constant
    factors: Buffer  # of the thrusts of each flight, shape (groups, lanes)


class StateRows(NamedTuple):
    """First rows of what is read and written in a buffer."""

    until: int
    thrust: int
    ramp: int
    state: int
    width: int  # rows of the state
    status: int
    step: int


@executor(nogil=True)
def sample(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: TrajectoryLog,
    budget: int,
    instants: Instants,
    at: StateRows,
    seen: Buffer,
) -> None:
    """Fly some groups from instant to instant, and read their states.

    Args:
        shape: Layout of the buffers.
        buffers: One row for each group, shape (groups, rows x lanes).
        lanes: A tuple as long as a group is wide.
        log: Without rows.
        budget: Most steps of a call to `springback.simulation.executor.advance`.
        instants: When.
        at: Rows of the buffers.
        seen: Filled with states, shape (groups, instants, rows, lanes); NaN of flights that were
            lost.
    """
    w, rotors = len(lanes), instants.thrusts.shape[1]
    for k in range(len(instants.times)):
        time, flying = instants.times[k], 0
        if time > 0.0:
            flying = 1
            for group in range(buffers.shape[0]):
                b = buffers[group]
                for lane in range(w):
                    b[at.until * w + lane] = time
                    if k > 0 and len(instants.thrusts) > 0:
                        before, factor = instants.times[k - 1], instants.factors[group, lane]
                        b[at.ramp * w + lane] = before
                        for rotor in range(rotors):
                            begin, end = instants.thrusts[k - 1, rotor], instants.thrusts[k, rotor]
                            slope = (end - begin) / (time - before)
                            b[(at.thrust + rotor) * w + lane] = begin * factor
                            b[(at.ramp + 1 + rotor) * w + lane] = slope * factor
                        b[at.step * w + lane] = 0.0  # thrusts have a kink: no peak is interpolated
        while flying > 0:
            flying = advance(shape, buffers, lanes, log, budget, 1.0)
        for group in range(buffers.shape[0]):
            b = buffers[group]
            for lane in range(w):
                is_lost = b[at.status * w + lane] != FLYING
                for row in range(at.width):
                    value = b[(at.state + row) * w + lane]
                    seen[group, k, row, lane] = _LOST if is_lost else value


def sampler_for(model: Model) -> Any:
    """`sample` for a model: the package's, or compiled for a user's own types."""
    own = own_types(model)
    return _own_sampler(frozenset(own), sources(own)) if own else sample


@functools.cache
def _own_sampler(own: frozenset[type], files: Origin | None) -> Any:
    """`sample` for a user's own types."""
    plain = getattr(sample, "py_func", sample)
    inner = user_executor(getattr(advance, "py_func", advance), files, nogil=True)
    return user_executor(with_globals(plain, advance=inner), files, nogil=True)
