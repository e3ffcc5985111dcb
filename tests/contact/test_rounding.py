"""What the rounding of flat rings does: sizes of the effect, as docs/story/contact.md tells them."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import pytest

from springback.contact.cage import Ring
from springback.scenario.model import RING_ROUNDING, flight_model
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import FlightRecord, fly_one

PAGE = Path(__file__).parents[2] / "docs" / "story" / "contact.md"
#: Nearly none [rad]: a ring that lies flat would touch at no point in particular.
SHARP = 1e-4
RADIUS = 0.11


def flat_hit(tilt: float, rounding: float) -> FlightRecord:
    """Quad without a hull, at 2 m/s into a wall that its rotor plane leans from by an angle [deg]."""
    wall = {"type": "wall", "distance": 1.0, "surface": "wall"}
    tables: dict[str, Any] = {
        "vehicle": {"preset": "quad", "hull": False},
        "world": {"gravity": 0.0, "obstacles": [wall]},
        "start": {"position": [0.72, 0, 1], "velocity": [2, 0, 0], "pitch": f"{90 - tilt} deg"},
        "thrust": [0.0, 0.0, 0.0, 0.0],
        "simulation": {"duration": 0.25},
    }
    scenario = scenario_from(tables)
    model = flight_model(scenario)._replace(contact_point=Ring(rounding))
    return fly_one(model, scenario.start_state(), trace=False)


def told() -> list[list[float]]:
    """The table of the page: tilt, earlier by, and pairs of numbers with and without rounding."""
    text = PAGE.read_text(encoding="utf-8").split("(ring-rounding)=")[1]
    rows = re.findall(r"^\| (\d[^|]*)\|([^|]*)\|([^|]*)\|([^|]*)\|$", text, re.M)
    return [[float(x) for cell in row for x in re.findall(r"[\d.]+", cell)] for row in rows]


def test_the_page_has_its_table() -> None:
    """Seven tilts, from a quarter of a degree to upright."""
    assert [row[0] for row in told()] == [0.25, 1.0, 2.0, 5.0, 10.0, 30.0, 90.0]


@pytest.mark.parametrize("row", told(), ids=lambda row: f"{row[0]:g} deg")
def test_what_the_page_says_of_rounding_is_measured(row: list[float]) -> None:
    """Touch earlier by r₀ (√(sin² + ε²) − sin); peak and rebound as printed."""
    tilt, earlier, *numbers = row
    rounded, sharp = flat_hit(tilt, RING_ROUNDING), flat_hit(tilt, SHARP)
    sine = math.sin(math.radians(tilt))
    gained = 2.0 * (sharp.record.first_impact.touch_time - rounded.record.first_impact.touch_time)
    reach = [math.hypot(sine, eps) - sine for eps in (RING_ROUNDING, SHARP)]
    assert gained == pytest.approx(RADIUS * (reach[0] - reach[1]), abs=1e-9)
    assert 1e6 * gained == pytest.approx(earlier, abs=0.06)
    measured = [
        *(one.record.impact_peaks.acceleration for one in (rounded, sharp)),
        *(-one.motion.state.velocity.x for one in (rounded, sharp)),
    ]
    for printed, number, digit in zip(numbers, measured, (1.0, 1.0, 0.001, 0.001), strict=True):
        assert printed == pytest.approx(number, abs=0.5001 * digit)


def test_it_does_not_matter_away_from_flat() -> None:
    """From 30° on the peak is the sharp ring's to 1e-4, at a few degrees it is not to 1e-2."""

    def off(tilt: float) -> float:
        a, b = (
            flat_hit(tilt, eps).record.impact_peaks.acceleration for eps in (RING_ROUNDING, SHARP)
        )
        return abs(a / b - 1.0)

    assert off(30.0) < 1e-4
    assert off(90.0) < 1e-5
    assert off(1.0) > 1e-2
