"""Impacts that press arms against their stops, by laws with and without a memory: ledgers close."""

from __future__ import annotations

from itertools import product

import pytest

import springback
from builders.cases import nonempty

LAWS = {
    "hunt-crossley": {"law": "hunt-crossley", "dissipation": 0.3},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.5},
}
#: A vehicle, and where it starts that its first hull is a little before the box [m].
STARTS = {"morphy": 0.405, "xplorer": 0.322}


@pytest.mark.parametrize(("vehicle", "law"), nonempty(product(STARTS, LAWS)))
def test_the_ledger_of_arms_at_their_stops_closes(vehicle: str, law: str) -> None:
    """To 2e-6: the contact comes deeper while a stop pushes it, and comes out.

    A stop acts at its full stiffness from the first moment, and what a contact loses by coming
    deeper begins at once: neither may depend on where within a step that is.
    """
    surface = {"stiffness": 5e4, **LAWS[law]}
    box = {"type": "box", "position": [0.8, 0, 1], "size": [0.5, 1, 1], "surface": surface}
    scenario = {
        "vehicle": vehicle,
        "thrust": "hover",
        "start": {"position": [STARTS[vehicle], 0, 1], "velocity": [3.0, 0, 0]},
        "simulation": {"duration": 0.06},
        "world": {"obstacles": [box]},
    }
    flown = springback.fly(scenario, executor="python", trajectory=False)
    assert flown.outcome.name == "ARM_BOTTOMED"
    assert flown.loss_stop > 1e-3
    assert abs(flown.ledger_residual) < 2e-6
