"""What a restitution beyond 0 to 1 means: a sentence beside the measure."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Parts that are listed one by one (chosen).
LISTED = 5
#: Share of the speed along the normal below which a touch is told to graze (chosen).
GRAZING = 0.1
_SPEEDS = ("vx", "vy", "vz")
#: Share beyond 1 that is rounding, and of the step, where nothing is lost (chosen: 3e-10 is usual).
ROUNDED = 1e-6
#: Normal forces below this are not yet contact [N] (chosen: steps land on touches).
AT_TOUCH = 1e-6


def restitution_note(
    measures: Mapping[str, float | None], columns: Mapping[str, Array], guard: str = "cage"
) -> str:
    """Explanation of ``restitution_at_separation`` if it is not within 0 to 1, else empty.

    The first impact joins all contacts less than ``simulation.dwell`` apart, and its speeds are
    along the normal of the first.  With another normal, or with energy of its spin, its rotors or
    an obstacle in motion, a vehicle may leave faster along that normal than it came; so may one
    that only grazed it.

    Args:
        measures: Of the flight.
        columns: Of the trajectory, by which contacts are told; may be empty.
        guard: What an arm touches with, in words.
    """
    restitution, left = (
        measures.get("restitution_at_separation"), measures.get("separation_time"),
    )  # fmt: skip
    if restitution is None or 0.0 <= restitution <= 1.0 + ROUNDED:
        return ""
    if restitution < 0.0:
        return "below 0: it left past what it hit"
    gains = "spin, rotors and what moves may add to it"
    begins = _contacts_until(columns, left, guard) if left is not None else []
    if len(begins) < 2:
        grazed = _grazed(measures, columns)
        return (
            f"above 1: it left faster along the normal of its first touch than it came{grazed}; "
            f"{gains}"
        )
    names = list(dict.fromkeys(name for _, name in sorted(begins)))
    what = f" ({', '.join(names)})" if len(names) <= LISTED else ""
    return (
        f"above 1: {len(begins)} contacts{what} are one impact, measured along the normal of the "
        f"first{_grazed(measures, columns)}; {gains}"
    )


def _grazed(measures: Mapping[str, float | None], columns: Mapping[str, Array]) -> str:
    """Words for a first touch that was almost along the surface, else empty."""
    inward, when = measures.get("touch_speed"), measures.get("touch_time")
    if inward is None or when is None or "vx" not in columns:
        return ""
    speed = float(np.linalg.norm([np.interp(when, columns["t"], columns[v]) for v in _SPEEDS]))
    return f", which it grazed: {inward:.2g} of {speed:.2g} m/s" if inward < GRAZING * speed else ""


def _contacts_until(
    columns: Mapping[str, Array], end: float, guard: str
) -> list[tuple[float, str]]:
    """Instants at which contacts of parts begin before an end [s], and the parts, in words."""
    found: list[tuple[float, str]] = []
    for column in (name for name in columns if name.startswith("fn")):
        felt = (columns[column] > AT_TOUCH) & (columns["t"] < end)
        rows = np.flatnonzero(np.diff(felt.astype(int), prepend=0) > 0)
        part = column[2:]
        name = f"{guard} {part}" if part.isdigit() else "the main body"
        found += [(float(columns["t"][row]), name) for row in rows]
    return found
