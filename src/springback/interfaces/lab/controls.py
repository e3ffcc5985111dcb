"""Knobs and choices: how one setting of the impact lab is set, checked and explained."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator

from springback.quantities import checked, number_in
from springback.settings import problem

#: Letters of a value that are looked at at all (chosen).
LONGEST_VALUE = 32
#: Digits that are kept of a number that was given in another unit (chosen: they fit the field).
DIGITS = 6
#: Of a setting that has an effect under all others.
EVERYWHERE: Mapping[str, tuple[str, ...]] = MappingProxyType({})


def shortened(text: str) -> str:
    """A stranger's text, no longer than fits into a message."""
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 1] + "…"


class SliderMark(NamedTuple):
    """A value that is marked beside a slider, and whose it is."""

    value: float
    words: str


class SliderControl(NamedTuple):
    """How a number is set: a slider with a field, in the unit of the page."""

    label: str
    unit: str
    least: float
    most: float
    step: float
    explains: str
    marks: tuple[SliderMark, ...] = ()
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = EVERYWHERE
    """Settings under which it has an effect; elsewhere the page hides it."""
    logarithmic: bool = False


class ChoiceControl(NamedTuple):
    """How one of several words is chosen."""

    label: str
    words: dict[str, str]
    """What the page says for each."""
    explains: str
    group: str = ""
    when: Mapping[str, tuple[str, ...]] = EVERYWHERE


def slider_control(how: SliderControl) -> Any:
    """Type of a field that a knob sets, checked to its range."""

    def validate(value: Any) -> float:
        if isinstance(value, str):
            unit = value.strip().lstrip("+-.0123456789eE").strip()
            value = number_in(value, how.unit, bare=True)
            # 10 km/h is 2.77778 m/s, in field, link, file and flight alike; what is typed in the
            # knob's own unit stays as it is.
            if unit not in ("", how.unit):
                value = float(f"{value:.{DIGITS}g}")
        return checked(value, how.unit, least=how.least, most=how.most)

    return Annotated[float, BeforeValidator(validate), how]


def choice_control(words: tuple[str, ...], how: ChoiceControl) -> Any:
    """Type of a field with one of several words."""

    def validate(value: Any) -> str:
        if value in words:
            return str(value)
        raise problem(
            f"must be {', '.join(words[:-1])} or {words[-1]} (got {shortened(str(value))!r})"
        )

    return Annotated[Literal[words], BeforeValidator(validate), how]
