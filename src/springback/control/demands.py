"""Demands of a curve on the vehicle: thrust, tilt and tilt rate, from flatness."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
Times = Sequence[float] | Array

#: Fraction of each limit that plans use where possible; the rest is left to feedback.  Chosen.
ROOM = 0.8
#: Samples of each segment at which demands are evaluated; a sampled peak of a smooth curve is then
#: within a relative (π/200)²/8 < 1e-4 of the true one.
SAMPLES = 200


class DifferentiableCurve(Protocol):
    """A curve in space with derivatives, such as SciPy's splines."""

    def __call__(self, x: Any, nu: int = 0) -> Any:
        """Derivative of order ``nu`` at times ``x`` [s], shape (..., 3)."""


class Limits(NamedTuple):
    """Limits of a vehicle."""

    mass: float  # [kg]
    gravity: float  # g [m/s²]
    max_thrust: float  # collective [N]
    min_thrust: float = 0.0  # collective [N]
    max_body_rate: float = math.radians(220.0)  # PX4's default MC_PITCHRATE_MAX [rad/s]
    max_tilt: float = math.pi / 3.0  # chosen: level flight there takes twice the weight [rad]


class Demands(NamedTuple):
    """Extreme demands of a curve."""

    max_thrust: float  # [N]
    min_thrust: float  # [N]
    tilt: float  # largest angle between thrust and vertical [rad]
    tilt_rate: float  # largest rate of the thrust direction [rad/s]

    def uses(self, limits: Limits) -> dict[str, float]:
        """Each demand as a fraction of its limit; above 1 it cannot be flown."""
        return {
            "thrust": self.max_thrust / limits.max_thrust,
            "least thrust": limits.min_thrust / max(self.min_thrust, 1e-12),
            "tilt": self.tilt / limits.max_tilt,
            "tilt rate": self.tilt_rate / limits.max_body_rate,
        }


def demands(curve: DifferentiableCurve, breaks: Times, limits: Limits) -> Demands:
    """Demands along a curve: thrust, tilt and tilt rate, from flatness.

    Thrust m (a + g e_Z) along b; ‖ḃ‖ = ‖j − (j·b) b‖ m/thrust (Mellinger and Kumar 2011, section
    III, the vector h_ω).  Air drag is neglected.
    """
    fractions = np.linspace(0.0, 1.0, SAMPLES)
    t = np.asarray(breaks[:-1])[:, None] + np.diff(breaks)[:, None] * fractions
    pull = curve(t, 2) + np.array([0.0, 0.0, limits.gravity])
    jerk = curve(t, 3)
    strength = np.maximum(np.linalg.norm(pull, axis=-1), 1e-12)
    b = pull / strength[..., None]
    turning = jerk - np.sum(jerk * b, axis=-1)[..., None] * b
    return Demands(
        max_thrust=float(limits.mass * strength.max()),
        min_thrust=float(limits.mass * strength.min()),
        tilt=float(np.arccos(np.clip(b[..., 2], -1.0, 1.0)).max()),
        tilt_rate=float((np.linalg.norm(turning, axis=-1) / strength).max()),
    )


def shortfalls(asked: Demands, limits: Limits, who: str) -> list[str]:
    """One sentence for each limit that is exceeded: the demand, the limit and the difference."""
    degrees = 180.0 / math.pi
    table = {
        "thrust": (asked.max_thrust, limits.max_thrust, "N", 1.0),
        "least thrust": (asked.min_thrust, limits.min_thrust, "N", 1.0),
        "tilt": (asked.tilt, limits.max_tilt, "deg", degrees),
        "tilt rate": (asked.tilt_rate, limits.max_body_rate, "deg/s", degrees),
    }
    sentences = []
    for name, use in asked.uses(limits).items():
        if use > 1.0 + 1e-9:
            wanted, limit, unit, scale = table[name]
            difference, side = abs(wanted - limit) * scale, "below" if "least" in name else "beyond"
            sentences.append(
                f"{who} needs a {name} of {wanted * scale:.4g} {unit}, {difference:.3g} {unit} "
                f"{side} the limit of {limit * scale:.4g} {unit}"
            )
    return sentences


# -- level, along a line --------------------------------------------------------------------------


def level_tilt(acceleration: Any, jerk: Any, gravity: float) -> tuple[Any, Any]:
    """Tilt [rad] and tilt rate [rad/s] of level flight along a line: atan(a/g), g ȧ/(g² + a²)."""
    square = gravity**2 + np.square(acceleration)
    return np.arctan2(acceleration, gravity), gravity * jerk / square


def level_demands(acceleration: Any, jerk: Any, limits: Limits) -> Demands:
    """Demands of level flight along a line, from accelerations [m/s²] and jerks [m/s³]."""
    tilt, rate = level_tilt(acceleration, jerk, limits.gravity)
    largest = float(np.abs(tilt).max())
    weight = limits.mass * limits.gravity
    return Demands(weight / math.cos(largest), weight, largest, float(np.abs(rate).max()))
