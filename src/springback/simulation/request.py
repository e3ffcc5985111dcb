"""What happens to a motion between two steps, rarely: the request of a record, carried out."""

from __future__ import annotations

from typing import Any

from springback.contact.obstacles import Forces, Impulses
from springback.dynamics.energy import energy, energy_without_contact, locked_state
from springback.dynamics.impulse import apply_impulses
from springback.dynamics.motion import Motion
from springback.kernels.compiler import generic, kernel, rare_kernel
from springback.kernels.trees import fold, replace, select, tree_map
from springback.simulation.measuring.record import APPLY_IMPULSE, BREAK_GUARDS, Model
from springback.vehicle.limits import GuardStiffness, LoadLimits, PeakLoad, PeakLoads
from springback.vehicle.state import PartMemory, VehicleMemory


@rare_kernel
def settled_motion(model: Model, motion: Motion) -> Motion:
    """Motion with the arms locked where they are; the lost energy is booked as settling."""
    before = energy_without_contact(model.airframe, model.world, motion.state)
    state = locked_state(model.airframe, motion.state)
    after = energy_without_contact(model.airframe, model.world, state)
    lost = before.kinetic + before.gravity + before.springs + before.stops
    lost -= after.kinetic + after.gravity + after.springs + after.stops
    return Motion(state, replace(motion.work, settling=motion.work.settling + lost))


@generic
def motion_after_event(
    laws: Forces | Impulses, model: Model, motion: Motion, request: float
) -> Motion:
    """Motion after a rare event: settled arms are locked, impulses of surfaces applied."""
    return settled_motion(model, motion)


@motion_after_event.register(Impulses)
@rare_kernel
def _motion_after_impulses(laws: Impulses, model: Model, motion: Motion, request: float) -> Motion:
    if request == APPLY_IMPULSE:
        of = model
        return apply_impulses(of.airframe, of.world, of.contact_point, of.guide, motion)
    return settled_motion(model, motion)


@generic
def motion_after_request(
    limits: Any, loads: Any, model: Model, motion: Motion, request: float
) -> Motion:
    """Motion after the request of a record.

    Args:
        limits: Of the model; its type tells whether anything can break.
        loads: Of the record.
        model: Of the flight.
        motion: When the request is carried out.
        request: `APPLY_IMPULSE` and so on.
    """
    return motion_after_event(model.world.laws, model, motion, request)


@motion_after_request.register(LoadLimits)
@rare_kernel
def _motion_with_limits(
    limits: LoadLimits, loads: PeakLoads, model: Model, motion: Motion, request: float
) -> Motion:
    after = motion
    if request != BREAK_GUARDS:
        after = motion_after_event(model.world.laws, model, motion, request)
    return fold(_with_broken_guards, after, limits.broken, (loads, model))


@kernel
def _left(before: float, share: float, load: PeakLoad) -> float:
    return select(load.broken_time >= 0.0, share, before)


@kernel
def _after_break(memory: PartMemory, share: float, load: PeakLoad) -> PartMemory:
    return replace(memory, stiffness=tree_map(_left, (memory.stiffness,), (share, load)))


@rare_kernel
def _with_broken_guards(
    motion: Motion, guards: GuardStiffness, loads: PeakLoads, model: Model
) -> Motion:
    """Motion with the stiffness that broken guards have left.

    What their contacts held goes down with it; the difference is booked as lost in contact.
    """
    state, known = motion.state, (motion.state.memory.arms, guards.stiffness, loads.guards)
    memory = VehicleMemory(tree_map(_after_break, known, ()), state.memory.hull)
    weak = replace(state, memory=memory)
    before = energy(model.airframe, model.world, model.contact_point, state)
    after = energy(model.airframe, model.world, model.contact_point, weak)
    lost = before.contact - after.contact
    return Motion(weak, replace(motion.work, contact=motion.work.contact + lost))
