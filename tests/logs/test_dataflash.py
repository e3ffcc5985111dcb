"""Logs of ArduPilot, and its own reader beside ours."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from pymavlink.DFReader import DFReader_binary

from builders.recordings import GRAVITY, acceleration_at, attitude_at, dataflash, rate_at, track_at
from springback.errors import InputError
from springback.logs.frame_turns import conjugate, world_vectors
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import ATTITUDE, POSITION, ROTOR_COMMAND, VELOCITY


def written(tmp_path: Path, data: bytes) -> Path:
    (tmp_path / "log.bin").write_bytes(data)
    return tmp_path / "log.bin"


def test_inertial_data_attitudes_and_poses_are_in_flu_and_nwu(tmp_path: Path) -> None:
    log = read_recording(written(tmp_path, dataflash()))
    told = {one.name: one for one in log.channels}
    t = np.arange(400) / 400.0
    force = world_vectors(conjugate(attitude_at(t)), acceleration_at(t) + GRAVITY)
    imu = told["IMU.accelerometer"]
    assert imu.times == pytest.approx(1.0 + t, abs=1e-6)
    assert imu.values == pytest.approx(force, abs=1e-5)
    assert told["IMU.gyro"].values == pytest.approx(rate_at(t), abs=1e-5)
    assert told["VISP.position"].values == pytest.approx(track_at(t[::4]), abs=1e-5)
    assert told["VISP.attitude"].values == pytest.approx(attitude_at(t[::4]), abs=1e-6)
    assert told["ATT"].values == pytest.approx(
        attitude_at(t[::4]), abs=2e-4
    )  # hundredths of a degree
    assert told["ATT"].quantity == ATTITUDE
    assert told["ATT"].chain.estimated
    assert told["XKF1.position"].quantity == POSITION
    assert told["XKF1.velocity"].quantity == VELOCITY
    assert told["RCOU"].quantity == ROTOR_COMMAND
    assert told["RCOU"].values[0].tolist() == [1500.0, 1501.0, 1502.0, 1503.0]
    assert log.parameters == {
        "INS_ACC_ID": 1.5, "INS_ACCEL_FILTER": 20.0, "INS_GYRO_FILTER": 0.0,
    }  # fmt: skip


def test_inertial_data_are_behind_the_filters_that_the_parameters_tell(tmp_path: Path) -> None:
    """`IMU` has what the control loops get; zero switches a filter off."""
    log = read_recording(written(tmp_path, dataflash()))
    told = {one.name: one.chain for one in log.channels}
    force, gyro = told["IMU.accelerometer"], told["IMU.gyro"]
    assert (force.low_pass, force.low_pass_order) == (20.0, 2)
    assert (gyro.low_pass, gyro.low_pass_order) == (None, 2)


def test_ardupilots_own_reader_reads_the_same(tmp_path: Path) -> None:
    path = written(tmp_path, dataflash(40))
    log = read_recording(path)
    other, rows = DFReader_binary(str(path)), []
    while (message := other.recv_match(type="IMU")) is not None:
        rows.append([message.AccX, -message.AccY, -message.AccZ])
    other.data_map.close()
    other.filehandle.close()
    imu = next(one for one in log.channels if one.name == "IMU.accelerometer")
    assert imu.values == pytest.approx(np.array(rows), rel=1e-6)


def test_a_part_is_read(tmp_path: Path) -> None:
    path = written(tmp_path, dataflash())
    log = read_recording(path, LogOptions(first=1.5, last=1.75))
    assert all(one.times[0] >= 1.5 and one.times[-1] <= 1.75 for one in log.channels)


def test_a_log_that_is_cut_off_or_damaged_is_read_as_far_as_it_goes(tmp_path: Path) -> None:
    data = dataflash()
    log = read_recording(written(tmp_path, data[:-10]))
    assert len(log.damage) == 1
    said = re.fullmatch(
        r"the log ends within a message, at byte (\d+), 1\.99\d s by its clock: it was cut off",
        log.damage[0],
    )
    assert said
    assert len(data) - 100 < int(said[1]) < len(data) - 10
    at = len(data) // 2
    log = read_recording(written(tmp_path, data[:at] + bytes(100) + data[at:]))
    imu = next(one for one in log.channels if one.name == "IMU.accelerometer")
    assert len(imu.times) >= 399
    assert "damaged in" in " ".join(log.damage)


@pytest.mark.parametrize(
    ("data", "said"),
    [(b"", "is empty"), (b"text", "is no binary log of ArduPilot"),
     (dataflash(1)[: 8 * 89], "has nothing that can be used")],
)  # fmt: skip
def test_what_is_no_log_is_refused_in_a_line(tmp_path: Path, data: bytes, said: str) -> None:
    with pytest.raises(InputError, match=said) as refused:
        read_recording(written(tmp_path, data))
    assert len(refused.value.problems) == 1
