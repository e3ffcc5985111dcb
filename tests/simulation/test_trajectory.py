"""Trajectories: which instants are kept, and that measures know all."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback import InputError, fly, load
from springback.simulation.trajectory import StoredRows

WALL = {"type": "wall", "distance": 2.5, "surface": "wall"}
THROWN: dict[str, Any] = {
    "vehicle": "arq", "thrust": "hover",
    "start": {"position": [2.1, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
    "world": {"obstacles": [WALL]},
    "simulation": {"duration": 0.15},
}  # fmt: skip
FLOWN: dict[str, Any] = {
    "vehicle": "arq",
    "reference": {"type": "run-up", "speed": 2.0},
    "world": {"obstacles": [WALL]},
    "simulation": {"duration": 2.503},
}
PAIR: dict[str, Any] = THROWN | {
    "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
    "second": {"vehicle": "quad", "thrust": "hover", "start": {"position": [2.8, 0.0, 1.0]}},
}


def thin(tables: dict[str, Any], interval: float | str) -> dict[str, Any]:
    return tables | {"simulation": tables["simulation"] | {"record_interval": interval}}


@pytest.mark.parametrize("tables", [THROWN, FLOWN, PAIR], ids=["throw", "pilot", "pair"])
def test_of_each_interval_the_first_instant_is_kept(tables: dict[str, Any]) -> None:
    """And the last of the flight; measures are those of all steps."""
    whole, kept = fly(tables), fly(thin(tables, "4 ms"))
    every, some = whole.columns["t"], kept.columns["t"]
    number = np.floor(every / 0.004 + 1e-6)
    first = np.flatnonzero(np.diff(number, prepend=-1.0) > 0)
    assert first[-1] < len(every) - 1
    at = np.array([*first, len(every) - 1])
    np.testing.assert_array_equal(some, every[at])
    for name in nonempty(whole.columns):
        assert whole.columns[name].shape[-1] == len(every)
        rows = whole.columns[name][..., at]
        np.testing.assert_array_equal(kept.columns[name], rows, err_msg=name)
    assert kept.measures == whole.measures
    assert len(some) < len(every) / 3


def test_rows_come_in_parts_of_any_size() -> None:
    rng = np.random.default_rng(3)
    table = np.column_stack([np.cumsum(rng.exponential(1e-3, 500)), rng.normal(size=500)])
    at_once = StoredRows(2, 3e-3)
    at_once.add(table)
    for cuts in nonempty([[1, 2, 250], [0, 499], [7, 7, 8, 300, 301]]):
        parts = StoredRows(2, 3e-3)
        for part in np.split(table, cuts):
            parts.add(part)
        np.testing.assert_array_equal(parts.all(), at_once.all())
    np.testing.assert_array_equal(at_once.all()[-1], table[-1])
    every = StoredRows(2)
    every.add(table)
    np.testing.assert_array_equal(every.all(), table)


@pytest.mark.parametrize("tables", [THROWN, FLOWN, PAIR], ids=["throw", "pilot", "pair"])
def test_what_is_kept_can_be_saved_and_read_again(tables: dict[str, Any], tmp_path: Path) -> None:
    """Scenarios are saved with all their tables, the sensors that nobody read among them."""
    kept = fly(thin(tables, "4 ms"))
    kept.save(tmp_path / "out", figures=False)
    again = load(tmp_path / "out")
    np.testing.assert_array_equal(again.columns["x"], kept.columns["x"])
    assert again.scenario.simulation.record_interval == 0.004


def test_sensors_without_a_pilot_need_every_step() -> None:
    with pytest.raises(InputError, match=r"^simulation\.record_interval: must be 0: without"):
        fly(thin(THROWN, "1 ms") | {"sensors": {}})
    with pytest.raises(InputError, match=r"^simulation\.record_interval: .*at least 0 s"):
        fly(thin(THROWN, -1.0))
