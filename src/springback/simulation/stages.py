"""Stages of a Runge–Kutta step, of many flights in lanes or of one.

Lanes are flown by one of two kinds of code: with the hull of the main body where it acts, and
without where it does not, which is quicker.  Compiling both takes a sixth longer; a single flight
always computes the hull, so that its first result is there sooner.  For the same reason its physics
is one function, `find_rates`, called at all four stages; in lanes each is compiled for its stage.
Of a `SplitFlight` it is an entry point of its own, `rates_apart`, known by its address: it is
compiled while another process compiles the loop over steps.
"""

from __future__ import annotations

from typing import Any

from springback.dynamics.limbs.shell import or_turns
from springback.dynamics.motion import Engaged, Motion, Rates, all_engaged, rates_while
from springback.kernels.compiler import (
    code_address,
    compiler_rule,
    executor,
    generic,
    kernel,
    step_kernel,
)
from springback.kernels.layout import Buffer, TreeLayout, read, rows, write
from springback.kernels.routines import run_at
from springback.kernels.trees import axpy, fold, replace, select
from springback.simulation.lanes import SingleFlight, SplitFlight, places
from springback.simulation.measuring.record import Model
from springback.simulation.thrusts import model_at
from springback.vehicle.state import State

# Classical Runge–Kutta, x + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄): stage i is taken at x + REACH[i] h kᵢ₋₁.
REACH = (0.0, 0.5, 0.5, 1.0)
WEIGHT = (1.0, 2.0, 2.0, 1.0)


@kernel
def rates_within(model: Model, state: State, phase: float, engaged: Engaged) -> Rates:
    """`rates_of` within a step, with the contacts of its beginning."""
    released = 1.0 if (model.timing.hybrid == 0.0) | (phase > 0.0) else 0.0
    return rates_while(model, state, released, engaged)


@kernel
def hull_acts(shape: TreeLayout, b: Buffer, w: int) -> bool:
    """True if the hull of any lane touches an obstacle in this step, or is a shell that turns."""
    at, engaged = places(shape, w), shape.record.contacts.engaged
    found = fold(or_turns, 0.0, read(shape.model, b, 0, w, 0).airframe.hull, ())
    first = at.engaged + rows(engaged.arms)
    for k in range(first * w, (first + rows(engaged.hull)) * w):
        found += b[k]
    return found > 0.0


@kernel
def _without_hull(model: Model) -> Model:
    return replace(model, airframe=replace(model.airframe, hull=()))


@kernel
def stage_model(shape: TreeLayout, b: Buffer, w: int, i: int, reach: float) -> Model:
    """Model of one lane at the instant of a stage."""
    at = places(shape, w)
    time = b[at.record * w + i] + reach * b[at.step * w + i]
    stage: Model = model_at(read(shape.model, b, 0, w, i), time)
    return stage


@kernel
def stage_state(shape: TreeLayout, b: Buffer, w: int, i: int, reach: float) -> State:
    """State of one lane for a stage, by the rates of the stage before."""
    at = places(shape, w)
    state = read(shape.motion.state, b, at.motion, w, i)
    rate = read(shape.motion.state, b, at.rate, w, i)
    reached: State = axpy(state, rate, reach * b[at.step * w + i])
    return reached


@kernel
def add_rates(shape: TreeLayout, b: Buffer, w: int, i: int, rate: Motion, weight: float) -> None:
    """Store the rates of a stage, and add them with their weight."""
    at = places(shape, w)
    so_far = read(shape.motion, b, at.total, w, i)
    write(rate.state, b, at.rate, w, i)
    write(axpy(so_far, rate, weight), b, at.total, w, i)


@kernel
def _add_with_hull(shape: TreeLayout, b: Buffer, w: int, reach: float, weight: float) -> None:
    for i in range(w):
        model = stage_model(shape, b, w, i, reach)
        state = stage_state(shape, b, w, i, reach)
        engaged = read(shape.record.contacts.engaged, b, places(shape, w).engaged, w, i)
        known = rates_within(model, state, b[places(shape, w).phase * w + i], engaged)
        add_rates(shape, b, w, i, known.motion, weight)


@kernel
def _add_without_hull(shape: TreeLayout, b: Buffer, w: int, reach: float, weight: float) -> None:
    for i in range(w):
        model = _without_hull(stage_model(shape, b, w, i, reach))
        state = stage_state(shape, b, w, i, reach)
        flags = read(shape.record.contacts.engaged, b, places(shape, w).engaged, w, i)
        engaged = Engaged(flags.arms, (), flags.bodies)
        known = rates_within(model, state, b[places(shape, w).phase * w + i], engaged)
        add_rates(shape, b, w, i, known.motion, weight)


@step_kernel
def _add_stage_of_lanes(shape: TreeLayout, b: Buffer, w: int, reach: float, weight: float) -> None:
    # Mostly no hull acts: its forces, all zero, are then left out.
    if hull_acts(shape, b, w):
        _add_with_hull(shape, b, w, reach, weight)
    else:
        _add_without_hull(shape, b, w, reach, weight)


@step_kernel
def find_rates(shape: TreeLayout, b: Buffer, reach: float, sees: bool) -> None:
    """Find the rates of a single flight at a stage: in their places in its buffer.

    Args:
        shape: Layout of the buffer.
        b: The buffer, one lane.
        reach: Of the stage: `REACH`.  With 0 a step begins: all contacts are looked for.
        sees: True to store the view, too.
    """
    at, begins = places(shape, 1), reach == 0.0
    model = stage_model(shape, b, 1, 0, reach)
    start = read(shape.motion.state, b, at.motion, 1, 0)
    state = select(begins, start, stage_state(shape, b, 1, 0, reach))
    engaged = read(shape.record.contacts.engaged, b, at.engaged, 1, 0)
    engaged = select(begins, all_engaged(model), engaged)
    known = rates_within(model, state, b[at.phase], engaged)
    write(known.motion, b, at.rate, 1, 0)
    if sees:
        write(known.seen, b, at.seen, 1, 0)


@kernel
def add_found_rates(shape: TreeLayout, b: Buffer, weight: float) -> None:
    """Add the rates that `find_rates` has found with the weight of their stage."""
    at = places(shape, 1)
    for k in range(rows(shape.motion)):
        b[at.total + k] += weight * b[at.rate + k]


@step_kernel
def _add_stage_of_one(shape: TreeLayout, b: Buffer, reach: float, weight: float) -> None:
    # `find_rates` is compiled once for all callers of one kind: hence both are step kernels.
    find_rates(shape, b, reach, False)
    add_found_rates(shape, b, weight)


@executor(nogil=True)
def rates_apart(shape: TreeLayout, b: Buffer, reach: float, sees: bool) -> None:
    """`find_rates`, compiled apart from the loop over steps."""
    find_rates(shape, b, reach, sees)


#: Lanes of single flights by the compiler's types of their layouts.
_COMPILED: dict[Any, SplitFlight] = {}


def split_flight(shape: TreeLayout, buffers: Buffer) -> SplitFlight:
    """Lanes of a single flight; its physics is compiled if need be."""
    kind = shape._numba_type_
    if kind not in _COMPILED:
        found = code_address(rates_apart, rates_arguments(shape, buffers))
        _COMPILED[kind] = SplitFlight(found)
    return _COMPILED[kind]


def is_compiled(shape: TreeLayout) -> bool:
    """True if `split_flight` compiles and loads nothing."""
    return shape._numba_type_ in _COMPILED


def rates_arguments(shape: TreeLayout, buffers: Buffer) -> tuple[Any, ...]:
    """Arguments of `rates_apart` for a single flight in its buffers: only their types matter."""
    return shape, buffers[0], REACH[0], True


def find_rates_at(physics: int, shape: TreeLayout, b: Buffer, reach: float, sees: bool) -> None:
    """`find_rates` by the address of `rates_apart`."""
    find_rates(shape, b, reach, sees)


@compiler_rule(find_rates_at)
def _find_rates_at(physics: Any, shape: Any, b: Any, reach: Any, sees: Any) -> Any:
    return lambda physics, shape, b, reach, sees: run_at(physics, (shape, b, reach, sees))


@generic
def add_stage(
    lanes: tuple[int, ...], shape: TreeLayout, b: Buffer, reach: float, weight: float
) -> None:
    """Add a Runge–Kutta stage of each lane.

    Args:
        lanes: A tuple as long as a group is wide, or a `SingleFlight`.
        shape: Layout of the buffer.
        b: Buffer of the group.
        reach: Of the stage, in steps: `REACH`.
        weight: Of the stage: `WEIGHT`.
    """
    _add_stage_of_lanes(shape, b, len(lanes), reach, weight)


@add_stage.register(SingleFlight)
def _add_lone_stage(
    lanes: SingleFlight, shape: TreeLayout, b: Buffer, reach: float, weight: float
) -> None:
    _add_stage_of_one(shape, b, reach, weight)


@add_stage.register(SplitFlight)
def _add_split_stage(
    lanes: SplitFlight, shape: TreeLayout, b: Buffer, reach: float, weight: float
) -> None:
    find_rates_at(lanes.physics, shape, b, reach, False)
    add_found_rates(shape, b, weight)
