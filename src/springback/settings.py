"""The base of everything a user writes down: strict, frozen, and helpful about unknown keys."""

from __future__ import annotations

import contextlib
import difflib
from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, model_validator
from pydantic_core import PydanticCustomError

from springback.errors import shortened, shown_value


def problem(message: str, field: str = "") -> PydanticCustomError:
    """What is wrong, in words, and with which key of the table (dotted for inner tables)."""
    return PydanticCustomError("problem", "{message}", {"message": message, "field": field})


@contextlib.contextmanager
def naming(field: str) -> Iterator[None]:
    """Name the key at fault in problems of checks that do not know it."""
    try:
        yield
    except PydanticCustomError as error:
        raise problem(error.message(), field) from None


#: Characters of a name (chosen: it goes into titles, columns and names of files).
LONGEST_NAME = 200


def _name(value: str) -> str:
    """A name of printable characters, which no terminal takes for more than text."""
    if len(value) > LONGEST_NAME:
        raise problem(f"must have at most {LONGEST_NAME} characters (got {len(value)})")
    if not value.isprintable():
        raise problem(f"must be printable, without control characters (got {shown_value(value)})")
    return value


Name = Annotated[str, AfterValidator(_name)]


class Settings(BaseModel):
    """A table of a scenario file."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, given: Any) -> Any:
        if isinstance(given, dict) and not given.keys() <= (fields := cls.model_fields).keys():
            for key in given:
                if key not in fields:
                    near = difflib.get_close_matches(str(key), fields, n=1, cutoff=0.5)
                    known = "known keys: " + ", ".join(fields)
                    hint = f"did you mean {near[0]}?" if near else known
                    raise problem(f"unknown key; {hint}", shortened(str(key)))
        return given
