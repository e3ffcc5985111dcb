"""Logs of every format, damaged or hostile, and what is promised for them.

A log is either read, and then looked through and searched for impacts with finite answers, or
refused in lines that a terminal can show.  Nothing is printed on the way.
"""

from __future__ import annotations

import contextlib
import io
import json
import tempfile
from pathlib import Path
from typing import NamedTuple

from hypothesis import strategies as st

from builders.recordings import ROWS, files
from springback.logs.overview import as_data, overview
from springback.logs.reading import read_recording

#: Most characters of a remark.
LONGEST = 2500
#: Pieces that are put into files.
PIECES = [
    b"\x00", b"\xff" * 4, b"\xff\x7f" * 4, b"\x00\x00\x80\x7f", b"\x00\x00\xc0\x7f" * 3, b"-1", b"nan", b"inf", b"1e999",
    b",", b"\n", b"\t", b'"', b"\r", b"1_0", b"Frame", b"Rotation Type,XYZ,", b"Segments\n", b"\xa3\x95\x80", b"\xa3\x95\x41",
    b"/\x73\x13\x20\x25\x0c\xbb\x12", b"uint64_t[65535] x;", b"Millimeters", b"EXT", b"float[3] q", b"D\x00\x00", b"\x1b[31m",
    b"\xe2\x80\xae", b"99999999999999999999", b"file = ", b"unit = ", b"[[channels]]", b"=", b"PAR1",
]  # fmt: skip


class LogFile(NamedTuple):
    """A log, with files that stand beside it."""

    name: str
    data: bytes
    damaged: str  # which file has the data: the log, or its table

    def __repr__(self) -> str:
        """Short: a round is run again by its seed."""
        return f"<{self.damaged}, {len(self.data)} bytes from {self.data[:40]!r}>"


#: Files that are damaged, and the log that is then read.
NAMES = {name: name for name in ("ulog.ulg", "mcap.mcap", "motive.csv", "vicon.csv", "qualisys.tsv",
         "table.toml", "bag.db3", "first.bag", "log.bin", "markers.c3d")} | {
    "table.csv": "table.toml", "rows.parquet": "rows.toml",
}  # fmt: skip


@st.composite
def logs(draw: st.DrawFn) -> LogFile:
    """A log with bytes exchanged, cut out, doubled or put in, or cut off."""
    damaged = draw(st.sampled_from(sorted(NAMES)))
    data = files()[damaged]
    early = draw(st.booleans())  # headers are short, and read first
    for _ in range(draw(st.integers(0, 4))):
        first = draw(st.integers(0, min(len(data), 2000) if early else len(data)))
        last = min(len(data), first + draw(st.integers(0, 40)))
        new = draw(st.one_of(
            st.sampled_from(PIECES), st.binary(max_size=8), st.just(data[first:last] * 2), st.just(b""),
            st.just(bytes(255 - b for b in data[first:last])),
        ))  # fmt: skip
        data = data[:first] + new + data[last:]
    if draw(st.integers(0, 3)) == 0:
        data = data[: draw(st.integers(0, len(data)))]
    return LogFile(NAMES[damaged], data, damaged)


def log_file(given: LogFile) -> None:
    """As `springback identify inspect` reads it.

    Raises:
        InputError: If it is refused.
    """
    said = io.StringIO()
    with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(said):
        folder = Path(name)
        for beside in ("table.csv", "table.toml", "rows.parquet"):
            (folder / beside).write_bytes(files()[beside])
        (folder / "rows.toml").write_text(ROWS)
        (folder / given.damaged).write_bytes(given.data)
        recording = read_recording(folder / given.name)
        found = overview([recording])
        json.dumps(as_data(found), allow_nan=False)
        for text in (*found.remarks, *found.missing, found.verdict):
            assert len(text) < LONGEST
    assert said.getvalue() == ""
