"""Solution of the six equations of motion by elimination, with guides or without."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.kernels.compiler import generic, kernel
from springback.kernels.vectors import Mat3, Vec, solve_symmetric
from springback.vehicle.state import PlanarInverse


class Free(NamedTuple):
    """No constraint: six degrees of freedom and the arms."""

    unused: float


class Slider(NamedTuple):
    """Constraint to one world axis without rotation, as on the paper's testbed."""

    axis: Vec  # unit vector, world


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
def solve(guide: Any, system: System, r: Mat3, gravity: float) -> Accelerations:
    """Accelerations of the main body under a constraint."""
    raise TypeError(f"{type(guide).__name__} is not a guide")


@solve.register(Free)
@kernel
def _solve_free(guide: Free, system: System, r: Mat3, gravity: float) -> Accelerations:
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


@solve.register(Slider)
@kernel
def _solve_slider(guide: Slider, system: System, r: Mat3, gravity: float) -> Accelerations:
    """Solve along the slider, the only free direction: uᵀ M u ẍ = uᵀ(b − M Rᵀ g e_Z)."""
    u = guide.axis @ r
    weight = Vec(0.0, 0.0, gravity) @ r
    m, slide = system.mass, system.sliding
    mu = Vec(
        (m - slide.x) * u.x - slide.z * u.y,
        (m - slide.y) * u.y - slide.z * u.x,
        m * u.z,
    )
    along_axis = (u @ system.force - mu @ weight) / (mu @ u)
    return Accelerations(weight + along_axis * u, Vec(0.0, 0.0, 0.0))
