"""Flight of a chunk of a campaign, by its plan and two numbers, in any process."""

from __future__ import annotations

from typing import Any, NamedTuple

from springback.batch.scenarios import Device, fly_scenarios, no_collection
from springback.campaign.design.layout import Design, design_of

Chunk = tuple[int, int]
"""Numbers of the first flight, and of the one after the last."""


class ChunkRows(NamedTuple):
    """Rows of a chunk of flights."""

    chunk: Chunk
    columns: dict[str, Any]


def fly_chunk(text: str, chunk: Chunk, device: Device = "cpu") -> ChunkRows:
    """Fly a chunk; its rows depend on the plan alone, not on process, device or other chunks.

    Args:
        text: The plan, from `springback.campaign.design.plan.Plan.canonical`.
        chunk: Flights to fly.
        device: Device on which they fly.
    """
    return ChunkRows(chunk, rows(design_of(text), chunk, device))


def rows(
    design: Design, chunk: Chunk, device: Device = "cpu", *, threads: int = 1
) -> dict[str, Any]:
    """Rows of a chunk of flights, by column."""
    with no_collection():
        drawn = design.slice(*chunk)
        ended = fly_scenarios(drawn.tables, threads=threads, device=device)
    tail = {"outcome": ended.outcomes, "problem": ended.problems}
    return {**drawn.columns, **tail, **ended.measures}
