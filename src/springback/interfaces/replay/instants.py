"""Which instants of a flight are drawn.

A trajectory has every step of the integration.  A picture needs all of them near a contact and few
elsewhere, so some are left out; what straight lines between those that stay get wrong is bounded by
`BOUNDS`, and measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from springback.simulation.playback import NO_FORCE

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: Of what the lines between the kept instants may get wrong, by unit; chosen: finer than a pixel.
BOUNDS = {"m": 2e-4, "": 2e-4, "m/s": 5e-3}
#: The same for arm lengths [m], accelerations [m/s²] and forces [N]; the last two have besides ...
ARM_BOUND, ACCELERATION_BOUND, FORCE_BOUND = 2e-5, 0.5, 0.5
#: ... this share of their peak.
SHARE = 0.01
#: Apart at most [s]: 200 instants a second.
APART = 5e-3
#: Every step is kept so long before and after a contact [s], ...
NEAR = 5e-3
#: ... as long as that makes no more than so many instants; chosen: 0.2 s at a step of 0.1 ms.
MOST_NEAR = 2000
#: Largest group of steps that may become one line; a power of 2.
GROUP = 64


def parts_of(columns: Mapping[str, Array]) -> list[str]:
    """What the columns of forces on each cage, and on the main body with a hull, end with."""
    return [name[2:] for name in columns if name.startswith("fn")]


def touching(columns: Mapping[str, Array]) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Whether anything touches anything, instant by instant."""
    felt = [columns[f"fn{k}"] + columns[f"ff{k}"] > NO_FORCE for k in parts_of(columns)]
    return np.asarray(np.logical_or.reduce(felt), dtype=np.bool_)


def intervals(t: Array, felt: Any, apart: float = 0.0) -> list[tuple[int, int]]:
    """First and last place of every contact; those less than ``apart`` [s] apart are one.

    Args:
        t: Instants [s].
        felt: Whether there is contact at each.
        apart: [s].
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(felt, dtype=int), [0]])))
    found: list[tuple[int, int]] = []
    for first, last in zip(edges[0::2].tolist(), (edges[1::2] - 1).tolist(), strict=True):
        if found and t[first] - t[found[-1][1]] < apart:
            found[-1] = (found[-1][0], last)
        else:
            found.append((first, last))
    return found


def _curves(columns: Mapping[str, Array], arms: int) -> tuple[Array, Array]:
    """What is drawn, shape (instants, quantities), and the bound of each."""
    names = dict.fromkeys("xyz", BOUNDS["m"])
    names |= {f"q{part}": BOUNDS[""] for part in "wxyz"}
    names |= {f"v{axis}": BOUNDS["m/s"] for axis in "xyz"}
    forces = [f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns)]
    peak = max((float(np.max(np.abs(columns[name]), initial=0.0)) for name in forces), default=0.0)
    hardest = max(float(np.max(np.abs(columns[f"a{axis}"]), initial=0.0)) for axis in "xyz")
    names |= {f"l{j}": ARM_BOUND for j in range(1, arms + 1)}
    names |= {f"a{axis}": max(ACCELERATION_BOUND, SHARE * hardest) for axis in "xyz"}
    names |= dict.fromkeys(forces, max(FORCE_BOUND, SHARE * peak))
    return np.stack([columns[name] for name in names], axis=1), np.array(list(names.values()))


def _departures(t: Array, values: Array, group: Places, size: int) -> Array:
    """Largest departure from the line between the ends, of each group of ``size`` steps.

    Args:
        t: Instants [s].
        values: Over their bounds, shape (instants, quantities).
        group: First places of the groups.
        size: Steps in a group.
    """
    inside = group[:, None] + np.arange(1, size)
    share = (t[inside] - t[group][:, None]) / (t[group + size] - t[group])[:, None]
    first, last = values[group][:, None, :], values[group + size][:, None, :]
    line = first + share[:, :, None] * (last - first)
    return np.asarray(np.abs(values[inside] - line).max(axis=(1, 2)))


def drawn_instants(columns: Mapping[str, Array], arms: int) -> Places:
    """Places of the instants that are drawn.

    All within `NEAR` of a contact, up to `MOST_NEAR` of them; elsewhere as few as `BOUNDS` and
    `APART` allow, found by halving groups of steps until each is near enough to a line.
    """
    t = columns["t"]
    values, bounds = _curves(columns, arms)
    values = values / bounds
    keep = np.zeros(len(t), dtype=bool)
    keep[[0, -1]] = True
    close = 0
    for first, last in intervals(t, touching(columns)):
        begin, end = np.searchsorted(t, [t[first] - NEAR, t[last] + NEAR])
        keep[[max(first - 1, 0), first, last, min(last + 1, len(t) - 1)]] = True
        end = min(int(end), int(begin) + MOST_NEAR - close)
        if end > begin:
            keep[begin:end] = True
            close += end - int(begin)
    return np.flatnonzero(keep | _vertices(t, values))


def _vertices(t: Array, values: Array) -> Any:
    """Ends of the lines that are near enough to everything between."""
    keep = np.zeros(len(t), dtype=bool)
    steps = len(t) - 1
    groups = np.arange(0, steps - GROUP + 1, GROUP)
    keep[len(groups) * GROUP :] = True  # fewer than a group are left over
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
    """What lines between the kept instants get wrong at most: m, m of arms, m/s², N, and so on."""
    t = columns["t"]

    def worst(*names: str) -> float:
        return max(
            float(np.max(np.abs(np.interp(t, t[places], columns[n][places]) - columns[n])))
            for n in names
        )

    numbers = range(1, arms + 1)
    return {
        "position": worst("x", "y", "z"),
        "attitude": worst("qw", "qx", "qy", "qz"),
        "arm_length": worst(*(f"l{j}" for j in numbers)),
        "velocity": worst("vx", "vy", "vz"),
        "acceleration": worst("ax", "ay", "az"),
        "force": worst(*(f"{kind}{k}" for kind in ("fn", "ff") for k in parts_of(columns))),
    }
