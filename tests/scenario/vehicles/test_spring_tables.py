"""Tables of springs that end before the travel does are told, with what follows."""

from __future__ import annotations

from typing import Any

import pytest

from builders.cases import nonempty
from springback.scenario.scenario import scenario_from
from springback.scenario.vehicles.spring_tables import spring_table_warnings
from springback.scenario.warnings import scenario_warnings
from springback.vehicle.library import VEHICLES

SLIDE = {"type": "slide", "damping": 25.0, "travel": [0, "20 mm"]}
HINGE = {
    "type": "hinge", "position": [0.06, 0, 0], "axis": [0, 1, 0], "travel": ["-40 deg", "30 deg"], "damping": 0.02,
}  # fmt: skip


def vehicle(joint: dict[str, Any]) -> dict[str, Any]:
    own = {"length": "125 mm", "cage_radius": "70 mm", "joint": joint}
    return {"vehicle": {"preset": "arq", "hull": {"radius": "30 mm"}, "arms": own}}


@pytest.mark.parametrize(
    ("joint", "said"),
    [
        (
            SLIDE | {"table": [[0, 0], ["5 mm", "10 N"], ["10 mm", "20 N"]]},
            "vehicle.arms.joint.table: ends at 0.01 m, 20 N, and the travel of arm 1 at 0.02 m: beyond "
            "its last point it goes on with its last slope, to 40 N",
        ),
        (
            HINGE | {"table": [[0, 0], ["20 deg", 1.0]]},
            "vehicle.arms.joint.table: ends at 20 deg, 1 N m, and the travel of arm 1 at 40 deg: beyond "
            "its last point it goes on with its last slope, to 2 N m",
        ),
    ],
)  # fmt: skip
def test_a_table_that_ends_early_is_told(joint: dict[str, Any], said: str) -> None:
    given = scenario_from(vehicle(joint))
    assert spring_table_warnings(given.vehicle) == [said]
    assert said in scenario_warnings(given)


def test_tables_that_reach_the_stop_are_not_told() -> None:
    whole = SLIDE | {"table": [[0, 0], ["5 mm", "10 N"], ["19.9 mm", "30 N"]]}
    assert spring_table_warnings(scenario_from(vehicle(whole)).vehicle) == []
    for name, entry in nonempty(VEHICLES.items()):
        assert spring_table_warnings(entry.vehicle) == [], name
