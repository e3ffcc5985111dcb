"""Flights in lanes that are read at instants: each is what it is alone, whatever stands beside it."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

from identification.rigs import rig
from springback.batch.sampled import sampled_flights

TIMES = np.arange(0.0, 0.35, 0.001)


def impact(exponent: float, stiffness: float = 2e5) -> dict[str, Any]:
    tables = rig("quad")
    surface = tables["world"]["obstacles"][0]["surface"]
    surface |= {"exponent": exponent, "stiffness": stiffness}
    return {key: value for key, value in tables.items() if key not in ("sensors", "seed")}


def test_exponents_of_other_types_are_flown_beside_each_other() -> None:
    """3/2 is compiled by a square root, all others by a power: two kinds of flights."""
    tables = [impact(1.5), impact(1.4, 1e5), impact(1.5, 1e5), impact(1.6, 3e5)]
    together = sampled_flights(copy.deepcopy(tables), TIMES)
    for k, one in enumerate(tables):
        alone = sampled_flights([one], TIMES)
        assert np.array_equal(together.values[k], alone.values[0])
    depths = together.vectors("position")[:, :, 0].max(axis=1)
    assert len(set(np.round(depths, 6))) == 4


def test_a_force_of_another_exponent_beside_three_halves_is_its_own() -> None:
    """The deepest point by the energy of an elastic law, k δ^(n+1)/(n+1) = m v²/2."""
    tables = []
    for n in (1.5, 1.4):
        one = impact(n)
        one["world"]["obstacles"][0]["surface"] = {
            "law": "hertz", "stiffness": 2e5, "exponent": n, "shared_by": 2,
            "friction_axes": "vertical",
        }  # fmt: skip
        tables.append(one)
    found = sampled_flights(tables, TIMES)
    x = found.vectors("position")[:, :, 0]
    for k, n in enumerate((1.5, 1.4)):
        depth = ((n + 1.0) * 0.5 * 1.892 * 1.85**2 / 2e5) ** (1.0 / (n + 1.0))
        reach = 2.0 - 0.3 * 2.0**-0.5
        assert x[k].max() - reach == pytest.approx(depth, rel=2e-3)
