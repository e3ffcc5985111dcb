"""Flights collected and laid into buffers, alone or in groups: the same as laid one by one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from springback.dynamics.gusts import NoGusts
from springback.kernels.layout import structure
from springback.kernels.trees import leaves
from springback.kernels.vectors import Vec
from springback.scenario.avionics import build_avionics
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import flight_buffers, shape_of
from springback.simulation.guided import avionics_buffers
from springback.simulation.loading import Loader
from springback.simulation.measuring.record import Model
from springback.simulation.onboard import Avionics
from springback.vehicle.state import State

Flight = tuple[Model, State, Avionics]


def flight(**tables: Any) -> Flight:
    given = {"vehicle": "arq", "reference": {"type": "hold"}, "recovery": {}}
    scenario = scenario_from(given | tables)
    model, start = scenario.flight_model(), scenario.start_state()
    return model, start, build_avionics(scenario, model, start).avionics


def mixed() -> list[Flight]:
    """Flights of one kind that differ in many ways, and in none."""
    wall = {"type": "wall", "distance": 3.0, "surface": "wall"}
    first = flight(world={"obstacles": [wall]})
    model, start, avionics = first
    pressed = start._replace(arm_length=(0.18, *start.arm_length[1:]))
    return [
        first,
        first,
        flight(world={"obstacles": [wall | {"distance": 2.0}]}, seed=3),
        (model, pressed, avionics),
        flight(world={"obstacles": [wall]}, start={"position": [0.2, 0, 1], "yaw": 0.1}),
        flight(world={"obstacles": [wall]}, control={"stiffness": 7.0}, model_error={"mass": 1.1}),
        (model, start._replace(velocity=Vec(-0.0, 0.0, 0.0)), avionics),
        flight(world={"obstacles": [wall]}, vehicle={"preset": "arq", "arms": {"stiffness": 3e3}}),
        first,
    ]


def differing(columns: list[list[float]]) -> tuple[list[int], Any]:
    """Leaves in which flights differ from the first, and their values."""
    values = np.array(columns)
    places = np.flatnonzero((values.view(np.int64) != values[:1].view(np.int64)).any(axis=0))
    return places.tolist(), values[:, places]


@pytest.mark.parametrize("width", [1, 4, 8])
@pytest.mark.parametrize("in_groups", [False, True])
def test_collected_flights_are_laid_as_by_themselves(width: int, in_groups: bool) -> None:
    """Also flights of two robots, and several that differ from one in a few leaves."""
    wall = {"type": "wall", "distance": 3.0, "surface": "wall"}
    other = flight(vehicle="quad", world={"obstacles": [wall]})
    flights = [*mixed(), other, *mixed()]
    models, starts, avionics_list = (list(column) for column in zip(*flights, strict=True))
    loader = Loader(*flights[0], width)
    if in_groups:
        flown = differing([leaves((model, start)) for model, start, _ in flights[:3]])
        loader.add(*flights[0], flown, differing([leaves(one) for *_, one in flights[:3]]))
    for one in flights[loader.count :]:
        loader.add(*one)
    laid = loader.flights()
    shape = shape_of(models[0], starts[0])
    wanted, onboard = (
        flight_buffers(shape, models, starts, width),
        avionics_buffers(avionics_list, width),
    )
    assert laid.onboard is not None
    # By their bits: −0 is not 0 here.
    np.testing.assert_array_equal(laid.buffers.view(np.int64), wanted.view(np.int64))
    np.testing.assert_array_equal(laid.onboard.view(np.int64), onboard.view(np.int64))


def test_flights_without_pilots_are_laid_too() -> None:
    flights = [(model, start) for model, start, _ in mixed()]
    loader = Loader(*flights[0], None, 8)
    for model, start in flights:
        loader.add(model, start, None)
    laid, (models, starts) = loader.flights(), zip(*flights, strict=True)
    assert laid.onboard is None
    np.testing.assert_array_equal(laid.buffers, flight_buffers(laid.shape, models, starts, 8))


def test_flights_of_another_kind_have_another_structure() -> None:
    """By one type, somewhere, or by a count; a batch has one."""
    first, gusty = (
        flight(),
        flight(air={"wind": [1, 0, 0], "body_drag": 0.02, "gusts": {"wind_at_6_m": 5}}),
    )
    model, start, avionics = first
    assert isinstance(avionics.systems.weather, NoGusts)
    arms = model.airframe._replace(arms=model.airframe.arms[:3])
    others: list[tuple[Any, Any, Any]] = [
        gusty,
        (model, start, gusty[2]),
        (model, start, None),
        (
            model,
            start,
            avionics._replace(onboard=avionics.onboard._replace(weather=gusty[2].onboard.weather)),
        ),
        (model, start, flight(recovery={"response": {"way": "staged"}})[2]),
        (model._replace(airframe=arms), start, avionics),
    ]
    for other in others:
        assert structure(other) != structure(first)
    assert structure(flight(start={"position": [0.0, 0.0, 2.0]})) == structure(first)
