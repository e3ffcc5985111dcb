"""What a vehicle bears: margins, when a part breaks, and what becomes of the flight."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.impacts import value
from springback.batch.scenarios import fly_scenarios
from springback.dynamics.limbs.arms import spring_damper_force
from springback.dynamics.stops import end_stop
from springback.errors import InputError
from springback.results.result import FlightResult

CAMERA = {"name": "camera", "position": [0.06, -0.02, 0.03], "specific_force": 150.0}
LIMITS = {"guard_force": 150.0, "arm_force": [200.0, 210.0, 220.0, 230.0], "components": [CAMERA]}
MARGINS = ("guard_margin", "arm_margin", "component_margin")


def into_a_wall(limits: Any, **changes: Any) -> dict[str, Any]:
    return {
        "vehicle": {"preset": "arq", "limits": limits},
        "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": 2.75, "surface": "wall"}]},
        "start": {"position": [2.2, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": 0.35},
        "simulation": {"duration": 0.4},
        **changes,
    }


def loads_of(flight: FlightResult) -> tuple[np.ndarray[Any, Any], ...]:
    """Normal force and force along each arm [N], and specific force at the camera [m/s²]."""
    c, arms = flight.columns, flight.scenario.vehicle.airframe().arms
    along = [
        [
            abs(spring_damper_force(arm, length, rate) + end_stop(arm, length, rate).force)
            for length, rate in zip(c[f"l{j}"].tolist(), c[f"dl{j}"].tolist(), strict=True)
        ]
        for j, arm in enumerate(arms, start=1)
    ]
    felt = np.linalg.norm(flight.specific_force(CAMERA["position"]), axis=1)
    return np.array([c[f"fn{j}"] for j in range(1, 5)]), np.array(along), felt


def test_margins_are_those_of_the_trajectory() -> None:
    """1 less the largest share of a limit; the camera's by the six equations, solved anew."""
    flight = springback.fly(into_a_wall(LIMITS))
    normal, along, felt = loads_of(flight)
    each = np.array(LIMITS["arm_force"])[:, None]
    expected = (normal.max() / 150.0, (along / each).max(), felt.max() / 150.0)
    for name, share in zip(MARGINS, expected, strict=True):
        assert value(flight, name) == pytest.approx(1.0 - share, abs=1e-6), name
        assert 0.05 < share < 1.0, name
    assert flight.measures["broken_time"] is None


def test_limits_change_no_number_of_the_flight() -> None:
    watched, plain = springback.fly(into_a_wall(LIMITS)), springback.fly(into_a_wall(False))
    for name, column in plain.columns.items():
        assert np.array_equal(watched.columns[name], column), name
    assert all(plain.measures[name] is None for name in (*MARGINS, "broken_time"))


@pytest.mark.parametrize("part", ["guard 2", "arm 2", "camera"])
def test_what_is_loaded_beyond_its_limit_breaks_when_it_is(part: str) -> None:
    """At the first instant whose load is beyond it: time, event, outcome, and no success."""
    given: dict[str, Any] = {
        "guard 2": {"guard_force": 60.0}, "arm 2": {"arm_force": 40.0},
        "camera": {"components": [CAMERA | {"specific_force": 40.0}]},
    }[part]  # fmt: skip
    flight = springback.fly(into_a_wall(given))
    normal, along, felt = loads_of(flight)
    load, most = {"guard 2": (normal[1], 60.0), "arm 2": (along[1], 40.0), "camera": (felt, 40.0)}[
        part
    ]
    first = flight.t[np.flatnonzero(load > most)[0]]
    assert value(flight, "broken_time") == pytest.approx(first, abs=1e-9)
    (event,) = [event for event in flight.events if event.kind == "broken"]
    assert event.t == pytest.approx(first, abs=1e-9)
    assert event.text.startswith(f"{part}: more than ")
    assert event.label == f"{part} broken"
    assert flight.outcome.word == "broken"
    assert not flight.success
    spared = springback.fly(into_a_wall(given | {"breaks": False}))
    assert spared.outcome.word == "separated"
    assert value(spared, "broken_time") == value(flight, "broken_time")


def test_a_component_feels_the_turning_in_free_flight() -> None:
    """ω² r outwards at the rim of a robot that spins, one rigid body far from everything."""
    spin, lever, thrust = 8.0, 0.2, 9.81
    rim = {"name": "rim", "position": [lever, 0.0, 0.0], "specific_force": 100.0}
    given = into_a_wall({"components": [rim]})
    given["world"] = {"obstacles": []}
    given["start"] = {"position": [0.0, 0.0, 1.0], "angular_velocity": [0.0, 0.0, spin]}
    flight = springback.fly(given)
    felt = math.hypot(spin**2 * lever, thrust)
    assert value(flight, "component_margin") == pytest.approx(1.0 - felt / 100.0, abs=1e-6)


def test_many_flights_break_as_each_does_alone() -> None:
    """To the bit, with limits of different size and number in one batch; also with a pilot."""
    tables = [into_a_wall(LIMITS | {"guard_force": 60.0 + 40.0 * k}) for k in range(4)]
    tables += [into_a_wall({"components": [CAMERA | {"specific_force": 50.0}]})]
    pilot = {"reference": {"type": "run-up", "speed": 2.0}, "recovery": {}, "thrust": 0.0,
             "start": {"position": [0.0, 0.0, 1.0]}, "simulation": {"duration": 4.0}}  # fmt: skip
    tables += [into_a_wall({"guard_force": 50.0}, **pilot)]
    rows = fly_scenarios(tables)
    for k, table in enumerate(tables):
        alone = springback.fly(table, trajectory=False)
        assert rows.outcomes[k] == alone.outcome.word
        for name in (*MARGINS, "broken_time"):
            seen, told = float(rows.measures[name][k]), alone.measures[name]
            assert (math.isnan(seen) and told is None) or seen == told, name
    assert rows.outcomes[0] == rows.outcomes[4] == rows.outcomes[5] == "broken"
    assert rows.outcomes[3] == "separated"


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        ({}, ("vehicle.limits", "limits nothing")),
        ({"guard_force": -1.0}, ("vehicle.limits.guard_force", "must be more than 0 N")),
        ({"guard_force": [1.0, 2.0]}, ("vehicle.limits.guard_force", "2 entries for 4 arms")),
        ({"components": [CAMERA, CAMERA]}, ("vehicle.limits.components[1].name", "another")),
        (
            {"components": [{"name": "x", "specific_force": "9 N"}]},
            ("vehicle.limits.components[0].specific_force", "m/s^2"),
        ),
    ],
)
def test_limits_that_cannot_be_are_refused(limits: Any, words: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as caught:
        springback.fly(into_a_wall(limits))
    assert all(word in str(caught.value) for word in words)


def test_the_force_within_a_rigid_arm_has_no_limit() -> None:
    given = into_a_wall({"arm_force": 10.0})
    given["vehicle"]["preset"] = "quad"
    with pytest.raises(InputError, match=r"vehicle\.limits\.arm_force: needs a compliant arm"):
        springback.fly(given)


HINGE = {
    "type": "hinge", "position": [0.06, 0.0, 0.0], "axis": [0, 0, 1], "travel": [-0.7, 0.7],
    "stiffness": 2.0, "damping": 0.02,
}  # fmt: skip
SLIDE = {
    "type": "slide", "direction": [-1, 0, 0], "travel": [0.0, 0.02], "stiffness": 5e3,
    "damping": 20.0,
}  # fmt: skip
RADIUS = 0.19 - 0.06


@pytest.mark.parametrize("order", ["hinge first", "slide first"])
def test_each_of_two_joints_has_its_own_limit(order: str) -> None:
    """A torque of the hinge, a force of the slide; the margin is that of what comes nearer to it.

    A slide behind a hinge bore anything: only the first of two joints that differ was looked at.
    """
    first, second = (HINGE, SLIDE) if order == "hinge first" else (SLIDE, HINGE)
    start = {"position": [2.35, 0.0, 1.0], "velocity": [0.5, 0.0, 0.0], "yaw": 0.35}
    tables = into_a_wall({"arm_force": 1e3}, start=start)
    arms = {"joint": first | {"second": second}}
    flight = springback.fly(tables | {"vehicle": tables["vehicle"] | {"arms": arms}})
    c = flight.columns
    coordinates = ("l", "dl"), ("bend", "dbend")
    turning, sliding = coordinates if order == "hinge first" else coordinates[::-1]

    def moves(names: tuple[str, str], free: float) -> tuple[Any, Any]:
        way, rate = (np.array([c[f"{name}{j}"] for j in range(1, 5)]) for name in names)
        return way - (free if names == ("l", "dl") else 0.0), rate

    at, rate = moves(turning, 0.19)
    torques = np.abs(2.0 * at / RADIUS + 0.02 * rate / RADIUS)
    at, rate = moves(sliding, 0.19)
    assert -0.02 < at.min() < -1e-3, "no stop adds to the spring"
    inside = np.abs(5e3 * at + 20.0 * rate).max()
    assert torques.max() > 0.1
    for limits, share in (
        ({"arm_force": 100.0, "hinge_torque": 1e3}, inside / 100.0),
        ({"arm_force": 1e5, "hinge_torque": 4.0}, torques.max() / 4.0),
        ({"hinge_torque": 4.0}, torques.max() / 4.0),
        ({"arm_force": 100.0}, max(inside, torques.max() / RADIUS) / 100.0),
    ):
        vehicle = tables["vehicle"] | {"arms": arms, "limits": limits}
        margin = value(springback.fly(tables | {"vehicle": vehicle}), "arm_margin")
        assert margin == pytest.approx(1.0 - share, abs=2e-3), limits


def test_a_flight_says_what_broke_and_when() -> None:
    limits = {"guard_force": 60.0, "components": [CAMERA]}
    flight = springback.fly(into_a_wall(limits))
    said = repr(flight)
    assert f"{flight.measures['guard_margin']:.5g}" in said
    assert "component_margin" in said
    [line] = [line for line in said.splitlines() if "broken_time" in line]
    assert line.strip().startswith(
        f"broken_time               {flight.measures['broken_time']:.5g} s, guard "
    )
    assert all(part in line for part in flight.broken_parts)
    told = [one for one in flight.events if one.kind == "broken"]
    assert len(flight.broken_parts) == len(told) >= 1
    for part, event in zip(flight.broken_parts, told, strict=True):
        assert f" at {event.t:.5g} s: more than " in part
    assert flight.summary()["broken_parts"] == flight.broken_parts
    assert "margin" not in repr(springback.fly(into_a_wall(None)))
