"""Guided flights that several tests fly, as the loop over the ticks wants them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.kernels.layout import Buffer, rows
from springback.kernels.trees import leaves, rebuilt
from springback.scenario.avionics import build_avionics, turn_on_normals
from springback.scenario.scenario import scenario_from
from springback.simulation.flight import flight_buffers, flight_records, shape_of
from springback.simulation.guided import (
    GuidedFlight,
    GuidedFlown,
    avionics_buffers,
    ticks_of,
)
from springback.simulation.guided_batch import fly_groups
from springback.simulation.noise import FlightNoise, noise_table
from springback.simulation.onboard import Draw
from springback.simulation.ticks import FlightBuffers

HOLD = {"type": "hold", "position": (0.2, 0.1, 1.1)}
WALL = {"obstacles": [{"type": "wall", "distance": 1.0, "surface": "wall"}]}
#: A little before the wall, on the way to it.
AT_WALL = {"position": (0.69, 0.0, 1.0), "velocity": (2.0, 0.1, 0.0), "pitch": 0.1}
GUSTY = {
    "wind": (2.0, 1.0, 0.0),
    "rotor_drag": (0.3, 0.3, 0.1),
    "gusts": {"wind_at_6_m": 6.0, "altitude": 10.0},
}


class Ready(NamedTuple):
    """Arguments of `fly_guided`."""

    flight: GuidedFlight
    noise: Buffer


class Lane(NamedTuple):
    """A flight for `fly_in_lanes`, and the same for `fly_guided`."""

    alone: Ready
    draws: tuple[Draw, ...]
    seed: int
    flight: int


def tables(duration: float, estimator: str = "perfect", **others: Any) -> dict[str, Any]:
    """A guided flight as plain tables."""
    return {
        "vehicle": "arq",
        "reference": HOLD,
        "estimator": {"type": estimator},
        "simulation": {"duration": duration},
    } | others


def ready(given: Mapping[str, Any], flight: int = 0) -> Ready:
    """A flight of a campaign, made ready."""
    return lane(given, flight).alone


def lane(given: Mapping[str, Any], flight: int = 0) -> Lane:
    """A flight of a campaign, made ready to fly in company."""
    scenario = scenario_from(given)
    model, start = scenario.flight_model(), scenario.start_state()
    biases = turn_on_normals([scenario.seed], flight)[0]
    built_avionics = build_avionics(scenario, model, start, biases=biases)
    ticks = ticks_of(model.timing.until, built_avionics.avionics.systems.period)
    noise = noise_table(scenario.seed, flight, ticks, built_avionics.noise)
    return Lane(
        Ready(GuidedFlight(model, start, built_avionics.avionics), noise),
        built_avionics.noise,
        scenario.seed,
        flight,
    )


def fly_in_lanes(flights: Sequence[Lane], **options: int) -> list[GuidedFlown]:
    """Flights of equal shape and duration in lanes of groups.

    Args:
        flights: Of one kind.
        **options: Of `fly_groups`; ``width``, the lanes of a group.
    """
    width = options.pop("width")
    alone, draws, seeds, numbers = (list(part) for part in zip(*flights, strict=True))
    models, starts, avionics_list = zip(*(one.flight for one in alone), strict=True)
    shape, avionics = shape_of(models[0], starts[0]), avionics_list[0]
    buffers = flight_buffers(shape, models, starts, width)
    onboard = avionics_buffers(avionics_list, width)
    together = FlightBuffers(buffers, onboard, (0,) * width)
    noise = FlightNoise(draws[0], seeds, numbers)
    fly_groups(alone[0].flight, together, noise, **options)
    after = rows(avionics.systems)
    memories = onboard.reshape(len(buffers), -1, width)
    return [
        GuidedFlown(one, rebuilt(avionics.onboard, memories[k // width, after:, k % width]), None)
        for k, one in enumerate(flight_records(shape, models, starts, buffers, width))
    ]


def same(a: GuidedFlown, b: GuidedFlown) -> bool:
    """Equality, bit for bit, of motion, record and on-board systems."""
    trees = [
        (a.flown.motion, b.flown.motion),
        (a.flown.record, b.flown.record),
        (a.onboard, b.onboard),
    ]
    return all(np.array_equal(leaves(one), leaves(other)) for one, other in trees)
