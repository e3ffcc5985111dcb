"""Times: rates, gaps, stamps of arrival, offsets, clocks that jump."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from builders.recordings import CHANGE, inertial, poses, recording
from springback.errors import InputError
from springback.logs.clock_jumps import clock_jumps, refuse_clock_jumps
from springback.logs.clocks import Integral, attitude_rates, clock_offset, timing
from springback.logs.overview import overview
from springback.logs.recording import (
    DISORDER,
    SPECIFIC_FORCE,
    Budget,
    LogChannel,
    log_channel,
    refuse_without_channels,
)


def channel(times: np.ndarray, values: np.ndarray | None = None, name: str = "imu"):
    force = np.tile([0.0, 0.0, 9.8], (len(times), 1)) if values is None else values
    return log_channel("log", name, SPECIFIC_FORCE, times, force)


def test_a_gap_is_found_with_its_place_and_length() -> None:
    t = np.concatenate([np.arange(0.0, 1.0, 0.005), np.arange(1.16, 2.0, 0.005)])
    told = timing(channel(t))
    assert told.rate == pytest.approx(200.0)
    [gap] = told.gaps
    assert (gap.start, gap.duration) == pytest.approx((0.995, 0.165))
    assert told.longest == gap
    assert not told.has_arrivals
    assert timing(channel(np.array([0.0]))).longest is None


def test_times_of_arrival_are_told_from_those_of_samples() -> None:
    """As in poses that came over a network in bursts: many gaps below 1 ms, many above 50 ms."""
    t = np.repeat(np.arange(0.0, 20.0, 0.06), 4) + np.tile([0.0, 2e-4, 4e-4, 6e-4], 334)[:1336]
    assert timing(channel(t)).has_arrivals
    jitter = np.random.default_rng(2).normal(0.0, 5e-4, 1000)
    assert not timing(channel(np.sort(np.arange(1000) * 0.01 + jitter))).has_arrivals


def test_samples_that_are_out_of_order_by_little_are_sorted_with_their_flags() -> None:
    t = np.array([0.0, 0.02, 0.01, 0.03])
    values = np.arange(12.0).reshape(4, 3)
    flags = values > 8.0
    found = log_channel("log", "imu", SPECIFIC_FORCE, t, values, clipped=flags)
    assert found.times.tolist() == [0.0, 0.01, 0.02, 0.03]
    assert found.values[:, 0].tolist() == [0.0, 6.0, 3.0, 9.0]
    assert found.disorder == (1, pytest.approx(0.01))
    assert found.clipped is not None
    assert found.clipped[:, 0].tolist() == [False, False, False, True]


def test_a_clock_that_goes_back_is_refused_with_its_place() -> None:
    t = np.concatenate([np.arange(0.0, 1.0, 0.01), np.arange(0.5, 2.0, 0.01)])
    with pytest.raises(InputError) as refused:
        channel(t)
    assert refused.value.problems == (
        "log: imu: its clock goes back by 0.49 s after 0.99 s (sample 100 of 250): read the "
        "part before or after with --from and --until",
    )
    channel(np.array([0.0, 1.0, 1.0 - 0.9 * DISORDER]))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e300])
def test_a_time_that_is_none_is_refused_unless_the_log_is_long(bad: float) -> None:
    short = np.array([0.0, bad, bad])
    with pytest.raises(InputError, match="log: imu: the time of sample 2 is no instant"):
        channel(short)
    t = np.arange(0.0, 10.0, 0.01)
    t[500] = bad
    assert len(channel(t).times) == 999


def test_a_value_that_is_none_is_lost_if_it_is_one_of_many() -> None:
    t = np.arange(0.0, 2.0, 0.01)
    values = np.tile([0.0, 0.0, 9.8], (200, 1))
    values[7] = 1e300
    assert channel(t, values).is_lost.tolist() == [k == 7 for k in range(200)]
    values[:50] = np.inf
    with pytest.raises(InputError, match="sample 1 is inf m/s\\^2, more than any vehicle does"):
        channel(t, values)


@pytest.mark.parametrize("start", [-3.0, 0.0125, 1173.5])
def test_the_offset_of_two_clocks_is_found_within_a_tenth_of_a_millisecond(start: float) -> None:
    _, gyro = inertial(4.0, start=start)
    _, attitude = poses(3.0)
    found = clock_offset(attitude, gyro)
    assert found.seconds == pytest.approx(start, abs=1e-4)
    assert found.correlation > 0.999


def test_no_mistake_of_axes_changes_the_offset() -> None:
    _, gyro = inertial(4.0, start=2.25)
    turned = replace(gyro, values=-gyro.values[:, [2, 0, 1]])
    _, attitude = poses(3.0)
    assert clock_offset(attitude, turned).seconds == pytest.approx(2.25, abs=1e-4)


def test_logs_of_two_clocks_are_compared_at_their_offset() -> None:
    found = overview([recording(*inertial(start=5.5)), recording(*poses())])
    assert all(one.passed for one in found.findings)
    assert "clocks +5.5000 s apart" in " ".join(one.sentence for one in found.findings)
    said = {one.name: one.sentence for one in found.findings}
    assert said["vehicle.attitude and accelerometer"].startswith("gravity is ")
    assert "bends as the specific force" in said["vehicle.position and accelerometer"]
    [impact] = found.impacts
    assert impact.touch == pytest.approx(7.5, abs=0.003)
    assert impact.velocity_change == pytest.approx(CHANGE, abs=0.03)


def test_rates_of_an_attitude_leave_out_gaps_losses_and_resets() -> None:
    _, attitude = poses(2.0)
    whole = attitude_rates(attitude)
    values = attitude.values.copy()
    values[100] = np.nan
    resets = np.zeros(len(values), dtype=bool)
    resets[200] = True
    found = attitude_rates(replace(attitude, values=values, resets=resets))
    jump = round(0.03 * 200)
    assert len(whole.begins) - len(found.begins) == 2 + jump
    assert np.abs(whole.values).max() < 3.0


def test_a_mean_over_a_gap_is_not_whole() -> None:
    t = np.concatenate([np.arange(0.0, 1.0, 0.005), np.arange(1.2, 2.0, 0.005)])
    values = np.stack([t, 2.0 * t, 0.0 * t], axis=1)
    integral = Integral(log_channel("log", "imu", SPECIFIC_FORCE, t, values))
    means, whole = integral.means(np.array([0.1, 0.98, -0.5]), np.array([0.2, 1.22, 0.2]))
    assert whole.tolist() == [True, False, False]
    assert means[0] == pytest.approx([0.15, 0.3, 0.0])


def test_a_log_too_large_for_the_memory_is_refused() -> None:
    budget = Budget("log", 10)
    budget.take(10)
    with pytest.raises(InputError, match=r"log: has more than 1e-05 million numbers of interest"):
        budget.take(1)


def test_a_log_of_which_nothing_is_read_says_what_would_be() -> None:
    with pytest.raises(InputError, match=r"log: has nothing that can be used \(cut\); known are x"):
        refuse_without_channels("log", [], "x", ["cut"])


def jumped(one: LogChannel, at: float, by: float) -> LogChannel:
    return replace(one, times=one.times + np.where(one.times > at, by, 0.0))


def test_a_track_whose_clock_jumps_ahead_is_refused_by_its_motion() -> None:
    """It flies on at 1 m/s from where it was."""
    place, attitude = poses()
    log = recording(*(jumped(one, 0.6, 0.5) for one in (place, attitude)))
    [found] = clock_jumps([log])
    assert (found.at, found.seconds) == (pytest.approx(0.6, abs=0.006), pytest.approx(0.5))
    with pytest.raises(
        InputError, match=r"^made: vehicle.position: its clock jumps ahead by 500 ms"
    ):
        refuse_clock_jumps([log])
    assert any("its clock jumps" in one.sentence for one in overview([log]).findings)


@pytest.mark.parametrize("which", ["track", "inertial unit"])
def test_a_clock_that_jumps_is_found_by_the_turns_of_another(which: str) -> None:
    place, attitude = poses(8.0, touch=7.0)
    unit = inertial(8.0, touch=7.0)
    if which == "track":
        attitude = jumped(attitude, 3.0, 0.4)
    else:
        unit = [jumped(one, 3.0, 0.4) for one in unit]
    [found] = clock_jumps([recording(*unit), recording(attitude, path="take")])
    assert found.log == ("take" if which == "track" else "made")
    assert found.seconds == pytest.approx(0.4, abs=0.01)
    assert "than before the gap" in found.sentence
    assert clock_jumps([recording(*inertial(8.0, touch=7.0)), recording(place)]) == []


def test_samples_that_are_lost_are_no_jump() -> None:
    """A gap of half a second, in which the vehicle flies on; a bounce back to where it was."""

    def without(one: LogChannel) -> LogChannel:
        kept = (one.times < 1.0) | (one.times > 1.5)
        return replace(one, times=one.times[kept], values=one.values[kept])

    place, attitude = (without(one) for one in poses())
    assert clock_jumps([recording(*inertial()), recording(place, attitude)]) == []
    back = np.where(place.times[:, None] > 1.2, -1.0, 1.0) * (place.times[:, None] - 1.25)
    returned = replace(place, values=np.tile(back, (1, 3)))
    assert clock_jumps([recording(returned)]) == []
