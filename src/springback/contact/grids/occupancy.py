"""Occupancy grids: files of cells that are occupied or free, and how Python writes them."""

from __future__ import annotations

import hashlib
import io
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.contact.grids.data_files import npy_array, npz_arrays, suffix_of
from springback.contact.grids.distance_grids import MOST_NODES
from springback.contact.grids.stored_forms import form_folder
from springback.errors import InputError
from springback.files import write_atomically
from springback.settings import problem

Array = np.ndarray[Any, np.dtype[Any]]


class Cells(NamedTuple):
    """Cells of a space."""

    occupied: Array  # true or false, shape (cells along x, y, z)
    cell: float  # length of one [m]
    low: Array  # lower corner of the first one [m], shape (3,)


def read_cells(
    file: str, data: bytes, cell: float | None, threshold: float, unknown: bool
) -> Cells:
    """Cells of a file.

    Args:
        file: Its name: ``.npy``, or ``.npz`` with ``occupancy``, perhaps ``cell`` and ``origin``.
        data: Its content.
        cell: Length of a cell [m]; None: that of the file.
        threshold: Probability from which on a cell is occupied.
        unknown: True if cells of no known probability are occupied.

    Raises:
        The problem, if the file is damaged, too large, or holds something else.
    """
    origin: Any = np.zeros(3)
    if suffix_of(file, (".npz", ".npy")) == ".npz":
        arrays = npz_arrays(file, data, MOST_NODES)
        if "occupancy" not in arrays:
            names = ", ".join(sorted(arrays)[:6])
            raise problem(f"{file}: must hold an array occupancy (got {names})", "file")
        values, origin = arrays["occupancy"], arrays.get("origin", origin)
        if cell is None and "cell" in arrays:
            cell = _number(file, arrays["cell"])
    else:
        values = npy_array(file, data, MOST_NODES)
    if cell is None:
        raise problem(f"is missing, in {file}, too: the length of a cell [m]", "cell")
    origin = np.asarray(origin, dtype=np.float64).reshape(-1)
    if origin.shape != (3,) or not np.isfinite(origin).all():
        raise problem(f"{file}: origin must be three finite numbers [m]", "file")
    if values.ndim != 3 or not values.size:
        shape = " x ".join(map(str, values.shape))
        raise problem(f"{file}: must have three axes (got {shape})", "file")
    return Cells(_occupied(file, values, threshold, unknown), cell, origin)


def _number(file: str, given: Array) -> float:
    found = float(given.reshape(-1)[0]) if given.size == 1 else float("nan")
    if not found > 0.0 or not np.isfinite(found):
        raise problem(f"{file}: cell must be a length above 0 m", "file")
    return found


def _occupied(file: str, values: Array, threshold: float, unknown: bool) -> Array:
    if values.dtype.kind == "b":
        return values
    numbers = values.astype(np.float64)
    lost = ~(numbers >= 0.0)
    if np.nanmax(numbers, initial=0.0) > 1.0:
        raise problem(
            f"{file}: probabilities must be at most 1 (got {np.nanmax(numbers):g})", "file"
        )
    return np.where(lost, unknown, numbers >= max(threshold, 1e-12))


def new_file(arrays: Mapping[str, Any], suffix: str, path: str | Path | None) -> str:
    """Path of a new file of arrays.

    Args:
        arrays: By name; for ``.npy`` one.
        suffix: ``.npy`` or ``.npz``.
        path: Of the file; None: among the kept forms, named by its content.

    Raises:
        InputError: If it cannot be written.
    """
    stream: Any = io.BytesIO()
    if suffix == ".npy":
        [values] = arrays.values()
        np.save(stream, values, allow_pickle=False)
    else:
        np.savez(stream, **arrays)
    data = stream.getvalue()
    name = hashlib.sha256(data).hexdigest()
    target = form_folder() / f"{name}{suffix}" if path is None else Path(path)
    if target.suffix != suffix:
        raise InputError(f"{target}: must end in {suffix}")
    try:
        if path is None:
            target.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(target, data)
    except OSError as error:
        raise InputError(f"{target}: cannot be written ({error.strerror})") from None
    return os.path.abspath(target)


def occupancy_file(
    occupancy: Any,
    cell: float,
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0),
    path: str | Path | None = None,
) -> str:
    """Path of a new file of cells, for an `OccupancyGrid` made in Python or by an importer.

    Args:
        occupancy: True where occupied, or probabilities, NaN where unknown; shape (cells along x,
            y, z).
        cell: Length of a cell [m].
        origin: Lower corner of the first cell [m].
        path: Of the file ``.npz``; by default it is among the kept forms, named by its content.

    Raises:
        InputError: If it cannot be written.
    """
    arrays = {"occupancy": np.asarray(occupancy), "cell": cell, "origin": np.asarray(origin)}
    return new_file(arrays, ".npz", path)
