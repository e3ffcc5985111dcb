"""ULog of PX4: real topics, damage, and PX4's own reader beside ours."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pyulog import ULog

from builders.recordings import files, raw_ulog, whole
from springback.errors import InputError
from springback.interfaces.cli.identify.logs import FORMATS
from springback.logs.overview import overview
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import (
    ATTITUDE,
    LANDED,
    POSITION,
    ROTOR_COMMAND,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
)
from springback.logs.writing.writers import WRITERS, write_recording

HERE = Path(__file__).parent
COUNT = 50


def rows(**columns: tuple[str, Any]) -> np.ndarray:
    """Rows of 200 Hz, from 1 s on."""
    kinds: list[Any] = [("timestamp", "<u8")]
    kinds += [(name, code, np.shape(value)[1:]) for name, (code, value) in columns.items()]
    found = np.zeros(COUNT, dtype=kinds)
    found["timestamp"] = 1_000_000 + 5000 * np.arange(COUNT)
    for name, (_, value) in columns.items():
        found[name] = value
    return found


def read(tmp_path: Path, data: bytes, **options: Any):
    path = tmp_path / "log.ulg"
    path.write_bytes(data)
    return read_recording(path, LogOptions(**options))


COMBINED = (
    "uint64_t timestamp;float[3] gyro_rad;uint32_t gyro_integral_dt;"
    "int32_t accelerometer_timestamp_relative;float[3] accelerometer_m_s2;"
    "uint32_t accelerometer_integral_dt;uint8_t accelerometer_clipping;"
)


def combined(clipping: int = 0, relative: int = 0) -> np.ndarray:
    return rows(
        gyro_rad=("<f4", np.tile([0.1, 0.2, 0.3], (COUNT, 1))),
        gyro_integral_dt=("<u4", np.full(COUNT, 5000)),
        accelerometer_timestamp_relative=("<i4", np.full(COUNT, relative)),
        accelerometer_m_s2=("<f4", np.tile([1.0, 2.0, -9.8], (COUNT, 1))),
        accelerometer_integral_dt=("<u4", np.full(COUNT, 4840)),
        accelerometer_clipping=("u1", np.full(COUNT, clipping)),
    )


def test_means_of_the_inertial_unit_are_in_flu_with_their_time_of_integration(
    tmp_path: Path,
) -> None:
    """Bits of clipping are x 1, y 2, z 4."""
    log = read(tmp_path, raw_ulog({"sensor_combined": (COMBINED, combined(5, -1250))}))
    force, gyro = log.channels
    assert force.values[0] == pytest.approx([1.0, -2.0, 9.8])
    assert gyro.values[0] == pytest.approx([0.1, -0.2, -0.3])
    assert (force.chain.average, gyro.chain.average) == (0.00484, 0.005)
    assert (force.times[0], gyro.times[0]) == (0.99875, 1.0)
    assert force.clipped is not None
    assert force.clipped[0].tolist() == [True, False, True]
    unknown = read(tmp_path, raw_ulog({"sensor_combined": (COMBINED, combined(0, 0x7FFFFFFF))}))
    assert unknown.channels[0].times[0] == 1.0


FILTERED = "uint64_t timestamp;uint64_t timestamp_sample;float[3] xyz;"


def test_what_the_controllers_get_is_behind_filters_of_second_order(tmp_path: Path) -> None:
    """PX4's VehicleAcceleration and VehicleAngularVelocity have a LowPassFilter2p each."""
    given = rows(
        timestamp_sample=("<u8", 999_000 + 5000 * np.arange(COUNT)),
        xyz=("<f4", np.tile([1.0, 2.0, -9.8], (COUNT, 1))),
    )
    names = ("vehicle_acceleration", "vehicle_angular_velocity")
    topics = dict.fromkeys(names, (FILTERED, given))
    corners = {"IMU_ACCEL_CUTOFF": 30.0, "IMU_GYRO_CUTOFF": 0.0}
    log = read(tmp_path, raw_ulog(topics, corners))
    told = {one.name: one.chain for one in log.channels}
    force, gyro = told["vehicle_acceleration"], told["vehicle_angular_velocity"]
    assert (force.low_pass, force.low_pass_order) == (30.0, 2)
    assert (gyro.low_pass, gyro.low_pass_order) == (None, 2)


FIFO = (
    "uint64_t timestamp;uint64_t timestamp_sample;uint32_t device_id;float dt;float scale;"
    "uint8_t samples;int16_t[32] x;int16_t[32] y;int16_t[32] z;uint8_t[5] _padding0;"
)


def fifo() -> np.ndarray:
    """Ten samples a message, 0.5 ms apart, the last at the message's own sample time."""
    count = np.zeros((COUNT, 32), dtype=np.int16)
    count[:, :10] = np.arange(10) * 100
    count[3, 9] = 32767
    return rows(
        timestamp_sample=("<u8", 999_000 + 5000 * np.arange(COUNT)),
        device_id=("<u4", np.ones(COUNT)), dt=("<f4", np.full(COUNT, 500.0)),
        scale=("<f4", np.full(COUNT, 0.01)), samples=("u1", np.full(COUNT, 10)),
        x=("<i2", count), y=("<i2", count), z=("<i2", -count),
    )  # fmt: skip


def test_every_sample_of_the_chip_has_its_own_time(tmp_path: Path) -> None:
    log = read(tmp_path, raw_ulog({"sensor_accel_fifo": (FIFO, fifo())}))
    [force] = log.channels
    assert force.quantity == SPECIFIC_FORCE
    assert len(force.times) == 10 * COUNT
    assert force.rate == pytest.approx(2000.0)
    assert force.times[[0, 9, 10]] == pytest.approx([0.9945, 0.999, 0.9995])
    assert force.values[3] == pytest.approx([3.0, -3.0, 3.0])
    assert force.chain.full_scale == pytest.approx(327.68)
    assert force.clipped is not None
    assert np.flatnonzero(force.clipped[:, 0]).tolist() == [39]


def test_counts_without_a_scale_are_refused(tmp_path: Path) -> None:
    old = fifo()[["timestamp", "timestamp_sample", "device_id", "dt", "samples", "x", "y", "z"]]
    packed = np.zeros(
        len(old), dtype=[(n, old.dtype[n].base, old.dtype[n].shape) for n in old.dtype.names or ()]
    )
    for name in old.dtype.names or ():
        packed[name] = old[name]
    with pytest.raises(
        InputError, match="sensor_accel_fifo: has no scale, as in logs of PX4 before"
    ):
        read(tmp_path, raw_ulog({"sensor_accel_fifo": (FIFO.replace("float scale;", ""), packed)}))


RAW = (
    "uint64_t timestamp;uint64_t timestamp_sample;float x;float y;float z;uint8_t[3] clip_counter;"
)


@pytest.mark.parametrize(
    ("rotation", "expected"),
    [(0, [1.0, -2.0, 9.0]), (4, [-1.0, 2.0, 9.0]), (2, [-2.0, -1.0, 9.0]), (8, [1.0, 2.0, -9.0])],
)
def test_raw_samples_are_turned_by_the_boards_rotation(
    tmp_path: Path, rotation: int, expected: list[float]
) -> None:
    """4 is a yaw of 180°, 2 one of 90°, 8 a roll of 180°, before FRD becomes FLU.

    Counts of clipped samples are those of each message: PX4's drivers begin each at zero.
    """
    counts = np.zeros((COUNT, 3))
    counts[[0, 10, 11, 12], 0] = 1, 1, 1, 8
    data = rows(
        timestamp_sample=("<u8", 1_000_000 + 5000 * np.arange(COUNT)),
        x=("<f4", np.full(COUNT, 1.0)), y=("<f4", np.full(COUNT, 2.0)),
        z=("<f4", np.full(COUNT, -9.0)), clip_counter=("u1", counts),
    )  # fmt: skip
    log = read(tmp_path, raw_ulog({"sensor_accel": (RAW, data)}, {"SENS_BOARD_ROT": rotation}))
    [force] = log.channels
    assert force.values[0] == pytest.approx(expected, abs=1e-6)
    assert force.clipped is not None
    axis = 1 if rotation == 2 else 0
    assert np.argwhere(force.clipped).tolist() == [[0, axis], [10, axis], [11, axis], [12, axis]]


def test_an_unknown_rotation_leaves_raw_samples_out_and_says_so(tmp_path: Path) -> None:
    topics = {
        "sensor_combined": (COMBINED, combined()),
        "sensor_accel": (RAW, rows(
            timestamp_sample=("<u8", np.ones(COUNT)), x=("<f4", np.ones(COUNT)), y=("<f4", np.ones(COUNT)),
            z=("<f4", np.ones(COUNT)), clip_counter=("u1", np.zeros((COUNT, 3))),
        )),
    }  # fmt: skip
    log = read(tmp_path, raw_ulog(topics, {"SENS_BOARD_ROT": 99}))
    assert [one.name for one in log.channels] == [
        "sensor_combined.accelerometer",
        "sensor_combined.gyro",
    ]
    assert "SENS_BOARD_ROT is 99" in log.remarks[0]


def test_estimates_turns_motors_and_landings_are_read(tmp_path: Path) -> None:
    half = np.sqrt(0.5)
    position = np.stack([0.1 * np.arange(COUNT), np.zeros(COUNT), -np.ones(COUNT)], axis=1)
    control = np.full((COUNT, 12), np.nan)
    control[:, :4] = 0.5
    reports = np.zeros((COUNT, 8), dtype=[("timestamp", "<u8"), ("esc_rpm", "<i4")])
    reports["esc_rpm"] = 3000
    topics = {
        "esc_report": ("uint64_t timestamp;int32_t esc_rpm;", np.zeros(0)),
        "vehicle_attitude": (
            "uint64_t timestamp;float[4] q;uint8_t quat_reset_counter;",
            rows(q=("<f4", np.tile([half, 0.0, 0.0, half], (COUNT, 1))),
                 quat_reset_counter=("u1", (np.arange(COUNT) > 20).astype(int))),
        ),
        "vehicle_visual_odometry": (
            "uint64_t timestamp;uint64_t timestamp_sample;uint8_t pose_frame;float[3] position;float[4] q;",
            rows(timestamp_sample=("<u8", 980_000 + 5000 * np.arange(COUNT)), pose_frame=("u1", np.ones(COUNT)),
                 position=("<f4", position), q=("<f4", np.full((COUNT, 4), np.nan))),
        ),
        "actuator_motors": (
            "uint64_t timestamp;float[12] control;", rows(control=("<f4", control)),
        ),
        "esc_status": (
            "uint64_t timestamp;uint8_t esc_count;esc_report[8] esc;",
            rows(esc_count=("u1", np.full(COUNT, 4)), esc=(reports.dtype, reports)),
        ),
        "vehicle_land_detected": ("uint64_t timestamp;bool landed;", rows(landed=("u1", np.ones(COUNT)))),
    }  # fmt: skip
    log = read(tmp_path, raw_ulog(topics))
    told = {one.quantity: one for one in log.channels}
    # a yaw of 90 deg to the right in NED is one of -90 deg in NWU
    assert told[ATTITUDE].values[0] == pytest.approx([half, 0.0, 0.0, -half])
    assert told[ATTITUDE].chain.estimated
    assert told[ATTITUDE].resets is not None
    assert np.flatnonzero(told[ATTITUDE].resets).tolist() == [21]
    assert told[POSITION].values[10] == pytest.approx([1.0, 0.0, 1.0])
    assert told[POSITION].times[0] == pytest.approx(0.98)
    assert not told[POSITION].chain.estimated
    assert told[ROTOR_COMMAND].values.shape == (COUNT, 4)
    assert told[ROTOR_SPEED].values[0] == pytest.approx([100.0 * np.pi] * 4)
    assert told[LANDED].values.all()
    assert "vehicle_visual_odometry.q" not in {one.name for one in log.channels}


def test_a_part_of_a_log_is_read(tmp_path: Path) -> None:
    data = raw_ulog({"sensor_combined": (COMBINED, combined())})
    log = read(tmp_path, data, first=1.05, last=1.1)
    assert log.channels[0].span == (1.05, 1.1)
    with pytest.raises(InputError, match=r"--from 3 s must be before --until 2 s"):
        read(tmp_path, data, first=3.0, last=2.0)


def test_a_log_that_is_cut_off_is_read_as_far_as_it_goes(tmp_path: Path) -> None:
    data = raw_ulog({"sensor_combined": (COMBINED, combined())})
    log = read(tmp_path, data[:-20])
    assert len(log.channels[0].times) == COUNT - 1
    place = len(data) - (3 + 2 + combined().itemsize)  # the last message, which is not whole
    last = log.channels[0].times[-1]
    assert log.damage == (
        f"the log ends within a message, at byte {place}, {last:.3f} s by its clock: it was cut "
        "off",
    )


def test_a_damaged_log_is_read_on_from_the_next_sync_message(tmp_path: Path) -> None:
    data = raw_ulog({"sensor_combined": (COMBINED, combined())})
    size = 3 + 2 + combined().itemsize
    at = len(data) - 20 * size
    sync = bytes((0x2F, 0x73, 0x13, 0x20, 0x25, 0x0C, 0xBB, 0x12))
    message = struct.pack("<H", 8) + b"S" + sync
    broken = (
        data[:at] + b"\xff\xff\xff\xff" + data[at : at + 5 * size] + message + data[at + 5 * size :]
    )
    log = read(tmp_path, broken)
    assert len(log.channels[0].times) == COUNT - 5
    assert log.damage == ("the log is damaged in 1 places, which were skipped",)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "is empty"),
        (b"ULog", "is no ULog"),
        (b"\x89PNG" * 10, "is no ULog (its first bytes are b'\\\\x89PNG"),
        (raw_ulog({}), "has nothing that can be used; known are actuator_motors"),
        (raw_ulog({})[:16] + struct.pack("<H", 40) + b"B" + bytes(8) + b"\2" + bytes(31), "needs a newer reader"),
    ],
)  # fmt: skip
def test_what_is_no_log_is_refused_in_a_line(tmp_path: Path, data: bytes, said: str) -> None:
    with pytest.raises(InputError, match=said.replace("(", r"\(")) as refused:
        read(tmp_path, data)
    assert len(refused.value.problems) == 1


def test_what_is_written_is_read_by_px4s_own_reader(tmp_path: Path) -> None:
    (tmp_path / "log.ulg").write_bytes(files()["ulog.ulg"])
    log = ULog(str(tmp_path / "log.ulg"))
    assert not log.file_corruption
    made = whole(1.0, 200.0)
    accel = next(one for one in log.data_list if one.name == "sensor_accel").data
    force = made.channels[0].values
    assert accel["x"] == pytest.approx(force[:, 0], rel=1e-6)
    assert accel["y"] == pytest.approx(-force[:, 1], rel=1e-6)
    assert accel["z"] == pytest.approx(-force[:, 2], rel=1e-6)
    pose = next(one for one in log.data_list if one.name == "vehicle_visual_odometry").data
    assert pose["position[2]"] == pytest.approx(-made.best(POSITION).values[:, 2], abs=1e-6)  # type: ignore[union-attr]
    assert log.initial_parameters == {"SENS_BOARD_ROT": 0}


def test_a_real_log_is_read_as_px4s_own_reader_does() -> None:
    """An extract of the sample log of PX4/pyulog (see px4_at_rest.md)."""
    path = HERE / "px4_at_rest.ulg"
    found, log = read_recording(path), ULog(str(path))
    accel = next(one for one in log.data_list if one.name == "sensor_combined").data
    force = next(one for one in found.channels if one.name == "sensor_combined.accelerometer")
    assert force.times == pytest.approx(accel["timestamp"] / 1e6)
    assert force.values[:, 2] == pytest.approx(-accel["accelerometer_m_s2[2]"], rel=1e-6)


def test_a_real_log_at_rest_has_no_impact_and_could_not_have_shown_one() -> None:
    found = overview([read_recording(HERE / "px4_at_rest.ulg")])
    assert found.verdict == (
        "no impact, and this log could not have shown one: sensor_combined.accelerometer has "
        "205 Hz, each sample a mean over 4.89 ms: 6 samples in a contact of 31 ms; "
        "sensor_combined.accelerometer has a gap of 161 ms at 20.327 s, into which a contact of "
        "31 ms fits 5 times; the vehicle rests from begin to end"
    )
    assert all(one.passed for one in found.findings)
    said = {one.name: one.sentence for one in found.findings}
    assert said["sensor_combined.accelerometer"].startswith("+9.62 m/s^2 along z at rest (-1.9 %")
    assert "its logger noted a loss of 30 ms at 19.501 s" in found.remarks[0]


def test_the_command_knows_the_formats_that_are_written() -> None:
    assert set(FORMATS) == set(WRITERS)


def test_a_time_before_zero_cannot_be_written(tmp_path: Path) -> None:
    from dataclasses import replace

    made = whole(1.0, 200.0)
    early = replace(made.channels[0], times=made.channels[0].times - 5.0)
    with pytest.raises(InputError, match="ULog has no times before 0"):
        write_recording(replace(made, channels=(early,)), tmp_path / "log.ulg")
    assert list(tmp_path.iterdir()) == []
