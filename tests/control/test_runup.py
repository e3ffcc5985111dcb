"""Run-ups: the paper's seven conditions for both robots, feasibility, and what cannot be done."""

from __future__ import annotations

import functools
import math
import re

import numpy as np
import pytest

from builders.cases import nonempty
from springback.contact.cage import ArmTip, Ring
from springback.control.demands import Limits
from springback.control.position import heading
from springback.control.reference_parameters import RunUpSettings
from springback.control.runup import RunUp, RunUpContact, reach, run_up
from springback.control.target import target
from springback.errors import InputError
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec
from springback.vehicle.library import ARQ, QUAD
from springback.vehicle.state import arm_direction

#: Pitch at contact [deg] and speed [m/s], section Impact Resilience.
CONDITIONS = [(0, 2.0), (0, 3.5), (-45, 2.0), (-30, 2.0), (-15, 2.0), (15, 2.0), (30, 2.0)]
ROBOTS = {"quad": QUAD.vehicle, "arq": ARQ.vehicle}
G, THRUST = 9.81, 2.8 * 9.81
EXACT = Ring(0.0)


def limits(robot: str) -> Limits:
    return Limits(ROBOTS[robot].mass, G, THRUST)


@functools.cache
def made(robot: str, pitch: float, speed: float) -> RunUp:
    settings = RunUpSettings(type="run-up", speed=speed, pitch=f"{pitch} deg", begins=1.0)
    airframe = ROBOTS[robot].airframe()
    return settings.run_up(limits(robot), lambda angle: reach(airframe, EXACT, angle))


EVERY = pytest.mark.parametrize(
    ("robot", "pitch", "speed"), [(r, *c) for r in ROBOTS for c in CONDITIONS]
)


@EVERY
def test_arrives_as_wanted(robot: str, pitch: float, speed: float) -> None:
    run, angle = made(robot, pitch, speed), math.radians(pitch)
    front = (0.19 / math.sqrt(2.0) + 0.11) * math.cos(angle)  # arms at 45 deg, Table I
    assert leaves(run.contact_position) == pytest.approx([2.75 - front, 0.0, 1.0], abs=1e-12)
    now = target(run.reference, run.contact_time)
    assert leaves(now.position) == pytest.approx(leaves(run.contact_position), abs=1e-9)
    assert leaves(now.velocity) == pytest.approx([speed, 0.0, 0.0], abs=1e-9)
    assert leaves(now.acceleration) == pytest.approx([G * math.tan(angle), 0.0, 0.0], abs=1e-9)
    assert leaves(now.jerk) == pytest.approx([0.0] * 3, abs=1e-7)  # rounding: 1e-16 · 6/(0.1 s)³
    assert now.yaw == 0.0
    for t in (0.0, 1.0):
        still = target(run.reference, t)
        assert leaves(still.position) == pytest.approx([0.0, 0.0, 1.0], abs=1e-9)
        assert leaves(still.velocity) == pytest.approx([0.0] * 3, abs=1e-9)
        assert leaves(still.acceleration) == pytest.approx([0.0] * 3, abs=1e-9)
        assert leaves(still.jerk) == pytest.approx([0.0] * 3, abs=1e-9)


@EVERY
def test_can_be_flown_and_says_what_it_asks(robot: str, pitch: float, speed: float) -> None:
    run, bounds = made(robot, pitch, speed), limits(robot)
    times = np.linspace(1.0, run.contact_time, 1500)
    path = [target(run.reference, float(t)) for t in times]
    a = np.array([now.acceleration for now in path])
    assert np.abs(a[:, 1:]).max() == 0.0  # straight and level
    tilts = np.arctan2(a[:, 0], G)
    thrust = bounds.mass * np.hypot(a[:, 0], G).max()
    rate = np.abs(np.gradient(tilts, times)).max()
    assert thrust == pytest.approx(run.largest_thrust, rel=1e-4)
    assert np.abs(tilts).max() == pytest.approx(run.largest_tilt, rel=1e-3)
    assert rate == pytest.approx(run.largest_tilt_rate, rel=1e-2)  # differences of 1 to 2 ms
    assert run.largest_thrust <= bounds.max_thrust
    assert run.largest_tilt <= bounds.max_tilt
    assert run.largest_tilt_rate <= bounds.max_body_rate
    assert min(now.velocity.x for now in path) > -1e-3 * speed  # never moves back


@EVERY
def test_is_smooth_up_to_jerk_everywhere(robot: str, pitch: float, speed: float) -> None:
    reference = made(robot, pitch, speed).reference
    for segment in nonempty(reference.segments):
        seam = reference.begins + segment.begins
        left, right = target(reference, seam - 1e-9), target(reference, seam)
        # Snap stays below 1e5 m/s⁴, so jerk moves by at most 1e-4 in 1e-9 s.
        assert np.abs(np.subtract(leaves(left), leaves(right))).max() < 1e-4


@EVERY
def test_pitch_is_steady_before_and_after_contact_and_all_ends_in_rest(
    robot: str, pitch: float, speed: float
) -> None:
    run = made(robot, pitch, speed)
    for dt in (-0.1, -0.05, 0.1, 0.29):
        a = target(run.reference, run.contact_time + dt).acceleration.x
        assert math.degrees(math.atan2(a, G)) == pytest.approx(pitch, abs=1e-5)
    end = target(run.reference, 1.0 + run.reference.duration)
    assert np.abs([*end.velocity, *end.acceleration, *end.jerk]).max() < 1e-9
    assert target(run.reference, 1e3).position.x == pytest.approx(end.position.x, abs=1e-9)
    assert abs(end.position.x - run.contact_position.x) < 5.0  # +30 deg: 3.7 m/s to brake from
    after = np.linspace(run.contact_time, 1.0 + run.reference.duration, 400)
    a = np.array([target(run.reference, float(t)).acceleration.x for t in after])
    assert limits(robot).mass * np.hypot(a, G).max() <= THRUST


def test_positive_pitch_speeds_up_into_the_wall() -> None:
    nose_down, nose_up = made("arq", 30, 2.0), made("arq", -30, 2.0)
    before = [
        target(run.reference, run.contact_time - 0.05).velocity.x for run in (nose_down, nose_up)
    ]
    assert before[0] < 2.0 < before[1]


def test_reach_of_both_contact_models() -> None:
    airframe = ROBOTS["arq"].airframe()
    for angle in (-0.7, 0.0, 0.5):
        ring = (0.19 * math.sqrt(0.5) + 0.11) * math.cos(angle)
        tip = (0.19 + 0.11) * math.sqrt(0.5) * math.cos(angle)
        assert reach(airframe, EXACT, angle) == pytest.approx(ring, abs=1e-12)
        assert reach(airframe, ArmTip(0.0), angle) == pytest.approx(tip, abs=1e-12)


@pytest.mark.parametrize("yaw", [0.0, 0.4, -math.pi / 4, 1.5, 3.0])
def test_reach_at_a_yaw_is_that_of_the_attitude_commanded_there(yaw: float) -> None:
    """The foremost point of circles that are turned, sampled, against the support in body axes."""
    left, *others = ROBOTS["arq"].airframe().arms
    airframe = ROBOTS["arq"].airframe()._replace(arms=(left._replace(length=0.3), *others))
    for pitch in (-0.7, 0.0, 0.5):
        tilt = Vec(math.sin(pitch), 0.0, math.cos(pitch))
        ahead = heading(tilt, yaw).axes.x  # world X in body axes
        rim = [
            arm.length * arm_direction(arm)
            + arm.cage_radius * Vec(math.cos(angle), math.sin(angle), 0.0)
            for arm in airframe.arms
            for angle in np.linspace(-math.pi, math.pi, 20_001)
        ]
        assert reach(airframe, EXACT, pitch, yaw) == pytest.approx(
            max(ahead @ point for point in rim), abs=1e-8
        )


@pytest.mark.parametrize("yaw", [0.0, math.pi / 4])
def test_a_yaw_is_held_all_along_and_meets_the_wall_with_what_is_foremost_then(yaw: float) -> None:
    airframe = ROBOTS["arq"].airframe()
    settings = RunUpSettings(type="run-up", speed=2.0, yaw=yaw)
    run = settings.run_up(limits("arq"), lambda angle: reach(airframe, EXACT, angle, yaw))
    front = 0.19 * math.cos(math.pi / 4 - yaw) + 0.11  # one arm straight ahead, or two beside it
    assert run.contact_position.x == pytest.approx(2.75 - front, abs=1e-12)
    for time in (0.0, run.contact_time, run.contact_time + 0.2, 100.0):
        assert target(run.reference, time).yaw == yaw
    assert run.largest_tilt == pytest.approx(
        made("arq", 0, 2.0).largest_tilt, rel=0.1
    )  # the way is a little shorter


def test_any_heading_is_the_same_run_up() -> None:
    wanted = made("arq", -15, 2.0)
    d = wanted.contact_position.x
    start, contact = Vec(1.0, 2.0, 1.5), Vec(1.0 - 0.6 * d, 2.0 + 0.8 * d, 1.5)
    run = run_up(start, RunUpContact(contact, 2.0, math.radians(-15)), limits("arq"))
    assert run.reference.yaw == pytest.approx(math.atan2(0.8, -0.6))
    assert run.contact_time == pytest.approx(wanted.contact_time - 1.0)
    now = target(run.reference, 0.7 * run.contact_time)
    same = target(wanted.reference, 1.0 + 0.7 * run.contact_time)
    assert leaves(now.velocity) == pytest.approx(
        [-0.6 * same.velocity.x, 0.8 * same.velocity.x, 0.0]
    )
    assert run.largest_tilt_rate == pytest.approx(wanted.largest_tilt_rate)


def test_a_longer_way_is_gentler() -> None:
    rates = [
        run_up(
            Vec(0.0, 0.0, 1.0), RunUpContact(Vec(d, 0.0, 1.0), 3.0, 0.0), limits("quad")
        ).largest_tilt_rate
        for d in (2.0, 3.0, 4.5)
    ]
    assert rates[0] > rates[1] > rates[2]


@pytest.mark.parametrize(
    ("speed", "pitch", "distance", "words"),
    [
        (2.0, 65.0, 2.5, r"thrust of [\d.]+ N, [\d.]+ N beyond the limit of 27.47 N"),
        (2.0, -65.0, 2.5, r"tilt of 65 deg, 5 deg beyond the limit of 60 deg"),
        (12.0, 0.0, 1.1, r"no room for the steady phase"),
        (0.5, 30.0, 2.5, r"steady for less than 0.0883 s \(got 0.1 s\)"),
        (2.0, 0.0, 0.0, "apart from it"),
    ],
)
def test_what_cannot_be_flown_says_why(
    speed: float, pitch: float, distance: float, words: str
) -> None:
    arrival = RunUpContact(Vec(distance, 0.0, 1.0), speed, math.radians(pitch))
    with pytest.raises(InputError, match=words):
        run_up(Vec(0.0, 0.0, 1.0), arrival, limits("arq"))


def test_the_distance_it_asks_for_is_enough() -> None:
    def attempt(distance: float) -> RunUp:
        arrival = RunUpContact(Vec(distance, 0.0, 1.0), 2.0, math.radians(-45))
        return run_up(Vec(0.0, 0.0, 1.0), arrival, limits("arq"))

    with pytest.raises(InputError) as refused:
        attempt(2.0)
    words = str(refused.value)
    assert re.search(r"m more than the 2 m it has; within 2 m it needs a tilt rate of", words)
    needed = float(words.split("distance of ")[1].split(" m")[0])
    assert 2.0 < needed < made("arq", -45, 2.0).contact_position.x  # it does fit the paper's way
    assert attempt(needed * 1.005).largest_tilt_rate <= limits("arq").max_body_rate  # three digits


def test_wall_must_be_before_the_start() -> None:
    settings = RunUpSettings(type="run-up", speed=2.0, wall_distance=0.2)
    with pytest.raises(InputError, match=r"wall_distance .* more than 0\.2444 m"):
        settings.run_up(limits("arq"), lambda pitch: reach(ROBOTS["arq"].airframe(), EXACT, pitch))
