"""Obstacles that move as rigid bodies: their motions, and where they are at an instant.

A body has axes of its own, which are those of the world at time 0.  Its solids are fixed in them.
The kinds of motion are numbers, so that bodies of all kinds are one structure to the compiler.

A given motion (`GIVEN`) is a function of time.  A free body (`FREE`) obeys the Newton–Euler
equations about its centre of mass.  One on a pivot (`PIVOTED`) turns about a point of the world,
like a ball on a rod; one on a hinge (`HINGED`) about an axis, like a door with a closer, which is a
torsion spring and damper, and with stops at both ends.  A carried one (`CARRIED`) is part
of a second vehicle, and is where that is.

Given motions are x = x₀ + V t + A sin(ω t + φ) and θ = Ω t + B sin(ω t + φ), plus cubic splines
through a table.

Of its `springback.vehicle.state.BodyState` a body uses only what its motion leaves open.  Where it
is given, that is the time, which is integrated like everything else: position and velocity are then
functions of the state alone, exact at every stage of a step.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from springback.kernels.angles import angle_of, sine_cosine
from springback.kernels.compiler import kernel
from springback.kernels.routines import number_at
from springback.kernels.vectors import Mat3, Quat, Vec, rotation
from springback.vehicle.state import BodyState

#: Kinds of motion, by number; an absent body fills up a number of bodies, and touches nothing.
ABSENT, GIVEN, FREE, PIVOTED, HINGED, CARRIED = -1.0, 0.0, 1.0, 2.0, 3.0, 4.0

#: Numbers of one piece of a spline: four coefficients of x, y, z and θ each.
CHANNELS, PIECE = 4, 16


_NONE = Vec(0.0, 0.0, 0.0)
_NO_MATRIX = Mat3(_NONE, _NONE, _NONE)


class GivenPath(NamedTuple):
    """A prescribed motion; the axis of its turning is that of the body."""

    start: Vec  # x₀, world [m]
    velocity: Vec  # V [m/s]
    amplitude: Vec  # A [m]
    rate: float  # ω [rad/s]
    phase: float  # φ [rad]
    turning: float  # Ω [rad/s]
    swing: float  # B [rad]
    table: float  # of a spline, whose values are added; 0: none


class BodyAccelerations(NamedTuple):
    """Accelerations of a moving obstacle."""

    linear: Vec  # of its origin, world [m/s²]
    angular: Vec  # its axes [rad/s²]


class MovingBody(NamedTuple):
    """An obstacle that moves."""

    scene: float  # address of the table of its solids, in its own axes
    kind: float  # of motion
    number: float  # from 0
    obstacle: float  # number of the obstacle in the world, from 0; −1 if absent
    mass: float  # [kg]
    inertia: Mat3  # about its centre of mass, or about its pivot; its own axes [kg m²]
    inverse: Mat3  # of that [1/(kg m²)]
    pivot: Vec  # world [m]
    lever: Vec  # from the pivot to the centre of mass, its own axes [m]
    axis: Vec  # unit vector of the hinge, or of prescribed turning: world, and its own axes
    closer: float  # stiffness of the closer [N m/rad]
    damping: float  # of the closer [N m s]; on a pivot, the rate at which spin decays [1/s]
    rest: float  # angle at which the closer is relaxed [rad]
    lowest: float  # angles of the stops [rad]
    highest: float
    stop: float  # stiffness of the stops [N m/rad]
    path: GivenPath
    points: float  # address of the spheres with which it touches the world; 0: it touches nothing
    reach: float  # farthest point of the solids from its origin [m]
    mobility: float  # upper bound of the speed of a point of it per impulse there [1/kg]
    start: BodyState  # at time 0
    accelerations: BodyAccelerations  # of a part of another vehicle, in the step before


class BodyPose(NamedTuple):
    """Place and motion of a moving obstacle; its origin is the centre of mass, or x of its path."""

    position: Vec  # of its origin, world [m]
    r: Mat3  # its axes to world axes
    velocity: Vec  # of its origin, world [m/s]
    spin: Vec  # angular velocity, world [rad/s]


class SplinePoint(NamedTuple):
    """Values of a spline and their rates."""

    position: Vec  # [m]
    angle: float  # [rad]
    velocity: Vec  # [m/s]
    turning: float  # [rad/s]


@kernel
def _piece(table: float, time: float) -> int:
    """Number of the piece of a spline for a time, by halving."""
    first, last = 0, int(number_at(table, 0)) - 1  # knots
    while last - first > 1:
        middle = (first + last) // 2
        if number_at(table, 1 + middle) <= time:
            first = middle
        else:
            last = middle
    return first


@kernel
def _channel(table: float, k: int, u: float) -> float:
    c = number_at(table, k), number_at(table, k + 1), number_at(table, k + 2)
    return ((c[0] * u + c[1]) * u + c[2]) * u + number_at(table, k + 3)


@kernel
def _channel_rate(table: float, k: int, u: float) -> float:
    c = number_at(table, k), number_at(table, k + 1), number_at(table, k + 2)
    return (3.0 * c[0] * u + 2.0 * c[1]) * u + c[2]


@kernel
def spline_point(table: float, time: float) -> SplinePoint:
    """Values of a spline at a time [s]: those of its ends before and after."""
    knots = int(number_at(table, 0))
    begin, end = number_at(table, 1), number_at(table, knots)
    within = (time >= begin) & (time <= end)
    t = time if within else (begin if time < begin else end)
    piece = _piece(table, t)
    u, k = t - number_at(table, 1 + piece), 1 + knots + PIECE * piece
    moves = 1.0 if within else 0.0
    return SplinePoint(
        Vec(_channel(table, k, u), _channel(table, k + 4, u), _channel(table, k + 8, u)),
        _channel(table, k + 12, u),
        moves
        * Vec(
            _channel_rate(table, k, u),
            _channel_rate(table, k + 4, u),
            _channel_rate(table, k + 8, u),
        ),
        moves * _channel_rate(table, k + 12, u),
    )


@kernel
def _turned(axis: Vec, angle: float) -> Mat3:
    half = sine_cosine(0.5 * angle)
    return rotation(Quat(half.cosine, axis.x * half.sine, axis.y * half.sine, axis.z * half.sine))


@kernel
def _given_pose(body: MovingBody, time: float) -> BodyPose:
    path = body.path
    wave = sine_cosine(path.rate * time + path.phase)
    position = path.start + time * path.velocity + wave.sine * path.amplitude
    velocity = path.velocity + (path.rate * wave.cosine) * path.amplitude
    angle = path.turning * time + path.swing * wave.sine
    turning = path.turning + path.rate * wave.cosine * path.swing
    if path.table > 0.0:
        there = spline_point(path.table, time)
        position, velocity = position + there.position, velocity + there.velocity
        angle, turning = angle + there.angle, turning + there.turning
    return BodyPose(position, _turned(body.axis, angle), velocity, turning * body.axis)


@kernel
def body_pose(body: MovingBody, state: BodyState) -> BodyPose:
    """Place and motion of a moving obstacle."""
    if body.kind == ABSENT:
        return BodyPose(_NONE, _NO_MATRIX, _NONE, _NONE)
    if body.kind == GIVEN:
        return _given_pose(body, state.position.x)
    r = rotation(state.attitude)
    spin = r @ state.angular_velocity
    if (body.kind == PIVOTED) | (body.kind == HINGED):
        if body.kind == HINGED:
            spin = (spin @ body.axis) * body.axis
        lever = r @ body.lever
        return BodyPose(body.pivot + lever, r, spin ^ lever, spin)
    return BodyPose(state.position, r, state.velocity, spin)


@kernel
def hinge_angle(body: MovingBody, attitude: Quat) -> float:
    """Angle of a hinged body from where it is at time 0, between −π and π [rad]."""
    q = attitude
    along = body.axis.x * q.x + body.axis.y * q.y + body.axis.z * q.z
    sign = 1.0 if q.w >= 0.0 else -1.0
    return 2.0 * angle_of(sign * along, sign * q.w)


class HingeTorque(NamedTuple):
    """Torque of closer and stops about the axis of a hinge."""

    torque: float  # [N m]
    loss: float  # power turned into heat [W]
    energy: float  # stored [J]


@kernel
def hinge_torque(body: MovingBody, angle: float, turning: float) -> HingeTorque:
    """Torque of closer and stops.

    Args:
        body: The obstacle.
        angle: `hinge_angle` [rad].
        turning: Its rate [rad/s].
    """
    away = angle - body.rest
    over = angle - body.highest if angle > body.highest else 0.0
    under = angle - body.lowest if angle < body.lowest else 0.0
    beyond = over + under
    torque = -body.closer * away - body.damping * turning - body.stop * beyond
    stored = 0.5 * (body.closer * away * away + body.stop * beyond * beyond)
    return HingeTorque(torque, body.damping * turning * turning, stored)


@kernel
def fastest_of_body(body: MovingBody, pose: BodyPose) -> float:
    """Upper bound on the speed of any point of a moving obstacle [m/s]."""
    if body.kind == ABSENT:
        return 0.0
    speed = math.sqrt(pose.velocity @ pose.velocity)
    return speed + body.reach * math.sqrt(pose.spin @ pose.spin)


#: An obstacle that is absent.
NO_BODY = MovingBody(
    0.0, ABSENT, 0.0, -1.0, 1.0, _NO_MATRIX, _NO_MATRIX, _NONE, _NONE, Vec(0.0, 0.0, 1.0), 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, GivenPath(_NONE, _NONE, _NONE, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0, 0.0, 0.0,
    BodyState(_NONE, Quat(1.0, 0.0, 0.0, 0.0), _NONE, _NONE), BodyAccelerations(_NONE, _NONE),
)  # fmt: skip
