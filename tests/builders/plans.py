"""Small plans to test with: throws at a wall, a millisecond each, and run-ups with recovery."""

from __future__ import annotations

from typing import Any

from springback.campaign.design.plan import Plan, plan_from

THROW: dict[str, Any] = {
    "vehicle": "arq",
    "thrust": "hover",
    "world": {
        "obstacles": [
            {"type": "wall", "distance": "1 m", "surface": "wall"},
            {"type": "ground", "surface": "wall"},
        ]
    },
    "start": {"position": ["0.6 m", 0, "1 m"], "velocity": [2.0, 0, 0]},
    "simulation": {"duration": 0.3},
}
SPEED = {"field": "start.velocity.0", "name": "speed", "from": "1 m/s", "to": "3 m/s"}
PITCH = {"field": "start.pitch", "name": "pitch", "from": "-30 deg", "to": "30 deg"}
SURFACE = {"field": "surface", "values": ["wall", "mat"]}
STIFFNESS = {"field": "stiffness", "factor": {"deviation": "10 %"}}
WALL = {"field": "wall angle", "normal": {"mean": 0, "deviation": "5 deg"}}


def plan(**given: Any) -> Plan:
    """Throws of both robots; 2 · 12 flights unless said otherwise."""
    usual = {
        "scenario": THROW, "robots": ["arq", "quad"], "method": "random", "samples": 12, "seed": 3,
        "vary": [SPEED, PITCH, SURFACE, STIFFNESS, WALL],
    }  # fmt: skip
    return plan_from(usual | given)
