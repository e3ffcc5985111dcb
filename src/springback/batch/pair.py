"""Two vehicles in one world: flights that can end in each other."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from springback.contact.cage import LANDED
from springback.contact.library import WALL
from springback.contact.parameters import SurfaceSettings
from springback.contact.scene.faces import SolidScene
from springback.contact.shapes import ShapeSettings
from springback.contact.surfaces import AnyExponent, Surface
from springback.contact.worlds import obstacles
from springback.dynamics.clearance import clearance
from springback.errors import InputError
from springback.kernels.routines import routines_compiled
from springback.results.columns import telemetry_columns, trajectory_columns, work_columns
from springback.results.flight import Flight, as_scenario, guided_result, ready_flight
from springback.scenario.build import ReadyFlight
from springback.scenario.scenario import Scenario
from springback.scenario.tables import UserShape
from springback.simulation.flight import FlightRecord
from springback.simulation.guided import GuidedFlown, ticks_of
from springback.simulation.measures import measures_of, outcome_of
from springback.simulation.noise import noise_table
from springback.simulation.pair.flying import PairedFlight, beside_each_other, fly_both

#: Contact of two cages: as one of them against a wall, twice in series (k^(−2/3) adds).
TWO_CAGES = WALL.model_copy(update={"stiffness": WALL.stiffness / 2.0**WALL.exponent})
#: What both scenarios must have in common.
COMMON = ("world", "clock", "simulation.duration")


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
    """Fly two vehicles in one world, each with its own pilot, sensors and noise, or without.

    Cages and hulls of both touch each other: those of the second are discs as thick as
    `springback.simulation.pair.parts.HEIGHT`, with round edges, and spheres.  Force and opposite
    force are equal to rounding.  Energy that one vehicle gives the other is ``work_driven``.

    Args:
        first: A `Scenario`, plain tables, or the path of a TOML file.
        second: Likewise; world, clock and duration must be the same.
        surface: Of the contact between both; by default that of two cages of the preset ``wall`` in
            series, with its friction.
        trajectory: Record trajectories.
        progress: Called from time to time with the simulated time [s].

    Returns:
        Both flights.

    Raises:
        InputError: If they cannot fly together, or start in each other; one line.
    """
    scenarios = as_scenario(first, ()), as_scenario(second, ())
    _check_common(*scenarios)
    sides = [
        _side(scenario, name) for scenario, name in zip(scenarios, ("first", "second"), strict=True)
    ]
    law = (TWO_CAGES if surface is None else surface).surface(AnyExponent, by_number=True)
    if law.restitution >= 0.0:
        raise InputError("surface.law: must not be impulse between two vehicles")
    if law.presliding > 0.0:
        raise InputError("surface.friction_law: must not be bristle between two vehicles")
    _check_apart(sides[0], sides[1], law)
    period = 1.0 / scenarios[0].clock
    results = fly_both(sides[0], sides[1], law, period=period, trace=trajectory, progress=progress)
    flights = [_flight_of(*both) for both in zip(scenarios, results, strict=True)]
    for flight in flights:
        for kind, sentence in flight.remarks.items():
            warnings.warn(f"{flight.scenario.name}: {sentence}", kind, stacklevel=2)
    return PairOfFlights(*flights)


def _check_common(first: Scenario, second: Scenario) -> None:
    """Reject two scenarios that differ in what both share."""
    for name in COMMON:
        one, other = first, second
        for key in name.split("."):
            one, other = getattr(one, key), getattr(other, key)
        if one != other:
            raise InputError(f"{name}: must be the same for both vehicles")
    for k, entry in enumerate(first.world.obstacles):
        if isinstance(entry, UserShape) or getattr(entry, "motion", None) is not None:
            raise InputError(
                f"world.obstacles[{k}]: cannot be combined with a second vehicle: it "
                + ("is a shape of your own" if isinstance(entry, UserShape) else "moves")
            )
        if isinstance(entry, ShapeSettings):
            laws = tuple(part.surface for part in entry.parts())
        else:
            laws = (entry.surface, getattr(entry, "backing", entry.surface))
        if any(law.law == "impulse" for law in laws):
            raise InputError(
                f"world.obstacles[{k}].surface.law: must not be impulse beside a second vehicle"
            )


def _check_apart(first: PairedFlight, second: PairedFlight, surface: Surface) -> None:
    """Reject a start in which a part of one vehicle is inside the other."""
    ours, _ = beside_each_other(first, second, surface)
    model, start = ours.model, ours.start
    with routines_compiled():
        gap = clearance(model.airframe, model.world, model.contact_point, start)
    if gap < -LANDED:
        raise InputError(
            f"second: start.position: puts a part of it {-gap:.3g} m inside the first vehicle "
            f"(got {list(second.start.position)} m)"
        )


def _side(scenario: Scenario, name: str) -> PairedFlight:
    """One vehicle, in the world as a scene."""
    if scenario.vehicle.hulls:
        raise InputError(
            f"{name}: vehicle.hulls: cannot be combined with a second vehicle: hulls besides cages "
            "and the sphere vehicle.hull do not touch it"
        )
    built = ready_flight(scenario)
    if built.plain is not None:
        raise InputError(f"{name}.pilot: must be compiled to fly beside another vehicle")
    if built.thrusts is not None:
        raise InputError(f"{name}.thrust: must be constant beside another vehicle, not a table")
    scene = obstacles(scenario.world.obstacles, as_scene=True)  # type: ignore[arg-type]  # checked
    assert isinstance(scene, SolidScene)
    model = built.model._replace(world=built.model.world._replace(obstacles=scene))
    return PairedFlight(model, built.start, *_avionics(built))


def _avionics(built: ReadyFlight) -> tuple[Any, Any]:
    if built.built_avionics is None:
        return None, None
    avionics, draws = built.built_avionics
    ticks = ticks_of(built.model.timing.until, avionics.systems.period)
    return avionics, noise_table(built.seed, 0, ticks, draws)


def _flight_of(scenario: Scenario, result: GuidedFlown | FlightRecord) -> Flight:
    flown = result.flown if isinstance(result, GuidedFlown) else result
    columns, units = trajectory_columns(flown)
    telemetry: dict[str, Any] = {}
    outcome, measures = outcome_of(flown.record), measures_of(flown)
    if isinstance(result, GuidedFlown):
        outcome, measures = guided_result(result)
        telemetry, more = telemetry_columns(result.telemetry, len(flown.start.arm_length))
        units = units | more
    return Flight(scenario, outcome, measures, columns, units, telemetry, work_columns(flown))
