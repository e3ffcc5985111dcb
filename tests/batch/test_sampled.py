"""Flights in lanes that are read at instants: each is what it is alone, whatever stands beside it."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from identification.rigs import rig
from springback.batch.sampled import sampled_flights
from springback.batch.templates import KnownFormulas
from springback.results.flight import fly
from springback.scenario.code_files import with_absolute_names
from springback.scenario.source_text import toml_tables

EXAMPLES = Path(__file__).parents[2] / "examples"
TIMES = np.arange(0.0, 0.35, 0.001)


def impact(exponent: float, stiffness: float = 2e5) -> dict[str, Any]:
    tables = rig("quad")
    surface = tables["world"]["obstacles"][0]["surface"]
    surface |= {"exponent": exponent, "stiffness": stiffness}
    return {key: value for key, value in tables.items() if key not in ("sensors", "seed")}


def test_exponents_of_other_types_are_flown_beside_each_other() -> None:
    """3/2 is compiled by a square root, all others by a power: two kinds of flights."""
    tables = [impact(1.5), impact(1.4, 1e5), impact(1.5, 1e5), impact(1.6, 3e5)]
    together = sampled_flights(copy.deepcopy(tables), TIMES)
    for k, one in enumerate(tables):
        alone = sampled_flights([one], TIMES)
        assert np.array_equal(together.values[k], alone.values[0])
    depths = together.vectors("position")[:, :, 0].max(axis=1)
    assert len(set(np.round(depths, 6))) == 4


def test_a_force_of_another_exponent_beside_three_halves_is_its_own() -> None:
    """The deepest point by the energy of an elastic law, k δ^(n+1)/(n+1) = m v²/2."""
    tables = []
    for n in (1.5, 1.4):
        one = impact(n)
        one["world"]["obstacles"][0]["surface"] = {
            "law": "hertz", "stiffness": 2e5, "exponent": n, "shared_by": 2,
            "friction_axes": "vertical",
        }  # fmt: skip
        tables.append(one)
    found = sampled_flights(tables, TIMES)
    x = found.vectors("position")[:, :, 0]
    for k, n in enumerate((1.5, 1.4)):
        depth = ((n + 1.0) * 0.5 * 1.892 * 1.85**2 / 2e5) ** (1.0 / (n + 1.0))
        reach = 2.0 - 0.3 * 2.0**-0.5
        assert x[k].max() - reach == pytest.approx(depth, rel=2e-3)


def with_lengths(count: int, first: float) -> list[dict[str, Any]]:
    """Flights that differ in their wall's stiffness and their start."""
    tables = []
    for k in range(count):
        one = impact(1.5, 1e5 * (first + 0.1 * k))
        one["start"] = one["start"] | {"velocity": [1.8 + 0.01 * k, 0.0, 0.0]}
        tables.append(one)
    return tables


def test_known_formulas_build_the_same_flights() -> None:
    """Bit for bit those that are read, one alone, too, and with a flight that is refused."""
    known = KnownFormulas()
    sampled_flights(with_lengths(9, 1.0), TIMES, known=known)
    later = with_lengths(5, 2.0)
    read = sampled_flights(copy.deepcopy(later), TIMES)
    later[2]["world"]["obstacles"][0]["surface"]["stiffness"] = -1.0
    quick = sampled_flights(copy.deepcopy(later), TIMES, known=known)
    for k in (0, 1, 3, 4):
        assert np.array_equal(quick.values[k], read.values[k])
    assert np.isnan(quick.values[2]).all()
    alone = sampled_flights([copy.deepcopy(later[3])], TIMES, known=known)
    assert np.array_equal(alone.values[0], read.values[3])


def test_known_formulas_read_no_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    known = KnownFormulas()
    sampled_flights(with_lengths(9, 1.0), TIMES, known=known)
    monkeypatch.delattr("springback.batch.sampled.scenario_from")
    sampled_flights(with_lengths(5, 2.0), TIMES, known=known)


def test_flights_of_another_template_forget_the_formulas() -> None:
    known = KnownFormulas()
    sampled_flights(with_lengths(9, 1.0), TIMES, known=known)
    other = [one | {"thrust": 0.0} for one in with_lengths(9, 1.0)]
    found = sampled_flights(copy.deepcopy(other), TIMES, known=known)
    assert np.array_equal(found.values, sampled_flights(other, TIMES).values)


def test_threads_give_the_same_states() -> None:
    tables = with_lengths(20, 1.0)
    one = sampled_flights(copy.deepcopy(tables), TIMES)
    two = sampled_flights(tables, TIMES, threads=2)
    assert np.array_equal(one.values, two.values)


def test_a_shape_of_the_users_own_is_met(monkeypatch: pytest.MonkeyPatch) -> None:
    """The states are those of the flight alone."""
    monkeypatch.setattr("springback.scenario.build.check_trusted", lambda *_: None)
    file = EXAMPLES / "own_obstacle.toml"
    tables = with_absolute_names(toml_tables(file.read_text(encoding="utf-8"), str(file)), EXAMPLES)
    states, flight = sampled_flights([tables], TIMES), fly(tables)
    assert flight.contacts >= 1
    touch = flight.touch_time
    assert touch is not None
    speeds = states.vectors("velocity")[0, :, 0]
    assert speeds[touch - 0.001 > TIMES] == pytest.approx(2.0, abs=0.01)
    assert speeds[-1] < 0.0
