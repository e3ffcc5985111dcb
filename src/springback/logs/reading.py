"""Reading a log of any known format."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from springback.errors import InputError, shown_value
from springback.logs.formats import motive, qualisys
from springback.logs.formats.autopilot import read_px_log
from springback.logs.formats.bags import read_bag
from springback.logs.formats.dataflash import read_dataflash
from springback.logs.formats.markers import read_markers
from springback.logs.formats.motive import read_motive
from springback.logs.formats.qualisys import read_qualisys
from springback.logs.formats.text import open_text
from springback.logs.formats.vicon import ALL_TITLES, read_vicon
from springback.logs.frame_turns import BODIES, WORLDS
from springback.logs.recording import Recording, TimeSpan
from springback.problems import nearest_name


class LogOptions(NamedTuple):
    """How a log is read."""

    first: float | None = None
    """First instant that is wanted [s], of the log's clock; None: from its begin."""
    last: float | None = None
    """Last instant that is wanted [s]; None: to its end."""
    world: str | None = None
    """World axes of motion capture and ROS, one of `springback.logs.frame_turns.WORLDS`."""
    body: str | None = None
    """Body axes of motion capture and ROS, one of `springback.logs.frame_turns.BODIES`."""

    def part(self) -> TimeSpan:
        """Instants that are wanted.

        Raises:
            InputError: If there are none.
        """
        all_of_it = TimeSpan()
        part = TimeSpan(
            all_of_it.first if self.first is None else self.first,
            all_of_it.last if self.last is None else self.last,
        )
        if not part.first < part.last:
            raise InputError(f"--from {part.first:g} s must be before --until {part.last:g} s")
        return part

    def axes(self, world: str, body: str) -> tuple[str, str]:
        """Names of the axes, by default those of a format."""
        return self.world or world, self.body or body


def read_recording(path: str | Path, options: LogOptions | None = None) -> Recording:
    """Recording of a log.

    The format is that of its suffix: ``.ulg`` (PX4), ``.bin`` (ArduPilot), ``.bag`` (ROS 1),
    ``.db3``, ``.mcap`` or a folder of them (ROS 2), ``.csv`` (Motive or Vicon, by its first line),
    ``.tsv`` (Qualisys), ``.c3d``, or ``.toml``: a mapping file for a table of one's own.

    Args:
        path: The log.
        options: Part and axes; by default all of it, in the axes of its format.

    Raises:
        InputError: In one line, if it cannot be read, or nothing of it can be used.
    """
    path, options = Path(path), options or LogOptions()
    for name, known in (("world", WORLDS), ("body", BODIES)):
        word = getattr(options, name)
        if word is not None and word not in known:
            near = nearest_name(str(word), known)
            hint = f"did you mean {near}?" if near else f"known are {', '.join(known)}"
            raise InputError(f"--{name}: {shown_value(word)} is not known; {hint}")
    part = options.part()
    try:
        if not path.exists():
            raise InputError(f"{path}: there is no such file")
        if not path.is_file() and not path.is_dir():
            raise InputError(f"{path}: cannot be read (is not a regular file)")
        reader = read_bag_of if path.is_dir() else _READERS.get(path.suffix.lower())
        if reader is None:
            known_suffixes = ", ".join(_READERS)
            raise InputError(
                f"{path}: {shown_value(path.suffix)} is no format of logs that is known "
                f"({known_suffixes}); a table of your own needs a mapping file"
            )
        if path.is_file() and path.stat().st_size == 0:
            raise InputError(f"{path}: is empty")
        with np.errstate(all="ignore"):  # numbers of damaged logs; channels are checked
            return _without_lost(reader(path, part, options))
    except UnicodeError as error:
        raise InputError(f"{path}: cannot be read ({error})") from None


def _without_lost(recording: Recording) -> Recording:
    """A recording without channels of which every sample is lost.

    Raises:
        InputError: If none is left.
    """
    lost = [one.name for one in recording.channels if one.is_lost.all()]
    if not lost:
        return recording
    kept = tuple(one for one in recording.channels if not one.is_lost.all())
    if not kept:
        raise InputError(f"{recording.path}: all samples of {', '.join(lost)[:300]} are lost")
    remarks = (*recording.remarks, *(f"{name}: all of its samples are lost" for name in lost[:20]))
    return replace(recording, channels=kept, remarks=remarks)


def read_bag_of(path: Path, part: TimeSpan, options: LogOptions) -> Recording:
    """Recording of a bag, in its axes."""
    return read_bag(path, part, *options.axes("enu", "flu"))


def _comma_separated(path: Path, part: TimeSpan, options: LogOptions) -> Recording:
    """Recording of a CSV file of Motive or Vicon, by its first line."""
    with open_text(path) as file:
        first = file.readline(10_000).lstrip('"')
    if first.startswith(motive.MAGIC):
        return read_motive(path, part, *options.axes("y-up", "y-up"))
    if first.strip().strip(',"') in ALL_TITLES:
        return read_vicon(path, part, *options.axes("z-up", "flu"))
    raise InputError(
        f"{path}: is neither of Motive nor of Vicon; a table of your own needs a mapping file, "
        "log.toml, which says what its columns are"
    )


def _tab_separated(path: Path, part: TimeSpan, options: LogOptions) -> Recording:
    """Recording of a TSV file of Qualisys."""
    with open_text(path) as file:
        first = file.readline(10_000)
    if not first.startswith(qualisys.MAGIC):
        raise InputError(
            f"{path}: is not of Qualisys (its first word is not {qualisys.MAGIC}); a table of your "
            "own needs a mapping file, log.toml, which says what its columns are"
        )
    return read_qualisys(path, part, *options.axes("z-up", "flu"))


def _own_table(path: Path, part: TimeSpan, _: LogOptions) -> Recording:
    """Recording of a table of one's own."""
    from springback.logs.formats.mapped import read_mapped  # loads what scenarios need

    return read_mapped(path, part)


_READERS: dict[str, Callable[[Path, TimeSpan, LogOptions], Recording]] = {
    ".ulg": lambda path, part, _: read_px_log(path, part),
    ".bin": lambda path, part, _: read_dataflash(path, part),
    ".bag": read_bag_of,
    ".db3": read_bag_of,
    ".mcap": read_bag_of,
    ".csv": _comma_separated,
    ".tsv": _tab_separated,
    ".c3d": lambda path, part, options: read_markers(path, part, options.axes("z-up", "flu")[0]),
    ".toml": _own_table,
}
