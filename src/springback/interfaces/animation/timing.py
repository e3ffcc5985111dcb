"""Instants of a film: close to real time, with slow motion around the impacts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.interfaces.replay.scene import Scene

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Chosen: time shown before and after the first touch by default [s].
BEFORE, AFTER = 0.30, 0.80
#: Chosen: slow-motion factor away from impacts, so that one can follow.
LIFE = 2.0
#: Chosen: slow motion begins this long before a touch and ends this long after a separation [s].
EARLY, LATE = 0.012, 0.030
#: Chosen: longest slow motion of an impact [s]; a robot may lean on a wall indefinitely.
LONGEST = 0.15
#: Chosen: flight time in which a film slows down [s].
EASING = 0.02
#: Maximum number of frames of a film (chosen: 60 s at 25 frames per second).
MOST_FRAMES = 1500


class FilmTiming(NamedTuple):
    """Instants of a film, relative to first touch, or to the start if there is no contact."""

    t: Array  # of every frame [s]
    slowness: Array  # of every frame: slow-motion factor
    begin: float
    end: float
    slow: tuple[tuple[float, float], ...]  # intervals in slow motion [s]


def origin(scene: Scene) -> float:
    """Time origin of a film: first touch, or the start of the flight [s].

    Args:
        scene: Of a flight.
    """
    if scene.first_touch is not None:
        return scene.first_touch
    return scene.impacts[0][0] if scene.impacts else float(scene.t[0])


def timing(
    scenes: Sequence[Scene],
    *,
    slow: float,
    fps: float,
    begin: float | None = None,
    end: float | None = None,
) -> FilmTiming:
    """Instants of a film.

    Args:
        scenes: One, or two side by side, synchronised at first touch.
        slow: Slow-motion factor of impacts.
        fps: Frames a second.
        begin: First instant, from first touch [s]; by default shortly before it.
        end: Last instant, from first touch [s].

    Raises:
        InputError: If the interval is empty, or has too many frames.
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


def impacts_left_out(scenes: Sequence[Scene]) -> str:
    """Which impacts begin after the end of a film of the usual length, in words; empty if none.

    Args:
        scenes: As for `timing`.
    """
    spans = [(a - origin(s), b - origin(s)) for s in scenes for a, b in s.impacts]
    later = sorted(span for span in spans if span[0] > AFTER)
    if not later:
        return ""
    count, first = len(later), later[0][0]
    end = math.ceil(100.0 * (max(b for _, b in later) + LATE)) / 100.0
    if count == 1:
        return (
            f"a later impact, {first:.3g} s after the first touch, is not in it: --to {end:g} "
            "shows it"
        )
    return (
        f"{count} later impacts, from {first:.3g} s after the first touch on, are not in it: "
        f"--to {end:g} shows them"
    )


def _windows(scenes: Sequence[Scene], start: float, stop: float) -> tuple[tuple[float, float], ...]:
    """Intervals in slow motion: the impacts of all scenes with some margin, merged."""
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
    """Slow-motion factor, easing in and out of the windows."""
    share = np.zeros_like(t)
    for a, b in windows:
        away = np.maximum(0.0, np.maximum(a - t, t - b)) / EASING
        share = np.maximum(share, np.clip(1.0 - away, 0.0, 1.0))
    return np.asarray(LIFE ** (1.0 - share) * max(slow, LIFE) ** share)


def _instants(
    windows: Sequence[tuple[float, float]], start: float, stop: float, slow: float, fps: float
) -> Array:
    """Flight times of frames, which are equally spaced in the time of the film."""
    fine = np.linspace(start, stop, max(2000, int((stop - start) / 2e-4)))
    pace = _slowness(fine, windows, slow)
    shown = np.concatenate([[0.0], np.cumsum(0.5 * (pace[1:] + pace[:-1]) * np.diff(fine))])
    count = int(shown[-1] * fps) + 1
    if count > MOST_FRAMES:
        raise InputError(
            f"a film of {count} frames is too long (at most {MOST_FRAMES}); give --from and --to, "
            "or a smaller --slow or --fps"
        )
    return np.interp(np.arange(count) / fps, shown, fine)
