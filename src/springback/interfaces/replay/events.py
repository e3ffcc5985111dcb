"""Events of a flight."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.interfaces.replay.instants import intervals, touching
from springback.recovery.state_machine import CRUISE, HOVER, LOOK, PHASES, RECOVER, RETURN, STAGES
from springback.results.flight import Flight

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Beginnings of the phases of a recovery: a short label for the time line, and a sentence.
_PHASE_EVENTS = {
    LOOK: ("detected", "the collision is detected: {trigger}"),
    STAGES: ("stages", "the recovery in stages begins"),
    RECOVER: ("way back", "the collision is characterised, the way back begins"),
    RETURN: ("return", "at rest at p_r, the way home begins"),
    HOVER: ("home", "home again"),
    CRUISE: ("run-up", "the next run-up begins"),
}
_TRIGGERS = {"hall": "an arm is compressed", "acceleration": "lateral acceleration",
             "wrench": "an external force"}  # fmt: skip
#: Impacts beyond this number are not labelled (chosen: as many as a time line can show).
MOST = 12


class Event(NamedTuple):
    """An event on the time line."""

    t: float  # [s]
    kind: str  # touch, separation, peak, alarm, phase, trouble or end
    label: str  # one or two words
    text: str  # a sentence without a full stop


def impacts_of(flight: Flight) -> tuple[tuple[float, float], ...]:
    """First touch and last separation of every impact [s]."""
    t = flight.columns["t"]
    found = intervals(t, _in_contact(flight), flight.scenario.simulation.dwell)
    ends = [(float(t[first]), float(t[min(last + 1, len(t) - 1)])) for first, last in found]
    if ends:  # the measures have the exact instants of the first, columns only the steps
        begin, end = flight.measures.get("touch_time"), flight.measures.get("separation_time")
        whole = end is not None and found[0][1] < len(t) - 1
        ends[0] = (begin or ends[0][0], end if end is not None and whole else ends[0][1])
    return tuple(ends)


def _in_contact(flight: Flight) -> Any:
    return touching(flight.columns)


def events_of(flight: Flight) -> tuple[Event, ...]:
    """Events in order of time."""
    t = flight.columns["t"]
    found = [*_contacts(flight), *_troubles(flight), *_phases(flight)]
    found.append(Event(float(t[-1]), "end", "end", flight.message))
    return tuple(sorted(found, key=lambda event: event.t))


def _contacts(flight: Flight) -> list[Event]:
    c = flight.columns
    felt = _in_contact(flight)
    found: list[Event] = []
    impacts = impacts_of(flight)
    for number, (begin, end) in enumerate(impacts[:MOST], start=1):
        which = "" if len(impacts) == 1 else f" {number}"
        speed = float(np.sqrt(sum(np.interp(begin, c["t"], c[f"v{a}"]) ** 2 for a in "xyz")))
        found.append(Event(begin, "touch", f"touch{which}", f"first touch, at {speed:.2f} m/s"))
        if end < c["t"][-1] or not felt[-1]:
            after = 1e3 * (end - begin)
            found.append(Event(end, "separation", f"off{which}", f"separates after {after:.1f} ms"))
    hardest, peak = flight.measures.get("peak_acceleration_time"), flight.peak_acceleration
    if impacts and hardest is not None and peak is not None:
        found.append(Event(hardest, "peak", "peak", f"peak acceleration, {peak:.0f} m/s²"))
    return found


def _troubles(flight: Flight) -> list[Event]:
    named = {"bottomed_time": ("bottomed", "an arm reaches the end of its stroke"),
             "ground_time": ("ground", "a cage touches the ground")}  # fmt: skip
    found = []
    for name, (label, text) in named.items():
        when = flight.measures.get(name)
        if when is not None:
            found.append(Event(when, "trouble", label, text))
    return found


def _phases(flight: Flight) -> list[Event]:
    """Changes of the pilot's phase."""
    telemetry = flight.telemetry
    if "phase" not in telemetry:
        return []
    t, phase = telemetry["t"], telemetry["phase"]
    found = []
    for k in np.flatnonzero(np.diff(phase)).tolist()[: 6 * MOST]:
        now = float(phase[k + 1])
        if not 0.0 <= now < len(PHASES):
            continue
        label, text = _PHASE_EVENTS[now]
        kind = "alarm" if now == LOOK else "phase"
        when = float(t[k + 1])
        found.append(Event(when, kind, label, text.format(trigger=_trigger(telemetry, k + 1))))
    return found


def _trigger(telemetry: dict[str, Array], k: int) -> str:
    """Cause of the alarm at a tick, in words."""
    raised = [
        words
        for name, words in _TRIGGERS.items()
        if f"alarms_{name}" in telemetry
        and telemetry[f"alarms_{name}"][k] > telemetry[f"alarms_{name}"][max(k - 2, 0)]
    ]
    return " and ".join(raised) or "a trigger"
