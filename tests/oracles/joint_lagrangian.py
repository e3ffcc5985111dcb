"""Arms on slides and hinges in plain numbers, and their Lagrange equations derived by SymPy.

The coordinates are x y z, the ZYX Euler angles φ θ ψ and, for each arm, how far it is pressed
in: the way c of a slide [m] or the angle c of a hinge [rad].  Only the places of the masses and the
axes of the rotors are written down: every velocity is a time derivative of a place, and every
generalised force the transposed Jacobian of what it works on.  Kinetic and potential energy are
sums over the main body and the arms, and so are the equations: each kind of arm is derived once,
with its own seven coordinates, and any number of arms of any kinds is put together from these.

The arms' own path lengths, their elimination and all cross products of the package are absent.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple

import numpy as np
import sympy as sp  # type: ignore[import-untyped]
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]


# -- plain numbers ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class Limb:
    """One arm, in body axes and SI units; c is how far it is pressed in."""

    kind: Literal["slide", "hinge"]
    end: Array  # at c = 0 [m]
    axis: Array  # unit: in which it slides, or about which it turns, right-handed, as c grows
    point: Array  # of the hinge's axis [m]; of no meaning to a slide
    mass: float
    stiffness: float  # [N/m] or [N m/rad], as those below
    quadratic: float
    preload: float
    damping: float
    thrust: float  # [N]
    torque_ratio: float  # with its sign [m]
    follows: bool  # the rotor turns with a hinge
    cage_radius: float = 0.11
    latch: tuple[float, float] = (0.0, 1.0)  # the force on c at which it opens, and that c

    @property
    def radius(self) -> float:
        """Distance from the end to the hinge's axis; 1 for a slide: way of the end per c."""
        if self.kind == "slide":
            return 1.0
        return float(np.linalg.norm(np.cross(self.axis, self.end - self.point)))

    def turn(self, c: Any) -> Array:
        """Axes of what is at the end, to body axes."""
        about = c * self.axis if self.kind == "hinge" else np.zeros(3)
        return np.asarray(Rotation.from_rotvec(about).as_matrix())

    def place(self, c: Any) -> Array:
        """Of the end, body axes [m]."""
        if self.kind == "slide":
            return self.end + c * self.axis
        return np.asarray(self.point + self.turn(c) @ (self.end - self.point))

    def slope(self, c: float) -> Array:
        """Of the place by c."""
        if self.kind == "slide":
            return self.axis
        return np.cross(self.axis, self.place(c) - self.point)

    @property
    def chain(self) -> tuple[Limb, ...]:
        """Its joints, from the main body on."""
        return (self,)

    def motion(self, c: Any, rate: Any) -> Array:
        """Velocity of the end as seen from the body, body axes [m/s]."""
        return np.asarray(rate * self.slope(c))

    def spin(self, c: Any, rate: Any) -> Array:
        """Angular velocity of what is at the end as seen from the body, body axes [rad/s]."""
        return np.asarray((rate if self.kind == "hinge" else 0.0) * self.axis)

    def mirrored(self) -> Limb:
        """The arm seen in a mirror, y → −y; its rotor then spins the other way."""
        return replace(
            self,
            end=self.end * ACROSS,
            axis=self.axis * (ACROSS if self.kind == "slide" else AROUND),
            point=self.point * ACROSS,
            torque_ratio=-self.torque_ratio,
        )

    def spring_force(self, c: Any, rate: Any) -> Any:
        """Spring and damper as a force on c."""
        spring = self.stiffness * c + self.quadratic * c * abs(c) + self.preload
        holds, opens = self.latch
        latch = 16.0 * holds * c * opens**3 / (3.0 * opens**2 + c**2) ** 2
        return -spring - latch - self.damping * rate


@dataclass(frozen=True)
class Between:
    """Springs and dampers between the ends of each arm and the next."""

    stiffness: float  # [N/m]
    damping: float  # [N s/m]
    distances: tuple[float, ...]  # where they are free [m]


@dataclass(frozen=True)
class Craft:
    """A main body and its arms."""

    body_mass: float
    inertia: Array  # of the main body alone, shape (3, 3)
    limbs: tuple[Limb, ...]
    gravity: float = 9.81
    between: Between | None = None

    @property
    def mass(self) -> float:
        """Everything [kg]."""
        return self.body_mass + sum(limb.mass for limb in self.limbs)


@dataclass(frozen=True)
class Pose:
    """Where a craft is and how it moves."""

    position: Array  # world
    attitude: Array  # (w, x, y, z), body to world
    velocity: Array  # world
    omega: Array  # body
    bends: Array  # c of each arm
    rates: Array

    @property
    def rotation(self) -> Array:
        """Rotation matrix, body to world."""
        return np.asarray(Rotation.from_quat(self.attitude, scalar_first=True).as_matrix())


class Second(NamedTuple):
    """Second derivatives of all coordinates."""

    linear: Array  # v̇, world [m/s²]
    angular: Array  # ω̇, body [rad/s²]
    bends: Array  # c̈


class Cloud:
    """A craft as a turning body and point masses, at one instant; world axes.

    Args:
        craft: Masses and places.
        now: State.
    """

    def __init__(self, craft: Craft, now: Pose) -> None:
        """Place the masses and give them their velocities."""
        r = now.rotation
        omega = r @ now.omega
        self.masses = np.array([craft.body_mass, *(limb.mass for limb in craft.limbs)])
        places, velocities = [now.position], [now.velocity]
        for limb, c, rate in zip(craft.limbs, now.bends, now.rates, strict=True):
            lever = r @ limb.place(c)
            places.append(now.position + lever)
            velocities.append(now.velocity + np.cross(omega, lever) + r @ limb.motion(c, rate))
        self.places, self.velocities = np.array(places), np.array(velocities)
        self.spin = r @ craft.inertia @ now.omega
        self.turning = 0.5 * float(now.omega @ craft.inertia @ now.omega)

    @property
    def momentum(self) -> Array:
        """Σ m v [kg m/s]."""
        return np.asarray(self.masses @ self.velocities)

    @property
    def angular_momentum(self) -> Array:
        """About the centre of mass [kg m²/s]."""
        centre = self.masses @ self.places / self.masses.sum()
        return np.asarray(self.spin + self.masses @ np.cross(self.places - centre, self.velocities))

    @property
    def kinetic(self) -> float:
        """Kinetic energy [J]."""
        return self.turning + 0.5 * float(self.masses @ (self.velocities**2).sum(axis=1))


# -- random crafts and states ----------------------------------------------------------------------


def about_z(azimuth: float) -> Array:
    """Axes of an arm in a direction of the body plane, to body axes."""
    return np.asarray(Rotation.from_euler("z", azimuth).as_matrix())


def random_limb(
    rng: np.random.Generator, azimuth: float, kind: Literal["slide", "hinge"], axis: Any
) -> Limb:
    """An arm unlike the others; its axis, of any length, is in the arm's own axes."""
    turn, along = about_z(azimuth), np.asarray(axis, dtype=float)
    hinged = kind == "hinge"
    end = [rng.uniform(0.15, 0.25), 0.0, rng.uniform(-0.03, 0.03)]
    point = [rng.uniform(0.03, 0.08), *rng.uniform(-0.02, 0.02, size=2)]
    size = 1.0 if hinged else 400.0
    return Limb(
        kind=kind,
        end=turn @ end,
        axis=turn @ along / np.linalg.norm(along),
        point=turn @ point,
        mass=rng.uniform(0.02, 0.15),
        stiffness=size * rng.uniform(3.0, 20.0),
        quadratic=(size if hinged else 1e5) * rng.uniform(0.5, 5.0),
        preload=(1.0 if hinged else 10.0) * rng.uniform(0.1, 1.0) * float(rng.integers(2)),
        damping=size * rng.uniform(0.01, 0.1),
        thrust=rng.uniform(1.0, 12.0),
        torque_ratio=rng.uniform(0.005, 0.03) * float(rng.choice([-1.0, 1.0])),
        follows=bool(rng.integers(2)),
        cage_radius=rng.uniform(0.07, 0.13),
    )


def random_pose(rng: np.random.Generator, craft: Craft) -> Pose:
    """A vigorous state, arms bent either way but where preload holds them; pitch within 70°."""
    sizes = np.array([0.6 if limb.kind == "hinge" else 0.03 for limb in craft.limbs])
    held = [limb.preload > 0.0 or limb.latch[0] > 0.0 for limb in craft.limbs]
    low = np.array([0.05 if one else -1.0 for one in held])
    yaw, pitch, roll = rng.uniform(-1.0, 1.0, size=3) * [np.pi, 1.2, np.pi]
    turn = Rotation.from_euler("ZYX", [yaw, pitch, roll])
    return Pose(
        position=rng.uniform(-2.0, 2.0, size=3),
        attitude=np.asarray(turn.as_quat(scalar_first=True)),
        velocity=rng.uniform(-3.0, 3.0, size=3),
        omega=rng.uniform(-10.0, 10.0, size=3),
        bends=sizes * rng.uniform(low, 1.0),
        rates=sizes * rng.uniform(-40.0, 40.0, size=len(sizes)),
    )


# -- mirrored and turned ---------------------------------------------------------------------------

ACROSS = np.array([1.0, -1.0, 1.0])  # of a place, a velocity or a force when y → −y
AROUND = -ACROSS  # of an axis of rotation, an angular velocity or a torque


def mirrored(craft: Craft, now: Pose) -> tuple[Craft, Pose]:
    """Everything seen in a mirror, y → −y; rotors then spin the other way."""
    limbs = tuple(limb.mirrored() for limb in craft.limbs)
    seen = Pose(
        position=now.position * ACROSS,
        attitude=now.attitude * np.array([1.0, *AROUND]),
        velocity=now.velocity * ACROSS,
        omega=now.omega * AROUND,
        bends=now.bends,
        rates=now.rates,
    )
    inertia = craft.inertia * np.outer(ACROSS, ACROSS)
    return replace(craft, inertia=inertia, limbs=limbs), seen


def renamed(craft: Craft, now: Pose, by: Rotation) -> tuple[Craft, Pose]:
    """The same craft where it was, described in other body axes, turned by −``by``."""
    turn, limbs = by.as_matrix(), []
    for limb in craft.limbs:
        vectors = (limb.end, limb.axis, limb.point)
        end, axis, point = (turn @ vector for vector in vectors)
        limbs.append(replace(limb, end=end, axis=axis, point=point))
    attitude = Rotation.from_quat(now.attitude, scalar_first=True) * by.inv()
    seen = replace(
        now, attitude=np.asarray(attitude.as_quat(scalar_first=True)), omega=turn @ now.omega
    )
    return replace(craft, inertia=turn @ craft.inertia @ turn.T, limbs=tuple(limbs)), seen


def turned(now: Pose, by: Rotation) -> Pose:
    """A craft turned about the origin of the world."""
    attitude = by * Rotation.from_quat(now.attitude, scalar_first=True)
    return replace(
        now,
        position=by.apply(now.position),
        attitude=np.asarray(attitude.as_quat(scalar_first=True)),
        velocity=by.apply(now.velocity),
    )


# -- Lagrange's equations --------------------------------------------------------------------------

#: Coordinates of the main body and one arm, and their rates.
Q = sp.Matrix(sp.symbols("x y z phi theta psi c", real=True))
U = sp.Matrix(sp.symbols("vx vy vz dphi dtheta dpsi dc", real=True))
#: Of the main body: m_b, its inertia, g.
BODY = sp.symbols("m_b Ixx Iyy Izz Ixy Ixz Iyz g", real=True)
#: Of an arm: free end, axis, point, m, k, k₂, preload, b, f_T, c_τ, whether the rotor follows, g;
#: of its latch, the force at which it opens, and where.
ARM = sp.symbols("ex ey ez ax ay az px py pz m k k2 P b f ct follows g F d", real=True)
#: Of a spring between two arms: k, b, its free length.
BETWEEN = sp.symbols("k b D", real=True)
E_Z = sp.Matrix([0, 0, 1])


def _about(axis: int, angle: Any) -> Any:
    """Rotation about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = sp.eye(3)
    turn[i, i] = turn[j, j] = sp.cos(angle)
    turn[i, j], turn[j, i] = -sp.sin(angle), sp.sin(angle)
    return turn


ROTATION = _about(2, Q[5]) * _about(1, Q[4]) * _about(0, Q[3])


@functools.cache
def angular_velocity() -> Any:
    """Angular velocity in body axes, from Rᵀ Ṙ = ω̂."""
    total = sp.zeros(3, 1)
    for k in (3, 4, 5):
        hat = sp.simplify(ROTATION.T * ROTATION.diff(Q[k]))
        total += sp.Matrix([hat[2, 1], hat[0, 2], hat[1, 0]]) * U[k]
    return total


def _lagrange(kinetic: Any, potential: Any, force: Any, arguments: Any) -> Any:
    """Functions of mass matrix and right-hand side of M Q̈ = b."""
    momentum = sp.Matrix([kinetic]).jacobian(U).T
    gradient = sp.Matrix([kinetic - potential]).jacobian(Q).T
    right = force + gradient - momentum.jacobian(Q) * U
    every = [*Q, *U, *arguments]
    return sp.lambdify(every, [momentum.jacobian(U), right], modules="numpy", cse=True)


@functools.cache
def body_equations() -> Any:
    m_b, ixx, iyy, izz, ixy, ixz, iyz, g = BODY
    inertia = sp.Matrix([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    omega, p = angular_velocity(), Q[:3, 0]
    v = p.jacobian(Q) * U
    kinetic = m_b * v.dot(v) / 2 + (omega.T * inertia * omega)[0] / 2
    return _lagrange(kinetic, m_b * g * p[2], sp.zeros(7, 1), BODY)


def turn_of_end(kind: str, axis: Any, c: Any) -> Any:
    """Rotation of what is at the end of an arm, as a formula."""
    if kind == "slide":
        return sp.eye(3)
    hat = sp.Matrix(3, 3, lambda i, j: axis.cross(sp.eye(3)[:, j])[i])
    return sp.eye(3) + sp.sin(c) * hat + (1 - sp.cos(c)) * hat * hat


def place_of_end(kind: str, end: Any, axis: Any, point: Any, c: Any) -> Any:
    """Place of the end of an arm, body axes, as a formula."""
    if kind == "slide":
        return end + c * axis
    return point + turn_of_end(kind, axis, c) * (end - point)


@functools.cache
def _forces_between(kinds: tuple[str, str]) -> Any:
    """Function of the generalised forces of a spring and damper between two arms."""
    bends, rates = sp.symbols("c1 c2", real=True), sp.symbols("u1 u2", real=True)
    vectors = [sp.symbols(f"e{j}(:3) a{j}(:3) p{j}(:3)", real=True) for j in (1, 2)]
    first, second = (
        place_of_end(kind, *(sp.Matrix(of[k : k + 3]) for k in (0, 3, 6)), c)
        for kind, of, c in zip(kinds, vectors, bends, strict=True)
    )
    k, b, free = BETWEEN
    apart = sp.sqrt((second - first).dot(second - first))
    slopes = [sp.diff(apart, c) for c in bends]
    rate = sum(slope * u for slope, u in zip(slopes, rates, strict=True))
    potential, loss = k * (apart - free) ** 2 / 2, b * rate**2 / 2  # Rayleigh
    forces = [-sp.diff(potential, c) - sp.diff(loss, u) for c, u in zip(bends, rates, strict=True)]
    arguments = [*bends, *rates, *vectors[0], *vectors[1], *BETWEEN]
    return sp.lambdify(arguments, forces, modules="numpy", cse=True)


def _all_between(craft: Craft, now: Pose) -> Array:
    """Generalised forces on c of all arms, by the springs between them."""
    count = len(craft.limbs)
    total = np.zeros(count)
    if craft.between is None:
        return total
    for j, free in enumerate(craft.between.distances):
        pair = (j, (j + 1) % count)
        first, second = (craft.limbs[one] for one in pair)
        vectors = [x for limb in (first, second) for x in (*limb.end, *limb.axis, *limb.point)]
        between = (craft.between.stiffness, craft.between.damping, free)
        forces = _forces_between((first.kind, second.kind))
        total[list(pair)] += forces(
            *now.bends[list(pair)], *now.rates[list(pair)], *vectors, *between
        )
    return total


@functools.cache
def _arm_equations(kind: str) -> Any:
    end, axis, point = (sp.Matrix(ARM[k : k + 3]) for k in (0, 3, 6))
    m, k, k2, preload, b, f, c_tau, follows, g, holds, opens = ARM[9:]
    c, omega = Q[6], angular_velocity()
    turned, here = turn_of_end(kind, axis, c), place_of_end(kind, end, axis, point, c)
    spin = omega if kind == "slide" else omega + U[6] * axis
    p = Q[:3, 0] + ROTATION * here
    v = p.jacobian(Q) * U
    potential = m * g * p[2] + k * c**2 / 2 + k2 * sp.Abs(c) * c**2 / 3 + preload * c
    potential += sp.Rational(8, 3) * holds * opens * c**2 / (3 * opens**2 + c**2)
    up = follows * turned * E_Z + (1 - follows) * E_Z  # of the rotor, body axes
    force = p.jacobian(Q).T * (f * ROTATION * up) + spin.jacobian(U).T * (c_tau * f * up)
    force[6] -= b * U[6]  # Rayleigh
    return _lagrange(m * v.dot(v) / 2, potential, force, ARM)


@functools.cache
def turning() -> Any:
    """W (3, 3) with ω = W η̇, and Ẇ η̇ (3, 1)."""
    omega, eta, rates = angular_velocity(), Q[3:6, 0], U[3:6, 0]
    return sp.lambdify(
        [*eta, *rates], [omega.jacobian(rates), omega.jacobian(eta) * rates], modules="numpy"
    )


def accelerations(craft: Craft, now: Pose, pushes: Array | None = None) -> Second:
    """Second derivatives by Lagrange's equations.

    Args:
        craft: Any.
        now: Its state.
        pushes: Further generalised forces on x, y, z, φ, θ, ψ and c of each arm.
    """
    psi, theta, phi = Rotation.from_quat(now.attitude, scalar_first=True).as_euler("ZYX")
    eta = (phi, theta, psi)
    w, _ = turning()(*eta, 0.0, 0.0, 0.0)
    rates = np.linalg.solve(w, now.omega)
    q, u = [*now.position, *eta], [*now.velocity, *rates]
    i = craft.inertia
    moments = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
    body = body_equations()(*q, 0.0, *u, 0.0, craft.body_mass, *moments, craft.gravity)

    size = 6 + len(craft.limbs)
    mass, right = np.zeros((size, size)), np.zeros(size)
    mass[:6, :6], right[:6] = body[0][:6, :6], body[1][:6, 0]
    for j, (limb, c, rate) in enumerate(zip(craft.limbs, now.bends, now.rates, strict=True)):
        numbers = [*limb.end, *limb.axis, *limb.point, limb.mass, limb.stiffness, limb.quadratic]
        numbers += [limb.preload, limb.damping, limb.thrust, limb.torque_ratio]
        numbers += [float(limb.follows), craft.gravity, *limb.latch]
        m, b = _arm_equations(limb.kind)(*q, c, *u, rate, *numbers)
        at = [*range(6), 6 + j]
        mass[np.ix_(at, at)] += m
        right[at] += b[:, 0]
    right[6:] += _all_between(craft, now)
    right += 0.0 if pushes is None else pushes
    second = np.linalg.solve(mass, right)
    w, drift = turning()(*eta, *rates)
    return Second(second[:3], w @ second[3:6] + drift[:, 0], second[6:])
