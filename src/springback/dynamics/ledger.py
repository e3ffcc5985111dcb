"""The energy ledger: work since the start, its balance at the end, and whether it closes.

Its history is in `springback.results.energy_history`.
"""

from __future__ import annotations

from functools import reduce
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from springback.dynamics.moving_obstacles import BodyWork
from springback.kernels.vectors import Vec

Array = npt.NDArray[Any]

#: A ledger closes if its residual is at most this share of the largest energy ...
TOLERANCE = 1e-4
#: ... or less than this, the rounding of heights and speeds of a vehicle at rest [J].
ROUNDING = 1e-9


class Work(NamedTuple):
    """Energies and impulse exchanged since the start, integrated with the motion."""

    thrust: float  # put in by the rotors [J]
    arm: float  # taken by arm dampers [J]
    stop: float  # taken by end stops [J]
    contact: float  # taken by contact damping, and by guards that lose stiffness [J]
    friction: float  # taken by friction [J]
    settling: float  # lost when settled arms are locked again [J]
    air: float  # taken by the air; negative where wind adds energy [J]
    impulse: Vec  # of the contact forces, world [N s]
    bodies: tuple[BodyWork, ...] = ()  # by obstacles that move; mostly none


class LedgerBalance(NamedTuple):
    """Balance of the energy ledgers of many flights, shape (flights,) each."""

    start: Array  # mechanical energy at the start, gravity above the start [J]
    end: Array  # the same at the end [J]
    residual: Array  # unaccounted energy, as a share of the largest energy
    driven: Array  # work of what moves obstacles as prescribed [J]
    in_obstacles: Array  # taken by joints of obstacles and their contacts with the world [J]
    closes: Array  # True if that is within `TOLERANCE`, or `ROUNDING`


def ledger_balance(work: Any, before: Any, after: Any) -> LedgerBalance:
    """Balance of energy and work: end − start − work of rotors and drives + losses, ideally zero.

    Energies are those of the vehicle and of all obstacles that move by themselves.

    Args:
        work: `Work` since the start, whose leaves are columns.
        before: `springback.dynamics.energy.Energy` at the start, likewise.
        after: `springback.dynamics.energy.Energy` at the end, likewise.
    """
    w, ground = work, before.gravity
    held = ground + before.obstacles  # height and obstacles count from the start
    start, end = before.total - held, after.total - held
    driven, in_obstacles = np.zeros_like(start), np.zeros_like(start)
    for body in w.bodies:
        in_obstacles = in_obstacles + body.joint + body.contact + body.friction
        driven = driven + body.driven
    losses = w.arm + w.stop + w.contact + w.friction + w.settling + w.air + in_obstacles
    fallen = np.abs(after.gravity - ground)
    moved = np.abs(after.obstacles - before.obstacles)
    work_done = np.abs(w.thrust), np.abs(w.air), np.abs(driven)
    energies = before.kinetic, after.kinetic, losses, fallen, moved, *work_done
    scale = reduce(np.maximum, energies)
    with np.errstate(divide="ignore", invalid="ignore"):
        left_over = end - start - w.thrust - driven + losses
        residual = np.where(scale > 0.0, left_over / scale, 0.0)
        closes = (np.abs(residual) <= TOLERANCE) | (np.abs(left_over) <= ROUNDING)
    return LedgerBalance(start, end, residual, driven, in_obstacles, closes)
