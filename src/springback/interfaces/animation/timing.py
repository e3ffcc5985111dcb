"""Which instants a film shows: as fast as life, or nearly, and slowly around the impacts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.interfaces.replay.scene import Scene

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Chosen: what is shown before and after the first touch [s], unless said otherwise.
BEFORE, AFTER = 0.30, 0.80
#: Chosen: how much slower than life a film is away from impacts, so that one can follow.
LIFE = 2.0
#: Chosen: slow motion begins so long before a touch, and ends so long after a separation [s].
EARLY, LATE = 0.012, 0.030
#: Chosen: an impact is slow for so long at most [s]; a robot may lean on a wall for ever.
LONGEST = 0.15
#: Chosen: time in which a film slows down [s of flight].
EASING = 0.02
#: Frames that a film may have: chosen, 60 s at 25 frames a second.
MOST_FRAMES = 1500


class FilmTiming(NamedTuple):
    """Instants of a film, counted from the first touch, or from the start where nothing touches."""

    t: Array  # of every frame [s]
    slowness: Array  # of every frame, how many times slower than life
    begin: float
    end: float
    slow: tuple[tuple[float, float], ...]  # what is shown slowly [s]


def origin(scene: Scene) -> float:
    """Where the time of a film is zero: first touch, or the start of the flight [s].

    Args:
        scene: Of a flight.
    """
    return scene.impacts[0][0] if scene.impacts else float(scene.t[0])


def timing(
    scenes: Sequence[Scene],
    *,
    slow: float,
    fps: float,
    begin: float | None = None,
    end: float | None = None,
) -> FilmTiming:
    """The instants of a film.

    Args:
        scenes: One, or two side by side, which touch together.
        slow: How many times slower than life impacts are shown.
        fps: Frames a second.
        begin: First instant, from first touch [s]; by default shortly before it.
        end: Last instant, from first touch [s].

    Raises:
        InputError: If there is nothing between the two, or too much.
    """
    first = min(float(s.t[0]) - origin(s) for s in scenes)
    last = max(float(s.t[-1]) - origin(s) for s in scenes)
    touched = any(s.impacts for s in scenes)
    start = max(first, -BEFORE) if begin is None and touched else first if begin is None else begin
    stop = min(last, AFTER) if end is None and touched else last if end is None else end
    if start >= stop:
        raise InputError(f"--from {start:g} s must be before --to {stop:g} s")
    if start > last or stop < first:
        raise InputError(
            f"--from {start:g} s --to {stop:g} s: the flight is from {first:.3g} to {last:.3g} s, "
            "counted from first touch"
        )
    start, stop = max(start, first), min(stop, last)
    windows = _windows(scenes, start, stop)
    t = _instants(windows, start, stop, max(slow, 1.0), fps)
    return FilmTiming(t, _slowness(t, windows, max(slow, 1.0)), start, stop, windows)


def _windows(scenes: Sequence[Scene], start: float, stop: float) -> tuple[tuple[float, float], ...]:
    """Times shown slowly: the impacts of all scenes with some room, as few intervals."""
    found: list[tuple[float, float]] = []
    spans = [(a - origin(s), b - origin(s)) for s in scenes for a, b in s.impacts]
    for a, b in sorted((a - EARLY, min(b, a + LONGEST) + LATE) for a, b in spans):
        if b <= start or a >= stop:
            continue
        if found and a <= found[-1][1] + 2.0 * EASING:
            found[-1] = (found[-1][0], max(b, found[-1][1]))
        else:
            found.append((a, b))
    return tuple(found)


def _slowness(t: Array, windows: Sequence[tuple[float, float]], slow: float) -> Array:
    """How many times slower than life, easing in and out of the windows."""
    share = np.zeros_like(t)
    for a, b in windows:
        away = np.maximum(0.0, np.maximum(a - t, t - b)) / EASING
        share = np.maximum(share, np.clip(1.0 - away, 0.0, 1.0))
    return np.asarray(LIFE ** (1.0 - share) * max(slow, LIFE) ** share)


def _instants(
    windows: Sequence[tuple[float, float]], start: float, stop: float, slow: float, fps: float
) -> Array:
    """Instants that are equally far apart on the film: flight time integrated over slowness."""
    fine = np.linspace(start, stop, max(2000, int((stop - start) / 2e-4)))
    pace = _slowness(fine, windows, slow)
    shown = np.concatenate([[0.0], np.cumsum(0.5 * (pace[1:] + pace[:-1]) * np.diff(fine))])
    count = int(shown[-1] * fps) + 1
    if count > MOST_FRAMES:
        raise InputError(
            f"a film of {count} frames is too long, {MOST_FRAMES} are the most; give --from and "
            "--to, a smaller --slow or a smaller --fps"
        )
    return np.interp(np.arange(count) / fps, shown, fine)
