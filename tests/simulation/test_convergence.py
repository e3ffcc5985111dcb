"""Steps: results converge, at the order the contact law allows, and the default step is fine enough.

The whole study is studies/convergence.py.
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from builders.impacts import towards_wall
from springback.results.flight import Flight, fly
from springback.scenario.tables import SimulationSettings

COMPARED = ("restitution_at_separation", "peak_acceleration", "contact_time", "travel")


def slider(vehicle: str) -> dict[str, Any]:
    """A slider test of the paper on the wall."""
    wall = {"preset": "wall", "friction_axes": "vertical"}
    return {
        "vehicle": vehicle,
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": wall}]},
        "start": {"position": [0.6, 0.0, 0.0], "velocity": [1.85, 0.0, 0.0]},
        "model": {"contact_point": "paper", "slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": 0.3},
    }


def oblique(vehicle: str, speed: float) -> dict[str, Any]:
    """A tilted impact on one arm, with friction along both tangents."""
    return towards_wall(vehicle, speed, position=[0.6, 0.0, 0.0], yaw="30 deg", pitch="15 deg")


CASES = {
    "Quad on the slider": slider("quad-slider"),
    "ARQ on the slider": slider("arq-slider"),
    "ARQ, oblique": oblique("arq", 2.0),
    "Quad, oblique and fast": oblique("quad", 6.0),
}
cases = pytest.mark.parametrize("scenario", CASES.values(), ids=CASES.keys())


def at_step(scenario: dict[str, Any], step: float) -> Flight:
    """A case flown with some impact step."""
    return fly(scenario, f"simulation.impact_step={step!r}", trajectory=False)


@cases
def test_the_default_step_is_within_a_thousandth(scenario: dict[str, Any]) -> None:
    """Against a step sixteen times finer, for COR, peak acceleration, contact time and travel."""
    step = SimulationSettings().impact_step
    default, fine = fly(scenario, trajectory=False), at_step(scenario, step / 16.0)
    for name in COMPARED:
        assert default.measures[name] == pytest.approx(fine.measures[name], rel=1e-3)


@pytest.mark.filterwarnings("ignore::springback.errors.LedgerWarning")  # of the coarsest step
@cases
def test_errors_fall_with_the_step(scenario: dict[str, Any]) -> None:
    """Restitution at every halving of the step is nearer the finest, until rounding is reached."""
    finest = at_step(scenario, 6.25e-6).measures["restitution_at_separation"]
    errors = []
    for step in (8e-4, 1e-4, 2.5e-5):
        found = at_step(scenario, step).measures["restitution_at_separation"]
        assert found is not None
        assert finest is not None
        errors.append(abs(found / finest - 1.0))
    assert errors[1] < max(0.2 * errors[0], 1e-6)
    assert errors[2] < max(0.5 * errors[1], 1e-7)


def test_order_is_that_of_the_contact_law() -> None:
    """Runge-Kutta has order 4 where the force is smooth; at first touch it goes as δ^1.5.

    One step across such a corner errs by h^2.5, and that is what is left of the order.
    """
    scenario = CASES["Quad on the slider"]
    steps = (4e-4, 2e-4, 1e-4)
    values = [at_step(scenario, step).measures["restitution_at_separation"] for step in steps]
    coarse, middle, fine = (value or math.nan for value in values)
    observed = math.log2(abs((coarse - middle) / (middle - fine)))
    assert 2.2 < observed < 3.5


def test_the_ledger_closes_at_the_default_step() -> None:
    """To 1e-6 of the kinetic energy before, for every case."""
    for scenario in CASES.values():
        residual = fly(scenario, trajectory=False).measures["ledger_residual"]
        assert residual is not None
        assert abs(residual) < 1e-6


def test_slip_speed_is_a_regularisation() -> None:
    """Friction that fades at ever lower slip has a limit; the default is within 2 % of it."""
    word = "world.obstacles[0].surface.slip_speed"
    scenario = CASES["ARQ, oblique"]

    def at_slip(speed: float) -> Flight:
        return fly(scenario, f"{word}={speed!r}", trajectory=False)

    usual, slow, limit = fly(scenario, trajectory=False), at_slip(0.01), at_slip(0.003)
    for name in COMPARED:
        sizes = [flight.measures[name] or math.nan for flight in (usual, slow, limit)]
        assert sizes[0] == pytest.approx(sizes[2], rel=2e-2)
        assert abs(sizes[1] / sizes[2] - 1.0) < 0.5 * abs(sizes[0] / sizes[2] - 1.0)
