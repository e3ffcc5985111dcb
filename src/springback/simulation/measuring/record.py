"""The record of a flight: each measure defined once, and updated step by step.

A single flight, a table of the paper and a campaign read the same accumulators, so they cannot
disagree.  Times are −1 until the event happens.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.laws.step_bounds import stiffness_rate
from springback.contact.obstacles import World
from springback.dynamics.clearance import (
    HASTE,
    Search,
    disc_gaps,
    first_hits,
    has_room,
    room_around,
    search_at,
)
from springback.dynamics.crossing import crossing, sooner, soonest, time_to
from springback.dynamics.limbs.arms import ArmView
from springback.dynamics.limbs.locked import RigidRates, RigidState
from springback.dynamics.motion import LANDED, Engaged, Motion, View
from springback.dynamics.obstacle_views import faster, first_hit, nearer, rebounding, speed_beside
from springback.kernels.compiler import kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    minimum,
    one_tuple,
    replace,
    select,
    tree_map,
)
from springback.kernels.vectors import Vec, larger, norm, smaller
from springback.simulation.measuring.peaks import (
    NOTHING_YET,
    Peaks,
    PeakSample,
    Recent,
    largest_change,
    largest_so_far,
    peaks_after,
    peaks_now,
)
from springback.simulation.thrusts import ARRIVED as ARRIVED
from springback.simulation.thrusts import Ramp
from springback.vehicle.placed.rotors import guards_of
from springback.vehicle.rotor_stop import UNHIT, Hits, hits_after
from springback.vehicle.state import (
    Airframe,
    State,
    fastest_cage,
    fastest_point,
    largest_rate,
    rates_of_arms,
    resting_stiffness,
)

FLYING, FINISHED, NOT_FINITE = 0.0, 1.0, 2.0
FREE_FLIGHT, IMPACT = 0.0, 1.0
NOTHING, LOCK_ARMS, APPLY_IMPULSE, BREAK_GUARDS = 0.0, 1.0, 2.0, 3.0
#: Kind of the next step: a full step, near an obstacle or while arms slide; a step as one rigid
#: body, far from everything; or undecided until the clearance is checked.
STEERED, CRUISING, MAY_LOOK = 0.0, 1.0, 2.0

#: A step to a crossing is at least this share of the impact step.
SHORTEST = 1e-3
TINY = 1e-9  # against division by zero


class Timing(NamedTuple):
    """End of the flight, lengths of steps, and ends of impacts."""

    until: float  # end of the flight [s]
    free_step: float  # in free flight [s]
    impact_step: float  # while something touches or a stop is pressed [s]
    settle_step: float  # while the arms settle [s]
    arm_tolerance: float  # an arm has settled within this distance of its balance [m] ...
    rate_tolerance: float  # ... and this rate [m/s]
    dwell: float  # a touch later than this begins a new impact [s]
    hybrid: float  # 1: one rigid body in free flight; 0: the arms can always slide


class Model(NamedTuple):
    """All constants of a flight."""

    airframe: Airframe
    world: World
    contact_point: Any  # Ring or ArmTip
    guide: Any  # Free or Slider
    air: Any  # Still or Air
    thrust: tuple[float, ...]  # of each rotor [N]
    timing: Timing
    ramp: tuple[Ramp, ...] = ()  # one if the thrusts change with time
    pushes: Any = ()  # `Pushes` of another vehicle, if there is one
    reaction: tuple[Any, ...] = ()  # of rotors that change speed, if known [N m]: `Plant`
    limits: Any = ()  # `LoadLimits`, if the vehicle has any
    surface_effect: Any = ()  # one `SurfaceEffect`, if surfaces change the thrust


class Stepping(NamedTuple):
    """Time, and control of the steps; `springback.simulation.lanes` knows these fields by place."""

    time: float  # [s]
    step: float  # next step [s]
    status: float  # FLYING, FINISHED, NOT_FINITE
    phase: float  # FREE_FLIGHT, IMPACT
    request: float  # NOTHING, LOCK_ARMS, APPLY_IMPULSE, BREAK_GUARDS
    cruising: float  # STEERED, CRUISING, MAY_LOOK
    room: float  # lower bound of the distance of every part from every obstacle [m]
    steps: float  # number of steps taken


class Contacts(NamedTuple):
    """Contacts of the whole flight."""

    touching: float  # 1 while any cage, or the hull, touches
    total: float  # number of times that the vehicle came into contact
    engaged: Engaged  # 1 for each pair in contact
    arms: tuple[float, ...]  # number of contacts of each cage
    hull: tuple[float, ...]  # number of contacts of the main body, if it has a hull
    impacts: float  # number of impacts: contacts closer together than the dwell time are one
    impact_open: float  # 1 until the dwell time is over
    last_touch_time: float  # [s]
    duration: float  # total time in contact [s]
    bottomed_time: float  # an arm reached the end of its stroke [s]
    ground_time: float  # a cage, or the hull, touched the ground [s]
    propellers: tuple[float, ...]  # each was first hit [s]; empty if their size is unknown


class FirstImpact(NamedTuple):
    """Motion at first touch, last separation and return of the first impact."""

    inward: Vec  # normal n into the obstacle at first touch, world
    point: Vec  # that is touched first, world [m]
    touch_time: float  # [s]
    touch_depth: float  # n · p of the main body at first touch [m]
    touch_speed: float  # n · v of the main body, relative to the centre of what it strikes [m/s]
    touch_mass_centre_speed: float  # n · v of the centre of mass, likewise [m/s]
    separation_time: float  # last separation [s]
    separation_speed: float  # n · v of the main body, likewise [m/s]
    separation_mass_centre_speed: float  # n · v of the centre of mass, likewise [m/s]
    return_time: float  # the main body is back at n · p of first touch [s]
    return_speed: float  # n · v of the main body [m/s]
    travel: float  # largest n · p less its value at first touch, until the last separation [m]
    struck: tuple[float, ...] = ()  # 1 for each moving obstacle that it touches first


class Record(NamedTuple):
    """Streaming measures of one flight."""

    stepping: Stepping  # first, see `springback.simulation.lanes`
    contacts: Contacts
    first_impact: FirstImpact
    peaks: Peaks  # of the whole flight
    impact_peaks: Peaks  # of the first impact, from its first touch until its arms have settled
    recent: Recent  # the last two instants, for peaks between instants
    hits: Any = ()  # `Hits`, where they stop rotors
    loads: Any = ()  # `PeakLoads`, where the vehicle has limits


def blank_record(engaged: Engaged, propellers: int, rotors: int = 0) -> Record:
    """Record before a flight, by contact flags and numbers of propellers and rotors that stop."""
    zero, never, hits = Vec(0.0, 0.0, 0.0), -1.0, (-1.0,) * propellers
    none, hull = (0.0,) * len(engaged.arms), (0.0,) * len(engaged.hull)
    peaks = Peaks(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    bodies = (0.0,) * len(engaged.bodies)
    first = FirstImpact(zero, zero, never, 0.0, 0.0, 0.0, never, 0.0, 0.0, never, 0.0, 0.0, bodies)
    return Record(
        Stepping(0.0, 0.0, FLYING, FREE_FLIGHT, NOTHING, MAY_LOOK, 0.0, 0.0),
        Contacts(0.0, 0.0, engaged, none, hull, 0.0, 0.0, never, 0.0, never, never, hits),
        first,
        peaks,
        peaks._replace(acceleration_time=never),
        NOTHING_YET,
        Hits((UNHIT,) * rotors) if rotors else (),
    )


@kernel
def _touch(engaged: tuple[float, ...]) -> float:
    return maximum(engaged)


@kernel
def _is_unsettled(arm: Any, view: ArmView, rate: Any, timing: Timing) -> float:
    """1 while an arm moves, or is away from its balance: its free length if nothing turns."""
    away = abs(view.unbalance) > resting_stiffness(arm) * timing.arm_tolerance
    moving = largest_rate(rate) > timing.rate_tolerance
    return arm.compliance if away | moving else 0.0


@kernel
def _rises(now: float, before: float) -> float:
    return 1.0 if now > before else 0.0


@kernel
def _count(so_far: float, now: float, before: float) -> float:
    return so_far + _rises(now, before)


@kernel
def record_after_cruise(
    model: Model, flight: RigidState, known: RigidRates, m: Record, good: bool, step: float
) -> Record:
    """Record after one step as one rigid body: `record_after` where no event can happen.

    Args:
        model: Of the flight.
        flight: Motion at the beginning of the step.
        known: Its rates.
        m: Record before.
        good: True if the result of the step is finite.
        step: Taken [s].
    """
    now, peaks = m.stepping, m.peaks
    a, felt = norm(known.flight.velocity), norm(known.specific_force)
    spin = norm(flight.angular_velocity)
    fastest = fastest_point(model.airframe, flight.velocity, flight.angular_velocity)
    room = now.room - HASTE * fastest * step
    stepping = replace(
        now,
        time=now.time + select(good, step, 0.0),
        step=step,
        status=select(good, now.status, NOT_FINITE),
        cruising=select(good & has_room(room, fastest, model.timing.free_step), CRUISING, MAY_LOOK),
        room=room,
        steps=now.steps + 1.0,
    )
    peaks = replace(
        peaks,
        acceleration=larger(a, peaks.acceleration),
        acceleration_time=select(a > peaks.acceleration, now.time, peaks.acceleration_time),
        specific_force=larger(felt, peaks.specific_force),
        angular_rate=larger(spin, peaks.angular_rate),
    )
    recent = Recent(now.step, m.recent.latest, PeakSample(a, felt, 0.0))
    return replace(m, stepping=stepping, peaks=peaks, recent=recent)


@kernel
def awaits_return(impacts: float, first: FirstImpact) -> bool:
    """True if the return from the first impact is still to come, after some number of impacts."""
    return (impacts == 1.0) & (first.return_time < 0.0) & (first.touch_time >= 0.0)


@kernel
def is_quiet(
    timing: Timing, touching: float, phase: float, impact_open: float, ahead: bool, others: Any
) -> bool:
    """True if a step as one rigid body misses nothing; never where others act (movers, rails)."""
    still = (touching == 0.0) & (phase == FREE_FLIGHT) & (impact_open == 0.0)
    return still & (not ahead) & (timing.hybrid > 0.0) & (len(others) == 0)


@kernel
def search_of(model: Model, state: State, m: Record) -> Search:
    """Whether to look for faces at the beginning of a step, after the one before."""
    now, timing = m.stepping, model.timing
    sliding = (now.phase > 0.0) | (timing.hybrid == 0.0)
    longest = select(sliding, timing.settle_step, timing.free_step)
    fastest = fastest_cage(model.airframe, state)
    return search_at(model.world.obstacles, now.room, fastest, now.step, longest)


class ClearanceCheck(NamedTuple):
    """Result of a check of the clearance: fields of `Stepping`."""

    cruising: float
    room: float


@kernel
def clearance_check(model: Model, state: State, m: Record) -> ClearanceCheck:
    """Kind of the next step by the distances of all parts from all obstacles."""
    room = room_around(model.airframe, model.world, model.contact_point, state)
    fastest = fastest_point(model.airframe, state.velocity, state.angular_velocity)
    c, ahead = m.contacts, awaits_return(m.contacts.impacts, m.first_impact)
    others = state.bodies + model.surface_effect + model.guide.rail
    quiet = is_quiet(model.timing, c.touching, m.stepping.phase, c.impact_open, ahead, others)
    cruising = select(quiet & has_room(room, fastest, model.timing.free_step), CRUISING, STEERED)
    return ClearanceCheck(cruising, room)


class Situation(NamedTuple):
    """Contacts and phase at an instant."""

    engaged: Engaged
    arms: tuple[float, ...]  # 1 for each cage in contact
    hull: tuple[float, ...]  # 1 if the hull is in contact
    touching: float  # as in `Contacts`, as are impacts, impact_open and last_touch_time
    impacts: float
    impact_open: float
    last_touch_time: float
    phase: float
    began: bool  # a contact began
    ended: bool  # the last contact ended
    locks: bool  # the arms have settled and are locked
    strikes: bool  # impulses are to be applied


@kernel
def situation_of(model: Model, state: State, view: View, m: Record) -> Situation:
    """Contacts and phase at an instant; ``m`` is the record before."""
    timing, now, before = model.timing, m.stepping, m.contacts
    engaged = Engaged(
        field_of(view.arms, "engaged"),
        field_of(view.hull, "engaged"),
        field_of(view.bodies, "engaged"),
    )
    arm_touching = tree_map(_touch, (engaged.arms,), ())
    hull_touching = tree_map(_touch, (engaged.hull,), ())
    touching = maximum(arm_touching + hull_touching)

    # Phases: with arms that are locked or slide, and with short steps or long ones.
    arms = (model.airframe.arms, view.arms, rates_of_arms(model.airframe.arms[0], state))
    unsettled = maximum(tree_map(_is_unsettled, arms, (timing,)))
    still_busy = select(unsettled > 0.0, now.phase, FREE_FLIGHT)
    phase = select(touching > 0.0, IMPACT, still_busy)
    locks = (phase < now.phase) & (timing.hybrid > 0.0)
    # Time passes between two impulses, even if the first one leaves parts that approach.
    impulsive = maximum(field_of(view.arms, "impulsive") + field_of(view.hull, "impulsive"))
    strikes = (impulsive > 0.0) & (now.request != APPLY_IMPULSE)

    # Impacts: contacts closer together than the dwell time belong to one.
    last_touch = select(touching > 0.0, now.time, before.last_touch_time)
    over = (phase == FREE_FLIGHT) & (now.time - last_touch > timing.dwell)
    impact_open = select(touching > 0.0, 1.0, select(over, 0.0, before.impact_open))
    impacts = before.impacts + _rises(impact_open, before.impact_open)
    return Situation(
        engaged, arm_touching, hull_touching, touching, impacts, impact_open, last_touch, phase,
        touching > before.touching, touching < before.touching, locks, strikes,
    )  # fmt: skip


@kernel
def _contacts_after(
    view: View, m: Record, at: Situation, step: float, discs: tuple[float, ...]
) -> Contacts:
    """Contacts after an instant; ``step`` is the next one, ``discs`` gaps of propellers [m]."""
    before, time = m.contacts, m.stepping.time
    engaged = before.engaged
    bottomed = maximum(field_of(view.arms, "bottomed")) > 0.0
    return Contacts(
        touching=at.touching,
        total=before.total + select(at.began, 1.0, 0.0),
        engaged=at.engaged,
        arms=tree_map(_count, (before.arms, at.arms, tree_map(_touch, (engaged.arms,), ())), ()),
        hull=tree_map(_count, (before.hull, at.hull, tree_map(_touch, (engaged.hull,), ())), ()),
        impacts=at.impacts,
        impact_open=at.impact_open,
        last_touch_time=at.last_touch_time,
        duration=before.duration + select(at.touching > 0.0, step, 0.0),
        bottomed_time=select(bottomed & (before.bottomed_time < 0.0), time, before.bottomed_time),
        ground_time=select(
            (view.on_ground > 0.0) & (before.ground_time < 0.0), time, before.ground_time
        ),
        propellers=first_hits(before.propellers, discs, time),
    )


@kernel
def _first_impact_after(state: State, view: View, m: Record, at: Situation) -> FirstImpact:
    """First impact after an instant; its first touch fixes the direction of its speeds."""
    before, time = m.first_impact, m.stepping.time
    first = at.began & (m.contacts.total == 0.0)
    length = norm(view.touched)
    inward = select(first, view.touched * (1.0 / select(length > 0.0, length, 1.0)), before.inward)
    depth, speed = inward @ state.position, inward @ state.velocity
    struck = tree_map(first_hit, (before.struck, view.bodies), (first,))
    closing = speed_beside(speed, struck, view.bodies, inward)
    centre_speed = speed_beside(inward @ view.mass_centre_velocity, struck, view.bodies, inward)
    touch_depth = select(first, depth, before.touch_depth)
    of_first = (at.impacts == 1.0) & (at.impact_open > 0.0)
    leaves = at.ended & of_first
    ahead = awaits_return(at.impacts, before)
    returns = ahead & (depth - touch_depth <= LANDED) & (speed < 0.0)
    goes_on = of_first & ((at.touching > 0.0) | at.ended)
    return FirstImpact(
        inward=inward,
        point=select(first, view.touched_at, before.point),
        touch_time=select(first, time, before.touch_time),
        touch_depth=touch_depth,
        touch_speed=select(first, closing, before.touch_speed),
        touch_mass_centre_speed=select(first, centre_speed, before.touch_mass_centre_speed),
        separation_time=select(leaves, time, before.separation_time),
        separation_speed=select(leaves, closing, before.separation_speed),
        separation_mass_centre_speed=select(
            leaves, centre_speed, before.separation_mass_centre_speed
        ),
        return_time=select(returns, time, before.return_time),
        return_speed=select(returns, speed, before.return_speed),
        travel=largest_so_far(goes_on, depth - touch_depth, before.travel),
        struck=struck,
    )


@kernel
def _time_to_crossing(
    timing: Timing, state: State, view: View, first: FirstImpact, ahead: bool
) -> float:
    """Time to the next crossing, on which a step lands: touch, separation, stop or return.

    A crossing that is predicted from afar is approached in two steps: the second prediction is a
    hundred times as accurate.
    """
    depth, speed = first.inward @ state.position, first.inward @ state.velocity
    crossings = field_of(view.arms, "crossing") + field_of(view.hull, "crossing")
    crossings = crossings + field_of(view.bodies, "crossing")
    returning = crossing(depth - first.touch_depth, select(ahead, speed, 0.0))
    time_to_crossing = time_to(sooner(soonest(crossings), returning))
    return select(
        time_to_crossing > timing.impact_step,
        time_to_crossing - 0.5 * timing.impact_step,
        time_to_crossing,
    )


@kernel
def _stepping_after(
    model: Model, state: State, view: View, m: Record, at: Situation, first: FirstImpact,
    search: Search, discs: tuple[float, ...],
) -> Stepping:  # fmt: skip
    """Next step and its kind; ``first`` is after this instant."""
    timing, now, phase = model.timing, m.stepping, at.phase
    ahead = awaits_return(at.impacts, m.first_impact)
    time_to_crossing = _time_to_crossing(timing, state, view, first, ahead)
    hits = fold(rebounding, at.touching, view.bodies, ())
    pressed = larger(hits, maximum(field_of(view.arms, "stopped"))) > 0.0
    impact_step = select(pressed, timing.impact_step, timing.settle_step)
    sliding = (phase > 0.0) | (timing.hybrid == 0.0)
    step = select(sliding | (hits > 0.0), impact_step, timing.free_step)
    step = smaller(step, larger(time_to_crossing, SHORTEST * timing.impact_step))
    # No point moves faster than this, so nothing can touch unnoticed within the step.
    fastest = fastest_point(model.airframe, state.velocity, state.angular_velocity)
    near = minimum(field_of(view.arms, "gap") + field_of(view.hull, "gap") + discs)
    near = select(search.looks > 0.0, fold(nearer, near, view.bodies, ()), search.room)
    haste = larger(fold(faster, fastest_cage(model.airframe, state), view.bodies, ()), TINY)
    stiff = stiffness_rate(view.friction_rate, view.contact_rate, view.slip_rate)
    both = 1.0 / (haste * stiff)  # one division for two
    step = smaller(step, larger(near * (stiff * both), timing.impact_step))
    step = smaller(step, larger(haste * both, SHORTEST * timing.impact_step))
    left = timing.until - now.time
    finished = left <= ARRIVED
    changed = (phase != now.phase) | at.strikes
    halted = finished | changed | (now.status != FLYING)
    step = select(halted, 0.0, smaller(step, left))
    others = state.bodies + model.surface_effect + model.guide.rail
    quiet = is_quiet(timing, at.touching, phase, at.impact_open, ahead, others)
    quiet = quiet & (step > 0.0)
    return Stepping(
        time=now.time,
        step=step,
        status=select((now.status == FLYING) & finished, FINISHED, now.status),
        phase=phase,
        request=select(at.strikes, APPLY_IMPULSE, select(at.locks, LOCK_ARMS, NOTHING)),
        cruising=select(quiet & has_room(near, fastest, timing.free_step), CRUISING, STEERED),
        room=near,
        steps=now.steps + select(step > 0.0, 1.0, 0.0),
    )


@kernel
def record_after(model: Model, motion: Motion, view: View, m: Record, search: Search) -> Record:
    """Record after one more instant, with the next step and phase decided.

    There are no branches: each line is an arithmetic selection, so that lanes stay packed.
    """
    state, now = motion.state, m.stepping
    at = situation_of(model, state, view, m)
    first: FirstImpact = _first_impact_after(state, view, m, at)
    gaps = disc_gaps(model.airframe, model.world, state, search.looks)
    discs = one_tuple(gaps)
    stepping: Stepping = _stepping_after(model, state, view, m, at, first, search, discs)
    sample = PeakSample(
        norm(view.acceleration),
        norm(view.specific_force),
        maximum(field_of(view.arms, "normal") + field_of(view.hull, "normal")),
    )
    parts = (at.engaged.arms + at.engaged.hull, m.contacts.engaged.arms + m.contacts.engaged.hull)
    jumped = maximum(tree_map(largest_change, parts, ())) > 0.0
    smooth = (now.step > 0.0) & (not jumped)
    peaks = peaks_now(state.angular_velocity, view, sample, m.recent, now, smooth)
    within = (at.impacts == 1.0) & (at.phase == IMPACT)  # until its arms have settled
    recent = Recent(select(smooth, now.step, 0.0), m.recent.latest, sample)
    return Record(
        stepping,
        _contacts_after(view, m, at, stepping.step, discs),
        first,
        peaks_after(m.peaks, peaks, True),
        peaks_after(m.impact_peaks, peaks, within),
        select(now.status == FLYING, recent, m.recent),
        hits_after(m.hits, guards_of(model.airframe.rotors, view.arms), gaps),
        m.loads,
    )
