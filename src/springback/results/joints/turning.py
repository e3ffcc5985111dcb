"""Angular acceleration of a vehicle with arms on joints, a shell, or rotors that it lists.

Arms that accelerate along their paths turn the main body, and bearings pass only a part of a moment
on, so that the equations of motion are evaluated again, by the kernel of the flight, at the
recorded states.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.motion import rates
from springback.kernels.compiler import executor, kernel, user_executor
from springback.kernels.layout import Buffer, TreeLayout, read, write
from springback.kernels.trees import leaves, replace
from springback.kernels.vectors import Vec
from springback.results.result import FlightResult
from springback.simulation.flight import model_state, own_types, sources
from springback.simulation.measuring.record import Model
from springback.simulation.playback import states_at
from springback.vehicle.state import State

Array = np.ndarray[Any, np.dtype[np.float64]]


class _Acting(NamedTuple):
    """What acts on a vehicle at one instant."""

    model: Model
    thrust: tuple[float, ...]  # of each rotor [N]
    reaction: tuple[Any, ...]  # of rotors that change speed, as of a `Model` [N m]
    released: float  # 1 while the arms can move
    state: State


class _Turned(NamedTuple):
    """How the main body moves."""

    acceleration: Vec  # world [m/s²]
    angular: Vec  # α, body axes [rad/s²]


@kernel
def _accelerations(at: _Acting) -> _Turned:
    plant = replace(at.model, thrust=at.thrust, reaction=at.reaction)
    motion = rates(plant, at.state, at.released).motion
    return _Turned(motion.state.velocity, motion.state.angular_velocity)


@executor(nogil=True)
def _all_accelerations(like: TreeLayout, instants: Buffer, out: Buffer) -> None:
    """Write `_Turned` for each instant; the rows of the buffers hold the leaves."""
    for i in range(instants.shape[0]):
        write(_accelerations(read(like, instants[i], 0, 1, 0)), out[i], 0, 1, 0)


def turning_by_equations(
    model: Model, flight: FlightResult, thrusts: list[Array], reactions: list[Array | float]
) -> Array:
    """Angular acceleration of the main body, body axes [rad/s²], shape (instants, 3).

    Whether the arms were locked is not recorded.  They were not while one of them moves; where none
    does, they were if the recorded acceleration is then closer to that of the equations.

    Args:
        model: Of the flight.
        flight: With its trajectory.
        thrusts: Of each rotor in the equations of motion [N], each of shape (instants,).
        reactions: Of rotors that change speed, each about its axis, or, of those of arms, about
            body z [N m].
    """
    c, states = flight.columns, states_at(model, flight.columns, slice(None))
    turned = reactions if model.airframe.rotors else [sum(reactions)]
    acting = [*thrusts, *(np.broadcast_to(one, len(states)) for one in turned)]
    arms = len(model.airframe.arms)
    free, locked = (_evaluated(model, states, acting, released) for released in (1.0, 0.0))
    recorded = np.stack([c[f"a{axis}"] for axis in "xyz"], axis=1)
    names = [name for j in range(1, arms + 1) for name in (f"dl{j}", f"dbend{j}") if name in c]
    moving = np.any([c[name] != 0.0 for name in names], axis=0)
    away = [np.linalg.norm(found[:, :3] - recorded, axis=1) for found in (free, locked)]
    stays = ~moving & (away[1] < away[0])
    return np.where(stays[:, None], locked[:, 3:], free[:, 3:])


def _evaluated(model: Model, states: Array, acting: list[Array], released: float) -> Array:
    """Leaves of `_Turned`, one row for each instant."""
    rotors = len(model.thrust)
    turned = ((0.0,) * rotors,) if model.airframe.rotors else (0.0,)
    like = _Acting(model, (0.0,) * rotors, turned, released, model_state(model))
    constants = np.array(leaves(model))
    given = [np.broadcast_to(constants, (len(states), len(constants))), np.stack(acting, axis=1)]
    instants = np.hstack([*given, np.full((len(states), 1), released), states])
    out, own = np.zeros((len(states), 6)), own_types(like)
    plain = getattr(_all_accelerations, "py_func", _all_accelerations)
    run = user_executor(plain, sources(own), nogil=True) if own else _all_accelerations
    run(TreeLayout(like), np.ascontiguousarray(instants), out)
    return out
