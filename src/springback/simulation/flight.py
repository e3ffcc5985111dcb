"""One flight, or many: the Python side of the executor."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Literal, NamedTuple

import numpy as np

from springback.dynamics.crossing import Crossing
from springback.dynamics.energy import Energy, energy
from springback.dynamics.motion import ArmView, HullView, Motion, View, Work
from springback.errors import InputError
from springback.kernels.compiler import Origin, implementations, user_executor
from springback.kernels.frozen import frozen_digest
from springback.kernels.layout import Buffer, TreeLayout, row_of, rows
from springback.kernels.trees import leaves, names, rebuilt
from springback.kernels.vectors import Quat, Vec
from springback.simulation.executor import advance
from springback.simulation.lanes import Shape, buffer_rows, empty_groups
from springback.simulation.record import FLYING, FREE_FLIGHT, IMPACT, Model, Record, blank_record
from springback.vehicle.state import State

Executor = Literal["compiled", "python"]

#: Flights abreast in one group: what fills the vector registers and still fits the first-level
#: cache, together with what the compiler puts aside there.
LANES = 8
#: Steps between two looks at the clock, the keyboard and the progress bar.
SLICE = 20_000
LOG_ROWS = 4_096
#: Most instants of a trajectory that are kept (chosen: some 2.5 GB with the telemetry and all
#: columns).
MOST_INSTANTS = 1_000_000
#: When this process read its first sources [s since the epoch].
BEGUN = time.time()


class Trace(NamedTuple):
    """A trajectory: one row an instant, columns named after the leaves of motion and view."""

    columns: tuple[str, ...]
    values: Buffer

    def __getitem__(self, name: str) -> Buffer:  # type: ignore[override]  # by name, not by place
        column: Buffer = self.values[:, self.columns.index(name)]
        return column


class FlightRecord(NamedTuple):
    """What the executor leaves of one flight."""

    model: Model
    start: State
    motion: Motion
    record: Record
    trace: Trace | None

    @property
    def before(self) -> Energy:
        """At the start."""
        m = self.model
        return energy(m.airframe, m.world, m.contact_point, self.start)

    @property
    def after(self) -> Energy:
        """At the end."""
        m = self.model
        return energy(m.airframe, m.world, m.contact_point, self.motion.state)


def still_work() -> Work:
    """A ledger with nothing in it."""
    return Work(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, Vec(0.0, 0.0, 0.0))


def shape_of(model: Model, state: State) -> Shape:
    """The trees of a flight, for the executor."""
    zero = Vec(0.0, 0.0, 0.0)
    arms, obstacles = len(model.airframe.arms), len(model.world.obstacles)
    hulls, apart = len(model.airframe.hull), (0.0,) * obstacles
    none = Crossing(0.0, 0.0)
    arm = ArmView(0.0, 0.0, 0.0, zero, 0.0, 0.0, none, apart, 0.0, 0.0, 0.0)
    hull = HullView(0.0, 0.0, 0.0, zero, none, apart, 0.0)
    view = View(zero, zero, zero, zero, zero, (arm,) * arms, (hull,) * hulls, 0.0, 0.0, 0.0, 0.0)
    return Shape(model, Motion(state, still_work()), view, blank_record(arms, obstacles, hulls))


def still_state(arm_lengths: Sequence[float]) -> State:
    """At the origin, level, at rest, arms as given [m]."""
    zero, lengths = Vec(0.0, 0.0, 0.0), tuple(float(x) for x in arm_lengths)
    return State(zero, Quat(1.0, 0.0, 0.0, 0.0), zero, zero, lengths, (0.0,) * len(lengths))


def loaded(shape: Shape, models: Sequence[Model], states: Sequence[State], width: int) -> Buffer:
    """Buffers with every flight in its lane; spare lanes repeat the last flight, already ended."""
    buffers = empty_groups(shape, len(states), width)
    lanes = buffers.reshape(len(buffers), -1, width)
    status = row_of(shape.record, "status") - rows(shape.record)
    for k in range(len(buffers) * width):
        group, lane = divmod(k, width)
        flight = min(k, len(states) - 1)
        model = models[min(flight, len(models) - 1)]
        lanes[group, :, lane] = flight_column(shape, model, states[flight], width)
        if k >= len(states):
            lanes[group, status, lane] = FLYING + 1.0
    return buffers


def flight_column(shape: Shape, model: Model, state: State, width: int) -> Buffer:
    """What a flight's lane holds at the start, in a buffer of some width; shape (rows,)."""
    column, record = np.zeros(buffer_rows(shape, width)), leaves(shape.record)
    begin = leaves(model) + leaves(state) + leaves(shape.motion.work)
    column[: len(begin)] = begin
    column[-len(record) :] = record
    column[row_of(shape.record, "phase") - len(record)] = first_phase(model, state)
    return column


def first_phase(model: Model, state: State) -> float:
    """An impact is taken to be on where arms start away from their free length, or moving."""
    for arm, length, rate in zip(
        model.airframe.arms, state.arm_length, state.arm_rate, strict=True
    ):
        if arm.compliance > 0.0 and (length != arm.length or rate != 0.0):
            return IMPACT
    return FREE_FLIGHT


def unloaded(
    shape: Shape, models: Sequence[Model], states: Sequence[State], buffers: Buffer, width: int
) -> list[FlightRecord]:
    """What the executor has left of every flight."""
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
    """Types in a tree that are not the package's: shapes and pilots of the user's."""
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
    """Files and modules of own types, of what is registered for them, and of the modules beside.

    None if their kernels had better not be kept: those of a script or of a session, those of a
    file that was changed while this process runs, which may have read it before, and those that
    take values from elsewhere which no digest can stand for.
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
    """Files of loaded modules in the folders of some files or below, but for what is installed."""
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


def fly_one(
    model: Model,
    start: State,
    *,
    trace: bool = True,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> FlightRecord:
    """Fly one flight to its end.

    Args:
        model: The flight's numbers.
        start: State at time 0.
        trace: Keep the trajectory: every step of it.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter (slow).
        progress: Called now and then with the simulated time [s].

    Raises:
        InputError: If the trajectory has more instants than can be kept.
    """
    shape = shape_of(model, start)
    buffers = loaded(shape, [model], [start], 1)
    width = 1 + rows(shape.motion) + rows(shape.seen)
    logs: list[Buffer] = []
    run, like = entry_for(model, executor), TreeLayout(shape)
    record_row = -rows(shape.record)
    while True:
        log = np.zeros((LOG_ROWS if trace else 0, width))
        logged = np.zeros(1, dtype=np.int64)
        flying = run(like, buffers, 0, 1, (0,), log, logged, SLICE, 0.0)
        logs.append(log[: logged[0]])
        time_now = float(buffers[0, record_row])
        check_instants(sum(map(len, logs)), time_now, model.timing.until)
        if progress is not None:
            progress(time_now)
        if not flying:
            break
    flown = unloaded(shape, [model], [start], buffers, 1)[0]
    if not trace:
        return flown
    return flown._replace(trace=Trace(trace_columns(shape), np.concatenate(logs)))


def check_instants(instants: int, reached: float, until: float) -> None:
    """Stop a flight whose trajectory has become too long to be kept.

    Args:
        instants: Of the trajectory so far, or foreseen.
        reached: Simulated time by then [s].
        until: When the flight ends [s].

    Raises:
        InputError: What there is, and what helps.
    """
    if instants > MOST_INSTANTS:
        raise InputError(
            f"simulation.duration: of {until:g} s makes a trajectory of more than {MOST_INSTANTS} "
            f"instants, which are all that can be kept; it has {instants} by {reached:.4g} s; give "
            "a shorter duration, coarser steps or a slower clock, or in Python trajectory=False"
        )


def trace_columns(shape: Shape) -> tuple[str, ...]:
    """Names of the columns of a trajectory."""
    return ("time", *names(shape.motion), *names(shape.seen))


def fly_many(
    models: Sequence[Model],
    starts: Sequence[State],
    *,
    threads: int | None = None,
    width: int = LANES,
    progress: Callable[[float], None] | None = None,
) -> list[FlightRecord]:
    """Fly many flights of equally shaped models, abreast in lanes, on several threads.

    Args:
        models: One for each flight, or a single one for all.
        starts: One state for each flight.
        threads: Defaults to the number of processors.
        width: Lanes in a group.
        progress: Called now and then with the share of groups done.
    """
    shape = shape_of(models[0], starts[0])
    buffers = loaded(shape, models, starts, width)
    fly_buffers(shape, buffers, width, threads=threads, progress=progress)
    return unloaded(shape, models, starts, buffers, width)


def fly_buffers(
    shape: Shape,
    buffers: Buffer,
    width: int,
    *,
    threads: int | None = None,
    progress: Callable[[float], None] | None = None,
) -> None:
    """Fly every group of some buffers to the end, in place."""
    like = TreeLayout(shape)
    lanes, log, run = (0,) * width, np.zeros((0, 1)), entry_for(shape.model)
    workers = threads or os.cpu_count() or 1
    chunk = max(1, -(-len(buffers) // (8 * workers)))

    def fly_chunk(first: int) -> int:
        last = min(first + chunk, len(buffers))
        logged = np.zeros(1, dtype=np.int64)
        while run(like, buffers, first, last, lanes, log, logged, SLICE, 0.0):
            pass
        return last - first

    done = 0
    with ThreadPoolExecutor(workers) as pool:
        for count in pool.map(fly_chunk, range(0, len(buffers), chunk)):
            done += count
            if progress is not None:
                progress(done / len(buffers))
