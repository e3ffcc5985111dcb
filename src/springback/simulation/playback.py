"""Contact forces and energies along a trajectory, evaluated again by the same kernels.

A trajectory holds lengths of arms and sums of forces; contact points and the force on each cage
follow from its states by the laws of the flight.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import (
    BodyMotion,
    CageContact,
    ContactFace,
    body_motion,
    contact_faces,
    face_contact,
    moving_bodies,
    obstacles_in_body_frame,
    obstacles_now,
)
from springback.contact.hull_contact import hull_contact, hull_faces
from springback.contact.moving.bodies import ABSENT, GIVEN, MovingBody
from springback.contact.obstacles import World
from springback.dynamics.energy import Energy, energy
from springback.kernels.compiler import executor, kernel, user_executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.trees import leaves, tree_map, tree_sum
from springback.kernels.vectors import Vec
from springback.simulation.flight import model_state, own_types, sources
from springback.simulation.record import Model
from springback.vehicle.state import Airframe, Arm, Sphere, State, arm_pose

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: Contact forces below this count as none [N].
NO_FORCE = 1e-9


class PartLoad(NamedTuple):
    """Load of all obstacles on one cage, or on the hull."""

    force: Vec  # on it, world [N]
    normal: float  # sum of the f_n [N]
    friction: Vec  # sum of the f_f, world [N]
    point: Vec  # sum of contact points, each times its f_n, world [N m]


class Instant(NamedTuple):
    """Inputs at one instant."""

    airframe: Airframe
    world: World
    contact_point: Any
    state: State


class Evaluation(NamedTuple):
    """Loads and energy at one instant."""

    parts: tuple[PartLoad, ...]  # cages, then the hull if there is one
    stored: Energy


@kernel
def _cage_load(face: ContactFace, arm: Any, body: BodyMotion) -> PartLoad:
    """Load of one face on one cage, in body axes from the main body."""
    return _load(face_contact(face, 1.0, arm, body))


@kernel
def _load(met: CageContact) -> PartLoad:
    f_n = met.touch.normal
    return PartLoad(met.touch.force, f_n, met.touch.friction, f_n * met.pressing_at)


@kernel
def _sphere_load(face: ContactFace, hull: Sphere, body: BodyMotion) -> PartLoad:
    return _load(hull_contact(face, 1.0, hull, body))


@kernel
def _arm_load(
    arm: Arm,
    length: float,
    rate: float,
    obstacles: Any,
    contact_point: Any,
    body: BodyMotion,
) -> PartLoad:
    pose = arm_pose(arm, length, rate, body.velocity)
    faces = contact_faces(obstacles, contact_point, arm.cage_radius, pose, 1.0)
    return _in_world(tree_sum(tree_map(_cage_load, (faces,), (pose, body))), body)


@kernel
def _in_world(p: PartLoad, body: BodyMotion) -> PartLoad:
    r = body.r
    point = r @ p.point + p.normal * body.position
    return PartLoad(r @ p.force, p.normal, r @ p.friction, point)


@kernel
def _hull_load(hull: Sphere, obstacles: Any, body: BodyMotion) -> PartLoad:
    loads = tree_map(_sphere_load, (hull_faces(hull, obstacles, 1.0),), (hull, body))
    return _in_world(tree_sum(loads), body)


@kernel
def _evaluate(at: Instant) -> Evaluation:
    state = at.state
    body = body_motion(state, 0.0)
    there = obstacles_now(at.world.obstacles, state.bodies)
    obstacles = obstacles_in_body_frame(there, state.position, body.r)
    arms = tree_map(
        _arm_load,
        (at.airframe.arms, state.arm_length, state.arm_rate),
        (obstacles, at.contact_point, body),
    )
    parts = arms + tree_map(_hull_load, (at.airframe.hull,), (obstacles, body))
    return Evaluation(parts, energy(at.airframe, at.world, at.contact_point, state))


@executor(nogil=True)
def _evaluate_all(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write `Evaluation` for each instant; the rows of the buffers hold the leaves."""
    for i in range(instants.shape[0]):
        write(_evaluate(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)


class LoadHistory(NamedTuple):
    """Contacts and energies over time."""

    force: Array  # on each cage, then the hull, world [N], shape (instants, parts, 3)
    normal: Array  # f_n [N], shape (instants, parts)
    friction: Array  # |f_f| [N], shape (instants, parts)
    point: Array  # where it acts, world [m], shape (instants, parts, 3); NaN where nothing touches
    energy: dict[str, Array]  # `Energy` by name [J], each of shape (instants,)


def states_at(model: Model, columns: Mapping[str, Array], places: Places | slice) -> Array:
    """Leaves of `State` at some instants of a trajectory, one row for each.

    Args:
        model: Of the flight.
        columns: Its trajectory.
        places: Rows of the instants.
    """
    names = [*"xyz", *(f"q{p}" for p in "wxyz"), *(f"v{a}" for a in "xyz"), *("wx", "wy", "wz")]
    count = range(1, len(model.airframe.arms) + 1)
    names += [f"{kind}{j}" for kind in ("l", "dl") for j in count]
    states = np.stack([columns[name][places] for name in names], axis=1)
    bodies = moving_bodies(model.world.obstacles)
    moving = [_body_states(body, columns, places, len(states)) for body in bodies]
    return np.concatenate([states, *moving], axis=1)


def _body_states(
    body: MovingBody, columns: Mapping[str, Array], places: Places | slice, count: int
) -> Array:
    """Leaves of `springback.vehicle.state.BodyState`, one row for each instant."""
    states = np.zeros((count, 13))
    states[:, 3] = 1.0
    if body.kind == GIVEN:
        states[:, 0] = columns["t"][places]
    elif body.kind != ABSENT:
        stem = f"obstacle{int(body.obstacle)}_"
        names = [*"xyz", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"]
        states[:] = np.stack([columns[stem + name][places] for name in names], axis=1)
    return states


def load_history(model: Model, columns: Mapping[str, Array], places: Places) -> LoadHistory:
    """Contacts and energies at some instants of a trajectory.

    Args:
        model: Of the flight.
        columns: Its trajectory.
        places: Rows of the instants.
    """
    arms = len(model.airframe.arms)
    states, still = states_at(model, columns, places), model_state(model)
    asked = Instant(model.airframe, model.world, model.contact_point, still)
    constants = np.array(leaves(asked)[: -states.shape[1]])
    instants = np.concatenate(
        [np.broadcast_to(constants, (len(states), len(constants))), states], 1
    )
    parts = arms + len(model.airframe.hull)
    out = np.zeros((len(states), 10 * parts + len(Energy._fields)))
    own = own_types(asked)
    plain = getattr(_evaluate_all, "py_func", _evaluate_all)
    run = user_executor(plain, sources(own), nogil=True) if own else _evaluate_all
    run(TreeLayout(asked), np.ascontiguousarray(instants), out)
    each_part = out[:, : 10 * parts].reshape(len(out), parts, 10)
    normal = each_part[:, :, 3]
    with np.errstate(divide="ignore", invalid="ignore"):
        point = np.where(
            normal[..., None] > NO_FORCE, each_part[:, :, 7:] / normal[..., None], np.nan
        )
    stored = {name: out[:, 10 * parts + k] for k, name in enumerate(Energy._fields)}
    friction = np.linalg.norm(each_part[:, :, 4:7], axis=2)
    return LoadHistory(each_part[:, :, :3], normal, friction, point, stored)
