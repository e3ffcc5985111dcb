"""Mass, centre and inertia of solids of uniform density, for obstacles that move by themselves.

The rounding of edges is not taken away.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.scene.solids import BOX, CAPSULE, FRUSTUM, ROUND_WINDOW, TORUS, WINDOW
from springback.contact.shapes import SolidShape

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Points and weights of an integral along an axis, exact for the polynomials here.
_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class MassProperties(NamedTuple):
    """Volume, centre, and inertia per density."""

    volume: float  # [m³]
    centre: Array  # [m], shape (3,)
    inertia: Array  # about the centre, per density [m⁵], shape (3, 3)


def mass_properties(solids: Sequence[SolidShape]) -> MassProperties | None:
    """Of several solids together, in world axes; None if the inertia of one is not known."""
    parts = [_of_solid(solid) for solid in solids]
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    volume = sum(part.volume for part in known)
    centre = sum((part.volume * part.centre for part in known), np.zeros(3)) / volume
    inertia = sum((_about(part, centre) for part in known), np.zeros((3, 3)))
    return MassProperties(volume, centre, inertia)


def _about(part: MassProperties, point: Array) -> Array:
    """Inertia about another point (Steiner)."""
    away = part.centre - point
    moved = part.volume * (away @ away * np.eye(3) - np.outer(away, away))
    return np.asarray(part.inertia + moved)


def _of_solid(solid: SolidShape) -> MassProperties | None:
    made = _MADE.get(solid.kind)
    if made is None:
        return None
    volume, offset, moments = made(solid.sizes, solid.rounding)
    axes = solid.axes
    return MassProperties(volume, solid.centre + axes.T @ offset, axes.T @ np.diag(moments) @ axes)


_Own = tuple[float, Array, Array]
"""Volume, centre and principal moments in the solid's own axes."""


def _cuboid(a: float, b: float, c: float) -> _Own:
    """Box of some half lengths."""
    volume = 8.0 * a * b * c
    moments = volume / 3.0 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    return volume, np.zeros(3), moments


def _box(s: Sequence[float], edge: float) -> _Own:
    return _cuboid(s[0] + edge, s[1] + edge, s[2] + edge)


def _revolved(radii: Array, z: Array, weights: Array) -> _Own:
    """Body of revolution from its radii at some heights."""
    area = math.pi * radii**2 * weights
    volume, along = float(area.sum()), float((area * z).sum())
    middle = along / volume
    about_z = float((0.5 * area * radii**2).sum())
    across = 0.5 * about_z + float((area * (z - middle) ** 2).sum())
    return volume, np.array([0.0, 0.0, middle]), np.array([across, across, about_z])


def _frustum(s: Sequence[float], edge: float) -> _Own:
    half = s[2] + edge
    z = half * _POINTS
    radii = 0.5 * (s[0] + s[1]) + 0.5 * (s[1] - s[0]) * _POINTS + edge
    return _revolved(radii, z, half * _WEIGHTS)


def _capsule(s: Sequence[float], edge: float) -> _Own:
    half, r = s[0], s[1]
    cap = 0.5 * r * (1.0 + _POINTS)  # height above the end of the axis
    z = np.concatenate([half * _POINTS, half + cap, -half - cap])
    ends = np.sqrt(r * r - cap**2)
    radii = np.concatenate([np.full(len(_POINTS), r), ends, ends])
    weights = np.concatenate([half * _WEIGHTS, 0.5 * r * _WEIGHTS, 0.5 * r * _WEIGHTS])
    return _revolved(radii, z, weights)


def _torus(s: Sequence[float], edge: float) -> _Own:
    large, r = s[0], s[1] + edge
    volume = 2.0 * math.pi**2 * large * r * r
    across = volume * (0.5 * large**2 + 0.625 * r * r)
    return volume, np.zeros(3), np.array([across, across, volume * (large**2 + 0.75 * r * r)])


def _without(outer: _Own, inner: _Own, offset: Array) -> _Own:
    """A body without an opening, whose centre is at an offset; products of inertia are zero."""
    volume = outer[0] - inner[0]
    centre = -inner[0] * offset / volume
    moments = outer[2] + _steiner(outer[0], -centre) - inner[2]
    return volume, centre, moments - _steiner(inner[0], offset - centre)


def _steiner(volume: float, away: Array) -> Array:
    return np.asarray(volume * (away @ away - away**2))


def _window(s: Sequence[float], edge: float) -> _Own:
    thick = s[2] + edge
    tall = s[1] + edge
    low, high = max(s[5] - s[4] + edge, -tall), min(s[5] + s[4] - edge, tall)  # a door's is longer
    inner = _cuboid(s[3] - edge, 0.5 * (high - low), thick)
    outer = _cuboid(s[0] + edge, tall, thick)
    return _without(outer, inner, np.array([0.0, 0.5 * (low + high), 0.0]))


def _round_window(s: Sequence[float], edge: float) -> _Own:
    thick, r = s[2] + edge, s[3] - edge
    inner = _revolved(np.full(len(_POINTS), r), thick * _POINTS, thick * _WEIGHTS)
    return _without(_cuboid(s[0] + edge, s[1] + edge, thick), inner, np.zeros(3))


_MADE = {
    BOX: _box, CAPSULE: _capsule, FRUSTUM: _frustum, TORUS: _torus, WINDOW: _window,
    ROUND_WINDOW: _round_window,
}  # fmt: skip
