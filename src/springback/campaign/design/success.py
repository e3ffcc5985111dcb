"""Conditions in words of measures and limits: ``arm_stroke < 20 mm``, ``recovered``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from pydantic_core import PydanticCustomError

from springback.campaign.columns import FLIGHT, RESULT, SECOND_OUTCOME, known_columns
from springback.errors import InputError, excerpt
from springback.problems import nearest_name
from springback.quantities import si_number
from springback.results.database import identifier, literal
from springback.simulation.measuring.measures import Outcome

_COMPARISON = re.compile(r"\s*(?P<name>[^<>=!]+?)\s*(?P<sign><=|>=|!=|==?|<|>)\s*(?P<limit>.+?)\s*")
_OUTCOME = re.compile(r"\s*(?P<no>not\s+)?(?P<word>[A-Za-z_]+)\s*")
#: Columns that cannot be in a condition, since they are the result of it or of the whole row.
_RESULTS = {"success", "problem"}
#: Relative difference up to which numbers are equal: levels of a field have 12 digits (chosen).
EQUAL = 1e-9


class ColumnCondition(NamedTuple):
    """A comparison of a column with a quantity, an outcome, or the verdict."""

    column: str
    sign: str
    """One of ``< <= > >= = !=``."""
    value: float | str
    """Limit in SI, or a word."""

    @property
    def sql(self) -> str:
        """The condition in SQL, false for flights without the column's value."""
        name = identifier(self.column)
        if isinstance(self.value, str):
            return f"coalesce({name} {self.sign} {literal(self.value)}, false)"
        number = f"{self.value!r}::DOUBLE"
        if self.sign not in ("=", "!="):
            return f"coalesce({name} {self.sign} {number}, false)"
        near = f"abs({name} - {number}) <= {EQUAL!r} * abs({number})"
        return f"coalesce({near if self.sign == '=' else f'NOT {near}'}, false)"


def condition_in_words(text: str, fields: Mapping[str, str | None], *, judged: bool = False) -> str:
    """SQL of a condition in words.

    It is a comparison of a column with a quantity (``touch_speed < 2 m/s``), an outcome
    (``recovered``, ``not hit_ground``), or several of these with ``or`` between them.  A limit of a
    measure that a flight does not have is not met.

    Args:
        text: The condition.
        fields: Unit of each varied field by column; None for fields of words.
        judged: True if rows have their verdict, which ``success`` and ``not success`` then ask for.

    Raises:
        InputError: If a name is unknown, or a quantity cannot be read.
    """
    return " OR ".join(one.sql for one in alternatives(text, fields, judged=judged))


def upper_limit(text: str) -> tuple[str, float] | None:
    """Column and largest value [SI] of a condition that is one upper limit of a measure.

    Args:
        text: A condition that `condition_in_words` accepts.
    """
    found, units = _COMPARISON.fullmatch(text), known_columns()
    if found is None or " or " in text or found["sign"] not in ("<", "<="):
        return None
    name = found["name"]
    return (name, si_number(found["limit"], units[name][0])) if name in units else None


def alternatives(
    text: str, fields: Mapping[str, str | None], *, judged: bool = False
) -> tuple[ColumnCondition, ...]:
    """Conditions of which one must hold, from a condition in words; see `condition_in_words`."""
    return tuple(_term(part, fields, judged) for part in re.split(r"\s+or\s+", text))


def _term(text: str, fields: Mapping[str, str | None], judged: bool) -> ColumnCondition:
    """A comparison, an outcome or the verdict."""
    columns: dict[str, str | None] = {name: unit for name, (unit, _) in known_columns().items()}
    columns |= {**dict.fromkeys(("robot", "outcome", "first_obstacle", *SECOND_OUTCOME)), **fields}
    outcomes = [outcome.word for outcome in Outcome]
    found = _OUTCOME.fullmatch(text)
    if found is not None:
        word = found["word"]
        if judged and word == "success":
            return ColumnCondition("success", "=", 0.0 if found["no"] else 1.0)
        if word in columns:
            raise InputError(f"{excerpt(text)}: has no limit; write such as {word} < 1")
        if word not in outcomes:
            hint = _hint(word, [*outcomes, *columns])
            raise InputError(f"{excerpt(text)}: is neither an outcome nor a limit{hint}")
        return ColumnCondition("outcome", "!=" if found["no"] else "=", word)
    found = _COMPARISON.fullmatch(text)
    if found is None:
        raise InputError(
            f"{excerpt(text)}: must be a limit such as arm_stroke < 20 mm, or an outcome such as "
            "recovered"
        )
    name, sign, limit = found["name"], found["sign"].replace("==", "="), found["limit"]
    if name not in columns or name in _RESULTS:
        hint = _hint(name, columns)
        raise InputError(f"{excerpt(text)}: there is no column {excerpt(name)}{hint}")
    unit = columns[name]
    if unit is None:
        if sign not in ("=", "!="):
            raise InputError(f"{excerpt(text)}: {name} holds words, which = and != compare")
        return ColumnCondition(name, sign, limit)
    try:
        return ColumnCondition(name, sign, si_number(limit, unit))
    except PydanticCustomError as error:
        raise InputError(f"{excerpt(text)}: {name}: {error.message()}") from None


def _hint(word: str, known: Mapping[str, object] | list[str]) -> str:
    hidden = {*FLIGHT, *RESULT}
    near = nearest_name(word, [name for name in known if name not in hidden])
    return f"; did you mean {near}?" if near else "; springback query FOLDER lists the columns"
