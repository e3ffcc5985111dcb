"""Rotors that a vehicle lists, in flight: the ledger, the executors, pilots, files and pictures."""

from __future__ import annotations

import copy
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from builders.impacts import value
from builders.listed_rotors import canted, coaxial, vehicle_with
from springback.batch.scenarios import fly_scenarios
from springback.interfaces.animation import bodies
from springback.interfaces.replay.scene import plain, scene_of
from springback.kernels.vectors import Vec
from springback.results.flight import Flight, fly
from springback.results.motion import angular_acceleration
from springback.results.saved import load
from springback.vehicle.parameters import Vehicle
from springback.vehicle.placed.rotors import poses_at

WALL = {"type": "wall", "distance": 0.6, "surface": "wall"}
FOLDING = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0.2, 0.3, 1],
    "travel": ["-60 deg", "60 deg"], "stiffness": "5 N m/rad", "damping": "0.02 N m s/rad",
}  # fmt: skip
TILT = math.radians(20.0)


def impact(hinged: bool, **simulation: Any) -> dict[str, Any]:
    """Into a wall, one rotor on the body, two on an arm, one arm without."""
    rotors = canted(TILT)
    rotors[1] = {"on": 1, "position": [0.0, 0.0, -0.05], "axis": [0.1, -0.2, 0.9], "spin": 1}
    rotors[2] = {"on": "body", "position": [-0.1, 0.02, 0.05], "axis": [0.9, 0.1, 0.4]}
    given = vehicle_with(rotors)
    if hinged:
        del given["arms"]["stroke"]
        given["arms"] |= {"joint": FOLDING, "cages": True}
    return {
        "vehicle": given, "thrust": [0.9, 0.7, 0.6, 1.2, 1.1, 0.8],
        "world": {"obstacles": [WALL]},
        "start": {
            "position": [0.3, 0.0, 1.0], "velocity": [2.0, 0.3, 0.1], "pitch": 0.2, "roll": 0.1,
            "angular_velocity": [0.5, -1.0, 2.0],
        },
        "simulation": {"duration": 0.12, **simulation},
    }  # fmt: skip


def octocopter(**changes: Any) -> dict[str, Any]:
    """Two rotors on each of four arms, two legs without; it flies to a wall, which stops rotors."""
    stop = {"guard_force": 5.0, "others_after": 0.02, "rotor_inertia": 1e-6,
            "thrust_coefficient": 1e-6}  # fmt: skip
    given = vehicle_with(coaxial(), 4, 2)
    given["propulsion"]["stop"] = stop
    return {
        "vehicle": given, "reference": {"type": "hold", "position": [0.0, 0.0, 1.0]},
        "world": {"obstacles": [WALL]},
        "start": {"position": [0.2, 0.05, 1.0], "velocity": [0.2, 0.0, 0.0], "roll": 0.1},
        "simulation": {"duration": 3.0},
        **changes,
    }  # fmt: skip


TO_THE_WALL = {
    "start": {"position": [0.3, 0.1, 1.0], "velocity": [1.5, 0.0, 0.0]},
    "simulation": {"duration": 0.3},
}


@pytest.fixture(scope="module", params=[False, True], ids=["planar", "hinges"])
def struck(request: pytest.FixtureRequest) -> tuple[dict[str, Any], Flight]:
    given = impact(request.param)
    return given, fly(given)


def test_the_ledger_closes(struck: tuple[dict[str, Any], Flight]) -> None:
    """To 1e-6 of the energies, with rotors that do work on arms that move."""
    _, flight = struck
    assert flight.measures["contacts"] == 1.0
    assert value(flight, "impact_arm_stroke") > 1e-3
    assert abs(value(flight, "work_thrust")) > 1e-2
    assert abs(value(flight, "ledger_residual")) < 1e-6


def test_executors_agree_bit_for_bit(struck: tuple[dict[str, Any], Flight]) -> None:
    """Plain Python, compiled, and in lanes beside others of other axes and places."""
    given, flight = struck
    again = fly(given, executor="python")
    for name in nonempty(flight.columns):
        assert np.array_equal(flight.columns[name], again.columns[name]), name
    group = [given] + [copy.deepcopy(given) for _ in range(8)]
    for k, one in enumerate(group[1:], start=1):
        one["vehicle"]["rotors"][2]["axis"] = [0.9 - 0.05 * k, 0.1, 0.4]
        one["vehicle"]["rotors"][1]["position"] = [0.0, 0.01 * k, -0.05]
    together = fly_scenarios(group, threads=1)
    for k, alone in ((0, flight), (5, fly(group[5]))):
        for name, number in nonempty(alone.measures.items()):
            found = np.asarray(together.measures[name])[k]
            assert np.isnan(found) if number is None else found == number, name


def test_angular_accelerations_are_those_of_the_rates(
    struck: tuple[dict[str, Any], Flight],
) -> None:
    """By the equations, and by differences of the recorded rates in steps before the touch."""
    _, flight = struck
    alpha, t = angular_acceleration(flight), flight.t
    spin = np.stack([flight.columns[f"w{axis}"] for axis in "xyz"], axis=1)
    before = np.flatnonzero(t < value(flight, "touch_time") - 1e-3)[:-1]
    assert len(before) > 10
    step = np.diff(t)[before][:, None]
    middle = 0.5 * (alpha[before] + alpha[before + 1])
    assert np.abs(np.diff(spin, axis=0)[before] / step - middle).max() < 1e-2 * np.abs(alpha).max()


def test_they_are_drawn_where_the_equations_have_them(
    struck: tuple[dict[str, Any], Flight],
) -> None:
    _, flight = struck
    scene, airframe = scene_of(flight), flight.scenario.flight_model().airframe
    assert [one.arm for one in scene.rotors] == [0, 0, -1, 3, 4, 5]
    assert scene.thrust.shape[1] == len(plain(scene)["rotors"]) == 6
    k = int(np.argmax(np.ptp(scene.arm_length, axis=1)))
    now = bodies.pose(scene, float(scene.t[k]))
    lengths = tuple(scene.arm_length[k].tolist())
    poses = poses_at(airframe.rotors, airframe.arms, lengths)
    places = bodies.rotor_places(scene.rotors, bodies.end_places(scene.arms, now), now)
    for place, pose in nonempty(zip(places, poses, strict=True)):
        there = np.array(pose.mount.end) + np.array(pose.lever)
        assert place.position == pytest.approx(now.position + now.rotation @ there, abs=1e-12)
        assert place.thrust == pytest.approx(now.rotation @ np.array(pose.up), abs=1e-12)
        away = np.linalg.norm(place.disc - place.position, axis=1)
        assert away == pytest.approx(np.full(len(away), 0.0635))
        assert (place.disc - place.position) @ place.thrust == pytest.approx(0.0, abs=1e-12)


# -- pilots ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def hovering() -> Flight:
    return fly(octocopter())


@pytest.fixture(scope="module")
def stopped() -> Flight:
    return fly(octocopter(**TO_THE_WALL))


def at_rest(flight: Flight) -> None:
    last = Vec(*(float(flight.columns[axis][-1]) for axis in "xyz"))
    assert (last.x, last.y, last.z) == pytest.approx((0.0, 0.0, 1.0), abs=0.02)
    speed = max(abs(float(flight.columns[f"v{axis}"][-1])) for axis in "xyz")
    assert speed < 0.02


def test_a_coaxial_octocopter_hovers(hovering: Flight) -> None:
    """Eight rotors on four of six arms: each carries an eighth of the weight."""
    at_rest(hovering)
    weight = Vehicle.model_validate(octocopter()["vehicle"]).mass * 9.81
    last = [hovering.telemetry[f"thrust{j}"][-1] for j in range(1, 9)]
    assert last == pytest.approx([weight / 8.0] * 8, rel=0.02)
    assert "thrust9" not in hovering.telemetry
    assert abs(value(hovering, "ledger_residual")) < 1e-6


def test_a_canted_hexarotor_hovers_level_at_the_thrust_of_its_tilt() -> None:
    """Sideways forces cancel; each rotor gives m g/(6 cos tilt)."""
    given = octocopter(vehicle=vehicle_with(canted(TILT)), world={})
    flight = fly(given)
    at_rest(flight)
    weight = Vehicle.model_validate(given["vehicle"]).mass * 9.81
    last = [flight.telemetry[f"thrust{j}"][-1] for j in range(1, 7)]
    assert last == pytest.approx([weight / 6.0 / math.cos(TILT)] * 6, rel=0.02)
    assert float(flight.columns["qw"][-1]) > math.cos(math.radians(0.5))


def test_guards_and_discs_stop_all_eight(stopped: Flight) -> None:
    """The two rotors of the arm that hits at once, the others after 20 ms; the same in Python."""
    telemetry = stopped.telemetry
    first = value(stopped, "rotor_stop_time")
    when = [telemetry[f"stopped{j}"] for j in range(1, 9)]
    begins = [float(one[one >= 0.0][0]) for one in when]
    assert sorted(begins)[:2] == pytest.approx([first] * 2)
    assert sorted(begins)[2:] == pytest.approx([first + 0.02] * 6)
    assert begins[0] == begins[1] == min(begins)
    assert stopped.measures["rotors_stopped"] == 8.0
    again = fly(octocopter(**TO_THE_WALL), executor="python")
    for name in nonempty(telemetry):
        assert np.array_equal(telemetry[name], again.telemetry[name], equal_nan=True), name
    for name in nonempty(stopped.columns):
        assert np.array_equal(stopped.columns[name], again.columns[name]), name


def test_a_saved_flight_is_read_back(stopped: Flight, tmp_path: Path) -> None:
    stopped.save(tmp_path / "octo")
    read = load(tmp_path / "octo")
    assert read.scenario.vehicle == stopped.scenario.vehicle
    assert (read.telemetry["thrust8"] == stopped.telemetry["thrust8"]).all()
    assert (angular_acceleration(read) == angular_acceleration(stopped)).all()
