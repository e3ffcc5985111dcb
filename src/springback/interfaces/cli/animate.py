"""The command ``springback animate``."""

from __future__ import annotations

import re
from pathlib import Path

import click

from springback.errors import InputError
from springback.interfaces.cli.common import PATH, Output, output_options


@click.command()
@click.argument("results", nargs=-1, type=PATH, metavar="RESULT [RESULT2]")
@click.option(
    "--slow", type=click.FloatRange(1.0, 1000.0), default=20.0, show_default=True,
    help="Slow-motion factor of impacts.",
)  # fmt: skip
@click.option("--from", "begin", type=float, help="First instant, relative to first touch [s].")
@click.option("--to", "end", type=float, help="Last instant, relative to first touch [s].")
@click.option("--fps", type=float, default=25.0, show_default=True, help="Frames per second.")
@click.option("--size", metavar="WxH", help="Width and height [px], such as 760x540.")
@output_options("The film: .gif, .webp or .mp4.", "force", "quiet")
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

    Impacts are in slow motion. Two flights are synchronised at their first touches.

    \b
    springback fly collision.toml --out arq
    springback fly collision.toml vehicle=quad --out quad
    springback animate arq quad --out collision.gif
    springback animate arq --out impact.webp --slow 100 --from -0.02 --to 0.1
    """
    if len(results) not in (1, 2):
        raise InputError(f"RESULT: give one folder, or two to show side by side ({len(results)})")
    for name, value in {"--from": begin, "--to": end, "--fps": fps, "--slow": slow}.items():
        if value is not None and not abs(value) < 1e9:
            raise InputError(f"{name} {value:g}: must be a finite number")
    if begin is not None and end is not None and begin >= end:
        raise InputError(f"--from {begin:g} s must be before --to {end:g} s")
    out = output.out
    assert out is not None  # it is required
    if out.exists() and (out.is_dir() or not output.force):
        ending = "is a folder" if out.is_dir() else "already exists; give another, or --force"
        raise InputError(f"--out {out}: {ending}")
    wanted = _size(size)
    from springback.interfaces.animation.film import check, write_film
    from springback.interfaces.replay.labels import scenes_of
    from springback.results.saved import read_result

    check(out, wanted, fps)
    with output.spinner("reading"):
        scenes = scenes_of([read_result(folder) for folder in results], results)
    for scene in scenes:
        for doubt in scene.notes:
            output.note(f"{scene.label}: {doubt}")
    from springback.files import atomic_file

    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with (
            atomic_file(out, suffix=out.suffix) as draft,
            output.progress_bar("drawing") as show,
        ):
            count = write_film(
                scenes, draft, slow=slow, begin=begin, end=end, fps=fps, size=wanted, progress=show
            )
    except OSError as error:
        raise InputError(f"--out {out}: cannot be written ({error.strerror})") from None
    output.note(f"written to {out}: {count} frames, {out.stat().st_size / 1e6:.2f} MB")


def _size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    found = re.fullmatch(r"(\d{1,5})x(\d{1,5})", text.strip().lower())
    if found is None:
        raise InputError(f"--size {text}: must be WIDTHxHEIGHT in px, such as 760x540")
    return int(found[1]), int(found[2])
