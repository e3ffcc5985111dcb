"""Selection of the instants of a flight that are drawn.

A trajectory has every integration step.  A picture needs all of them near a contact and few
elsewhere, so some are left out; the error of linear interpolation between the others is bounded by
`BOUNDS`, and measured.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from springback.results.contacts.spans import contact_mask, intervals, parts_of

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: Largest interpolation errors, by unit (chosen: finer than a pixel).
BOUNDS = {"m": 2e-4, "": 2e-4, "m/s": 5e-3}
#: The same for arm lengths [m], accelerations [m/s²] and forces [N]; for the last two the bound is
ARM_BOUND, ACCELERATION_BOUND, FORCE_BOUND = 2e-5, 0.5, 0.5
#: at least this fraction of their peak.
SHARE = 0.01
#: Largest spacing of instants [s].
APART = 5e-3
#: Time before and after a contact in which every step is kept [s], ...
NEAR = 5e-3
#: ... up to this number of instants (chosen: 0.2 s at steps of 0.1 ms).
MOST_NEAR = 2000
#: Columns of where moving obstacles are, and how they are turned.
OBSTACLE_PLACE, OBSTACLE_TURN = re.compile(r"obstacle\d+_[xyz]"), re.compile(r"obstacle\d+_q[wxyz]")
#: Largest number of steps replaced by one line, a power of 2.
GROUP = 64


def _curves(columns: Mapping[str, Array], arms: int) -> tuple[Array, Array]:
    """Drawn quantities, shape (instants, quantities), and the error bound of each."""
    names = dict.fromkeys("xyz", BOUNDS["m"])
    names |= {f"q{part}": BOUNDS[""] for part in "wxyz"}
    names |= {f"v{axis}": BOUNDS["m/s"] for axis in "xyz"}
    forces = [f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns)]
    peak = max((float(np.max(np.abs(columns[name]), initial=0.0)) for name in forces), default=0.0)
    hardest = max(float(np.max(np.abs(columns[f"a{axis}"]), initial=0.0)) for axis in "xyz")
    names |= {name: BOUNDS["m"] for name in columns if OBSTACLE_PLACE.fullmatch(name)}
    names |= {name: BOUNDS[""] for name in columns if OBSTACLE_TURN.fullmatch(name)}
    names |= {f"l{j}": ARM_BOUND for j in range(1, arms + 1)}
    names |= {f"bend{j}": ARM_BOUND for j in range(1, arms + 1) if f"bend{j}" in columns}
    names |= {f"a{axis}": max(ACCELERATION_BOUND, SHARE * hardest) for axis in "xyz"}
    names |= dict.fromkeys(forces, max(FORCE_BOUND, SHARE * peak))
    return np.stack([columns[name] for name in names], axis=1), np.array(list(names.values()))


def _departures(t: Array, values: Array, group: Places, size: int) -> Array:
    """Largest deviation of each group of ``size`` steps from the line between its ends.

    Args:
        t: Instants [s].
        values: Quantities divided by their bounds, shape (instants, quantities).
        group: First index of each group.
        size: Steps in a group.
    """
    inside = group[:, None] + np.arange(1, size)
    share = (t[inside] - t[group][:, None]) / (t[group + size] - t[group])[:, None]
    first, last = values[group][:, None, :], values[group + size][:, None, :]
    line = first + share[:, :, None] * (last - first)
    return np.asarray(np.abs(values[inside] - line).max(axis=(1, 2)))


def drawn_instants(columns: Mapping[str, Array], arms: int) -> Places:
    """Indices of the instants that are drawn.

    All within `NEAR` of a contact, up to `MOST_NEAR`; elsewhere as few as `BOUNDS` and `APART`
    allow, found by halving groups of steps until each is close enough to a line.
    """
    t = columns["t"]
    values, bounds = _curves(columns, arms)
    values = values / bounds
    keep = np.zeros(len(t), dtype=bool)
    keep[[0, -1]] = True
    close = 0
    for first, last in intervals(t, contact_mask(columns)):
        begin, end = np.searchsorted(t, [t[first] - NEAR, t[last] + NEAR])
        keep[[max(first - 1, 0), first, last, min(last + 1, len(t) - 1)]] = True
        end = min(int(end), int(begin) + MOST_NEAR - close)
        if end > begin:
            keep[begin:end] = True
            close += end - int(begin)
    return np.flatnonzero(keep | _vertices(t, values))


def _vertices(t: Array, values: Array) -> Any:
    """True for the ends of lines that approximate the steps between within the bounds."""
    keep = np.zeros(len(t), dtype=bool)
    steps = len(t) - 1
    groups = np.arange(0, steps - GROUP + 1, GROUP)
    keep[len(groups) * GROUP :] = True  # the rest is less than a group
    size = GROUP
    while size > 1 and len(groups):
        wide = t[groups + size] - t[groups] > APART * (1.0 + 1e-9)
        coarse = wide.copy()
        coarse[~wide] = _departures(t, values, groups[~wide], size) > 1.0
        keep[groups[~coarse]] = True
        halves = groups[coarse]
        size //= 2
        groups = np.sort(np.concatenate([halves, halves + size]))
    keep[groups] = True
    return keep


def departure(columns: Mapping[str, Array], arms: int, places: Places) -> dict[str, float]:
    """Largest interpolation error between the kept instants, by quantity and unit."""
    t = columns["t"]

    def worst(*names: str) -> float:
        return max(
            float(np.max(np.abs(np.interp(t, t[places], columns[n][places]) - columns[n])))
            for n in names
        )

    numbers = range(1, arms + 1)
    obstacles = [name for name in columns if OBSTACLE_PLACE.fullmatch(name)]
    return {
        "position": worst("x", "y", "z"),
        "attitude": worst("qw", "qx", "qy", "qz"),
        "arm_length": worst(*(f"l{j}" for j in numbers)),
        **({"bends": worst(*(f"bend{j}" for j in numbers))} if "bend1" in columns else {}),
        **({"obstacles": worst(*obstacles)} if obstacles else {}),
        "velocity": worst("vx", "vy", "vz"),
        "acceleration": worst("ax", "ay", "az"),
        "force": worst(*(f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns))),
    }
