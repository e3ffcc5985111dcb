"""Topics of PX4 as channels: from logs in ULog and from ROS messages of the same names.

World NED and body FRD become NWU and FLU.  What each topic is, and what is done to its numbers
before they are logged: PX4 user guide and message definitions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from springback.errors import InputError
from springback.logs.formats.ulog import Rows, Topic, read_ulog
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, flags_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    ATTITUDE,
    LANDED,
    POSITION,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    VELOCITY,
    Array,
    Budget,
    LogChannel,
    Recording,
    SensorChain,
    TimeSpan,
    log_channel,
    refuse_without_channels,
)

NED, FRD = WORLDS["ned"], BODIES["frd"]
#: An integer that stands for "no time difference known".
UNKNOWN_TIME = 0x7FFFFFFF
#: Board rotations (parameter SENS_BOARD_ROT): roll, pitch, yaw [deg].
BOARD = (
    (0, 0, 0), (0, 0, 45), (0, 0, 90), (0, 0, 135), (0, 0, 180), (0, 0, 225), (0, 0, 270),
    (0, 0, 315), (180, 0, 0), (180, 0, 45), (180, 0, 90), (180, 0, 135), (0, 180, 0),
    (180, 0, 225), (180, 0, 270), (180, 0, 315), (90, 0, 0), (90, 0, 45), (90, 0, 90),
    (90, 0, 135), (270, 0, 0), (270, 0, 45), (270, 0, 90), (270, 0, 135), (0, 90, 0), (0, 270, 0),
    (0, 180, 90), (0, 180, 270), (90, 90, 0), (180, 90, 0), (270, 90, 0), (90, 180, 0),
    (270, 180, 0), (90, 270, 0), (180, 270, 0), (270, 270, 0), (90, 180, 90), (90, 0, 270),
)  # fmt: skip

Settings = Mapping[str, float | int | str]
Maker = Callable[[str, "TopicTable"], list[LogChannel]]


class TopicTable:
    """Rows of a topic, with what is needed to make channels of them."""

    def __init__(self, topic: Topic, parameters: Settings, several: bool) -> None:
        """Take the rows.

        Args:
            topic: With its rows.
            parameters: Of the autopilot.
            several: True if there are other instances, so that the name needs the number.
        """
        self.rows: Rows = topic.rows
        self.name = f"{topic.name}[{topic.instance}]" if several else topic.name
        self.parameters = parameters
        self.times: Array = topic.rows["timestamp"].astype(float) / 1e6

    def has(self, *names: str) -> bool:
        """True if all these fields exist."""
        return set(names) <= set(self.rows.dtype.names or ())

    def column(self, *names: str) -> Array:
        """One field that is an array, or several, as columns, shape (rows, width)."""
        parts = [np.asarray(self.rows[name], dtype=float) for name in names]
        return np.concatenate([part.reshape(len(self.rows), -1) for part in parts], axis=1)

    def setting(self, name: str) -> float | None:
        """A positive parameter; None if it is not logged or switched off."""
        value = self.parameters.get(name)
        return float(value) if isinstance(value, float | int) and value > 0 else None


def _mean_time(table: TopicTable, name: str) -> float | None:
    """Median of a duration [s]: in µs, in logs of PX4 before 1.4 in s."""
    if not table.has(name):
        return None
    middle = float(np.median(table.column(name)))
    scale = 1.0 if table.rows[name].dtype.kind == "f" else 1e-6
    return middle * scale if middle > 0.0 else None


def _combined(where: str, table: TopicTable) -> list[LogChannel]:
    stem = table.name
    force = vectors_in(FRD, table.column("accelerometer_m_s2"))
    at = table.times
    if table.has("accelerometer_timestamp_relative"):
        late = table.column("accelerometer_timestamp_relative")[:, 0]
        at = at + np.where(late == UNKNOWN_TIME, 0.0, late) / 1e6
    clipped = None
    if table.has("accelerometer_clipping"):
        bits = table.rows["accelerometer_clipping"].astype(int)
        clipped = np.stack([bits >> k & 1 for k in range(3)], axis=1).astype(bool)
    mean = SensorChain(
        average=_mean_time(table, "accelerometer_integral_dt"),
        note="mean over the time of integration, stamped with the gyroscope's time",
    )
    turn = SensorChain(average=_mean_time(table, "gyro_integral_dt"))
    return [
        log_channel(
            where, f"{stem}.accelerometer", SPECIFIC_FORCE, at, force, clipped=clipped, chain=mean
        ),
        log_channel(
            where, f"{stem}.gyro", ANGULAR_VELOCITY, table.times,
            vectors_in(FRD, table.column("gyro_rad")), chain=turn,
        ),
    ]  # fmt: skip


def _board(parameters: Settings) -> Array | None:
    """Turn of vectors from the board's axes to FRD; None if the rotation is not known."""
    number = parameters.get("SENS_BOARD_ROT", 0)
    if not isinstance(number, int) or not 0 <= number < len(BOARD):
        return None
    a, b, c = (math.radians(angle) for angle in BOARD[number])
    roll = np.array(
        [[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]], dtype=float
    )
    pitch = np.array(
        [[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]], dtype=float
    )
    yaw = np.array(
        [[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]], dtype=float
    )
    return np.asarray(yaw @ pitch @ roll)


def _raw(quantity: str) -> Maker:
    """Reader of `sensor_accel` or `sensor_gyro`: values of the chip at one instant."""

    def read(where: str, table: TopicTable) -> list[LogChannel]:
        board = _board(table.parameters)
        if board is None:
            return []
        values = vectors_in(FRD @ board, table.column("x", "y", "z"))
        at = _sample_times(table)
        clipped = None
        if table.has("clip_counter"):
            # Counts are those of the message's own samples, not of all so far.
            clipped = flags_in(FRD @ board, table.column("clip_counter") > 0.0)
        chain = SensorChain(note="of the chip, without the autopilot's calibration")
        return [log_channel(where, table.name, quantity, at, values, clipped=clipped, chain=chain)]

    return read


def _sample_times(table: TopicTable) -> Array:
    """Instants of the samples [s] where they are logged, else of the messages."""
    if not table.has("timestamp_sample"):
        return table.times
    at = table.column("timestamp_sample")[:, 0] / 1e6
    return np.where(at > 0.0, at, table.times)


def _fifo(quantity: str) -> Maker:
    """Reader of `sensor_accel_fifo` or `sensor_gyro_fifo`: every sample of the chip."""

    def read(where: str, table: TopicTable) -> list[LogChannel]:
        board = _board(table.parameters)
        if board is None or not table.has("dt", "samples", "x", "y", "z"):
            return []
        if not table.has("scale"):
            raise InputError(
                f"{where}: {table.name}: has no scale, as in logs of PX4 before 1.12: its numbers "
                "have no known unit"
            )
        ends, step = _sample_times(table), table.column("dt")[:, 0] / 1e6
        most = table.rows["x"].shape[1]
        count = np.clip(table.rows["samples"].astype(int), 0, most)
        places = np.arange(most)
        used = places < count[:, None]
        at = (ends[:, None] - (count[:, None] - 1 - places) * step[:, None])[used]
        counts = np.stack([table.rows[axis].astype(float)[used] for axis in "xyz"], axis=1)
        scale = np.broadcast_to(table.column("scale"), used.shape)[used]
        values = vectors_in(FRD @ board, counts * scale[:, None])
        clipped = flags_in(FRD @ board, np.abs(counts) >= 32767.0)
        if not len(at):
            return []
        chain = SensorChain(
            full_scale=float(32768.0 * np.abs(table.column("scale")).max()),
            note="every sample of the chip, without the autopilot's calibration",
        )
        return [log_channel(where, table.name, quantity, at, values, clipped=clipped, chain=chain)]

    return read


def _increments(where: str, table: TopicTable) -> list[LogChannel]:
    found, at = [], _sample_times(table)
    for name, quantity in (("delta_velocity", SPECIFIC_FORCE), ("delta_angle", ANGULAR_VELOCITY)):
        if not table.has(name, f"{name}_dt"):
            continue
        span = table.column(f"{name}_dt") / 1e6
        with np.errstate(divide="ignore", invalid="ignore"):
            values = np.where(span > 0.0, table.column(name) / span, np.nan)
        clipped = None
        if table.has(f"{name}_clipping"):
            bits = table.rows[f"{name}_clipping"].astype(int)
            clipped = np.stack([bits >> k & 1 for k in range(3)], axis=1).astype(bool)
        chain = SensorChain(average=_mean_time(table, f"{name}_dt"))
        found.append(
            log_channel(
                where, f"{table.name}.{name}", quantity, at, vectors_in(FRD, values),
                clipped=clipped, chain=chain,
            )
        )  # fmt: skip
    return found


def _filtered(quantity: str, corner: str) -> Maker:
    """Reader of `vehicle_acceleration` or `vehicle_angular_velocity`, behind a low-pass."""

    def read(where: str, table: TopicTable) -> list[LogChannel]:
        values = vectors_in(FRD, table.column("xyz"))
        # A Butterworth filter of second order in either module (LowPassFilter2p).
        chain = SensorChain(
            low_pass=table.setting(corner), low_pass_order=2, note=f"behind {corner}"
        )
        return [log_channel(where, table.name, quantity, _sample_times(table), values, chain=chain)]

    return read


def _attitude(where: str, table: TopicTable) -> list[LogChannel]:
    resets = None
    if table.has("quat_reset_counter"):
        counts = table.column("quat_reset_counter")[:, 0]
        resets = np.diff(counts, prepend=counts[:1]) != 0.0
    values = attitudes_in(NED, FRD, table.column("q"))
    return [
        log_channel(
            where, table.name, ATTITUDE, _sample_times(table), values, resets=resets,
            chain=SensorChain(estimated=True),
        )
    ]  # fmt: skip


def _local(where: str, table: TopicTable) -> list[LogChannel]:
    resets = None
    if table.has("xy_reset_counter", "z_reset_counter"):
        counts = table.column("xy_reset_counter", "z_reset_counter")
        resets = (np.diff(counts, axis=0, prepend=counts[:1]) != 0.0).any(axis=1)
    at, chain = _sample_times(table), SensorChain(estimated=True)
    return [
        log_channel(
            where, f"{table.name}.{name}", quantity, at, vectors_in(NED, table.column(*axes)),
            resets=resets, chain=chain,
        )
        for name, quantity, axes in (
            ("position", POSITION, ("x", "y", "z")), ("velocity", VELOCITY, ("vx", "vy", "vz")),
        )
    ]  # fmt: skip


def _odometry(where: str, table: TopicTable) -> list[LogChannel]:
    """A pose that came over a link, of a motion capture for example."""
    place = ("position",) if table.has("position") else ("x", "y", "z")
    at = _sample_times(table)
    chain = SensorChain(note="came over a link: its delay and jitter are in the times")
    found = [
        log_channel(
            where, f"{table.name}.position", POSITION, at, vectors_in(NED, table.column(*place)),
            chain=chain,
        )
    ]  # fmt: skip
    if table.has("q"):
        q = table.column("q")
        q[np.abs(q).sum(axis=1) == 0.0] = np.nan
        if not np.isnan(q).any(axis=1).all():
            values = attitudes_in(NED, FRD, q)
            found.append(log_channel(where, f"{table.name}.q", ATTITUDE, at, values, chain=chain))
    return found


def _motors(where: str, table: TopicTable) -> list[LogChannel]:
    values = table.column("control")
    used = ~np.isnan(values).all(axis=0)
    if not used.any():
        return []
    at = _sample_times(table)
    return [log_channel(where, table.name, ROTOR_COMMAND, at, values[:, used])]


def _outputs(where: str, table: TopicTable) -> list[LogChannel]:
    count = int(np.median(table.column("noutputs")))
    values = table.column("output")[:, : max(count, 0)]
    if not values.size:
        return []
    chain = SensorChain(note="outputs to the motors, in the unit of the driver")
    return [log_channel(where, table.name, ROTOR_COMMAND, table.times, values, chain=chain)]


def _esc(where: str, table: TopicTable) -> list[LogChannel]:
    escs, count = table.rows["esc"], int(np.median(table.column("esc_count")))
    if "esc_rpm" not in (escs.dtype.names or ()) or not 0 < count <= escs.shape[1]:
        return []
    speeds = escs["esc_rpm"][:, :count].astype(float) * (2.0 * math.pi / 60.0)
    return [log_channel(where, table.name, ROTOR_SPEED, table.times, speeds)]


def _landed(where: str, table: TopicTable) -> list[LogChannel]:
    return [log_channel(where, table.name, LANDED, table.times, table.column("landed"))]


def _arm_length(where: str, table: TopicTable) -> list[LogChannel]:
    at = _sample_times(table)
    lengths, clipped = table.column("length"), None
    if table.has("clipped"):
        clipped = table.column("clipped") > 0.0
    return [log_channel(where, table.name, ARM_LENGTH, at, lengths, clipped=clipped)]


MAKERS: dict[str, tuple[Maker, tuple[str, ...]]] = {
    "sensor_combined": (_combined, ("accelerometer_m_s2", "gyro_rad")),
    "sensor_accel": (_raw(SPECIFIC_FORCE), ("x", "y", "z")),
    "sensor_gyro": (_raw(ANGULAR_VELOCITY), ("x", "y", "z")),
    "sensor_accel_fifo": (_fifo(SPECIFIC_FORCE), ()),
    "sensor_gyro_fifo": (_fifo(ANGULAR_VELOCITY), ()),
    "vehicle_imu": (_increments, ()),
    "vehicle_acceleration": (_filtered(SPECIFIC_FORCE, "IMU_ACCEL_CUTOFF"), ("xyz",)),
    "vehicle_angular_velocity": (_filtered(ANGULAR_VELOCITY, "IMU_GYRO_CUTOFF"), ("xyz",)),
    "vehicle_attitude": (_attitude, ("q",)),
    "vehicle_local_position": (_local, ("x", "y", "z", "vx", "vy", "vz")),
    "vehicle_visual_odometry": (_odometry, ()),
    "vehicle_mocap_odometry": (_odometry, ()),
    "actuator_motors": (_motors, ("control",)),
    "actuator_outputs": (_outputs, ("noutputs", "output")),
    "esc_status": (_esc, ("esc", "esc_count")),
    "vehicle_land_detected": (_landed, ("landed",)),
    "arm_length": (_arm_length, ("length",)),
}
"""Readers of topics, with the fields that they need; `arm_length` is springback's own."""


def channels_of(where: str, topics: list[Topic], parameters: Settings) -> list[LogChannel]:
    """Channels of topics of PX4.

    Raises:
        InputError: If the clock or a value of one cannot be.
    """
    found: list[LogChannel] = []
    names = [topic.name for topic in topics]
    for topic in topics:
        table = TopicTable(topic, parameters, names.count(topic.name) > 1)
        make, fields = MAKERS[topic.name]
        if table.has(*fields):
            try:
                found += make(where, table)
            except (KeyError, ValueError, IndexError, TypeError) as error:
                if isinstance(error, InputError):
                    raise
                raise InputError(
                    f"{where}: {table.name}: its fields are not those of PX4 "
                    f"({', '.join(topic.rows.dtype.names or ())[:200]})"
                ) from None
    return found


def read_px_log(path: Path, part: TimeSpan) -> Recording:
    """Recording of a ULog of PX4.

    Args:
        path: The log.
        part: Instants that are wanted, in seconds of its clock.

    Raises:
        InputError: If it is no ULog, or nothing of it can be used.
    """
    file = read_ulog(path, frozenset(MAKERS), part, Budget(str(path)))
    channels = channels_of(str(path), file.topics, file.parameters)
    seen = [*file.damage, *file.remarks]
    refuse_without_channels(str(path), channels, ", ".join(sorted(MAKERS)), seen)
    remarks = list(file.remarks)
    if "SENS_BOARD_ROT" in file.parameters and _board(file.parameters) is None:
        remarks.append(
            f"SENS_BOARD_ROT is {file.parameters['SENS_BOARD_ROT']:g}, which is not known: raw "
            "channels are left out"
        )
    return Recording(
        path, "ULog", tuple(channels), tuple(file.dropouts), file.parameters, tuple(remarks),
        damage=tuple(file.damage),
    )  # fmt: skip
