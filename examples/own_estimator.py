"""A user-defined estimator: it integrates the inertial unit and leans on motion capture.

It runs within the pilot, compiled: settings and memory are NamedTuples of floats and vectors; no
arrays, integers, or exceptions.

springback check own_estimator.py:blend
springback trust .
springback fly own_estimator.toml --out own_estimator
"""

from typing import NamedTuple

import springback
from springback import (
    CompiledEstimator,
    Estimate,
    EstimatorStep,
    Measurement,
    Vec,
    estimator_step,
    kernel,
    rotation,
)
from springback.kernels.vectors import (
    conjugate,
    exponential_map,
    normalise,
    quaternion_product,
)


class Blend(NamedTuple):
    """Settings."""

    period: float  # of the clock [s]
    gravity: float  # g along −Z [m/s²]
    place: float  # share of a position error that a pose corrects
    speed: float  # correction of the velocity per position error [1/s]
    turn: float  # share of an attitude error that a pose corrects


@kernel
def moved(e: Blend, measurement: Measurement, at: Estimate) -> Estimate:
    """The estimate one tick later."""
    omega = measurement.inertial.angular_velocity
    force = rotation(at.attitude) @ measurement.inertial.specific_force
    acceleration = force - Vec(0.0, 0.0, e.gravity)
    attitude = normalise(quaternion_product(at.attitude, exponential_map(e.period * omega)))
    position = at.position + e.period * at.velocity
    return Estimate(position, attitude, at.velocity + e.period * acceleration, omega)


@estimator_step.register(Blend)
@kernel
def _(estimator: Blend, tick: float, measurement: Measurement, memory: Estimate):
    """Estimate and new memory at every tick; here they are the same."""
    e, now, pose = estimator, moved(estimator, measurement, memory), measurement.pose
    if pose.fresh < 0.5:
        return EstimatorStep(now, now)
    # The pose is some ms old: it is compared with where the vehicle was then.
    then = quaternion_product(now.attitude, exponential_map(-pose.age * now.angular_velocity))
    missed = pose.position - (now.position - pose.age * now.velocity)
    error = quaternion_product(conjugate(then), pose.attitude)
    twice = -2.0 if error.w < 0.0 else 2.0
    turned = exponential_map(e.turn * twice * Vec(error.x, error.y, error.z))
    corrected = Estimate(
        now.position + e.place * missed,
        normalise(quaternion_product(now.attitude, turned)),
        now.velocity + e.speed * missed,
        now.angular_velocity,
    )
    return EstimatorStep(corrected, corrected)


def blend(
    context: springback.PilotContext, place: float = 0.2, speed: float = 4.0, turn: float = 0.1
) -> CompiledEstimator:
    """The estimator for a vehicle, which context knows, and the parameters of a scenario."""
    s = context.start
    start = Estimate(s.position, s.attitude, s.velocity, s.angular_velocity)
    return CompiledEstimator(Blend(context.period, context.gravity, place, speed, turn), start)


def main() -> springback.Flight:
    scenario = {
        "name": "own estimator",
        "vehicle": "quad",
        "reference": {"type": "hold"},
        "estimator": {"type": "own", "code": f"{__file__}:blend"},
        "start": {"position": [0.0, 0.0, 1.0], "roll": "10 deg"},
        "simulation": {"duration": 3.0},
    }
    return springback.fly(scenario)


if __name__ == "__main__":
    flight = main()
    print(flight)
    print("at the end:", *(f"{flight.columns[axis][-1]:.3f} m" for axis in "xyz"))
