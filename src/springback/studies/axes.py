"""Parameters of a trial by name: which there are, their units, and how one is given a value.

``speed`` and ``pitch`` are the run-up's; any other name is the dotted path of a number in the
scenario, such as ``control.time_constant``, ``world.obstacles.0.surface.friction`` or
``air.wind.0``.
"""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BeforeValidator
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError

from springback.errors import InputError
from springback.problems import dotted, key_path
from springback.quantities import checked, number_in
from springback.scenario.files import overridden
from springback.scenario.scenario import Scenario, preset, scenario_from
from springback.settings import Settings, meant
from springback.studies.run_ups import run_up_scenario
from springback.studies.trials import DURATION, NO_SCATTER, Condition, trial_tables
from springback.vehicle.library import VEHICLES

Path = tuple[str | int, ...]

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
class Parameter:
    """A number of a trial's scenario."""

    name: str
    path: Path
    unit: str
    """SI; empty for plain numbers."""
    whole: bool = False
    """Whether it must be a whole number."""
    others: tuple[float, ...] = ()
    """Of a vector, all its numbers, of which this is one."""

    @property
    def shown_unit(self) -> str:
        """As people read it: angles in degrees."""
        return {"rad": "deg", "": "-"}.get(self.unit, self.unit)

    def shown(self, value: float) -> float:
        """A value in the shown unit."""
        return _degrees(value) if self.unit == "rad" else value

    def read(self, text: str) -> float:
        """The SI value of a text such as ``0.1``, ``5 N/mm`` or ``-60deg``."""
        try:
            value = checked(number_in(text, self.unit, bare=True), self.unit)
        except PydanticCustomError as error:
            raise InputError(f"{self.name}: {error.message()}") from None
        if self.whole and value != round(value):
            raise InputError(f"{self.name}: must be a whole number (got {value:g})")
        return value

    def placed(self, tables: dict[str, Any], value: float) -> dict[str, Any]:
        """Tables with the parameter at a value."""
        if self.others and not isinstance(_at(tables, self.path[:-1]), list | tuple):
            vector = f"{dotted(self.path[:-1])}={[*self.others]}"
            tables = overridden(tables, [vector])
        number = int(value) if self.whole else value
        return overridden(tables, [f"{dotted(self.path)}={number!r}"])


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
    return number_at(name, path, scenario)


def number_at(name: str, path: Path, scenario: Scenario) -> Parameter | None:
    """The number at a path of a scenario; None if what is there is no single number.

    Args:
        name: That it goes by.
        path: Keys and indices, at least one.
        scenario: That has it.

    Raises:
        InputError: If there is nothing of this path.
    """
    field, parent = _walked(path, name, scenario)
    unit, whole = _number_kind(field, inside=isinstance(path[-1], int))
    if unit is None and not whole:
        return None
    others = tuple(parent) if isinstance(parent, tuple) else ()
    if any(not isinstance(entry, float | int) for entry in others):
        return None
    return Parameter(name, path, unit or "", whole, others)


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
        return self.parameter.placed(tables, self.value)


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
            tables, paths = found.placed(tables, value), [*paths, found.path]
    changes = {key: tables[key] for key in (str(path[0]) for path in paths)}
    return Condition(robot, pitch, speed, changes)


def example(robot: str) -> Scenario:
    """A trial of a robot without luck, to look parameters up in."""
    entry = preset("vehicle", robot, VEHICLES)
    if entry.vehicle.propulsion is None:
        raise InputError(f"--robot {robot}: has no propulsion, so no pilot can fly it")
    noise_stream = NO_SCATTER.drawn(robot, 0.0, 2.0, 0, 0)
    return scenario_from(trial_tables(robot, 0.0, 2.0, noise_stream))


# -- looking into settings ------------------------------------------------------------------------


def _walked(path: Path, name: str, scenario: Scenario) -> tuple[FieldInfo | None, Any]:
    """The field at the end of a path, and the list that an entry is in.

    A table that is not there is looked up in its class.
    """
    field: FieldInfo | None = None
    node: Any = scenario
    parent: Any = None
    for key in path:
        kind = node if isinstance(node, type) else type(node)
        if isinstance(key, int):
            if not isinstance(node, tuple) or key >= len(node):
                raise InputError(f"{name}: there is no entry {key}")
            parent, node = node, node[key]
        elif not issubclass(kind, Settings):
            raise InputError(f"{name}: unknown parameter; {key!r} is not inside a table")
        elif key not in kind.model_fields:
            near = meant(key, [*kind.model_fields, *SHORT])
            known = "known here: " + ", ".join(kind.model_fields)
            hint = f"did you mean {near}?" if near else known
            raise InputError(f"{name}: unknown parameter {key!r}; {hint}")
        else:
            field, parent = kind.model_fields[key], None
            node = field.default if isinstance(node, type) else getattr(node, key)
            if node is None:
                node = next(_tables(field.annotation), None)
    return field, parent


def _leaves(annotation: Any, notes: tuple[Any, ...] = ()) -> Iterator[tuple[Any, tuple[Any, ...]]]:
    """The plain types of an annotation, each with what `Annotated` says of it."""
    if get_origin(annotation) is Annotated:
        inner, *more = get_args(annotation)
        yield from _leaves(inner, (*notes, *more))
    elif get_origin(annotation) in (Union, UnionType):
        for branch in get_args(annotation):
            yield from _leaves(branch, notes)
    else:
        yield annotation, notes


def _tables(annotation: Any) -> Iterator[type[Settings]]:
    for leaf, _ in _leaves(annotation):
        if isinstance(leaf, type) and issubclass(leaf, Settings):
            yield leaf


def _number_kind(field: FieldInfo | None, inside: bool) -> tuple[str | None, bool]:
    """SI unit of a number's field, None if it has none, and whether it is a whole number's.

    Args:
        field: Any.
        inside: Whether an entry of its list is meant.
    """
    if field is None:
        return None, False
    leaves = list(_leaves(field.annotation, tuple(field.metadata)))
    for leaf, notes in leaves:
        if leaf is float or (inside and get_origin(leaf) is tuple):
            for note in notes:
                if isinstance(note, BeforeValidator) and (unit := _unit(note.func)) is not None:
                    return unit, False
    return None, any(leaf is int for leaf, _ in leaves)


def _unit(validator: Any) -> str | None:
    """The unit that a validator of `springback.quantities` was made for."""
    if isinstance(validator, functools.partial):
        known: Mapping[str, Any] = validator.keywords
    else:
        known = inspect.getclosurevars(validator).nonlocals
    unit = known.get("unit")
    return unit if isinstance(unit, str) else None


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


def _degrees(angle: float) -> float:
    """Of radians, without the last digits, which are rounding errors."""
    return round(math.degrees(angle), 9) + 0.0
