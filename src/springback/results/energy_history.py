"""Energy balance over time: stored, supplied and lost energy at every instant.

Its balance at the end of a flight is in `springback.dynamics.ledger`; this is its history.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from springback.errors import InputError
from springback.results.flight import Flight, fly
from springback.results.pair.contacts import pair_view
from springback.scenario.scenario import Scenario
from springback.simulation.measuring.record import Model
from springback.simulation.playback import load_history
from springback.vehicle.arms.bent import ON_JOINTS
from springback.vehicle.state import Airframe, Arm, Shell

Array = np.ndarray[Any, np.dtype[np.float64]]
Columns = dict[str, Array]

#: Columns of a ledger besides time: stored, then supplied, then lost energy [J].  They are named
#: after the measures of their final values.
HELD = (
    "energy_kinetic", "energy_gravity", "energy_springs", "energy_stops", "energy_obstacles",
    "energy_contact",
)  # fmt: skip
SUPPLIED = ("work_thrust", "work_driven")
LOST = (
    "loss_arm", "loss_contact", "loss_friction", "loss_stop", "loss_settling", "loss_air",
    "loss_obstacles",
)  # fmt: skip
#: Losses of the vehicle itself are recorded under their own names.
_OF_OBSTACLES = "loss_obstacles"


def ledger(flight: Flight | Scenario) -> dict[str, Array]:
    """Energy ledger of a flight, instant by instant.

    Args:
        flight: Flight as flown.  One read from a folder has no record of its work: it is flown
            again, to the same bits, as is a scenario; then without a pilot or obstacles of the
            user's own.

    Returns:
        Columns of shape (instants,): ``t`` [s], the same as of the trajectory; stored energy
        (`HELD`, gravity and obstacles above the start), that supplied by rotors and by what drives
        obstacles (`SUPPLIED`), and that lost (`LOST`), all in J since the start.
        Of two vehicles each is driven by the other; what their contact stores is the first one's.

    Raises:
        InputError: For a second vehicle that was read from a folder.
    """
    if isinstance(flight, Scenario):
        flight = fly(flight)
    elif not flight.work and flight.is_second:
        raise InputError("the work of a second vehicle is not in a folder: fly both again")
    elif not flight.work:
        flight = fly(flight.scenario)
    work, model, trace = flight.work, flight.scenario.flight_model(flight.own), flight.columns
    if flight.second is not None:
        seen = pair_view(flight.scenario, flight.columns, flight.second.columns)
        model, trace = seen.model, seen.columns
    bodies = [k for k in range(1, len(work)) if f"bodies.{k}.driven" in work]
    columns = {"t": flight.t, "work_thrust": work["thrust"]}
    columns |= {name: work[name.removeprefix("loss_")] for name in LOST if name != _OF_OBSTACLES}
    columns["work_driven"] = _all_together(work, [f"bodies.{k}.driven" for k in bodies])
    of_obstacles = [f"bodies.{k}.{x}" for k in bodies for x in ("joint", "contact", "friction")]
    columns[_OF_OBSTACLES] = _all_together(work, of_obstacles)
    airframe = model.airframe
    kinds = (*ON_JOINTS, Shell)
    turning = any(isinstance(part, kinds) for part in airframe.arms + airframe.hull)
    if bodies or turning:
        columns |= _evaluated(model, trace)
    else:
        columns |= _stored_energy(airframe, model.world.gravity, trace)
        columns["energy_obstacles"] = np.zeros(len(flight.t))
        columns["energy_contact"] = _remainder(columns, work)
    return {name: columns[name] for name in ("t", *HELD, *SUPPLIED, *LOST)}


def _all_together(work: Columns, names: list[str]) -> Array:
    return sum((work[name] for name in names), np.zeros(len(work["thrust"])))


def _evaluated(model: Model, c: Columns) -> Columns:
    """Stored energies evaluated again by the kernels of the flight."""
    held = load_history(model, c, np.arange(len(c["t"]))).energy
    found = {f"energy_{name}": column for name, column in held.items()}
    for name in ("energy_gravity", "energy_obstacles"):
        found[name] = found[name] - found[name][0]
    return found


def _remainder(columns: Columns, work: Columns) -> Array:
    """Contact energy: what is left, as the ledger closes (tests/results/test_energy_history.py)."""
    known = sum(columns[name] for name in HELD[:-1]) + sum(columns[name] for name in LOST)
    before = sum(float(columns[name][0]) for name in HELD[:-1])  # flights start without contact
    rest = np.maximum(before + columns["work_thrust"] - known, 0.0)
    return np.where(work["touching"] > 0.0, rest, 0.0)


def _stored_energy(airframe: Airframe, gravity: float, c: Columns) -> dict[str, Array]:
    """Kinetic energy, height, springs and stops: `springback.dynamics.energy.energy` in columns.

    For arms that slide in the body plane.
    """
    velocity, spin, r = _vectors(c, "v"), _vectors(c, "w"), _rotations(c)
    body_mass = airframe.mass - sum(arm.mass for arm in airframe.arms)
    inertia = np.array(airframe.inertia)
    held = {
        "energy_kinetic": 0.5 * body_mass * np.sum(velocity**2, axis=1)
        + 0.5 * np.einsum("ti,ij,tj->t", spin, inertia, spin),
        "energy_gravity": body_mass * gravity * c["z"],
        "energy_springs": np.zeros(len(velocity)),
        "energy_stops": np.zeros(len(velocity)),
    }
    for j, arm in enumerate(airframe.arms, start=1):
        length, rate = c[f"l{j}"], c[f"dl{j}"]
        e = np.array([arm.cosine, arm.sine, 0.0])
        lever = length[:, None] * e
        moving = np.einsum("tji,tj->ti", r, velocity) + rate[:, None] * e + np.cross(spin, lever)
        height = c["z"] + np.einsum("ti,ti->t", r[:, 2], lever)
        held["energy_kinetic"] = held["energy_kinetic"] + 0.5 * arm.mass * np.sum(moving**2, axis=1)
        held["energy_gravity"] = held["energy_gravity"] + arm.mass * gravity * height
        held["energy_springs"] = held["energy_springs"] + _half_square(arm.stiffness, arm, length)
        held["energy_stops"] = held["energy_stops"] + _in_stops(arm, length)
    held["energy_gravity"] = held["energy_gravity"] - held["energy_gravity"][0]
    return held


def _half_square(stiffness: float, arm: Arm, length: Array) -> Array:
    """Energy ½ k (L − l)² of a sliding arm [J]."""
    energy: Array = 0.5 * arm.compliance * stiffness * (arm.length - length) ** 2
    return energy


def _in_stops(arm: Arm, length: Array) -> Array:
    """Energy ½ k (beyond either stop)² of a sliding arm [J]."""
    inner, outer = np.maximum(arm.shortest - length, 0.0), np.maximum(length - arm.length, 0.0)
    energy: Array = 0.5 * arm.compliance * arm.stop_stiffness * (inner**2 + outer**2)
    return energy


def _vectors(c: Columns, stem: str) -> Array:
    """Vectors of shape (instants, 3)."""
    return np.stack([c[f"{stem}{axis}"] for axis in "xyz"], axis=1)


def _rotations(c: Columns) -> Array:
    """Rotations from body to world, shape (instants, 3, 3)."""
    w, x, y, z = (c[f"q{part}"] for part in "wxyz")
    rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)
