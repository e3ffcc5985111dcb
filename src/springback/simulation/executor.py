"""The loop: Runge–Kutta steps of many flights abreast, or of one.

One function serves all executors.  Compiled with 16 lanes it flies 16 flights in the registers of
the vector unit; with one lane it is the single flight; uncompiled it is plain Python.  The number
of lanes is the length of a tuple, so the compiler knows it.

A group of flights lies in one flat buffer, lane by lane within each row: model, motion, weighted
sum, rate, for a single flight the view, record.  Flat, with constant offsets, because that is what
compilers vectorise.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from springback.contact.obstacles import Forces, Impulses
from springback.dynamics.energy import energy, locked
from springback.dynamics.impulse import struck
from springback.dynamics.motion import Motion, Rates, View, Work, rates
from springback.kernels.compiler import executor, generic, guard, kernel, rare_kernel
from springback.kernels.layout import Buffer, Like, read, row_of, rows, write
from springback.kernels.trees import along, along_strictly, pick, square
from springback.kernels.vectors import Quat
from springback.simulation.record import (
    APPLY_IMPULSE,
    ARRIVED,
    FLYING,
    NOT_FINITE,
    NOTHING,
    Model,
    Record,
    observed,
)
from springback.vehicle.state import State

#: A flight whose squared coordinates and speeds add up to more than this has diverged.
DIVERGED = 1e12

# Classical Runge–Kutta, x + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄): stage i is taken at x + REACH[i] h kᵢ₋₁.
REACH = (0.0, 0.5, 0.5, 1.0)
WEIGHT = (1.0, 2.0, 2.0, 1.0)


class Shape(NamedTuple):
    """Trees that tell the executor what lies in a buffer; their numbers do not matter."""

    model: Model
    motion: Motion
    seen: View
    record: Record


@rare_kernel
def settled(model: Model, motion: Motion) -> Motion:
    """The motion with its arms locked, the energy lost booked as settling."""
    before = energy(model.airframe, model.world, model.contact_point, motion.state)
    state = locked(model.airframe, motion.state)
    after = energy(model.airframe, model.world, model.contact_point, state)
    w = motion.work
    lost = before.kinetic + before.gravity + before.springs + before.stops
    lost -= after.kinetic + after.gravity + after.springs + after.stops
    return Motion(
        state,
        Work(w.thrust, w.arm, w.stop, w.contact, w.friction, w.settling + lost, w.air, w.impulse),
    )


@generic
def answered(laws: Forces | Impulses, model: Model, motion: Motion, request: float) -> Motion:
    """The motion after a rare event: settled arms are locked; impulses where a surface has them."""
    return settled(model, motion)


@answered.register(Impulses)
@rare_kernel
def _answered_with_impulses(laws: Impulses, model: Model, motion: Motion, request: float) -> Motion:
    if request == APPLY_IMPULSE:
        return struck(model.airframe, model.world, model.contact_point, motion)
    return settled(model, motion)


class Places(NamedTuple):
    """Rows of a buffer at which its parts begin."""

    motion: int
    total: int  # weighted sum of the stages' rates
    rate: int  # of the state, at the stage before
    seen: int  # the view, of a single flight only
    record: int  # it begins with time, step, status, phase, request
    step: int
    status: int
    phase: int
    request: int
    end: int


@kernel
def places(shape: Like | Shape, w: int) -> Places:
    """Rows at which the parts of a buffer of ``w`` lanes begin; the model is the first."""
    motion = rows(shape.model)
    total = motion + rows(shape.motion)
    rate = total + rows(shape.motion)
    view = rate + rows(shape.motion.state)
    record = view + (rows(shape.seen) if w == 1 else 0)
    end = record + rows(shape.record)
    return Places(
        motion, total, rate, view, record, record + 1, record + 2, record + 3, record + 4, end
    )


@kernel
def rates_of(model: Model, state: State, phase: float) -> Rates:
    """Rates of one flight; its arms are free to slide during an impact, or always."""
    released = 1.0 if (model.timing.hybrid == 0.0) | (phase > 0.0) else 0.0
    return rates(
        model.airframe,
        model.world,
        model.contact_point,
        model.guide,
        model.air,
        state,
        model.thrust,
        released,
    )


@kernel
def begun(shape: Like, b: Buffer, w: int) -> None:
    """Begin a step: every lane is measured, its step chosen, its rates known."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        motion = read(shape.motion, b, at.motion, w, i)
        record = read(shape.record, b, at.record, w, i)
        known = rates_of(model, motion.state, record.phase)
        write(observed(model, motion, known.seen, record), b, at.record, w, i)
        write(known.motion.state, b, at.rate, w, i)
        write(known.motion, b, at.total, w, i)
        if w == 1:  # only a single flight is logged
            write(known.seen, b, at.seen, w, i)


@kernel
def staged(shape: Like, b: Buffer, w: int, reach: float, weight: float) -> None:
    """One more Runge–Kutta stage of every lane."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        state = read(shape.motion.state, b, at.motion, w, i)
        rate = read(shape.motion.state, b, at.rate, w, i)
        so_far = read(shape.motion, b, at.total, w, i)
        h, phase = b[at.step * w + i], b[at.phase * w + i]
        known = rates_of(model, along(state, rate, reach * h), phase)
        write(known.motion.state, b, at.rate, w, i)
        write(along(so_far, known.motion, weight), b, at.total, w, i)


@guard
def taken(shape: Like, b: Buffer, w: int, i: int) -> None:
    """Take the step of one lane where it leads to finite numbers; else its last state stays."""
    at = places(shape, w)
    h = b[at.step * w + i]
    old = read(shape.motion, b, at.motion, w, i)
    rate = read(shape.motion, b, at.total, w, i)
    new = along_strictly(old, rate, h / 6.0)
    good = square(new) < DIVERGED
    q = new.state.attitude
    scale = 1.0 / math.sqrt(square(q))
    turned = Quat(q.w * scale, q.x * scale, q.y * scale, q.z * scale)
    s = new.state
    state = State(s.position, turned, s.velocity, s.angular_velocity, s.arm_length, s.arm_rate)
    # A flight that has ended keeps its bits while its neighbours fly on: even normalising moves it.
    write(pick(good & (h > 0.0), Motion(state, new.work), old), b, at.motion, w, i)
    b[at.record * w + i] += h if good else 0.0
    b[at.status * w + i] = b[at.status * w + i] if good else NOT_FINITE


@executor(nogil=True)
def advance(
    shape: Like,
    buffers: Buffer,
    first: int,
    last: int,
    lanes: tuple[int, ...],
    log: Buffer,
    logged: Any,
    budget: int,
    early: float,
) -> int:
    """Advance the groups ``first`` to ``last`` of flights, each by at most ``budget`` steps.

    Args:
        shape: What lies in the buffers.
        buffers: One group a row, shape (groups, rows x lanes).
        first: Index of the first group.
        last: Index past the last group.
        lanes: A tuple as long as a group is wide.
        log: Trajectory of a single flight, one instant a row, shape (instants, columns); empty for
            none.  The columns are time, motion and view.
        logged: Number of rows of the log in use, shape (1,); advanced.
        budget: Most steps to take.
        early: 1 leaves every flight at ``until`` as it arrives, to be flown on; 0 ends it there.

    Returns:
        Number of flights that are still flying and not there yet.
    """
    w = len(lanes)
    at = places(shape, w)
    motion_rows, view_rows = rows(shape.motion), rows(shape.seen)
    until = row_of(shape.model, "timing")  # its first field
    flying = 0

    for group in range(first, last):
        b = buffers[group]
        running = w
        for _ in range(budget):
            if log.shape[0] > 0 and logged[0] >= log.shape[0]:
                break
            begun(shape, b, w)
            if w == 1 and log.shape[0] > 0 and (b[at.step] > 0.0 or b[at.status] != FLYING):
                line = logged[0]
                log[line, 0] = b[at.record]
                for k in range(motion_rows):
                    log[line, 1 + k] = b[at.motion + k]
                for k in range(view_rows):
                    log[line, 1 + motion_rows + k] = b[at.seen + k]
                logged[0] = line + 1
            for stage in range(1, 4):
                staged(shape, b, w, REACH[stage], WEIGHT[stage])

            for i in range(w):
                taken(shape, b, w, i)
            running = 0
            asked = 0
            for i in range(w):
                flies = b[at.status * w + i] == FLYING
                there = b[until * w + i] - b[at.record * w + i] <= ARRIVED
                running += 1 if flies & ((early == 0.0) | (not there)) else 0
                asked += 1 if flies & (b[at.request * w + i] != NOTHING) else 0
            # Behind a branch of its own: else the rare event is computed, masked, at every step.
            for i in range(w if asked > 0 else 0):
                if b[at.request * w + i] != NOTHING and b[at.status * w + i] == FLYING:
                    model = read(shape.model, b, 0, w, i)
                    motion = read(shape.motion, b, at.motion, w, i)
                    motion = answered(model.world.laws, model, motion, b[at.request * w + i])
                    write(motion, b, at.motion, w, i)
            if running == 0:
                break
        flying += running
    return flying


def buffer_rows(shape: Shape, width: int) -> int:
    """Number of rows that one flight takes in a buffer of some width."""
    return places(shape, width).end


def empty_groups(shape: Shape, flights: int, width: int) -> Buffer:
    """Zeroed buffers for a number of flights in groups of ``width``, aligned to cache lines."""
    groups, size = -(-flights // width), buffer_rows(shape, width) * width
    line = 64
    raw = np.zeros(groups * size * 8 + line, dtype=np.uint8)
    start = -raw.ctypes.data % line
    return raw[start : start + groups * size * 8].view(np.float64).reshape(groups, size)
