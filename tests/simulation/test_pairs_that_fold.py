"""Two vehicles of which arms fold, or shells turn: both feel one contact, whoever moves how."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import scipy

from builders.cases import nonempty
from springback.errors import InputError
from springback.results.energy_history import HELD, LOST, ledger
from springback.results.flight import Flight, fly
from springback.results.motion import angular_acceleration
from springback.results.pair.contacts import loads_on_first, loads_on_second

RADIAL = {"type": "slide", "travel": [0, "40 mm"], "stiffness": "5 N/mm", "damping": 20}
FOLDING = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0.2, 0.1, 1],
    "travel": ["-60 deg", "60 deg"], "stiffness": "5 N m/rad", "damping": "0.02 N m s/rad",
}  # fmt: skip
FLAPPING = {
    "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0.2],
    "travel": ["-30 deg", "60 deg"], "stiffness": "8 N m/rad", "damping": "0.02 N m s/rad",
}  # fmt: skip
BEARING = {"damping": 1e-3, "friction": 2e-3}
ROLLING = {
    "preset": "caged-sphere",
    "hulls": [{"type": "sphere", "radius": 0.2, "position": [0.01, 0, 0.02],
               "gimbal": {"shell_mass": 0.15, **BEARING}}],
}  # fmt: skip
RINGED = {
    "preset": "caged-sphere",
    "hulls": [{"type": "ring", "radius": 0.2, "position": [0.01, 0, 0.02],
               "axis": [0.15, -0.1, 1], "bearing": {"ring_mass": 0.08, **BEARING}}],
}  # fmt: skip
#: Canted at the ends of two arms, and a lift and a pusher on the main body.
LISTED = [
    {"on": 1, "position": [0.01, 0.0, 0.02], "axis": [0.2, 0.1, 1.0]},
    {"on": 3, "axis": [-0.1, 0.2, 1.0]},
    {"on": "body", "position": [0.0, 0.05, -0.01]},
    {"on": "body", "position": [0.02, 0.01, -0.03], "axis": [0.6, 0.3, -0.2], "torque_ratio": 0.02},
]
LOSSES = ("loss_arm", "loss_contact", "loss_friction", "loss_stop", "loss_settling")


def four_arms(**arms: Any) -> dict[str, Any]:
    """A vehicle of 1.2 kg with four arms."""
    common = {
        "directions": ["45 deg", "135 deg", "225 deg", "315 deg"],
        "length": 0.19, "mass": 0.05, "cage_radius": 0.11, "torque_ratio": 0.012,
    }  # fmt: skip
    body = {"mass": 1.0, "inertia": [8e-3, 9e-3, 16e-3]}
    return {"name": "own", "arms": {**common, **arms}, "body": body}


def tables(first: Any, second: Any, place: list[float], yaw: float) -> dict[str, Any]:
    """A glancing meeting at 2.5 m/s, without gravity and thrust."""
    return {
        "vehicle": first,
        "world": {"gravity": 0.0, "obstacles": []},
        "start": {"position": [0.0, 0.0, 0.0], "velocity": [1.5, 0.0, 0.0]},
        "simulation": {"duration": 0.2},
        "second": {
            "vehicle": second,
            "start": {"position": place, "velocity": [-1.0, 0.0, 0.0], "yaw": yaw},
            "surface": {"law": "hunt-crossley", "stiffness": 7e4, "dissipation": 0.3,
                        "friction": 0.5},
        },
    }  # fmt: skip


MEETINGS = {
    "folding meets flapping": tables(
        four_arms(joint=FOLDING), four_arms(joint=FLAPPING), [0.6, 0.01, 0.0], 3.1
    ),
    "flapping meets folding": tables(
        four_arms(joint=FLAPPING), four_arms(joint=FOLDING), [0.6, 0.01, 0.0], 3.1
    ),
    "rolling meets ringed": tables(ROLLING, RINGED, [0.45, 0.12, 0.05], np.pi),
    "ringed meets rolling": tables(RINGED, ROLLING, [0.45, 0.12, 0.05], np.pi),
}


def both(flight: Flight) -> tuple[Flight, Any]:
    assert flight.second is not None
    return flight, flight.second


@pytest.mark.parametrize("name", MEETINGS)
def test_momentum_energy_and_the_touch_are_of_both(name: str) -> None:
    """Force and opposite force, what both have and lose together, when and how deep they touch."""
    first, second = both(fly(MEETINGS[name]))
    pushes = [np.array([f.work[f"impulse.{axis}"] for axis in "xyz"]) for f in (first, second)]
    assert np.abs(pushes[0]).max() > 0.1
    assert np.abs(pushes[0] + pushes[1]).max() < 1e-12
    for measure in nonempty(("touch_time", "touch_speed", "penetration", "contact_duration")):
        one, other = (flight.measures[measure] for flight in (first, second))  # type: ignore[literal-required]
        assert one is not None
        assert one == pytest.approx(other, rel=1e-11), measure
    for flight in nonempty((first, second)):
        assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6
    lost = sum(f.measures[name] or 0.0 for f in (first, second) for name in LOSSES)  # type: ignore[literal-required]
    kept = sum(f.measures["energy_end"] or 0.0 for f in (first, second))
    speeds = zip((first, second), (1.5, 1.0), strict=True)
    before = sum(0.5 * f.scenario.vehicle.mass * speed**2 for f, speed in speeds)
    assert lost > 0.1
    assert kept + lost == pytest.approx(before, rel=1e-6)


def test_slides_written_as_joints_meet_as_those_in_the_plane() -> None:
    """Of one vehicle along its own arms, on either side."""
    spring = {"stiffness": "5 N/mm", "damping": 20, "stroke": "40 mm"}
    planar = four_arms(**spring)
    place, yaw = [0.6, 0.02, 0.0], 3.0
    plain, jointed = (
        both(fly(tables(one, one, place, yaw))) for one in (planar, four_arms(joint=RADIAL))
    )
    for one, other in nonempty(zip(plain, jointed, strict=True)):
        assert (one.measures["arm_stroke"] or 0.0) > 1e-3
        for column in nonempty(("x", "y", "z", "vx", "vy", "wz", "l1", "l2", "l3", "l4")):
            last, same = one.columns[column][-1], other.columns[column][-1]
            assert last == pytest.approx(same, abs=2e-6), column


def with_thrust(rotors: list[dict[str, Any]] | None) -> Flight:
    """Two of the same vehicle in the plane, with these rotors, at constant and unequal thrusts."""
    spring = {"stiffness": "5 N/mm", "damping": 20, "stroke": "40 mm"}
    one = four_arms(**spring) | ({} if rotors is None else {"rotors": rotors})
    given = tables(one, one, [0.6, 0.02, 0.0], 3.0)
    given["second"]["thrust"] = [1.0, 2.0, 3.0, 0.5]
    return fly(given | {"thrust": [3.0, 2.5, 2.0, 1.5]})


def test_vehicles_that_list_their_rotors_meet_while_these_blow() -> None:
    """What acts on one acts back on the other; work and losses account for the energy of both."""
    first, second = both(with_thrust(LISTED))
    pushes = [np.array([f.work[f"impulse.{axis}"] for axis in "xyz"]) for f in (first, second)]
    assert np.abs(pushes[0]).max() > 0.1
    assert np.abs(pushes[0] + pushes[1]).max() < 1e-12
    for flight in nonempty((first, second)):
        assert (flight.measures["arm_stroke"] or 0.0) > 1e-3
        assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6
    lost = sum(f.measures[name] or 0.0 for f in (first, second) for name in LOSSES)  # type: ignore[literal-required]
    kept = sum(f.measures["energy_end"] or 0.0 for f in (first, second))
    blown = sum(f.measures["work_thrust"] or 0.0 for f in (first, second))
    speeds = zip((first, second), (1.5, 1.0), strict=True)
    before = sum(0.5 * f.scenario.vehicle.mass * speed**2 for f, speed in speeds)
    assert blown > 1.0
    assert kept + lost == pytest.approx(before + blown, rel=1e-6)


def test_one_rotor_on_each_arm_listed_or_not_meets_as_well() -> None:
    plain, listed = (
        both(with_thrust(rotors)) for rotors in (None, [{"on": j} for j in range(1, 5)])
    )
    for one, other in nonempty(zip(plain, listed, strict=True)):
        for column in nonempty(("x", "y", "z", "vx", "vz", "wx", "wz", "l1", "l3")):
            last, same = one.columns[column][-1], other.columns[column][-1]
            assert last == pytest.approx(same, abs=1e-9), column


@pytest.mark.parametrize("name", MEETINGS)
def test_each_ledger_closes_at_every_instant(name: str) -> None:
    """What each has, has lost and was given by the other, evaluated again from both trajectories."""
    for flight in nonempty(both(fly(MEETINGS[name]))):
        books = ledger(flight)
        held, lost = (sum(books[part] for part in parts) for parts in (HELD, LOST))
        left = held + lost - books["work_thrust"] - books["work_driven"] - held[0]
        assert np.abs(left).max() < 2e-6 * held[0]


@pytest.mark.parametrize("name", ["folding meets flapping", "rolling meets ringed"])
def test_an_accelerometer_off_the_centre_feels_the_other_vehicle(name: str) -> None:
    """Angular acceleration is the change of the angular velocity; of the second it is refused."""
    first, second = both(fly(MEETINGS[name]))
    alpha, t = angular_acceleration(first), first.t
    assert np.abs(alpha).max() > 5.0
    for k, axis in enumerate("xyz"):
        change = scipy.integrate.cumulative_trapezoid(alpha[:, k], t, initial=0.0)
        assert first.columns[f"w{axis}"] == pytest.approx(
            change, abs=0.01 * np.abs(alpha).max() * 0.01
        )
    with pytest.raises(InputError, match="second vehicle"):
        angular_acceleration(second)


@pytest.mark.parametrize("name", ["folding meets flapping", "ringed meets rolling"])
def test_contacts_are_evaluated_again_where_they_were(name: str) -> None:
    """Forces and moments of both are opposite, and those that the flight recorded."""
    first, second = both(fly(MEETINGS[name]))
    given = first.scenario, first.columns, second.columns, np.arange(len(first.t))
    loads = loads_on_first(*given), loads_on_second(*given)
    sums = [one.force.sum(axis=1) for one in loads]
    moments = [np.cross(np.nan_to_num(one.point), one.force).sum(axis=1) for one in loads]
    assert np.abs(sums[0]).max() > 10.0
    assert np.abs(sums[0] + sums[1]).max() < 1e-12
    assert np.abs(moments[0] + moments[1]).max() < 1e-12
    parts = ("1", "2", "3", "4", "_body")
    for flight, found in nonempty(zip((first, second), loads, strict=True)):
        for k, part in enumerate(parts[: found.normal.shape[1]]):
            assert np.abs(found.normal[:, k] - flight.columns[f"fn{part}"]).max() < 1e-8
            assert np.abs(found.friction[:, k] - flight.columns[f"ff{part}"]).max() < 1e-8
