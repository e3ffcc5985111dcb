"""The Newton-Euler form is the paper's ten-coordinate Lagrangian, state by state.

Two derivations that share no line: SymPy's from energies and virtual work, and the package's from the
balance of forces and moments with the arms eliminated.  Both are exact, so they agree to rounding:
the solve amplifies it by the condition of the mass matrix, some 10³, hence 1e-9 and not 1e-15.
"""

from __future__ import annotations

import numpy as np
import pytest

from oracles import lagrangian, models

WALL = models.Wall(np.array([-1.0, 0.0, 0.0]), -models.FAR)
STATES = 80
RELATIVE = 1e-9


@pytest.fixture(scope="module", autouse=True)
def equations() -> None:
    """Derive once."""
    lagrangian.derived()


def drawn(seed: int, contacts: int) -> tuple[models.Scene, models.Start]:
    """A vehicle with four unequal arms at a random state, some cages in the wall, rotors on."""
    rng = np.random.default_rng([seed, contacts])
    craft = models.random_craft(rng)
    start = models.random_start(rng, craft)
    scene = models.Scene(
        craft,
        WALL,
        thrust=tuple(rng.uniform(0.0, 12.0, size=4)),
        contact="tip",
        friction_axes="vertical",
    )
    return models.touching(scene, start, contacts, rng.uniform(1e-3, 15e-3)), start


def error(a: np.ndarray, b: np.ndarray) -> float:
    """Largest difference, relative to the largest component (at least 1)."""
    return float(np.abs(a - b).max() / max(1.0, np.abs(b).max()))


@pytest.mark.parametrize("contacts", [0, 1, 2])
def test_accelerations_are_those_of_the_lagrangian(contacts: int) -> None:
    """v̇, ω̇ and l̈ agree at random states with no, one and two cages in contact."""
    pressed = 0
    for seed in range(STATES):
        scene, start = drawn(seed, contacts)
        ours = models.accelerations_of(scene, start)
        theirs = lagrangian.accelerations(scene, start)
        for a, b in zip(ours, theirs, strict=True):
            assert error(a, b) < RELATIVE
        arms = models.rates_of(scene, start).seen.arms
        assert sum(arm.depth > 0.0 for arm in arms) == contacts
        pressed += sum(arm.normal > 0.0 for arm in arms)
    # Some cages leave so fast that the surface lets go; most must press, or nothing was compared.
    assert pressed >= STATES * contacts / 2
