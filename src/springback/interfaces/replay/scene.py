"""A flight as a scene: all data that the page, films and the lab need to draw it.

`scene_of` makes a `Scene` from a flight, and `plain` converts it to a dictionary for JSON, in which

- tuples and texts are unchanged, and fields of NamedTuples and dataclasses are keyed by name;
- an array is ``{"type": "f4", "shape": [...], "data": base64}``, little-endian in C order;
  ``f8`` for instants, ``i4`` for triangles, else ``f4``;
- ``force`` and ``point``, mostly empty, are ``{"at": places, "of": their rows}``: the rows of those
  instants, all others being zero.

All data are in SI units, radians, world axes NWU, body axes FLU, quaternions wxyz body to world.
Instants are not evenly spaced: all integration steps near contacts, few elsewhere.  Values between
instants are interpolated linearly; ``departure`` has the largest error of this.
"""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, is_dataclass
from typing import Any, NamedTuple

import numpy as np

from springback.contact.worlds import Own
from springback.dynamics.motion import Slider
from springback.errors import InputError
from springback.interfaces.output.robots import robot_label
from springback.interfaces.replay.arm_shapes import ArmShape as ArmShape
from springback.interfaces.replay.arm_shapes import JointShape as JointShape
from springback.interfaces.replay.arm_shapes import LatchShape as LatchShape
from springback.interfaces.replay.arm_shapes import arm_shapes as arm_shapes
from springback.interfaces.replay.geometry import Drawable, drawables
from springback.interfaces.replay.hull_meshes import HullMesh, hull_meshes, mesh_of_hull
from springback.interfaces.replay.instants import departure, drawn_instants
from springback.interfaces.replay.tracks import BodyTrack, body_tracks
from springback.results.contacts.spans import parts_of
from springback.results.contacts.stored import stored_loads
from springback.results.events import Event, impacts_of
from springback.results.flight import Flight
from springback.results.pair.contacts import loads_on_first, loads_on_second
from springback.results.result import NAMED
from springback.results.saved import load as load
from springback.simulation.measuring.record import Model
from springback.simulation.playback import LoadHistory, load_history
from springback.vehicle.arms.bent import ON_JOINTS
from springback.vehicle.arms.neighbours import NeighbourSprings
from springback.vehicle.hulls import SphereHull
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Energies that change by less than this fraction of the largest change are not plotted (chosen).
SEEN = 1e-4
#: Recomputed forces may differ from the columns by this fraction of the peak (chosen: rounding).
AGREES = 1e-6


#: Radius of the disc of a rotor where its propeller is unknown, of that of its cage (chosen).
BLADES = 0.62


class NeighbourShape(NamedTuple):
    """Spring between the ends of two arms."""

    first: int  # number of the arm, from 0
    second: int
    distance: float  # between the ends where it is free [m]


class RotorShape(NamedTuple):
    """A rotor, on the main body or at the end of an arm."""

    arm: int  # its arm, from 0; -1 for the main body
    offset: tuple[float, ...]  # of its middle from what it is on [m]
    axis: tuple[float, ...]  # unit vector of its thrust, in the axes of what it is on
    level: bool  # True: its axis does not turn with the arm
    spin: int  # sign of the torque about the axis
    radius: float  # of its disc [m]
    listed: bool  # True: its vehicle lists it, so that it may be anywhere


class HullShape(NamedTuple):
    """What the main body touches with: a sphere, or hulls of other kinds."""

    centre: tuple[float, float, float]  # from the main body, body axes [m]
    radius: float  # [m]; that of a sphere around all
    meshes: tuple[HullMesh, ...] = ()  # of each hull; empty for a sphere alone


class Series(NamedTuple):
    """A curve over the instants."""

    panel: str  # heading of the plot
    name: str  # label in the panel
    unit: str
    values: Array  # shape (instants,)


@dataclass(frozen=True, eq=False)
class Scene:
    """A flight to be drawn."""

    label: str
    """Name of the robot, or the caller's label."""
    scenario: str
    """Name of the scenario."""
    outcome: str
    """One word."""
    sentence: str
    """The outcome in a sentence."""
    success: bool
    """True if it recovered or, without a pilot, left the obstacle."""
    arms: tuple[ArmShape, ...]
    rotors: tuple[RotorShape, ...]
    hull: tuple[HullShape, ...]
    """Hull of the main body; empty without one."""
    max_thrust: float
    """Maximum thrust of one rotor, for scales [N]."""
    guide: tuple[float, ...]
    """Axis of a slider, unit vector, world; empty in free flight."""
    obstacles: tuple[Drawable, ...]
    t: Array
    """Instants [s], shape (n,)."""
    position: Array
    """Position of the main body, world [m], shape (n, 3)."""
    attitude: Array
    """Quaternion wxyz, body to world, shape (n, 4)."""
    arm_length: Array
    """Arm lengths [m], shape (n, arms)."""
    thrust: Array
    """Rotor thrusts [N], shape (n, rotors), from the telemetry, constant between ticks."""
    force: Array
    """Force of each contact, world [N], shape (n, contacts, 3)."""
    point: Array
    """Point of application, world [m], shape (n, contacts, 3); zero without contact."""
    part: tuple[int, ...]
    """Of each contact: number of its cage from 0, then of the hull; each has one or more."""
    bodies: tuple[BodyTrack, ...]
    """Tracks of the obstacles that move."""
    series: tuple[Series, ...]
    events: tuple[Event, ...]
    impacts: tuple[tuple[float, float], ...]
    """First touch and last separation of each impact [s]."""
    measures: dict[str, float | None]
    units: dict[str, str]
    """Units of the measures."""
    departure: dict[str, float]
    """Largest error of linear interpolation between instants by quantity, SI units."""
    notes: tuple[str, ...]
    """Remarks on what the picture does not show, in sentences."""
    first_touch: float | None = None
    """Time of the first touch of any vehicle in its world [s]; None: that of its first impact."""
    world: int = 0
    """Number of its world: scenes of one world are drawn in one place."""
    touched: tuple[str, ...] = ()
    """What it touched, a line each."""
    neighbours: tuple[NeighbourShape, ...] = ()
    """Springs between arms."""
    warnings: tuple[str, ...] = ()
    """What may be meant otherwise or is doubtful, in sentences."""
    bends: Array = field(default_factory=lambda: np.zeros((0, 0)))
    """Ways of the second joints of arms [m], shape (n, arms); empty where arms have none."""


def scene_of(flight: Flight, *, label: str = "", own: Sequence[Own] = ()) -> Scene:
    """A flight as a scene; a second vehicle has one of its own, `scene_beside`.

    Args:
        flight: With its trajectory.
        label: Label beside another flight; by default the robot's name.
        own: The user's own obstacles, for a flight read from a file, which contains only their
            meshes.

    Raises:
        InputError: If the flight has no trajectory.
    """
    if not flight.columns:
        raise InputError("this flight has no trajectory: fly it with trajectory=True")
    model = flight.scenario.flight_model(own or flight.own)
    places = drawn_instants(flight.columns, len(model.airframe.arms))
    if flight.second is None:
        loads = load_history(model, flight.columns, places)
    else:
        loads = loads_on_first(flight.scenario, flight.columns, flight.second.columns, places)
    if flight.own_contacts and not own:
        loads = stored_loads(flight, loads, places)
    return _scene(flight, model, loads, places, label, own or flight.own)


def scene_beside(flight: Flight, *, label: str = "") -> Scene:
    """The second vehicle of a flight as a scene.

    Args:
        flight: With a second vehicle, and both trajectories.
        label: Label beside the first; by default the robot's name.
    """
    second = flight.second
    assert second is not None
    model = second.scenario.flight_model()
    places = drawn_instants(second.columns, len(model.airframe.arms))
    loads = loads_on_second(flight.scenario, flight.columns, second.columns, places)
    return _scene(second, model, loads, places, label, ())


def _scene(
    flight: Flight, model: Model, loads: LoadHistory, places: Any, label: str, own: Sequence[Own]
) -> Scene:
    """Scene of a vehicle and its contacts at some instants."""
    c, count = flight.columns, len(model.airframe.arms)
    touches = loads.point[np.isfinite(loads.point).all(axis=2)]
    place = np.stack([c[axis][places] for axis in "xyz"], axis=1)
    tracks = body_tracks(model, c, places)
    entries = flight.scenario.world.obstacles
    things = drawables(entries, own, place, touches, flight.own_surfaces, tracks)
    thrust = _thrust(flight, model, c["t"][places])
    robot = flight.scenario.vehicle.name
    propulsion = flight.scenario.vehicle.propulsion
    named = flight.summary()["units"]
    doubts = () if flight.own_contacts else _doubts(flight, loads, places)
    return Scene(
        label=label or robot_label(robot),
        scenario=flight.scenario.name,
        outcome=flight.outcome.word,
        sentence=flight.message,
        success=flight.success,
        arms=arm_shapes(model.airframe, flight.scenario.vehicle),
        rotors=rotor_shapes(model.airframe, flight.scenario.vehicle),
        hull=hull_shapes(model.airframe, flight.scenario.vehicle),
        max_thrust=propulsion.max_thrust if propulsion else float(thrust.max(initial=1.0)),
        guide=tuple(model.guide.axis) if isinstance(model.guide, Slider) else (),
        obstacles=things.drawables,
        t=c["t"][places],
        position=place,
        attitude=np.stack([c[f"q{part}"][places] for part in "wxyz"], axis=1),
        arm_length=np.stack([c[f"l{j}"][places] for j in range(1, count + 1)], axis=1),
        thrust=thrust,
        force=loads.force,
        point=np.nan_to_num(loads.point, nan=0.0),
        part=loads.part,
        bodies=tracks,
        series=_series(flight, model, loads, thrust, places),
        events=_time_line(flight),
        impacts=impacts_of(flight),
        measures=dict(flight.measures),
        units={name: named[name] for name in flight.measures if name in named},
        departure=departure(c, count, places),
        notes=(*things.notes, *doubts),
        touched=_touched(flight),
        neighbours=neighbour_shapes(model.airframe),
        bends=_bends(c, count, places),
        warnings=flight.warnings,
    )


def _bends(columns: dict[str, Array], count: int, places: Any) -> Array:
    """Ways of the second joints [m], shape (n, arms) or, without, (0, 0)."""
    if "bend1" not in columns:
        return np.zeros((0, 0))
    return np.stack([columns[f"bend{j}"][places] for j in range(1, count + 1)], axis=1)


def hull_shapes(airframe: Airframe, vehicle: Vehicle) -> tuple[HullShape, ...]:
    """Shape of the main body's hull, if it has one."""
    meshes = hull_meshes(vehicle, "body")
    if meshes and vehicle.hull is not None:
        ball = SphereHull(type="sphere", position=vehicle.hull.offset, radius=vehicle.hull.radius)
        meshes = (mesh_of_hull(ball.form()), *meshes)
    return tuple(HullShape((*one.centre,), one.radius, meshes) for one in airframe.hull)


def rotor_shapes(airframe: Airframe, vehicle: Vehicle) -> tuple[RotorShape, ...]:
    """Shapes of the rotors of an airframe: those listed, else one at the end of each arm."""
    level = [isinstance(arm, ON_JOINTS) and not arm.joint.follows > 0.0 for arm in airframe.arms]
    if not airframe.rotors:
        return tuple(
            RotorShape(
                j, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0), level[j],
                1 if arm.torque_ratio > 0.0 else -1, BLADES * arm.cage_radius, False,
            )
            for j, arm in enumerate(airframe.arms)
        )  # fmt: skip
    known = None if vehicle.propulsion is None else vehicle.propulsion.disk_radius
    found = []
    for one in airframe.rotors.each:
        j, q = int(one.arm) - 1, one.axes
        spin, up = 1 if one.torque_ratio > 0.0 else -1, (q.x.z, q.y.z, q.z.z)
        radius = known or BLADES * airframe.arms[max(j, 0)].cage_radius
        still = j >= 0 and level[j]
        found.append(RotorShape(j, (*one.offset,), up, still, spin, radius, True))
    return tuple(found)


def neighbour_shapes(airframe: Airframe) -> tuple[NeighbourShape, ...]:
    """Shapes of the springs between the ends of arms, if there are any."""
    if not isinstance(airframe.neighbours, NeighbourSprings):
        return ()
    count = len(airframe.arms)
    return tuple(
        NeighbourShape(j, (j + 1) % count, spring.distance)
        for j, spring in enumerate(airframe.neighbours.springs)
    )


#: Events of single parts, too many for a time line.
_OF_PARTS = (
    "contact", "release", "stop", "stop_release", "latch_open", "latch_close", "settled",
)  # fmt: skip


def _time_line(flight: Flight) -> tuple[Event, ...]:
    """Events that are drawn, failures marked as trouble."""
    return tuple(
        event._replace(kind="trouble") if event.kind in ("bottomed", "ground") else event
        for event in flight.events
        if event.kind not in _OF_PARTS
    )


def _touched(flight: Flight) -> tuple[str, ...]:
    """Touched obstacles with their hardest contacts, in words."""
    met = flight.obstacle_contacts
    more = (f"and {len(met) - NAMED} more",) if len(met) > NAMED else ()
    return (*(one.text for one in met[:NAMED]), *more)


def _thrust(flight: Flight, model: Model, t: Array) -> Array:
    """Rotor thrusts [N], shape (instants, rotors): those of a pilot, of a table, else constant."""
    known = next(
        (table for table in (flight.telemetry, flight.columns) if "thrust1" in table), None
    )
    if known is None:
        return np.broadcast_to(np.array(model.thrust, dtype=float), (len(t), len(model.thrust)))
    page = np.clip(np.searchsorted(known["t"], t, "right") - 1, 0, None)
    rotors = range(1, len(model.thrust) + 1)
    return np.stack([known[f"thrust{j}"][page] for j in rotors], axis=1)


def _series(
    flight: Flight, model: Model, loads: LoadHistory, thrust: Array, places: Any
) -> tuple[Series, ...]:
    """Curves over time."""
    c = {name: values[places] for name, values in flight.columns.items()}
    arms = list(enumerate(model.airframe.arms, start=1))
    speed = np.sqrt(c["vx"] ** 2 + c["vy"] ** 2 + c["vz"] ** 2)
    found = [Series("Velocity", "speed", "m/s", speed)]
    found += [Series("Velocity", f"v{axis}", "m/s", c[f"v{axis}"]) for axis in "xyz"]
    hardness = np.sqrt(c["ax"] ** 2 + c["ay"] ** 2 + c["az"] ** 2)
    found.append(Series("Acceleration", "main body", "m/s²", hardness))
    found += [
        Series("Arm compression", f"arm {j}", "mm", 1e3 * (arm.length - c[f"l{j}"]))
        for j, arm in arms
        if arm.compliance > 0.0
    ]
    found += [
        Series("Arm compression", f"arm {j}, second joint", "mm", -1e3 * c[f"bend{j}"])
        for j, arm in arms
        if arm.compliance > 0.0 and f"bend{j}" in c
    ]
    for j, _ in arms:
        whole = np.sqrt(c[f"fn{j}"] ** 2 + c[f"ff{j}"] ** 2)
        guard = flight.scenario.vehicle.guard_word
        found.append(Series("Contact force", f"{guard} {j}", "N", whole))
    if np.any(c.get("fn_body", np.zeros(1)) > 0.0):
        whole = np.sqrt(c["fn_body"] ** 2 + c["ff_body"] ** 2)
        found.append(Series("Contact force", "main body", "N", whole))
    stored = dict(loads.energy)
    for name in ("gravity", "obstacles"):
        stored[name] = stored[name] - stored[name][0]
    words = {"kinetic": "motion", "springs": "arm springs", "stops": "end stops",
             "contact": "contacts", "gravity": "height", "obstacles": "obstacles"}  # fmt: skip
    moves = {name: float(np.ptp(stored[name])) for name in words}
    found += [
        Series("Energy", word, "J", stored[name])
        for name, word in words.items()
        if moves[name] > SEEN * max(moves.values())
    ]
    rotors = range(1, thrust.shape[1] + 1)
    found += [Series("Thrust", f"rotor {j}", "N", thrust[:, j - 1]) for j in rotors]
    return tuple(found)


def _doubts(flight: Flight, loads: LoadHistory, places: Any) -> tuple[str, ...]:
    """Remark if the drawn contact forces differ from those of the trajectory."""
    parts = parts_of(flight.columns)
    columns = [np.stack([flight.columns[f"{kind}{part}"][places] for part in parts], axis=1)
               for kind in ("fn", "ff")]  # fmt: skip
    peak = max(float(columns[0].max()), float(columns[1].max()), 1.0)
    off = max(
        float(np.abs(loads.normal - columns[0]).max()),
        float(np.abs(loads.friction - columns[1]).max()),
    )
    if off <= AGREES * peak:
        return ()
    return (
        f"some contact forces, up to {off:.3g} N, come from obstacles of your own, which this "
        "older result does not hold: they are missing in the sum, and not drawn as arrows; fly it "
        "again",
    )


# -- as JSON --------------------------------------------------------------------------------------


def plain(scene: Scene) -> dict[str, Any]:
    """Scene as plain data for JSON, in the format of the module's docstring."""
    data = {field.name: _plain(getattr(scene, field.name)) for field in fields(scene)}
    data["t"] = _pack(scene.t, "f8")
    at = np.flatnonzero(np.abs(scene.force).max(axis=(1, 2)) > 0.0)
    for name in ("force", "point"):
        rows = getattr(scene, name)[at]
        data[name] = {"at": _pack(at, "i4"), "of": _pack(rows, "f4")}
    return data


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return _pack(value, "i4" if value.dtype.kind in "iu" else "f4")
    if is_dataclass(value):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        return {name: _plain(getattr(value, name)) for name in value._fields}
    if isinstance(value, tuple | list):
        return [_plain(entry) for entry in value]
    if isinstance(value, dict):
        return {name: _plain(entry) for name, entry in value.items()}
    return value


def _pack(values: Any, kind: str) -> dict[str, Any]:
    """Array as type, shape and base64 text of its numbers."""
    data = np.ascontiguousarray(values, dtype=f"<{kind}")
    text = base64.b64encode(data.tobytes()).decode("ascii")
    return {"type": kind, "shape": list(data.shape), "data": text}
