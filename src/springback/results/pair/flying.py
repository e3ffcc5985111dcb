"""Two vehicles of a scenario, flown together."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

from springback.contact.library import WALL
from springback.contact.moving.hulls import with_hulls
from springback.contact.scene.faces import SolidScene
from springback.contact.surfaces import AnyExponent
from springback.contact.worlds import obstacles
from springback.errors import InputError
from springback.scenario.build import ReadyFlight
from springback.scenario.model import RING_ROUNDING
from springback.scenario.scenario import Scenario
from springback.scenario.tables import SecondVehicle
from springback.scenario.worlds.imported import single_obstacles
from springback.simulation.flight import FlightRecord
from springback.simulation.guided import GuidedFlown, ticks_of
from springback.simulation.measuring.record import Model
from springback.simulation.noise import noise_table
from springback.simulation.pair.flying import PairedFlight, fly_both
from springback.simulation.pair.solids import solids_of
from springback.vehicle.parameters import Vehicle

Flown = GuidedFlown | FlightRecord

#: Contact of two cages: as one of them against a wall, twice in series (k^(−2/3) adds).
TWO_CAGES = WALL.model_copy(update={"stiffness": WALL.stiffness / 2.0**WALL.exponent})


def fly_beside(
    scenario: Scenario,
    first: ReadyFlight,
    second: ReadyFlight,
    *,
    trace: bool = True,
    progress: Callable[[float], None] | None = None,
) -> tuple[Flown, Flown]:
    """Fly two vehicles together.

    Args:
        scenario: Of both.
        first: Flight of the first one.
        second: That of the second.
        trace: Record trajectories and telemetry.
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If a pilot is not compiled.
    """
    one, other = (_side(scenario, *each) for each in (("", first), ("second.", second)))
    period = 1.0 / scenario.clock
    return fly_both(
        one, other, law_between(scenario), period=period, trace=trace,
        interval=scenario.simulation.record_interval, progress=progress,
    )  # fmt: skip


@contextlib.contextmanager
def of_second() -> Iterator[None]:
    """Name the second vehicle in problems of its own tables, which are told as of a first one."""
    try:
        yield
    except InputError as error:
        raise InputError(*map(_of_second, error.problems)) from error.__cause__


def _of_second(line: str) -> str:
    """A problem, named by its path in the scenario of both if it is of a table of its own."""
    table = line.partition(":")[0].partition(".")[0]
    return f"second.{line}" if table in SecondVehicle.model_fields else line


def law_between(scenario: Scenario) -> Any:
    """Law of the contact between both vehicles."""
    given = None if scenario.second is None else scenario.second.surface
    return (TWO_CAGES if given is None else given).surface(AnyExponent, in_scene=True)


def _side(scenario: Scenario, path: str, built: ReadyFlight) -> PairedFlight:
    if built.plain is not None:
        raise InputError(f"{path}pilot: must be compiled to fly beside another vehicle")
    vehicle = (scenario.beside() if path else scenario).vehicle
    model = in_a_scene(scenario, vehicle, built.model)
    return PairedFlight(model, built.start, *_avionics(built), solids_of(vehicle))


def in_a_scene(scenario: Scenario, vehicle: Vehicle, model: Model) -> Model:
    """A model whose world is a scene, whatever is in it, that all hulls of a vehicle can meet."""
    given = single_obstacles(scenario.world.obstacles)
    remember = any(hull.remembers for hull in vehicle.hulls)
    scene = obstacles(given, as_scene=True, hull_memory=remember)
    assert isinstance(scene, SolidScene)
    if vehicle.hulls:
        scene = with_hulls(scene, RING_ROUNDING)
    return model._replace(world=model.world._replace(obstacles=scene))


def _avionics(built: ReadyFlight) -> tuple[Any, Any]:
    if built.built_avionics is None:
        return None, None
    avionics, draws = built.built_avionics
    ticks = ticks_of(built.model.timing.until, avionics.systems.period)
    return avionics, noise_table(built.seed, 0, ticks, draws)
