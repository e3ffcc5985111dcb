"""Scenarios that share tables, checked and made ready without doing the shared work again.

What is checked and what is made is what `springback.scenario.scenario` checks and makes; only
words are missing.  Where anything is wrong, the scenario is read again the ordinary way, which says
what.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any

from pydantic import TypeAdapter, ValidationError
from pydantic_core import PydanticCustomError

from springback.contact.parameters import ObstacleSettings, SurfaceSettings
from springback.errors import InputError
from springback.kernels.memo import FOREVER, Build, Memo
from springback.scenario.build import ReadyFlight, build_flight
from springback.scenario.presets import estimator_table, surface_table, vehicle_table
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.tables import WorldSettings
from springback.settings import problem
from springback.vehicle.library import VEHICLES

#: What `settings_of` and `ready_of` raise.
UNCHECKED = (PydanticCustomError, ValidationError, InputError)


def made_ready(
    table: Mapping[str, Any], build: Memo, biases: Sequence[float] | None = None
) -> ReadyFlight:
    """A flight made ready from plain tables.

    Args:
        table: The whole scenario.
        build: Remembers what flights before shared.
        biases: `turn_on_normals` of its seed, if they are known already.

    Raises:
        InputError: One line for each problem, as of `scenario_from`, but for the distance that a
        run-up would need, which takes long to find out.
    """
    try:
        return ready_of(scenario_of(table, build), build, biases)
    except PydanticCustomError as error:
        if (error.context or {}).get("field") == "reference":
            raise InputError(f"reference: {error.message()}") from None
    except (ValidationError, InputError):
        pass
    return scenario_from(table, False).build()


def ready_of(
    scenario: Scenario, build: Build, biases: Sequence[float] | None = None
) -> ReadyFlight:
    """The checks across the tables, and the numbers.

    Args:
        scenario: Of `scenario_with`.
        build: How parts are made.
        biases: `turn_on_normals` of its seed, if they are known already.
    """
    return build_flight(scenario, (), None, build, biases, advises=False)


# -- settings by tables ---------------------------------------------------------------------------


def scenario_of(table: Mapping[str, Any], build: Build) -> Scenario:
    """A scenario whose tables were checked one by one, but not against each other."""
    return scenario_with(settings_of(table, build))


def scenario_with(settings: Mapping[str, Any]) -> Scenario:
    """A scenario of settings that were checked, by the name of their table."""
    return _bare().with_checked(**settings)


def settings_of(
    table: Mapping[str, Any],
    build: Build,
    before: tuple[Mapping[str, Any], Mapping[str, Any]] = ({}, {}),
) -> dict[str, Any]:
    """The tables of a scenario, checked one by one.

    Args:
        table: The whole scenario.
        build: How parts are made.
        before: Another scenario, which it may share tables with, and its settings.
    """
    others, known = before
    readers, given = _readers(), dict(_defaults())
    for name, value in table.items():
        if name in known and name in others and value is others[name]:
            given[name] = known[name]
            continue
        if name not in readers:
            raise problem("unknown key", str(name))
        place = FOREVER if isinstance(value, dict) else None
        given[name] = build(readers[name], value, build, place=place)
    if "vehicle" not in given:
        raise problem("is missing", "vehicle")
    return given


@functools.cache
def _bare() -> Scenario:
    """Any scenario."""
    return Scenario(vehicle=VEHICLES["arq"].vehicle)


@functools.cache
def _defaults() -> dict[str, Any]:
    """What stands where nothing is given."""
    fields = Scenario.model_fields
    return {name: field.default for name, field in fields.items() if not field.is_required()}


@functools.cache
def _readers() -> dict[str, Callable[[Any, Build], Any]]:
    """What checks the values of the scenario's keys."""
    return {name: _reader(name) for name in Scenario.model_fields}


def _reader(name: str) -> Callable[[Any, Build], Any]:
    """Checks the value of a key of the scenario."""
    field = Scenario.model_fields[name]
    kind: Any = (
        Annotated[(field.annotation, *field.metadata)] if field.metadata else field.annotation
    )
    check = TypeAdapter[Any](kind).validate_python
    unfold = {"vehicle": vehicle_table, "estimator": estimator_table}.get(name, _as_given)

    def read(value: Any, build: Build) -> Any:
        return check(unfold(value))

    return _world if name == "world" else read


def _as_given(value: Any) -> Any:
    """A table that has no presets."""
    return value


def _world(value: Any, build: Build) -> WorldSettings:
    """The world, obstacle by obstacle."""
    if isinstance(value, Mapping) and isinstance(value.get("obstacles"), list | tuple):
        entries = [
            build(_obstacle, entry, k, build, place=k) for k, entry in enumerate(value["obstacles"])
        ]
        value = {**value, "obstacles": entries}
    return WorldSettings.model_validate(value)


_OBSTACLE: TypeAdapter[Any] = TypeAdapter(ObstacleSettings)


def _obstacle(entry: Any, number: int, build: Build) -> Any:
    """An obstacle, surface by surface."""
    if isinstance(entry, Mapping):
        parts = [key for key in ("surface", "backing") if key in entry]
        read = {key: build(_surface, entry[key], place=(key, number)) for key in parts}
        entry = {**entry, **read}
    return _OBSTACLE.validate_python(entry)


def _surface(given: Any) -> SurfaceSettings:
    return SurfaceSettings.model_validate(surface_table(given))
