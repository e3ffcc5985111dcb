"""An exponent that the law of a surface does not read is warned of."""

from __future__ import annotations

from typing import Any

import pytest

from builders.cases import nonempty
from springback.contact.library import SURFACES
from springback.scenario.scenario import scenario_from
from springback.scenario.warnings import scenario_warnings
from springback.studies.scenario_check import check_warnings

FOAM = {
    "law": "foam", "stiffness": 2e4, "plateau_force": "30 N", "densification_depth": "15 mm",
    "restitution": 0.3,
}  # fmt: skip
TABLE = {"law": "table", "loading": [[0, 0], [0.01, 50]], "restitution": 0.5}
LINEAR = {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 20.0}
IMPULSE = {"law": "impulse", "restitution": 0.5}
HERTZ = {"law": "hertz", "stiffness": 2e4}
CONSTANT = {"law": "constant-restitution", "stiffness": 2e4, "restitution": 0.5}


def tables(surface: Any, **vehicle: Any) -> dict[str, Any]:
    ground = {"type": "ground", "surface": "wall"}
    wall = {"type": "wall", "distance": "3 m", "surface": surface}
    return {
        "vehicle": {"preset": "arq", **vehicle}, "start": {"position": [0, 0, 1]},
        "world": {"obstacles": [ground, wall]},
    }  # fmt: skip


def told(given: dict[str, Any]) -> list[str]:
    return [line for line in scenario_warnings(scenario_from(given)) if "exponent" in line]


@pytest.mark.parametrize("law", [LINEAR, FOAM, TABLE, IMPULSE])
def test_an_exponent_that_is_not_read_is_told(law: dict[str, Any]) -> None:
    given = tables(law | {"exponent": 1.2})
    [said] = told(given)
    assert said.startswith(
        f"world.obstacles[1].surface.exponent is not used: law {law['law']} has none, and 1.2 "
    )
    assert said in check_warnings(scenario_from(given))
    # As it is saved, with every key, and without one, or that of a linear spring.
    assert told(scenario_from(given).model_dump()) == [said]
    for more in ({}, {"exponent": 1}):
        assert told(tables(law | more)) == []
        assert told(scenario_from(tables(law | more)).model_dump()) == []


@pytest.mark.parametrize("law", [HERTZ, CONSTANT])
def test_one_that_is_read_is_not_told(law: dict[str, Any]) -> None:
    assert told(tables(law | {"exponent": 1.2})) == []


def test_presets_are_not_told_with_another_law() -> None:
    for name in nonempty(SURFACES):
        assert told(tables(name)) == [], name
        assert told(tables({"preset": name, "law": "kelvin-voigt"})) == [], name


def test_hulls_backings_and_second_vehicles_count() -> None:
    hull = {"type": "sphere", "radius": 0.05}
    soft = {"hulls": [hull, hull | {"surface": FOAM | {"exponent": 1.2}}]}
    [said] = told(tables("wall", **soft))
    assert said.startswith("vehicle.hulls[1].surface.exponent is not used: law foam has none")
    assert "(power does)" in said
    assert told(tables("wall", hulls=[hull | {"surface": FOAM}])) == []
    mat = {"type": "mat", "distance": "3 m", "thickness": 0.1, "surface": "mat",
           "backing": LINEAR | {"exponent": 2}}  # fmt: skip
    given = tables("wall")
    given["world"]["obstacles"][1] = mat
    [said] = told(given)
    assert said.startswith("world.obstacles[1].backing.exponent is not used")
    there = {"vehicle": "arq", "start": {"position": [0, 3, 1]}}
    given = tables("wall") | {"second": there | {"surface": LINEAR | {"exponent": 2}}}
    [said] = told(given)
    assert said.startswith("second.surface.exponent is not used")
