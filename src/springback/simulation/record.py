"""What a flight is remembered by: every measure defined once, updated step by step.

A single flight, a table of the paper and a campaign read the same accumulators, so they cannot
disagree.  Times are −1 until they happen.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.obstacles import World
from springback.dynamics.clearance import clearance
from springback.dynamics.crossing import crossing, sooner, soonest, time_to
from springback.dynamics.motion import LANDED, ArmView, Engaged, Motion, View
from springback.dynamics.rigid import RigidRates, RigidState
from springback.kernels.compiler import kernel
from springback.kernels.trees import field_of, maximum, minimum, replace, select, tree_map
from springback.kernels.vectors import Vec, larger, norm, smaller
from springback.simulation.peaks import NOTHING_YET, PeakSample, Recent, peak_of, spacing
from springback.vehicle.state import Airframe, Arm, State, fastest_cage, fastest_point

FLYING, FINISHED, NOT_FINITE = 0.0, 1.0, 2.0
FREE_FLIGHT, IMPACT = 0.0, 1.0
NOTHING, LOCK_ARMS, APPLY_IMPULSE = 0.0, 1.0, 2.0
#: How the next step is taken: as that of a vehicle that is near something, or whose arms slide; as
#: one rigid body far from everything; as a look about will tell.
STEERED, CRUISING, MAY_LOOK = 0.0, 1.0, 2.0

#: A step is at most so many times that in which friction brings a cage to rest (chosen; the method
#: is stable up to 2.785, and at 2.25 the energy ledger of hard impacts is twice as far off).
FRICTION_SHARE = 2.0
#: A step is at most this share of the time scale of contacts and end stops, 1/(ω + 2 ζ ω) ...
CONTACT_SHARE = 0.35
#: ... and of that in which a slip changes, as it does when friction turns round (both chosen:
#: studies/families.py).
SLIP_SHARE = 0.25
PER_FRICTION_SHARE, PER_CONTACT_SHARE = 1.0 / FRICTION_SHARE, 1.0 / CONTACT_SHARE
PER_SLIP_SHARE = 1.0 / SLIP_SHARE
#: Steps shorter than this share of the impact step are not taken to land on a crossing.
SHORTEST = 1e-3
#: A flight is at its end within this time [s].
ARRIVED = 1e-12
#: A flight cruises while its cages cannot come to anything within so many free steps ...
ROOMY_STEPS = 8.0
#: ... and this far [m].
ROOM = 1e-3
#: Cages are taken to be this much faster than at the beginning of a step.
HASTE = 2.0
#: Against division by zero.
TINY = 1e-9


class Timing(NamedTuple):
    """When to stop, how finely to step, and when an impact is over."""

    until: float  # end of the flight [s]
    free_step: float  # in free flight [s]
    impact_step: float  # while something touches or a stop is pressed [s]
    settle_step: float  # while the arms settle [s]
    arm_tolerance: float  # an arm has settled within this distance of its balance [m] ...
    rate_tolerance: float  # ... and this rate [m/s]
    dwell: float  # a new touch later than this starts a new impact [s]
    hybrid: float  # 1: one rigid body in free flight; 0: the arms are always free to slide


class Model(NamedTuple):
    """Everything a flight needs, as numbers."""

    airframe: Airframe
    world: World
    contact_point: Any  # Ring or ArmTip
    guide: Any  # Free or Slider
    air: Any  # Still or Air
    thrust: tuple[float, ...]  # of each rotor [N]
    timing: Timing


class Record(NamedTuple):
    """Streaming measures of one flight.  The first seven fields steer the executor."""

    time: float  # [s]
    step: float  # the step about to be taken [s]
    status: float  # FLYING, FINISHED, NOT_FINITE
    phase: float  # FREE_FLIGHT, IMPACT
    request: float  # NOTHING, LOCK_ARMS, APPLY_IMPULSE
    cruising: float  # STEERED, CRUISING, MAY_LOOK
    room: float  # at least so far is every part from every obstacle [m]

    steps: float  # taken so far
    touching: float  # 1 while any cage, or the hull, touches
    contacts: float  # times that the vehicle came into contact, one by one
    engaged: Engaged  # 1 where something touches
    arm_contacts: tuple[float, ...]  # the same for each cage
    hull_contacts: tuple[float, ...]  # the same for the main body, if it has a hull
    impacts: float  # contacts closer than the dwell time are one impact
    impact_open: float
    last_touch_time: float  # [s]
    contact_duration: float  # total time in contact [s]

    inward: Vec  # normal into the obstacle at first touch, world
    touch_time: float  # [s]
    touch_depth: float  # n · p of the main body at first touch [m]
    touch_speed: float  # n · v of the main body [m/s]
    touch_mass_centre_speed: float  # n · v of the centre of mass [m/s]
    separation_time: float  # last separation of the first impact [s]
    separation_speed: float  # n · v of the main body [m/s]
    separation_mass_centre_speed: float  # [m/s]
    return_time: float  # the main body is back at n · p of first touch [s]
    return_speed: float  # n · v of the main body [m/s]

    # Of the whole flight.
    peak_acceleration: float  # ‖v̇‖ of the main body [m/s²]
    peak_acceleration_time: float  # [s]
    peak_specific_force: float  # ‖v̇ + g e_Z‖ of the main body [m/s²]
    peak_angular_rate: float  # ‖ω‖ [rad/s]
    peak_normal_force: float  # largest f_n of one cage, or of the hull [N]
    peak_penetration: float  # δ [m]
    peak_compression: float  # L − l [m]
    peak_extension: float  # l − L [m]
    # The same of the first impact, from its first touch on until its arms have settled.
    impact_peak_acceleration: float
    impact_peak_acceleration_time: float
    impact_peak_specific_force: float
    impact_peak_angular_rate: float
    impact_peak_normal_force: float
    impact_penetration: float
    impact_arm_stroke: float
    impact_arm_extension: float
    travel: float  # n · p past its value at first touch, until the last separation [m]
    bottomed_time: float  # an arm reached the end of its stroke [s]
    ground_time: float  # a cage, or the hull, touched the ground [s]
    recent: Recent  # the last two instants, for peaks between instants


def blank_record(arm_count: int, obstacle_count: int = 1, hull_count: int = 0) -> Record:
    """The record of a flight that has not begun."""
    never, none = -1.0, (0.0,) * arm_count
    apart = (0.0,) * obstacle_count
    engaged = Engaged((apart,) * arm_count, (apart,) * hull_count)
    return Record(
        time=0.0, step=0.0, status=FLYING, phase=FREE_FLIGHT, request=NOTHING,
        cruising=MAY_LOOK, room=0.0,
        steps=0.0, touching=0.0, contacts=0.0, engaged=engaged, arm_contacts=none,
        hull_contacts=(0.0,) * hull_count,
        impacts=0.0, impact_open=0.0, last_touch_time=never, contact_duration=0.0,
        inward=Vec(0.0, 0.0, 0.0), touch_time=never, touch_depth=0.0, touch_speed=0.0,
        touch_mass_centre_speed=0.0, separation_time=never, separation_speed=0.0,
        separation_mass_centre_speed=0.0, return_time=never, return_speed=0.0,
        peak_acceleration=0.0, peak_acceleration_time=0.0, peak_specific_force=0.0,
        peak_angular_rate=0.0, peak_normal_force=0.0, peak_penetration=0.0,
        peak_compression=0.0, peak_extension=0.0,
        impact_peak_acceleration=0.0, impact_peak_acceleration_time=never,
        impact_peak_specific_force=0.0, impact_peak_angular_rate=0.0,
        impact_peak_normal_force=0.0, impact_penetration=0.0, impact_arm_stroke=0.0,
        impact_arm_extension=0.0, travel=0.0,
        bottomed_time=never, ground_time=never, recent=NOTHING_YET,
    )  # fmt: skip


@kernel
def _extension(arm: ArmView) -> float:
    return -arm.compression


@kernel
def _change(now: float, before: float) -> float:
    return (now - before) * (now - before)


@kernel
def _largest_change(now: tuple[float, ...], before: tuple[float, ...]) -> float:
    return maximum(tree_map(_change, (now, before), ()))


@kernel
def _touching(engaged: tuple[float, ...]) -> float:
    return maximum(engaged)


@kernel
def _unsettled(arm: Arm, view: ArmView, rate: float, timing: Timing) -> float:
    """1 while a sliding arm is away from where it would come to rest, or moves.

    That is its free length only while the vehicle does not turn.
    """
    away = abs(view.unbalance) > arm.stiffness * timing.arm_tolerance
    moving = abs(rate) > timing.rate_tolerance
    return arm.compliance if away | moving else 0.0


@kernel
def _rises(now: float, before: float) -> float:
    return 1.0 if now > before else 0.0


@kernel
def _count(so_far: float, now: float, before: float) -> float:
    return so_far + _rises(now, before)


@kernel
def has_room(timing: Timing, room: float, fastest: float) -> bool:
    """Whether nothing can touch anything for a while.

    Args:
        timing: Of the flight.
        room: At least so far is every part from every obstacle [m].
        fastest: None is faster [m/s].
    """
    return room > ROOMY_STEPS * HASTE * fastest * timing.free_step + ROOM


@kernel
def cruised_past(
    model: Model, flight: RigidState, known: RigidRates, m: Record, good: bool, step: float
) -> Record:
    """The record after one step as one rigid body: `observed` where nothing can happen.

    Args:
        model: Of the flight.
        flight: Motion at the beginning of the step.
        known: Its rates.
        m: The record before.
        good: Whether the step leads to finite numbers.
        step: Taken [s].
    """
    a, felt = norm(known.flight.velocity), norm(known.specific_force)
    spin = norm(flight.angular_velocity)
    fastest = fastest_point(model.airframe, flight.velocity, flight.angular_velocity)
    room = m.room - HASTE * fastest * step
    return replace(
        m,
        time=m.time + select(good, step, 0.0),
        step=step,
        status=select(good, m.status, NOT_FINITE),
        cruising=select(good & has_room(model.timing, room, fastest), CRUISING, MAY_LOOK),
        room=room,
        steps=m.steps + 1.0,
        peak_acceleration=larger(a, m.peak_acceleration),
        peak_acceleration_time=select(a > m.peak_acceleration, m.time, m.peak_acceleration_time),
        peak_specific_force=larger(felt, m.peak_specific_force),
        peak_angular_rate=larger(spin, m.peak_angular_rate),
        recent=Recent(m.step, m.recent.latest, PeakSample(a, felt, 0.0)),
    )


@kernel
def returns_yet(impacts: float, m: Record) -> bool:
    """Whether the return from the first of so many impacts is still to come."""
    return (impacts == 1.0) & (m.return_time < 0.0) & (m.touch_time >= 0.0)


@kernel
def is_quiet(
    timing: Timing, touching: float, phase: float, impact_open: float, ahead: bool
) -> bool:
    """Whether nothing goes on that a step as one rigid body would miss."""
    still = (touching == 0.0) & (phase == FREE_FLIGHT) & (impact_open == 0.0)
    return still & (not ahead) & (timing.hybrid > 0.0)


@kernel
def _grown(counts: bool, value: float, so_far: float) -> float:
    """The largest value so far, where this one counts."""
    return select(counts, larger(value, so_far), so_far)


class Sight(NamedTuple):
    """What a look at how far everything is comes to: the fields of `Record`."""

    cruising: float
    room: float


@kernel
def looked_about(model: Model, state: State, m: Record) -> Sight:
    """A look at how far everything is, which is no step."""
    near = clearance(model.airframe, model.world, model.contact_point, state)
    fastest = fastest_point(model.airframe, state.velocity, state.angular_velocity)
    ahead = returns_yet(m.impacts, m)
    quiet = is_quiet(model.timing, m.touching, m.phase, m.impact_open, ahead)
    cruising = select(quiet & has_room(model.timing, near, fastest), CRUISING, STEERED)
    return Sight(cruising, near)


@kernel
def observed(model: Model, motion: Motion, view: View, m: Record) -> Record:
    """The record after one more instant, with the next step and phase decided.

    No branches: every line is an arithmetic selection, so that lanes of flights stay abreast.
    """
    timing, state = model.timing, motion.state
    engaged = Engaged(field_of(view.arms, "engaged"), field_of(view.hull, "engaged"))
    arm_touching = tree_map(_touching, (engaged.arms,), ())
    hull_touching = tree_map(_touching, (engaged.hull,), ())
    touching = maximum(arm_touching + hull_touching)
    began, ended = touching > m.touching, touching < m.touching

    # The first touch fixes the direction along which speeds are measured.
    never_touched = m.contacts == 0.0
    first = began & never_touched
    length = norm(view.touched)
    inward = select(first, view.touched * (1.0 / select(length > 0.0, length, 1.0)), m.inward)
    depth, speed = inward @ state.position, inward @ state.velocity
    centre_speed = inward @ view.mass_centre_velocity
    touch_depth = select(first, depth, m.touch_depth)

    # Phases: locked or not, and how finely to step.
    unsettled = maximum(
        tree_map(_unsettled, (model.airframe.arms, view.arms, state.arm_rate), (timing,))
    )
    still_busy = select(unsettled > 0.0, m.phase, FREE_FLIGHT)
    phase = select(touching > 0.0, IMPACT, still_busy)
    settles = phase < m.phase
    lock = settles & (timing.hybrid > 0.0)
    # Time goes on between two impulses, whatever the first one left closing in.
    impulsive = maximum(field_of(view.arms, "impulsive") + field_of(view.hull, "impulsive"))
    strike = (impulsive > 0.0) & (m.request != APPLY_IMPULSE)

    # Impacts: contacts closer together than the dwell time belong to one.
    last_touch = select(touching > 0.0, m.time, m.last_touch_time)
    over = (phase == FREE_FLIGHT) & (m.time - last_touch > timing.dwell)
    impact_open = select(touching > 0.0, 1.0, select(over, 0.0, m.impact_open))
    impacts = m.impacts + _rises(impact_open, m.impact_open)
    of_first = (impacts == 1.0) & (impact_open > 0.0)
    leaves = ended & of_first
    within = (impacts == 1.0) & (phase == IMPACT)  # until its arms have settled
    ahead = returns_yet(impacts, m)
    returns = ahead & (depth - touch_depth <= LANDED) & (speed < 0.0)

    # The next step lands on the next crossing: touch, separation, stop, return.  A crossing that is
    # predicted from afar is met from nearby: a second prediction is a hundred times as good.
    crossings = field_of(view.arms, "crossing") + field_of(view.hull, "crossing")
    returning = crossing(depth - touch_depth, select(ahead, speed, 0.0))
    time_to_crossing = time_to(sooner(soonest(crossings), returning))
    time_to_crossing = select(
        time_to_crossing > timing.impact_step,
        time_to_crossing - 0.5 * timing.impact_step,
        time_to_crossing,
    )
    pressed = larger(touching, maximum(field_of(view.arms, "stopped"))) > 0.0
    impact_step = select(pressed, timing.impact_step, timing.settle_step)
    sliding = (phase > 0.0) | (timing.hybrid == 0.0)
    step = select(sliding, impact_step, timing.free_step)
    step = smaller(step, larger(time_to_crossing, SHORTEST * timing.impact_step))
    # No point moves faster than this, so nothing can touch unnoticed within the step.
    fastest = fastest_point(model.airframe, state.velocity, state.angular_velocity)
    near = minimum(field_of(view.arms, "gap") + field_of(view.hull, "gap"))
    haste = larger(fastest_cage(model.airframe, state), TINY)
    stiff = larger(view.contact_rate * PER_CONTACT_SHARE, view.slip_rate * PER_SLIP_SHARE)
    stiff = larger(larger(stiff, view.friction_rate * PER_FRICTION_SHARE), 1.0)
    both = 1.0 / (haste * stiff)  # one division for two
    step = smaller(step, larger(near * (stiff * both), timing.impact_step))
    step = smaller(step, larger(haste * both, SHORTEST * timing.impact_step))
    left = timing.until - m.time
    finished = left <= ARRIVED
    changed = (phase != m.phase) | strike
    halted = finished | changed | (m.status != FLYING)
    step = select(halted, 0.0, smaller(step, left))
    quiet = is_quiet(timing, touching, phase, impact_open, ahead) & (step > 0.0)
    cruising = select(quiet & has_room(timing, near, fastest), CRUISING, STEERED)

    now = PeakSample(
        norm(view.acceleration),
        norm(view.specific_force),
        maximum(field_of(view.arms, "normal") + field_of(view.hull, "normal")),
    )
    parts = (engaged.arms + engaged.hull, m.engaged.arms + m.engaged.hull)
    jumped = maximum(tree_map(_largest_change, parts, ())) > 0.0
    smooth = (m.step > 0.0) & (not jumped)
    apart, earlier, latest = spacing(m.recent, m.step, smooth), m.recent.earlier, m.recent.latest
    hardest = peak_of(earlier.acceleration, latest.acceleration, now.acceleration, apart)
    felt = peak_of(earlier.specific_force, latest.specific_force, now.specific_force, apart).value
    normal = peak_of(earlier.normal_force, latest.normal_force, now.normal_force, apart).value
    a, hardest_time = hardest.value, m.time + hardest.time
    grew, hit_harder = a > m.peak_acceleration, within & (a > m.impact_peak_acceleration)
    spin = norm(state.angular_velocity)
    depth_in = maximum(field_of(view.arms, "depth") + field_of(view.hull, "depth"))
    stroke = maximum(field_of(view.arms, "compression"))
    extension = maximum(tree_map(_extension, (view.arms,), ()))
    bottomed = maximum(field_of(view.arms, "bottomed")) > 0.0
    return Record(
        time=m.time,
        step=step,
        status=select((m.status == FLYING) & finished, FINISHED, m.status),
        phase=phase,
        request=select(strike, APPLY_IMPULSE, select(lock, LOCK_ARMS, NOTHING)),
        cruising=cruising,
        room=near,
        steps=m.steps + select(step > 0.0, 1.0, 0.0),
        touching=touching,
        contacts=m.contacts + select(began, 1.0, 0.0),
        engaged=engaged,
        arm_contacts=tree_map(
            _count, (m.arm_contacts, arm_touching, tree_map(_touching, (m.engaged.arms,), ())), ()
        ),
        hull_contacts=tree_map(
            _count, (m.hull_contacts, hull_touching, tree_map(_touching, (m.engaged.hull,), ())), ()
        ),
        impacts=impacts,
        impact_open=impact_open,
        last_touch_time=last_touch,
        contact_duration=m.contact_duration + select(touching > 0.0, step, 0.0),
        inward=inward,
        touch_time=select(first, m.time, m.touch_time),
        touch_depth=touch_depth,
        touch_speed=select(first, speed, m.touch_speed),
        touch_mass_centre_speed=select(first, centre_speed, m.touch_mass_centre_speed),
        separation_time=select(leaves, m.time, m.separation_time),
        separation_speed=select(leaves, speed, m.separation_speed),
        separation_mass_centre_speed=select(leaves, centre_speed, m.separation_mass_centre_speed),
        return_time=select(returns, m.time, m.return_time),
        return_speed=select(returns, speed, m.return_speed),
        peak_acceleration=larger(a, m.peak_acceleration),
        peak_acceleration_time=select(grew, hardest_time, m.peak_acceleration_time),
        peak_specific_force=larger(felt, m.peak_specific_force),
        peak_angular_rate=larger(spin, m.peak_angular_rate),
        peak_normal_force=larger(normal, m.peak_normal_force),
        peak_penetration=larger(depth_in, m.peak_penetration),
        peak_compression=larger(stroke, m.peak_compression),
        peak_extension=larger(extension, m.peak_extension),
        impact_peak_acceleration=select(hit_harder, a, m.impact_peak_acceleration),
        impact_peak_acceleration_time=select(
            hit_harder, hardest_time, m.impact_peak_acceleration_time
        ),
        impact_peak_specific_force=_grown(within, felt, m.impact_peak_specific_force),
        impact_peak_angular_rate=_grown(within, spin, m.impact_peak_angular_rate),
        impact_peak_normal_force=_grown(within, normal, m.impact_peak_normal_force),
        impact_penetration=_grown(within, depth_in, m.impact_penetration),
        impact_arm_stroke=_grown(within, stroke, m.impact_arm_stroke),
        impact_arm_extension=_grown(within, extension, m.impact_arm_extension),
        travel=_grown(of_first & ((touching > 0.0) | ended), depth - touch_depth, m.travel),
        bottomed_time=select(bottomed & (m.bottomed_time < 0.0), m.time, m.bottomed_time),
        ground_time=select((view.on_ground > 0.0) & (m.ground_time < 0.0), m.time, m.ground_time),
        recent=select(
            m.status == FLYING,
            Recent(select(smooth, m.step, 0.0), latest, now),
            m.recent,
        ),
    )
