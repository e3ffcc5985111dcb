"""What is made out of collisions that are made up: the wall's normal, whatever friction does."""

import math
from typing import Any

import numba
import numpy as np
import pytest

from springback.kernels.trees import leaves
from springback.kernels.vectors import Quat, Vec, norm, rotation
from springback.recovery.characterisation import (
    Characterisation,
    Collision,
    CollisionObservation,
    CollisionStart,
    characterise,
    contact_point,
    is_within,
    no_observation,
    observation_after,
    window_is_over,
)
from springback.recovery.detection import CollisionInputs
from springback.recovery.line_of_action import face_normal, level_normal, lever_of, pass_of
from springback.recovery.parameters import RecoverySettings
from springback.recovery.wrench import ExternalWrench, RecentImpulse
from springback.sensing.measurement import Estimate, Inertial, Measurement, Pose
from springback.vehicle.library import VEHICLES

AIRFRAME = VEHICLES["quad"].vehicle.airframe()
ARMS, LENGTHS = AIRFRAME.arms, tuple(arm.length for arm in AIRFRAME.arms)
NONE, LEVEL = Vec(0.0, 0.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0)
CHARACTERISATION = RecoverySettings().collision_characterisation(157.0)


def attitude(yaw: float, pitch: float = 0.0) -> Quat:
    """Yaw first, then pitch; positive nose down [deg]."""
    a, b = math.radians(yaw) / 2.0, math.radians(pitch) / 2.0
    c, s, d, t = math.cos(a), math.sin(a), math.cos(b), math.sin(b)
    return Quat(c * d, -s * t, c * t, s * d)


def level(angle: float) -> Vec:
    """Horizontal unit vector [deg]."""
    return Vec(math.cos(math.radians(angle)), math.sin(math.radians(angle)), 0.0)


def off(a: Vec, b: Vec) -> float:
    """Signed angle between level parts [deg]."""
    return math.degrees(math.atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y))


def rim(r: Any, arm: int, normal: Vec) -> np.ndarray[Any, Any]:
    """Foremost point of a cage from the main body, world [m]: independently, by NumPy."""
    turn = np.array(r)
    flat = np.array(normal) - (np.array(normal) @ turn[:, 2]) * turn[:, 2]
    e = np.array([ARMS[arm].cosine, ARMS[arm].sine, 0.0])
    found: np.ndarray[Any, Any] = LENGTHS[arm] * turn @ e + 0.11 * flat / np.linalg.norm(flat)
    return found


def blow_of(r: Any, normal: Vec, pushes: dict[int, np.ndarray[Any, Any]]) -> RecentImpulse:
    """What an observer has summed up of forces at some cages [N s], without rotation meanwhile."""
    turn = np.array(r)
    impulse = np.sum(list(pushes.values()), axis=0)
    moment = np.sum([np.cross(rim(r, arm, normal), push) for arm, push in pushes.items()], axis=0)
    carried, turning = turn.T @ impulse, turn.T @ moment
    return RecentImpulse(Vec(*impulse), Vec(*carried), Vec(*turning), NONE, NONE, NONE, NONE)


def wrench_of(blow: RecentImpulse) -> ExternalWrench:
    return ExternalWrench(NONE, NONE, NONE, (0.0,) * 4, NONE, NONE, blow)


def seen(force: Vec = NONE, lengths: tuple[float, ...] = LENGTHS) -> Measurement:
    still = Estimate(NONE, LEVEL, NONE, NONE)
    return Measurement(Inertial(force, NONE, 1.0), Pose(NONE, LEVEL, 1.0, 0.0), lengths, 1.0, still)


def characterisation_error(
    normal: Vec,
    friction: float,
    arms: dict[int, float],
    *,
    yaw: float = 0.0,
    pitch: float = 0.0,
    pressed: tuple[float, ...] = (0.0,) * 4,
    settings: Characterisation = CHARACTERISATION,
    law: Any = characterise,
) -> Collision:
    """A collision with an upright wall.

    Args:
        normal: Into the wall, world.
        friction: Level friction, a share of the normal force, to the left of the normal.
        arms: Normal impulse on each that was hit [N s].
        yaw: Of the robot [deg].
        pitch: Of the robot, positive nose down [deg].
        pressed: Largest compression of each arm [m].
        settings: Settings.
        law: `characterise`, or its twin.
    """
    q = attitude(yaw, pitch)
    r = rotation(q)
    left = np.array([-normal.y, normal.x, 0.0])
    force = -(np.array(normal) + friction * left)
    blow = blow_of(r, normal, {arm: size * force for arm, size in arms.items()})
    found = no_observation(AIRFRAME)._replace(pressed=pressed, attitude=q, lengths=LENGTHS)
    at = Estimate(Vec(1.0, 2.0, 3.0), q, NONE, NONE)
    start = CollisionStart(Vec(1.0, 2.0, 3.0), Vec(1.0, 0.0, 0.0), NONE)
    said: Collision = law(settings, inputs(seen(), at, wrench_of(blow)), found, start)
    return said


def inputs(measurement: Measurement, at: Estimate, words: ExternalWrench) -> CollisionInputs:
    return CollisionInputs(AIRFRAME, measurement, at, words)


@pytest.mark.parametrize("friction", [-0.4, -0.1, 0.0, 0.2, 0.4])
@pytest.mark.parametrize("wall", [-30.0, -12.0, 8.0, 30.0])
@pytest.mark.parametrize("yaw", [0.0, 77.0])
def test_one_arm_tells_the_normal_whatever_the_friction(
    wall: float, friction: float, yaw: float
) -> None:
    """The arm towards which the wall leans is hit: front left, of index 0, for a positive angle."""
    arm = 0 if wall > 0.0 else 1
    hit = characterisation_error(level(wall + yaw), friction, {arm: 2.0}, yaw=yaw)
    assert abs(off(level(wall + yaw), hit.by_fusion)) < 1e-6
    assert off(level(wall + yaw), hit.by_wrench) == pytest.approx(math.degrees(math.atan(friction)))
    assert hit.arms == tuple(1.0 if j == arm else 0.0 for j in range(4))
    assert hit.direction == hit.by_fusion


@pytest.mark.parametrize("pitch", [-45.0, -20.0, 30.0])
@pytest.mark.parametrize("wall", [-25.0, 20.0])
def test_a_tilted_robot_sees_the_same_normal(pitch: float, wall: float) -> None:
    hit = characterisation_error(level(wall), 0.2, {0 if wall > 0.0 else 1: 2.0}, pitch=pitch)
    assert abs(off(level(wall), hit.by_fusion)) < 0.5


@pytest.mark.parametrize("share", [0.4, 0.5, 0.6])
@pytest.mark.parametrize(("pitch", "friction"), [(0.0, 0.3), (-45.0, 0.1)])
def test_two_arms_tell_the_normal_of_their_common_tangent(
    share: float, pitch: float, friction: float
) -> None:
    """Shared more unequally, two arms with friction cannot be distinguished from one."""
    hit = characterisation_error(
        level(0.0), friction, {0: 2.0 * share, 1: 2.0 - 2.0 * share}, pitch=pitch
    )
    assert abs(off(level(0.0), hit.by_fusion)) < 1e-6
    assert hit.arms == (1.0, 1.0, 0.0, 0.0)


def test_arms_that_were_pressed_in_are_believed_and_those_behind_are_not() -> None:
    """Arms behind slide by their own inertia; what the front ones say is that both were hit."""
    both = (3e-3, 2e-3, 2.5e-3, 2.5e-3)
    hit = characterisation_error(level(0.0), 0.0, {0: 2.0, 1: 0.1}, pressed=both)
    assert hit.arms == (1.0, 1.0, 0.0, 0.0)
    assert abs(off(level(0.0), hit.by_fusion)) < 1e-6


def test_the_arms_alone_say_only_along_which_they_were_pressed() -> None:
    one = characterisation_error(level(15.0), 0.0, {0: 2.0}, pressed=(5e-3, 0.0, 0.0, 0.0))
    assert off(level(45.0), one.by_arms) == pytest.approx(0.0, abs=1e-9)
    two = characterisation_error(level(0.0), 0.0, {0: 1.0, 1: 1.0}, pressed=(5e-3, 5e-3, 0.0, 0.0))
    assert off(level(0.0), two.by_arms) == pytest.approx(0.0, abs=1e-9)
    assert characterisation_error(level(0.0), 0.0, {0: 1.0}).by_arms == NONE


@pytest.mark.parametrize("source", ["arms", "acceleration", "wrench", "fused"])
def test_the_source_that_is_chosen_is_relied_on(source: str) -> None:
    settings = RecoverySettings.model_validate({"characterisation": {"source": source}})
    pressed = (5e-3, 0.0, 0.0, 0.0)
    hit = characterisation_error(
        level(20.0),
        0.3,
        {0: 2.0},
        pressed=pressed,
        settings=settings.collision_characterisation(157.0),
    )
    ways = {
        "arms": hit.by_arms, "wrench": hit.by_wrench, "fused": hit.by_fusion,
        "acceleration": hit.by_wrench,  # says nothing here, so the wrench is asked
    }  # fmt: skip
    assert hit.direction == ways[source]


def test_the_accelerometer_points_away_from_the_obstacle() -> None:
    """The wall is where the specific force comes from: the robot is pushed the other way."""
    found = no_observation(AIRFRAME)._replace(jolted=Vec(-30.0, 40.0, 0.0), lengths=LENGTHS)
    at, words = Estimate(NONE, LEVEL, NONE, NONE), wrench_of(RecentImpulse(*(NONE,) * 7))
    hit = characterise(
        CHARACTERISATION, inputs(seen(), at, words), found, CollisionStart(NONE, NONE, NONE)
    )
    assert hit.by_acceleration == pytest.approx((0.6, -0.8, 0.0))
    assert hit.by_fusion == hit.by_wrench == NONE


def test_without_any_push_the_way_of_flight_is_taken() -> None:
    hit = characterisation_error(level(0.0), 0.0, {0: 0.0})
    assert hit.direction == Vec(1.0, 0.0, 0.0)


def anywhere() -> Characterisation:
    """Settings for obstacles of any inclination."""
    free = RecoverySettings.model_validate({"characterisation": {"level": False}})
    return free.collision_characterisation(157.0)


@pytest.mark.parametrize("lean", [-50.0, -20.0, 0.0, 35.0, 60.0])
@pytest.mark.parametrize("pitch", [0.0, -25.0])
def test_the_normal_of_a_leaning_face_is_found_whatever_the_friction_along_it(
    lean: float, pitch: float
) -> None:
    """A level robot's cage is level where it touches, and so is the friction here."""
    flat, up = math.cos(math.radians(lean)), math.sin(math.radians(lean))
    heading = level(20.0)
    normal = Vec(flat * heading.x, flat * heading.y, up)
    friction = 0.3 if pitch == 0.0 else 0.0
    hit = characterisation_error(
        normal, friction, {0: 2.0}, yaw=0.0, pitch=pitch, settings=anywhere()
    )
    assert np.allclose(hit.by_fusion, normal, atol=1e-6)
    assert np.linalg.norm(hit.by_fusion) == pytest.approx(1.0)
    upright = characterisation_error(normal, friction, {0: 2.0}, pitch=pitch)
    assert upright.by_fusion.z == 0.0


def test_two_cages_on_a_pole_have_no_common_tangent() -> None:
    """Pushed from ahead and to the right: an upright wall would be straight ahead."""
    heading = level(25.0)
    pushes = {0: 1.0, 1: 1.0}
    any_shape = characterisation_error(
        heading, 0.0, pushes, pressed=(5e-3, 5e-3, 0.0, 0.0), settings=anywhere()
    )
    assert off(heading, any_shape.by_fusion) == pytest.approx(0.0, abs=1e-6)
    wall = characterisation_error(heading, 0.0, pushes, pressed=(5e-3, 5e-3, 0.0, 0.0))
    assert off(level(0.0), wall.by_fusion) == pytest.approx(0.0, abs=1e-6)


def test_friction_up_a_face_is_taken_for_an_inclination() -> None:
    """What force and moment cannot tell apart: atan μ."""
    force = -np.array([1.0, 0.0, 0.4])
    r = rotation(LEVEL)
    blow = blow_of(r, level(0.0), {0: 2.0 * force})
    found = no_observation(AIRFRAME)._replace(attitude=LEVEL, lengths=LENGTHS)
    start = CollisionStart(NONE, Vec(1.0, 0.0, 0.0), NONE)
    at = Estimate(NONE, LEVEL, NONE, NONE)
    hit = characterise(anywhere(), inputs(seen(), at, wrench_of(blow)), found, start)
    assert hit.by_fusion.z == pytest.approx(math.sin(math.atan(0.4)), abs=1e-6)


@pytest.mark.parametrize("pitch", [0.0, -45.0, 30.0])
def test_the_contact_point_is_that_of_the_circle(pitch: float) -> None:
    r = rotation(attitude(10.0, pitch))
    place, normal = Vec(1.0, 2.0, 3.0), level(25.0)
    point = contact_point(AIRFRAME, place, r, LENGTHS, (1.0, 0.0, 0.0, 0.0), normal)
    np.testing.assert_allclose(point, np.array(place) + rim(r, 0, normal), atol=1e-12)
    hit = characterisation_error(level(25.0), 0.2, {0: 2.0})
    at = np.array(place) + rim(rotation(LEVEL), 0, level(25.0))
    np.testing.assert_allclose(hit.contact_point, at, atol=1e-9)


def test_the_lever_arm_is_moment_over_force() -> None:
    blow = RecentImpulse(NONE, Vec(-3.0, -4.0, 9.0), Vec(0.0, 0.0, 0.5), NONE, NONE, NONE, NONE)
    assert lever_of(blow) == pytest.approx(-0.1)
    assert lever_of(RecentImpulse(NONE, NONE, Vec(0.0, 0.0, 0.5), NONE, NONE, NONE, NONE)) == 0.0


def test_a_line_through_an_arm_passes_through_the_opposite_one_too_but_meets_the_front() -> None:
    met = pass_of(AIRFRAME, LENGTHS, level(45.0), 0.0)
    assert met.one == (1.0, 0.0, 0.0, 0.0)
    assert met.sine == pytest.approx(0.0, abs=1e-12)


def test_turning_back_undoes_a_turn_and_a_tilted_plane_keeps_the_level_normal() -> None:
    assert off(face_normal(level(30.0), math.sin(math.radians(12.0))), level(18.0)) < 1e-9
    r, normal = rotation(attitude(20.0, -40.0)), level(55.0)
    flat = np.array(r).T @ np.array(normal)
    found = level_normal(r, Vec(float(flat[0]), float(flat[1]), 0.0))
    np.testing.assert_allclose(found, normal, atol=1e-12)


def test_what_was_strongest_is_kept_and_clipped_readings_say_no_direction() -> None:
    at, nothing = Estimate(NONE, attitude(90.0), NONE, NONE), wrench_of(blow_of(
        rotation(LEVEL), level(0.0), {0: np.zeros(3)}))  # fmt: skip
    so_far = no_observation(AIRFRAME)
    for reading in (40.0, 90.0, 150.0, 60.0):
        now = inputs(seen(Vec(-reading, 0.0, 9.81)), at, nothing)
        so_far = observation_after(CHARACTERISATION, now, so_far)
    assert so_far.ticks == 4.0
    assert norm(so_far.jolted - Vec(0.0, -90.0, 0.0)) < 1e-9  # body x is world y
    assert so_far.clipped == 3.0  # the third of four
    assert is_within(CHARACTERISATION.limit, Vec(0.0, -100.0, 0.0))
    assert not is_within(CHARACTERISATION.limit, Vec(0.0, 0.0, 150.0))


def test_it_looks_longer_only_where_nothing_but_a_clipped_accelerometer_felt_it() -> None:
    """Ticks are of 1 ms; the reading of the eighth was clipped."""
    clear = no_observation(AIRFRAME)

    def enough(at: int, clipped: float, pressed: float, second: float = 0.0) -> bool:
        found = clear._replace(ticks=float(at), clipped=clipped, pressed=(pressed, 0.0, 0.0, 0.0))
        return bool(window_is_over(CHARACTERISATION, found, (1.0, second, 0.0, 0.0), 1e-3 * at))

    window, longer = round(1e3 * CHARACTERISATION.window), round(1e3 * CHARACTERISATION.longer)
    assert not enough(window - 1, 0.0, 0.0)
    assert enough(window + 1, 0.0, 0.0)
    assert enough(window + 1, 8.0, 5e-3)
    assert enough(window + 1, 8.0, 0.0, second=1.0)
    assert not enough(8 + longer - 1, 8.0, 0.0)
    assert enough(8 + longer + 1, 8.0, 0.0)


def test_plain_and_compiled_are_twins() -> None:
    @numba.njit
    def law(a: Any, b: Any, c: Any, d: Any) -> Any:
        return characterise(a, b, c, d)

    @numba.njit
    def seen_once(a: Any, b: Any, c: Any) -> Any:
        return observation_after(a, b, c)

    for wall, pressed in ((20.0, (0.0,) * 4), (-10.0, (0.0, 6e-3, 0.0, 0.0))):
        arms = {0 if wall > 0.0 else 1: 2.0}
        plain = characterisation_error(level(wall), 0.25, arms, pitch=-20.0, pressed=pressed)
        compiled = characterisation_error(
            level(wall), 0.25, arms, pitch=-20.0, pressed=pressed, law=law
        )
        np.testing.assert_allclose(leaves(compiled), leaves(plain), rtol=0.0, atol=1e-12)
    so_far: CollisionObservation = no_observation(AIRFRAME)
    at, force = Estimate(NONE, attitude(30.0), NONE, NONE), seen(Vec(-40.0, 3.0, 9.81))
    words = wrench_of(blow_of(rotation(LEVEL), level(0.0), {0: np.ones(3)}))
    now = inputs(force, at, words)
    plain_seen = observation_after(CHARACTERISATION, now, so_far)
    assert leaves(seen_once(CHARACTERISATION, now, so_far)) == leaves(plain_seen)
