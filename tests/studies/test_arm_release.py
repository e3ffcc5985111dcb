"""The release of an elastic arm: a recording that is made here, and files that are none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from springback.errors import InputError
from springback.studies.recordings.arm_release import REST, errors_of, predict_release, read_release


def recording(path: Path, held: float) -> Path:
    """Rows as of the repository, from the published law, with 0.03 deg of noise while held."""
    time = np.arange(-1.0, 1.2, 1.0 / 300.0) + 1e-4
    bent = np.radians(held) - REST

    def rates(_: float, y: np.ndarray) -> list[float]:
        return [y[1], -5834.0 * y[0] * abs(y[0]) - 230.0 * y[1]]

    moved = solve_ivp(rates, (0.0, 1.2), [bent, 0.0], rtol=1e-9, atol=1e-12, dense_output=True)
    angle = np.where(time < 0.0, np.radians(held), REST + moved.sol(np.maximum(time, 0.0))[0])
    angle += np.radians(0.03) * np.sin(1e3 * np.arange(len(time))) * (time < 0.0)
    rows = [f"{t:.9f},{np.degrees(a):.9f}" for t, a in zip(time, angle, strict=True)]
    path.write_text("time,elevation\n" + "\n".join(rows) + "\n")
    return path


def test_an_arm_that_follows_the_law_is_predicted(tmp_path: Path) -> None:
    """Two formulations: an ordinary differential equation, and a flight of the preset."""
    release = read_release(recording(tmp_path / "arm.csv", 22.9))
    assert np.degrees(release.angle[0]) == pytest.approx(22.9, abs=0.01)
    errors = errors_of(release, predict_release(release, 0.5), 0.5)
    # Measured: 0.115 deg; the release is found at a row, up to a period of 3.3 ms late.
    assert np.degrees(errors.rms) < 0.15
    assert errors.rows == pytest.approx(150, abs=3)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "must begin with the line time,elevation"),
        ("t,angle\n0,1\n", "must begin with the line time,elevation"),
        ("time,elevation\n0,1\n0.1,x\n", "must hold two numbers a line"),
        ("time,elevation\n0,1\n0,2\n", "must hold finite numbers, times increasing"),
        ("time,elevation\n0,1\n1,nan\n", "must hold finite numbers, times increasing"),
        ("time,elevation\n-1,5\n0,5\n1,5\n", "holds no release of an arm"),
    ],
)
def test_other_files_are_refused_in_one_line(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "arm.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_release(path)
    [line] = caught.value.problems
    assert line == f"{path}: {message}"
