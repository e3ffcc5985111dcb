"""Text files of motion captures: variants of their headers, units, and orders of angles."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.cases import nonempty
from builders.recordings import attitude_at, files, poses, track_at
from springback.errors import InputError
from springback.logs.frame_turns import world_vectors
from springback.logs.reading import LogOptions, read_recording
from springback.logs.recording import ATTITUDE, MARKERS, POSITION


def read(tmp_path: Path, name: str, text: str, **options: Any):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return read_recording(path, LogOptions(**options))


# -- Motive ---------------------------------------------------------------------------------------

MOTIVE = """\
Format Version,1.24,Take Name,Take 1,Capture Frame Rate,240.000000,Export Frame Rate,120.000000,\
Rotation Type,Quaternion,Length Units,Millimeters,Coordinate Space,Global

,Type,,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Marker,Marker,Marker
,Name,,arq,arq,arq,arq,arq,arq,arq,arq,M1,M1,M1
,ID,,1,1,1,1,1,1,1,1,2,2,2
,Parent,,,,,,,,,,,,
,,,Position,Position,Position,Rotation,Rotation,Rotation,Rotation,Mean Marker Error,Position,Position,Position
Frame,Time (Seconds),,X,Y,Z,X,Y,Z,W,,X,Y,Z
0,0.000000,,1000.0,2000.0,-3000.0,0.0,0.70710678,0.0,0.70710678,0.1,1.0,2.0,3.0
1,0.008333,,,,,,,,,,1.0,2.0,3.0
2,0.016667,,1000.0,2000.0,-3000.0,0.0,0.70710678,0.0,0.70710678,0.1,,,
"""


def test_motives_rows_are_found_by_their_labels_and_y_up_is_turned(tmp_path: Path) -> None:
    """A turn about Motive's Y, which is up, is a yaw."""
    log = read(tmp_path, "take.csv", MOTIVE)
    told = {one.name: one for one in log.channels}
    assert told["arq.position"].values[0] == pytest.approx([1.0, 3.0, 2.0])
    assert told["arq.attitude"].values[0] == pytest.approx([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)])
    assert told["arq.position"].is_lost.tolist() == [False, True, False]
    assert told["markers"].values[0] == pytest.approx([0.001, -0.003, 0.002])
    assert told["markers"].labels == ("M1",)
    assert "was captured at 240 Hz and exported at 120 Hz" in log.remarks
    assert told["arq.position"].chain.smoothed


@pytest.mark.parametrize("words", [("z-up", "flu")])
def test_other_axes_are_taken_where_they_are_given(tmp_path: Path, words: tuple[str, str]) -> None:
    log = read(tmp_path, "take.csv", MOTIVE, world=words[0], body=words[1])
    assert log.channels[0].values[0] == pytest.approx([1.0, 2.0, -3.0])
    with pytest.raises(InputError, match=r"--world: 'enuu' is not known; did you mean enu\?"):
        read(tmp_path, "take.csv", MOTIVE, world="enuu")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Quaternion", "XYZ", "Rotation Type is 'XYZ': export it as Quaternion"),
        ("Global", "Local", "Coordinate Space is 'Local': export it as Global"),
        ("Millimeters", "Furlongs", "the unit of length 'Furlongs' is not known"),
        ("Frame,Time (Seconds)", "Frame,Timecode", "has no column of Time beside Frame"),
        (",Name,,", ",Nom,,", "has no row of Name above its data"),
        ("0,0.000000", "0,zero", r"take.csv:9: Time: must be a number (got 'zero')"),
        ("-3000.0,0.0", "-3000.0m,0.0", r"take.csv:9: arq Z: must be a number (got '-3000.0m')"),
        ("Frame,", "Frme,", "has no row that begins with Frame"),
        ("0,0.000000", "0,", "frame 1 of its data has no time"),
        ("0.008333", "-8.33", "its clock goes back by"),
    ],
)  # fmt: skip
def test_what_motive_should_not_have_exported_is_refused(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    with pytest.raises(InputError) as refused:
        read(tmp_path, "take.csv", MOTIVE.replace(old, new, 1))
    [line] = refused.value.problems
    assert said in line


# -- Vicon ----------------------------------------------------------------------------------------


def vicon(turns: str = "vector", *, markers: bool = True, unit: str = "deg") -> str:
    """Nexus's file of one body with four markers, in mm."""
    t = np.arange(0.0, 1.0, 0.01)
    q, place = attitude_at(t), track_at(t)
    rotation = Rotation.from_quat(q, scalar_first=True)
    angles = rotation.as_rotvec() if turns == "vector" else rotation.as_euler("XYZ")
    angles = np.degrees(angles) if unit == "deg" else angles
    lines = ["Segments", "100", ",,arq:body,,,,,", "Frame,Sub Frame,RX,RY,RZ,TX,TY,TZ"]
    lines.append(f",,{unit},{unit},{unit},mm,mm,mm")
    lines += [
        ",".join([str(k + 1), "0", *(f"{x:.9f}" for x in (*angles[k], *(1e3 * place[k])))])
        for k in range(len(t))
    ]
    if markers:
        corners = np.array([[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [-0.1, 0.0, 0.05], [0.0, -0.1, 0.0]])
        lines += ["", "Trajectories", "100", ",,arq:A,,,arq:B,,,arq:C,,,arq:D,,"]
        lines += ["Frame,Sub Frame" + ",X,Y,Z" * 4, ",," + ",".join(["mm"] * 12)]
        for k in range(len(t)):
            at = (world_vectors(np.tile(q[k], (4, 1)), corners) + place[k]) * 1e3
            lines.append(",".join([str(k + 1), "0", *(f"{x:.6f}" for x in at.reshape(-1))]))
    return "\n".join([*lines, "", "Devices", "1000", "anything", ""])


@pytest.mark.parametrize("turns", ["vector", "euler"])
@pytest.mark.parametrize("unit", ["deg", "rad"])
def test_vicons_angles_are_tried_on_the_markers(tmp_path: Path, turns: str, unit: str) -> None:
    log = read(tmp_path, "take.csv", vicon(turns, unit=unit))
    told = {one.quantity: one for one in log.channels}
    t = told[ATTITUDE].times
    assert t == pytest.approx(np.arange(0.0, 1.0, 0.01))
    assert told[ATTITUDE].values == pytest.approx(attitude_at(t), abs=1e-7)
    assert told[POSITION].values == pytest.approx(track_at(t), abs=1e-9)
    assert told[MARKERS].values.shape == (100, 12)
    assert ("Euler" in " ".join(log.remarks)) is (turns == "euler")
    assert "Devices are not read" in log.remarks


def test_vicons_angles_without_markers_are_taken_as_a_rotation_vector_and_it_is_said(
    tmp_path: Path,
) -> None:
    log = read(tmp_path, "take.csv", vicon(markers=False))
    assert "no marker of the file shows" in log.remarks[1]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Segments\n100", "Segments\nfast", "the rate of Segments: must be a positive number"),
        ("deg,deg,deg", "turns,deg,deg", "angles are in 'turns', not deg or rad"),
        ("Frame,Sub", "Fram,Sub", "must begin with Frame,Sub Frame (got 'Fram')"),
        ("\n7,0,", "\n,0,", "a line has no number of its frame"),
    ],
)
def test_what_vicon_should_not_have_exported_is_refused(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    with pytest.raises(InputError) as refused:
        read(tmp_path, "take.csv", vicon().replace(old, new, 1))
    [line] = refused.value.problems
    assert said in line


# -- Qualisys -------------------------------------------------------------------------------------


def qualisys(order: str = "F", *, header: str = "Frame\tTime\tX\tY\tZ\n", time: bool = True) -> str:
    t = np.arange(0.0, 0.5, 0.01)
    rotation = Rotation.from_quat(attitude_at(t), scalar_first=True)
    lines = ["NO_OF_FRAMES\t50", "NO_OF_BODIES\t1", "FREQUENCY\t100", "DATA_INCLUDED\t6D"]
    lines.append("BODY_NAMES\tarq")
    angles, place = rotation.as_euler("XYZ", degrees=True), 1e3 * track_at(t)
    for k, matrix in enumerate(rotation.as_matrix()):
        numbers = [*place[k], *angles[k], 0.3, *matrix.reshape(-1, order=order)]  # type: ignore[call-overload]
        lead = [str(k + 1), f"{t[k]:.5f}"] if time else []
        lines.append("\t".join([*lead, *(f"{x:.7f}" for x in numbers)]))
    head, rest = lines[:5], lines[5:]
    return "\n".join([*head, *([header.strip()] if header else []), *rest, ""])


@pytest.mark.parametrize("order", ["F", "C"])
@pytest.mark.parametrize("time", [True, False])
def test_qualisys_matrices_are_read_in_the_order_that_fits_their_angles(
    tmp_path: Path, order: str, time: bool
) -> None:
    log = read(
        tmp_path,
        "take.tsv",
        qualisys(order, header="" if not time else "Frame\tTime\tX\tY\tZ", time=time),
    )
    told = {one.quantity: one for one in log.channels}
    t = told[ATTITUDE].times
    assert t == pytest.approx(np.arange(0.0, 0.5, 0.01))
    assert told[ATTITUDE].values == pytest.approx(attitude_at(t), abs=1e-6)
    assert told[POSITION].values == pytest.approx(track_at(t), abs=1e-9)
    assert log.remarks == ()


def test_a_lost_body_of_qualisys_is_all_zeros(tmp_path: Path) -> None:
    lines = qualisys().splitlines()
    lines[8] = "\t".join([*lines[8].split("\t")[:2], *["0.000"] * 16])
    log = read(tmp_path, "take.tsv", "\n".join(lines))
    assert all(np.flatnonzero(one.is_lost).tolist() == [2] for one in log.channels)


def test_markers_of_qualisys_are_read(tmp_path: Path) -> None:
    text = (
        "NO_OF_FRAMES\t2\nFREQUENCY\t200\nDATA_INCLUDED\t3D\nMARKER_NAMES\tA\tB\n"
        "1.0\t2.0\t3.0\t0.0\t0.0\t0.0\n1.0\t2.0\t3.0\t4.0\t5.0\t6.0\n"
    )
    [markers] = read(tmp_path, "take.tsv", text).channels
    assert markers.labels == ("A", "B")
    assert markers.times.tolist() == [0.0, 0.005]
    assert markers.values[1] == pytest.approx([1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3])
    assert markers.is_lost.tolist() == [True, False]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("BODY_NAMES\tarq", "NAMES\tarq", "names neither markers nor bodies"),
        ("BODY_NAMES\tarq", "BODY_NAMES\tarq\tquad", "its lines have 18 numbers; 2 bodies need 16"),
        ("FREQUENCY", "FREQUENCE", ""),
        ("\t0.3000000\t", "\t0.3000000\t9", "Rot of frame 1 is no rotation"),
    ],
)
def test_what_qualisys_should_not_have_exported_is_refused(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    text = qualisys().replace(old, new, 1)
    if not said:  # times are in the file, so that the rate is not needed
        read(tmp_path, "take.tsv", text)
        return
    with pytest.raises(InputError) as refused:
        read(tmp_path, "take.tsv", text)
    [line] = refused.value.problems
    assert said in line


def test_an_external_frequency_needs_times(tmp_path: Path) -> None:
    text = qualisys(header="", time=False).replace("FREQUENCY\t100", "FREQUENCY\tEXT")
    with pytest.raises(InputError, match="FREQUENCY is 'EXT' and there is no column of Time"):
        read(tmp_path, "take.tsv", text)


# -- all ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["motive.csv", "vicon.csv", "qualisys.tsv"])
def test_what_is_written_is_read_back(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(files()[name])
    log = read_recording(tmp_path / name)
    for one, made in nonempty(zip(log.channels, poses(1.0), strict=True)):
        assert (one.name, one.quantity) == (made.name, made.quantity)
        assert one.times == pytest.approx(made.times, abs=1e-9)
        assert one.values == pytest.approx(made.values, abs=1e-6)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.csv", "t,ax,ay\n0,1,2\n", "is neither of Motive nor of Vicon; a table of your own needs a mapping"),
        ("a.tsv", "t\tax\n0\t1\n", "is not of Qualisys"),
        ("a.txt", "1", "'.txt' is no format of logs that is known (.ulg, .bin, .bag"),
        ("a.csv", "Format Version," + "x" * 1_000_001, "a.csv:1: has more than 1,000,000 characters"),
    ],
)  # fmt: skip
def test_other_files_are_refused_in_a_line(tmp_path: Path, name: str, text: str, said: str) -> None:
    with pytest.raises(InputError) as refused:
        read(tmp_path, name, text)
    [line] = refused.value.problems
    assert said in line
    with pytest.raises(InputError, match="there is no such file"):
        read_recording(tmp_path / "none.ulg")
