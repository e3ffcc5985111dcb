"""A simulated flight, written and read back: the same numbers to 1e-6, in every format."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import springback
from builders.recordings import raw_ulog, whole
from springback.errors import InputError
from springback.logs.formats.ros import RosCollector
from springback.logs.overview import overview
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ARM_LENGTH,
    POSITION,
    SPECIFIC_FORCE,
    Recording,
    TimeSpan,
)
from springback.logs.writing.flight_recording import flight_recording
from springback.logs.writing.writers import WRITERS, write_recording

SCENARIO = {
    "vehicle": "arq", "thrust": "hover",
    "world": {"obstacles": [{"type": "wall", "distance": "2.75 m", "surface": "wall"}]},
    "start": {
        "position": ["1.4 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0],
        "angular_velocity": [0.1, 0.2, 0.3],
    },
    "simulation": {"duration": "1 s"}, "sensors": {"imu": {"rate": "1 kHz"}},
}  # fmt: skip


@pytest.fixture(scope="module")
def flown() -> springback.Flight:
    return springback.fly(SCENARIO)


@pytest.fixture(scope="module")
def flight(flown: springback.Flight) -> Recording:
    return flight_recording(flown, Path("flight"))


def test_a_flights_recording_is_what_its_sensors_gave(
    flown: springback.Flight, flight: Recording
) -> None:
    force, place = flight.best(SPECIFIC_FORCE), flight.best(POSITION)
    assert force is not None
    assert place is not None
    assert force.values[:, 0].tolist() == flown.telemetry["imu_ax"].tolist()
    assert force.chain.full_scale == pytest.approx(16.0 * 9.80665)
    assert force.chain.low_pass == 218.1
    truth = np.interp(place.times, flown.t, flown.columns["x"])
    assert place.values[:, 0] == pytest.approx(truth, abs=4e-3)  # at the instants that they are of
    lengths = flight.best(ARM_LENGTH)
    assert lengths is not None
    assert lengths.rate == pytest.approx(200.0)
    arms = np.stack(
        [np.interp(lengths.times, flown.t, flown.columns[f"l{j}"]) for j in (1, 2, 3, 4)], axis=1
    )
    assert lengths.values == pytest.approx(arms, abs=5e-4)  # counts of the converter
    assert np.ptp(arms, axis=0).max() > 5e-3


def test_the_impact_of_a_flight_is_found_where_it_was(
    flown: springback.Flight, flight: Recording
) -> None:
    found = overview([flight])
    first = found.impacts[0]
    assert first.refused == ""
    touch = flown.measures["touch_time"]
    assert first.touch == pytest.approx(touch, abs=0.004)
    assert first.normal is not None
    assert first.normal[0] < -0.8
    assert all(one.passed for one in found.findings), found.findings


@pytest.mark.parametrize("word", WRITERS)
def test_what_is_read_back_equals_what_was_flown_to_1e_6(
    flight: Recording, tmp_path: Path, word: str
) -> None:
    path = tmp_path / f"flight{WRITERS[word][0]}"
    left_out = write_recording(flight, path, word)
    back = read_recording(path.with_suffix(".toml") if word == "table" else path)
    assert len(back.channels) + len(left_out) == len(flight.channels)
    assert len(back.channels) == (2 if word in ("motive", "vicon", "qualisys") else 5)
    for one in back.channels:
        made = flight.best(one.quantity)
        assert made is not None
        assert one.times == pytest.approx(made.times, abs=1e-6)
        assert one.values == pytest.approx(made.values, rel=1e-6, abs=1e-6)
        assert is_same(one.clipped, made.clipped)


def is_same(flags: Any, others: Any) -> bool:
    """True for equal flags, or none of both."""
    if flags is None or others is None:
        return flags is others
    return np.array_equal(flags, others)


CLIPS = {
    **SCENARIO, "sensors": {
        "imu": {
            "rate": "1 kHz", "accelerometer": {"full_scale": "15 m/s^2"},
            "gyroscope": {"full_scale": "0.25 rad/s"},
        },
        "hall": {"overrun": 0.0},
    },
}  # fmt: skip


@pytest.fixture(scope="module")
def clipped() -> Recording:
    return flight_recording(springback.fly(CLIPS), Path("flight"))


@pytest.mark.parametrize("word", ["ulog", "mcap", "table"])
def test_flags_of_clipped_samples_are_read_back(
    clipped: Recording, tmp_path: Path, word: str
) -> None:
    """Of a flight that leaves all ranges; then any flags, from the first sample to the last."""
    rng, some = np.random.default_rng(5), []
    for one in clipped.channels:
        if one.clipped is None:
            some.append(one)
            continue
        assert one.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY, ARM_LENGTH)
        flags = rng.random(one.values.shape) < 0.3
        flags[0], flags[-1] = True, True
        some.append(replace(one, clipped=flags))
    for number, made in enumerate((clipped, replace(clipped, channels=tuple(some)))):
        path = tmp_path / f"flight{number}{WRITERS[word][0]}"
        assert write_recording(made, path, word) == []
        back = read_recording(path.with_suffix(".toml") if word == "table" else path)
        told = 0
        for one in made.channels:
            [again] = [two for two in back.channels if two.quantity == one.quantity]
            assert is_same(again.clipped, one.clipped), one.name
            told += one.clipped is not None and bool(one.clipped.any())
        assert told == 3


def test_flags_of_a_bag_follow_its_body_axes(clipped: Recording, tmp_path: Path) -> None:
    """In a body of right, front, up the first axis of the file is the second."""
    path = tmp_path / "flight.mcap"
    write_recording(clipped, path)
    [force] = read_recording(path, LogOptions(body="rfu")).of(SPECIFIC_FORCE)
    made = clipped.best(SPECIFIC_FORCE)
    assert made is not None
    assert made.clipped is not None
    assert np.array_equal(force.clipped, made.clipped[:, [1, 0, 2]])
    assert not np.array_equal(force.clipped, made.clipped)


def test_flags_of_samples_that_a_bag_has_lost_are_not_those_of_others(tmp_path: Path) -> None:
    """By their instants, in whatever order they come."""
    collector = RosCollector("bag", TimeSpan(), "enu", "flu")
    kind = "sensor_msgs/msg/JointState"

    def add(topic: str, time: int, names: list[str], values: list[float]) -> None:
        header = SimpleNamespace(stamp=SimpleNamespace(sec=time, nanosec=0))
        message = SimpleNamespace(header=header, name=names, position=values, effort=[])
        collector.add(topic, kind, message, float(time))

    for time in (4, 1, 2):
        add("/arm_lengths/clipped", time, [".0", ".1"], [float(time != 2), float(time == 4)])
    for time in (1, 2, 3, 4):
        add("/arm_lengths", time, ["arm1", "arm2"], [0.1, 0.1])
    [lengths] = collector.channels()
    assert lengths.clipped is not None
    assert lengths.clipped.astype(int).tolist() == [[1, 0], [0, 0], [0, 0], [1, 1]]


def test_a_flight_without_sensors_is_refused(tmp_path: Path) -> None:
    bare = springback.fly({key: value for key, value in SCENARIO.items() if key != "sensors"})
    with pytest.raises(
        InputError, match=r"flight: has no readings of sensors; give the scenario a"
    ):
        flight_recording(bare, Path("flight"))


@pytest.mark.parametrize(
    ("name", "word", "said"),
    [
        ("a.txt", None, r"must end in one of \.csv, \.mcap, \.tsv, \.ulg \(got '\.txt'\)"),
        ("a.csv", "ulog", r"must end in \.ulg, as files of ulog do"),
        ("none/a.ulg", None, "cannot be written"),
    ],
)
def test_what_cannot_be_written_is_refused(
    tmp_path: Path, name: str, word: str | None, said: str
) -> None:
    with pytest.raises(InputError, match=said):
        write_recording(whole(1.0, 200.0), tmp_path / name, word)
    assert list(tmp_path.iterdir()) == []


def test_frames_off_an_even_grid_cannot_be_vicons(tmp_path: Path) -> None:
    made = whole(1.0, 200.0)
    late = [replace(one, times=one.times + 0.0021) for one in made.channels]
    with pytest.raises(InputError, match="its frames are not at multiples of 5 ms"):
        write_recording(replace(made, channels=tuple(late)), tmp_path / "a.csv", "vicon")


#: Reads a log, and prints the most memory that it took [KiB], which Linux tells.
READS = (
    "import sys; from pathlib import Path; from springback.logs.reading import read_recording;"
    "from springback.logs.overview import overview;"
    "found = overview([read_recording(sys.argv[1])]); print(len(found.channels));"
    "[peak] = [l for l in Path('/proc/self/status').read_text().splitlines() if 'VmHWM' in l];"
    "print(peak.split()[1])"
)


def test_a_large_log_is_streamed(tmp_path: Path) -> None:
    """600 MB of messages that are not wanted, among those that are: memory stays far below."""
    rows = np.zeros(200, dtype=[("timestamp", "<u8"), ("x", "<f4", (3,))])
    rows["timestamp"] = 10**6 + 5000 * np.arange(200)
    rows["x"][:, 2] = -9.8
    small = raw_ulog({"vehicle_acceleration": ("uint64_t timestamp;float[3] xyz;", rows)})
    other = (60_000).to_bytes(2, "little") + b"D" + (99).to_bytes(2, "little") + bytes(59_998)
    with (tmp_path / "large.ulg").open("wb") as file:
        file.write(small)
        for _ in range(10_000):
            file.write(other)
    done = subprocess.run(
        [sys.executable, "-c", READS, str(tmp_path / "large.ulg")],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    channels, used = map(int, done.stdout.split())
    assert channels == 1
    assert used < 150 * 1024, f"{used} KiB"
