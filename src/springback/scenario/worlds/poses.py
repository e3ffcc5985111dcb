"""Poses of frames in the files of other programs, in each of their notations.

A pose takes a point p of the inner frame to R p + t in the outer one; `a @ b` is b seen through a.
Euler angles that are read back are those of `springback.frames`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Below this cosine of the pitch roll and yaw turn about the same axis: roll is then 0.
UPENDED = 1e-12


class FramePose(NamedTuple):
    """Pose of a frame in another."""

    turn: Array  # R, shape (3, 3): columns are its axes in the outer frame
    place: Array  # t, its origin in the outer frame [m]

    def __matmul__(self, inner: FramePose) -> FramePose:
        """Pose of what has the pose ``inner`` in this frame."""
        return FramePose(self.turn @ inner.turn, self.turn @ inner.place + self.place)

    def inverse(self) -> FramePose:
        """Pose of the outer frame in this one."""
        return FramePose(self.turn.T, -self.turn.T @ self.place)

    def point(self, x: float, y: float, z: float) -> list[float]:
        """A point of this frame in the outer one [m]."""
        found: list[float] = (self.turn @ np.array([x, y, z]) + self.place).tolist()
        return found

    def angles(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw [rad], exact to rounding at any pitch."""
        r = self.turn.tolist()
        cosine = math.hypot(r[0][0], r[1][0])
        pitch = math.atan2(-r[2][0], cosine)
        yaw = math.atan2(r[1][0], r[0][0]) if cosine > UPENDED else math.atan2(-r[0][1], r[1][1])
        s, c = math.sin(yaw), math.cos(yaw)
        roll = math.atan2(s * r[0][2] - c * r[1][2], c * r[1][1] - s * r[0][1])
        return (roll if cosine > UPENDED else 0.0), pitch, yaw


def at_origin() -> FramePose:
    """The pose of a frame in itself."""
    return FramePose(np.eye(3), np.zeros(3))


def from_angles(place: Sequence[float], angles: Sequence[float]) -> FramePose:
    """Pose from a place [m] and roll, pitch, yaw about fixed axes [rad] (SDF, URDF)."""
    (a, b, c), (p, q, r) = map(math.cos, angles), map(math.sin, angles)
    turn = np.array([
        [c * b, c * q * p - r * a, c * q * a + r * p],
        [r * b, r * q * p + c * a, r * q * a - c * p],
        [-q, b * p, b * a],
    ])  # fmt: skip
    return FramePose(turn, np.array(place, dtype=float))


def turn_from_quaternion(w: float, x: float, y: float, z: float) -> Array:
    """Rotation of a quaternion of any length but 0."""
    length = math.hypot(w, x, y, z)
    w, x, y, z = w / length, x / length, y / length, z / length
    return np.array([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ])  # fmt: skip


def turn_about(axis: Sequence[float], angle: float) -> Array:
    """Rotation about an axis of any length but 0 by an angle [rad]."""
    length, s = math.hypot(*axis), math.sin(0.5 * angle)
    return turn_from_quaternion(math.cos(0.5 * angle), *(s * part / length for part in axis))


def turn_in_sequence(sequence: str, angles: Sequence[float]) -> Array:
    """Rotation by Euler angles in the order of MJCF's ``eulerseq``.

    Args:
        sequence: Three axes: in small letters each turns with the frame, in capitals it is fixed.
        angles: About each of them [rad].
    """
    found = np.eye(3)
    for letter, angle in zip(sequence, angles, strict=True):
        axis = [float(letter.lower() == name) for name in "xyz"]
        turn = turn_about(axis, angle)
        found = found @ turn if letter.islower() else turn @ found
    return found


def turn_from_axes(x: Sequence[float], y: Sequence[float]) -> Array:
    """Rotation whose first axis is along x, and whose second is y made perpendicular to it."""
    first = np.array(x) / math.hypot(*x)
    second = np.array(y) - (first @ np.array(y)) * first
    second /= np.linalg.norm(second)
    return np.stack([first, second, np.cross(first, second)], axis=1)


def turn_to(z: Sequence[float]) -> Array:
    """The shortest rotation that takes the third axis along a direction."""
    length = math.hypot(*z)
    x, y, up = (part / length for part in z)
    across = math.hypot(x, y)
    if across < 1e-10:
        return np.eye(3) if up > 0.0 else np.diag([1.0, -1.0, -1.0])
    return turn_about([-y, x, 0.0], math.atan2(across, up))
