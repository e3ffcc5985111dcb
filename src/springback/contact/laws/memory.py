"""What the contacts of a vehicle remember: elastic slip, and how deep they were.

Elastic slip is integrated with the motion; depths are renewed at the beginning of every step.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.contact.laws.bristles import BristleRate
from springback.contact.laws.hysteresis import next_memory, no_point
from springback.contact.loads import CageContact
from springback.kernels.compiler import generic, kernel
from springback.kernels.trees import field_of, fold, maximum, one_tuple, replace, tree_map, tree_sum
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.state import (
    Bristles,
    PartMemory,
    PressedPoint,
    PressedPoints,
    VehicleMemory,
)


class PartBristles(NamedTuple):
    """Bristles of one part of the vehicle: their rate, and their limits on steps."""

    rate: Bristles
    turning: float  # rolling resistance as a damper [N m s]
    recovery: float  # rate at which they come to rest [1/s]; 0 without contact


@kernel
def _with_contact(total: BristleRate, more: BristleRate) -> BristleRate:
    return tree_sum((total, more))


@kernel
def _of_part(bristles: Bristles, contacts: tuple[BristleRate, ...], r: Mat3) -> PartBristles:
    none = Vec(0.0, 0.0, 0.0)
    all_ = fold(_with_contact, BristleRate(none, none, 0.0, 0.0, 0.0), contacts, ())
    share = 1.0 / all_.weight if all_.weight > 0.0 else 0.0
    rate = Bristles(r @ (all_.slip * share), r @ (all_.roll * share))
    return PartBristles(rate, all_.turning, all_.recovery)


@kernel
def bristles_of(
    memory: PartMemory, met: tuple[CageContact, ...], r: Mat3
) -> tuple[PartBristles, ...]:
    """Rate of the bristles of a part: the mean over its contacts, weighted by normal forces.

    Args:
        memory: Of the part.
        met: The faces that it meets.
        r: Body axes to world axes.
    """
    return tree_map(_of_part, (memory.bristles,), (one_tuple(field_of(met, "bristles")), r))


@kernel
def pressed_of(memory: PartMemory, met: tuple[CageContact, ...]) -> tuple[PressedPoints, ...]:
    """What a part will remember of how deep its contacts were.

    Args:
        memory: Of the part.
        met: The faces that it meets.
    """
    return tree_map(next_memory, (memory.pressed,), (one_tuple(field_of(met, "pressed")),))


@generic
def arm_memory(memory: Any, arms: tuple[Any, ...]) -> tuple[PartMemory, ...]:
    """For each arm what its contacts remember; mostly nothing."""
    return tree_map(_nothing, (arms,), ())


@generic
def hull_memory(memory: Any, hull: tuple[Any, ...]) -> tuple[PartMemory, ...]:
    """As `arm_memory`, for the hull of the main body."""
    return tree_map(_nothing, (hull,), ())


@kernel
def _nothing(part: Any) -> PartMemory:
    return PartMemory((), (), (), ())


@arm_memory.register(VehicleMemory)
@kernel
def _given_arm_memory(memory: VehicleMemory, arms: tuple[Any, ...]) -> tuple[PartMemory, ...]:
    return memory.arms


@kernel
def _of_hull(none: tuple[()], hull: Any, memory: tuple[PartMemory, ...]) -> tuple[PartMemory, ...]:
    return memory


@hull_memory.register(VehicleMemory)
@kernel
def _given_hull_memory(memory: VehicleMemory, hull: tuple[Any, ...]) -> tuple[PartMemory, ...]:
    return fold(_of_hull, (), hull, (memory.hull,))  # without a hull, where that touches nothing


@generic
def memory_rates(
    memory: Any,
    arms: tuple[tuple[PartBristles, ...], ...],
    hull: tuple[tuple[PartBristles, ...], ...],
    spins: tuple[tuple[Vec, ...], ...],
) -> Any:
    """Rate of what the contacts of a vehicle remember, as its state has it.

    Args:
        memory: Of the state.
        arms: Bristles of each arm.
        hull: Bristles of the hull, if it takes part.
        spins: Ω̇ of the hull, if it is a shell that turns by itself [rad/s²].
    """
    return ()


@kernel
def _no_rate(bristles: Bristles) -> Bristles:
    none = Vec(0.0, 0.0, 0.0)
    return Bristles(none, none)


@kernel
def _fixed_point(point: PressedPoint) -> PressedPoint:
    return no_point()


@kernel
def _fixed(pressed: PressedPoints) -> PressedPoints:
    return PressedPoints(0.0, tree_map(_fixed_point, (pressed.points,), ()))


@kernel
def _no_spin(spin: Vec) -> Vec:
    return Vec(0.0, 0.0, 0.0)


@kernel
def _unchanged(stiffness: float) -> float:
    return 0.0


@kernel
def _still(memory: PartMemory) -> PartMemory:
    return PartMemory(
        tree_map(_no_rate, (memory.bristles,), ()), tree_map(_fixed, (memory.pressed,), ()),
        tree_map(_no_spin, (memory.spin,), ()), tree_map(_unchanged, (memory.stiffness,), ()),
    )  # fmt: skip


@kernel
def _part_rate(memory: PartMemory, bristles: tuple[PartBristles, ...]) -> PartMemory:
    return PartMemory(
        field_of(bristles, "rate"), tree_map(_fixed, (memory.pressed,), ()), (),
        tree_map(_unchanged, (memory.stiffness,), ()),
    )  # fmt: skip


@kernel
def _turning_rate(
    memory: PartMemory, bristles: tuple[PartBristles, ...], spin: tuple[Vec, ...]
) -> PartMemory:
    return replace(_part_rate(memory, bristles), spin=spin)


@kernel
def _hull_rate(
    so_far: tuple[PartMemory, ...],
    bristles: tuple[PartBristles, ...],
    memory: tuple[PartMemory, ...],
    spins: tuple[tuple[Vec, ...], ...],
) -> tuple[PartMemory, ...]:
    return tree_map(_turning_rate, (memory, (bristles,), spins), ())


@memory_rates.register(VehicleMemory)
@kernel
def _vehicle_rates(
    memory: VehicleMemory,
    arms: tuple[tuple[PartBristles, ...], ...],
    hull: tuple[tuple[PartBristles, ...], ...],
    spins: tuple[tuple[Vec, ...], ...],
) -> VehicleMemory:
    of_hull = fold(_hull_rate, tree_map(_still, (memory.hull,), ()), hull, (memory.hull, spins))
    return VehicleMemory(tree_map(_part_rate, (memory.arms, arms), ()), of_hull)


@kernel
def friction_rate_with_bristles(rate: float, part: PartBristles, largest: float) -> float:
    """Upper bound on the rate at which friction stops a part, with its bristles [1/s].

    Args:
        rate: Bound without them [1/s].
        part: Its bristles.
        largest: Largest reciprocal of the inertia about the main body [1/(kg m²)].
    """
    return rate + 1.5 * part.turning * largest + 2.0 * part.recovery


@generic
def memory_after(memory: Any, arms: tuple[Any, ...], hull: tuple[Any, ...]) -> Any:
    """Memory after an instant: bristles of parts that touch nothing have sprung back.

    Args:
        memory: Of the state.
        arms: Views of the arms.
        hull: View of the hull, if there is one.
    """
    return ()


@kernel
def _held(bristles: Bristles, touches: float) -> Bristles:
    return Bristles(bristles.slip * touches, bristles.roll * touches)


@kernel
def _part_after(memory: PartMemory, view: Any) -> PartMemory:
    bristles = tree_map(_held, (memory.bristles,), (maximum(view.engaged),))
    return PartMemory(bristles, view.pressed, memory.spin, memory.stiffness)


@memory_after.register(VehicleMemory)
@kernel
def _vehicle_after(
    memory: VehicleMemory, arms: tuple[Any, ...], hull: tuple[Any, ...]
) -> VehicleMemory:
    return VehicleMemory(
        tree_map(_part_after, (memory.arms, arms), ()),
        tree_map(_part_after, (memory.hull, hull), ()),
    )


@kernel
def _of_point(so_far: float, point: PressedPoint) -> float:
    return so_far + point.lost


@kernel
def _of_pressed(so_far: float, pressed: PressedPoints) -> float:
    return fold(_of_point, so_far, pressed.points, ())


@kernel
def _with_part(so_far: float, memory: PartMemory) -> float:
    return fold(_of_pressed, so_far, memory.pressed, ())


@generic
def energy_lost_deeper(memory: Any) -> float:
    """Energy that the contacts of a vehicle lost by coming deeper in the last step [J].

    Args:
        memory: By `memory_after` that step.
    """
    return 0.0


@energy_lost_deeper.register(VehicleMemory)
@kernel
def _vehicle_lost(memory: VehicleMemory) -> float:
    return fold(_with_part, 0.0, memory.arms + memory.hull, ())
