"""The job that everything here is timed on, and our own executor doing it.

A compliant quadrotor flies into a wall: the five-body model, all its measures and its energy
ledger, at the impact step throughout, so that every flight takes the same number of steps and a
step means the same in every program.
"""

from __future__ import annotations

import time
from typing import Any, NamedTuple

import numpy as np

from springback.contact.cage import Ring
from springback.contact.obstacles import Forces, Obstacle, Plane, World
from springback.contact.surfaces import Surface, ThreeHalves
from springback.dynamics.air import Still
from springback.dynamics.motion import Free
from springback.kernels.layout import TreeLayout, rows
from springback.kernels.trees import leaves, names
from springback.kernels.vectors import Quat, Vec
from springback.simulation import flight
from springback.simulation.executor import advance
from springback.simulation.lanes import empty_groups
from springback.simulation.measuring.record import Model, Timing
from springback.simulation.stages import split_flight
from springback.vehicle.library import VEHICLES
from springback.vehicle.state import State

Array = np.ndarray[Any, np.dtype[np.float64]]

IMPACT_STEP = 1e-4  # [s]


def reference_model(until: float = 0.1, free_step: float = IMPACT_STEP) -> Model:
    """The paper's vehicle before a wall at x = 1 m, at hovering thrust; built only here.

    Args:
        until: Duration of a flight [s].
        free_step: Step away from contact [s]; equal to the impact step unless asked otherwise.
    """
    # Without its hull, which the other programs do not have and nothing here would touch.
    airframe = VEHICLES["arq"].vehicle.airframe()._replace(hull=())
    surface = Surface(
        stiffness=1e5,
        dissipation=0.6,
        viscosity=0.0,
        exponent=ThreeHalves(1.5),
        friction=0.8,
        vertical=0.0,
        slip_speed=0.1,
        restitution=-1.0,
    )
    wall = Obstacle(Plane(Vec(-1.0, 0.0, 0.0), -1.0), surface, 0.0)
    timing = Timing(
        until=until,
        free_step=free_step,
        impact_step=IMPACT_STEP,
        settle_step=IMPACT_STEP,
        arm_tolerance=1e-5,
        rate_tolerance=1e-3,
        dwell=0.02,
        hybrid=1.0,
    )
    hover = airframe.mass * 9.81 / len(airframe.arms)
    return Model(
        airframe=airframe,
        world=World((wall,), Forces(0.0), 9.81),
        contact_point=Ring(1e-3),
        guide=Free(0.0),
        air=Still(0.0),
        thrust=(hover,) * len(airframe.arms),
        timing=timing,
    )


def starts(model: Model, count: int) -> list[State]:
    """States just before the wall, at 1 to 3 m/s, turned and turning a little, each its own way."""
    lengths = tuple(arm.length for arm in model.airframe.arms)
    chance = np.random.default_rng(1)
    made = []
    for speed in np.linspace(1.0, 3.0, count):
        q = np.array([1.0, *chance.normal(0.0, 0.1, 3)])
        q /= np.linalg.norm(q)
        state = flight.still_state(lengths)
        made.append(
            state._replace(
                position=Vec(0.68, 0.0, 1.0),
                attitude=Quat(*map(float, q)),
                velocity=Vec(float(speed), 0.0, 0.0),
                angular_velocity=Vec(*map(float, chance.normal(0.0, 0.5, 3))),
            )
        )
    return made


class Outcome(NamedTuple):
    """What a program makes of the flights, by the names of our leaves: one value a flight."""

    seconds: float
    values: dict[str, Array]

    @property
    def rate(self) -> float:
        """Steps a second, all flights together."""
        return float(self.values["stepping.steps"].sum()) / self.seconds


class Lanes:
    """Our executor with many flights in lanes.

    Args:
        model: Of all flights.
        states: One for each flight.
        width: Lanes of a group.
    """

    def __init__(self, model: Model, states: list[State], width: int) -> None:
        """Lay the flights into buffers."""
        self.shape, self.width, self.count = flight.shape_of(model, states[0]), width, len(states)
        self.loaded = flight.flight_buffers(self.shape, [model], states, width)
        self.buffers = empty_groups(self.shape, len(states), width)
        self.columns = ["motion." + n for n in names(self.shape.motion)], names(self.shape.record)

    def run(self, threads: int) -> Outcome:
        """Fly all; only the flying is timed."""
        self.buffers[:] = self.loaded
        began = time.perf_counter()
        flight.fly_buffers(self.shape, self.buffers, self.width, threads=threads)
        seconds = time.perf_counter() - began
        lanes = self.buffers.reshape(len(self.buffers), -1, self.width).transpose(1, 0, 2)
        table = lanes.reshape(len(lanes), -1)[:, : self.count]
        motion, record = self.columns
        at = rows(self.shape.model)
        values = dict(zip(motion, table[at : at + len(motion)], strict=True))
        values |= dict(zip(record, table[-len(record) :], strict=True))
        return Outcome(seconds, {name: row.copy() for name, row in values.items()})


class Single:
    """Our executor with one long flight alone, no trajectory kept."""

    def __init__(self, model: Model, state: State) -> None:
        """Lay the flight into a buffer."""
        self.shape = flight.shape_of(model, state)
        self.loaded = flight.flight_buffers(self.shape, [model], [state], 1)
        self.steps = names(self.shape.record).index("stepping.steps") - rows(self.shape.record)

    def run(self) -> float:
        """Seconds a step."""
        buffers = empty_groups(self.shape, 1, 1)
        buffers[:] = self.loaded
        log, lanes = flight.empty_log(), split_flight(TreeLayout(self.shape), buffers)
        began = time.perf_counter()
        while advance(TreeLayout(self.shape), buffers, lanes, log, flight.SLICE, 0.0):
            pass
        return (time.perf_counter() - began) / float(buffers[0, self.steps])


def inputs(model: Model, states: list[State], wanted: list[str]) -> Array:
    """Leaves of model and state by name, one flight a row; each program has its own order."""
    labels = [*names(model), *("state." + n for n in names(states[0]))]
    order = [labels.index(name) for name in wanted]
    numbers = leaves(model)
    return np.array([[*numbers, *leaves(state)] for state in states])[:, order]
