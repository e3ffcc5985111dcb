"""TSV exports of Qualisys Track Manager: 3D trajectories and 6D bodies.

Angles are roll, pitch and yaw about the turned axes, R = R_x R_y R_z, and R is exported beside them
(Qualisys documentation, "Rotation angle calculations in QTM").  Of the two orders in which a file
may list R, that is taken which agrees with its angles.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError, shown_value
from springback.logs.formats.text import (
    MOST_HEADER,
    NumberColumns,
    open_text,
    positive,
    table_lines,
)
from springback.logs.frame_turns import BODIES, WORLDS, attitudes_in, vectors_in
from springback.logs.recording import (
    ATTITUDE,
    MARKERS,
    POSITION,
    Array,
    Budget,
    LogChannel,
    Recording,
    SensorChain,
    TimeSpan,
    log_channel,
    refuse_without_channels,
)

#: First word of the file.
MAGIC = "NO_OF_FRAMES"
#: Columns of a body: position, three angles, residual, and the matrix.
BODY_COLUMNS = 16
#: Angles that agree with a matrix do so within this [rad] (chosen: three digits are exported).
AGREED = math.radians(0.5)
#: Millimetre [m], the unit of all lengths.
MM = 1e-3


def read_qualisys(path: Path, part: TimeSpan, world: str, body: str) -> Recording:
    """Recording of a TSV file of QTM.

    Args:
        path: The file.
        part: Instants that are wanted [s].
        world: Name of its world axes, of `springback.logs.frame_turns.WORLDS`.
        body: Name of its body axes, of `springback.logs.frame_turns.BODIES`.

    Raises:
        InputError: If it is none, or nothing of it can be used.
    """
    where, budget = str(path), Budget(str(path))
    settings: dict[str, list[str]] = {}
    columns: NumberColumns | None = None
    lead: list[str] = []
    with open_text(path) as file:
        for line, cells in table_lines(file, where, "\t"):
            if cells and not cells[-1].strip():  # a tabulator at the end of the line
                cells.pop()
            if columns is None and cells:
                word = cells[0].strip()
                if word.lower() in ("frame", "time") or _is_axes(cells):
                    lead = [cell.strip().lower() for cell in cells[:2]]
                    continue
                if not _is_number(word):
                    settings[word] = [cell.strip() for cell in cells[1:]]
                    if line > MOST_HEADER:
                        break
                    continue
                columns = _columns(where, settings, lead, len(cells), budget)
            if columns is not None and cells:
                columns.add(line, cells)
    if columns is None:
        raise InputError(f"{where}: has no frames")
    values = columns.values()
    times = _times(where, settings, columns, values)
    chosen = np.array([part.has(at) for at in times], dtype=bool)
    values, times = values[chosen], times[chosen]
    if not len(times):
        raise InputError(f"{where}: has no frames between --from and --until")
    first = 1 if "Time" in columns.names else 0
    remarks: list[str] = []
    channels = _channels(where, settings, times, values[:, first:], world, body, remarks)
    refuse_without_channels(where, channels, "3D trajectories and 6D bodies", remarks)
    words = {key: " ".join(value)[:200] for key, value in settings.items()}
    return Recording(path, "Qualisys TSV", tuple(channels), (), words, tuple(remarks))


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _is_axes(cells: list[str]) -> bool:
    """True for the row of names above the columns."""
    words = {cell.strip() for cell in cells}
    return {"X", "Y", "Z"} <= words or any(word.endswith(" X") for word in words)


def _names(settings: dict[str, list[str]]) -> tuple[bool, list[str]]:
    """True and the bodies, or False and the markers."""
    included = " ".join(settings.get("DATA_INCLUDED", []))
    if "6D" in included:
        return True, settings.get("BODY_NAMES", [])
    return False, settings.get("MARKER_NAMES", [])


def _columns(
    where: str, settings: dict[str, list[str]], lead: list[str], width: int, budget: Budget
) -> NumberColumns:
    bodies, names = _names(settings)
    if not names:
        raise InputError(
            f"{where}: names neither markers nor bodies (MARKER_NAMES, BODY_NAMES) for "
            f"DATA_INCLUDED {shown_value(' '.join(settings.get('DATA_INCLUDED', [])))}"
        )
    each = BODY_COLUMNS if bodies else 3
    before = width - each * len(names)
    if lead:
        before = sum(word in ("frame", "time") for word in lead)
    wanted = before + each * len(names)
    if not 0 <= before <= 2 or width not in (wanted, wanted - 1):  # the last may be blank
        raise InputError(
            f"{where}: its lines have {width} numbers; {len(names)} "
            f"{'bodies need 16' if bodies else 'markers need 3'} each, after Frame and Time"
        )
    labels = [f"{name} {k + 1}" for name in names for k in range(each)]
    places = list(range(before, before + each * len(names)))
    # a single column before the data is the time if it is called so, else the number of the frame
    has_time = before == 2 or lead[:1] == ["time"]
    if has_time:
        labels, places = ["Time", *labels], [before - 1, *places]
    return NumberColumns(where, labels, places, budget)


def _times(
    where: str, settings: dict[str, list[str]], columns: NumberColumns, values: Array
) -> Array:
    if "Time" in columns.names:
        times = values[:, 0]
        if np.isnan(times).any():
            bad = int(np.flatnonzero(np.isnan(times))[0])
            raise InputError(f"{where}: frame {bad + 1} of its data has no time")
        return times
    word = next(iter(settings.get("FREQUENCY", [])), "")
    if not _is_number(word):
        raise InputError(
            f"{where}: FREQUENCY is {shown_value(word)} and there is no column of Time: export it "
            "with times"
        )
    return np.arange(len(values)) / positive(word, where, "FREQUENCY")


def _channels(
    where: str,
    settings: dict[str, list[str]],
    times: Array,
    values: Array,
    world: str,
    body: str,
    remarks: list[str],
) -> list[LogChannel]:
    bodies, names = _names(settings)
    if not bodies:
        markers = values.reshape(len(values), -1, 3) * MM
        markers[(markers == 0.0).all(axis=2)] = np.nan
        turned = vectors_in(WORLDS[world], markers).reshape(len(values), -1)
        return [
            log_channel(
                where, "markers", MARKERS, times, turned, clock="motion capture",
                labels=tuple(names),
            )
        ]  # fmt: skip
    found: list[LogChannel] = []
    chain = SensorChain(note="solved of markers by QTM")
    for k, name in enumerate(names):
        block = values[:, BODY_COLUMNS * k : BODY_COLUMNS * (k + 1)]
        matrix, spread = block[:, 7:].reshape(-1, 3, 3), np.abs(block[:, 7:]).sum(axis=1)
        lost = np.isnan(block).any(axis=1) | (spread == 0.0)
        position = np.where(lost[:, None], np.nan, vectors_in(WORLDS[world], block[:, :3] * MM))
        q = np.full((len(block), 4), np.nan)
        if not lost.all():
            q[~lost] = _attitudes(
                f"{where}: {name}", matrix[~lost], np.radians(block[~lost, 3:6]), remarks
            )
        attitude = attitudes_in(WORLDS[world], BODIES[body], q)
        for what, quantity, numbers in (
            ("position", POSITION, position), ("attitude", ATTITUDE, attitude),
        ):  # fmt: skip
            found.append(
                log_channel(
                    where, f"{name}.{what}", quantity, times, numbers, clock="motion capture",
                    chain=chain,
                )
            )  # fmt: skip
    return found


def _attitudes(where: str, matrices: Array, angles: Array, remarks: list[str]) -> Array:
    """Quaternions of matrices, in the order that agrees with the angles.

    Raises:
        InputError: If they are no rotations.
    """
    rotation = scipy.spatial.transform.Rotation
    unit = np.abs(np.einsum("nij,nik->njk", matrices, matrices) - np.eye(3)).max(axis=(1, 2))
    if not (unit < 0.01).all() or not (np.linalg.det(matrices) > 0.0).all():
        bad = int(np.argmax(unit))
        raise InputError(f"{where}: Rot of frame {bad + 1} is no rotation")
    told = rotation.from_euler("XYZ", angles)
    by_rows = rotation.from_matrix(matrices)
    by_columns = by_rows.inv()
    errors = [float(np.median((told.inv() * one).magnitude())) for one in (by_columns, by_rows)]
    best = by_columns if errors[0] <= errors[1] else by_rows
    if min(errors) > AGREED:
        remarks.append(
            f"{where}: its angles are not roll, pitch and yaw of Qualisys's standard: attitudes "
            "are those of Rot, read column by column"
        )
        best = by_columns
    return np.asarray(best.as_quat(scalar_first=True))
