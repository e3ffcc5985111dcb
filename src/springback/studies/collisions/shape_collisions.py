"""Study of characterisation at other shapes than the paper's wall: poles, edges, balls, slopes.

Robots cruise into a shape that stands where the wall was, with the scatter of the trials, offset
sideways and in height by chance.  What they then say of its normal and of the contact point is held
against the truth, in three dimensions: the impulse of all normal forces from the touch to the end
of the observation window, and where it acted.  Where two cages touch at once, as on a pole between
two arms, its direction lies between both normals, which is where there is free space.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import BodyMotion, contact_faces, obstacles_in_body_frame
from springback.contact.loads import face_contact
from springback.kernels.vectors import Quat, Vec, rotation
from springback.progress import Progress, silent
from springback.random_streams import Purpose, stream
from springback.recovery.state_machine import LOOK
from springback.studies.detection import (
    Approach,
    ReadyTrial,
    approach_tables,
    fly_ready_trial,
)
from springback.studies.run_ups import ROBOTS, StudyVehicle, study_vehicles
from springback.vehicle.state import ArmPose, PartMemory, arm_pose

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Speeds at contact [m/s].
SPEEDS = (1.0, 2.0, 3.5)
#: Height at which the robots fly [m].
HEIGHT = 1.0
#: Offsets of a shape sideways, and of those of finite height upwards [m], even within these.
ASIDE, ABOVE = 0.12, 0.08
#: Instants at which the true contacts are looked at (chosen), and the share of the impulse that a
#: part must have to have taken part.
INSTANTS, TOOK_PART = 8, 0.1
#: Ways that can tell a normal, as in `springback.recovery.characterisation`.
SOURCES = ("arms", "wrench", "fused")


def _wall(x: float, y: float, z: float, lean: float = 0.0) -> dict[str, Any]:
    normal = [-math.cos(lean), 0.0, math.sin(lean)]
    return {"type": "wall", "position": [x, y, HEIGHT], "normal": normal}


def _pole(x: float, y: float, z: float, radius: float, axis: Sequence[float]) -> dict[str, Any]:
    place = [x + radius, y, HEIGHT]
    return {"type": "pole", "position": place, "radius": radius, "axis": list(axis)}


def _edge(x: float, y: float, z: float, roll: float) -> dict[str, Any]:
    return {"type": "edge", "position": [x, y, HEIGHT + z], "roll": roll, "edge_radius": 0.005}


def _ball(x: float, y: float, z: float, radius: float) -> dict[str, Any]:
    return {"type": "sphere", "position": [x + radius, y, HEIGHT + z], "radius": radius}


UPRIGHT, QUARTER = (0.0, 0.0, 1.0), 0.5 * math.pi
#: Shapes by name: their tables, at some x of their nearest point, y and height above `HEIGHT` [m].
SHAPES: dict[str, Callable[[float, float, float], dict[str, Any]]] = {
    "wall": _wall,
    "wall leaning back 20 deg": lambda x, y, z: _wall(x, y, z, math.radians(20.0)),
    "wall leaning over 20 deg": lambda x, y, z: _wall(x, y, z, math.radians(-20.0)),
    "pole, radius 0.10 m": lambda x, y, z: _pole(x, y, z, 0.10, UPRIGHT),
    "pole, radius 0.03 m": lambda x, y, z: _pole(x, y, z, 0.03, UPRIGHT),
    "pole, 30 deg sideways": lambda x, y, z: _pole(x, y, z, 0.05, (0.0, 0.5, math.sqrt(0.75))),
    "upright edge": lambda x, y, z: _edge(x, y, z, 0.0),
    "level edge": lambda x, y, z: _edge(x, y, z, QUARTER),
    "ball, radius 0.3 m": lambda x, y, z: _ball(x, y, z, 0.3),
}


class ShapeCollision(NamedTuple):
    """One collision with a shape, and what the robot said of it."""

    robot: str
    shape: str
    speed: float  # at contact [m/s]
    level: bool  # the robot takes obstacles for upright
    touched: bool
    noticed: bool
    directions: dict[str, float]  # angle from the true normal by source [rad]; NaN if it says none
    used: float  # angle from the true normal to the direction in use [rad]
    contact_point: float  # error of the contact point, from the main body [m]
    arms: int  # that took part
    body: bool  # the main body took part


def shape_tables(
    shape: str, approach: Approach, vehicle: StudyVehicle, seed: int, level: bool
) -> dict[str, Any]:
    """The scenario of a collision with a shape in place of the paper's wall."""
    tables = approach_tables(
        approach, vehicle, seed, {"recovery": {"characterisation": {"level": level}}}
    )
    wall, ground = tables["world"]["obstacles"]
    number = (list(SHAPES).index(shape), round(1e3 * approach.speed), approach.trial)
    chance = stream(seed, Purpose.SCATTER, *number)
    y, z = chance.uniform(-ASIDE, ASIDE), chance.uniform(-ABOVE, ABOVE)
    one = SHAPES[shape](float(wall["position"][0]), float(y), float(z))
    obstacles = [{**one, "surface": wall["surface"]}, ground]
    return tables | {"world": {**tables["world"], "obstacles": obstacles}}


def _angle(a: Array, b: Array) -> float:
    """Angle between two vectors [rad]; NaN if one is zero."""
    if min(np.linalg.norm(a), np.linalg.norm(b)) < 1e-9:
        return math.nan
    return math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b))


class NormalImpulse(NamedTuple):
    """Impulse of all normal forces of a collision, without friction."""

    direction: Array  # from robot to obstacle, world
    lever: Array  # mean place at which it acts, from the main body, world [m]
    arms: int  # that took part
    body: bool  # the main body took part


def normal_impulse(ready: ReadyTrial, guided: Any, begin: float, end: float) -> NormalImpulse:
    """True impulse of the normal forces between two times, from the contacts at `INSTANTS` of them.

    Args:
        ready: The flight.
        guided: What was flown, with its trajectory.
        begin: Time [s].
        end: Time [s].
    """
    trace, model = guided.flown.trace, ready.model
    t: Array = np.asarray(trace["time"])
    there = np.flatnonzero((t >= begin) & (t <= end))
    push, moment = np.zeros(3), np.zeros(3)
    cages, bodies, total = np.zeros(len(model.airframe.arms)), 0.0, 0.0
    for row in there[np.linspace(0, len(there) - 1, min(INSTANTS, len(there))).astype(int)]:
        for part, force, at, inward in _contacts_at(model, trace, int(row)):
            push, moment, total = push + force * inward, moment + force * at, total + force
            if part < len(cages):
                cages[part] += force
            else:
                bodies += force
    if total == 0.0:
        nothing = np.full(3, math.nan)
        return NormalImpulse(nothing, nothing, 0, False)
    took = TOOK_PART * total
    return NormalImpulse(
        push / np.linalg.norm(push), moment / total, int((cages > took).sum()), bodies > took
    )


def _contacts_at(model: Any, trace: Any, row: int) -> Iterator[tuple[int, float, Array, Array]]:
    """Part, normal force, place from the main body and normal of each contact; world axes."""
    attitude = Quat(*(float(trace[f"state.attitude.{axis}"][row]) for axis in "wxyz"))
    place = Vec(*(float(trace[f"state.position.{axis}"][row]) for axis in "xyz"))
    none, r = Vec(0.0, 0.0, 0.0), rotation(attitude)
    around = obstacles_in_body_frame(model.world.obstacles, place, r)
    still = BodyMotion(place, r, none, none, none, 0.0)
    parts: list[tuple[Any, float, ArmPose]] = []
    for j, arm in enumerate(model.airframe.arms):
        length = float(trace[f"state.arm_length.{j + 1}"][row])
        pose = arm_pose(arm, length, 0.0, none)
        parts.append((model.contact_point, arm.cage_radius, pose))
    parts += [(hull, hull.radius, ArmPose(none, hull.centre, none)) for hull in model.airframe.hull]
    for k, (part, radius, pose) in enumerate(parts):
        for face in contact_faces(around, part, radius, pose, 1.0):
            met = face_contact(face, 1.0, PartMemory((), (), (), ()), pose, still)
            if met.touch.normal > 0.0:
                at, inward = np.array(r @ met.pressing_at), np.array(r @ met.inward)
                yield k, met.touch.normal, at, inward


def fly_shape_collision(
    shape: str, approach: Approach, vehicle: StudyVehicle, seed: int, level: bool
) -> ShapeCollision:
    """Fly one collision with a shape."""
    ready, guided = fly_ready_trial(shape_tables(shape, approach, vehicle, seed, level))
    touch, telemetry = guided.flown.record.first_impact.touch_time, guided.telemetry
    assert telemetry is not None  # every flight of the study keeps one
    looking = np.flatnonzero(telemetry["pilot.phase"] == LOOK)
    words = (approach.robot, shape, approach.speed, level)
    if touch < 0.0 or not len(looking):
        nothing = dict.fromkeys(SOURCES, math.nan)
        return ShapeCollision(*words, touch >= 0.0, False, nothing, math.nan, math.nan, 0, False)
    hit, over = guided.onboard.pilot.collision, float(telemetry["time"][looking[-1]])
    true = normal_impulse(ready, guided, touch, over)
    said = {
        name: _angle(np.array(way), true.direction)
        for name, way in zip(SOURCES, (hit.by_arms, hit.by_wrench, hit.by_fusion), strict=True)
    }
    off = np.array(hit.contact_point) - np.array(hit.position) - true.lever
    return ShapeCollision(
        *words, True, True, said, _angle(np.array(hit.direction), true.direction),
        float(np.linalg.norm(off)), true.arms, true.body,
    )  # fmt: skip


class ShapeErrors(NamedTuple):
    """Errors of all collisions of one robot with one shape: medians and 95 % quantiles."""

    robot: str
    shape: str
    level: bool
    hits: int
    missed: int  # that the robot did not notice
    body: int  # in which the main body took part
    wrench: tuple[float, float]  # angle from the true normal [deg]
    fused: tuple[float, float]
    used: tuple[float, float]
    contact_point: tuple[float, float]  # [m]

    def as_dict(self) -> dict[str, Any]:
        """One row of a table."""
        row: dict[str, Any] = {
            "robot": self.robot, "shape": self.shape, "taken for upright": self.level,
            "hits": self.hits, "missed": self.missed, "with the main body": self.body,
        }  # fmt: skip
        for name, unit in (
            ("wrench", "deg"),
            ("fused", "deg"),
            ("used", "deg"),
            ("contact_point", "m"),
        ):
            row[f"{name} median [{unit}]"], row[f"{name} 95 % [{unit}]"] = getattr(self, name)
        return row


def shape_errors(hits: Sequence[ShapeCollision]) -> list[ShapeErrors]:
    """Errors of each robot with each shape, in the order of the hits."""
    cases = dict.fromkeys((one.robot, one.shape, one.level) for one in hits)
    found = []
    for case in cases:
        mine = [one for one in hits if (one.robot, one.shape, one.level) == case and one.touched]
        angles = {name: [math.degrees(one.directions[name]) for one in mine] for name in SOURCES}
        used = [math.degrees(one.used) for one in mine]
        found.append(
            ShapeErrors(
                *case, len(mine), sum(not one.noticed for one in mine),
                sum(one.body for one in mine), _spread(angles["wrench"]),
                _spread(angles["fused"]), _spread(used),
                _spread([one.contact_point for one in mine]),
            )
        )  # fmt: skip
    return found


def _spread(values: Sequence[float]) -> tuple[float, float]:
    known = np.array([value for value in values if not math.isnan(value)])
    if not len(known):
        return math.nan, math.nan
    return float(np.median(known)), float(np.quantile(known, 0.95))


def shape_collisions(
    flights: int = 10,
    *,
    robots: Sequence[str] = ROBOTS,
    shapes: Sequence[str] = tuple(SHAPES),
    speeds: Sequence[float] = SPEEDS,
    seed: int = 0,
    progress: Progress = silent,
) -> list[ShapeCollision]:
    """Fly all collisions, by robots that take obstacles for upright and by others that do not.

    Args:
        flights: Of each robot, shape and speed.
        robots: Presets, and files with a vehicle.
        shapes: Names in `SHAPES`.
        speeds: At contact [m/s].
        seed: Of all random draws.
        progress: Called with the fraction done.

    Raises:
        InputError: If a robot is invalid.
    """
    vehicles = study_vehicles(robots)
    asked = list(product(vehicles, shapes, (True, False), speeds, range(flights)))
    found = []
    for k, (vehicle, shape, level, speed, trial) in enumerate(asked):
        approach = Approach(vehicle.name, speed, 0.0, 0.0, trial)
        found.append(fly_shape_collision(shape, approach, vehicle, seed, level))
        progress((k + 1) / len(asked))
    return found


def shape_sentences(rows: Sequence[ShapeErrors]) -> list[str]:
    """The result in words: a line for each robot, shape and setting."""
    return [
        f"{row.robot}, {row.shape}, {'taken for upright' if row.level else 'of any inclination'}: "
        f"direction in use {row.used[0]:.1f} deg off by the median, {row.used[1]:.1f} deg at 95 %, "
        f"contact point {1e3 * row.contact_point[0]:.0f} mm and "
        f"{1e3 * row.contact_point[1]:.0f} mm; {row.missed} of {row.hits} not noticed"
        for row in rows
    ]
