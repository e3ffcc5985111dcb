"""Values of a plan's fields as text, in the units in which the plan has them."""

from __future__ import annotations

import re
from typing import Any

from pydantic_core import PydanticCustomError

from springback.campaign.design.dimensions import Dimension
from springback.campaign.design.distributions import (
    LevelSet,
    NormalDistribution,
    NormalFactor,
    PosteriorColumn,
    UniformDistribution,
)
from springback.campaign.design.layout import Design
from springback.campaign.design.plan import Vary
from springback.interfaces.output.quantities import DisplayUnit, display_unit
from springback.quantities import number_in

_WITH_UNIT = re.compile(r"\s*[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?\s*(?P<unit>\S.*?)\s*")
#: Most levels that are shown one by one, and how many of more at both ends (chosen).
FEW, FIRST, LAST = 8, 3, 2


def dimension_units(design: Design) -> list[DisplayUnit]:
    """Units of a design's dimensions: those in which its plan was written, else degrees or SI."""
    entries = iter(design.plan.vary)
    return [
        _usual(one.unit) if one.scatter or one.joint else _written(next(entries), one.unit)
        for one in design.dimensions
    ]


def _written(entry: Vary, unit: str) -> DisplayUnit:
    """Unit of the first number of an entry that has one."""
    normal = entry.normal
    laws = () if normal is None else (normal.mean, normal.deviation)
    for given in (entry.from_, entry.to, *(entry.values or ()), *laws):
        found = _WITH_UNIT.fullmatch(given) if isinstance(given, str) else None
        if found:
            try:
                return DisplayUnit(found["unit"], 1.0 / number_in(f"1 {found['unit']}", unit))
            except PydanticCustomError:  # a word, such as the name of a surface
                continue
    return _usual(unit)


def _usual(unit: str) -> DisplayUnit:
    return display_unit(unit) if unit == "rad" else DisplayUnit(unit, 1.0)


def law_text(one: Dimension, scale: float, symbol: str = "") -> str:
    """Values of a dimension in words.

    Args:
        one: The dimension.
        scale: From SI to the unit shown.
        symbol: Of that unit; none is shown if it is empty.
    """
    law, factor, unit = one.law, " times its own" if one.factor else "", f" {symbol}".rstrip()
    if isinstance(law, LevelSet):
        shown = [_level(value, scale) for value in law.values]
        few = shown if len(shown) <= FEW else [*shown[:FIRST], "...", *shown[-LAST:]]
        return f"{', '.join(few)}{unit} ({len(shown)} values)"
    if isinstance(law, PosteriorColumn):
        low, high = scale * min(law.draws), scale * max(law.draws)
        return f"{low:.6g} to {high:.6g}{unit}, {len(law.draws)} rows of a posterior"
    if isinstance(law, UniformDistribution):
        spacing = " (logarithmic)" if law.logarithmic else ""
        return f"{scale * law.first:.6g} to {scale * law.last:.6g}{unit}{factor}{spacing}"
    if isinstance(law, NormalDistribution):
        added = ", added to its own" if one.own or one.scatter else ""
        mean, deviation = scale * law.mean, scale * law.deviation
        return f"normal, mean {mean:.6g}{unit}, deviation {deviation:.6g}{unit}{added}"
    assert isinstance(law, NormalFactor)
    return f"normal, deviation {law.deviation:.6g}, times its own"


def _level(value: Any, scale: float) -> str:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return f"{scale * value:.6g}" if is_number else str(value)
