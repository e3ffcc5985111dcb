"""Other arms and laws on the slider: tries fly what they say, and the page has what they give."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from slider_laws import SURFACES, TRIES, SliderTry, deviations, fit, gap, tables_of

from builders.cases import nonempty
from springback.paper.slider import READINGS, fitted_dissipation, slider_tables
from springback.results.flight import as_scenario, fly

PAGE = Path(__file__).parents[2] / "docs/paper/slider_laws.md"
FLOWN = ("as read", "one-sided springs", "latch", "latch, damper", "latch, spring, damper")


def found(base: str, name: str) -> SliderTry:
    [tried] = [one for one in TRIES if (one.base, one.name) == (base, name)]
    return tried


def lines() -> dict[tuple[str, str], list[str]]:
    """Cells of the page's table, by reading and try."""
    rows = [line.strip("| ").split(" | ") for line in PAGE.read_text().splitlines()
            if re.match(r"\| (?:B|D|D, letter): ", line)]  # fmt: skip
    return {tuple(row[0].split(": ")): row[1:] for row in rows}  # type: ignore[misc]


@pytest.mark.parametrize("base", ["B", "D", "D, letter"])
def test_slides_along_the_arms_are_the_readings(base: str) -> None:
    """Joints with rings fly as arms of the plane with the paper's contact point."""
    [reading] = [one for one in READINGS if one.name == base]
    ours = deviations(found(base, "as read"), "wall", ())
    tables = slider_tables(reading, "wall", 1.85, fitted_dissipation("wall"))
    m = fly(tables, *reading.overrides, trajectory=False).measures
    theirs = (
        (m["restitution_at_separation"] or 0.0) / 0.444, (m["impact_peak_acceleration"] or 0.0) / 144,
        (m["travel"] or 0.0) / 0.029, (m["time_to_return"] or 0.0) / 0.079,
    )  # fmt: skip
    assert [1.0 + one for one in ours] == pytest.approx(theirs, rel=1e-5)


def test_the_page_has_all_tries() -> None:
    assert list(lines()) == [(one.base, one.name) for one in TRIES]


def test_the_page_has_what_is_flown() -> None:
    """With the fitted numbers as the page has them, to three digits: within 2 % of print."""
    tries = [one for one in TRIES if one.name in FLOWN]
    for tried in nonempty(tries):
        cells = lines()[tried.base, tried.name]
        numbers = re.findall(r"(?:^|, )\S+ ([\d.e+-]+)", cells[0]) if tried.fitted else []
        values = tuple(
            float(word) / one.scale for word, one in zip(numbers, tried.fitted, strict=True)
        )
        if min(values, default=1.0) <= 0.0:
            continue  # the search has taken its law away
        off = [one for surface in SURFACES for one in deviations(tried, surface, values)]
        printed = [float(cell.split(" %")[0]) / 100.0 for cell in cells[1:9]]
        assert off == pytest.approx(printed, abs=0.02), tried.name
        assert [cell.endswith("*f*") for cell in cells[1:5]] == [bool(tried.fitted)] * 4
        assert not any(cell.endswith("*f*") for cell in cells[5:9])
        assert gap(tried, values) == pytest.approx(float(cells[11]), abs=15.0)


def test_a_fit_lessens_the_deviation() -> None:
    """Of one number, from its start."""
    tried = found("D", "right arms of another spring")

    def size(values: tuple[float, ...]) -> float:
        return sum(one * one for one in deviations(tried, "wall", values))

    assert size(fit(tried)) < size((tried.fitted[0].start,))


def test_laws_of_surfaces_are_those_of_the_surface_that_is_hit() -> None:
    """Foam is a mat's; constant restitution is Quad's on each; bristles keep c_a."""
    for surface in nonempty(SURFACES):
        hit = [
            as_scenario(tables_of(tried, surface, tuple(n.start for n in tried.fitted)))
            .world.obstacles[0].surface  # type: ignore[union-attr]
            for tried in (found("B", "mat of foam"), found("B", "constant restitution"),
                          found("B", "bristles along the wall"))
        ]  # fmt: skip
        assert hit[0].law == ("foam" if surface == "mat" else "hunt-crossley")
        assert (hit[1].law, hit[1].restitution) == (
            "constant-restitution", {"wall": 0.547, "mat": 0.598}[surface],
        )  # fmt: skip
        assert hit[2].dissipation == pytest.approx(fitted_dissipation(surface))
        assert (hit[2].friction_law, hit[2].friction_axes) == ("bristle", "both")
