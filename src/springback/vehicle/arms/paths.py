"""Paths of the ends of arms at many instants at once, by NumPy.

For pictures and tables: `springback.vehicle.arms.joints.joint_pose` is the same for one instant of
the equations of motion.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.kernels.vectors import Vec
from springback.vehicle.arms.bent import ON_JOINTS, BentArm
from springback.vehicle.arms.joints import STRAIGHT, Joint, JointedArm
from springback.vehicle.state import Arm, arm_direction

Array = np.ndarray[Any, np.dtype[np.float64]]


class ArmPath(NamedTuple):
    """Where the end of an arm is, by its lengths; body axes."""

    end: Array  # from the main body [m], shape (lengths, 3)
    direction: Array  # in which it moves as the arm gets longer, unit, shape (lengths, 3)
    turn: Array  # axes of what is at the end, to body axes, shape (lengths, 3, 3)


def arm_path(arm: Arm | JointedArm | BentArm, lengths: Array, ways: Array | None = None) -> ArmPath:
    """Path of the end of an arm.

    Args:
        arm: In the body plane, or on joints.
        lengths: Of the arm [m], shape (lengths,).
        ways: Of a second joint [m], shape (lengths,); by default it is free.
    """
    if isinstance(arm, BentArm):
        bends = np.zeros(len(lengths)) if ways is None else ways
        return bent_path(arm.joint, arm.second.joint, lengths - arm.length, bends)
    if isinstance(arm, JointedArm):
        return joint_path(arm.joint, lengths - arm.length)
    return planar_path(np.array([arm.cosine, arm.sine, 0.0]), lengths)


def free_end_along(arm: Arm | JointedArm | BentArm, direction: Vec) -> float:
    """Distance of the free end of an arm from the main body along a direction in body axes [m]."""
    if isinstance(arm, ON_JOINTS):
        return direction @ arm.joint.end
    return arm.length * (direction @ arm_direction(arm))


def planar_path(direction: Array, lengths: Array) -> ArmPath:
    """Path of the end of an arm that slides along its direction, from the main body.

    Args:
        direction: Unit vector, body axes.
        lengths: Of the arm [m], shape (lengths,).
    """
    along = np.broadcast_to(direction, (len(lengths), 3))
    still = np.broadcast_to(np.eye(3), (len(lengths), 3, 3))
    return ArmPath(lengths[:, None] * direction, along, still)


def bent_path(first: Joint, second: Joint, beyond: Array, ways: Array) -> ArmPath:
    """Path of the end of an arm on two joints, as `springback.vehicle.arms.bent.bent_pose`.

    Args:
        first: The joint on the main body.
        second: That which it carries.
        beyond: l − L of the first [m], shape (instants,).
        ways: s₂ of the second [m], shape (instants,).

    Returns:
        By its length the direction is that of the first joint, of any size.
    """
    inner, outer = joint_path(first, beyond), joint_path(second, ways)
    out = np.einsum("tij,tj->ti", inner.turn, outer.end - np.array(second.end))
    axis = np.cross(np.array(first.direction), np.array(first.inward))
    along = inner.direction + first.curvature * np.cross(axis, out)
    return ArmPath(inner.end + out, along, inner.turn @ outer.turn)


def joint_path(joint: Joint, beyond: Array) -> ArmPath:
    """Path of the end of an arm on a joint.

    Args:
        joint: Its joint.
        beyond: By how much the arm is longer than free, l − L [m], shape (lengths,).
    """
    start, along, inward = (np.array(v) for v in (joint.end, joint.direction, joint.inward))
    axis, k = np.cross(along, inward), joint.curvature
    angle = k * beyond
    sine, cosine = np.sin(angle)[:, None], np.cos(angle)[:, None]
    ahead, aside = beyond[:, None], np.zeros((len(beyond), 1))
    if k > STRAIGHT:
        ahead, aside = sine / k, (1.0 - cosine) / k
    skewed = np.cross(np.eye(3), axis)  # rows e_i × a, so that skewed @ v = a × v
    about = sine[:, :, None] * skewed + (1.0 - cosine[:, :, None]) * (skewed @ skewed)
    return ArmPath(
        start + ahead * along + aside * inward, cosine * along + sine * inward, np.eye(3) + about
    )
