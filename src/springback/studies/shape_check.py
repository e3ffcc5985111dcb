"""Check of an obstacle of the user's own: its distance and normal, seen from all sides."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any

from springback.contact.obstacles import signed_distance
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.progress import Progress, silent
from springback.scenario.user.obstacles import check_shape_from
from springback.studies.pilot_check import Finding

#: Distance of the points of view from the surface [m] (chosen: that of a vehicle before a contact).
AROUND = 0.3
#: Step of finite differences, and distance within which the surface is reached [m] (chosen).
STEP, REACHED = 1e-5, 1e-3
#: Steps to the surface at most: a distance that is understated by half takes some 20.
WALK = 200


def check_shape(shape: Any, start: Vec, *, progress: Progress = silent) -> list[Finding]:
    """Check the functions of a shape where a vehicle could touch it.

    From the start the surface is looked for along the gradient of the distance.  Rays from the
    start, and from 14 points around the nearest point of the surface, then sample both functions
    (`springback.scenario.user.obstacles.check_shape_from`).

    Args:
        shape: A NamedTuple with `signed_distance` and `outward_normal`.
        start: Position of a vehicle, world [m].
        progress: Called with the fraction of the points done.
    """
    problems: list[str] = []
    nearest = None
    try:
        nearest = _nearest(shape, start)
    except InputError as error:
        problems += error.problems
    views = [start, *(_around(nearest) if nearest is not None else ())]
    for k, view in enumerate(views, start=1):
        try:
            check_shape_from(view, shape, "shape")
        except InputError as error:
            problems += error.problems
        progress(k / len(views))
    found = nearest is not None
    where = f"nearest at {_text(nearest)} m" if nearest is not None else "no surface was reached"
    findings = [Finding("has a surface", found, f"seen from {_text(start)} m: {where}")]
    for name, good in (
        ("signed_distance", "finite, nowhere more than the true one, grows by 1 m a metre"),
        ("outward_normal", "1 long, and the gradient of signed_distance"),
    ):
        bad = [line for line in problems if line.startswith(f"shape: {name}")]
        fine = f"{good}, seen from {len(views)} points" if not problems else "no error before that"
        said = bad[0].partition(": ")[2] if bad else fine
        findings.append(Finding(name, not bad, said))
    named = tuple(f"shape: {finding.name}" for finding in findings)
    others = [line for line in problems if not line.startswith(named)]
    if others:
        findings.append(Finding("answers everywhere", False, others[0].partition(": ")[2]))
    return findings


def _nearest(shape: Any, start: Vec) -> Vec | None:
    """Point of the surface that is reached along the gradient; None if there is none."""
    point = start
    for _ in range(WALK):
        gap = _distance(shape, point)
        if abs(gap) < REACHED:
            return point
        slope = [
            (_distance(shape, point + axis) - _distance(shape, point - axis)) / (2.0 * STEP)
            for axis in (Vec(STEP, 0.0, 0.0), Vec(0.0, STEP, 0.0), Vec(0.0, 0.0, STEP))
        ]
        steepness = max(math.hypot(*slope), 1e-3)  # of a distance it is 1
        point = point - (gap / steepness**2) * Vec(*slope)
    return None


def _distance(shape: Any, point: Vec) -> float:
    try:
        value = signed_distance(shape, point)
    except Exception as error:
        what = " ".join(f"{type(error).__name__}: {error}".split())
        raise InputError(f"shape: signed_distance at {_text(point)} m raises {what}") from error
    if not isinstance(value, float) or not math.isfinite(value):
        raise InputError(f"shape: signed_distance at {_text(point)} m is {value!r}, not finite")
    return value


def _around(point: Vec) -> Iterator[Vec]:
    """Points around another, along axes and diagonals."""
    for x, y, z in itertools.product((-1.0, 0.0, 1.0), repeat=3):
        if (count := abs(x) + abs(y) + abs(z)) in (1.0, 3.0):
            yield point + Vec(x, y, z) * (AROUND / count**0.5)


def _text(point: Vec) -> str:
    return f"[{', '.join(f'{part:.4g}' for part in point)}]"
