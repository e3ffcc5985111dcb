"""Axes that make a log agree with itself, as the options that a user types.

Where poses and inertial unit disagree, every pair of world and body axes that has a name is tried
on the poses that were read: the first with which all findings pass, and which differs least from
what was assumed, is the answer.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from springback.logs.frame_check import check_frames
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import ATTITUDE, POSITION, VELOCITY, LogChannel, Recording

#: Axes that readers assume of poses, by the format.
ASSUMED = {
    "Motive CSV": ("y-up", "y-up"), "Vicon CSV": ("z-up", "flu"), "Qualisys TSV": ("z-up", "flu"),
    "C3D": ("z-up", "flu"), "ROS 1 bag": ("enu", "flu"), "ROS 2 bag": ("enu", "flu"),
    "MCAP": ("enu", "flu"),
}  # fmt: skip
#: Axes of the world that are another's by another name.
_SAME = {"z-up": "nwu"}


def axes_options(
    recordings: Sequence[Recording], world: str | None = None, body: str | None = None
) -> str:
    """Options with which all findings pass, such as ``--world ned --body frd``; empty if none do.

    Args:
        recordings: Logs of one flight, as they were read.
        world: World axes that were given to the readers.
        body: Body axes that were given.
    """
    failed = [one for one in check_frames(recordings) if not one.passed]
    turnable = [one for one in recordings if one.format in ASSUMED and one.of(ATTITUDE)]
    if not failed or not turnable:
        return ""
    pairs = itertools.product((w for w in WORLDS if w not in _SAME), BODIES)
    now: dict[int, tuple[str, str]] = {}
    for one in turnable:
        assumed = ASSUMED[one.format]
        now[id(one)] = world or assumed[0], body or assumed[1]
    read_as = list(now.values())
    for pair in sorted(pairs, key=lambda pair: _differences(pair, read_as)):
        if _differences(pair, read_as) == 0:
            continue
        tried = [_turned(one, now[id(one)], pair) if id(one) in now else one for one in recordings]
        if all(one.passed for one in check_frames(tried)):
            return f"--world {pair[0]} --body {pair[1]}"
    return ""


def _differences(pair: tuple[str, str], now: Sequence[tuple[str, str]]) -> int:
    """How many names of axes differ from those assumed."""
    return sum(
        (pair[0] != _SAME.get(world, world)) + (pair[1] != body) for world, body in now
    )  # fmt: skip


def _turned(one: Recording, now: tuple[str, str], then: tuple[str, str]) -> Recording:
    """A recording whose poses are read in other axes."""
    world = WORLDS[then[0]] @ WORLDS[now[0]].T
    body = BODIES[then[1]] @ BODIES[now[1]].T
    channels = list[LogChannel]()
    for channel in one.channels:
        if channel.quantity == ATTITUDE:
            channel = replace(channel, values=attitudes_in(world, body, channel.values))
        elif channel.quantity in (POSITION, VELOCITY):
            channel = replace(channel, values=vectors_in(world, channel.values))
        channels.append(channel)
    return replace(one, channels=tuple(channels))
