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
#: A word in quotes, which may contain anything, a blank-delimited and/or, or a parenthesis.
_PIECE = re.compile(
    r"""(?<![^\s(<>=])(?P<quoted>'(?:[^']|'')*'|"[^"]*")"""
    r"""|(?P<sign>[()])|(?<=[\s)])(?P<join>and|or)(?=[\s(])"""
)
_NOT = re.compile(r"not(?:\s+|(?=\())(?P<rest>.+)", re.DOTALL)
_OUTCOME = re.compile(r"\s*(?P<no>not\s+)?(?P<word>[A-Za-z_]+)\s*")
#: Columns that cannot be in a condition, since they are the result of it or of the whole row.
_RESULTS = {"success", "problem"}
#: Relative difference up to which numbers are equal: levels of a field have 12 digits (chosen).
EQUAL = 1e-9
#: Most parentheses and negations of a condition (chosen).
MOST_NESTED = 50


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

    It is a comparison of a column with a quantity (``touch_speed < 2 m/s``) or a word
    (``surface = wall``; in quotes if it contains ``and``, ``or`` or parentheses), an outcome
    (``recovered``, ``not hit_ground``), or several of these with ``and``, ``or``, ``not`` and
    parentheses: ``not (surface = wall and penetration > 5 mm)``.  ``and`` binds closer than ``or``.
    A limit of a measure that a flight does not have is not met.

    Args:
        text: The condition.
        fields: Unit of each varied field by column; None for fields of words.
        judged: True if rows have their verdict, which ``success`` and ``not success`` then ask for.

    Raises:
        InputError: If a name is unknown, or a quantity cannot be read.
    """
    if text.count("(") + len(re.findall(r"\bnot\b", text)) > MOST_NESTED:
        raise InputError(f"{excerpt(text)}: has more than {MOST_NESTED} parentheses and words not")
    either = _split(text, "or")
    if len(either) > 1:
        return " OR ".join(condition_in_words(part, fields, judged=judged) for part in either)
    both = _split(text, "and")
    if len(both) > 1:
        return " AND ".join(f"({condition_in_words(p, fields, judged=judged)})" for p in both)
    text = text.strip()
    if _is_enclosed(text):
        return f"({condition_in_words(text[1:-1], fields, judged=judged)})"
    negated = _NOT.fullmatch(text)
    if negated and not _OUTCOME.fullmatch(text):
        return f"NOT ({condition_in_words(negated['rest'], fields, judged=judged)})"
    return _term(text, fields, judged).sql


def _split(text: str, word: str) -> list[str]:
    """Parts of a condition between ``and`` or ``or``, not of what is in quotes or parentheses."""
    parts, depth, begin = list[str](), 0, 0
    for piece in _PIECE.finditer(text):
        if sign := piece["sign"]:
            depth += 1 if sign == "(" else -1
        elif piece["join"] == word and depth == 0:
            parts.append(text[begin : piece.start()])
            begin = piece.end()
    return [*parts, text[begin:]]


def _is_enclosed(text: str) -> bool:
    """True if the parenthesis that a condition begins with is closed at its end."""
    depth = 0
    for piece in _PIECE.finditer(text):
        depth += {"(": 1, ")": -1}.get(piece["sign"] or "", 0)
        if depth == 0:
            return text.startswith("(") and piece.end() == len(text)
    return False


def is_simple(text: str) -> bool:
    """True for a list of comparisons and outcomes with ``or``, which `alternatives` can read."""
    nested = any(piece["sign"] or piece["join"] == "and" for piece in _PIECE.finditer(text))
    return not nested and not any(
        _NOT.fullmatch(part.strip()) and not _OUTCOME.fullmatch(part) for part in _split(text, "or")
    )


def word_literal(word: str) -> str:
    """A word in quotes, as in a condition."""
    doubled = word.replace("'", "''")
    return f"'{doubled}'"


def upper_limit(text: str) -> tuple[str, float] | None:
    """Column and largest value [SI] of a condition that is one upper limit of a measure.

    Args:
        text: A condition that `condition_in_words` accepts.
    """
    found, units = _COMPARISON.fullmatch(text), known_columns()
    if found is None or not is_simple(text) or " or " in text or found["sign"] not in ("<", "<="):
        return None
    name = found["name"]
    return (name, si_number(found["limit"], units[name][0])) if name in units else None


def alternatives(
    text: str, fields: Mapping[str, str | None], *, judged: bool = False
) -> tuple[ColumnCondition, ...]:
    """Comparisons of which one must hold, from a condition in words; see `condition_in_words`.

    Returns:
        Nothing if it is more than a list of them: has ``and``, parentheses or ``not`` of a limit.
    """
    if not is_simple(text):
        return ()
    return tuple(_term(part, fields, judged) for part in _split(text, "or"))


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
        return ColumnCondition(name, sign, _unquoted(limit))
    try:
        return ColumnCondition(name, sign, si_number(limit, unit))
    except PydanticCustomError as error:
        raise InputError(f"{excerpt(text)}: {name}: {error.message()}") from None


def _unquoted(word: str) -> str:
    """A word as it is stored, whether it was typed in quotes or not."""
    found = _PIECE.fullmatch(word)
    if found is None or not found["quoted"]:
        return word
    return word[1:-1].replace("''", "'") if word[0] == "'" else word[1:-1]


def _hint(word: str, known: Mapping[str, object] | list[str]) -> str:
    hidden = {*FLIGHT, *RESULT}
    near = nearest_name(word, [name for name in known if name not in hidden])
    return f"; did you mean {near}?" if near else "; springback query FOLDER lists the columns"
