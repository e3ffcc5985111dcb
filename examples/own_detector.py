"""A user-defined detector: a jolt of the accelerometer is a collision, against its direction.

It runs within the pilot, compiled: settings and memory are NamedTuples of floats and vectors; no
arrays, integers, or exceptions.

springback check own_detector.py:jolt
springback trust .
springback fly own_detector.toml --out own_detector
"""

from typing import NamedTuple

import springback
from springback import CompiledDetector, DetectorStep, Vec, detector_step, kernel, rotation


class Jolt(NamedTuple):
    """Settings."""

    threshold: float  # horizontal specific force [m/s²]
    pause: float  # after a collision without another [s]


class Memory(NamedTuple):
    """State of the detector between ticks."""

    last: float  # time of the last collision [s]


@detector_step.register(Jolt)
@kernel
def _(detector: Jolt, time: float, inputs: springback.CollisionInputs, memory: Memory):
    """Alarm, direction of the obstacle, and the new memory, at every tick.

    Inputs are the measurement, the estimate (`inputs.estimate.velocity`, say), the external force
    (`inputs.wrench.force` [N]) and the pilot's model of the airframe.
    """
    axes = rotation(inputs.estimate.attitude)
    force = axes @ inputs.measurement.inertial.specific_force  # in world axes [m/s²]
    level = Vec(force.x, force.y, 0.0)
    rested = time - memory.last > detector.pause
    if rested and level @ level > detector.threshold * detector.threshold:
        return DetectorStep(1.0, -level, Memory(time))
    return DetectorStep(0.0, Vec(0.0, 0.0, 0.0), memory)  # zero: springback finds the direction


def jolt(
    context: springback.PilotContext, threshold: float = 20.0, pause: float = 1.0
) -> CompiledDetector:
    """The detector for a vehicle, which context knows, and the parameters of a scenario."""
    return CompiledDetector(Jolt(threshold, pause), Memory(-pause))


def main() -> springback.Flight:
    scenario = {
        "name": "own detector",
        "vehicle": "quad",
        "reference": {"type": "run-up", "speed": "2 m/s"},
        "recovery": {"detection": {"own": {"code": f"{__file__}:jolt"}}},
        "world": {"obstacles": [{"type": "wall", "distance": "2.75 m", "surface": "wall"}]},
        "simulation": {"duration": 8.0},
    }
    return springback.fly(scenario)


if __name__ == "__main__":
    print(main())
