"""Conventions of frames, attitudes and units.

World: NWU, X north, Y west, Z up.  Body: FLU, x forward, y left, z up.  Quaternions: Hamilton,
scalar first, body to world.  Euler angles: ZYX, R = R_z(yaw) R_y(pitch) R_x(roll); positive pitch
is nose down.  SI units and radians.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.kernels.tracing import cos, sin  # for batch set-up


def attitude_from_euler(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Quaternion (w, x, y, z), body to world, of ZYX Euler angles [rad]."""
    a, b, c = cos(0.5 * roll), cos(0.5 * pitch), cos(0.5 * yaw)
    p, q, r = sin(0.5 * roll), sin(0.5 * pitch), sin(0.5 * yaw)
    return (
        a * b * c + p * q * r,
        p * b * c - a * q * r,
        a * q * c + p * b * r,
        a * b * r - p * q * c,
    )


def euler_from_attitude(attitude: Any) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Roll, pitch and yaw [rad] of quaternions (w, x, y, z), shape (..., 4) to (..., 3).

    With the nose straight down or up only yaw and roll together are determined: roll is then 0.
    """
    from scipy.spatial.transform import Rotation  # slow to import, and rarely needed

    flat = np.asarray(attitude, dtype=float).reshape(-1, 4)
    angles = Rotation.from_quat(flat, scalar_first=True).as_euler("ZYX", suppress_warnings=True)
    return np.asarray(angles[:, ::-1]).reshape(*np.shape(attitude)[:-1], 3)
