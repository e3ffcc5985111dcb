"""Euler angles against SciPy's rotations, and there and back."""

import numpy as np
from scipy.spatial.transform import Rotation

from springback.frames import attitude_from_euler, euler_from_attitude


def test_euler_angles_are_scipys_intrinsic_zyx() -> None:
    for roll, pitch, yaw in np.random.default_rng(0).uniform(-1.5, 1.5, (100, 3)):
        ours = attitude_from_euler(roll, pitch, yaw)
        theirs = Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_quat(scalar_first=True)
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-15)
        np.testing.assert_allclose(euler_from_attitude(ours), [roll, pitch, yaw], atol=1e-12)


def test_positive_pitch_is_nose_down() -> None:
    attitude = Rotation.from_quat(attitude_from_euler(0.0, 0.1, 0.0), scalar_first=True)
    assert attitude.apply([1.0, 0.0, 0.0])[2] < 0.0
