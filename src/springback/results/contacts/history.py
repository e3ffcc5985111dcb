"""Moments of contacts, and distances, at the recorded states by the kernels of the flight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import BodyMotion, ContactFace, per_face
from springback.contact.hull_contact import (
    BodySight,
    arm_faces,
    arm_gaps,
    arm_sight,
    body_sight,
    hull_contact,
    hull_faces,
    hull_gaps,
)
from springback.contact.laws.memory import arm_memory, hull_memory
from springback.contact.loads import CageContact, face_contact
from springback.contact.worlds import Own
from springback.dynamics.limbs.shell import hull_motion
from springback.errors import InputError
from springback.kernels.compiler import executor, kernel, user_executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.trees import leaves, tree_map, tree_sum
from springback.kernels.vectors import Vec
from springback.results.result import FlightResult
from springback.simulation.flight import model_state, own_types, sources
from springback.simulation.measuring.record import Model
from springback.simulation.playback import Instant, states_at
from springback.vehicle.state import (
    PartMemory,
    coordinates_of_arms,
    in_body_axes,
    rates_of_arms,
)

Array = np.ndarray[Any, np.dtype[np.float64]]


def model_of(flight: FlightResult, own: tuple[Own, ...]) -> Model:
    """Model of a recorded flight.

    Args:
        flight: With its trajectory.
        own: The user's own obstacles, for a flight read from a file.

    Raises:
        InputError: If the trajectory was not recorded, or the user's own obstacles are unknown.
    """
    flight.need_trajectory()
    own = own or flight.own
    if flight.own_surfaces and not own:
        raise InputError(
            "the flight was read from a folder, which holds no laws of obstacles of your own: "
            "give them as own"
        )
    return flight.scenario.flight_model(own)


class PartContact(NamedTuple):
    """A cage or the hull: its moment and distances."""

    moment: Vec  # of its contact forces about the main body, body axes [N m]
    gaps: tuple[float, ...]  # to each face that it can meet [m]


@kernel
def _on_cage(face: ContactFace, memory: PartMemory, arm: Any, body: BodyMotion) -> CageContact:
    return face_contact(face, 1.0, memory, arm, body)


@kernel
def _on_hull(face: ContactFace, memory: PartMemory, hull: Any, body: BodyMotion) -> CageContact:
    return hull_contact(face, 1.0, memory, hull, body)


@kernel
def _moment(contact: CageContact) -> Vec:
    return contact.touch.moment


@kernel
def _arm_contact(
    arm: Any,
    length: float,
    rate: float,
    memory: PartMemory,
    contact_point: Any,
    around: BodySight,
) -> PartContact:
    pose, obstacles, body = arm_sight(arm, length, rate, around)
    faces = arm_faces(arm, obstacles, contact_point, pose, 1.0)
    found = tree_map(_on_cage, (faces,), (memory, pose, body))
    gaps = arm_gaps(arm, obstacles, contact_point, pose)
    moment = tree_sum(tree_map(_moment, (found,), ()))
    return PartContact(in_body_axes(arm, length, moment), gaps)


@kernel
def _hull_contact(hull: Any, memory: PartMemory, obstacles: Any, body: BodyMotion) -> PartContact:
    there = hull_motion(hull, memory, body)
    found = tree_map(_on_hull, (hull_faces(hull, obstacles, 1.0),), (memory, hull, there))
    return PartContact(tree_sum(tree_map(_moment, (found,), ())), hull_gaps(hull, obstacles))


@kernel
def _contacts(at: Instant) -> tuple[PartContact, ...]:
    state = at.state
    around = body_sight(at.world.obstacles, state, 0.0)
    obstacles, body = around.obstacles, around.body
    on_arms = arm_memory(state.memory, at.airframe.arms)
    on_hull = hull_memory(state.memory, at.airframe.hull)
    lengths = coordinates_of_arms(at.airframe.arms[0], state)
    arms = tree_map(
        _arm_contact,
        (at.airframe.arms, lengths, rates_of_arms(at.airframe.arms[0], state), on_arms),
        (at.contact_point, around),
    )
    found: tuple[PartContact, ...] = arms + tree_map(
        _hull_contact, (at.airframe.hull, on_hull), (obstacles, body)
    )
    return found


@executor(nogil=True)
def _all_contacts(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write `PartContact` of each part for each instant; rows of the buffers hold the leaves."""
    for i in range(instants.shape[0]):
        write(_contacts(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)


#: Parts whose gaps differ by less touch together [m] (chosen: steps land on a touch).
TOGETHER = 1e-6


def nearest_impulsive(at: Instant) -> dict[int, Vec]:
    """Parts that are nearest to surfaces of the impulse law, and where they touch, world [m].

    Args:
        at: An instant, evaluated in plain Python.

    Returns:
        By the number of the cage from 0, then of the hull; empty without such a surface.
    """
    near = sorted(_impulsive_contacts(at), key=lambda one: one[0])
    touching = [one for one in near if one[0] <= near[0][0] + TOGETHER]
    return {part: point for _, part, point in sorted(touching, key=lambda one: one[1])}


def _impulsive_contacts(at: Instant) -> Iterator[tuple[float, int, Vec]]:
    """Gap [m], number of the part and point [m] of each face of the impulse law."""
    state, airframe = at.state, at.airframe
    around = body_sight(at.world.obstacles, state, 0.0)
    for part, (arm, length, rate, memory) in enumerate(
        zip(
            airframe.arms, coordinates_of_arms(airframe.arms[0], state),
            rates_of_arms(airframe.arms[0], state), arm_memory(state.memory, airframe.arms),
            strict=True,
        )
    ):  # fmt: skip
        pose, obstacles, body = arm_sight(arm, length, rate, around)
        for face in arm_faces(arm, obstacles, at.contact_point, pose, 1.0):
            yield from _impulsive(face_contact(face, 1.0, memory, pose, body), part, body)
    hulls = zip(airframe.hull, hull_memory(state.memory, airframe.hull), strict=True)
    for part, (hull, memory) in enumerate(hulls, start=len(airframe.arms)):
        body = hull_motion(hull, memory, around.body)
        for face in hull_faces(hull, around.obstacles, 1.0):
            yield from _impulsive(hull_contact(face, 1.0, memory, hull, body), part, body)


def _impulsive(met: CageContact, part: int, body: BodyMotion) -> Iterator[tuple[float, int, Vec]]:
    if met.impulsive > 0.0:
        yield met.gap, part, body.position + body.r @ met.pressing_at


class ContactHistory(NamedTuple):
    """Moments and distances over time."""

    moment: Array  # of all contacts about the main body, body axes [N m], shape (instants, 3)
    gaps: Array  # of cages, then the hull, to each obstacle [m], shape (instants, parts, obstacles)


def contact_history(model: Model, flight: FlightResult) -> ContactHistory:
    """Contacts at the instants of the trajectory."""
    arms, states = len(model.airframe.arms), states_at(model, flight.columns, slice(None))
    like = Instant(model.airframe, model.world, model.contact_point, model_state(model))
    constants = np.array(leaves(like)[: -states.shape[1]])
    instants = np.hstack([np.broadcast_to(constants, (len(states), len(constants))), states])
    parts, obstacles = arms + len(model.airframe.hull), len(per_face(model.world.obstacles, 0.0))
    out = np.zeros((len(states), parts * (3 + obstacles)))
    own = own_types(like)
    plain = getattr(_all_contacts, "py_func", _all_contacts)
    run = user_executor(plain, sources(own), nogil=True) if own else _all_contacts
    run(TreeLayout(like), np.ascontiguousarray(instants), out)
    each = out.reshape(len(out), parts, 3 + obstacles)
    return ContactHistory(each[:, :, :3].sum(axis=1), each[:, :, 3:])
