"""Tables of one's own: units, axes, blanks, and what is wrong in a line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.recordings import ROWS, files, whole, write_parquet
from springback.errors import InputError
from springback.logs.reading import LogOptions, read_recording
from springback.logs.writing.writers import write_recording

MAPPING = """
file = "log.csv"
[axes]
world = "enu"
body = "frd"
[[channels]]
name = "imu"
quantity = "specific force"
columns = ["ax", "ay", "az"]
unit = "gn"
time = "t"
time_unit = "ms"
full_scale = "16 gn"
average = "4 ms"
low_pass = "218 Hz"
low_pass_order = 2
[[channels]]
name = "body"
quantity = "position"
columns = ["x", "y", "z"]
unit = "mm"
time = "t"
time_unit = "ms"
[[channels]]
name = "turn"
quantity = "attitude"
columns = ["qx", "qy", "qz", "qw"]
order = "xyzw"
time = "t"
time_unit = "ms"
"""
TABLE = """\
# a comment
t,ax,ay,az,x,y,z,qx,qy,qz,qw,more
0,0.1,0.2,-1.0,1000,2000,500,0,0,0,1,word
5,0.1,0.2,-1.0,,,,,,,,word
10,16.0,0.2,-1.0,1000,2000,500,0,0,0,1,word
"""


def read(tmp_path: Path, mapping: str = MAPPING, table: str = TABLE, **options: Any):
    (tmp_path / "log.toml").write_text(mapping)
    (tmp_path / "log.csv").write_text(table)
    return read_recording(tmp_path / "log.toml", LogOptions(**options))


def test_units_and_axes_are_those_of_the_mapping(tmp_path: Path) -> None:
    """East, north, up in mm; forward, right, down in g; a body that looks east."""
    imu, body, turn = read(tmp_path).channels
    assert imu.times.tolist() == [0.0, 0.005, 0.01]
    assert imu.values[0] == pytest.approx([0.980665, -1.96133, 9.80665])
    assert body.values[0] == pytest.approx([2.0, -1.0, 0.5])
    assert body.times.tolist() == [0.0, 0.01]  # a blank is no sample
    half = np.sqrt(0.5)  # FRD's x along ENU's east: -90 deg about NWU's z, and a roll of 180
    assert np.abs(turn.values[0]) == pytest.approx([0.0, half, half, 0.0], abs=1e-12)
    assert (imu.chain.average, imu.chain.low_pass) == (0.004, 218.0)
    assert imu.chain.low_pass_order == 2
    assert imu.chain.full_scale == pytest.approx(156.9064)
    assert imu.clipped is not None
    assert imu.clipped[:, 0].tolist() == [False, False, True]


def test_samples_at_the_end_of_the_range_are_told_by_columns_or_by_the_range(
    tmp_path: Path,
) -> None:
    """A converter of 16 bits ends a count below 16 gn on one side, which was no clip before."""
    step = 16.0 / 2**15
    table = TABLE.replace("10,16.0,0.2,-1.0", f"10,{16.0 - step:.8f},{16.0 - 4.0 * step:.8f},-16.0")
    flags = read(tmp_path, table=table).channels[0].clipped
    assert flags is not None
    assert flags.tolist() == [[False] * 3, [False] * 3, [True, False, True]]
    own = MAPPING.replace('low_pass = "218 Hz"', 'clipped = ["x", "y", "z"]', 1).replace(
        "low_pass_order = 2\n", ""
    ).replace('body = "frd"', 'body = "rfu"')  # fmt: skip
    words = TABLE.replace("0,0.1,0.2,-1.0,1000,2000,500", "0,0.1,0.2,-1.0,1,0,0")
    words = words.replace("10,16.0,0.2,-1.0,1000,2000,500", "10,16.0,0.2,-1.0,0,0,1")
    flags = read(tmp_path, own, words).channels[0].clipped
    assert flags is not None  # right, front, up: the first column is the second axis
    assert flags.tolist() == [[False, True, False], [False] * 3, [False, False, True]]


def test_blanks_are_lost_samples_where_the_mapping_says_so(tmp_path: Path) -> None:
    mapping = MAPPING.replace('unit = "mm"', 'unit = "mm"\nblank = "lost"')
    body = read(tmp_path, mapping).channels[1]
    assert body.is_lost.tolist() == [False, True, False]


def test_a_part_is_read(tmp_path: Path) -> None:
    assert read(tmp_path, first=0.004).channels[0].times.tolist() == [0.005, 0.01]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"ax", "ay", "az"', '"ax", "ay"', "channels[0].columns: specific force needs 3 columns (got 2)"),
        ('"ax"', '"aix"', "has no column 'aix'; did you mean ax?"),
        ('unit = "gn"', 'unit = "kg"', "channels[0].unit: "),
        ('unit = "gn"', 'unti = "gn"', "channels[0].unti: unknown key; did you mean unit?"),
        ("specific force", "spezific force", "channels[0].quantity: is not known; did you mean specific force?"),
        ('world = "enu"', 'world = "enuu"', "axes.world: is not known; did you mean enu?"),
        ('time_unit = "ms"', 'time_unit = "m"', "channels[0].time_unit: "),
        ('file = "log.csv"', 'file = "none.csv"', "file: there is no file"),
        ('file = "log.csv"', "", "file: is missing"),
        ('full_scale = "16 gn"', 'full_scale = "16 kg"', "channels[0].full_scale: "),
        ('average = "4 ms"', 'average = "-4 ms"', "channels[0].average: must be more than 0 s"),
        ('time = "t"', 'time = "t"\nclipped = ["ax"]', "channels[0].clipped: needs one for each of 3 columns (got 1)"),
        ('time = "t"', 'time = "t"\nclipped = ["ax", "ay", "aw"]', "has no column 'aw'; it has t, ax"),
        ('order = "xyzw"', 'clipped = ["qx", "qy", "qz", "qw"]', "channels[2].clipped: an attitude has no range"),
        ("[[channels]]", "[[channels", "is not TOML"),
    ],
)  # fmt: skip
def test_a_wrong_mapping_is_refused_by_key(tmp_path: Path, old: str, new: str, said: str) -> None:
    with pytest.raises(InputError) as refused:
        read(tmp_path, MAPPING.replace(old, new, 1))
    assert said in refused.value.problems[0]
    assert "log." in refused.value.problems[0] or "none.csv" in refused.value.problems[0]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("10,16.0", "10,sixteen", "log.csv:5: ax: must be a number (got 'sixteen')"),
        ("10,16.0", "10,1_6", "log.csv:5: ax: must be a number (got '1_6')"),
        ("5,0.1", "x,0.1", "log.csv:4: t: must be a number (got 'x')"),
        (TABLE, "t,ax\n", "has no column 'ay'"),
        (TABLE, "", "is empty"),
        (TABLE, TABLE.splitlines()[1], "has no lines of numbers"),
        (TABLE, TABLE.splitlines()[1] + '\n"1,2', "log.csv:2: t: must be a number (got '1,2')"),
    ],
)
def test_a_wrong_table_is_refused_by_line(tmp_path: Path, old: str, new: str, said: str) -> None:
    with pytest.raises(InputError) as refused:
        read(tmp_path, table=TABLE.replace(old, new, 1))
    [line] = refused.value.problems
    assert said in line or (said == "is empty" and "has no lines" in line)


def test_parquet_is_read_by_the_same_mapping(tmp_path: Path) -> None:
    write_parquet(tmp_path / "rows.parquet")
    (tmp_path / "rows.toml").write_text(ROWS)
    [imu] = read_recording(tmp_path / "rows.toml").channels
    assert imu.times[:2].tolist() == [0.0, 0.005]
    assert imu.values[1] == pytest.approx([0.00980665, 0.0, 9.80665])
    (tmp_path / "rows.parquet").write_bytes(b"PAR1 nothing")
    with pytest.raises(InputError, match="cannot be read as Parquet"):
        read_recording(tmp_path / "rows.toml")


def test_what_is_written_is_read_back_to_the_last_bit(tmp_path: Path) -> None:
    made = whole(1.0, 200.0)
    write_recording(made, tmp_path / "log.csv")
    back = read_recording(tmp_path / "log.toml")
    for one, other in nonempty(zip(made.channels, back.channels, strict=True)):
        assert (one.name, one.quantity, one.clock) == (other.name, other.quantity, other.clock)
        assert np.array_equal(one.times, other.times)
        assert one.values == pytest.approx(other.values, abs=1e-15)
        assert one.chain == other.chain


def test_the_files_of_the_builder_are_those_that_are_written() -> None:
    assert {"table.csv", "table.toml"} <= files().keys()
