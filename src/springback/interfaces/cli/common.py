"""Options, progress and printing that commands share.

Results go to stdout, everything else to stderr.
"""

from __future__ import annotations

import functools
import json
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import click

from springback.interfaces.cli.completion import complete_vehicle
from springback.interfaces.output.plain_text import plain_text
from springback.interfaces.output.progress_lines import ProgressLines

Command = Callable[..., None]
FIRST = (
    "flying; a new kind of flight is compiled first, which takes 10 s (20 s to a minute with a "
    "pilot, up to two minutes with moving obstacles, up to four with a second vehicle)"
)
"""Label of the spinner while a flight is flown."""
PATIENCE = 1.0
"""Seconds before a progress bar appears."""


def say(text: str) -> None:
    """Print a line on stderr."""
    click.echo(plain_text(text), err=True)


@dataclass(frozen=True)
class Terminal:
    """Output of a command on the terminal, according to ``--quiet`` and ``--json``."""

    quiet: bool = False
    as_json: bool = False

    def note(self, text: str) -> None:
        """Print a remark on stderr, unless ``quiet``."""
        if not self.quiet:
            say(text)

    def print(self, data: Any, text: str | None = None) -> None:
        """Print a result on stdout: data as JSON if wanted, else a text, by default the data."""
        if self.as_json:
            click.echo(json.dumps(data, indent=2, allow_nan=False, default=str))
        else:
            click.echo(plain_text(data if text is None else text))

    @contextmanager
    def progress_bar(self, label: str) -> Iterator[Callable[[float], None]]:
        """Progress for fractions from 0 to 1: as `progress_in_words`, without words."""
        with self.progress_in_words(label) as (show, _):
            yield show

    @contextmanager
    def progress_in_words(
        self, label: str
    ) -> Iterator[tuple[Callable[[float], None], Callable[[str], None]]]:
        """Functions that show a fraction from 0 to 1, and tell in words what is being done.

        A bar on a terminal, after a second; elsewhere a line every ten seconds, also while nothing
        is shown.
        """
        from rich.console import Console

        console = Console(stderr=True)
        if self.quiet:
            yield (lambda share: None), (lambda doing: None)
        elif console.is_terminal:
            with _bar(console, label) as both:
                yield both
        else:
            lines = ProgressLines(label, say)
            with lines.looking():
                yield lines.show, lines.tell

    @contextmanager
    def spinner(self, label: str) -> Iterator[Callable[[str], None]]:
        """A spinner for work that reports no progress; yields what tells in words what is done.

        Without a terminal a line every ten seconds.
        """
        import threading

        from rich.console import Console
        from rich.markup import escape

        console = Console(stderr=True)
        if self.quiet:
            yield lambda doing: None
            return
        if not console.is_terminal:
            lines = ProgressLines(label, say)
            with lines.looking():
                yield lines.tell
            return
        status = console.status(label)
        timer = threading.Timer(PATIENCE, status.start)
        timer.start()
        try:
            yield lambda doing: status.update(escape(f"{label}: {doing}"))
        finally:
            timer.cancel()
            timer.join()
            status.stop()


@contextmanager
def _bar(
    console: Any, label: str
) -> Iterator[tuple[Callable[[float], None], Callable[[str], None]]]:
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    words = TextColumn("{task.description}", markup=False)
    bar = Progress(words, BarColumn(), TimeElapsedColumn(), console=console, transient=True)
    task = bar.add_task(label, total=1.0)
    begun = time.monotonic()

    def show(share: float) -> None:
        bar.update(task, completed=share)
        if not bar.live.is_started and time.monotonic() - begun > PATIENCE:
            bar.start()

    def tell(doing: str) -> None:
        bar.update(task, description=plain_text(f"{label}: {doing}"))

    try:
        yield show, tell
    finally:
        bar.stop()


@dataclass(frozen=True)
class Output(Terminal):
    """Output of a command on the terminal and into the folder ``--out``."""

    out: Path | None = None
    force: bool = False
    no_figures: bool = False

    def folder(self, replaces: Iterable[str] = ()) -> AbstractContextManager[Path]:
        """Folder to write into; see `springback.interfaces.output.folders.output_folder`.

        Raises:
            InputError: If none was given, or it cannot be written.
        """
        from springback.errors import InputError
        from springback.interfaces.output.folders import output_folder

        if self.out is None:
            raise InputError("--out is missing: the folder to write to (or --dry-run)")
        return output_folder(self.out, force=self.force, replaces=replaces)

    def wants_figures(self) -> bool:
        """True if figures are wanted and can be drawn; prints how to install missing packages.

        Call it once, as it prints each time.
        """
        from importlib.util import find_spec

        if self.no_figures or find_spec("matplotlib") is not None:
            return not self.no_figures
        from springback.extras import install_line

        self.note(f"figures are left out, as they need matplotlib: {install_line('plot')}")
        return False

    def note_written(self, files: Iterable[Path] = ()) -> None:
        """Print the names and the folder of written files."""
        names = ", ".join(path.name for path in files)
        self.note(f"written to {self.out}" + (f": {names}" if names else ""))


def as_lines(data: dict[str, Any], indent: str = "") -> str:
    """Nested plain data as indented lines."""
    lines = []
    for key, value in data.items():
        if isinstance(value, dict):
            lines += [f"{indent}{key}:", as_lines(value, indent + "  ")]
        else:
            lines.append(f"{indent}{key}: {value}")
    return "\n".join(lines)


# -- options --------------------------------------------------------------------------------------

PATH = click.Path(path_type=Path)
FLAGS = {
    "no_figures": click.option("--no-figures", is_flag=True, help="Write no figures."),
    "force": click.option("--force", is_flag=True, help="Replace existing results."),
    "as_json": click.option("--json", "as_json", is_flag=True, help="Print the result as JSON."),
    "quiet": click.option("--quiet", "-q", is_flag=True, help="Show no progress and no remarks."),
}
"""Options of many commands in the order of their help, by the field that they set."""
seed_option = click.option(
    "--seed",
    type=click.IntRange(0),
    default=0,
    show_default=True,
    help="Seed of all random numbers.",
)

robots_option = click.option(
    "--robot", "robots", multiple=True, default=("arq", "quad"), show_default=True,
    help="Vehicle preset, or vehicle file; may be repeated.",
    shell_complete=complete_vehicle,
)  # fmt: skip


def trials_option(default: int, of: str = "Trials of each test.") -> Callable[[Command], Command]:
    """The option ``--trials``."""
    return click.option(
        "--trials", type=click.IntRange(1, 1000), default=default, show_default=True, help=of
    )


def terminal_options(*flags: str) -> Callable[[Command], Command]:
    """Decorator that adds some of `FLAGS`, and passes them as ``terminal``."""
    return _gather(Terminal, "terminal", *(FLAGS[flag] for flag in flags))


def output_options(
    what: str, *flags: str, required: bool = True, default: Path | None = None
) -> Callable[[Command], Command]:
    """Decorator that adds ``--out`` and `FLAGS`, and passes them as ``output``.

    Args:
        what: Help of ``--out``.
        flags: Some of `FLAGS`; by default all.
        required: Require ``--out``.
        default: Default of ``--out``.
    """
    # An explicit default of None counts as a value to click, and nothing would be required.
    given: dict[str, Any] = {} if default is None else {"default": default, "show_default": True}
    out = click.option("--out", type=PATH, required=required and not given, help=what, **given)
    return _gather(Output, "output", out, *(FLAGS[flag] for flag in flags or FLAGS))


def _gather(
    kind: type[Terminal], name: str, *options: Callable[[Command], Command]
) -> Callable[[Command], Command]:
    own = [field.name for field in fields(kind)]

    def decorate(command: Command) -> Command:
        @functools.wraps(command)
        def run(**given: Any) -> None:
            taken = {key: given.pop(key) for key in own if key in given}
            command(**given, **{name: kind(**taken)})

        decorated: Command = run
        for option in reversed(options):
            decorated = option(decorated)
        return decorated

    return decorate
