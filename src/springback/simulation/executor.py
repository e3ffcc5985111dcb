"""The loop: Runge–Kutta steps of many flights abreast, or of one.

One function serves all executors.  Compiled with 8 lanes it flies 8 flights in the registers of
the vector unit; with one lane it is the single flight; uncompiled it is plain Python.  The number
of lanes is the length of a tuple, so the compiler knows it.

What lies where, and how flights change lanes, is told in `springback.simulation.lanes`.
"""

from __future__ import annotations

from typing import Any

from springback.contact.obstacles import Forces, Impulses, Obstacle, World
from springback.dynamics.crossing import NO_CROSSING, Crossing
from springback.dynamics.energy import energy, with_arms_locked
from springback.dynamics.impulse import apply_impulses
from springback.dynamics.motion import (
    ArmView,
    Engaged,
    HullView,
    Motion,
    Rates,
    View,
    rates,
    rates_while,
)
from springback.dynamics.rigid import RigidRates, RigidState, as_one_body, one_body_step
from springback.kernels.compiler import executor, generic, guard, kernel, rare_kernel
from springback.kernels.layout import Buffer, TreeLayout, read, rows, write
from springback.kernels.trees import axpy, axpy_strictly, replace, select, square, tree_map
from springback.kernels.vectors import Vec, renormalise
from springback.simulation.lanes import (
    CRUISES,
    LOOKS,
    STEERS,
    classify,
    number_lanes,
    places,
    refill,
    restore_order,
    stash,
    unstash,
)
from springback.simulation.record import (
    APPLY_IMPULSE,
    FLYING,
    NOT_FINITE,
    NOTHING,
    Model,
    cruised_past,
    looked_about,
    observed,
)
from springback.vehicle.state import Airframe, Arm, Sphere, State

#: A flight whose squared coordinates and speeds add up to more than this has diverged.
DIVERGED = 1e12

# Classical Runge–Kutta, x + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄): stage i is taken at x + REACH[i] h kᵢ₋₁.
REACH = (0.0, 0.5, 0.5, 1.0)
WEIGHT = (1.0, 2.0, 2.0, 1.0)
SIXTH = 1.0 / 6.0


@rare_kernel
def settled(model: Model, motion: Motion) -> Motion:
    """The motion with its arms locked where they are, the energy lost booked as settling."""
    before = energy(model.airframe, model.world, model.contact_point, motion.state)
    state = with_arms_locked(model.airframe, motion.state)
    after = energy(model.airframe, model.world, model.contact_point, state)
    lost = before.kinetic + before.gravity + before.springs + before.stops
    lost -= after.kinetic + after.gravity + after.springs + after.stops
    work = replace(motion.work, settling=motion.work.settling + lost)
    return Motion(state, work)


@generic
def answered(laws: Forces | Impulses, model: Model, motion: Motion, request: float) -> Motion:
    """The motion after a rare event: settled arms are locked; impulses where a surface has them."""
    return settled(model, motion)


@answered.register(Impulses)
@rare_kernel
def _answered_with_impulses(laws: Impulses, model: Model, motion: Motion, request: float) -> Motion:
    if request == APPLY_IMPULSE:
        return apply_impulses(model.airframe, model.world, model.contact_point, motion)
    return settled(model, motion)


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
def rates_within(model: Model, state: State, phase: float, engaged: Engaged) -> Rates:
    """`rates_of` within a step: contact is on where it was at the beginning of the step."""
    released = 1.0 if (model.timing.hybrid == 0.0) | (phase > 0.0) else 0.0
    return rates_while(
        model.airframe,
        model.world,
        model.contact_point,
        model.guide,
        model.air,
        state,
        model.thrust,
        released,
        engaged,
    )


@kernel
def first_stage(shape: TreeLayout, b: Buffer, w: int) -> None:
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
def hull_touches(shape: TreeLayout, b: Buffer, w: int) -> bool:
    """Whether the hull of any lane touches something in this step."""
    at, found = places(shape, w), 0.0
    first = at.engaged + rows(shape.record.engaged.arms)
    for k in range(first * w, (first + rows(shape.record.engaged.hull)) * w):
        found += b[k]
    return found > 0.0


@kernel
def _without_hull(model: Model) -> Model:
    return replace(model, airframe=replace(model.airframe, hull=()))


@kernel
def next_stage(shape: TreeLayout, b: Buffer, w: int, reach: float, weight: float) -> None:
    """One more Runge–Kutta stage of every lane."""
    at = places(shape, w)
    # A hull mostly touches nothing in any lane: its forces, all zero, are then left out.
    if hull_touches(shape, b, w):
        for i in range(w):
            model = read(shape.model, b, 0, w, i)
            state = _reached(shape, b, w, i, reach)
            engaged = read(shape.record.engaged, b, at.engaged, w, i)
            known = rates_within(model, state, b[at.phase * w + i], engaged)
            _weighed(shape, b, w, i, known.motion, weight)
    else:
        for i in range(w):
            model = _without_hull(read(shape.model, b, 0, w, i))
            state = _reached(shape, b, w, i, reach)
            engaged = Engaged(read(shape.record.engaged.arms, b, at.engaged, w, i), ())
            known = rates_within(model, state, b[at.phase * w + i], engaged)
            _weighed(shape, b, w, i, known.motion, weight)


@kernel
def _reached(shape: TreeLayout, b: Buffer, w: int, i: int, reach: float) -> State:
    """Where the stage before leads one lane."""
    at = places(shape, w)
    state = read(shape.motion.state, b, at.motion, w, i)
    rate = read(shape.motion.state, b, at.rate, w, i)
    reached: State = axpy(state, rate, reach * b[at.step * w + i])
    return reached


@kernel
def _weighed(shape: TreeLayout, b: Buffer, w: int, i: int, rate: Motion, weight: float) -> None:
    """Keep the rates of a stage, and add them with their weight."""
    at = places(shape, w)
    so_far = read(shape.motion, b, at.total, w, i)
    write(rate.state, b, at.rate, w, i)
    write(axpy(so_far, rate, weight), b, at.total, w, i)


@guard
def is_finite(x: RigidState) -> bool:
    """Whether a motion is finite, and within reason."""
    return square(x) < DIVERGED


@kernel
def landed(motion: Motion, x: RigidState) -> Motion:
    """The motion of a vehicle that flew as one body."""
    state = replace(
        motion.state, position=x.position, attitude=x.attitude, velocity=x.velocity,
        angular_velocity=x.angular_velocity,
    )  # fmt: skip
    return Motion(state, replace(motion.work, thrust=x.thrust_work, air=x.air_work))


@kernel
def _apart(obstacle: Obstacle) -> float:
    return 0.0


@kernel
def _far_arm(arm: Arm, length: float, room: float, obstacles: tuple[Obstacle, ...]) -> ArmView:
    none, apart = Vec(0.0, 0.0, 0.0), tree_map(_apart, (obstacles,), ())
    pressed = arm.length - length
    return ArmView(
        room, 0.0, 0.0, none, pressed, 0.0, Crossing(NO_CROSSING, 1.0), apart, 0.0, 0.0, 0.0
    )


@kernel
def _far_hull(hull: Sphere, room: float, obstacles: tuple[Obstacle, ...]) -> HullView:
    none, apart = Vec(0.0, 0.0, 0.0), tree_map(_apart, (obstacles,), ())
    return HullView(room, 0.0, 0.0, none, Crossing(NO_CROSSING, 1.0), apart, 0.0)


@kernel
def cruise_view(
    airframe: Airframe,
    world: World,
    lengths: tuple[float, ...],
    known: RigidRates,
    room: float,
) -> View:
    """The view of a flight that cruises: nothing touches, no arm moves."""
    arms = tree_map(_far_arm, (airframe.arms, lengths), (room, world.obstacles))
    hull = tree_map(_far_hull, (airframe.hull,), (room, world.obstacles))
    none, a, centre = Vec(0.0, 0.0, 0.0), known.flight.velocity, known.mass_centre_velocity
    return View(a, known.specific_force, centre, none, none, arms, hull, 0.0, 0.0, 0.0, 0.0)


@guard
def accept_step(shape: TreeLayout, b: Buffer, w: int, i: int) -> None:
    """Take the step of one lane where it leads to finite numbers; else its last state stays."""
    at = places(shape, w)
    h = b[at.step * w + i]
    old = read(shape.motion, b, at.motion, w, i)
    rate = read(shape.motion, b, at.total, w, i)
    new = axpy_strictly(old, rate, SIXTH * h)
    good = square(new.state) < DIVERGED
    state = replace(new.state, attitude=renormalise(new.state.attitude))
    # A flight that has ended keeps its bits while its neighbours fly on: even normalising moves it.
    write(select(good & (h > 0.0), Motion(state, new.work), old), b, at.motion, w, i)
    b[at.record * w + i] += h if good else 0.0
    b[at.status * w + i] = b[at.status * w + i] if good else NOT_FINITE


@kernel
def rigid_step(shape: TreeLayout, b: Buffer, w: int) -> None:
    """One step of every lane that is marked as one that cruises."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        motion = read(shape.motion, b, at.motion, w, i)
        record = read(shape.record, b, at.record, w, i)
        s, work = motion.state, motion.work
        body = as_one_body(model.airframe, s.arm_length, model.thrust)
        x = RigidState(
            s.position, s.attitude, s.velocity, s.angular_velocity, work.thrust, work.air
        )
        guide, air, gravity = model.guide, model.air, model.world.gravity
        left = model.timing.until - record.time
        h = left if left < model.timing.free_step else model.timing.free_step
        flown = one_body_step(guide, air, body, gravity, x, h)
        known, new = flown.known, flown.flight
        good = is_finite(new)
        goes = b[at.mark * w + i] == CRUISES
        write(select(goes & good, landed(motion, new), motion), b, at.motion, w, i)
        write(
            select(goes, cruised_past(model, x, known, record, good, h), record), b, at.record, w, i
        )
        if w == 1:
            view = cruise_view(model.airframe, model.world, s.arm_length, known, record.room)
            write(view, b, at.seen, w, i)


@kernel
def check_clearance(shape: TreeLayout, b: Buffer, w: int) -> None:
    """The lanes that are to look see whether they have room to cruise."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        motion = read(shape.motion, b, at.motion, w, i)
        record = read(shape.record, b, at.record, w, i)
        seen = looked_about(model, motion.state, record)
        looks = b[at.mark * w + i] == LOOKS
        b[at.cruising * w + i] = seen.cruising if looks else record.cruising
        b[at.room * w + i] = seen.room if looks else record.room


@kernel
def log_motion(shape: TreeLayout, b: Buffer, line: Buffer) -> None:
    """Time and motion of a single flight, into its line of the log."""
    at = places(shape, 1)
    line[0] = b[at.record]
    for k in range(rows(shape.motion)):
        line[1 + k] = b[at.motion + k]


@kernel
def log_view(shape: TreeLayout, b: Buffer, line: Buffer) -> None:
    """The view of a single flight, into its line of the log."""
    at, moving = places(shape, 1), rows(shape.motion)
    for k in range(rows(shape.seen)):
        line[1 + moving + k] = b[at.seen + k]


@kernel
def cruised_on(shape: TreeLayout, b: Buffer, w: int, log: Buffer, logged: Any) -> None:
    """One step of the lanes that cruise; of a single flight, a line of the log."""
    logs = (w == 1) & (log.shape[0] > 0)
    if logs:
        log_motion(shape, b, log[logged[0]])
    rigid_step(shape, b, w)
    if logs:
        log_view(shape, b, log[logged[0]])
        logged[0] += 1


@kernel
def log_steered(shape: TreeLayout, b: Buffer, w: int, log: Buffer, logged: Any) -> None:
    """Of a single flight that is steered, a line of the log."""
    at = places(shape, w)
    if (w == 1) & (log.shape[0] > 0) and (b[at.step] > 0.0 or b[at.status] != FLYING):
        log_motion(shape, b, log[logged[0]])
        log_view(shape, b, log[logged[0]])
        logged[0] += 1


@kernel
def handle_events(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Answer the requests of all lanes."""
    at = places(shape, w)
    asked = 0
    for i in range(w):
        flies = b[at.status * w + i] == FLYING
        asked += 1 if flies & (b[at.request * w + i] != NOTHING) else 0
    # Behind a branch of its own: else the rare event is computed, masked, at every step.
    for i in range(w if asked > 0 else 0):
        if b[at.request * w + i] != NOTHING and b[at.status * w + i] == FLYING:
            model = read(shape.model, b, 0, w, i)
            motion = read(shape.motion, b, at.motion, w, i)
            motion = answered(model.world.laws, model, motion, b[at.request * w + i])
            write(motion, b, at.motion, w, i)


@executor(nogil=True)
def advance(
    shape: TreeLayout,
    buffers: Buffer,
    first: int,
    last: int,
    lanes: tuple[int, ...],
    log: Buffer,
    logged: Any,
    budget: int,
    early: float,
) -> int:
    """Advance the groups ``first`` to ``last`` of flights.

    The groups take turns: each flies on while any of its flights cruises, or finds on looking about
    that it can, then each steers while any is to be steered, and so on.  In its turn a group takes
    flights over from later groups, for those that have nothing to do in it; all are back in their
    lanes at the end.

    Args:
        shape: What lies in the buffers.
        buffers: One group a row, shape (groups, rows x lanes).
        first: Index of the first group.
        last: Index past the last group.
        lanes: A tuple as long as a group is wide.
        log: Trajectory of a single flight, one instant a row, shape (instants, columns); empty for
            none.  The columns are time, motion and view.
        logged: Number of rows of the log in use, shape (1,); advanced.
        budget: Most steps to take, those of all groups together.
        early: 1 leaves every flight at ``until`` as it arrives, to be flown on; 0 ends it there.

    Returns:
        Number of flights that are still flying and not there yet.
    """
    w, groups = len(lanes), last - first
    several = w > 1  # a lane alone that steers has no neighbours to be put aside
    # It is 1, which the compiler does not know: loops of known length it would unroll, not pack.
    once = logged.shape[0]
    if w > 1:
        number_lanes(shape, buffers, first, last, w)
    lines = log.shape[0] if log.shape[0] > 0 else logged[0] + 1
    flying = 1
    while flying > 0 and budget > 0 and logged[0] < lines:
        # All look first, for a group takes only flights over that are known to cruise.
        for group in range(first, last if several else first):
            if classify(shape, buffers[group], w, early).looking > 0:
                check_clearance(shape, buffers[group], w)
        for turn in range(2 * groups):
            group, cruising = first + turn % groups, turn < groups
            wanted = CRUISES if cruising else STEERS
            b, more = buffers[group], (w > 1) & (group + 1 < last)
            while budget > 0 and logged[0] < lines:
                now = classify(shape, b, w, early)
                if now.looking > 0:
                    check_clearance(shape, b, w)
                    now = classify(shape, b, w, early)
                able = now.cruising if cruising else now.steering
                if able == 0:
                    break
                if more and able < w:
                    more = refill(shape, buffers, group, last, w, wanted, early)
                    now = classify(shape, b, w, early)
                if cruising:
                    cruised_on(shape, b, w, log, logged)
                else:
                    if several and now.cruising + now.waiting > 0:
                        stash(shape, b, w)
                    first_stage(shape, b, w)
                    log_steered(shape, b, w, log, logged)
                    for stage in range(1, 3 + once):
                        next_stage(shape, b, w, REACH[stage], WEIGHT[stage])
                    for i in range(w * once):
                        accept_step(shape, b, w, i)
                    if several and now.cruising + now.waiting > 0:
                        unstash(shape, b, w)
                    handle_events(shape, b, w)
                budget -= 1
        flying = 0
        for group in range(first, last):
            now = classify(shape, buffers[group], w, early)
            flying += now.cruising + now.looking + now.steering
    if w > 1:
        restore_order(shape, buffers, first, last, w)
    return flying


@executor(nogil=True)
def to_tick(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: Buffer,
    logged: Any,
    budget: int,
    early: float,
) -> int:
    """Advance groups to their next tick, as `advance`.

    Between two ticks nearly all flights take one step as one body, which is not worth changing
    lanes for.

    Args:
        shape: What lies in the buffers.
        buffers: One group a row, shape (groups, rows x lanes).
        lanes: A tuple as long as a group is wide.
        log: As for `advance`.
        logged: As for `advance`.
        budget: As for `advance`.
        early: As for `advance`.

    Returns:
        Number of flights that are still flying and not there yet.
    """
    w, busy = len(lanes), 0
    lines = log.shape[0] if log.shape[0] > 0 else logged[0] + 1
    for group in range(buffers.shape[0]):
        b = buffers[group]
        now = classify(shape, b, w, early)
        while now.cruising + now.looking > 0 and logged[0] < lines:
            if now.looking > 0:
                check_clearance(shape, b, w)
            else:
                cruised_on(shape, b, w, log, logged)
            now = classify(shape, b, w, early)
        busy += now.steering + now.cruising + now.looking
    if busy > 0:
        busy = advance(shape, buffers, 0, buffers.shape[0], lanes, log, logged, budget, early)
    return busy
