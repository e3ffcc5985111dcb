"""Table III within its rounding: what passes, and that nothing of ARQ's does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from springback.contact.laws.restitution import restitution
from springback.paper.printed import SLIDER_SPEED
from springback.paper.printed_intervals import (
    ROUNDED,
    SURFACES,
    PrintedInterval,
    compared_column,
    conditions,
    dissipation_interval,
    nearest,
    printed_column,
    slider_numbers,
)
from springback.paper.slider import COUNTED, QUAD, READINGS

PAGE = Path(__file__).parents[2] / "docs" / "paper" / "table_iii.md"
NAMED = {reading.name: reading for reading in READINGS}


def page_rows(surface: str) -> dict[str, list[str]]:
    """Cells of the page's rows of ARQ's column of a surface, by reading."""
    text = PAGE.read_text(encoding="utf-8")
    part = text.split(f"| **ARQ, {surface}, printed** |")[1].split("**")[0]
    rows = [line.split(" | ") for line in re.findall(r"^\| (.*) \|$", part, re.M)]
    return {cells[0]: cells[1:] for cells in rows}


def test_quads_restitution_within_its_rounding_gives_c_a_within_half_a_percent() -> None:
    """0.432 s/m, as is used everywhere, is inside; the ends give the rounded numbers back."""
    wall, mat = (dissipation_interval(surface) for surface in SURFACES)
    assert wall.low < 0.432 < wall.high
    assert mat.low < 0.354 < mat.high
    assert wall == pytest.approx((0.4302, 0.4342), abs=5e-5)
    assert (wall.high - wall.low) / 0.432 == pytest.approx(0.0093, abs=1e-4)
    for speed, c_a in conditions("wall"):
        assert abs(speed - SLIDER_SPEED) == pytest.approx(0.005)
        assert abs(restitution(c_a, speed) - 0.547) == pytest.approx(5e-4, abs=1e-9)
    text = PAGE.read_text(encoding="utf-8")
    for surface in (wall, mat):
        assert f"from {surface.low:.4f} to {surface.high:.4f}" in text


def test_quad_on_the_wall_passes_within_rounding_alone() -> None:
    column = compared_column(QUAD, "wall")
    assert [one.quantity for one in column] == list(COUNTED)
    assert all(one.passes for one in column)
    peak = next(one for one in compared_column(QUAD, "mat") if "peak" in one.quantity)
    assert not peak.passes
    assert peak.predicted.low > 1.07 * peak.printed.high


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("name", ["A", "B", "C"])
def test_no_reading_of_arq_meets_any_number_within_rounding(name: str, surface: str) -> None:
    column = compared_column(NAMED[name], surface)
    assert not any(one.passes for one in column)
    [_, peak, travel, _, passed, _] = page_rows(surface)[name]
    assert passed == "0 of 4"
    assert peak == f"{column[1].predicted.low:.1f} to {column[1].predicted.high:.1f} ✗"
    ends = (1e3 * end for end in column[2].predicted)
    assert travel == "{:.2f} to {:.2f} ✗".format(*ends)


def test_no_c_a_and_no_speed_near_print_brings_reading_b_to_it() -> None:
    """The search is no worse than the printed conditions, and reports what it flies."""
    near = nearest(NAMED["B"], "wall")
    wanted = printed_column("arq", "wall")[near.worst]
    told = slider_numbers(NAMED["B"], "wall", near.speed, near.dissipation)
    number = float(told[COUNTED.index(near.worst)])
    assert number / (0.5 * sum(wanted)) - 1.0 == pytest.approx(near.deviation, abs=1e-6)
    assert 0.3 < abs(near.deviation) < 0.44  # 44 % of the time at the printed conditions
    assert page_rows("wall")["B"][5].endswith(f"{100.0 * near.deviation:+.0f} %")


def test_an_interval_is_what_rounding_leaves_and_meets_at_its_ends() -> None:
    narrow = PrintedInterval(1.0, 2.0)
    assert narrow.meets(PrintedInterval(2.0, 3.0))
    assert not narrow.meets(PrintedInterval(2.1, 3.0))
    for quantity, one in printed_column("quad", "wall").items():
        assert one.high - one.low == pytest.approx(2.0 * ROUNDED[quantity])
