"""Tracks of recordings as text files of motion captures: Motive, Vicon and Qualisys."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.errors import InputError
from springback.files import write_atomically
from springback.logs.frame_turns import WORLDS, attitudes_in, rotation_vector, vectors_in
from springback.logs.recording import ATTITUDE, POSITION, Array, Recording

#: Frames lie on an even grid within this share of their distance.
EVEN = 1e-3


class _Body(NamedTuple):
    name: str
    position: Array  # [m], shape (frames, 3)
    attitude: Array  # shape (frames, 4)


def _bodies(recording: Recording, world: str, body: str) -> tuple[Array, list[_Body]]:
    """Instants, and the measured bodies in other axes.

    Raises:
        InputError: If there are none.
    """
    found: list[_Body] = []
    times: Array | None = None
    for place in recording.of(POSITION):
        turn = next(
            (
                one for one in recording.of(ATTITUDE)
                if one.clock == place.clock and np.array_equal(one.times, place.times)
                and one.name.rpartition(".")[0] == place.name.rpartition(".")[0]
            ),
            None,
        )  # fmt: skip
        if place.chain.estimated or turn is None:
            continue
        if times is not None and not np.array_equal(times, place.times):
            continue
        times = place.times
        w, b = WORLDS[world].T, WORLDS[body].T
        found.append(
            _Body(
                place.name.rpartition(".")[0] or place.name,
                vectors_in(w, place.values),
                attitudes_in(w, b, turn.values),
            )
        )
    if times is None:
        raise InputError(f"{recording.path}: has no measured position with an attitude")
    return times, found


def _left_out(recording: Recording, bodies: list[_Body]) -> list[str]:
    """Names of channels that are not those of the bodies."""
    names = {f"{one.name}.{part}" for one in bodies for part in ("position", "attitude")}
    return [one.name for one in recording.channels if one.name not in names]


def _rate(times: Array) -> float:
    steps = np.diff(times)
    steps = steps[steps > 0.0]
    return float(1.0 / np.median(steps)) if len(steps) else 1.0


def write_motive(recording: Recording, path: Path) -> list[str]:
    """Write the bodies of a recording as Motive's CSV: Y up, metres, quaternions.

    Args:
        recording: What is written.
        path: The file.

    Returns:
        Names of other channels, which are left out.

    Raises:
        InputError: If it has no bodies.
    """
    times, bodies = _bodies(recording, "y-up", "y-up")
    rate, frames = _rate(times), len(times)
    head = [
        "Format Version", "1.23", "Take Name", "springback", "Capture Frame Rate", f"{rate:.6f}",
        "Export Frame Rate", f"{rate:.6f}", "Total Frames in Take", f"{frames}",
        "Rotation Type", "Quaternion", "Length Units", "Meters", "Coordinate Space", "Global",
    ]  # fmt: skip
    names = [one.name.replace(",", " ") for one in bodies]
    parts = ["Rotation"] * 4 + ["Position"] * 3
    lines = [
        ",".join(head),
        "",
        ",".join(["", "Type", *["Rigid Body"] * (7 * len(bodies))]),
        ",".join(["", "Name", *[name for name in names for _ in range(7)]]),
        ",".join(["", "ID", *[str(k + 1) for k in range(len(bodies)) for _ in range(7)]]),
        ",".join(["", "", *parts * len(bodies)]),
        ",".join(["Frame", "Time (Seconds)", *list("XYZWXYZ") * len(bodies)]),
    ]
    for k, at in enumerate(times):
        cells = [str(k), f"{at:.9f}"]
        for one in bodies:
            w, x, y, z = one.attitude[k]
            cells += _cells([x, y, z, w, *one.position[k]], 9)
        lines.append(",".join(cells))
    write_atomically(path, "\n".join([*lines, ""]))
    return _left_out(recording, bodies)


def _cells(values: list[float], digits: int) -> list[str]:
    """Numbers as text; blanks for lost ones."""
    if np.isnan(values).any():
        return [""] * len(values)
    return [f"{one:.{digits}f}" for one in values]


def write_vicon(recording: Recording, path: Path) -> list[str]:
    """Write the bodies of a recording as Vicon's CSV: rotation vectors [rad], millimetres.

    Args:
        recording: What is written.
        path: The file.

    Returns:
        Names of other channels, which are left out.

    Raises:
        InputError: If it has no bodies, or its frames are not on an even grid from 0 on.
    """
    times, bodies = _bodies(recording, "z-up", "nwu")
    rate = _rate(times)
    exact = round(rate) if abs(rate - round(rate)) < 1e-3 else rate
    places = times * exact
    numbers = np.round(places)
    if np.abs(places - numbers).max() > EVEN or numbers[0] < 0:
        raise InputError(
            f"{recording.path}: its frames are not at multiples of {1e3 / exact:.4g} ms, and "
            "Vicon's files have no times"
        )
    axes = ["RX", "RY", "RZ", "TX", "TY", "TZ"]
    units = ["rad"] * 3 + ["mm"] * 3
    lines = [
        "Segments",
        f"{exact:g}",
        "," + "".join(f",springback:{one.name.replace(',', ' ')},,,,," for one in bodies),
        ",".join(["Frame", "Sub Frame", *axes * len(bodies)]),
        ",".join(["", "", *units * len(bodies)]),
    ]
    for k, frame in enumerate(numbers):
        cells = [str(int(frame) + 1), "0"]
        for one in bodies:
            turn = rotation_vector(one.attitude[k])
            cells += _cells([*turn, *(1e3 * one.position[k])], 9)
        lines.append(",".join(cells))
    write_atomically(path, "\n".join([*lines, ""]))
    return _left_out(recording, bodies)


def write_qualisys(recording: Recording, path: Path) -> list[str]:
    """Write the bodies of a recording as QTM's TSV, 6D: millimetres, degrees, matrices.

    Args:
        recording: What is written.
        path: The file.

    Returns:
        Names of other channels, which are left out.

    Raises:
        InputError: If it has no bodies.
    """
    times, bodies = _bodies(recording, "z-up", "nwu")
    names = [one.name.replace("\t", " ") for one in bodies]
    matrix = [f"Rot[{k}]" for k in range(9)]
    columns = ["X", "Y", "Z", "Roll", "Pitch", "Yaw", "Residual", *matrix]
    lines = [
        f"NO_OF_FRAMES\t{len(times)}",
        "NO_OF_CAMERAS\t8",
        f"NO_OF_BODIES\t{len(bodies)}",
        f"FREQUENCY\t{_rate(times):.6g}",
        "DESCRIPTION\tspringback, simulated",
        "DATA_INCLUDED\t6D",
        "\t".join(["BODY_NAMES", *names]),
        "\t".join(["Frame", "Time", *columns * len(bodies)]),
    ]
    rotation = scipy.spatial.transform.Rotation
    for k, at in enumerate(times):
        cells = [str(k + 1), f"{at:.9f}"]
        for one in bodies:
            if np.isnan(one.position[k]).any() or np.isnan(one.attitude[k]).any():
                cells += ["0.000"] * 16
                continue
            turn = rotation.from_quat(one.attitude[k], scalar_first=True)
            angles = turn.as_euler("XYZ", degrees=True, suppress_warnings=True)
            listed = turn.as_matrix().T.reshape(-1)  # column by column
            cells += _cells([*(1e3 * one.position[k]), *angles, 0.0], 7)
            cells += _cells([*listed], 10)
        lines.append("\t".join(cells))
    write_atomically(path, "\n".join([*lines, ""]))
    return _left_out(recording, bodies)
