"""Steps of two vehicles together: the same instants, the same lengths, the same forces.

The first vehicle meets the parts of the second as moving obstacles, and their contact is computed
there, once.  The second gets the opposite forces, so that momentum is kept to rounding, and is told
where and how deep it is touched.  At each stage of a step the parts of each are where they are at
that stage.  While neither can touch anything,
each takes steps as one rigid body.
"""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from springback.contact.moving.bodies import BodyAccelerations, MovingBody
from springback.dynamics.clearance import HASTE, has_room
from springback.dynamics.limbs.arms import ArmView
from springback.dynamics.motion import HullView, View
from springback.dynamics.touches import PartPush
from springback.kernels.compiler import Origin, executor, kernel, user_executor, with_globals
from springback.kernels.layout import Buffer, TreeLayout, read, row_of, write
from springback.kernels.trees import field_of, maximum, replace, tree_map
from springback.kernels.vectors import Mat3, rotation
from springback.simulation.executor import (
    TrajectoryLog,
    accept_step,
    begin_step,
    cruise,
    handle_events,
    has_space,
    log_step,
)
from springback.simulation.flight import SLICE, own_types, sources
from springback.simulation.guided import FLY, LOOK, TickRange
from springback.simulation.lanes import CRUISES, SingleFlight, places
from springback.simulation.measuring.record import (
    ARRIVED,
    FINISHED,
    FLYING,
    awaits_return,
    is_quiet,
)
from springback.simulation.pair.parts import part_accelerations, parts_of
from springback.simulation.stages import (
    REACH,
    WEIGHT,
    add_found_rates,
    find_rates,
    stage_state,
)
from springback.simulation.ticks import (
    FlightBuffers,
    FlightLog,
    Layouts,
    drive_rotors,
    sense_and_decide,
)
from springback.vehicle.state import fastest_point


@kernel
def _with_parts(shape: TreeLayout, b: Buffer, other: TreeLayout, o: Buffer, reach: float) -> None:
    """Write where the parts of the other vehicle are at a stage into the state of this one."""
    model = read(other.model, o, 0, 1, 0)
    state = stage_state(other, o, 1, 0, reach)
    row = places(shape, 1).motion + row_of(shape.motion.state, "bodies")
    write(parts_of(model.airframe, state), b, row, 1, 0)


@kernel
def _accelerated(body: MovingBody, known: BodyAccelerations) -> MovingBody:
    return replace(body, accelerations=known)


@kernel
def _with_accelerations(shape: TreeLayout, b: Buffer, other: TreeLayout, o: Buffer) -> None:
    """Write the accelerations of the other vehicle's parts, a step ago, into this one's world."""
    at, model = places(other, 1), read(other.model, o, 0, 1, 0)
    state = read(other.motion.state, o, at.motion, 1, 0)
    rate = read(other.motion.state, o, at.rate, 1, 0)
    world = shape.model.world
    row = row_of(shape.model, "world") + row_of(world, "obstacles")
    row += row_of(world.obstacles, "bodies")
    bodies = read(world.obstacles.bodies, b, row, 1, 0)
    known = part_accelerations(model.airframe, state, rate)
    write(tree_map(_accelerated, (bodies, known), ()), b, row, 1, 0)


@kernel
def _kept(push: PartPush, r: Mat3) -> PartPush:
    """A push that in the second's axes, and back in those of the world, is what it was.

    Within a step the quaternion is not quite of length 1, so that r rᵀ is not quite 1.
    """
    force, moment, friction = push.force, push.moment, push.friction
    return replace(
        push,
        force=2.0 * force - r @ (force @ r),
        moment=2.0 * moment - r @ (moment @ r),
        friction=2.0 * friction - r @ (friction @ r),
    )


@kernel
def _touches(part: ArmView | HullView) -> float:
    return maximum(part.engaged)


@kernel
def _with_pushes(shape: TreeLayout, b: Buffer, seen: View, reach: float) -> None:
    """Write what the first vehicle does at a stage into the model of the second.

    Args:
        shape: Layout of the buffer of the second.
        b: That buffer.
        seen: By the first.
        reach: Of the stage.
    """
    r = rotation(stage_state(shape, b, 1, 0, reach).attitude)
    row = row_of(shape.model, "pushes")
    pushes = shape.model.pushes
    write(tree_map(_kept, (field_of(seen.bodies, "push"),), (r,)), b, row, 1, 0)
    touching = tree_map(_touches, (seen.arms,), ()) + tree_map(_touches, (seen.hull,), ())
    write(touching, b, row + row_of(pushes, "strikers"), 1, 0)


@executor(nogil=True)
def begin_both(
    first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer, log_a: TrajectoryLog,
    log_b: TrajectoryLog,
) -> None:  # fmt: skip
    """Begin a step of both vehicles: the shorter of both."""
    at, to = places(first, 1), places(second, 1)
    _with_parts(first, a, second, b, 0.0)
    _with_parts(second, b, first, a, 0.0)
    _with_accelerations(first, a, second, b)
    begin_step(SingleFlight(0), first, a)
    _with_pushes(second, b, read(first.seen, a, at.seen, 1, 0), 0.0)
    begin_step(SingleFlight(0), second, b)
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
    find_rates(first, a, reach, True)
    _with_pushes(second, b, read(first.seen, a, places(first, 1).seen, 1, 0), reach)
    find_rates(second, b, reach, False)
    add_found_rates(first, a, weight)
    add_found_rates(second, b, weight)


@executor(nogil=True)
def end_both(first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer) -> None:
    """Take the step of both vehicles, and process their requests."""
    _leave_room(first, a, second, b, a[places(first, 1).step])
    accept_step(first, a, 1, 0)
    accept_step(second, b, 1, 0)
    handle_events(first, a, 1)
    handle_events(second, b, 1)


@kernel
def _leave_room(first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer, h: float) -> None:
    """Set the room of both to what a step of ``h`` leaves of the smaller one."""
    at, to = places(first, 1).room, places(second, 1).room
    left = a[at] if a[at] < b[to] else b[to]
    left -= HASTE * (_speed(first, a) + _speed(second, b)) * h
    a[at], b[to] = left, left


@kernel
def _speed(shape: TreeLayout, b: Buffer) -> float:
    """Upper bound of the speed of any point of a vehicle [m/s]."""
    model = read(shape.model, b, 0, 1, 0)
    state = read(shape.motion.state, b, places(shape, 1).motion, 1, 0)
    return fastest_point(model.airframe, state.velocity, state.angular_velocity)


@kernel
def _is_lone(shape: TreeLayout, b: Buffer) -> bool:
    """True if a step of a vehicle as one rigid body misses no event of its own."""
    model = read(shape.model, b, 0, 1, 0)
    record = read(shape.record, b, places(shape, 1).record, 1, 0)
    now, contacts = record.stepping, record.contacts
    ahead = awaits_return(contacts.impacts, record.first_impact)
    quiet = is_quiet(
        model.timing, contacts.touching, now.phase, contacts.impact_open, ahead, ()
    ) & (now.status == FLYING)
    return bool(quiet & (model.timing.until - now.time > ARRIVED))


@executor(nogil=True)
def cruise_both(
    first: TreeLayout, a: Buffer, second: TreeLayout, b: Buffer, log_a: TrajectoryLog,
    log_b: TrajectoryLog,
) -> bool:  # fmt: skip
    """Take a step of both vehicles as rigid bodies, if nothing can touch meanwhile.

    Returns:
        True if they took it.
    """
    at, to = places(first, 1), places(second, 1)
    model = read(first.model, a, 0, 1, 0)
    left, h = model.timing.until - a[at.record], model.timing.free_step
    h = left if left < h else h
    room = a[at.room] if a[at.room] < b[to.room] else b[to.room]
    roomy = has_room(room, _speed(first, a) + _speed(second, b), model.timing.free_step)
    if not (roomy and _is_lone(first, a) and _is_lone(second, b)):
        return False
    if log_a.rows.shape[0] > 0:
        _with_parts(first, a, second, b, 0.0)
        _with_parts(second, b, first, a, 0.0)
    _leave_room(first, a, second, b, h)
    room = a[at.room]
    a[at.mark], b[to.mark] = CRUISES, CRUISES
    cruise(first, a, 1, log_a)
    cruise(second, b, 1, log_b)
    a[at.room], b[to.room] = room, room
    return True


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
        if not cruise_both(first, a, second, b, log_a, log_b):
            begin_both(first, a, second, b, log_a, log_b)
            for stage in range(1, 4):
                stage_of_both(first, a, second, b, REACH[stage], WEIGHT[stage])
            end_both(first, a, second, b)
        budget -= 1
    return 1 if a[row_a] == FLYING and b[row_b] == FLYING else 0


class NoAvionics(NamedTuple):
    """In place of the avionics of a vehicle with constant thrust."""

    period: float  # of the clock [s]


class PairedBuffers(NamedTuple):
    """One of two vehicles in flight."""

    layouts: Layouts
    motion: Buffer
    onboard: Buffer  # avionics, or `NoAvionics`
    noise: Buffer  # shape (ticks, channels)
    log: FlightLog


@executor(nogil=True)
def guided_tick(side: PairedBuffers, tick: int, duration: float) -> None:
    """Run sensors and pilot, and set the rotors until the next tick."""
    buffers = FlightBuffers(side.motion, side.onboard, (0,))
    sense_and_decide(side.layouts, buffers, tick, side.noise[tick], side.log)
    drive_rotors(side.layouts, buffers, tick, side.noise[tick], side.log, duration)


@executor(nogil=True)
def unguided_tick(side: PairedBuffers, tick: int, duration: float) -> None:
    """Fly on with the same thrust until the next tick."""
    shape, b = side.layouts.shape, side.motion
    end, row = (tick + 1) * side.onboard[0], places(shape, 1).status
    b[row_of(shape.model, "timing")] = end if end < duration else duration  # its first field
    b[row] = FLYING if b[row] == FINISHED else b[row]


#: What begins a tick of each vehicle; replaced by `pair_guide`.
begin_first = begin_second = guided_tick


@executor(nogil=True)
def guide_both(first: PairedBuffers, second: PairedBuffers, ticks: TickRange) -> None:
    """Fly two vehicles from tick to tick.

    It returns when the ticks are done, when a log is full, and after many steps within a tick;
    called again, it continues from there.

    Args:
        first: The one on whose side contact is computed.
        second: The other one.
        ticks: To be flown; their position is advanced.
    """
    at, one, other = ticks.position, first.layouts.shape, second.layouts.shape
    a, b, log_a, log_b = first.motion, second.motion, first.log.trajectory, second.log.trajectory
    while at[0] < ticks.end:
        if at[1] == LOOK:
            begin_first(first, at[0], ticks.duration)
            begin_second(second, at[0], ticks.duration)
            at[1] = FLY
        early = 0.0 if at[0] == ticks.last else 1.0
        if advance_both(one, a, other, b, log_a, log_b, SLICE, early) > 0:
            return
        at[0], at[1] = at[0] + 1, LOOK


def begin_and_end_both(first: PairedBuffers, second: PairedBuffers, ticks: TickRange) -> None:
    """About half of `guide_both`: what can be compiled beside the rest."""
    one, other, a, b = first.layouts.shape, second.layouts.shape, first.motion, second.motion
    begin_both(one, a, other, b, first.log.trajectory, second.log.trajectory)
    end_both(one, a, other, b)


def pair_guide(first: Any, second: Any) -> Any:
    """`guide_both` for the avionics of two vehicles, or `NoAvionics`."""
    own = own_types(first) | own_types(second)
    guided = tuple(not isinstance(one, NoAvionics) for one in (first, second))
    return _pair_guide(guided, frozenset(own), sources(own) if own else None)


@functools.cache
def _pair_guide(guided: tuple[bool, bool], own: frozenset[type], files: Origin | None) -> Any:
    def entry(function: Any, **parts: Any) -> Any:
        plain = with_globals(function.py_func, **parts)
        return user_executor(plain, files, nogil=True) if own else executor(nogil=True)(plain)

    tick: Any = guided_tick
    if own:
        parts = {"sense_and_decide": sense_and_decide, "drive_rotors": drive_rotors}
        tick = entry(guided_tick, **{name: entry(part) for name, part in parts.items()})
    begins = [tick if pilot else unguided_tick for pilot in guided]
    return entry(guide_both, begin_first=begins[0], begin_second=begins[1])
