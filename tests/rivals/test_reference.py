"""The impact written by hand in C flies what ours flies: else their speeds say nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.c_reference import Reference, disagreement
from benchmarks.job import Lanes, reference_model, starts
from benchmarks.run import AGREEMENT

from builders.missing import needs
from springback.simulation.flight import LANES

FLIGHTS = 48


@needs("gcc")
@pytest.mark.parametrize("lanes", [1, 4])
@pytest.mark.parametrize(("until", "free_step"), [(0.1, 1e-4), (0.3, 1e-3)])
def test_the_reference_takes_our_steps_to_our_numbers(
    tmp_path: Path, lanes: int, until: float, free_step: float
) -> None:
    model = reference_model(until=until, free_step=free_step)
    states = starts(model, FLIGHTS)
    ours = Lanes(model, states, LANES).run(1)
    error, where = disagreement(ours, Reference(lanes, tmp_path, model, states).run(1))
    assert error < AGREEMENT, where
