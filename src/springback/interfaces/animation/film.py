"""Films of flights: GIF, WebP or, with an extra, MP4, drawn without a display.

The same flights give the same file, byte for byte, with the same versions of the libraries.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from springback.errors import InputError
from springback.extras import needs
from springback.files import atomic_file
from springback.interfaces.animation.timing import timing
from springback.interfaces.output.python_wording import python_words
from springback.interfaces.output.robots import BLUE, GREEN, ORANGE, RED
from springback.interfaces.replay.labels import scenes_of
from springback.interfaces.replay.scene import Scene
from springback.results.flight import Flight

Array = np.ndarray[Any, np.dtype[np.float64]]
Frames = Sequence[Any]

SUFFIXES = (".gif", ".webp", ".mp4")
SIZES = {1: (600, 540), 2: (760, 540)}
"""Chosen: width and height for one flight and for two [px]."""
LEAST, MOST = 160, 2160
"""Chosen: smallest and largest width or height [px]."""
FASTEST = 50.0
"""Frames per second; browsers slow a GIF down above this."""
COLOURS, SAMPLED = 64, 12
"""Chosen: colours of a GIF, and number of frames from which its palette is computed."""
SLOWEST = 1000.0
"""Largest slow-motion factor (chosen)."""
HOLD = 1.0
"""Chosen: how long the last frame is held [s]."""
INKS = (BLUE, RED, GREEN, ORANGE)
"""Colours of thin lines, which the palette would otherwise lack."""
QUALITY = 80
"""Chosen: quality of WebP; MP4 uses the constant rate factor `CRF`."""
CRF = "20"


def save_film(
    flight: Flight, path: str | Path, *others: Flight, force: bool = False, **options: Any
) -> Path:
    """Write a film from Python: `springback.Flight.animate`.

    Args:
        flight: With its trajectory.
        path: Of the film.
        others: At most one.
        force: Replace an existing file.
        **options: As for `write_film`.
    """
    path = Path(path)
    with python_words():
        if len(others) > 1:
            raise InputError(f"a film shows one flight or two (got {1 + len(others)})")
        check(path, force=force, **options)
        replace_film(scenes_of([flight, *others]), path, **options)
    return path


def replace_film(scenes: Sequence[Scene], path: Path, **options: Any) -> int:
    """Write a film as by `write_film`, completely or not at all, and its folder if need be."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_file(path, suffix=path.suffix) as draft:
            return write_film(scenes, draft, **options)
    except OSError as error:
        raise InputError(f"--out {path}: cannot be written ({error.strerror})") from None


def write_film(
    scenes: Sequence[Scene],
    path: Path,
    *,
    slow: float = 20.0,
    begin: float | None = None,
    end: float | None = None,
    fps: float = 25.0,
    size: tuple[int, int] | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> int:
    """Write a film of one flight, or of two side by side, synchronised at first touch.

    Args:
        scenes: Of one world, or of two; each has one vehicle or two.
        path: Ends in .gif, .webp or .mp4.
        slow: Slow-motion factor of impacts.
        begin: First instant, from first touch [s]; by default shortly before it.
        end: Last instant, from first touch [s].
        fps: Frames a second.
        size: Width and height [px].
        progress: Called with the fraction of frames drawn.

    Returns:
        The number of frames.

    Raises:
        InputError: If there is nothing to show, the suffix is unknown, or an extra is missing.
    """
    check(path, slow=slow, begin=begin, end=end, fps=fps, size=size, force=True)
    from springback.interfaces.animation.frame import Frame, worlds_of

    when = timing(scenes, slow=slow, begin=begin, end=end, fps=fps)
    picture, count = Frame(scenes, when, size or SIZES[len(worlds_of(scenes))]), len(when.t)
    frames = []
    for k in range(count):
        frames.append(picture.at(k))
        progress((k + 1) / count)
    {".gif": _gif, ".webp": _webp, ".mp4": _mp4}[path.suffix.lower()](frames, path, fps)
    return count


def check(
    path: Path,
    *,
    slow: float = 20.0,
    begin: float | None = None,
    end: float | None = None,
    fps: float = 25.0,
    size: tuple[int, int] | None = None,
    force: bool = False,
) -> None:
    """Check the options of a film before anything is drawn; arguments as for `write_film`.

    Args:
        path: Of the film.
        slow: From 1 to 1000.
        begin: Before the end.
        end: After the beginning.
        fps: At most `FASTEST`.
        size: Width and height [px].
        force: Replace an existing file.

    Raises:
        InputError: If an option is invalid, the file exists, or an extra is not installed.
    """
    for name, value in {"--from": begin, "--to": end, "--fps": fps, "--slow": slow}.items():
        if value is not None and not abs(value) < 1e9:
            raise InputError(f"{name} {value:g}: must be a finite number")
    if not 1.0 <= slow <= SLOWEST:
        raise InputError(f"--slow {slow:g}: must be from 1 to {SLOWEST:g}")
    if begin is not None and end is not None and begin >= end:
        raise InputError(f"--from {begin:g} s must be before --to {end:g} s")
    if path.exists() and (path.is_dir() or not force):
        ending = "is a folder" if path.is_dir() else "already exists; give another, or --force"
        raise InputError(f"--out {path}: {ending}")
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(f"--out {path}: must end in {', '.join(SUFFIXES)}")
    if not 1.0 <= fps <= FASTEST:
        raise InputError(f"--fps {fps:g}: must be from 1 to {FASTEST:g} frames per second")
    for side in size or ():
        if not LEAST <= side <= MOST:
            raise InputError(f"--size: {side} px must be from {LEAST} to {MOST} px")
    if suffix == ".mp4" and any(side % 2 for side in size or ()):
        raise InputError("--size: an mp4 needs an even width and height")
    needs("matplotlib", "plot")
    needs("PIL", "plot")
    if suffix == ".mp4":
        needs("av", "video")


def _durations(count: int, fps: float) -> list[int]:
    """Duration of each frame [ms], in whole hundredths of a second as GIF requires."""
    ends = np.round(np.arange(1, count + 1) * 100.0 / fps)
    stays = [10 * int(stay) for stay in np.diff(ends, prepend=0.0)]
    return [*stays[:-1], stays[-1] + int(1e3 * HOLD)]


def _gif(frames: Frames, path: Path, fps: float) -> None:
    """Use one palette for all frames, without dithering, so that a still background stays still."""
    from matplotlib.colors import to_rgb
    from PIL import Image

    chosen = [frames[k] for k in np.linspace(0, len(frames) - 1, SAMPLED).astype(int)]
    inks = [np.full((40, frames[0].shape[1], 3), to_rgb(ink)) * 255 for ink in INKS]
    sampled = np.vstack([*chosen, *(ink.astype(np.uint8) for ink in inks)])
    palette = Image.fromarray(sampled).quantize(COLOURS, dither=Image.Dither.NONE)
    images = [
        Image.fromarray(f).quantize(palette=palette, dither=Image.Dither.NONE) for f in frames
    ]
    images[0].save(
        path, save_all=True, append_images=images[1:], duration=_durations(len(frames), fps),
        loop=0, optimize=False, disposal=1,
    )  # fmt: skip


def _webp(frames: Frames, path: Path, fps: float) -> None:
    from PIL import Image

    images = [Image.fromarray(frame) for frame in frames]
    images[0].save(
        path, save_all=True, append_images=images[1:], duration=_durations(len(frames), fps),
        loop=0, quality=QUALITY, method=4,
    )  # fmt: skip


def _mp4(frames: Frames, path: Path, fps: float) -> None:
    """Encode H.264 in a single thread, so that the bytes do not depend on the number of cores."""
    from fractions import Fraction

    import av
    from av.container import Flags

    held = [*frames, *[frames[-1]] * round(HOLD * fps)]
    with av.open(str(path), "w", options={"movflags": "+faststart"}) as film:
        bitexact: Any = Flags.bitexact.value
        film.flags |= bitexact  # no time of creation
        stream = film.add_stream("libx264", rate=Fraction(fps).limit_denominator(1000))
        stream.height, stream.width = frames[0].shape[:2]
        stream.pix_fmt, stream.thread_count = "yuv420p", 1
        stream.options = {"crf": CRF, "preset": "medium"}
        for frame in held:
            for packet in stream.encode(av.VideoFrame.from_ndarray(frame, format="rgb24")):
                film.mux(packet)
        for packet in stream.encode():
            film.mux(packet)
