"""Recorded impacts of an ellipse on a floor, and what six models said of them, by their own files.

The recordings are those of N. Fazeli and A. Rodriguez, MCube Lab (repository
``mcubelab/planar-impact-dataset``).  They have no licence, so none of their numbers is part of this
package, and nothing is fetched: the user names the folder of a copy.

A recording is plane: x along the floor, y upwards, θ from x towards y.  In the files ẋ has the
other sign: with it as stored, the change of spin contradicts the impulse at the contact point that
changed ẋ and ẏ; turned over, both agree within the recordings' noise (`unexplained_spin`), and the
impulses stored beside them have the sign that follows.  So ẋ is turned over on reading.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.io import loadmat
from scipy.io.matlab import MatReadError

from springback.errors import InputError

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Mass [kg] and radius of gyration [m] of the ellipse, as its readme gives them.
MASS, GYRATION = 0.0364, 0.0192
#: Signs with which velocities are read.
TURNED = np.array([-1.0, 1.0, 1.0])
#: Models whose velocities are stored, in the order of their columns.
MODELS = (
    "Drumwright-Shell", "AP Poisson", "AP Newton", "Mirtich", "Wang-Mason", "Whittaker",
)  # fmt: skip
#: Files that are read, below the folder or its ``processed_data``.
STATES, PREDICTED = "data_ellipse.mat", "v_models.mat"
#: Largest file that is read [bytes]; the recordings take 0.2 MB.
LARGEST = 50_000_000


class PlanarImpacts(NamedTuple):
    """Some impacts of one plane body on a floor."""

    before: Array  # velocities ẋ, ẏ [m/s] and θ̇ [rad/s], shape (impacts, 3)
    after: Array  # the same after the impact
    lever: Array  # from the centre of mass to the contact point, x and y [m], shape (impacts, 2)
    models: Array  # velocities after the impact by `MODELS`, shape (impacts, models, 3)

    def part(self, which: slice) -> PlanarImpacts:
        """Some of them, in order."""
        return PlanarImpacts(*(column[which] for column in self))


def at_contact(velocity: Array, lever: Array) -> Array:
    """Velocities of the contact point along and out of the floor [m/s].

    Args:
        velocity: ẋ, ẏ and θ̇, shape (..., 3).
        lever: To the contact point [m], shape (..., 2).
    """
    along = velocity[..., 0] - velocity[..., 2] * lever[..., 1]
    return np.stack([along, velocity[..., 1] + velocity[..., 2] * lever[..., 0]], axis=-1)


def read_planar_impacts(folder: Path) -> PlanarImpacts:
    """Recordings from a copy of their repository.

    Args:
        folder: The repository, or its folder ``processed_data``.

    Raises:
        InputError: If a file is missing, too large, no MATLAB file, or not what it should hold.
    """
    states = _variable(folder, STATES, "data")
    if states.dtype.names is None or states.size != 1:
        raise InputError(f"{STATES}: data: must be one structure")
    one = states.ravel()[0]
    before = _numbers(one, "states_i", 6)[:, 3:]
    after = _numbers(one, "states_f", 6)[:, 3:]
    normal, tangent = _numbers(one, "n", 3), _numbers(one, "d", 3)
    models = np.asarray(_variable(folder, PREDICTED, "v_models"), dtype=float)
    shape = (len(before), 3 * len(MODELS))
    if {len(after), len(normal), len(tangent)} != {len(before)} or models.shape != shape:
        raise InputError(
            f"{PREDICTED}: v_models: must have {shape[0]} rows and {shape[1]} columns, as "
            f"{STATES} has impacts (got {' x '.join(map(str, models.shape))})"
        )
    lever = np.stack([normal[:, 2], -tangent[:, 2]], axis=1)
    predicted = models.reshape(-1, len(MODELS), 3)
    return PlanarImpacts(before * TURNED, after * TURNED, lever, predicted * TURNED)


def spin_by_impulse(impacts: PlanarImpacts) -> Array:
    """Spin after impacts if the impulse that changed ẋ and ẏ acted at the contact point [rad/s]."""
    gain = impacts.after - impacts.before
    x, y = impacts.lever.T
    turning = (x * gain[:, 1] - y * gain[:, 0]) / GYRATION**2
    return np.asarray(impacts.before[:, 2] + turning)


def unexplained_spin(impacts: PlanarImpacts) -> float:
    """Scatter of the spin that the impulse does not explain, of the scatter of its change."""
    left = impacts.after[:, 2] - spin_by_impulse(impacts)
    return float(left.std() / (impacts.after[:, 2] - impacts.before[:, 2]).std())


def _numbers(one: Any, name: str, width: int) -> Array:
    if name not in (one.dtype.names or ()):
        raise InputError(f"{STATES}: data.{name}: is missing")
    found = np.asarray(one[name], dtype=float)
    if found.ndim != 2 or found.shape[1] != width or not len(found):
        shape = " x ".join(map(str, found.shape))
        raise InputError(f"{STATES}: data.{name}: must have {width} columns (got {shape})")
    if not np.isfinite(found).all():
        raise InputError(f"{STATES}: data.{name}: must be finite")
    return found


def _variable(folder: Path, file: str, name: str) -> Any:
    """A variable of a MATLAB file."""
    places = [folder / file, folder / "processed_data" / file]
    path = next((place for place in places if place.is_file()), None)
    if path is None:
        raise InputError(
            f"{folder}: has no {file}; name a copy of github.com/mcubelab/planar-impact-dataset"
        )
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: has more than {LARGEST / 1e6:g} MB")
    try:
        found = loadmat(path)
    except (MatReadError, ValueError, TypeError, OSError, KeyError, NotImplementedError):
        raise InputError(f"{path}: is no MATLAB file that can be read") from None
    if name not in found:
        raise InputError(f"{path}: has no variable {name}")
    return found[name]
