"""Writing a recording in any known format."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from springback.errors import InputError, shown_value
from springback.logs.recording import Recording
from springback.logs.writing.bag_file import write_bag
from springback.logs.writing.capture_files import write_motive, write_qualisys, write_vicon
from springback.logs.writing.table_file import write_table
from springback.logs.writing.ulog_file import write_ulog

#: Writers by the word for a format, each with the suffix of its files.
WRITERS: dict[str, tuple[str, Callable[[Recording, Path], list[str]]]] = {
    "ulog": (".ulg", write_ulog),
    "mcap": (".mcap", write_bag),
    "table": (".csv", write_table),
    "motive": (".csv", write_motive),
    "vicon": (".csv", write_vicon),
    "qualisys": (".tsv", write_qualisys),
}


def write_recording(recording: Recording, path: Path, word: str | None = None) -> list[str]:
    """Write a recording, completely or not at all.

    Args:
        recording: What is written.
        path: The file.
        word: A format, one of `WRITERS`; by default that of the suffix, ``.csv`` being a table.

    Returns:
        Names of channels for which the format has no place.

    Raises:
        InputError: If the format is not known, the suffix is not its own, the recording has
            nothing for it, or the file cannot be written.
    """
    suffix = path.suffix.lower()
    chosen = word or next((name for name, (end, _) in WRITERS.items() if end == suffix), None)
    if chosen is None or chosen not in WRITERS:
        known = ", ".join(sorted({end for end, _ in WRITERS.values()}))
        raise InputError(f"{path}: must end in one of {known} (got {shown_value(path.suffix)})")
    ending, write = WRITERS[chosen]
    if suffix != ending:
        raise InputError(f"{path}: must end in {ending}, as files of {chosen} do")
    try:
        return write(recording, path)
    except OSError as error:
        raise InputError(f"{path}: cannot be written ({error.strerror})") from None
