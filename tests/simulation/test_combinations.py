"""Whatever the settings accept flies: law x contact point x friction x arms x guide x pilot x hull."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import pairwise_combinations
from springback.batch.scenarios import fly_scenarios
from springback.results.flight import fly
from springback.simulation.measuring.measures import Outcome

LAWS: dict[str, dict[str, Any]] = {
    "hunt-crossley": {"law": "hunt-crossley", "dissipation": 0.3},
    "hertz": {"law": "hertz", "exponent": 2.0, "stiffness": 1e7},
    "kelvin-voigt": {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 50.0},
    "impulse": {"law": "impulse", "restitution": 0.4},
    "softening": {"law": "hunt-crossley", "stiffness": 2e3, "exponent": 0.54, "dissipation": 0.3},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.4},
    "foam": {
        "law": "foam",
        "stiffness": 1e5,
        "plateau_force": "40 N",
        "densification_depth": "8 mm",
        "restitution": 0.3,
        "viscosity": "5 N s/m",
    },
    "table": {
        "law": "table",
        "loading": [[0, 0], ["1 mm", "80 N"], ["10 mm", "300 N"]],
        "unloading": [["0.5 mm", 0], ["10 mm", "300 N"]],
        "recovers": False,
    },
}
ARMS = {
    "hybrid": ({}, "hybrid"),
    "always-free": ({}, "always-free"),
    "rigid": ({"arms": {"compliant": False}}, "hybrid"),
}
#: Who touches: the cages alone, or, of a robot that flies belly first, its main body.
PARTS = ("cages", "hull")
CHOICES = (LAWS, ("ring", "paper"), ("both", "vertical"), ARMS, ("free", "slider", "pilot"), PARTS)
COMBINATIONS = pairwise_combinations(CHOICES)


def scenario(
    law: str, point: str, axes: str, arms: str, guide: str, part: str, duration: float
) -> dict[str, Any]:
    """A hair in front of a wall, at 2 m/s."""
    vehicle, model = ARMS[arms]
    front = 0.2445 if point == "ring" else 0.2125  # of the foremost cages, and 0.3 to 0.4 mm of air
    front = 0.0603 if part == "hull" else front
    surface = {**LAWS[law], "friction": 0.8, "friction_axes": axes}
    tables: dict[str, Any] = {
        "vehicle": {"preset": "arq", "hull": part == "hull" and {"radius": 0.06}, **vehicle},
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": surface}]},
        "start": {"position": [1.0 - front, 0.0, 1.0], "velocity": [2.0, 0.0, 0.0]},
        "model": {"contact_point": point, "arms": model},
        "simulation": {"duration": duration},
    }
    if part == "hull":
        tables["start"]["pitch"] = "90 deg"
    if guide == "slider":
        tables["model"]["slider"] = [1.0, 0.0, 0.0]
    elif guide == "pilot":
        tables["reference"] = {"type": "hold"}
    return tables


def test_every_pair_of_choices_is_flown() -> None:
    assert 24 <= len(COMBINATIONS) <= 40


@pytest.mark.parametrize("combination", COMBINATIONS, ids="-".join)
def test_every_combination_flies(combination: tuple[str, ...]) -> None:
    """In plain Python: it touches, ends at its time, and its ledger closes."""
    flight = fly(scenario(*combination, 0.002), executor="python", trajectory=False)
    m = flight.measures
    assert flight.outcome in (Outcome.SEPARATED, Outcome.IN_CONTACT)
    assert m["end_time"] == pytest.approx(0.002)
    assert m["touch_speed"] == pytest.approx(2.0, rel=0.02)
    assert abs(m["ledger_residual"] or 0.0) < 1e-5
    assert m["body_contacts"] == (1.0 if combination[5] == "hull" else None)


@pytest.mark.parametrize(
    "combination",
    [
        ("impulse", "ring", "both", "hybrid", "free", "cages"),
        ("impulse", "paper", "vertical", "always-free", "slider", "hull"),
        ("impulse", "ring", "both", "hybrid", "pilot", "hull"),
        ("kelvin-voigt", "paper", "vertical", "rigid", "free", "hull"),
        ("hertz", "ring", "vertical", "always-free", "free", "cages"),
        ("hunt-crossley", "ring", "both", "hybrid", "pilot", "hull"),
        ("softening", "ring", "vertical", "hybrid", "free", "cages"),
        ("constant-restitution", "ring", "both", "hybrid", "pilot", "hull"),
        ("foam", "paper", "vertical", "always-free", "free", "cages"),
        ("table", "ring", "both", "rigid", "slider", "hull"),
    ],
    ids="-".join,
)
def test_compiled_and_in_a_campaigns_lanes_it_is_the_same_flight(
    combination: tuple[str, ...],
) -> None:
    """Bit for bit what plain Python flies: every law, and either value of everything else."""
    tables = scenario(*combination, 0.002)  # type: ignore[arg-type]
    plain = fly(tables, executor="python", trajectory=False).measures
    assert fly(tables, trajectory=False).measures == plain
    together = fly_scenarios([tables] * 3, threads=1)
    for name, value in plain.items():
        column = np.asarray(together.measures[name])
        assert all(np.isnan(column)) if value is None else all(column == value), name


def rough(chance: np.random.Generator, restitution: float) -> dict[str, Any]:
    """A vehicle of any attitude and spin that falls into the corner of a wall and the ground."""
    surface = {"law": "impulse", "restitution": restitution, "friction": chance.uniform(0.0, 0.8)}
    ground = {"type": "ground", "height": -0.3, "surface": surface}
    return {
        "vehicle": ("arq", "quad")[chance.integers(2)],
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": surface}, ground]},
        "start": {
            "position": [0.55, 0.0, 0.3],
            "velocity": [chance.uniform(0.5, 5.0), *chance.uniform(-1.0, 1.0, 2)],
            "roll": chance.uniform(-0.4, 0.4), "pitch": chance.uniform(-1.0, 1.0),
            "yaw": chance.uniform(-3.0, 3.0),
            "angular_velocity": list(chance.normal(0.0, 3.0, 3)),
        },
        "simulation": {"duration": 0.5},
    }  # fmt: skip


def test_impulses_end_whatever_the_restitution() -> None:
    """Flights that come to rest on impulses end, and none gains energy.

    A third of such flights, nearly all of restitution 0, stood still for ever: an impulse that left
    a cage closing in by rounding was given again and again at one instant.
    """
    chance = np.random.default_rng(3)
    for k in range(24):
        restitution = (0.0, 0.1, float(chance.uniform(0.0, 1.0)), 1.0)[k % 4]
        m = fly(rough(chance, restitution), trajectory=False).measures
        assert m["end_time"] == pytest.approx(0.5)
        assert abs(m["ledger_residual"] or 0.0) < 1e-6
        # A cage that has landed a micrometre too deep is put back, against its weight.
        assert (m["loss_contact"] or 0.0) > -1e-5 * (m["energy_start"] or 0.0)
