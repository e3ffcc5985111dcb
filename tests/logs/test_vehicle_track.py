"""Which of several bodies is the vehicle: by its turns, by its motion, or by name."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from builders.recordings import inertial, poses, recording
from springback.errors import InputError
from springback.logs.frame_check import check_frames
from springback.logs.overview import overview
from springback.logs.recording import ATTITUDE, POSITION, LogChannel, Recording
from springback.logs.segments import find_impacts
from springback.logs.vehicle_track import chosen_track, with_vehicle


def at_rest(name: str) -> list[LogChannel]:
    """A body that lies where it is."""
    place, attitude = poses(name=name)
    still = np.tile([1.0, 0.0, 0.0, 0.0], (len(place.times), 1))
    return [
        replace(place, values=np.tile([3.0, 0.1, 0.5], (len(place.times), 1))),
        replace(attitude, values=still),
    ]


def capture(*channels: LogChannel) -> Recording:
    return recording(*channels, path="take.csv")


def test_the_body_that_turns_as_the_gyroscope_says_is_the_vehicle() -> None:
    """The wall comes first in the file."""
    logs = [recording(*inertial()), capture(*at_rest("wall"), *poses())]
    [wrong] = find_impacts(logs)
    assert wrong.velocity == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
    found = chosen_track(logs)
    assert found.problem == ""
    assert found.sentence == (
        "the vehicle's track is vehicle, not wall: its turns are those of gyroscope"
    )
    [right] = find_impacts(found.recordings)
    assert right.velocity == find_impacts([recording(*inertial()), capture(*poses())])[0].velocity
    told = found.recordings[1]
    assert [one.name for one in told.of(POSITION)] == ["vehicle.position", "wall.position"]
    assert told.of(ATTITUDE)[0].name == "vehicle.attitude"
    assert not any("wall.attitude and" in one.name for one in check_frames(found.recordings))
    assert overview(found.recordings).impacts == (right,)


def test_without_a_gyroscope_the_only_body_that_moves_is_the_vehicle() -> None:
    found = chosen_track([capture(*at_rest("wall"), *poses())])
    assert found.sentence == "the vehicle's track is vehicle, not wall: nothing else moves"


def test_bodies_that_cannot_be_told_apart_are_listed() -> None:
    logs = [capture(*poses(name="chaser"), *at_rest("wall"), *poses())]
    said = (
        r"^take.csv: has 3 bodies, and it cannot be told which is the vehicle .* give --track, or "
        r"track in a plan, one of chaser, wall, vehicle$"
    )
    with pytest.raises(InputError, match=said):
        with_vehicle(logs)
    [named] = with_vehicle(logs, "vehicle")
    assert named.others == ("chaser.position", "chaser.attitude", "wall.position", "wall.attitude")
    with pytest.raises(InputError, match="have no body 'vehicel'; did you mean vehicle"):
        with_vehicle(logs, "vehicel")


def test_one_body_by_two_records_needs_no_name() -> None:
    both = [recording(*inertial(), *poses(name="vision")), capture(*poses())]
    assert with_vehicle(both)[1].others == ()
    [alone] = with_vehicle([capture(*poses())])
    assert alone.others == ()
    with pytest.raises(InputError, match="have no body 'wall'; known are vehicle"):
        with_vehicle([capture(*poses())], "wall")
