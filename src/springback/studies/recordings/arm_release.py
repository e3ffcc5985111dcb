"""A recorded release of an elastic arm, and the same arm let go here.

The recording is that of an arm of Morphy that was bent by 23 deg and let go, from the repository
``ntnu-arl/aerial_gym_simulator`` (Autonomous Robots Lab, NTNU, BSD-3-Clause), file
``aerial_gym/examples/stored_data/joint_step.csv``: rows of time [s] and elevation [deg].  Nothing
is fetched: the user names the file.

Nothing is fitted here.  Spring, damper and the position of rest are those that its authors fitted
to this very recording: θ̈ = −5834 φ|φ| − 230 θ̇ with φ = θ − 7.2 deg.

    python -m springback.studies.recordings.arm_release FOLDER
"""

from __future__ import annotations

import csv
import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.results.flight import fly
from springback.studies.recordings.command import run_study
from springback.vehicle.folding import morphy_vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Position of rest of the recorded arm [rad], as its authors give it.
REST = math.radians(7.2)
#: The arm is let go where it has left its mean before by more than this [rad] (chosen: seven
#: standard deviations of what was recorded while it was held).
LEFT = math.radians(0.3)
#: Time over which the angles are compared, from the release on [s] (chosen: by then the arm has
#: come back by nine tenths).
COMPARED = 1.0
#: Place of the recording in its repository.
RECORDING = Path("aerial_gym/examples/stored_data/joint_step.csv")
#: Error that is wanted, rms [rad].
WANTED = math.radians(1.0)
#: Largest file that is read [bytes].
LARGEST = 10_000_000


class Release(NamedTuple):
    """Angle of an arm from its release on."""

    time: Array  # [s], shape (rows,)
    angle: Array  # from level [rad], shape (rows,)


class ReleaseErrors(NamedTuple):
    """Predicted less recorded angles."""

    rms: float  # [rad]
    largest: float  # [rad]
    rows: int


def read_release(path: Path) -> Release:
    """The recording, from the last row before the release on.

    Raises:
        InputError: If it is too large, has other columns, or the arm is not let go in it.
    """
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: has more than {LARGEST / 1e6:g} MB")
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    if not rows or rows[0] != ["time", "elevation"]:
        raise InputError(f"{path}: must begin with the line time,elevation")
    try:
        time, angle = np.array(rows[1:], dtype=float).T
    except ValueError:
        raise InputError(f"{path}: must hold two numbers a line") from None
    if not (np.isfinite(time).all() and np.isfinite(angle).all() and (np.diff(time) > 0.0).all()):
        raise InputError(f"{path}: must hold finite numbers, times increasing")
    angle = np.radians(angle)
    held = float(np.mean(angle[time < 0.0])) if (time < 0.0).any() else float(angle[0])
    gone = np.flatnonzero(angle < held - LEFT)
    # Single rows may be off: from the release on all are.
    first = next((int(k) for k in gone if (angle[k : k + 10] < held - LEFT).all()), None)
    if first is None:
        raise InputError(f"{path}: holds no release of an arm")
    begin = max(first - 1, 0)
    return Release(time[begin:] - time[begin], np.concatenate([[held], angle[begin + 1 :]]))


def predict_release(release: Release, duration: float = COMPARED) -> Release:
    """The same release here, on a main body that is too heavy to move."""
    vehicle = morphy_vehicle(100.0, (1.0, 1.0, 1.0))
    radius = vehicle.arms.radius(0)
    bent = float(release.angle[0]) - REST
    flight = fly(
        {
            "vehicle": vehicle.model_dump(),
            "world": {"gravity": 0.0},
            "start": {"compression": bent * radius},
            "model": {"arms": "always-free"},
            "simulation": {"duration": duration},
        },
    )
    free = vehicle.arms.at("length", 0)
    return Release(flight.t, REST + (free - flight.columns["l1"]) / radius)


def errors_of(release: Release, here: Release, duration: float = COMPARED) -> ReleaseErrors:
    """Errors of a prediction over the compared time."""
    compared = release.time <= duration
    off = np.interp(release.time[compared], here.time, here.angle) - release.angle[compared]
    return ReleaseErrors(
        float(np.sqrt(np.mean(off**2))), float(np.abs(off).max()), int(compared.sum())
    )


def release_lines(folder: Path | None) -> Iterator[str]:
    """What is predicted of the recording in a copy of its repository.

    Raises:
        InputError: If it is not there, or cannot be read.
    """
    places = () if folder is None else (folder / RECORDING, folder / RECORDING.name)
    path = next((place for place in places if place.is_file()), None)
    if path is None:
        where = "no folder was named" if folder is None else f"{folder}: has no {RECORDING.name}"
        raise InputError(f"{where}; name a copy of github.com/ntnu-arl/aerial_gym_simulator")
    release = read_release(path)
    found = errors_of(release, predict_release(release))
    yield (
        f"let go at {math.degrees(release.angle[0]):.1f} deg, {COMPARED:g} s: off by "
        f"{math.degrees(found.rms):.2f} deg rms ({math.degrees(WANTED):g} wanted), "
        f"{math.degrees(found.largest):.1f} deg at most, {found.rows} rows"
    )


if __name__ == "__main__":
    sys.exit(run_study(release_lines, sys.argv[1:]))
