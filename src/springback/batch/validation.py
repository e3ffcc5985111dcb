"""Validation and building of scenarios that share tables, without repeating the shared work.

The checks and results are those of `springback.scenario.scenario`; only error messages are missing.
If anything is wrong, the scenario is read again the ordinary way, which reports it.
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

#: Exceptions of `settings_of` and `ready_of`.
UNCHECKED = (PydanticCustomError, ValidationError, InputError)


def flight_from_tables(
    table: Mapping[str, Any], build: Memo, biases: Sequence[float] | None = None
) -> ReadyFlight:
    """Build a flight from plain tables.

    Args:
        table: The whole scenario.
        build: Memo with the parts that earlier flights share.
        biases: `turn_on_normals` of its seed, if already known.

    Raises:
        InputError: One line for each problem, as of `scenario_from`, but without the distance that
            a run-up would need, which is slow to find.
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
    """Check a scenario across its tables, and build it.

    Args:
        scenario: From `scenario_with`.
        build: Builder of the parts.
        biases: `turn_on_normals` of its seed, if already known.
    """
    return build_flight(scenario, (), None, build, biases, advises=False)


# -- settings by tables ---------------------------------------------------------------------------


def scenario_of(table: Mapping[str, Any], build: Build) -> Scenario:
    """A scenario with tables validated one by one, but not against each other."""
    return scenario_with(settings_of(table, build))


def scenario_with(settings: Mapping[str, Any]) -> Scenario:
    """A scenario of validated settings, by the name of their table."""
    return _bare().with_checked(**settings)


def settings_of(
    table: Mapping[str, Any],
    build: Build,
    before: tuple[Mapping[str, Any], Mapping[str, Any]] = ({}, {}),
) -> dict[str, Any]:
    """Tables of a scenario, validated one by one.

    Args:
        table: The whole scenario.
        build: Builder of the parts.
        before: Another scenario that may share tables, and its settings.
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
    """A minimal scenario."""
    return Scenario(vehicle=VEHICLES["arq"].vehicle)


@functools.cache
def _defaults() -> dict[str, Any]:
    """Default values of a scenario."""
    fields = Scenario.model_fields
    return {name: field.default for name, field in fields.items() if not field.is_required()}


@functools.cache
def _readers() -> dict[str, Callable[[Any, Build], Any]]:
    """Validators of the scenario's keys."""
    return {name: _reader(name) for name in Scenario.model_fields}


def _reader(name: str) -> Callable[[Any, Build], Any]:
    """Validator of one key of the scenario."""
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
    """A table without presets, unchanged."""
    return value


def _world(value: Any, build: Build) -> WorldSettings:
    """The world, validated obstacle by obstacle."""
    if isinstance(value, Mapping) and isinstance(value.get("obstacles"), list | tuple):
        entries = [
            build(_obstacle, entry, k, build, place=k) for k, entry in enumerate(value["obstacles"])
        ]
        value = {**value, "obstacles": entries}
    return WorldSettings.model_validate(value)


_OBSTACLE: TypeAdapter[Any] = TypeAdapter(ObstacleSettings)


def _obstacle(entry: Any, number: int, build: Build) -> Any:
    """An obstacle, validated surface by surface."""
    if isinstance(entry, Mapping):
        parts = [key for key in ("surface", "backing") if key in entry]
        read = {key: build(_surface, entry[key], place=(key, number)) for key in parts}
        entry = {**entry, **read}
    return _OBSTACLE.validate_python(entry)


def _surface(given: Any) -> SurfaceSettings:
    return SurfaceSettings.model_validate(surface_table(given))
