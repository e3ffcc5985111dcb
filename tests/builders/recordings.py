"""Recordings by formula, and files of every format with them: sums of sines, and a push at a wall."""

from __future__ import annotations

import functools
import struct
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from springback.logs.frame_turns import (
    BODIES,
    WORLDS,
    attitudes_in,
    conjugate,
    product,
    rotation_vector,
    vector_quaternion,
    vectors_in,
    world_vectors,
)
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    SPECIFIC_FORCE,
    LogChannel,
    Recording,
    SensorChain,
    log_channel,
)
from springback.logs.writing.writers import WRITERS, write_recording

GRAVITY = np.array([0.0, 0.0, 9.80665])
START = np.array([0.0, 0.0, 1.0])
#: The push: when [s], how long [s], and the change of velocity [m/s].
TOUCH, CONTACT, CHANGE = 2.0, 0.031, np.array([-3.0, 0.4, 0.2])


def attitude_at(t: np.ndarray) -> np.ndarray:
    """Attitudes that turn about all axes, shape (n, 4)."""
    x = np.stack([0.25 * np.sin(5.1 * t), np.zeros_like(t), np.zeros_like(t)], axis=1)
    y = np.stack([np.zeros_like(t), 0.2 * np.sin(3.7 * t + 1.0), np.zeros_like(t)], axis=1)
    z = np.stack([np.zeros_like(t), np.zeros_like(t), 0.5 * np.sin(2.3 * t)], axis=1)
    return product(product(vector_quaternion(z), vector_quaternion(y)), vector_quaternion(x))


def rate_at(t: np.ndarray) -> np.ndarray:
    """Their rates [rad/s], body axes, by differences over 2e-5 s."""
    h = 1e-5
    return rotation_vector(product(conjugate(attitude_at(t - h)), attitude_at(t + h))) / (2.0 * h)


def acceleration_at(t: np.ndarray, change: Any = CHANGE, touch: float = TOUCH) -> np.ndarray:
    """Accelerations [m/s²], world: sines, and a half sine that changes the velocity."""
    smooth = np.stack([0.9 * np.sin(2.0 * t), 0.8 * np.cos(2.9 * t), 0.7 * np.sin(4.3 * t)], axis=1)
    inside = (t >= touch) & (t <= touch + CONTACT)
    push = np.where(inside, np.pi / (2.0 * CONTACT) * np.sin(np.pi * (t - touch) / CONTACT), 0.0)
    return smooth + push[:, None] * np.asarray(change)


def track_at(t: np.ndarray, change: Any = CHANGE, touch: float = TOUCH) -> np.ndarray:
    """Positions [m], world: the accelerations integrated twice, from 1 m/s ahead."""
    fine = np.arange(0.0, t[-1] + 2e-5, 1e-5)
    a = acceleration_at(fine, change, touch)
    v = np.array([1.0, 0.0, 0.0]) + np.concatenate(
        [np.zeros((1, 3)), np.cumsum(0.5e-5 * (a[1:] + a[:-1]), axis=0)]
    )
    p = np.concatenate([np.zeros((1, 3)), np.cumsum(0.5e-5 * (v[1:] + v[:-1]), axis=0)])
    return np.stack([np.interp(t, fine, one) for one in (p + START).T], axis=1)


def inertial(
    duration: float = 4.0, rate: float = 1000.0, *, change: Any = CHANGE, start: float = 0.0,
    touch: float = TOUCH, full_scale: float = 400.0,
) -> list[LogChannel]:  # fmt: skip
    """Accelerometer and gyroscope, on a clock that begins at `start`."""
    t = np.arange(0.0, duration, 1.0 / rate)
    force = world_vectors(conjugate(attitude_at(t)), acceleration_at(t, change, touch) + GRAVITY)
    clipped = np.abs(force) >= full_scale
    force = np.clip(force, -full_scale, full_scale)
    chain = SensorChain(full_scale=full_scale)
    return [
        log_channel("made", "accelerometer", SPECIFIC_FORCE, t + start, force, clipped=clipped,
                    chain=chain),
        log_channel("made", "gyroscope", ANGULAR_VELOCITY, t + start, rate_at(t)),
    ]  # fmt: skip


def poses(
    duration: float = 4.0, rate: float = 200.0, *, change: Any = CHANGE, name: str = "vehicle",
    touch: float = TOUCH, aside: Any = (0.0, 0.0, 0.0),
) -> list[LogChannel]:  # fmt: skip
    """A body that a motion capture tracks, on a clock that begins at 0."""
    t = np.arange(0.0, duration, 1.0 / rate)
    place = track_at(t, change, touch) + np.asarray(aside)
    return [
        log_channel("made", f"{name}.position", POSITION, t, place, clock="motion capture"),
        log_channel(
            "made", f"{name}.attitude", ATTITUDE, t, attitude_at(t), clock="motion capture"
        ),
    ]


def recording(*channels: LogChannel, path: str = "made", form: str = "made") -> Recording:
    return Recording(Path(path), form, channels)


def whole(duration: float = 4.0, rate: float = 1000.0) -> Recording:
    """All that a flight records."""
    t = np.arange(0.0, duration, 0.005)
    pressed = 0.01 * np.where((t > TOUCH) & (t < TOUCH + CONTACT), 1.0, 0.0)
    lengths = 0.2 - pressed[:, None] * [1.0, 0.0, 0.0, 1.0]
    command = 0.5 + 0.1 * np.sin(t[:, None] + np.arange(4.0))
    return recording(
        *inertial(duration, rate), *poses(duration),
        log_channel("made", "arm lengths", ARM_LENGTH, t, lengths),
        log_channel("made", "commands", ROTOR_COMMAND, t, command),
    )  # fmt: skip


# -- files ----------------------------------------------------------------------------------------


def dataflash(rows: int = 400, rate: float = 400.0, *, force: Any = None) -> bytes:
    """A log of ArduPilot: formats, parameters, inertial data, attitudes, poses and outputs."""
    kinds = {
        "FMT": (128, "BBnNZ", "Type,Length,Name,Format,Columns"),
        "PARM": (64, "QNf", "TimeUS,Name,Value"),
        "IMU": (65, "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
        "ATT": (66, "QccC", "TimeUS,Roll,Pitch,Yaw"),
        "XKF1": (67, "QBffffff", "TimeUS,C,VN,VE,VD,PN,PE,PD"),
        "VISP": (68, "QQIfffffff", "TimeUS,RTimeUS,CTimeMS,PX,PY,PZ,Roll,Pitch,Yaw,Err"),
        "RCOU": (69, "QHHHH", "TimeUS,C1,C2,C3,C4"),
        "OTHR": (70, "QB", "TimeUS,X"),
    }  # fmt: skip
    code = {"Q": "Q", "B": "B", "n": "4s", "N": "16s", "Z": "64s", "f": "f", "c": "h", "C": "H",
            "H": "H", "I": "I"}  # fmt: skip
    forms = {
        name: struct.Struct("<" + "".join(code[c] for c in kind[1])) for name, kind in kinds.items()
    }

    def message(name: str, *values: Any) -> bytes:
        return b"\xa3\x95" + bytes((kinds[name][0],)) + forms[name].pack(*values)

    data = b"".join(
        message("FMT", number, forms[name].size + 3, name.encode(), form.encode(), labels.encode())
        for name, (number, form, labels) in kinds.items()
    )
    data += message("PARM", 0, b"INS_ACC_ID", 1.5)
    data += message("PARM", 0, b"INS_ACCEL_FILTER", 20.0)
    data += message("PARM", 0, b"INS_GYRO_FILTER", 0.0)
    t = np.arange(rows) / rate
    frd, ned = BODIES["frd"], WORLDS["ned"]
    a = (
        world_vectors(conjugate(attitude_at(t)), acceleration_at(t) + GRAVITY)
        if force is None
        else force
    )
    w = rate_at(t)
    place = track_at(t)
    q = attitudes_in(ned, frd, attitude_at(t))
    for k, at in enumerate(t):
        us = round(1e6 * at) + 1_000_000
        data += message("IMU", us, 0, *(frd @ w[k]), *(frd @ a[k]))
        if k % 4 == 0:
            roll, pitch, yaw = euler_degrees(q[k])
            data += message(
                "ATT", us, round(100 * roll), round(100 * pitch), round(100 * yaw) % 36000
            )
            data += message("XKF1", us, 0, 0.0, 0.0, 0.0, *(ned @ place[k]))
            data += message("VISP", us, us, us // 1000, *(ned @ place[k]), roll, pitch, yaw, 0.0)
            data += message("RCOU", us, 1500, 1501, 1502, 1503)
            data += message("OTHR", us, 3)
    return data


def euler_degrees(q: np.ndarray) -> tuple[float, float, float]:
    """Roll, pitch and yaw [deg] about x, y and z."""
    w, x, y, z = (float(part) for part in q)
    return (
        float(np.degrees(np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)))),
        float(np.degrees(np.arcsin(np.clip(2 * (w * y - z * x), -1.0, 1.0)))),
        float(np.degrees(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))),
    )


def c3d(frames: int = 100, rate: float = 200.0, *, scale: float = -1.0) -> bytes:
    """A C3D file of three markers [mm], one lost in its second frame."""
    names = [b"M1  ", b"M2  ", b"M3  "]

    def parameter(group: int, name: bytes, kind: int, sizes: list[int], body: bytes) -> bytes:
        rest = struct.pack("bB", kind, len(sizes)) + bytes(sizes) + body + b"\0"
        return struct.pack("bb", len(name), group) + name + struct.pack("<H", len(rest) + 2) + rest

    group = struct.pack("bb", 5, -1) + b"POINT" + struct.pack("<H", 3) + b"\0"
    parameters = b"\1\x50\1\x54" + group
    parameters += parameter(1, b"USED", 2, [], struct.pack("<h", 3))
    parameters += parameter(1, b"SCALE", 4, [], struct.pack("<f", scale))
    parameters += parameter(1, b"RATE", 4, [], struct.pack("<f", rate))
    parameters += parameter(1, b"DATA_START", 2, [], struct.pack("<h", 3))
    parameters += parameter(1, b"FRAMES", 2, [], struct.pack("<h", frames))
    parameters += parameter(1, b"UNITS", -1, [2], b"mm")
    parameters += parameter(1, b"LABELS", -1, [4, 3], b"".join(names))
    analog = struct.pack("bb", 6, -2) + b"ANALOG" + struct.pack("<H", 3) + b"\0"
    parameters += analog + parameter(2, b"USED", 2, [], struct.pack("<h", 0))
    parameters += b"\0" * (512 - len(parameters))
    head = struct.pack("<BBHHHHHfHHf", 2, 0x50, 3, 0, 1, frames, 10, scale, 3, 0, rate)
    head += b"\0" * (512 - len(head))
    t = np.arange(frames) / rate
    place = 1e3 * track_at(t)
    offsets = np.array([[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 100.0, 50.0]])
    rows = np.zeros((frames, 3, 4), dtype="<f4")
    rows[:, :, :3] = place[:, None] + offsets
    rows[1, 2] = [0.0, 0.0, 0.0, -1.0]
    if scale > 0.0:
        rows[:, :, :3] /= scale
        return head + parameters + np.round(rows).astype("<i2").tobytes()
    return head + parameters + rows.tobytes()


def raw_ulog(
    topics: dict[str, tuple[str, np.ndarray]], parameters: dict[str, Any] | None = None
) -> bytes:
    """A ULog of topics: fields of the format, and structured rows."""

    def message(kind: bytes, body: bytes) -> bytes:
        return struct.pack("<H", len(body)) + kind + body

    data = b"ULog\x01\x12\x35\x01" + struct.pack("<Q", 0) + message(b"B", bytes(40))
    for name, (fields, _) in topics.items():
        if fields:
            data += message(b"F", f"{name}:{fields}".encode())
    for name, value in (parameters or {}).items():
        kind, form = ("int32_t", "<i") if isinstance(value, int) else ("float", "<f")
        key = f"{kind} {name}".encode()
        data += message(b"P", bytes((len(key),)) + key + struct.pack(form, value))
    used = [name for name, (_, rows) in topics.items() if len(rows)]
    for number, name in enumerate(used):
        data += message(b"A", struct.pack("<BH", 0, number) + name.encode())
    for number, name in enumerate(used):
        for row in topics[name][1]:
            data += message(b"D", struct.pack("<H", number) + row.tobytes())
    return data


@functools.cache
def files() -> dict[str, bytes]:
    """A short file of each format, by its name; mapped tables are two."""
    made = whole(1.0, 200.0)
    found: dict[str, bytes] = {}
    with tempfile.TemporaryDirectory() as folder:
        for word, (suffix, _) in WRITERS.items():
            path = Path(folder) / f"{word}{suffix}"
            write_recording(made, path, word)
            found[path.name] = path.read_bytes()
        found["table.toml"] = (Path(folder) / "table.toml").read_bytes()
        write_parquet(Path(folder) / "rows.parquet")
        found["rows.parquet"] = (Path(folder) / "rows.parquet").read_bytes()
        sqlite_bag(Path(folder) / "bag.db3", Path(folder) / "mcap.mcap")
        found["bag.db3"] = (Path(folder) / "bag.db3").read_bytes()
        first_bag(Path(folder) / "first.bag")
        found["first.bag"] = (Path(folder) / "first.bag").read_bytes()
    found["log.bin"] = dataflash(200)
    found["markers.c3d"] = c3d(50)
    return found


#: Mapping of `rows.parquet`.
ROWS = """
file = "rows.parquet"
[[channels]]
name = "imu"
quantity = "specific force"
columns = ["ax", "ay", "az"]
unit = "gn"
time = "ms"
time_unit = "ms"
"""


def write_parquet(path: Path) -> None:
    import duckdb

    duckdb.sql(
        "SELECT i * 5.0 AS ms, 0.001 * i AS ax, 0.0 AS ay, 1.0 AS az FROM range(100) t(i)"
    ).write_parquet(str(path))


def sqlite_bag(path: Path, mcap: Path) -> None:
    """The messages of an MCAP file, as a ROS 2 bag in SQLite."""
    import sqlite3

    from mcap.reader import make_reader

    base = sqlite3.connect(path)
    base.execute(
        "CREATE TABLE topics(id INTEGER, name TEXT, type TEXT, serialization_format TEXT, "
        "offered_qos_profiles TEXT)"
    )
    base.execute(
        "CREATE TABLE messages(id INTEGER, topic_id INTEGER, timestamp INTEGER, data BLOB)"
    )
    known = {}
    with mcap.open("rb") as file:
        for k, (schema, channel, message) in enumerate(make_reader(file).iter_messages()):
            if channel.id not in known:
                known[channel.id] = schema.name
                row = (channel.id, channel.topic, schema.name, "cdr", "")
                base.execute("INSERT INTO topics VALUES (?, ?, ?, ?, ?)", row)
            base.execute(
                "INSERT INTO messages VALUES (?, ?, ?, ?)",
                (k, channel.id, message.log_time, message.data),
            )
    base.commit()
    base.close()


def first_bag(path: Path, rows: int = 200) -> None:
    """A ROS 1 bag with inertial data and a transform, as `vicon_bridge` writes it."""
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS1_NOETIC)
    kinds = store.types
    t = np.arange(rows) / 200.0
    force = world_vectors(conjugate(attitude_at(t)), acceleration_at(t) + GRAVITY)
    turn, place = rate_at(t), vectors_in(WORLDS["enu"].T, track_at(t))
    q = attitudes_in(WORLDS["enu"].T, np.eye(3), attitude_at(t))
    vector, quaternion = kinds["geometry_msgs/msg/Vector3"], kinds["geometry_msgs/msg/Quaternion"]
    with Writer(path) as writer:
        imu = writer.add_connection("/imu", "sensor_msgs/msg/Imu", typestore=store)
        body = writer.add_connection(
            "/vicon/arq/arq", "geometry_msgs/msg/TransformStamped", typestore=store
        )
        for k, at in enumerate(t):
            ns = 10**18 + round(1e9 * at)
            stamp = kinds["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)
            header = kinds["std_msgs/msg/Header"](seq=k, stamp=stamp, frame_id="world")
            none = np.zeros(9)
            none[0] = -1.0
            message = kinds["sensor_msgs/msg/Imu"](
                header, quaternion(0.0, 0.0, 0.0, 1.0), none, vector(*turn[k]), np.zeros(9),
                vector(*force[k]), np.zeros(9),
            )  # fmt: skip
            data = store.serialize_ros1(message, "sensor_msgs/msg/Imu")
            writer.write(imu, ns + 10**6, bytes(data))
            w, x, y, z = q[k]
            pose = kinds["geometry_msgs/msg/Transform"](vector(*place[k]), quaternion(x, y, z, w))
            moved = kinds["geometry_msgs/msg/TransformStamped"](header, "arq", pose)
            data = store.serialize_ros1(moved, "geometry_msgs/msg/TransformStamped")
            writer.write(body, ns + 10**6, bytes(data))
