"""Sliders and choices: input, validation and explanation of the settings of the impact lab."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema
from pydantic_core.core_schema import literal_schema, no_info_before_validator_function

from springback.quantities import Unit, number_in
from springback.settings import problem

#: Longest value quoted in a message [characters] (chosen).
LONGEST_VALUE = 32
#: Significant digits of a number converted from another unit (chosen: they fit the field).
DIGITS = 6


def excerpt(text: str) -> str:
    """Untrusted text, shortened to fit into a message."""
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"


class SliderMark(NamedTuple):
    """A value marked beside a slider, and its source."""

    value: float
    words: str


@dataclass(frozen=True, kw_only=True)
class SliderControl(Unit):
    """A number set by a slider with a field, in the unit of the page."""

    label: str
    least: float
    most: float
    step: float
    explains: str
    marks: tuple[SliderMark, ...] = ()
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Settings under which it has an effect; otherwise the page hides it."""
    logarithmic: bool = False
    path: str = ""
    """Field of a scenario that it sets, where problems with it are reported."""
    whole: bool = False

    def read(self, value: Any) -> float:
        """Number in the unit of the page, within its range."""
        if isinstance(value, str):
            unit = value.strip().lstrip("+-.0123456789eE").strip()
            value = number_in(value, self.unit, bare=True)
            # 10 km/h is 2.77778 m/s in field, link, file and flight alike; a number typed in the
            # slider's own unit is not rounded.
            if unit not in ("", self.unit):
                value = float(f"{value:.{DIGITS}g}")
        number = super().read(value)
        if self.whole and number != round(number):
            raise problem(f"must be a whole number (got {number:g})")
        return number


@dataclass(frozen=True)
class NoControl(Unit):
    """A number that cannot be set, as the user's file gives several, with the reason."""

    label: str = ""
    explains: str = ""
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def read(self, value: Any) -> float:
        """Refuse any value."""
        raise problem(f"cannot be set: {self.explains}")


@dataclass(frozen=True)
class ChoiceControl:
    """A choice among several words."""

    label: str
    words: dict[str, str]
    """Label on the page of each word."""
    explains: str
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def read(self, value: Any) -> str:
        """A valid word."""
        if value in tuple(self.words):
            return str(value)
        *others, last = self.words
        words = f"{', '.join(others)} or {last}"
        raise problem(f"must be {words} (got {excerpt(str(value))!r})")

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate words before pydantic does, for a message of our own."""
        return no_info_before_validator_function(self.read, literal_schema(list(self.words)))
