"""Responses of the impact lab: scenes of flights, energy balances, measures and a sentence."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np

from springback.interfaces.lab.measures import measure_rows, printed_for, sentence, went_well
from springback.interfaces.lab.obstacles import SHAPES, obstacle_of
from springback.interfaces.lab.scenarios import (
    file_name,
    is_piloted,
    lab_scenario,
    robots_of,
)
from springback.interfaces.lab.settings import LabSettings, query_of
from springback.interfaces.lab.vehicles import robot_name
from springback.interfaces.replay.geometry import Drawable
from springback.interfaces.replay.labels import in_one_world
from springback.interfaces.replay.scene import Scene, Series, plain, scene_beside, scene_of
from springback.results.energy_history import ledger
from springback.results.flight import Flight, fly

#: Panel of the energy balance among a scene's series, whose parts are stored or lost.
ENERGY = "Energy"
#: Parts of the energy balance in stacking order, with their labels on the page.  Obstacles have
#: what they hold beyond the least that they had, and those that are driven take what they are done.
PARTS = {
    "energy_kinetic": "motion",
    "energy_springs": "arm springs",
    "energy_stops": "end stops",
    "energy_contact": "contact",
    "energy_obstacles": "moving obstacles",
    "loss_arm": "lost in arms",
    "loss_contact": "lost in contact",
    "loss_friction": "lost in friction",
    "loss_stop": "lost in stops",
    "loss_settling": "lost in locking",
    "loss_air": "lost to air",
    "loss_obstacles": "lost in obstacles",
    "taken": "to driven obstacles",
}
#: Lines over the stack where obstacles move: what was put in, which the stack sums to, and what
#: driven obstacles gave of it.
PUT_IN = {"put_in": "put in", "given": "by driven obstacles"}
#: Names of a balance in a world of two robots, each of which drives the other.
OF_TWO = {"taken": "to the other robot", "given": "by the other robot"}
#: Parts below this fraction of the largest are not plotted (chosen).
TOO_SMALL = 1e-4
#: Time resolution of curves and pose [s] (chosen: arms take some 20 ms to spring back).
RESOLUTION = 2.5e-4
#: Most instants of a flight besides touches (chosen): a robot leaning on a wall takes small steps.
MOST = 6000
#: Half the side of the piece of wall drawn for an impact [m] (chosen).
PIECE = 0.5


Array = np.ndarray[Any, np.dtype[np.float64]]
Columns = Mapping[str, Array]


def answer(settings: LabSettings) -> dict[str, Any]:
    """Everything that the page shows for some settings, as plain data for JSON.

    Raises:
        InputError: If they cannot be flown; one line for each problem.
    """
    begun, robots = time.perf_counter(), robots_of(settings)
    with ThreadPoolExecutor(len(robots)) as pool:  # compiled flights release the interpreter lock
        flown_all = pool.map(lambda robot: fly(lab_scenario(settings, robot)), robots)
        flights = dict(zip(robots, flown_all, strict=True))
    flown = time.perf_counter()
    scenes = [
        _flight_response(settings, robot, flight, world)
        for world, (robot, flight) in enumerate(flights.items())
    ]
    return {
        "query": query_of(settings),
        "settings": settings.model_dump(),
        "flights": scenes,
        "is_piloted": is_piloted(settings),
        "measures": measure_rows(settings, flights),
        "printed_for": printed_for(settings),
        "took": {
            "flying": round(1e3 * (flown - begun), 2),
            "all": round(1e3 * (time.perf_counter() - begun), 2),
        },
    }


def _flight_response(
    settings: LabSettings, robot: str, flight: Flight, world: int
) -> dict[str, Any]:
    """A flight as its scene, with that of a second vehicle, and with the curves of the lab."""
    coarse, label = coarse_flight(flight), robot_name(settings, robot)
    drawn = [(flight, coarse, scene_of(coarse, label=label))]
    if flight.second is not None and coarse.second is not None:
        name = flight.second.scenario.name
        drawn.append((flight.second, coarse.second, scene_beside(coarse, label=name)))
    scenes = in_one_world([_lab_scene(settings, *one) for one in drawn])
    shown = [plain(replace(scene, world=world)) for scene in scenes]
    return {
        "robot": robot,
        "label": label,
        "outcome": flight.outcome.word,
        "sentence": sentence(settings, robot, flight),
        "well": went_well(settings, flight),
        "file": file_name(settings, robot),
        "scene": shown[0],
        "second": shown[1] if len(shown) > 1 else None,
    }


def _lab_scene(settings: LabSettings, flight: Flight, coarse: Flight, scene: Scene) -> Scene:
    """A scene with the curves of the lab in place of its own."""
    energies, paired = ledger(flight), flight.is_second or flight.second is not None
    series = (
        *curves(coarse, scene),
        *energy_series(energies, np.searchsorted(energies["t"], scene.t), OF_TWO if paired else {}),
    )
    return replace(scene, series=series, obstacles=_nearby(settings, scene.obstacles))


def _nearby(settings: LabSettings, things: tuple[Drawable, ...]) -> tuple[Drawable, ...]:
    """Obstacles near the contact: for an impact only a piece of wall, to show robots large.

    What the page has another name for than the scenario, like a door, is called by that.
    """
    chosen = obstacle_of(settings)
    shape = SHAPES.get(chosen)
    things = tuple(one._replace(name=chosen) if one.name == shape else one for one in things)
    if settings.mode != "impact":
        return things
    found = []
    for thing in things:
        if not thing.normal:
            found.append(thing)
            continue
        halves = [np.array(half) for half in (thing.across, thing.along)]
        across, along = (half * min(1.0, PIECE / np.linalg.norm(half)) for half in halves)
        found.append(thing._replace(across=tuple(across.tolist()), along=tuple(along.tolist())))
    return tuple(found)


def coarse_flight(flight: Flight) -> Flight:
    """A flight with fewer instants, for transfer to a page; those of two vehicles are the same.

    One step per `RESOLUTION`, or fewer if that leaves too many, is kept, together with touches,
    separations and the peak.
    """
    t, second = flight.columns["t"], flight.second
    keep, resolution = np.ones(len(t), dtype=bool), RESOLUTION
    while resolution == RESOLUTION or keep.sum() > MOST:
        bins = np.floor(t / resolution)
        keep[1:] = bins[1:] > bins[:-1]
        resolution *= 2.0
    for one in (flight, second):
        if one is not None:
            keep[_turning_points(one)] = True

    def thinned(one: Flight) -> Flight:
        return replace(one, columns={name: values[keep] for name, values in one.columns.items()})

    coarse = replace(thinned(flight), second=None)
    return replace(
        coarse, second=None if second is None else replace(thinned(second), first=coarse)
    )


def _turning_points(flight: Flight) -> Any:
    """Rows of touches, separations, the peak and the end."""
    c, m, t = flight.columns, flight.measures, flight.columns["t"]
    touching = np.sum([c[name] for name in c if name.startswith("fn")], axis=0) > 0.0
    changes = np.flatnonzero(touching[1:] != touching[:-1])
    whens = [m[n] for n in ("touch_time", "separation_time", "impact_peak_acceleration_time")]
    rows = [min(int(np.searchsorted(t, when)), len(t) - 1) for when in whens if when is not None]
    return np.concatenate([changes, changes + 1, rows, [len(t) - 1]]).astype(np.intp)


def curves(flight: Flight, scene: Scene) -> Iterable[Series]:
    """One curve per panel for each robot, so that robots can be overlaid.

    Args:
        flight: Any.
        scene: Its scene; the contact force is the vector sum of the forces drawn on its cages.
    """
    places = np.searchsorted(flight.columns["t"], scene.t)
    c = {name: values[places] for name, values in flight.columns.items()}
    arms = range(1, flight.scenario.vehicle.arm_count + 1)
    lengths = flight.scenario.vehicle.arms
    pressed = np.max([lengths.at("length", j - 1) - c[f"l{j}"] for j in arms], axis=0)
    for j in arms:
        pressed = np.maximum(pressed, np.abs(c.get(f"bend{j}", 0.0)))
    pushed = np.linalg.norm(scene.force.sum(axis=1), axis=1)
    felt = np.sqrt(c["ax"] ** 2 + c["ay"] ** 2 + c["az"] ** 2)
    yield Series("Acceleration", "main body", "m/s²", felt)
    yield Series("Arm compression", "most compressed arm", "mm", 1e3 * pressed)
    yield Series("Velocity", "along X", "m/s", c["vx"])
    yield Series("Contact force", "sum of all contacts", "N", pushed)


def energy_series(
    energies: Columns, places: Any, called: Mapping[str, str] = MappingProxyType({})
) -> Iterable[Series]:
    """The energy balance as series: its significant parts, in stacking order.

    What rotors, height and driven obstacles put in is no part of its own: it is the sum of all.
    Where obstacles move it is a line besides, from the other side of the ledger (`PUT_IN`).

    Args:
        energies: A ledger.
        places: Rows that are shown.
        called: Names of some parts in place of those of `PARTS` and `PUT_IN`.
    """
    parts, put_in = balance(energies)
    most = max(float(np.max(np.abs(values))) for values in parts.values())
    for name, words in PARTS.items():
        if float(np.max(np.abs(parts[name]))) > TOO_SMALL * most:
            yield Series(ENERGY, called.get(name, words), "J", parts[name][places])
    moved = (energies[name] for name in ("energy_obstacles", "loss_obstacles", "work_driven"))
    if not any(float(np.max(np.abs(values))) > TOO_SMALL * most for values in moved):
        return
    for name, words in PUT_IN.items():
        if float(np.max(np.abs(put_in[name]))) > TOO_SMALL * most:
            yield Series(ENERGY, called.get(name, words), "J", put_in[name][places])


def balance(energies: Columns) -> tuple[Columns, Columns]:
    """Parts of the balance by the names of `PARTS`, and what was put in by those of `PUT_IN` [J].

    The parts sum to ``put_in``: what there was at the start, with what obstacles lose at most, the
    work of rotors, loss of height, and what driven obstacles gave.
    """
    e, driven = energies, energies["work_driven"]
    least = min(0.0, float(np.min(e["energy_obstacles"])))
    given, taken = np.maximum(driven, 0.0), np.maximum(-driven, 0.0)
    own = {name: e[name] for name in PARTS if name != "taken"}
    parts = own | {"energy_obstacles": e["energy_obstacles"] - least, "taken": taken}
    begun = sum(float(values[0]) for values in parts.values())
    work = e["work_thrust"] - e["work_thrust"][0]
    height = e["energy_gravity"] - e["energy_gravity"][0]
    return parts, {"put_in": begun + work - height + given, "given": given}
