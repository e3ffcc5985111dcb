"""Flying a stretch of a campaign: from the plan and two numbers to rows, anywhere."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.batch.scenarios import Device, fly_scenarios, no_collection
from springback.campaign.design.layout import Design, design_of

Chunk = tuple[int, int]
"""First flight, and the one after the last."""


class ChunkRows(NamedTuple):
    """A stretch of flights, flown."""

    chunk: Chunk
    columns: dict[str, Any]


def fly_chunk(text: str, chunk: Chunk, device: Device = "cpu") -> ChunkRows:
    """Fly a stretch; its rows depend on the plan alone, wherever and with whatever it flies.

    Args:
        text: The plan, as `springback.campaign.design.plan.Plan.canonical` has it.
        chunk: Which flights.
        device: On which they fly.
    """
    return ChunkRows(chunk, rows(design_of(text), chunk, device))


def rows(
    design: Design, chunk: Chunk, device: Device = "cpu", *, threads: int = 1
) -> dict[str, Any]:
    """Rows of a stretch of flights, column by column."""
    with no_collection():
        drawn = design.slice(*chunk)
        ended = fly_scenarios(drawn.tables, threads=threads, device=device)
    tail = {"outcome": ended.outcomes, "problem": ended.problems}
    return {**drawn.columns, **tail, **ended.measures}
