"""A user-defined pilot that is compiled: it hovers with motion capture and a gyroscope.

Settings and memory are NamedTuples of floats and vectors; no arrays, integers, or exceptions.

springback check own_pilot_compiled.py:hover
springback fly own_pilot.toml --out own_pilot
"""

import math
from typing import NamedTuple

import springback
from springback import CompiledPilot, Measurement, PilotOutput, Vec, kernel, pilot_step, rotation

VEHICLE = springback.QUAD.vehicle
ARM = VEHICLE.airframe().arms[0]
ZERO = Vec(0.0, 0.0, 0.0)


class Hover(NamedTuple):
    """Settings."""

    place: Vec  # where to hover [m]
    mass: float  # [kg]
    inertia: Vec  # about the body axes [kg m²]
    lever: float  # of each rotor about body x and y [m]
    torque_ratio: float  # torque about body z per thrust [m]
    most: float  # thrust of a rotor [N]


class Memory(NamedTuple):
    """State of the pilot between ticks."""

    begun: float  # 0 before the first tick
    seen: float  # time of the last pose [s]
    position: Vec  # there and then [m]
    velocity: Vec  # smoothed [m/s]


@kernel
def moved(time: float, measurement: Measurement, memory: Memory) -> Memory:
    pose = measurement.pose
    if memory.begun == 0.0:
        return Memory(1.0, time, pose.position, Vec(0.0, 0.0, 0.0))
    if pose.fresh > 0.0 and time > memory.seen:
        raw = (pose.position - memory.position) * (1.0 / (time - memory.seen))
        velocity = memory.velocity + 0.2 * (raw - memory.velocity)
        return Memory(1.0, time, pose.position, velocity)
    return memory


@kernel
def clipped(thrust: float, most: float) -> float:
    return min(max(thrust, 0.0), most)


@pilot_step.register(Hover)
@kernel
def _(pilot: Hover, time: float, measurement: Measurement, memory: Memory) -> PilotOutput:
    """Thrust of each rotor [N], and the new memory, at every tick."""
    p, after, pose = pilot, moved(time, measurement, memory), measurement.pose
    force = p.mass * (-5.0 * (pose.position - p.place) - 3.5 * after.velocity)
    force = force + Vec(0.0, 0.0, p.mass * 9.81)
    axes = rotation(pose.attitude)
    wanted = (force @ axes) * (1.0 / math.sqrt(force @ force))
    yaw = math.atan2(axes.y.x, axes.x.x)
    turn = 25.0 * (
        6.5 * Vec(-wanted.y, wanted.x, -0.4 * yaw) - measurement.inertial.angular_velocity
    )

    # Each rotor takes a quarter of each: front left, front right, rear right, rear left.
    thrust = 0.25 * (force @ Vec(axes.x.z, axes.y.z, axes.z.z))
    roll = 0.25 * p.inertia.x * turn.x / p.lever
    pitch = 0.25 * p.inertia.y * turn.y / p.lever
    yawing = 0.25 * p.inertia.z * turn.z / p.torque_ratio
    thrusts = (
        clipped(thrust + roll - pitch + yawing, p.most),
        clipped(thrust - roll - pitch - yawing, p.most),
        clipped(thrust - roll + pitch + yawing, p.most),
        clipped(thrust + roll + pitch - yawing, p.most),
    )
    return PilotOutput(thrusts, after)


SETTINGS = Hover(
    place=Vec(0.0, 0.0, 1.0),
    mass=VEHICLE.mass,
    inertia=Vec(*(float(moment) for moment in VEHICLE.inertia().diagonal())),
    lever=ARM.length * ARM.sine,
    torque_ratio=ARM.torque_ratio,
    most=VEHICLE.propulsion.max_thrust,
)
hover = CompiledPilot(SETTINGS, Memory(0.0, 0.0, ZERO, ZERO))


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
