"""Vehicles of other authors: they fly, touch by what their authors built, and say their sources."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.kernels.vectors import Quat, Vec, rotation
from springback.results.flight import Flight, fly
from springback.simulation.measuring.measures import Outcome
from springback.vehicle.arms.bent import BentCoordinates
from springback.vehicle.library import OF_OTHERS, VEHICLES
from springback.vehicle.state import arm_pose

NAMES = [entry.vehicle.name for entry in OF_OTHERS]
WALL = {"type": "wall", "distance": 1.0, "surface": "wall"}


def into_a_wall(name: str, **start: Any) -> dict[str, Any]:
    """Without gravity and thrust, 0.1 mm in front of a wall."""
    return {
        "vehicle": name,
        "world": {"gravity": 0.0, "obstacles": [WALL]},
        "start": {
            "position": [0.0, 0.0, 1.0], "velocity": [1.5, 0.0, 0.0], "touch_distance": 1e-4, **start,
        },
        "simulation": {"duration": 0.003},
    }  # fmt: skip


def momentum_of(flight: Flight) -> float:
    """Momentum along X at the end, of the main body and of the ends of its arms [kg m/s]."""
    c, vehicle = flight.columns, flight.scenario.vehicle
    r = rotation(Quat(*(float(c[f"q{part}"][-1]) for part in "wxyz")))
    speed, omega = (Vec(*(float(c[f"{stem}{axis}"][-1]) for axis in "xyz")) for stem in "vw")
    total = vehicle.body.mass * speed.x
    for j, arm in enumerate(vehicle.airframe().arms, start=1):
        at: list[Any] = [float(c[f"{kind}{j}"][-1]) for kind in ("l", "dl")]
        if f"bend{j}" in c:
            ends = [float(c[f"{kind}{j}"][-1]) for kind in ("bend", "dbend")]
            at = [BentCoordinates(*both) for both in zip(at, ends, strict=True)]
        pose = arm_pose(arm, *at, speed @ r)
        total += arm.mass * (r @ (pose.sliding + (omega ^ pose.lever))).x
    return total


@pytest.mark.parametrize("name", NAMES)
def test_it_touches_a_wall_and_is_pushed_back(name: str) -> None:
    """In plain Python: momentum is what the wall gives, and the ledger closes."""
    flight = fly(into_a_wall(name), executor="python")
    m = flight.measures
    assert m["touch_speed"] == pytest.approx(1.5, rel=1e-6)
    given = momentum_of(flight) - 1.5 * flight.scenario.vehicle.mass
    assert given < 0.0
    assert m["impulse_x"] == pytest.approx(given, rel=1e-4)
    assert abs(m["ledger_residual"] or 0.0) < 1e-5


def test_bumpers_touch_where_they_are() -> None:
    """Tilted inward and above the middle: at a wall the two front ones are pressed, pitching it up.

    A ring of radius r, tilted by t, reaches r cos t ahead of its centre, 24 mm above the middle,
    so that the push of the wall turns the robot's nose up: a negative rate about the left.
    """
    flight = fly(into_a_wall("spiri"), executor="python")
    c = flight.columns
    assert min(c["fn1"].max(), c["fn2"].max()) > 0.0
    assert max(c["fn3"].max(), c["fn4"].max()) == 0.0
    ahead = 1.0 - c["x"][0] - 1e-4
    tilt = np.radians(11.0)
    assert 0.132 + 0.11 * np.cos(tilt) <= ahead <= 0.132 + 0.11
    assert c["wy"][-1] < 0.0


def test_circles_that_are_no_cages_touch_nothing() -> None:
    """The sphere of 0.2 m alone meets the wall."""
    flight = fly(into_a_wall("caged-sphere", yaw=0.4), executor="python")
    c = flight.columns
    assert c["x"][0] == pytest.approx(1.0 - 0.2 - 1e-4, abs=1e-6)
    assert max(c[f"fn{j}"].max() for j in range(1, 5)) == 0.0
    assert c["fn_body"].max() > 0.0


def test_a_gimbal_that_holds_makes_it_the_fixed_sphere() -> None:
    """The shell's inertia is taken off the body's: together they are the vehicle without a gimbal.

    The way there goes as one over the damping of the bearings.
    """
    # Obliquely, with friction, so that the wall turns it.
    hit = {"velocity": [1.5, 0.8, 0.4]}
    ends = []
    for damping in (None, 5.0, 50.0):
        tables = into_a_wall("caged-sphere", **hit)
        if damping is not None:
            tables = into_a_wall("caged-sphere-gimbal", **hit)
            hull = VEHICLES["caged-sphere-gimbal"].vehicle.hulls[0]
            shell = hull.model_dump(exclude_none=True)
            shell["gimbal"]["damping"] = damping
            tables["vehicle"] = {"preset": "caged-sphere-gimbal", "hulls": [shell]}
        tables["world"]["obstacles"] = [{**WALL, "surface": {"preset": "wall", "friction": 0.5}}]
        tables["simulation"]["duration"] = 0.02
        flight = fly(tables, executor="python")
        ends.append(np.array([flight.columns[f"w{axis}"][-1] for axis in "xyz"]))
    fixed, loose, held = ends
    turning = np.abs(fixed).max()
    assert turning > 1.0
    assert np.abs(held - fixed).max() < 0.01 * turning
    assert np.abs(loose - fixed).max() > 5.0 * np.abs(held - fixed).max()


def test_a_pilot_recovers_with_the_sphere_in_its_gimbal() -> None:
    """Into a wall turned by 20 degrees, at 3 m/s: the shell is turned by it, and the ledger closes."""
    wall = {
        "type": "wall", "position": [3.0, 0.0, 0.0], "normal": [-np.cos(0.35), np.sin(0.35), 0.0],
        "surface": {"preset": "wall", "friction": 0.5},
    }  # fmt: skip
    tables = {
        "vehicle": "caged-sphere-gimbal",
        "world": {"obstacles": [wall]},
        "reference": {"type": "run-up", "speed": 3.0},
        "recovery": {},
        "simulation": {"duration": 6.0},
    }
    flight = fly(tables)
    assert flight.outcome is Outcome.RECOVERED
    spin = np.array([flight.columns[f"shell_w{axis}"] for axis in "xyz"])
    assert np.abs(spin[2]).max() > 3.0
    assert np.abs(spin[:2]).max() < np.abs(spin[2]).max()
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_each_carries_itself() -> None:
    """Thrust for twice the weight, or what is published; moments that a body can have."""
    for name in nonempty(NAMES):
        vehicle = VEHICLES[name].vehicle
        assert vehicle.propulsion is not None
        lift = 4.0 * vehicle.propulsion.max_thrust / (9.81 * vehicle.mass)
        assert 1.9 < lift < 3.5, name
        x, y, z = np.diag(np.array(vehicle.body.inertia))
        assert max(x, y, z) <= x + y + z - max(x, y, z), name


def test_every_field_that_is_set_has_a_source() -> None:
    for entry in nonempty(OF_OTHERS):
        given = {"body.mass", "body.inertia", "arms.directions", "arms.length", "arms.cage_radius",
                 "arms.mass", "arms.torque_ratio", "propulsion.max_thrust"}  # fmt: skip
        given |= {"arms.joint"} if entry.vehicle.arms.joint else set()
        given |= {"hulls"} if entry.vehicle.hulls else set()
        given |= {"hull.radius"} if entry.vehicle.hull else set()
        given |= set() if entry.vehicle.arms.cages else {"arms.cages"}
        assert given <= set(entry.sources), entry.vehicle.name


def test_one_arm_of_s_arq_yields_and_weighs_four_percent_more() -> None:
    """Over Quad without its battery; arms in balance, so that it hovers level."""
    robot, frame = VEHICLES["s-arq"].vehicle, VEHICLES["quad"].vehicle
    battery = 0.37
    assert (robot.mass - battery) / (frame.mass - battery) == pytest.approx(1.04)
    assert robot.inertia() == pytest.approx(1.04 * frame.inertia(), abs=1e-12)
    assert [arm.compliance for arm in robot.airframe().arms] == [1.0, 0.0, 0.0, 0.0]


def test_the_arm_of_s_arq_takes_about_half_of_the_peak_off() -> None:
    """49 % at 1.5 m/s; its authors tell of some 40 %, of which the sense is meant, and the size."""
    peaks = []
    for name in ("quad", "s-arq"):
        given = into_a_wall(name, yaw=-np.pi / 4) | {"simulation": {"duration": 0.05}}
        peaks.append(fly(given, executor="python").measures["impact_peak_acceleration"])
    rigid, soft = peaks
    assert 0.3 < 1.0 - soft / rigid < 0.6
