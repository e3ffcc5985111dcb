"""Steps of two vehicles together: the same instants, the same lengths, the same forces.

The first vehicle meets the parts of the second as moving obstacles, and their contact is computed
there, once.  The second meets those of the first with a surface that does not push, so that it
knows when it is touched, and gets the opposite forces: momentum is kept to rounding.  At each stage
of a step the parts of each are where they are at that stage.
"""

from __future__ import annotations

from springback.dynamics.motion import Engaged, Rates
from springback.dynamics.touches import PartPush
from springback.kernels.compiler import executor, kernel
from springback.kernels.layout import Buffer, TreeLayout, read, row_of, write
from springback.kernels.trees import field_of
from springback.simulation.executor import (
    REACH,
    WEIGHT,
    TrajectoryLog,
    accept_step,
    add_rates,
    begin_step,
    handle_events,
    has_space,
    log_step,
    rates_within,
    stage_model,
    stage_state,
)
from springback.simulation.lanes import places
from springback.simulation.pair.parts import parts_of
from springback.simulation.record import ARRIVED, FLYING


@kernel
def _with_parts(shape: TreeLayout, b: Buffer, other: TreeLayout, o: Buffer, reach: float) -> None:
    """Write where the parts of the other vehicle are at a stage into the state of this one."""
    model = read(other.model, o, 0, 1, 0)
    state = stage_state(other, o, 1, 0, reach)
    row = places(shape, 1).motion + row_of(shape.motion.state, "bodies")
    write(parts_of(model.airframe, state), b, row, 1, 0)


@kernel
def _with_pushes(shape: TreeLayout, b: Buffer, pushes: tuple[PartPush, ...]) -> None:
    """Write the pushes of the first vehicle into the model of the second."""
    write(pushes, b, row_of(shape.model, "pushes"), 1, 0)


@executor(nogil=True)
def begin_both(
    first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer, log_a: TrajectoryLog,
    log_b: TrajectoryLog,
) -> None:  # fmt: skip
    """Begin a step of both vehicles: the shorter of both."""
    at, to = places(first, 1), places(second, 1)
    _with_parts(first, a, second, b, 0.0)
    _with_parts(second, b, first, a, 0.0)
    begin_step(first, a, 1)
    seen = read(first.seen, a, at.seen, 1, 0)
    _with_pushes(second, b, field_of(seen.bodies, "push"))
    begin_step(second, b, 1)
    h = a[at.step] if a[at.step] < b[to.step] else b[to.step]
    _shorten(first, a, h)
    _shorten(second, b, h)
    log_step(first, a, 1, log_a)
    log_step(second, b, 1, log_b)


@kernel
def _shorten(shape: TreeLayout, b: Buffer, h: float) -> None:
    """Make the step of a flight shorter, as if it had chosen so."""
    at, record = places(shape, 1), shape.record
    row = at.record + row_of(record, "contacts")
    contacts = read(record.contacts, b, row, 1, 0)
    if contacts.touching > 0.0:
        b[row + row_of(record.contacts, "duration")] += h - b[at.step]
    if h == 0.0 and b[at.step] > 0.0:
        b[at.record + row_of(record.stepping, "steps")] -= 1.0
    b[at.step] = h


@executor(nogil=True)
def stage_of_both(
    first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer, reach: float, weight: float
) -> None:
    """Add a Runge–Kutta stage of both vehicles."""
    _with_parts(first, a, second, b, reach)
    _with_parts(second, b, first, a, reach)
    known = _stage_rates(first, a, reach)
    _with_pushes(second, b, field_of(known.seen.bodies, "push"))
    pushed = _stage_rates(second, b, reach)
    add_rates(first, a, 1, 0, known.motion, weight)
    add_rates(second, b, 1, 0, pushed.motion, weight)


@kernel
def _stage_rates(shape: TreeLayout, b: Buffer, reach: float) -> Rates:
    at = places(shape, 1)
    model, state = stage_model(shape, b, 1, 0, reach), stage_state(shape, b, 1, 0, reach)
    engaged: Engaged = read(shape.record.contacts.engaged, b, at.engaged, 1, 0)
    return rates_within(model, state, b[at.phase], engaged)


@executor(nogil=True)
def end_both(first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer) -> None:
    """Take the step of both vehicles, and process their requests."""
    accept_step(first, a, 1, 0)
    accept_step(second, b, 1, 0)
    handle_events(first, a, 1)
    handle_events(second, b, 1)


@executor(nogil=True)
def advance_both(
    first: TreeLayout,
    a: Buffer,
    second: TreeLayout,
    b: Buffer,
    log_a: TrajectoryLog,
    log_b: TrajectoryLog,
    budget: int,
    early: float,
) -> int:
    """Advance two vehicles together until both have reached ``until``, or one has diverged.

    Args:
        first: Layout of the buffer of the first vehicle.
        a: Its buffer, one lane.
        second: As ``first``, of the second vehicle, whose model has `Pushes`.
        b: Its buffer.
        log_a: Trajectory of the first.
        log_b: Trajectory of the second.
        budget: Most steps to take.
        early: 1 leaves both flying when they reach ``until``, to be continued; 0 ends them.

    Returns:
        1 if they still fly.
    """
    row_a, row_b, clock = places(first, 1).status, places(second, 1).status, places(first, 1).record
    until = row_of(first.model, "timing")  # its first field
    while budget > 0 and a[row_a] == FLYING and b[row_b] == FLYING:
        if early > 0.0 and a[until] - a[clock] <= ARRIVED:
            return 0
        if not (has_space(log_a) and has_space(log_b)):
            break
        begin_both(first, a, second, b, log_a, log_b)
        for stage in range(1, 4):
            stage_of_both(first, a, second, b, REACH[stage], WEIGHT[stage])
        end_both(first, a, second, b)
        budget -= 1
    return 1 if a[row_a] == FLYING and b[row_b] == FLYING else 0
