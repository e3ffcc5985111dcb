"""Numbers with units as text: ``"2.75 m"``, ``"5 N/mm"``, ``"-60 deg"``; nothing is evaluated.

The grammar is one decimal number, blanks, and one unit: symbols of the table below with SI
prefixes, joined by blanks or ``·``, with powers and one or more divisions.  There is no comma, no
second number and no operator between numbers.  An angle is a dimension of its own, so that degrees
are not plain numbers and Hz is not rad/s.
"""

from __future__ import annotations

import difflib
import functools
import math
import re
from fractions import Fraction
from typing import NamedTuple

#: Most characters of a number with its unit (chosen); longer text is rejected.
LONGEST = 64
#: Radians per degree, as in the standard library: "15 deg" is ``math.radians(15)``.
DEGREE = math.pi / 180.0

_NUMBER = re.compile(
    r"(?P<number>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?|[+-]?(?i:inf|infinity|nan)(?![a-zA-Z]))"
    r"[ \t]*(?P<unit>[^0-9 \t,.+*-].*|1 */.*)?",
    re.DOTALL,
)
_TERM = re.compile(
    r"(?P<root>√)?(?P<symbol>g_?0|[a-zA-Zµμ°%]+)"
    r"(?:\^(?P<power>-?[0-9](?:\.[0-9]{1,6})?)|(?P<raised>⁻?[¹²³⁴]))?"
)
_JOINED = re.compile(r"[ \t]*[·*][ \t]*|[ \t]+")
_RAISED = str.maketrans("⁻¹²³⁴", "-1234")

Dimension = tuple[Fraction, ...]


class UnitError(ValueError):
    """Text that is not a number with a unit, or has a unit of another dimension."""


class UnitScale(NamedTuple):
    """A unit: its size in SI units and its dimension."""

    size: Fraction  # decimal or rational part
    degrees: Fraction  # power of the degree in it
    dimension: Dimension  # powers of kg, m, s, A and rad

    def times(self, other: UnitScale, power: Fraction) -> UnitScale:
        """Product of this unit and a power of another."""
        size = other.size
        if power.denominator > 2:  # of a contact law's exponent, such as N/m^0.7
            size, whole = Fraction(float(size) ** float(power)), 1
        elif power.denominator != 1:
            root = Fraction(math.isqrt(size.numerator), math.isqrt(size.denominator))
            if root * root != size:  # the root of kHz is irrational
                root = Fraction(math.sqrt(size))
            size, whole = root, int(2 * power)
        else:
            whole = int(power)
        return UnitScale(
            self.size * size**whole,
            self.degrees + power * other.degrees,
            tuple(a + power * b for a, b in zip(self.dimension, other.dimension, strict=True)),
        )


def _unit(size: str | int, *dimension: int, degrees: int = 0) -> UnitScale:
    powers = (*dimension, *(0,) * (5 - len(dimension)))
    return UnitScale(Fraction(size), Fraction(degrees), tuple(map(Fraction, powers)))


_ONE = _unit(1)
#: Units that take prefixes.
_PREFIXED = {
    "m": _unit(1, 0, 1),
    "g": _unit("0.001", 1),
    "s": _unit(1, 0, 0, 1),
    "A": _unit(1, 0, 0, 0, 1),
    "rad": _unit(1, 0, 0, 0, 0, 1),
    "N": _unit(1, 1, 1, -2),
    "J": _unit(1, 1, 2, -2),
    "W": _unit(1, 1, 2, -3),
    "Wh": _unit(3600, 1, 2, -2),
    "V": _unit(1, 1, 2, -3, -1),
    "T": _unit(1, 1, 0, -2, -1),
    "Hz": _unit(1, 0, 0, -1),
    "Pa": _unit(1, 1, -1, -2),
}
_PREFIXES = {
    "G": "1e9", "M": "1e6", "k": "1e3", "d": "1e-1", "c": "1e-2", "m": "1e-3",
    "u": "1e-6", "µ": "1e-6", "μ": "1e-6", "n": "1e-9",
}  # fmt: skip
#: Units without prefixes.
_PLAIN = {
    "deg": _unit(1, 0, 0, 0, 0, 1, degrees=1),
    "turn": _unit(360, 0, 0, 0, 0, 1, degrees=1),
    "rpm": _unit(6, 0, 0, -1, 0, 1, degrees=1),
    "min": _unit(60, 0, 0, 1),
    "h": _unit(3600, 0, 0, 1),
    "in": _unit("0.0254", 0, 1),
    "ft": _unit("0.3048", 0, 1),
    "lb": _unit("0.45359237", 1),
    "oz": _unit("0.028349523125", 1),
    "mph": _unit("0.44704", 0, 1, -1),
    "gn": _unit("9.80665", 0, 1, -2),
    "%": _unit("0.01"),
    "ppm": _unit("1e-6"),
}
_NAMES = {
    "°": "deg", "degree": "deg", "degrees": "deg", "radian": "rad", "radians": "rad",
    "meter": "m", "meters": "m", "metre": "m", "metres": "m",
    "second": "s", "seconds": "s", "minute": "min", "minutes": "min", "hour": "h", "hours": "h",
    "gram": "g", "grams": "g", "newton": "N", "newtons": "N", "percent": "%",
    "g_0": "gn", "g0": "gn",
    "inch": "in", "inches": "in", "foot": "ft", "feet": "ft", "rev": "turn", "revolution": "turn",
}  # fmt: skip
#: Units by symbol.
SYMBOLS: dict[str, UnitScale] = {
    **_PREFIXED,
    **{
        prefix + symbol: UnitScale(Fraction(factor) * unit.size, unit.degrees, unit.dimension)
        for symbol, unit in _PREFIXED.items()
        for prefix, factor in _PREFIXES.items()
    },
    **_PLAIN,
}
SYMBOLS |= {name: SYMBOLS[symbol] for name, symbol in _NAMES.items()}
#: Common units of several symbols, to be suggested for misspelt ones.
_COMPOSED = (
    "m/s", "km/h", "ft/s", "m/s^2", "deg/s", "rad/s", "N/m", "N/mm", "N m", "N m/rad", "N m/deg",
    "N s/m", "N m s/rad", "kg m^2", "g cm^2",
)  # fmt: skip
#: Likeness from which one of them, or of the symbols, may be meant (chosen).
_LIKE = 0.6


@functools.lru_cache(maxsize=256)
def unit_of(text: str) -> UnitScale:
    """Unit of a text such as ``N/mm``, ``kg m^2``, ``1/s`` or ``N/(m s)``; dimensionless if empty.

    Raises:
        UnitError: If the text is not a unit, or is ambiguous.
    """
    if not text.strip():
        return _ONE
    result = _ONE
    for k, part in enumerate(text.split("/")):
        words = part.strip()
        if k == 0 and words in ("", "1"):  # of "/s" and "1/s"
            continue
        grouped = k > 0 and words.startswith("(") and words.endswith(")")
        terms = _JOINED.split(words[1:-1].strip() if grouped else words)
        if k > 0 and len(terms) > 1 and not grouped:
            above = text.partition("/")[0].strip()
            raise UnitError(f"could be read in two ways; write {above}/({' '.join(terms)})")
        for term in terms:
            result = result.times(*_term(term, -1 if k else 1))
    return result


def _term(term: str, over: int) -> tuple[UnitScale, Fraction]:
    """Unit and power of a term such as ``mm^2``."""
    found = _TERM.fullmatch(term)
    if found is None:
        raise UnitError(f"{term!r} is no unit" if term else "a unit is missing")
    symbol = found["symbol"]
    unit = SYMBOLS.get(symbol)
    if unit is None:
        near = difflib.get_close_matches(symbol, SYMBOLS, n=1, cutoff=_LIKE)
        hint = f"; did you mean {near[0]}?" if near else ""
        raise UnitError(f"unknown unit {symbol!r}{hint}")
    power = Fraction(found["power"] or (found["raised"] or "1").translate(_RAISED))
    power = power / 2 if found["root"] else power
    if not power:
        raise UnitError(f"{term!r} is no unit")
    return unit, over * power


def read_number(text: str, unit: str, *, bare: bool = False) -> float:
    """Value of a text in a given unit.

    Decimal parts are converted exactly and rounded once, so that ``"9.3 mm"`` is 0.0093; angles are
    converted as `math.radians` does.

    Args:
        text: Such as ``2.75 m``.
        unit: Unit of the result; empty for a plain number.
        bare: Accept a number without a unit as one in ``unit``.

    Raises:
        UnitError: If the text is not a number with a unit, or its unit has another dimension.
    """
    words = text.strip()
    found = _NUMBER.fullmatch(words) if len(words) <= LONGEST else None
    if found is None:
        raise UnitError(_no_number(words, bare))
    number, given = found["number"], (found["unit"] or "").strip()
    if not given and unit and not bare:
        raise UnitError("has no unit")
    try:
        scale = unit_of(given) if given else None
    except UnitError as error:
        why, near = str(error), _nearest_of(given, unit)
        if near and why.startswith("unknown unit"):
            why = f"unknown unit {given!r}; did you mean {near}?"
        raise UnitError(_no_number(words, bare, why)) from None
    target = unit_of(unit)
    if scale is None:
        scale = target
    if scale.dimension != target.dimension:
        raise UnitError("has the wrong unit")
    if number.lstrip("+-")[0] in "iInN":
        return float(number)
    value = _shortest(Fraction(number) * scale.size / target.size)
    degrees = scale.degrees - target.degrees
    return value * DEGREE ** float(degrees) if degrees else value


def _nearest_of(given: str, unit: str) -> str:
    """Unit of the dimension that is wanted, most like a misspelt one; empty if none is like it.

    The unit that is asked for is preferred to others that are as like.
    """
    wanted = unit_of(unit).dimension
    known = [unit, *(one for one in _COMPOSED if unit_of(one).dimension == wanted)]
    known += [symbol for symbol, one in SYMBOLS.items() if one.dimension == wanted]
    likeness = {one: difflib.SequenceMatcher(None, one, given).ratio() for one in known}
    best = max(likeness, key=lambda one: likeness[one])
    return best if likeness[best] >= _LIKE else ""


def _shortest(exact: Fraction) -> float:
    try:
        return float(exact)
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


def _no_number(words: str, bare: bool, why: str = "") -> str:
    """Message about a text that is not a number, or lacks a required unit."""
    if re.match(r"[+-]?[0-9.]*,[0-9]", words):
        why = "it has a comma; write a decimal point, and nothing between thousands"
    elif re.match(r"[+-]?[0-9.]+ *[^ 0-9*].*[*][*]", words):
        why = "powers are written with ^"
    elif "±" in words or "+/-" in words:
        why = "an uncertainty cannot be given"
    elif re.match(r"[+-]?[0-9.]+(?:[ '_][0-9]| *[*+-])", words):
        why = "it is more than one number"
    return f"is not a number{'' if bare else ' with a unit'}{': ' if why else ''}{why}"
