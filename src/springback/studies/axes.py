"""Parameters of a trial by name: which there are, their units, and how one is given a value.

``speed`` and ``pitch`` are the run-up's; any other name is the dotted path of a number in the
scenario, such as ``control.time_constant``, ``world.obstacles.0.surface.friction`` or
``air.wind.0``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from springback.errors import InputError
from springback.problems import dotted, key_path
from springback.scenario.fields import Parameter, Path, number_at
from springback.scenario.files import overridden
from springback.scenario.scenario import Scenario, preset, scenario_from
from springback.studies.run_ups import run_up_scenario
from springback.studies.trials import DURATION, NO_SCATTER, Condition, trial_tables
from springback.vehicle.library import VEHICLES

#: Parameters with a name of their own.
SHORT: dict[str, Path] = {"speed": ("reference", "speed"), "pitch": ("reference", "pitch")}
#: The run-up where neither axis nor setting says otherwise [m/s], [rad]: the paper's fastest.
RUN_UP = {"speed": 3.5, "pitch": 0.0}
#: What every trial deals out by itself, and so cannot be given.
DEALT = {
    "start": "every trial starts elsewhere, as luck has it",
    "seed": "give --seed",
    "vehicle.preset": "give --robot",
    "vehicle": "give --robot, or a number of the vehicle, such as vehicle.arms.stiffness",
    "name": "a trial has no name",
}
#: The wall; a trial places it.
SURFACE: Path = ("world", "obstacles", 0, "surface")
#: Most values along an axis (chosen): more are a slip of the pen.
MOST_VALUES = 200


@dataclass(frozen=True)
class Axis:
    """Values of a parameter, equally far apart."""

    parameter: Parameter
    values: tuple[float, ...]
    """SI."""

    @property
    def name(self) -> str:
        """Of the parameter."""
        return self.parameter.name

    @property
    def label(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.parameter.shown_unit}]"

    @property
    def shown(self) -> tuple[float, ...]:
        """Values in the shown unit."""
        return tuple(self.parameter.shown(value) for value in self.values)


def parameter(name: str, scenario: Scenario) -> Parameter | None:
    """The parameter of a name; None if it is there but is no single number.

    Args:
        name: Short or dotted.
        scenario: That has it.

    Raises:
        InputError: If there is none of this name, or trials deal it out.
    """
    path = SHORT.get(name) or key_path(name)
    name = next((short for short, full in SHORT.items() if full == path), dotted(path))
    if not path:
        raise InputError(f"unknown parameter {name!r}; give speed, pitch or a dotted path")
    for length in (1, 2):
        why = DEALT.get(dotted(path[:length]))
        if why and (length == len(path) or path[0] == "start"):
            raise InputError(f"{name}: cannot be given; {why}")
    if path[:2] == SURFACE[:2] and path[:4] != SURFACE:
        raise InputError(
            f"{name}: cannot be given, a trial places the wall; what can is {dotted(SURFACE)}, "
            f"such as {dotted(SURFACE)}.friction"
        )
    return number_at(name, path, scenario, tuple(SHORT))


def read_axis(text: str, scenario: Scenario) -> Axis:
    """An axis written as ``name=from:to:count``.

    Args:
        text: Such as ``pitch=-60deg:60deg:9``.
        scenario: That has the parameter.
    """
    name, sign, span = text.partition("=")
    parts = span.split(":")
    if not sign or len(parts) != 3:
        raise InputError(
            f"{text!r} is no axis; write name=from:to:count, such as speed=1:5:9 or "
            "pitch=-60deg:60deg:9"
        )
    found = parameter(name.strip(), scenario)
    if found is None:
        raise InputError(f"{name.strip()}: is no single number, and cannot be an axis")
    first, last = found.read(parts[0]), found.read(parts[1])
    count = int(parts[2]) if parts[2].strip().isdecimal() else 0
    if not 2 <= count <= MOST_VALUES:
        raise InputError(
            f"{found.name}: count must be a whole number from 2 to {MOST_VALUES} (got {parts[2]!r})"
        )
    if first == last:
        raise InputError(f"{found.name}: from and to must differ (got {parts[0]} twice)")
    digits = 12 - math.ceil(math.log10(max(abs(first), abs(last))))
    steps = (first + (last - first) * k / (count - 1) for k in range(count))
    values = tuple(round(value, digits) + 0.0 for value in steps)  # + 0: no minus zero
    for value in values if found.whole else ():
        if value != round(value):
            raise InputError(
                f"{found.name}: must be whole numbers, which {count} values from {first:g} to "
                f"{last:g} are not"
            )
    return Axis(found, values)


@dataclass(frozen=True)
class Fixed:
    """A setting that is the same in all trials."""

    parameter: Parameter | None
    """None where the value is no number."""
    path: Path
    word: str
    """As it was given."""
    value: float = 0.0

    def placed(self, tables: dict[str, Any]) -> dict[str, Any]:
        """Tables with the setting."""
        if self.parameter is None:
            return overridden(tables, [self.word])
        return _placed(tables, self.parameter, self.value)


def read_fixed(word: str, scenario: Scenario) -> Fixed:
    """A setting written as ``key=value``."""
    name, sign, text = word.partition("=")
    if not sign or not name.strip():
        raise InputError(f"{word!r} is no setting; write key=value, such as pitch=30deg")
    found = parameter(name.strip(), scenario)
    if found is None:
        return Fixed(None, key_path(name.strip()), word)
    return Fixed(found, found.path, word, found.read(text.strip().strip("\"'")))


def condition(
    robot: str, fixed: Sequence[Fixed], places: Sequence[tuple[Parameter, float]]
) -> Condition:
    """The test of a robot with settings, and parameters at values.

    Args:
        robot: Preset.
        fixed: Settings; later ones win.
        places: Parameters and values, which win over settings.
    """
    numbers = [(one.parameter, one.value) for one in fixed if one.parameter is not None]
    run_up = dict(RUN_UP)
    for found, value in [*numbers, *places]:
        if found.name in SHORT:
            run_up[found.name] = value
    speed, pitch = run_up["speed"], _degrees(run_up["pitch"])
    start = run_up_scenario(robot, pitch, speed, simulation={"duration": DURATION})
    tables, paths = start, list[Path]()
    for one in fixed:
        if one.parameter is None or one.parameter.name not in SHORT:
            tables, paths = one.placed(tables), [*paths, one.path]
    for found, value in places:
        if found.name not in SHORT:
            tables, paths = _placed(tables, found, value), [*paths, found.path]
    changes = {key: tables[key] for key in (str(path[0]) for path in paths)}
    return Condition(robot, pitch, speed, changes)


def example(robot: str) -> Scenario:
    """A trial of a robot without luck, to look parameters up in."""
    entry = preset("vehicle", robot, VEHICLES)
    if entry.vehicle.propulsion is None:
        raise InputError(f"--robot {robot}: has no propulsion, so no pilot can fly it")
    noise_stream = NO_SCATTER.drawn(robot, 0.0, 2.0, 0, 0)
    return scenario_from(trial_tables(robot, 0.0, 2.0, noise_stream))


def _at(tables: Any, path: Path) -> Any:
    """What stands at a path in raw tables; None if nothing does."""
    for key in path:
        if isinstance(tables, Mapping):
            tables = tables.get(str(key))
        elif isinstance(tables, list) and isinstance(key, int) and key < len(tables):
            tables = tables[key]
        else:
            return None
    return tables


def _placed(tables: dict[str, Any], found: Parameter, value: float) -> dict[str, Any]:
    """Tables with a parameter at a value."""
    if found.others and not isinstance(_at(tables, found.path[:-1]), list | tuple):
        tables = overridden(tables, [f"{dotted(found.path[:-1])}={[*found.others]}"])
    number = int(value) if found.whole else value
    return overridden(tables, [f"{dotted(found.path)}={number!r}"])


def _degrees(angle: float) -> float:
    """Of radians, without the last digits, which are rounding errors."""
    return round(math.degrees(angle), 9) + 0.0
