"""Flights built together are, number by number, those built alone."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from springback.batch import templates
from springback.batch.templates import BuiltGroup, ScenarioGroup, Template, built_groups, pace_of
from springback.errors import InputError
from springback.kernels import tracing
from springback.kernels.trees import leaves
from springback.scenario.avionics import normals_at_start
from springback.scenario.build import ReadyFlight
from springback.scenario.scenario import scenario_from
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
    "at touch": [
        table | {"start": {**table["start"], "touch_distance": 1e-4 * k, "yaw": 0.1 * k}}
        for k, table in enumerate(thrown())
    ],
    "quaternions": [
        table | {"start": {"quaternion": [math.cos(0.1 * k), 0.0, math.sin(0.1 * k), 0.0]}}
        for k, table in enumerate(thrown())
    ],
    "directions and moments": [
        table | {"vehicle": {
            "preset": "arq",
            "arms": {"directions": [0.785 + 0.001 * k, 2.356, 3.927, 5.498 - 0.001 * k]},
            "body": {"inertia": [[5e-3 + 1e-4 * (k % 3), 0.0, 0.0], [0.0, 5e-3, 0.0],
                                 [0.0, 0.0, 8e-3 - 1e-4 * k]]},
        }}
        for k, table in enumerate(thrown())
    ],
    "noise": holding(sensors=lambda k: {"motion_capture": {"position_noise": 1e-4 * (k + 1)}}),
    "signs of zero": holding(start=lambda k: {"velocity": [0.0 if k % 2 else -0.0, 0.0, 0.0]}),
    "run-ups": holding(reference=lambda k: {"type": "run-up", "speed": 2.0 + 0.01 * k}),
    "pitches of stiff arms": holding(
        reference=lambda k: {"type": "run-up", "speed": 2.0, "pitch": 0.01 * k},
        vehicle=lambda k: {"preset": "arq", "arms": {"stiffness": 4e3 + 100.0 * k}},
    ),
    "references": holding(reference=lambda k: {"type": "hold", "position": [0.1 * k, 0, 1]}),
    "drag": holding(air=lambda k: {"body_drag": 0.01 + 0.001 * k, "wind": [0.1 + 0.1 * k, 0, 0.2]}),
    "gusts": holding(
        air=lambda k: {"body_drag": 0.01, "gusts": {"wind_at_6_m": 5.0, "airspeed": 3.0}}
    ),
    "gusts in wind": holding(
        air=lambda k: {"body_drag": 0.01, "wind": [0.1 + 0.1 * k, 0, 0.2],
                       "gusts": {"wind_at_6_m": 5.0 + k}}
    ),
    "restitutions": holding(
        world=lambda k: {
            "obstacles": [{"type": "wall", "distance": 2.0, "surface": {
                "restitution": 0.3 + 0.01 * k, "restitution_speed": 2.0}}]
        }
    ),
    "impulses": holding(  # in a scene: the same one for all
        start=lambda k: {"velocity": [0.01 * k, 0.0, 0.0]},
        world=lambda k: {
            "obstacles": [{"type": "wall", "distance": 2.0, "surface": {
                "law": "impulse", "restitution": 0.3}}]
        }
    ),
    "mats": holding(
        world=lambda k: {
            "obstacles": [{"type": "mat", "normal": [-1.0, 0.01 * k, 0.0], "surface": "mat",
                           "position": [2.0 + k, 0, 0], "backing": "wall"}]
        }
    ),
}  # fmt: skip


def flight_from(table: Mapping[str, Any]) -> ReadyFlight:
    """A flight built alone."""
    return scenario_from(table, False, advises=False).build(advises=False)


def together(tables: list[dict[str, Any]]) -> tuple[list[ScenarioGroup], list[BuiltGroup]]:
    """Groups of flights that differ in numbers only, and what is built of them together."""
    groups: list[ScenarioGroup] = []
    for number, table in enumerate(tables):
        if not any(group.takes(number, table) for group in groups):
            groups.append(ScenarioGroup(number, table))

    def normals(number: int) -> list[float]:
        return normals_at_start(tables[number]["seed"], "gusts" in tables[number].get("air", {}))

    def one(number: int) -> ReadyFlight:
        return flight_from(tables[number])

    return groups, [built for g in groups for built in built_groups(g, normals, one)]


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
    ready = flight_from(table)
    avionics = leaves(ready.built_avionics.avionics) if ready.built_avionics else []
    return np.array([*leaves((ready.model, ready.start)), *avionics])


@pytest.mark.parametrize("plan", PLANS)
def test_many_are_as_alone(plan: str) -> None:
    tables = PLANS[plan]
    (group,), (many,) = together(tables)
    assert many.flights == group.flights == [*range(COUNT)]
    for row, table in enumerate(tables):
        assert numbers(many, row).tobytes() == numbers_alone(table).tobytes()
        assert pace_of(many.first) == pace_of(flight_from(table))


def test_directions_and_moments_are_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Which of two moments is the larger was asked, and each row read by itself."""
    read: list[str] = []
    by_row = tracing._by_row

    def counted(function: Any, *given: Any) -> Any:
        read.append(function.__name__)
        return by_row(function, *given)

    monkeypatch.setattr(tracing, "_by_row", counted)
    together(PLANS["directions and moments"])
    assert {"cos", "sin"} <= {*read}
    assert not {"airframe", "_inertia", "check_moments"} & {*read}


def test_flights_that_go_another_way_are_left_out() -> None:
    """One starts inside the wall; of another nothing is left beside the arms."""
    tables = scattered("arq", {})
    tables[3] |= {"start": {**tables[3]["start"], "position": [2.7, 0.0, 1.0]}}
    tables[5] |= {"model_error": {"mass": 0.1, "inertia": 1.0}}
    (_,), (many,) = together(tables)
    assert many.flights == [k for k in range(COUNT) if k not in (3, 5)]
    for row, k in enumerate(many.flights):
        assert numbers(many, row).tobytes() == numbers_alone(tables[k]).tobytes()
    with pytest.raises(InputError, match="inside"):
        numbers_alone(tables[3])
    with pytest.raises(InputError, match=r"model_error\.mass"):
        numbers_alone(tables[5])


def test_flights_of_one_clock_and_duration_are_built_together() -> None:
    """Those are of a batch."""
    for tables in (
        holding(clock=lambda k: [1000.0, 2000.0][k % 2]),
        holding(simulation=lambda k: {"duration": [1.0, 2.0][k % 2]}),
    ):
        tables = [table | {"seed": k} for k, table in enumerate([*tables, *tables])]
        groups, built = together(tables)
        assert [many.flights for many in built] == [group.flights for group in groups]
        assert [len(group.flights) for group in groups] == [COUNT, COUNT]
        for many in built:
            for row, k in enumerate(many.flights):
                assert numbers(many, row).tobytes() == numbers_alone(tables[k]).tobytes()
                assert pace_of(many.first) == pace_of(flight_from(tables[k]))


def test_each_branch_is_built_together() -> None:
    """Walls in reach of the start are checked in detail; a first flight may be refused."""
    tables = holding(model_error=lambda k: {"mass": 0.1 if k < 2 else 1.0 + 0.01 * k}) + [
        table | {"start": {"position": [0.1, 0.0, 1.0 + k % 2 * 1e-3 * k], "yaw": 0.1}}
        for k, table in enumerate(holding(model_error=lambda k: {"mass": 1.0 + 0.01 * k}))
    ]
    walls = {"obstacles": [{"type": "ground", "surface": "wall"}]}
    tables = [table | {"world": walls} for table in tables]
    for k in range(COUNT):
        tables[k] = tables[k] | {"start": {"position": [0.0, 0.0, 1.0 - k % 2 * 0.8], "yaw": 0.1}}
    _, built = together([*tables, *tables])
    assert len(built) > 1
    flights = [k for many in built for k in many.flights]
    assert len(flights) == len(set(flights)) > COUNT
    for many in built:
        for row, k in enumerate(many.flights):
            assert numbers(many, row).tobytes() == numbers_alone((tables * 2)[k]).tobytes()


def test_few_are_built_alone() -> None:
    tables = scattered("arq", {})
    assert together(tables[: templates.FEW])[1] != []
    assert together(tables[: templates.FEW - 1])[1] == []


def test_a_function_that_takes_a_traced_number_for_a_float_is_found_out(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever is not as the flight built alone is not trusted."""
    build_flight = templates.build_flight

    def careless(*given: Any, **named: Any) -> ReadyFlight:
        ready = build_flight(*given, **named)
        start = ready.start
        height = getattr(start.position.z, "value", start.position.z)
        return ready._replace(start=start._replace(position=start.position._replace(z=height)))

    assert together(PLANS["scattered ARQ"])[1] != []
    monkeypatch.setattr(templates, "build_flight", careless)
    assert together(PLANS["scattered ARQ"])[1] == []


# -- templates ------------------------------------------------------------------------------------


def numbers_in(template: Template, other: Any) -> list[float] | None:
    found: list[float] = []
    return found if template.takes(other, found) else None


def test_a_template_takes_numbers_and_gives_them_back() -> None:
    first = {"position": [0.0, 1.0, (2.0, "3 m")], "yaw": 0.1, "count": 3}
    other = {"position": [3.0, 4.0, (5.0, "3 m")], "yaw": -0.0, "count": 3}
    template = Template(first)
    found = numbers_in(template, other)
    assert found == [3.0, 4.0, 5.0, 0.0]
    assert numbers_in(template, first) == template.own == [0.0, 1.0, 2.0, 0.1]
    assert template.with_numbers(iter(found)) == other
    assert math.copysign(1.0, template.with_numbers(iter(found))["yaw"]) == -1.0


def test_tables_that_differ_in_more_than_numbers_are_not_alike() -> None:
    template = Template({"stiffness": 9.0, "law": "lee", "count": 1, "list": [1.0]})
    same = {"stiffness": 8.0, "law": "lee", "count": 1, "list": [2.0]}
    assert numbers_in(template, same) is not None
    for change in (
        {"law": "full"}, {"count": 2}, {"count": True}, {"stiffness": 8}, {"stiffness": "8 N/m"},
        {"list": []}, {"list": [1.0, 2.0]}, {"list": (1.0,)}, {"damping": 3.0},
    ):  # fmt: skip
        assert numbers_in(template, same | change) is None
    assert numbers_in(template, {key: same[key] for key in ("law", "count", "list")}) is None
    assert numbers_in(template, None) is None
