"""Units of time that are mistaken: which are found, by what, and what is left alone."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from builders.cases import nonempty
from builders.recordings import inertial, poses, recording, whole
from springback.errors import InputError
from springback.logs.overview import missing_for_impact, overview
from springback.logs.reading import read_recording
from springback.logs.recording import VELOCITY, LogChannel, Recording, log_channel
from springback.logs.time_units import refuse_time_units, time_factor
from springback.logs.writing.writers import write_recording


def slower(factor: float, *channels: LogChannel) -> list[LogChannel]:
    return [replace(one, times=factor * one.times) for one in channels]


@pytest.mark.parametrize(
    ("factor", "way"),
    [(1e3, "1000 times too long"), (1e6, "1e+06 times too long"), (1e-3, "1000 times too short")],
)
def test_a_log_whose_clocks_all_run_wrong_is_refused_with_the_factor(
    factor: float, way: str
) -> None:
    """Not its gyroscope nor its positions, which such a clock makes a thousand times too fast."""
    log = recording(*slower(factor, *inertial(), *poses()))
    said = (
        rf"^made: accelerometer, gyroscope, vehicle\.position, vehicle\.attitude: their times are "
        rf"probably {way.replace('+', '[+]')}: \S+ and \S+ Hz would be 200 and 1000 Hz; so rates "
        r"of turn of vehicle.attitude and gyroscope agree \((0\.99\d|1\.000)\)$"
    )
    for refuse in (refuse_time_units, overview):
        with pytest.raises(InputError, match=said):
            refuse([log])
    refuse_time_units([recording(*inertial(), *poses())])


@pytest.mark.parametrize("turns", [True, False])
def test_one_clock_that_runs_a_thousand_times_too_slow_is_refused(turns: bool) -> None:
    """By the turns that agree with its times in ms; else as both then last equally long."""
    force, gyro = inertial()
    held = gyro if turns else replace(gyro, values=0.0 * gyro.values)
    log = recording(force, held, *slower(1e3, *poses()))
    reason = (
        "rates of turn of vehicle.attitude and gyroscope agree" if turns else "it lasts 4 s, as"
    )
    said = rf"^made: vehicle.position, vehicle.attitude: .* 0\.2 Hz would be 200 Hz; so {reason}"
    with pytest.raises(InputError, match=said):
        refuse_time_units([log])
    two = [recording(force, held, path="imu"), recording(*slower(1e3, *poses()), path="take")]
    with pytest.raises(InputError, match=r"^take: vehicle\.position"):
        refuse_time_units(two)


def test_a_track_whose_velocity_is_another_is_of_another_unit_of_time() -> None:
    place, _ = poses()
    speed = log_channel(
        "made", "vehicle.velocity", VELOCITY, place.times[1:],
        np.diff(place.values, axis=0) / 0.005, clock=place.clock,
    )  # fmt: skip
    log = recording(*slower(1e3, place, speed))
    with pytest.raises(InputError, match=r"so vehicle\.position moves at 1\.\d+ m/s, as vehicle.v"):
        refuse_time_units([log])


def test_slow_and_fast_logs_that_are_right_are_left_alone() -> None:
    """Positions of 5 Hz, a FIFO of 32 kHz, stamps of arrival in bursts."""
    force, gyro = inertial()
    place, attitude = poses()
    slow = [replace(one, times=one.times[::40], values=one.values[::40])
            for one in (place, attitude)]  # fmt: skip
    refuse_time_units([recording(force, gyro, *slow)])
    t = np.arange(32000) / 32000.0
    refuse_time_units(
        [recording(log_channel("made", "fifo", force.quantity, t, np.ones((32000, 3))))]
    )
    bursts = np.repeat(np.arange(0.0, 4.0, 0.05), 10) + np.tile(1e-6 * np.arange(10), 80)
    late = replace(place, times=bursts, values=place.values[:800])
    assert time_factor(late) == 1.0
    for one in nonempty(whole().channels):
        assert time_factor(one) == 1.0


def test_an_inertial_unit_that_is_slow_alone_is_not_refused_but_doubted() -> None:
    """Nothing else tells: its times may be right, of a log that shows no impact anyway."""
    log = recording(*slower(1e3, *inertial()))
    refuse_time_units([log])
    [said] = [one for one in missing_for_impact([log]) if "fastest acceleration" in one]
    assert "has 1 Hz: 0 samples in a contact" in said
    assert "or its times are in another unit: 1000 times shorter they have 1000 Hz" in said


@pytest.mark.parametrize(
    ("unit", "factor", "said"),
    [("s", 1e3, "probably in ms, not in s:"), ("us", 1e3, "probably in ms, not in us:"),
     ("ms", 1e6, "probably in us, not in ms:")],
)  # fmt: skip
def test_a_mapping_with_a_wrong_unit_of_time_is_told_the_right_one(
    tmp_path: Path, unit: str, factor: float, said: str
) -> None:
    """The table's times are in units of 1/factor seconds, and the mapping says another unit."""
    log = whole(2.0)
    scaled = Recording(log.path, log.format, tuple(slower(factor, *log.channels)))
    write_recording(scaled, tmp_path / "flight.csv")
    mapping = (tmp_path / "flight.toml").read_text()
    mapping = mapping.replace("[[channels]]\n", f'[[channels]]\ntime_unit = "{unit}"\n')
    (tmp_path / "flight.toml").write_text(mapping)
    with pytest.raises(InputError, match=said):
        refuse_time_units([read_recording(tmp_path / "flight.toml")])
    right = said.split()[2].rstrip(",")
    (tmp_path / "flight.toml").write_text(mapping.replace(f'= "{unit}"\n', f'= "{right}"\n'))
    refuse_time_units([read_recording(tmp_path / "flight.toml")])
