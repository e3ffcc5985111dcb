"""Thrusts over time in a flight without a pilot: a table of instants, linear in between.

The loop over steps knows one stretch between two instants, its thrusts and their slopes: a member
of `springback.simulation.measuring.record.Model` that is empty for constant thrusts.  A flight is
flown stretch by stretch.  A step ends at each instant, so that no Runge–Kutta step has a kink
within it, and the method keeps its order.
"""

from __future__ import annotations

import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from springback.dynamics.limbs.locked import OneBody, RigidState, rigid_body
from springback.dynamics.rigid import RigidStep, driven_step
from springback.kernels.compiler import kernel
from springback.kernels.trees import axpy, fold, replace

#: A flight ends within this time of its end, a stretch of it likewise [s].
ARRIVED = 1e-12

Array = np.ndarray[Any, np.dtype[np.float64]]


class Ramp(NamedTuple):
    """Slope of the thrusts on one stretch."""

    since: float  # time at which the thrusts of the model are those of the rotors [s]
    slope: tuple[float, ...]  # of each rotor [N/s]


@kernel
def _ramped(thrust: tuple[float, ...], ramp: Ramp, time: float) -> tuple[float, ...]:
    return axpy(thrust, ramp.slope, time - ramp.since)


@kernel
def model_at(model: Any, time: float) -> Any:
    """Model of a flight with the thrusts of an instant [s]; the same if they are constant."""
    return replace(model, thrust=fold(_ramped, model.thrust, model.ramp, (time,)))


@kernel
def body_at(model: Any, lengths: tuple[float, ...], time: float) -> OneBody:
    """The vehicle as one rigid body, under the thrusts of an instant.

    Args:
        model: Of the flight.
        lengths: Of the arms [m].
        time: The instant [s].
    """
    thrust = model_at(model, time).thrust
    body: OneBody = rigid_body(model.airframe, lengths, thrust, model.reaction)
    return body


@kernel
def ramped_step(
    constant: RigidStep,
    ramp: Ramp,
    model: Any,
    lengths: tuple[float, ...],
    time: float,
    x: RigidState,
    h: float,
) -> RigidStep:
    """Step as one rigid body under thrusts that change.

    Args:
        constant: The same under constant thrusts, which this replaces.
        ramp: Of the model.
        model: Of the flight.
        lengths: Of the arms [m].
        time: At the beginning of the step [s].
        x: Motion then.
        h: Step [s].
    """
    begin, middle = body_at(model, lengths, time), body_at(model, lengths, time + 0.5 * h)
    bodies = begin, middle, body_at(model, lengths, time + h)
    return driven_step(model.guide, model.air, bodies, model.world.gravity, x, h)


# -- tables ---------------------------------------------------------------------------------------


class Stretch(NamedTuple):
    """Part of a flight on which thrusts are linear."""

    end: float  # [s]; infinite for the last
    thrust: tuple[float, ...]  # at ``ramp.since`` [N]
    ramp: Ramp


class ThrustTable(NamedTuple):
    """Thrusts at some instants; before the first and after the last they are constant."""

    time: tuple[float, ...]  # not decreasing; twice the same for a jump [s]
    values: tuple[tuple[float, ...], ...]  # of each rotor at each instant [N]

    def stretches(self, until: float = math.inf) -> list[Stretch]:
        """The stretches of a flight from time 0 until its end [s]."""
        early = [(0.0, self.values[0])] if self.time[0] > 0.0 else []
        knots = [*early, *zip(self.time, self.values, strict=True), (math.inf, self.values[-1])]
        found = []
        for (begin, thrust), (end, reached) in itertools.pairwise(knots):
            if begin < end and begin < until - ARRIVED:
                pairs = zip(thrust, reached, strict=True)
                slope = tuple((after - now) / (end - begin) for now, after in pairs)
                found.append(Stretch(end, thrust, Ramp(begin, slope)))
        return found

    def at(self, times: Any) -> Array:
        """Thrusts at some instants, at a jump those after it [N], shape (instants, rotors)."""
        t, stretches = np.asarray(times, dtype=np.float64), self.stretches()
        which = np.searchsorted([one.end for one in stretches], t + ARRIVED, "right")
        begin = np.array([one.ramp.since for one in stretches])[which]
        thrust = np.array([one.thrust for one in stretches])[which]
        slope = np.array([one.ramp.slope for one in stretches])[which]
        return np.asarray(thrust + (t - begin)[:, None] * slope)
