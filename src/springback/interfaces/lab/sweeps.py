"""Sweeps of the impact lab: measures over the range of one control, flown in lanes in one call."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Mapping
from typing import Any, NamedTuple

from springback.batch.scenarios import REFUSED, fly_scenarios
from springback.errors import InputError
from springback.interfaces.lab.controls import SliderControl, excerpt
from springback.interfaces.lab.measures import IMPACT
from springback.interfaces.lab.scenarios import is_piloted, lab_scenario, robots_of
from springback.interfaces.lab.settings import LabSettings, control_of, query_of
from springback.interfaces.lab.vehicles import robot_name
from springback.scenario.fields import fields_of
from springback.settings import nearest_name

#: Flights of a sweep for each robot (chosen: four groups of lanes, and the last point).
POINTS = 33
#: Most threads of one sweep (chosen: single flights come first).
THREADS = 4
#: Settings that are not numbers of a kind: each value would be compiled.
NOT_SWEPT = ("arm_count",)


class Sweep(NamedTuple):
    """Settings, one of which is varied over its range."""

    settings: LabSettings
    of: str


def sweep_of(settings: LabSettings, of: str) -> Sweep:
    """Validated sweep.

    Args:
        settings: All other settings.
        of: Name of the setting to vary.

    Raises:
        InputError: If it cannot be varied.
    """
    known = [one["name"] for one in sweep_choices(type(settings))["controls"]]
    if of not in known:
        near = nearest_name(of, known)
        hint = f"did you mean {near}?" if near else f"known: {', '.join(known)}"
        raise InputError(f"of: cannot be swept (got {excerpt(of)!r}); {hint}")
    if is_piloted(settings):
        raise InputError(
            "of: flights with a pilot are not swept here; a campaign can (springback campaign)"
        )
    return Sweep(settings, of)


def sweep_choices(table: type[LabSettings]) -> dict[str, Any]:
    """Controls that can be swept, and measures that can be drawn, as plain data for the page."""
    names = {name: control_of(name, table) for name in fields_of(table) if name not in NOT_SWEPT}
    return {
        "controls": [
            {"name": name, "label": control.label}
            for name, control in names.items()
            if isinstance(control, SliderControl)
        ],
        "measures": [
            {"name": one.name, "label": one.label, "unit": one.unit}
            for one in IMPACT
            if one.name != "touch_speed"
        ],
    }


def points(control: SliderControl) -> list[float]:
    """Values of a control over its range; geometric if its slider is logarithmic."""
    least, most = control.least, control.most
    shares = [k / (POINTS - 1) for k in range(POINTS)]
    if control.logarithmic:
        inner = [least * (most / least) ** share for share in shares]
    else:
        inner = [least + (most - least) * share for share in shares]
    return [least, *(float(f"{one:.6g}") for one in inner[1:-1]), most]


def sweep_answer(sweep: Sweep) -> dict[str, Any]:
    """Measures of all robots at the points of a sweep, as plain data for JSON; null if undefined.

    Points that the scenario's checks refuse are null, too; the first reason is given.
    """
    begun, settings = time.perf_counter(), sweep.settings
    control = control_of(sweep.of, type(settings))
    assert isinstance(control, SliderControl)
    at, robots = points(control), robots_of(settings)
    flown = {robot: _Row(settings, robot, sweep.of, at) for robot in robots}
    tables = [one for row in flown.values() for one in row.tables if one is not None]
    rows = fly_scenarios(tables, threads=min(os.cpu_count() or 1, THREADS))
    first, measures = 0, {}
    for row in flown.values():
        first = row.take(rows.outcomes, rows.measures, first)
    for one in IMPACT:
        measures[one.name] = {
            robot: [None if x is None else one.factor * x for x in row.values(one.name)]
            for robot, row in flown.items()
        }
    refused = [why for row in flown.values() for why in row.refused]
    return {
        "query": query_of(settings),
        "of": sweep.of,
        "at": at,
        "labels": {robot: robot_name(settings, robot) for robot in robots},
        "measures": measures,
        "refused": len(refused),
        "why": refused[0] if refused else "",
        "took": round(1e3 * (time.perf_counter() - begun), 1),
    }


class _Row:
    """Flights of one robot."""

    def __init__(self, settings: LabSettings, robot: str, of: str, at: list[float]) -> None:
        """Scenarios at some values of a setting; equal ones, of a robot without it, only once."""
        self.tables: list[Mapping[str, Any] | None] = []
        self.refused: list[str] = []
        self._numbers: list[int | None] = []
        self._found: dict[str, list[float | None]] = {}
        for value in at:
            try:
                given = lab_scenario(settings.with_checked(**{of: value}), robot)
            except InputError as error:
                self.refused.append(error.problems[0])
                self._numbers.append(None)
                continue
            table = given.model_dump(exclude_none=True, exclude={"name"})
            if not self.tables or table != self.tables[-1]:
                self.tables.append(table)
            self._numbers.append(len(self.tables) - 1)

    def take(self, outcomes: list[str], measures: Mapping[str, Any], first: int) -> int:
        """Take this robot's flights from a batch, from the ``first`` on; the next robot's first."""
        end = first + len(self.tables)
        for name, column in measures.items():
            flown = [
                float(x) if math.isfinite(x) and word != REFUSED else None
                for x, word in zip(column[first:end], outcomes[first:end], strict=True)
            ]
            self._found[name] = [None if k is None else flown[k] for k in self._numbers]
        return end

    def values(self, name: str) -> list[float | None]:
        """A measure at every point, in SI."""
        return self._found[name]
