"""Numbers with units: what is read, exactly, and what is refused because it could mean two things."""

from __future__ import annotations

import contextlib
import math
import time
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from springback.quantities import number_in, si_number
from springback.units import SYMBOLS, UnitError, read_number, unit_of

#: Text, the unit that is wanted, and the value: all by definition of the units.
READ = [
    ("2.75 m", "m", 2.75), ("275cm", "m", 2.75), ("9.3 mm", "m", 0.0093), (".5 km", "m", 500.0),
    ("5 N/mm", "N/m", 5000.0), ("90 N*s/m", "N s/m", 90.0), ("90 N·s/m", "N s/m", 90.0),
    ("1e-3 kg m^2", "kg m^2", 1e-3), ("1 g m²", "kg m^2", 1e-3), ("36 km/h", "m/s", 10.0),
    ("1 kHz", "1/s", 1000.0), ("20 1/s", "1/s", 20.0), ("20 /s", "1/s", 20.0), ("2 s^-1", "1/s", 2.0),
    ("90 deg", "rad", math.pi / 2.0), ("-60deg", "rad", math.radians(-60.0)), ("1 turn", "rad", math.tau),
    ("60 rpm", "rad/s", math.tau), ("3 N/(m s)", "N/(m s)", 3.0), ("2 m/s/s", "m/s^2", 2.0),
    ("1 mm/s^2/√Hz", "m/s^2/Hz^0.5", 1e-3), ("70 Wh", "J", 252000.0), ("2 mV/mT", "V/T", 2.0),
    ("40 %", "", 0.4), ("0.4", "", 0.4), ("3 mm/m", "", 0.003), ("+2 m", "m", 2.0), ("5 inch", "m", 0.127),
    ("16 gn", "m/s^2", 156.9064), ("16 g_0", "m/s^2", 156.9064), ("16 g0", "m/s^2", 156.9064), ("180 deg", "deg", 180.0), ("200 kN/m^1.5", "kN/m^1.5", 200.0),
    ("2 kN/m^0.7", "N/m^0.7", 2000.0), ("2 N/mm^0.75", "N/m^0.75", 2.0 * 1000.0**0.75), ("3 kN/m^1.333", "N/m^1.333", 3000.0),
]  # fmt: skip


@pytest.mark.parametrize(("text", "unit", "value"), READ)
def test_what_is_read(text: str, unit: str, value: float) -> None:
    """Conversions are exact and rounded once, so equality is equality of bits."""
    assert read_number(text, unit) == value
    assert si_number(text, unit) == value


#: Text, the unit of the field, and a word of the reason.
REFUSED = [
    ("2,75 m", "m", "comma"), ("1,5 m", "m", "comma"), ("1,2 kg", "kg", "comma"), ("0,4", "", "comma"),
    ("1,5", "rad", "comma"), ("10,5 deg", "rad", "comma"), ("1.234,5 m", "m", "comma"),
    ("1,234.5 m", "m", "comma"), ("12 345 m", "m", "more than one"), ("1 200 g", "kg", "more than one"),
    ("1'000 m", "m", "more than one"), ("1_000 m", "m", "more than one"), ("2*3 m", "m", "more than one"),
    ("9**9**9 deg", "rad", "more than one"), ("2 m + 3 m", "m", "no unit"), ("2 m 3", "m", "no unit"),
    ("1 ±0.1 m", "m", "uncertainty"), ("1 +/- 0.1 m", "m", "uncertainty"), ("%s", "s", "not a number"),
    ("1 Hz", "rad/s", "wrong unit"), ("60 rpm", "1/s", "wrong unit"), ("22 deg", "", "wrong unit"),
    ("1 rad", "", "wrong unit"), ("1 1/s", "rad/s", "wrong unit"), ("0.4 bit", "", "unknown unit"),
    ("2 bananas", "kg", "unknown unit"), ("5 N/m s", "N/(m s)", "two ways"), ("1.2", "kg", "no unit"),
    ("5 N/", "N", "missing"), ("m", "m", "not a number"), ("", "m", "not a number"), ("0x10 m", "m", "no unit"),
    ("１ m", "m", "not a number"), ("1 m\x00", "m", "no unit"), ("1 m^9.5.1", "m", "no unit"),
    ("1" * 65 + " m", "m", "not a number"), ("__import__('os')", "", "not a number"), ("2 m**2", "m", "written with ^"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "unit", "word"), REFUSED)
def test_what_is_refused(text: str, unit: str, word: str) -> None:
    """Nothing is guessed, taken apart or computed; the field's unit and the text are named."""
    with pytest.raises(PydanticCustomError) as caught:
        si_number(text, unit)
    said = caught.value.message()
    assert word in said
    assert said.endswith(f"; expected {unit or 'a plain number'}")


@pytest.mark.parametrize(
    ("text", "unit", "meant"),
    [
        ("2 mps", "m/s", "m/s"), ("5 kmh", "m/s", "km/h"), ("3 Nm", "N m", "N m"),
        ("3 N/mmm", "N/m", "N/mm"), ("4 degs", "rad", "deg"), ("4 milimeters", "m", "meters"),
    ],
)  # fmt: skip
def test_a_misspelt_unit_is_told_one_of_the_right_dimension(
    text: str, unit: str, meant: str
) -> None:
    """``mps`` is more like ``ms`` than ``m/s``, but no speed is in milliseconds."""
    with pytest.raises(UnitError, match=rf"unknown unit '.*'; did you mean {meant}\?$"):
        read_number(text, unit)


def test_nothing_is_evaluated() -> None:
    """Expressions that would take for ever are refused at once."""
    begun = time.perf_counter()
    for text in ("9**9**9", "9^9^9 m", "m^9999999", "1e999999 m", "(" * 60, "1 " + "m/" * 30 + "m"):
        with pytest.raises(UnitError):
            read_number(text, "rad")
    assert time.perf_counter() - begun < 0.5


decimals = st.decimals(-1000000, 1000000, places=4)


@given(decimals, st.sampled_from(["mm", "cm", "m", "km", "in", "ft"]))
def test_text_is_its_own_decimal(number: object, unit: str) -> None:
    """``"9.3 mm"`` is the float nearest to 0.0093, as if it had been written so."""
    assert read_number(f"{number} {unit}", "m") == float(Fraction(str(number)) * SYMBOLS[unit].size)
    assert read_number(f"{number}", "m", bare=True) == float(str(number))


@given(decimals)
def test_degrees_are_those_of_the_standard_library(number: object) -> None:
    """The same bits as `math.radians`, so that Python and files agree."""
    assert read_number(f"{number} deg", "rad") == math.radians(float(str(number)))


@given(st.sampled_from(sorted(SYMBOLS)), st.sampled_from(sorted(SYMBOLS)), st.integers(1, 4))
def test_units_multiply_and_divide(one: str, other: str, power: int) -> None:
    """A product, a quotient and a power have the sizes and dimensions that they must have."""
    a, b = unit_of(one), unit_of(other)
    product, quotient = unit_of(f"{one} {other}"), unit_of(f"{one}/{other}")
    assert product.size == a.size * b.size
    assert quotient.size == a.size / b.size
    assert product.dimension == tuple(x + y for x, y in zip(a.dimension, b.dimension, strict=True))
    assert quotient.degrees == a.degrees - b.degrees
    assert unit_of(f"{one}^{power}").size == a.size**power
    assert unit_of(f"1/{one}").dimension == tuple(-x for x in a.dimension)


@given(st.text(max_size=80), st.sampled_from(["", "m", "rad", "kg m^2"]))
def test_any_text_is_a_number_or_refused(text: str, unit: str) -> None:
    """No other exception, whatever is written."""
    with contextlib.suppress(PydanticCustomError):
        assert isinstance(number_in(text, unit), float)


def test_numbers_of_any_size_are_told_to_be_finite() -> None:
    """Whole numbers that no float holds, of which the digits are not written out."""
    for value in (10**400, -(10**400), 10**5000, math.inf, "1e400 m"):
        with pytest.raises(PydanticCustomError, match="must be finite") as caught:
            si_number(value, "m")
        assert len(caught.value.message()) < 150


@pytest.mark.parametrize("value", [15, 45.0, -6.3, "400 deg"])
def test_angles_keep_within_a_turn(value: float | str) -> None:
    """A plain 45 is radians, hardly what is meant; the message says how degrees are written."""
    with pytest.raises(PydanticCustomError, match="within a full turn") as caught:
        si_number(value, "rad")
    if not isinstance(value, str):
        assert f'write "{value:g} deg"' in caught.value.message()
    assert si_number("360 deg", "rad") == math.tau
    assert si_number(-math.tau, "rad") == -math.tau
