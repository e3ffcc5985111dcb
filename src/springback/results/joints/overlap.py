"""Cages of one vehicle that come into each other: they do not touch in the model."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Any

import numpy as np

from springback.vehicle.arms.joints import STRAIGHT
from springback.vehicle.arms.settings import LEVEL, Arms
from springback.vehicle.parameters import Vehicle

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Overlap that is told [m] (chosen: a cage gives way by as much).
TOLD = 2e-3
#: Vertical share of a hinge's axis from which cages on it stay level.
UPRIGHT = 1.0 - 1e-9


def overlapping_cages(vehicle: Vehicle, columns: Mapping[str, Array]) -> str | None:
    """A sentence on the cages that came into each other most, if any did.

    Ends of arms on two joints are taken as if the second stood still, and cages that tilt as balls.

    Args:
        vehicle: The one that flew.
        columns: Of its trajectory; without one nothing is known.
    """
    arms, count = vehicle.arms, vehicle.arm_count
    if not arms.cages or not vehicle.is_compliant or "l1" not in columns:
        return None
    ends = [end_positions(vehicle, j, columns[f"l{j + 1}"]) for j in range(count)]
    worst, sentence = TOLD, None
    for i, j in combinations(range(count), 2):
        room = float(arms.at("cage_radius", i) + arms.at("cage_radius", j))
        apart = ends[i] - ends[j]
        overlap = room - np.linalg.norm(apart, axis=1)
        if not (cage_tilts(arms, i) or cage_tilts(arms, j)):
            overlap = -level_gap(apart, room, LEVEL)
        at = int(overlap.argmax())
        if overlap[at] > worst:
            worst = float(overlap[at])
            sentence = (
                f"cages of arms {i + 1} and {j + 1} came {1e3 * worst:.3g} mm into each other, at "
                f"{columns['t'][at]:.4g} s: parts of one vehicle do not touch here; a shorter "
                "travel with end stops, or stiffer springs, keep them apart"
            )
    return sentence


def level_gap(apart: Array, room: float, level: float) -> Array:
    """Gap between two level circles [m]; less than 0 if they overlap at one height.

    Args:
        apart: From one middle to the other [m], shape (..., 3).
        room: Sum of their radii [m].
        level: Difference of heights below which they can meet side by side [m].
    """
    beside, above = np.hypot(apart[..., 0], apart[..., 1]) - room, np.abs(apart[..., 2])
    found: Array = np.where(above < level, beside, np.hypot(np.maximum(beside, 0.0), above))
    return found


def cage_tilts(arms: Arms, arm: int) -> bool:
    """True if the cage of an arm tilts as the arm turns about its first joint."""
    path = arms.joint_of(arm)
    axis = path.direction ^ path.inward
    return bool(arms.hinges[0]) and abs(axis.z) < UPRIGHT


def end_positions(vehicle: Vehicle, arm: int, lengths: Array) -> Array:
    """Ends of an arm in body axes [m], shape (instants, 3), by its first joint."""
    joint = vehicle.arms.joint_of(arm)
    way = lengths - float(vehicle.arms.at("length", arm))
    k = joint.curvature
    ahead = np.sin(k * way) / k if k > STRAIGHT else way
    aside = (1.0 - np.cos(k * way)) / k if k > STRAIGHT else np.zeros_like(way)
    found = np.array(joint.end) + np.outer(ahead, joint.direction) + np.outer(aside, joint.inward)
    return np.asarray(found)
