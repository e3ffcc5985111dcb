"""The command ``springback animate``."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import PATH, Output, output_options


@click.command()
@click.argument("results", nargs=-1, type=PATH, metavar="RESULT [RESULT2]")
@click.option(
    "--slow", type=click.FloatRange(1.0, 1000.0), default=20.0, show_default=True,
    help="Slow-motion factor of impacts.",
)  # fmt: skip
@click.option(
    "--from", "begin", type=float,
    help="First instant, relative to first touch [s].  [default: -0.3; without a touch the start]",
)  # fmt: skip
@click.option(
    "--to", "end", type=float,
    help="Last instant, relative to first touch [s].  [default: 0.8; without a touch the end]",
)  # fmt: skip
@click.option("--fps", type=float, default=25.0, show_default=True, help="Frames per second.")
@click.option("--size", metavar="WxH", help="Width and height [px], such as 760x540.")
@output_options("File of the film: .gif, .webp or .mp4.", "force", "quiet")
def animate(
    results: tuple[Path, ...],
    slow: float,
    begin: float | None,
    end: float | None,
    fps: float,
    size: str | None,
    output: Output,
) -> None:
    """Make a film of a RESULT, a folder that springback fly wrote, or of two side by side.

    Impacts are shown in slow motion. Two flights are synchronised at their first touches. A
    film ends 0.8 s after the first touch; with --to it holds later impacts, too.

    \b
    springback fly collision.toml --out arq
    springback fly collision.toml vehicle=quad --out quad
    springback animate arq quad --out collision.gif
    springback animate arq --out impact.webp --slow 100 --from -0.02 --to 0.1
    """
    if len(results) not in (1, 2):
        raise InputError(f"RESULT: give one folder, or two to show side by side ({len(results)})")
    out = output.out
    assert out is not None  # it is required
    from springback.interfaces.animation.film import check, replace_film
    from springback.interfaces.animation.timing import impacts_left_out
    from springback.interfaces.replay.labels import scenes_of
    from springback.results.saved import load

    options: dict[str, Any] = {
        "slow": slow,
        "begin": begin,
        "end": end,
        "fps": fps,
        "size": _size(size),
    }
    check(out, force=output.force, **options)
    with output.spinner("reading"):
        scenes = scenes_of([load(folder) for folder in results], results)
    for scene in scenes:
        for doubt in (*scene.warnings, *scene.notes):
            output.note(f"{scene.label}: {doubt}")
    with output.progress_bar("drawing") as show:
        count = replace_film(scenes, out, progress=show, **options)
    output.note(f"written to {out}: {count} frames, {out.stat().st_size / 1e6:.2f} MB")
    if end is None and (later := impacts_left_out(scenes)):
        output.note(later)


def _size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text.strip().lower())
    if found is None:
        raise InputError(f"--size {text}: must be WIDTHxHEIGHT in px, such as 760x540")
    return int(found[1]), int(found[2])
