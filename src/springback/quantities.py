"""Numbers with units, at the edge only.

A user writes ``"5 N/mm"``, ``"0.19 m"``, ``"45 deg"``, or plain SI numbers.

Inside the package everything is SI and radians.  A field declared with `quantity` takes a number
(SI) or a string with a unit of the right kind, is finite, and keeps to its range; else its error
says what was given, in which unit, and what is allowed.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, Any

from pydantic import BeforeValidator

from springback.settings import problem


@functools.cache
def _units() -> Any:
    import pint  # slow to import, so only when a string is met

    return pint.UnitRegistry(cache_folder=":auto:")


def _number(text: str, unit: str) -> float:
    """The SI value of a string such as ``5 N/mm``, for a field in some SI unit."""
    import pint

    registry, wanted = _units(), unit or "a plain number"
    try:
        parsed = registry.Quantity(text)
    except Exception as error:  # pint raises many kinds for malformed text
        raise problem(f"is not a number with a unit (got {text!r}); expected {wanted}") from error
    try:
        return float(parsed.to(unit or "").magnitude)
    except pint.DimensionalityError as error:
        raise problem(f"has the wrong unit (got {text!r}); expected {wanted}") from error


def checked(
    value: Any,
    unit: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
) -> float:
    """A finite SI number in its range, from a number or a string with a unit.

    Raises:
        The problem, with what was given, its unit and the allowed range.
    """
    if isinstance(value, str):
        number = _number(value, unit)
    elif isinstance(value, bool) or not isinstance(value, int | float):
        kind = f"a number in {unit} or text with a unit" if unit else "a plain number"
        raise problem(f"must be {kind} (got {value!r})")
    else:
        number = float(value)
    if (
        math.isfinite(number)
        and (above is None or number > above)
        and (least is None or number >= least)
        and (most is None or number <= most)
    ):
        return number
    bounds = [
        ("finite", math.isfinite(number)),
        (f"more than {_shown(above, unit)}", above is None or number > above),
        (f"at least {_shown(least, unit)}", least is None or number >= least),
        (f"at most {_shown(most, unit)}", most is None or number <= most),
    ]
    broken = [claim for claim, holds in bounds if not holds]
    given = repr(value) if isinstance(value, str) else _shown(number, unit)
    raise problem(f"must be {broken[0]} (got {given})")


def _shown(number: float | None, unit: str) -> str:
    return "" if number is None else f"{number:g} {unit}".strip()


def quantity(unit: str, **bounds: float) -> Any:
    """Type of a settings field, a float in an SI unit; bounds ``above``, ``least``, ``most``."""
    return Annotated[float, BeforeValidator(functools.partial(checked, unit=unit, **bounds))]


def spread(unit: str, **bounds: float) -> Any:
    """Type of a pydantic field: one float, or one for each arm."""

    def validate(value: Any) -> float | tuple[float, ...]:
        if isinstance(value, list | tuple):
            return tuple(checked(entry, unit, **bounds) for entry in value)
        return checked(value, unit, **bounds)

    return Annotated[float | tuple[float, ...], BeforeValidator(validate)]


def triple(unit: str) -> Any:
    """Type of a pydantic field: three floats along x, y, z."""

    def validate(value: Any) -> tuple[float, ...]:
        if not isinstance(value, list | tuple) or len(value) != 3:
            raise problem(f"must be three numbers in {unit or 'no unit'} (got {value!r})")
        return tuple(checked(entry, unit) for entry in value)

    return Annotated[tuple[float, float, float], BeforeValidator(validate)]


Mass = quantity("kg", above=0.0)
Length = quantity("m", above=0.0)
Position = quantity("m")
Speed = quantity("m/s", above=0.0)
Duration = quantity("s", above=0.0)
Angle = quantity("rad")
Factor = quantity("", least=0.0)
