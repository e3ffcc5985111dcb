"""McGill's stages: each asks for what it should, and is over when its bounds hold."""

import math

import numpy as np
import pytest

from springback.control.parameters import ControlSettings
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, Vec, rotation
from springback.recovery.characterisation import Collision
from springback.recovery.parameters import ResponseSettings
from springback.recovery.stages import DAMPING, LEVELLING, OVER, TILTING, Stage, stage_command
from springback.sensing.measurement import Estimate

STILL, NORTH = Vec(0.0, 0.0, 0.0), Vec(1.0, 0.0, 0.0)
HIT = Collision(
    STILL, NORTH, NORTH, STILL, STILL, STILL, STILL, STILL, (1.0, 1.0, 0.0, 0.0), 50.0
)  # fmt: skip
LAW = ControlSettings().position_law(1.4, 9.81)
RESPONSE = ResponseSettings(way="staged").response()
AWAY = -math.atan(0.75)  # pitch of the first stage: nose up, away from a wall in the north


def at(pitch: float, climb: float = 0.0, rate: float = 0.0) -> Estimate:
    attitude = Quat(*attitude_from_euler(0.0, pitch, 0.0))
    return Estimate(STILL, attitude, Vec(0.0, 0.0, climb), Vec(0.0, rate, 0.0))


def asked(stage: float, here: Estimate) -> tuple[Stage, float]:
    """The stage, and the pitch that it asks for."""
    now = stage_command(RESPONSE, LAW, HIT, here, 0.0, stage)  # type: ignore[arg-type]
    r = rotation(now.word.attitude)
    return now, math.atan2(r.x.z, r.z.z)


def test_the_first_stage_leans_away_from_the_wall() -> None:
    now, pitch = asked(TILTING, at(0.3))
    assert now.stage == TILTING
    assert pitch == pytest.approx(AWAY)


def test_thrust_is_what_the_axis_can_give_and_never_negative() -> None:
    """m max(0, a_des · b): full size along a_des, none beyond a right angle."""
    along, _ = asked(TILTING, at(AWAY, rate=5.0))
    assert along.word.thrust == pytest.approx(1.4 * 9.81 * math.hypot(1.0, 0.75))
    beyond, _ = asked(TILTING, at(AWAY + math.radians(100.0)))
    assert beyond.word.thrust == 0.0


@pytest.mark.parametrize(
    ("stage", "here", "then"),
    [
        (TILTING, at(AWAY), LEVELLING),
        (TILTING, at(AWAY, rate=2.5), TILTING),
        (TILTING, at(AWAY + 0.16), TILTING),
        (LEVELLING, at(0.19, climb=-2.0), DAMPING),
        (LEVELLING, at(0.21), LEVELLING),
        (DAMPING, at(0.3, climb=-0.6), DAMPING),
        (DAMPING, at(0.3, climb=-0.4), OVER),
        (LEVELLING, at(0.1, climb=0.1), OVER),
    ],
)
def test_a_stage_is_over_when_its_bounds_hold(stage: float, here: Estimate, then: float) -> None:
    assert asked(stage, here)[0].stage == then


def test_only_the_third_stage_damps_the_climb() -> None:
    falling = asked(DAMPING, at(0.0, climb=-1.0))[0].word.thrust
    assert falling == pytest.approx(1.4 * (9.81 + 5.0))
    levelling, pitch = asked(LEVELLING, at(0.5, climb=-1.0))
    assert pitch == pytest.approx(0.0, abs=1e-12)
    assert levelling.word.thrust == pytest.approx(1.4 * 9.81 * math.cos(0.5))


def test_turned_about_the_vertical_it_leans_the_same_way() -> None:
    """The direction is the wall's; the yaw is kept beside it."""
    for yaw in np.linspace(-2.0, 2.0, 5):
        now = stage_command(RESPONSE, LAW, HIT, at(0.3), float(yaw), TILTING)  # type: ignore[arg-type]
        r = rotation(now.word.attitude)
        assert (r.x.z, r.y.z) == pytest.approx((-0.6, 0.0))
        left = (r.x.y, r.y.y)  # b_2 is normal to the heading
        assert left[0] * math.cos(yaw) + left[1] * math.sin(yaw) == pytest.approx(0.0, abs=1e-12)
