"""Names of code of the user's own in a table of settings, and arguments for it."""

from __future__ import annotations

import re
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator

from springback.errors import shown_value
from springback.quantities import si_number
from springback.settings import Settings, naming, problem

#: Name of an object in a Python file.
CODE_FORM = re.compile(r"(?P<file>.+):(?P<name>[^\W\d]\w*)\Z")


def _code_name(value: str) -> str:
    found = CODE_FORM.match(value)
    if not found or not found["file"].endswith(".py") or not value.isprintable():
        raise problem(f"must be FILE.py:NAME (got {shown_value(value)})")
    return value


#: Name of an object in a Python file, ``FILE.py:NAME``.
CodeName = Annotated[str, AfterValidator(_code_name)]


def _arguments(given: Any) -> dict[str, Any]:
    """Arguments of a user's function: plain numbers, and triples of them."""
    if not isinstance(given, dict):
        raise problem(f"must be a table of numbers (got {shown_value(given)})")
    read = dict[str, Any]()
    for key, value in given.items():
        if not isinstance(key, str) or not key.isidentifier():
            raise problem(f"{shown_value(key)} cannot be the name of an argument")
        with naming(key):
            if isinstance(value, list | tuple) and len(value) == 3:
                read[key] = tuple(si_number(part, "") for part in value)
            else:
                read[key] = si_number(value, "")
    return read


#: Arguments of a user's type or function, in SI.
Arguments = Annotated[dict[str, Any], PlainValidator(_arguments)]


class UserCode(Settings):
    """Code of your own, and its arguments."""

    code: CodeName
    """``FILE.py:NAME`` of the code, or of a function that returns it."""
    parameters: Arguments = Field(default_factory=dict)
    """Arguments of that function, in SI."""


def _code_table(given: Any) -> Any:
    """The table of code that is named without parameters."""
    return {"code": _code_name(given)} if isinstance(given, str) else given


#: Code of the user's own: a table, or its name alone if it has no parameters.
NamedCode = Annotated[UserCode, BeforeValidator(_code_table)]
