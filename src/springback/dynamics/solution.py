"""Solution of the six equations of motion by elimination, with guides or without."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Protocol

from springback.contact.obstacles import World
from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import (
    Mat3,
    Vec,
    inverse_symmetric,
    solve_symmetric,
    symmetric_part,
    transpose,
)
from springback.vehicle.state import Airframe, PlanarInverse


class SliderFriction(NamedTuple):
    """Dry friction of a slider's rail, the same whatever presses on it."""

    axis: Vec  # unit vector, world
    friction: float  # F [N]
    slip_speed: float  # v_s, below which it is regularised [m/s]


class Free(NamedTuple):
    """No constraint: six degrees of freedom and the arms."""

    unused: float
    rail: tuple[SliderFriction, ...] = ()  # always empty


class Slider(NamedTuple):
    """Constraint to one world axis without rotation, as on the paper's testbed."""

    axis: Vec  # unit vector, world
    rail: tuple[SliderFriction, ...] = ()  # its dry friction; empty without any


class Accelerations(NamedTuple):
    """Solution of the six equations."""

    linear: Vec  # a' = Rᵀ(v̇ + g e_Z), body [m/s²]
    angular: Vec  # α, body [rad/s²]


class System(NamedTuple):
    """The six equations of `springback.dynamics.motion`."""

    mass: float  # m [kg]
    sliding: Vec  # Σ u m (e_x², e_y², e_x e_y)
    inverse: PlanarInverse  # of M
    carried: Vec  # s, in the body plane
    inertia: Mat3  # J
    force: Vec  # right-hand side of a', body
    moment: Vec  # right-hand side of α, body


@kernel
def times(n: PlanarInverse, b: Vec) -> Vec:
    """Product M⁻¹ b."""
    return Vec(n.xx * b.x + n.xy * b.y, n.xy * b.x + n.yy * b.y, n.zz * b.z)


@generic
def solve(guide: Any, system: Any, r: Mat3, gravity: float) -> Accelerations:
    """Accelerations of the main body under a constraint."""
    raise TypeError(f"{type(guide).__name__} is not a guide")


@solve.register(Free)
@kernel
def _solve_free(guide: Free, system: Any, r: Mat3, gravity: float) -> Accelerations:
    return solve_freely(system)


@generic
def solve_freely(system: Any) -> Accelerations:
    """Solution of the six equations without constraint."""
    raise TypeError(f"{type(system).__name__} is no system of equations")


@solve_freely.register(System)
@kernel
def _solve_in_plane(system: System) -> Accelerations:
    """Eliminate the translation, a' = M⁻¹(b − α × s); then solve (J − Ĉᵀ M⁻¹ Ĉ) α, 3 x 3."""
    n, s = system.inverse, system.carried
    alone = times(n, system.force)
    j = system.inertia
    sxx, sxy, syy = s.x * s.x, s.x * s.y, s.y * s.y
    jxx, jyy, jxy = j.x.x - n.zz * syy, j.y.y - n.zz * sxx, j.x.y + n.zz * sxy
    jzz = j.z.z - (n.xx * syy - 2.0 * n.xy * sxy + n.yy * sxx)
    reduced = Mat3(Vec(jxx, jxy, j.x.z), Vec(jxy, jyy, j.y.z), Vec(j.x.z, j.y.z, jzz))
    alpha = solve_symmetric(reduced, system.moment - (s ^ alone))
    return Accelerations(alone - times(n, alpha ^ s), alpha)


@generic
def resisting(system: Any, u: Vec) -> Vec:
    """Product M u with the mass that resists translation."""
    raise TypeError(f"{type(system).__name__} is no system of equations")


@resisting.register(System)
@kernel
def _in_plane(system: System, u: Vec) -> Vec:
    m, slide = system.mass, system.sliding
    return Vec(
        (m - slide.x) * u.x - slide.z * u.y,
        (m - slide.y) * u.y - slide.z * u.x,
        m * u.z,
    )


class SpatialSystem(NamedTuple):
    """The six equations of a vehicle whose arms are on joints: three blocks, in body axes."""

    linear: Mat3  # of a' in the equations of force [kg]
    mixed: Mat3  # of α in the equations of force; transposed, of a' in those of moment [kg m]
    angular: Mat3  # of α in the equations of moment [kg m²]
    force: Vec  # right-hand side of a'
    moment: Vec  # right-hand side of α


@solve_freely.register(SpatialSystem)
@kernel
def _solve_in_space(system: SpatialSystem) -> Accelerations:
    """Eliminate the translation, then solve for α, as in the plane."""
    n, c = inverse_symmetric(system.linear), system.mixed
    nc = n @ c
    reduced = symmetric_part(system.angular - transpose(c) @ nc)
    alone = n @ system.force
    alpha = solve_symmetric(reduced, system.moment - alone @ c)
    return Accelerations(alone - nc @ alpha, alpha)


@resisting.register(SpatialSystem)
@kernel
def _in_space(system: SpatialSystem, u: Vec) -> Vec:
    return system.linear @ u


@solve.register(Slider)
@kernel
def _solve_slider(guide: Slider, system: Any, r: Mat3, gravity: float) -> Accelerations:
    """Solve along the slider, the only free direction: uᵀ M u ẍ = uᵀ(b − M Rᵀ g e_Z)."""
    u = guide.axis @ r
    weight = Vec(0.0, 0.0, gravity) @ r
    mu = resisting(system, u)
    along_axis = (u @ system.force - mu @ weight) / (mu @ u)
    return Accelerations(weight + along_axis * u, Vec(0.0, 0.0, 0.0))


# -- dry friction of a rail, for `fold` ------------------------------------------------------------


@kernel
def _per_speed(rail: SliderFriction, speed: float) -> float:
    return 1.0 / math.sqrt(speed * speed + rail.slip_speed * rail.slip_speed)


@kernel
def with_rail(force: Vec, rail: SliderFriction, velocity: Vec, r: Mat3) -> Vec:
    """A force, and that of a rail, −F v/√(v² + v_s²) along it, body axes [N].

    Coulomb's law, regularised as `springback.contact.surfaces.friction_force` is.

    Args:
        force: So far, body axes [N].
        rail: F [N], v_s [m/s].
        velocity: Of the main body, world [m/s].
        r: Body axes to world axes.
    """
    speed = rail.axis @ velocity
    return force - (rail.friction * speed * _per_speed(rail, speed)) * (rail.axis @ r)


@kernel
def rail_loss(loss: float, rail: SliderFriction, velocity: Vec) -> float:
    """A power, and that which a rail turns into heat [W]; arguments as for `with_rail`."""
    speed = rail.axis @ velocity
    return loss + rail.friction * speed * speed * _per_speed(rail, speed)


@kernel
def rail_friction_rate(
    so_far: float, rail: SliderFriction, velocity: Vec, system: Any, r: Mat3
) -> float:
    """A bound on the rate of friction, and that of a rail on what it carries [1/s]."""
    u = rail.axis @ r
    mass = resisting(system, u) @ u
    return so_far + rail.friction * _per_speed(rail, rail.axis @ velocity) / mass


@kernel
def rail_slip_rate(so_far: float, rail: SliderFriction, velocity: Vec, acceleration: Vec) -> float:
    """A bound on the rate of slips over their regularised speed, and that of a rail [1/s]."""
    return so_far + abs(rail.axis @ acceleration) * _per_speed(rail, rail.axis @ velocity)


class Plant(Protocol):
    """A vehicle, and all that acts on it: `springback.simulation.measuring.record.Model` is one."""

    @property
    def airframe(self) -> Airframe:
        """Constants of the vehicle."""

    @property
    def world(self) -> World:
        """Obstacles and gravity."""

    @property
    def contact_point(self) -> Any:
        """`Ring` or `ArmTip`."""

    @property
    def guide(self) -> Any:
        """`Free` or `Slider`."""

    @property
    def air(self) -> Any:
        """`Still` or `Air`."""

    @property
    def thrust(self) -> tuple[float, ...]:
        """Thrust of each rotor [N]."""

    @property
    def surface_effect(self) -> tuple[Any, ...]:
        """`springback.vehicle.propulsion.SurfaceEffect`, if surfaces change the thrust."""

    @property
    def pushes(self) -> Any:
        """`Pushes` of another vehicle; empty without one."""

    @property
    def reaction(self) -> tuple[Any, ...]:
        """Moments of rotors that change speed [N m]; empty where none is known.

        One number, the sum about body z; or, of rotors that the vehicle lists, a tuple with that
        of each about its own axis.
        """
