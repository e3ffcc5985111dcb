"""Numbers with units in user input.

A user writes ``"5 N/mm"``, ``"0.19 m"``, ``"45 deg"``, or plain SI numbers; inside the package
everything is in SI units and radians.  A field ``Annotated[float, Unit("m", above=0.0)]`` accepts a
finite number (SI), or a string with a unit of the same dimension, within its range; otherwise its
error states the value, its unit and the allowed range.  Text is parsed by `springback.units`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema
from pydantic_core.core_schema import no_info_plain_validator_function

from springback.errors import shown_value
from springback.kernels.tracing import Traced, holds  # for batch set-up
from springback.settings import naming, problem
from springback.units import UnitError, read_number

#: Bounds on the magnitudes of non-zero numbers, in SI (chosen: no force, mass or length of a
#: vehicle is beyond them, and their seventh powers are finite).
SMALLEST, LARGEST = 1e-30, 1e30
#: Largest magnitude of an angle: a full turn [rad].
FULL_TURN = 2.0 * math.pi


def number_in(text: str, unit: str, *, bare: bool = False) -> float:
    """Value of a text such as ``5 N/mm`` in a given unit.

    Args:
        text: A number and a unit.
        unit: Unit of the result; empty for a plain number.
        bare: Accept a number without a unit as one in ``unit``.

    Raises:
        The problem, with the given text and the expected unit.
    """
    try:
        return read_number(text, unit, bare=bare)
    except UnitError as error:
        wanted = unit or "a plain number"
        raise problem(f"{error} (got {shown_value(text)}); expected {wanted}") from None


def si_number(
    value: Any,
    unit: str,
    *,
    above: float | None = None,
    least: float | None = None,
    most: float | None = None,
) -> float:
    """A finite SI number in its range, from a number or a string with a unit.

    The magnitude of an angle is at most a full turn: plain numbers are in radians, and a larger one
    is most likely meant in degrees.

    Raises:
        The problem, with the given value, its unit and the allowed range.
    """
    number: Any
    if isinstance(value, Traced):  # of a campaign, whose flights are read and built together
        number = value
    elif isinstance(value, str):
        number = number_in(value, unit)
    elif isinstance(value, bool) or not isinstance(value, int | float):
        kind = f"a number in {unit} or text with a unit" if unit else "a plain number"
        raise problem(f"must be {kind} (got {shown_value(value)})")
    else:
        number = _float(value)

    def is_allowed(x: Any) -> Any:  # of a number, or of a column of them
        fine = is_sizeable(x)
        fine = fine if above is None else fine & (x > above)
        fine = fine if least is None else fine & (x >= least)
        return fine if most is None else fine & (x <= most)

    if holds(is_allowed, number):
        if unit == "rad" and abs(number) > FULL_TURN:
            raise problem(_beyond_a_turn(value, number))
        finite: float = number
        return finite
    given = shown_value(value) if isinstance(value, str) else _given(number, unit)
    bounds = [
        ("finite", math.isfinite(number)),
        (f"more than {with_unit(above, unit)}", above is None or number > above),
        (f"at least {with_unit(least, unit)}", least is None or number >= least),
        (f"at most {with_unit(most, unit)}", most is None or number <= most),
    ]
    bounds += [
        (f"at most {with_unit(LARGEST, unit)} in size", abs(number) <= LARGEST),
        (f"0, or at least {with_unit(SMALLEST, unit)} in size", is_sizeable(number)),
    ]
    broken = [claim for claim, holds in bounds if not holds]
    raise problem(f"must be {broken[0]} (got {given})")


def is_sizeable(number: Any) -> Any:
    """True for numbers that are 0, or of a magnitude whose squares and products are finite."""
    return (number == 0.0) | (abs(number) >= SMALLEST) & (abs(number) <= LARGEST)


def _beyond_a_turn(value: Any, angle: float) -> str:
    """Message about an angle beyond a full turn [rad]."""
    turn = "must be within a full turn, -360 deg to 360 deg"
    if isinstance(value, str):
        return f"{turn} (got {shown_value(value)})"
    return (
        f"{turn}; plain numbers are radians (got {angle:g} rad, which is "
        f'{math.degrees(angle):.6g} deg; write "{angle:g} deg" if degrees are meant)'
    )


def _float(value: float) -> float:
    """Number as a float; infinity for an integer that is too large."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def with_unit(number: float | None, unit: str) -> str:
    """A number and its unit; angles in degrees."""
    if number is None:
        return ""
    angle = unit == "rad" and abs(number) <= FULL_TURN
    return f"{math.degrees(number):.6g} deg" if angle else f"{number:g} {unit}".strip()


def _given(number: float, unit: str) -> str:
    """A plain number as it was given, and an angle in degrees, too."""
    plain, shown = f"{number:g} {unit}".strip(), with_unit(number, unit)
    return plain if shown == plain else f"{plain}, which is {shown}"


@dataclass(frozen=True)
class Unit:
    """SI unit and range of a field of settings, for `typing.Annotated`.

    The field is a float, two floats (`Pair`), three along x, y, z
    (`Triple`), a quaternion (`Quadruple`), one for each arm (`PerArm`), or two or three for all or
    each (`PairPerArm`, `TriplePerArm`).
    """

    unit: str
    """Empty for a plain number."""
    above: float | None = None
    least: float | None = None
    most: float | None = None

    def read(self, value: Any) -> float:
        """Number in SI.

        Raises:
            The problem, with the given value, its unit and the allowed range.
        """
        return si_number(value, self.unit, above=self.above, least=self.least, most=self.most)

    def triple(self, value: Any) -> tuple[float, ...]:
        """Three numbers in SI; see `pair`."""
        return self._several(value, 3, "three")

    def pair(self, value: Any) -> tuple[float, ...]:
        """Two numbers in SI.

        Raises:
            The problem, with the given value, its unit and the allowed range.
        """
        return self._several(value, 2, "two")

    def _several(self, value: Any, count: int, word: str) -> tuple[float, ...]:
        if not isinstance(value, list | tuple) or len(value) != count:
            numbers = f"{word} numbers in {self.unit or 'no unit'}"
            raise problem(f"must be {numbers} (got {shown_value(value)})")
        return tuple(map(self.read, value))

    def quadruple(self, value: Any) -> tuple[float, ...]:
        """Quaternion w, x, y, z.

        Raises:
            The problem, with the given value and the allowed range.
        """
        if not isinstance(value, list | tuple) or len(value) != 4:
            raise problem(f"must be four plain numbers, w, x, y, z (got {shown_value(value)})")
        return tuple(map(self.read, value))

    def _one_or_each(self, value: Any) -> float | tuple[float, ...]:
        return tuple(map(self.read, value)) if isinstance(value, list | tuple) else self.read(value)

    def _triple_or_each(self, value: Any) -> Any:
        return _or_each(self.triple, value)

    def _pair_or_each(self, value: Any) -> Any:
        return _or_each(self.pair, value)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Numbers are read in place of pydantic."""
        readers = {
            Pair: self.pair, Triple: self.triple, Quadruple: self.quadruple,
            PerArm: self._one_or_each, PairPerArm: self._pair_or_each,
            TriplePerArm: self._triple_or_each,
        }  # fmt: skip
        return no_info_plain_validator_function(readers.get(source, self.read))


def _or_each(read: Callable[[Any], tuple[float, ...]], value: Any) -> Any:
    """Several numbers, or a list of such, one for each arm."""
    if isinstance(value, list | tuple) and value and isinstance(value[0], list | tuple):
        found = []
        for k, one in enumerate(value):
            with naming(f"[{k}]"):
                found.append(read(one))
        return tuple(found)
    return read(value)


Pair: TypeAlias = tuple[float, float]
Triple: TypeAlias = tuple[float, float, float]
Quadruple: TypeAlias = tuple[float, float, float, float]
PerArm: TypeAlias = float | tuple[float, ...]
PairPerArm: TypeAlias = Pair | tuple[Pair, ...]
TriplePerArm: TypeAlias = Triple | tuple[Triple, ...]

Mass = Annotated[float, Unit("kg", above=0.0)]
Length = Annotated[float, Unit("m", above=0.0)]
Position = Annotated[float, Unit("m")]
Speed = Annotated[float, Unit("m/s", above=0.0)]
Duration = Annotated[float, Unit("s", above=0.0)]
Angle = Annotated[float, Unit("rad")]
Factor = Annotated[float, Unit("", least=0.0)]
