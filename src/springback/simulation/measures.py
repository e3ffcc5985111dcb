"""The measures of a flight by name and unit, and its outcome in a sentence."""

from __future__ import annotations

import math
from enum import Enum

from springback.simulation.flight import Flown
from springback.simulation.record import NOT_FINITE, Record


class Outcome(Enum):
    """How a flight ended; the value is the sentence."""

    NOT_FINITE = "the simulation diverged; the last good state is kept"
    HIT_GROUND = "a cage touched the ground"
    ARM_BOTTOMED = "an arm reached the end of its stroke"
    IN_CONTACT = "still in contact with an obstacle at the end"
    SEPARATED = "hit an obstacle and left it again"
    NO_CONTACT = "touched nothing"
    RECOVERED = "recovered from every collision"
    NOT_DETECTED = "a collision was not noticed"
    NOT_SETTLED = "did not come to rest where it should after a collision"

    @property
    def word(self) -> str:
        """Short name, as it stands in files."""
        return self.name.lower()


def outcome_of(record: Record) -> Outcome:
    """The outcome of a flight; where several apply, the worst."""
    if record.status == NOT_FINITE:
        return Outcome.NOT_FINITE
    if record.ground_time >= 0.0:
        return Outcome.HIT_GROUND
    if record.bottomed_time >= 0.0:
        return Outcome.ARM_BOTTOMED
    if record.touching > 0.0:
        return Outcome.IN_CONTACT
    return Outcome.SEPARATED if record.contacts > 0.0 else Outcome.NO_CONTACT


#: Unit and meaning of every measure.
MEASURES = {
    "restitution_at_separation": ("", "|v_n| of the main body, last separation / first touch"),
    "restitution_at_return": ("", "the same, when it is back where it was at first touch"),
    "restitution_of_mass_centre": ("", "the same for the centre of mass, last separation"),
    "touch_time": ("s", "first touch"),
    "touch_speed": ("m/s", "speed of the main body into the obstacle at first touch"),
    "separation_time": ("s", "last separation of the first impact"),
    "return_time": ("s", "main body back where it was at first touch"),
    "contact_time": ("s", "first touch to last separation of the first impact"),
    "time_to_return": ("s", "first touch to the main body's return"),
    "contact_duration": ("s", "total time in contact, all contacts"),
    "peak_acceleration": ("m/s^2", "largest |dv/dt| of the main body"),
    "peak_acceleration_time": ("s", "when"),
    "peak_specific_force": ("m/s^2", "largest specific force of the main body, gravity included"),
    "peak_angular_rate": ("rad/s", "largest angular rate"),
    "peak_normal_force": ("N", "largest normal force of one cage"),
    "penetration": ("m", "deepest penetration of a cage"),
    "arm_stroke": ("m", "largest compression of an arm"),
    "arm_extension": ("m", "largest extension of an arm past its free length"),
    "travel": ("m", "of the main body past its place at first touch, into the obstacle"),
    "impulse_x": ("N s", "of all contact forces, world X"),
    "impulse_y": ("N s", "of all contact forces, world Y"),
    "impulse_z": ("N s", "of all contact forces, world Z"),
    "contacts": ("", "times that the vehicle came into contact, one by one"),
    "impacts": ("", "contacts closer together than the dwell time are one impact"),
    "bottomed_time": ("s", "an arm reached the end of its stroke"),
    "ground_time": ("s", "a cage touched the ground"),
    "end_time": ("s", "end of the simulation"),
    "steps": ("", "Runge-Kutta steps taken"),
    "energy_start": ("J", "kinetic energy and what is stored, gravity above the start"),
    "energy_end": ("J", "the same at the end"),
    "energy_kinetic": ("J", "kinetic energy at the end"),
    "energy_gravity": ("J", "gravitational energy at the end, above the start"),
    "energy_springs": ("J", "in arm springs at the end"),
    "energy_stops": ("J", "in end stops at the end"),
    "energy_contact": ("J", "in contacts at the end"),
    "work_thrust": ("J", "put in by the rotors"),
    "loss_arm": ("J", "taken by arm dampers"),
    "loss_stop": ("J", "taken by end stops"),
    "loss_contact": ("J", "taken by contact damping"),
    "loss_friction": ("J", "taken by friction"),
    "loss_settling": ("J", "lost when settled arms are locked again"),
    "loss_air": ("J", "taken by the air; negative where wind gives"),
    "ledger_residual": ("", "unaccounted for, as a share of the largest of the energies"),
}  # fmt: skip


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def _ratio(speed: float, touch_speed: float, happened: bool) -> float | None:
    return abs(speed) / abs(touch_speed) if happened and touch_speed else None


def measures_of(flown: Flown) -> dict[str, float | None]:
    """Every measure of a flight, in the order of `MEASURES`; None for what did not happen."""
    m, work, before, after = flown.record, flown.motion.work, flown.before, flown.after
    ground_level = before.gravity
    start = before.total - ground_level
    end = after.total - ground_level
    losses = work.arm + work.stop + work.contact + work.friction + work.settling + work.air
    fallen = abs(after.gravity - ground_level)
    kinetic = max(before.kinetic, after.kinetic)
    scale = max(kinetic, losses, abs(work.thrust), abs(work.air), fallen)
    left, back = m.separation_time >= 0.0, m.return_time >= 0.0

    def time(value: float) -> float | None:
        return value if value >= 0.0 else None

    values: dict[str, float | None] = {
        "restitution_at_separation": _ratio(m.separation_speed, m.touch_speed, left),
        "restitution_at_return": _ratio(m.return_speed, m.touch_speed, back),
        "restitution_of_mass_centre": _ratio(
            m.separation_mass_centre_speed, m.touch_mass_centre_speed, left
        ),
        "touch_time": time(m.touch_time),
        "touch_speed": m.touch_speed if m.touch_time >= 0.0 else None,
        "separation_time": time(m.separation_time),
        "return_time": time(m.return_time),
        "contact_time": m.separation_time - m.touch_time if left else None,
        "time_to_return": m.return_time - m.touch_time if back else None,
        "contact_duration": m.contact_duration,
        "peak_acceleration": m.peak_acceleration,
        "peak_acceleration_time": m.peak_acceleration_time,
        "peak_specific_force": m.peak_specific_force,
        "peak_angular_rate": m.peak_angular_rate,
        "peak_normal_force": m.peak_normal_force,
        "penetration": m.peak_penetration,
        "arm_stroke": m.peak_compression,
        "arm_extension": m.peak_extension,
        "travel": m.travel,
        "impulse_x": work.impulse.x,
        "impulse_y": work.impulse.y,
        "impulse_z": work.impulse.z,
        "contacts": m.contacts,
        "impacts": m.impacts,
        "bottomed_time": time(m.bottomed_time),
        "ground_time": time(m.ground_time),
        "end_time": m.time,
        "steps": m.steps,
        "energy_start": start,
        "energy_end": end,
        "energy_kinetic": after.kinetic,
        "energy_gravity": after.gravity - ground_level,
        "energy_springs": after.springs,
        "energy_stops": after.stops,
        "energy_contact": after.contact,
        "work_thrust": work.thrust,
        "loss_arm": work.arm,
        "loss_stop": work.stop,
        "loss_contact": work.contact,
        "loss_friction": work.friction,
        "loss_settling": work.settling,
        "loss_air": work.air,
        "ledger_residual": (end - start - work.thrust + losses) / scale if scale > 0.0 else 0.0,
    }
    return {name: None if value is None else _finite(value) for name, value in values.items()}
