"""Records, blank and with some of their fields changed."""

from __future__ import annotations

from typing import Any

from springback.dynamics.motion import Engaged
from springback.simulation.measuring.record import Record, blank_record


def record_of(arms: int, obstacles: int = 1, hulls: int = 0, propellers: int = 0) -> Record:
    """Record of a flight that has not begun, of parts that all have as many faces."""
    apart = (0.0,) * obstacles
    return blank_record(Engaged((apart,) * arms, (apart,) * hulls), propellers)


def record_with(record: Record, **groups: dict[str, Any]) -> Record:
    """A record with fields of some of its groups replaced."""
    changed = {name: getattr(record, name)._replace(**new) for name, new in groups.items()}
    return record._replace(**changed)
