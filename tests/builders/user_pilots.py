"""Pilots of the user's own with parameters and a detector in them: one law, plain and compiled."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from springback import QUAD

#: It hovers open loop, and reports a collision while it is pushed back by more than a threshold.
FILE = """
from typing import NamedTuple
from springback import CompiledPilot, PilotContext, PilotOutput, Vec, kernel, pilot_step


class Guard(NamedTuple):
    share: float
    threshold: float
    offset: Vec


@pilot_step.register(Guard)
@kernel
def guarded(pilot, time, measurement, memory):
    felt = measurement.inertial.specific_force.x
    lift = pilot.share * (1.0 + pilot.offset.z)
    return PilotOutput((lift, lift, lift, lift), memory + 1.0, 1.0 if felt < -pilot.threshold else 0.0)


def guard(context: PilotContext, threshold=5.0, offset=Vec(0.0, 0.0, 0.0)):
    if threshold > 1e4:
        raise ValueError(f"a threshold of {threshold:g}")
    share = context.vehicle.mass * context.gravity / 4.0
    return CompiledPilot(Guard(share, threshold, offset), 0.0)


def plain_guard(context: PilotContext, threshold, offset=Vec(0.0, 0.0, 0.0)):
    settings = guard(context, threshold, offset).settings

    def pilot(time, measurement, memory):
        return guarded(settings, time, measurement, memory or 0.0)

    return pilot


@pilot_step.register(Vec)
@kernel
def silent(pilot, time, measurement, memory):
    return PilotOutput((pilot.x, pilot.x, pilot.x, pilot.x), memory)


def mute(context: PilotContext):
    return CompiledPilot(Vec(context.vehicle.mass * context.gravity / 4.0, 0.0, 0.0), 0.0)


def hover(time, measurement, memory):
    return [3.0] * 4, memory
"""
#: Thrust of each rotor of the vehicle in hover [N].
SHARE = QUAD.vehicle.mass * 9.81 / 4.0


def pilot_file(folder: Path) -> Path:
    """The file of these pilots, written into a folder."""
    path = folder / "guards.py"
    path.write_text(FILE)
    return path


def before_a_wall(pilot: Any, **others: Any) -> dict[str, Any]:
    """Quad some millimetres before a wall, at 0.4 m/s, flown by a pilot; it is soon off it."""
    return {
        "vehicle": "quad",
        "pilot": pilot,
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.755, 0.0, 1.0], "velocity": [0.4, 0.0, 0.0]},
        "simulation": {"duration": 0.12, "impact_step": 5e-4},
        "recovery": {"settling": {"dwell": 0.02, "speed": 0.5}},
    } | others
