"""Impulses of a recorded flight: where its motion jumped at a surface of the impulse law.

Such a surface has no force, so that columns of forces do not tell of it.  Flights whose motion
jumped have columns of the impulse so far, `IMPULSE`; without a force it changes by jumps alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Columns of the impulse of all contacts on the vehicle so far, world [N s].
IMPULSE = ("impulse_x", "impulse_y", "impulse_z")
#: Impulses below this are rounding [N s] (chosen).
NO_IMPULSE = 1e-12
#: Share by which the impulse of forces between two instants may exceed that of the larger of both
#: (chosen: they rise within a step; a jump is far above it).
RISING = 3.0
#: Most rows from one impulse to the next of a vehicle at rest, which has one every other step.
NEXT = 2


class Jump(NamedTuple):
    """A jump of the motion, or several of a vehicle at rest, step by step."""

    begin: float  # instant of the first [s]
    end: float  # of the last [s]
    before: int  # row before the largest
    impulse: tuple[float, float, float]  # of the largest, on the vehicle, world [N s]

    @property
    def size(self) -> float:
        """Of the largest impulse [N s]."""
        return float(np.linalg.norm(self.impulse))


def impulse_columns(columns: Mapping[str, Array], trace: Any) -> dict[str, Array]:
    """Columns of the impulse [N s], if the motion jumped; else none.

    Args:
        columns: Of the trajectory.
        trace: As recorded.
    """
    found = {
        name: np.ascontiguousarray(trace[f"work.{name.replace('_', '.')}"]) for name in IMPULSE
    }
    return found if any(jumps_of({**columns, **found})) else {}


def jumps_of(columns: Mapping[str, Array]) -> Iterator[Jump]:
    """Jumps of a flight, in order of time.

    Args:
        columns: Of the trajectory; without those of the impulse there are none.
    """
    if any(name not in columns for name in IMPULSE):
        return
    t, steps = columns["t"], np.diff(np.stack([columns[name] for name in IMPULSE], axis=1), axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    felt = sum(
        (values for name, values in columns.items() if name.startswith(("fn", "ff"))),
        np.zeros(len(t)),
    )
    most = RISING * np.maximum(felt[:-1], felt[1:]) * np.diff(t)
    rows = np.flatnonzero(sizes > most + NO_IMPULSE)
    for group in np.split(rows, np.flatnonzero(np.diff(rows) > NEXT) + 1):
        if len(group):
            hardest = int(group[np.argmax(sizes[group])])
            x, y, z = steps[hardest].tolist()
            yield Jump(float(t[group[0] + 1]), float(t[group[-1] + 1]), hardest, (x, y, z))
