"""The obstacle that a vehicle meets first if it flies straight on, and how it meets it.

The way is that of the velocity at the start, or of a run-up; gravity, thrust and the motion of
obstacles are left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from springback.contact.obstacles import Plane, signed_distance
from springback.contact.parameters import Ground, Mat, SurfaceSettings, Wall, faces
from springback.contact.scene.faces import SolidScene
from springback.contact.scene.nearest import distance_of
from springback.contact.worlds import obstacles, surfaces_of
from springback.control.position import heading
from springback.control.reference_parameters import RunUpSettings
from springback.kernels.routines import routines_compiled
from springback.kernels.vectors import Quat, Vec, norm, quaternion_of, rotation
from springback.results.contacts.places import gaps_in
from springback.scenario.tables import ScenarioTables, UserShape
from springback.scenario.user.obstacles import own_obstacles
from springback.scenario.worlds.imported import (
    Imported,
    obstacle_words,
    part_words,
    single_obstacles,
)
from springback.vehicle.parameters import Vehicle

#: Longest way that is looked along [m], and most places on it (chosen).
FARTHEST, MOST_LOOKS = 100.0, 400
#: A gap so small is a touch [m], and the step past what is touched and not approached [m] (chosen).
TOUCHING, PAST = 1e-6, 0.02
#: Least cosine between the way and the direction into an obstacle that it meets (chosen: 3 deg from
#: parallel, so that the ground below a start near it is none).
LEAST_CLOSING = 0.05
#: Half the step of the differences that normals are taken from [m] (chosen).
STEP = 1e-6
#: Most points of a hull that are looked at one by one, not as a ball around them (chosen).
MOST_POINTS = 8


class ObstacleApproach(NamedTuple):
    """Approach of a vehicle to the first obstacle on its way."""

    obstacle: int
    """Its index in the scenario."""
    words: str
    """It in a sentence; of an imported world its element."""
    way: float
    """Of the main body until then, straight on [m]."""
    place: Vec
    """Where it is met, world [m]."""
    speed: float
    """Into the obstacle, along its normal there [m/s]."""
    arm: int
    """Index of the arm whose cage is foremost."""
    angle: float
    """Between that arm and the direction into the obstacle [rad]."""
    along: float
    """Share of the normal force that presses the arm, if its cage slides inwards."""
    is_level: bool
    """False if it is met from above or below the arms rather than ahead of one: the three numbers
    before mean nothing then."""


class _StraightWay(NamedTuple):
    """A way straight on, without turning."""

    start: Vec
    direction: Vec
    speed: float
    attitude: Quat


class _Ball(NamedTuple):
    """A cage, or a part of a hull."""

    place: Vec  # from the main body, world axes
    radius: float


class _Touch(NamedTuple):
    """The first touch on a way."""

    way: float
    normal: Vec  # out of the obstacle
    place: Vec


def approach_ahead(scenario: ScenarioTables) -> ObstacleApproach | None:
    """Approach to the first obstacle straight on, at the attitude of the start or of a run-up.

    Cages are taken as balls.  Obstacles that move are where they begin.

    Returns:
        None if the vehicle starts at rest, or nothing is on its way.

    Raises:
        InputError: If an obstacle of the user's own cannot be made.
        The problem: If another one cannot.
    """
    way = _way_of(scenario)
    if way is None or not scenario.world.obstacles:
        return None
    balls = _balls(scenario.vehicle, way.attitude)
    found: tuple[int, _Touch] | None = None
    for k, shapes in enumerate(_shapes(scenario)):
        nearer = FARTHEST if found is None else found[1].way
        for shape in shapes:
            touch = _first_touch(shape, way, balls, nearer)
            if touch is not None:
                found, nearer = (k, touch), touch.way
    return None if found is None else _approach(scenario, way, *found)


def _way_of(scenario: ScenarioTables) -> _StraightWay | None:
    start, reference = scenario.start, scenario.reference
    if isinstance(reference, RunUpSettings):
        tilt = Vec(math.sin(reference.pitch), 0.0, math.cos(reference.pitch))
        attitude = quaternion_of(heading(tilt, reference.yaw).axes)
        return _StraightWay(Vec(*reference.start), Vec(1.0, 0.0, 0.0), reference.speed, attitude)
    velocity = Vec(*start.velocity)
    speed = float(norm(velocity))
    if not speed > 0.0:
        return None
    return _StraightWay(start.place(), velocity * (1.0 / speed), speed, start.attitude())


def _balls(vehicle: Vehicle, attitude: Quat) -> list[_Ball]:
    """Cages and hulls, turned as the vehicle is."""
    turn, arms = rotation(attitude), vehicle.arms
    ends = [Vec(*arms.place(j, 0.0)) for j in range(vehicle.arm_count)]
    found = [_Ball(turn @ end, arms.at("cage_radius", j)) for j, end in enumerate(ends)]
    if vehicle.hull is not None:
        found.append(_Ball(turn @ Vec(*vehicle.hull.offset), vehicle.hull.radius))
    for one in vehicle.hulls:
        form = one.form()
        middle = Vec(0.0, 0.0, 0.0) if isinstance(one.on, str) else ends[one.on - 1]
        few = 0 < len(form.points) <= MOST_POINTS
        points, radius = (form.points, form.radius) if few else ([form.middle()], form.around())
        found += [_Ball(turn @ (middle + Vec(*map(float, point))), radius) for point in points]
    return found


def _shapes(scenario: ScenarioTables) -> Iterator[list[Any]]:
    """Planes, shapes and scenes of each obstacle of a world, at rest."""
    own = iter(own_obstacles(scenario.world))
    for entry in scenario.world.obstacles:
        if isinstance(entry, UserShape):
            yield [next(own)[0]]
            continue
        singles = [_at_rest(one) for one in single_obstacles([entry])]
        planes = [one for one in singles if isinstance(one, Wall | Mat | Ground)]
        others = [one for one in singles if not isinstance(one, Wall | Mat | Ground)]
        found: list[Any] = [faces(one)[0][0] for one in planes]
        yield [*found, obstacles(others, as_scene=True)] if others else found


def _at_rest(entry: Any) -> Any:
    moves = getattr(entry, "motion", None) is not None
    return entry.model_copy(update={"motion": None}) if moves else entry


def _distance(shape: Any, point: Vec) -> float:
    known = hasattr(shape, "table")  # a scene
    return float(distance_of(shape, point) if known else signed_distance(shape, point))


def _normal(shape: Any, point: Vec) -> Vec:
    """Gradient of the distance; zero where it has none."""
    if isinstance(shape, Plane):
        return shape.normal
    steps = [Vec(*row) for row in (STEP * np.eye(3)).tolist()]
    slope = Vec(*(_distance(shape, point + s) - _distance(shape, point - s) for s in steps))
    size = float(norm(slope))
    return slope * (1.0 / size) if size > STEP else Vec(0.0, 0.0, 0.0)


def _first_touch(shape: Any, way: _StraightWay, balls: list[_Ball], nearer: float) -> _Touch | None:
    """First touch of a ball that approaches a shape, nearer than a way [m]; None without one."""
    if isinstance(shape, Plane) and -(way.direction @ shape.normal) <= LEAST_CLOSING:
        return None
    at = 0.0
    for _ in range(MOST_LOOKS):
        here = way.start + way.direction * at
        gaps = [_distance(shape, here + ball.place) - ball.radius for ball in balls]
        for gap, ball in zip(gaps, balls, strict=True):
            if gap <= TOUCHING:
                normal = _normal(shape, here + ball.place)
                if -(way.direction @ normal) > LEAST_CLOSING:
                    return _Touch(at, normal, here + ball.place - normal * (gap + ball.radius))
        least = min(gaps)
        at += least if least > TOUCHING else PAST
        if not at < nearer:
            break
    return None


def _approach(
    scenario: ScenarioTables, way: _StraightWay, number: int, touch: _Touch
) -> ObstacleApproach:
    words, entry = _touched(scenario, number, touch.place)
    arms = scenario.vehicle.arms
    into = touch.normal * -1.0
    ahead = into @ rotation(way.attitude)  # in body axes
    angles = [math.atan2(ahead.y, ahead.x) - direction for direction in arms.directions]
    reaches = [arms.at("length", j) * math.cos(angle) for j, angle in enumerate(angles)]
    first = max(range(len(reaches)), key=lambda j: reaches[j] + arms.at("cage_radius", j))
    angle = abs(math.remainder(angles[first], math.tau))
    law = _law(entry)
    friction = law.friction if law.friction_axes == "both" else 0.0
    return ObstacleApproach(
        number, words, touch.way, touch.place,
        float(way.speed * (way.direction @ into)), first, angle,
        math.cos(angle) - friction * math.sin(angle), math.hypot(ahead.x, ahead.y) > abs(ahead.z),
    )  # fmt: skip


def _touched(scenario: ScenarioTables, number: int, place: Vec) -> tuple[str, Any]:
    """An obstacle that is touched at a place, in a sentence; of an imported world its element."""
    entry = scenario.world.obstacles[number]
    if not isinstance(entry, Imported):
        return obstacle_words(number, entry), entry
    near = [
        (signed_distance(faces(plane)[0][0], place), one)
        for one in entry.parts
        if isinstance(plane := one.obstacle, Wall | Mat | Ground)
    ]
    solid = [one for one in entry.parts if not isinstance(one.obstacle, Wall | Mat | Ground)]
    if solid:
        scene = obstacles([one.obstacle for one in solid], as_scene=True)
        assert isinstance(scene, SolidScene)
        with routines_compiled():
            near += [(gap, solid[owner]) for gap, owner in gaps_in(scene.table, place)]
    part = min(near, key=lambda pair: pair[0])[1]
    return part_words(number, entry, part), part.obstacle


def _law(entry: Any) -> SurfaceSettings:
    """Surface of an obstacle, of its first part if it has several."""
    law = entry.surface if isinstance(entry, UserShape) else surfaces_of(entry)[0]
    assert isinstance(law, SurfaceSettings)
    return law
