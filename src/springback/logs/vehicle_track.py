"""Which of several bodies that a motion capture tracked is the vehicle.

It is the one whose turns are those of the gyroscope, else the only one that moves, else the one
that a user names.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from springback.errors import InputError, shown_value
from springback.logs.frame_check import AGREED, offset_of
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
    POSITION,
    VELOCITY,
    LogChannel,
    Recording,
)
from springback.problems import nearest_name

#: Largest distance of a body at rest from its middle [m] (chosen: noise, and what is knocked).
STILL = 0.05


class _Tracked(NamedTuple):
    log: int
    name: str
    position: LogChannel
    attitude: LogChannel | None


class ChosenTrack(NamedTuple):
    """Logs of which the vehicle's track is known, or why it is not."""

    recordings: list[Recording]
    problem: str  # empty if it is known, or there is only one
    sentence: str  # which was chosen, of several, and why


def chosen_track(recordings: Sequence[Recording], name: str | None = None) -> ChosenTrack:
    """Logs of one flight, those bodies named in them that are not the vehicle.

    Args:
        recordings: The logs.
        name: Of the vehicle's body, if a user gives it.

    Raises:
        InputError: If there is no such body.
    """
    bodies = [body for k, one in enumerate(recordings) for body in _bodies(k, one)]
    names = list(dict.fromkeys(one.name for one in bodies))
    if name is not None and name not in names:
        near = nearest_name(name, dict.fromkeys(names))
        known = f"known are {', '.join(names)[:300]}" if names else "there is none"
        raise InputError(
            f"track: the logs have no body {shown_value(name)}; "
            + (f"did you mean {near}?" if near else known)
        )
    if len(names) < 2:
        return ChosenTrack(list(recordings), "", "")
    if name is not None:
        taken, why = [name], "as it was named"
    else:
        taken, why = _told(recordings, bodies)
    if not taken:
        where = recordings[bodies[0].log].path
        return ChosenTrack(
            list(recordings),
            f"{where}: has {len(names)} bodies, and it cannot be told which is the vehicle (turns "
            "of none are those of a gyroscope): give --track, or track in a plan, one of "
            f"{', '.join(names)[:300]}",
            "",
        )
    others = [name for name in names if name not in taken]
    marked = [
        replace(one, others=tuple(c.name for c in one.channels if _body_of(c) in others))
        for one in recordings
    ]
    left = f", not {', '.join(others)}" if others else ""
    return ChosenTrack(marked, "", f"the vehicle's track is {', '.join(taken)}{left}: {why}")


def with_vehicle(recordings: Sequence[Recording], name: str | None = None) -> list[Recording]:
    """Logs of one flight whose vehicle's track is known.

    Args:
        recordings: The logs.
        name: Of the vehicle's body, if a user gives it.

    Raises:
        InputError: With the list of bodies, if there are several and it cannot be told.
    """
    chosen = chosen_track(recordings, name)
    if chosen.problem:
        raise InputError(chosen.problem)
    return chosen.recordings


def _body_of(channel: LogChannel) -> str:
    """Name of the body of a pose; empty for other channels and for estimates."""
    if channel.quantity not in (POSITION, ATTITUDE, VELOCITY) or channel.chain.estimated:
        return ""
    return channel.name.rpartition(".")[0] or channel.name


def _bodies(log: int, recording: Recording) -> list[_Tracked]:
    found = []
    for position in recording.of(POSITION):
        if name := _body_of(position):
            attitude = next(
                (one for one in recording.of(ATTITUDE) if _body_of(one) == name), None
            )  # fmt: skip
            found.append(_Tracked(log, name, position, attitude))
    return found


def _told(recordings: Sequence[Recording], bodies: Sequence[_Tracked]) -> tuple[list[str], str]:
    """Names of the vehicle's bodies, which may be several records of one, and why."""
    gyros = [
        (one, channel) for one in recordings for channel in one.of(ANGULAR_VELOCITY)
        if not channel.chain.estimated
    ]  # fmt: skip
    gyro = max(gyros, key=lambda pair: pair[1].rate, default=None)
    if gyro is not None:
        turning = [
            one.name for one in bodies
            if one.attitude is not None
            and offset_of(recordings[one.log], one.attitude, gyro).correlation >= AGREED
        ]  # fmt: skip
        if turning:
            return turning, f"its turns are those of {gyro[1].name}"
    moving = [one.name for one in bodies if _moves(one.position)]
    return (moving, "nothing else moves") if len(moving) == 1 else ([], "")


def _moves(track: LogChannel) -> bool:
    values = track.values[~track.is_lost]
    return bool(len(values) and np.ptp(values, axis=0).max() > 2.0 * STILL)
