"""Recorded tosses of a cube on a board, and the same cube thrown here from where each began.

The recordings are those of S. Pfrommer, M. Halm and M. Posa, "ContactNets: Learning Discontinuous
Contact Dynamics with Smooth, Implicit Representations" (2020), DAIR Lab, repository
``DAIRLab/contact-nets``, BSD-3-Clause.  Nothing is fetched: the user names the folder of a copy.

Lengths in the files are half widths of the cube.  A row is position, attitude wxyz, velocity in
world axes, angular velocity in the cube's axes, and six inputs, which are zero.  Files are of
PyTorch's first format: pickles and then the numbers; they are read without it, and no code in them
is run.

    python -m springback.studies.recordings.cube_tosses FOLDER
"""

from __future__ import annotations

import collections
import io
import pickle
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from springback.errors import InputError
from springback.results.flight import fly
from springback.studies.recordings.command import run_study

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Half width of the cube [m], its mass [kg] and moment of inertia [kg m²], as the files and their
#: parameters give them (0.295 m h²), and time between rows [s].
HALF, MASS, INERTIA, PERIOD = 0.0524, 0.37, 0.00081, 1.0 / 148.0
#: Columns of a row.
WIDTH = 19
#: Largest file that is read [bytes], and the first number of the format.
LARGEST, MAGIC = 10_000_000, 0x1950A86A20F9469CFC6C
#: Stiffness of cube and board [N/m^1.5] (chosen: some 5 mm at 2 m/s; 4e4 gives the same errors to a
#: tenth), speed at which restitution holds and slip speed [m/s] (chosen).
STIFFNESS, SPEED, SLIP_SPEED = 1e6, 1.0, 0.02


class TossLaw(NamedTuple):
    """What was fitted of cube and board."""

    restitution: float
    friction: float


#: Fitted on the first fifth of 570 tosses, by the median error of the place of rest, over
#: e of 0.1, 0.2 and μ from 0.16 to 0.20 in steps of 0.01.
FROZEN = TossLaw(0.1, 0.18)


class Toss(NamedTuple):
    """A recorded toss; world axes, the board at z = 0."""

    position: Array  # [m], shape (rows, 3)
    attitude: Array  # wxyz, cube to world, shape (rows, 4)
    velocity: Array  # [m/s], shape (rows, 3)
    spin: Array  # cube's axes [rad/s], shape (rows, 3)


class TossErrors(NamedTuple):
    """Errors of one toss."""

    rest: float  # of the place at the end of the recording [m]
    turn: float  # of the attitude there [rad]
    path: float  # mean of the place over the recording [m]
    same_face: float  # 1 if it lies on the same face
    way: float  # from beginning to end, along the board, recorded [m]
    ledger: float  # share of the energy that the flight's ledger leaves


class _Numbers(pickle.Unpickler):
    """Reads plain values and the one kind of tensor; anything else is refused."""

    def find_class(self, module: str, name: str) -> Any:
        """A stand-in for each of the three names of a tensor of doubles."""
        known: dict[tuple[str, str], Any] = {
            ("torch._utils", "_rebuild_tensor_v2"): lambda *given: given,
            ("torch", "DoubleStorage"): "double",
            ("collections", "OrderedDict"): collections.OrderedDict,
        }
        if (module, name) not in known:
            raise pickle.UnpicklingError(f"{module}.{name}")
        return known[module, name]

    def persistent_load(self, pid: Any) -> Any:
        """What is said of the numbers that follow."""
        return pid


def read_toss(path: Path) -> Toss:
    """A toss from a file of the recordings.

    Raises:
        InputError: If it is too large, of another format, or holds anything else.
    """
    if path.stat().st_size > LARGEST:
        raise InputError(f"{path}: has more than {LARGEST / 1e6:g} MB")
    given = io.BytesIO(path.read_bytes())
    try:
        magic, _, _, tensor, _ = (_Numbers(given).load() for _ in range(5))
        storage, offset, size = tensor[:3]
        count = int.from_bytes(given.read(8), "little")
        numbers = np.frombuffer(given.read(), "<f8")
        fits = magic == MAGIC and storage[1] == "double" and offset == 0
    except (pickle.UnpicklingError, ValueError, TypeError, IndexError, EOFError, KeyError,
            AttributeError, OverflowError, UnicodeDecodeError, ImportError):  # fmt: skip
        raise InputError(f"{path}: is no file of a tensor of doubles") from None
    if not (fits and len(size) == 3 and size[0] == 1 and size[2] == WIDTH and size[1] >= 2):
        raise InputError(f"{path}: must hold rows of {WIDTH} doubles")
    if count != size[1] * WIDTH or len(numbers) != count or not np.isfinite(numbers).all():
        raise InputError(f"{path}: must hold {size[1]} x {WIDTH} finite numbers")
    rows = numbers.reshape(-1, WIDTH).copy()
    if np.abs(np.linalg.norm(rows[:, 3:7], axis=1) - 1.0).max() > 0.01:
        raise InputError(f"{path}: attitudes must have length 1")
    return Toss(rows[:, :3] * HALF, rows[:, 3:7], rows[:, 7:10] * HALF, rows[:, 10:13])


def read_tosses(folder: Path) -> list[Toss]:
    """All tosses of a copy of the repository, or of its folder ``data/tosses_processed``, in order.

    Raises:
        InputError: If there is none, or one cannot be read.
    """
    for place in (folder / "data" / "tosses_processed", folder):
        paths = [path for path in place.glob("*.pt") if path.stem.isdecimal()]
        if paths:
            return [read_toss(path) for path in sorted(paths, key=lambda path: int(path.stem))]
    raise InputError(f"{folder}: has no tosses; name a copy of github.com/DAIRLab/contact-nets")


def toss_tables(toss: Toss, law: TossLaw = FROZEN) -> dict[str, Any]:
    """A scenario in which the cube is thrown as it was, and a vehicle is too far away to matter."""
    turn = Rotation.from_quat(toss.attitude[0], scalar_first=True)
    yaw, pitch, roll = turn.as_euler("ZYX").tolist()
    surface = {
        "stiffness": STIFFNESS, "restitution": law.restitution, "restitution_speed": SPEED,
        "friction": law.friction, "slip_speed": SLIP_SPEED,
    }  # fmt: skip
    cube = {
        "type": "box", "position": toss.position[0].tolist(), "size": [2.0 * HALF] * 3,
        "edge_radius": 0.0, "roll": roll, "pitch": pitch, "yaw": yaw, "surface": surface,
        "motion": {
            "type": "free", "mass": MASS, "inertia": [INERTIA] * 3,
            "velocity": toss.velocity[0].tolist(),
            "angular_velocity": turn.apply(toss.spin[0]).tolist(),
        },
    }  # fmt: skip
    return {
        "vehicle": "quad",
        "thrust": [0.0] * 4,
        "world": {"obstacles": [cube, {"type": "ground", "surface": surface}]},
        "start": {"position": [50.0, 50.0, 500.0]},
        "simulation": {"duration": (len(toss.position) - 1) * PERIOD},
    }


def toss_errors(toss: Toss, law: TossLaw = FROZEN) -> TossErrors:
    """Throw the cube as it was thrown, and see where it is when the recording ends."""
    flight = fly(toss_tables(toss, law))
    c = flight.columns
    place = np.stack([c[f"obstacle0_{axis}"] for axis in "xyz"], axis=1)
    turn = [c[f"obstacle0_q{part}"][-1] for part in "wxyz"]  # since the start
    first, last = (Rotation.from_quat(toss.attitude[k], scalar_first=True) for k in (0, -1))
    end = Rotation.from_quat(turn, scalar_first=True) * first
    up, recorded = (one.inv().apply([0.0, 0.0, 1.0]) for one in (end, last))
    times = PERIOD * np.arange(len(toss.position))
    then = np.stack([np.interp(times, flight.t, column) for column in place.T], axis=1)
    return TossErrors(
        float(np.linalg.norm(place[-1] - toss.position[-1])),
        float((end * last.inv()).magnitude()),
        float(np.linalg.norm(then - toss.position, axis=1).mean()),
        1.0
        if np.argmax(np.abs(up)) == np.argmax(np.abs(recorded)) and up @ recorded > 0.0
        else 0.0,
        float(np.linalg.norm((toss.position[-1] - toss.position[0])[:2])),
        abs(flight.measures["ledger_residual"] or 0.0),
    )


def toss_sentences(tosses: list[Toss], law: TossLaw = FROZEN) -> list[str]:
    """What is to be said of all tosses but the first fifth, on which the law was fitted."""
    rest = tosses[len(tosses) // 5 :]
    found = [toss_errors(toss, law) for toss in rest]
    median = TossErrors(*np.median(np.array(found), axis=0))
    low, high = np.quantile([one.rest for one in found], [0.25, 0.75])
    same = np.mean([one.same_face for one in found])
    return [
        f"{len(rest)} tosses, restitution {law.restitution:g}, friction {law.friction:g}",
        f"place of rest: off by {1e3 * median.rest:.1f} mm by the median (quartiles "
        f"{1e3 * low:.1f} and {1e3 * high:.1f}), of a way of {1e3 * median.way:.0f} mm",
        f"place on the way: off by {1e3 * median.path:.1f} mm by the median of the means",
        f"turned by {np.degrees(median.turn):.0f} degrees by the median; on the same face: "
        f"{100.0 * same:.0f} %",
        f"largest rest of a ledger: {max(one.ledger for one in found):.1e}",
    ]


def toss_lines(folder: Path | None) -> Iterator[str]:
    """`toss_sentences` of a copy of the repository.

    Raises:
        InputError: If none is named, or it has no tosses that can be read.
    """
    if folder is None:
        raise InputError("no folder was named; name a copy of github.com/DAIRLab/contact-nets")
    yield from toss_sentences(read_tosses(folder))


if __name__ == "__main__":
    sys.exit(run_study(toss_lines, sys.argv[1:]))
