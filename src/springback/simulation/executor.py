"""The loop over steps: Runge–Kutta steps of many flights in lanes, or of one.

One function serves all executors.  Compiled with 8 lanes, it flies 8 flights in the registers of
the vector unit; with one lane it flies a single flight; not compiled, it is plain Python.  The
number of lanes is the length of a tuple, so that the compiler knows it.

Layout of the buffers, and swaps between lanes: `springback.simulation.lanes`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.cage import moving_bodies
from springback.contact.hull_contact import arm_flags, hull_flags
from springback.contact.laws.memory import (
    arm_memory,
    energy_lost_deeper,
    hull_memory,
    memory_after,
)
from springback.contact.obstacles import World
from springback.dynamics.clearance import Search
from springback.dynamics.crossing import NO_CROSSING, Crossing
from springback.dynamics.limbs.arms import ArmView
from springback.dynamics.limbs.locked import RigidRates, RigidState
from springback.dynamics.motion import HullView, Motion, Rates, View, rates
from springback.dynamics.obstacle_views import NO_VIEW, BodyView
from springback.dynamics.rigid import rigid_step
from springback.kernels.compiler import executor, generic, guard, kernel, step_kernel
from springback.kernels.layout import Buffer, TreeLayout, read, row_of, rows, write
from springback.kernels.trees import (
    axpy_strictly,
    fold,
    replace,
    select,
    square,
    tree_map,
)
from springback.kernels.vectors import Vec, renormalise
from springback.simulation.lanes import (
    CRUISES,
    LOOKS,
    STEERS,
    SingleFlight,
    SplitFlight,
    classify,
    number_lanes,
    places,
    refill,
    restore_order,
    stash,
    unstash,
)
from springback.simulation.measuring.limits import cruise_record_with_loads, record_with_loads
from springback.simulation.measuring.record import (
    FLYING,
    NOT_FINITE,
    NOTHING,
    Model,
    Record,
    clearance_check,
    search_of,
)
from springback.simulation.request import motion_after_request
from springback.simulation.stages import REACH, WEIGHT, add_stage, find_rates, find_rates_at
from springback.simulation.thrusts import body_at, model_at, ramped_step
from springback.vehicle.state import (
    Airframe,
    Arm,
    BodyState,
    PartMemory,
    State,
    compression_of,
    coordinates_of_arms,
)

#: A flight has diverged if the sum of squares of its coordinates and speeds is more than this.
DIVERGED = 1e12

SIXTH = 1.0 / 6.0


@kernel
def rates_of(model: Model, state: State, phase: float, looks: float) -> Rates:
    """Rates of one flight; its arms can slide during an impact, or always."""
    released = 1.0 if (model.timing.hybrid == 0.0) | (phase > 0.0) else 0.0
    return rates(model, state, released, looks)


class FlightInLane(NamedTuple):
    """What the buffer of a group holds of one flight, but for the results of stages."""

    model: Model
    motion: Motion
    record: Record


@kernel
def _record_rates(
    shape: TreeLayout, b: Buffer, w: int, i: int, flown: FlightInLane, known: Rates, search: Search
) -> None:
    """Record what one lane knows as its step begins, and add its rates as those of a stage."""
    at, (model, motion, record) = places(shape, w), flown
    heat = row_of(shape.motion, "work") + row_of(shape.motion.work, "contact")
    write(record_with_loads(model, motion, known, record, search), b, at.record, w, i)
    memory = memory_after(motion.state.memory, known.seen.arms, known.seen.hull)
    write(memory, b, at.motion + row_of(shape.motion.state, "memory"), w, i)
    b[(at.motion + heat) * w + i] += energy_lost_deeper(memory)
    write(known.motion, b, at.total, w, i)


@kernel
def _read_flight(shape: TreeLayout, b: Buffer, w: int, i: int) -> FlightInLane:
    at = places(shape, w)
    motion = read(shape.motion, b, at.motion, w, i)
    return FlightInLane(
        read(shape.model, b, 0, w, i), motion, read(shape.record, b, at.record, w, i)
    )


@step_kernel
def _begin_lanes(shape: TreeLayout, b: Buffer, w: int) -> None:
    at = places(shape, w)
    for i in range(w):
        flown = _read_flight(shape, b, w, i)
        state, now = flown.motion.state, flown.record.stepping
        search = search_of(flown.model, state, flown.record)
        looks = 1.0 if w == 1 else search.looks  # a single flight logs true gaps
        known = rates_of(model_at(flown.model, now.time), state, now.phase, looks)
        _record_rates(shape, b, w, i, flown, known, search)
        write(known.motion.state, b, at.rate, w, i)
        if w == 1:  # only a single flight is logged
            write(known.seen, b, at.seen, w, i)


@step_kernel
def _begin_one(shape: TreeLayout, b: Buffer) -> None:
    find_rates(shape, b, REACH[0], True)
    _record_found(shape, b)


@kernel
def _record_found(shape: TreeLayout, b: Buffer) -> None:
    """Record what `find_rates` has found as a step of a single flight begins."""
    at, flown = places(shape, 1), _read_flight(shape, b, 1, 0)
    motion, seen = read(shape.motion, b, at.rate, 1, 0), read(shape.seen, b, at.seen, 1, 0)
    search = search_of(flown.model, flown.motion.state, flown.record)
    _record_rates(shape, b, 1, 0, flown, Rates(motion, seen), search)


@generic
def begin_step(lanes: tuple[int, ...], shape: TreeLayout, b: Buffer) -> None:
    """Begin a step of each lane: its first stage, the record, and the length of the step.

    Args:
        lanes: A tuple as long as a group is wide, or a `SingleFlight`.
        shape: Layout of the buffer.
        b: Buffer of the group.
    """
    _begin_lanes(shape, b, len(lanes))


@begin_step.register(SingleFlight)
def _begin_lone_step(lanes: SingleFlight, shape: TreeLayout, b: Buffer) -> None:
    _begin_one(shape, b)


@begin_step.register(SplitFlight)
def _begin_split_step(lanes: SplitFlight, shape: TreeLayout, b: Buffer) -> None:
    find_rates_at(lanes.physics, shape, b, REACH[0], True)
    _record_found(shape, b)


@guard
def is_finite(x: RigidState) -> bool:
    """True if a motion is finite and has not diverged."""
    return square(x) < DIVERGED


@kernel
def motion_of_body(motion: Motion, x: RigidState) -> Motion:
    """Motion of a vehicle after a step as one rigid body."""
    state = replace(
        motion.state, position=x.position, attitude=x.attitude, velocity=x.velocity,
        angular_velocity=x.angular_velocity,
    )  # fmt: skip
    return Motion(state, replace(motion.work, thrust=x.thrust_work, air=x.air_work))


@kernel
def _far_arm(arm: Arm, length: float, memory: PartMemory, room: float, obstacles: Any) -> ArmView:
    none, apart = Vec(0.0, 0.0, 0.0), arm_flags(arm, obstacles, 0.0)
    never, compression = Crossing(NO_CROSSING, 1.0), compression_of(arm, length)
    return ArmView(
        room, 0.0, 0.0, none, compression, 0.0, never, apart, 0.0, 0.0, 0.0, memory.pressed
    )


@kernel
def _far_hull(hull: Any, memory: PartMemory, room: float, obstacles: Any) -> HullView:
    none, apart = Vec(0.0, 0.0, 0.0), hull_flags(hull, obstacles, 0.0)
    return HullView(room, 0.0, 0.0, none, Crossing(NO_CROSSING, 1.0), apart, 0.0, memory.pressed)


@kernel
def _far_body(body: Any) -> BodyView:
    return NO_VIEW


@kernel
def cruise_view(
    airframe: Airframe, world: World, state: State, known: RigidRates, room: float
) -> View:
    """View of a vehicle as one rigid body: nothing touches, no arm moves."""
    of_arms = arm_memory(state.memory, airframe.arms)
    of_hull = hull_memory(state.memory, airframe.hull)
    lengths = coordinates_of_arms(airframe.arms[0], state)
    arms = tree_map(_far_arm, (airframe.arms, lengths, of_arms), (room, world.obstacles))
    hull = tree_map(_far_hull, (airframe.hull, of_hull), (room, world.obstacles))
    none, a, centre = Vec(0.0, 0.0, 0.0), known.flight.velocity, known.mass_centre_velocity
    bodies = tree_map(_far_body, (moving_bodies(world.obstacles),), ())
    seen = arms, hull, 0.0, 0.0, 0.0, 0.0, bodies
    return View(a, known.specific_force, centre, none, none, none, *seen)


@guard
def _renormalised(body: BodyState) -> BodyState:
    return replace(body, attitude=renormalise(body.attitude))


@guard
def accept_step(shape: TreeLayout, b: Buffer, w: int, i: int) -> None:
    """Take the step of one lane if its result is finite; otherwise its last state is kept."""
    at = places(shape, w)
    h = b[at.step * w + i]
    old = read(shape.motion, b, at.motion, w, i)
    rate = read(shape.motion, b, at.total, w, i)
    new = axpy_strictly(old, rate, SIXTH * h)
    good = square(new.state) < DIVERGED
    bodies = tree_map(_renormalised, (new.state.bodies,), ())
    state = replace(new.state, attitude=renormalise(new.state.attitude), bodies=bodies)
    # A flight that has ended keeps its bits while its neighbours fly on: normalising changes some.
    write(select(good & (h > 0.0), Motion(state, new.work), old), b, at.motion, w, i)
    b[at.record * w + i] += h if good else 0.0
    b[at.status * w + i] = b[at.status * w + i] if good else NOT_FINITE


@kernel
def take_rigid_steps(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Take a step as one rigid body of each lane that is marked for it."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        motion = read(shape.motion, b, at.motion, w, i)
        record = read(shape.record, b, at.record, w, i)
        s, work = motion.state, motion.work
        lengths = coordinates_of_arms(model.airframe.arms[0], s)
        body = body_at(model, lengths, record.stepping.time)
        x = RigidState(
            s.position, s.attitude, s.velocity, s.angular_velocity, work.thrust, work.air
        )
        guide, air, gravity = model.guide, model.air, model.world.gravity
        left = model.timing.until - record.stepping.time
        h = left if left < model.timing.free_step else model.timing.free_step
        flown = rigid_step(guide, air, body, gravity, x, h)
        given = model, lengths, record.stepping.time, x, h
        flown = fold(ramped_step, flown, model.ramp, given)
        known, new = flown.known, flown.flight
        good = is_finite(new)
        goes = b[at.mark * w + i] == CRUISES
        write(select(goes & good, motion_of_body(motion, new), motion), b, at.motion, w, i)
        after = cruise_record_with_loads(model, x, known, record, good, h)
        write(select(goes, after, record), b, at.record, w, i)
        if w == 1:
            world, room = model.world, record.stepping.room
            write(cruise_view(model.airframe, world, s, known, room), b, at.seen, w, i)


@kernel
def check_clearance(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Check the clearance of the lanes that are marked for it."""
    at = places(shape, w)
    for i in range(w):
        model = read(shape.model, b, 0, w, i)
        motion = read(shape.motion, b, at.motion, w, i)
        record = read(shape.record, b, at.record, w, i)
        found, before = clearance_check(model, motion.state, record), record.stepping
        looks = b[at.mark * w + i] == LOOKS
        b[at.cruising * w + i] = found.cruising if looks else before.cruising
        b[at.room * w + i] = found.room if looks else before.room


@kernel
def log_motion(shape: TreeLayout, b: Buffer, line: Buffer) -> None:
    """Write time and motion of a single flight to a row of its trajectory."""
    at = places(shape, 1)
    line[0] = b[at.record]
    for k in range(rows(shape.motion)):
        line[1 + k] = b[at.motion + k]


@kernel
def log_view(shape: TreeLayout, b: Buffer, line: Buffer) -> None:
    """Write the view of a single flight to a row of its trajectory."""
    at, moving = places(shape, 1), rows(shape.motion)
    for k in range(rows(shape.seen)):
        line[1 + moving + k] = b[at.seen + k]


class TrajectoryLog(NamedTuple):
    """Trajectory of a single flight; without rows, none is recorded."""

    rows: Buffer  # one instant a row, shape (instants, columns): time, motion and view
    used: Any  # number of rows in use, shape (1,); advanced


@kernel
def has_space(log: TrajectoryLog) -> bool:
    """True unless the trajectory is recorded and full."""
    return bool(log.rows.shape[0] == 0 or log.used[0] < log.rows.shape[0])


@kernel
def cruise(shape: TreeLayout, b: Buffer, w: int, log: TrajectoryLog) -> None:
    """Take a step as one rigid body of the marked lanes; log that of a single flight."""
    logs = (w == 1) & (log.rows.shape[0] > 0)
    if logs:
        log_motion(shape, b, log.rows[log.used[0]])
    take_rigid_steps(shape, b, w)
    if logs:
        log_view(shape, b, log.rows[log.used[0]])
        log.used[0] += 1


@kernel
def log_step(shape: TreeLayout, b: Buffer, w: int, log: TrajectoryLog) -> None:
    """Log a full step of a single flight."""
    at = places(shape, w)
    if (w == 1) & (log.rows.shape[0] > 0) and (b[at.step] > 0.0 or b[at.status] != FLYING):
        log_motion(shape, b, log.rows[log.used[0]])
        log_view(shape, b, log.rows[log.used[0]])
        log.used[0] += 1


@kernel
def handle_events(shape: TreeLayout, b: Buffer, w: int) -> None:
    """Process the requests of all lanes."""
    at, requests = places(shape, w), 0
    for i in range(w):
        flies = b[at.status * w + i] == FLYING
        requests += 1 if flies & (b[at.request * w + i] != NOTHING) else 0
    # In a branch of its own: otherwise the rare event is computed, masked, at every step.
    for i in range(w if requests > 0 else 0):
        if b[at.request * w + i] != NOTHING and b[at.status * w + i] == FLYING:
            model = read(shape.model, b, 0, w, i)
            motion = read(shape.motion, b, at.motion, w, i)
            loads, request = read(shape.record, b, at.record, w, i).loads, b[at.request * w + i]
            motion = motion_after_request(model.limits, loads, model, motion, request)
            write(motion, b, at.motion, w, i)


@executor(nogil=True)
def advance(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: TrajectoryLog,
    budget: int,
    early: float,
) -> int:
    """Advance some groups of flights.

    The groups take turns: each flies on while any of its flights cruises, or may after a check of
    its clearance; then each takes full steps while any of its flights needs them; and so on.  In
    its turn a group takes over flights from later groups for those that do something else; all are
    back in their lanes at the end.

    Args:
        shape: Layout of the buffers.
        buffers: One row for each group, shape (groups, rows x lanes).
        lanes: A tuple as long as a group is wide.
        log: Trajectory of a single flight.
        budget: Most steps to take, all groups together.
        early: 1 leaves each flight flying when it reaches ``until``, to be continued; 0 ends it.

    Returns:
        Number of flights that have not reached ``until``.
    """
    w, groups = len(lanes), buffers.shape[0]
    several = w > 1  # a single lane has no neighbours to protect
    # 1, which the compiler does not know: it would unroll a loop of known length, not pack it.
    once, flying = log.used.shape[0], 1
    if several:
        number_lanes(shape, buffers, w)
    while flying > 0 and budget > 0 and has_space(log):
        # Check all clearances first: a group takes over only flights that are known to cruise.
        for group in range(groups if several else 0):
            if classify(shape, buffers[group], w, early).looking > 0:
                check_clearance(shape, buffers[group], w)
        for turn in range(2 * groups):
            group, cruising = turn % groups, turn < groups
            wanted = CRUISES if cruising else STEERS
            b, more = buffers[group], several & (group + 1 < groups)
            while budget > 0 and has_space(log):
                now = classify(shape, b, w, early)
                if now.looking > 0:
                    check_clearance(shape, b, w)
                    now = classify(shape, b, w, early)
                able = now.cruising if cruising else now.steering
                if able == 0:
                    break
                if more and able < w:
                    more = refill(shape, buffers, group, w, wanted, early)
                    now = classify(shape, b, w, early)
                if cruising:
                    cruise(shape, b, w, log)
                else:
                    shared = several and now.cruising + now.waiting > 0
                    if shared:
                        stash(shape, b, w)
                    begin_step(lanes, shape, b)
                    log_step(shape, b, w, log)
                    for stage in range(1, 3 + once):
                        add_stage(lanes, shape, b, REACH[stage], WEIGHT[stage])
                    for i in range(w * once):
                        accept_step(shape, b, w, i)
                    if shared:
                        unstash(shape, b, w)
                    handle_events(shape, b, w)
                budget -= 1
        flying = 0
        for group in range(groups):
            now = classify(shape, buffers[group], w, early)
            flying += now.cruising + now.looking + now.steering
    if several:
        restore_order(shape, buffers, w)
    return flying


@kernel
def cruise_to_tick(shape: TreeLayout, b: Buffer, w: int, log: TrajectoryLog, early: float) -> int:
    """Let the flights of a group cruise towards their next tick, as far as they can.

    Args:
        shape: Layout of the buffer.
        b: Buffer of the group.
        w: Number of lanes.
        log: Trajectory of a single flight.
        early: As for `advance`.

    Returns:
        Number of flights that have not reached it.
    """
    now = classify(shape, b, w, early)
    while now.cruising + now.looking > 0 and has_space(log):
        if now.looking > 0:
            check_clearance(shape, b, w)
        else:
            cruise(shape, b, w, log)
        now = classify(shape, b, w, early)
    return now.steering + now.cruising + now.looking


@executor(nogil=True)
def to_tick(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: TrajectoryLog,
    budget: int,
    early: float,
) -> int:
    """Advance groups to their next tick; arguments and result as for `advance`.

    Between two ticks nearly all flights take one step as one rigid body, for which it is not worth
    changing lanes.
    """
    busy = 0
    for group in range(buffers.shape[0]):
        busy += cruise_to_tick(shape, buffers[group], len(lanes), log, early)
    if busy > 0:
        busy = advance(shape, buffers, lanes, log, budget, early)
    return busy
