"""Arms on two joints that begin pressed in on the second: where that puts them, and what follows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from builders.cases import nonempty
from springback.batch.scenarios import fly_scenarios
from springback.errors import InputError
from springback.results.flight import as_scenario, fly

HELD = 0.06  # of both hinges from the middle [m]
RADIUS, MASS = 0.13, 0.05  # of an arm's end from the hinge, of arq's arms
STIFFNESS, DAMPING = 2.0, 0.01


def tables(pressed: Any, heavy: bool = True, second: Any = None, **more: Any) -> dict[str, Any]:
    """ARQ's arms on universal joints, without gravity, on a main body that hardly moves."""
    first = {
        "type": "hinge", "position": [HELD, 0, 0], "axis": [0, 1, 0], "travel": [-0.6, 0.6],
        "stiffness": 3.0, "damping": 0.02,
    }  # fmt: skip
    side = first | {"axis": [0, 0, 1], "stiffness": STIFFNESS, "damping": DAMPING}
    body = {"body": {"mass": 400.0, "inertia": [30.0, 30.0, 30.0]}} if heavy else {}
    return {
        "vehicle": {
            "preset": "arq", **body,
            "arms": {"joint": {**first, "second": {**side, **(second or {})}}},
        },
        "world": {"gravity": 0},
        "thrust": 0.0,
        "start": {"second_compression": pressed},
        "model": {"arms": "always-free"},
        "simulation": {"duration": 0.02},
        **more,
    }  # fmt: skip


def test_an_arm_let_go_swings_as_its_hinge_says() -> None:
    """m ρ² φ̈ + c φ̇ + κ φ = 0 on a body that stays; the first joints stay free."""
    flight = fly(tables(0.01, simulation={"duration": 0.04}), executor="python")
    rate = DAMPING / (2.0 * MASS * RADIUS**2)
    omega = math.sqrt(STIFFNESS / (MASS * RADIUS**2) - rate**2)
    t = flight.t
    swung = -0.01 * np.exp(-rate * t) * (np.cos(omega * t) + rate / omega * np.sin(omega * t))
    assert flight.columns["bend1"][0] == -0.01
    for j in nonempty(range(1, 5)):
        assert np.abs(flight.columns[f"bend{j}"] - swung).max() < 3e-6
        assert np.abs(flight.columns[f"l{j}"] - 0.19).max() < 1e-9
    assert omega * t[-1] > 0.5 * math.pi
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6


def test_pressed_to_the_other_side_it_is_the_mirror_image() -> None:
    """In the plane of x and z: arms 1 and 2, and 3 and 4, change places, and sides."""
    one = fly(tables([0.01, -0.004, 0.002, 0.006], heavy=False), executor="python").columns
    other = fly(tables([0.004, -0.01, -0.006, -0.002], heavy=False), executor="python").columns
    for mine, theirs in ((1, 2), (2, 1), (3, 4), (4, 3)):
        assert one[f"bend{mine}"] == pytest.approx(-other[f"bend{theirs}"], abs=1e-12)
        assert one[f"l{mine}"] == pytest.approx(other[f"l{theirs}"], abs=1e-12)
    assert one["y"] == pytest.approx(-other["y"], abs=1e-12)
    assert np.abs(one["y"]).max() > 1e-6


def test_a_preload_holds_it_in_its_stop_from_where_it_is_pressed() -> None:
    second = {"preload": 0.1, "travel": [0.0, 0.6]}
    rest = fly(tables(0.0, second=second), executor="python").columns["bend1"][0]
    pressed = fly(tables(0.01, second=second), executor="python").columns["bend1"][0]
    assert rest > 0.0
    assert pressed == rest - 0.01


def test_in_a_batch_it_is_the_same_flight() -> None:
    """What differs is set up in one pass: each as alone, bit for bit."""
    cases = [tables(0.002 * k, simulation={"duration": 0.004}) for k in range(1, 6)]
    together = fly_scenarios(cases, threads=1).measures["arm_stroke"]
    alone = [fly(case, trajectory=False).measures["arm_stroke"] for case in cases]
    assert together.tolist() == alone
    assert len(set(alone)) == len(cases)


def message(given: dict[str, Any]) -> str:
    with pytest.raises(InputError) as caught:
        as_scenario(given)
    assert len(caught.value.problems) == 1
    return caught.value.problems[0]


def test_what_cannot_be_is_one_line() -> None:
    assert message(tables("90 mm")) == (
        "start.second_compression: of arm 1 must be within its travel, -0.078 to 0.078 m "
        "(got 0.09 m)"
    )
    assert "has 3 entries for 4 arms" in message(tables([0.01, 0.0, 0.0]))
    given = tables([0.0, 0.0, "1 mm", 0.0])
    given["vehicle"]["arms"]["compliant"] = [True, True, False, True]
    assert (
        "start.second_compression: of arm 3 must be within its travel, as it is rigid"
        in message(given)
    )
    plain = {"vehicle": "arq", "start": {"second_compression": [0, 0, 0, "1 mm"]}}
    assert message(plain) == (
        "start.second_compression: needs arms on two joints: a second one, "
        "vehicle.arms.joint.second (got 0.001 m)"
    )
    assert "wrong unit" in message(tables("3 deg"))
