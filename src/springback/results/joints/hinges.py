"""Angles of hinged arms, and the torques about their hinges, along a recorded flight.

Of each hinge the trajectory has the arc: an angle is that over the radius of the path, and a torque
is what spring, damper, latch and end stops do along the path, times that radius.  The forces are
evaluated again, by the laws of the flight, at the recorded states.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.limbs.arms import spring_damper_force
from springback.dynamics.stops import end_stop
from springback.kernels.compiler import executor, kernel
from springback.kernels.layout import Buffer, TreeLayout, read
from springback.kernels.trees import leaves
from springback.results.result import FlightResult
from springback.vehicle.arms.bent import ON_JOINTS
from springback.vehicle.arms.joints import STRAIGHT
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]


class HingeHistory(NamedTuple):
    """A hinge of an arm over time, at the instants of the trajectory."""

    arm: int  # its number, from 1
    joint: int  # 1 for that on the main body, 2 for that which the first one carries
    angle: Array  # from where the arm is free, positive as it is pressed in [rad]
    torque: Array  # of spring, damper, latch and end stops, positive against that [N m]


class _HingeInstant(NamedTuple):
    """A joint at one instant."""

    arm: Any  # constants of the arm, or of its second joint
    length: float  # along its path [m]
    rate: float  # [m/s]


@kernel
def _force(at: _HingeInstant) -> float:
    stop = end_stop(at.arm, at.length, at.rate)
    return float(spring_damper_force(at.arm, at.length, at.rate) + stop.force)


@executor(nogil=True)
def _all_forces(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write the force along the path at each instant; the rows of the buffer hold the leaves."""
    for i in range(instants.shape[0]):
        out[i, 0] = _force(read(like, instants[i], 0, 1, 0))


def hinge_histories(flight: FlightResult) -> tuple[HingeHistory, ...]:
    """Hinges of the arms that can turn, arm by arm, those on the main body first.

    Args:
        flight: With its trajectory.

    Returns:
        None of arms that slide, or are locked.
    """
    columns, model = flight.columns, flight.scenario.flight_model(flight.own)
    found = []
    for number, arm in enumerate(model.airframe.arms, start=1):
        if not isinstance(arm, ON_JOINTS) or not arm.compliance > 0.0:
            continue
        joints: list[tuple[int, Any, str, str]] = [(1, arm, f"l{number}", f"dl{number}")]
        if hasattr(arm, "second"):
            joints.append((2, arm.second, f"bend{number}", f"dbend{number}"))
        for which, joint, way, rate in joints:
            curvature = joint.joint.curvature
            if curvature > STRAIGHT:
                angle = curvature * (joint.length - columns[way])
                torque = _forces(joint, columns[way], columns[rate]) / curvature
                found.append(HingeHistory(number, which, angle, torque))
    return tuple(sorted(found, key=lambda one: one.joint))


def has_hinges(vehicle: Vehicle) -> bool:
    """True for a vehicle with an arm that can turn about a hinge."""
    return vehicle.is_compliant and any(vehicle.arms.hinges)


def _forces(joint: Any, lengths: Array, rates: Array) -> Array:
    """Force along the path of a joint, positive as it lengthens the arm [N], shape (instants,)."""
    like = _HingeInstant(joint, 0.0, 0.0)
    constants = np.array(leaves(joint))
    rows = np.broadcast_to(constants, (len(lengths), len(constants)))
    instants = np.hstack([rows, np.stack([lengths, rates], axis=1)])
    out = np.zeros((len(lengths), 1))
    _all_forces(TreeLayout(like), np.ascontiguousarray(instants), out)
    return out[:, 0]
