"""Measures of a flight by name and unit, and its outcome in a sentence."""

from __future__ import annotations

import math
from enum import Enum
from typing import Any

import numpy as np

from springback.dynamics.ledger import ledger_balance
from springback.simulation.flight import FlightRecord
from springback.simulation.measuring.columns import Array, as_columns
from springback.simulation.measuring.record import NOT_FINITE, Record
from springback.vehicle.limits import NO_LIMIT

Flags = np.ndarray[Any, np.dtype[np.bool_]]


class Outcome(Enum):
    """Outcome of a flight; the value is its sentence."""

    NOT_FINITE = "the simulation diverged; the last good state is kept"
    BROKEN = "a part was loaded beyond its limit"
    HIT_GROUND = "touched the ground"
    ARM_BOTTOMED = "an arm reached the end of its stroke"
    IN_CONTACT = "still in contact with an obstacle at the end"
    SEPARATED = "hit an obstacle and left it again"
    NO_CONTACT = "touched nothing"
    RECOVERED = "recovered from every collision"
    NOT_DETECTED = "a collision was not detected"
    NOT_SETTLED = "did not come to rest after a collision, at its goal if it has one"

    @property
    def word(self) -> str:
        """Short name, used in files."""
        return self.name.lower()


def outcome_of(record: Record) -> Outcome:
    """Outcome of a flight; if several apply, the worst."""
    return outcomes_of(as_columns(record))[0]


def outcomes_of(record: Any) -> list[Outcome]:
    """Outcomes of many flights, from a `Record` whose leaves are columns."""
    claims = [
        (Outcome.NOT_FINITE, record.stepping.status == NOT_FINITE),
        (Outcome.BROKEN, _is_broken(record)),
        (Outcome.HIT_GROUND, record.contacts.ground_time >= 0.0),
        (Outcome.ARM_BOTTOMED, record.contacts.bottomed_time >= 0.0),
        (Outcome.IN_CONTACT, record.contacts.touching > 0.0),
        (Outcome.SEPARATED, record.contacts.total > 0.0),
    ]
    return first_claimed(claims, Outcome.NO_CONTACT)


def first_claimed(claims: list[tuple[Outcome, Any]], otherwise: Outcome) -> list[Outcome]:
    """For each flight, the first outcome whose claim holds."""
    said = [otherwise, *(outcome for outcome, _ in claims)]
    numbers = range(1, len(said))
    chosen = np.select([claim for _, claim in claims], list(numbers), 0)
    return [said[k] for k in chosen.tolist()]


#: Outcomes of a flight without a pilot that are no success.
FAILURES = (Outcome.BROKEN, Outcome.HIT_GROUND, Outcome.ARM_BOTTOMED, Outcome.NOT_FINITE)

#: Slowest touch that has a restitution [m/s] (chosen).
SLOWEST = 0.01

#: Unit and meaning of each measure.  Those of the first impact are from its first touch until the
#: arms have settled, the others of the whole flight.
MEASURES = {
    "restitution_at_separation": ("", "v_n of the main body, out at last separation / in at touch"),
    "restitution_at_return": ("", "the same, when it is back where it was at first touch"),
    "restitution_of_mass_centre": ("", "the same for the centre of mass, last separation"),
    "touch_time": ("s", "first touch"),
    "touch_speed": (
        "m/s",
        "speed of the main body into the obstacle at first touch, along its normal, relative to it",
    ),
    "touch_x": ("m", "where it is touched first, world X; unknown on another vehicle"),
    "touch_y": ("m", "the same, world Y"),
    "touch_z": ("m", "the same, world Z"),
    "separation_time": ("s", "last separation of the first impact"),
    "return_time": ("s", "main body back where it was at first touch"),
    "contact_time": ("s", "first touch to last separation of the first impact; impulses have none"),
    "time_to_return": ("s", "first touch to the main body's return"),
    "travel": (
        "m",
        "way of the main body into the obstacle, from its place at first touch until last "
        "separation; 0 if it is driven back from there on",
    ),
    "impact_peak_acceleration": (
        "m/s^2",
        "first impact: largest |dv/dt| of the main body; an impulse has none, nor force",
    ),
    "impact_peak_acceleration_time": ("s", "time of it"),
    "impact_peak_specific_force": (
        "m/s^2",
        "first impact: largest specific force of the main body, gravity included",
    ),
    "impact_peak_angular_rate": ("rad/s", "first impact: largest angular rate"),
    "impact_peak_normal_force": (
        "N",
        "first impact: largest normal force of one guard, or of the main body",
    ),
    "impact_penetration": ("m", "first impact: deepest penetration of a guard, or the main body"),
    "impact_arm_stroke": ("m", "first impact: largest compression of an arm"),
    "impact_arm_extension": (
        "m",
        "first impact: largest extension of an arm past its free length",
    ),
    "contact_duration": ("s", "whole flight: total time in contact, all contacts"),
    "peak_acceleration": (
        "m/s^2",
        "whole flight: largest |dv/dt| of the main body; none if all contacts are impulses",
    ),
    "peak_acceleration_time": ("s", "time of it"),
    "peak_specific_force": (
        "m/s^2",
        "whole flight: largest specific force of the main body, gravity included",
    ),
    "peak_angular_rate": ("rad/s", "whole flight: largest angular rate"),
    "peak_normal_force": (
        "N",
        "whole flight: largest normal force of one guard, or of the main body",
    ),
    "penetration": ("m", "whole flight: deepest penetration of a guard, or the main body"),
    "arm_stroke": ("m", "whole flight: largest compression of an arm"),
    "arm_extension": ("m", "whole flight: largest extension of an arm past its free length"),
    "impulse_x": ("N s", "whole flight: impulse of all contact forces on the vehicle, world X"),
    "impulse_y": ("N s", "the same, world Y"),
    "impulse_z": ("N s", "the same, world Z"),
    "contacts": ("", "number of times that the vehicle came into contact"),
    "body_contacts": ("", "number of times that the main body came into contact; needs a hull"),
    "impacts": ("", "number of impacts: contacts closer together than the dwell time are one"),
    "bottomed_time": ("s", "an arm reached the end of its stroke"),
    "ground_time": ("s", "a guard or the main body touched the ground"),
    "propeller_hit_time": ("s", "a propeller was hit; needs propulsion.disk_radius"),
    "propellers_hit": ("", "number of propellers that were hit; likewise"),
    "rotor_stop_time": ("s", "a rotor stopped, hit; needs propulsion.stop"),
    "rotors_stopped": ("", "number of rotors that stopped at least once; likewise"),
    "guard_margin": (
        "",
        "what the most loaded guard could still bear, over its limit; needs vehicle.limits",
    ),
    "arm_margin": ("", "the same for the force along an arm"),
    "component_margin": ("", "the same for the specific force at a component"),
    "broken_time": ("s", "a part was loaded beyond its limit"),
    "end_time": ("s", "end of the simulation"),
    "steps": ("", "Runge-Kutta steps taken"),
    "energy_start": ("J", "kinetic and stored energy, gravity above the start"),
    "energy_end": ("J", "the same at the end"),
    "energy_kinetic": ("J", "kinetic energy at the end"),
    "energy_gravity": ("J", "gravitational energy at the end, above the start"),
    "energy_springs": ("J", "in arm springs at the end"),
    "energy_stops": ("J", "in end stops at the end"),
    "energy_contact": ("J", "in contacts at the end"),
    "energy_obstacles": ("J", "gained since the start by obstacles that move by themselves"),
    "work_thrust": ("J", "done by the rotors"),
    "work_driven": ("J", "done by what moves obstacles as prescribed"),
    "loss_arm": ("J", "dissipated by arm dampers"),
    "loss_stop": ("J", "dissipated by end stops"),
    "loss_contact": ("J", "dissipated by contact damping, and when guards lose stiffness"),
    "loss_friction": ("J", "dissipated by friction"),
    "loss_settling": ("J", "lost when settled arms are locked again"),
    "loss_air": ("J", "lost to the air; negative where wind does work"),
    "loss_obstacles": ("J", "dissipated in joints of obstacles, and at their own contacts"),
    "ledger_residual": ("", "unaccounted energy, as a share of the largest energy"),
    "ledger_open": ("", "1 if that is more than 1e-4 and 1e-9 J: the flight cannot be trusted"),
}  # fmt: skip


def scalars_of(columns: dict[str, Array]) -> dict[str, float | None]:
    """Measures of a single flight by name; None where they are NaN."""
    values = {name: float(column[0]) for name, column in columns.items()}
    return {name: None if math.isnan(value) else value for name, value in values.items()}


def where(happened: Any, value: Array) -> Array:
    """A value where an event happened, else NaN."""
    return np.where(happened, value, np.nan)


def _time(value: Array) -> Array:
    return where(value >= 0.0, value)


def _ratio(speed: Array, touch_speed: Array, happened: Array) -> Array:
    """Speed out of the obstacle over that at touch; negative if it still moves on into it.

    NaN where the touch was slower than `SLOWEST`: what moves a vehicle later is no rebound.
    """
    fast: Any = np.abs(touch_speed) >= SLOWEST
    with np.errstate(divide="ignore", invalid="ignore"):
        return where(happened & fast, -speed / np.abs(touch_speed))


def _body_contacts(record: Any) -> Array:
    """Number of contacts of the main body; NaN without a hull, because it is unknown then."""
    return next(iter(record.contacts.hull), np.full_like(record.contacts.total, np.nan))


def _first_time(times: tuple[Array, ...], like: Array) -> Array:
    """When something first happened to any propeller or rotor [s]; NaN if it did not.

    Args:
        times: Of each; negative if it did not happen; empty if it is not known.
        like: Of the shape of a column.
    """
    unknown = np.full_like(like, np.nan)
    return np.asarray(np.fmin.reduce([unknown, *map(_time, times)]))


def _number_of(times: tuple[Array, ...], like: Array) -> Array:
    """To how many it happened, arguments as for `_first_time`; NaN if it is not known."""
    unknown = np.full_like(like, np.nan)
    return np.asarray(sum(1.0 * (time >= 0.0) for time in times)) if times else unknown


def _margin(record: Any, parts: str) -> Array:
    """1 less the largest share of a limit that a load was, over some parts; NaN without a limit."""
    unknown = np.full_like(record.contacts.total, np.nan)
    margins = [
        where(one.broken_time != NO_LIMIT, 1.0 - one.share)
        for one in getattr(record.loads, parts, ())
    ]
    return np.asarray(np.fmin.reduce([unknown, *margins]))


def _broken_times(record: Any) -> tuple[Array, ...]:
    """When each part was first loaded beyond its limit; empty where there is none."""
    parts = [getattr(record.loads, name, ()) for name in ("guards", "arms", "components")]
    return tuple(one.broken_time for group in parts for one in group)


def _is_broken(record: Any) -> Flags:
    """True for flights that fail by a load beyond a limit."""
    first = _first_time(_broken_times(record), record.contacts.total)
    return np.asarray(np.isfinite(first) & (getattr(record.loads, "breaks", 0.0) > 0.0))


def _stop_times(record: Any) -> tuple[Array, ...]:
    """When each rotor first stopped; empty where hits stop none."""
    return tuple(hits.stop_time for hits in getattr(record.hits, "rotors", ()))


def measure_columns(record: Any, work: Any, before: Any, after: Any) -> dict[str, Array]:
    """Measures of many flights, in the order of `MEASURES`; NaN for events that did not happen.

    Args:
        record: A `Record` whose leaves are columns, a number for each flight; all others likewise.
        work: `Work` since the start.
        before: `Energy` at the start.
        after: `Energy` at the end.
    """
    w, first, contacts, stepping = work, record.first_impact, record.contacts, record.stepping
    peaks, impact = record.peaks, record.impact_peaks
    balance = ledger_balance(work, before, after)
    touched = first.touch_time >= 0.0
    left, back = first.separation_time >= 0.0, first.return_time >= 0.0
    # Impulses, one or several after each other, last no time and have no force nor acceleration.
    pushed = touched & (impact.normal_force > 0.0)
    felt = ~touched | pushed | (peaks.normal_force > 0.0)
    values: dict[str, Any] = {
        "restitution_at_separation": _ratio(first.separation_speed, first.touch_speed, left),
        "restitution_at_return": _ratio(first.return_speed, first.touch_speed, back),
        "restitution_of_mass_centre": _ratio(
            first.separation_mass_centre_speed,
            first.touch_mass_centre_speed,
            left,
        ),
        "touch_time": _time(first.touch_time),
        "touch_speed": where(touched, first.touch_speed),
        **{f"touch_{axis}": where(touched, getattr(first.point, axis)) for axis in "xyz"},
        "separation_time": _time(first.separation_time),
        "return_time": _time(first.return_time),
        "contact_time": where(left & pushed, first.separation_time - first.touch_time),
        "time_to_return": where(back, first.return_time - first.touch_time),
        "travel": where(pushed, first.travel),
        "impact_peak_acceleration": where(pushed, impact.acceleration),
        "impact_peak_acceleration_time": where(pushed, _time(impact.acceleration_time)),
        "impact_peak_specific_force": where(pushed, impact.specific_force),
        "impact_peak_angular_rate": where(touched, impact.angular_rate),
        "impact_peak_normal_force": where(pushed, impact.normal_force),
        "impact_penetration": where(touched, impact.penetration),
        "impact_arm_stroke": where(touched, impact.compression),
        "impact_arm_extension": where(touched, impact.extension),
        "contact_duration": contacts.duration,
        "peak_acceleration": where(felt, peaks.acceleration),
        "peak_acceleration_time": where(felt, peaks.acceleration_time),
        "peak_specific_force": where(felt, peaks.specific_force),
        "peak_angular_rate": peaks.angular_rate,
        "peak_normal_force": peaks.normal_force,
        "penetration": peaks.penetration,
        "arm_stroke": peaks.compression,
        "arm_extension": peaks.extension,
        "impulse_x": w.impulse.x,
        "impulse_y": w.impulse.y,
        "impulse_z": w.impulse.z,
        "contacts": contacts.total,
        "body_contacts": _body_contacts(record),
        "impacts": contacts.impacts,
        "bottomed_time": _time(contacts.bottomed_time),
        "ground_time": _time(contacts.ground_time),
        "propeller_hit_time": _first_time(contacts.propellers, contacts.total),
        "propellers_hit": _number_of(contacts.propellers, contacts.total),
        "rotor_stop_time": _first_time(_stop_times(record), contacts.total),
        "rotors_stopped": _number_of(_stop_times(record), contacts.total),
        **{f"{kind}_margin": _margin(record, f"{kind}s") for kind in ("guard", "arm", "component")},
        "broken_time": _first_time(_broken_times(record), contacts.total),
        "end_time": stepping.time,
        "steps": stepping.steps,
        "energy_start": balance.start,
        "energy_end": balance.end,
        "energy_kinetic": after.kinetic,
        "energy_gravity": after.gravity - before.gravity,
        "energy_springs": after.springs,
        "energy_stops": after.stops,
        "energy_contact": after.contact,
        "energy_obstacles": after.obstacles - before.obstacles,
        "work_thrust": w.thrust,
        "work_driven": balance.driven,
        "loss_arm": w.arm,
        "loss_stop": w.stop,
        "loss_contact": w.contact,
        "loss_friction": w.friction,
        "loss_settling": w.settling,
        "loss_air": w.air,
        "loss_obstacles": balance.in_obstacles,
        "ledger_residual": balance.residual,
        "ledger_open": np.where(balance.closes, 0.0, 1.0),
    }
    return {name: where(np.isfinite(value), value) for name, value in values.items()}


def measures_of(flown: FlightRecord) -> dict[str, float | None]:
    """Measures of a flight, in the order of `MEASURES`; None for events that did not happen."""
    trees = flown.record, flown.motion.work, flown.before, flown.after
    return scalars_of(measure_columns(*(as_columns(tree) for tree in trees)))
