"""What commands share: options, progress, and what they print.

Results go to stdout, everything else to stderr.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from springback.interfaces.output.plain_text import plain_text

OUT = click.Path(file_okay=True, path_type=Path)
FIRST = "flying; the first of a kind is compiled: some 15 s, with a pilot a minute or two"
"""Said while one waits for a flight."""
PATIENCE = 1.0
"""Seconds before a progress bar appears."""


@contextmanager
def progress_bar(label: str, quiet: bool) -> Iterator[Callable[[float], None]]:
    """A progress bar for shares from 0 to 1, on a terminal only, once a second has passed."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    bar = Progress(
        *columns, console=console, transient=True, disable=quiet or not console.is_terminal
    )
    task = bar.add_task(label, total=1.0)
    begun = time.monotonic()

    def show(share: float) -> None:
        bar.update(task, completed=share)
        if not bar.live.is_started and time.monotonic() - begun > PATIENCE:
            bar.start()

    try:
        yield show
    finally:
        bar.stop()


@contextmanager
def spinner(label: str, quiet: bool) -> Iterator[None]:
    """A spinner for work that reports no progress, such as compiling."""
    import threading

    from rich.console import Console

    console = Console(stderr=True)
    if quiet or not console.is_terminal:
        yield
        return
    status = console.status(label)
    timer = threading.Timer(PATIENCE, status.start)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        status.stop()


def note(text: str, quiet: bool) -> None:
    """Print a remark on stderr, unless none are wanted."""
    if not quiet:
        click.echo(plain_text(text), err=True)


def have_figures(quiet: bool) -> bool:
    """Whether figures can be drawn; if not, how to change that is said."""
    from importlib.util import find_spec

    if find_spec("matplotlib") is not None:
        return True
    from springback.extras import install_line

    note(f"figures are left out, they need matplotlib: {install_line('plot')}", quiet)
    return False


def require_figures() -> None:
    """Refuse to go on where figures and reports cannot be made.

    Raises:
        InputError: With the command that installs what is missing.
    """
    from springback.extras import needs

    needs("matplotlib", "plot")
    needs("jinja2", "plot")


def print_result(data: Any, as_json: bool) -> None:
    """Print a result on stdout: plain data as JSON, or a text."""
    if as_json:
        click.echo(json.dumps(data, indent=2, allow_nan=False, default=str))
    else:
        click.echo(plain_text(data))


def as_lines(data: dict[str, Any], indent: str = "") -> str:
    """Nested plain data as indented lines."""
    lines = []
    for key, value in data.items():
        if isinstance(value, dict):
            lines += [f"{indent}{key}:", as_lines(value, indent + "  ")]
        else:
            lines.append(f"{indent}{key}: {value}")
    return "\n".join(lines)


json_option = click.option("--json", "as_json", is_flag=True, help="Print the result as JSON.")
quiet_option = click.option("--quiet", "-q", is_flag=True, help="No progress, no remarks.")
force_option = click.option("--force", is_flag=True, help="Replace results in the output folder.")
