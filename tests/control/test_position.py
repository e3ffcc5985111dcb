"""Position control: hover, small angles, flatness by another road, limits, the integral."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.random_turns import as_quat, as_rotation, random_attitudes, random_vec
from springback.control.parameters import ControlSettings
from springback.control.position import (
    NO_MEMORY,
    Aim,
    PositionLaw,
    aim,
    flat_rates,
    heading,
    upward,
)
from springback.control.target import Target
from springback.kernels.trees import leaves
from springback.kernels.vectors import Mat3, Quat, Vec, quaternion_of, rotation
from springback.sensing.measurement import Estimate

MASS, GRAVITY = 1.22, 9.81
ZERO = Vec(0.0, 0.0, 0.0)
LEVEL = Quat(1.0, 0.0, 0.0, 0.0)
SETTINGS = ControlSettings()
LAW = SETTINGS.position_law(MASS, GRAVITY)
HERE = Estimate(ZERO, LEVEL, ZERO, ZERO)


def wanted(**changes: object) -> Target:
    return Target(ZERO, ZERO, ZERO, ZERO, 0.0, 0.0)._replace(**changes)


def aimed(law: PositionLaw = LAW, at: Estimate = HERE, **changes: object) -> Aim:
    return aim(law, wanted(**changes), at, NO_MEMORY)


def up(q: Quat) -> np.ndarray:
    return as_rotation(q).apply([0.0, 0.0, 1.0])


def test_hover_needs_the_weight_and_no_tilt() -> None:
    target = aimed().target
    assert target.thrust == pytest.approx(MASS * GRAVITY, rel=1e-15)
    np.testing.assert_allclose(leaves(target.attitude), [1, 0, 0, 0], atol=1e-15)


@pytest.mark.parametrize(("axis", "turn"), [("x", "y"), ("y", "x")])
def test_small_errors_tilt_towards_the_target(axis: str, turn: str) -> None:
    """K_p d/(m g) about +y for a target ahead (nose down), about −x for one to the left."""
    d = 1e-4
    target = aimed(position=ZERO._replace(**{axis: d})).target
    angle = 2.0 * getattr(target.attitude, turn)
    sign = 1.0 if turn == "y" else -1.0
    assert angle == pytest.approx(sign * SETTINGS.stiffness * d / (MASS * GRAVITY), rel=1e-6)


def test_gains_are_forces_not_accelerations() -> None:
    """A heavier model climbs with the same extra force, and tilts less."""
    for mass in (1.0, 2.0):
        law = SETTINGS.position_law(mass, GRAVITY)
        assert aimed(law, position=Vec(0.0, 0.0, 0.1)).target.thrust - mass * GRAVITY == (
            pytest.approx(0.1 * SETTINGS.vertical_stiffness, rel=1e-12)
        )
        moving = HERE._replace(velocity=Vec(0.0, 0.0, 0.1))
        assert aimed(law, moving).target.thrust - mass * GRAVITY == (
            pytest.approx(-0.1 * SETTINGS.damping_for(mass)[1], rel=1e-12)
        )


def test_feedback_is_cut_and_feed_forward_is_not() -> None:
    most = SETTINGS.feedback_acceleration
    far = aimed(position=Vec(100.0, 0.0, 0.0)).target
    assert math.tan(2.0 * math.asin(far.attitude.y)) == pytest.approx(most / GRAVITY, rel=1e-12)
    ahead = aimed(acceleration=Vec(2.0 * most, 0.0, 0.0)).target
    assert math.tan(2.0 * math.asin(ahead.attitude.y)) == pytest.approx(
        2.0 * most / GRAVITY, rel=1e-12
    )


def test_thrust_is_the_force_along_the_body_axis_as_it_is() -> None:
    for q in random_attitudes(50, 1):
        thrust = aimed(at=HERE._replace(attitude=q)).target.thrust
        assert thrust == pytest.approx(max(0.0, MASS * GRAVITY * up(q)[2]), abs=1e-12)


def flat_attitude(acceleration: np.ndarray, yaw: float) -> Rotation:
    """Mellinger's construction by orthogonalisation, without a vector product for b_1.

    b_3 along the force; b_1 is x_C freed of its part along b_3.
    """
    b_3 = acceleration / np.linalg.norm(acceleration)
    x_c = np.array([math.cos(yaw), math.sin(yaw), 0.0])
    # b_2 is normal to b_3 and x_C, so b_1 is in their plane and normal to b_3.
    b_1 = x_c - (x_c @ b_3) * b_3
    b_1 /= np.linalg.norm(b_1)
    return Rotation.from_matrix(np.column_stack([b_1, np.cross(b_3, b_1), b_3]))


def test_attitude_is_the_flat_one() -> None:
    rng = np.random.default_rng(2)
    for _ in range(200):
        a, yaw = random_vec(rng, 8.0), float(rng.uniform(-3.0, 3.0))
        got = as_rotation(aimed(acceleration=a, yaw=yaw).target.attitude)
        expected = flat_attitude(np.array([a.x, a.y, a.z + GRAVITY]), yaw)
        assert (got.inv() * expected).magnitude() < 1e-7


def test_feed_forward_is_the_angular_velocity_of_the_flat_attitude() -> None:
    """Against differences of attitudes along a path of constant jerk and yaw rate."""
    rng, h = np.random.default_rng(3), 1e-5
    law = SETTINGS.model_copy(update={"feed_forward": True}).position_law(MASS, GRAVITY)
    for _ in range(50):
        a, jerk = random_vec(rng, 6.0), random_vec(rng, 20.0)
        yaw, yaw_rate = float(rng.uniform(-3.0, 3.0)), float(rng.uniform(-2.0, 2.0))
        target = aimed(law, acceleration=a, jerk=jerk, yaw=yaw, yaw_rate=yaw_rate).target
        ends = [
            flat_attitude(np.array(a + jerk * t + Vec(0.0, 0.0, GRAVITY)), yaw + yaw_rate * t)
            for t in (-h, h)
        ]
        differences = (ends[0].inv() * ends[1]).as_rotvec() / (2.0 * h)
        np.testing.assert_allclose(leaves(target.angular_velocity), differences, atol=1e-5)
    assert (
        leaves(aimed(acceleration=a, jerk=jerk, yaw_rate=1.0).target.angular_velocity) == [0.0] * 3
    )


def test_tilt_stays_within_its_limit_and_lift_above_zero() -> None:
    """Also where the force vanishes, points down or lies along the heading: never singular."""
    rng, most = np.random.default_rng(4), math.radians(50.0)
    law = SETTINGS.model_copy(update={"tilt_limit": most}).position_law(MASS, GRAVITY)
    cases = [random_vec(rng, 60.0) for _ in range(300)]
    cases += [Vec(0.0, 0.0, -GRAVITY), Vec(5.0, 0.0, -GRAVITY), Vec(0.0, 0.0, -50.0)]
    limited = 0
    for a in cases:
        force = upward(law, (a + Vec(0.0, 0.0, GRAVITY)) * MASS)
        axis = up(aimed(law, acceleration=a).target.attitude)
        assert force.z > 0.0
        along = np.array(force) @ up(LEVEL)  # thrust is of what can be aimed at, no more
        assert aimed(law, acceleration=a).target.thrust == pytest.approx(along, rel=1e-12)
        assert axis[2] >= math.cos(most) - 1e-12
        limited += axis[2] < math.cos(most) + 1e-9
        if a.z + GRAVITY > law.min_lift / MASS:  # height goes before sideways motion
            assert force.z == pytest.approx(MASS * (a.z + GRAVITY), rel=1e-12)
    assert limited > 50


def test_heading_along_the_axis_still_is_an_attitude() -> None:
    built = heading(Vec(1.0, 0.0, 0.0), 0.0)
    r = np.array(built.axes)
    np.testing.assert_allclose(r.T @ r, np.eye(3), atol=1e-15)
    assert np.linalg.det(r) == pytest.approx(1.0)
    assert all(map(math.isfinite, leaves(flat_rates(built, Vec(1.0, 2.0, 3.0), 9.0, 1.0))))


def test_integral_removes_a_steady_error_and_does_not_wind_up() -> None:
    law = SETTINGS.model_copy(update={"integral": 3.0}).position_law(MASS, GRAVITY)
    memory, off = NO_MEMORY, HERE._replace(position=Vec(0.0, 0.0, -0.1))
    for _ in range(50):
        memory = aim(law, wanted(), off, memory).memory
    assert memory.integral.z == pytest.approx(3.0 * 0.1 * 50 * law.period, rel=1e-12)
    for _ in range(2000):
        memory = aim(law, wanted(), off, memory).memory
    assert memory.integral.z == law.integral_limit
    far = HERE._replace(position=Vec(0.0, 0.0, -50.0))
    assert aim(law, wanted(), far, NO_MEMORY).memory == NO_MEMORY


def test_quaternion_of_a_matrix() -> None:
    half_turns = [as_quat(Rotation.from_rotvec(np.pi * np.eye(3)[k])) for k in range(3)]
    for q in [*random_attitudes(500, 5), *half_turns]:
        back = quaternion_of(rotation(q))
        assert back.w >= 0.0
        assert abs(np.dot(leaves(back), leaves(q))) == pytest.approx(1.0, abs=1e-14)
        assert np.abs(np.array(rotation(back)) - np.array(rotation(q))).max() < 1e-14
    assert quaternion_of(Mat3(Vec(1.0, 0.0, 0.0), Vec(0.0, 1.0, 0.0), Vec(0.0, 0.0, 1.0))) == LEVEL


def test_plain_python_is_the_compiled_law() -> None:
    @numba.njit
    def compiled(law, target, at, memory):  # type: ignore[no-untyped-def]
        return aim(law, target, at, memory)

    rng = np.random.default_rng(6)
    law = SETTINGS.model_copy(update={"feed_forward": True, "integral": 1.0}).position_law(
        MASS, GRAVITY
    )
    for q in random_attitudes(200, 7):
        target = Target(*(random_vec(rng, 5.0) for _ in range(4)), 0.3, 0.2)
        at = Estimate(random_vec(rng, 1.0), q, random_vec(rng, 1.0), ZERO)
        assert compiled(law, target, at, NO_MEMORY) == aim(law, target, at, NO_MEMORY)


def test_height_goes_first_where_thrust_is_short() -> None:
    """No more than the rotors give: the vertical part is kept, the horizontal keeps its direction.

    And its margin, where the vertical part alone would take all.
    """
    most = 24.0
    law, rng = SETTINGS.position_law(MASS, GRAVITY, most), np.random.default_rng(9)
    short = 0
    for _ in range(200):
        force = random_vec(rng, 40.0)
        got = upward(law, force)
        lift = min(max(force.z, law.min_lift), most)
        assert got.z == pytest.approx(lift, rel=1e-12)
        across, asked = math.hypot(got.x, got.y), math.hypot(force.x, force.y)
        room = max(math.sqrt(most**2 - lift**2), law.margin * most)
        assert across == pytest.approx(min(asked, room, lift * law.slope), rel=1e-9)
        assert got.x * force.y == pytest.approx(got.y * force.x, abs=1e-9)
        short += asked > room
    assert short > 30
