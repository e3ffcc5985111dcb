"""The vehicles of two scenarios in one world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from springback.contact.parameters import SurfaceSettings
from springback.results.flight import Flight, as_scenario, fly
from springback.scenario.scenario import Scenario


class PairOfFlights(NamedTuple):
    """Flights of two vehicles in one world."""

    first: Flight
    second: Flight


def fly_pair(
    first: Scenario | Mapping[str, Any] | str | Path,
    second: Scenario | Mapping[str, Any] | str | Path,
    *,
    surface: SurfaceSettings | None = None,
    trajectory: bool = True,
    progress: Callable[[float], None] | None = None,
) -> PairOfFlights:
    """Fly the vehicles of two scenarios in one world, each with its own pilot, or without.

    It is `fly` of the first scenario with the second vehicle as its ``second``.  Cages and hulls of
    both touch each other: those of the second are discs as thick as
    `springback.simulation.pair.solids.HEIGHT`, with round edges, and spheres.  Force and opposite
    force are equal to rounding.  Energy that one vehicle gives the other is ``work_driven``.

    Args:
        first: A `Scenario`, plain tables, or the path of a TOML file.
        second: Likewise; world, clock and steps must be the same.
        surface: Surface of the contact between the two; by default that of two cages of the preset
            ``wall`` in series, with its friction.
        trajectory: Record trajectories.
        progress: Called from time to time with the simulated time [s].

    Returns:
        Both flights.

    Raises:
        InputError: If they cannot fly together, or start in each other; one line.
    """
    both = as_scenario(first, ()).with_second(as_scenario(second, ()), surface)
    flight = fly(both, trajectory=trajectory, progress=progress)
    assert flight.second is not None
    return PairOfFlights(flight, flight.second)
