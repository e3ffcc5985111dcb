"""Impacts: found with their numbers, refused with the reason; and what a log could not have shown."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from builders.recordings import (
    CHANGE,
    CONTACT,
    TOUCH,
    acceleration_at,
    attitude_at,
    inertial,
    poses,
    recording,
    whole,
)
from springback.errors import InputError
from springback.frames import euler_from_attitude
from springback.interfaces.cli.identify.logs import impact_text
from springback.logs.axes_options import axes_options, refuse_unused_axes
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.overview import missing_for_impact, overview
from springback.logs.recording import (
    ARM_LENGTH,
    MAPPED,
    POSITION,
    ROTOR_SPEED,
    SPECIFIC_FORCE,
    VELOCITY,
    Recording,
    SensorChain,
    log_channel,
)
from springback.logs.segments import find_impacts


def test_an_impact_is_found_with_its_velocity_change_and_normal() -> None:
    [found] = find_impacts([whole()])
    assert found.refused == ""
    assert set(found.evidence) == {"specific force", "arm length", "bend of the track"}
    assert found.touch == pytest.approx(TOUCH, abs=0.003)
    assert found.release == pytest.approx(TOUCH + CONTACT, abs=0.003)
    assert found.peak == pytest.approx(np.pi / (2.0 * CONTACT) * 3.03, rel=0.03)
    assert found.velocity_change == pytest.approx(CHANGE, abs=0.03)
    assert found.normal == pytest.approx(CHANGE / np.linalg.norm(CHANGE), abs=0.03)
    assert found.window[0] == pytest.approx(found.touch - 0.3)
    assert found.window[1] >= found.release + 0.25


def test_an_impact_is_found_with_the_state_that_it_begins_with() -> None:
    """Velocity by the track, 0.2 s of integrated accelerations; attitude; the arms pressed 10 mm."""
    [found] = find_impacts([whole()])
    fine = np.linspace(0.0, found.touch, 200_001)
    smooth = acceleration_at(fine, np.zeros(3))
    true = np.array([1.0, 0.0, 0.0]) + np.trapezoid(smooth, fine, axis=0)
    assert found.velocity == pytest.approx(true, abs=0.02)
    angles = euler_from_attitude(attitude_at(np.array([found.touch]))[0])
    assert found.attitude == pytest.approx(angles, abs=0.01)
    assert found.pressed is not None
    assert found.pressed[0] in (1, 4)
    assert found.pressed[1] == pytest.approx(0.01)
    [blind] = find_impacts([recording(*inertial())])
    assert (blind.velocity, blind.attitude, blind.pressed) == (None, None, None)


@pytest.mark.parametrize(
    ("made", "wrong"),
    [(("y-up", "y-up"), ("nwu", "flu")), (("ned", "frd"), ("enu", "flu")),
     (("enu", "flu"), ("enu", "frd"))],
)  # fmt: skip
def test_wrong_axes_are_named_as_the_options_to_type(
    made: tuple[str, str], wrong: tuple[str, str]
) -> None:
    """Poses written in some axes and read in others; with the inertial unit beside them."""
    world = WORLDS[wrong[0]] @ WORLDS[made[0]].T
    body = BODIES[wrong[1]] @ BODIES[made[1]].T
    position, attitude = poses()
    read = recording(
        replace(position, values=vectors_in(world, position.values)),
        replace(attitude, values=attitudes_in(world, body, attitude.values)),
        form="MCAP",
    )
    unit = recording(*inertial())
    assert axes_options([read, unit], *wrong) == f"--world {made[0]} --body {made[1]}"
    assert axes_options([recording(position, attitude, form="MCAP"), unit]) == ""


def test_wrong_axes_of_a_mapping_are_named_as_its_lines() -> None:
    """Poses and inertial unit are of one table, whose vectors are all turned."""
    world, body = WORLDS["ned"], BODIES["frd"]
    position, attitude = poses()
    force, gyro = inertial()
    turned = (
        replace(force, values=vectors_in(body, force.values)),
        replace(gyro, values=vectors_in(body, gyro.values)),
        replace(position, values=vectors_in(world, position.values)),
        replace(attitude, values=attitudes_in(world, body, attitude.values)),
    )
    read = {"world": "nwu", "body": "flu"}  # what the mapping says, of a table in NED and FRD
    table = replace(recording(*turned, path="log.csv", form=MAPPED), parameters=read)
    said = '[axes] world = "ned" body = "frd" in the mapping file of log.csv'
    assert axes_options([table]) == said
    with pytest.raises(InputError, match=r"^--world: is not read for log.csv, whose mapping file"):
        refuse_unused_axes([table], world="ned")
    refuse_unused_axes([table, recording(force, form="MCAP")], world="ned")
    refuse_unused_axes([table])
    alone = (force, gyro, *turned[2:])
    table = replace(recording(*alone, path="log.csv", form=MAPPED), parameters=read)
    assert axes_options([table]).startswith(
        '[axes] world = "ned" body = "frd" in a mapping file of their own for the poses of log.csv'
    )


def test_a_log_that_is_cut_off_in_flight_did_not_rest() -> None:
    """At 2 m/s without turning, or as an autopilot's velocity has it."""
    t = np.arange(0.0, 1.0, 0.01)
    still = log_channel("log", "imu", SPECIFIC_FORCE, t, np.tile([0.0, 0.0, 9.81], (100, 1)))
    assert "rests from begin to end" in overview([recording(still)]).verdict
    track = log_channel("log", "v.position", POSITION, t, t[:, None] * [2.0, 0.0, 0.0])
    flown = log_channel("log", "v", VELOCITY, t, np.tile([2.0, 0.0, 0.0], (100, 1)))
    for moving in (track, flown):
        assert "rests" not in overview([recording(still, moving)]).verdict


def test_a_track_alone_tells_no_duration() -> None:
    [found] = find_impacts([recording(*poses())])
    assert impact_text(found).startswith(f"at {found.touch:.4f} s, ")


def test_a_smooth_flight_has_no_impact() -> None:
    quiet = recording(*inertial(change=np.zeros(3)), *poses(change=np.zeros(3)))
    assert find_impacts([quiet]) == []
    assert overview([quiet]).verdict == "no impact"


def test_a_track_alone_shows_an_impact() -> None:
    [found] = find_impacts([recording(*poses())])
    assert found.evidence == ("bend of the track",)
    assert found.touch == pytest.approx(TOUCH + 0.5 * CONTACT, abs=0.02)
    assert np.isnan(found.peak)


def test_clipped_samples_are_counted_and_are_evidence() -> None:
    [found] = find_impacts([recording(*inertial(full_scale=60.0), *poses())])
    assert "clipping" in found.evidence
    assert found.clipped == pytest.approx(
        1000 * CONTACT * (1.0 - 2.0 / np.pi * np.arcsin(60.0 / 152.0)), abs=3
    )
    assert found.peak < 90.0


def test_arm_lengths_alone_show_an_impact() -> None:
    t = np.arange(0.0, 4.0, 0.005)
    pressed = np.where((t > 2.0) & (t < 2.04), 0.01, 0.0)
    lengths = 0.2 - pressed[:, None] * np.ones(4)
    [found] = find_impacts([recording(log_channel("log", "hall", ARM_LENGTH, t, lengths))])
    assert found.evidence == ("arm length",)
    assert (
        find_impacts(
            [recording(log_channel("log", "hall", ARM_LENGTH, t, 0.2 + 0.03 * (lengths - 0.2)))]
        )
        == []
    )


def without(one: Recording, first: float, last: float) -> Recording:
    """A log with a gap."""
    found = []
    for channel in one.channels:
        kept = (channel.times < first) | (channel.times > last)
        clipped = None if channel.clipped is None else channel.clipped[kept]
        found.append(
            replace(
                channel, times=channel.times[kept], values=channel.values[kept], clipped=clipped
            )
        )
    return replace(one, channels=tuple(found))


def part_of(one: Recording, first: float, last: float) -> Recording:
    return without(without(one, -1.0, first), last, 100.0)


def test_an_impact_with_a_gap_in_it_is_refused() -> None:
    [found] = find_impacts([without(recording(*inertial(), *poses()), 2.01, 2.02)])
    assert found.refused == "a gap of 12 ms of accelerometer is in its contact"


def test_an_impact_at_the_end_of_a_log_is_refused() -> None:
    [found] = find_impacts([part_of(recording(*inertial(), *poses()), 0.0, 2.06)])
    assert found.refused.startswith("accelerometer has 2.0")
    assert "0.03 s after it" in found.refused.replace("0.029", "0.03").replace("0.028", "0.03")
    [found] = find_impacts([part_of(recording(*inertial(), *poses()), 1.9, 4.0)])
    assert "has 0.1" in found.refused.replace("0.099", "0.1")


def test_an_accelerometer_that_is_too_slow_is_refused() -> None:
    [found] = find_impacts([recording(*inertial(rate=200.0), *poses())])
    assert found.refused.startswith("accelerometer has ")
    assert "10 are needed" in found.refused


def test_an_impact_without_its_markers_is_refused() -> None:
    place, attitude = poses()
    lost = (place.times > 1.95) & (place.times < 2.2)
    gone = [
        replace(one, values=np.where(lost[:, None], np.nan, one.values))
        for one in (place, attitude)
    ]
    [found] = find_impacts([recording(*inertial(), *gone)])
    assert found.refused.endswith("% of the frames of vehicle.position around it are lost")


def test_a_landing_is_refused() -> None:
    change = np.array([0.8, 0.0, 3.0])
    found = find_impacts([recording(*inertial(change=change), *poses(change=change))])
    assert [one.refused for one in found] == ["its normal points up: a landing"]


def test_a_second_body_nearby_is_refused() -> None:
    near = poses(name="other", aside=(0.0, 0.3, 0.0))
    [found] = find_impacts([recording(*inertial(), *poses(), *near)])
    assert found.refused == "other.position is 0.30 m away: two bodies"
    far = poses(name="other", aside=(0.0, 2.0, 0.0))
    [found] = find_impacts([recording(*inertial(), *poses(), *far)])
    assert found.refused == ""


def test_propellers_that_stop_in_it_are_refused() -> None:
    t = np.arange(0.0, 4.0, 0.01)
    speeds = np.full((len(t), 4), 900.0)
    speeds[t > TOUCH + 0.01, 1] = 0.0
    rotors = log_channel("log", "rpm", ROTOR_SPEED, t, speeds)
    [found] = find_impacts([recording(*inertial(), *poses(), rotors)])
    assert found.refused == "propellers stopped by it (rpm)"


def test_a_track_whose_clock_cannot_be_aligned_is_no_evidence() -> None:
    """Its bend would be anywhere on the accelerometer's clock."""
    force, _ = inertial(start=3.0)
    [found] = find_impacts([recording(force), recording(*poses())])
    assert found.evidence == ("specific force",)
    assert found.touch == pytest.approx(3.0 + TOUCH, abs=0.003)
    assert found.velocity_change is None


def test_two_impacts_are_two_and_rattling_is_one() -> None:
    force, gyro = inertial(4.0)
    again, _ = inertial(4.0, touch=3.0)
    close, _ = inertial(4.0, touch=2.08)
    smooth, _ = inertial(4.0, change=np.zeros(3))

    def both(other) -> Recording:
        return recording(
            replace(force, values=force.values + other.values - smooth.values), gyro, *poses()
        )

    assert len(find_impacts([both(again)])) == 2
    [one] = find_impacts([both(close)])
    assert one.release - one.touch == pytest.approx(0.08 + CONTACT, abs=0.01)


# -- what a log could not have shown -------------------------------------------------------------


def resting(gap: float = 0.0) -> Recording:
    """205 Hz of means at rest, as PX4 logs them by default, with a gap."""
    t = np.arange(0.0, 6.5, 1.0 / 205.0)
    t = t[(t < 1.0) | (t > 1.0 + gap)]
    noise = np.random.default_rng(1).normal(0.0, 0.03, (len(t), 3))
    force = log_channel(
        "log", "sensor_combined.accelerometer", SPECIFIC_FORCE, t, noise + np.array([0.0, 0.0, 9.62]),
        clipped=np.zeros((len(t), 3), bool), chain=SensorChain(average=4.84e-3),
    )  # fmt: skip
    return Recording(Path("log"), "ULog", (force,))


def test_logs_of_two_flights_are_not_taken_for_those_of_one() -> None:
    """The same channel twice at one time; two formats, or parts one after the other, may be one."""
    one = whole()
    other = replace(one, path=Path("second.toml"))
    with pytest.raises(
        InputError, match=r"second\.toml and .* both have .*: they are of two flights"
    ):
        find_impacts([one, other])
    assert find_impacts([one, replace(other, format="another")])
    later = replace(
        other, channels=tuple(replace(c, times=c.times + 100.0) for c in other.channels)
    )
    assert find_impacts([one, later])


def test_a_log_at_rest_with_a_gap_could_not_have_shown_an_impact() -> None:
    found = overview([resting(0.16)])
    assert found.verdict == (
        "no impact, and this log could not have shown one: sensor_combined.accelerometer has "
        "205 Hz, each sample a mean over 4.84 ms: 6 samples in a contact of 31 ms; "
        "sensor_combined.accelerometer has a gap of 166 ms at 0.995 s, into which a contact of "
        "31 ms fits 5 times; the vehicle rests from begin to end"
    )
    missing = " / ".join(found.missing)
    assert "SDLOG_PROFILE = 665" in missing
    for words in ("6 samples in a contact", "flattens", "no rates of turn", "no measured positions",
                  "no speeds nor commands of the rotors"):  # fmt: skip
        assert words in missing


def test_nothing_is_missing_in_a_good_log() -> None:
    assert missing_for_impact([whole()]) == []
    slow = whole()
    filtered = replace(slow.channels[0], chain=SensorChain(low_pass=30.0, full_scale=157.0))
    [said] = missing_for_impact([replace(slow, channels=(filtered, *slow.channels[1:]))])
    assert said == "accelerometer is behind a low-pass of 30 Hz"


def test_an_estimate_is_no_measured_position() -> None:
    place, attitude = poses()
    told = [replace(one, chain=SensorChain(estimated=True)) for one in (place, attitude)]
    one = recording(*inertial(), *told)
    assert any("no measured positions" in text for text in missing_for_impact([one]))
    assert one.best(POSITION) is told[0]
    [found] = find_impacts([one])
    assert "bend of the track" not in found.evidence


def test_the_verdict_counts_what_can_be_used() -> None:
    assert overview([whole()]).verdict == "1 impact"
    assert overview([recording(*inertial(rate=200.0), *poses())]).verdict.startswith(
        "one impact, refused: accelerometer has"
    )
