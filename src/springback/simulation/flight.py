"""Flights without avionics, one or many: the Python side of the executor."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Literal, NamedTuple

import numpy as np

from springback.contact.cage import moving_bodies
from springback.contact.hull_contact import arm_flags, hull_flags
from springback.contact.laws.hysteresis import no_point
from springback.contact.laws.memory import arm_memory, hull_memory
from springback.contact.moving.scene import MovingScene
from springback.contact.scene.faces import SolidScene
from springback.dynamics.crossing import Crossing
from springback.dynamics.energy import Energy, energy
from springback.dynamics.limbs.arms import ArmView
from springback.dynamics.motion import Engaged, HullView, Motion, View, Work
from springback.dynamics.moving_obstacles import BodyWork
from springback.dynamics.obstacle_views import NO_VIEW
from springback.kernels.compiler import Origin, implementations, user_executor
from springback.kernels.concurrent.compilation import compile_with_help
from springback.kernels.frozen import frozen_digest
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows
from springback.kernels.trees import leaves, names, rebuilt
from springback.kernels.vectors import Quat, Vec
from springback.simulation.executor import TrajectoryLog, advance, has_space
from springback.simulation.lanes import (
    Shape,
    SplitFlight,
    buffer_rows,
    empty_groups,
    lanes_of,
    places,
)
from springback.simulation.measuring.record import (
    FLYING,
    FREE_FLIGHT,
    IMPACT,
    Model,
    Record,
    blank_record,
)
from springback.simulation.stages import is_compiled, rates_apart, rates_arguments, split_flight
from springback.simulation.thrusts import ARRIVED, ThrustTable
from springback.simulation.trajectory import StoredRows, check_instants
from springback.vehicle.arms.bent import BentArm
from springback.vehicle.limits import LoadLimits, initial_loads
from springback.vehicle.placed.rotors import propellers_of
from springback.vehicle.state import (
    Airframe,
    Bend,
    Bristles,
    PartMemory,
    PressedPoints,
    Shell,
    State,
    VehicleMemory,
)

Executor = Literal["compiled", "python"]

#: Lanes of a group: they fill the vector registers, and their data with the registers that the
#: compiler spills still fit the first-level cache.
LANES = 8
#: Steps between two checks for an interrupt and updates of the progress bar.
SLICE = 20_000
LOG_ROWS = 4_096
#: Time at which this process read its first sources [s since the epoch].
BEGUN = time.time()


class Trace(NamedTuple):
    """A trajectory: one row for each instant, columns named after the leaves of motion and view."""

    columns: tuple[str, ...]
    values: Buffer

    def __getitem__(self, name: str) -> Buffer:  # type: ignore[override]  # by name, not by place
        column: Buffer = self.values[:, self.columns.index(name)]
        return column


class FlightRecord(NamedTuple):
    """Result of one flight."""

    model: Model
    start: State
    motion: Motion
    record: Record
    trace: Trace | None

    @property
    def before(self) -> Energy:
        """Energy at the start."""
        m = self.model
        return energy(m.airframe, m.world, m.contact_point, self.start)

    @property
    def after(self) -> Energy:
        """Energy at the end."""
        m = self.model
        return energy(m.airframe, m.world, m.contact_point, self.motion.state)


def still_work() -> Work:
    """Work of a flight that has not begun."""
    return work_of_bodies(0)


def work_of_bodies(bodies: int) -> Work:
    """Work of a flight among some moving obstacles that has not begun."""
    none = BodyWork(0.0, 0.0, 0.0, 0.0)
    return Work(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, Vec(0.0, 0.0, 0.0), (none,) * bodies)


def shape_of(model: Model, state: State) -> Shape:
    """Trees of a flight, whose structure is the layout of its buffers."""
    zero = Vec(0.0, 0.0, 0.0)
    none, obstacles, bodies = Crossing(0.0, 0.0), model.world.obstacles, len(state.bodies)
    apart = Engaged(
        tuple(arm_flags(arm, obstacles, 0.0) for arm in model.airframe.arms),
        tuple(hull_flags(hull, obstacles, 0.0) for hull in model.airframe.hull),
        (0.0,) * bodies,
    )
    of_arms = arm_memory(state.memory, model.airframe.arms)
    of_hull = hull_memory(state.memory, model.airframe.hull)
    arms = tuple(
        ArmView(0.0, 0.0, 0.0, zero, 0.0, 0.0, none, flags, 0.0, 0.0, 0.0, kept.pressed)
        for flags, kept in zip(apart.arms, of_arms, strict=True)
    )
    hulls = tuple(
        HullView(0.0, 0.0, 0.0, zero, none, flags, 0.0, kept.pressed)
        for flags, kept in zip(apart.hull, of_hull, strict=True)
    )
    seen = arms, hulls, 0.0, 0.0, 0.0, 0.0, (NO_VIEW,) * bodies
    view = View(zero, zero, zero, zero, zero, zero, *seen)
    propellers = propellers_of(model.airframe)
    rotors = len(model.thrust) if model.reaction else 0
    record = blank_record(apart, propellers, rotors)._replace(loads=initial_loads(model.limits))
    return Shape(model, Motion(state, work_of_bodies(bodies)), view, record)


def still_state(arm_lengths: Sequence[float]) -> State:
    """State at the origin, level, at rest, with arms of the given lengths [m]."""
    zero, lengths = Vec(0.0, 0.0, 0.0), tuple(float(x) for x in arm_lengths)
    return State(zero, Quat(1.0, 0.0, 0.0, 0.0), zero, zero, lengths, (0.0,) * len(lengths))


def model_state(model: Model) -> State:
    """State of the structure that a model's flights have, at rest at the origin."""
    bodies = tuple(body.start for body in moving_bodies(model.world.obstacles))
    still = still_state([0.0] * len(model.airframe.arms))._replace(bodies=bodies)
    return still._replace(memory=memory_at_start(model), bends=bends_at_rest(model.airframe))


def bends_at_rest(airframe: Airframe) -> tuple[Bend, ...]:
    """Second coordinates of arms on two joints, free and at rest; mostly there are none."""
    return tuple(Bend(0.0, 0.0) for arm in airframe.arms if isinstance(arm, BentArm))


def memory_at_start(model: Model) -> VehicleMemory | tuple[()]:
    """Memory of a vehicle that has touched nothing; `()` where nothing is remembered."""
    obstacles, airframe = model.world.obstacles, model.airframe
    scene = obstacles.still if isinstance(obstacles, MovingScene) else obstacles
    presses = isinstance(scene, SolidScene) and has_memory(scene)
    turns = any(isinstance(hull, Shell) for hull in airframe.hull)
    breaks = isinstance(model.limits, LoadLimits) and bool(model.limits.broken)
    if not (presses or turns or breaks):
        return ()
    none = Vec(0.0, 0.0, 0.0)
    bristles = (Bristles(none, none),) if presses else ()

    def part(faces: tuple[float, ...], hull: Any = None) -> PartMemory:
        points = PressedPoints(0.0, (no_point(),) * len(faces))
        spin = (none,) if isinstance(hull, Shell) else ()
        whole = (1.0,) if breaks and hull is None else ()
        return PartMemory(bristles, (points,) if presses else (), spin, whole)

    return VehicleMemory(
        tuple(part(arm_flags(arm, obstacles, 0.0)) for arm in airframe.arms),
        tuple(part(hull_flags(hull, obstacles, 0.0), hull) for hull in airframe.hull),
    )


def has_memory(scene: SolidScene) -> bool:
    """True if contacts with a scene have a state: that of all its laws, to be one structure."""
    return scene.bristles > 0.0 or scene.remembers > 0.0 or scene.memory > 0.0


def with_spin(memory: Any, spin: Vec) -> Any:
    """Memory of a vehicle whose shell turns by itself, with an angular velocity, world [rad/s]."""
    hull = tuple(one._replace(spin=(spin,)) for one in memory.hull)
    return memory._replace(hull=hull)


def flight_buffers(
    shape: Shape, models: Sequence[Model], states: Sequence[State], width: int
) -> Buffer:
    """Buffers with each flight in its lane; spare lanes repeat the last flight, already ended."""
    buffers = empty_groups(shape, len(states), width)
    lanes = buffers.reshape(len(buffers), -1, width)
    status = row_of(shape.record.stepping, "status") - rows(shape.record)
    for k in range(len(buffers) * width):
        group, lane = divmod(k, width)
        flight = min(k, len(states) - 1)
        model = models[min(flight, len(models) - 1)]
        lanes[group, :, lane] = flight_column(shape, model, states[flight], width)
        if k >= len(states):
            lanes[group, status, lane] = FLYING + 1.0
    return buffers


def flight_column(shape: Shape, model: Model, state: State, width: int) -> Buffer:
    """Content of a flight's lane at the start, in a buffer of some width; shape (rows,)."""
    column, record = np.zeros(buffer_rows(shape, width)), leaves(shape.record)
    begin = leaves(model) + leaves(state) + leaves(shape.motion.work)
    column[: len(begin)] = begin
    column[-len(record) :] = record
    column[row_of(shape.record.stepping, "phase") - len(record)] = first_phase(model, state)
    return column


def first_phase(model: Model, state: State) -> float:
    """IMPACT if a sliding arm starts away from its free length or moving, else FREE_FLIGHT."""
    for arm, length, rate in zip(
        model.airframe.arms, state.arm_length, state.arm_rate, strict=True
    ):
        if arm.compliance > 0.0 and (length != arm.length or rate != 0.0):
            return IMPACT
    moves = any(arm.compliance > 0.0 for arm in model.airframe.arms)
    if moves and any(bend.way != 0.0 or bend.rate != 0.0 for bend in state.bends):
        return IMPACT
    return FREE_FLIGHT


def flight_records(
    shape: Shape, models: Sequence[Model], states: Sequence[State], buffers: Buffer, width: int
) -> list[FlightRecord]:
    """Results of each flight, read from the buffers."""
    lanes = buffers.reshape(len(buffers), -1, width)
    model_rows, motion_rows = rows(shape.model), rows(shape.motion)
    record_rows = rows(shape.record)
    flown = []
    for k, start in enumerate(states):
        group, lane = divmod(k, width)
        column = lanes[group, :, lane]
        motion = rebuilt(shape.motion, column[model_rows : model_rows + motion_rows])
        record = rebuilt(shape.record, column[-record_rows:])
        m = models[min(k, len(models) - 1)]
        flown.append(FlightRecord(m, start, motion, record, None))
    return flown


def own_types(tree: Any) -> set[type]:
    """Types in a tree that are not the package's: a user's own obstacles and pilots."""
    found: set[type] = set()
    _gather_types(tree, found)
    named = {cls for cls in found if hasattr(cls, "_fields")}
    return {cls for cls in named if not cls.__module__.startswith("springback.")}


def _gather_types(tree: Any, found: set[type]) -> None:
    found.add(type(tree))
    for branch in tree:
        if isinstance(branch, tuple):
            _gather_types(branch, found)


def sources(types: set[type]) -> Origin | None:
    """Origin of a user's own types, of the functions registered for them, and of their neighbours.

    It is None if their kernels must not be cached: those of a script or of an interactive session,
    those of a file that has changed since this process began, which may have read it before, and
    those that use values from elsewhere of which there is no digest.
    """
    entries = [entry for cls in types for entry in (cls, *implementations(cls))]
    entries = [entry for entry in entries if not entry.__module__.startswith("springback.")]
    own = {entry.__module__ for entry in entries}
    files = {getattr(sys.modules.get(name), "__file__", None) for name in own}
    if "__main__" in own or None in files:
        return None
    named = sorted({str(file) for file in files} | _beside({str(file) for file in files}))
    frozen = frozen_digest(sorted(entries, key=lambda one: (one.__module__, one.__qualname__)))
    try:
        if frozen is None or not all(os.path.getmtime(file) < BEGUN for file in named):
            return None
    except OSError:
        return None
    return Origin(tuple(named), tuple(sorted(own)), frozen)


def _beside(files: set[str]) -> set[str]:
    """Files of loaded modules in the folders of some files or below, without installed ones."""
    folders = tuple(os.path.join(os.path.dirname(file), "") for file in files)
    installed = (sys.prefix + os.sep, sys.base_prefix + os.sep)
    loaded_from = {
        str(getattr(module, "__file__", None) or "")
        for name, module in list(sys.modules.items())
        if name != "__main__" and not name.startswith("springback.")
    }
    return {
        file for file in loaded_from if file.startswith(folders) and not file.startswith(installed)
    }


def entry_for(model: Model, executor: Executor = "compiled") -> Any:
    """The executor for a model: compiled, or the same source as plain Python."""
    plain = getattr(advance, "py_func", advance)
    own = own_types(model)
    if executor == "python":
        return plain
    return user_executor(plain, sources(own), nogil=True) if own else advance


def is_split(model: Model, executor: Executor) -> bool:
    """True if the physics of a single flight is compiled apart from the loop over its steps.

    That of a user's own types is compiled with all that uses it, in a cache of its own.
    """
    return executor == "compiled" and not own_types(model)


def fly_to_end(
    shape: TreeLayout,
    buffers: Buffer,
    lanes: tuple[int, ...],
    log: TrajectoryLog,
    budget: int,
    early: float,
) -> None:
    """Calls of `fly_one`, for another process that compiles them."""
    rates_apart(shape, buffers[0], early, early > 0.0)
    advance(shape, buffers, lanes, log, budget, early)


def fly_one(
    model: Model,
    start: State,
    *,
    thrusts: ThrustTable | None = None,
    trace: bool = True,
    interval: float = 0.0,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> FlightRecord:
    """Fly one flight to its end.

    Args:
        model: Of the flight.
        start: State at time 0.
        thrusts: Thrusts over time, of a model with a `Ramp`.
        trace: Record the trajectory.
        interval: Of which the trajectory keeps the first step [s]; 0: it keeps each.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter (slow).
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If the trajectory would have too many instants to be recorded.
    """
    shape = shape_of(model, start)
    buffers = flight_buffers(shape, [model], [start], 1)
    width = 1 + rows(shape.motion) + rows(shape.seen)
    stored = StoredRows(width, interval)
    run, like = entry_for(model, executor), TreeLayout(shape)
    record_row, log = -rows(shape.record), empty_log(LOG_ROWS if trace else 0, width)
    lanes = lanes_of(1)
    if is_split(model, executor):
        if not is_compiled(like):
            given = like, buffers, SplitFlight(0), log, SLICE, 0.0
            physics = rates_arguments(like, buffers)
            compile_with_help([(advance, given), (rates_apart, physics)], (fly_to_end, given))
        lanes = split_flight(like, buffers)
    for early in _stretches(shape, buffers, 1, thrusts):
        flying = 1
        while flying:
            flying = run(like, buffers, lanes, log, SLICE, early)
            time_now = float(buffers[0, record_row])
            check_instants(stored.count + log.used[0], time_now, model.timing.until)
            if progress is not None:
                progress(time_now)
            if not has_space(log):
                stored.add(log.rows)
                log = empty_log(LOG_ROWS, width)
    stored.add(log.rows[: log.used[0]])
    flown = flight_records(shape, [model], [start], buffers, 1)[0]
    if not trace:
        return flown
    return flown._replace(trace=Trace(trace_columns(shape), stored.all()))


def _stretches(
    shape: Shape, buffers: Buffer, width: int, thrusts: ThrustTable | None
) -> Iterator[float]:
    """Stretches of some flights, one after another: their thrusts and ends are written to buffers.

    Yields:
        The argument ``early`` of `springback.simulation.executor.advance`.
    """
    if thrusts is None:
        yield 0.0
        return
    at, lanes = places(shape, width), buffers.reshape(len(buffers), -1, width)
    thrust, ramp, row = (row_of(shape.model, name) for name in ("thrust", "ramp", "timing"))
    until = lanes[:, row].copy()  # the first field of the timing
    stretches = thrusts.stretches(float(until.max()))
    for stretch in stretches:
        goes_on = (until > stretch.ramp.since + ARRIVED)[:, None]  # others keep their last thrusts
        changes = [(row, (stretch.end,)), (thrust, stretch.thrust), (ramp, leaves(stretch.ramp))]
        changes.append((at.step, (0.0,)))  # thrusts have a kink here: no peak is interpolated
        for first, values in changes:
            part = lanes[:, first : first + len(values)]
            part[:] = np.where(goes_on, np.array(values)[:, None], part)
        lanes[:, row] = np.minimum(until, lanes[:, row])
        yield 0.0 if stretch is stretches[-1] else 1.0


def empty_log(rows: int = 0, columns: int = 1) -> TrajectoryLog:
    """Log for a number of instants; without any, no trajectory is recorded."""
    return TrajectoryLog(np.zeros((rows, columns)), np.zeros(1, dtype=np.int64))


def trace_columns(shape: Shape) -> tuple[str, ...]:
    """Names of the columns of a trajectory."""
    return ("time", *names(shape.motion), *names(shape.seen))


def fly_many(
    models: Sequence[Model],
    starts: Sequence[State],
    *,
    thrusts: ThrustTable | None = None,
    threads: int | None = None,
    width: int = LANES,
    progress: Callable[[float], None] | None = None,
) -> list[FlightRecord]:
    """Fly many flights, whose models have one structure, in lanes and on several threads.

    Args:
        models: One for each flight, or a single one for all.
        starts: One state for each flight.
        thrusts: Thrusts over time of all flights, of models with a `Ramp`.
        threads: Number of threads; by default that of processors.
        width: Lanes in a group.
        progress: Called from time to time with the share of groups done.
    """
    shape = shape_of(models[0], starts[0])
    buffers = flight_buffers(shape, models, starts, width)
    fly_buffers(shape, buffers, width, thrusts=thrusts, threads=threads, progress=progress)
    return flight_records(shape, models, starts, buffers, width)


def fly_buffers(
    shape: Shape,
    buffers: Buffer,
    width: int,
    *,
    thrusts: ThrustTable | None = None,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Fly all flights to their end, in their buffers.

    Args:
        shape: Layout of the buffers.
        buffers: Shape (groups, rows x width).
        width: Lanes in a group.
        thrusts: Thrusts over time of all flights, of models with a `Ramp`.
        threads: Number of threads; by default that of processors.
        progress: Called from time to time with the share of groups done.
    """
    like = TreeLayout(shape)
    lanes, run = lanes_of(width), entry_for(shape.model)
    workers = threads or os.cpu_count() or 1
    chunk = max(1, -(-len(buffers) // (8 * workers)))

    def fly_chunk(first: int) -> int:
        last = min(first + chunk, len(buffers))
        for early in _stretches(shape, buffers[first:last], width, thrusts):
            while run(like, buffers[first:last], lanes, empty_log(), SLICE, early):
                pass
        return last - first

    done = 0
    with ThreadPoolExecutor(workers) as pool:
        for count in pool.map(fly_chunk, range(0, len(buffers), chunk)):
            done += count
            if progress is not None:
                progress(done / len(buffers))
