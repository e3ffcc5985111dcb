"""The registry of fields: unit, range, default and place of every number a user can give."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

from springback.errors import InputError
from springback.interfaces.lab.settings import LabSettings
from springback.quantities import PerArm, Triple, Unit
from springback.scenario.fields import TableField, degrees, fields_of, number_at
from springback.scenario.scenario import Scenario, scenario_from
from springback.settings import Settings
from springback.vehicle.parameters import Arms


def every_field(table: type[Settings], seen: set[type]) -> Iterator[TableField]:
    for field in fields_of(table).values():
        yield field
        for inner in field.tables:
            if inner not in seen:
                seen.add(inner)
                yield from every_field(inner, seen)


def test_every_number_of_a_scenario_has_a_unit() -> None:
    numbers = [f for f in every_field(Scenario, set()) if any(t is float for t, _ in f.entries)]
    assert len(numbers) > 120
    assert [field.key for field in numbers if field.unit is None] == []


def test_unit_range_shape_and_default_are_those_of_the_declaration() -> None:
    arms = fields_of(Arms)
    assert arms["stiffness"].unit == Unit("N/m", above=0.0)
    assert (arms["stiffness"].shape, arms["stiffness"].default) == (PerArm, 5e3)
    assert arms["length"].required
    [start] = fields_of(Scenario)["start"].tables
    assert (fields_of(start)["velocity"].shape, fields_of(start)["roll"].shape) == (Triple, float)
    speed = fields_of(LabSettings)["speed"].unit
    assert speed is not None
    assert (speed.unit, speed.least, speed.most) == ("m/s", 0.5, 6.0)


def test_numbers_are_found_where_they_are_and_where_they_would_be() -> None:
    scenario = scenario_from({"vehicle": "arq", "start": {"velocity": [1.0, 2.0, 3.0]}})
    found = number_at("v", ("start", "velocity", 1), scenario, ())
    assert found is not None
    assert (found.unit, found.others) == ("m/s", (1.0, 2.0, 3.0))
    pace = number_at("pace", ("recovery", "response", "pace"), scenario, ())  # there is no recovery
    assert pace is not None
    assert (pace.unit, pace.whole, pace.read("0.2 s^2/m")) == ("s^2/m", False, 0.2)
    yaw = number_at("yaw", ("start", "yaw"), scenario, ())
    assert yaw is not None
    assert (yaw.read("90deg"), degrees(yaw.read("-60deg"))) == (math.pi / 2.0, -60.0)
    runs = number_at("runs", ("recovery", "runs"), scenario, ())
    assert runs is not None
    assert runs.whole
    assert number_at("v", ("start", "velocity"), scenario, ()) is None
    assert number_at("type", ("estimator", "type"), scenario, ()) is None


@pytest.mark.parametrize(
    ("law", "unit"),
    [
        ({"law": "kelvin-voigt", "stiffness": 5e3, "viscosity": 1.0}, "N/m"),
        ({"law": "hertz", "exponent": 1.0}, "N/m"), ({"law": "hertz"}, "N/m^1.5"),
        ({"law": "hertz", "exponent": 2}, "N/m^2"), ("wall", "N/m^1.5"),
    ],
)  # fmt: skip
def test_a_stiffness_has_the_unit_of_its_law(law: object, unit: str) -> None:
    wall = {"type": "wall", "distance": 1.0, "surface": law}
    scenario = scenario_from({
        "vehicle": "arq", "start": {"position": [0, 0, 1]}, "world": {"obstacles": [wall]},
    })  # fmt: skip
    path = ("world", "obstacles", 0, "surface", "stiffness")
    found = number_at("k", path, scenario, ())
    assert found is not None
    assert (found.unit, found.by_law) == (unit, True)
    assert found.read(f"3 k{unit}") == found.read("3000") == 3000.0
    friction = number_at("mu", (*path[:-1], "friction"), scenario, ())
    assert friction is not None
    assert (friction.unit, friction.by_law) == ("", False)


@pytest.mark.parametrize(
    ("path", "said"),
    [
        (("start", "yow"), "did you mean yaw?"),
        (("spede",), "did you mean speed?"),
        (("start", "yaw", "rate"), "is not inside a table"),
        (("start", "velocity", 3), r"the scenario has no start.velocity\[3\]"),
        (("world", "obstacles", 0, "distance"), r"the scenario has no world.obstacles\[0\]"),
    ],
)
def test_what_is_not_there_is_said(path: tuple[str | int, ...], said: str) -> None:
    with pytest.raises(InputError, match=said.replace("?", r"\?")):
        number_at("x", path, scenario_from({"vehicle": "arq"}), ("speed",))
