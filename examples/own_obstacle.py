"""ARQ flies into a vertical pole: a user-defined obstacle in thirty lines."""

import math
from typing import NamedTuple

import springback
from springback import Vec, kernel, outward_normal, signed_distance


class Pole(NamedTuple):
    """A vertical cylinder."""

    x: float
    y: float
    radius: float


@signed_distance.register(Pole)
@kernel
def _(pole: Pole, point: Vec) -> float:
    dx, dy = point.x - pole.x, point.y - pole.y
    return math.sqrt(dx * dx + dy * dy) - pole.radius


@outward_normal.register(Pole)
@kernel
def _(pole: Pole, point: Vec) -> Vec:
    dx, dy = point.x - pole.x, point.y - pole.y
    inverse = 1.0 / math.sqrt(dx * dx + dy * dy)
    return Vec(dx * inverse, dy * inverse, 0.0)


def main() -> springback.Flight:
    scenario = {
        "vehicle": "arq",
        "thrust": "hover",
        "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": "45 deg"},
    }
    return springback.fly(scenario, own=[(Pole(2.75, 0.0, 0.05), springback.WALL)])


if __name__ == "__main__":
    print(main())
