"""Largest loads of what a vehicle bears only so much of, step by step.

They are looked at where a step begins, after the record of the same instant; between instants no
peak is interpolated.
"""

from __future__ import annotations

from typing import Any

from springback.dynamics.clearance import Search
from springback.dynamics.limbs.arms import spring_damper_force
from springback.dynamics.limbs.locked import RigidRates, RigidState
from springback.dynamics.motion import Motion, Rates, View
from springback.dynamics.stops import end_stop
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import field_of, replace, select, tree_map
from springback.kernels.vectors import Vec, larger, norm
from springback.simulation.measuring.record import (
    Model,
    Record,
    record_after,
    record_after_cruise,
)
from springback.vehicle.limits import NO_LIMIT, UNLIMITED, ComponentLimit, PeakLoad, PeakLoads
from springback.vehicle.state import Airframe, Arm, State


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


@kernel
def arm_force(arm: Arm, length: float, rate: float) -> float:
    """Force along an arm that slides, between its end and the main body [N]."""
    return abs(spring_damper_force(arm, length, rate) + end_stop(arm, length, rate).force)


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
    forces = tree_map(arm_force, (airframe.arms, state.arm_length, state.arm_rate), ())
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
    return replace(after, loads=loads)


@kernel
def cruise_record_with_loads(
    model: Model, x: RigidState, known: RigidRates, m: Record, good: bool, step: float
) -> Record:
    """`record_after_cruise`, arguments as there, with the loads of the parts."""
    after = record_after_cruise(model, x, known, m, good, step)
    loads = loads_after_cruise(m.loads, model.limits, x, known, m.stepping.time)
    return replace(after, loads=loads)
