"""Recordings as a table in CSV, with a mapping file that says what its columns are."""

from __future__ import annotations

import csv
import itertools
import json
from pathlib import Path
from typing import Any

import numpy as np

from springback.files import atomic_file, write_atomically
from springback.logs.recording import ATTITUDE, QUANTITIES, Array, LogChannel, Recording


def write_table(recording: Recording, path: Path) -> list[str]:
    """Write a recording as CSV, and beside it a mapping file of the same name, ``.toml``.

    Each clock and rate has a column of times of its own; numbers are written in full.  Samples at
    the end of a range are 1 in columns of their own.

    Args:
        recording: What is written.
        path: The file, ``.csv``.

    Returns:
        Nothing is left out: an empty list.
    """
    groups: list[tuple[str, Array]] = []
    columns: list[tuple[str, list[str]]] = []
    entries: list[str] = []
    for channel in recording.channels:
        time = next((name for name, at in groups if np.array_equal(at, channel.times)), None)
        if time is None:
            time = f"t{len(groups) + 1}"
            groups.append((time, channel.times))
            columns.append((time, list(map(_text, channel.times))))
        stem = channel.name.replace(" ", "_").replace(",", "_")
        names = [f"{stem}.{label}" for label in _labels(channel)]
        texts = [list(map(_text, values)) for values in channel.values.T]
        columns += list(zip(names, texts, strict=True))
        if channel.clipped is not None:
            flags = [[str(int(one)) for one in column] for column in channel.clipped.T]
            columns += list(zip(map(_flag_name, names), flags, strict=True))
        entries.append(_entry(channel, time, names))
    mapping = [
        "# What the columns of the table are: springback identify inspect FILE.toml",
        f"file = {json.dumps(path.name)}",
        "",
        "[axes]",
        'world = "nwu"',
        'body = "flu"',
        "",
        *entries,
    ]
    with atomic_file(path) as draft, draft.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([name for name, _ in columns])
        cells = (texts for _, texts in columns)
        writer.writerows(itertools.zip_longest(*cells, fillvalue=""))
    write_atomically(path.with_suffix(".toml"), "\n".join(mapping))
    return []


def _text(value: Any) -> str:
    return "" if np.isnan(value) else repr(float(value))


def _flag_name(name: str) -> str:
    """Column that tells which samples of a column are at the end of the range."""
    return f"{name}.clipped"


def _labels(channel: LogChannel) -> list[str]:
    width = channel.values.shape[1]
    if channel.quantity == ATTITUDE:
        return list("wxyz")
    if channel.labels and 3 * len(channel.labels) == width:
        return [f"{name}.{axis}" for name in channel.labels for axis in "xyz"]
    return list("xyz") if width == 3 else [str(k + 1) for k in range(width)]


def _entry(channel: LogChannel, time: str, names: list[str]) -> str:
    """Table of a channel in the mapping."""
    chain, unit = channel.chain, QUANTITIES[channel.quantity].unit
    lines = [
        "[[channels]]",
        f"name = {json.dumps(channel.name, ensure_ascii=False)}",
        f'quantity = "{channel.quantity}"',
        f"columns = {json.dumps(names, ensure_ascii=False)}",
        f'unit = "{unit}"',
        f'time = "{time}"',
        f"clock = {json.dumps(channel.clock, ensure_ascii=False)}",
    ]
    if channel.clipped is not None:
        lines.append(f"clipped = {json.dumps(list(map(_flag_name, names)), ensure_ascii=False)}")
    if channel.is_lost.any():
        lines.append('blank = "lost"')
    if chain.full_scale is not None:
        lines.append(f"full_scale = {chain.full_scale!r}")
    if chain.average is not None:
        lines.append(f"average = {chain.average!r}")
    if chain.low_pass is not None:
        lines.append(f"low_pass = {chain.low_pass!r}")
    if chain.low_pass is not None and chain.low_pass_order is not None:
        lines.append(f"low_pass_order = {chain.low_pass_order}")
    lines += [f"{word} = true" for word in ("estimated", "smoothed") if getattr(chain, word)]
    return "\n".join([*lines, ""])
