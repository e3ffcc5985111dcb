"""Flight of a chunk of a campaign, by its plan and two numbers, in any process."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from springback.batch.scenarios import Device, fly_scenarios, has_second
from springback.campaign.compiler_times import compile_kinds
from springback.campaign.design.layout import Design, design_of
from springback.contact.parameters import PLANES
from springback.errors import InputError
from springback.kernels.compiler import no_collection
from springback.scenario.code_files import changed_files
from springback.scenario.scenario import scenario_from
from springback.scenario.user.compiled import compile_user_code

#: Flights of a chunk that are looked at for kinds to be compiled (chosen).
FEW = 6

Chunk = tuple[int, int]
"""Numbers of the first flight, and of the one after the last."""


class ChunkRows(NamedTuple):
    """Rows of a chunk of flights."""

    chunk: Chunk
    columns: dict[str, Any]
    code: dict[str, str]
    """SHA-256 of the user's own files with which they were flown, by path."""


def fly_chunk(text: str, chunk: Chunk, device: Device = "cpu") -> ChunkRows:
    """Fly a chunk; its rows depend on the plan alone, not on process, device or other chunks.

    Args:
        text: The plan, from `springback.campaign.design.plan.Plan.canonical`.
        chunk: Flights to fly.
        device: Device on which they fly.

    Raises:
        InputError: If a file of the user's own cannot be used, or changes during the flights.
    """
    design = design_of(text)
    code = design.code
    found = ChunkRows(chunk, rows(design, chunk, device), code)
    if changed := changed_files(code):
        raise InputError(f"{', '.join(changed)}: was changed during the flights")
    return found


def try_code(design: Design, device: Device = "cpu") -> None:
    """Build each robot with the user's own code, if there is any, before anything is flown.

    Raises:
        InputError: If a file cannot be used or compiled, or something cannot fly on the device.
    """
    if device != "cpu":
        for base in design.bases:
            _check_planes(base, device)
    for base in design.bases if design.code else ():
        if device != "cpu":
            raise InputError(f"--device {device}: cannot fly code of your own; use cpu")
        compile_user_code(scenario_from(base, False).build(advises=False))


def _check_planes(base: Mapping[str, Any], device: Device) -> None:
    """Reject obstacles that are looked for by a routine of the processor."""
    if has_second(base):
        raise InputError(f"--device {device}: cannot fly two vehicles; use cpu")
    for k, entry in enumerate((base.get("world") or {}).get("obstacles", ())):
        if (kind := entry.get("type")) not in (*PLANES, "own"):
            raise InputError(
                f"--device {device}: flies into {', '.join(PLANES)} only, and "
                f"world.obstacles[{k}] is a {kind}; use cpu"
            )


def rows(
    design: Design, chunk: Chunk, device: Device = "cpu", *, threads: int = 1
) -> dict[str, Any]:
    """Rows of a chunk of flights, by column."""
    with no_collection():
        drawn = design.slice(*chunk)
        if device == "cpu":
            compile_kinds(_few(drawn.tables, len(design.robots)), design.code)
        ended = fly_scenarios(drawn.tables, threads=threads, device=device)
    return {**drawn.columns, **ended.columns}


def _few(tables: list[Any], robots: int) -> list[Any]:
    """One flight of each robot, and a few more, for the kinds of flight among them."""
    return tables[:robots] + tables[robots :: max(1, len(tables) // FEW)]
