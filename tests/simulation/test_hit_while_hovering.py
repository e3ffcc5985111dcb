"""A hovering robot that a swinging ball hits: the example, with its pilot and recovery."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from springback.results.flight import fly
from springback.simulation.measuring.measures import Outcome

EXAMPLE = Path(__file__).parents[2] / "examples" / "swinging_ball.toml"


@pytest.mark.parametrize("yaw", [0, 45])
def test_it_recovers_and_knows_where_the_ball_was(yaw: int) -> None:
    """Along an arm the direction is that to the ball; between two cages, midway between normals."""
    flight = fly(EXAMPLE, f"start.yaw={yaw} deg", f"reference.yaw={yaw} deg", trajectory=False)
    m = flight.measures
    assert flight.outcome is Outcome.RECOVERED
    assert m["impacts"] == m["runs"] == m["recovered_runs"] == 1.0
    assert m["detection_delay"] < 0.015
    if yaw:
        assert m["touch_speed"] == pytest.approx(1.55, abs=0.03)
        assert m["direction_error"] < math.radians(2.0)
        assert m["impact_arm_stroke"] > 5e-3
    else:  # the ball's centre is on the robot's axis, 41 degrees from the normal at either cage
        assert m["direction_error"] == pytest.approx(math.radians(41.0), abs=math.radians(2.0))
    assert abs(m["ledger_residual"]) < 1e-6
    assert m["energy_obstacles"] < -0.9
