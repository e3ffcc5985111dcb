"""Recordings as a ROS 2 bag in one MCAP file: standard messages, ENU and FLU (REP 103)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.extras import needs
from springback.files import atomic_file
from springback.logs.formats.ros import CLIPPED
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    SPECIFIC_FORCE,
    Array,
    LogChannel,
    Recording,
)

ENU = WORLDS["enu"]


class _Sink:
    """An MCAP file that is being written."""

    def __init__(self, writer: Any, store: Any) -> None:
        self.writer, self.store = writer, store
        self.schemas: dict[str, int] = {}
        self.rows: list[tuple[int, int, bytes]] = []

    def kind(self, name: str) -> Any:
        """Type of a message, to make it."""
        return self.store.types[name]

    def topic(self, topic: str, name: str) -> int:
        """Number of a new topic."""
        if name not in self.schemas:
            text = self.store.generate_msgdef(name, ros_version=2)[0]
            self.schemas[name] = self.writer.register_schema(name, "ros2msg", text.encode())
        return int(self.writer.register_channel(topic, "cdr", self.schemas[name]))

    def add(self, channel: int, name: str, time: int, message: Any) -> None:
        """Add a message."""
        self.rows.append((time, channel, bytes(self.store.serialize_cdr(message, name))))

    def finish(self) -> None:
        """Write all messages in the order of their times."""
        for count, (time, channel, data) in enumerate(sorted(self.rows, key=lambda row: row[0])):
            self.writer.add_message(channel, time, data, time, count)


def write_bag(recording: Recording, path: Path) -> list[str]:
    """Write a recording as a ROS 2 bag in MCAP.

    Accelerometer and gyroscope become ``sensor_msgs/Imu``, poses ``geometry_msgs/PoseStamped``;
    lengths of arms and commands of rotors are positions and efforts of ``sensor_msgs/JointState``.
    Samples at the end of a range have positions of 1 in a topic beside theirs, ``.../clipped``.

    Args:
        recording: What is written.
        path: The file, ``.mcap``.

    Returns:
        Names of channels for which there is no message.

    Raises:
        InputError: If the libraries are missing, or nothing could be written.
    """
    typesys, mcap = needs("rosbags.typesys", "logs"), needs("mcap.writer", "logs")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    with atomic_file(path) as draft, draft.open("wb") as file:
        writer = mcap.Writer(file)
        writer.start(profile="ros2", library="springback")
        sink = _Sink(writer, store)
        left_out = _add_all(sink, recording)
        if not sink.rows:
            raise InputError(f"{recording.path}: has nothing that a bag has a message for")
        sink.finish()
        writer.finish()
    return left_out


def _add_all(sink: _Sink, recording: Recording) -> list[str]:
    left_out, used = [], set[int]()
    gyros = [one for one in recording.channels if one.quantity == ANGULAR_VELOCITY]
    counts: dict[str, int] = {}

    def topic(name: str) -> str:
        counts[name] = counts.get(name, 0) + 1
        return name if counts[name] == 1 else f"/{counts[name]}{name}"

    for channel in recording.channels:
        if id(channel) in used:
            continue
        if channel.quantity == SPECIFIC_FORCE:
            gyro = next((g for g in gyros if np.array_equal(g.times, channel.times)), None)
            if gyro is None:
                left_out.append(channel.name)
                continue
            used.add(id(gyro))
            _add_imu(sink, topic("/imu/data_raw"), channel, gyro)
        elif channel.quantity == POSITION:
            turn = next(
                (
                    one for one in recording.channels
                    if one.quantity == ATTITUDE and one.clock == channel.clock
                    and id(one) not in used and np.array_equal(one.times, channel.times)
                ),
                None,
            )  # fmt: skip
            if turn is None:
                left_out.append(channel.name)
                continue
            used.add(id(turn))
            stem = "/estimate" if channel.chain.estimated else ""
            _add_poses(sink, topic(f"{stem}/vehicle/pose"), channel, turn)
        elif channel.quantity in (ARM_LENGTH, ROTOR_COMMAND):
            _add_joints(sink, topic, channel)
        elif channel.quantity not in (ANGULAR_VELOCITY, ATTITUDE):
            left_out.append(channel.name)
    left_out += [
        one.name for one in recording.channels
        if one.quantity in (ANGULAR_VELOCITY, ATTITUDE) and id(one) not in used
    ]  # fmt: skip
    return left_out


def _stamps(times: Array) -> list[int]:
    """Times [ns].

    Raises:
        InputError: If one is before 0, which a stamp of ROS cannot be.
    """
    if times.min() < 0.0:
        raise InputError(f"a bag has no times before 0 (got {times.min():g} s)")
    return [int(one) for one in np.round(times * 1e9)]


def _header(sink: _Sink, stamp: int, frame: str) -> Any:
    time = sink.kind("builtin_interfaces/msg/Time")(sec=stamp // 10**9, nanosec=stamp % 10**9)
    return sink.kind("std_msgs/msg/Header")(stamp=time, frame_id=frame)


def _add_imu(sink: _Sink, topic: str, force: LogChannel, gyro: LogChannel) -> None:
    name = "sensor_msgs/msg/Imu"
    number, imu = sink.topic(topic, name), sink.kind(name)
    vector = sink.kind("geometry_msgs/msg/Vector3")
    quaternion = sink.kind("geometry_msgs/msg/Quaternion")
    none, unknown = np.zeros(9), np.zeros(9)
    none[0] = -1.0  # no attitude
    flu = BODIES["flu"]
    rows = zip(
        _stamps(force.times), vectors_in(flu.T, force.values), vectors_in(flu.T, gyro.values),
        strict=True,
    )  # fmt: skip
    _add_flags(sink, topic, {"linear_acceleration": force, "angular_velocity": gyro})
    for stamp, a, w in rows:
        message = imu(
            header=_header(sink, stamp, "base_link"),
            orientation=quaternion(x=0.0, y=0.0, z=0.0, w=1.0), orientation_covariance=none,
            angular_velocity=vector(x=w[0], y=w[1], z=w[2]), angular_velocity_covariance=unknown,
            linear_acceleration=vector(x=a[0], y=a[1], z=a[2]),
            linear_acceleration_covariance=unknown,
        )  # fmt: skip
        sink.add(number, name, stamp, message)


def _add_poses(sink: _Sink, topic: str, place: LogChannel, turn: LogChannel) -> None:
    name = "geometry_msgs/msg/PoseStamped"
    number = sink.topic(topic, name)
    point, quaternion, pose, stamped = (
        sink.kind(f"geometry_msgs/msg/{word}")
        for word in ("Point", "Quaternion", "Pose", "PoseStamped")
    )
    positions = vectors_in(ENU.T, place.values)
    attitudes = attitudes_in(ENU.T, np.eye(3), turn.values)
    for stamp, p, q in zip(_stamps(place.times), positions, attitudes, strict=True):
        at = pose(
            position=point(x=p[0], y=p[1], z=p[2]),
            orientation=quaternion(x=q[1], y=q[2], z=q[3], w=q[0]),
        )
        sink.add(number, name, stamp, stamped(header=_header(sink, stamp, "map"), pose=at))


def _add_joints(sink: _Sink, topic: Any, channel: LogChannel) -> None:
    is_length = channel.quantity == ARM_LENGTH
    name = topic("/arm_lengths" if is_length else "/rotor_commands")
    part = "arm" if is_length else "rotor"
    names = [f"{part}{k + 1}" for k in range(channel.values.shape[1])]
    _add_joint_states(sink, name, channel.times, names, channel.values, is_position=is_length)
    _add_flags(sink, name, {"": channel})


def _add_flags(sink: _Sink, topic: str, parts: dict[str, LogChannel]) -> None:
    """Samples at the end of the range, of the parts of a topic's messages that tell them."""
    told = {part: one for part, one in parts.items() if one.clipped is not None}
    if not told:
        return
    names = [f"{part}.{k}" for part, one in told.items() for k in range(one.values.shape[1])]
    flags = np.concatenate([np.asarray(one.clipped, dtype=float) for one in told.values()], axis=1)
    times = next(iter(told.values())).times
    _add_joint_states(sink, f"{topic}/{CLIPPED}", times, names, flags, is_position=True)


def _add_joint_states(
    sink: _Sink, topic: str, times: Array, names: list[str], values: Array, *, is_position: bool
) -> None:
    """Positions of joints, or their efforts."""
    name, none = "sensor_msgs/msg/JointState", np.zeros(0)
    number, joint = sink.topic(topic, name), sink.kind(name)
    for stamp, row in zip(_stamps(times), np.ascontiguousarray(values), strict=True):
        message = joint(
            header=_header(sink, stamp, "base_link"), name=names,
            position=row if is_position else none, velocity=none,
            effort=none if is_position else row,
        )  # fmt: skip
        sink.add(number, name, stamp, message)
