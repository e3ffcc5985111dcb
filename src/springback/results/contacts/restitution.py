"""What a restitution beyond 0 to 1 means: a sentence beside the measure."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Parts that are listed one by one (chosen).
LISTED = 5
#: Normal forces below this are not yet contact [N] (chosen: steps land on touches).
AT_TOUCH = 1e-6


def restitution_note(
    restitution: float | None, columns: Mapping[str, Array], separation: float | None
) -> str:
    """Explanation of ``restitution_at_separation`` if it is not within 0 to 1, else empty.

    The first impact joins all contacts less than ``simulation.dwell`` apart, and its speeds are
    along the normal of the first.  With another normal, or with energy of its spin, its rotors or
    an obstacle in motion, a vehicle may leave faster along that normal than it came.

    Args:
        restitution: The measure.
        columns: Of the trajectory, by which contacts are told; may be empty.
        separation: Instant of the last separation of the first impact [s].
    """
    if restitution is None or 0.0 <= restitution <= 1.0:
        return ""
    if restitution < 0.0:
        return "below 0: it left past what it hit"
    gains = "spin, rotors and what moves may add to it"
    begins = _contacts_until(columns, separation) if separation is not None else []
    if len(begins) < 2:
        return f"above 1: it left faster along the normal of its first touch than it came; {gains}"
    names = list(dict.fromkeys(name for _, name in sorted(begins)))
    what = f" ({', '.join(names)})" if len(names) <= LISTED else ""
    return (
        f"above 1: {len(begins)} contacts{what} are one impact, measured along the normal of the "
        f"first; {gains}"
    )


def _contacts_until(columns: Mapping[str, Array], end: float) -> list[tuple[float, str]]:
    """Instants at which contacts of parts begin before an end [s], and the parts, in words."""
    found: list[tuple[float, str]] = []
    for column in (name for name in columns if name.startswith("fn")):
        felt = (columns[column] > AT_TOUCH) & (columns["t"] < end)
        rows = np.flatnonzero(np.diff(felt.astype(int), prepend=0) > 0)
        part = column[2:]
        name = f"cage {part}" if part.isdigit() else "the main body"
        found += [(float(columns["t"][row]), name) for row in rows]
    return found
