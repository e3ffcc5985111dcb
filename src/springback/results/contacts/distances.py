"""Distances of the parts of a vehicle from obstacles along a recorded flight."""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.contact.moving.hulls import with_hulls
from springback.contact.moving.scene import MovingScene, exactly
from springback.contact.parameters import faces
from springback.contact.scene.faces import FACES, SolidScene
from springback.contact.worlds import Own, alone, obstacles
from springback.errors import InputError
from springback.results.contacts.history import contact_history, model_of
from springback.results.result import FlightResult
from springback.scenario.model import RING_ROUNDING
from springback.scenario.tables import UserShape
from springback.scenario.worlds.imported import Imported, single_obstacles

Array = np.ndarray[Any, np.dtype[np.float64]]


def _alone(entry: Any, number: int) -> Any:
    """Scene of one obstacle of a world, or of all elements of an imported one."""
    if isinstance(entry, Imported):
        return obstacles(single_obstacles([entry]), as_scene=True)
    return alone(entry, number)


def gaps(flight: FlightResult, obstacle: int | None = None, own: tuple[Own, ...] = ()) -> Array:
    """Distances of cages and hull from the obstacles; see `springback.Flight.gap`."""
    model = model_of(flight, own)
    entries = [x for x in flight.scenario.world.obstacles if not isinstance(x, UserShape)]
    known, shapes = len(entries), own or flight.own
    if not (count := known + len(shapes)):
        beside = "; gap() knows no distance between two vehicles"
        raise InputError(
            "the world of this flight has no obstacles"
            f"{'' if flight.scenario.second is None else beside}"
        )
    if obstacle is not None and not 0 <= obstacle < count:
        raise InputError(f"obstacle: must be from 0 to {count - 1} (got {obstacle})")
    if isinstance(model.world.obstacles, SolidScene | MovingScene):
        there = model.world.obstacles
        if obstacle is not None and obstacle < known:
            there = _alone(entries[obstacle], obstacle)
            there = with_hulls(there, RING_ROUNDING) if flight.scenario.vehicle.hulls else there
        model = model._replace(world=model.world._replace(obstacles=exactly(there)))
        seen = contact_history(model, flight).gaps
        if obstacle is not None and obstacle >= known:
            seen = seen[:, :, FACES + obstacle - known :][:, :, :1]
        nearest: Array = seen.min(axis=2)
        return nearest
    counts = [
        *(sum(len(faces(one)) for one in single_obstacles([entry])) for entry in entries),
        *(1 for _ in shapes),
    ]
    ends = np.cumsum([0, *counts])  # a second contact of a ring, listed after these, is no nearer
    first, last = 0, int(ends[-1])
    if obstacle is not None:
        first, last = ends[obstacle : obstacle + 2].tolist()
    found: Array = contact_history(model, flight).gaps[:, :, first:last].min(axis=2)
    return found
