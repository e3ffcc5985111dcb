"""Force curves: the force of something that is pressed in, as a table, going in and coming out.

Between its points a curve is a piecewise cubic without overshoot (PCHIP: F. Fritsch and R. Carlson,
SIAM Journal on Numerical Analysis 17, 1980), so that force and stiffness are continuous; beyond its
last point it goes on with its last slope.

What is measured coming out is kept as the share φ of the force going in, at the same depth, by the
share w of the energy that was put in up to the deepest depth: as foams are described in crash
simulation (OpenRadioss, /MAT/LAW70, where 1 − φ is called a damage).  From any other deepest depth
it comes out along the same φ(w), which returns the same share ∫ φ dw of the energy.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.kernels.compiler import kernel
from springback.kernels.routines import NumberTable, number_at

Array = np.ndarray[Any, np.dtype[np.float64]]
#: Points of a curve: a depth [m] and a force [N] each.
Points = tuple[tuple[float, float], ...]

#: A table begins with the number of points going in, the number coming out, the steepest slope of
#: φ, and the share of the energy that is returned.
COUNT, COUNT_OUT, STEEPEST, RETURNED, HEADER = 0, 1, 2, 3, 4
#: Numbers of a point: where it is, four coefficients of what follows, and the integral up to it.
WIDTH = 6
#: Points at which φ is taken from two curves (chosen).
SHARES = 33


class Pressed(NamedTuple):
    """Something pressed in to some depth for the first time."""

    force: float  # [N]
    slope: float  # of the force [N/m]
    energy: float  # put in [J]


class Returned(NamedTuple):
    """What it gives back when it comes out."""

    share: float  # φ, of the force going in
    energy: float  # ∫ φ dw up to the present w


def force_table(loading: Points, unloading: Points | None = None) -> NumberTable:
    """Table of a curve, for kernels.

    Args:
        loading: Points going in, from (0, 0), depths increasing.
        unloading: Points coming out, from force 0 to the last point of ``loading``, at no depth
            above that; without them it comes out as it went in.
    """
    going_in = _rows(np.array(loading))
    if unloading is None:
        return NumberTable(np.array([len(going_in), 0.0, 0.0, 1.0, *going_in.ravel()]))
    shares = _shares(np.array(loading), np.array(unloading))
    coming_out = _rows(shares)
    fine = np.linspace(0.0, 1.0, 2001)
    slopes = scipy.interpolate.PchipInterpolator(*shares.T).derivative()(fine)
    head = [len(going_in), len(coming_out), float(np.abs(slopes).max()), coming_out[-1, 5]]
    return NumberTable(np.array([*head, *going_in.ravel(), *coming_out.ravel()]))


def _rows(points: Array) -> Array:
    """Numbers of the points of a curve, shape (points, WIDTH); the last goes on straight."""
    x, y = points.T
    curve = scipy.interpolate.PchipInterpolator(x, y)
    rows = np.zeros((len(x), WIDTH))
    rows[:, 0] = x
    rows[:-1, 1:5] = curve.c[::-1].T
    rows[-1, 1:3] = y[-1], max(float(curve.derivative()(x[-1])), 0.0)
    rows[:, 5] = [float(curve.integrate(x[0], end)) for end in x]
    return rows


def _shares(loading: Array, unloading: Array) -> Array:
    """Points (w, φ) of two curves, shape (SHARES, 2)."""
    going_in = scipy.interpolate.PchipInterpolator(*loading.T)
    coming_out = scipy.interpolate.PchipInterpolator(*unloading.T)
    fine = np.linspace(0.0, loading[-1, 0], 4001)
    energy = going_in.antiderivative()(fine)
    w = np.linspace(0.0, 1.0, SHARES)
    depth = np.interp(w[1:] * energy[-1], energy, fine)
    out = np.where(depth >= unloading[0, 0], coming_out(depth), 0.0)
    share = np.clip(out / going_in(depth), 0.0, 1.0)
    return np.stack([w, [share[0], *share]], axis=1)


class _Row(NamedTuple):
    """A value of a curve, its slope and its integral."""

    value: float
    slope: float
    integral: float


@kernel
def _value_at(table: float, first: int, count: int, x: float) -> _Row:
    """Value of a curve whose numbers begin at a position of a table; at x ≥ its first point."""
    k = first
    for i in range(1, count):
        if number_at(table, first + WIDTH * i) <= x:
            k = first + WIDTH * i
    t = x - number_at(table, k)
    a, b = number_at(table, k + 1), number_at(table, k + 2)
    c, d = number_at(table, k + 3), number_at(table, k + 4)
    return _Row(
        a + t * (b + t * (c + t * d)),
        b + t * (2.0 * c + t * 3.0 * d),
        number_at(table, k + 5) + t * (a + t * (b / 2.0 + t * (c / 3.0 + t * d / 4.0))),
    )


@kernel
def pressed_at(table: float, depth: float) -> Pressed:
    """Force, slope and energy of a curve going in, at a depth ≥ 0 [m]."""
    there = _value_at(table, HEADER, int(number_at(table, COUNT)), depth)
    return Pressed(there.value, there.slope, there.integral)


@kernel
def returned_at(table: float, w: float) -> Returned:
    """Share of the force coming out where a share w of the energy is left; 1 without such a curve.

    Args:
        table: Of a curve.
        w: From 0 to 1, at the deepest depth.
    """
    count = int(number_at(table, COUNT_OUT))
    if count == 0:
        return Returned(1.0, w)
    first = HEADER + WIDTH * int(number_at(table, COUNT))
    there = _value_at(table, first, count, w)
    return Returned(there.value, there.integral)


@kernel
def next_point(table: float, depth: float, rate: float, near: float) -> float:
    """Depth of the next point of a curve [m], where its cubics join; 0 if there is none.

    Args:
        table: Of a curve.
        depth: The present depth [m].
        rate: Of the depth, whose sign tells which way [m/s].
        near: A point that is nearer than this has been reached [m].
    """
    found, last = 0.0, HEADER + WIDTH * (int(number_at(table, COUNT)) - 1)
    for k in range(int(number_at(table, COUNT))):
        if rate < 0.0:
            x = number_at(table, HEADER + WIDTH * k)
            found = x if x < depth - near else found
        else:  # from the last on, so that the nearest is found last
            x = number_at(table, last - WIDTH * k)
            found = x if x > depth + near else found
    return found
