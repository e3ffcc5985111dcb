"""Events of a flight."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from springback.recovery.state_machine import CRUISE, HOVER, LOOK, PHASES, RECOVER, RETURN, STAGES
from springback.results.contacts.jumps import jumps_of
from springback.results.contacts.places import (
    ContactPlace,
    JumpContact,
    contact_places,
    jump_contacts,
)
from springback.results.contacts.spans import (
    ContactSpan,
    contact_mask,
    contact_spans,
    intervals,
    spans,
)
from springback.results.motion import specific_force_at
from springback.results.result import FlightResult
from springback.simulation.measuring.limits import arm_force
from springback.vehicle.arms.bent import ON_JOINTS, BentArm, BentCoordinates
from springback.vehicle.arms.joints import STRAIGHT
from springback.vehicle.limits import UNLIMITED, JointShares, LoadLimits
from springback.vehicle.rotor_stop import BROKEN

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


#: A step lands on the touch of the ground, one more may pass until there is a force [s] (chosen).
NEAR = 2e-3
#: Longer contact without force is told of [s] (chosen): a viscous surface comes back slower than a
#: vehicle leaves it.
LINGERS = 5e-4


class Event(NamedTuple):
    """An event of a flight.

    Kinds of the whole vehicle, one after the other in every impact: ``touch``, ``peak`` and
    ``separation``; ``bottomed``, ``ground`` and ``propeller`` once; ``rotor`` once for each that
    stops; ``alarm`` and ``phase`` of a recovery; ``settled``, when the arms are locked again;
    ``end``.  Kinds of one part, a guard or the hull: ``contact`` and ``release``, ``stop`` and
    ``stop_release`` of an arm, ``latch_open`` and ``latch_close`` of its latch, and ``broken``,
    once, of what is loaded beyond its limit.
    """

    t: float
    """Instant [s]; that of a part is exact to one step of the integration."""
    kind: str
    label: str
    """A few words."""
    text: str
    """A sentence without a full stop."""
    arm: int | None = None
    """Number of the arm, from 1, if it is an event of one."""
    value: float | None = None
    """Speed [m/s] of a touch, of a contact that of the main body; duration [s] of a separation or
    release, or for which a latch was open; acceleration [m/s²] of a peak; compression [m] of a
    stop.
    """
    obstacle: str | None = None
    """Of a touch or a contact: what is touched, such as ``world.obstacles[0], a pole``."""
    place: tuple[float, float, float] | None = None
    """Of a touch or a contact: where it is pressed hardest, world [m]."""


def impacts_of(flight: FlightResult) -> tuple[tuple[float, float], ...]:
    """First touch and last separation of every impact [s]; of impulses, the first and the last."""
    t, dwell = flight.columns["t"], flight.scenario.simulation.dwell
    found = intervals(t, contact_mask(flight.columns), dwell)
    ends = [(float(t[first]), float(t[min(last + 1, len(t) - 1)])) for first, last in found]
    pressing = bool(found) and found[-1][1] == len(t) - 1
    if jumps := [(one.begin, one.end) for one in jumps_of(flight.columns)]:
        ends = _joined(sorted([*ends, *jumps]), dwell)
    if ends:  # the measures have the exact instants of the first, columns only the steps
        begin, end = flight.measures.get("touch_time"), flight.measures.get("separation_time")
        whole = end is not None and not (pressing and len(ends) == 1)
        ends[0] = (begin or ends[0][0], end if end is not None and whole else ends[0][1])
    return tuple(ends)


def _joined(ends: Sequence[tuple[float, float]], apart: float) -> list[tuple[float, float]]:
    """Spans of time, in order of their beginnings, those closer together than ``apart`` as one."""
    found = [ends[0]]
    for begin, end in ends[1:]:
        if begin - found[-1][1] < apart:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return found


def events_of(flight: FlightResult) -> tuple[Event, ...]:
    """Events in order of time."""
    t = flight.columns["t"]
    touches = sorted(contact_spans(flight), key=lambda one: one.begin)
    met = list(zip(touches, contact_places(flight, touches), strict=True))
    hits = jump_contacts(flight)
    found = [*_contacts(flight, met, hits), *_failures(flight, met), *_phases(flight)]
    found += [*_settling(flight), *_reports(flight), *_parts(flight, met), *_overloads(flight)]
    found += _impulses(flight, hits)
    found.append(Event(float(t[-1]), "end", "end", flight.message))
    return tuple(sorted(found, key=lambda event: event.t))


_Met = Sequence[tuple[ContactSpan, ContactPlace | None]]


def _contacts(flight: FlightResult, met: _Met, hits: Sequence[JumpContact]) -> list[Event]:
    c = flight.columns
    felt = contact_mask(flight.columns)
    found: list[Event] = []
    impacts, near = impacts_of(flight), max(NEAR, flight.scenario.simulation.record_interval)
    for number, (begin, end) in enumerate(impacts[:MOST], start=1):
        which = "" if len(impacts) == 1 else f" {number}"
        hit = next((one for one in hits if abs(one.jump.begin - begin) <= near), None)
        when = begin if hit is None else float(c["t"][hit.jump.before])  # it jumps at the touch
        speed = float(np.sqrt(sum(np.interp(when, c["t"], c[f"v{a}"]) ** 2 for a in "xyz")))
        sentence = f"{'first touch' if number == 1 else 'touches again'}, at {speed:.2f} m/s"
        along = flight.touch_speed if number == 1 else None
        if along is not None and flight.is_beside_movers:
            speed = along
            sentence = f"first touch, at {speed:.2f} m/s along the normal, relative to it"
        elif along is not None and abs(along - speed) > 0.01 * speed:
            sentence += f", {along:.2f} m/s of it along the normal (touch_speed)"
        there = next((place for one, place in met if one.end > begin), None)
        there = there if hit is None else hit.place
        sentence += "" if there is None else f", on {there.obstacle}"
        sentence += "" if hit is None else f", impulse {hit.jump.size:.3g} N s"
        place = (None, None) if there is None else there[:2]
        found.append(Event(begin, "touch", f"touch{which}", sentence, None, speed, *place))
        lasts = any(one.begin < end and one.end > begin for one, _ in met)
        if (lasts or not hits) and (end < c["t"][-1] or not felt[-1]):
            sentence = f"separates after {1e3 * (end - begin):.1f} ms"
            pressed = max((one.end for one, _ in met if one.begin < end), default=end)
            if end - pressed > LINGERS:
                sentence += (
                    f", the last {1e3 * (end - pressed):.1f} ms of them without force, still "
                    "within the obstacle's undeformed surface"
                )
            found.append(Event(end, "separation", f"off{which}", sentence, value=end - begin))
    hardest, peak = flight.measures.get("peak_acceleration_time"), flight.peak_acceleration
    if impacts and hardest is not None and peak is not None:
        sentence = f"peak acceleration, {peak:.0f} m/s²"
        found.append(Event(hardest, "peak", "peak", sentence, value=peak))
    return found


def _overloads(flight: FlightResult) -> list[Event]:
    """When each part was first loaded beyond its limit."""
    limits, c = flight.scenario.vehicle.limits, flight.columns
    if limits is None or flight.measures.get("broken_time") is None:
        return []
    known = flight.scenario.vehicle.load_limits()
    assert isinstance(known, LoadLimits)
    loads: list[tuple[str, Array, float, str]] = []
    arms = flight.scenario.vehicle.arms
    for j, arm in enumerate(flight.scenario.vehicle.airframe().arms, start=1):
        loads.append((f"guard {j}", c[f"fn{j}"], known.guards[j - 1], "N"))
        shares, radii = known.joints[j - 1], arms.radii(j - 1)
        for k, (share, radius) in enumerate(zip(shares, radii, strict=False)):
            if known.arms[j - 1] == UNLIMITED or share == 0.0:
                continue
            alone = JointShares(*(share if k == joint else 0.0 for joint in range(len(shares))))
            forces = np.array([arm_force(arm, *moves, alone) for moves in _arm_moves(c, j)])
            torque = limits.hinge_torque is not None and radius > 0.0
            lever, unit = (radius / share, "N m") if torque else (1.0 / share, "N")
            name = f"hinge of arm {j}" if torque else f"arm {j}"
            if len(radii) > 1:
                name = f"{('first', 'second')[k]} {'hinge' if torque else 'joint'} of arm {j}"
            loads.append((name, forces * lever, known.arms[j - 1] * lever, unit))
    for one in limits.components:
        if not (flight.is_second and any(one.position)):
            felt = np.linalg.norm(specific_force_at(flight, one.position), axis=1)
            loads.append((one.name, felt, one.specific_force, "m/s²"))
    found = []
    left = {f"guard {j}": s for one in known.broken for j, s in enumerate(one.stiffness, start=1)}
    for name, load, most, unit in loads:
        beyond = np.flatnonzero(load > most)
        if len(beyond):
            when, sentence = float(c["t"][beyond[0]]), f"{name}: more than {most:g} {unit}"
            if name in left:
                sentence += f", {100.0 * left[name]:.3g} % of its stiffness is left"
            found.append(Event(when, "broken", f"{name} broken", sentence, value=float(load.max())))
    return found


def _arm_moves(c: Mapping[str, Array], j: int) -> Iterator[tuple[Any, Any]]:
    """Coordinate of arm ``j`` and its rate, instant by instant; of two joints both."""
    one = [c[f"{kind}{j}"].tolist() for kind in ("l", "dl")]
    if f"bend{j}" not in c:
        yield from zip(*one, strict=True)
        return
    both = [c[f"{kind}{j}"].tolist() for kind in ("bend", "dbend")]
    for length, rate, bend, turning in zip(*one, *both, strict=True):
        yield BentCoordinates(length, bend), BentCoordinates(rate, turning)


def _failures(flight: FlightResult, met: _Met) -> list[Event]:
    named = {"bottomed_time": ("bottomed", "an arm reaches the end of its stroke"),
             "ground_time": ("ground", "{parts} the ground"),
             "propeller_hit_time": ("propeller", "a propeller is hit")}  # fmt: skip
    found = []
    for name, (label, text) in named.items():
        when = flight.measures.get(name)
        if when is not None:
            found.append(Event(when, label, label, text.format(parts=_grounded(when, met))))
    return [*found, *_rotor_stops(flight)]


def _rotor_stops(flight: FlightResult) -> list[Event]:
    """When each rotor first stops, hit."""
    first = flight.measures.get("rotor_stop_time")
    if first is None:
        return []
    found = []
    for j in range(1, flight.scenario.vehicle.rotor_count + 1):
        since = flight.telemetry.get(f"stopped{j}", np.zeros(0))
        for k in np.flatnonzero((since >= 0.0) | (since == BROKEN))[:1].tolist():
            breaks = since[k] == BROKEN  # in the tick before, after which the row is
            when = float(flight.telemetry["t"][max(k - 1, 0)] if breaks else since[k])
            what = "its propeller is hit and breaks" if breaks else "it is hit"
            found.append(Event(when, "rotor", f"rotor {j}", f"rotor {j} stops: {what}"))
    return found or [Event(first, "rotor", "rotor", "a rotor stops")]  # in the last tick


def _grounded(when: float, met: _Met) -> str:
    """Parts that touch the ground first, with the verb; the vehicle if they are not known."""
    near = [
        (one.begin, one.name)
        for one, there in met
        if one.begin - NEAR <= when <= one.end and (there is None or there.is_ground)
    ]
    first = min((begin for begin, _ in near), default=0.0)
    names = [name for begin, name in near if begin == first] or ["the vehicle"]
    return f"{' and '.join(names)} {'touch' if len(names) > 1 else 'touches'}"


def _settling(flight: FlightResult) -> Iterator[Event]:
    """Instants at which the arms have settled and are locked again, after an impact."""
    rates = ("dl", "dbend")
    moves = [values != 0.0 for name, values in flight.columns.items() if name.startswith(rates)]
    moving = np.logical_or.reduce(moves) if moves else np.zeros(len(flight.t), dtype=bool)
    t = flight.t
    for k in np.flatnonzero(moving[:-1] & ~moving[1:]).tolist():
        yield Event(float(t[k + 1]), "settled", "settled", "the arms have settled and are locked")


def _parts(flight: FlightResult, met: _Met) -> Iterator[Event]:
    """Contacts of each guard and of the hull, and end stops of each arm."""
    c = flight.columns
    speed = np.sqrt(sum(c[f"v{axis}"] ** 2 for axis in "xyz"))
    for one, there in met:
        what = "" if there is None else f" {there.obstacle}"
        sentence = f"{one.name} touches{what}, normal force up to {one.force:.0f} N"
        label, place = f"{one.name} on", (None, None) if there is None else there[:2]
        yield Event(one.begin, "contact", label, sentence, one.arm, float(speed[one.first]), *place)
        sentence = f"{one.name} is without force after {1e3 * (one.end - one.begin):.1f} ms"
        label, lasts = f"{one.name} off", one.end - one.begin
        yield Event(one.end, "release", label, sentence, one.arm, lasts)
    for j, shortest in enumerate(_shortest(flight), start=1):
        yield from _stops(flight, c[f"l{j}"], shortest, j, f"arm {j}")
    for j, arm in enumerate(flight.scenario.vehicle.airframe().arms, start=1):
        if isinstance(arm, BentArm) and arm.compliance * arm.stop_stiffness > 0.0:
            name = f"the second joint of arm {j}"
            yield from _stops(flight, c[f"bend{j}"], arm.second.shortest, j, name)
        if isinstance(arm, ON_JOINTS):
            yield from _latches(flight, arm, c[f"l{j}"], j, f"arm {j}")
        if isinstance(arm, BentArm):
            name = f"the second joint of arm {j}"
            yield from _latches(flight, arm.second, c[f"bend{j}"], j, name)


def _impulses(flight: FlightResult, hits: Sequence[JumpContact]) -> Iterator[Event]:
    """Jumps of the motion, by each part that touches."""
    c = flight.columns
    for hit in hits:
        row = hit.jump.before
        speed = float(np.sqrt(sum(c[f"v{axis}"][row] ** 2 for axis in "xyz")))
        several = len(hit.parts) > 1
        for part, name in zip(hit.parts, hit.names, strict=True):
            sentence = f"{name} touches {hit.place.obstacle}, impulse {hit.jump.size:.3g} N s"
            sentence += " of all that touch at once" if several else ""
            arm = part + 1 if part < flight.scenario.vehicle.arm_count else None
            yield Event(
                hit.jump.begin, "contact", f"{name} on", sentence, arm, speed, *hit.place[:2]
            )


def _stops(
    flight: FlightResult, length: Array, shortest: float, j: int, name: str
) -> Iterator[Event]:
    """When a joint of arm ``j`` is at its inner end stop."""
    for first, last, begin, end in spans(flight, length < shortest):
        most = float(length[0] - np.min(length[first : last + 1]))
        sentence = f"{name} reaches its end stop, compressed by up to {1e3 * most:.1f} mm"
        yield Event(begin, "stop", f"stop {j}", sentence, j, most)
        sentence = f"{name} leaves its end stop after {1e3 * (end - begin):.1f} ms"
        yield Event(end, "stop_release", f"stop {j} off", sentence, j, end - begin)


def _latches(flight: FlightResult, joint: Any, way: Array, j: int, name: str) -> Iterator[Event]:
    """When the latch of a joint of arm ``j`` opens, and closes again."""
    curvature = joint.joint.curvature
    is_hinge = curvature > STRAIGHT
    for latch in joint.spring.latch:
        most = f"{latch.force / curvature:.3g} N m" if is_hinge else f"{latch.force:.3g} N"
        opened = (
            joint.length - way > latch.travel if latch.force > 0.0 else np.zeros(len(way), bool)
        )
        for _, _, begin, end in spans(flight, opened):
            sentence = f"the latch of {name} opens, at {most}"
            yield Event(begin, "latch_open", f"latch {j} open", sentence, j)
            if end < flight.t[-1]:
                sentence = f"the latch of {name} closes after {1e3 * (end - begin):.1f} ms"
                yield Event(end, "latch_close", f"latch {j} closed", sentence, j, end - begin)


def _shortest(flight: FlightResult) -> list[float]:
    """Length of each sliding arm at its inner end stop [m]; −1 for a locked one."""
    arms = flight.scenario.flight_model().airframe.arms
    return [arm.shortest if arm.compliance * arm.stop_stiffness > 0.0 else -1.0 for arm in arms]


def _phases(flight: FlightResult) -> list[Event]:
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
        found.append(Event(when, kind, label, text.format(trigger=_trigger(flight, k + 1))))
    return found


def _reports(flight: FlightResult) -> list[Event]:
    """Alarms that a pilot of the user's own reports."""
    telemetry = flight.telemetry
    reports = telemetry.get("alarm", np.zeros(0)) > 0.5
    rises = np.flatnonzero(reports & ~np.concatenate([[False], reports[:-1]]))
    text = "your pilot reports a collision"
    return [Event(float(telemetry["t"][k]), "alarm", "detected", text) for k in rises[:MOST]]


def _trigger(flight: FlightResult, k: int) -> str:
    """Cause of the alarm at a tick, in words."""
    telemetry, recovery = flight.telemetry, flight.scenario.recovery
    other = "a trigger" if recovery is None or recovery.detection.own is None else "your detector"
    raised = [
        words
        for name, words in _TRIGGERS.items()
        if f"alarms_{name}" in telemetry
        and telemetry[f"alarms_{name}"][k] > telemetry[f"alarms_{name}"][max(k - 2, 0)]
    ]
    return " and ".join(raised) or other
