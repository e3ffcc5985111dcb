"""Results shown by the impact lab: measures beside the printed numbers, and a sentence."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, NamedTuple

from springback.contact.parameters import Mat
from springback.interfaces.lab.obstacles import WORDS, obstacle_of
from springback.interfaces.lab.scenarios import is_piloted
from springback.interfaces.lab.settings import (
    DEFAULTS,
    VEHICLE_SETTINGS,
    LabSettings,
    digits,
    is_default,
)
from springback.interfaces.lab.vehicles import robot_name
from springback.paper.printed import (
    RECOVERY_PITCH,
    SUCCESS,
    SUCCESS_WORDS,
    TABLE_III,
    PrintedImpact,
)
from springback.results.contacts.places import contact_places
from springback.results.contacts.restitution import restitution_note
from springback.results.contacts.spans import contact_spans
from springback.results.flight import Flight
from springback.simulation.measuring.measures import Outcome

#: Standard value of g, for accelerations in multiples of it [m/s²].
EARTH = 9.81
#: Pitch [deg] and speed [m/s] of the collision whose largest pitches are printed, and these [deg].
FASTEST = (0.0, 3.5)
PITCHES = dict(zip(("nose_up", "nose_down"), RECOVERY_PITCH, strict=True))


#: Article of an obstacle's word.
_ARTICLE = re.compile("^(an?|the) ")


class Measure(NamedTuple):
    """A measure in the unit of the page."""

    name: str
    label: str
    unit: str
    factor: float = 1.0  # from SI to the unit
    printed: str = ""  # field of the printed numbers

    def read(self, measures: Mapping[str, float | None]) -> float | None:
        """Value in the unit of the page; None if it is undefined."""
        value = measures.get(self.name)
        return None if value is None else self.factor * value


#: Measures of an impact, and of a flight with recovery.
IMPACT = (
    Measure("touch_speed", "speed at touch", "m/s"),
    Measure("restitution_at_separation", "restitution", "", printed="restitution"),
    Measure("impact_peak_acceleration", "peak acceleration", "m/s²", printed="peak_acceleration"),
    Measure("contact_time", "contact time", "ms", 1e3, "contact_time"),
    Measure("travel", "travel of the body", "mm", 1e3, "travel"),
    Measure("impact_arm_stroke", "arm compression", "mm", 1e3),
    Measure("impact_penetration", "depth of a cage", "mm", 1e3),
    Measure("impact_peak_normal_force", "peak force on a cage", "N"),
)
FLIGHT = (
    Measure("touch_speed", "speed at touch", "m/s"),
    Measure("restitution_at_separation", "restitution", ""),
    Measure("impact_peak_acceleration", "peak acceleration", "m/s²"),
    Measure("contact_time", "contact time", "ms", 1e3),
    Measure("impact_arm_stroke", "arm compression", "mm", 1e3),
    Measure("detection_delay", "detected after", "ms", 1e3),
    Measure("recovery_time", "at rest after", "s"),
    Measure("height_loss", "height loss", "mm", 1e3),
    Measure("nose_up", "largest pitch, nose up", "deg", math.degrees(1.0)),
    Measure("nose_down", "largest pitch, nose down", "deg", math.degrees(1.0)),
)


def measure_rows(settings: LabSettings, flights: dict[str, Flight]) -> list[dict[str, Any]]:
    """Measures by name, unit and robot, with the paper's printed values."""
    rows = []
    for one in FLIGHT if is_piloted(settings) else IMPACT:
        values = {robot: one.read(f.measures) for robot, f in flights.items()}
        if all(value is None for value in values.values()):
            continue
        printed = {robot: _printed_text(settings, robot, one) for robot in flights}
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


def _printed_text(settings: LabSettings, robot: str, one: Measure) -> str:
    """Number of Table III as shown: simulated, and in brackets the tested one where printed."""
    if obstacle_of(settings) != "wall":
        return ""
    if (robot, settings.mode, settings.pitch, settings.speed) == ("arq", "flight", *FASTEST):
        return f"{PITCHES[one.name]:.3g}" if one.name in PITCHES else ""
    row: PrintedImpact | None = TABLE_III.get((robot, settings.surface))  # none of the file's
    if row is None or not one.printed or settings.mode != "impact":
        return ""
    tested = getattr(row, f"{one.printed}_test", None)
    words = f"{one.factor * getattr(row, one.printed):.3g}"
    return words if tested is None else f"{words} ({one.factor * tested:.3g})"


def printed_for(settings: LabSettings) -> dict[str, Any]:
    """Settings for which the printed numbers hold (``words``), and if these are they (``same``)."""
    if obstacle_of(settings) != "wall":
        return {"words": "", "same": False}
    if settings.mode == "flight":
        return {
            "words": "Paper, section Impact Resilience: trials recovered; pitch of a recovery.",
            "same": _is_papers(settings, "yaw", "surface", "recovery"),
        }
    words = f"Paper, Table III: simulation (test), slider, {digits(DEFAULTS.speed)} m/s, straight."
    same = _is_papers(settings, "guide", "speed", "pitch", "yaw")
    return {"words": words if settings.surface in ("wall", "mat") else "", "same": same}


def _is_papers(settings: LabSettings, *names: str) -> bool:
    """True if some settings are the paper's, and ARQ and Quad are."""
    ours = settings.user is not None or is_default(settings, *VEHICLE_SETTINGS)
    return ours and all(getattr(settings, name) == getattr(DEFAULTS, name) for name in names)


def printed_success(settings: LabSettings, robot: str) -> str:
    """Success of such a collision as the paper prints it; empty if it prints nothing."""
    key = robot, settings.pitch, settings.speed
    if obstacle_of(settings) != "wall":
        return ""
    if key in SUCCESS:
        return f"{SUCCESS[key]:.0%} recovered"
    return SUCCESS_WORDS.get(key, "")


# -- in a sentence --------------------------------------------------------------------------------


def went_well(settings: LabSettings, flight: Flight) -> bool:
    """True if the robot left what it hit as it should: recovered, if it has a pilot of the lab."""
    if settings.mode == "flight":
        return flight.outcome is Outcome.RECOVERED
    if is_piloted(settings):
        return flight.success
    if obstacle_of(settings) == "window" and flight.measures["touch_speed"] is None:
        return True
    return flight.outcome is Outcome.SEPARATED


def sentence(settings: LabSettings, robot: str, flight: Flight) -> str:
    """Summary of a flight in a sentence; a second one explains an unusual restitution."""
    name, m = robot_name(settings, robot), flight.measures
    if m["touch_speed"] is None:
        window = obstacle_of(settings) == "window" and not is_piloted(settings)
        return f"{name} {'flies through the window and ' if window else ''}touches nothing."
    hits = "is hit by" if obstacle_of(settings) == "ball" else "hits"
    words = f"{name} {hits} {_target(settings, flight)} at {m['touch_speed']:.2f} m/s"
    again, lasted = m["restitution_at_separation"], m["contact_time"]
    if again is not None and lasted is not None:
        left = again * m["touch_speed"]
        words += f", leaves it at {left:.2f} m/s after {1e3 * lasted:.0f} ms"
    peak = m["impact_peak_acceleration"] or 0.0
    words += f", peaks at {peak:.0f} m/s² ({peak / EARTH:.0f} g)"
    note = restitution_note(m, flight.columns, flight.scenario.vehicle.guard_word)
    why = f" Its restitution is {note}." if note else ""
    return f"{words}; {_ending(settings, flight)}.{why}"


def _target(settings: LabSettings, flight: Flight) -> str:
    """What is hit, with its article."""
    user = settings.user
    if obstacle_of(settings) != "wall":
        return f"the {WORDS.get(settings.obstacle, settings.obstacle)}"
    if user is not None and settings.mode == "file":
        return _touched_first(flight)
    if isinstance(getattr(user, "target", None), Mat) and settings.surface in ("file", "own"):
        return "the mat"
    return "the mat" if settings.surface == "mat" else "the wall"


def _touched_first(flight: Flight) -> str:
    """Obstacle of a file that was touched first, by its own word."""
    spans = sorted(contact_spans(flight), key=lambda one: one.begin)[:1]
    found = next(iter(contact_places(flight, spans)), None)
    if found is None:
        return "the obstacle"
    word = found.obstacle.rpartition(", ")[2]
    return f"the {_ARTICLE.sub('', word)}"


def _ending(settings: LabSettings, flight: Flight) -> str:
    """End of the sentence: the outcome."""
    m, out = flight.measures, flight.outcome
    if is_piloted(settings) and out is Outcome.RECOVERED:
        rest, lost = m["recovery_time"] or 0.0, m["height_loss"] or 0.0
        return f"recovers, at rest after {rest:.2f} s, {1e3 * lost:.0f} mm lower"
    if out is Outcome.SEPARATED:
        stroke = m["impact_arm_stroke"] or 0.0
        return f"arms compress by {1e3 * stroke:.1f} mm" if stroke > 0.0 else "no arm compresses"
    if out is Outcome.IN_CONTACT:
        return f"still in contact at the end, at {m['end_time'] or 0.0:.3g} s"
    return flight.message
