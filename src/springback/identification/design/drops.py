"""Drop tests among which a plan chooses: heights and tilts, each from its fall to its bounce."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.identification.observations.drop_start import Fall, fall_of
from springback.identification.observations.initial_state import InitialState
from springback.identification.observations.windows import BEFORE_BOUNCE
from springback.identification.settings import FitPlan
from springback.logs.segments import find_impacts
from springback.logs.writing.flight_recording import flight_recording
from springback.results.flight import fly
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import Scenario, scenario_from

#: Time after touch that a drop is flown to look for its bounce [s] (chosen).
BOUNCES = 0.5


class DropWindow(NamedTuple):
    """Part of a drop that a fit would use."""

    before: float  # from its first instant to touch [s]
    after: float  # from touch to its bounce, or less [s]
    start: InitialState  # at its first instant


def drop_candidates(
    plan: FitPlan, scenario: Scenario, tables: Mapping[str, Any]
) -> list[tuple[str, list[str]]]:
    """Names and overrides of drops from all heights at all tilts, that of the scenario first.

    Args:
        plan: Of the fit.
        scenario: Its scenario.
        tables: The same as plain tables.

    Raises:
        InputError: If the scenario's vehicle does not fall from its start onto something.
    """
    given, start = plan.candidates, scenario.start
    fall_of(scenario)  # what is wrong with the scenario is said once
    tilts: list[tuple[float, float] | None] = [None]
    if scenario.model.slider is None and start.quaternion is None:
        own = (start.roll, start.pitch)
        tilts = [own, *(one for one in itertools.product(given.rolls, given.pitches) if one != own)]
    found = []
    for height, tilt in itertools.product(given.heights, tilts):
        change, turned = [], ""
        if tilt is not None:
            roll, pitch = tilt
            change = [f"start.roll={roll!r}", f"start.pitch={pitch!r}"]
            turned = f", roll {math.degrees(roll):g} deg, pitch {math.degrees(pitch):g} deg"
        fall = fall_of(scenario_from(apply_overrides(dict(tables), change), False, advises=False))
        up = -fall.acceleration / np.linalg.norm(fall.acceleration)
        place = np.array(start.position) + (height - fall.height) * up
        shown = [round(float(part), 9) for part in place]
        found.append((f"{height:g} m{turned}", [*change, f"start.position={shown}"]))
    return found


def planned_drop(
    plan: FitPlan, scenario: Scenario, tables: Mapping[str, Any], longest: float
) -> DropWindow:
    """Part of a drop that a fit would use: from its fall until it bounces.

    Args:
        plan: Of the fit.
        scenario: Of the drop.
        tables: The same as plain tables.
        longest: Time after touch that is recorded at most [s].

    Raises:
        InputError: If it is no drop, or a log of it would have no impact that can be used.
    """
    fall = fall_of(scenario)
    before = min(plan.window.before, fall.duration)
    position, velocity = fall.before_touch(before)
    state, tracked = scenario.start_state(), "motion-capture" in plan.candidates.sensors
    guess = InitialState(
        position, velocity, np.array(state.attitude), np.array(state.angular_velocity), tracked,
        0.0 if tracked else fall.speed,
    )  # fmt: skip
    bounce = _bounce(tables, fall)
    after = longest if bounce is None else min(longest, bounce - BEFORE_BOUNCE)
    return DropWindow(before, after, guess)


def _bounce(tables: Mapping[str, Any], fall: Fall) -> float | None:
    """Time from touch to the impact that follows, as a log would tell it [s]; None if none does."""
    simulation = dict(tables.get("simulation", {})) | {"duration": fall.duration + BOUNCES}
    flown = dict(tables) | {"simulation": simulation}
    flown.setdefault("sensors", {})
    found = find_impacts([flight_recording(fly(scenario_from(flown)), Path("drop"))], drops=True)
    usable = [one for one in found if not one.refused]
    if not usable:
        why = [one.refused for one in found] or ["a log of it would have no impact"]
        raise InputError(*why)
    first = usable[0]
    return None if first.following is None else first.following - first.touch
