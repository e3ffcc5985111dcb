"""C3D files, and EZC3D beside our reader."""

from __future__ import annotations

from pathlib import Path

import ezc3d
import numpy as np
import pytest

from builders.recordings import c3d, track_at
from springback.errors import InputError
from springback.logs.reading import LogOptions, read_recording


def written(tmp_path: Path, data: bytes) -> Path:
    (tmp_path / "take.c3d").write_bytes(data)
    return tmp_path / "take.c3d"


@pytest.mark.parametrize(("scale", "within"), [(-1.0, 1e-6), (0.1, 1e-4)])
def test_markers_are_read_in_metres_from_numbers_of_either_kind(
    tmp_path: Path, scale: float, within: float
) -> None:
    [markers] = read_recording(written(tmp_path, c3d(scale=scale))).channels
    assert markers.labels == ("M1", "M2", "M3")
    assert markers.times == pytest.approx(np.arange(100) / 200.0)
    place = track_at(markers.times)
    assert markers.values[:, :3] == pytest.approx(place, abs=within)
    assert markers.values[:, 3:6] == pytest.approx(place + np.array([0.1, 0.0, 0.0]), abs=within)
    assert np.argwhere(np.isnan(markers.values[:, 6])).tolist() == [[1]]


def test_ezc3d_reads_the_same(tmp_path: Path) -> None:
    path = written(tmp_path, c3d())
    [markers] = read_recording(path).channels
    other = ezc3d.c3d(str(path))["data"]["points"][:3]  # (3, markers, frames) [mm]
    mine = 1e3 * markers.values.reshape(-1, 3, 3)
    assert np.nan_to_num(mine) == pytest.approx(
        np.nan_to_num(np.moveaxis(other, 2, 0).swapaxes(1, 2)), abs=1e-3
    )


def test_a_file_that_ezc3d_writes_is_read(tmp_path: Path) -> None:
    made = ezc3d.c3d()
    made["parameters"]["POINT"]["RATE"]["value"] = [250.0]
    made["parameters"]["POINT"]["UNITS"]["value"] = ["m"]
    made["parameters"]["POINT"]["LABELS"]["value"] = ("A", "B")
    points = np.ones((4, 2, 30))
    points[0, 1] = np.arange(30)
    made["data"]["points"] = points
    made.write(str(tmp_path / "other.c3d"))
    [markers] = read_recording(tmp_path / "other.c3d").channels
    assert markers.labels == ("A", "B")
    assert markers.rate == pytest.approx(250.0)
    assert markers.values[5] == pytest.approx([1.0, 1.0, 1.0, 5.0, 1.0, 1.0])


def test_analog_samples_are_passed_over_and_it_is_said(tmp_path: Path) -> None:
    made = ezc3d.c3d()
    made["parameters"]["POINT"]["RATE"]["value"] = [250.0]
    made["parameters"]["POINT"]["UNITS"]["value"] = ["m"]
    made["parameters"]["POINT"]["LABELS"]["value"] = ("A",)
    made["parameters"]["ANALOG"]["RATE"]["value"] = [1000.0]
    made["parameters"]["ANALOG"]["LABELS"]["value"] = ("F1", "F2")
    points = np.ones((4, 1, 30))
    points[1, 0] = np.arange(30)
    made["data"]["points"] = points
    made["data"]["analogs"] = np.full((1, 2, 120), 7.0)
    made.write(str(tmp_path / "forces.c3d"))
    log = read_recording(tmp_path / "forces.c3d")
    assert log.channels[0].values[:, 1] == pytest.approx(np.arange(30.0))
    assert log.remarks == ("has analog samples, 8 numbers a frame: they are not read",)


def test_a_part_and_other_axes_are_read(tmp_path: Path) -> None:
    path = written(tmp_path, c3d())
    [markers] = read_recording(path, LogOptions(first=0.1, last=0.2, world="y-up")).channels
    assert markers.span == pytest.approx((0.1, 0.2))
    x, y, z = track_at(markers.times)[0]
    assert markers.values[0, :3] == pytest.approx([x, -z, y], abs=1e-6)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"\2\x50" + bytes(600), "ends before its parameters|is of another processor"),
        (b"nothing" * 100, "is no C3D file"),
        (c3d()[:2] + b"\0\0" + c3d()[4:], "has no markers"),
        (c3d()[:515] + b"\x55" + c3d()[516:], r"is of another processor \(85\)"),
        (c3d()[:1024], "has no frames"),
    ],
)
def test_what_is_no_c3d_is_refused_in_a_line(tmp_path: Path, data: bytes, said: str) -> None:
    with pytest.raises(InputError, match=said) as refused:
        read_recording(written(tmp_path, data))
    assert len(refused.value.problems) == 1


def test_a_file_that_is_cut_off_is_read_as_far_as_it_goes(tmp_path: Path) -> None:
    log = read_recording(written(tmp_path, c3d()[:-100]))
    assert len(log.channels[0].times) == 97
    assert log.damage == ("ends after 97 of 100 frames: it was cut off",)
