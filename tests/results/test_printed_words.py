"""What is printed of flights: guards that are no cages, locked arms, impulses without a peak."""

from __future__ import annotations

from typing import Any

import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.results.flight import Flight, as_scenario, fly

ARMS = {"directions": [0.0, 2.0, -2.0], "length": 0.15, "mass": 0.03, "cage_radius": 0.07}
MEASURES = ("impact_arm_stroke", "arm_stroke")


def tables(**changes: Any) -> dict[str, Any]:
    """A vehicle of 0.5 kg with balls around its rotors, 1 cm before a wall at 2 m/s."""
    balls = [{"type": "sphere", "on": k, "radius": 0.07} for k in (1, 2, 3)]
    return {
        "vehicle": {
            "body": {"mass": 0.41, "inertia": [1e-3, 1e-3, 1.5e-3]},
            "arms": {**ARMS, "compliant": False, "cages": False, **changes.pop("arms", {})},
            "hulls": balls,
        },
        "thrust": "hover",
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": {
            "law": "hertz", "stiffness": 1e5, **changes.pop("surface", {})}}]},
        "start": {"position": [0.77, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
        "simulation": {"duration": 0.03},
        **changes,
    }  # fmt: skip


def flown(**changes: Any) -> Flight:
    return fly(tables(**changes), executor="python")


def test_a_vehicle_without_cages_has_guards() -> None:
    flight = flown()
    texts = [repr(flight), *(event.text for event in flight.events)]
    assert any("guard 1 touches" in text for text in nonempty(texts))
    assert "by guard 1, normal force up to" in repr(flight)
    assert not [text for text in texts if "cage" in text]
    with pytest.raises(InputError, match=r"puts the guard of arm 1 0\.02 m inside"):
        as_scenario(tables(start={"position": [0.8, 0.0, 1.0]}))
    caged = tables(arms={"cages": True}, start={"position": [0.8, 0.0, 1.0]})
    with pytest.raises(InputError, match=r"puts the cage of arm 1 0\.02 m inside"):
        as_scenario(caged)


def test_locked_arms_have_no_stroke_in_print() -> None:
    flight = flown()
    assert "arm_stroke" not in repr(flight)
    every = [line.name for line in flight.readable_measures(all_of_them=True)]
    assert not set(MEASURES) & set(every)
    assert flight.measures["arm_stroke"] == 0.0
    soft = flown(arms={"compliant": [True, False, False], "stroke": 0.02})
    assert "impact_arm_stroke" in repr(soft)
    assert set(MEASURES) < {one.name for one in soft.readable_measures(all_of_them=True)}


def test_a_flight_of_impulses_has_no_peak_and_one_without_contact_has() -> None:
    flight = flown(surface={"law": "impulse", "restitution": 0.5})
    assert flight.measures["contacts"] == 1.0
    for name in nonempty(("peak_acceleration", "peak_acceleration_time", "peak_specific_force")):
        assert flight.measures[name] is None, name
        assert flight.measures[f"impact_{name}"] is None, name
    assert not [event for event in flight.events if event.kind == "peak"]
    lines = [line for line in repr(flight).splitlines() if "peak_acceleration" in line]
    assert [line.split()[-1] for line in lines] == ["-", "-"]
    fall = flown(thrust=0.0, world={"obstacles": []})
    assert fall.measures["peak_acceleration"] == pytest.approx(9.81)


def test_a_payload_that_rotors_do_not_hold_is_at_fault() -> None:
    hovers = {"preset": "arq"}
    given: dict[str, Any] = {
        "vehicle": hovers, "reference": {"type": "hold", "position": [0, 0, 1]},
        "payload": {"mass": "9 kg"},
    }  # fmt: skip
    scenario = as_scenario(given | {"payload": {"mass": "1 kg"}})
    propulsion, vehicle = scenario.vehicle.propulsion, scenario.vehicle
    assert propulsion is not None
    most = 4.0 * propulsion.max_thrust / 9.81 - vehicle.mass
    with pytest.raises(InputError) as refused:
        fly(given)
    assert f"payload.mass: must be less than {most:.4g} kg" in str(refused.value)
    with pytest.raises(InputError, match=r"max_thrust: must be more than .*payload and model_err"):
        fly(given | {"vehicle": hovers | {"propulsion": {"max_thrust": "3 N"}}})
    with pytest.raises(InputError, match=r"weigh what is elsewhere with the body.*got \[0\.1, "):
        as_scenario(given | {"payload": {"mass": "0.1 kg", "position": [0.1, 0, 0]}})


def test_a_stop_without_a_pilot_says_what_it_needs() -> None:
    stop = {"preset": "arq", "propulsion": {"stop": {"guard_force": "20 N"}}}
    words = r"vehicle\.propulsion\.stop: acts only where a pilot flies: give a \[reference\]"
    with pytest.raises(InputError, match=f"^{words}"):
        fly({"vehicle": stop, "thrust": "hover"})
    second = {"vehicle": stop, "thrust": "hover", "start": {"position": [0, 3, 1]}}
    with pytest.raises(InputError, match=rf"second\.{words}"):
        fly({"vehicle": "arq", "thrust": "hover", "second": second})
