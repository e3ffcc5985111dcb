"""Rotors that a vehicle lists: user input, allocation, hover, discs and guards; in plain Python."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from builders.listed_rotors import canted, coaxial, of_each_arm, vehicle_with
from springback.control.mixing import allocation, mixer, rotor_thrusts, wrench_of
from springback.control.target import Wrench
from springback.dynamics.clearance import propeller_gaps
from springback.errors import InputError
from springback.interfaces.lab.vehicle_controls import arm_changes, changed_vehicle, why_fixed_count
from springback.interfaces.lab.vehicles import is_balanced
from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec
from springback.results.flight import fly
from springback.scenario.scenario import Scenario
from springback.simulation.flight import still_state
from springback.studies.scenario_check import check_warnings, derived_numbers
from springback.vehicle.endurance import hover_power, largest_payload
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.balance import hover_balance
from springback.vehicle.placed.rotors import guards_of
from springback.vehicle.placed.settings import wrench_matrix
from springback.vehicle.rotor_stop import StopSettings, reactions_of

HOLD: dict[str, Any] = {"reference": {"type": "hold", "position": [0.0, 0.0, 1.0]}}
PUSHER = {"on": "body", "position": [-0.2, 0.0, 0.0], "axis": [3.0, 0.0, 0.0]}
TILT = math.radians(20.0)


def vehicle(rotors: list[dict[str, Any]], **more: Any) -> Vehicle:
    return Vehicle.model_validate(vehicle_with(rotors, **more))


# -- user input ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("rotors", "words"),
    [
        ([{"on": "body"}], ("vehicle.rotors[0].position", "is missing")),
        ([{"on": 1, "axis": [0, 0, 0]}], ("vehicle.rotors[0].axis", "(got [0.0, 0.0, 0.0])")),
        ([{"on": 1}, {"on": 7}], ("vehicle.rotors[1].on", "from 1 to 6", "got 7")),
        ([{"on": "arm"}], ("vehicle.rotors[0].on", 'must be "body"')),
        ([{"on": 2}, {"on": 2}], ("vehicle.rotors[1].position", "where rotors[0] is")),
        ([{"on": 2, "position": ["3 m", 0, 0]}], ("vehicle.rotors[0].position", "must be within")),
        ([{"on": 2, "spin": 2}], ("vehicle.rotors[0].spin", "-1 or 1")),
        ([{"on": 2, "torque_ratio": "2 N"}], ("vehicle.rotors[0].torque_ratio", "m")),
        ([{"on": 2, "tilt": 3}], ("vehicle.rotors[0].tilt", "unknown key")),
        ([PUSHER], ("vehicle.rotors", "cannot hover")),
        ([{"on": 1, "position": [0, 0, 1e-3 * k]} for k in range(33)], ("at most 32",)),
    ],
)  # fmt: skip
def test_bad_rotors_are_one_line(rotors: list[dict[str, Any]], words: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as caught:
        fly({"vehicle": vehicle_with(rotors), "thrust": "hover"})
    (line,) = caught.value.problems
    assert all(word in line for word in words), line


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"rotors": of_each_arm(3)}, ("vehicle.rotors", "yaw", "rank 3 of 4")),
        ({"rotors": [{"on": 1}, {"on": 4}]}, ("vehicle.rotors", "rank 2 of 4")),
        ({"rotors": [{**one, "torque_ratio": 0.0} for one in of_each_arm(6)]}, ("leave yaw",)),
        (
            {"rotors": [*of_each_arm(4), {"on": "body", "position": [-0.16, 0.0, 0.0]}]},
            ("vehicle.rotors[2]", "pull down"),
        ),
        (
            {"rotors": [*of_each_arm(6), PUSHER],
             "propulsion": {"max_thrust": 2.5, "min_thrust": 0.05}},
            ("vehicle.propulsion.min_thrust", "rotors[6]", "0.05 N"),
        ),
        ({"rotors": canted(math.radians(75.0))}, ("vehicle.rotors", "cannot hover")),
        (
            {"rotors": canted(math.radians(55.0)), "propulsion": {"max_thrust": 1.5}},
            ("vehicle.propulsion.max_thrust", "must be more than 1.653 N"),
        ),
    ],
)  # fmt: skip
def test_a_pilot_needs_lift_and_three_moments(
    changes: dict[str, Any], words: tuple[str, ...]
) -> None:
    given = vehicle_with(changes.pop("rotors"), **changes)
    with pytest.raises(InputError) as caught:
        springback.Scenario(vehicle=given, **HOLD).build()
    (line,) = caught.value.problems
    assert all(word in line for word in words), line


def test_spins_are_those_of_the_list_and_ratios_those_of_its_arm() -> None:
    given = vehicle_with([{"on": 2}, {"on": 4, "spin": -1}, {"on": 1, "torque_ratio": 0.5}])
    given["arms"]["torque_ratio"] = [0.01, 0.02, 0.03, 0.04, 0.05, 0.06]
    each = Vehicle.model_validate(given).airframe().rotors.each
    assert [one.torque_ratio for one in each] == [-0.02, -0.04, -0.5]
    assert [one.arm for one in each] == [2.0, 4.0, 1.0]
    given["arms"]["spin"] = [1] * 6
    with pytest.raises(InputError, match=r"arms\.spin: cannot be combined with rotors"):
        Vehicle(**given)


def test_guards_alone_stop_nothing_on_the_body() -> None:
    rotors = [{"on": "body", "position": [x, y, 0.0]} for x in (-0.1, 0.1) for y in (-0.1, 0.1)]
    stop = {"max_thrust": 9.0, "stop": {"guard_force": 5.0}}
    with pytest.raises(InputError, match=r"propulsion.stop.guard_force: stops no rotor"):
        Vehicle(**vehicle_with(rotors, propulsion=stop))
    Vehicle(**vehicle_with(rotors, propulsion=stop | {"disk_radius": 0.05}))
    Vehicle(**vehicle_with([*rotors, {"on": 1}], propulsion=stop))


# -- wrench and allocation -------------------------------------------------------------------------


def by_hand(given: dict[str, Any], lengths: np.ndarray) -> np.ndarray:
    """Columns of force and moment of each rotor on planar arms of these lengths, shape (6, n)."""
    columns, arms = [], given["arms"]
    for k, one in enumerate(given["rotors"]):
        up = np.array(one.get("axis", [0.0, 0.0, 1.0]))
        up = up / np.linalg.norm(up)
        place = np.array(one.get("position", [0.0, 0.0, 0.0]))
        if one["on"] != "body":
            angle = arms["directions"][one["on"] - 1]
            end = lengths[one["on"] - 1] * np.array([np.cos(angle), np.sin(angle), 0.0])
            place = place + end
        drag = one.get("spin", -1 if k % 2 == 0 else 1) * 0.0127 * up
        columns.append([*up, *(np.cross(place, up) + drag)])
    return np.array(columns).T


CASES = {
    "canted": (vehicle_with(canted(TILT)), 6),
    "coaxial, with legs": (vehicle_with(coaxial(), 4, 2), 8),
    "pusher": (vehicle_with([*canted(0.1), PUSHER]), 6),
}


@pytest.mark.parametrize("name", CASES)
def test_allocation_is_the_pseudoinverse_of_the_wrench_matrix(name: str) -> None:
    """At any arm lengths; rotors that do not lift are given nothing."""
    given, lifting = CASES[name]
    craft, rng = Vehicle.model_validate(given), np.random.default_rng(51)
    airframe, free = craft.airframe(), np.array(craft.lengths())
    np.testing.assert_allclose(
        wrench_matrix(craft.rotors, craft.arms), by_hand(given, free), atol=1e-15
    )
    for _ in range(20):
        lengths = free - rng.uniform(0.0, 0.02, size=len(free))
        b = by_hand(given, lengths)[2:]
        used = b * (np.arange(b.shape[1]) < lifting)
        wanted = np.array([rng.uniform(2.0, 9.0), *rng.normal(0.0, 0.1, 3)])
        wrench = Wrench(wanted[0], Vec(*wanted[1:].tolist()))
        thrusts = allocation(mixer(airframe, tuple(lengths.tolist())), wrench)
        np.testing.assert_allclose(thrusts, np.linalg.pinv(used) @ wanted, atol=1e-9)
        given_back = leaves(wrench_of(airframe, tuple(lengths.tolist()), thrusts))
        np.testing.assert_allclose(given_back, wanted, atol=1e-10)
        np.testing.assert_allclose(given_back, b @ np.array(thrusts), atol=1e-12)


@pytest.mark.parametrize("name", CASES)
def test_limited_thrusts_keep_roll_and_pitch(name: str) -> None:
    """Lift and yaw give way; what does not lift stays still, but for 1e-9 of the lift."""
    given, lifting = CASES[name]
    craft, rng = Vehicle.model_validate(given), np.random.default_rng(52)
    airframe, tight = craft.airframe(), 0
    table = mixer(airframe, craft.lengths())
    for _ in range(100):
        wanted = Wrench(float(rng.uniform(0.5, 14.0)), Vec(*rng.normal(0.0, 0.15, 3).tolist()))
        thrusts = np.array(rotor_thrusts(table, 0.0, 2.5, wanted, 100.0))
        assert (thrusts >= 0.0).all()
        assert (thrusts <= 2.5).all()
        assert (thrusts[lifting:] <= 2e-8).all()
        moment = wrench_of(airframe, craft.lengths(), tuple(thrusts.tolist())).moment
        assert (moment.x, moment.y) == pytest.approx((wanted.moment.x, wanted.moment.y), abs=1e-7)
        free = np.array(allocation(table, wanted))
        tight += bool((free > 2.5).any() or (free < 0.0).any())
    assert tight > 20


# -- hover -----------------------------------------------------------------------------------------


def test_hover_is_shared_by_those_that_lift() -> None:
    craft = vehicle([*canted(TILT), PUSHER])
    weight = craft.mass * 9.81
    shares = craft.hover_thrusts(weight)
    assert shares[:6] == pytest.approx([weight / (6.0 * math.cos(TILT))] * 6)
    assert shares[6] == 0.0
    lifted = wrench_matrix(craft.rotors, craft.arms)[2] @ np.array(shares)
    assert lifted == pytest.approx(weight)
    assert craft.lift == pytest.approx(6.0 * math.cos(TILT))


def test_tilt_costs_power_and_payload() -> None:
    """Of each rotor T^1.5 by momentum theory, at T = m g/(n cos tilt)."""
    power = {"max_thrust": 2.5, "disk_radius": 0.0635, "figure_of_merit": 0.5}
    flat, tilted = (vehicle(canted(tilt), propulsion=power) for tilt in (0.0, TILT))
    assert hover_power(tilted) / hover_power(flat) == pytest.approx(math.cos(TILT) ** -1.5)
    both = [largest_payload(one) + one.mass for one in (tilted, flat)]
    assert both[0] / both[1] == pytest.approx(math.cos(TILT))


def test_balance_in_hover() -> None:
    """Canted by turns: none; all forwards: as much as the tangent; one pair apart: its lever."""
    assert max(hover_balance(vehicle(canted(TILT)))) < 1e-12
    forwards = [{**one, "axis": [math.tan(0.1), 0.0, 1.0]} for one in of_each_arm(6)]
    assert hover_balance(vehicle(forwards)).sideways == pytest.approx(math.tan(0.1))
    off = [{"on": "body", "position": [0.02, 0.0, 0.05], "spin": spin} for spin in (-1, 1)]
    off[1]["position"] = [0.02, 0.0, -0.05]
    found = hover_balance(vehicle(off))
    assert found.tilting == pytest.approx(0.02)
    assert found.turning == pytest.approx(0.0, abs=1e-15)


def check_of(rotors: list[dict[str, Any]], **more: Any) -> tuple[dict[str, float], str]:
    scenario = Scenario(vehicle=vehicle_with(rotors, **more))
    numbers = {one.name: one.value for one in derived_numbers(scenario)}
    return numbers, " ".join(check_warnings(scenario))


def test_the_check_tells_of_rotors() -> None:
    numbers, warnings = check_of([*canted(TILT), PUSHER])
    assert numbers["rotors that lift"] == 6.0
    assert numbers["lift per thrust"] == pytest.approx(math.cos(TILT))
    assert numbers["hover side force"] < 1e-12
    assert warnings == ""
    forwards = [{**one, "axis": [math.tan(0.1), 0.0, 1.0]} for one in of_each_arm(6)]
    numbers, warnings = check_of(forwards)
    assert numbers["hover side force"] == pytest.approx(math.tan(0.1))
    assert "sideways with 10 % of the weight" in warnings
    numbers, warnings = check_of([PUSHER])
    assert numbers["rotors that lift"] == 0.0
    assert "hover thrust share" not in numbers
    assert "cannot hover" in warnings
    _, warnings = check_of(of_each_arm(2))
    assert "hover takes 114 % of the maximum thrust: the vehicle cannot hover" in warnings


# -- the lab ---------------------------------------------------------------------------------------


def test_the_lab_keeps_their_number_and_turns_them_with_the_arms() -> None:
    given = vehicle_with([*canted(TILT), PUSHER])
    craft = Vehicle.model_validate(given)
    assert "listed one by one" in why_fixed_count(craft)
    assert is_balanced(vehicle(canted(TILT)))
    assert not is_balanced(vehicle(of_each_arm(3)))
    assert not is_balanced(vehicle([PUSHER]))
    changes = list(arm_changes(craft, 6, 30.0))
    turned = Vehicle.model_validate(changed_vehicle(given, changes))
    c, s = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
    about = np.kron(np.eye(2), np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]))
    before, after = (wrench_matrix(one.rotors, one.arms) for one in (craft, turned))
    np.testing.assert_allclose(after, about @ before, atol=1e-12)


# -- discs, guards, reactions ----------------------------------------------------------------------


def test_a_tilted_disc_is_where_its_rotor_is() -> None:
    """Of an upright one at a height, a pusher across x, and one tilted; at a wall and the ground."""
    rotors = [
        {"on": 1, "position": [0.0, 0.0, 0.1]},
        {"on": "body", "position": [0.1, 0.0, 0.0], "axis": [1.0, 0.0, 0.0]},
        {"on": "body", "position": [0.0, 0.1, 0.0], "axis": [1.0, 0.0, 1.0]},
    ]
    craft = vehicle(
        rotors, propulsion={"max_thrust": 2.0, "disk_radius": 0.05, "disk_height": 0.01}
    )
    wall = {"type": "wall", "distance": 2.0, "surface": springback.WALL}
    slanted = 0.05 / math.sqrt(2.0)
    lift = 0.01 / math.sqrt(2.0)
    wanted = {
        "wall": [2.0 - 0.165 - 0.05, 2.0 - 0.11, 2.0 - slanted - lift],
        "ground": [1.11, 1.0 - 0.05, 1.0 - slanted + lift],
    }
    for one in nonempty([{"type": "ground", "surface": springback.WALL}, wall]):
        model = Scenario(vehicle=craft, world={"obstacles": [one]}).flight_model()
        state = still_state(craft.lengths())._replace(position=Vec(0.0, 0.0, 1.0))
        found = propeller_gaps(model.airframe, model.world, state, 1.0)
        assert found == pytest.approx(wanted[one["type"]], abs=2e-3)
    turn = Quat(math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))  # yaw 90 deg: body x is world y
    turned = propeller_gaps(model.airframe, model.world, state._replace(attitude=turn), 1.0)
    assert turned == pytest.approx([2.0 - 0.05, 2.0 - 0.05, 2.0 + 0.1 - 0.05], abs=2e-3)


def test_the_guard_of_a_rotor_is_that_of_its_arm() -> None:
    class Seen:
        def __init__(self, normal: float) -> None:
            self.normal, self.impulsive = normal, 0.0

    rotors = vehicle([{"on": 3}, PUSHER, {"on": 1}, *coaxial(1)]).airframe().rotors
    views = tuple(Seen(10.0 * j) for j in range(1, 7))
    assert [one.normal for one in guards_of(rotors, views)] == [30.0, 0.0, 10.0, 10.0, 10.0]
    assert guards_of((), views) is views


def test_rotors_that_stop_turn_the_body_about_their_own_axes() -> None:
    """One number for each, about its axis; the moment of a pusher is along x."""
    stop = StopSettings(guard_force=9.0, rotor_inertia=2e-5, thrust_coefficient=8e-6).stop(
        1e-3, True
    )
    airframe = vehicle([{"on": 1, "spin": 1}, {**PUSHER, "spin": -1}]).airframe()
    (each,) = reactions_of(airframe.rotors, airframe.arms, (2.0, 2.0), (0.0, 2.0), stop)
    assert each == pytest.approx((-2e-5 * 500.0 / 1e-3, 0.0))
    (each,) = reactions_of(airframe.rotors, airframe.arms, (2.0, 2.0), (2.0, 0.0), stop)
    assert each == pytest.approx((0.0, 2e-5 * 500.0 / 1e-3))
