"""Numbers with units, at the edge only.

A user writes ``"5 N/mm"``, ``"0.19 m"``, ``"45 deg"``, or plain SI numbers.

Inside the package everything is SI and radians.  A field declared with `quantity` takes a number
(SI) or a string with a unit of the right kind, is finite, and keeps to its range; else its error
says what was given, in which unit, and what is allowed.  Text is read by `springback.units`.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, Any

from pydantic import BeforeValidator

from springback.errors import shown_value
from springback.settings import problem
from springback.units import UnitError, read_number

#: Sizes of numbers other than zero, in SI (chosen: no force, mass or length of a vehicle is beyond
#: them, and their seventh powers are still numbers).
SMALLEST, LARGEST = 1e-30, 1e30
#: Most that a plain angle may be, either way: a full turn [rad].
FULL_TURN = 2.0 * math.pi


def number_in(text: str, unit: str, *, bare: bool = False) -> float:
    """The value of a text such as ``5 N/mm`` in some unit.

    Args:
        text: A number and a unit.
        unit: That the value is wanted in; empty for a plain number.
        bare: Whether a number without a unit is read as one in ``unit``.

    Raises:
        The problem, with what was given and what is expected.
    """
    try:
        return read_number(text, unit, bare=bare)
    except UnitError as error:
        wanted = unit or "a plain number"
        raise problem(f"{error} (got {shown_value(text)}); expected {wanted}") from None


def checked(
    value: Any,
    unit: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
) -> float:
    """A finite SI number in its range, from a number or a string with a unit.

    An angle is within a full turn either way: a plain number is radians, and one beyond a full turn
    is far more likely to be degrees.

    Raises:
        The problem, with what was given, its unit and the allowed range.
    """
    if isinstance(value, str):
        number = number_in(value, unit)
    elif isinstance(value, bool) or not isinstance(value, int | float):
        kind = f"a number in {unit} or text with a unit" if unit else "a plain number"
        raise problem(f"must be {kind} (got {shown_value(value)})")
    else:
        number = _float(value)
    if (
        math.isfinite(number)
        and (above is None or number > above)
        and (least is None or number >= least)
        and (most is None or number <= most)
        and is_sizeable(number)
    ):
        if unit == "rad" and abs(number) > FULL_TURN:
            raise problem(_beyond_a_turn(value, number))
        return number
    given = shown_value(value) if isinstance(value, str) else _shown(number, unit)
    bounds = [
        ("finite", math.isfinite(number)),
        (f"more than {_shown(above, unit)}", above is None or number > above),
        (f"at least {_shown(least, unit)}", least is None or number >= least),
        (f"at most {_shown(most, unit)}", most is None or number <= most),
    ]
    bounds += [
        (f"at most {_shown(LARGEST, unit)} in size", abs(number) <= LARGEST),
        (f"0, or at least {_shown(SMALLEST, unit)} in size", is_sizeable(number)),
    ]
    broken = [claim for claim, holds in bounds if not holds]
    raise problem(f"must be {broken[0]} (got {given})")


def is_sizeable(number: float) -> bool:
    """Whether a number is 0, or of a size of which squares and products can be formed."""
    return number == 0.0 or SMALLEST <= abs(number) <= LARGEST


def _beyond_a_turn(value: Any, angle: float) -> str:
    """What is said of an angle beyond a full turn [rad]."""
    turn = "must be within a full turn, -360 deg to 360 deg"
    if isinstance(value, str):
        return f"{turn} (got {shown_value(value)})"
    return (
        f"{turn}; plain numbers are radians (got {angle:g} rad, which is "
        f'{math.degrees(angle):.6g} deg; write "{angle:g} deg" if degrees are meant)'
    )


def _float(value: float) -> float:
    """A number as a float; infinite where it is a whole number too large for one."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


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
            raise problem(
                f"must be three numbers in {unit or 'no unit'} (got {shown_value(value)})"
            )
        return tuple(checked(entry, unit) for entry in value)

    return Annotated[tuple[float, float, float], BeforeValidator(validate)]


Mass = quantity("kg", above=0.0)
Length = quantity("m", above=0.0)
Position = quantity("m")
Speed = quantity("m/s", above=0.0)
Duration = quantity("s", above=0.0)
Angle = quantity("rad")
Factor = quantity("", least=0.0)
