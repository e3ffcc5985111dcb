"""Arms on two joints in plain numbers, and their Lagrange equations derived by SymPy.

As `oracles.joint_lagrangian`, whose arms these are by their first joints: c and its rates are pairs.
The second joint moves the end of the free arm first, and the first moves what comes of it; only
that place and the axis of the rotor are written down.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp  # type: ignore[import-untyped]
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles import models
from oracles.joint_lagrangian import (
    E_Z,
    ROTATION,
    Craft,
    Limb,
    Pose,
    Q,
    Second,
    U,
    angular_velocity,
    body_equations,
    random_limb,
    turn_of_end,
    turning,
)

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BentLimb(Limb):
    """An arm whose first joint carries a second; of that mass, rotor and cage are of no meaning."""

    second: Limb | None = None

    @property
    def chain(self) -> tuple[Limb, ...]:
        """Both joints, from the main body on."""
        assert self.second is not None
        return (self, self.second)

    @property
    def outer(self) -> Limb:
        """The second joint."""
        return self.chain[1]

    def turn(self, c: Any) -> Array:
        """Axes of what is at the end, to body axes."""
        return super().turn(c[0]) @ self.outer.turn(c[1])

    def place(self, c: Any) -> Array:
        """Of the end, body axes [m]."""
        out = self.outer.place(c[1])
        if self.kind == "slide":
            return np.asarray(out + c[0] * self.axis)
        return np.asarray(self.point + super().turn(c[0]) @ (out - self.point))

    def motion(self, c: Any, rate: Any) -> Array:
        """Velocity of the end as seen from the body, body axes [m/s]."""
        inner = super().turn(c[0])
        own = self.axis if self.kind == "slide" else np.cross(self.axis, self.place(c) - self.point)
        return np.asarray(rate[0] * own + rate[1] * inner @ self.outer.slope(c[1]))

    def spin(self, c: Any, rate: Any) -> Array:
        """Angular velocity of what is at the end as seen from the body, body axes [rad/s]."""
        own = super().spin(c[0], rate[0])
        return np.asarray(own + super().turn(c[0]) @ self.outer.spin(c[1], rate[1]))

    def mirrored(self) -> Limb:
        """The arm seen in a mirror, y → −y."""
        seen = super().mirrored()
        return replace(seen, second=self.outer.mirrored())  # type: ignore[call-arg]

    def spring_force(self, c: Any, rate: Any) -> Any:
        """Springs and dampers as forces on both c."""
        own = super().spring_force(c[0], rate[0])
        return np.array([own, self.outer.spring_force(c[1], rate[1])])


# -- random crafts and states ----------------------------------------------------------------------

#: Kinds of the two joints, and their axes in the axes of an arm; None: drawn for each arm.
PAIRS: dict[str, tuple[str, Any, str, Any]] = {
    "universal joints": ("hinge", [0.0, 0.0, 1.0], "hinge", [0.0, -1.0, 0.0]),
    "hinges apart": ("hinge", None, "hinge", None),
    "slides on hinges": ("hinge", [0.2, -1.0, 0.3], "slide", [-1.0, 0.2, 0.1]),
    "hinges on slides": ("slide", [-1.0, 0.1, 0.2], "hinge", [0.1, 0.2, 1.0]),
    "slides on slides": ("slide", [-1.0, 0.3, 0.0], "slide", [0.3, 0.2, 1.0]),
}
#: Least sine of the angle between the two directions of motion of drawn joints.
LEAST = 0.35


def drawn(name: str, seed: int, size: float = 1.0) -> tuple[Craft, Pose]:
    """Unequal arms, three or four, at a random state, rotors on.

    Args:
        name: One of `PAIRS`.
        seed: Of the numbers.
        size: Of angles and ways, and of their rates.
    """
    rng = np.random.default_rng([41, list(PAIRS).index(name), seed])
    count = 3 + seed % 2
    limbs = tuple(_limb(rng, name, 2.0 * np.pi / count * j) for j in range(count))
    craft = Craft(rng.uniform(0.8, 2.0), models.random_inertia(rng), limbs)
    turn = Rotation.from_euler("ZYX", rng.uniform(-1.0, 1.0, size=3) * [np.pi, 1.2, np.pi])
    sizes = size * np.array(
        [[0.6 if one.kind == "hinge" else 0.03 for one in limb.chain] for limb in limbs]
    )
    held = [[one.preload > 0.0 or one.latch[0] > 0.0 for one in limb.chain] for limb in limbs]
    bends = sizes * rng.uniform(np.where(held, 0.05, -1.0), 1.0)
    return craft, Pose(
        position=rng.uniform(-2.0, 2.0, size=3),
        attitude=np.asarray(turn.as_quat(scalar_first=True)),
        velocity=rng.uniform(-3.0, 3.0, size=3),
        omega=rng.uniform(-10.0, 10.0, size=3),
        bends=bends,
        rates=sizes * rng.uniform(-40.0, 40.0, size=bends.shape),
    )


def _limb(rng: np.random.Generator, name: str, azimuth: float) -> BentLimb:
    azimuth += rng.uniform(-0.4, 0.4)
    kind, axis, other, across = PAIRS[name]
    while True:
        first, second = (
            random_limb(rng, azimuth, one, rng.normal(size=3) if given is None else given)  # type: ignore[arg-type]
            for one, given in ((kind, axis), (other, across))
        )
        second = replace(second, end=first.end)
        if name == "universal joints":
            second = replace(second, point=first.point)
        latch = (1.5, 0.1) if second.kind == "hinge" else (40.0, 0.004)
        if rng.integers(2) and second.preload == 0.0:
            second = replace(second, latch=latch)
        limb = BentLimb(**vars(first), second=second)
        ways = [limb.motion(c, r) for c in _corners(limb) for r in ([1.0, 0.0], [0.0, 1.0])]
        pairs = np.array(ways).reshape(-1, 2, 3)
        scale = np.array([first.radius, second.radius])
        sine = np.linalg.norm(np.cross(*(pairs / scale[:, None]).transpose(1, 0, 2)), axis=1)
        if sine.min() > LEAST:
            return limb


def _corners(limb: BentLimb) -> list[list[float]]:
    size = 0.7 if limb.outer.kind == "hinge" else 0.035
    return [[0.0, c] for c in np.linspace(-size, size, 5)]


# -- Lagrange's equations --------------------------------------------------------------------------

#: A second coordinate, its rate, and numbers of the second joint: axis, point, k, k₂, preload, b,
#: and of its latch the force at which it opens, and where.
C2, DC2 = sp.symbols("c2 dc2", real=True)
FIRST = sp.symbols("ex ey ez ax ay az px py pz m k k2 P b f ct follows g F d", real=True)
SECOND = sp.symbols("bx by bz qx qy qz K K2 P2 B F2 d2", real=True)


def _potential(c: Any, k: Any, k2: Any, preload: Any, holds: Any, opens: Any) -> Any:
    latch = sp.Rational(8, 3) * holds * opens * c**2 / (3 * opens**2 + c**2)
    return k * c**2 / 2 + k2 * sp.Abs(c) * c**2 / 3 + preload * c + latch


@functools.cache
def _arm_equations(kind: str, other: str) -> Any:
    """Functions of mass matrix and right-hand side, all eight coordinates."""
    q, u = sp.Matrix([*Q, C2]), sp.Matrix([*U, DC2])
    end, axis, point = (sp.Matrix(FIRST[k : k + 3]) for k in (0, 3, 6))
    m, k, k2, preload, b, f, c_tau, follows, g, holds, opens = FIRST[9:]
    across, pivot = (sp.Matrix(SECOND[k : k + 3]) for k in (0, 3))
    inner, outer = turn_of_end(kind, axis, Q[6]), turn_of_end(other, across, C2)
    out = end + C2 * across if other == "slide" else pivot + outer * (end - pivot)
    here = out + Q[6] * axis if kind == "slide" else point + inner * (out - point)
    omega = angular_velocity()
    spin = omega + (sp.zeros(3, 1) if kind == "slide" else U[6] * axis)
    spin += sp.zeros(3, 1) if other == "slide" else DC2 * inner * across
    p = Q[:3, 0] + ROTATION * here
    v = p.jacobian(q) * u
    potential = m * g * p[2] + _potential(Q[6], k, k2, preload, holds, opens)
    potential += _potential(C2, *SECOND[6:9], *SECOND[10:])
    up = follows * inner * outer * E_Z + (1 - follows) * E_Z  # of the rotor, body axes
    force = p.jacobian(q).T * (f * ROTATION * up) + spin.jacobian(u).T * (c_tau * f * up)
    force[6] -= b * U[6]  # Rayleigh
    force[7] -= SECOND[9] * DC2
    kinetic = m * v.dot(v) / 2
    momentum = sp.Matrix([kinetic]).jacobian(u).T
    gradient = sp.Matrix([kinetic - potential]).jacobian(q).T
    right = force + gradient - momentum.jacobian(q) * u
    every = [*q, *u, *FIRST, *SECOND]
    return sp.lambdify(every, [momentum.jacobian(u), right], modules="numpy", cse=True)


def accelerations(craft: Craft, now: Pose) -> Second:
    """Second derivatives by Lagrange's equations, of a craft whose arms are all `BentLimb`s."""
    psi, theta, phi = Rotation.from_quat(now.attitude, scalar_first=True).as_euler("ZYX")
    eta = (phi, theta, psi)
    w, _ = turning()(*eta, 0.0, 0.0, 0.0)
    rates = np.linalg.solve(w, now.omega)
    q, u, i = [*now.position, *eta], [*now.velocity, *rates], craft.inertia
    moments = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
    body = body_equations()(*q, 0.0, *u, 0.0, craft.body_mass, *moments, craft.gravity)
    size = 6 + 2 * len(craft.limbs)
    mass, right = np.zeros((size, size)), np.zeros(size)
    mass[:6, :6], right[:6] = body[0][:6, :6], body[1][:6, 0]
    for j, (limb, c, rate) in enumerate(zip(craft.limbs, now.bends, now.rates, strict=True)):
        first, second = limb.chain
        numbers = [*limb.end, *limb.axis, *limb.point, limb.mass, limb.stiffness, limb.quadratic]
        numbers += [limb.preload, limb.damping, limb.thrust, limb.torque_ratio]
        numbers += [float(limb.follows), craft.gravity, *limb.latch]
        numbers += [*second.axis, *second.point, second.stiffness, second.quadratic]
        numbers += [second.preload, second.damping, *second.latch]
        m, b = _arm_equations(first.kind, second.kind)(*q, *c, *u, *rate, *numbers)
        at = [*range(6), 6 + 2 * j, 7 + 2 * j]
        mass[np.ix_(at, at)] += m
        right[at] += b[:, 0]
    found = np.linalg.solve(mass, right)
    w, drift = turning()(*eta, *rates)
    return Second(found[:3], w @ found[3:6] + drift[:, 0], found[6:].reshape(-1, 2))
