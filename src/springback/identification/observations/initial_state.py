"""State of a vehicle before touch, as its log tells it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.drop_start import Fall
from springback.logs.frame_turns import conjugate, product, rotation_vector, vector_quaternion
from springback.logs.recording import ANGULAR_VELOCITY, ATTITUDE, POSITION, Array
from springback.scenario.model import way_to_touch
from springback.scenario.scenario import Scenario

#: Fewest samples of a track before touch, and distance from touch [s] (chosen).
FEWEST, CLEAR = 5, 5e-3


class InitialState(NamedTuple):
    """State at the start of the window."""

    position: Array  # world [m]
    velocity: Array  # world [m/s]
    attitude: Array  # body to world, w, x, y, z
    angular_velocity: Array  # body [rad/s]
    tracked: bool  # a track tells the position, else the scenario
    fallen: float = 0.0  # speed at touch of a drop from a known height, without a track [m/s]

    def displace(self, shift: Any) -> InitialState:
        """The guess with latents' changes, shape (..., 12): position, velocity, turn, rate."""
        turn = vector_quaternion(np.asarray(shift[..., 6:9]))
        attitude = product(self.attitude, turn)
        attitude /= np.linalg.norm(attitude, axis=-1, keepdims=True)
        return InitialState(
            self.position + shift[..., :3], self.velocity + shift[..., 3:6], attitude,
            self.angular_velocity + shift[..., 9:12], self.tracked, self.fallen,
        )  # fmt: skip


def initial_state(
    scenario: Scenario, readings: Sequence[ChannelWindow], touch: float, fall: Fall | None = None
) -> InitialState:
    """State at the start of the window, from the tracks before touch, else from the scenario.

    Args:
        scenario: Of the flight.
        readings: Of the impact.
        touch: In its window [s].
        fall: From the scenario's start, in a drop test.
    """
    found = {one.quantity: one for one in readings}
    state = scenario.start_state()
    attitude, omega = np.array(state.attitude), np.array(state.angular_velocity)
    position, velocity = np.array(state.position), np.array(state.velocity)
    tracked = _line(found.get(POSITION), touch)
    turned = _turn(found.get(ATTITUDE), touch)
    if scenario.model.slider is None:
        if turned is not None:
            attitude, omega = turned
        if (gyro := found.get(ANGULAR_VELOCITY)) is not None:
            early = gyro.values[gyro.times < max(0.2 * touch, 0.01)]
            if len(early) and not np.isnan(early).all():
                omega = np.nanmean(early, axis=0)
    if tracked is not None:
        position, velocity = tracked
    elif fall is not None:
        position, velocity = fall.before_touch(touch)
    elif (speed := float(np.linalg.norm(velocity))) > 0.0:
        way = float(way_to_touch(scenario.flight_model(), state))
        position = position + (way - speed * touch) * velocity / speed
    axis = scenario.model.slider
    if axis is not None:
        unit, home = np.array(axis) / np.linalg.norm(axis), np.array(state.position)
        position = home + ((position - home) @ unit) * unit
        velocity = (velocity @ unit) * unit
    fallen = 0.0 if fall is None or tracked is not None else fall.speed
    return InitialState(position, velocity, attitude, omega, tracked is not None, fallen)


def _line(track: ChannelWindow | None, touch: float) -> tuple[Array, Array] | None:
    """Position and velocity at the start of the window, by a parabola through a track."""
    if track is None:
        return None
    known = (track.times < touch - CLEAR) & ~np.isnan(track.values).any(axis=1)
    if known.sum() < FEWEST:
        return None
    t, values = track.times[known], track.values[known]
    fit = np.polynomial.polynomial.polyfit(t, values, 2 if known.sum() > 2 * FEWEST else 1)
    return fit[0], fit[1]


def _turn(track: ChannelWindow | None, touch: float) -> tuple[Array, Array] | None:
    """Attitude at the start of the window and the rate of turn, body axes."""
    if track is None:
        return None
    known = (track.times < touch - CLEAR) & ~np.isnan(track.values).any(axis=1)
    if known.sum() < FEWEST:
        return None
    t, q = track.times[known], track.values[known]
    vectors = rotation_vector(product(conjugate(q[0]), q))
    begin, rate = np.polynomial.polynomial.polyfit(t, vectors, 1)
    return product(q[0], vector_quaternion(begin)), rate
