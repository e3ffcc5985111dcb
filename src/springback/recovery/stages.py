"""McGill's staged recovery: tilt away, level out, damp the vertical speed."""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.control.position import PositionLaw, heading
from springback.control.target import AttitudeTarget
from springback.kernels.angles import angle_of
from springback.kernels.compiler import kernel
from springback.kernels.trees import select
from springback.kernels.vectors import Vec, norm, positive_part, quaternion_of, rotation
from springback.recovery.characterisation import Collision
from springback.recovery.response import Staged
from springback.sensing.measurement import Estimate

TILTING, LEVELLING, DAMPING, OVER = 1.0, 2.0, 3.0, 4.0


class Stage(NamedTuple):
    """A stage, and its command to the autopilot."""

    stage: float
    word: AttitudeTarget


@kernel
def _angle(a: Vec, b: Vec) -> float:
    """Angle between two unit vectors [rad]."""
    return angle_of(norm(a ^ b), a @ b)


@kernel
def stage_command(
    response: Staged, law: PositionLaw, hit: Collision, at: Estimate, yaw: float, stage: float
) -> Stage:
    """One period of a stage: a_des = g e_Z − a f_c⁰ − d v_z e_Z, thrust m max(0, a_des·b).

    Tilting uses only a, damping only d, levelling neither.  A stage is over as soon as its bounds
    hold at one period (in the flight code, at two), and the command is that of the next one.

    Args:
        response: Bounds.
        law: Position law, for mass and gravity.
        hit: The collision.
        at: Estimated motion.
        yaw: Yaw to hold [rad].
        stage: `TILTING` at first; `OVER` at the end.
    """
    r = rotation(at.attitude)
    b, up = Vec(r.x.z, r.y.z, r.z.z), Vec(0.0, 0.0, 1.0)
    spin = math.sqrt(at.angular_velocity.x**2 + at.angular_velocity.y**2)
    calm = spin < response.rate
    away = hit.direction * -response.away
    leaning = up * law.gravity + away
    tilted = calm & (_angle(b, leaning * (1.0 / norm(leaning))) < response.tilt)
    level = calm & (_angle(b, up) < response.level)
    still = math.fabs(at.velocity.z) < response.climb

    first = select((stage == TILTING) & tilted, LEVELLING, stage)
    second = select((first == LEVELLING) & level, DAMPING, first)
    now = select((second == DAMPING) & still, OVER, second)

    damped = select(now >= DAMPING, response.damping, 0.0) * at.velocity.z
    wanted = up * (law.gravity - damped) + away * select(now == TILTING, 1.0, 0.0)
    size = norm(wanted)
    axes = heading(wanted * (1.0 / size), yaw).axes
    thrust = law.mass * positive_part(wanted @ b)
    return Stage(now, AttitudeTarget(quaternion_of(axes), Vec(0.0, 0.0, 0.0), thrust))
