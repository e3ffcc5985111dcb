"""The energy ledger's balance, from energies and work given by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.dynamics.energy import Energy
from springback.dynamics.ledger import LedgerBalance, ledger_balance
from springback.dynamics.motion import Work
from springback.dynamics.moving_obstacles import BodyWork
from springback.kernels.vectors import Vec

NO_WORK = Work(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, Vec(0.0, 0.0, 0.0))


def balance(
    end: float,
    gravity: float = 3.0,
    start: float = 10.0,
    bodies_of: BodyWork | None = None,
    gained: float = 0.0,
    **work: float,
) -> LedgerBalance:
    """Balance of one flight from kinetic energies at the start and the end, 3 J up at the start."""
    columns: Any = NO_WORK._replace(**{name: np.array([w]) for name, w in work.items()})
    if bodies_of is not None:
        columns = columns._replace(bodies=(bodies_of,))
    none = np.array([0.0])
    energies = (
        Energy(np.array([kinetic]), np.array([height]), none, none, none, np.array([obstacles]))  # type: ignore[arg-type]
        for kinetic, height, obstacles in ((start, 3.0, 5.0), (end, gravity, 5.0 + gained))
    )
    return ledger_balance(columns, *energies)


@pytest.mark.parametrize("lost", ["arm", "stop", "contact", "friction", "settling", "air"])
def test_each_loss_is_missing_at_the_end(lost: str) -> None:
    found = balance(8.0, thrust=4.0, **{lost: 6.0})
    assert (found.start, found.end, found.residual) == (10.0, 8.0, 0.0)
    assert found.closes


def test_height_is_counted_from_the_start() -> None:
    found = balance(8.0, gravity=5.0)
    assert (found.start, found.end, found.residual) == (10.0, 10.0, 0.0)


def test_the_residual_is_a_share_of_the_largest_energy() -> None:
    assert balance(10.004).residual == pytest.approx(4e-4, rel=1e-3)
    assert balance(1.0).residual == pytest.approx(-0.9)
    assert balance(1.0, gravity=-7.0, start=1.0).residual == pytest.approx(-1.0)
    assert balance(10.004, thrust=-100.0, arm=-100.0).residual == pytest.approx(4e-5, rel=1e-3)


@pytest.mark.parametrize(("left", "closes"), [(9e-4, True), (1.1e-3, False), (-1.1e-3, False)])
def test_a_ledger_closes_to_a_ten_thousandth(left: float, closes: bool) -> None:
    assert bool(balance(10.0 + left).closes) is closes


@pytest.mark.parametrize(("left", "closes"), [(0.9e-9, True), (1.1e-9, False)])
def test_at_rest_it_closes_to_rounding(left: float, closes: bool) -> None:
    found = balance(left, start=0.0)
    assert found.residual > 0.9
    assert bool(found.closes) is closes


def test_what_moves_obstacles_and_what_they_keep_is_counted() -> None:
    """Work of a drive goes into the vehicle; what a free obstacle gained left it."""
    pushed = BodyWork(2.0, 0.0, 0.0, 0.0)
    assert balance(12.0, bodies_of=pushed).residual[0] == pytest.approx(0.0, abs=1e-12)
    lost = BodyWork(0.0, 0.5, 0.25, 0.25)
    assert balance(9.0, bodies_of=lost).residual[0] == pytest.approx(0.0, abs=1e-12)
    assert balance(8.0, gained=2.0).residual[0] == pytest.approx(0.0, abs=1e-12)
