"""The registry of fields: unit, range, default and place of every number a user can give."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest

from builders.cases import nonempty
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


#: Keys of numbers without a bound of their own, and why they need none.
UNBOUNDED = {
    "inertia": "of a main body: by its mass and reach", "directions": "angles, within a full turn",
    "seed": "any is as good", "thrust": "by max_thrust, or that of a newton", "time": "of a table",
    "values": "by max_thrust", "parameters": "of code of the user's own",
    "elements": "as obstacles, when they are placed", "spin": "a sign",
    "on": "an arm that there is",
}  # fmt: skip


def test_every_number_of_a_scenario_has_an_upper_bound() -> None:
    fields = list(every_field(Scenario, set()))
    bare = set()
    for field in nonempty(fields):
        unit = field.unit
        declared = unit is not None and unit.most is not None
        counted = any(hasattr(note, "le") for _, notes in field.entries for note in notes)
        kinds = {kind for kind, _ in field.entries} | {type(field.default)}
        holds_numbers = unit is not None or bool(kinds & {int, float}) or "float" in str(kinds)
        if holds_numbers and not (declared or counted or field.largest is not None):
            bare.add(field.key)
    assert bare <= set(UNBOUNDED)
    assert len([field for field in fields if field.largest is not None]) > 150


WALL = {"type": "wall", "distance": 2.0, "surface": {"preset": "wall"}}
ABSURD: dict[str, tuple[dict[str, Any], str]] = {
    "place": ({"start": {"position": [1e12, 0, 0]}},
              r"start\.position\[0\]: must be from -1e\+06 m to 1e\+06 m \(got 1e\+12 m\)"),
    "speed": ({"start": {"velocity": [0, -1e9, 0]}},
              r"start\.velocity\[1\]: must be from -10000 m/s to 10000 m/s \(got -1e\+09 m/s\)"),
    "stiffness": ({"world": {"obstacles": [{**WALL, "surface": {"preset": "wall", "stiffness": 1e30}}]}},
                  r"obstacles\[0\]\.surface\.stiffness: must be at most 1e\+12 N/m\^1\.5 \(got 1e\+30 N"),
    "friction": ({"world": {"obstacles": [{**WALL, "surface": {"preset": "wall", "friction": 1e20}}]}},
                 r"obstacles\[0\]\.surface\.friction: must be at most 100 \(got 1e\+20\)"),
    "arm": ({"vehicle": {"preset": "arq", "arms": {"stiffness": [6e3, 6e3, 1e13, 6e3]}}},
            r"vehicle\.arms\.stiffness\[2\]: must be at most 1e\+12 N/m \(got 1e\+13 N/m\)"),
    "second": ({"second": {"vehicle": "quad", "start": {"position": [5e6, 0, 1]}}},
               r"second\.start\.position\[0\]: must be from -1e\+06 m to 1e\+06 m"),
}  # fmt: skip


@pytest.mark.parametrize("case", ABSURD)
def test_numbers_with_which_flights_would_diverge_are_refused_by_name(case: str) -> None:
    more, words = ABSURD[case]
    with pytest.raises(InputError, match=words):
        scenario_from({"vehicle": "arq", **more})


def test_numbers_at_the_bounds_are_read() -> None:
    hard = {"preset": "wall", "stiffness": 1e12, "friction": 100.0}
    world = {"obstacles": [{**WALL, "distance": 1e6, "surface": hard}]}
    given = {"vehicle": "arq", "world": world, "start": {"velocity": [1e4, 0, 0]}}
    assert scenario_from(given).start.velocity == (1e4, 0.0, 0.0)


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
