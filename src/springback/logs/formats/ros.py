"""Messages of ROS 1 and 2 as channels, whatever file they are from.

Vectors of the world are in ENU by default and those of a body in FLU (REP 103); messages of PX4 are
in NED and FRD.  Quaternions are XYZW.  Times are those of the headers, not those of arrival.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.logs.formats.autopilot import MAKERS, channels_of
from springback.logs.formats.ulog import Topic
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, flags_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    QUANTITIES,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    VELOCITY,
    Array,
    Budget,
    LogChannel,
    SensorChain,
    TimeSpan,
    log_channel,
)

#: Numbers of a part of a message: its name, quantity and values.
Part = tuple[str, str, list[float]]
#: Most names of frames or bodies in one topic (chosen).
MOST_BODIES = 100
#: Topics of poses that an estimator gives, not a measurement, by a word in their names.
ESTIMATES = ("odom", "local_position", "estimate", "filtered")
#: Topics of joint states that springback writes.
OWN_TOPICS = ("arm_lengths", "rotor_commands")
#: Last part of the name of a topic of springback, of samples at the end of the range: joints named
#: by the part of a message and the place in it, whose positions are 1.
CLIPPED = "clipped"
#: Most joints or motors of one message (chosen).
MOST_PARTS = 64


def _vector(v: Any) -> list[float]:
    return [float(v.x), float(v.y), float(v.z)]


def _turn(q: Any) -> list[float]:
    return [float(q.w), float(q.x), float(q.y), float(q.z)]


def _pose(pose: Any, stem: str = "") -> list[Part]:
    return [
        (f"{stem}position", POSITION, _vector(pose.position)),
        (f"{stem}orientation", ATTITUDE, _turn(pose.orientation)),
    ]


def _transform(transform: Any, stem: str) -> list[Part]:
    return [
        (f"{stem}position", POSITION, _vector(transform.translation)),
        (f"{stem}orientation", ATTITUDE, _turn(transform.rotation)),
    ]


def _pose_stamped(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    yield message.header, _pose(message.pose)


def _pose_covariance(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    yield message.header, _pose(message.pose.pose)


def _transform_stamped(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    yield message.header, _transform(message.transform, "")


def _transforms(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    for one in message.transforms:
        yield one.header, _transform(one.transform, f"{one.child_frame_id}.")


def _odometry(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    twist = message.twist.twist
    parts = _pose(message.pose.pose)
    parts.append(("angular_velocity", ANGULAR_VELOCITY, _vector(twist.angular)))
    yield message.header, parts


def _imu(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    parts = [
        ("linear_acceleration", SPECIFIC_FORCE, _vector(message.linear_acceleration)),
        ("angular_velocity", ANGULAR_VELOCITY, _vector(message.angular_velocity)),
    ]
    turn = _turn(message.orientation)
    if float(message.orientation_covariance[0]) != -1.0 and any(turn):
        parts.append(("orientation", ATTITUDE, turn))
    yield message.header, parts


def _named_poses(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    for one in message.poses:
        yield message.header, _pose(one.pose, f"{one.name}.")


def _rigid_bodies(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    for one in message.rigidbodies:
        yield message.header, _pose(one.pose, f"{one.rigid_body_name}.")


def _actuators(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    speeds = [float(one) for one in message.angular_velocities]
    if speeds:
        yield message.header, [("angular_velocities", ROTOR_SPEED, speeds)]


def _telemetry(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    speeds = [float(one.rpm) * 2.0 * np.pi / 60.0 for one in message.esc_telemetry]
    if speeds:
        yield message.header, [("rpm", ROTOR_SPEED, speeds)]


def _joints(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    """Lengths of arms as positions, or commands of rotors as efforts (springback's own topics)."""
    lengths = [float(one) for one in message.position]
    efforts = [float(one) for one in message.effort]
    if lengths:
        yield message.header, [("", ARM_LENGTH, lengths)]
    elif efforts:
        yield message.header, [("", ROTOR_COMMAND, efforts)]


def _flags(message: Any) -> Iterator[tuple[Any, list[Part]]]:
    """Samples at the end of the range (springback's own topics)."""
    found: dict[str, list[float]] = {}
    for name, flag in zip(message.name, message.position, strict=False):
        found.setdefault(str(name).rpartition(".")[0], []).append(float(flag))
    yield message.header, [(part, CLIPPED, flags) for part, flags in found.items()]


READERS: dict[str, Callable[[Any], Iterator[tuple[Any, list[Part]]]]] = {
    "geometry_msgs/msg/PoseStamped": _pose_stamped,
    "geometry_msgs/msg/PoseWithCovarianceStamped": _pose_covariance,
    "geometry_msgs/msg/TransformStamped": _transform_stamped,
    "tf2_msgs/msg/TFMessage": _transforms,
    "nav_msgs/msg/Odometry": _odometry,
    "sensor_msgs/msg/Imu": _imu,
    "motion_capture_tracking_interfaces/msg/NamedPoseArray": _named_poses,
    "mocap4r2_msgs/msg/RigidBodies": _rigid_bodies,
    "mav_msgs/msg/Actuators": _actuators,
    "mavros_msgs/msg/ESCTelemetry": _telemetry,
    "sensor_msgs/msg/JointState": _joints,
}


def snake_case(name: str) -> str:
    """A name such as ``SensorCombined`` as ``sensor_combined``."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def px_topic(topic: str, kind: str) -> str | None:
    """Topic of PX4 that a message of its package is, if it is read."""
    if not kind.startswith("px4_msgs/"):
        return None
    for name in (topic.rpartition("/")[2], snake_case(kind.rpartition("/")[2])):
        if name in MAKERS:
            return name
    return None


def is_read(topic: str, kind: str) -> bool:
    """True for the messages that become channels; joint states only in springback's own topics."""
    if kind == "sensor_msgs/msg/JointState":
        return topic.rpartition("/")[2] in (*OWN_TOPICS, CLIPPED)
    return kind in READERS or px_topic(topic, kind) is not None


class _Samples:
    """Samples of one part of a topic."""

    def __init__(self, quantity: str, width: int) -> None:
        self.quantity, self.width = quantity, width
        self.times, self.arrivals, self.values = array("d"), array("d"), array("d")


class RosCollector:
    """Messages, gathered into channels."""

    def __init__(self, where: str, part: TimeSpan, world: str, body: str) -> None:
        """Start without messages.

        Args:
            where: The file, for messages.
            part: Instants that are wanted [s].
            world: Name of the world axes, of `springback.logs.frame_turns.WORLDS`.
            body: Name of the body axes, of `springback.logs.frame_turns.BODIES`.
        """
        self.where, self.part, self.budget = where, part, Budget(where)
        self.world, self.body = WORLDS[world], BODIES[body]
        self.samples: dict[tuple[str, str], _Samples] = {}
        self.flags: dict[tuple[str, str], _Samples] = {}
        self.tables: dict[str, tuple[str, list[dict[str, Any]]]] = {}
        self.unstamped: set[str] = set()

    def add(self, topic: str, kind: str, message: Any, arrival: float) -> None:
        """Add a message.

        Args:
            topic: Its topic.
            kind: Its type, such as ``sensor_msgs/msg/Imu``.
            message: The message, with its fields as attributes.
            arrival: Time [s] at which it was recorded.
        """
        name = px_topic(topic, kind)
        if name is not None:
            self._add_row(topic, name, message)
            return
        stem, _, last = topic.rpartition("/")
        flags = last == CLIPPED and kind == "sensor_msgs/msg/JointState"
        read = _flags if flags else READERS[kind]
        for header, parts in read(message):
            at = float(header.stamp.sec) + 1e-9 * float(header.stamp.nanosec)
            if at == 0.0:
                at = arrival
                if arrival != 0.0:
                    self.unstamped.add(topic)
            if self.part.has(at):
                for part in parts:
                    if flags:
                        self._add_part(self.flags, stem, part, at, arrival)
                    else:
                        self._add_part(self.samples, topic, part, at, arrival)

    def _add_part(
        self,
        into: dict[tuple[str, str], _Samples],
        topic: str,
        part: Part,
        at: float,
        arrival: float,
    ) -> None:
        name, quantity, values = part
        rows = into.get((topic, name))
        if rows is None:
            if len(into) >= 3 * MOST_BODIES or len(values) > MOST_PARTS:
                return
            rows = into[topic, name] = _Samples(quantity, len(values))
        if len(values) != rows.width:
            return
        self.budget.take(rows.width + 2)
        rows.times.append(at)
        rows.arrivals.append(arrival)
        rows.values.extend(values)

    def _add_row(self, topic: str, name: str, message: Any) -> None:
        """A message of PX4: its numbers, under their names."""
        row = {}
        for field in getattr(message, "__dataclass_fields__", {}):
            value = getattr(message, field)
            if isinstance(value, bool | int | float | np.ndarray):
                row[field] = value
        if "timestamp" in row and self.part.has(float(row["timestamp"]) / 1e6):
            self.budget.take(sum(np.size(value) for value in row.values()))
            self.tables.setdefault(topic, (name, []))[1].append(row)

    def channels(self) -> list[LogChannel]:
        """All channels.

        Raises:
            InputError: If a clock or a value of one cannot be.
        """
        found = [self._channel(topic, name, rows) for (topic, name), rows in self.samples.items()]
        for topic, (name, rows) in self.tables.items():
            table = _structured(rows)
            made = channels_of(self.where, [Topic(name, 0, table)], {})
            if topic.rpartition("/")[2] != name:
                made = [_renamed(one, name, topic) for one in made]
            found += made
        return found

    def _channel(self, topic: str, name: str, rows: _Samples) -> LogChannel:
        order = np.argsort(np.frombuffer(rows.arrivals), kind="stable")
        at = np.frombuffer(rows.times)[order]
        values: Array = np.frombuffer(rows.values).reshape(len(at), -1)[order]
        frame = QUANTITIES[rows.quantity].frame
        if rows.quantity == ATTITUDE:
            values = attitudes_in(self.world, self.body, values)
        elif frame:
            values = vectors_in(self.world if frame == "world" else self.body, values)
        where = topic.lower()
        estimated = rows.quantity in (ATTITUDE, POSITION, VELOCITY) and (
            (name == "orientation" and "imu" in where) or any(word in where for word in ESTIMATES)
        )
        chain = SensorChain(estimated=estimated)
        full = f"{topic}.{name}" if name else topic
        clipped = None
        if rows.quantity != ATTITUDE:
            clipped = self._clipped(topic, name, rows.width, at)
        if clipped is not None and frame:
            clipped = flags_in(self.world if frame == "world" else self.body, clipped)
        return log_channel(
            self.where, full, rows.quantity, at, values, clipped=clipped, chain=chain
        )  # fmt: skip

    def _clipped(self, topic: str, name: str, width: int, at: Array) -> Any:
        """Flags of samples at the end of the range, by their instants; None if nothing tells."""
        rows = self.flags.get((topic, name))
        if rows is None or rows.width != width:
            return None
        times = np.frombuffer(rows.times)
        order = np.argsort(times, kind="stable")
        flags = np.frombuffer(rows.values).reshape(len(times), -1)[order] > 0.0
        places = np.minimum(np.searchsorted(times[order], at), len(times) - 1)
        return flags[places] & (times[order][places] == at)[:, None]

    def remarks(self) -> list[str]:
        """What was seen, a sentence each."""
        return [
            f"{topic}: has no times in its headers; those of arrival are taken"
            for topic in sorted(self.unstamped)
        ]


def _structured(rows: list[dict[str, Any]]) -> Any:
    """Rows as a structured array, of the fields and shapes of the first."""
    first = {key: np.asarray(value) for key, value in rows[0].items()}
    kinds: list[Any] = [
        (key, np.uint64 if key.startswith("timestamp") else one.dtype, one.shape)
        for key, one in first.items()
        if one.dtype.kind in "biuf"
    ]
    table = np.zeros(len(rows), dtype=kinds)
    for key, _, shape in kinds:
        column = [row[key] for row in rows]
        if any(np.shape(one) != shape for one in column):
            continue
        table[key] = column
    return table


def _renamed(one: LogChannel, name: str, topic: str) -> LogChannel:
    from dataclasses import replace

    return replace(one, name=one.name.replace(name, topic, 1))


def refuse_damage(where: str, error: BaseException, what: str) -> InputError:
    """The error for a bag that its library cannot read: the first words of what that says."""
    said = " ".join(str(error).split())[:200] or type(error).__name__
    return InputError(f"{where}: cannot be read as {what}: {said}")
