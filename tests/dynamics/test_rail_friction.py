"""Dry friction of a slider's rail: distances in closed form, its heat, and what it holds."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

import springback
from builders.cases import nonempty
from springback.batch.sampled import sampled_flights
from springback.errors import InputError
from springback.identification.observations.drop_start import fall_of
from springback.results.flight import Flight, fly
from springback.scenario.scenario import scenario_from

QUAD = springback.VEHICLES["quad"].vehicle
MASS, G, SLIP_SPEED = QUAD.mass, 9.81, 0.03
MU = 0.12
FRICTION = MU * MASS * G


def thrown(speed: float, duration: float = 1.0, **model: Any) -> dict[str, Any]:
    """A carriage thrown along a level rail, far from anything to hit: of the structure of `impact`."""
    return {
        "vehicle": "quad",
        "world": {"obstacles": [{"type": "wall", "distance": 50.0, "surface": "wall"}]},
        "start": {"position": [0.0, 0.0, 1.0], "velocity": [speed, 0.0, 0.0]},
        "model": {"slider": [1.0, 0.0, 0.0], "slider_friction": FRICTION, **model},
        "simulation": {"duration": duration},
    }


def impact(vehicle: str = "arq-slider", **model: Any) -> dict[str, Any]:
    """A slider test: 1.85 m/s at a wall, and back."""
    return {
        "vehicle": vehicle,
        "world": {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]},
        "start": {"position": [0.55, 0.0, 1.0], "velocity": [1.85, 0.0, 0.0]},
        "model": {"slider": [1.0, 0.0, 0.0], "slider_friction": 4.0, **model},
        "simulation": {"duration": 0.5},
    }


def way(speed: float, slip_speed: float = SLIP_SPEED) -> float:
    """Way to rest of m v dv/dx = −F v/√(v² + v_s²): (m/F) ∫ √(v² + v_s²) dv [m]."""
    root = np.hypot(speed, slip_speed)
    of_regularised = speed * root + slip_speed**2 * np.arcsinh(speed / slip_speed)
    return float(0.5 * MASS / FRICTION * of_regularised)


def residual(flight: Flight) -> float:
    return abs(flight.measures["ledger_residual"] or 0.0)


@pytest.mark.parametrize("speed", [1.0, -0.6])
def test_a_carriage_stops_after_the_way_of_coulombs_law(speed: float) -> None:
    flight = fly(thrown(speed, 1.4))
    c = flight.columns
    assert np.sign(speed) * c["x"][-1] == pytest.approx(way(abs(speed)), rel=1e-6)
    assert np.sign(speed) * c["x"][-1] == pytest.approx(speed**2 / (2.0 * MU * G), rel=0.02)
    assert abs(c["vx"][-1]) < 1e-2 * abs(speed)
    lost = 0.5 * MASS * (speed**2 - c["vx"][-1] ** 2)
    assert flight.measures["loss_friction"] == pytest.approx(lost, rel=1e-6)
    assert residual(flight) < 1e-6


def test_it_slows_at_a_constant_rate_and_the_accelerometer_feels_it() -> None:
    flight = fly(thrown(2.0, 0.3))
    felt = flight.specific_force()
    assert felt[:, 0] == pytest.approx(-MU * G, rel=2e-3)
    assert felt[:, 2] == pytest.approx(G, rel=1e-12)
    assert flight.columns["vx"][-1] == pytest.approx(2.0 - 0.3 * MU * G, rel=1e-3)


def test_a_slope_holds_what_is_not_too_steep() -> None:
    """It creeps where F v/√(v² + v_s²) = m g sin α, far below the slip speed; else it slides."""
    for slope, slides in ((0.05, False), (0.3, True)):
        axis = [np.cos(slope), 0.0, -np.sin(slope)]
        tables = thrown(0.0, 0.8, slider=axis)
        flight = fly(tables)
        along = flight.columns["vx"][-1] / axis[0]
        push = np.sin(slope) / MU
        if slides:
            rate = G * (np.sin(slope) - MU)
            assert along == pytest.approx(rate * 0.8, rel=0.05)
        else:
            assert along == pytest.approx(SLIP_SPEED * push / np.sqrt(1.0 - push**2), rel=1e-3)
        assert residual(flight) < 1e-6


@pytest.mark.parametrize("arms", ["hybrid", "always-free"])
@pytest.mark.parametrize("vehicle", ["arq-slider", "quad-slider"])
def test_ledgers_of_impacts_close(vehicle: str, arms: str) -> None:
    flight = fly(impact(vehicle, arms=arms))
    assert flight.measures["contacts"] == 1.0
    assert residual(flight) < 1e-6
    without = fly(impact(vehicle, arms=arms, slider_friction=0.0))
    assert flight.columns["vx"].min() > without.columns["vx"].min() + 0.05


def test_lanes_fly_it_as_alone() -> None:
    """Also beside flights without any, which are of another kind."""
    tables = [impact(slider_friction=f) for f in (0.0, 1.0, 4.0, 2.0)]
    at = np.linspace(0.0, 0.45, 10)
    found = sampled_flights([copy.deepcopy(one) for one in tables], at)
    for k, one in nonempty(enumerate(tables)):
        alone = fly(one)
        x = np.interp(at, alone.columns["t"], alone.columns["vx"])
        assert found.of("velocity.x")[k, :, 0] == pytest.approx(x, abs=2e-3), k
    ends = found.of("velocity.x")[:, -1, 0]
    assert len(set(ends.tolist())) == 4
    one = sampled_flights([copy.deepcopy(tables[2])], at)
    assert one.values[0].tobytes() == found.values[2].tobytes()


def test_without_it_a_slider_has_no_rail() -> None:
    assert scenario_from(impact(slider_friction=0.0)).flight_model().guide.rail == ()
    [rail] = scenario_from(impact()).flight_model().guide.rail
    assert rail.friction == 4.0


def test_a_drop_along_a_rail_is_slower() -> None:
    tables = {
        "vehicle": "quad", "thrust": 0.0,
        "world": {"obstacles": [{"type": "ground", "surface": "wall"}]},
        "start": {"position": [0.0, 0.0, 1.0], "pitch": 0.3},
        "model": {"slider": [0.0, 0.0, 1.0], "slider_friction": FRICTION},
    }  # fmt: skip
    fall, free = (
        fall_of(scenario_from(tables | {"model": tables["model"] | {"slider_friction": f}}))
        for f in (FRICTION, 0.0)
    )
    assert fall.speed == pytest.approx(free.speed * np.sqrt(1.0 - MU), rel=1e-6)
    flown = fly(tables | {"simulation": {"duration": 0.9 * fall.duration}})
    assert flown.columns["vz"][-1] == pytest.approx(-0.9 * fall.speed, rel=2e-3)
    held = tables | {"model": tables["model"] | {"slider_friction": 1.01 * MASS * G}}
    with pytest.raises(InputError, match=r"^model\.slider_friction: holds the vehicle"):
        fall_of(scenario_from(held))


@pytest.mark.parametrize(
    ("model", "said"),
    [
        ({"slider_friction": "1 N"}, "model.slider_friction: needs a slider"),
        ({"slider": [1, 0, 0], "slider_friction": "-1 N"}, "model.slider_friction: must be at least 0"),
        ({"slider": [1, 0, 0], "slider_friction": "1 kg"}, "model.slider_friction: "),
        ({"slider": [1, 0, 0], "slider_slip_speed": 0.0}, "model.slider_slip_speed: must be "),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(model: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError) as error:
        scenario_from({"vehicle": "quad", "model": model})
    [line] = error.value.problems
    assert line.startswith(said)
