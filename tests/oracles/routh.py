"""One cage striking a wall: Routh's equations with Stronge's restitution, by an ODE solver.

The normal impulse p is the independent variable.  The velocity u of the contact point obeys
du/dp = G (n − μ s/|s|), with its slip s and the 3 x 3 matrix G of what an impulse there does to its own
point.  Compression lasts while u·n < 0; the bounce ends when the normal impulse has given back e² of
the work that compression took.  Slip directions are regularised over 1e-4 m/s, so that a cage that
sticks stays; an implicit solver copes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]

CREEP = 1e-4  # [m/s]


def velocity_after(
    velocity: Array, give: Array, normal: Array, friction: float, restitution: float
) -> Array:
    """Velocity of the contact point after the impact [m/s].

    Args:
        velocity: Before the impact; closing in, so velocity · normal < 0.
        give: G, velocity of the point for a unit impulse on it, shape (3, 3) [1/kg].
        normal: Unit normal out of the wall.
        friction: μ.
        restitution: e.
    """
    n = normal

    def slope(_: float, y: Array) -> Array:
        u = y[:3]
        slip = u - (u @ n) * n
        impulse = n - friction * slip / np.sqrt(slip @ slip + CREEP**2)
        speed = float(u @ n)
        return np.array([*(give @ impulse), max(-speed, 0.0), max(speed, 0.0)])

    def paid_back(_: float, y: Array) -> float:
        compressing = y[:3] @ n < 0.0
        return float(-1.0 if compressing else y[4] - restitution**2 * y[3])

    paid_back.terminal = True  # type: ignore[attr-defined]
    paid_back.direction = 1.0  # type: ignore[attr-defined]
    longest = -float(velocity @ n) / float(np.linalg.eigvalsh(give)[0]) * 100.0
    solved = solve_ivp(
        slope,
        (0.0, longest),
        np.array([*velocity, 0.0, 0.0]),
        method="Radau",
        events=paid_back,
        rtol=1e-8,
        atol=1e-10,
    )
    if solved.status != 1:
        raise RuntimeError("the impact does not end")
    return np.asarray(solved.y[:3, -1])
