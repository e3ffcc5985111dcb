"""The commands ``springback identify inspect``, ``segment`` and ``convert``."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from springback.errors import InputError
from springback.interfaces.cli.common import PATH, Terminal, say, terminal_options

if TYPE_CHECKING:
    from springback.logs.overview import Overview
    from springback.logs.recording import Recording
    from springback.logs.segments import LogImpact

#: Formats that ``convert`` writes.
FORMATS = ("ulog", "mcap", "table", "motive", "vicon", "qualisys")


@click.group()
def identify() -> None:
    """Recordings of real flights: what is in them, the impacts in them, what they tell.

    LOG is of PX4 (.ulg), ArduPilot (.bin), ROS 1 (.bag), ROS 2 (.mcap, .db3, or their folder),
    OptiTrack Motive or Vicon (.csv), Qualisys (.tsv), C3D (.c3d), or a mapping file (.toml) that
    says what the columns of a table of your own are. Several are logs of the same flight, each on
    its own clock.
    """


def log_options(command: Callable[..., None]) -> Callable[..., None]:
    """Options of every command that reads logs."""
    for option in (
        click.option("--body", metavar="AXES", help="Body axes of poses: flu, frd, rfu, y-up."),
        click.option("--world", metavar="AXES",
                     help="World axes of poses: nwu, enu, ned, z-up, y-up."),
        click.option("--until", "last", type=float, metavar="SECONDS",
                     help="Last instant to read, by the log's clock."),
        click.option("--from", "first", type=float, metavar="SECONDS",
                     help="First instant to read, by the log's clock."),
    ):  # fmt: skip
        command = option(command)
    return command


track_option = click.option(
    "--track", metavar="NAME",
    help="The vehicle, if motion capture tracked several bodies; by default the one that turns as "
    "the gyroscope says.",
)  # fmt: skip


no_check_option = click.option(
    "--no-check", is_flag=True,
    help="Go on, with a warning, if the data contradict their axes or their quaternion order.",
)  # fmt: skip


def recordings_of(logs: Sequence[Path], **given: Any) -> list[Recording]:
    """Recordings of logs, or of results of simulated flights.

    Args:
        logs: Paths.
        **given: Fields of `springback.logs.reading.LogOptions`.

    Raises:
        InputError: If one cannot be read.
    """
    from springback.logs.axes_options import refuse_unused_axes
    from springback.logs.reading import LogOptions
    from springback.logs.writing.flight_recording import log_or_flight

    options = LogOptions(**given)
    found = [log_or_flight(path, options) for path in logs]
    refuse_unused_axes(found, options.world, options.body)
    return found


@identify.command()
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", type=PATH)
@log_options
@track_option
@terminal_options("as_json", "quiet")
def inspect(
    logs: tuple[Path, ...], first: float | None, last: float | None, world: str | None,
    body: str | None, track: str | None, terminal: Terminal,
) -> None:  # fmt: skip
    """Show what is in logs, and what is missing for an impact.

    Channels with rates, gaps, clipped and lost samples; what the data say about their own frames
    and units: |q| = 1, gravity along +z, turn rates and bends of the track that agree with the
    inertial unit, or which rotation of the axes would make them agree.

    \b
    springback identify inspect flight.ulg
    springback identify inspect flight.ulg take.csv --world y-up
    springback identify inspect table.toml --from 12 --until 20
    """
    from springback.logs.axes_options import axes_options
    from springback.logs.overview import as_data, damages, overview
    from springback.logs.time_units import refuse_time_units
    from springback.logs.vehicle_track import chosen_track

    read = recordings_of(logs, first=first, last=last, world=world, body=body)
    refuse_time_units(read)
    chosen = chosen_track(read, track)
    recordings = chosen.recordings
    with terminal.spinner("comparing the channels"):
        found = overview(recordings)
        said = [text for text in (chosen.problem, chosen.sentence) if text]
        found = found._replace(remarks=(*said, *found.remarks))
        options = axes_options(recordings, world, body)
    text = _overview_text(found)
    if options:
        text += f"\n\nall findings pass with {options}"
    terminal.print(as_data(found) | {"axes_options": options or None}, text)
    for sentence in damages(recordings):
        say(f"warning: {sentence}")


@identify.command()
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", type=PATH)
@log_options
@track_option
@no_check_option
@terminal_options("as_json", "quiet")
def segment(
    logs: tuple[Path, ...], first: float | None, last: float | None, world: str | None,
    body: str | None, track: str | None, no_check: bool, terminal: Terminal,
) -> None:  # fmt: skip
    """Find the impacts in logs: when, how strong, which way; or why one cannot be used.

    The exit code is 2 if there is none, with the reason, or if the data contradict their axes.

    \b
    springback identify segment flight.ulg
    springback identify segment flight.ulg take.csv --json
    """
    from springback.logs.axes_options import refuse_wrong_axes
    from springback.logs.clock_jumps import refuse_clock_jumps
    from springback.logs.frame_check import refuse_units
    from springback.logs.overview import as_data, damages, overview
    from springback.logs.time_units import refuse_time_units
    from springback.logs.vehicle_track import with_vehicle

    read = recordings_of(logs, first=first, last=last, world=world, body=body)
    refuse_time_units(read)
    recordings = with_vehicle(read, track)
    refuse_clock_jumps(recordings)
    for one in recordings:
        refuse_units(one)
    with terminal.spinner("comparing the channels"):
        warnings = refuse_wrong_axes(recordings, world, body, goes_on=no_check)
    with terminal.spinner("looking for impacts"):
        found = overview(recordings)
    if not found.impacts:
        names = ", ".join(str(path) for path in logs)
        raise InputError(f"{names}: {found.verdict}")
    data = as_data(found)
    terminal.print(
        {"verdict": data["verdict"], "impacts": data["impacts"]},
        "\n".join([found.verdict, *(impact_text(one) for one in found.impacts)]),
    )
    for sentence in (*damages(recordings), *warnings):
        say(f"warning: {sentence}")


@identify.command()
@click.argument("source", metavar="LOG|RESULT", type=PATH)
@click.option(
    "--out", type=PATH, required=True,
    help="File to write: .ulg, .mcap, .csv (with a mapping file, .toml) or .tsv.",
)  # fmt: skip
@click.option(
    "--as", "form", type=click.Choice(FORMATS),
    help="Format, if the suffix does not tell: motive and vicon are .csv, too.",
)  # fmt: skip
@log_options
@terminal_options("force", "quiet")
def convert(
    source: Path, out: Path, form: str | None, first: float | None, last: float | None,
    world: str | None, body: str | None, force: bool, terminal: Terminal,
) -> None:  # fmt: skip
    """Write a log, or the sensor readings of a simulated flight, in another format.

    RESULT is a folder that springback fly wrote for a scenario with [sensors] or a pilot.

    \b
    springback identify convert results --out flight.ulg
    springback identify convert results --out flight.mcap
    springback identify convert results --out take.csv --as motive
    springback identify convert flight.ulg --out flight.csv
    """
    from springback.logs.writing.writers import write_recording

    if out.is_dir():
        raise InputError(f"--out {out}: is a folder; give a file such as flight.ulg")
    beside = out.with_suffix(".toml")
    is_table = form == "table" or (form is None and out.suffix.lower() == ".csv")
    for path in (out, *([beside] if is_table else [])):
        if path.exists() and not force:
            raise InputError(f"{path}: exists; give --force to replace it")
    if out.exists() and source.exists() and out.resolve() == source.resolve():
        raise InputError(f"--out {out}: is the log itself")
    [recording] = recordings_of((source,), first=first, last=last, world=world, body=body)
    left_out = write_recording(recording, out, form)
    if left_out:
        terminal.note(f"not in this format: {', '.join(left_out)}")
    terminal.note(f"written: {out}" + (f" and {beside}" if is_table else ""))


# -- text -----------------------------------------------------------------------------------------


def _overview_text(found: Overview) -> str:
    lines = [found.verdict, "", *found.logs, "", *_channel_lines(found)]
    lines += ["", "what the data say of frames and units"]
    lines += [
        f"  {'pass' if one.passed else 'FAIL'}  {one.name}: {one.sentence}"
        for one in found.findings
    ]
    if found.missing:
        lines += ["", "missing for an impact", *(f"  {text}" for text in found.missing)]
    if found.remarks:
        lines += ["", "remarks", *(f"  {text}" for text in found.remarks)]
    if found.impacts:
        lines += ["", "impacts", *(f"  {impact_text(one)}" for one in found.impacts)]
    return "\n".join(lines)


def _channel_lines(found: Overview) -> list[str]:
    head = ("channel", "quantity", "samples", "rate", "longest gap", "clipped", "lost", "sensor")
    rows = [head]
    for one in found.channels:
        gap = "-"
        if one.gap_start is not None:
            gap = f"{1e3 * one.longest_gap:.0f} ms at {one.gap_start:.3f} s"
        rows.append((
            one.name, one.quantity, str(one.samples), f"{one.rate:.4g} Hz", gap,
            "?" if one.clipped is None else str(one.clipped), str(one.lost), one.chain,
        ))  # fmt: skip
    widths = [max(len(row[k]) for row in rows) for k in range(len(head) - 1)]
    return [
        "  ".join([*(f"{row[k]:<{width}}" for k, width in enumerate(widths)), row[-1]]).rstrip()
        for row in rows
    ]


def impact_text(one: LogImpact) -> str:
    """An impact in a line."""
    words = [f"at {one.touch:.4f} s"]
    if one.release > one.touch:  # a track alone tells no more than an instant
        words[0] += f" for {1e3 * (one.release - one.touch):.1f} ms"
    if one.velocity is not None:
        words.append(f"{math.hypot(*one.velocity):.2f} m/s before it")
    if one.attitude is not None:
        roll, pitch, yaw = (math.degrees(angle) for angle in one.attitude)
        words.append(f"roll {roll:+.0f}, pitch {pitch:+.0f}, yaw {yaw:+.0f} deg")
    if one.pressed is not None:
        words.append(f"arm {one.pressed[0]} pressed most, by {1e3 * one.pressed[1]:.1f} mm")
    if one.peak == one.peak:
        words.append(f"peak {one.peak:.4g} m/s^2")
    if one.clipped:
        words.append(f"{one.clipped} samples clipped")
    if one.velocity_change is not None:
        shown = ", ".join(f"{part:+.2f}" for part in one.velocity_change)
        words.append(f"change of velocity [{shown}] m/s")
    if one.normal is not None:
        shown = ", ".join(f"{part:+.2f}" for part in one.normal)
        words.append(f"normal [{shown}]")
    words.append(f"by {' and '.join(one.evidence)}")
    if one.refused:
        words.append(f"refused: {one.refused}")
    return ", ".join(words)
