"""Flights by the thousand: every number is that of the flight flown alone."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import springback
from springback.batch.scenarios import REFUSED, Rows, fly_scenarios
from springback.errors import InputError
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.simulation.measuring.measures import MEASURES
from springback.studies.trials import Scatter, trial_tables

WALL = {"type": "wall", "distance": 1.0, "surface": "wall"}


def collisions() -> list[dict[str, Any]]:
    """Run-ups of both robots in turn, by chance; two that cannot be flown among them.

    They are enough to be made ready together (`springback.batch.templates`).
    """
    changes = {"simulation": {"duration": 3.0}}
    tables, shared = [], None
    for k in range(10):
        for robot in ("arq", "quad"):
            noise_stream = Scatter().draw(robot, 0.0, 3.0, k, 0)
            table = trial_tables(robot, 0.0, 3.0, noise_stream, changes)
            shared = shared or {name: table[name] for name in ("reference", "recovery")}
            tables.append(table | shared)
    tables[3] = tables[3] | {"control": {"stiffness": "-1 N/m"}}
    tables[6] = tables[6] | {"start": {"position": [2.7, 0.0, 1.0]}}
    for k in range(10, 18):
        tables[k] = tables[k] | {"estimator": {"type": "complementary"}}
    for k in (8, 9, 14, 17):  # of their group some wait for a sample that others have
        tables[k] = tables[k] | {"sensors": {"imu": {"rate": "500 Hz"}}}
    return tables


def guided() -> list[dict[str, Any]]:
    """Flights with a pilot that expects no collision."""
    start = {"position": (0.69, 0.0, 1.0), "velocity": (2.0, 0.1, 0.0), "pitch": 0.1}
    base = {
        "vehicle": "arq",
        "reference": {"type": "hold", "position": (0.2, 0.1, 1.1)},
        "estimator": {"type": "perfect"},
        "world": {"obstacles": [WALL]},
        "simulation": {"duration": 0.3},
    }
    return [base | {"start": start | {"yaw": 0.02 * k}} for k in range(3)]


def unguided() -> list[dict[str, Any]]:
    """Throws at a wall, past it, into the ground, with the arms always free, of two durations."""
    ground = {"type": "ground", "surface": "wall"}
    base = {
        "vehicle": "arq",
        "thrust": "hover",
        "world": {"obstacles": [WALL, ground]},
        "start": {"position": [0.6, 0, 1], "velocity": [2.0, 0, 0]},
        "simulation": {"duration": 0.3},
    }
    return [
        base,
        base | {"vehicle": {"preset": "arq", "arms": {"stiffness": "2 N/mm"}}},
        base | {"vehicle": "quad", "start": {"position": [0.6, 0, 1], "velocity": [-1.0, 0, 0]}},
        base | {"thrust": 0.0, "start": {"position": [0, 0, 0.1], "velocity": [0, 0, -1]}},
        base | {"simulation": {"duration": 0.1}, "model": {"arms": "always-free"}},
        base | {"simulation": {"duration": 0.05}},
        base | {"air": {"body_drag": 0.02, "wind": [3, 0, 0]}},
        base | {"nmae": "mistaken"},
        base | {"air": {"body_drag": 0.02, "gusts": {"wind_at_6_m": 5.0, "airspeed": 3.0}}},
    ]


ALL = {"collisions": collisions, "guided": guided, "unguided": unguided}


def row(rows: Rows, k: int) -> tuple[Any, ...]:
    """One row; NaN as None, that rows can be compared."""
    values = [float(column[k]) for column in rows.measures.values()]
    told = tuple(None if math.isnan(value) else value for value in values)
    return rows.outcomes[k], rows.problems[k], *told


def flown_alone(table: Mapping[str, Any]) -> tuple[Any, ...]:
    """The row of a flight flown by itself, by the ordinary way."""
    names = (*MEASURES, *RECOVERY_MEASURES)
    try:
        flight = springback.fly(table, trajectory=False)
    except InputError as error:
        return REFUSED, "; ".join(error.problems), *(None for _ in names)
    return flight.outcome.word, "", *(flight.measures.get(name) for name in names)


@pytest.mark.parametrize("kind", ALL)
def test_flights_are_those_flown_alone(kind: str) -> None:
    tables = ALL[kind]()
    rows = fly_scenarios(tables)
    assert list(rows.measures) == [*MEASURES, *RECOVERY_MEASURES]
    for k, table in enumerate(tables):
        assert row(rows, k) == flown_alone(table), k


def test_company_and_order_do_not_matter() -> None:
    tables = [*collisions(), *unguided()]
    all_rows, count = fly_scenarios(tables, threads=2), len(tables)
    order = np.random.default_rng(0).permutation(count).tolist()
    shuffled = fly_scenarios([tables[k] for k in order])
    assert [row(shuffled, place) for place in range(count)] == [row(all_rows, k) for k in order]
    few = fly_scenarios([tables[k] for k in order[:4]])
    assert [row(few, place) for place in range(4)] == [row(all_rows, k) for k in order[:4]]


def test_blocks_do_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    tables = unguided()
    whole = fly_scenarios(tables)
    monkeypatch.setattr("springback.batch.scenarios.BLOCK", 3)
    shares: list[float] = []
    parts = fly_scenarios(tables, progress=shares.append)
    assert [row(parts, k) for k in range(len(tables))] == [
        row(whole, k) for k in range(len(tables))
    ]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0


def test_what_happens_happens() -> None:
    """Lest the comparisons above compare nothing."""
    rows = fly_scenarios(collisions())
    assert set(rows.outcomes) > {REFUSED}
    assert np.nanmax(rows.measures["runs"]) == 1.0
    assert np.isfinite(rows.measures["detection_delay"]).sum() == len(rows.outcomes) - 2
    thrown = fly_scenarios(unguided()).outcomes
    assert {"separated", "no_contact", "hit_ground", REFUSED} <= set(thrown)


def test_nothing_is_flown_of_nothing() -> None:
    rows = fly_scenarios([])
    assert rows.outcomes == rows.problems == []
    assert all(len(column) == 0 for column in rows.measures.values())
