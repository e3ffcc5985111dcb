"""Two vehicles that strike each other beside MuJoCo, with the contact applied by formula.

MuJoCo integrates both vehicles with their sliding arms; rings, discs and the law of their contact are
written down once more in `oracles.mujoco_pair`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from oracles import models
from springback.batch.pair import fly_pair
from springback.contact.parameters import SurfaceSettings
from springback.results.flight import Flight
from springback.scenario.scenario import scenario_from

pytest.importorskip("mujoco")
from oracles import mujoco_pair  # only where the engine is

STEP, DURATION = 1e-4, 0.015
#: A hundredth of the promise, 0.1 mm [m], and what that turns an arm of 0.3 m by [rad].
POSITION, ATTITUDE = 1e-6, 1e-5
#: The promise, of the peak: both read it at steps that do not coincide.
PEAK = 1e-3

SURFACE = SurfaceSettings(
    law="hunt-crossley", stiffness=7e4, dissipation=0.3, friction=0.5, slip_speed=0.1
)
THRUST = ([5.0, 6.0, 4.5, 5.5], [4.0, 3.5, 5.0, 4.5])

#: Starts of both, some millimetres before the touch; the second comes.  No ring gets as deep into a
#: disc as to its middle, where the nearest side changes and the force with it.
MEETINGS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "head-on": (
        {"position": [0.0, 0.0, 0.0], "velocity": [0.9, 0.0, 0.0]},
        {"position": [0.491, 0.0, 0.004], "velocity": [-0.6, 0.0, 0.0], "yaw": np.pi, "pitch": 0.05},
    ),
    "glancing": (
        {"position": [0.0, 0.0, 0.0], "velocity": [1.5, 0.0, 0.0], "roll": 0.1,
         "angular_velocity": [0.5, -1.0, 2.0]},
        {"position": [0.5285, 0.2477, 0.01], "velocity": [-1.0, -0.2, 0.0], "yaw": 2.6, "pitch": -0.1},
    ),
    "from above": (
        {"position": [0.0, 0.0, 0.0], "velocity": [0.5, 0.0, 0.3], "pitch": 0.1},
        {"position": [0.4, 0.03, 0.0395], "velocity": [-0.7, 0.0, -1.0], "yaw": 3.0, "pitch": 0.15},
    ),
    "cage on main body": (
        {"position": [0.0, 0.0, 0.0], "velocity": [0.9, 0.1, 0.0], "yaw": 0.8},
        {"position": [0.37, 0.01, 0.005], "velocity": [-0.6, 0.0, 0.2], "pitch": 1.5, "roll": 0.1},
    ),
    "main body on cage": (
        {"position": [0.0, 0.0, 0.0], "velocity": [0.9, 0.1, 0.0], "pitch": 1.5, "roll": 0.1},
        {"position": [0.37, 0.01, 0.005], "velocity": [-0.6, 0.0, 0.2], "yaw": 2.3},
    ),
}  # fmt: skip
CASES = (
    ("head-on", "arq", "arq"),
    ("head-on", "quad", "quad"),
    ("glancing", "arq", "quad"),
    ("glancing", "quad", "arq"),
    ("from above", "arq", "quad"),
    ("cage on main body", "arq", "arq"),
    ("main body on cage", "arq", "arq"),
)


def tables(vehicle: str, start: dict[str, Any], thrust: list[float]) -> dict[str, Any]:
    """A vehicle without a pilot; arms may always slide, and steps are short."""
    return {
        "vehicle": vehicle,
        "thrust": thrust,
        "start": start,
        "model": {"arms": "always-free"},
        "simulation": {"duration": DURATION, "impact_step": STEP, "free_step": STEP},
    }


def plain(given: dict[str, Any]) -> tuple[models.Scene, models.Start]:
    """Vehicle and start in plain numbers."""
    scenario = scenario_from(given)
    craft = models.craft_of(scenario.true_airframe())
    nowhere = models.Wall(np.array([0.6, 0.0, 0.8]), -1e3)
    scene = models.Scene(craft, nowhere, tuple(given["thrust"]))
    return scene, models.start_of(scenario.start_state())


def agree(ours: Flight, theirs: Any) -> tuple[float, float, float, float]:
    """Errors of position, attitude and arms at the end, and of the peak."""
    c, end = ours.columns, theirs.end

    def last(*names: str) -> Any:
        return np.array([c[name][-1] for name in names])

    position = np.abs(last("x", "y", "z") - end.position).max()
    now = models.Start(end.position, last("qw", "qx", "qy", "qz"), *(np.zeros(3),) * 4)
    attitude = np.abs(now.rotation - end.rotation).max()
    arms = np.abs(last("l1", "l2", "l3", "l4") - end.lengths).max()
    peak = abs((ours.measures["peak_acceleration"] or 0.0) / theirs.peak_acceleration - 1.0)
    return float(position), float(attitude), float(arms), float(peak)


@pytest.mark.parametrize(("name", "first", "second"), CASES)
def test_both_fly_as_in_the_engine(name: str, first: str, second: str) -> None:
    """From before the touch until after it: places, attitudes, arms and peaks of both."""
    given = [
        tables(vehicle, start, thrust)
        for vehicle, start, thrust in zip((first, second), MEETINGS[name], THRUST, strict=True)
    ]
    ours = fly_pair(given[0], given[1], surface=SURFACE)
    (scene, start), (other, its_start) = plain(given[0]), plain(given[1])
    theirs = mujoco_pair.fly_both(
        (scene, other), (start, its_start), SURFACE, until=DURATION, step=STEP
    )
    assert (ours.first.measures["touch_time"] or 0.0) > 0.0  # the start is not in the contact
    for flight, oracle in nonempty(zip(ours, theirs, strict=True)):
        assert (flight.measures["peak_acceleration"] or 0.0) > 20.0
        position, attitude, arms, peak = agree(flight, oracle)
        assert position < POSITION
        assert attitude < ATTITUDE
        assert arms < POSITION
        assert peak < PEAK
