"""Sweeps of the impact lab: measures over the range of one control.

The flights are those of the page, one by one on a few threads: 33 take 0.2 s.  In lanes they take
no less, as reading them does, and lanes are compiled for minutes for each new number of arms.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import groupby
from typing import Any, NamedTuple

from springback.errors import InputError
from springback.interfaces.lab.controls import SliderControl, excerpt
from springback.interfaces.lab.measures import IMPACT
from springback.interfaces.lab.scenarios import is_piloted, lab_scenario, robots_of
from springback.interfaces.lab.settings import LabSettings, control_of, query_of
from springback.interfaces.lab.vehicles import robot_name
from springback.problems import nearest_name
from springback.results.flight import fly
from springback.scenario.fields import fields_of

#: Flights of a sweep for each robot (chosen).
POINTS = 33
#: Most threads of one sweep (chosen: single flights come first).
THREADS = 4
#: Settings that are not numbers of a kind: each value would be compiled.
NOT_SWEPT = ("arm_count",)

_Measures = dict[str, float | None]


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

    Points that the scenario's checks refuse are null, too; see `_refusals`.
    """
    begun, settings = time.perf_counter(), sweep.settings
    control = control_of(sweep.of, type(settings))
    assert isinstance(control, SliderControl)
    at, robots = points(control), robots_of(settings)
    with ThreadPoolExecutor(min(os.cpu_count() or 1, THREADS)) as pool:
        fly_at = partial(_point, settings, sweep.of)
        flown = {robot: list(pool.map(partial(fly_at, robot), at)) for robot in robots}
    return {
        "query": query_of(settings),
        "of": sweep.of,
        "at": at,
        "labels": {robot: robot_name(settings, robot) for robot in robots},
        "measures": {
            one.name: {
                robot: [None if isinstance(x, str) else one.read(x) for x in row]
                for robot, row in flown.items()
            }
            for one in IMPACT
        },
        "refusals": [
            {"robot": robot, **one} for robot, row in flown.items() for one in _refusals(at, row)
        ],
        "took": round(1e3 * (time.perf_counter() - begun), 1),
    }


def _refusals(at: Sequence[float], row: Sequence[_Measures | str]) -> Iterator[dict[str, Any]]:
    """Stretches of points that cannot be flown, each with the reason at its end beside others."""
    for refused, run in groupby(range(len(at)), lambda k: isinstance(row[k], str)):
        places = list(run)
        first, last = places[0], places[-1]
        if refused:
            why = row[last if first == 0 else first]
            yield {"from": at[first], "to": at[last], "count": len(places), "why": why}


def _point(settings: LabSettings, of: str, robot: str, value: float) -> _Measures | str:
    """Measures with one setting changed, or the reason why that cannot be flown."""
    try:
        given = lab_scenario(settings.with_checked(**{of: value}), robot)
    except InputError as error:
        return error.problems[0]
    return fly(given, trajectory=False).measures
