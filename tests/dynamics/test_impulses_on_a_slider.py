"""The impulse law on a slider: the rail takes what acts across it, and all moments."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.results.flight import Flight, fly

RESTITUTION, SPEED, SLOPE = 0.4, 2.0, "60 deg"


def hit(friction: float, **vehicle: Any) -> Flight:
    """A vehicle on a slider along x, into a face that leans back by 30 degrees."""
    surface = {"law": "impulse", "restitution": RESTITUTION, "friction": friction}
    face = {"type": "slope", "position": [2.5, 0.0, 0.5], "angle": SLOPE, "surface": surface}
    tables = {
        "vehicle": {"preset": "quad", **vehicle},
        "world": {"obstacles": [face]},
        "start": {"position": [1.6, 0.0, 1.0], "velocity": [SPEED, 0.0, 0.0], "yaw": 0.1,
                  "touch_distance": 3e-4},
        "model": {"slider": [1.0, 0.0, 0.0]},
        "simulation": {"duration": 2e-3},
    }  # fmt: skip
    return fly(tables, executor="python")


HULL = {"hulls": [{"type": "sphere", "radius": 0.05, "position": [0.25, 0.1, 0.03]}]}


@pytest.mark.parametrize("vehicle", [{}, HULL], ids=["cages", "hull"])
@pytest.mark.parametrize("friction", [0.0, 0.8])
def test_it_stays_on_the_slider_and_its_ledger_closes(
    friction: float, vehicle: dict[str, Any]
) -> None:
    """No velocity across, no spin; what is lost is booked to rounding."""
    flight = hit(friction, **vehicle)
    c = flight.columns
    assert flight.measures["contacts"] == 1.0
    for name in ("vy", "vz", "wx", "wy", "wz"):
        assert np.abs(c[name]).max() == 0.0, name
    assert c["vx"][-1] < 0.0
    assert abs(flight.measures["ledger_residual"] or 0.0) < 1e-12


@pytest.mark.parametrize("vehicle", [{}, HULL], ids=["cages", "hull"])
def test_without_friction_it_rebounds_as_a_mass_point(vehicle: dict[str, Any]) -> None:
    """v' = −e v, wherever the contact is; m (v − v') is what the face gives along the slider."""
    flight = hit(0.0, **vehicle)
    assert flight.columns["vx"][-1] == pytest.approx(-RESTITUTION * SPEED, rel=1e-9)
    gained = flight.scenario.vehicle.mass * (1.0 + RESTITUTION) * SPEED
    assert flight.measures["impulse_x"] == pytest.approx(-gained, rel=1e-9)
    lean = flight.measures["impulse_z"] / flight.measures["impulse_x"]  # type: ignore[operator]
    assert lean == pytest.approx(-np.tan(np.pi / 6.0), rel=1e-9)
