"""Bags of ROS 1 and ROS 2 and MCAP files: their messages, one after the other.

Files are streamed.  Standard messages are decoded by the definitions of their ROS; others, such as
those of PX4, by the definitions in the file.
"""

from __future__ import annotations

import re
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.extras import needs
from springback.logs.formats.ros import READERS, RosCollector, is_read, refuse_damage
from springback.logs.recording import Recording, TimeSpan, refuse_without_channels

_NAME = re.compile(r"[A-Za-z0-9_/]*", re.ASCII)
#: Longest record of an MCAP file, and chunk of a bag of ROS 1, that is read [bytes] (chosen).
LONGEST_RECORD = 256 * 2**20
#: Longest message that is decoded [bytes] (chosen: poses and inertial data are short).
LONGEST_MESSAGE = 2**20
#: Largest file of a bag in SQLite whose pages are kept in memory [KiB].
CACHE = 16 * 1024


class RawMessage(NamedTuple):
    """A message as it is stored."""

    topic: str
    kind: str
    encoding: str  # "cdr" or "ros1"
    definition: str
    arrival: float  # [s]
    data: bytes


class _Decoder:
    """Decoder of messages by their types."""

    def __init__(self) -> None:
        typesys = needs("rosbags.typesys", "logs")
        self.typesys = typesys
        self.stores = {
            "cdr": typesys.get_typestore(typesys.Stores.ROS2_HUMBLE),
            "ros1": typesys.get_typestore(typesys.Stores.ROS1_NOETIC),
        }
        self.unknown: set[tuple[str, str]] = set()

    def decode_message(self, message: RawMessage) -> Any:
        """The message; None if its type is not known.

        Raises:
            An exception of any kind, if it is damaged.
        """
        store = self.stores[message.encoding]
        key = (message.encoding, message.kind)
        if key in self.unknown:
            return None
        if message.kind not in store.fielddefs:
            if not message.definition:
                self.unknown.add(key)
                return None
            found = self.typesys.get_types_from_msg(message.definition, message.kind)
            plain: dict[str, Any] = {k: ([], v[1]) for k, v in found.items()}  # no constants
            if not is_harmless(plain):
                self.unknown.add(key)
                return None
            store.register({k: v for k, v in plain.items() if k not in store.fielddefs})
        if message.encoding == "ros1":
            return store.deserialize_ros1(message.data, message.kind)
        return store.deserialize_cdr(message.data, message.kind)


def is_harmless(definition: Any) -> bool:
    """True if all names of a definition are of letters, digits, ``_`` and ``/``.

    The library writes Python of them, and runs it.
    """
    if isinstance(definition, str):
        return _NAME.fullmatch(definition) is not None
    if isinstance(definition, dict):
        return all(is_harmless(k) and is_harmless(v) for k, v in definition.items())
    if isinstance(definition, list | tuple):
        return all(map(is_harmless, definition))
    return definition is None or isinstance(definition, int)


def read_bag(path: Path, part: TimeSpan, world: str, body: str) -> Recording:
    """Recording of a bag: a file ``.bag``, ``.db3`` or ``.mcap``, or a folder of the last two.

    Args:
        path: The file or folder.
        part: Instants that are wanted [s].
        world: Name of its world axes, of `springback.logs.frame_turns.WORLDS`.
        body: Name of its body axes, of `springback.logs.frame_turns.BODIES`.

    Raises:
        InputError: If it cannot be read, or nothing of it can be used.
    """
    where, remarks, damage = str(path), list[str](), list[str]()
    decoder, collector = _Decoder(), RosCollector(where, part, world, body)
    damaged = 0
    for file, messages in _sources(path):
        for raw in messages(file, remarks, damage):
            if len(raw.data) > LONGEST_MESSAGE:
                continue
            try:
                message = decoder.decode_message(raw)
                if message is not None:
                    collector.add(raw.topic, raw.kind, message, raw.arrival)
            except InputError:
                raise
            except Exception as error:  # libraries raise what they like for damaged messages
                damaged += 1
                if damaged > 1000:
                    raise refuse_damage(where, error, "messages") from None
    if damaged:
        damage.append(f"{damaged} messages are damaged and were skipped")
    remarks += [
        f"{kind}: has no definition in the bag, so that it is not read"
        for _, kind in sorted(decoder.unknown)
    ]
    channels = collector.channels()
    kinds = [kind.replace("/msg/", "/") for kind in READERS]
    refuse_without_channels(
        where,
        channels,
        f"{', '.join(kinds)} and messages of px4_msgs",
        (*damage, *remarks, *collector.remarks()),
    )
    name = {".bag": "ROS 1 bag", ".mcap": "MCAP"}.get(path.suffix.lower(), "ROS 2 bag")
    return Recording(
        path, name, tuple(channels), remarks=(*remarks, *collector.remarks()), damage=tuple(damage)
    )


Source = Callable[[Path, list[str], list[str]], Iterator[RawMessage]]


def _sources(path: Path) -> list[tuple[Path, Source]]:
    """Files of a bag, each with its reader."""
    if not path.is_dir():
        return [(path, _SUFFIXES[path.suffix.lower()])]
    files = sorted(one for one in path.iterdir() if one.suffix.lower() in (".db3", ".mcap"))
    if not files:
        raise InputError(f"{path}: has no files .db3 or .mcap, so that it is no bag of ROS 2")
    return [(one, _SUFFIXES[one.suffix.lower()]) for one in files]


def _mcap_messages(path: Path, remarks: list[str], damage: list[str]) -> Iterator[RawMessage]:
    """Messages of an MCAP file, in the order of the file."""
    stream_reader = needs("mcap.stream_reader", "logs")
    records = needs("mcap.records", "logs")
    schemas: dict[int, tuple[str, str, str]] = {}
    channels: dict[int, tuple[str, str, str, str] | None] = {}
    others: set[str] = set()
    with path.open("rb") as file:
        reader = stream_reader.StreamReader(file, record_size_limit=LONGEST_RECORD)
        found = reader.records
        while True:
            try:
                record = next(found, None)
            except Exception as error:  # a damaged or truncated file: what is whole was read
                said = " ".join(str(error).split())[:100] or type(error).__name__
                damage.append(f"{path.name}: is damaged, and what follows is lost ({said})")
                break
            if record is None:
                break
            if isinstance(record, records.Schema):
                text = record.data[:LONGEST_MESSAGE].decode("utf-8", "replace")
                schemas[record.id] = (record.name, record.encoding, text)
            elif isinstance(record, records.Channel):
                channels[record.id] = _mcap_channel(record, schemas, others)
            elif isinstance(record, records.Message):
                channel = channels.get(record.channel_id)
                if channel is not None:
                    yield RawMessage(*channel, 1e-9 * record.log_time, record.data)
    if others:
        remarks.append(f"not read: {', '.join(sorted(others))[:300]}")


def _mcap_channel(
    record: Any, schemas: dict[int, tuple[str, str, str]], others: set[str]
) -> tuple[str, str, str, str] | None:
    """Topic, type, encoding and definition of a channel that is read."""
    kind, language, text = schemas.get(record.schema_id, ("", "", ""))
    parts = kind.split("/")
    name = "/".join([parts[0], "msg", parts[-1]]) if len(parts) in (2, 3) else kind
    if record.message_encoding in ("cdr", "ros1") and is_read(record.topic, name):
        definition = text if language in ("ros2msg", "ros1msg") else ""
        return (record.topic, name, record.message_encoding, definition)
    coded = "" if record.message_encoding in ("cdr", "ros1") else f" ({record.message_encoding})"
    others.add(record.topic + coded)
    return None


def _sqlite_messages(path: Path, remarks: list[str], damage: list[str]) -> Iterator[RawMessage]:
    """Messages of a ROS 2 bag in SQLite, in the order of the file."""
    try:
        with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as base:
            base.execute(f"PRAGMA cache_size = -{CACHE}")
            base.execute("PRAGMA trusted_schema = OFF")
            tables = {row[0] for row in base.execute("SELECT name FROM sqlite_master")}
            definitions: dict[str, str] = {}
            if "message_definitions" in tables:
                asked = (
                    "SELECT topic_type, encoded_message_definition FROM message_definitions "
                    "WHERE encoding = 'ros2msg'"
                )
                definitions = {str(a): str(b) for a, b in base.execute(asked)}
            wanted, others = dict[Any, tuple[str, str, str, str]](), list[str]()
            for number, topic, kind, form in base.execute(
                "SELECT id, name, type, serialization_format FROM topics"
            ):
                if form == "cdr" and is_read(str(topic), str(kind)):
                    wanted[number] = (str(topic), str(kind), "cdr", definitions.get(str(kind), ""))
                else:
                    others.append(str(topic))
            if others:
                remarks.append(f"not read: {', '.join(sorted(others))[:300]}")
            marks = ", ".join("?" * len(wanted))
            for number, time, data in base.execute(
                f"SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN ({marks})",
                list(wanted),
            ):
                if number in wanted and isinstance(data, bytes) and isinstance(time, int):
                    yield RawMessage(*wanted[number], 1e-9 * time, data)
    except (sqlite3.Error, OverflowError) as error:
        raise refuse_damage(str(path), error, "a ROS 2 bag") from None


def _bag_messages(path: Path, remarks: list[str], damage: list[str]) -> Iterator[RawMessage]:
    """Messages of a ROS 1 bag, in the order of arrival."""
    rosbag = needs("rosbags.rosbag1", "logs")
    try:
        with rosbag.Reader(path) as reader:
            longest = max((one.datasize for one in reader.chunks.values()), default=0)
            if longest > LONGEST_RECORD:
                raise InputError(
                    f"{path}: has a chunk of {1e-6 * longest:.0f} MB, which would have to be held "
                    f"at once: write it again in chunks of less than {1e-6 * LONGEST_RECORD:.0f} "
                    "MB (rosbag record --chunksize)"
                )
            wanted = [one for one in reader.connections if is_read(one.topic, one.msgtype)]
            names = {one.topic for one in reader.connections} - {one.topic for one in wanted}
            if names:
                remarks.append(f"not read: {', '.join(sorted(names))[:300]}")
            if not wanted:
                return
            for one, time, data in reader.messages(connections=wanted):
                text = one.msgdef.data if hasattr(one.msgdef, "data") else str(one.msgdef)
                yield RawMessage(one.topic, one.msgtype, "ros1", text, 1e-9 * time, bytes(data))
    except InputError:
        raise
    except Exception as error:  # the library raises what it likes for damaged files
        what = "a ROS 1 bag; `rosbag reindex` may repair its index"
        raise refuse_damage(str(path), error, what) from None


_SUFFIXES: dict[str, Source] = {
    ".mcap": _mcap_messages,
    ".db3": _sqlite_messages,
    ".bag": _bag_messages,
}
