"""The paper's Euler-Lagrange equations (3)-(15), derived by SymPy from its own ten coordinates.

Q = [x y z, φ θ ψ, l₁ l₂ l₃ l₄] with ZYX Euler angles.  Only positions and orientations are written
down by hand: every velocity is a time derivative of a position, and every generalised force is the
transposed Jacobian of the point (or angular velocity) that the force works on.  Nothing is taken from
the package; none of the cross products, centrifugal or Coriolis terms of its Newton-Euler form occur.

The misprints of the paper are mended: the contact force has the sign of Hunt and Crossley, arm dampers
are Rayleigh's, rotor thrust works along R e_z, and I is the main body's own inertia.  Friction has the
package's regularisation, v/√(v² + v_s²).
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np
import sympy as sp  # type: ignore[import-untyped]
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.models import Scene, Start

Array = NDArray[np.float64]
ARMS = 4


class Symbols(NamedTuple):
    """Arguments of the derived functions, in order."""

    q: list[Any]  # 10 coordinates
    u: list[Any]  # their rates
    body: list[Any]  # m_b, Ixx, Iyy, Izz, Ixy, Ixz, Iyz, g
    arms: list[Any]  # for each arm: cos, sin, m_a, k_l, b_l, L, r_0, c_τ, f_T
    wall: list[Any]  # D, k_c, d, μ, v_s

    @property
    def all(self) -> list[Any]:
        """All of them, flat."""
        return [*self.q, *self.u, *self.body, *self.arms, *self.wall]


class Equations(NamedTuple):
    """Numerical functions of all symbols."""

    system: Any  # mass matrix (10, 10) and right-hand side (10, 1) of M Q̈ = b
    turning: Any  # W (3, 3) with ω = W η̇, and Ẇ η̇ (3, 1)


def _symbols() -> Symbols:
    arm_names = "ex ey m k b L r c f"
    return Symbols(
        q=list(sp.symbols("x y z phi theta psi l1:5", real=True)),
        u=list(sp.symbols("vx vy vz dphi dtheta dpsi dl1:5", real=True)),
        body=list(sp.symbols("m_b Ixx Iyy Izz Ixy Ixz Iyz g", real=True)),
        arms=[
            sp.Symbol(f"{name}{j}", real=True) for j in range(ARMS) for name in arm_names.split()
        ],
        wall=list(sp.symbols("D k_c d mu v_s", real=True)),
    )


def _rotation(phi: Any, theta: Any, psi: Any) -> Any:
    """R = R_z(ψ) R_y(θ) R_x(φ)."""
    about_x = sp.Matrix([[1, 0, 0], [0, sp.cos(phi), -sp.sin(phi)], [0, sp.sin(phi), sp.cos(phi)]])
    about_y = sp.Matrix(
        [[sp.cos(theta), 0, sp.sin(theta)], [0, 1, 0], [-sp.sin(theta), 0, sp.cos(theta)]]
    )
    about_z = sp.Matrix([[sp.cos(psi), -sp.sin(psi), 0], [sp.sin(psi), sp.cos(psi), 0], [0, 0, 1]])
    return about_z * about_y * about_x


@functools.cache
def derived() -> Equations:
    """Derive the equations of motion once and turn them into NumPy functions (some 10 s)."""
    s = _symbols()
    q, u = sp.Matrix(s.q), sp.Matrix(s.u)
    p, eta = sp.Matrix(s.q[:3]), s.q[3:6]
    m_b, ixx, iyy, izz, ixy, ixz, iyz, g = s.body
    face, k_c, d, mu, v_s = s.wall
    e_x, e_z = sp.Matrix([1, 0, 0]), sp.Matrix([0, 0, 1])
    r = _rotation(*eta)

    def rate(expression: Any) -> Any:
        """Time derivative of a matrix that depends on Q."""
        return expression.jacobian(q) * u

    # Angular velocity in body axes: Rᵀ Ṙ = ω̂, column by column of ∂R/∂η.
    columns = []
    for angle in eta:
        hat = sp.simplify(r.T * r.diff(angle))
        columns.append(sp.Matrix([hat[2, 1], hat[0, 2], hat[1, 0]]))
    w_of_eta = sp.Matrix.hstack(*columns)
    omega = w_of_eta * sp.Matrix(s.u[3:6])

    inertia = sp.Matrix([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    kinetic = m_b * rate(p).dot(rate(p)) / 2 + (omega.T * inertia * omega)[0] / 2
    potential = m_b * g * p.dot(e_z)
    force = sp.zeros(10, 1)
    for j in range(ARMS):
        ex, ey, m, k, b, free_length, r_0, c_tau, f = s.arms[9 * j : 9 * j + 9]
        length, direction = s.q[6 + j], r * sp.Matrix([ex, ey, 0])
        p_j = p + length * direction
        v_j = rate(p_j)
        kinetic += m * v_j.dot(v_j) / 2  # eq. (5)
        potential += m * g * p_j.dot(e_z) + k * (free_length - length) ** 2 / 2  # eq. (7)

        # Rotor: f_T R e_z on the arm's end, and its torque about body z.
        force += p_j.jacobian(q).T * (f * r * e_z)
        force += omega.jacobian(u).T * (c_tau * f * e_z)
        force[6 + j] -= b * s.u[6 + j]  # Rayleigh

        # Contact, eqs. (13)-(15): the penetration depends on Q alone, so f_n works along its gradient.
        delta = (p_j + (r_0 * direction.dot(e_x)) * e_x).dot(e_x) - face
        gradient = sp.Matrix([delta]).jacobian(q)
        delta_rate = (gradient * u)[0]
        depth = sp.Max(delta, 0)
        f_n = sp.Max(k_c * depth * sp.sqrt(depth) * (1 + d * delta_rate), 0)
        slip = v_j.dot(e_z)
        f_f = -mu * f_n * slip / sp.sqrt(slip**2 + v_s**2)
        force += -f_n * gradient.T + f_f * sp.Matrix([p_j.dot(e_z)]).jacobian(q).T

    momentum = sp.Matrix([kinetic]).jacobian(u).T
    mass_matrix = momentum.jacobian(u)
    gradient = sp.Matrix([kinetic - potential]).jacobian(q).T
    right = force + gradient - momentum.jacobian(q) * u
    return Equations(
        system=sp.lambdify(s.all, [mass_matrix, right], modules="numpy", cse=True),
        turning=sp.lambdify(
            s.all,
            [w_of_eta, omega.jacobian(sp.Matrix(eta)) * sp.Matrix(s.u[3:6])],
            modules="numpy",
            cse=True,
        ),
    )


def _numbers(scene: Scene) -> list[float]:
    craft, wall = scene.craft, scene.wall
    i = craft.inertia
    if not np.array_equal(wall.normal, [-1.0, 0.0, 0.0]):
        raise ValueError("the paper's wall stands across e_X")
    body = [craft.body_mass, i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2], scene.gravity]
    arms: list[float] = []
    for a, thrust in zip(craft.arms, scene.thrust, strict=True):
        arms += [math.cos(a.azimuth), math.sin(a.azimuth), a.mass, a.stiffness, a.damping]
        arms += [a.length, a.cage_radius, a.torque_ratio, thrust]
    return [
        *body,
        *arms,
        -wall.offset,
        wall.stiffness,
        wall.dissipation,
        wall.friction,
        wall.slip_speed,
    ]


def accelerations(scene: Scene, start: Start) -> tuple[Array, Array, Array]:
    """v̇ in world axes, ω̇ in body axes and l̈ of the Lagrangian model at one state."""
    equations, numbers = derived(), _numbers(scene)
    psi, theta, phi = Rotation.from_quat(start.attitude, scalar_first=True).as_euler("ZYX")
    q = [*start.position, phi, theta, psi, *start.lengths]
    turning = equations.turning(*q, *([0.0] * 10), *numbers)[0]
    u = [*start.velocity, *np.linalg.solve(turning, start.omega), *start.rates]
    mass_matrix, right = equations.system(*q, *u, *numbers)
    q_second = np.linalg.solve(mass_matrix, right)[:, 0]
    turning, drift = equations.turning(*q, *u, *numbers)
    return q_second[:3], turning @ q_second[3:6] + drift[:, 0], q_second[6:]
