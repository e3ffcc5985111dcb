"""Flights among moving obstacles: momentum, energy, moving frames, and closed forms without contact."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
import scipy

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.dynamics.energy import angular_momentum
from springback.kernels.vectors import Quat, Vec, rotation
from springback.results.flight import fly
from springback.scenario.scenario import scenario_from
from springback.vehicle.state import State

SURFACE = {"law": "hunt-crossley", "stiffness": 4e5, "dissipation": 0.3, "friction": 0.5}
BALL = {"type": "sphere", "radius": 0.12, "surface": SURFACE}


def tables(
    *obstacles: dict[str, Any], velocity: Any = (0.0, 0.0, 0.0), duration: float = 0.1, **more: Any
) -> dict[str, Any]:
    """ARQ without gravity or thrust at the origin, among some obstacles."""
    return {
        "vehicle": "arq",
        "world": {"obstacles": list(obstacles), "gravity": more.pop("gravity", 0.0)},
        "start": {"position": [0.0, 0.0, 0.0], "velocity": list(velocity), **more.pop("start", {})},
        "simulation": {"duration": duration},
        **more,
    }  # fmt: skip


def ball(at: Any, **motion: Any) -> dict[str, Any]:
    """A ball that moves."""
    return {**BALL, "position": list(at), "motion": motion}


def thrown(**motion: Any) -> dict[str, Any]:
    """A ball that flies past the nose of the vehicle, and strikes the cages to the left of it."""
    return ball(
        (0.5, 0.06, 0.02), type="free", **{"mass": 0.4, "velocity": [-3.0, 0.0, 0.0]} | motion
    )


def vector(columns: Any, stem: str, row: int, axes: str = "xyz") -> Any:
    """A vector of a trajectory at one instant."""
    return np.array([columns[f"{stem}{axis}"][row] for axis in axes])


def test_what_the_vehicle_gains_the_ball_loses() -> None:
    """Linear and angular momentum of vehicle and ball together stay as they are, to rounding."""
    flight = fly(tables(thrown(), velocity=(0.5, 0.0, 0.0)))
    c, work = flight.columns, flight.work
    assert flight.measures["contacts"] >= 1.0
    impulse = np.array([work[f"impulse.{axis}"] for axis in "xyz"])
    ball_speed = np.array([c[f"obstacle0_v{axis}"] for axis in "xyz"])
    lost = 0.4 * (ball_speed - ball_speed[:, :1])
    assert np.abs(impulse[:, -1]).max() > 0.3
    assert np.abs(impulse + lost).max() < 1e-12

    airframe, inertia = flight.scenario.true_airframe(), 0.4 * 0.4 * 0.12**2 * np.eye(3)

    def spin(row: int) -> Any:
        place = Vec(*vector(c, "", row).tolist())
        state = State(
            place, Quat(*vector(c, "q", row, "wxyz").tolist()), Vec(*vector(c, "v", row).tolist()),
            Vec(*vector(c, "w", row).tolist()), tuple(float(c[f"l{j}"][row]) for j in range(1, 5)),
            tuple(float(c[f"dl{j}"][row]) for j in range(1, 5)),
        )  # fmt: skip
        # The centre of mass of all cannot move: the arms' is found by the linear momentum.
        own = np.array(angular_momentum(airframe, state))
        momentum = np.array(work_momentum(row))
        centre = vector(c, "", row) + np.array(arms_centre(airframe, state))
        x, v = vector(c, "obstacle0_", row), vector(c, "obstacle0_v", row)
        ball_own = inertia @ vector(c, "obstacle0_w", row)  # a sphere: the same in all axes
        return own + np.cross(centre, momentum) + 0.4 * np.cross(x, v) + rotated(c, row, ball_own)

    def work_momentum(row: int) -> Any:
        return airframe.mass * np.array([0.5, 0.0, 0.0]) + impulse[:, row]

    assert np.abs(spin(-1) - spin(0)).max() < 1e-9


def arms_centre(airframe: Any, state: Any) -> Any:
    """Centre of mass of a vehicle, from the main body, world [m]."""
    first = sum(
        arm.mass * length * np.array([arm.cosine, arm.sine, 0.0])
        for arm, length in zip(airframe.arms, state.arm_length, strict=True)
    )
    return np.array(rotation(state.attitude)) @ first / airframe.mass


def rotated(c: Any, row: int, own: Any) -> Any:
    """A vector in the ball's axes, in world axes."""
    return np.array(rotation(Quat(*vector(c, "obstacle0_q", row, "wxyz").tolist()))) @ own


MOTIONS: dict[str, dict[str, Any]] = {
    "constant": {"type": "constant", "velocity": [-2.0, 0.0, 0.3], "turning": 3.0},
    "sine": {"type": "sine", "amplitude": [-0.1, 0.0, 0.0], "frequency": 6.0, "swing": 0.4},
    "table": {"type": "table", "time": [0.0, 0.05, 0.2],
              "position": [[0.0, 0.0, 0.0], [-0.15, 0.0, 0.0], [-0.15, 0.1, 0.0]],
              "angle": [0.0, 0.2, 0.0]},
    "free": {"type": "free", "mass": 0.4, "velocity": [-2.0, 0.0, 0.0],
             "angular_velocity": [1.0, 2.0, 8.0]},
    "pendulum": {"type": "pendulum", "mass": 1.0, "pivot": [0.5, 0.0, 1.0],
                 "angular_velocity": [0.0, 2.5, 0.0], "damping": 0.01},
    "hinge": {"type": "hinge", "mass": 3.0, "pivot": [0.5, 0.6, 0.0], "turning": 3.0,
              "closer": 2.0, "damping": 0.5, "highest": "10 deg"},
}  # fmt: skip
HITTERS: dict[str, dict[str, Any]] = {
    "sphere": {"type": "sphere", "position": [0.43, 0.0, 0.02], "radius": 0.1},
    "box": {"type": "box", "position": [0.43, 0.0, 0.02], "size": [0.2, 0.3, 0.4], "yaw": 0.3,
            "edge_radius": 0.02},
    "capsule": {"type": "capsule", "start": [0.36, -0.2, 0.0], "end": [0.36, 0.3, 0.1], "radius": 0.03},
    "pole": {"type": "pole", "position": [0.42, 0.0, -0.3], "radius": 0.08, "height": 0.6},
    "cone": {"type": "cone", "position": [0.46, 0.0, -0.1], "radius": 0.15, "height": 0.4},
    "hoop": {"type": "hoop", "position": [0.38, 0.0, 0.0], "radius": 0.25, "tube_radius": 0.02},
    "window": {"type": "window", "position": [0.4, 0.0, 0.0], "size": [0.8, 0.8],
               "opening": [0.3, 0.3], "thickness": 0.05, "edge_radius": 0.01},
    "edge": {"type": "edge", "position": [0.33, 0.0, 0.0], "length": 0.5, "width": 0.2,
             "edge_radius": 0.02},
    "stairs": {"type": "stairs", "position": [0.34, 0.0, -0.3], "steps": 4,
               "edge_radius": 0.02},
    "doorway": {"type": "doorway", "position": [0.4, 0.0, -0.38], "size": [0.9, 1.0],
                "opening": [0.3, 0.8], "thickness": 0.05, "edge_radius": 0.01},
}  # fmt: skip
GROUND = {"type": "ground", "height": -0.4, "surface": SURFACE}
PAIRS = [
    (shape, motion, k) for k, (shape, motion) in enumerate(itertools.product(HITTERS, MOTIONS))
]


@pytest.mark.parametrize("shape", HITTERS)
def test_every_shape_moves_in_every_way(shape: str) -> None:
    """It flies; where something touches, the ledger of vehicle and obstacles closes."""
    touched = 0
    for name, motion, k in nonempty(one for one in PAIRS if one[0] == shape):
        moving = {**HITTERS[name], "surface": SURFACE, "motion": MOTIONS[motion]}
        flight = fly(
            tables(moving, GROUND, velocity=(0.8, 0.0, 0.0), gravity=9.81, duration=0.15),
            trajectory=False,
        )
        m = flight.measures
        # Of the default steps; at edges of small radius as for the same shapes at rest.
        assert abs(m["ledger_residual"]) < 5e-5, (name, motion, k)
        touched += m["contacts"] > 0.0
    assert touched >= 3


def test_a_moving_wall_is_a_wall_at_rest_in_the_moving_frame() -> None:
    """All positions relative to it are the same, and what drives it puts in the difference."""
    wall = {
        "type": "wall",
        "position": [0.4, 0.0, 0.0],
        "normal": [-1.0, 0.2, 0.1],
        "surface": SURFACE,
    }
    drift = [-1.5, 0.4, 0.2]
    moving = fly(tables({**wall, "motion": {"type": "constant", "velocity": drift}},
                        velocity=(0.5, 0.0, 0.0), duration=0.15))  # fmt: skip
    still = fly(tables(wall, velocity=(2.0, -0.4, -0.2), duration=0.15))
    for k, axis in enumerate("xyz"):
        there = np.interp(moving.t, still.t, still.columns[axis]) + drift[k] * moving.t
        assert np.abs(moving.columns[axis] - there).max() < 2e-7  # between instants
        end = still.columns[axis][-1] + drift[k] * moving.t[-1]
        assert moving.columns[axis][-1] == pytest.approx(end, abs=1e-9)
    m = moving.measures
    impulse = [m[f"impulse_{axis}"] for axis in "xyz"]
    assert m["work_driven"] == pytest.approx(np.dot(impulse, drift), abs=1e-9)
    assert abs(m["ledger_residual"]) < 1e-6
    assert m["touch_speed"] == pytest.approx(still.measures["touch_speed"], rel=1e-9)
    assert m["restitution_at_separation"] == pytest.approx(
        still.measures["restitution_at_separation"], rel=1e-6
    )


def test_a_very_heavy_ball_is_one_at_rest() -> None:
    """A free obstacle of a million tonnes is as good as a fixed one."""
    at = (0.45, 0.05, 0.03)
    there = {"velocity": (2.0, 0.0, 0.0), "duration": 0.15}
    heavy = fly(tables(ball(at, type="free", mass=1e9), **there), trajectory=False)
    fixed = fly(tables({**BALL, "position": list(at)}, **there), trajectory=False)
    for name in (
        "impact_peak_acceleration",
        "separation_time",
        "impulse_x",
        "restitution_at_separation",
    ):
        assert heavy.measures[name] == pytest.approx(fixed.measures[name], rel=1e-6), name


FAR = {"start": {"position": [50.0, 0.0, 50.0]}}


def test_a_hanging_ball_swings_as_a_physical_pendulum() -> None:
    """From 60°: the speed at the bottom follows from its height, its period from the elliptic integral."""
    length, angle, m, r = 0.8, math.radians(60.0), 1.3, 0.12
    at = (length * math.sin(angle), 0.0, -length * math.cos(angle))
    hanging = ball(at, type="pendulum", mass=m, pivot=[0.0, 0.0, 0.0])
    flight = fly(tables(hanging, gravity=9.81, duration=2.0, **FAR))
    c = flight.columns
    about = m * length**2 + 0.4 * m * r**2
    rate = math.sqrt(m * 9.81 * length / about)
    period = 4.0 / rate * scipy.special.ellipk(math.sin(0.5 * angle) ** 2)
    x = c["obstacle0_x"]
    falls = np.flatnonzero((x[:-1] > 0.0) & (x[1:] <= 0.0))
    k = falls[0]
    zero = np.interp(0.0, [-x[k], -x[k + 1]], [flight.t[k], flight.t[k + 1]])
    assert zero == pytest.approx(0.25 * period, rel=1e-5)
    speed = np.sqrt(c["obstacle0_vx"] ** 2 + c["obstacle0_vz"] ** 2)
    fall = length * (1.0 - math.cos(angle))
    assert speed.max() == pytest.approx(length * math.sqrt(2.0 * m * 9.81 * fall / about), rel=1e-6)
    assert abs(flight.measures["ledger_residual"]) < 1e-6


def test_a_door_closes_as_a_damped_oscillator() -> None:
    """Angle of a door with a closer, against the closed form; its inertia is m w²/3 + thickness."""
    w, thick, m, k, damp = 0.9, 0.04, 20.0, 8.0, 6.0
    door = {
        "type": "box", "position": [0.5 * w, 0.0, 1.0], "size": [w, thick, 2.0], "edge_radius": 0.0,
        "surface": SURFACE,
        "motion": {"type": "hinge", "mass": m, "pivot": [0.0, 0.0, 1.0], "closer": k,
                   "damping": damp, "turning": 1.5},
    }  # fmt: skip
    flight = fly(tables(door, gravity=9.81, duration=1.5, **FAR))
    inertia = m / 3.0 * w**2 + m / 12.0 * thick**2
    decay, rate = 0.5 * damp / inertia, math.sqrt(k / inertia - (0.5 * damp / inertia) ** 2)
    expected = 1.5 / rate * np.exp(-decay * flight.t) * np.sin(rate * flight.t)
    angle = np.arctan2(flight.columns["obstacle0_y"], flight.columns["obstacle0_x"])
    assert np.abs(angle - expected).max() < 1e-6
    assert abs(flight.measures["ledger_residual"]) < 1e-6
    assert flight.measures["loss_obstacles"] > 1.0


def test_a_door_is_stopped_at_its_frame() -> None:
    """It turns no farther than its stop by more than the spring gives way, and comes back."""
    door = {
        "type": "box", "position": [0.45, 0.0, 1.0], "size": [0.9, 0.04, 2.0], "surface": SURFACE,
        "motion": {"type": "hinge", "mass": 20.0, "pivot": [0.0, 0.0, 1.0], "turning": 1.5,
                   "highest": "20 deg"},
    }  # fmt: skip
    flight = fly(tables(door, duration=1.0, **FAR))
    angle = np.arctan2(flight.columns["obstacle0_y"], flight.columns["obstacle0_x"])
    beyond = angle.max() - math.radians(20.0)
    inertia = 20.0 / 3.0 * 0.9**2 + 20.0 / 12.0 * 0.04**2
    assert beyond == pytest.approx(1.5 * math.sqrt(inertia / 500.0), rel=1e-3)
    assert angle[-1] < 0.0


def test_a_thrown_box_falls_bounces_and_comes_to_rest() -> None:
    """Its energy goes into its own contacts; the ledger closes; it lies on a face at the end."""
    box = {
        "type": "box", "position": [0.0, 0.0, 0.6], "size": [0.3, 0.2, 0.1], "roll": 0.4, "pitch": 0.3,
        "surface": SURFACE, "motion": {"type": "free", "mass": 0.8, "velocity": [0.5, 0.0, 0.0]},
    }  # fmt: skip
    floor = {**GROUND, "height": 0.0}
    flight = fly(tables(box, floor, gravity=9.81, duration=3.0, **FAR))
    c = flight.columns
    assert abs(flight.measures["ledger_residual"]) < 1e-6
    assert flight.measures["loss_obstacles"] > 4.0
    assert c["obstacle0_z"][-1] == pytest.approx(0.05, abs=1e-3)
    assert math.hypot(c["obstacle0_vx"][-1], c["obstacle0_vy"][-1]) < 0.02
    assert abs(c["obstacle0_vz"][-1]) < 1e-3


def test_all_executors_fly_the_same_bits() -> None:
    """Plain Python, compiled alone, and many at once."""
    each = [
        tables(thrown(velocity=[speed, 0.0, 0.0]), duration=4e-3, start={"touch_distance": 1e-4},
               velocity=(1.0, 0.0, 0.0))
        for speed in (-3.0, -1.0)
    ]  # fmt: skip
    together = fly_scenarios(each, threads=1)
    for k, one in enumerate(nonempty(each)):
        plain = fly(one, executor="python", trajectory=False).measures
        assert plain["contacts"] == 1.0
        assert fly(one, trajectory=False).measures == plain
        for name, value in plain.items():
            row = together.measures[name][k]
            assert np.isnan(row) if value is None else row == value, name


def test_many_moving_obstacles_at_once() -> None:
    """Five bodies, filled up to eight: each is where it would be alone."""
    five = [ball((3.0 * k, 20.0, 5.0), type="free", mass=0.1 + k, velocity=[0.0, 0.0, 1.0 * k])
            for k in range(5)]  # fmt: skip
    flight = fly(tables(*five, gravity=9.81, duration=0.05), executor="python")
    for k in range(5):
        z = flight.columns[f"obstacle{k}_z"][-1]
        assert z == pytest.approx(5.0 + 0.05 * k - 0.5 * 9.81 * 0.05**2, abs=1e-12)
    assert "obstacle5_z" not in flight.columns


@pytest.mark.parametrize("moving", [1, 2, 3])
def test_gaps_of_each_obstacle_are_told_however_many_move(moving: int) -> None:
    """The least of all is that of the world."""
    balls = [ball((0.6 + 0.1 * k, 0.3 * k, 0.1), type="constant", velocity=[-1.0, 0.0, 0.0])
             for k in range(moving)]  # fmt: skip
    flight = fly(tables(*balls, {**BALL, "position": [0.9, 0.0, 0.0]}, duration=0.05))
    each = np.stack([flight.gap(k) for k in range(moving + 1)])
    assert each.min(axis=0) == pytest.approx(flight.gap(), abs=1e-12)
    assert (np.argmin(each[:, -1], axis=0) != moving).any()  # a moving one is nearest to a part


WRONG: dict[str, tuple[dict[str, Any], str]] = {
    "no mass": ({"type": "free"}, "mass"),
    "mass 0": ({"type": "free", "mass": 0.0}, "motion.mass: must be more than 0 kg"),
    "an impossible inertia": (
        {"type": "free", "mass": 1.0, "inertia": [1.0, 1.0, 3.0]}, "no moment larger"
    ),
    "no pivot": ({"type": "pendulum", "mass": 1.0}, "pivot"),
    "a pivot in the middle": (
        {"type": "pendulum", "mass": 1.0, "pivot": [0.5, 0.0, 0.0]}, "must not be the centre of mass"
    ),
    "times that go back": (
        {"type": "table", "time": [0.0, 2.0, 1.0], "angle": [0.0, 0.0, 0.0]}, "must be more than 2 s"
    ),
    "a place too few": (
        {"type": "table", "time": [0.0, 1.0], "position": [[0.0, 0.0, 0.0]]}, "2 instants"
    ),
    "an empty table": ({"type": "table", "time": [0.0, 1.0]}, "needs position, angle or both"),
    "no axis": ({"type": "constant", "axis": [0.0, 0.0, 0.0]}, "must not be zero"),
    "stops on one side": (
        {"type": "hinge", "mass": 1.0, "pivot": [0.0, 0.0, 0.0], "lowest": 0.2},
        "motion.lowest: must be at most 0 deg (got 0.2 rad, which is 11.4592 deg)",
    ),
    "stops on the other side": (
        {"type": "hinge", "mass": 1.0, "pivot": [0.0, 0.0, 0.0], "highest": "-5 deg"},
        "motion.highest: must be at least 0 deg (got '-5 deg')",
    ),
    "an unknown motion": ({"type": "dance"}, "motion"),
}  # fmt: skip


@pytest.mark.parametrize("what", WRONG)
def test_wrong_motions_are_refused_in_a_line(what: str) -> None:
    """The line names the field."""
    motion, words = WRONG[what]
    with pytest.raises(Exception, match=r"world\.obstacles\[0\]") as caught:
        scenario_from(tables({**BALL, "position": [0.5, 0.0, 0.0], "motion": motion}))
    text = str(caught.value)
    assert words in text, text
    assert "\n" not in text.strip(), text


def test_what_has_no_end_has_no_mass() -> None:
    """An endless pole cannot be free, nor turn; a wall can only move as prescribed."""
    pole = {"type": "pole", "position": [0.5, 0.0, 0.0], "radius": 0.1, "surface": SURFACE}
    for motion in ({"type": "free", "mass": 1.0}, {"type": "constant", "turning": 1.0}):
        with pytest.raises(Exception, match=r"an end|without end"):
            scenario_from(tables({**pole, "motion": motion}))
    wall = {
        "type": "wall",
        "distance": 2.0,
        "surface": SURFACE,
        "motion": {"type": "free", "mass": 1.0},
    }
    with pytest.raises(Exception, match="motion"):
        scenario_from(tables(wall))


def test_impulses_and_motion_are_not_combined() -> None:
    """The impulse law of surfaces knows nothing of moving obstacles, and says so."""
    law = {"law": "impulse", "restitution": 0.5}
    moving = {**thrown(), "surface": law}
    with pytest.raises(Exception, match=r"surface\.law: must not be impulse"):
        scenario_from(tables(moving))
