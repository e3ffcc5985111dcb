"""Whatever a scenario says, flights that differ in its numbers are built together as alone."""

from __future__ import annotations

import copy
import functools
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
import pytest

from springback.batch.templates import FEW, BuiltGroup, ScenarioGroup, built_groups
from springback.errors import InputError
from springback.kernels.layout import structure
from springback.kernels.trees import leaves
from springback.scenario.avionics import normals_at_start
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


def alone(table: dict[str, Any]) -> ReadyFlight:
    return scenario_from(table, False, advises=False).build(advises=False)


def shifted(table: Any, factor: float) -> Any:
    """A table with all its floats multiplied, but for the times that a batch shares."""
    if isinstance(table, dict):
        shared = ("simulation", "clock")
        return {k: v if k in shared else shifted(v, factor) for k, v in table.items()}
    if isinstance(table, list | tuple):
        return type(table)(shifted(entry, factor) for entry in table)
    return table * factor if type(table) is float else table


def trial() -> dict[str, Any]:
    """A trial of a recovery."""
    return trial_tables("arq", 0.0, 2.0, Scatter().draw("arq", 0.0, 2.0, 0, 0))


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


def bits(ready: ReadyFlight) -> tuple[Any, bytes, bytes]:
    """Types and numbers of a flight; −0 is not 0 here."""
    avionics = ready.built_avionics.avionics if ready.built_avionics else ()
    flown = (ready.model, ready.start)
    types = structure(flown), structure(avionics)
    return types, np.array(leaves(flown)).tobytes(), np.array(leaves(avionics)).tobytes()


def bits_of(many: BuiltGroup, row: int) -> tuple[Any, bytes, bytes]:
    """Those of one flight of a group."""
    types, *trees = bits(many.first)
    found = []
    for tree, (places, values) in zip(trees, (many.flown, many.onboard), strict=True):
        numbers = np.frombuffer(tree).copy()
        numbers[places] = values[row]
        found.append(numbers.tobytes())
    return types, found[0], found[1]


def built(tables: list[dict[str, Any]]) -> list[BuiltGroup]:
    """What is built together of flights that differ in numbers only."""
    group = ScenarioGroup(0, tables[0])
    assert all(group.takes(k, table) for k, table in enumerate(tables[1:], start=1))
    is_gusty = (tables[0].get("air") or {}).get("gusts") is not None
    normals = [normals_at_start(table["seed"], is_gusty) for table in tables]
    return list(built_groups(group, normals.__getitem__, lambda k: alone(tables[k])))


@pytest.mark.parametrize("has_pilot", [True, False])
def test_whatever_differs_is_built_as_alone(has_pilot: bool) -> None:
    base = trial()
    if not has_pilot:
        base = {key: base[key] for key in ("vehicle", "world", "start", "simulation")}
    together, refused = 0, 0
    for table in varied(1, 60, base):
        tables = [shifted(table, 1.0 + 1e-4 * k) | {"seed": k} for k in range(FEW)]
        for many in built(tables):
            together += 1
            for row, k in enumerate(many.flights):
                assert bits_of(many, row) == bits(alone(tables[k]))
        try:
            alone(tables[0])
        except InputError:
            refused += 1
    assert together > 20
    assert refused > 10


def places_of_floats(table: Any, at: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Paths of all floats in a table."""
    parts: Iterable[tuple[Any, Any]] = ()
    if isinstance(table, dict):
        parts = table.items()
    elif isinstance(table, list):
        parts = enumerate(table)
    for key, part in parts:
        if type(part) is float:
            yield (*at, key)
        else:
            yield from places_of_floats(part, (*at, key))


def changed(table: Any, path: tuple[Any, ...], k: int) -> dict[str, Any]:
    """A table with one of its numbers changed a little, by the number of a flight."""
    copied: dict[str, Any] = copy.deepcopy(table)
    *keys, last = path
    node = functools.reduce(lambda part, key: part[key], keys, copied)
    node[last] = node[last] * (1.0 + 1e-5 * (k + 1)) if node[last] else 1e-6 * (k + 1)
    return copied | {"seed": 0}


def without_none(table: Any) -> Any:
    if isinstance(table, dict):
        return {key: without_none(part) for key, part in table.items() if part is not None}
    return [without_none(part) for part in table] if isinstance(table, list | tuple) else table


def test_every_number_is_traced() -> None:
    """Whatever a campaign varies: flights that can be flown are built together."""
    air = {"body_drag": 0.01, "wind": [1.0, 0.5, 0.0], "gusts": {"wind_at_6_m": 5.0}}
    full = without_none(scenario_from(trial() | {"air": air}).model_dump(exclude={"seed"}))
    traced, refused = 0, []
    for path in places_of_floats(full):
        if path in (("clock",), ("simulation", "duration")):  # of a batch
            continue
        if path == ("start", "second_compression"):  # of arms on two joints, below
            continue
        if path == ("vehicle", "arms", "height"):  # raised ends: another structure than level ones
            continue
        if path[-2:] == ("surface", "exponent"):  # other than 3/2: a scene, each by itself
            continue
        tables = [changed(full, path, k) for k in range(FEW)]
        together = [k for many in built(tables) for k in many.flights]
        traced += together == [*range(FEW)]
        if together != [*range(FEW)]:
            with pytest.raises(InputError):
                alone(tables[0])
            refused.append(path)
    assert traced > 150
    assert len(refused) <= 30  # such as the friction of a rail without a slider


def test_every_number_of_two_joints_is_traced() -> None:
    """Springs, dampers, travels; places and axes but for flights that take other branches."""
    hinge = {"type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0.1, 0.2, 1.0],
             "travel": [-1.0, 1.0], "stiffness": 5.0, "quadratic": 1.0, "damping": 0.02,
             "play": 0.01}  # fmt: skip
    second = {**hinge, "axis": [0.0, 1.0, 0.1], "travel": [-0.3, 0.6]}
    base = trial()
    vehicle = {"preset": "arq", "arms": {"joint": {**hinge, "second": second}}}
    full = {**{key: base[key] for key in ("world", "start", "simulation")}, "vehicle": vehicle}
    paths = [path for path in places_of_floats(vehicle, ("vehicle",)) if "joint" in path]
    assert len(paths) == 24
    full["start"] = {**full["start"], "second_compression": 0.0}
    for path in (*paths, ("start", "second_compression")):
        groups = built([changed(full, path, k) for k in range(FEW)])
        together = [k for many in groups for k in many.flights]
        turned = {"position", "axis"} & set(path)
        assert len(together) > 1 if turned else together == [*range(FEW)], path
