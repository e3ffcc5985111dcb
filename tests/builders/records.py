"""Records with some of their fields changed."""

from __future__ import annotations

from typing import Any

from springback.simulation.record import Record


def record_with(record: Record, **groups: dict[str, Any]) -> Record:
    """A record with fields of some of its groups replaced."""
    changed = {name: getattr(record, name)._replace(**new) for name, new in groups.items()}
    return record._replace(**changed)
