"""Rates of moving obstacles in plain Python: signs that a flight of a few milliseconds shows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.contact.cage import moving_bodies
from springback.contact.moving.bodies import hinge_torque, spline_point
from springback.results.flight import Flight, fly
from springback.scenario.scenario import scenario_from

SURFACE = {"law": "hunt-crossley", "stiffness": 4e5, "dissipation": 0.3, "friction": 0.5}
BALL = {"type": "sphere", "position": [0.3, 0.06, 0.02], "radius": 0.1, "surface": SURFACE}
DOOR = {"type": "box", "position": [0.0, 0.45, 0.0], "size": [0.04, 0.9, 2.0], "surface": SURFACE}
HINGE = {
    "type": "hinge", "mass": 8.0, "pivot": [0.0, 0.0, 0.0], "closer": 5.0, "damping": 2.0,
    "rest": 0.1, "lowest": -0.2, "highest": 0.5,
}  # fmt: skip


def tables(obstacle: dict[str, Any], **more: Any) -> dict[str, Any]:
    """ARQ without thrust, a tenth of a millimetre before it touches an obstacle."""
    start = {"position": [0.0, 0.0, 0.0], "velocity": [2.0, 0.3, 0.1], "touch_distance": 1e-4}
    return {
        "vehicle": "arq", "world": {"obstacles": [obstacle], "gravity": more.pop("gravity", 0.0)},
        "start": start, "simulation": {"duration": 4e-3}, **more,
    }  # fmt: skip


def plain(obstacle: dict[str, Any], **more: Any) -> Flight:
    """A flight in plain Python."""
    return fly(tables(obstacle, **more), executor="python")


def far(obstacle: dict[str, Any], gravity: float = 9.81) -> Flight:
    """A flight in which the vehicle is elsewhere."""
    start = {"position": [50.0, 0.0, 0.0]}
    return plain(obstacle, gravity=gravity, start=start, simulation={"duration": 0.02})


def test_closer_and_stops_pull_back_and_the_damper_brakes() -> None:
    """The torque is −dE/dθ of what is stored, and against the turning; it takes power at all times."""
    world = scenario_from(tables(DOOR | {"motion": HINGE})).flight_model().world
    body, _ = moving_bodies(world.obstacles)  # and one that is absent
    for angle in nonempty((-0.4, -0.1, 0.0, 0.3, 0.7)):
        step = 1e-6
        stored = [hinge_torque(body, angle + s, 0.0).energy for s in (-step, step)]
        still = hinge_torque(body, angle, 0.0)
        assert still.torque == pytest.approx(-(stored[1] - stored[0]) / (2.0 * step), rel=1e-6)
        assert still.loss == 0.0
        for turning in (-1.0, 2.0):
            moving = hinge_torque(body, angle, turning)
            assert (moving.torque - still.torque) * turning == pytest.approx(-2.0 * turning**2)
            assert moving.loss == pytest.approx(2.0 * turning**2)
    assert hinge_torque(body, 0.7, 0.0).torque < -(500.0 - 1.0) * 0.2


def test_a_raised_pendulum_falls() -> None:
    """By g sin θ along its way at first; what it gains in speed it loses in height."""
    angle = 0.6
    place = [0.8 * math.sin(angle), 0.0, -0.8 * math.cos(angle)]
    motion = {"type": "pendulum", "mass": 1.3, "pivot": [0.0, 0.0, 0.0]}
    c = far(BALL | {"position": place, "motion": motion}).columns
    about = 0.8**2 + 0.4 * 0.1**2
    falling = -9.81 * 0.8 * math.sin(angle) / about * 0.8  # of the centre, along its way
    assert c["obstacle0_vx"][-1] == pytest.approx(falling * math.cos(angle) * c["t"][-1], rel=1e-3)
    assert c["obstacle0_z"][-1] < c["obstacle0_z"][0]


ROPE = {
    "type": "capsule", "start": [0.3, 0.06, -0.8], "end": [0.3, 0.06, 1.2], "radius": 0.006,
    "surface": SURFACE | {"friction": 0.0},
    "motion": {"type": "pendulum", "mass": 0.2, "pivot": [0.3, 0.06, 1.3], "damping": 0.05},
}  # fmt: skip


def test_damping_takes_all_spin_of_a_pendulum_at_the_rate_of_its_swing() -> None:
    """Else that of a rope about itself, 10⁻⁵ of its moment, would decay within microseconds."""
    spin = {"angular_velocity": [0.2, 0.0, 5.0]}
    c = far(ROPE | {"motion": ROPE["motion"] | spin}, gravity=0.0).columns
    about = 0.2 * (2.012**2 / 12.0 + 1.1**2)
    left = math.exp(-0.05 / about * c["t"][-1])
    assert c["obstacle0_wz"][-1] == pytest.approx(5.0 * left, rel=1e-5)
    turned = math.hypot(c["obstacle0_wx"][-1], c["obstacle0_wy"][-1])
    assert turned == pytest.approx(0.2 * left, rel=1e-3)
    assert left < 0.999


def test_a_thin_rope_is_met_in_few_steps() -> None:
    """Steps follow what an impulse on its surface does, not the least of its moments of inertia."""
    flight = plain(ROPE)
    assert flight.measures["contacts"] >= 1.0
    assert len(flight.columns["t"]) < 300
    assert abs(flight.measures["ledger_residual"]) < 1e-6


def test_the_speed_per_impulse_of_a_body_is_bounded_closely() -> None:
    """By a point of its surface and a direction, at random: never more, and hardly less."""
    generator = np.random.default_rng(3)
    motions = (ROPE["motion"], {"type": "free", "mass": 0.2})
    for motion in nonempty(motions):
        world = scenario_from(tables(ROPE | {"motion": motion})).flight_model().world
        body = moving_bodies(world.obstacles)[0]
        from_pivot = np.array([0.0, 0.0, -1.1]) if motion is motions[0] else np.zeros(3)
        angle, height = generator.uniform(0, 2 * np.pi, 2000), generator.choice((-1.0, 1.0), 2000)
        points = np.column_stack([0.006 * np.cos(angle), 0.006 * np.sin(angle), height])
        along = generator.standard_normal((2000, 3))
        along /= np.linalg.norm(along, axis=1)[:, None]
        turned = np.cross(points + from_pivot, along)
        found = np.einsum("ki,ij,kj->k", turned, np.array(body.inverse), turned).max()
        found += 0.0 if motion is motions[0] else 1.0 / 0.2
        assert found < body.mobility < 1.6 * found


def test_a_free_body_falls_and_turns_as_it_was_thrown() -> None:
    motion = {
        "type": "free",
        "mass": 0.5,
        "velocity": [0.0, 1.0, 2.0],
        "angular_velocity": [0.0, 0.0, 3.0],
    }
    c = far(BALL | {"motion": motion}).columns
    t = c["t"][-1]
    assert c["obstacle0_z"][-1] == pytest.approx(0.02 + 2.0 * t - 0.5 * 9.81 * t**2, abs=1e-12)
    assert 2.0 * math.asin(c["obstacle0_qz"][-1]) == pytest.approx(3.0 * t, rel=1e-9)


MASSIVE = {
    "free": {"type": "free", "mass": 0.4, "angular_velocity": [1.0, 2.0, 8.0]},
    "pendulum": {"type": "pendulum", "mass": 0.4, "pivot": [0.3, 0.0, 0.4], "damping": 0.05},
    "hinge": {"type": "hinge", "mass": 0.4, "pivot": [0.3, -0.3, 0.0], "turning": -1.0,
              "closer": 2.0, "damping": 0.3},
}  # fmt: skip


@pytest.mark.parametrize("name", MASSIVE)
def test_energy_is_kept_with_what_is_struck(name: str) -> None:
    """Vehicle and obstacle together, friction and spin of the ball included."""
    flight = plain(BALL | {"motion": MASSIVE[name]})
    assert flight.measures["contacts"] >= 1.0
    assert flight.measures["loss_friction"] > 1e-3
    assert abs(flight.measures["ledger_residual"]) < 1e-6


def test_momentum_is_kept_with_a_free_ball() -> None:
    flight = plain(BALL | {"motion": MASSIVE["free"]})
    c = flight.columns
    for axis in "xyz":
        gained = flight.measures[f"impulse_{axis}"]
        lost = 0.4 * (c[f"obstacle0_v{axis}"][-1] - c[f"obstacle0_v{axis}"][0])
        assert gained == pytest.approx(-lost, abs=1e-12)
    assert abs(flight.measures["impulse_x"]) > 0.01


GIVEN = {
    "constant": {"type": "constant", "velocity": [-1.0, 0.5, 0.3], "turning": 3.0},
    "sine": {"type": "sine", "amplitude": [-0.02, 0.0, 0.0], "frequency": 20.0, "swing": 0.1},
}  # fmt: skip


@pytest.mark.parametrize("name", GIVEN)
def test_what_drives_an_obstacle_puts_in_what_is_gained(name: str) -> None:
    """Its work has the sign with which the ledger closes, along the surface, too."""
    flight = plain(BALL | {"motion": GIVEN[name]})
    assert flight.measures["contacts"] >= 1.0
    assert abs(flight.measures["work_driven"]) > 1e-2
    assert abs(flight.measures["ledger_residual"]) < 1e-6


def test_a_moving_wall_rubs_as_a_wall_at_rest_in_its_frame() -> None:
    """Forces depend on the velocity relative to the surface, normal and along."""
    wall = {
        "type": "wall",
        "position": [0.4, 0.0, 0.0],
        "normal": [-1.0, 0.2, 0.1],
        "surface": SURFACE,
    }
    drift = [-1.5, 0.4, 0.2]
    moving = plain(wall | {"motion": {"type": "constant", "velocity": drift}},
                   start={"position": [0.12, 0.0, 0.0], "velocity": [0.5, 0.0, 0.0]},
                   simulation={"duration": 0.012})  # fmt: skip
    still = plain(wall, start={"position": [0.12, 0.0, 0.0], "velocity": [2.0, -0.4, -0.2]},
                  simulation={"duration": 0.012})  # fmt: skip
    assert abs(moving.measures["impulse_y"]) > 0.01
    for axis in "xyz":
        name = f"impulse_{axis}"
        assert moving.measures[name] == pytest.approx(still.measures[name], rel=1e-6)


def test_a_table_is_at_rest_before_and_after_it() -> None:
    """At its knots it has their places, and between them it moves; beyond it does not."""
    motion = {"type": "table", "time": [0.5, 1.0, 2.0],
              "position": [[0.0, 0.0, 0.0], [0.3, 0.1, 0.0], [0.2, 0.0, -0.4]],
              "angle": [0.0, 0.5, -0.2]}  # fmt: skip
    world = scenario_from(tables(BALL | {"motion": motion}, start={})).flight_model().world
    body, _ = moving_bodies(world.obstacles)  # and one that is absent
    table = body.path.table
    for t, place, angle in zip(motion["time"], motion["position"], motion["angle"], strict=True):
        there = spline_point(table, t)
        np.testing.assert_allclose(there.position, place, atol=1e-12)
        assert there.angle == pytest.approx(angle, abs=1e-12)
    for t in (0.0, 3.0):
        assert spline_point(table, t).velocity @ spline_point(table, t).velocity == 0.0
    step, at = 1e-6, spline_point(table, 1.4)
    before, after = (spline_point(table, 1.4 + s).position for s in (-step, step))
    np.testing.assert_allclose(at.velocity, np.subtract(after, before) / (2 * step), rtol=1e-6)
