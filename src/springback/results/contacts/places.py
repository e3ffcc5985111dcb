"""Which obstacle a part of a vehicle touches, and where.

A trajectory holds the force on each part; the place of a contact follows from the recorded state,
evaluated in plain Python for the few instants that are asked for, and the obstacle from the place.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import moving_bodies
from springback.contact.moving.bodies import ABSENT, CARRIED, body_pose
from springback.contact.moving.scene import MovingScene
from springback.contact.obstacles import Obstacle, SecondContact, signed_distance
from springback.contact.parameters import Ground, faces
from springback.contact.scene.faces import SolidScene
from springback.contact.scene.nearest import HALF_SPACES, HEADER, nearest_solid
from springback.contact.scene.sections import FARTHEST
from springback.contact.scene.solids import OWNER, WIDTH, solid_face
from springback.contact.shapes import ShapeSettings
from springback.contact.worlds import BuiltIn
from springback.kernels.routines import number_at, routines_compiled
from springback.kernels.trees import rebuilt
from springback.kernels.vectors import Vec
from springback.results.contacts.history import model_of, nearest_impulsive
from springback.results.contacts.jumps import Jump, jumps_of
from springback.results.contacts.spans import ContactSpan, contact_spans, part_name, parts_of
from springback.results.contacts.stored import stored_point
from springback.results.pair.contacts import PairView, pair_view
from springback.results.result import FlightResult, ObstacleContact
from springback.scenario.scenario import Scenario
from springback.scenario.tables import UserShape, WorldSettings
from springback.scenario.user.obstacles import own_names
from springback.scenario.worlds.imported import (
    Imported,
    obstacle_words,
    part_words,
    single_obstacles,
    with_article,
)
from springback.simulation.flight import FlightRecord, model_state
from springback.simulation.measuring.record import FirstImpact, Model
from springback.simulation.playback import NO_FORCE, FaceLoad, Instant, loads_at, states_at

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Contacts beyond this number are not looked at (chosen: these take a second; a robot that rattles
#: has thousands).
MOST = 300


class ContactPlace(NamedTuple):
    """What a part touches at an instant."""

    obstacle: str  # such as "world.obstacles[0], a pole"
    point: tuple[float, float, float] | None  # world [m]; None: another vehicle, known by its force
    is_ground: bool = False  # True for a ground of the scenario


class NamedObstacles(NamedTuple):
    """Names of the obstacles of a scenario, such as "world.obstacles[0], a pole"."""

    at_rest: list[str]  # of springback's own, elements of imported worlds one by one
    planes: list[str]  # of each face of these, if all are plane
    moving: dict[float, str]  # by their number
    own: list[str]  # of the user's own
    other: str  # of another vehicle
    grounds: set[str]  # those that are the ground

    @property
    def only(self) -> str:
        """Name of what can be touched if there is one thing alone, else empty."""
        each = [*self.at_rest, *self.moving.values(), *self.own]
        return each[0] if len(each) == 1 else ""

    def of_first(self, obstacles: Any, first: FirstImpact) -> str:
        """What a flight touched first; empty if it touched nothing.

        Args:
            obstacles: Of its model.
            first: Of its record.
        """
        if first.touch_time < 0.0:
            return ""
        if math.isnan(first.point.x):
            return self.other
        for body, struck in zip(moving_bodies(obstacles), first.struck, strict=True):
            if struck > 0.0:
                return self.other if body.kind == CARRIED else self.moving[body.obstacle]
        near = list(_near_at_rest(obstacles, first.point, self))
        return min(near).name if near else self.other


def _names_of(flight: FlightResult) -> NamedObstacles:
    own = [type(shape).__name__ for shape, _ in flight.own]
    kinds = own or [one.name for one in flight.own_surfaces]
    return obstacle_names(flight.scenario.world, kinds, is_second=flight.is_second)


def obstacle_names(
    world: WorldSettings, kinds: Sequence[str], *, is_second: bool = False
) -> NamedObstacles:
    """Names of the obstacles of a world.

    Args:
        world: Of the scenario.
        kinds: Classes of the user's own obstacles.
        is_second: True for those that the second of two vehicles meets.
    """
    stems = [name.removesuffix(".shape") for name in own_names(world, kinds)]
    given = [one.name for one in world.obstacles if isinstance(one, UserShape)]
    given += [""] * (len(stems) - len(given))
    of_own = [
        f"{stem}, {name or with_article(kind)}"
        for stem, name, kind in zip(stems, given, kinds, strict=True)
    ]
    other = "the first vehicle" if is_second else "the second vehicle"
    found = NamedObstacles([], [], {}, of_own, other, set())
    for k, entry in enumerate(world.obstacles):
        if isinstance(entry, UserShape):
            continue
        name = obstacle_words(k, entry)
        if getattr(entry, "motion", None) is not None:
            found.moving[float(k)] = name
            continue
        each: list[tuple[str, BuiltIn]]
        if isinstance(entry, Imported):
            each = [(part_words(k, entry, one), one.obstacle) for one in entry.parts]
        else:
            each = [(name, entry)]
        for name, one in each:
            found.grounds.update([name] if isinstance(one, Ground) else [])
            found.at_rest.append(name)
            found.planes.extend([] if isinstance(one, ShapeSettings) else [name] * len(faces(one)))
    return found


def names_in(scenario: Scenario, model: Model) -> NamedObstacles:
    """Names of the obstacles of a built flight, those of the user's own by their classes."""
    each = single_obstacles(scenario.world.obstacles)
    planes = [one for one in each if not isinstance(one, UserShape | ShapeSettings)]
    there = model.world.obstacles
    still = there.still if isinstance(there, MovingScene) else there
    own = (
        still.own
        if isinstance(still, SolidScene)
        else there[sum(len(faces(one)) for one in planes) :]
    )
    kinds = [type(one.shape).__name__ for one in own if not isinstance(one.shape, SecondContact)]
    return obstacle_names(scenario.world, kinds, is_second=bool(model.pushes))


def first_obstacle(scenario: Scenario, flown: FlightRecord) -> str:
    """What a flight touched first; empty if it touched nothing."""
    names = names_in(scenario, flown.model)
    with routines_compiled():
        return names.of_first(flown.model.world.obstacles, flown.record.first_impact)


class _Near(NamedTuple):
    """An obstacle and its distance from a point."""

    gap: float  # [m]
    name: str


def gaps_in(table: Any, point: Vec) -> Iterator[tuple[float, int]]:
    """Distances of the solids of a table that may be the nearest, and numbers of their owners.

    Args:
        table: Of a scene; with routines compiled.
        point: In its axes [m].
    """
    rows = [HEADER + WIDTH * k for k in range(int(number_at(table, HALF_SPACES)))]
    found = [(solid_face(table, row, point).gap, row) for row in rows]
    nearest = nearest_solid(table, point, FARTHEST)
    found += [(nearest.gap, nearest.row)] if nearest.row >= 0 else []
    for gap, row in found:
        yield gap, int(number_at(table, row + OWNER))


def _one_by_one(each: Iterable[Obstacle], point: Vec, names: Sequence[str]) -> Iterator[_Near]:
    for one, name in zip(each, names, strict=False):  # then come second contacts of the same
        yield _Near(signed_distance(one.shape, point), name)


def _near_at_rest(there: Any, point: Vec, names: NamedObstacles) -> Iterator[_Near]:
    """Obstacles at rest that may be the nearest to a point of the world."""
    if not isinstance(there, SolidScene | MovingScene):
        yield from _one_by_one(there, point, [*names.planes, *names.own])
        return
    still = there.still if isinstance(there, MovingScene) else there
    for gap, owner in gaps_in(still.table, point):
        yield _Near(gap, names.at_rest[owner])
    yield from _one_by_one(still.own, point, names.own)


def _all_near(
    there: Any, bodies: Sequence[Any], point: Vec, names: NamedObstacles
) -> Iterator[_Near]:
    """Obstacles that may be the nearest to a point of the world."""
    yield from _near_at_rest(there, point, names)
    for body, now in zip(moving_bodies(there), bodies, strict=True):
        if body.kind != ABSENT and body.scene != 0.0:  # parts without solids are not met
            pose = body_pose(body, now)
            name = names.other if body.kind == CARRIED else names.moving[body.obstacle]
            for gap, _ in gaps_in(body.scene, (point - pose.position) @ pose.r):
                yield _Near(gap, name)


class _Evaluation(NamedTuple):
    """What contacts are evaluated with."""

    model: Model
    columns: Mapping[str, Array]
    names: NamedObstacles
    view: PairView | None = None  # of the second of two vehicles: the first, which meets it
    beside: bool = False  # with another vehicle


def _evaluation(flight: FlightResult) -> _Evaluation:
    names, first, second = _names_of(flight), flight.first, flight.second
    if second is not None:
        seen = pair_view(flight.scenario, flight.columns, second.columns)
        return _Evaluation(seen.model, seen.columns, names, beside=True)
    if first is not None:
        seen = pair_view(first.scenario, first.columns, flight.columns)
        return _Evaluation(seen.other, flight.columns, names, seen, beside=True)
    return _Evaluation(model_of(flight, ()), flight.columns, names)


def _instant(model: Model, columns: Mapping[str, Array], row: int) -> Instant:
    """A vehicle at a row of its trajectory."""
    leaves = states_at(model, columns, np.array([row]))[0].tolist()
    state = rebuilt(model_state(model), leaves)
    return Instant(model.airframe, model.world, model.contact_point, state)


def _hardest_face(faces: Iterable[FaceLoad]) -> FaceLoad:
    return max(faces, key=lambda face: face.normal)


def _place_at(given: _Evaluation, row: int, part: int) -> ContactPlace | None:
    """What a part touches at a row of the trajectory; None if nothing presses on it."""
    instant, names = _instant(given.model, given.columns, row), given.names
    with routines_compiled():
        pressed = _hardest_face(loads_at(instant)[part])
        if given.view is not None:  # the first vehicle presses with what acts on itself
            alone = _instant(given.view.of_part(part), given.view.columns, row)
            theirs = _hardest_face(chain.from_iterable(loads_at(alone)))
            if theirs.normal > max(pressed.normal, NO_FORCE):
                x, y, z = theirs.point
                return ContactPlace(names.other, (x, y, z))
        if pressed.normal <= NO_FORCE:
            return ContactPlace(names.other, None) if given.beside else None
        bodies, there = instant.state.bodies, given.model.world.obstacles
        near = list(_all_near(there, bodies, pressed.point, names))
        x, y, z = pressed.point
        name = min(near).name if near else names.other
        return ContactPlace(name, (x, y, z), name in names.grounds)


def _stored_place(given: _Evaluation, flight: FlightResult, one: ContactSpan) -> ContactPlace:
    """What a part touched by the stored contacts of a flight that was read back."""
    part, model = parts_of(flight.columns)[one.part], given.model
    point = stored_point(flight, part, one.hardest_time)
    state = rebuilt(
        model_state(model), states_at(model, given.columns, np.array([one.hardest]))[0].tolist()
    )
    with routines_compiled():
        at_rest = given.names._replace(own=[])
        near = [*_all_near(model.world.obstacles, state.bodies, Vec(*point), at_rest)]
    surfaces = zip(flight.own_surfaces, given.names.own, strict=True)
    near += [_Near(one.distance(np.array(point)), name) for one, name in surfaces]
    name = min(near).name
    return ContactPlace(name, point, name in given.names.grounds)


def contact_places(flight: FlightResult, spans: Sequence[ContactSpan]) -> list[ContactPlace | None]:
    """What is touched in some contacts, and where, when each is pressed hardest.

    Args:
        flight: With its trajectory.
        spans: Its contacts.

    Returns:
        For each; None beyond `MOST`, and for all of them if the flight met obstacles of the user's
        own and was read from a folder of an earlier version, which lacks its contacts.
    """
    is_read = bool(flight.own_surfaces) and not flight.own
    if not spans or (is_read and not flight.own_contacts):
        return [None] * len(spans)
    found: list[ContactPlace | None]
    if is_read:
        model = flight.scenario.flight_model(())
        given = _Evaluation(model, flight.columns, _names_of(flight))
        found = [_stored_place(given, flight, one) for one in spans[:MOST]]
    else:
        given = _evaluation(flight)
        found = [_place_at(given, one.hardest, one.part) for one in spans[:MOST]]
    return found + [None] * (len(spans) - len(found))


class JumpContact(NamedTuple):
    """A jump of the motion, and what touched what."""

    jump: Jump
    parts: tuple[int, ...]  # numbers of the cages from 0, then of the hull
    names: tuple[str, ...]  # of these parts, in words
    place: ContactPlace  # of the first of them


def jump_contacts(flight: FlightResult) -> list[JumpContact]:
    """Jumps of a flight at surfaces of the impulse law, in order of time; `MOST` of them at most.

    Args:
        flight: With its trajectory.
    """
    jumps = list(jumps_of(flight.columns))[:MOST]
    is_read = bool(flight.own_surfaces) and not flight.own
    if not jumps or is_read:  # no file holds laws of the user's own
        return []
    given, guard = _evaluation(flight), flight.scenario.vehicle.guard_word
    parts, found = parts_of(flight.columns), []
    for jump in jumps:
        instant = _instant(given.model, given.columns, jump.before + 1)
        with routines_compiled():
            touched = nearest_impulsive(instant)
            if not touched:
                continue
            numbers = tuple(touched)
            point = touched[numbers[0]]
            near = _all_near(given.model.world.obstacles, instant.state.bodies, point, given.names)
            name = min(near).name
        there = ContactPlace(name, (point.x, point.y, point.z), name in given.names.grounds)
        words = tuple(part_name(parts[k], guard) for k in numbers)
        found.append(JumpContact(jump, numbers, words, there))
    return found


def obstacle_contacts(flight: FlightResult) -> tuple[ObstacleContact, ...]:
    """Obstacles that a vehicle touched, in order of their first contacts.

    Args:
        flight: With its trajectory.
    """
    spans = sorted(contact_spans(flight), key=lambda one: one.begin)
    met: dict[str, list[tuple[ContactSpan, ContactPlace]]] = {}
    begins: dict[str, float] = {}
    for one, place in zip(spans, contact_places(flight, spans), strict=True):
        if place is not None:
            met.setdefault(place.obstacle, []).append((one, place))
            begins.setdefault(place.obstacle, one.begin)
    found = {name: _hardest(name, each) for name, each in met.items()}
    struck: dict[str, list[JumpContact]] = {}
    for hit in jump_contacts(flight):
        struck.setdefault(hit.place.obstacle, []).append(hit)
    for name, hits in struck.items():
        begins[name] = min(begins.get(name, math.inf), hits[0].jump.begin)
        found[name] = _largest(name, hits, found.get(name))
    return tuple(found[name] for name in sorted(found, key=lambda name: begins[name]))


def _largest(
    name: str, hits: Sequence[JumpContact], pressed: ObstacleContact | None
) -> ObstacleContact:
    """What a vehicle touched by impulses, and by forces, too, if it has a mat of its own."""
    hit = max(hits, key=lambda one: one.jump.size)
    count, parts = sum(len(one.parts) for one in hits), {p for one in hits for p in one.names}
    if pressed is not None:
        return pressed._replace(
            contacts=pressed.contacts + count, parts=tuple(sorted(parts | {*pressed.parts})),
            impulse=hit.jump.size,
        )  # fmt: skip
    return ObstacleContact(
        name, count, tuple(sorted(parts)), 0.0, hit.jump.begin, " and ".join(hit.names),
        hit.place.point, hit.jump.size,
    )  # fmt: skip


def _hardest(name: str, each: list[tuple[ContactSpan, ContactPlace]]) -> ObstacleContact:
    one, there = max(each, key=lambda pair: pair[0].force)
    parts = tuple(sorted({span.name for span, _ in each}))
    return ObstacleContact(
        name, len(each), parts, one.force, one.hardest_time, one.name, there.point
    )
