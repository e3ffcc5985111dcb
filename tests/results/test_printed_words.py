"""What is printed of flights: guards that are no cages, locked arms, impulses without a peak."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.errors import InputError
from springback.results.flight import Flight, as_scenario, fly
from springback.results.saved import load

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
    assert flight.measures["contact_time"] is None
    assert flight.measures["travel"] is None
    fall = flown(thrust=0.0, world={"obstacles": []})
    assert fall.measures["peak_acceleration"] == pytest.approx(9.81)


def impulses(**changes: Any) -> Flight:
    """A vehicle that turns, so that two of its guards strike a wall one after the other."""
    surface = {"law": "impulse", "restitution": 0.5, "friction": 0.1}
    start = {"position": [0.77, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0], "yaw": "40 deg"}
    simulation = {"duration": 0.06, "dwell": 0.05, **changes}
    return flown(surface=surface, start=start, simulation=simulation)


def test_impulses_after_each_other_have_no_duration_and_are_told_of_one_by_one() -> None:
    flight = impulses()
    m = flight.measures
    assert (m["impacts"], m["contacts"]) == (1.0, 2.0)
    assert (m["separation_time"] or 0.0) > (m["touch_time"] or 0.0) + 1e-3
    for name in nonempty(
        ("contact_time", "travel", "impact_peak_acceleration", "peak_acceleration")
    ):
        assert m[name] is None, name
    hits = [event for event in flight.events if event.kind == "contact"]
    assert len(hits) == 2
    assert len({one.arm for one in hits}) == 2
    [touch] = [event for event in flight.events if event.kind == "touch"]
    assert touch.t == m["touch_time"]
    assert touch.value == pytest.approx(2.0, rel=1e-3)
    assert touch.obstacle == "world.obstacles[0], a wall"
    assert "at 2.00 m/s, on world.obstacles[0], a wall, impulse " in touch.text
    assert touch.place == pytest.approx((m["touch_x"], m["touch_y"], m["touch_z"]), abs=1e-6)
    assert not [event for event in flight.events if event.kind in ("separation", "release")]
    mass = flight.scenario.vehicle.mass
    sizes = []
    for hit in nonempty(hits):
        row = int(np.searchsorted(flight.t, hit.t))
        sizes.append(mass * abs(flight.columns["vx"][row] - flight.columns["vx"][row - 1]))
        assert "touches world.obstacles[0], a wall, impulse " in hit.text
    [met] = flight.obstacle_contacts
    assert met.parts == tuple(sorted(f"guard {one.arm}" for one in hits))
    assert met.force == 0.0
    assert met.impulse == pytest.approx(max(sizes), rel=0.05)  # it turns and rubs, too
    assert f"impulse up to {met.impulse:.3g} N s on {met.part}, at [1.00, " in repr(flight)


def test_a_flight_of_impulses_that_is_read_back_knows_what_it_touched(tmp_path: Path) -> None:
    """The impulse so far is in its files, the jumps follow from it, of thinned instants, too."""
    flight = impulses()
    flight.save(tmp_path, figures=False)
    again = load(tmp_path)
    assert repr(again) == repr(flight)
    assert again.events == flight.events
    assert again.units["impulse_x"] == "N s"
    last = [again.columns[f"impulse_{axis}"][-1] for axis in "xyz"]
    assert last == [again.measures[f"impulse_{axis}"] for axis in "xyz"]
    thin = impulses(record_interval=2e-3)
    assert [one.obstacle for one in thin.obstacle_contacts] == ["world.obstacles[0], a wall"]
    assert [one.kind for one in thin.events].count("touch") == 1


def test_flights_of_forces_have_no_columns_of_impulses() -> None:
    flight = flown()
    assert not [name for name in flight.columns if name.startswith("impulse")]
    assert flight.obstacle_contacts[0].impulse == 0.0


def test_the_impulse_of_all_contacts_is_printed_where_there_is_one() -> None:
    """It is the change of momentum without weight: here rotors carry that."""
    flight = flown()
    mass, c = flight.scenario.vehicle.mass, flight.columns
    gained = [mass * (c[f"v{axis}"][-1] - c[f"v{axis}"][0]) for axis in "xyz"]
    [line] = [line for line in repr(flight).splitlines() if line.startswith("  impulse ")]
    assert f" {float(np.linalg.norm(gained)):.4g} N s by all contacts: [{gained[0]:.3g}, " in line
    assert line.endswith("] N s, world axes")
    assert line.split("impulse", 1)[1].strip() in flight._repr_html_()
    fall = flown(thrust=0.0, world={"obstacles": []})
    assert fall.impulse_text == ""
    assert "impulse" not in repr(fall)


def test_speed_and_travel_say_what_they_are() -> None:
    """A vehicle at rest that is struck is driven back at once: it goes no way into what hits it."""
    still = "  touch_speed               2 m/s, along the normal"
    assert still in repr(flown()).splitlines()
    ball = {"type": "sphere", "position": [0.32, 0.0, 1.0], "radius": 0.1, "surface": "mat",
            "motion": {"type": "constant", "velocity": [-1.0, 0.0, 0.0]}}  # fmt: skip
    start = {"position": [0.0, 0.0, 1.0]}
    hit = flown(world={"obstacles": [ball]}, start=start, simulation={"duration": 0.05})
    assert hit.measures["travel"] == 0.0
    text = repr(hit)
    assert "m/s, along the normal, relative to what it touched\n" in text
    assert "  travel                    0 m; driven back at once\n" in text
    assert flown(thrust=0.0, world={"obstacles": []}).measures["travel"] is None


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
