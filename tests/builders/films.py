"""Flights to be filmed."""

from __future__ import annotations

from typing import Any

from springback.results.flight import fly
from springback.scenario.scenario import scenario_from


def thrown(**wall: Any) -> Any:
    """ARQ is thrown level into a wall, its rotors at hover thrust."""
    wall = wall or {"distance": "2.75 m"}
    return fly(scenario_from({
        "name": "thrown", "vehicle": "arq", "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "surface": "wall", **wall}]},
        "start": {"position": ["2.3 m", 0, "1 m"], "velocity": ["2 m/s", 0, 0]},
        "simulation": {"duration": "0.3 s"},
    }))  # fmt: skip
