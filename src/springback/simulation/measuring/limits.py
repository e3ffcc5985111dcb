"""Largest loads on the parts of a vehicle that have limits, step by step.

They are evaluated where a step begins, after the record of the same instant; between instants no
peak is interpolated.
"""

from __future__ import annotations

from typing import Any

from springback.dynamics.clearance import Search
from springback.dynamics.crossing import NO_CROSSING
from springback.dynamics.limbs.arms import spring_damper_force
from springback.dynamics.limbs.locked import RigidRates, RigidState
from springback.dynamics.motion import Motion, Rates, View
from springback.dynamics.stops import end_stop
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import (
    field_of,
    fold,
    maximum,
    minimum,
    replace,
    select,
    tree_map,
)
from springback.kernels.vectors import Vec, larger, norm, smaller
from springback.simulation.measuring.record import (
    BREAK_GUARDS,
    NOTHING,
    SHORTEST,
    Model,
    Record,
    record_after,
    record_after_cruise,
)
from springback.vehicle.arms.bent import BentArm, BentCoordinates
from springback.vehicle.limits import (
    NO_LIMIT,
    UNLIMITED,
    ComponentLimit,
    GuardStiffness,
    JointShares,
    LoadLimits,
    PeakLoad,
    PeakLoads,
)
from springback.vehicle.state import (
    Airframe,
    PartMemory,
    State,
    VehicleMemory,
    coordinates_of_arms,
    rates_of_arms,
)

#: A step to a break is to end a little beyond the limit: at this share of it.
BEYOND = 1.0 + 1e-9


@kernel
def specific_force_at(position: Vec, centre: Vec, omega: Vec, angular: Vec) -> Vec:
    """Specific force at a point of the main body, body axes [m/s²].

    Args:
        position: From the centre of the main body, body axes [m].
        centre: a' there, body axes [m/s²].
        omega: ω, body axes [rad/s].
        angular: α = ω̇, body axes [rad/s²].
    """
    return centre + (angular ^ position) + (omega ^ (omega ^ position))


@kernel
def _grown(before: PeakLoad, load: float, limit: float, time: float) -> PeakLoad:
    share = load / limit
    breaks = (share > 1.0) & (before.broken_time == -1.0)
    broken = select(breaks, time, before.broken_time)
    return PeakLoad(larger(share, before.share), select(limit < UNLIMITED, broken, NO_LIMIT))


@kernel
def _idle(before: PeakLoad, limit: float, time: float) -> PeakLoad:
    return _grown(before, 0.0, limit, time)


@kernel
def _felt(component: ComponentLimit, centre: Vec, omega: Vec, angular: Vec) -> float:
    felt: float = norm(specific_force_at(component.position, centre, omega, angular))
    return felt


@generic
def arm_force(arm: Any, length: Any, rate: Any, shares: JointShares) -> float:
    """Force along the path of an arm that can move, between its end and the main body [N]."""
    return abs(spring_damper_force(arm, length, rate) + end_stop(arm, length, rate).force)


@arm_force.register(BentArm)
@kernel
def _force_of_two(
    arm: BentArm, length: BentCoordinates, rate: BentCoordinates, shares: JointShares
) -> float:
    """The larger of both, each as a share of its own limit."""
    outer_joint, at, speed = arm.second, length, rate
    first = spring_damper_force(arm, at.first, speed.first)
    first += end_stop(arm, at.first, speed.first).force
    second = spring_damper_force(outer_joint, at.second, speed.second)
    second += end_stop(outer_joint, at.second, speed.second).force
    return larger(shares.first * abs(first), shares.second * abs(second))


@generic
def loads_after(
    loads: Any, limits: Any, airframe: Airframe, state: State, view: View, angular: Vec, time: float
) -> Any:
    """Largest loads after an instant, where they are looked at.

    Args:
        loads: `PeakLoads` before; empty for a vehicle without limits.
        limits: `LoadLimits`, likewise.
        airframe: Constants of the vehicle.
        state: Its state.
        view: At that instant.
        angular: Angular acceleration, body axes [rad/s²].
        time: Of the instant [s].
    """
    return loads


@loads_after.register(object)
@kernel
def _not_looked_at(
    loads: Any, limits: Any, airframe: Airframe, state: State, view: View, angular: Vec, time: float
) -> Any:
    return loads


@loads_after.register(PeakLoads)
@kernel
def _loads_seen(
    loads: PeakLoads, limits: Any, airframe: Airframe, state: State, view: View, angular: Vec,
    time: float,
) -> PeakLoads:  # fmt: skip
    lengths, arm = coordinates_of_arms(airframe.arms[0], state), airframe.arms[0]
    moves = (airframe.arms, lengths, rates_of_arms(arm, state), limits.joints)
    forces = tree_map(arm_force, moves, ())
    at = (view.specific_force, state.angular_velocity, angular)
    felt = tree_map(_felt, (limits.components,), at)
    normal, most = field_of(view.arms, "normal"), field_of(limits.components, "most")
    return PeakLoads(
        tree_map(_grown, (loads.guards, normal, limits.guards), (time,)),
        tree_map(_grown, (loads.arms, forces, limits.arms), (time,)),
        tree_map(_grown, (loads.components, felt, most), (time,)),
        limits.breaks,
    )


@generic
def loads_after_cruise(
    loads: Any, limits: Any, x: RigidState, known: RigidRates, time: float
) -> Any:
    """Largest loads after a step as one rigid body: of components only.

    Args:
        loads: As for `loads_after`.
        limits: As for `loads_after`.
        x: Motion at the beginning of the step.
        known: Its rates.
        time: Of that instant [s].
    """
    return loads


@loads_after_cruise.register(object)
@kernel
def _not_looked_at_in_cruise(
    loads: Any, limits: Any, x: RigidState, known: RigidRates, time: float
) -> Any:
    return loads


@loads_after_cruise.register(PeakLoads)
@kernel
def _loads_in_cruise(
    loads: PeakLoads, limits: Any, x: RigidState, known: RigidRates, time: float
) -> PeakLoads:
    at = (known.specific_force, x.angular_velocity, known.flight.angular_velocity)
    felt = tree_map(_felt, (limits.components,), at)
    most = field_of(limits.components, "most")
    return PeakLoads(
        tree_map(_idle, (loads.guards, limits.guards), (time,)),
        tree_map(_idle, (loads.arms, limits.arms), (time,)),
        tree_map(_grown, (loads.components, felt, most), (time,)),
        limits.breaks,
    )


@generic
def landing_on_break(
    limits: Any, after: Record, before: Record, memory: Any, shortest: float
) -> Record:
    """A record whose next step ends where a guard is loaded to its limit, and then breaks it.

    Only guards that lose stiffness are looked at.

    Args:
        limits: `LoadLimits`; empty for a vehicle without limits.
        after: Record after an instant.
        before: The same a step earlier.
        memory: Of the state.
        shortest: Of all steps to a break [s].
    """
    return after


@landing_on_break.register(LoadLimits)
@kernel
def _landing_on_limit(
    limits: LoadLimits, after: Record, before: Record, memory: Any, shortest: float
) -> Record:
    return fold(_or_break, after, limits.broken, (before, memory, shortest))


@kernel
def _is_due(stiffness: float, share: float, load: PeakLoad) -> float:
    return 1.0 if (load.broken_time >= 0.0) & (stiffness != share) else 0.0


@kernel
def _breaks(memory: PartMemory, share: float, load: PeakLoad) -> float:
    return maximum(tree_map(_is_due, (memory.stiffness,), (share, load)))


@kernel
def _until_break(left: float, load: PeakLoad, before: PeakLoad, step: float) -> float:
    """Time until a load that grows is beyond its limit, as it did within the last step [s]."""
    grown = load.share - before.share
    rises = (left < 1.0) & (load.broken_time == -1.0) & (grown > 0.0) & (step > 0.0)
    return (BEYOND - load.share) * step / grown if rises else NO_CROSSING


@kernel
def _or_break(
    after: Record, guards: GuardStiffness, before: Record, memory: VehicleMemory, shortest: float
) -> Record:
    now, contacts = after.stepping, after.contacts
    loads, left = after.loads.guards, guards.stiffness
    due = maximum(tree_map(_breaks, (memory.arms, left, loads), ()))
    # A step of length zero only carries out another request: its instant is not in the trajectory.
    asks = (due > 0.0) & (now.step > 0.0) & (now.request == NOTHING)
    grow = (left, loads, before.loads.guards)
    until = larger(minimum(tree_map(_until_break, grow, (before.stepping.step,))), shortest)
    step = smaller(now.step, select(asks, shortest, until))
    request = select(asks, BREAK_GUARDS, now.request)
    saved = select(contacts.touching > 0.0, now.step - step, 0.0)
    return replace(
        after, stepping=replace(now, step=step, request=request),
        contacts=replace(contacts, duration=contacts.duration - saved),
    )  # fmt: skip


@kernel
def record_with_loads(
    model: Model, motion: Motion, known: Rates, m: Record, search: Search
) -> Record:
    """`record_after` an instant, with the loads of the parts.

    Args:
        model: Of the flight.
        motion: At that instant.
        known: Its rates.
        m: Record before.
        search: By `springback.simulation.measuring.record.search_of`.
    """
    after = record_after(model, motion, known.seen, m, search)
    state, angular = motion.state, known.motion.state.angular_velocity
    loads = loads_after(
        m.loads, model.limits, model.airframe, state, known.seen, angular, m.stepping.time
    )
    shortest = SHORTEST * model.timing.impact_step
    return landing_on_break(model.limits, replace(after, loads=loads), m, state.memory, shortest)


@kernel
def cruise_record_with_loads(
    model: Model, x: RigidState, known: RigidRates, m: Record, good: bool, step: float
) -> Record:
    """`record_after_cruise`, arguments as there, with the loads of the parts."""
    after = record_after_cruise(model, x, known, m, good, step)
    loads = loads_after_cruise(m.loads, model.limits, x, known, m.stepping.time)
    return replace(after, loads=loads)
