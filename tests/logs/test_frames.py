"""Turns of axes, and what the data say of them."""

from __future__ import annotations

import itertools
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from builders.recordings import inertial, poses, recording, whole
from springback.errors import InputError
from springback.logs.axes_options import axes_options, refuse_wrong_axes
from springback.logs.frame_check import ORDERS, check_frames, refuse_units
from springback.logs.frame_turns import (
    BODIES,
    WORLDS,
    attitudes_in,
    axis_turns,
    conjugate,
    matrix_quaternion,
    other_order,
    product,
    rotation_vector,
    turn_words,
    vector_quaternion,
    vectors_in,
    world_vectors,
)
from springback.logs.overview import overview
from springback.logs.recording import MAPPED, Recording

#: North, west and up, and forward, left and up, as other axes have them.
OTHERS_NORTH_WEST_UP = {
    "ned": ([1, 0, 0], [0, -1, 0], [0, 0, -1]),
    "enu": ([0, 1, 0], [-1, 0, 0], [0, 0, 1]),
    "y-up": ([1, 0, 0], [0, 0, -1], [0, 1, 0]),
    "nwu": ([1, 0, 0], [0, 1, 0], [0, 0, 1]),
}
OTHERS_FORWARD_LEFT_UP = {
    "frd": ([1, 0, 0], [0, -1, 0], [0, 0, -1]),
    "rfu": ([0, 1, 0], [-1, 0, 0], [0, 0, 1]),
    "flu": ([1, 0, 0], [0, 1, 0], [0, 0, 1]),
}


@pytest.mark.parametrize("name", OTHERS_NORTH_WEST_UP)
def test_north_west_and_up_of_other_axes_are_x_y_and_z(name: str) -> None:
    assert vectors_in(WORLDS[name], OTHERS_NORTH_WEST_UP[name]) == pytest.approx(np.eye(3))


@pytest.mark.parametrize("name", OTHERS_FORWARD_LEFT_UP)
def test_forward_left_and_up_of_other_axes_are_x_y_and_z(name: str) -> None:
    assert vectors_in(BODIES[name], OTHERS_FORWARD_LEFT_UP[name]) == pytest.approx(np.eye(3))


@pytest.mark.parametrize(
    ("world", "body"), list(itertools.product(["ned", "enu", "y-up"], ["frd", "rfu", "y-up"]))
)
def test_a_turned_attitude_turns_turned_vectors(world: str, body: str) -> None:
    """R v in other axes, turned, is the turned R times the turned v."""
    q = Rotation.random(20, random_state=3).as_quat(scalar_first=True)
    v = np.random.default_rng(4).normal(size=(20, 3))
    turned = attitudes_in(WORLDS[world], BODIES[body], q)
    expected = vectors_in(WORLDS[world], world_vectors(q, v))
    assert world_vectors(turned, vectors_in(BODIES[body], v)) == pytest.approx(expected, abs=1e-12)


def test_a_turned_attitude_keeps_its_sign_from_sample_to_sample() -> None:
    t = np.linspace(0.0, 20.0, 400)
    q = vector_quaternion(np.stack([0.0 * t, 0.0 * t, t], axis=1))
    jumping = q * np.where(np.arange(400) % 3 == 0, -1.0, 1.0)[:, None]
    found = attitudes_in(WORLDS["ned"], BODIES["frd"], jumping)
    assert np.einsum("ij,ij->i", found[1:], found[:-1]).min() > 0.99
    lost = jumping.copy()
    lost[5] = np.nan
    found = attitudes_in(WORLDS["ned"], BODIES["frd"], lost)
    assert np.isnan(found[5]).all()
    assert (found[6] @ found[4]) > 0.99


def test_quaternions_agree_with_those_of_scipy() -> None:
    turns = Rotation.random(50, random_state=1)
    q = turns.as_quat(canonical=True, scalar_first=True)
    assert rotation_vector(q) == pytest.approx(turns.as_rotvec(), abs=1e-9)
    back = vector_quaternion(turns.as_rotvec())
    assert back * np.sign(back[:, :1]) == pytest.approx(q, abs=1e-9)
    matrices = np.array([matrix_quaternion(m) for m in turns.as_matrix()])
    assert matrices == pytest.approx(q, abs=1e-9)
    both = (turns[:25] * turns[25:]).as_quat(canonical=True, scalar_first=True)
    mine = product(q[:25], q[25:])
    assert mine * np.sign(mine[:, :1]) == pytest.approx(both, abs=1e-9)


def test_there_are_24_turns_of_axes_and_the_identity_is_the_first() -> None:
    turns = axis_turns()
    assert len({turn.tobytes() for turn in turns}) == 24
    assert [float(np.linalg.det(turn)) for turn in turns] == pytest.approx([1.0] * 24)
    assert np.array_equal(turns[0], np.eye(3))
    assert turn_words(turns[0]) == "x = x, y = y, z = z"


@pytest.mark.parametrize("number", range(24))
def test_every_mistake_of_the_inertial_units_axes_is_found_and_named(number: int) -> None:
    turn = axis_turns()[number]
    wrong = [replace(one, values=one.values @ turn.T) for one in inertial()]
    findings = check_frames([recording(*wrong), recording(*poses())])
    by_name = {one.name: one for one in findings}
    gyro = by_name["vehicle.attitude and gyroscope"]
    track = by_name["vehicle.position and accelerometer"]
    assert gyro.passed is track.passed is (number == 0)
    if number:
        assert turn_words(turn.T) in gyro.sentence
        assert turn_words(turn.T) in track.sentence
    rest = by_name["accelerometer"]
    assert rest.passed is bool(np.array_equal(turn[2], [0.0, 0.0, 1.0]))


@pytest.mark.parametrize("tracked", [True, False])
def test_a_vehicle_that_leans_and_accelerates_has_no_wrong_axes(tracked: bool) -> None:
    """Nose down by 15 degrees: the specific force is along the body's z, not the world's."""
    t = np.arange(0.0, 2.0, 0.001)
    lean = np.radians(15.0)
    turn = np.stack([0.3 * np.sin(9.0 * t), np.full_like(t, lean), 0.0 * t], axis=1)
    q, slow = vector_quaternion(turn), slice(None, None, 5)
    push = world_vectors(q, np.tile([0.0, 0.0, 9.80665 / np.cos(lean)], (len(t), 1)))
    speed = np.cumsum(1e-3 * (push - [0.0, 0.0, 9.80665]), axis=0)
    force, gyro, place, attitude = whole().channels[:4]
    rates = rotation_vector(product(conjugate(q[:-1]), q[1:])) / 1e-3
    channels = [
        replace(force, times=t, values=np.tile(push[:1] * 0.0 + [0.0, 0.0, 9.80665 / np.cos(lean)],
                                               (len(t), 1)), clipped=None),
        replace(gyro, times=t[:-1] + 5e-4, values=rates),
        replace(attitude, times=t[slow], values=q[slow]),
    ]  # fmt: skip
    if tracked:
        track = 1e-3 * np.cumsum(speed, axis=0)[slow]
        channels.append(replace(place, times=t[slow], values=track))
    found = {one.name: one for one in check_frames([recording(*channels)])}
    up = found["vehicle.attitude and accelerometer"]
    assert up.passed, up.sentence
    assert ("gravity is 0." in up.sentence) is tracked
    askew = Rotation.from_euler("y", 20.0, degrees=True).as_matrix()
    channels[0] = replace(channels[0], values=channels[0].values @ askew.T)
    found = {one.name: one for one in check_frames([recording(*channels)])}
    assert found["vehicle.attitude and accelerometer"].passed is not tracked


@pytest.mark.parametrize("world", ["y-up", "ned"])
def test_a_world_whose_z_is_not_up_is_found(world: str) -> None:
    place, attitude = poses()
    turn = WORLDS[world].T
    wrong = [
        replace(place, values=vectors_in(turn, place.values)),
        replace(attitude, values=attitudes_in(turn, np.eye(3), attitude.values)),
    ]
    findings = {one.name: one for one in check_frames([recording(*inertial(), *wrong)])}
    up = findings["vehicle.attitude and accelerometer"]
    assert not up.passed
    assert f"along the world's {'+y' if world == 'y-up' else '-z'}" in up.sentence
    right = check_frames([recording(*inertial(), place, attitude)])
    assert all(one.passed for one in right)


def test_rates_that_no_turn_explains_are_said_so() -> None:
    force, gyro = inertial()
    noise = np.random.default_rng(5).normal(size=gyro.values.shape)
    findings = check_frames([recording(force, replace(gyro, values=noise), *poses())])
    found = next(one for one in findings if "gyroscope" in one.name)
    assert not found.passed
    assert "no turn of axes" in found.sentence


def test_quaternions_that_are_not_of_unit_length_are_found() -> None:
    place, attitude = poses()
    long = replace(attitude, values=1.005 * attitude.values)
    [found] = check_frames([recording(place, long)])
    assert (found.passed, found.sentence) == (False, "|q| = 1 within 0.005")
    with pytest.raises(InputError, match=r"\|q\| is 57\.3 at the median, not 1"):
        refuse_units(recording(replace(attitude, values=57.3 * attitude.values)))


@pytest.mark.parametrize(
    ("factor", "said"),
    [(1e3, "mm/s^2"), (1e-3, "km/s^2"), (1.0 / 9.80665, "g"), (1e3 / 9.80665, "mg")],
)
def test_an_acceleration_in_another_unit_is_refused(factor: float, said: str) -> None:
    force, _ = inertial()
    with pytest.raises(InputError, match=rf"made: accelerometer: .* probably {re.escape(said)}$"):
        refuse_units(recording(replace(force, values=factor * force.values)))
    refuse_units(recording(force))


@pytest.mark.parametrize("factor", [1e-3 / 9.80665, 1e5])
def test_an_acceleration_that_no_unit_explains_is_refused(factor: float) -> None:
    """Readings in g that are called mm/s², for one: its axes were blamed."""
    force, _ = inertial()
    with pytest.raises(InputError, match=r"gravity 9\.81: its unit, or its scale, is wrong$"):
        refuse_units(recording(replace(force, values=factor * force.values)))


@pytest.mark.parametrize(("factor", "said"), [(1e3, "mm"), (1e-3, "km")])
def test_a_position_in_another_unit_is_refused(factor: float, said: str) -> None:
    """Too large by its speed alone, too small by the accelerometer."""
    place, attitude = poses()
    wrong = replace(place, values=factor * place.values)
    with pytest.raises(InputError, match=rf"is probably {said}$"):
        overview([recording(*inertial(), wrong, attitude)])
    if factor > 1.0:
        with pytest.raises(InputError, match="probably mm"):
            refuse_units(recording(wrong))


@pytest.mark.parametrize(
    ("factor", "known", "said"),
    [
        (1e3, None, "no arm is longer than 3 m: its unit is probably mm"),
        (100.0, None, "no arm is longer than 3 m: its unit is probably cm"),
        (1e3, 0.19, "the scenario's longest arm is 0.19 m: its unit is probably mm"),
        (10.0, 0.19, "the scenario's longest arm is 0.19 m: its unit is probably cm"),
        (1e-3, 0.19, "the numbers are probably metres already"),
    ],
)
def test_lengths_that_no_arm_has_are_refused(factor: float, known: float | None, said: str) -> None:
    log = whole()
    arms = log.channels[4]
    with pytest.raises(InputError, match=rf"^made: arm lengths: lengths are .*{re.escape(said)}$"):
        refuse_units(recording(replace(arms, values=factor * arms.values)), known)
    refuse_units(log, known)
    refuse_units(recording(replace(arms, values=arms.values - 0.2)), known)  # compressions


@pytest.mark.parametrize(("factor", "said"), [(180.0 / np.pi, "deg/s"), (1e3, "mrad/s")])
def test_rates_in_another_unit_are_refused(factor: float, said: str) -> None:
    force, gyro = inertial()
    wrong = replace(gyro, values=factor * gyro.values)
    with pytest.raises(InputError, match=rf"unit of gyroscope is probably {said}$"):
        overview([recording(force, wrong, *poses())])


def test_an_accelerometer_at_rest_is_held_to_5_percent() -> None:
    force, _ = inertial(2.0)
    still = np.tile([0.0, 0.0, 9.62], (len(force.times), 1))
    [found] = check_frames([recording(replace(force, values=still))])
    assert (found.passed, found.sentence[:29]) == (True, "+9.62 m/s^2 along z at rest (")
    assert "-1.9 % of gravity" in found.sentence
    [found] = check_frames([recording(replace(force, values=0.94 * still))])
    assert not found.passed


MAPPED_AXES = {"world": "ned", "body": "frd"}


def as_table(channels: Any, order: str = "wxyz", axes: Any = None) -> Recording:
    """Channels as a mapping file reads them, whose quaternions are those of another order."""
    place, attitude = channels
    told = dict(axes or MAPPED_AXES) | {f"{attitude.name}.order": order}
    turns = WORLDS[told["world"]], BODIES[told["body"]]
    wrong = replace(attitude, values=other_order(*turns, attitude.values, ORDERS[order]))
    return replace(recording(place, wrong, form=MAPPED), parameters=told)


@pytest.mark.parametrize("order", ["wxyz", "xyzw"])
def test_the_other_order_of_quaternions_is_found_and_named(order: str) -> None:
    """xyzw read as wxyz, and the other way round; no turn of axes is blamed."""
    log = as_table(poses(), order)
    [found] = [one for one in check_frames([recording(*inertial()), log]) if not one.passed]
    assert found.name == "vehicle.attitude, order"
    assert found.is_mistake
    true = ORDERS[order]
    assert found.sentence.startswith(f"its quaternions are {true}, not {order} as they were read")
    assert "rates of turn agree (1.000)" in found.sentence
    logs = [recording(*inertial()), log]
    assert axes_options(logs) == f'order = "{true}" of vehicle.attitude in the mapping file of made'


def test_a_wrong_order_and_wrong_axes_are_found_together() -> None:
    """The table is NWU and FLU, xyzw; the mapping says NED, FRD and wxyz."""
    place, attitude = poses()
    true = WORLDS["nwu"], BODIES["flu"]
    given = attitudes_in(true[0].T, true[1].T, attitude.values)[:, [1, 2, 3, 0]]
    said = WORLDS["ned"], BODIES["frd"]
    turn = said[0] @ true[0].T
    wrong = [
        replace(place, values=vectors_in(turn, place.values)),
        replace(attitude, values=attitudes_in(*said, given)),
    ]
    told = MAPPED_AXES | {"vehicle.attitude.order": "wxyz"}
    log = replace(recording(*wrong, form=MAPPED), parameters=told)
    # the inertial unit is in the same table, in the same wrong body axes
    body = said[1] @ true[1].T
    imu = [replace(one, values=vectors_in(body, one.values)) for one in inertial()]
    whole_log = replace(log, channels=(*imu, *log.channels))
    assert axes_options([whole_log]) == (
        '[axes] world = "nwu" body = "flu", and order = "xyzw" of vehicle.attitude, in the mapping '
        "file of made"
    )


def test_mistakes_are_refused_and_doubts_are_warnings() -> None:
    force, gyro = inertial()
    turned = [replace(one, values=one.values * [1.0, -1.0, -1.0]) for one in (force, gyro)]
    with pytest.raises(InputError, match=r"not along [+]z: its axes are not FLU"):
        refuse_wrong_axes([recording(*turned, *poses())])
    warned = refuse_wrong_axes([recording(*turned, *poses())], goes_on=True)
    assert any("its axes are not FLU" in text for text in warned)
    weak = replace(force, values=0.75 * force.values)  # a scale, which is no mistake of axes
    [doubt] = refuse_wrong_axes([recording(weak, gyro, *poses())])
    assert "% of gravity" in doubt
    assert refuse_wrong_axes([recording(force, gyro, *poses())]) == []


def test_a_vehicle_that_lies_on_its_side_after_an_impact_has_no_wrong_axes() -> None:
    """Of a flight of 1 s and 9 s on its side the median is along y; the log is only doubted."""
    force, _ = inertial(10.0)
    fallen = np.where(force.times[:, None] < 1.0, [0.0, 0.0, 9.81], [0.0, 9.81, 0.0])
    [found] = check_frames([recording(replace(force, values=fallen, clipped=None))])
    assert (found.passed, found.is_mistake) == (False, False)
    always = np.tile([0.0, 9.81, 0.0], (len(force.times), 1))
    [found] = check_frames([recording(replace(force, values=always, clipped=None))])
    assert found.is_mistake


def test_a_tenth_of_a_second_tells_no_axes() -> None:
    """Some turn of axes always agrees somewhere along the track: once it was called a mistake."""
    _, rate = inertial(0.12)
    turned = replace(rate, values=rate.values * [-1.0, 1.0, -1.0])
    [told] = [x for x in check_frames([recording(turned, *poses())]) if "and gyro" in x.name]
    assert told.passed
    assert "too little" in told.sentence
