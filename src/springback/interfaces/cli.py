"""The command line.

Results go to stdout, everything else to stderr.  Exit codes: 0 done, 1 the run failed, 2 the input
is wrong, 130 interrupted.  Heavy modules are imported by the commands that need them.
"""

from __future__ import annotations

import errno
import gc
import json
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

import click

from springback.errors import FlightWarning, InputError, warn_in_one_line
from springback.interfaces import last_words
from springback.interfaces.plain_text import plain_text
from springback.version import __version__

OUT = click.Path(file_okay=True, path_type=Path)
FIRST = "flying; the first of a kind is compiled: some 15 s, with a pilot a minute or two"
"""Said while one waits for a flight."""
PATIENCE = 1.0
"""Seconds before a progress bar appears."""
FEW_CYCLES = 200_000
"""New objects between two searches for cycles: loading modules makes many objects and no garbage,
and with Python's own 700 the searches take a tenth of the time of a short command."""


@contextmanager
def _progress(label: str, quiet: bool) -> Iterator[Callable[[float], None]]:
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
def _patience(label: str, quiet: bool) -> Iterator[None]:
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


def _say(text: str, quiet: bool) -> None:
    if not quiet:
        click.echo(plain_text(text), err=True)


def _have_figures(quiet: bool) -> bool:
    from importlib.util import find_spec

    if find_spec("matplotlib") is not None:
        return True
    from springback.experiments.extras import install_line

    _say(f"figures are left out, they need matplotlib: {install_line('plot')}", quiet)
    return False


json_option = click.option("--json", "as_json", is_flag=True, help="Print the result as JSON.")
quiet_option = click.option("--quiet", "-q", is_flag=True, help="No progress, no remarks.")
force_option = click.option("--force", is_flag=True, help="Replace results in the output folder.")


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="springback")
def cli() -> None:
    """Simulate micro aerial vehicles that survive hitting things."""


@cli.command()
@click.argument("scenario", type=click.Path(path_type=Path))
@click.argument("overrides", nargs=-1, metavar="[KEY=VALUE]...")
@click.option(
    "--out", type=OUT, required=True, help="Folder for summary.json, trajectory.parquet, figures."
)
@click.option(
    "--pilot", metavar="FILE.py:NAME",
    help="Fly with a pilot of your own: a function, or an OwnPilot, which is compiled.",
)  # fmt: skip
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@force_option
@json_option
@quiet_option
def fly(
    scenario: Path,
    overrides: tuple[str, ...],
    out: Path,
    pilot: str | None,
    no_figures: bool,
    force: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Fly a SCENARIO file, with any of its values overridden.

    \b
    springback fly scenario.toml --out results
    springback fly scenario.toml vehicle.arms.stiffness="6 N/mm" start.pitch="15 deg" --out results
    springback fly scenario.toml --pilot my_pilot.py:hover --out results
    """
    from springback.experiments.guidance import uneasy
    from springback.experiments.pilots import read_pilot
    from springback.experiments.result import fly as fly_scenario
    from springback.experiments.scenario_file import read_scenario
    from springback.interfaces.files import FLIGHT_FILES, SUMMARY, output_folder, write_flight

    own = read_pilot(pilot) if pilot else None
    ready = read_scenario(scenario, overrides, pilot=own is not None)
    for sentence in uneasy(ready, own=own is not None):
        _say(f"warning: {sentence}", False)
    with output_folder(out, force=force, replaces=FLIGHT_FILES) as folder:
        with _patience(FIRST, quiet):
            with warnings.catch_warnings():  # said below, in this program's own way
                warnings.simplefilter("ignore", FlightWarning)
                flight = fly_scenario(ready, pilot=own)
            figures = not no_figures and _have_figures(quiet)
            written = write_flight(flight, folder, figures=figures)
        names = [path.name for path in written]
        summary = (folder / SUMMARY).read_text(encoding="utf-8")
    _print(json.loads(summary) if as_json else repr(flight), as_json)
    _say(f"written to {out}: {', '.join(names)}", quiet)
    for sentence in flight.remarks.values():
        _say(f"warning: {sentence}", False)
    if not flight.is_finite:
        sys.exit(1)


@cli.command()
@click.argument("pilot", metavar="FILE.py:NAME")
@click.argument("scenario", type=click.Path(path_type=Path), required=False)
@json_option
@quiet_option
def check(pilot: str, scenario: Path | None, as_json: bool, quiet: bool) -> None:
    """Try a pilot of your own on what every pilot should keep to.

    At rest at the start of the SCENARIO (by default quad at [0, 0, 1] m) it must hover.

    \b
    springback check my_pilot.py:hover
    """
    from springback.experiments.pilot_check import check_pilot

    with _progress("trying the pilot", quiet) as show:
        findings = check_pilot(pilot, scenario, progress=show)
    lines = [f"{'pass' if f.passed else 'FAIL'}  {f.name}: {f.sentence}" for f in findings]
    _print([f._asdict() for f in findings] if as_json else "\n".join(lines), as_json)
    failed = sum(not f.passed for f in findings)
    _say(f"{len(findings) - failed} of {len(findings)} passed", quiet)
    if failed:
        sys.exit(1)


@cli.command()
@click.argument("part", type=click.Choice(["all", "slider", "flight", "resilience"]), default="all")
@click.option(
    "--out", type=OUT, required=True, help="Folder for report.html, figures, JSON and CSV."
)
@click.option(
    "--reading", "readings", multiple=True, metavar="'NAME: KEY=VALUE ...'",
    help="One more reading of the printed parameters: reading B with changes.",
)  # fmt: skip
@force_option
@json_option
@quiet_option
def reproduce(
    part: str, out: Path, readings: tuple[str, ...], force: bool, as_json: bool, quiet: bool
) -> None:
    """Reproduce the paper: its numbers beside ours, in a report.

    `slider` is Table III, the deflections and contact times, and the speed sweep; `flight` is Table
    I, sizes, payload and hover time, and Table IV, steps and circles; `resilience` is collisions in
    flight, seven kinds of ten trials for both robots, and ten collisions in a row.
    """
    from springback.interfaces.files import output_folder

    if readings and part not in ("all", "slider"):
        raise InputError("--reading is for the slider tests; leave it out, or reproduce all")
    _needs_figures()
    with output_folder(out, force=force) as folder:
        rows = _reproduced(part, readings, folder, quiet)
    if as_json:
        _print([row.as_dict() for row in rows], as_json)
    elif not quiet:
        _print(_table(rows), as_json)
    _say(f"report: {out / 'report.html'}", quiet)


def _reproduced(part: str, readings: tuple[str, ...], folder: Path, quiet: bool) -> list[Any]:
    """Reproduce a part, write the report into a folder, give the compared numbers."""
    from springback.experiments.paper.features import feature_rows
    from springback.experiments.paper.flight import flight_experiments
    from springback.experiments.paper.resilience import resilience_experiments
    from springback.experiments.paper.slider import named_reading, slider_experiments
    from springback.interfaces.report import Results, write_report

    extra, results = [named_reading(text) for text in readings], Results()
    if part in ("all", "slider"):
        _say("slider tests: Table III and the sweep; the first run compiles for a minute", quiet)
        with _progress("slider tests", quiet) as show:
            results = replace(results, slider=slider_experiments(extra, show))
    if part in ("all", "flight"):
        _say("free flight: Tables I and IV; the first run compiles for a minute", quiet)
        with _progress("free flight", quiet) as show:
            flown = flight_experiments(progress=show)
        results = replace(results, features=feature_rows(), flight=flown)
    if part in ("all", "resilience"):
        _say("collisions in flight; the first run compiles for a minute or two", quiet)
        with _progress("collisions in flight", quiet) as show:
            results = replace(results, resilience=resilience_experiments(progress=show))
    with _patience("writing the report", quiet):
        write_report(results, folder, about=_about())
    return results.rows


@cli.command()
@click.argument("preset", required=False)
@json_option
def show(preset: str | None, as_json: bool) -> None:
    """Show a vehicle, surface or estimator PRESET, each number with its source; or all presets."""
    from springback.contact.library import SOURCES, SURFACES
    from springback.experiments.scenario import preset as known_preset
    from springback.sensing.library import ESTIMATORS
    from springback.sensing.library import SOURCES as ESTIMATOR_SOURCES
    from springback.vehicle.library import VEHICLES

    if preset is None:
        names = {name: entry.summary for name, entry in VEHICLES.items()}
        names |= {
            name: f"surface, {entry.law}, friction {entry.friction_axes}"
            for name, entry in SURFACES.items()
        }
        names |= {name: f"estimator, {entry.type}" for name, entry in ESTIMATORS.items()}
        _print(
            names if as_json else "\n".join(f"{name:<12} {text}" for name, text in names.items()),
            as_json,
        )
        return
    known = {**VEHICLES, **SURFACES, **ESTIMATORS}
    entry = known_preset("vehicle, surface or estimator", preset, known)
    extra: dict[str, Any] = {}
    if preset in VEHICLES:
        settings, sources, summary = entry.vehicle, entry.sources, entry.summary
        extra = {"mass": entry.vehicle.mass, "inertia": entry.vehicle.inertia().tolist()}
    elif preset in ESTIMATORS:
        settings, sources, summary = entry, ESTIMATOR_SOURCES[preset], f"estimator {preset}"
    else:
        settings, sources, summary = entry, SOURCES[preset], f"surface {preset}"
        extra = {"dissipation": entry.dissipation_value()}
    data = {
        "summary": summary,
        "settings": settings.model_dump(),
        "sources": sources,
        "derived": extra,
    }
    _print(data if as_json else _described(data), as_json)


@cli.command()
@json_option
@quiet_option
def doctor(as_json: bool, quiet: bool) -> None:
    """Check this installation: versions, extras, compiler, agreement of the executors."""
    from springback.interfaces.doctor import diagnosis

    with _patience("compiling and checking", quiet):
        found = diagnosis()
    _print(found if as_json else _described(found), as_json)
    if not found["compiled_equals_python"]:
        _say("compiled flights differ from plain Python: please report this", False)
        sys.exit(1)


def _needs_figures() -> None:
    from springback.experiments.extras import needs

    needs("matplotlib", "plot")
    needs("jinja2", "plot")


def _about() -> dict[str, str]:
    import platform
    from importlib import metadata

    versions = {name: metadata.version(name) for name in ("numpy", "scipy", "numba")}
    return {"springback": __version__, "python": platform.python_version(), **versions}


def _print(data: Any, as_json: bool) -> None:
    if as_json:
        click.echo(json.dumps(data, indent=2, allow_nan=False, default=str))
    else:
        click.echo(plain_text(data))


def _described(data: dict[str, Any], indent: str = "") -> str:
    """Nested plain data as indented lines."""
    lines = []
    for key, value in data.items():
        if isinstance(value, dict):
            lines += [f"{indent}{key}:", _described(value, indent + "  ")]
        else:
            lines.append(f"{indent}{key}: {value}")
    return "\n".join(lines)


def _table(rows: list[Any]) -> str:
    """Compared numbers as text."""
    lines = [
        f"{'':<11}{'robot':<16}{'on':<6}{'reading':<9}{'quantity':<43}{'ours':>10}{'printed':>10}"
        f"{'':>9}  mark"
    ]
    for row in rows:
        deviation = (
            "" if row.deviation is None or row.mark.word == "given" else f"{row.deviation:+.1%}"
        )
        ours = "-" if row.ours is None else f"{row.ours:.4g}"
        printed = "-" if row.printed is None else f"{row.printed:.4g}"
        slider = bool(row.dissipation_from)  # elsewhere a reading is a part of what the number is
        reading = row.reading if slider else ""
        quantity = row.quantity if slider or not row.reading else f"{row.quantity}, {row.reading}"
        lines.append(
            f"{row.experiment:<11}{row.robot:<16}{row.surface:<6}{reading:<9}{quantity:<43}"
            f"{ours:>10}{printed:>10}{deviation:>9}  {row.mark.word}"
        )
    return "\n".join(lines)


from springback.interfaces import (  # noqa: E402, F401
    cli_campaign,
    cli_examples,
    cli_film,
    cli_lab,
    cli_map,
    cli_study,
    cli_view,
)


def main() -> None:
    """Run the command line and leave with its exit code."""
    gc.set_threshold(FEW_CYCLES)
    warn_in_one_line()
    try:
        cli.main(standalone_mode=False)
    except InputError as error:
        for line in error.problems:
            _say(f"error: {line}", False)
        sys.exit(2)
    except click.Abort as error:
        # So says click of Ctrl-C, and of a file that ends too early, too.
        if isinstance(error.__cause__, EOFError):
            raise error.__cause__ from None
        _interrupted()
    except KeyboardInterrupt:
        _interrupted()
    except click.ClickException as error:
        error.show()
        sys.exit(2)
    except Exception as error:
        if last_words.came():  # and whatever it led to in a library
            _interrupted()
        said = environment(error)
        if said is None:
            raise
        _say(f"error: {said}", False)
        sys.exit(1)


def _interrupted() -> NoReturn:
    last_words.deafen()
    _say(last_words.words(), False)
    sys.exit(130)


#: Errors of the system that are nobody's mistake here.
_OF_THE_SYSTEM = {
    getattr(errno, name) for name in
    ("ENOSPC", "EDQUOT", "EIO", "EROFS", "EFBIG", "EACCES", "EPERM", "ENAMETOOLONG", "EMFILE",
     "ENFILE", "ELOOP", "ESTALE", "ENOTDIR", "EISDIR")
    if hasattr(errno, name)
}  # fmt: skip


def environment(error: BaseException) -> str | None:
    """What a disk or the memory has to say, in one line; None if the program is at fault."""
    if isinstance(error, OSError) and error.errno in _OF_THE_SYSTEM:
        where = f"{error.filename}: " if error.filename else ""
        return f"{where}{error.strerror}"
    if isinstance(error, MemoryError):
        return f"out of memory ({' '.join(str(error).split()) or 'no more to be had'})"
    if type(error).__name__ in ("IOException", "FatalException"):  # DuckDB's
        return " ".join(str(error).split())[:300]
    return None
