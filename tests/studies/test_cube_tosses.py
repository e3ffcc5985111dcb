"""Tosses of a cube: reading files without PyTorch, and throwing it again.

The files are written here in the same form; those of the recordings are no part of the tests.
"""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from springback.errors import InputError
from springback.results.flight import fly
from springback.studies.recordings.cube_tosses import (
    HALF,
    MAGIC,
    PERIOD,
    Toss,
    TossLaw,
    read_toss,
    read_tosses,
    toss_errors,
    toss_sentences,
    toss_tables,
)

Array = np.ndarray[Any, np.dtype[np.float64]]
LAW = TossLaw(0.3, 0.25)


def tensor_bytes(size: tuple[int, ...], count: int, kind: str = "DoubleStorage") -> bytes:
    """A pickle of a tensor as PyTorch's first format has it."""

    def number(value: int) -> bytes:
        return b"J" + value.to_bytes(4, "little", signed=True)

    shape = b"(" + b"".join(number(one) for one in size) + b"t"
    steps = b"(" + b"".join(number(1) for _ in size) + b"t"
    storage = b"(" + b"X\x07\x00\x00\x00storage" + f"ctorch\n{kind}\n".encode()
    storage += b"X\x01\x00\x00\x000X\x03\x00\x00\x00cpu" + number(count) + b"NtQ"
    empty = b"ccollections\nOrderedDict\n)R"
    return (
        b"\x80\x02ctorch._utils\n_rebuild_tensor_v2\n("
        + storage + number(0) + shape + steps + b"\x89" + empty + b"tR."
    )  # fmt: skip


def written(path: Path, rows: Array, **others: Any) -> Path:
    """A file of a toss, or of something like it."""
    size, count = others.get("size", (1, *rows.shape)), rows.size
    parts = [pickle.dumps(one, 2) for one in (others.get("magic", MAGIC), 1001, {"int": 4})]
    parts += [others.get("tensor", tensor_bytes(size, count)), pickle.dumps(["0"], 2)]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"".join(parts) + count.to_bytes(8, "little") + rows.astype("<f8").tobytes())
    return path


def recorded(law: TossLaw = LAW, count: int = 90) -> Array:
    """Rows of a toss as this package throws it, from a turned start."""
    turned = np.array([0.8, 0.3, -0.4, 0.33])
    start = np.zeros((count, 19))
    start[0] = [1.0, -2.0, 3.5, *turned / np.linalg.norm(turned), 12.0, -5.0, -3.0, 2.0, 1.0, -4.0,
                *[0.0] * 6]  # fmt: skip
    toss = _toss(start)
    flight = fly(toss_tables(toss, law))
    c, times = flight.columns, PERIOD * np.arange(count)
    rows = start.copy()
    for k, axis in enumerate("xyz"):
        rows[:, k] = np.interp(times, flight.t, c[f"obstacle0_{axis}"]) / HALF
    rows[:, 3:7] = start[0, 3:7]
    q = [c[f"obstacle0_q{part}"][-1] for part in "wxyz"]
    rows[-1, 3:7] = product(q, start[0, 3:7])
    return rows


def product(p: Any, q: Any) -> Any:
    """Product of two quaternions."""
    (a, b), (u, v) = (p[0], np.array(p[1:])), (q[0], np.array(q[1:]))
    return [a * u - b @ v, *(a * v + u * b + np.cross(b, v))]


def _toss(rows: Array) -> Toss:
    return Toss(rows[:, :3] * HALF, rows[:, 3:7], rows[:, 7:10] * HALF, rows[:, 10:13])


def test_a_file_is_read_as_it_was_written(tmp_path: Path) -> None:
    """Lengths in metres; in the order of the files' numbers."""
    chance = np.random.default_rng(3)
    tosses = [chance.normal(size=(5 + k, 19)) for k in range(12)]
    for rows in tosses:
        rows[:, 3:7] /= np.linalg.norm(rows[:, 3:7], axis=1)[:, None]
    for k, rows in enumerate(tosses):
        written(tmp_path / "data" / "tosses_processed" / f"{k}.pt", rows)
    found = read_tosses(tmp_path)
    assert [len(toss.position) for toss in found] == [5 + k for k in range(12)]
    assert np.allclose(found[3].position, tosses[3][:, :3] * HALF, rtol=1e-15)
    assert np.array_equal(found[3].spin, tosses[3][:, 10:13])


def test_the_law_that_made_a_toss_throws_it_again(tmp_path: Path) -> None:
    """Place and attitude at the end; another friction ends elsewhere."""
    toss = read_toss(written(tmp_path / "0.pt", recorded()))
    same, other = toss_errors(toss, LAW), toss_errors(toss, TossLaw(0.3, 0.1))
    assert same.rest < 1e-9
    assert same.turn < 1e-6
    assert same.path < 1e-6
    assert same.same_face == 1.0
    assert same.way > 0.2
    assert same.ledger < 1e-5
    assert other.rest > 0.01
    sentences = toss_sentences([toss], LAW)
    assert sentences[0] == "1 tosses, restitution 0.3, friction 0.25"
    assert sentences[3] == "turned by 0 degrees by the median; on the same face: 100 %"


def test_the_spin_is_that_of_the_cube(tmp_path: Path) -> None:
    """In its own axes: a cube turned by a quarter about z that spins about its x spins about y."""
    rows = np.zeros((3, 19))
    rows[:, 3] = rows[:, 6] = np.sqrt(0.5)
    rows[:, 2], rows[:, 10] = 9.0, 2.0
    toss = read_toss(written(tmp_path / "0.pt", rows))
    cube = toss_tables(toss)["world"]["obstacles"][0]
    assert cube["motion"]["angular_velocity"] == pytest.approx([0.0, 2.0, 0.0], abs=1e-12)
    assert cube["yaw"] == pytest.approx(0.5 * np.pi)


ROWS = np.full((4, 19), 0.5)


@pytest.mark.parametrize(
    ("others", "words"),
    [
        ({"magic": 7}, "must hold rows of 19 doubles"),
        ({"size": (4, 19)}, "must hold rows of 19 doubles"),
        ({"size": (1, 9, 19)}, "must hold 9 x 19 finite numbers"),
        ({"tensor": tensor_bytes((1, 4, 19), 76, "FloatStorage")}, "is no file of a tensor"),
        ({"tensor": b"cos\nsystem\n(X\x04\x00\x00\x00truetR."}, "is no file of a tensor"),
        ({"tensor": b"\x80\x02K\x01."}, "is no file of a tensor"),
    ],
)
def test_files_of_another_form_are_refused(
    tmp_path: Path, others: dict[str, Any], words: str
) -> None:
    """In a line; no code in them is run."""
    with pytest.raises(InputError, match=words):
        read_toss(written(tmp_path / "0.pt", ROWS, **others))


def test_numbers_must_be_finite_and_a_folder_must_have_some(tmp_path: Path) -> None:
    """Each is refused in a line."""
    with pytest.raises(InputError, match="finite numbers"):
        read_toss(written(tmp_path / "0.pt", ROWS * np.nan))
    with pytest.raises(InputError, match="attitudes must have length 1"):
        read_toss(written(tmp_path / "0.pt", 2.0 * ROWS))
    with pytest.raises(InputError, match=r"has no tosses; name a copy of github"):
        read_tosses(tmp_path / "none")
