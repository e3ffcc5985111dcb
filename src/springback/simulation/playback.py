"""Contact forces and energies along a trajectory, evaluated again by the same kernels.

A trajectory holds lengths of arms and sums of forces; contact points and the force on each cage
follow from its states by the laws of the flight.  A cage that touches two things, or one thing at
two points, has two contacts.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import scipy  # submodules are loaded on first use

from springback.contact.cage import (
    BodyMotion,
    ContactFace,
    moving_bodies,
)
from springback.contact.hull_contact import (
    BodySight,
    arm_faces,
    arm_flags,
    arm_sight,
    body_sight,
    hull_contact,
    hull_faces,
    hull_flags,
)
from springback.contact.laws.memory import arm_memory, hull_memory
from springback.contact.loads import CageContact, face_contact
from springback.contact.moving.bodies import ABSENT, GIVEN, MovingBody
from springback.contact.moving.scene import MovingScene
from springback.contact.obstacles import World
from springback.contact.scene.faces import SolidScene
from springback.dynamics.energy import Energy, energy
from springback.dynamics.limbs.shell import hull_motion
from springback.kernels.compiler import executor, kernel, user_executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.trees import leaves, tree_map
from springback.kernels.vectors import Vec
from springback.simulation.flight import model_state, own_types, sources
from springback.simulation.measuring.record import Model
from springback.vehicle.state import (
    Airframe,
    PartMemory,
    State,
    coordinates_of_arms,
    rates_of_arms,
)

Array = np.ndarray[Any, np.dtype[np.float64]]
Places = np.ndarray[Any, np.dtype[np.intp]]

#: Contact forces below this count as none [N].
NO_FORCE = 1e-9


class FaceLoad(NamedTuple):
    """Load of one face that a cage, or the hull, meets."""

    force: Vec  # on it, world [N]
    normal: float  # f_n [N]
    friction: Vec  # f_f, world [N]
    point: Vec  # of contact, world [m]


class Instant(NamedTuple):
    """Inputs at one instant."""

    airframe: Airframe
    world: World
    contact_point: Any
    state: State


class Evaluation(NamedTuple):
    """Loads and energy at one instant."""

    parts: tuple[tuple[FaceLoad, ...], ...]  # of cages, then of the hull if there is one
    stored: Energy


@kernel
def _cage_load(face: ContactFace, memory: PartMemory, arm: Any, body: BodyMotion) -> FaceLoad:
    return _in_world(face_contact(face, 1.0, memory, arm, body), body)


@kernel
def _hull_load(face: ContactFace, memory: PartMemory, hull: Any, body: BodyMotion) -> FaceLoad:
    return _in_world(hull_contact(face, 1.0, memory, hull, body), body)


@kernel
def _in_world(met: CageContact, body: BodyMotion) -> FaceLoad:
    """A contact in body axes from the main body, in the world."""
    touch, r = met.touch, body.r
    point = body.position + r @ met.pressing_at
    return FaceLoad(r @ touch.force, touch.normal, r @ touch.friction, point)


@kernel
def _arm_loads(
    arm: Any,
    length: float,
    rate: float,
    memory: PartMemory,
    contact_point: Any,
    around: BodySight,
) -> tuple[FaceLoad, ...]:
    pose, obstacles, body = arm_sight(arm, length, rate, around)
    faces = arm_faces(arm, obstacles, contact_point, pose, 1.0)
    return tree_map(_cage_load, (faces,), (memory, pose, body))


@kernel
def _hull_loads(
    hull: Any, memory: PartMemory, obstacles: Any, body: BodyMotion
) -> tuple[FaceLoad, ...]:
    there = hull_motion(hull, memory, body)
    return tree_map(_hull_load, (hull_faces(hull, obstacles, 1.0),), (memory, hull, there))


@kernel
def loads_at(at: Instant) -> tuple[tuple[FaceLoad, ...], ...]:
    """Loads of the faces that each cage meets, then the hull if there is one."""
    state = at.state
    around = body_sight(at.world.obstacles, state, 0.0)
    obstacles, body = around.obstacles, around.body
    on_arms = arm_memory(state.memory, at.airframe.arms)
    on_hull = hull_memory(state.memory, at.airframe.hull)
    lengths = coordinates_of_arms(at.airframe.arms[0], state)
    arms = tree_map(
        _arm_loads,
        (at.airframe.arms, lengths, rates_of_arms(at.airframe.arms[0], state), on_arms),
        (at.contact_point, around),
    )
    found: tuple[tuple[FaceLoad, ...], ...] = arms + tree_map(
        _hull_loads, (at.airframe.hull, on_hull), (obstacles, body)
    )
    return found


@kernel
def _evaluate(at: Instant) -> Evaluation:
    return Evaluation(loads_at(at), energy(at.airframe, at.world, at.contact_point, at.state))


@executor(nogil=True)
def _evaluate_all(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write `Evaluation` for each instant; the rows of the buffers hold the leaves."""
    for i in range(instants.shape[0]):
        write(_evaluate(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)


class LoadHistory(NamedTuple):
    """Contacts and energies over time.

    Each cage, then the hull, has one contact or more: as many as it had at once in the flight, in
    an order in which each stays where it was from instant to instant.
    """

    part: tuple[int, ...]  # of each contact: number of its cage from 0, then of the hull
    force: Array  # of each contact, world [N], shape (instants, contacts, 3)
    point: Array  # where it acts, world [m], shape (instants, contacts, 3); NaN without a force
    normal: Array  # sum of the f_n on each part [N], shape (instants, parts)
    rubbing: Array  # sum of the f_f on each part, world [N], shape (instants, parts, 3)
    energy: dict[str, Array]  # `Energy` by name [J], each of shape (instants,)

    @property
    def friction(self) -> Array:
        """Magnitude of the friction on each part [N], shape (instants, parts)."""
        return np.asarray(np.linalg.norm(self.rubbing, axis=2))


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
    memory = model_state(model).memory
    needed = recorded_memory(memory, model.world.obstacles)
    # What a step lost changes nothing after it; flights of earlier versions were stored without.
    rows = [
        0.0 * columns["t"][places]
        if name not in needed or (name.endswith("_lost") and name not in columns)
        else columns[name][places]
        for name in memory_columns(memory)
    ]
    held = [np.stack(rows, axis=1)] if rows else []
    bent = bend_columns(len(model_state(model).bends))
    bends = [np.stack([columns[name][places] for name in bent], axis=1)] if bent else []
    return np.concatenate([states, *moving, *held, *bends], axis=1)


def bend_columns(count: int) -> dict[str, tuple[str, str]]:
    """Columns of a trajectory for the second joints of arms.

    Args:
        count: Number of arms that have one.

    Returns:
        Names in the trace, and units, by the name of the column, in the order of a state.
    """
    found = {}
    for j in range(1, count + 1):
        found[f"bend{j}"] = (f"state.bends.{j}.way", "m")
        found[f"dbend{j}"] = (f"state.bends.{j}.rate", "m/s")
    return found


def recorded_memory(memory: Any, obstacles: Any) -> dict[str, tuple[str, str]]:
    """Those of `memory_columns` that a surface needs: the others are 0 all along.

    Args:
        memory: Of a state.
        obstacles: Of the world.
    """
    scene = obstacles.still if isinstance(obstacles, MovingScene) else obstacles
    unused = []
    if isinstance(scene, SolidScene):
        unused += [] if scene.bristles > 0.0 else [".bristles."]
        unused += [] if scene.remembers > 0.0 else [".pressed."]
    return {
        name: (source, unit)
        for name, (source, unit) in memory_columns(memory).items()
        if not any(kind in source for kind in unused)
    }


def memory_columns(memory: Any) -> dict[str, tuple[str, str]]:
    """Columns of a trajectory for the memory of all parts, leaf by leaf.

    Args:
        memory: Of a state; `()` has none.

    Returns:
        Names in the trace, and units, by the name of the column.
    """
    if memory == ():
        return {}
    parts = [(f"{j}", f"arms.{j}", part) for j, part in enumerate(memory.arms, start=1)]
    parts += [("_body", f"hull.{k}", part) for k, part in enumerate(memory.hull, start=1)]
    found: dict[str, tuple[str, str]] = {}
    for part, source, kept in parts:
        stem = f"state.memory.{source}"
        for name, kind, unit in (("stick", "slip", "m"), ("roll", "roll", "rad")):
            for axis in "xyz" if kept.bristles else "":
                found[f"{name}{part}_{axis}"] = (f"{stem}.bristles.1.{kind}.{axis}", unit)
        for pressed in kept.pressed:
            found[f"crushed{part}"] = (f"{stem}.pressed.1.crushed", "m")
            for k in range(1, len(pressed.points) + 1):
                at, point = f"{stem}.pressed.1.points.{k}", f"{part}_{k}"
                for axis in "xyz":
                    found[f"pressed{point}_{axis}"] = (f"{at}.place.{axis}", "m")
                for axis in "xyz":
                    found[f"pressed{point}_n{axis}"] = (f"{at}.inward.{axis}", "1")
                found[f"pressed{point}_depth"] = (f"{at}.depth", "m")
                found[f"pressed{point}_crushed"] = (f"{at}.crushed", "m")
                found[f"pressed{point}_lost"] = (f"{at}.lost", "J")
        for axis in "xyz" if kept.spin else "":
            found[f"shell_w{axis}"] = (f"{stem}.spin.1.{axis}", "rad/s")
        for _ in kept.stiffness:
            found[f"stiffness{part}"] = (f"{stem}.stiffness.1", "1")
    return found


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
    states, still = states_at(model, columns, places), model_state(model)
    asked = Instant(model.airframe, model.world, model.contact_point, still)
    constants = np.array(leaves(asked)[: -states.shape[1]])
    instants = np.concatenate(
        [np.broadcast_to(constants, (len(states), len(constants))), states], 1
    )
    there = model.world.obstacles
    counts = [len(arm_flags(arm, there, 0.0)) for arm in model.airframe.arms]
    counts += [len(hull_flags(hull, there, 0.0)) for hull in model.airframe.hull]
    wide = 10 * sum(counts)
    out = np.zeros((len(states), wide + len(Energy._fields)))
    own = own_types(asked)
    plain = getattr(_evaluate_all, "py_func", _evaluate_all)
    run = user_executor(plain, sources(own), nogil=True) if own else _evaluate_all
    run(TreeLayout(asked), np.ascontiguousarray(instants), out)
    stored = {name: out[:, wide + k] for k, name in enumerate(Energy._fields)}
    ends = 10 * np.cumsum([0, *counts])
    each = [
        out[:, first:last].reshape(len(out), -1, 10) for first, last in itertools.pairwise(ends)
    ]
    rubbed = np.stack([one[..., 4:7].sum(axis=1) for one in each], axis=1)
    contacts = [_contacts(one) for one in each]
    part = tuple(k for k, one in enumerate(contacts) for _ in range(one.shape[1]))
    found = np.concatenate([np.zeros((len(out), 0, 6)), *contacts], axis=1)
    normal = np.stack([one[..., 3].sum(axis=1) for one in each], axis=1)
    return LoadHistory(part, found[..., :3], found[..., 3:], normal, rubbed, stored)


def _contacts(each: Array) -> Array:
    """Forces and points of the contacts of one part, shape (instants, contacts, 6).

    Args:
        each: Leaves of `FaceLoad` of its faces, shape (instants, faces, 10).
    """
    acts = each[..., 3] > NO_FORCE
    point = np.where(acts[..., None], each[..., 7:], np.nan)
    found = np.concatenate([each[..., :3], point], axis=2)
    most = max(int(acts.sum(axis=1).max(initial=0)), 1)
    order = np.argsort(~acts, axis=1, kind="stable")[:, :most]
    found = np.take_along_axis(found, order[..., None], axis=1)
    if most > 1:
        _keep_places(found)
    return found


def _keep_places(found: Array) -> None:
    """Put contacts into the order in which they are nearest to where they were, in place.

    Faces of a scene come in order of their depth, which changes from instant to instant.

    Args:
        found: Of `_contacts`.
    """
    last = found[0, :, 3:].copy()
    for row in np.flatnonzero(np.isfinite(found[:, :, 3]).any(axis=1)):
        here = found[row]
        away = np.linalg.norm(here[None, :, 3:] - last[:, None, :], axis=2)
        here = here[scipy.optimize.linear_sum_assignment(np.nan_to_num(away))[1]]
        found[row] = here
        last = np.where(np.isfinite(here[:, 3:]), here[:, 3:], last)
