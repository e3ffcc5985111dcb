"""Flights made ready together are, number by number, those made ready alone."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from springback.batch import templates
from springback.batch.templates import BuiltGroup, ScenarioGroup, Template, build_group, pace_of
from springback.batch.validation import flight_from_tables, settings_of
from springback.control.parameters import ControlSettings
from springback.errors import InputError
from springback.kernels.memo import Memo
from springback.kernels.trees import leaves
from springback.scenario.avionics import turn_on_normals
from springback.scenario.build import ReadyFlight
from springback.scenario.tables import Start, WorldSettings
from springback.studies.trials import Scatter, trial_tables

COUNT = 12
WALL = {"type": "wall", "distance": 2.75, "surface": "wall"}


def scattered(robot: str, changes: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Trials with scattered starts and noise."""
    scatter, tables = Scatter(), []
    for k in range(COUNT):
        tables.append(trial_tables(robot, 0.0, 2.0, scatter.draw(robot, 0.0, 2.0, k, 0), changes))
    shared = {name: tables[0][name] for name in ("vehicle", "reference", "recovery", "simulation")}
    return [table | shared for table in tables]


def thrown() -> list[dict[str, Any]]:
    """Without a pilot, at walls of many distances, arms of many kinds."""
    return [
        {
            "vehicle": {"preset": "arq", "arms": {"damping": 1.0 + 0.1 * k, "stroke": 0.03}},
            "thrust": "hover",
            "start": {"position": [0.0, 0.1 * k, 1.0], "velocity": [2.0, 0.0, 0.0]},
            "world": {
                "gravity": 9.81 - 0.1 * k,
                "obstacles": [{**WALL, "distance": 1.0 + 0.1 * k}],
            },
            "payload": {"mass": 0.01 * (k + 1)},
            "seed": k,
        }
        for k in range(COUNT)
    ]


def holding(**more: Any) -> list[dict[str, Any]]:
    """With a pilot that holds a place; some tables by number."""
    base = {"vehicle": "arq", "reference": {"type": "hold"}, "simulation": {"duration": 1.0}}
    return [
        base | {name: made(k) for name, made in more.items()} | {"seed": k} for k in range(COUNT)
    ]


PLANS = {
    "scattered ARQ": scattered("arq", {}),
    "scattered Quad, complementary": scattered("quad", {"estimator": {"type": "complementary"}}),
    "perfect state": scattered("arq", {"estimator": {"type": "perfect"}}),
    "Lee's law": scattered("arq", {"control": {"attitude": "lee", "rate_integral": 1.0}}),
    "thrown": thrown(),
    "noise": holding(sensors=lambda k: {"motion_capture": {"position_noise": 1e-4 * (k + 1)}}),
    "signs of zero": holding(start=lambda k: {"velocity": [0.0 if k % 2 else -0.0, 0.0, 0.0]}),
    "mats": holding(
        world=lambda k: {
            "obstacles": [{"type": "mat", "normal": [-1.0, 0.01 * k, 0.0], "surface": "mat",
                           "position": [2.0 + k, 0, 0], "backing": "wall"}]
        }
    ),
}  # fmt: skip


def together(
    tables: list[dict[str, Any]], build: Memo
) -> tuple[list[ScenarioGroup], list[BuiltGroup | None]]:
    """Groups of flights that are alike, and what is made of each."""
    groups: list[ScenarioGroup] = []
    for number, table in enumerate(tables):
        settings = settings_of(table, build)
        del settings["seed"]
        if not any(group.takes(number, settings) for group in groups):
            groups.append(ScenarioGroup(number, settings, build))
    biases = turn_on_normals([table["seed"] for table in tables])

    def one(number: int) -> ReadyFlight:
        return flight_from_tables(tables[number], build, biases[number])

    return groups, [build_group(g, [biases[k] for k in g.flights], one) for g in groups]


def numbers(many: BuiltGroup, row: int) -> np.ndarray[Any, Any]:
    """All numbers of one of many flights."""
    built_avionics = many.first.built_avionics
    flown = leaves((many.first.model, many.first.start))
    onboard = leaves(built_avionics.avionics) if built_avionics else []
    for tree, (places, values) in ((flown, many.flown), (onboard, many.onboard)):
        for place, value in zip(places, values[row].tolist(), strict=True):
            tree[place] = value
    return np.array([*flown, *onboard])


def numbers_alone(table: dict[str, Any]) -> np.ndarray[Any, Any]:
    ready = flight_from_tables(table, Memo())
    avionics = leaves(ready.built_avionics.avionics) if ready.built_avionics else []
    return np.array([*leaves((ready.model, ready.start)), *avionics])


@pytest.mark.parametrize("plan", PLANS)
def test_many_are_as_alone(plan: str) -> None:
    tables = PLANS[plan]
    (group,), (many,) = together(tables, Memo())
    assert many is not None
    assert many.flights == group.flights == [*range(COUNT)]
    for row, table in enumerate(tables):
        assert numbers(many, row).tobytes() == numbers_alone(table).tobytes()
        assert pace_of(many.first) == pace_of(flight_from_tables(table, Memo()))


def test_flights_that_go_another_way_are_left_out() -> None:
    """One starts inside the wall; of another nothing is left beside the arms."""
    tables = scattered("arq", {})
    tables[3] |= {"start": {**tables[3]["start"], "position": [2.7, 0.0, 1.0]}}
    tables[5] |= {"model_error": {"mass": 0.1, "inertia": 1.0}}
    (_,), (many,) = together(tables, Memo())
    assert many is not None
    assert many.flights == [k for k in range(COUNT) if k not in (3, 5)]
    for row, k in enumerate(many.flights):
        assert numbers(many, row).tobytes() == numbers_alone(tables[k]).tobytes()
    with pytest.raises(InputError, match="inside"):
        numbers_alone(tables[3])
    with pytest.raises(InputError, match=r"model_error\.mass"):
        numbers_alone(tables[5])


def test_what_no_formula_does_is_made_alone() -> None:
    """Run-ups are sought, drag asks for roots, gusts are drawn, ticks are counted."""
    varied = {
        "run-ups": holding(reference=lambda k: {"type": "run-up", "speed": 2.0 + 0.01 * k}),
        "drag": holding(air=lambda k: {"body_drag": 0.01 + 0.001 * k}),
        "gusts": holding(
            air=lambda k: {"body_drag": 0.01, "gusts": {"wind_at_6_m": 5.0, "airspeed": 3.0}},
            start=lambda k: {"yaw": 0.01 * k},
        ),
        "clock": holding(clock=lambda k: [1000.0, 2000.0][k % 2]),
        "duration": holding(simulation=lambda k: {"duration": 1.0 + 0.1 * k}),
        "a sick first": holding(model_error=lambda k: {"mass": 0.1 + 0.1 * k}),
    }
    for tables in varied.values():
        _, made = together(tables, Memo())
        assert made == [None] * len(made)


def test_few_are_made_alone() -> None:
    tables = scattered("arq", {})
    assert together(tables[: templates.FEW], Memo())[1] != [None]
    assert together(tables[: templates.FEW - 1], Memo())[1] == [None]


def test_a_function_that_takes_a_cell_for_a_float_is_found_out(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever is not as the flight made ready alone is not trusted."""
    ready_of = templates.ready_of

    def careless(*given: Any) -> ReadyFlight:
        ready = ready_of(*given)
        start = ready.start
        height = getattr(start.position.z, "value", start.position.z)
        return ready._replace(start=start._replace(position=start.position._replace(z=height)))

    assert together(PLANS["scattered ARQ"], Memo())[1] != [None]
    monkeypatch.setattr(templates, "ready_of", careless)
    assert together(PLANS["scattered ARQ"], Memo())[1] == [None]


# -- templates ------------------------------------------------------------------------------------


def test_a_template_takes_numbers_and_gives_them_back() -> None:
    first = Start(position=(0.0, 1.0, 2.0), yaw=0.1)
    other = Start(position=(3.0, 4.0, 5.0), yaw=-0.0)
    template = Template(first)
    found = template.numbers(other)
    assert found is not None
    assert template.numbers(first) == template.own
    assert template.with_numbers(iter(found)) == other
    assert math.copysign(1.0, template.with_numbers(iter(found)).yaw) == -1.0
    assert template.with_numbers(iter(found)).model_fields_set == other.model_fields_set


def test_settings_that_differ_in_more_than_numbers_are_not_alike() -> None:
    given = ControlSettings(stiffness=9.0)
    template = Template(given)
    assert template.numbers(ControlSettings(stiffness=8.0)) is not None
    for other in (
        ControlSettings(stiffness=9.0, attitude="lee"),
        ControlSettings(stiffness=9.0, damping=3.0),  # none is not a number
        ControlSettings(stiffness=9.0, rate_gain=given.rate_gain),  # given, which may matter
        Start(),
        None,
    ):
        assert template.numbers(other) is None


def test_worlds_are_alike_obstacle_by_obstacle() -> None:
    def world(*distances: float) -> WorldSettings:
        walls = [{**WALL, "distance": d, "surface": {"law": "hertz"}} for d in distances]
        return WorldSettings.model_validate({"obstacles": walls})

    template = Template(world(1.0, 2.0))
    assert template.numbers(world(3.0, 4.0)) is not None
    assert template.with_numbers(iter(template.numbers(world(3.0, 4.0)) or [])) == world(3.0, 4.0)
    assert template.numbers(world(1.0)) is None
    assert template.numbers(world(1.0, 2.0, 3.0)) is None
    assert Template((1, "a", (True, None))).numbers((1, "a", (True, None))) == []
    assert Template((1, "a", (True, None))).numbers((1, "a", (False, None))) is None
    assert Template([1.0]).numbers([1.0]) is None
