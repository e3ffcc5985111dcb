"""Whole hits of a shell and of a ring in their bearings: beside Pinocchio, mirrored and turned."""

from __future__ import annotations

import functools
import importlib
from dataclasses import replace
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from oracles.models import Wall
from springback.results.flight import Flight, as_scenario, fly
from springback.scenario.model import RING_ROUNDING

Array = NDArray[np.float64]

RADIUS, MASS = 0.2, 0.1  # of what turns [m], [kg]
DAMPING, FRICTION = 1e-3, 2e-3  # of its bearings, viscous [N m s] and dry [N m]
#: What turns: its table, its mass there, the hull, and how it spins at the start [rad/s].
TURNING: dict[str, tuple[str, str, dict[str, Any], list[float]]] = {
    "shell": (
        "gimbal", "shell_mass", {"type": "sphere", "position": [0.02, 0.01, 0.03]}, [5, 3, -4],
    ),
    "ring": (
        "bearing", "ring_mass",
        {"type": "ring", "position": [0.02, 0.01, 0.03], "axis": [0.15, -0.1, 1.0]},
        [1.5, -1.0, 10.0],
    ),
}  # fmt: skip
#: Body to world at the start.
ATTITUDE = np.asarray(Rotation.from_euler("ZYX", [0.3, 0.2, 0.1]).as_quat(scalar_first=True))
NORMAL = np.array([-0.9, -0.3, 0.1]) / np.linalg.norm([0.9, 0.3, 0.1])
FACE = np.array([1.0, 0.2, 1.0])  # a point of the wall [m]
SURFACE = {"stiffness": 3e6, "dissipation": 0.3, "friction": 0.5, "slip_speed": 0.1}
UNTIL = 0.012

ACROSS = np.array([1.0, -1.0, 1.0])  # of a place or a velocity when y → −y
AROUND = -ACROSS  # of a rotation

turning = pytest.mark.parametrize("name", TURNING)


def tables(name: str) -> dict[str, Any]:
    """An oblique, spinning hit at 2.3 m/s, from just before the touch on."""
    joint, mass, hull, spin = TURNING[name]
    bearings = {mass: MASS, "damping": DAMPING, "friction": FRICTION}
    wall = {"type": "wall", "position": FACE.tolist(), "normal": NORMAL.tolist()}
    return {
        "vehicle": {
            "preset": "caged-sphere", "hulls": [{**hull, "radius": RADIUS, joint: bearings}],
        },
        "world": {"gravity": 0, "obstacles": [{**wall, "surface": SURFACE}]},
        "start": {
            "position": [0.0, 0.0, 1.0], "velocity": [2.0, 1.0, 0.5],
            "quaternion": ATTITUDE.tolist(), "angular_velocity": [1.0, -2.0, 1.5],
            "shell_spin": spin, "touch_distance": 1e-4,
        },
        "simulation": {"duration": UNTIL},
    }  # fmt: skip


def mirrored(given: dict[str, Any]) -> dict[str, Any]:
    """Everything seen in a mirror, y → −y."""
    [hull], [wall], start = given["vehicle"]["hulls"], given["world"]["obstacles"], given["start"]
    for table, key in (
        (hull, "position"), (hull, "axis"), (wall, "position"), (wall, "normal"),
        (start, "position"), (start, "velocity"),
    ):  # fmt: skip
        if key in table:
            table[key] = (table[key] * ACROSS).tolist()
    for key in ("angular_velocity", "shell_spin"):
        start[key] = (start[key] * AROUND).tolist()
    start["quaternion"] = (start["quaternion"] * np.array([1.0, *AROUND])).tolist()
    return given


def turned(given: dict[str, Any], by: Rotation) -> dict[str, Any]:
    """The whole scene turned about the origin of the world."""
    [wall], start = given["world"]["obstacles"], given["start"]
    for table, key in (
        (wall, "position"), (wall, "normal"), (start, "position"), (start, "velocity"),
    ):  # fmt: skip
        table[key] = by.apply(table[key]).tolist()
    attitude = by * Rotation.from_quat(start["quaternion"], scalar_first=True)
    start["quaternion"] = attitude.as_quat(scalar_first=True).tolist()
    return given


class Motion(NamedTuple):
    """Of the vehicle and of what turns, at one instant."""

    position: Array  # world
    rotation: Array  # body to world, shape (3, 3)
    velocity: Array  # world
    omega: Array  # body
    spin: Array  # of what turns, world; of a ring, its part along the axis


def motion(flight: Flight, at: int) -> Motion:
    """At one sample of a flight."""

    def vector(*names: str) -> Array:
        return np.array([flight.columns[name][at] for name in names])

    attitude = Rotation.from_quat(vector("qw", "qx", "qy", "qz"), scalar_first=True)
    return Motion(
        vector("x", "y", "z"), np.asarray(attitude.as_matrix()), vector("vx", "vy", "vz"),
        vector("wx", "wy", "wz"), vector("shell_wx", "shell_wy", "shell_wz"),
    )  # fmt: skip


def hit(given: dict[str, Any]) -> Flight:
    """A flight that has touched the wall and left it."""
    flight = fly(given, executor="python")
    assert flight.measures["contacts"] == 1.0
    assert flight.columns["fn_body"].max() > 100.0
    assert flight.columns["fn_body"][-1] == 0.0
    return flight


@functools.cache
def first_hit(name: str) -> Flight:
    """As it is, neither mirrored nor turned."""
    return hit(tables(name))


def assert_same(ours: Motion, theirs: Motion, places: float, speeds: float) -> None:
    """Two states agree, by places [m], axes, and speeds [m/s, rad/s]."""
    for name, a, b in zip(Motion._fields, ours, theirs, strict=True):
        within = places if name in ("position", "rotation") else speeds
        np.testing.assert_allclose(a, b, rtol=0, atol=within, err_msg=name)


@turning
def test_hits_are_those_of_pinocchio(name: str) -> None:
    """Two bodies on a joint, with the force of the wall and the friction of bearings by formula.

    Measured: places to 3 nm, speeds to 4e-6 rad/s, by the engine's equal steps across the touch.
    """
    pytest.importorskip("mujoco")
    pytest.importorskip("pinocchio")
    oracle: ModuleType = importlib.import_module("oracles.bearings_pinocchio")
    given = tables(name)
    flight = first_hit(name)
    start, end = motion(flight, 0), motion(flight, -1)
    body = as_scenario(given).vehicle.body
    centre = np.array(given["vehicle"]["hulls"][0]["position"])
    whole, r = np.array(body.inertia), start.rotation
    craft: Any
    if name == "shell":
        own = 2.0 / 3.0 * MASS * RADIUS**2
        craft = oracle.ShellCraft(body.mass - MASS, whole, MASS, own, centre, DAMPING, 0.0)
        spin: Any = start.spin
    else:
        axis = np.array(given["vehicle"]["hulls"][0]["axis"])
        axis /= np.linalg.norm(axis)
        craft = oracle.RingCraft(body.mass - MASS, whole, MASS, RADIUS, centre, axis, DAMPING, 0.0)
        spin = float(start.spin @ r @ axis)
    # Users give the inertia of everything, about the common centre of mass.
    craft = replace(craft, inertia=whole - (craft.together - craft.inertia))
    wall = Wall(
        NORMAL, float(NORMAL @ FACE), SURFACE["stiffness"], 1.5 * SURFACE["dissipation"],
        SURFACE["friction"], SURFACE["slip_speed"],
    )  # fmt: skip
    kind = oracle.ShellPose if name == "shell" else oracle.RingPose
    begin = kind(ATTITUDE, start.velocity, start.omega, spin)
    place, there = oracle.InPinocchio(craft, FRICTION, RING_ROUNDING).fly(
        begin, start.position, wall, until=UNTIL, step=2.5e-5
    )
    spun = there.spin if name == "shell" else there.spin * (there.rotation @ craft.axis)
    theirs = Motion(place, there.rotation, there.velocity, there.omega, spun)
    assert np.linalg.norm(end.spin - start.spin) > 1.0
    assert_same(end, theirs, 1e-7, 2e-5)


@turning
def test_mirrored_and_turned_hits(name: str) -> None:
    """y → −y; vehicle and wall turned together, any way.

    What turns gains 1e5 rad/s² in the hit: rounding moves the touch by some 1e-13 s, and its speed
    by 1e-8 rad/s.  Measured: in the mirror bit by bit, turned to 1e-9 rad/s (spins at 6e-9 with
    another turn).
    """
    end = motion(first_hit(name), -1)
    seen = motion(hit(mirrored(tables(name))), -1)
    expected = Motion(
        end.position * ACROSS, end.rotation * np.outer(ACROSS, ACROSS), end.velocity * ACROSS,
        end.omega * AROUND, end.spin * AROUND,
    )  # fmt: skip
    assert_same(seen, expected, 1e-10, 2e-8)
    by = Rotation.random(rng=np.random.default_rng(17))
    seen = motion(hit(turned(tables(name), by)), -1)
    expected = Motion(
        by.apply(end.position), by.as_matrix() @ end.rotation, by.apply(end.velocity),
        end.omega, by.apply(end.spin),
    )  # fmt: skip
    assert_same(seen, expected, 1e-10, 2e-8)
