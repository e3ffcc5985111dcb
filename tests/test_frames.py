"""Euler angles against SciPy's rotations, and there and back."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from springback.frames import attitude_from_euler, euler_from_attitude


def test_euler_angles_are_scipys_intrinsic_zyx() -> None:
    for roll, pitch, yaw in np.random.default_rng(0).uniform(-1.5, 1.5, (100, 3)):
        ours = attitude_from_euler(roll, pitch, yaw)
        theirs = Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_quat(scalar_first=True)
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=1e-15)
        np.testing.assert_allclose(euler_from_attitude(ours), [roll, pitch, yaw], atol=1e-12)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("pitch", [-0.5 * np.pi, 0.5 * np.pi])
def test_the_nose_straight_down_or_up_is_no_trouble(pitch: float) -> None:
    """Roll is then 0 and yaw turns for both; SciPy would warn of it."""
    roll, found, _ = euler_from_attitude(attitude_from_euler(0.3, pitch, 0.5))
    assert roll == 0.0
    np.testing.assert_allclose(found, pitch, atol=1e-7)


def test_positive_pitch_is_nose_down() -> None:
    attitude = Rotation.from_quat(attitude_from_euler(0.0, 0.1, 0.0), scalar_first=True)
    assert attitude.apply([1.0, 0.0, 0.0])[2] < 0.0


def test_attitudes_in_the_axes_of_others() -> None:
    """As docs/coming_from.md converts them: FRD to NED, and FLU to ENU."""
    half_turn = np.diag([1.0, -1.0, -1.0])  # about X: NWU and NED, FLU and FRD
    to_enu = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    for seed in range(20):
        turned = Rotation.random(random_state=seed)
        w, x, y, z = turned.as_quat(scalar_first=True)
        px4 = Rotation.from_quat([w, x, -y, -z], scalar_first=True).as_matrix()
        np.testing.assert_allclose(px4, half_turn @ turned.as_matrix() @ half_turn, atol=1e-15)
        quarter = Rotation.from_quat([0.5**0.5, 0.0, 0.0, 0.5**0.5], scalar_first=True)
        enu = (quarter * turned).as_matrix()
        np.testing.assert_allclose(enu, to_enu @ turned.as_matrix(), atol=1e-15)
    north, west, up = 1.0, 2.0, 3.0
    np.testing.assert_array_equal(to_enu @ [north, west, up], [-west, north, up])
