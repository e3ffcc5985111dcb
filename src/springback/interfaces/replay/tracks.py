"""Tracks of the obstacles that move: where each is, and how it is turned, over time.

The axes of a moving obstacle are those of the world before it moves, about its origin: its centre
of mass, or the reference point of a prescribed motion.  A point of it that is placed at P is at
x(t) + R(t) (P − o), with o where the origin was placed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import moving_bodies
from springback.contact.moving.bodies import ABSENT, CARRIED, FREE, GIVEN, PIVOTED, MovingBody
from springback.kernels.vectors import Vec
from springback.simulation.measuring.record import Model

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]


class BodyTrack(NamedTuple):
    """Where a moving obstacle is over time."""

    obstacle: int  # its number in the world, from 0
    origin: tuple[float, ...]  # where its origin was placed, world [m]
    rod: tuple[float, ...]  # pivot of one that hangs on a rod, world [m]; empty for others
    position: Array  # of its origin, world [m], shape (instants, 3)
    attitude: Array  # quaternion wxyz, its axes to the world's, shape (instants, 4)


def body_tracks(
    model: Model, columns: Mapping[str, Array], places: Places | slice
) -> tuple[BodyTrack, ...]:
    """Tracks of all moving obstacles at some instants of a trajectory.

    Args:
        model: Of the flight.
        columns: Its trajectory.
        places: Rows of the instants.
    """
    moving = [
        one for one in moving_bodies(model.world.obstacles) if one.kind not in (ABSENT, CARRIED)
    ]
    return tuple(_track(one, columns, places) for one in moving)


def _track(body: MovingBody, columns: Mapping[str, Array], places: Places | slice) -> BodyTrack:
    number = int(body.obstacle)
    x, q = (
        np.stack([columns[f"obstacle{number}_{name}"][places] for name in names], axis=1)
        for names in ("xyz", ("qw", "qx", "qy", "qz"))
    )
    rod = tuple(body.pivot) if body.kind == PIVOTED else ()
    return BodyTrack(number, tuple(_placed(body)), rod, x, _steady(q))


def _placed(body: MovingBody) -> Vec:
    """Where the origin of an obstacle was placed, world [m]."""
    if body.kind == GIVEN:
        return body.path.start
    return body.start.position if body.kind == FREE else body.pivot + body.lever


def _steady(attitude: Array) -> Array:
    """Quaternions without changes of sign from instant to instant."""
    flips = np.sum(attitude[1:] * attitude[:-1], axis=1) < 0.0
    sign = np.where(np.cumsum(flips) % 2 == 1, -1.0, 1.0)
    return np.concatenate([attitude[:1], attitude[1:] * sign[:, None]])


def turned_by(attitude: Array) -> Array:
    """Rotation matrices of quaternions wxyz of any length but zero.

    Args:
        attitude: Shape (..., 4).

    Returns:
        Their axes to the world's, shape (..., 3, 3).
    """
    w, x, y, z = np.moveaxis(attitude / np.linalg.norm(attitude, axis=-1, keepdims=True), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def relative_to(track: BodyTrack, points: Array) -> Array:
    """A flight as a moving obstacle sees it, in its own axes about where it was placed.

    Args:
        track: With as many instants as there are points.
        points: World [m], shape (instants, 3).
    """
    back = turned_by(track.attitude)
    return np.asarray(track.origin + np.einsum("kji,kj->ki", back, points - track.position))


def way_of(track: BodyTrack, points: Array, instants: Sequence[int]) -> Array:
    """Points of a moving obstacle at some instants, world [m].

    Args:
        track: Its track.
        points: Where they are placed, world [m], shape (points, 3).
        instants: Rows of the track.
    """
    rows = np.array(instants)
    turn = turned_by(track.attitude[rows])
    away = np.einsum("kij,pj->kpi", turn, points - np.array(track.origin))
    return np.asarray((track.position[rows][:, None] + away).reshape(-1, 3))
