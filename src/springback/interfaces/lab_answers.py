"""What the impact lab answers: flights as scenes with their energy ledger, measures, a sentence."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from springback.experiments.ledger import ledger
from springback.experiments.paper.printed import (
    RECOVERY_PITCH,
    SUCCESS,
    SUCCESS_WORDS,
    TABLE_III,
    Impact,
)
from springback.experiments.result import Flight, fly
from springback.interfaces.lab_scenarios import (
    NAMES,
    file_name,
    lab_scenario,
    robots_of,
)
from springback.interfaces.lab_settings import DEFAULTS, LabSettings, query_of, shown
from springback.interfaces.scene import Series, plain, scene_of
from springback.interfaces.scene_geometry import Drawable
from springback.simulation.measures import Outcome

#: Heading of the ledger among a scene's series; a series is held, or lost for good.
ENERGY = "Energy"
#: Parts of the ledger in the order in which they are stacked, and what the page calls them.
PARTS = {
    "energy_kinetic": "motion",
    "energy_springs": "arm springs",
    "energy_stops": "end stops",
    "energy_contact": "contact",
    "loss_arm": "lost in arms",
    "loss_contact": "lost in contact",
    "loss_friction": "lost in friction",
    "loss_stop": "lost in stops",
    "loss_settling": "lost in locking",
    "loss_air": "lost to air",
}
#: A part below this share of the largest is left out of the plot (chosen).
TOO_SMALL = 1e-4
EARTH = 9.81
#: Of the curves and the pose in time [s], chosen: arms take some 20 ms to spring back.
RESOLUTION = 2.5e-4
#: Instants of one flight at most, but for touches (chosen): a robot that leans on a wall steps finely.
MOST = 6000
#: Half a side of the piece of wall that is drawn of an impact [m], chosen.
PIECE = 0.5


Array = np.ndarray[Any, np.dtype[np.float64]]


#: Pitch [deg] and speed [m/s] of the collision of which largest pitches are printed, and these.
FASTEST = (0.0, 3.5)
PITCHES = dict(zip(("nose_up", "nose_down"), RECOVERY_PITCH, strict=True))


class Shown(NamedTuple):
    """A measure as the page shows it."""

    name: str
    label: str
    unit: str
    factor: float = 1.0  # of the unit
    printed: str = ""  # field of the printed numbers


#: Of an impact, and of a flight with what follows.
IMPACT = (
    Shown("touch_speed", "speed at touch", "m/s"),
    Shown("restitution_at_separation", "restitution", "", printed="restitution"),
    Shown("peak_acceleration", "peak acceleration", "m/s²", printed="peak_acceleration"),
    Shown("contact_time", "contact time", "ms", 1e3, "contact_time"),
    Shown("travel", "travel of the body", "mm", 1e3, "travel"),
    Shown("arm_stroke", "arm compression", "mm", 1e3),
    Shown("penetration", "depth of a cage", "mm", 1e3),
    Shown("peak_normal_force", "peak force on a cage", "N"),
)
FLIGHT = (
    Shown("touch_speed", "speed at touch", "m/s"),
    Shown("restitution_at_separation", "restitution", ""),
    Shown("peak_acceleration", "peak acceleration", "m/s²"),
    Shown("contact_time", "contact time", "ms", 1e3),
    Shown("arm_stroke", "arm compression", "mm", 1e3),
    Shown("detection_delay", "noticed after", "ms", 1e3),
    Shown("recovery_time", "at rest after", "s"),
    Shown("height_loss", "height lost", "mm", 1e3),
    Shown("nose_up", "largest pitch, nose up", "deg", math.degrees(1.0)),
    Shown("nose_down", "largest pitch, nose down", "deg", math.degrees(1.0)),
)


def answer(settings: LabSettings) -> dict[str, Any]:
    """Everything that the page shows of some settings, in plain data for JSON.

    Raises:
        InputError: If they cannot be flown; one line for each problem.
    """
    begun = time.perf_counter()
    flights = {robot: fly(lab_scenario(settings, robot)) for robot in robots_of(settings)}
    flown = time.perf_counter()
    told = [_told(settings, robot, flight) for robot, flight in flights.items()]
    return {
        "query": query_of(settings),
        "settings": settings.model_dump(),
        "flights": told,
        "measures": measure_rows(settings, flights),
        "printed_for": printed_for(settings),
        "took": {
            "flying": round(1e3 * (flown - begun), 2),
            "all": round(1e3 * (time.perf_counter() - begun), 2),
        },
    }


def _told(settings: LabSettings, robot: str, flight: Flight) -> dict[str, Any]:
    """One flight: its scene, with the curves of the lab in place of the scene's own."""
    coarse = coarsened(flight)
    scene = scene_of(coarse, label=NAMES[robot])
    books = ledger(flight.scenario)
    series = (*curves(coarse, scene.t), *energy_series(books, np.searchsorted(books["t"], scene.t)))
    return {
        "robot": robot,
        "label": NAMES[robot],
        "outcome": flight.outcome.word,
        "sentence": sentence(settings, robot, flight),
        "well": went_well(settings, flight),
        "file": file_name(settings, robot),
        "scene": plain(replace(scene, series=series, obstacles=_trimmed(settings, scene.obstacles))),
    }


def _trimmed(settings: LabSettings, things: tuple[Drawable, ...]) -> tuple[Drawable, ...]:
    """Of an impact only the piece of wall that robots meet is drawn, so that they are seen large."""
    if settings.mode != "impact":
        return things
    found = []
    for thing in things:
        halves = [np.array(half) for half in (thing.across, thing.along)]
        across, along = (half * min(1.0, PIECE / np.linalg.norm(half)) for half in halves)
        found.append(thing._replace(across=tuple(across.tolist()), along=tuple(along.tolist())))
    return tuple(found)


def coarsened(flight: Flight) -> Flight:
    """A flight with fewer instants: what a page shows, and what goes to it.

    Of all steps within `RESOLUTION`, or more where that leaves too many, one stays; and so do
    touches, separations and the peak.
    """
    c, m = flight.columns, flight.measures
    t = c["t"]
    keep, resolution = np.ones(len(t), dtype=bool), RESOLUTION
    while resolution == RESOLUTION or keep.sum() > MOST:
        bins = np.floor(t / resolution)
        keep[1:] = bins[1:] > bins[:-1]
        resolution *= 2.0
    touching = sum(c[name] for name in c if name.startswith("fn")) > 0.0
    changes = np.flatnonzero(touching[1:] != touching[:-1])
    keep[np.concatenate([changes, changes + 1, [len(t) - 1]])] = True
    for name in ("touch_time", "separation_time", "peak_acceleration_time"):
        if m[name] is not None:
            keep[min(int(np.searchsorted(t, m[name])), len(t) - 1)] = True
    return replace(flight, columns={name: values[keep] for name, values in c.items()})


def curves(flight: Flight, t: Array) -> Iterable[Series]:
    """One curve a panel for each robot, so that robots can be laid over one another."""
    places = np.searchsorted(flight.columns["t"], t)
    c = {name: values[places] for name, values in flight.columns.items()}
    arms = range(1, flight.scenario.vehicle.arm_count + 1)
    lengths = flight.scenario.vehicle.arms
    pressed = np.max([lengths.at("length", j - 1) - c[f"l{j}"] for j in arms], axis=0)
    pushed = np.sum([c[f"fn{j}"] for j in arms], axis=0)
    felt = np.sqrt(c["ax"] ** 2 + c["ay"] ** 2 + c["az"] ** 2)
    yield Series("Acceleration", "main body", "m/s²", felt)
    yield Series("Arm compression", "most pressed arm", "mm", 1e3 * pressed)
    yield Series("Velocity", "along X", "m/s", c["vx"])
    yield Series("Contact force", "all cages", "N", pushed)


def energy_series(books: dict[str, Any], places: Any) -> Iterable[Series]:
    """The ledger as series: parts that matter, in the order in which they are stacked.

    What rotors and height give is neither held nor lost but put in: the sum of all parts.
    """
    most = max(float(np.max(np.abs(books[name]))) for name in PARTS)
    for name, words in PARTS.items():
        if float(np.max(np.abs(books[name]))) > TOO_SMALL * most:
            yield Series(ENERGY, words, "J", books[name][places])


# -- measures, beside print -----------------------------------------------------------------------


def measure_rows(settings: LabSettings, flights: dict[str, Flight]) -> list[dict[str, Any]]:
    """Measures by name, unit and robot, with what the paper prints for them."""
    rows = []
    for one in FLIGHT if settings.mode == "flight" else IMPACT:
        values = {robot: _scaled(f.measures.get(one.name), one) for robot, f in flights.items()}
        if all(value is None for value in values.values()):
            continue
        printed = {robot: _printed(settings, robot, one) for robot in flights}
        rows.append(
            {"name": one.name, "label": one.label, "unit": one.unit, "values": values,
             "printed": {robot: word for robot, word in printed.items() if word}}
        )  # fmt: skip
    if settings.mode == "flight":
        words = {robot: printed_success(settings, robot) for robot in flights}
        if any(words.values()):
            outcomes = {robot: f.outcome.word.replace("_", " ") for robot, f in flights.items()}
            rows.insert(
                0, {"name": "outcome", "label": "outcome", "unit": "", "values": outcomes,
                    "printed": {robot: word for robot, word in words.items() if word}},
            )  # fmt: skip
    return rows


def _scaled(value: float | None, one: Shown) -> float | None:
    return None if value is None else one.factor * value


def _printed(settings: LabSettings, robot: str, one: Shown) -> str:
    """A number of Table III as the page shows it: simulated, and tested where that was printed."""
    if (robot, settings.mode, settings.pitch, settings.speed) == ("arq", "flight", *FASTEST):
        return f"{PITCHES[one.name]:.3g}" if one.name in PITCHES else ""
    row: Impact | None = TABLE_III.get((robot, settings.surface))
    if row is None or not one.printed or settings.mode != "impact":
        return ""
    tested = getattr(row, f"{one.printed}_test", None)
    words = f"{one.factor * getattr(row, one.printed):.3g}"
    return words if tested is None else f"{words} ({one.factor * tested:.3g})"


def printed_for(settings: LabSettings) -> dict[str, Any]:
    """For which settings the printed numbers hold, and whether these are they."""
    if settings.mode == "flight":
        return {
            "words": "Paper, section Impact Resilience: share of trials recovered; pitch of a recovery.",
            "same": _is_default(settings, "yaw", "surface", "recovery", *_ARMS),
        }
    words = f"Paper, Table III: simulation (test), slider, {shown(DEFAULTS.speed)} m/s, straight."
    same = _is_default(settings, "guide", "speed", "pitch", "yaw", *_ARMS)
    return {"words": words if settings.surface != "own" else "", "same": same}


_ARMS = ("stiffness", "damping", "arm_mass")


def _is_default(settings: LabSettings, *names: str) -> bool:
    return all(getattr(settings, name) == getattr(DEFAULTS, name) for name in names)


def printed_success(settings: LabSettings, robot: str) -> str:
    """What the paper says of the recovery from such a collision, in a word; empty if nothing."""
    key = robot, settings.pitch, settings.speed
    if key in SUCCESS:
        return f"{SUCCESS[key]:.0%} recovered"
    return SUCCESS_WORDS.get(key, "")


# -- in a sentence --------------------------------------------------------------------------------


def went_well(settings: LabSettings, flight: Flight) -> bool:
    """Whether the robot left the wall as it should: recovered, with a pilot who answers."""
    if settings.mode == "flight":
        return flight.outcome is Outcome.RECOVERED
    return flight.outcome is Outcome.SEPARATED


def sentence(settings: LabSettings, robot: str, flight: Flight) -> str:
    """What happened to a robot, in one or two sentences."""
    name, m = NAMES[robot], flight.measures
    if m["touch_speed"] is None:
        return f"{name} touches nothing."
    what = "mat" if settings.surface == "mat" else "wall"
    words = f"{name} meets the {what} at {m['touch_speed']:.2f} m/s"
    again, lasted = m["restitution_at_separation"], m["contact_time"]
    if again is not None and lasted is not None:
        left = again * m["touch_speed"]
        words += f", leaves it at {left:.2f} m/s after {1e3 * lasted:.0f} ms"
    peak = m["peak_acceleration"] or 0.0
    words += f", feels {peak:.0f} m/s² ({peak / EARTH:.0f} g)"
    return f"{words}; {_ending(settings, flight)}."


def _ending(settings: LabSettings, flight: Flight) -> str:
    """How it ends."""
    m, out = flight.measures, flight.outcome
    if settings.mode == "flight" and out is Outcome.RECOVERED:
        rest, lost = m["recovery_time"] or 0.0, m["height_loss"] or 0.0
        return f"recovers, at rest after {rest:.2f} s, {1e3 * lost:.0f} mm lower"
    if out is Outcome.SEPARATED:
        stroke = m["arm_stroke"] or 0.0
        return f"its arms give way by {1e3 * stroke:.1f} mm" if stroke > 0.0 else "no arm gives way"
    if out is Outcome.IN_CONTACT:
        return f"still touches when the time is up, at {m['end_time'] or 0.0:.3g} s"
    return flight.message
