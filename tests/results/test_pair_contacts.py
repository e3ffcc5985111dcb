"""Two vehicles in one world: their contacts evaluated again, saved and read back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.pairs import turn, two, vehicle
from springback.batch.pair import fly_pair
from springback.errors import InputError
from springback.results.flight import Flight, fly
from springback.results.pair.contacts import loads_on_first, loads_on_second
from springback.results.saved import load
from springback.scenario.scenario import scenario_from
from springback.simulation.playback import LoadHistory


@pytest.fixture(scope="module")
def flight() -> Flight:
    """Both in a glancing meeting."""
    return fly(two())


@pytest.fixture(scope="module")
def loads(flight: Flight) -> tuple[LoadHistory, LoadHistory]:
    """Contacts of both at all instants."""
    assert flight.second is not None
    given = flight.scenario, flight.columns, flight.second.columns, np.arange(len(flight.t))
    return loads_on_first(*given), loads_on_second(*given)


def test_fly_pair_is_the_flight_of_a_scenario_of_two(flight: Flight) -> None:
    """Every number, to the last bit."""
    scenario = scenario_from(two())
    alone = scenario.model_copy(update={"second": None})
    first, second = fly_pair(alone, scenario.beside())
    assert flight.second is not None
    for one, other in nonempty(((flight, first), (flight.second, second))):
        assert one.measures == other.measures
        for name in nonempty(one.columns):
            assert np.array_equal(one.columns[name], other.columns[name]), name


def test_forces_are_opposite_and_act_at_one_point(loads: Any) -> None:
    """Their sums, and their moments about the origin, so that each is drawn where it is."""
    first, second = loads
    sums = [one.force.sum(axis=1) for one in loads]
    moments = [np.cross(np.nan_to_num(one.point), one.force).sum(axis=1) for one in loads]
    assert np.abs(sums[0]).max() > 10.0
    assert np.abs(sums[0] + sums[1]).max() < 1e-12
    assert np.abs(moments[0] + moments[1]).max() < 1e-12
    assert set(first.part) | set(second.part) <= set(range(5))


def test_they_are_those_of_the_flight(flight: Flight, loads: Any) -> None:
    """Normal force and friction of each cage of both, as recorded."""
    assert flight.second is not None
    for one, found in nonempty(zip((flight, flight.second), loads, strict=True)):
        rubbed = max(one.columns[f"ff{j}"].max() for j in range(1, 5))
        assert rubbed > 1.0
        for j in range(1, 5):
            assert np.abs(found.normal[:, j - 1] - one.columns[f"fn{j}"]).max() < 1e-10
            assert np.abs(found.friction[:, j - 1] - one.columns[f"ff{j}"]).max() < 1e-10


def test_points_lie_on_the_cages_that_they_are_of(flight: Flight, loads: Any) -> None:
    """Of the first on the circle; of the second within its disc, in its plane to half its height."""
    assert flight.second is not None
    for row, (one, found) in enumerate(zip((flight, flight.second), loads, strict=True)):
        c, airframe, seen = one.columns, one.scenario.true_airframe(), 0
        for k, part in enumerate(found.part):
            for i in np.flatnonzero(np.abs(found.force[:, k]).max(axis=1) > 1e-6)[::20]:
                arm = airframe.arms[part]
                r = turn([c[f"q{p}"][i] for p in "wxyz"])
                place = np.array([c[a][i] for a in "xyz"])
                end = c[f"l{part + 1}"][i] * np.array([arm.cosine, arm.sine, 0.0])
                away = r.T @ (found.point[i, k] - place) - end
                assert abs(away[2]) < 0.021
                assert np.hypot(*away[:2]) < arm.cage_radius + 1e-3
                assert row or np.hypot(*away[:2]) > arm.cage_radius - 5e-3
                seen += 1
        assert seen > 3


def test_an_accelerometer_off_the_centre_feels_the_other_vehicle(flight: Flight) -> None:
    """The exact angular acceleration of the first is the rate of its recorded spin."""
    at = np.array([0.1, 0.0, 0.0])
    felt, still = flight.specific_force(at.tolist()), flight.specific_force()
    c, t = flight.columns, flight.t
    spin = np.stack([c[f"w{axis}"] for axis in "xyz"], axis=1)
    rate = np.gradient(spin, t, axis=0)
    formula = still + np.cross(rate, at) + np.cross(spin, np.cross(spin, at))
    touching = np.flatnonzero(sum(c[f"fn{j}"] for j in range(1, 5)) > 1.0)
    inside = touching[10:-10]
    assert np.abs(np.cross(rate, at)[inside]).max() > 5.0
    assert np.abs(felt - formula)[inside].max() < 0.02 * np.abs(formula[inside]).max()


def test_that_of_the_second_is_refused_where_it_is_not_known(flight: Flight) -> None:
    assert flight.second is not None
    assert flight.second.specific_force().shape == (len(flight.t), 3)
    with pytest.raises(InputError, match=r"at: must be \[0, 0, 0\] for a second vehicle"):
        flight.second.specific_force([0.1, 0.0, 0.0])


def test_both_are_saved_in_one_folder_and_read_back(flight: Flight, tmp_path: Path) -> None:
    files = flight.save(tmp_path / "both", figures=False)
    assert {"trajectory.parquet", "second_trajectory.parquet"} <= {path.name for path in files}
    again = load(tmp_path / "both")
    assert again.second is not None
    assert flight.second is not None
    for one, other in nonempty(((flight, again), (flight.second, again.second))):
        assert one.measures == other.measures
        assert one.outcome is other.outcome
        assert np.array_equal(one.columns["x"], other.columns["x"])
    (tmp_path / "both/second_trajectory.parquet").unlink()
    with pytest.raises(InputError, match=r"second_trajectory\.parquet: is missing"):
        load(tmp_path / "both")


def test_hulls_of_both_are_among_the_contacts() -> None:
    """Opposite, and as recorded."""
    comes = vehicle(0.7, -1.0, yaw=np.pi)
    given = two(comes, simulation={"duration": 0.12})
    hulls = {
        "first": {"type": "sphere", "radius": 0.05, "position": [0.2, 0.0, 0.0]},
        "second": {"type": "box", "size": [0.56, 0.3, 0.1]},
    }
    given["vehicle"] = {"preset": "arq", "hulls": [hulls["first"]]}
    given["second"]["vehicle"] = {"preset": "arq", "hulls": [hulls["second"]]}
    flight = fly(given)
    assert flight.second is not None
    where = flight.scenario, flight.columns, flight.second.columns, np.arange(len(flight.t))
    first, second = loads_on_first(*where), loads_on_second(*where)
    sums = [one.force.sum(axis=1) for one in (first, second)]
    assert np.abs(sums[0]).max() > 10.0
    assert np.abs(sums[0] + sums[1]).max() < 1e-12
    for one, found in nonempty(((flight, first), (flight.second, second))):
        assert np.abs(found.normal[:, 4] - one.columns["fn_body"]).max() < 1e-10
    assert flight.columns["fn_body"].max() + flight.second.columns["fn_body"].max() > 1.0
    assert flight.specific_force([0.1, 0.0, 0.0]).shape == (len(flight.t), 3)


def test_a_gap_without_obstacles_is_refused_with_what_it_does_not_know() -> None:
    alone = {
        "vehicle": "arq", "thrust": "hover", "world": {"obstacles": []},
        "simulation": {"duration": 1e-3},
    }  # fmt: skip
    flight = fly(alone, executor="python")
    with pytest.raises(InputError, match=r"has no obstacles$"):
        flight.gap()
    second = {"vehicle": "arq", "thrust": "hover", "start": {"position": [2.0, 0.0, 1.0]}}
    both = scenario_from({**alone, "second": second})
    with pytest.raises(InputError, match=r"no distance between two vehicles$"):
        replace(flight, scenario=both).gap()
