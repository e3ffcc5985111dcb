"""PX4's ULog, read message by message: memory holds the wanted topics only.

Format: PX4 user guide, "ULog File Format" (version 1).  A log that ends in the middle of a message,
as after a loss of power, is read up to there.
"""

from __future__ import annotations

import struct
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np

from springback.errors import InputError, shown_value
from springback.logs.recording import Budget, TimeSpan

MAGIC = b"ULog\x01\x12\x35"
#: What a sync message contains.
SYNC = bytes((0x2F, 0x73, 0x13, 0x20, 0x25, 0x0C, 0xBB, 0x12))
#: Bytes that are read at a time.
BLOCK = 1 << 20
#: Types of messages that the format knows.
KNOWN = frozenset(b"BFIMPQARDLCSO")
TYPES = {
    "int8_t": "i1", "uint8_t": "u1", "int16_t": "<i2", "uint16_t": "<u2", "int32_t": "<i4",
    "uint32_t": "<u4", "int64_t": "<i8", "uint64_t": "<u8", "float": "<f4", "double": "<f8",
    "bool": "u1", "char": "u1",
}  # fmt: skip
#: First field of every topic.
TIMESTAMP = ("uint64_t", 0, "timestamp")
#: Deepest nesting of formats, and longest message [bytes].
DEEPEST, LONGEST = 5, 65535

Rows = np.ndarray[Any, np.dtype[Any]]


class Topic(NamedTuple):
    """All messages of one instance of a topic."""

    name: str
    instance: int
    rows: Rows  # structured: a field for each of the format


@dataclass
class UlogFile:
    """What is in a log, apart from topics that are not wanted."""

    start: float = 0.0  # [s]
    topics: list[Topic] = field(default_factory=list)
    others: list[str] = field(default_factory=list)
    parameters: dict[str, float | int] = field(default_factory=dict)
    about: dict[str, str] = field(default_factory=dict)
    dropouts: list[tuple[float, float]] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    damage: list[str] = field(default_factory=list)


class _Subscription(NamedTuple):
    name: str
    instance: int
    kind: np.dtype[Any]
    data: bytearray


def read_ulog(path: Path, wanted: Collection[str], part: TimeSpan, budget: Budget) -> UlogFile:
    """Read the wanted topics of a log, and its parameters.

    Args:
        path: The log.
        wanted: Names of topics.
        part: Instants that are wanted, in seconds of its clock.
        budget: Of numbers in memory.

    Raises:
        InputError: If it is no ULog, or is damaged such that nothing can be read.
    """
    found = UlogFile()
    with path.open("rb") as file:
        head = file.read(16)
        if head[:7] == MAGIC and len(head) < 16:
            raise InputError(f"{path}: is cut off after {len(head)} of the 16 bytes of its head")
        if head[:7] != MAGIC:
            raise InputError(f"{path}: is no ULog (its first bytes are {shown_value(head[:8])})")
        found.start = struct.unpack_from("<Q", head, 8)[0] / 1e6
        _UlogParser(str(path), found, wanted, part, budget).read(file)
    return found


class _UlogParser:
    """State while a log is read."""

    def __init__(
        self, where: str, found: UlogFile, wanted: Collection[str], part: TimeSpan, budget: Budget
    ) -> None:
        self.where, self.found, self.wanted = where, found, wanted
        self.part, self.budget = part, budget
        self.formats: dict[str, list[tuple[str, int, str]]] = {}
        self.kinds: dict[str, np.dtype[Any]] = {}
        self.subscriptions: dict[int, _Subscription] = {}
        self.all: list[_Subscription] = []
        self.last = 0.0

    def read(self, file: BinaryIO) -> None:
        """Read all messages."""
        cuts = list[int]()
        for kind, body in _messages(file, self.found.damage, cuts):
            if kind == 0x44:  # D
                self._data(body)
            elif kind == 0x46:  # F
                self._format(body)
            elif kind == 0x41:  # A
                self._subscribe(body)
            elif kind in (0x50, 0x49):  # P, I
                self._entry(body, parameter=kind == 0x50)
            elif kind == 0x4F and len(body) >= 2:  # O
                self.found.dropouts.append((self.last, struct.unpack_from("<H", body)[0] / 1e3))
            elif kind == 0x42:  # B
                self._flags(body)
        for at in cuts:
            self.found.damage.append(
                f"the log ends within a message, at byte {at}, {self.last:.3f} s by its clock: it "
                "was cut off"
            )
        for one in self.all:
            if one.data:
                rows = np.frombuffer(bytes(one.data), dtype=one.kind)
                one.data.clear()
                self.found.topics.append(Topic(one.name, one.instance, rows))

    def _flags(self, body: bytes) -> None:
        if any(body[8:16]) and (len(body) < 16 or body[8] & ~1 or any(body[9:16])):
            raise InputError(f"{self.where}: needs a newer reader of ULog (incompatible flags)")

    def _format(self, body: bytes) -> None:
        name, _, text = body.decode("utf-8", "replace").partition(":")
        fields = []
        for entry in filter(None, text.split(";")):
            kind, _, label = entry.strip().partition(" ")
            kind, _, count = kind.partition("[")
            size = count.rstrip("]")
            if not label or (count and not size.isdecimal()) or len(size) > 5:
                return  # a damaged format: its topic is not read
            fields.append((kind, int(size) if count else 0, label))
        self.formats[name] = fields

    def _kind(self, name: str, depth: int = 0) -> np.dtype[Any] | None:
        """Type of a topic's rows, trailing padding left out; None if it is damaged."""
        fields = self.formats.get(name)
        if not fields or depth > DEEPEST:
            return None
        if depth == 0:
            while fields and fields[-1][2].startswith("_padding"):
                fields = fields[:-1]
        parts: list[Any] = []
        size = 0
        for kind, count, label in fields:
            plain: Any = TYPES.get(kind)
            one = np.dtype(plain) if plain else self._kind(kind, depth + 1)
            if one is None or any(label == known[0] for known in parts):
                return None
            size += one.itemsize * max(count, 1)
            if size > LONGEST:
                return None
            parts.append((label, one, (count,)) if count else (label, one))
        return np.dtype(parts) if parts else None

    def _subscribe(self, body: bytes) -> None:
        if len(body) < 4:
            return
        instance, number = struct.unpack_from("<BH", body)
        name = body[3:].decode("utf-8", "replace")
        if name not in self.wanted:
            self.subscriptions.pop(number, None)
            if name not in self.found.others:
                self.found.others.append(name)
            return
        kind = self._kind(name)
        first = next(iter(self.formats.get(name, ())), None)
        if kind is None or first is None or first != TIMESTAMP:
            self.found.remarks.append(f"{name}: its format is damaged, so that it is not read")
            return
        taken = _Subscription(name, instance, kind, bytearray())
        self.subscriptions[number] = taken
        self.all.append(taken)

    def _data(self, body: bytes) -> None:
        if len(body) < 10:
            return
        number, time = struct.unpack_from("<HQ", body)
        self.last = time / 1e6 if time else self.last
        one = self.subscriptions.get(number)
        if one is None or not self.part.has(time / 1e6):
            return
        size = one.kind.itemsize
        if len(body) >= 2 + size:
            self.budget.take(size // 4)
            one.data.extend(body[2 : 2 + size])

    def _entry(self, body: bytes, *, parameter: bool) -> None:
        """A parameter or an information, which has the same form."""
        if not body or len(body) < 1 + body[0]:
            return
        kind, _, name = body[1 : 1 + body[0]].decode("utf-8", "replace").partition(" ")
        value = body[1 + body[0] :]
        if parameter:
            form = {"int32_t": "<i", "float": "<f"}.get(kind)
            if form and len(value) >= 4:
                number = struct.unpack_from(form, value)[0]
                if np.isfinite(number):
                    self.found.parameters[name] = number
        elif kind.startswith("char[") and len(self.found.about) < 100:
            self.found.about[name] = value.decode("utf-8", "replace")


def _messages(file: BinaryIO, damage: list[str], cuts: list[int]) -> Iterator[tuple[int, bytes]]:
    """Types and bodies of all messages; after damage, on from the next sync message.

    Args:
        file: After its head.
        damage: What is damaged is added, a sentence each.
        cuts: The byte of the message within which the file ends is added.
    """
    data, at, damaged = b"", 0, 0
    while True:
        if len(data) - at < 3 + LONGEST:
            more = file.read(BLOCK)
            data, at = data[at:] + more, 0
        if len(data) - at < 3:
            if len(data) > at:
                cuts.append(file.tell() - len(data) + at)
            break
        size, kind = data[at] | data[at + 1] << 8, data[at + 2]
        if kind not in KNOWN:
            damaged, place = damaged + 1, file.tell() - len(data) + at
            found = data.find(SYNC, at)
            while found < 0:
                more = file.read(BLOCK)
                if not more:
                    damage.append(f"the log is damaged at byte {place}, and what follows is lost")
                    return
                data, at = data[-len(SYNC) :] + more, 0
                found = data.find(SYNC)
            at = found + len(SYNC)
            continue
        if len(data) - at < 3 + size:
            cuts.append(file.tell() - len(data) + at)
            break
        yield kind, data[at + 3 : at + 3 + size]
        at += 3 + size
    if damaged:
        damage.append(f"the log is damaged in {damaged} places, which were skipped")
