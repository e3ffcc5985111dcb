"""Motions of a main body, as contacts see it."""

from __future__ import annotations

from springback.contact.cage import BodyMotion
from springback.kernels.vectors import Mat3, Vec

STILL = Vec(0.0, 0.0, 0.0)
LEVEL = Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))


def body(r: Mat3 = LEVEL, velocity: Vec = STILL, omega: Vec = STILL) -> BodyMotion:
    """A main body at the origin, with its velocity and angular velocity in body axes."""
    return BodyMotion(STILL, r, velocity, omega, r.z, 0.0)
