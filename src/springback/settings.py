"""Base class of all user input: strict, frozen, and with suggestions for unknown keys."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, ValidationError, model_validator
from pydantic_core import PydanticCustomError

from springback.errors import InputError, excerpt, shown_value
from springback.problems import dotted_path, nearest_name, problem_paths

if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass
else:
    ModelMetaclass = type(BaseModel)


def problem(message: str, field: str = "") -> PydanticCustomError:
    """Validation error with a message and the key of the table (dotted for inner tables)."""
    return PydanticCustomError("problem", "{message}", {"message": message, "field": field})


@contextlib.contextmanager
def naming(field: str) -> Iterator[None]:
    """Name the key in problems of checks that do not know it, or only its last part."""
    try:
        yield
    except PydanticCustomError as error:
        inner = str((error.context or {}).get("field", ""))
        below = inner and not inner.startswith(field)
        raise problem(error.message(), f"{field}.{inner}" if below else field) from None


#: Most characters of a name (chosen: it is used in titles, columns and file names).
LONGEST_NAME = 200


def _name(value: str) -> str:
    """Name of printable characters, which cannot control a terminal."""
    if len(value) > LONGEST_NAME:
        raise problem(f"must have at most {LONGEST_NAME} characters (got {len(value)})")
    if not value.isprintable():
        raise problem(f"must be printable, without control characters (got {shown_value(value)})")
    return value


Name = Annotated[str, AfterValidator(_name)]


def none_for_false(value: Any) -> Any:
    """None for False, which removes the table of a preset; for pydantic, before it validates."""
    return None if value is False else value


class _SettingsType(ModelMetaclass):
    """Metaclass that reports invalid arguments of a constructor as `InputError`, one line each.

    It affects only direct calls such as ``Plan(method="sobol")``.  Inner tables are built by the
    validators, whose problems keep their path.
    """

    def __call__(cls: Any, *positional: Any, **given: Any) -> Any:
        try:
            return super().__call__(*positional, **given)
        except ValidationError as error:
            raise InputError(*cls.in_words(error)) from None


class Settings(BaseModel, metaclass=_SettingsType):
    """A table of a scenario file."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    @classmethod
    def in_words(cls, error: ValidationError) -> list[str]:
        """Problems of a table, one line each: the key, and the problem of its value."""
        found = problem_paths(error)
        return [f"{dotted_path(path)}: {what}" if path else what for path, what in found]

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy with some keys changed, which are validated like those of a file.

        Args:
            update: Keys and their new values: numbers in SI, text with a unit, or inner tables,
                of which only the given keys are changed.
            deep: Copy the inner tables, too.

        Raises:
            InputError: One line for each problem, if the changed table is invalid.
        """
        if not update:
            return super().model_copy(deep=deep)
        given = {name: getattr(self, name) for name in self.model_fields_set}
        for key, value in update.items():
            inner = getattr(self, key, None)
            if isinstance(value, Mapping) and isinstance(inner, Settings):
                try:
                    value = inner.model_copy(update=value)
                except InputError as error:
                    raise InputError(*(f"{key}.{line}" for line in error.problems)) from None
            given[key] = value
        changed = type(self)(**given)
        return changed.model_copy(deep=deep)

    def with_checked(self, **values: Any) -> Self:
        """A copy with some values replaced by valid ones, without validation."""
        return super().model_copy(update=values)

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, given: Any) -> Any:
        if isinstance(given, dict) and not given.keys() <= (fields := cls.model_fields).keys():
            for key in given:
                if key not in fields:
                    near = nearest_name(str(key), fields)
                    hint = f"did you mean {near}?" if near else f"known keys: {', '.join(fields)}"
                    raise problem(f"unknown key; {hint}", excerpt(str(key)))
        return given
