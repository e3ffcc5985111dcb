"""The hits that springback and MuJoCo are compared on, and what of them must be accurate.

Both fly the vehicle of `benchmarks.job`, the five bodies of ARQ at hovering thrust, into a wall.
Every program may take the coarsest step at which its own restitution, peak acceleration and contact
time are within `TOLERANCE` of what they converge to, in the worst of `JUDGED` hits.  MuJoCo has
another contact law; its constants are fitted so that what both converge to agrees within that
tolerance, too, in the median over the hits; every report shows how well.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.job import reference_model, starts
from benchmarks.mujoco_model import xml
from springback.kernels.vectors import Quat, Vec
from springback.simulation.measuring.record import Model
from springback.vehicle.state import State

METRICS = ("restitution", "peak acceleration", "contact time")
TOLERANCE, JUDGED = 0.01, 32
HORIZON = 0.15  # [s]
FREE_STEP = 1e-3  # [s]
DEFAULT_STEP = 1e-4  # [s]
#: Tried, coarsest first, and the one taken as the limit [s].
OUR_STEPS, OUR_LIMIT = (1e-3, 5e-4, 2e-4, 1e-4), 1e-5
THEIR_STEPS, THEIR_LIMIT = (1e-3, 5e-4, 3e-4, 2e-4, 1e-4, 5e-5, 2.5e-5, 2e-5, 1e-5), 1e-5
INTEGRATORS = ("RK4", "implicitfast")
LIMITING = "RK4"  # whose limit is used for both, as its errors are the smaller
#: MuJoCo's wall: stiffness and damping, and the impedance that grows with depth.  Fitted by least
#: squares: over the judged hits, the median of theirs over ours is 1 for each of `METRICS`.
WALL = 'solref="-20106 -91.12" solimp="0.3072 0.95 0.01224 0.5 1" priority="1"'
#: What tells MuJoCo's contact apart, its depth included; only where accuracy is judged.
WATCHED = '<contact geom1="wall" data="found dist" reduce="mindist" num="1"/>'


def model(step: float) -> Model:
    """The vehicle before the wall, taking some step in contact [s]."""
    made = reference_model(until=HORIZON, free_step=FREE_STEP)
    settle = min(4.0 * step, FREE_STEP)
    return made._replace(timing=made.timing._replace(impact_step=step, settle_step=settle))


def hits(count: int) -> list[State]:
    """Starts before the wall at 1.5 to 3 m/s, each turned its own way by about 2°, not turning."""
    chance, common = np.random.default_rng(0), starts(model(DEFAULT_STEP), 1)[0]
    made = []
    for speed in np.linspace(1.5, 3.0, count):
        q = np.array([1.0, *chance.normal(0.0, 0.02, 3)])
        q /= np.linalg.norm(q)
        made.append(
            common._replace(
                attitude=Quat(*map(float, q)),
                velocity=Vec(float(speed), 0.0, 0.0),
                angular_velocity=Vec(0.0, 0.0, 0.0),
            )
        )
    return made


def rows(states: list[State]) -> list[list[float]]:
    """Positions and velocities of a free body and four slides, as MuJoCo orders them."""
    still = [0.0] * 4
    return [
        [*s.position, *s.attitude, *still, *s.velocity, *s.angular_velocity, *still] for s in states
    ]


def document(integrator: str, step: float, watched: bool) -> str:
    """The vehicle and its wall for MuJoCo."""
    seen = WATCHED if watched else ""
    return xml(model(step), integrator, "disc", False, wall=WALL, watched=seen)


def thrust() -> float:
    """Of all rotors together [N]."""
    return float(sum(model(DEFAULT_STEP).thrust))


def agreement(ours: Any, theirs: Any) -> dict[str, dict[str, float]]:
    """What MuJoCo converges to over what springback does, of every metric.

    Args:
        ours: Metrics of the hits, shape (3, hits).
        theirs: The same.
    """
    ratios = np.asarray(theirs) / np.asarray(ours)
    return {
        name: {
            "median": float(np.median(row)), "lowest": float(row.min()), "highest": float(row.max())
        }
        for name, row in zip(METRICS, ratios, strict=True)
    }  # fmt: skip


def chosen(found: dict[str, Any]) -> tuple[float, list[float]]:
    """The coarsest step whose worst errors are all within the tolerance, and its errors.

    Args:
        found: Of a program that judged its accuracy: ``errors`` of every step.

    Raises:
        ValueError: If no step is fine enough.
    """
    ordered = sorted(((float(step), errors) for step, errors in found["errors"]), reverse=True)
    for step, errors in ordered:
        if max(errors) <= TOLERANCE:
            return step, errors
    raise ValueError(f"no step is within {TOLERANCE:.0%}")
