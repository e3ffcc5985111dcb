"""Scenarios that share tables: made ready fast, to the very numbers of each made ready alone."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.validation import flight_from_tables
from springback.errors import InputError
from springback.kernels.layout import structure
from springback.kernels.memo import FOREVER, Memo
from springback.kernels.trees import leaves
from springback.scenario.avionics import build_avionics
from springback.scenario.build import ReadyFlight
from springback.scenario.scenario import scenario_from
from springback.studies.trials import Scatter, trial_tables

SIX = {
    "body": {"mass": "1.2 kg", "inertia": [0.01, 0.011, 0.02]},
    "arms": {
        "directions": ["30 deg", "90 deg", "150 deg", "210 deg", "270 deg", "330 deg"],
        "length": 0.25, "mass": 0.05, "cage_radius": 0.1, "damping": 2.0, "torque_ratio": 0.016,
    },
    "propulsion": {"max_thrust": "6 N"},
}  # fmt: skip


def alone(table: dict[str, Any]) -> ReadyFlight | str:
    """A flight made ready by itself, or why it cannot be."""
    try:
        scenario = scenario_from(table, False)
    except InputError as error:
        return str(error)
    model, start = scenario.flight_model(), scenario.start_state()
    built_avionics = build_avionics(scenario, model, start) if scenario.reference else None
    return ReadyFlight(scenario.seed, model, start, built_avionics)


def shared(table: dict[str, Any], build: Memo) -> ReadyFlight | str:
    try:
        return flight_from_tables(table, build)
    except InputError as error:
        return str(error)


def assert_same(a: ReadyFlight | str, b: ReadyFlight | str) -> None:
    if isinstance(a, str) or isinstance(b, str):
        assert brief(a) == brief(b)
        return
    assert a.seed == b.seed
    assert (a.built_avionics is None) == (b.built_avionics is None)
    trees = [(a.model, b.model), (a.start, b.start)]
    if a.built_avionics and b.built_avionics:
        trees.append((a.built_avionics.avionics, b.built_avionics.avionics))
        assert a.built_avionics.noise == b.built_avionics.noise
    for one, other in trees:
        assert structure(one) == structure(other)
        # By their bits: −0 is not 0 here.
        np.testing.assert_array_equal(
            np.array(leaves(one)).view(np.int64), np.array(leaves(other)).view(np.int64)
        )


def brief(problem: Any) -> Any:
    """A problem without the distance that a run-up would need, which takes long to find out."""
    if not isinstance(problem, str):
        return problem
    return re.sub(r"needs (a distance of|more than).* the ([\d.]+ m it has)", r"needs \2", problem)


def campaign(count: int) -> list[dict[str, Any]]:
    """Tables of trials of both robots in turn that share what does not differ."""
    first = {robot: trial_tables(robot, 0.0, 2.0, _luck(robot, 0)) for robot in ("arq", "quad")}
    tables = []
    for k in range(count):
        for robot, base in first.items():
            own = trial_tables(robot, 0.0, 2.0, _luck(robot, k))
            same = {key: base[key] for key in ("vehicle", "reference", "recovery", "simulation")}
            table = own | same
            table["world"]["obstacles"][1] = base["world"]["obstacles"][1]
            tables.append(table)
    return tables


def _luck(robot: str, trial: int) -> Any:
    return Scatter().draw(robot, 0.0, 2.0, trial, 0)


def test_flights_of_a_campaign_are_made_ready_as_alone() -> None:
    build = Memo()
    for table in nonempty(campaign(12)):
        assert_same(shared(table, build), alone(table))


#: One value after another of every table, some of which cannot be.
CHANGES: dict[str, list[Any]] = {
    "vehicle": [
        "quad", "arq", {"preset": "arq", "arms": {"stiffness": "2 N/mm"}}, SIX, "ark", 3,
        {"preset": "arq", "arms": {"compliant": False}}, {"preset": "quad", "propulsion": None},
        {"preset": "arq", "propulsion": {"max_thrust": "1 N"}},
    ],
    "world": [
        {"gravity": 1.62}, {"gravity": -1.0}, {"obstacles": []}, {"obstacles": 5}, {},
        {"obstacles": [{"type": "wall", "distance": 2.0, "surface": "mat"}]},
        {"obstacles": [{"type": "wall", "distance": 0.1, "surface": "wall"}]},
        {"obstacles": [{"type": "wall", "normal": [0, 0, 0], "position": [2, 0, 0],
                        "surface": "wall"}]},
        {"obstacles": [{"type": "mat", "distance": 3.0, "surface": "mat", "backing": "wall"}]},
        {"obstacles": [{"type": "wall", "distance": 3.0, "surface": {"preset": "wall",
                        "stiffness": 1e5, "exponent": 1.3}}]},
        {"obstacles": [{"type": "wall", "distance": 3.0, "surface": {"law": "impulse",
                        "restitution": 0.5}}]},
        {"obstacles": [{"type": "pit", "surface": "wall"}]},
    ],
    "start": [
        {"position": [0.1, 0, 1]}, {"yaw": "5 deg", "roll": 0.1}, {"position": [0, 0, 0.05]},
        {"angular_velocity": [1.0, -2.0, 0.5]}, {"position": [0, 0]}, {"velocity": "fast"}, {},
        {"position": [2.6, 0, 1]},
    ],
    "reference": [
        {"type": "hold"}, {"type": "run-up", "speed": 1.5}, {"type": "run-up", "speed": 50.0},
        {"type": "circle", "radius": 0.5}, {"type": "steps"}, {"type": "loop"}, None,
        {"type": "run-up", "speed": 2.0, "pitch": "-30 deg"},
    ],
    "control": [
        {"stiffness": 8.0}, {"stiffness": -8.0}, {"attitude": "full"}, {"rate_frequency": 300.0},
        {"rate_limit": "100 deg/s"}, {"feed_forward": False}, {"gain": 1.0},
    ],
    "recovery": [
        {"home": [0.1, 0, 1]}, {"response": {"way": "staged"}}, {"response": {"way": "set-point"}},
        {"settling": {"stay": 0.1}}, {"observer": {"force_bandwidth": 1e5}}, {}, None,
    ],
    "estimator": [
        {"type": "complementary"}, {"type": "perfect"}, {"type": "kalman"}, {"type": "luenberger"},
        {"kalman": {"offset": [0.01, 0, 0]}},
    ],
    "sensors": [
        {"imu": {"offset": [0.01, 0, 0.02]}}, {"imu": {"perfect": True}}, {"imu": {"rate": 333.0}},
        {"motion_capture": {"perfect": True}}, {"hall": {"delay": 1.0}}, {},
    ],
    "clock": [2000.0, 500.0, 0.0, 1e9, "1 kHz"],
    "seed": [1, 2**70, -1, 1.5, True],
    "air": [
        {"body_drag": 0.02}, {"body_drag": 0.02, "wind": [1, 0, 0], "gusts": {"wind_at_6_m": 5}},
        {"wind": [1, 0, 0]}, {"body_drag": 1e4},
    ],
    "payload": [{"mass": "100 g"}, {"mass": "9 kg"}, {"position": [0, 0, 1]}],
    "model_error": [
        {"mass": 1.1, "inertia": 0.9}, {"mass": 0.1}, {"inertia": 0.1}, {"mass": 3.0}, {},
    ],
    "model": [{"contact_point": "paper"}, {"arms": "always-free"}, {"slider": [1, 0, 0]}],
    "simulation": [{"duration": 2.0}, {"impact_step": 1.0}, {"duration": "1 h"}, {"dwell": 0.1}],
    "thrust": ["hover", 3.0, [1, 2, 3], -1.0],
    "name": ["one", 5],
    "nmae": [1],
}  # fmt: skip


def varied(seed: int, count: int, base: dict[str, Any]) -> list[dict[str, Any]]:
    """Tables, each of which differs from some base in a few values that others share."""
    noise_stream, tables = np.random.default_rng(seed), []
    for _ in range(count):
        table = dict(base)
        for key in noise_stream.choice(
            list(CHANGES), size=noise_stream.integers(0, 3), replace=False
        ):
            table[str(key)] = CHANGES[str(key)][noise_stream.integers(len(CHANGES[str(key)]))]
        tables.append({key: value for key, value in table.items() if value is not None})
    return tables


@pytest.mark.parametrize("has_pilot", [True, False])
def test_whatever_differs_is_made_ready_as_alone(has_pilot: bool) -> None:
    base = campaign(1)[0]
    if not has_pilot:
        base = {key: base[key] for key in ("vehicle", "world", "start", "simulation")}
    build, refused = Memo(), 0
    tables = varied(1, 150, base)
    for table in tables:
        one = shared(table, build)
        assert_same(one, alone(table))
        refused += isinstance(one, str)
    assert 30 < refused < 120  # both happen


def test_what_is_kept_for_ever_can_be_forgotten() -> None:
    """Else memory would grow with the number of flights."""
    made: list[str] = []
    build = Memo()

    def part(name: str) -> str:
        made.append(name)
        return name

    for name in ("a", "b", "a"):
        build(part, name, place=FOREVER)
    build.forget()
    build(part, "a", place=FOREVER)
    assert made == ["a", "b", "a"]


def test_a_part_that_was_refused_is_refused_again() -> None:
    build, (table, *_) = Memo(), campaign(1)
    bad = table | {"control": {"stiffness": -1.0}}
    assert_same(shared(bad, build), alone(bad))
    assert_same(shared(bad, build), alone(bad))
    assert_same(shared(table, build), alone(table))


def test_nothing_is_remembered_of_others_tables() -> None:
    """Equal tables that are not the same objects, and the same flight after others."""
    tables = campaign(3)
    build, first = Memo(), [shared(table, Memo()) for table in tables]
    for order in ([0, 1, 2, 3, 4, 5], [5, 1, 4, 0, 3, 2], [2, 2, 0, 2]):
        for k in nonempty(order):
            assert_same(shared(tables[k], build), first[k])
