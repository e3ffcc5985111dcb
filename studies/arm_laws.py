"""Test whether preload, free play or a one-sided damper explains ARQ's numbers on the slider.

    python studies/arm_laws.py

Prints the table in studies/README.md.

The printed model has none of them, but hardware may: each is a reading with one thing more and one
number, fitted to the eight numbers of ARQ in Table III.  The robot's symmetry on the slider leaves
three unknowns, the main body's place and the compression of the front and of the rear arms, so that
a small model does; without an additional law it gives what the whole program gives
(tests/paper/test_arm_laws.py).

Along X, with the arms at 45 degrees, c = cos 45°, s = L - l of the front arms, u of the rear ones,
x the way of the main body, and m the whole mass:

    cage          δ = x - c s,    f = k_c δ^1.5 (1 + 1.5 c_a δ') >= 0  at each of two cages
    whole robot   m x'' - 2 m_a c s'' + 2 m_a c u'' = -2 f
    front arms    m_a (s'' - c x'') = c f - F(s, s')
    rear arms     m_a (u'' + c x'') = -F(u, u')
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # its parts are loaded when first used

from springback.contact.library import SURFACES
from springback.paper.printed import SLIDER_SPEED, TABLE_III
from springback.paper.slider import fitted_dissipation

COSINE = math.sqrt(0.5)
BODY = 1.882
"""[kg], Table II's main body with its bar."""
STEP, LONGEST = 2e-5, 0.25
"""[s], chosen: of the Runge–Kutta method, and of a test."""
SURFACES_HIT = ("wall", "mat")


class ArmLaw(NamedTuple):
    """A spring and damper of an arm, with what hardware may add."""

    mass: float
    """Of the arm [kg]."""
    stiffness: float
    """[N/m]"""
    damping: float
    """On the way in [N s/m]."""
    rebound: float = 1.0
    """Damping on the way out, over that on the way in."""
    preload: float = 0.0
    """That presses the arm against its stop at the free length [N]."""
    play: float = 0.0
    """Way that the arm goes before the spring touches it [m]."""

    @property
    def has_stop(self) -> bool:
        """Whether the arm cannot grow longer than its free length: what preloads must stop."""
        return self.preload > 0.0 or self.play > 0.0

    def force(self, stroke: float, rate: float) -> float:
        """Towards the free length, for a compression [m] and its rate [m/s]; [N]."""
        if self.has_stop and stroke <= self.play:
            return 0.0
        damping = self.damping * (1.0 if rate > 0.0 else self.rebound)
        return self.preload + self.stiffness * (stroke - self.play) + damping * rate


BASES = {"B": ArmLaw(0.05, 5e3, 90.0), "D": ArmLaw(0.1, 1250.0, 22.5)}
"""The readings that are varied, as `springback.paper.slider.READINGS` has them."""


class Bounce(NamedTuple):
    """The four numbers of a column of Table III, `springback.paper.slider.COUNTED`."""

    restitution: float
    peak: float  # [m/s²]
    travel: float  # [m]
    back: float  # time until the body is back [s]


class FittedLaw(NamedTuple):
    """A named law, with the number that was fitted."""

    name: str
    what: str
    unit: str
    field: str
    bounds: tuple[float, float]
    scale: float


VARIANTS = (
    FittedLaw("preload", "springs are pressed against a stop by", "N", "preload", (0.0, 60.0), 1.0),
    FittedLaw("free play", "arms move freely for", "mm", "play", (0.0, 0.015), 1e3),
    FittedLaw("one-sided damper", "damping on the way out is less, by a factor of", "", "rebound",
            (0.0, 1.0), 1.0),
)  # fmt: skip
"""A reading with one thing more."""


def bounce(surface: str, law: ArmLaw, dissipation: float, speed: float = SLIDER_SPEED) -> Bounce:
    """ARQ hits a surface on the slider.

    Args:
        surface: ``wall`` or ``mat``.
        law: Of each arm.
        dissipation: c_a [s/m].
        speed: At touch [m/s].
    """
    stiffness = float(SURFACES[surface].stiffness) / 2.0
    mass = law.mass
    whole = BODY + 4.0 * mass

    def contact(x: float, v: float, s: float, r: float) -> float:
        depth, rate = x - COSINE * s, v - COSINE * r
        if depth <= 0.0:
            return 0.0
        return max(0.0, stiffness * depth * math.sqrt(depth) * (1.0 + 1.5 * dissipation * rate))

    def rates(state: State) -> State:
        x, v, s, r, u, q = state
        f = contact(x, v, s, r)
        front, rear = COSINE * f - law.force(s, r), -law.force(u, q)
        # An arm at its stop stands still with the body until something pushes it in.
        stands = [law.has_stop and s <= 0.0 and r <= 0.0, law.has_stop and u <= 0.0 and q <= 0.0]
        for _ in stands:
            own = whole - 2.0 * mass * COSINE**2 * (2 - sum(stands))
            pushed = (0.0 if stands[0] else front) - (0.0 if stands[1] else rear)
            a = (-2.0 * f + 2.0 * COSINE * pushed) / own
            moves = [front / mass + COSINE * a, rear / mass - COSINE * a]
            needs = [COSINE * f + mass * COSINE * a > law.preload, -mass * COSINE * a > law.preload]
            stands = [still and not need for still, need in zip(stands, needs, strict=True)]
        b, d = (0.0 if still else move for still, move in zip(stands, moves, strict=True))
        return v, a, r, b, q, d

    state: State = (0.0, speed, 0.0, 0.0, 0.0, 0.0)
    time, peak, travel = 0.0, 0.0, 0.0
    left: float | None = None
    while time < LONGEST:
        k1 = rates(state)
        k2 = rates(_motion(state, k1, 0.5 * STEP))
        k3 = rates(_motion(state, k2, 0.5 * STEP))
        k4 = rates(_motion(state, k3, STEP))
        before = state[0]
        mean = [
            (a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(k1, k2, k3, k4, strict=True)
        ]
        x, v, s, r, u, q = _motion(state, mean, STEP)
        if law.has_stop:
            s, r = (0.0, 0.0) if s < 0.0 else (s, r)
            u, q = (0.0, 0.0) if u < 0.0 else (u, q)
        state, time = (x, v, s, r, u, q), time + STEP
        peak, travel = max(peak, -k1[1]), max(travel, x)
        if left is None and time > 1e-3 and x - COSINE * s <= 0.0:
            left = v
        if x <= 0.0 and v < 0.0:
            back = time - STEP * x / (x - before)
            return Bounce(-(v if left is None else left) / speed, peak, travel, back)
    return Bounce(math.nan, peak, travel, math.nan)


State = tuple[float, float, float, float, float, float]
"""Place and velocity of the main body, compression and its rate of front and rear arms."""


def _motion(state: State, rate: Sequence[float], time: float) -> State:
    x, v, s, r, u, q = (y + time * dy for y, dy in zip(state, rate, strict=True))
    return x, v, s, r, u, q


def deviations(law: ArmLaw) -> list[float]:
    """Relative deviations from ARQ's eight numbers of Table III, the wall's first."""
    found = []
    for surface in SURFACES_HIT:
        ours = bounce(surface, law, fitted_dissipation(surface))
        p = TABLE_III["arq", surface]
        printed = (p.restitution, p.peak_acceleration, p.travel, p.contact_time)
        found += [a / b - 1.0 for a, b in zip(ours, printed, strict=True)]
    return found


class Fit(NamedTuple):
    """A variant with its number as fitted."""

    base: str
    """Reading, of `BASES`."""
    variant: FittedLaw
    value: float  # SI
    deviations: tuple[float, ...]  # of the eight numbers


def fit(base: str, variant: FittedLaw) -> Fit:
    """A variant with the number that makes its root mean square deviation least.

    Args:
        base: Reading, of `BASES`.
        variant: Of `VARIANTS`.
    """

    def error(value: float) -> float:
        off = np.array(deviations(BASES[base]._replace(**{variant.field: float(value)})))
        return float(np.sqrt(np.mean(off**2))) if np.all(np.isfinite(off)) else 1e3

    found = scipy.optimize.minimize_scalar(
        error, bounds=variant.bounds, method="bounded",
        options={"xatol": 1e-2 * (variant.bounds[1] - variant.bounds[0])},
    )  # fmt: skip
    value = float(found.x)
    law = BASES[base]._replace(**{variant.field: value})
    return Fit(base, variant, value, tuple(deviations(law)))


def row(name: str, number: str, off: list[float]) -> str:
    """A line of the table: deviations of the eight numbers, and counts of the small ones."""
    near = (sum(abs(one) <= share for one in off) for share in (0.05, 0.10))
    words = [name, number, *(f"{100 * one:+.0f} %" for one in off), *map(str, near)]
    return f"| {' | '.join(words)} |"


def main() -> None:
    """Fit all of them."""
    heads = [f"{what}, {surface}" for surface in ("wall", "mat")
             for what in ("COR", "peak", "travel", "time")]  # fmt: skip
    print(f"| | fitted | {' | '.join(heads)} | within 5 % | within 10 % |")
    print("|:---|:---|" + "---:|" * 10)
    for base, law in BASES.items():
        print(row(f"reading {base}", "–", deviations(law)))
        for variant in VARIANTS:
            best = fit(base, variant)
            number = f"{variant.scale * best.value:.2g} {variant.unit}".strip()
            print(row(f"{base}, {variant.name}", number, list(best.deviations)))


if __name__ == "__main__":
    main()
