"""What the authors of the recorded drops identified from them, computed again from a user's copy.

The recordings are those of `springback.studies.recordings.frame_drops`; their authors read them,
and fitted a mass on a spring and a damper, in the notebook of the same repository
(``CogniFly_Experiments.ipynb``).  Here are its steps in its own order: calibration, the first
reading above 3 g, peaks of the size of the specific force, the stiffness by ten pressed forces, and
the criterion of stiffness and damping, a mean square up to each drop's peak, through a first-order
low-pass.  The criterion's corner is 500 rad/s in the notebook; its text, and the capacitors of the
sensor, say 500 Hz.  Both are computed.

Nothing of the repository is part of this package, but digests of its folders, which say whether a
copy is the one for which the published numbers hold.

    python -m springback.studies.recordings.frame_identification FOLDER
"""

from __future__ import annotations

import ast
import hashlib
import json
import math
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError
from springback.studies.recordings.command import run_study
from springback.studies.recordings.frame_drops import CASES, LARGEST, PERIOD, ROW, ROWS, TOUCH

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Calibration of the notebook: counts per g along z, along x and y, and zeros of the three axes.
PER_G = 8.87700438
ALONG = np.array([0.9577 * PER_G, 0.9577 * PER_G, PER_G])
ZEROS = np.array([2019.93872, 2020.0, 2020.77284438])
#: g of the notebook [m/s²] and mass of the soft frame [kg].
G, MASS = 9.81, 0.241
#: Corner of the notebook's low-pass [rad/s], and that of its text.
WRITTEN, MEANT = 500.0, 2.0 * math.pi * 500.0
#: Soft drops, of which the criterion is made.
SOFT = tuple(case for case in CASES if case.vehicle == "cognifly")
NOTEBOOK, MAP = "CogniFly_Experiments.ipynb", "countour_plot_c_0-100_k_0-15000.csv"
#: Ends of the published map: damping [N s/m] and stiffness [N/m], 200 of each.
MOST_DAMPING, MOST_STIFFNESS = 100.0, 15000.0
#: Where the notebook's search begins [N s/m, N/m], and points of the map that are compared.
BEGIN, COMPARED = (50.0, 7040.0), 5
#: The published damping [N s/m], the mean, and how far another may be for the same (chosen).
PUBLISHED_DAMPING, SAME = 46.0, 2.0
#: SHA-256 of the names and contents of each folder's files, as published in 2021.
DIGESTS = {
    "SoftBottom_50cm": "fe22cb3b6b4ea7d2e6aa662018b99a8e3dc1752435e4aee2ada3c993d648b3e7",
    "SoftBottom_100cm": "b02f6412f8ee178788f2adddbf8ba6c67ada3e74e36d7f5d78649c812854c071",
    "SoftBottom_150cm": "57a12b5abdf3f5ccab9e3713e7e74ed03f72cbc4a13df06eb2d4833540860703",
    "RigidBottom_30cm": "cffc8f5a2ebc34b15a98b60778e0e93c7663ffc47f96da1d5f44fd1c902049e6",
}
#: Printed by the notebook: recordings, and medians of peaks [g] where it prints them.
PUBLISHED_FILES = {
    "SoftBottom_50cm": 101, "SoftBottom_100cm": 97, "SoftBottom_150cm": 89, "RigidBottom_30cm": 89,
}  # fmt: skip
PUBLISHED_PEAKS = {"SoftBottom_150cm": 136.718206431523, "RigidBottom_30cm": 159.25520774731538}
#: ... and stiffnesses by its pressed forces [N/m]: through the weight, and through any force.
PUBLISHED_STIFFNESS, PUBLISHED_FREE = 7040.33305493, 6375.0418200066915


class FrameParameters(NamedTuple):
    """Optimum of a criterion."""

    damping: float  # [N s/m]
    stiffness: float  # [N/m]
    mean_square: float  # [m²/s⁴], summed over the heights


def folder_digest(folder: Path) -> str:
    """SHA-256 of names and contents of a folder's files, in order of their names."""
    whole = hashlib.sha256()
    for path in sorted(folder.iterdir()):
        whole.update(path.name.encode())
        whole.update(hashlib.sha256(path.read_bytes()).digest())
    return whole.hexdigest()


def impact_sizes(folder: Path) -> list[Array]:
    """Size of the specific force of each drop of a folder from just before touch [g].

    All files count, whatever their ending, and all are as long as the shortest.

    Args:
        folder: Of one height.

    Raises:
        InputError: If it has no recordings, or one cannot be read or touches nothing.
    """
    paths = sorted(folder.iterdir()) if folder.is_dir() else []
    if not paths:
        raise InputError(
            f"{folder.parent}: has no {folder.name}; name a copy of "
            "github.com/thecognifly/CrashLandingExperiments"
        )
    sizes = [_size(path) for path in paths]
    shortest = min(map(len, sizes))
    return [size[:shortest] for size in sizes]


def _size(path: Path) -> Array:
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: has more than {LARGEST / 1e6:g} MB")
    given = path.read_bytes()
    if not given or len(given) % ROW:
        raise InputError(f"{path}: must hold rows of {ROW} bytes (got {len(given)} bytes)")
    rows = np.frombuffer(given, ROWS)
    if (np.diff(rows["t"].astype(np.int64)) != round(1e6 * PERIOD)).any():
        raise InputError(f"{path}: must have a row every {1e3 * PERIOD:g} ms")
    counts = np.stack([rows[axis] for axis in "xyz"], axis=1).astype(float)
    size: Array = np.linalg.norm((counts - ZEROS) / ALONG, axis=1)
    above = np.flatnonzero(size > TOUCH)
    if not len(above) or above[0] == 0:
        raise InputError(f"{path}: has no reading above {TOUCH:g} g after a fall")
    return size[above[0] - 1 :]


def pressed_forces(folder: Path) -> tuple[Array, Array]:
    """Displacements [m] and forces [N] of the slow test, as the notebook of a copy lists them.

    Raises:
        InputError: If the copy has no such notebook, or it no such list.
    """
    path = folder / NOTEBOOK
    if not path.is_file():
        raise InputError(f"{folder}: has no {NOTEBOOK}")
    try:
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
        [listed] = re.findall(r"^FxD = (.*)$", text, re.M)
        pairs = np.array(ast.literal_eval(f"[{listed}]"), dtype=float).reshape(-1, 2)
    except (ValueError, KeyError, TypeError, SyntaxError):
        raise InputError(f"{path}: has no list FxD of forces and heights") from None
    # Heights are of the top above the ground, in cm; 3.6 cm without a force.
    return 1e-2 * (pairs[0, 1] - pairs[:, 1]), pairs[:, 0]


def pressed_stiffness(displacements: Array, forces: Array) -> tuple[float, float]:
    """Stiffness by least squares [N/m]: through the weight at no displacement, and through any.

    Args:
        displacements: [m].
        forces: [N].
    """
    above = forces - MASS * G
    through_weight = float(displacements @ above / (displacements @ displacements))
    return through_weight, float(np.polyfit(displacements, forces, 1)[0])


def predicted_sizes(
    damping: float, stiffness: float, height: float, samples: int, corner: float
) -> Array:
    """Size of the acceleration of a mass on a spring and a damper that lands [m/s²].

    m ẍ = m g − k x − c ẋ from x = 0 at the speed of the fall, without separation, every
    millisecond from touch; then the low-pass, from zero, along straight lines between samples, as
    SciPy's ``lsim`` takes them.

    Args:
        damping: c [N s/m].
        stiffness: k [N/m].
        height: Of the fall [m].
        samples: How many.
        corner: Of the low-pass [rad/s].
    """
    rate = np.zeros((3, 3))
    rate[0, 1], rate[1] = 1.0, (-stiffness / MASS, -damping / MASS, G)
    step = scipy.linalg.expm(rate * PERIOD)
    states = np.empty((samples, 3))
    states[0] = 0.0, math.sqrt(2.0 * G * height), 1.0
    for k in range(1, samples):
        states[k] = step @ states[k - 1]
    size = np.abs(states @ rate[1])
    turn = corner * PERIOD
    left = math.exp(-turn)
    late = 1.0 - (1.0 - left) / turn
    early = (1.0 - left) - late
    told, _ = scipy.signal.lfilter([late, early], [1.0, -left], size, zi=[-late * size[0]])
    return np.asarray(told)


class DropMisfit:
    """The notebook's criterion of damping and stiffness over drops from several heights."""

    def __init__(self, drops: Mapping[float, Sequence[Array]]) -> None:
        """Take the drops.

        Args:
            drops: By height [m]: sizes of the specific force from just before touch [g].
        """
        self._parts = []
        for height, sizes in drops.items():
            lengths = np.array([int(size.argmax()) for size in sizes])
            measured = np.zeros((len(sizes), int(lengths.max())))
            for row, size, length in zip(measured, sizes, lengths, strict=True):
                row[:length] = G * size[:length]
            weights = np.arange(measured.shape[1]) < lengths[:, None]
            self._parts.append((height, measured, weights / lengths[:, None]))

    def mean_square(self, damping: float, stiffness: float, corner: float) -> float:
        """Sum over the heights of the mean over the drops of the mean square up to the peak.

        Args:
            damping: [N s/m].
            stiffness: [N/m].
            corner: Of the low-pass [rad/s].
        """
        total = 0.0
        for height, measured, weights in self._parts:
            told = predicted_sizes(damping, stiffness, height, measured.shape[1], corner)
            total += float((weights * (told - measured) ** 2).sum()) / len(measured)
        return total

    def optimum(self, corner: float) -> FrameParameters:
        """Damping and stiffness of the least criterion, sought from where the notebook begins.

        Args:
            corner: Of the low-pass [rad/s].
        """

        def cost(point: Array) -> float:
            if point.min() < 0.0:
                return 100.0
            return math.log1p(self.mean_square(float(point[0]), float(point[1]), corner))

        found = scipy.optimize.minimize(
            cost, np.array(BEGIN), method="Nelder-Mead", options={"xatol": 1e-2, "fatol": 1e-9}
        )
        return FrameParameters(float(found.x[0]), float(found.x[1]), math.expm1(found.fun))


def read_map(folder: Path) -> Array:
    """The published map of the criterion, shape (stiffness, damping).

    Raises:
        InputError: If a copy has none.
    """
    path = folder / MAP
    try:
        found = np.loadtxt(path, ndmin=2)
    except (OSError, ValueError):
        raise InputError(f"{folder}: has no {MAP} of numbers") from None
    return np.asarray(found)


def map_range(values: Array, share: float) -> tuple[float, float, float, float]:
    """Least and most damping [N s/m] and stiffness [N/m] near the minimum of a map.

    Args:
        values: Shape (stiffness, damping).
        share: By which the criterion may be above its minimum.
    """
    rows, columns = np.nonzero(values <= (1.0 + share) * np.nanmin(values))
    stiffness = np.linspace(0.0, MOST_STIFFNESS, values.shape[0])
    damping = np.linspace(0.0, MOST_DAMPING, values.shape[1])
    return (
        float(damping[columns.min()]), float(damping[columns.max()]),
        float(stiffness[rows.min()]), float(stiffness[rows.max()]),
    )  # fmt: skip


def map_difference(criterion: DropMisfit, values: Array) -> float:
    """Largest relative difference from the published map, at some points all over it."""
    rows, columns = (np.linspace(1, n - 1, COMPARED).astype(int) for n in values.shape)
    stiffness = np.linspace(0.0, MOST_STIFFNESS, values.shape[0])
    damping = np.linspace(0.0, MOST_DAMPING, values.shape[1])
    worst = 0.0
    for row in rows:
        for column in columns:
            ours = criterion.mean_square(damping[column], stiffness[row], WRITTEN)
            worst = max(worst, abs(ours / float(values[row, column]) - 1.0))
    return worst


def identification_lines(folder: Path | None) -> Iterator[str]:
    """What follows from a copy, beside what is published.

    Args:
        folder: Of the user's own copy.

    Raises:
        InputError: If there is none, or it lacks recordings, notebook or map.
    """
    if folder is None:
        raise InputError(
            "no folder was named; name a copy of github.com/thecognifly/CrashLandingExperiments"
        )
    drops = {}
    for case in CASES:
        sizes = impact_sizes(folder / case.folder)
        drops[case.folder] = sizes
        others = sum(path.suffix != ".bin" for path in (folder / case.folder).iterdir())
        published = folder_digest(folder / case.folder) == DIGESTS[case.folder]
        peak = float(np.median([size.max() for size in sizes]))
        printed = PUBLISHED_PEAKS.get(case.folder)
        yield (
            f"{case.folder}: {len(sizes) - others} recordings"
            + (f" and {others} whose ending is misspelt" if others else "")
            + f", published {PUBLISHED_FILES[case.folder]}; "
            + ("files as published" if published else "files are not those published in 2021")
            + f"; median peak {peak:.2f} g"
            + (f", published {printed:.2f} g" if printed is not None else "")
        )
    displacements, forces = pressed_forces(folder)
    through, free = pressed_stiffness(displacements, forces)
    yield (
        f"pressed slowly, {len(forces)} forces: {through:.1f} N/m through the weight, published "
        f"{PUBLISHED_STIFFNESS:.1f}; {free:.1f} N/m through any force, published "
        f"{PUBLISHED_FREE:.1f}"
    )
    criterion = DropMisfit({case.height: drops[case.folder] for case in SOFT})
    values = read_map(folder)
    yield (
        f"criterion, corner 500 rad/s: within {map_difference(criterion, values):.1g} of the "
        f"published map at {COMPARED**2} points"
    )
    for share in (0.01, 0.05):
        low, high, soft, stiff = map_range(values, share)
        yield (
            f"map: within {100.0 * share:g} % of its minimum from {low:.0f} to {high:.0f} N s/m "
            f"and from {soft:.0f} to {stiff:.0f} N/m"
        )
    written, meant = criterion.optimum(WRITTEN), criterion.optimum(MEANT)
    for what, one in (("500 rad/s, as written", written), ("500 Hz, as meant", meant)):
        agrees = abs(one.damping - PUBLISHED_DAMPING) <= SAME
        yield (
            f"corner of {what}: {one.damping:.1f} N s/m and {one.stiffness:.0f} N/m; "
            f"{'agrees with' if agrees else 'contradicts'} the published "
            f"{PUBLISHED_DAMPING:g} N s/m"
        )
    less = 1.0 - meant.mean_square / written.mean_square
    yield f"the criterion is {100.0 * less:.1f} % smaller with 500 Hz"


if __name__ == "__main__":
    sys.exit(run_study(identification_lines, sys.argv[1:]))
