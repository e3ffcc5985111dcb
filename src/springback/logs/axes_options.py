"""Axes that make a log agree with itself, as the options that a user types.

Where poses and inertial unit disagree, every pair of world and body axes that has a name is tried
on the poses that were read: the first with which all findings pass, and which differs least from
what was assumed, is the answer; or the other order of a table's quaternions, or both.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import replace

from springback.errors import InputError, shown_value
from springback.logs.frame_check import (
    ORDER,
    ORDER_KEY,
    ORDERS,
    FrameFinding,
    check_frames,
)
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
    MAPPED,
    POSITION,
    SPECIFIC_FORCE,
    VELOCITY,
    LogChannel,
    Recording,
)

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
    """What to type for all findings to pass; empty if nothing would, or if they do.

    Options such as ``--world ned --body frd``, or lines of a mapping file, such as ``[axes] world =
    "ned" body = "frd"``.

    Args:
        recordings: Logs of one flight, as they were read.
        world: World axes that were given to the readers.
        body: Body axes that were given.
    """
    found = check_frames(recordings)
    if all(one.passed for one in found):
        return ""
    posed = [one for one in recordings if one.of(ATTITUDE)]
    turnable = [one for one in posed if one.format in ASSUMED]
    now = {
        id(one): (world or ASSUMED[one.format][0], body or ASSUMED[one.format][1])
        for one in turnable
    }
    if pair := _passing(recordings, now):
        return f"--world {pair[0]} --body {pair[1]}"
    mapped = [one for one in posed if one.format == MAPPED and "world" in one.parameters]
    now = {id(one): (str(one.parameters["world"]), str(one.parameters["body"])) for one in mapped}
    where = ", ".join(one.path.name for one in mapped)
    for poses_alone in (False, True):
        if pair := _passing(recordings, now, poses_alone):
            line = f'[axes] world = "{pair[0]}" body = "{pair[1]}"'
            if poses_alone:
                return f"{line} in a mapping file of their own for the poses of {where}"
            return f"{line} in the mapping file of {where}"
    if _is_order_only(found):
        return f"{_order_words(mapped, found)} in the mapping file of {where}"
    if pair := _passing(recordings, now, poses_alone=False, orders=True):
        line = f'[axes] world = "{pair[0]}" body = "{pair[1]}"'
        turned = [
            _turned(one, now[id(one)], pair, False) if id(one) in now else one for one in recordings
        ]
        words = _order_words(mapped, check_frames(turned))
        return f"{line}, and {words}, in the mapping file of {where}"
    return ""


def _is_order_only(found: Sequence[FrameFinding]) -> bool:
    """True if all findings pass but those on the order of quaternions."""
    return all(one.passed or one.name.endswith(ORDER) for one in found)


def _order_words(mapped: Sequence[Recording], found: Sequence[FrameFinding]) -> str:
    """The other order of those quaternions that need it, such as ``order = "xyzw" of pose``."""
    wrong = [one.name.removesuffix(ORDER) for one in found if not one.passed]
    told = {
        name: ORDERS[str(one.parameters[name + ORDER_KEY])]
        for one in mapped for name in wrong if name + ORDER_KEY in one.parameters
    }  # fmt: skip
    return ", ".join(f'order = "{order}" of {name}' for name, order in told.items())


def refuse_wrong_axes(
    recordings: Sequence[Recording],
    world: str | None = None,
    body: str | None = None,
    *,
    goes_on: bool = False,
) -> list[str]:
    """Refuse logs whose axes, or order of quaternions, their own data contradict.

    Args:
        recordings: Logs of one flight, as they were read.
        world: World axes that were given to the readers.
        body: Body axes that were given.
        goes_on: Return what is refused as warnings.

    Returns:
        Findings that fail and may have another reason, a sentence each.

    Raises:
        InputError: In one line for each mistake, the first with what to type.
    """
    failed = [one for one in check_frames(recordings) if not one.passed]
    if not failed:
        return []
    names = ", ".join(str(one.path) for one in recordings)
    options = axes_options(recordings, world, body)
    failed.sort(key=lambda one: not one.is_mistake)
    said = [f"{names}: {one.name}: {one.sentence}" for one in failed]
    said[0] += f"; all findings pass with {options}" if options else ""
    mistakes = [text for text, one in zip(said, failed, strict=True) if one.is_mistake]
    if mistakes and not goes_on:
        raise InputError(*mistakes)
    return said


def refuse_unused_axes(
    recordings: Sequence[Recording], world: str | None = None, body: str | None = None
) -> None:
    """Refuse names of axes that no log of a flight is read by.

    Args:
        recordings: The logs.
        world: World axes that were given.
        body: Body axes that were given.

    Raises:
        InputError: If a log with a mapping, which has its own, is the only one that could.
    """
    if any(one.format in ASSUMED for one in recordings):
        return
    for name, word in (("world", world), ("body", body)):
        mapped = next((one for one in recordings if one.format == MAPPED), None)
        if word is not None and mapped is not None:
            raise InputError(
                f"--{name}: is not read for {mapped.path}, whose mapping file says its axes: write "
                f'{name} = "{word}" there, under [axes] (got {shown_value(word)})'
            )


def _passing(
    recordings: Sequence[Recording],
    now: Mapping[int, tuple[str, str]],
    poses_alone: bool = True,
    orders: bool = False,
) -> tuple[str, str] | None:
    """Axes in which all findings pass, those nearest to the present ones first.

    Args:
        recordings: The logs.
        now: Axes of those that can be read in others, by their identity.
        poses_alone: False if a log's inertial unit is read in the same body axes.
        orders: True if the order of quaternions may be another one, too.
    """
    if not now:
        return None
    read_as = list(now.values())
    pairs = itertools.product((w for w in WORLDS if w not in _SAME), BODIES)
    for pair in sorted(pairs, key=lambda pair: _differences(pair, read_as)):
        if _differences(pair, read_as) == 0:
            continue
        tried = [
            _turned(one, now[id(one)], pair, poses_alone) if id(one) in now else one
            for one in recordings
        ]
        found = check_frames(tried)
        if all(one.passed for one in found) or (orders and _is_order_only(found)):
            return pair
    return None


def _differences(pair: tuple[str, str], now: Sequence[tuple[str, str]]) -> int:
    """How many names of axes differ from those assumed."""
    return sum(
        (pair[0] != _SAME.get(world, world)) + (pair[1] != body) for world, body in now
    )  # fmt: skip


def _turned(
    one: Recording, now: tuple[str, str], then: tuple[str, str], poses_alone: bool
) -> Recording:
    """A recording whose poses, or whose poses and inertial unit, are read in other axes."""
    world = WORLDS[then[0]] @ WORLDS[now[0]].T
    body = BODIES[then[1]] @ BODIES[now[1]].T
    channels = list[LogChannel]()
    for channel in one.channels:
        if channel.quantity == ATTITUDE:
            channel = replace(channel, values=attitudes_in(world, body, channel.values))
        elif channel.quantity in (POSITION, VELOCITY):
            channel = replace(channel, values=vectors_in(world, channel.values))
        elif channel.quantity in (SPECIFIC_FORCE, ANGULAR_VELOCITY) and not poses_alone:
            channel = replace(channel, values=vectors_in(body, channel.values))
        channels.append(channel)
    told = {**one.parameters, "world": then[0], "body": then[1]}
    return replace(one, channels=tuple(channels), parameters=told)
