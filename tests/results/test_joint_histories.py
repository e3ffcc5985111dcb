"""Histories of vehicles whose arms are on joints: energies and turning, against other ways."""

import re
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from springback.dynamics.energy import energy
from springback.kernels.vectors import Quat, Vec
from springback.results.energy_history import HELD, LOST, ledger
from springback.results.flight import Flight, fly
from springback.results.motion import angular_acceleration
from springback.vehicle.arms.bent import BentArm, BentCoordinates, bent_pose
from springback.vehicle.arms.joints import joint_pose
from springback.vehicle.arms.paths import arm_path, free_end_along
from springback.vehicle.library import ARQ
from springback.vehicle.state import Bend, State

HINGE = {
    "type": "hinge", "position": [0.06, 0.01, 0.01], "axis": [0.3, 0.5, 0.8],
    "travel": ["-5 deg", "4 deg"], "stiffness": "4 N m/rad", "quadratic": 5.0, "damping": 0.02,
    "play": "1 deg",
}  # fmt: skip
SLIDE = {
    "type": "slide", "direction": [-1.0, 0.0, 1.0], "travel": [0.0, 0.012], "damping": 10.0,
    "table": [[0.0, 0.0], [0.004, 4.0], [0.02, 90.0]], "preload": 3.0,
}  # fmt: skip
SECOND = {
    "type": "hinge", "position": [0.08, 0.0, 0.0], "axis": [0.1, 1.0, -0.2],
    "travel": ["-3 deg", "3 deg"], "stiffness": "2 N m/rad", "damping": 0.02,
}  # fmt: skip
JOINTS = {"hinge": HINGE, "slide": SLIDE, "hinges": {**HINGE, "second": SECOND}}


def tables(joint: dict[str, Any]) -> dict[str, Any]:
    angles = ["45 deg", "135 deg", "225 deg", "315 deg"]
    arms = {"directions": angles, "length": 0.19, "mass": 0.05, "cage_radius": 0.11,
            "height": 0.02, "joint": joint}  # fmt: skip
    return {
        "vehicle": {"body": {"mass": 1.0, "inertia": [0.008, 0.009, 0.016]}, "arms": arms},
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.66, 0.0, 1.0], "velocity": [2.0, 0.1, 0.0],
                  "pitch": 0.2, "roll": 0.1},
        "thrust": 3.0, "simulation": {"duration": 0.12},
    }  # fmt: skip


@pytest.fixture(scope="module", params=["hinge", "slide", "hinges"])
def flight(request: pytest.FixtureRequest) -> Flight:
    return fly(tables(JOINTS[request.param]))


def state_at(flight: Flight, k: int) -> State:
    c = {name: float(values[k]) for name, values in flight.columns.items()}
    return State(
        Vec(c["x"], c["y"], c["z"]), Quat(c["qw"], c["qx"], c["qy"], c["qz"]),
        Vec(c["vx"], c["vy"], c["vz"]), Vec(c["wx"], c["wy"], c["wz"]),
        tuple(c[f"l{j}"] for j in range(1, 5)), tuple(c[f"dl{j}"] for j in range(1, 5)),
        bends=tuple(Bend(c[f"bend{j}"], c[f"dbend{j}"]) for j in range(1, 5) if "bend1" in c),
    )  # fmt: skip


def path_of(arm: Any, length: float, way: float) -> tuple[Any, Any, Any]:
    """By the equations: end of an arm, its direction, and how what is there is turned."""
    if isinstance(arm, BentArm):
        bent = bent_pose(arm, BentCoordinates(length, way), 0.0)
        return bent.end, bent.first, bent.turn
    there = joint_pose(arm, length, 0.0)
    return there.end, there.direction, there.turn


def test_paths_of_many_lengths_are_those_of_the_equations(flight: Flight) -> None:
    arms = flight.scenario.flight_model().airframe.arms
    lengths, ways = np.linspace(0.15, 0.23, 9), np.linspace(0.03, -0.05, 9)
    for arm in (arms[0], arms[2]):
        path = arm_path(arm, lengths, ways)
        for k in (0, 3, 4, 8):
            end, direction, turn = path_of(arm, float(lengths[k]), float(ways[k]))
            assert path.end[k] == pytest.approx(tuple(end), abs=1e-15), k
            assert path.direction[k] == pytest.approx(tuple(direction), abs=1e-15), k
            assert path.turn[k] == pytest.approx(np.array(turn), abs=1e-15), k
        along, free = Vec(0.6, 0.0, 0.8), arm_path(arm, lengths).end[4]
        assert free_end_along(arm, along) == pytest.approx(free @ [0.6, 0.0, 0.8])


def test_the_path_of_an_arm_in_the_plane_is_its_direction() -> None:
    arm, lengths = ARQ.vehicle.airframe().arms[0], np.array([0.1, 0.19])
    path = arm_path(arm, lengths)
    assert (path.end == lengths[:, None] * np.array([arm.cosine, arm.sine, 0.0])).all()
    assert (path.turn == np.eye(3)).all()
    assert free_end_along(arm, Vec(1.0, 0.0, 0.0)) == arm.length * arm.cosine


def test_every_part_held_is_what_the_laws_say(flight: Flight) -> None:
    books, model = ledger(flight), flight.scenario.flight_model()
    start = energy(model.airframe, model.world, model.contact_point, state_at(flight, 0))
    moved = np.flatnonzero(flight.columns["dl1"])
    for k in (0, int(moved[10]), int(moved[len(moved) // 2]), len(flight.t) - 1):
        now = energy(model.airframe, model.world, model.contact_point, state_at(flight, k))
        told = {name: books[f"energy_{name}"][k] for name in now._fields}
        wanted = now._replace(gravity=now.gravity - start.gravity)._asdict()
        assert told == pytest.approx(wanted, abs=1e-6 * start.kinetic), k
    for name in ("energy_springs", "energy_stops", "energy_contact"):
        assert np.ptp(books[name]) > 1e-3, name


def test_what_is_held_and_lost_is_what_was_there_and_put_in(flight: Flight) -> None:
    books = ledger(flight)
    held, lost = (sum(books[name] for name in names) for names in (HELD, LOST))
    left = held + lost - books["work_thrust"] - held[0]
    assert np.abs(left).max() < 1e-6 * held[0]


def test_the_kinetic_energy_is_that_of_its_points(flight: Flight) -> None:
    """From differences of the places of the ends in the world, not from the arms' kinematics."""
    c, t, airframe = flight.columns, flight.t, flight.scenario.flight_model().airframe
    attitude = np.stack([c[f"q{p}"] for p in "wxyz"], 1)
    turn = Rotation.from_quat(attitude, scalar_first=True)
    place, spin = (np.stack([c[f"{s}{a}"] for a in "xyz"], 1) for s in ("", "w"))
    velocity = np.stack([c[f"v{a}"] for a in "xyz"], 1)
    inertia = np.array(airframe.inertia)
    whole = 0.5 * np.einsum("ti,ij,tj->t", spin, inertia, spin) + 0.5 * np.sum(velocity**2, 1)
    middle = 0.5 * (whole[1:] + whole[:-1])
    for j, arm in enumerate(airframe.arms, start=1):
        end = place + turn.apply(arm_path(arm, c[f"l{j}"], c.get(f"bend{j}")).end)
        speed = np.diff(end, axis=0) / np.diff(t)[:, None]
        middle = middle + 0.5 * arm.mass * np.sum(speed**2, 1)
    books, fine = ledger(flight), np.diff(t) < 1.5e-4
    told = books["energy_kinetic"]
    assert fine.sum() > 100
    error = np.abs(middle - 0.5 * (told[1:] + told[:-1]))[fine]
    assert error.max() < 1e-3 * told[0]


def differences(flight: Flight) -> tuple[Any, Any, Any]:
    """Of the angular velocity, and of the same from the angular acceleration; steps [s]."""
    c, step = flight.columns, np.diff(flight.t)
    alpha = angular_acceleration(flight)
    spin = np.stack([c[f"w{axis}"] for axis in "xyz"], 1)
    return np.diff(spin, axis=0) / step[:, None], 0.5 * (alpha[1:] + alpha[:-1]), step


def test_the_angular_acceleration_is_the_change_of_the_angular_velocity(flight: Flight) -> None:
    """But for the step to the touch, at which the arms are released and it jumps."""
    seen, told, step = differences(flight)
    touch = flight.measures["touch_time"]
    assert touch is not None
    chosen = (step < 1.5e-4) & (np.abs(flight.t[1:] - touch) > 1e-9)
    assert chosen.sum() > 100
    assert np.abs(seen).max() > 50.0
    assert np.abs(seen - told)[chosen].max() < 0.005 * np.abs(seen).max()


def test_locked_arms_do_not_turn_the_body(flight: Flight) -> None:
    """Before the touch they are locked: what they would do if they were not is not told."""
    touch = flight.measures["touch_time"]
    assert touch is not None
    before = flight.t < touch - 1e-9
    assert before.sum() > 5
    assert np.abs(angular_acceleration(flight)[before]).max() < 1e-9


def test_a_hinge_that_breaks_is_told_by_its_torque() -> None:
    """In N m, as the limit was given; a force along the path, where that was."""
    given = tables(HINGE)
    given["vehicle"]["limits"] = {"hinge_torque": "0.4 N m"}
    [first, *_] = fly(given).broken_parts
    assert re.match(r"hinge of arm \d at 0\.\d+ s: more than 0\.4 N m", first), first
    given["vehicle"]["limits"] = {"arm_force": "3 N"}
    [first, *_] = fly(given).broken_parts
    assert re.match(r"arm \d at 0\.\d+ s: more than 3 N", first), first


def test_of_two_joints_the_one_that_breaks_is_told_as_its_limit_was_given() -> None:
    """It was a force along the path of the first, 70.6 N, that nobody had entered."""
    given = tables(JOINTS["hinges"])
    given["vehicle"]["limits"] = {"hinge_torque": "0.4 N m"}
    [first, *_] = fly(given).broken_parts
    assert re.match(r"(first|second) hinge of arm \d at 0\.\d+ s: more than 0\.4 N m", first), first
