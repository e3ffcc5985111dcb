"""ArduPilot's binary logs (DataFlash, ``.BIN``).

Each message begins with two bytes and the number of its type; messages FMT say what the others
contain (ArduPilot documentation, "Downloading and Analyzing Data Logs").  Vectors are in FRD and
NED, as PX4's.
"""

from __future__ import annotations

import math
import struct
from array import array
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
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

HEAD = b"\xa3\x95"
FORMAT = 0x80
#: Length of a message FMT [bytes].
FORMAT_LENGTH = 89
BLOCK = 1 << 20
#: struct's codes of the format's, with the factor of their unit.
CODES: dict[str, tuple[str, float]] = {
    "b": ("b", 1.0), "B": ("B", 1.0), "h": ("h", 1.0), "H": ("H", 1.0), "i": ("i", 1.0),
    "I": ("I", 1.0), "f": ("f", 1.0), "d": ("d", 1.0), "n": ("4s", 0.0), "N": ("16s", 0.0),
    "Z": ("64s", 0.0), "c": ("h", 0.01), "C": ("H", 0.01), "e": ("i", 0.01), "E": ("I", 0.01),
    "L": ("i", 1e-7), "M": ("B", 1.0), "q": ("q", 1.0), "Q": ("Q", 1.0), "a": ("64s", 0.0),
    "g": ("e", 1.0),
}  # fmt: skip
#: Messages that are read, with the fields that each needs.
WANTED: dict[str, tuple[str, ...]] = {
    "IMU": ("GyrX", "GyrY", "GyrZ", "AccX", "AccY", "AccZ"),
    "ACC": ("AccX", "AccY", "AccZ"),
    "GYR": ("GyrX", "GyrY", "GyrZ"),
    "ATT": ("Roll", "Pitch", "Yaw"),
    "AHR2": ("Q1", "Q2", "Q3", "Q4"),
    "XKF1": ("VN", "VE", "VD", "PN", "PE", "PD"),
    "NKF1": ("VN", "VE", "VD", "PN", "PE", "PD"),
    "VISP": ("PX", "PY", "PZ", "Roll", "Pitch", "Yaw"),
    "RCOU": ("C1", "C2", "C3", "C4"),
    "ESC": ("RPM",),
    "PARM": (),
}


class _Format(NamedTuple):
    name: str
    length: int
    form: struct.Struct
    labels: tuple[str, ...]
    factors: tuple[float, ...]


class _MessageRows:
    """Numbers of one message and instance."""

    def __init__(self) -> None:
        self.data = array("d")
        self.times = array("d")


def read_dataflash(path: Path, part: TimeSpan) -> Recording:
    """Recording of a log of ArduPilot.

    Args:
        path: The log.
        part: Instants that are wanted, in seconds of its clock.

    Raises:
        InputError: If it is none, or nothing of it can be used.
    """
    where, damage = str(path), list[str]()
    parser = _BinParser(where, part)
    with path.open("rb") as file:
        if file.read(3) != HEAD + bytes((FORMAT,)):
            raise InputError(f"{where}: is no binary log of ArduPilot (it begins otherwise)")
        file.seek(0)
        parser.read(file, damage)
    channels = _channels(where, parser)
    refuse_without_channels(where, channels, ", ".join(sorted(WANTED)), damage)
    return Recording(
        path, "ArduPilot BIN", tuple(channels), parameters=parser.parameters, damage=tuple(damage)
    )


class _BinParser:
    """State while a log is read."""

    def __init__(self, where: str, part: TimeSpan) -> None:
        self.where, self.part, self.budget = where, part, Budget(where)
        self.formats: dict[int, _Format | int] = {}  # a length where a format is damaged
        self.rows: dict[tuple[str, int], _MessageRows] = {}
        self.parameters: dict[str, float | int | str] = {}
        self.last = 0.0

    def read(self, file: BinaryIO, damage: list[str]) -> None:
        """Read all messages; after damage, on from the next one that is known."""
        data, at, damaged, ended = b"", 0, 0, False
        while True:
            if len(data) - at < 512 and not ended:
                more = file.read(BLOCK)
                ended = not more
                data, at = data[at:] + more, 0
            if len(data) - at < 3:
                break
            kind = data[at + 2]
            known = FORMAT_LENGTH if kind == FORMAT else self.formats.get(kind)
            length = known.length if isinstance(known, _Format) else known
            if data[at : at + 2] != HEAD or length is None:
                damaged += 1
                found = data.find(HEAD, at + 1)
                at = len(data) - 1 if found < 0 else found
                if found < 0 and ended:
                    break
                continue
            if len(data) - at < length:
                place = file.tell() - len(data) + at
                damage.append(
                    f"the log ends within a message, at byte {place}, {self.last:.3f} s by its "
                    "clock: it was cut off"
                )
                break
            if kind == FORMAT:
                self._format(data[at + 3 : at + FORMAT_LENGTH])
            elif isinstance(known, _Format) and known.name in WANTED:
                self._message(known, data, at + 3)
            at += length
        if damaged:
            damage.append(f"the log is damaged in {damaged} places, which were skipped")

    def _format(self, body: bytes) -> None:
        kind, length = body[0], body[1]
        if kind == FORMAT or length < 3:
            return
        name, codes, labels = (
            part.split(b"\0")[0].decode("ascii", "replace")
            for part in (body[2:6], body[6:22], body[22:86])
        )
        names = tuple(labels.split(",")) if labels else ()
        if any(code not in CODES for code in codes) or len(names) != len(codes):
            self.formats[kind] = length
            return
        form = struct.Struct("<" + "".join(CODES[code][0] for code in codes))
        factors = tuple(CODES[code][1] for code in codes)
        whole = form.size + 3 == length
        self.formats[kind] = _Format(name, length, form, names, factors) if whole else length

    def _message(self, known: _Format, data: bytes, at: int) -> None:
        values = dict(zip(known.labels, known.form.unpack_from(data, at), strict=True))
        if known.name == "PARM":
            name, value = values.get("Name"), values.get("Value")
            if isinstance(name, bytes) and isinstance(value, float) and math.isfinite(value):
                self.parameters[name.split(b"\0")[0].decode("ascii", "replace")] = value
            return
        wanted = WANTED[known.name]
        time = values.get("TimeUS", values.get("TimeMS"))
        if not isinstance(time, int) or not set(wanted) <= values.keys():
            return
        seconds = time / (1e6 if "TimeUS" in values else 1e3)
        self.last = seconds
        if not self.part.has(seconds):
            return
        if "SampleUS" in values and isinstance(values["SampleUS"], int) and values["SampleUS"]:
            seconds = values["SampleUS"] / 1e6
        instance = values.get("I", values.get("Instance", 0))
        rows = self.rows.setdefault((known.name, int(instance)), _MessageRows())
        factors = dict(zip(known.labels, known.factors, strict=True))
        self.budget.take(len(wanted) + 1)
        rows.times.append(seconds)
        rows.data.extend([float(values[name]) * factors[name] for name in wanted])


def _filtered(parser: _BinParser, corner: str) -> SensorChain:
    """Chain of `IMU`, behind a Butterworth filter of second order; zero switches it off."""
    given = parser.parameters.get(corner)
    low_pass = float(given) if isinstance(given, float) and given > 0.0 else None
    return SensorChain(low_pass=low_pass, low_pass_order=2, note=f"behind {corner}")


def _channels(where: str, parser: _BinParser) -> list[LogChannel]:
    frd, ned = BODIES["frd"], WORLDS["ned"]
    found: list[LogChannel] = []
    several = {name for name, number in parser.rows if number > 0}
    for (name, instance), rows in sorted(parser.rows.items()):
        at = np.frombuffer(rows.times)
        values = np.frombuffer(rows.data).reshape(len(at), -1)
        label = f"{name}[{instance}]" if name in several else name

        def add(
            what: str, quantity: str, numbers: Array, chain: SensorChain,
            label: str = label, at: Array = at,
        ) -> None:  # fmt: skip
            full = f"{label}.{what}" if what else label
            found.append(log_channel(where, full, quantity, at, numbers, chain=chain))

        if name == "IMU":
            turn, force = (_filtered(parser, f"INS_{one}_FILTER") for one in ("GYRO", "ACCEL"))
            add("gyro", ANGULAR_VELOCITY, vectors_in(frd, values[:, :3]), turn)
            add("accelerometer", SPECIFIC_FORCE, vectors_in(frd, values[:, 3:]), force)
        elif name in ("ACC", "GYR"):
            kind = SPECIFIC_FORCE if name == "ACC" else ANGULAR_VELOCITY
            note = SensorChain(note="every sample that the driver gave")
            add("", kind, vectors_in(frd, values), note)
        elif name == "ATT":
            add("", ATTITUDE, attitudes_in(ned, frd, _quaternions(values)),
                SensorChain(estimated=True))  # fmt: skip
        elif name == "AHR2":
            add("", ATTITUDE, attitudes_in(ned, frd, values), SensorChain(estimated=True))
        elif name in ("XKF1", "NKF1"):
            estimate = SensorChain(estimated=True)
            add("velocity", VELOCITY, vectors_in(ned, values[:, :3]), estimate)
            add("position", POSITION, vectors_in(ned, values[:, 3:]), estimate)
        elif name == "VISP":
            chain = SensorChain(note="came over a link: its delay and jitter are in the times")
            add("position", POSITION, vectors_in(ned, values[:, :3]), chain)
            add("attitude", ATTITUDE,
                attitudes_in(ned, frd, _quaternions(values[:, 3:])), chain)  # fmt: skip
        elif name == "RCOU":
            add("", ROTOR_COMMAND, values, SensorChain(note="pulses to the motors [us]"))
        elif name == "ESC":
            add("", ROTOR_SPEED, values * (2.0 * math.pi / 60.0), SensorChain())
    return found


def _quaternions(angles: Array) -> Array:
    """Quaternions of roll, pitch and yaw [deg] about x, y, z of FRD, shape (n, 3) to (n, 4)."""
    if not np.isfinite(angles).all():
        angles = np.where(np.isfinite(angles), angles, 0.0)
    rotation = scipy.spatial.transform.Rotation.from_euler("ZYX", angles[:, ::-1], degrees=True)
    return np.asarray(rotation.as_quat(scalar_first=True))
