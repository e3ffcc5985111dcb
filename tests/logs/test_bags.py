"""Bags of ROS 1 and 2 and MCAP: decoded, streamed, damaged; and ROS's own readers beside ours."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
import pytest
from mcap.writer import Writer
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from builders.recordings import files, first_bag, whole
from springback.errors import InputError
from springback.logs.formats.bags import is_harmless
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import ANGULAR_VELOCITY, ATTITUDE, POSITION, SPECIFIC_FORCE

NAMES = ("mcap.mcap", "bag.db3")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in (*NAMES, "first.bag"):
        (tmp_path / name).write_bytes(files()[name])
    return tmp_path


@pytest.mark.parametrize("name", NAMES)
def test_a_bag_of_ros_2_is_read_as_it_was_written(folder: Path, name: str) -> None:
    made, log = whole(1.0, 200.0), read_recording(folder / name)
    for quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY, POSITION, ATTITUDE):
        one, other = made.best(quantity), log.best(quantity)
        assert one is not None
        assert other is not None
        assert other.times == pytest.approx(one.times, abs=1e-9)
        assert other.values == pytest.approx(one.values, abs=1e-12)
    assert log.remarks == ()


def test_a_folder_is_a_bag_of_ros_2(folder: Path) -> None:
    bag = folder / "bag"
    bag.mkdir()
    (folder / "bag.db3").rename(bag / "bag_0.db3")
    assert len(read_recording(bag).channels) == 6
    (bag / "bag_0.db3").rename(folder / "elsewhere.db3")
    with pytest.raises(InputError, match=r"has no files \.db3 or \.mcap"):
        read_recording(bag)


def test_a_bag_of_ros_1_is_in_enu_and_has_the_times_of_its_headers(folder: Path) -> None:
    """Arrival is 1 ms later."""
    made, log = whole(1.0, 200.0), read_recording(folder / "first.bag")
    place, force = log.best(POSITION), log.best(SPECIFIC_FORCE)
    assert place is not None
    assert force is not None
    assert place.name == "/vicon/arq/arq.position"
    assert place.times[0] == 1e9
    assert place.values == pytest.approx(made.best(POSITION).values, abs=1e-12)  # type: ignore[union-attr]
    assert force.values == pytest.approx(made.channels[0].values, abs=1e-12)
    attitude = log.best(ATTITUDE)
    assert attitude is not None
    assert attitude.values == pytest.approx(made.best(ATTITUDE).values, abs=1e-12)  # type: ignore[union-attr]


def test_ros_reads_the_mcap_that_is_written(folder: Path) -> None:
    bag = folder / "bag"
    bag.mkdir()
    (folder / "mcap.mcap").rename(bag / "bag.mcap")
    topics = {
        "/imu/data_raw": ("sensor_msgs/msg/Imu", 200), "/vehicle/pose": ("geometry_msgs/msg/PoseStamped", 200),
        "/arm_lengths": ("sensor_msgs/msg/JointState", 200), "/rotor_commands": ("sensor_msgs/msg/JointState", 200),
    }  # fmt: skip
    lines = ["rosbag2_bagfile_information:", "  version: 5", "  storage_identifier: mcap"]
    lines += ["  relative_file_paths: [bag.mcap]", "  duration: {nanoseconds: 995000000}"]
    lines += ["  starting_time: {nanoseconds_since_epoch: 0}", "  message_count: 800"]
    lines += ["  compression_format: ''", "  compression_mode: ''", "  topics_with_message_count:"]
    for name, (kind, count) in topics.items():
        lines += [
            f"  - message_count: {count}", "    topic_metadata:", f"      name: {name}",
            f"      type: {kind}", "      serialization_format: cdr", "      offered_qos_profiles: ''",
        ]  # fmt: skip
    (bag / "metadata.yaml").write_text("\n".join(lines) + "\n")
    force = whole(1.0, 200.0).channels[0].values
    with AnyReader([bag]) as reader:
        found = [
            reader.deserialize(data, one.msgtype)
            for one, _, data in reader.messages() if one.topic == "/imu/data_raw"
        ]  # fmt: skip
    assert len(found) == 200
    last = found[-1].linear_acceleration  # type: ignore[attr-defined]
    assert [last.x, last.y, last.z] == pytest.approx(force[-1])
    assert found[0].orientation_covariance[0] == -1.0  # type: ignore[attr-defined]


def test_a_chunk_that_would_have_to_be_held_at_once_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bag of ROS 1 is read chunk by chunk: 1.1 GB in one took 1.2 GB of memory."""
    monkeypatch.setattr("springback.logs.formats.bags.LONGEST_RECORD", 20_000)
    with pytest.raises(
        InputError, match=r"has a chunk of \d+ MB, which would have to be held"
    ) as e:
        read_recording(folder / "first.bag")
    assert len(e.value.problems) == 1
    monkeypatch.setattr("springback.logs.formats.bags.LONGEST_RECORD", 2**20)
    assert read_recording(folder / "first.bag").best(SPECIFIC_FORCE) is not None


PX = """string NOTE=");import os;os.abort()#"
uint64 timestamp
float32[3] gyro_rad
uint32 gyro_integral_dt
int32 accelerometer_timestamp_relative
float32[3] accelerometer_m_s2
uint32 accelerometer_integral_dt
uint8 accelerometer_clipping
"""
OWN = """std_msgs/Header header
NamedPose[] poses
================================================================================
MSG: motion_capture_tracking_interfaces/NamedPose
string name
geometry_msgs/Pose pose
"""


def own_messages(path: Path) -> None:
    """An MCAP of messages that no distribution has: of PX4, and of a motion capture."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    kinds = {
        "px4_msgs/msg/SensorCombined": PX,
        "motion_capture_tracking_interfaces/msg/NamedPoseArray": OWN,
    }
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start(profile="ros2", library="test")
        numbers = {}
        for kind, text in kinds.items():
            store.register(
                {
                    k: v
                    for k, v in get_types_from_msg(text, kind).items()
                    if k not in store.fielddefs
                }
            )
            schema = writer.register_schema(kind, "ros2msg", text.encode())
            topic = "/fmu/out/sensor_combined" if "px4" in kind else "/poses"
            numbers[kind] = writer.register_channel(topic, "cdr", schema)
        types = store.types
        for k in range(60):
            ns = 5_000_000 * (k + 1)
            combined = types["px4_msgs/msg/SensorCombined"](
                ns // 1000, np.array([0.1, 0.2, 0.3], np.float32), 5000, 0,
                np.array([1.0, 2.0, -9.8], np.float32), 4840, 1,
            )  # fmt: skip
            kind = "px4_msgs/msg/SensorCombined"
            writer.add_message(numbers[kind], ns, bytes(store.serialize_cdr(combined, kind)), ns)
            stamp = types["builtin_interfaces/msg/Time"](0, ns)
            header = types["std_msgs/msg/Header"](stamp, "world")
            pose = types["geometry_msgs/msg/Pose"](
                types["geometry_msgs/msg/Point"](1.0, 2.0, 3.0),
                types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0),
            )
            named = types["motion_capture_tracking_interfaces/msg/NamedPose"]("arq", pose)
            kind = "motion_capture_tracking_interfaces/msg/NamedPoseArray"
            poses = types[kind](header, [named])
            writer.add_message(numbers[kind], ns, bytes(store.serialize_cdr(poses, kind)), ns)
        writer.finish()


def test_messages_with_definitions_of_their_own_are_read(tmp_path: Path) -> None:
    """Of PX4 in NED and FRD, of the motion capture in ENU."""
    own_messages(tmp_path / "own.mcap")
    told = {one.name: one for one in read_recording(tmp_path / "own.mcap").channels}
    force = told["sensor_combined.accelerometer"]
    assert force.values[0] == pytest.approx([1.0, -2.0, 9.8])
    assert force.chain.average == pytest.approx(4.84e-3)
    assert force.clipped is not None
    assert force.clipped[0].tolist() == [True, False, False]
    assert told["/poses.arq.position"].values[0] == pytest.approx([2.0, -1.0, 3.0])
    plain = read_recording(tmp_path / "own.mcap", LogOptions(world="nwu"))
    assert plain.best(POSITION).values[0] == pytest.approx([1.0, 2.0, 3.0])  # type: ignore[union-attr]


def test_definitions_of_a_bag_are_no_programs() -> None:
    """The library makes Python of them: names are letters, and constants are left out."""
    kind = "own_msgs/msg/Harmless"
    found = get_types_from_msg("uint8 x\nOther[] y\n", kind)
    assert is_harmless(found)
    assert not is_harmless({kind: ([], [("x=1;import os", found[kind][1][0][1])])})
    assert not is_harmless({"a/msg/B(": ([], [])})
    assert not is_harmless({kind: ([("A", "string", "\n")], [])})


def test_an_mcap_that_is_cut_off_is_read_as_far_as_it_goes(tmp_path: Path) -> None:
    store = get_typestore(Stores.ROS2_HUMBLE)
    stream = io.BytesIO()
    writer = Writer(stream, chunk_size=2000)
    writer.start(profile="ros2", library="test")
    kind = "geometry_msgs/msg/PointStamped"
    text = store.generate_msgdef("geometry_msgs/msg/PoseStamped", ros_version=2)[0]
    schema = writer.register_schema("geometry_msgs/msg/PoseStamped", "ros2msg", text.encode())
    number = writer.register_channel("/pose", "cdr", schema)
    other = writer.register_channel("/point", "cdr", writer.register_schema(kind, "ros2msg", b""))
    text_imu = writer.register_channel("/imu", "json", 0)
    types = store.types
    for k in range(500):
        stamp = types["builtin_interfaces/msg/Time"](0, 10**6 * (k + 1))
        pose = types["geometry_msgs/msg/PoseStamped"](
            types["std_msgs/msg/Header"](stamp, ""),
            types["geometry_msgs/msg/Pose"](
                types["geometry_msgs/msg/Point"](1.0 * k, 2.0, 3.0),
                types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0),
            ),
        )
        data = bytes(store.serialize_cdr(pose, "geometry_msgs/msg/PoseStamped"))
        writer.add_message(number, 10**6 * (k + 1), data, 0)
        writer.add_message(other, 10**6 * (k + 1), b"unread", 0)
        writer.add_message(text_imu, 10**6 * (k + 1), b"{}", 0)
    writer.finish()
    path = tmp_path / "cut.mcap"
    path.write_bytes(stream.getvalue()[: len(stream.getvalue()) // 2])
    log = read_recording(path)
    assert 50 < len(log.channels[0].times) < 500
    assert "cut.mcap: is damaged, and what follows is lost" in log.damage[0]
    assert "not read: /imu (json), /point" in log.remarks


@pytest.mark.parametrize(
    ("name", "said"),
    [("mcap.mcap", "has nothing that can be used"), ("bag.db3", "cannot be read as a ROS 2 bag"),
     ("first.bag", "cannot be read as a ROS 1 bag")],
)  # fmt: skip
def test_a_file_that_is_no_bag_is_refused_in_a_line(tmp_path: Path, name: str, said: str) -> None:
    (tmp_path / name).write_bytes(b"not a bag at all" * 100)
    with pytest.raises(InputError, match=said) as refused:
        read_recording(tmp_path / name)
    assert len(refused.value.problems) == 1


def test_without_the_library_the_command_that_installs_it_is_named(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "rosbags.typesys", None)
    with pytest.raises(InputError, match=r"this needs rosbags.*\[logs\]"):
        read_recording(folder / "first.bag")


def test_a_bag_of_a_part_of_the_time(tmp_path: Path) -> None:
    first_bag(tmp_path / "a.bag", 100)
    log = read_recording(tmp_path / "a.bag", LogOptions(first=1e9 + 0.2, last=1e9 + 0.3))
    assert log.channels[0].span == (1e9 + 0.2, 1e9 + 0.3)
