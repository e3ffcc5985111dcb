"""Uncertainties in words become priors; what is none is refused in one line."""

import math
from typing import Any

import pytest

from springback.errors import InputError
from springback.identification.unknowns import field_unknown, with_values
from springback.scenario.scenario import Scenario, scenario_from

TABLES = {
    "vehicle": "arq-slider",
    "world": {"obstacles": [{"type": "wall", "distance": 2.0, "surface": "wall"}]},
    "start": {"position": [1.0, 0.0, 1.0], "velocity": [1.85, 0.0, 0.0]},
    "model": {"slider": [1.0, 0.0, 0.0], "contact_point": "paper"},
}
STIFFNESS = "world.obstacles.0.surface.stiffness"


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    return scenario_from(dict(TABLES))


def test_a_factor_holds_two_deviations(scenario: Scenario) -> None:
    one = field_unknown(STIFFNESS, "factor 5", "free", scenario)
    assert one.value(0.0) == pytest.approx(2e5)
    assert one.value(2.0) == pytest.approx(1e6)
    assert one.value(-2.0) == pytest.approx(4e4)
    assert one.coordinate(1e6) == pytest.approx(2.0)


def test_shares_and_absolute_doubts_are_one_deviation(scenario: Scenario) -> None:
    mass = field_unknown("vehicle.body.mass", "1.88 kg +- 0.5 %", "known", scenario)
    assert mass.value(1.0) == pytest.approx(1.88 * math.exp(0.005))
    plus = field_unknown("vehicle.arms.damping", "+- 5 N s/m", "free", scenario)
    assert not plus.logarithmic
    assert plus.value(-1.0) == pytest.approx(scenario.vehicle.arms.damping - 5.0)
    assert field_unknown("vehicle.body.mass", "± 10 g", "known", scenario).deviation == 0.01


def test_a_stiffness_of_a_surface_may_have_its_unit_or_none(scenario: Scenario) -> None:
    for text in ("200 kN/m^1.5 +- 3 kN/m^1.5", "2e5 +- 3e3", "2e5 +- 3 kN/m^1.5"):
        one = field_unknown(STIFFNESS, text, "known", scenario)
        assert (one.unit, one.centre, one.deviation) == ("N/m^1.5", 2e5, 3e3)


def test_values_go_where_they_belong_and_nowhere_else(scenario: Scenario) -> None:
    fields = [
        field_unknown(STIFFNESS, "factor 5", "free", scenario),
        field_unknown("vehicle.arms.stiffness", "5 N/mm factor 3", "free", scenario),
    ]
    changed = scenario_from(with_values(TABLES, fields, [2.0, 0.0]))
    assert changed.world.obstacles[0].surface.stiffness == pytest.approx(1e6)
    assert changed.vehicle.arms.stiffness == pytest.approx(5000.0)
    assert changed.vehicle.arms.damping == scenario.vehicle.arms.damping
    assert TABLES["vehicle"] == "arq-slider"


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        (STIFFNESS, "about 5", "is no uncertainty"),
        (STIFFNESS, "factor 0.5", "more than 1"),
        (STIFFNESS, "+- 0 %", "above zero"),
        ("world.obstacles.0.surface.stifness", "factor 5", "stiffness"),
        ("vehicle.arms.stiffness", "5 kg factor 3", "expected N/m"),
        (
            "world.obstacles.0.surface.dissipation",
            "factor 3",
            r"give the middle, too, as in '1 s/m factor 3'",
        ),
        ("vehicle.name", "factor 3", "no number"),
        ("start.position.1", "+- 5 %", "above zero"),
    ],
)
def test_what_is_no_uncertainty_is_refused(
    scenario: Scenario, name: str, text: str, said: str
) -> None:
    with pytest.raises(InputError, match=said) as caught:
        field_unknown(name, text, "free", scenario)
    assert len(caught.value.problems) == 1
    assert name in str(caught.value)


@pytest.mark.parametrize(
    ("law", "name"),
    [
        ("hertz", "restitution"),
        ("hertz", "dissipation"),
        ("kelvin-voigt", "exponent"),
        ("foam", "exponent"),
        ("table", "exponent"),
    ],
)
def test_a_number_that_the_law_does_not_read_is_refused(law: str, name: str) -> None:
    more: dict[str, Any] = {
        "foam": {
            "stiffness": 2e4,
            "plateau_force": 60.0,
            "densification_depth": 0.015,
            "restitution": 0.3,
        },
        "table": {"loading": [[0.0, 0.0], [0.01, 60.0]]},
    }.get(law, {})
    tables = {**TABLES, "world": {"obstacles": [
        {"type": "wall", "distance": 2.0, "surface": {"law": law, "viscosity": 10.0, **more}}
    ]}}  # fmt: skip
    elastic = scenario_from(tables)
    with pytest.raises(InputError, match=f"surface.{name}: law {law} does not use it"):
        field_unknown(f"world.obstacles.0.surface.{name}", "0.5 +- 10 %", "free", elastic)
    assert field_unknown("world.obstacles.0.surface.viscosity", "+- 10 %", "free", elastic)
