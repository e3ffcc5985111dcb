"""Knobs and choices: how one setting of the impact lab is set, checked and explained."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema
from pydantic_core.core_schema import literal_schema, no_info_before_validator_function

from springback.quantities import Unit, number_in
from springback.settings import problem

#: Letters of a value that are looked at at all (chosen).
LONGEST_VALUE = 32
#: Digits that are kept of a number that was given in another unit (chosen: they fit the field).
DIGITS = 6


def shortened(text: str) -> str:
    """A stranger's text, no longer than fits into a message."""
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"


class SliderMark(NamedTuple):
    """A value that is marked beside a slider, and whose it is."""

    value: float
    words: str


@dataclass(frozen=True, kw_only=True)
class SliderControl(Unit):
    """How a number is set: a slider with a field, in the unit of the page."""

    label: str
    least: float
    most: float
    step: float
    explains: str
    marks: tuple[SliderMark, ...] = ()
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Settings under which it has an effect; elsewhere the page hides it."""
    logarithmic: bool = False

    def read(self, value: Any) -> float:
        """A number in its range, in the unit of the page."""
        if isinstance(value, str):
            unit = value.strip().lstrip("+-.0123456789eE").strip()
            value = number_in(value, self.unit, bare=True)
            # 10 km/h is 2.77778 m/s, in field, link, file and flight alike; what is typed in the
            # slider's own unit stays as it is.
            if unit not in ("", self.unit):
                value = float(f"{value:.{DIGITS}g}")
        return super().read(value)


@dataclass(frozen=True)
class ChoiceControl:
    """How one of several words is chosen."""

    label: str
    words: dict[str, str]
    """What the page says for each."""
    explains: str
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def read(self, value: Any) -> str:
        """One of the words."""
        if value in tuple(self.words):
            return str(value)
        *others, last = self.words
        words = f"{', '.join(others)} or {last}"
        raise problem(f"must be {words} (got {shortened(str(value))!r})")

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Words are read before pydantic sees them."""
        return no_info_before_validator_function(self.read, literal_schema(list(self.words)))
