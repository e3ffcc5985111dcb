"""Recordings as ULog, the format of PX4: its topics and axes."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.files import atomic_file
from springback.logs.formats.ulog import MAGIC
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    SPECIFIC_FORCE,
    VELOCITY,
    Array,
    LogChannel,
    Recording,
)

NED, FRD = WORLDS["ned"], BODIES["frd"]
#: Outputs of ``actuator_motors``.
MOTORS = 12
#: Frame of a pose: NED.
POSE_FRAME_NED = 1


class _Table(NamedTuple):
    """Messages of one topic."""

    name: str
    fields: tuple[tuple[str, str, int], ...]  # type of the format, name, length (0: one number)
    kind: np.dtype[Any]
    rows: Any


#: struct-like codes of numpy by the types of the format.
CODES = {"uint64_t": "<u8", "uint32_t": "<u4", "uint8_t": "u1", "float": "<f4", "double": "<f8"}


def _table(name: str, times: Array, **columns: tuple[str, Any]) -> _Table:
    """Messages of columns: type of the format, and values of shape (rows,) or (rows, width)."""
    stamps = np.round(times * 1e6)
    if stamps.min() < 0.0:
        raise InputError(f"{name}: ULog has no times before 0 (got {times.min():g} s)")
    given = {"timestamp": ("uint64_t", stamps), **columns}
    fields, kinds = [], list[Any]()
    for label, (code, values) in given.items():
        width = 0 if np.ndim(values) == 1 else np.shape(values)[1]
        fields.append((code, label, width))
        kinds.append((label, CODES[code], (width,)) if width else (label, CODES[code]))
    rows = np.zeros(len(times), dtype=kinds)
    for label, (_, values) in given.items():
        rows[label] = values
    return _Table(name, tuple(fields), rows.dtype, rows)


def write_ulog(recording: Recording, path: Path) -> list[str]:
    """Write a recording as ULog.

    Accelerations and rates become ``sensor_accel`` and ``sensor_gyro``, measured poses
    ``vehicle_visual_odometry``, estimates ``vehicle_attitude`` and ``vehicle_local_position``,
    commands ``actuator_motors``; lengths of arms become a topic ``arm_length``.  Samples at the end
    of a range are ``clip_counter`` of the first two, and ``clipped`` of the last.  Times are
    rounded to microseconds and most numbers to single precision, as the format has them.

    Args:
        recording: What is written.
        path: The file.

    Returns:
        Names of channels for which there is no topic.

    Raises:
        InputError: If a time is negative.
    """
    tables, left_out = _tables(recording)
    with atomic_file(path) as draft, draft.open("wb") as file:
        start = min(int(table.rows["timestamp"][0]) for table in tables) if tables else 0
        file.write(MAGIC + struct.pack("<BQ", 1, start))
        file.write(_message(b"B", bytes(40)))
        for key, text in (("sys_name", "springback"), ("ver_hw", "simulated")):
            label = f"char[{len(text)}] {key}".encode()
            file.write(_message(b"I", bytes((len(label),)) + label + text.encode()))
        for table in {table.name: table for table in tables}.values():
            parts = [f"{code}{f'[{n}]' if n else ''} {name}" for code, name, n in table.fields]
            file.write(_message(b"F", f"{table.name}:{';'.join(parts)};".encode()))
        board = b"int32_t SENS_BOARD_ROT"
        file.write(_message(b"P", bytes((len(board),)) + board + struct.pack("<i", 0)))
        seen: dict[str, int] = {}
        for number, table in enumerate(tables):
            instance = seen.get(table.name, 0)
            seen[table.name] = instance + 1
            head = struct.pack("<BH", instance, number)
            file.write(_message(b"A", head + table.name.encode()))
        for body in _data(tables):
            file.write(_message(b"D", body))
    return left_out


def _message(kind: bytes, body: bytes) -> bytes:
    return struct.pack("<H", len(body)) + kind + body


def _data(tables: list[_Table]) -> Iterator[bytes]:
    """Bodies of all messages in the order of their times."""
    stamps = np.concatenate([table.rows["timestamp"] for table in tables])
    topics = np.concatenate([np.full(len(t.rows), k) for k, t in enumerate(tables)])
    places = np.concatenate([np.arange(len(table.rows)) for table in tables])
    for k in np.argsort(stamps, kind="stable"):
        topic = int(topics[k])
        yield struct.pack("<H", topic) + tables[topic].rows[places[k]].tobytes()


def _tables(recording: Recording) -> tuple[list[_Table], list[str]]:
    found: list[_Table] = []
    left_out: list[str] = []
    used: set[int] = set()
    for channel in recording.channels:
        if id(channel) in used:
            continue
        known = channel.times
        if channel.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY):
            found.append(_sensor(channel))
        elif channel.quantity in (POSITION, ATTITUDE, VELOCITY):
            other = _partner(channel, recording)
            used |= {id(one) for one in other.values()}
            made = _estimate(known, other) if channel.chain.estimated else _pose(known, other)
            if made is None:
                left_out.append(channel.name)
            else:
                found.append(made)
        elif channel.quantity == ROTOR_COMMAND and channel.values.shape[1] <= MOTORS:
            control = np.full((len(known), MOTORS), np.nan)
            control[:, : channel.values.shape[1]] = channel.values
            stamps = ("uint64_t", np.round(known * 1e6))
            found.append(
                _table("actuator_motors", known, timestamp_sample=stamps,
                       control=("float", control))
            )  # fmt: skip
        elif channel.quantity == ARM_LENGTH:
            found.append(_table(
                "arm_length", known, length=("float", channel.values), **_flags(channel, "clipped")
            ))  # fmt: skip
        else:
            left_out.append(channel.name)
    if not found:
        raise InputError(f"{recording.path}: has nothing that ULog has a topic for")
    return found, left_out


def _sensor(channel: LogChannel) -> _Table:
    """An accelerometer or gyroscope."""
    values = vectors_in(FRD.T, channel.values)
    axes = {axis: ("float", values[:, k]) for k, axis in enumerate("xyz")}
    stamps = ("uint64_t", np.round(channel.times * 1e6))
    name = "sensor_accel" if channel.quantity == SPECIFIC_FORCE else "sensor_gyro"
    device = ("uint32_t", np.ones(len(values)))
    flags = _flags(channel, "clip_counter")  # counted in each message, whose sample is one
    return _table(name, channel.times, timestamp_sample=stamps, device_id=device, **axes, **flags)


def _flags(channel: LogChannel, name: str) -> dict[str, tuple[str, Any]]:
    """Flags of samples at the end of the range as a field; none if a channel does not tell."""
    return {} if channel.clipped is None else {name: ("uint8_t", channel.clipped)}


def _partner(channel: LogChannel, recording: Recording) -> dict[str, LogChannel]:
    """Channels of a pose at the same instants, by their quantities."""
    found = {channel.quantity: channel}
    for one in recording.channels:
        if (
            one.quantity in (POSITION, ATTITUDE, VELOCITY)
            and one.chain.estimated == channel.chain.estimated
            and one.clock == channel.clock
            and one.quantity not in found
            and np.array_equal(one.times, channel.times)
        ):
            found[one.quantity] = one
    return found


def _pose(times: Array, parts: dict[str, LogChannel]) -> _Table | None:
    """A measured pose."""
    if POSITION not in parts:
        return None
    stamps = ("uint64_t", np.round(times * 1e6))
    place = vectors_in(NED.T, parts[POSITION].values)
    q = np.full((len(times), 4), np.nan)
    if ATTITUDE in parts:
        q = attitudes_in(NED.T, FRD.T, parts[ATTITUDE].values)
    return _table(
        "vehicle_visual_odometry", times, timestamp_sample=stamps,
        pose_frame=("uint8_t", np.full(len(times), POSE_FRAME_NED)),
        position=("float", place), q=("float", q),
    )  # fmt: skip


def _estimate(times: Array, parts: dict[str, LogChannel]) -> _Table | None:
    """An estimate of attitude, or of position and velocity."""
    stamps = ("uint64_t", np.round(times * 1e6))
    if POSITION in parts and VELOCITY in parts and ATTITUDE not in parts:
        place = vectors_in(NED.T, parts[POSITION].values)
        speed = vectors_in(NED.T, parts[VELOCITY].values)
        columns = {axis: ("float", place[:, k]) for k, axis in enumerate("xyz")}
        columns |= {f"v{axis}": ("float", speed[:, k]) for k, axis in enumerate("xyz")}
        return _table("vehicle_local_position", times, timestamp_sample=stamps, **columns)
    if ATTITUDE in parts and POSITION not in parts:
        q = attitudes_in(NED.T, FRD.T, parts[ATTITUDE].values)
        return _table("vehicle_attitude", times, timestamp_sample=stamps, q=("float", q))
    return None
