"""ARQ flies into a vertical pole: a user-defined obstacle.

springback check own_obstacle.py:POLE
springback fly own_obstacle.toml --out own_obstacle
python own_obstacle.py
"""

import math
from typing import NamedTuple

import springback
from springback import Vec, kernel, outward_normal, signed_distance


class Pole(NamedTuple):
    """A vertical cylinder: floats and vectors only, so that it can be compiled."""

    x: float  # of its axis, world [m]
    y: float  # [m]
    radius: float  # [m]


@signed_distance.register(Pole)
@kernel
def _(pole: Pole, point: Vec) -> float:
    """Distance of a point [m], negative inside; far away it may be less than the true one."""
    dx, dy = point.x - pole.x, point.y - pole.y
    return math.sqrt(dx * dx + dy * dy) - pole.radius


@outward_normal.register(Pole)
@kernel
def _(pole: Pole, point: Vec) -> Vec:
    """Unit vector out of the pole, world axes: the gradient of the distance."""
    dx, dy = point.x - pole.x, point.y - pole.y
    inverse = 1.0 / math.sqrt(dx * dx + dy * dy)
    return Vec(dx * inverse, dy * inverse, 0.0)


POLE = Pole(x=2.75, y=0.0, radius=0.05)


def main() -> springback.Flight:
    scenario = {
        "vehicle": "arq",
        "thrust": "hover",
        "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": "45 deg"},
    }
    return springback.fly(scenario, own=[(POLE, springback.WALL)])


if __name__ == "__main__":
    print(main())
