"""Knobs and choices: how one setting of the impact lab is set, checked and explained."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator

from springback.quantities import checked
from springback.settings import problem

#: Letters of a value that are looked at at all (chosen).
LONGEST_VALUE = 32
#: Digits that are kept of a number that was given in another unit (chosen: they fit the field).
DIGITS = 6
_WITH_UNIT = re.compile(
    r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[+-]?[0-9]{1,3})? *[a-z%° /·]{1,12}", re.IGNORECASE
)
#: Of a setting that has an effect under all others.
EVERYWHERE: Mapping[str, tuple[str, ...]] = MappingProxyType({})


def shortened(text: str) -> str:
    """A stranger's text, no longer than fits into a message."""
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"


class Mark(NamedTuple):
    """A value that is marked beside a slider, and whose it is."""

    value: float
    words: str


class Knob(NamedTuple):
    """How a number is set: a slider with a field, in the unit of the page."""

    label: str
    unit: str
    least: float
    most: float
    step: float
    explains: str
    marks: tuple[Mark, ...] = ()
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = EVERYWHERE
    """Settings under which it has an effect; elsewhere the page hides it."""
    logarithmic: bool = False


class Choice(NamedTuple):
    """How one of several words is chosen."""

    label: str
    words: dict[str, str]
    """What the page says for each."""
    explains: str
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = EVERYWHERE


def knob(how: Knob) -> Any:
    """Type of a field that a knob sets, checked to its range."""

    def validate(value: Any) -> float:
        if isinstance(value, str):
            value = _number_of(value, how.unit)
        number = checked(value, how.unit, least=how.least, most=how.most)
        # 10 km/h is 2.77778 m/s, in field, link, file and flight alike; what is typed in the knob's
        # own unit stays as it is.
        return float(f"{number:.{DIGITS}g}") if isinstance(value, str) else number

    return Annotated[float, BeforeValidator(validate), how]


def _number_of(text: str, unit: str) -> float | str:
    """A number in a knob's unit; text with a unit is left to `checked` if it is no more than that.

    Strings come from strangers: expressions such as ``9**9**9`` are not to be computed.
    """
    text = text.strip()
    try:
        return float(text)
    except ValueError:
        if len(text) <= LONGEST_VALUE and _WITH_UNIT.fullmatch(text):
            return text
    raise problem(f"must be a number in {unit or 'no unit'} (got {shortened(text)!r})")


def choice(words: tuple[str, ...], how: Choice) -> Any:
    """Type of a field with one of several words."""

    def validate(value: Any) -> str:
        if value in words:
            return str(value)
        raise problem(
            f"must be {', '.join(words[:-1])} or {words[-1]} (got {shortened(str(value))!r})"
        )

    return Annotated[Literal[words], BeforeValidator(validate), how]
