"""The small model of the slider: the whole program's numbers, and what other arm laws would do."""

from __future__ import annotations

import pytest
from arm_laws import BASES, VARIANTS, bounce

from springback.paper.slider import READINGS, fitted_dissipation, slider_tables
from springback.results.flight import fly


@pytest.mark.parametrize("base", list(BASES))
@pytest.mark.parametrize("surface", ["wall", "mat"])
def test_without_an_additional_law_it_is_the_whole_program(base: str, surface: str) -> None:
    """Two formulations: five bodies in 3-D with events, three unknowns with fixed steps."""
    (reading,) = [one for one in READINGS if one.name == base]
    c_a = fitted_dissipation(surface)
    small = bounce(surface, BASES[base], c_a)
    whole = fly(slider_tables(reading, surface, 1.85, c_a), *reading.overrides, trajectory=False)
    m = whole.measures
    assert small.restitution == pytest.approx(m["restitution_at_separation"], rel=2e-4)
    assert small.peak == pytest.approx(m["impact_peak_acceleration"], rel=2e-4)
    assert small.travel == pytest.approx(m["travel"], rel=2e-4)
    assert small.back == pytest.approx(m["time_to_return"], rel=5e-4)


def test_a_law_of_no_strength_changes_nothing() -> None:
    base = BASES["D"]
    plain = bounce("wall", base, 0.432)
    assert bounce("wall", base._replace(rebound=1.0), 0.432) == plain
    slight = bounce("wall", base._replace(preload=1e-6), 0.432)
    assert slight.peak == pytest.approx(plain.peak, rel=5e-3)


def test_what_each_law_does() -> None:
    """A preload stiffens, play lets the body go farther, a softer way out gives more back."""
    base = BASES["D"]
    plain = bounce("wall", base, 0.432)
    loaded = bounce("wall", base._replace(preload=20.0), 0.432)
    assert loaded.travel < plain.travel
    assert loaded.peak > plain.peak
    free = bounce("wall", base._replace(play=0.005), 0.432)
    assert free.travel > plain.travel
    lively = bounce("wall", base._replace(rebound=0.3), 0.432)
    assert lively.restitution > plain.restitution
    assert lively.travel == pytest.approx(plain.travel, rel=2e-3)


def test_every_variant_has_one_number() -> None:
    assert len({variant.name for variant in VARIANTS}) == len(VARIANTS)
    for variant in VARIANTS:
        assert variant.field in BASES["D"]._fields
        assert variant.bounds[0] < variant.bounds[1]
