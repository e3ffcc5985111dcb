"""Arms on one joint or two, latched and tied to each other, with whatever they can meet, pairwise."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from builders.cases import pairwise_combinations
from springback.batch.scenarios import fly_scenarios
from springback.results.flight import as_scenario, fly
from springback.simulation.measuring.measures import Outcome

JOINTS: dict[str, dict[str, Any] | None] = {
    "planar": None,
    "radial": {"type": "slide", "travel": [0, "40 mm"], "stiffness": "5 N/mm", "damping": 20},
    "leg": {
        "type": "slide", "direction": [-0.5, 0.2, 1], "travel": ["-5 mm", "40 mm"],
        "table": [[0, 0], ["5 mm", "20 N"], ["40 mm", "90 N"]], "play": "0.1 mm",
    },
    "preloaded": {
        "type": "slide", "travel": [0, "40 mm"], "stiffness": "3 N/mm", "preload": "5 N",
        "one_sided": True, "damping": 10,
    },
    "folding": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 1],
        "travel": ["-60 deg", "60 deg"], "stiffness": "5 N m/rad", "damping": "0.02 N m s/rad",
    },
    "flapping": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0],
        "travel": ["-30 deg", "60 deg"], "quadratic": "20 N m/rad^2", "rotors": "body",
        "damping": "0.02 N m s/rad",
    },
    "odd": {
        "type": "hinge", "position": ["60 mm", "10 mm", "10 mm"], "axis": [0.3, 0.5, 0.8],
        "travel": ["-40 deg", "60 deg"], "stiffness": [3, 4, 5, 6],
        "damping": "0.02 N m s/rad",
    },
    "latched": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 1], "damping": 0.05,
        "travel": [0, "60 deg"], "stiffness": "2 N m/rad",
        "latch": {"torque": "1.5 N m", "travel": "1 deg"},
    },
    "universal": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 1], "damping": 0.02,
        "travel": ["-60 deg", "60 deg"], "stiffness": [4, 5, 6, 7],
        "second": {
            "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0], "damping": 0.01,
            "travel": ["-0.5 deg", "40 deg"], "stiffness": "4 N m/rad", "play": "0.1 deg",
        },
    },
    "apart": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0], "damping": 0.02,
        "travel": ["-30 deg", "60 deg"], "quadratic": "20 N m/rad^2", "rotors": "body",
        "second": {
            "type": "hinge", "position": ["90 mm", "5 mm", 0], "axis": [0.2, 0.1, 1],
            "travel": [0, "50 deg"], "stiffness": "3 N m/rad", "damping": 0.02,
            "latch": {"torque": "0.8 N m", "travel": "1 deg"},
        },
    },
    "hinge on a slide": {
        "type": "slide", "travel": [0, "40 mm"], "stiffness": "5 N/mm", "damping": 10,
        "preload": "4 N",
        "second": {
            "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 1, 0], "damping": 0.02,
            "travel": ["-40 deg", "40 deg"], "table": [[0, 0], ["5 deg", 0.5], ["40 deg", 6]],
        },
    },
    "slide on a hinge": {
        "type": "hinge", "position": ["60 mm", 0, 0], "axis": [0, 0, 1], "damping": 0.02,
        "travel": ["-60 deg", "60 deg"], "stiffness": "5 N m/rad",
        "second": {
            "type": "slide", "travel": [0, "1 mm"], "stiffness": "4 N/mm", "one_sided": True,
            "preload": "3 N", "damping": 10,
        },
    },
}  # fmt: skip
LAWS: dict[str, dict[str, Any]] = {
    "hunt-crossley": {"law": "hunt-crossley", "dissipation": 0.3},
    "kelvin-voigt": {"law": "kelvin-voigt", "stiffness": 2e4, "viscosity": 20.0},
    "impulse": {"law": "impulse", "restitution": 0.4},
    "constant-restitution": {"law": "constant-restitution", "restitution": 0.4},
    "bristle": {"law": "hunt-crossley", "dissipation": 0.3, "friction_law": "bristle"},
}
MODES = ("hybrid", "always-free")
GUIDES = ("free", "slider", "pilot")
PARTS = ("cages", "hulls")
OBSTACLES = ("wall", "pole")
NEIGHBOURS = ("alone", "springs")
CHOICES = (JOINTS, LAWS, MODES, GUIDES, PARTS, OBSTACLES, NEIGHBOURS)


def scenario(
    joint: str,
    law: str,
    mode: str,
    guide: str,
    part: str,
    obstacle: str,
    neighbours: str,
    duration: float,
) -> dict[str, Any]:
    """A hair in front of an obstacle, at 2 m/s, pitched and rolled."""
    surface = {**LAWS[law], "friction": 0.8}
    solid: dict[str, Any] = {"type": "wall", "distance": 1.0, "surface": surface}
    if obstacle == "pole":
        solid = {"type": "pole", "position": [1.1, 0.05, 1], "radius": 0.1, "surface": surface}
    arms: dict[str, Any] = {
        "directions": ["45 deg", "135 deg", "225 deg", "315 deg"],
        "length": 0.19, "mass": 0.05, "cage_radius": 0.11, "torque_ratio": 0.012,
    }  # fmt: skip
    if JOINTS[joint] is not None:
        arms |= {"height": [0.0, 0.02, 0.0, 0.02], "joint": JOINTS[joint]}
    if neighbours == "springs":
        arms["neighbours"] = {"stiffness": "3 N/mm", "damping": 4}
    vehicle: dict[str, Any] = {
        "name": "own", "arms": arms, "body": {"mass": 1.0, "inertia": [8e-3, 9e-3, 16e-3]},
        "propulsion": {"max_thrust": 7.0},
    }  # fmt: skip
    if part == "hulls":
        arms["cages"] = False
        balls = [{"type": "sphere", "on": j, "radius": 0.1} for j in (1, 2, 3, 4)]
        vehicle["hulls"] = [*balls, {"type": "sphere", "radius": 0.05}]
    tables: dict[str, Any] = {
        "vehicle": vehicle,
        "world": {"obstacles": [solid]},
        "start": {
            "position": [0.0, 0.0, 1.0], "velocity": [2.0, 0.1, 0.0], "pitch": 0.2, "roll": 0.1,
            "touch_distance": 1e-5,
        },
        "model": {"arms": mode},
        "simulation": {"duration": duration},
    }  # fmt: skip
    if guide == "slider":
        tables["model"]["slider"] = [1.0, 0.0, 0.0]
        tables["start"]["velocity"] = [2.0, 0.0, 0.0]
    elif guide == "pilot":
        # No pilot begins by a distance to the touch: it begins where a flight without one does.
        placed = as_scenario(tables, (), False).build().start.position
        tables["start"] |= {"position": [*placed], "touch_distance": None}
        tables["reference"] = {"type": "hold"}
    return tables


COMBINATIONS = pairwise_combinations(CHOICES)


def test_every_pair_of_choices_is_flown() -> None:
    assert 50 <= len(COMBINATIONS) <= 80


@pytest.mark.parametrize("combination", COMBINATIONS, ids="-".join)
def test_every_combination_flies(combination: tuple[str, ...]) -> None:
    """In plain Python: it ends at its time, and its ledger closes."""
    flight = fly(scenario(*combination, 0.0015), executor="python", trajectory=False)
    m = flight.measures
    assert flight.outcome in (Outcome.SEPARATED, Outcome.IN_CONTACT)
    assert m["end_time"] == pytest.approx(0.0015)
    assert abs(m["ledger_residual"] or 0.0) < 2e-6


@pytest.mark.parametrize(
    "combination",
    [
        ("folding", "hunt-crossley", "hybrid", "free", "cages", "wall", "alone"),
        ("preloaded", "hunt-crossley", "always-free", "free", "cages", "wall", "alone"),
        ("latched", "hunt-crossley", "hybrid", "free", "cages", "wall", "springs"),
        ("planar", "hunt-crossley", "hybrid", "free", "cages", "wall", "springs"),
        ("universal", "hunt-crossley", "hybrid", "pilot", "cages", "wall", "springs"),
    ],
    ids="-".join,
)
def test_compiled_and_in_a_campaigns_lanes_it_is_the_same_flight(
    combination: tuple[str, ...],
) -> None:
    """Bit for bit what plain Python flies."""
    tables = scenario(*combination, 0.003)
    plain = fly(tables, executor="python", trajectory=False).measures
    assert fly(tables, trajectory=False).measures == plain
    together = fly_scenarios([tables] * 9, threads=1)
    for name, value in plain.items():
        column = np.asarray(together.measures[name])
        assert all(np.isnan(column)) if value is None else all(column == value), name


def test_the_stroke_of_an_arm_counts_to_either_side() -> None:
    """An arm that is let go beyond its free length swings; its stroke is the larger way."""
    tables = scenario(
        "flapping", "hunt-crossley", "always-free", "free", "cages", "wall", "alone", 0.004
    )
    tables["world"]["obstacles"][0]["distance"] = 9.0
    del tables["start"]["touch_distance"]
    tables["start"]["compression"] = [-0.02, 0.01, 0.01, 0.01]
    flight = fly(tables, executor="python")
    ways = [np.abs(0.19 - flight.columns[f"l{j}"]).max() for j in (1, 2, 3, 4)]
    assert flight.measures["arm_stroke"] == pytest.approx(max(ways), rel=1e-12)
    assert max(ways) == pytest.approx(0.02)
    assert flight.columns["l1"][0] == pytest.approx(0.21)
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-6
