"""Motion capture: exactly as late as it says, as wrong as it says, and gone as often as it says."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from springback.kernels.vectors import Quat, Vec
from springback.sensing.measurement import Pose, Truth, task_pace
from springback.sensing.motion_capture import (
    MotionCapture,
    MotionCaptureNoise,
    PerfectMotionCapture,
    motion_capture_at_start,
    pose_of,
)
from springback.sensing.parameters import MotionCaptureSettings
from springback.vehicle.state import State

TICK = 1e-3
ZERO = Vec(0.0, 0.0, 0.0)
LEVEL = Quat(1.0, 0.0, 0.0, 0.0)
QUIET = MotionCaptureNoise(ZERO, ZERO, 0.0)
NEVER = -40.0


def state(x: float, attitude: Quat = LEVEL) -> State:
    return State(Vec(x, 0.5 * x, -x), attitude, ZERO, ZERO, (0.19,), (0.0,))


def truth(x: float, attitude: Quat = LEVEL) -> Truth:
    now = state(x, attitude)
    return Truth(now, now, TICK, 9.81)


def exact(every: float, delay: float) -> MotionCapture:
    return MotionCapture(task_pace(every), delay, 0.0, 0.0, NEVER, -NEVER)


def poses(device: MotionCapture, ticks: int) -> list[Pose]:
    """Poses of a robot whose x [m] is the number of the tick."""
    memory, result = motion_capture_at_start(device, state(0.0)), []
    for tick in range(ticks):
        told = pose_of(device, float(tick), truth(float(tick)), QUIET, memory)
        memory = told.memory
        result.append(told.pose)
    return result


@pytest.mark.parametrize(("every", "delay"), [(e, d) for e in (1, 2, 5) for d in range(4 * e + 1)])
def test_every_pose_is_as_old_as_it_says(every: int, delay: int) -> None:
    said = poses(exact(float(every), float(delay)), 60)
    for tick, pose in nonempty(enumerate(said)):
        taken = tick - delay
        assert pose.fresh == (taken >= 0 and taken % every == 0)
        if pose.fresh:
            assert pose.position.x == taken
            assert pose.age == pytest.approx(delay * TICK, abs=1e-15)
        assert pose.position.x == pytest.approx(tick - pose.age / TICK, abs=1e-9)


def test_perfect_is_exact_at_every_tick() -> None:
    turn = Quat(0.5, 0.5, -0.5, 0.5)
    device = PerfectMotionCapture(0.0)
    memory = motion_capture_at_start(device, state(0.0))
    for tick in range(7):
        noise = MotionCaptureNoise(Vec(9.0, 9.0, 9.0), Vec(9.0, 9.0, 9.0), -9.0)
        told = pose_of(device, float(tick), truth(0.3 * tick, turn), noise, memory)
        assert told.pose == Pose(Vec(0.3 * tick, 0.15 * tick, -0.3 * tick), turn, 1.0, 0.0)


def test_noise_has_the_size_that_was_asked_for() -> None:
    device = MotionCaptureSettings(delay=0.0, rate=1000.0, attitude_noise=2e-3).device(TICK)
    turn = Quat(*Rotation.from_rotvec([0.3, -0.8, 0.5]).as_quat(scalar_first=True).tolist())
    memory = motion_capture_at_start(device, state(0.0, turn))
    rng, shifts, turns = np.random.default_rng(3), [], []
    count = 4000
    for tick in range(count):
        n = rng.standard_normal(6).tolist()
        noise = MotionCaptureNoise(Vec(*n[:3]), Vec(*n[3:]), 0.0)
        told = pose_of(device, float(tick), truth(0.0, turn), noise, memory)
        memory = told.memory
        shifts.append(told.pose.position)
        turns.append(told.pose.attitude)
        assert math.hypot(*told.pose.attitude) == pytest.approx(1.0, abs=1e-15)
    measured = Rotation.from_quat(turns, scalar_first=True)
    angles = (Rotation.from_quat(turn, scalar_first=True).inv() * measured).as_rotvec()
    four_sigma = 4.0 / math.sqrt(2 * count)  # of a standard deviation, relative
    np.testing.assert_allclose(np.std(shifts, axis=0), 2e-4, rtol=four_sigma)
    np.testing.assert_allclose(np.std(angles, axis=0), 2e-3, rtol=four_sigma)
    np.testing.assert_allclose(np.corrcoef(angles.T), np.eye(3), atol=4.0 / math.sqrt(count))


def test_gaps_are_as_frequent_and_as_long_as_asked_for() -> None:
    p, length, count = 0.02, 5.0, 20_000
    settings = MotionCaptureSettings(rate=1000.0, delay=0.0, loss_probability=p, loss_length=length)
    device = settings.device(TICK)
    memory = motion_capture_at_start(device, state(0.0))
    rng, fresh, positions = np.random.default_rng(4), [], []
    for tick, normal in enumerate(rng.standard_normal(count).tolist()):
        told = pose_of(
            device, float(tick), truth(float(tick)), MotionCaptureNoise(ZERO, ZERO, normal), memory
        )
        memory = told.memory
        fresh.append(told.pose.fresh)
        positions.append(told.pose.position.x)
        assert told.pose.position.x == pytest.approx(tick - told.pose.age / TICK, abs=1e-6)
    lost = 1.0 - np.array(fresh)
    # Two-state chain: share p/(p + r), memory of one step λ = 1 − p − r; bands of four sigma.
    r = 1.0 / length
    share, memory_of_chain = p / (p + r), 1.0 - p - r
    spread = share * (1 - share) / count * (1 + memory_of_chain) / (1 - memory_of_chain)
    assert lost.mean() == pytest.approx(share, abs=4 * math.sqrt(spread))
    gaps = np.sum(np.diff(lost, prepend=0.0) > 0)
    deviation = math.sqrt((1 - r) / r**2 / gaps)
    assert lost.sum() / gaps == pytest.approx(length, abs=4 * deviation)


def test_the_last_pose_stands_through_a_gap() -> None:
    device = MotionCapture(task_pace(2.0), 2.0, 0.0, 0.0, 0.0, 0.0)  # p = r = 1/2; the sign decides
    memory, seen = motion_capture_at_start(device, state(0.0)), []
    for tick in range(20):
        normal = -1.0 if tick == 6 else (1.0 if tick < 12 else -1.0)
        told = pose_of(
            device, float(tick), truth(float(tick)), MotionCaptureNoise(ZERO, ZERO, normal), memory
        )
        memory = told.memory
        seen.append((told.pose.fresh, told.pose.position.x))
    # Samples of ticks 6, 8 and 10 are lost; that of tick 12 is back, and arrives at 14.
    assert [tick for tick, (fresh, _) in enumerate(seen) if fresh][:5] == [2, 4, 6, 14, 18]
    assert all(x == 4.0 for _, x in seen[6:14])
