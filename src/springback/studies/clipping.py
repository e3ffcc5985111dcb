"""Velocity that clipping hides from an accelerometer, over the speed of a collision.

A filter must learn from poses what it cannot read, and how soon it does depends on how much it
trusts them; so the size of the gap, not the impact itself, separates the robots.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from springback.progress import Progress, silent
from springback.results.estimate_errors import clipped_area
from springback.results.flight import fly
from springback.sensing.parameters import STANDARD_GRAVITY
from springback.studies.friction import PRINTED_FRICTION, impact_tables
from springback.studies.run_ups import ROBOTS, study_vehicles

SPEEDS = tuple(0.5 * k for k in range(2, 11))
"""[m/s]"""
RANGE = 16.0 * STANDARD_GRAVITY
"""Range of the ICM-20689 [m/s²]."""
KINDS = (("quad", "vertical"), ("arq", "both"), ("arq", "vertical"))
"""Robots and axes of friction, the hardest impact first; a rigid front hardly minds the axes."""


class ClippingLoss(NamedTuple):
    """One collision."""

    robot: str
    axes: str
    speed: float  # into the wall [m/s]
    velocity: float  # hidden from the accelerometer [m/s]
    change: float  # of the velocity in the impact [m/s]

    def as_dict(self) -> dict[str, float | str]:
        """One row of a table."""
        return {
            "robot": self.robot, "friction axes": self.axes, "speed [m/s]": self.speed,
            "velocity hidden by clipping [m/s]": self.velocity,
            "change of velocity [m/s]": self.change,
        }  # fmt: skip


def clipping_losses(
    speeds: Sequence[float] = SPEEDS,
    *,
    full_scale: float = RANGE,
    progress: Progress = silent,
) -> list[ClippingLoss]:
    """Fly both robots straight into the paper's wall, level, and integrate what is clipped.

    Args:
        speeds: Into the wall [m/s].
        full_scale: Range of each axis of the accelerometer [m/s²].
        progress: Called with the fraction done.
    """
    found, vehicles = [], {one.name: one for one in study_vehicles(ROBOTS)}
    asked = [(robot, axes, speed) for robot, axes in KINDS for speed in speeds]
    for done, (robot, axes, speed) in enumerate(asked, 1):
        flight = fly(impact_tables(vehicles[robot], axes, PRINTED_FRICTION, 0.0, speed))
        velocity = clipped_area(flight, full_scale)
        restitution = flight.measures["restitution_at_separation"] or 0.0
        found.append(ClippingLoss(robot, axes, speed, velocity, speed * (1.0 + restitution)))
        progress(done / len(asked))
    return found
