"""A shell under the impulse law: a jump of its spin, beside that of the main body.

Bearings pass no impulse: their moments are finite.  An impulse P at a point ρ of a shell whose
centre is c gives the spin of its own a jump, and the main body what is left of the moment:

    I_s Δs = Q ((ρ − c) × P),   on the main body: ρ × P − Q ((ρ − c) × P),

both about the centre of mass.  Q is 1 for a sphere in a gimbal, a aᵀ for a ring about its axis a.
The point moves with v + ω × ρ + Q (s − ω) × (ρ − c).
"""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, rare_kernel
from springback.kernels.trees import fold, replace, tree_map
from springback.kernels.vectors import Mat3, Vec
from springback.vehicle.state import PartMemory, Shell, VehicleMemory


class ShellImpulse(NamedTuple):
    """A shell at the instant of an impulse, world axes."""

    centre: Vec  # c, from the centre of mass [m]
    axis: tuple[Vec, ...]  # a, of a ring
    inverse_inertia: float  # 1/I_s [1/(kg m²)]
    spin: Vec  # Ω of a sphere, s of a ring; or a jump of it [rad/s]


@generic
def shells_hit(
    hull: Any, memory: PartMemory, r: Mat3, mass_centre: Vec
) -> tuple[ShellImpulse, ...]:
    """The shell, if a hull is one.

    Args:
        hull: Of the main body.
        memory: Of the hull.
        r: Body axes to world axes.
        mass_centre: From the main body, world [m].
    """
    return ()


@shells_hit.register(Shell)
@rare_kernel
def _shell_hit(hull: Shell, memory: PartMemory, r: Mat3, mass_centre: Vec) -> tuple[ShellImpulse]:
    axis = tree_map(_turned, (hull.axis,), (r,))
    centre = r @ hull.centre - mass_centre
    return (ShellImpulse(centre, axis, 1.0 / hull.inertia, memory.spin[0]),)


@rare_kernel
def _turned(axis: Vec, r: Mat3) -> Vec:
    return r @ axis


@rare_kernel
def _along(turned: Vec, axis: Vec) -> Vec:
    return (turned @ axis) * axis


@rare_kernel
def _of_its_own(shell: ShellImpulse, turned: Vec) -> Vec:
    """Q x: the part of a moment, or of a rate, that is the shell's alone."""
    return fold(_along, turned, shell.axis, ())


@rare_kernel
def velocity_at(
    v: Vec, w: Vec, lever: Vec, on_hull: float, shells: tuple[ShellImpulse, ...]
) -> Vec:
    """Velocity of a point, world [m/s]; or a jump of it.

    Args:
        v: Velocity of the centre of mass, world [m/s].
        w: Angular velocity of the main body, world [rad/s].
        lever: ρ, from the centre of mass, world [m].
        on_hull: 1 for a point of the hull, 0 for one of a cage.
        shells: The hull's shell, if it is one.
    """
    return fold(_with_spin, v + (w ^ lever), shells, (w, lever, on_hull))


@rare_kernel
def _with_spin(velocity: Vec, shell: ShellImpulse, w: Vec, lever: Vec, on_hull: float) -> Vec:
    relative = _of_its_own(shell, shell.spin - w)
    return velocity + (relative ^ (lever - shell.centre)) * on_hull


@rare_kernel
def spin_moment(lever: Vec, impulse: Vec, on_hull: float, shells: tuple[ShellImpulse, ...]) -> Vec:
    """Moment of an impulse at a lever that turns the shell alone, world [N m s]."""
    return fold(_with_moment, Vec(0.0, 0.0, 0.0), shells, (lever, impulse, on_hull))


@rare_kernel
def _with_moment(so_far: Vec, shell: ShellImpulse, lever: Vec, impulse: Vec, on_hull: float) -> Vec:
    return so_far + _of_its_own(shell, (lever - shell.centre) ^ impulse) * on_hull


@rare_kernel
def jumps_of_spin(shells: tuple[ShellImpulse, ...], moment: Vec) -> tuple[ShellImpulse, ...]:
    """The shell with the jump of its spin by a moment [N m s] instead of its spin."""
    return tree_map(_jump, (shells,), (moment,))


@rare_kernel
def _jump(shell: ShellImpulse, moment: Vec) -> ShellImpulse:
    return replace(shell, spin=moment * shell.inverse_inertia)


@rare_kernel
def spun(
    shells: tuple[ShellImpulse, ...], jumps: tuple[ShellImpulse, ...], share: float
) -> tuple[ShellImpulse, ...]:
    """The shell after a share of a jump of its spin."""
    return tree_map(_spun, (shells, jumps), (share,))


@rare_kernel
def _spun(shell: ShellImpulse, jump: ShellImpulse, share: float) -> ShellImpulse:
    return replace(shell, spin=shell.spin + jump.spin * share)


@rare_kernel
def memory_with_spins(memory: Any, shells: tuple[ShellImpulse, ...]) -> Any:
    """What a vehicle's parts remember, with the spin of its shell, if it has one."""
    return fold(_with_spin_kept, memory, shells, ())


@rare_kernel
def _with_spin_kept(memory: VehicleMemory, shell: ShellImpulse) -> VehicleMemory:
    return replace(memory, hull=tree_map(_kept, (memory.hull,), (shell.spin,)))


@rare_kernel
def _kept(part: PartMemory, spin: Vec) -> PartMemory:
    return replace(part, spin=(spin,))
