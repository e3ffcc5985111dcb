"""Drops of a frame: files of the recordings' form, and what is predicted of them."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from springback.errors import InputError
from springback.studies.recordings.drop_predictions import (
    FROZEN,
    STATIC,
    FrameLaw,
    block_law,
    drop_flight,
    measures_of,
    specific_force,
)
from springback.studies.recordings.frame_drops import (
    ACROSS,
    CASES,
    RECORDED,
    ROWS,
    SENSITIVITY,
    DropCase,
    DropSpread,
    drop_measures,
    fall_time,
    read_drop,
    read_drops,
    statistics_of,
)
from springback.vehicle.endurance import GRAVITY
from springback.vehicle.library import VEHICLES

PAGE = Path(__file__).parents[2] / "docs" / "recordings.md"
Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]


def readings(peak: float = 90.0, flight: int = 60, before: int = 400) -> Array:
    """Specific force along z [g]: held, a fall from 0.5 m, a peak 4 ms after the touch, rest."""
    falls = round(1e3 * fall_time(0.5))
    touch = [0.3 * peak, 0.4 * peak, 0.6 * peak, 0.8 * peak, peak, 0.5 * peak, 0.1 * peak]
    parts = [[1.0] * before, [0.0] * falls, touch, [0.0] * flight, [20.0, 8.0], [1.0] * 300]
    return np.concatenate([np.array(part) for part in parts])


def written(path: Path, force: Array, *, across: float = 0.0, step: int = 1000) -> Path:
    """A file of the form of the recordings."""
    rows = np.zeros(len(force), ROWS)
    rows["t"] = 77_000 + step * np.arange(len(force))
    rows["x"] = np.round(2019.0 + SENSITIVITY * ACROSS * across * (force > 3.0))
    rows["y"] = 2021
    rows["z"] = np.round(2020.0 + SENSITIVITY * force)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(rows.tobytes())
    return path


def test_a_drop_is_read_as_it_was_written(tmp_path: Path) -> None:
    """The zero comes from the fall: one gram's weight before it is no reading of zero."""
    force = readings()
    path = written(tmp_path / "acc_z-1.bin", force, across=30.0)
    read = read_drop(path, 0.5)
    assert read is not None
    found = drop_measures(read, 0.5)
    assert found.peak == pytest.approx(math.hypot(90.0, 30.0), abs=0.1)
    assert found.rise == pytest.approx(4e-3)
    # 60 ms in the air, after a fall of 319 ms.
    assert found.restitution == pytest.approx(30.0 / 319.0, rel=0.01)


def test_a_drop_that_begins_within_its_fall_is_left_out(tmp_path: Path) -> None:
    case = CASES[0]
    for k in range(3):
        written(tmp_path / case.folder / f"acc_b-{k}.bin", readings(80.0 + 10.0 * k))
    written(tmp_path / case.folder / "acc_b-9.bin", readings()[500:])
    drops = read_drops(tmp_path, case)
    assert len(drops) == 3
    found = statistics_of(drops)
    assert found.peak.median == pytest.approx(90.0, abs=0.1)
    assert found.peak.low == pytest.approx(85.0, abs=0.1)
    assert found.drops == 3


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "must hold rows of 10 bytes .got 0 bytes"),
        (b"123456789012", "must hold rows of 10 bytes .got 12 bytes"),
        (b"text " * 40, "must have a row every 1 ms"),
        (np.array([(k * 1000, 9000, 0, 0) for k in range(50)], ROWS).tobytes(), "below 4096"),
        (np.array([(k * 1000, 9, 9, 9) for k in range(50)], ROWS).tobytes(), "nothing was touched"),
    ],
)
def test_other_files_are_refused_in_one_line(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / CASES[0].folder / "acc_b-1.bin"
    path.parent.mkdir()
    path.write_bytes(content)
    with pytest.raises(InputError, match=words) as caught:
        read_drops(tmp_path, CASES[0])
    [line] = caught.value.problems
    assert line.startswith(f"{path}: ")


def test_a_folder_without_drops_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"has no SoftBottom_50cm/\*.bin; name a copy of github"):
        read_drops(tmp_path, CASES[0])
    with pytest.raises(InputError, match="nothing was touched"):
        drop_measures(np.zeros(50), 0.5)


# -- what is predicted ----------------------------------------------------------------------------


def table_rows() -> dict[str, list[str]]:
    """Cells of the page's table of drops, by their first."""
    lines = re.findall(r"^\| (\d+ cm, [^|]*?) \| (.*) \|$", PAGE.read_text(encoding="utf-8"), re.M)
    return {name: [cell.strip() for cell in rest.split("|")] for name, rest in lines}


def test_the_page_prints_what_is_frozen() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert f"{FROZEN.stiffness / 1e3:.1f} kN/m" in text
    assert f"{FROZEN.restitution:.3f}" in text
    assert f"{FROZEN.stiffness / STATIC:.1f} times" in text
    assert f"{block_law().stiffness / 1e6:.0f} MN/m" in text
    for case in CASES[:3]:
        peak = RECORDED[case.folder].peak
        cell = f"{peak.median:g} g ({peak.low:g} to {peak.high:g})"
        assert table_rows()[f"{1e2 * case.height:.0f} cm, peak"][0] == cell


def test_a_spread_holds_what_is_between_its_quartiles() -> None:
    spread = DropSpread(2.0, 1.0, 4.0)
    assert [spread.holds(x) for x in (0.9, 1.0, 3.9, 4.1)] == [False, True, True, False]


def peak_by_energy(law: FrameLaw, case: DropCase) -> float:
    """Largest specific force of one mass on one spring [g], from the energy in it at its deepest."""
    mass = VEHICLES[case.vehicle].vehicle.mass
    weight = mass * GRAVITY
    squared = weight**2 + 2.0 * law.stiffness * weight * case.height
    return (weight + math.sqrt(squared)) / weight


@pytest.mark.parametrize("case", CASES[:3], ids=lambda case: case.folder)
def test_predicted_peaks_are_those_of_the_energy_in_a_spring(case: DropCase) -> None:
    """Two formulations: the page's flights, and a formula; 1000 readings a second miss the top."""
    cells = table_rows()[f"{1e2 * case.height:.0f} cm, peak"]
    assert float(cells[1].split()[0]) == pytest.approx(peak_by_energy(FROZEN, case), rel=0.01)
    inside = RECORDED[case.folder].peak.holds(float(cells[1].split()[0]))
    assert cells[2] == ("fitted" if case == CASES[0] else "yes" if inside else "**no**")


def test_the_block_would_be_far_too_stiff() -> None:
    """As the page says; the peak of a body that stops on it, by the same formula."""
    found = peak_by_energy(block_law(), CASES[3])
    assert f"{found:.0f} g" in PAGE.read_text(encoding="utf-8")
    assert found / RECORDED[CASES[3].folder].peak.median > 20.0


def test_a_drop_is_flown_as_the_page_says() -> None:
    """The whole vehicle, from 100 cm."""
    case = CASES[1]
    flight = drop_flight(FROZEN, case)
    found, rows = measures_of(flight, case.height), table_rows()
    assert flight.measures["touch_speed"] == pytest.approx(math.sqrt(2.0 * GRAVITY), rel=1e-3)
    assert specific_force(flight)[0] < 1e-6  # it falls
    assert f"{found.peak:.0f} g" == rows["100 cm, peak"][1]
    assert f"{1e3 * found.rise:.0f} ms" == rows["100 cm, time to peak"][1]
    assert f"{found.restitution:.2f}" == rows["100 cm, restitution"][1]
