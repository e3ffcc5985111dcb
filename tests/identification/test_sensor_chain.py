"""What sensors would tell, against what the sensors of a flight did tell."""

import numpy as np
import pytest

from identification.rigs import LOSS, STIFFNESS, problem_of, recorded, rig
from springback.identification.observations.sensor_chain import (
    ChannelChain,
    channel_output,
    fine_grid,
    smooth,
)

GRID = np.arange(0.0, 0.2005, 1e-3)


@pytest.mark.parametrize("speed", [1.0, 4.0])
def test_the_chain_is_that_of_the_simulated_sensors(speed: float) -> None:
    """Exact but for the converter's counts, clipped peak and low-pass included."""
    quiet = {"noise": 0.0, "bias": 0.0, "walk": 0.0}
    tables = rig(
        speed=speed,
        imu={"accelerometer": quiet, "gyroscope": quiet},
        motion_capture={"perfect": True},
    )
    recording = recorded(tables)
    problem = problem_of(tables, recording, {STIFFNESS: "factor 4", LOSS: "factor 4"})
    true = np.zeros(len(problem.unknowns))
    start, state = problem.impact.start, problem.scenario.start_state()
    force = next(one for one in problem.readings if one.name == "accelerometer")
    # The window begins at a sample of the log: the true state there is known on a slider.
    way = state.position.x + state.velocity.x * _begin(recording, force) - start.position[0]
    for name, value in (
        ("start position", way), ("start velocity", state.velocity.x - start.velocity[0]),
    ):  # fmt: skip
        true[problem.place[name]] = problem.unknowns[problem.place[name]].coordinate(value)
    told = problem.predictions(true)["accelerometer"]
    step = 2.0 * 16.0 * 9.80665 / 2**16
    settled = force.times > 0.01  # before, the filter's memory is that of the start
    assert np.abs(told - force.values)[settled].max() < 0.51 * step + 1e-3
    peak = np.abs(force.values[:, 0]).max()
    assert (peak > 156.0) == (speed == 4.0)


def _begin(recording, force) -> float:
    """Instant of the log at which a window begins."""
    channel = next(one for one in recording.channels if one.name == "accelerometer")
    place = len(channel.times) - len(force.times)
    found = [
        k for k in range(place + 1)
        if np.array_equal(channel.values[k : k + len(force.values)], force.values)
    ]  # fmt: skip
    return float(channel.times[found[-1]])


def test_a_step_comes_through_range_low_pass_and_average_as_formulas_have_it() -> None:
    true = np.where(np.arange(200)[None, :, None] < 100, 0.0, 10.0) * np.ones((1, 1, 3))
    none = np.zeros((1, 3))
    times = GRID[1:]
    clipped = channel_output(true, none, ChannelChain(6.0, None, None), GRID, times)[0]
    assert clipped.max() == 6.0
    low = channel_output(true, none, ChannelChain(None, 50.0, None), GRID, times)[0, :, 0]
    since = np.maximum(np.arange(1, 201) - 100, 0) * 1e-3
    np.testing.assert_allclose(low, 10.0 * -np.expm1(-2.0 * np.pi * 50.0 * since), atol=1e-9)
    mean = channel_output(true, none, ChannelChain(None, None, 0.005), GRID, times)[0, :, 0]
    np.testing.assert_allclose(mean[100:106], [2.0, 4.0, 6.0, 8.0, 10.0, 10.0], atol=1e-9)
    bias = channel_output(true, none + 1.0, ChannelChain(6.0, None, None), GRID, times)[0]
    assert bias.min() == 1.0
    assert bias.max() == 6.0  # the range is behind the bias


def test_the_grid_has_the_samples_and_fine_steps() -> None:
    grid = fine_grid(np.array([0.005, 0.0101, 0.0102]), 0.02)
    assert {0.0, 0.005, 0.0101, 0.0102, 0.02} <= set(grid)
    assert np.diff(grid).max() <= 1e-3 + 1e-12
    assert np.diff(grid).min() > 0.0


def test_smoothing_shifts_nothing_and_halves_at_its_corner() -> None:
    """A second-order Butterworth filter forth and back has gain 1/2 at its corner."""
    t = np.arange(2000) / 200.0
    wave = np.sin(2.0 * np.pi * 12.0 * t)[None, :, None]
    found = smooth(wave, 200.0, 12.0)[0, 500:1500, 0]
    np.testing.assert_allclose(found, 0.5 * wave[0, 500:1500, 0], atol=2e-3)
