"""C3D files: trajectories of markers, of little-endian machines.

Format: "The C3D File Format User Guide" (c3d.org): blocks of 512 bytes, a header, parameters, then
frames of points (x, y, z, residual) and analog samples.  A negative residual is a lost marker.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from springback.errors import InputError
from springback.logs.formats.text import metres
from springback.logs.frame_turns import WORLDS, vectors_in
from springback.logs.recording import (
    MARKERS,
    Array,
    Budget,
    Recording,
    TimeSpan,
    log_channel,
)

BLOCK = 512
#: Second byte of the file.
MAGIC = 0x50
#: Processor of little-endian files, in the fourth byte of the parameters.
INTEL = 84
#: Most bytes of parameters that are read (the format allows 255 blocks).
MOST_PARAMETERS = 255 * BLOCK


def read_markers(path: Path, part: TimeSpan, world: str) -> Recording:
    """Recording of a C3D file.

    Args:
        path: The file.
        part: Instants that are wanted, from its first frame on [s].
        world: Name of its world axes, of `springback.logs.frame_turns.WORLDS`.

    Raises:
        InputError: If it is none, is of another machine, or has no markers.
    """
    where = str(path)
    with path.open("rb") as file:
        head = file.read(BLOCK)
        if len(head) < BLOCK or head[1] != MAGIC:
            raise InputError(f"{where}: is no C3D file")
        points, analogs, first, last = struct.unpack_from("<4H", head, 2)
        scale, start = struct.unpack_from("<fH", head, 12)
        rate = struct.unpack_from("<f", head, 20)[0]
        file.seek(max(head[0] - 1, 1) * BLOCK)
        parameters = _parameters(where, file.read(MOST_PARAMETERS))
        names, unit = _labels(parameters, points)
        if not points:
            raise InputError(f"{where}: has no markers")
        if not (np.isfinite(rate) and rate > 0.0 and np.isfinite(scale) and scale != 0.0):
            raise InputError(f"{where}: its rate is {rate:g} Hz and its scale {scale:g}")
        if last < first:
            raise InputError(f"{where}: has frames {first} to {last}")
        counts = _counts(parameters, last - first + 1)
        form = np.dtype("<f4" if scale < 0.0 else "<i2")
        width = 4 * points + analogs
        budget = Budget(where)
        file.seek(max(start - 1, 1) * BLOCK)
        frames: list[Array] = []
        begin = max(0, int(np.ceil(part.first * rate))) if np.isfinite(part.first) else 0
        file.seek(begin * width * form.itemsize, 1)
        for k in range(begin, counts):
            data = file.read(width * form.itemsize)
            if len(data) < width * form.itemsize or k / rate > part.last:
                break
            budget.take(4 * points)
            row = np.frombuffer(data, dtype=form)[: 4 * points].astype(float)
            frames.append(row.reshape(points, 4))
    if not frames:
        raise InputError(f"{where}: has no frames")
    remarks, damage = list[str](), list[str]()
    if len(frames) < counts - begin and not np.isfinite(part.last):
        damage.append(f"ends after {len(frames)} of {counts} frames: it was cut off")
    if analogs:
        remarks.append(f"has analog samples, {analogs} numbers a frame: they are not read")
    values = np.stack(frames)
    places = values[..., :3] * (1.0 if scale < 0.0 else scale) * metres(unit, where)
    with np.errstate(invalid="ignore"):
        places[(values[..., 3] < 0.0) | ~np.isfinite(values).all(axis=2)] = np.nan
    turned = vectors_in(WORLDS[world], places).reshape(len(frames), -1)
    times = (begin + np.arange(len(frames))) / rate
    channel = log_channel(
        where, "markers", MARKERS, times, turned, clock="motion capture", labels=names
    )
    return Recording(path, "C3D", (channel,), remarks=tuple(remarks), damage=tuple(damage))


_Value = list[str] | list[float]


def _parameters(where: str, data: bytes) -> dict[str, _Value]:
    """Parameters by `GROUP:NAME`, those that are text or numbers."""
    if len(data) < 4:
        raise InputError(f"{where}: ends before its parameters")
    if data[3] != INTEL:
        raise InputError(
            f"{where}: is of another processor ({data[3]}): write it again as little-endian"
        )
    at, groups, found = 4, dict[int, str](), dict[str, _Value]()
    while at + 4 <= len(data):
        length, number = abs(struct.unpack_from("b", data, at)[0]), data[at + 1]
        if not length or not number:
            break
        name = data[at + 2 : at + 2 + length].decode("ascii", "replace").upper()
        here = at + 2 + length
        if here + 2 > len(data):
            break
        step = struct.unpack_from("<H", data, here)[0]
        if number >= 128:
            groups[256 - number] = name
        else:
            value = _value(data, here + 2)
            if value is not None:
                found[f"{groups.get(number, number)}:{name}"] = value
        if not step:
            break
        at = here + step
    return found


def _value(data: bytes, at: int) -> _Value | None:
    """Value of a parameter: texts, or numbers."""
    if at + 2 > len(data):
        return None
    kind, count = struct.unpack_from("b", data, at)[0], data[at + 1]
    sizes = list(data[at + 2 : at + 2 + count])
    at += 2 + count
    size = int(np.prod(sizes, dtype=np.int64)) if sizes else 1
    each = abs(kind)
    if each not in (1, 2, 4) or size * each > MOST_PARAMETERS or at + size * each > len(data):
        return None
    body = data[at : at + size * each]
    if kind == -1:
        width = max(sizes[0], 1) if sizes else 1
        return [
            body[k : k + width].decode("ascii", "replace").strip() for k in range(0, size, width)
        ]
    numbers = np.frombuffer(body, dtype={1: "u1", 2: "<i2", 4: "<f4"}[each])
    return [float(one) for one in numbers]


def _labels(parameters: dict[str, _Value], points: int) -> tuple[tuple[str, ...], str]:
    """Names of the markers, and the unit of length."""
    given = parameters.get("POINT:LABELS", [])
    names = [str(one) for one in given][:points]
    names += [f"marker {k + 1}" for k in range(len(names), points)]
    unit = parameters.get("POINT:UNITS", ["mm"])
    return tuple(names), str(unit[0]) if unit and unit[0] else "mm"


def _counts(parameters: dict[str, _Value], told: int) -> int:
    """Frames: more than 65535 are told in a parameter alone."""
    given = parameters.get("POINT:FRAMES") or [0.0]
    count = given[0]
    if isinstance(count, float):
        count = count + 65536.0 if count < 0.0 else count
        if count > told and np.isfinite(count):
            return min(int(count), 10**8)
    return told
