"""Heights on a regular grid: their files, and the numbers of the smooth ground through them."""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.grids.data_files import npy_array, suffix_of
from springback.contact.grids.distance_grids import coefficients
from springback.contact.grids.images import grey_image
from springback.contact.grids.occupancy import new_file
from springback.contact.scene.height_face import COEFFICIENTS, PER_CELL, RIDGES
from springback.contact.scene.sections import FARTHEST
from springback.kernels.routines import NumberTable
from springback.settings import problem

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Most points of a height map, and fewest along an axis (chosen: 32 MB).
MOST_POINTS, FEWEST = 4_000_000, 4
#: Share of the smallest radius of hollows, or ridges, within which the nearest point is taken for
#: unique (chosen).
SURELY = 0.9


class HeightForm(NamedTuple):
    """Numbers of the ground, as `springback.contact.scene.height_face` takes them."""

    half: tuple[float, float, float]  # half lengths of its box [m]
    middle: float  # height of the centre of the box [m]
    table: NumberTable
    share: float  # 1/√(1 + s²) for the steepest slope s
    reach: float  # distance within which the nearest point is unique [m]
    spline: Array  # coefficients of the heights, along x and y [m]


def read_heights(file: str, data: bytes, levels: tuple[float, float] | None) -> Array:
    """Heights of a file [m], shape (points along x, points along y).

    Args:
        file: Its name: ``.npy``, an array with the first index along x, in metres; or ``.png``,
            grey, its columns along x, its upper row at the largest y.
        data: Its content.
        levels: Heights of black and white, for an image [m].

    Raises:
        The problem, if the file is damaged, too small or too large, or not finite.
    """
    if suffix_of(file, (".npy", ".png")) == ".png":
        if levels is None:
            raise problem("is missing: heights of black and white of the image", "range")
        grey = grey_image(file, data, MOST_POINTS)[::-1].T
        found = levels[0] + (levels[1] - levels[0]) * grey
    elif levels is not None:
        raise problem("is for images: a file .npy holds metres", "range")
    else:
        found = npy_array(file, data, MOST_POINTS).astype(np.float64)
    shape = " x ".join(map(str, found.shape))
    if found.ndim != 2:
        raise problem(f"{file}: must have two axes, along x and y (got {shape})", "file")
    if min(found.shape) < FEWEST:
        raise problem(
            f"{file}: must have at least {FEWEST} x {FEWEST} heights (got {shape})", "file"
        )
    if not np.isfinite(found).all():
        i, j = np.argwhere(~np.isfinite(found))[0]
        raise problem(f"{file}: height [{i}, {j}] is not finite", "file")
    return found


def height_file(heights: Any, path: str | Path | None = None) -> str:
    """Path of a new file of heights, for a `HeightMap` made in Python.

    Args:
        heights: Shape (points along x, points along y) [m].
        path: Of the file; by default it is among the kept forms, named by its content.

    Raises:
        InputError: If it cannot be written.
    """
    return new_file({"heights": np.asarray(heights, dtype=np.float64)}, ".npy", path)


def height_form(heights: Array, apart: Array, depth: float) -> HeightForm:
    """Numbers of the ground through some heights.

    Args:
        heights: Shape (points along x, points along y) [m].
        apart: Distances of the points along x and y [m].
        depth: From the lowest point to the bottom [m].
    """
    spline = coefficients(heights)
    low, high = float(spline.min()) - depth, float(spline.max())
    middle, nodes = 0.5 * (low + high), np.array(heights.shape) - 1
    x, y = (0.5 * apart * nodes).tolist()
    head = np.zeros(COEFFICIENTS)
    head[:PER_CELL], head[PER_CELL:RIDGES] = heights.shape, 1.0 / apart
    head[RIDGES] = _unique(-spline, apart)
    centred = spline - middle
    table = NumberTable(np.concatenate([head, centred.ravel(), _cell_bounds(centred).ravel()]))
    share, reach = 1.0 / math.hypot(1.0, _steepest(spline, apart)), _unique(spline, apart)
    return HeightForm((x, y, 0.5 * (high - low)), middle, table, share, reach, spline)


def _unique(spline: Array, apart: Array) -> float:
    """Distance above a surface within which the nearest point is unique [m]."""
    bend = _most_hollow(spline, apart)
    return min(SURELY / bend, FARTHEST) if bend > 0.0 else FARTHEST


def _cell_bounds(spline: Array) -> Array:
    """Highest and lowest coefficient of each cell, shape (cells along x, along y, 2).

    A spline lies between them.
    """
    cells = tuple(n - 3 for n in spline.shape)
    parts = [spline[i : i + cells[0], j : j + cells[1]] for i in range(4) for j in range(4)]
    highest, lowest = functools.reduce(np.maximum, parts), functools.reduce(np.minimum, parts)
    return np.stack([highest, lowest], axis=-1)


def _around(values: Array) -> Array:
    """Largest of the values around each, over more places than a cell's spline reads."""
    found: Any = scipy.ndimage.maximum_filter(values, size=5, mode="nearest")
    return np.asarray(found)


def _same(*arrays: Array) -> tuple[Array, ...]:
    """The parts that arrays of nearly one size share."""
    x, y = (min(one.shape[k] for one in arrays) for k in (0, 1))
    return tuple(one[:x, :y] for one in arrays)


def _steepest(spline: Array, apart: Array) -> float:
    """Upper bound on the slope: a spline's derivative lies between differences of coefficients."""
    x, y = (_around(np.abs(np.diff(spline, axis=k)) / apart[k]) for k in (0, 1))
    x, y = _same(x, y)
    return float(np.hypot(x, y).max())


def _most_hollow(spline: Array, apart: Array) -> float:
    """Upper bound on the larger eigenvalue of second derivatives: curvature of hollows [1/m]."""
    xx, yy = (_around(np.diff(spline, 2, axis=k) / apart[k] ** 2) for k in (0, 1))
    xy = _around(np.abs(np.diff(np.diff(spline, axis=0), axis=1)) / (apart[0] * apart[1]))
    xx, yy, xy = _same(xx, yy, xy)
    return float((0.5 * (xx + yy) + np.hypot(0.5 * (xx - yy), xy)).max())
