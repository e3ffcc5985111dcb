"""Start of a drop test: from rest at a known height, by free fall until touch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.logs.recording import Array
from springback.scenario.model import way_to_touch
from springback.scenario.scenario import Scenario


class Fall(NamedTuple):
    """Free fall of a scenario from its start to its first touch."""

    position: Array  # at the start, world [m]
    velocity: Array  # there [m/s]
    acceleration: Array  # [m/s²]
    height: float  # from the start to touch, along the fall [m]
    duration: float  # [s]

    @property
    def speed(self) -> float:
        """Speed at touch along the fall [m/s]."""
        down = self.acceleration / np.linalg.norm(self.acceleration)
        return float((self.velocity + self.duration * self.acceleration) @ down)

    def before_touch(self, time: float) -> tuple[Array, Array]:
        """Position and velocity so long before touch [s]."""
        t = self.duration - time
        place = self.position + t * self.velocity + 0.5 * t * t * self.acceleration
        return place, self.velocity + t * self.acceleration


def is_drop(scenario: Scenario) -> bool:
    """True if a scenario's vehicle falls from its start: rotors off, nothing sideways."""
    if not isinstance(scenario.thrust, int | float) or scenario.thrust != 0.0:
        return False
    along_x, along_y, along_z = scenario.model.slider or scenario.start.velocity
    return along_x == along_y == 0.0 and (scenario.model.slider is None or along_z != 0.0)


def fall_of(scenario: Scenario) -> Fall:
    """Fall from the start of a scenario, down along its slider if it has one.

    Args:
        scenario: With rotors off.

    Raises:
        InputError: If its rotors turn, or it falls onto nothing.
    """
    if not isinstance(scenario.thrust, int | float) or scenario.thrust != 0.0:
        raise InputError(
            "thrust: must be 0 in the scenario of a drop test without a track, whose start falls "
            f"freely (got {str(scenario.thrust)[:40]})"
        )
    down = np.array([0.0, 0.0, -1.0])
    if scenario.model.slider is not None:
        axis = np.array(scenario.model.slider) / np.linalg.norm(scenario.model.slider)
        down = -np.sign(axis[2]) * axis
    if not (down.any() and scenario.world.gravity > 0.0):
        what = "model.slider: is level" if not down.any() else "world.gravity: is 0"
        raise InputError(f"{what}, so nothing drops")
    state = scenario.start_state()
    pull = scenario.world.gravity * float(-down[2])
    if scenario.model.slider is not None:
        pull -= scenario.model.slider_friction / scenario.vehicle.mass
        if not pull > 0.0:
            raise InputError(
                "model.slider_friction: holds the vehicle on the slider, so nothing drops (got "
                f"{scenario.model.slider_friction:g} N)"
            )
    try:
        way = float(
            way_to_touch(scenario.flight_model(), state._replace(velocity=Vec(*down.tolist())))
        )
    except PydanticCustomError:
        raise InputError(
            "start.position: straight down from it the vehicle meets no obstacle of the scenario: "
            "a drop needs a ground below"
        ) from None
    velocity = np.array(state.velocity)
    rate = float(velocity @ down)
    duration = (np.sqrt(rate * rate + 2.0 * pull * way) - rate) / pull
    return Fall(np.array(state.position), velocity, pull * down, way, float(duration))
