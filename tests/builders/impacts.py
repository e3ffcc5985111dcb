"""Impacts on a wall at X = 1 m that several tests look at; all of one compiled structure."""

from __future__ import annotations

from typing import Any

from springback.results.flight import Flight, fly


def towards_wall(vehicle: str = "arq", speed: float = 2.0, **start: Any) -> dict[str, Any]:
    """A vehicle in front of the paper's wall, without gravity; keywords go to the start."""
    return {
        "vehicle": vehicle,
        "world": {
            "gravity": 0.0,
            "obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}],
        },
        "start": {"position": [0.68, 0.0, 0.0], "velocity": [speed, 0.0, 0.0], **start},
        "simulation": {"duration": 0.25},
    }


def flown(vehicle: str, *overrides: str, speed: float = 2.0, **start: Any) -> Flight:
    """The same, flown."""
    return fly(towards_wall(vehicle, speed, **start), *overrides)


def value(flight: Flight, name: str) -> float:
    """A measure that must have happened."""
    found = flight.measures[name]
    assert found is not None, name
    return found
