"""Shapes of the arms of a vehicle: along a slide, or on one joint or two."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.interfaces.replay.hull_meshes import HullMesh, hull_meshes
from springback.kernels.vectors import Vec, norm
from springback.vehicle.arms.bent import ON_JOINTS, BentArm, SecondJoint
from springback.vehicle.arms.joints import STRAIGHT, Joint, JointedArm
from springback.vehicle.arms.paths import ArmPath, bent_path, joint_path, planar_path
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, Arm

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Chosen, of a slide's spring: its inner seat is at least, and its outer seat from the end of the
#: arm, at this share of the end's distance from the main body; length between both, per stroke.
SEAT, COLLAR, ROOM = 0.24, 0.13, 1.8
#: Chosen: place of a latch between the end of a hinged arm, 0, and its hinge, 1, of the first joint
#: and of the second; they differ as both hinges may be in one point.
LATCHED = (0.55, 0.35)


class JointShape(NamedTuple):
    """Joint of an arm: a slide in any direction, or a hinge."""

    path: Joint  # of the end of the arm
    anchor: tuple[float, ...]  # where it is on the main body: hinge, or seat of the spring [m]

    @property
    def is_hinge(self) -> bool:
        """True for a hinge, whose path is an arc about the anchor."""
        return self.path.curvature > STRAIGHT


class LatchShape(NamedTuple):
    """Latch of an arm: a face on it meets one on what carries its joint, until it opens."""

    face: tuple[float, ...]  # where they meet while all is free, from the main body, body axes [m]
    travel: float  # way of the arm's end at which it opens [m]
    joint: int = 0  # 0: of the first, from the main body; 1: of the second, from what it carries

    def is_open(self, pressed: float, bend: float) -> bool:
        """True if it has opened.

        Args:
            pressed: By how much the first joint is pressed in [m].
            bend: Way of the second joint [m], negative as it is pressed in.
        """
        return (-bend if self.joint else pressed) > self.travel


class ArmShape(NamedTuple):
    """An arm with its cage; what is at the end of a hinged arm turns with it."""

    direction: tuple[float, ...]  # of its free end from the main body, unit vector, body axes
    length: float  # free length [m]
    shortest: float  # length at full stroke [m]
    cage_radius: float  # [m]; the circle lies in the plane of the arms while the arm is free
    caged: bool  # False: it is no cage
    compliant: bool
    hulls: tuple[HullMesh, ...] = ()  # from its end
    joint: tuple[JointShape, ...] = ()  # none: it slides along its direction
    latch: tuple[LatchShape, ...] = ()
    second: tuple[JointShape, ...] = ()  # that the first one carries, at rest

    @property
    def reach(self) -> float:
        """Distance of its free end from the main body [m]."""
        return float(np.linalg.norm(self.joint[0].path.end)) if self.joint else self.length

    def path(self, lengths: Array, ways: Array | None = None) -> ArmPath:
        """Path of its end, by its lengths [m], and the ways of its second joint [m]."""
        for joint, second in zip(self.joint, self.second, strict=False):
            bends = np.zeros(len(lengths)) if ways is None else ways
            return bent_path(joint.path, second.path, lengths - self.length, bends)
        for joint in self.joint:
            return joint_path(joint.path, lengths - self.length)
        return planar_path(np.array(self.direction), lengths)

    def yielding(self, length: float, bend: float = 0.0) -> float:
        """How far it has given way at a length [m]: on joints, to either side, the larger."""
        pressed = self.length - length
        return max(abs(pressed), abs(bend)) if self.joint else pressed

    def faces(self, latch: LatchShape, length: float, bend: float) -> Array:
        """Both faces of a latch, on what carries its joint and on the arm, body axes [m].

        Args:
            latch: One of its latches.
            length: Of the arm [m].
            bend: Way of its second joint [m].
        """
        ways = ((self.length, 0.0), (length, 0.0), (length, bend))
        paths = [self.path(np.array([first]), np.array([second])) for first, second in ways]
        lever = np.array(latch.face) - paths[0].end[0]
        pair = paths[latch.joint : latch.joint + 2]
        return np.array([path.end[0] + path.turn[0] @ lever for path in pair])

    def pivots(self, length: float) -> list[Array]:
        """Hinges at a length, from the main body on, body axes [m]."""
        found = [np.array(joint.anchor) for joint in self.joint if joint.is_hinge]
        there = self.path(np.array([length]))  # as the first joint alone turns it
        for joint in self.second:
            if joint.is_hinge:
                from_end = np.array(joint.anchor) - np.array(joint.path.end)
                found.append(there.end[0] + there.turn[0] @ from_end)
        return found


def arm_shapes(airframe: Airframe, vehicle: Vehicle) -> tuple[ArmShape, ...]:
    """Shapes of the arms of an airframe."""
    return tuple(
        ArmShape(
            direction=_direction(arm), length=arm.length, shortest=arm.shortest,
            cage_radius=arm.cage_radius, caged=arm.caged > 0.0, compliant=arm.compliance > 0.0,
            hulls=hull_meshes(vehicle, j),
            joint=(_joint_shape(arm),) if isinstance(arm, ON_JOINTS) else (),
            latch=_latch_shapes(arm) if isinstance(arm, ON_JOINTS) else (),
            second=(_joint_shape(arm.second),) if isinstance(arm, BentArm) else (),
        )
        for j, arm in enumerate(airframe.arms, start=1)
    )  # fmt: skip


def _direction(arm: Arm | JointedArm | BentArm) -> tuple[float, ...]:
    """Unit vector from the main body to the free end of an arm, body axes."""
    if isinstance(arm, Arm):
        return (arm.cosine, arm.sine, 0.0)
    return tuple(arm.joint.end * (1.0 / norm(arm.joint.end)))


def _joint_shape(arm: JointedArm | BentArm | SecondJoint) -> JointShape:
    """Shape of a joint.

    The axis of a hinge is drawn where it meets the plane of the arc, the seat of a slide's spring
    so far behind the end that the spring fits in at full stroke.
    """
    path, stroke, reach = arm.joint, arm.length - arm.shortest, norm(arm.joint.end)
    if path.curvature > STRAIGHT:
        return JointShape(path, tuple(path.end + path.inward * (1.0 / path.curvature)))
    behind = min((1.0 - SEAT) * reach, COLLAR * reach + ROOM * stroke)
    return JointShape(path, tuple(path.end - behind * path.direction))


def _latch_shapes(arm: JointedArm | BentArm) -> tuple[LatchShape, ...]:
    """Shapes of the latches of its joints, if any: on a hinged arm or the outer seat of a slide."""
    joints: list[JointedArm | BentArm | SecondJoint] = [arm]
    joints += [arm.second] if isinstance(arm, BentArm) else []
    found = []
    for number, one in enumerate(joints):
        path, shape = one.joint, _joint_shape(one)
        if shape.is_hinge:
            face = path.end + LATCHED[number] * (Vec(*shape.anchor) - path.end)
        else:
            face = path.end - (COLLAR * norm(path.end)) * path.direction
        held = [latch for latch in one.spring.latch if latch.force > 0.0]
        found += [LatchShape(tuple(face), latch.travel, number) for latch in held]
    return tuple(found)
