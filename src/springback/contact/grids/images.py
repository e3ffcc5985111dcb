"""Grey images as arrays of numbers: PNG with 8 or 16 bits, without another library."""

from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np

from springback.settings import problem

Array = np.ndarray[Any, np.dtype[np.float64]]

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
#: Colour types of PNG, for messages.
_COLOURS = {2: "colours", 3: "a palette", 4: "transparency", 6: "colours"}


def grey_image(file: str, data: bytes, most: int) -> Array:
    """Brightness of the pixels of a grey PNG, 0 to 1, the upper row first, shape (rows, columns).

    W3C, "Portable Network Graphics (PNG) Specification", third edition, sections 7 to 9 and 11.

    Args:
        file: Its name, for errors.
        data: Its content.
        most: Most pixels.

    Raises:
        The problem, if it is no such image, too large or damaged.
    """
    try:
        return _grey(file, data, most)
    except (struct.error, zlib.error, IndexError) as error:
        raise problem(f"{file}: is damaged ({error})", "file") from None


def _grey(file: str, data: bytes, most: int) -> Array:
    if not data.startswith(_SIGNATURE):
        raise problem(f"{file}: is not PNG", "file")
    width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    if colour != 0 or bits not in (8, 16):
        what = _COLOURS.get(colour, "grey") + f" of {bits} bits"
        raise problem(f"{file}: must be grey of 8 or 16 bits (has {what})", "file")
    if interlaced:
        raise problem(f"{file}: must not be interlaced", "file")
    if not 0 < width * height <= most:
        raise problem(f"{file}: must have at most {most} pixels (got {width} x {height})", "file")
    depth = bits // 8
    line, place, parts = width * depth + 1, 8, []
    while place < len(data):
        (size,), name = struct.unpack(">I", data[place : place + 4]), data[place + 4 : place + 8]
        if name == b"IDAT":
            parts.append(data[place + 8 : place + 8 + size])
        if name == b"IEND":
            break
        place += 12 + size
    packed = zlib.decompressobj()
    plain = packed.decompress(b"".join(parts), line * height)
    if len(plain) != line * height:
        raise problem(f"{file}: is damaged (ends early)", "file")
    rows = np.frombuffer(plain, dtype=np.uint8).reshape(height, line)
    before, found = np.zeros(line - 1, dtype=np.uint8), np.empty((height, line - 1), np.uint8)
    for k, row in enumerate(rows):
        before = found[k] = _unfiltered(file, int(row[0]), row[1:], before, depth)
    whole = found.reshape(height, width, depth)
    if depth == 1:
        return np.asarray(whole[:, :, 0] / 255.0)
    return np.asarray((256.0 * whole[:, :, 0] + whole[:, :, 1]) / 65535.0)


def _unfiltered(file: str, kind: int, row: Any, before: Any, depth: int) -> Any:
    """A line of an image, of which the filter tells how it was predicted."""
    if kind == 0:
        return row
    if kind == 2:
        return row + before
    if kind == 1:
        sums = np.cumsum(row.reshape(-1, depth).astype(np.int64), axis=0)
        return (sums & 255).astype(np.uint8).reshape(-1)
    if kind not in (3, 4):
        raise problem(f"{file}: is damaged (filter {kind})", "file")
    out, above = bytearray(row.tobytes()), before.tobytes()
    for k, value in enumerate(out):
        left = out[k - depth] if k >= depth else 0
        if kind == 3:
            guess = (left + above[k]) // 2
        else:
            corner = above[k - depth] if k >= depth else 0
            whole = left + above[k] - corner
            near = [(abs(whole - left), left), (abs(whole - above[k]), above[k])]
            best = min(near, key=lambda one: one[0])
            guess = best[1] if best[0] <= abs(whole - corner) else corner
        out[k] = (value + guess) & 255
    return np.frombuffer(bytes(out), dtype=np.uint8)
