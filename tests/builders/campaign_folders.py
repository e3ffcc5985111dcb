"""Rows that no flight made, to fill a store with."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import numpy as np

from builders.plans import plan
from springback.campaign.design.layout import Design, lay_out
from springback.campaign.store import open_store
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measuring.measures import MEASURES


def rows(design: Design, first: int, last: int) -> dict[str, Any]:
    """Rows of flights, each of which follows from its number alone."""
    columns: dict[str, Any] = dict(design.slice(first, last).columns)
    drawn = [
        np.frombuffer(hashlib.sha256(str(k).encode()).digest(), np.uint8) / 256.0
        for k in range(first, last)
    ]
    won = [1.2 - 0.2 * v > d[0] for v, d in zip(columns["speed"], drawn, strict=True)]
    columns["outcome"] = [
        "refused" if k % 10 == 9 else "separated" if ok else "hit_ground"
        for k, ok in zip(range(first, last), won, strict=True)
    ]
    columns["problem"] = ["too weak" if w == "refused" else "" for w in columns["outcome"]]
    hit = ["" if w == "refused" else "world.obstacles[0], a wall" for w in columns["outcome"]]
    columns["first_obstacle"] = hit
    for j, name in enumerate(MEASURES | RECOVERY_MEASURES):
        values = np.array(
            [d[j % 32] + 1e-9 * k for d, k in zip(drawn, range(first, last), strict=True)]
        )
        values[np.array(columns["outcome"]) == "refused"] = np.nan
        columns[name] = values if name in MEASURES else values * np.nan
    return columns


def filled(folder: Path, parts: int = 3, size: int = 10, **given: Any) -> Design:
    """A folder with some parts of a campaign."""
    design = lay_out(plan(**{"samples": 30, **given}))
    with open_store(folder, design, resume=False) as store:
        for k in range(parts):
            last = min((k + 1) * size, design.flights)
            store.add(k * size, last, rows(design, k * size, last))
    return design
