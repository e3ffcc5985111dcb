"""Published identification of a dropped frame: its steps, on drops whose answers are known."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy

from springback.errors import InputError
from springback.studies.recordings.frame_drops import CASES, ROWS
from springback.studies.recordings.frame_identification import (
    ALONG,
    DIGESTS,
    MAP,
    MASS,
    MEANT,
    NOTEBOOK,
    PUBLISHED_FREE,
    PUBLISHED_STIFFNESS,
    SOFT,
    WRITTEN,
    ZEROS,
    DropMisfit,
    G,
    folder_digest,
    identification_lines,
    impact_sizes,
    map_range,
    predicted_sizes,
    pressed_forces,
    pressed_stiffness,
)

PAGE = Path(__file__).parents[2] / "docs" / "recordings.md"
TRUE = (30.0, 6000.0)
Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]


def drop(height: float, corner: float = MEANT, factor: float = 1.0) -> Array:
    """Size of the specific force [g] of a drop whose answers are known, from touch to its peak."""
    told = predicted_sizes(*TRUE, height, 20, corner) / G
    return np.asarray(factor * told[: int(told.argmax()) + 1])


def write_drop(path: Path, size: Array) -> None:
    """A file of the recordings' form: held, a fall, the impact, rest."""
    force = np.concatenate([np.ones(40), np.zeros(60), size, np.ones(30)])
    rows = np.zeros(len(force), ROWS)
    rows["t"] = 5000 + 1000 * np.arange(len(force))
    rows["x"], rows["y"] = round(ZEROS[0]), round(ZEROS[1])
    rows["z"] = np.round(ZEROS[2] + ALONG[2] * force)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(rows.tobytes())


def write_copy(folder: Path) -> Path:
    """A copy of the repository's form, with answers that are known."""
    for case in CASES:
        for k, factor in enumerate((0.9, 1.0, 1.1)):
            ending = "bhn" if case.height == 1.0 and k == 2 else "bin"
            write_drop(
                folder / case.folder / f"acc_a-{k}.{ending}", drop(case.height, MEANT, factor)
            )
    forces = [[0.0, 3.6], *([round(MASS * G + 5000.0 * x, 6), 3.6 - 100.0 * x]
                            for x in (0.002, 0.006, 0.011))]  # fmt: skip
    listed = ", ".join(map(str, forces))
    cells = [{"source": ["x = 1\n"]}, {"source": ["# pressed\n", f"FxD = {listed}\n", "y = 2"]}]
    (folder / NOTEBOOK).write_text(json.dumps({"cells": cells}), encoding="utf-8")
    criterion = DropMisfit({case.height: impact_sizes(folder / case.folder) for case in SOFT})
    grid = [
        [criterion.mean_square(c, k, WRITTEN) for c in np.linspace(0.0, 100.0, 11)]
        for k in np.linspace(0.0, 15000.0, 16)
    ]
    np.savetxt(folder / MAP, np.array(grid))
    return folder


@pytest.mark.parametrize("corner", [WRITTEN, MEANT])
@pytest.mark.parametrize("damping", [46.0, 90.0])  # below and above the critical damping
def test_the_prediction_is_that_of_the_notebook(damping: float, corner: float) -> None:
    """Its formulation: SciPy's ``lsim`` of the mass, spring and damper, then of the low-pass."""
    times, stiffness = 1e-3 * np.arange(30), 7040.0
    system = scipy.signal.StateSpace(
        np.array([[0.0, 1.0], [-stiffness / MASS, -damping / MASS]]), np.array([[0.0], [G]]),
        np.array([1.0, 0.0]), np.array([[0.0]]),
    )  # fmt: skip
    begin = [0.0, math.sqrt(2.0 * G * 1.5)]
    _, _, states = scipy.signal.lsim(system, np.ones(30), times, X0=begin)
    size = np.abs(states @ [-stiffness / MASS, -damping / MASS] + G)
    _, told, _ = scipy.signal.lsim(scipy.signal.lti([corner], [1.0, corner]), size, times)
    ours = predicted_sizes(damping, stiffness, 1.5, 30, corner)
    assert ours == pytest.approx(told, rel=1e-9, abs=1e-9)


def test_the_criterion_finds_what_drops_were_made_with_and_a_wrong_corner_does_not() -> None:
    """A corner that is 6.3 times too low is taken for damping: twice as much of it."""
    drops = {case.height: [np.append(drop(case.height), np.zeros(20))] for case in SOFT}
    criterion = DropMisfit(drops)
    found = criterion.optimum(MEANT)
    assert (found.damping, found.stiffness) == pytest.approx(TRUE, rel=1e-3)
    assert found.mean_square < 1e-3
    wrong = criterion.optimum(WRITTEN)
    assert wrong.damping > 1.5 * TRUE[0]
    assert wrong.mean_square > 100.0 * max(found.mean_square, 1e-3)


def test_the_criterion_weighs_heights_and_drops_alike() -> None:
    """A mean over the samples of a drop, a mean over the drops, a sum over the heights."""
    one, other = drop(0.5), drop(1.5)
    low = predicted_sizes(40.0, 8000.0, 0.5, len(one) - 1, MEANT) - G * one[:-1]
    high = predicted_sizes(40.0, 8000.0, 1.5, len(other) - 1, MEANT) - G * other[:-1]
    criterion = DropMisfit({0.5: [one, one, one], 1.5: [other]})
    expected = float((low**2).mean() + (high**2).mean())
    assert criterion.mean_square(40.0, 8000.0, MEANT) == pytest.approx(expected)


def test_the_lines_of_a_copy(tmp_path: Path) -> None:
    lines = list(identification_lines(write_copy(tmp_path)))
    soft = next(line for line in lines if line.startswith("SoftBottom_100cm"))
    assert soft.startswith("SoftBottom_100cm: 2 recordings and 1 whose ending is misspelt, ")
    assert "files are not those published in 2021" in soft
    peak = float(soft.split("median peak ")[1].split(" g")[0])
    assert peak == pytest.approx(drop(1.0).max(), abs=0.1)  # a count is 0.11 g
    assert any("4 forces" in line for line in lines)
    assert any("published map at 25 points" in line and "within 0 " in line for line in lines)
    meant = next(line for line in lines if line.startswith("corner of 500 Hz"))
    damping, stiffness = meant.split(": ")[1].split(" N/m")[0].split(" N s/m and ")
    assert (float(damping), float(stiffness)) == pytest.approx(TRUE, rel=0.05)
    assert "contradicts the published 46 N s/m" in meant


def test_forces_are_fitted_through_the_weight_and_through_any(tmp_path: Path) -> None:
    """A line through the weight has its slope both ways; with a force at zero, only without."""
    displacements, forces = pressed_forces(write_copy(tmp_path))
    assert forces[0] == 0.0
    through, _ = pressed_stiffness(displacements, forces)
    assert through == pytest.approx(5000.0, rel=1e-6)  # the first pair is at no displacement
    x = np.array([0.0, 0.004, 0.008])
    assert pressed_stiffness(x, 3000.0 * x + MASS * G) == pytest.approx((3000.0, 3000.0))
    assert pressed_stiffness(x, 3000.0 * x + 20.0)[1] == pytest.approx(3000.0)


def test_a_range_of_a_map_is_where_it_is_near_its_minimum() -> None:
    stiffness, damping = np.meshgrid(
        np.linspace(0, 15000, 31), np.linspace(0, 100, 21), indexing="ij"
    )
    values = 100.0 + ((stiffness - 7000.0) / 1000.0) ** 2 + ((damping - 45.0) / 5.0) ** 2
    assert map_range(values, 0.01) == pytest.approx((40.0, 50.0, 6000.0, 8000.0))


def test_a_digest_is_of_names_and_contents(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"one")
    first = folder_digest(tmp_path)
    (tmp_path / "a").rename(tmp_path / "b")
    second = folder_digest(tmp_path)
    (tmp_path / "b").write_bytes(b"two")
    assert len({first, second, folder_digest(tmp_path), *DIGESTS.values()}) == 3 + len(CASES)


@pytest.mark.parametrize(
    ("break_it", "words"),
    [
        (lambda f: (f / NOTEBOOK).unlink(), f"has no {NOTEBOOK}"),
        (lambda f: (f / NOTEBOOK).write_text("{}"), "has no list FxD of forces and heights"),
        (lambda f: (f / MAP).unlink(), f"has no {MAP} of numbers"),
        (lambda f: (f / MAP).write_text("words"), f"has no {MAP} of numbers"),
        (lambda f: (f / "SoftBottom_50cm" / "acc_a-0.bin").write_bytes(b"123"), "rows of 10 bytes"),
        (lambda f: write_drop(f / "SoftBottom_50cm" / "acc_a-0.bin", np.ones(5)), "above 3 g after"),
        (lambda f: [p.unlink() for p in (f / "RigidBottom_30cm").iterdir()],
         "has no RigidBottom_30cm; name a copy of github"),
    ],
)  # fmt: skip
def test_another_copy_is_refused_in_one_line(
    tmp_path: Path, break_it: Callable[[Path], object], words: str
) -> None:
    break_it(write_copy(tmp_path))
    with pytest.raises(InputError, match=words) as caught:
        list(identification_lines(tmp_path))
    [line] = caught.value.problems
    assert line.startswith(str(tmp_path))


def test_the_page_prints_the_published_numbers() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert f"{PUBLISHED_STIFFNESS:.0f} N/m" in text
    assert f"{PUBLISHED_FREE:.0f} N/m" in text
