"""Friction by bristles: what lies or leans stays where it is, and what falls comes to rest."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.contact.laws.bristles import bristle_friction, bristle_load
from springback.contact.surfaces import Surface, ThreeHalves
from springback.kernels.vectors import Vec, norm
from springback.results.flight import Flight, fly
from springback.results.motion import angular_acceleration
from springback.scenario.scenario import scenario_from

SURFACE = {"restitution": 0.5, "restitution_speed": 1.85, "friction": 0.8}
HELD = {**SURFACE, "friction_law": "bristle"}
GRAVITY = 9.81
HULLS: dict[str, dict[str, Any]] = {
    "capsule": {"type": "capsule", "start": [-0.08, 0.01, -0.01], "end": [0.1, 0, 0], "radius": 0.05},
    "box": {"type": "box", "size": [0.16, 0.12, 0.08], "edge_radius": 0.002},
    "points": {
        "type": "points", "radius": 0.003,
        "points": [[0, 0, 0.08], [0.11, 0, -0.05], [-0.06, 0.09, -0.05], [-0.06, -0.08, -0.05]],
    },
    "ring": {"type": "ring", "radius": 0.1, "axis": [0.2, 0.1, 1.0]},
}  # fmt: skip

#: A robot that lies flat.
BOXED = {"preset": "quad", "hull": False, "hulls": [HULLS["box"]]}


def slope(angle: float, surface: dict[str, Any]) -> dict[str, Any]:
    """A plane through the origin that falls towards X."""
    a = math.radians(angle)
    normal = [math.sin(a), 0.0, math.cos(a)]
    return {"type": "wall", "position": [0, 0, 0], "normal": normal, "surface": surface}


def tables(
    obstacles: list[dict[str, Any]], duration: float, vehicle: Any = "arq", **start: Any
) -> dict[str, Any]:
    """A vehicle without thrust."""
    return {
        "vehicle": vehicle,
        "world": {"obstacles": obstacles},
        "start": {"position": [0.0, 0.0, 0.2], **start},
        "thrust": [0.0] * 4,
        "simulation": {"duration": duration},
    }


def place(flight: Flight, t: float) -> Any:
    """Position at an instant [m]."""
    c = flight.columns
    return np.array([np.interp(t, c["t"], c[axis]) for axis in "xyz"])


def speeds(flight: Flight) -> tuple[float, float]:
    """Speed [m/s] and angular rate [rad/s] at the end."""
    c = flight.columns
    v, w = ([c[f"{stem}{axis}"][-1] for axis in "xyz"] for stem in "vw")
    return float(np.linalg.norm(v)), float(np.linalg.norm(w))


# -- the law ---------------------------------------------------------------------------------------

LAW = Surface(2e5, 0.4, 0.0, ThreeHalves(1.5), 0.8, 0.0, 0.03, -1.0, 1e-4, 0.0)


def test_sliding_friction_is_coulombs() -> None:
    slip, z, h = Vec(0.3, -0.4, 0.0), Vec(0.0, 0.0, 0.0), 1e-6
    for _ in range(2000):  # 1 mm
        z = z + h * bristle_load(z, slip, LAW.presliding, LAW.slip_speed).rate
    friction = bristle_friction(LAW, 10.0, slip, z)
    assert norm(friction.force + slip * (0.8 * 10.0 / 0.5)) < 1e-9
    assert friction.loss == pytest.approx(8.0 * 0.5, rel=1e-9)


def test_what_is_held_does_not_creep_however_long_it_is_shaken() -> None:
    z, h, steps = Vec(0.5e-4, 0.0, 0.0), 1e-5, 100_000
    for k in range(steps):  # 0.2 mm/s at 50 Hz, about zero
        slip = Vec(2e-4 * math.cos(2.0 * math.pi * 50.0 * h * (k + 0.5)), 0.0, 0.0)
        z = z + h * bristle_load(z, slip, LAW.presliding, LAW.slip_speed).rate
    assert z.x == pytest.approx(0.5e-4, abs=1e-12)


def test_bristles_never_pull_with_more_than_friction() -> None:
    chance = np.random.default_rng(3)
    for _ in range(300):
        slip, z = (Vec(*row) for row in chance.normal(size=(2, 3)) * [[0.1], [1e-4]])
        friction = bristle_friction(LAW, 10.0, slip, z)
        assert norm(friction.force) <= 8.0 * (1.0 + 1e-12)
        held = bristle_load(z, slip, LAW.presliding, LAW.slip_speed)
        if norm(z) > LAW.presliding:  # no stretch grows beyond the largest
            assert z @ held.rate <= 1e-18


# -- on a slope ------------------------------------------------------------------------------------


@pytest.mark.parametrize("pitch", ["0 deg", "180 deg"])
def test_a_landed_robot_does_not_creep_on_a_slope(pitch: str) -> None:
    flight = fly(tables([slope(20.0, HELD)], 62.0, pitch=pitch))
    assert np.linalg.norm(place(flight, 62.0) - place(flight, 2.0)) < 1e-3
    assert np.linalg.norm(place(flight, 62.0) - place(flight, 10.0)) < 1e-6
    assert max(speeds(flight)) < 1e-9


def test_the_regularised_law_creeps_there() -> None:
    """With the speed at which its friction holds: v_s r/√(1 − r²), where r = tan α/μ."""
    flight = fly(tables([slope(20.0, SURFACE)], 3.0))
    share = math.tan(math.radians(20.0)) / 0.8
    crept = np.linalg.norm(place(flight, 3.0) - place(flight, 2.0))
    assert crept == pytest.approx(0.03 * share / math.sqrt(1.0 - share * share), rel=0.05)


def test_a_robot_slides_on_a_slope_steeper_than_friction_holds() -> None:
    angle, mu = 45.0, 0.4
    above, surface = [0.0295, 0.0, 0.0295], {**HELD, "friction": mu}
    flight = fly(tables([slope(angle, surface)], 1.0, BOXED, position=above, pitch=f"{angle} deg"))
    c, a = flight.columns, math.radians(angle)
    late = c["t"] > 0.8
    along = c["vx"][late] * math.cos(a) - c["vz"][late] * math.sin(a)
    rise = np.polyfit(c["t"][late], along, 1)[0]
    assert rise == pytest.approx(GRAVITY * (math.sin(a) - mu * math.cos(a)), rel=0.02)


def test_friction_at_rest_is_in_the_file_and_in_the_replay() -> None:
    flight = fly(tables([slope(20.0, HELD)], 6.0))
    total = sum(flight.columns[f"ff{j}"][-1] for j in (1, 2, 3, 4)) + flight.columns["ff_body"][-1]
    weight = flight.scenario.vehicle.mass * GRAVITY * math.sin(math.radians(20.0))
    assert total == pytest.approx(weight, rel=1e-3)
    assert np.abs(angular_acceleration(flight)[-1]).max() < 1e-4  # it still settles


# -- a fall ----------------------------------------------------------------------------------------


def fallen(vehicle: Any, seeds: int, **surface: Any) -> list[Flight]:
    """Flights that fell 2 m, tumbling, seen for 10 s."""
    ground = {"type": "ground", "surface": {**HELD, **surface}}
    chance = np.random.default_rng(8)
    found = []
    for _ in range(seeds):
        start = {
            "position": [0, 0, 2.0], "velocity": [*chance.uniform(-1.0, 1.0, 2), 0.0],
            "roll": chance.uniform(-3.1, 3.1), "pitch": chance.uniform(-1.5, 1.5),
            "angular_velocity": chance.uniform(-4.0, 4.0, 3).tolist(),
        }  # fmt: skip
        found.append(fly(tables([ground], 10.0, vehicle, **start)))
    return found


def test_whatever_falls_comes_to_rest() -> None:
    for flight in nonempty(
        fallen("arq", 6, rolling_resistance=1e-3)
    ):  # on the sphere about its body
        assert max(speeds(flight)) < 1e-6
        assert np.linalg.norm(place(flight, 10.0) - place(flight, 8.0)) < 1e-6


@pytest.mark.parametrize("hull", HULLS)
def test_it_comes_to_rest_on_any_hull(hull: str) -> None:
    quad = {"preset": "quad", "hull": False, "hulls": [HULLS[hull]]}
    for flight in nonempty(fallen(quad, 3, rolling_resistance=1e-3)):
        assert np.linalg.norm(place(flight, 10.0) - place(flight, 8.0)) < 1e-3


def test_a_rolling_sphere_loses_what_rolling_resistance_takes() -> None:
    """Deceleration g ρ/R over 1 + J/(m R²), of a ball that rolls without slip."""
    lever, radius = 2e-3, 0.3
    ball = {"preset": "quad", "hull": {"radius": radius}}
    ground = {"type": "ground", "surface": {**HELD, "rolling_resistance": lever}}
    start = {"position": [0, 0, 0.3], "velocity": [1.0, 0, 0], "roll": "90 deg"}
    given = tables([ground], 2.0, ball, **start, angular_velocity=[0.0, 0.0, 1.0 / radius])
    flight = fly(given)
    c, vehicle = flight.columns, scenario_from(given).vehicle
    inertia = vehicle.inertia()[2][2]
    late = c["t"] > 0.5
    slows = -np.polyfit(c["t"][late], c["vx"][late], 1)[0]
    mass = vehicle.mass
    assert slows == pytest.approx(
        GRAVITY * lever / radius / (1.0 + inertia / (mass * radius * radius)), rel=0.05
    )


# -- executors, and what cannot be -----------------------------------------------------------------


def test_lanes_fly_the_bits_of_single_flights() -> None:
    given = [tables([slope(20.0, HELD)], 0.6, pitch=f"{pitch} deg") for pitch in (0, 25, 50)]
    together = fly_scenarios(given, threads=1)
    assert not any(together.problems)
    for k, one in enumerate(nonempty(given)):
        for name, number in fly(one, trajectory=False).measures.items():
            row = together.measures[name][k]
            assert np.isnan(row) if number is None else row == number, (k, name)


def test_a_robot_rides_on_a_plate_that_swings() -> None:
    plate = {
        "type": "box", "position": [0, 0, -0.1], "size": [2, 2, 0.2], "surface": HELD,
        "motion": {"type": "sine", "amplitude": [0.1, 0, 0], "frequency": 0.5},
    }  # fmt: skip
    flight = fly(tables([plate], 6.0, BOXED, position=[0, 0, 0.08]))
    c = flight.columns
    late = c["t"] > 2.0
    offset = c["x"][late] - c["obstacle0_x"][late]
    assert np.ptp(c["x"][late]) > 0.15
    assert np.ptp(offset) < 1e-3


@pytest.mark.parametrize(
    ("surface", "said"),
    [
        ({"law": "impulse", "restitution": 0.5, "friction_law": "bristle"}, "friction_law"),
        ({**SURFACE, "presliding": 2e-4}, "presliding"),
        ({**SURFACE, "rolling_resistance": 1e-3}, "rolling_resistance"),
        ({**HELD, "presliding": 0.0}, "presliding"),
    ],
)
def test_bristles_that_cannot_be_are_refused(surface: dict[str, Any], said: str) -> None:
    with pytest.raises(Exception, match=said):
        scenario_from(tables([slope(20.0, surface)], 1.0))
