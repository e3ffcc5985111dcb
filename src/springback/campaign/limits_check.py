"""Conditions of success that no flight can meet."""

from __future__ import annotations

import re

import numpy as np
from pydantic import ValidationError
from pydantic_core import PydanticCustomError

from springback.campaign.design.layout import Design
from springback.campaign.design.success import upper_limit
from springback.errors import InputError
from springback.scenario.presets import expand_presets
from springback.scenario.tables import ScenarioTables
from springback.simulation.measuring.measures import Outcome
from springback.studies.approach import ObstacleApproach, approach_ahead
from springback.studies.scenario_check import least_deceleration

#: Measures that are at least the deceleration of the main body.
DECELERATIONS = (
    "peak_acceleration", "peak_specific_force", "impact_peak_acceleration",
    "impact_peak_specific_force",
)  # fmt: skip
#: Flights that are looked at, spread over the campaign (chosen).
TRIED = 256


def unreached_success(design: Design) -> list[str]:
    """Sentence on a success that asks for a recovery, where no flight can recover.

    Args:
        design: Whose success is a list of conditions in words.
    """
    given = design.plan.success
    asked = isinstance(given, tuple) and any(
        {part.strip() for part in re.split(r"\bor\b", text)} == {Outcome.RECOVERED.word}
        for text in given
    )
    keys = {
        key for base in design.bases for key in ("recovery", "pilot") if base.get(key) is not None
    }
    varied = {one.table for one in design.dimensions}
    if not asked or keys or design.plan.pilots or varied & {"recovery", "pilot"}:
        return []
    return [
        f"success asks for {Outcome.RECOVERED.word}, and no flight can be: the scenario has no "
        "[recovery], so that every flight counts as a failure"
    ]


def unmet_limits(design: Design) -> list[str]:
    """Sentences on limits of success below v²/(2 s), with which an arm stops the body at best.

    Args:
        design: Whose success is a list of conditions in words.
    """
    given = design.plan.success
    limits = [upper_limit(text) for text in given] if isinstance(given, tuple) else []
    asked = [one for one in limits if one is not None and one[0] in DECELERATIONS]
    if not asked:
        return []
    name, limit = min(asked, key=lambda one: one[1])
    numbers = np.unique(np.linspace(0, design.flights - 1, TRIED).astype(int)).tolist()
    beyond = dict[int, tuple[float, ScenarioTables, ObstacleApproach]]()
    for number in numbers:
        tables = design.slice(number, number + 1).tables[0]
        try:
            scenario = ScenarioTables.model_validate(expand_presets(tables))
            approach = approach_ahead(scenario)
        except (InputError, ValidationError, PydanticCustomError):  # a row that is refused
            continue
        least = least_deceleration(scenario, approach)
        if approach is not None and least > limit:
            beyond[number] = least, scenario, approach
    if not beyond:
        return []
    worst = max(beyond, key=lambda number: beyond[number][0])
    least, scenario, approach = beyond[worst]
    stroke = scenario.vehicle.arms.at("stroke", approach.arm)
    return [
        f"success asks for {name} below {limit:.4g} m/s², and in {len(beyond)} of {len(numbers)} "
        f"flights no spring can stop the body so gently within its stroke: flight {worst} meets "
        f"{approach.words}, at {approach.speed:.3g} m/s, and with s = {1e3 * stroke:.3g} mm "
        f"v²/(2 s) is {least:.4g} m/s²"
    ]
