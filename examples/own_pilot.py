"""A user-defined pilot in plain Python: it hovers with motion capture and a gyroscope.

springback check own_pilot.py:hover
springback fly own_pilot.toml --out own_pilot
"""

import math
from typing import NamedTuple

import numpy as np

import springback
from springback import Measurement

VEHICLE = springback.QUAD.vehicle
GRAVITY, MASS, INERTIA = 9.81, VEHICLE.mass, VEHICLE.inertia()
PLACE = np.array([0.0, 0.0, 1.0])  # where to hover [m]
STIFFNESS, DAMPING = 5.0, 3.5  # of position [1/s², 1/s]
LEANING, TURNING = 6.5, 25.0  # of attitude and of rates [1/s]
SMOOTHING = 0.2  # weight of a new velocity

#: Thrust, roll, pitch and yaw moment for one newton of each rotor.
EFFECTS = np.array([
    [1.0, arm.sine * arm.length, -arm.cosine * arm.length, arm.torque_ratio]
    for arm in VEHICLE.airframe().arms
]).T  # fmt: skip


class Memory(NamedTuple):
    """State of the pilot between ticks."""

    seen: float  # time of the last pose [s]
    position: np.ndarray  # there and then [m]
    velocity: np.ndarray  # smoothed [m/s]


def hover(time: float, measurement: Measurement, memory: Memory | None):
    """Thrust of each rotor [N], and the new memory; memory is None at first.

    It is called at every tick, 1000 times a second.  Measurements are delayed and noisy: a pose
    with position [m] and attitude (quaternion wxyz, body to world), and an inertial unit with
    angular velocity [rad/s] and specific force [m/s²] in body axes.  ``fresh`` says if one is new.
    Everything to be remembered goes into the memory, which is returned anew and never changed.
    """
    pose, position = measurement.pose, np.array(measurement.pose.position)
    if memory is None:
        memory = Memory(time, position, np.zeros(3))
    if pose.fresh and time > memory.seen:
        raw = (position - memory.position) / (time - memory.seen)
        velocity = memory.velocity + SMOOTHING * (raw - memory.velocity)
        memory = Memory(time, position, velocity)

    force = MASS * (-STIFFNESS * (position - PLACE) - DAMPING * memory.velocity)
    force = force + np.array([0.0, 0.0, MASS * GRAVITY])
    axes = np.array(springback.rotation(pose.attitude))  # columns are the body axes in the world
    wanted = axes.T @ force / np.linalg.norm(force)  # thrust direction, seen from the body
    yaw = math.atan2(axes[1, 0], axes[0, 0])
    rates = LEANING * np.array([-wanted[1], wanted[0], -0.4 * yaw])
    gyroscope = np.array(measurement.inertial.angular_velocity)
    moment = INERTIA @ (TURNING * (rates - gyroscope))

    thrusts = np.linalg.solve(EFFECTS, [force @ axes[:, 2], *moment])
    return np.clip(thrusts, 0.0, VEHICLE.propulsion.max_thrust), memory


def main() -> springback.Flight:
    scenario = {
        "name": "own pilot",
        "vehicle": "quad",
        "start": {"position": [0.3, 0.0, 1.0], "roll": "10 deg"},
        "simulation": {"duration": 3.0},
    }
    return springback.fly(scenario, pilot=hover)


if __name__ == "__main__":
    flight = main()
    print(flight)
    print("at the end:", *(f"{flight.columns[axis][-1]:.3f} m" for axis in "xyz"))
