"""Two vehicles in one world: the Python side, from tick to tick."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from springback.contact.laws.memory import hull_memory
from springback.contact.moving.scene import scene_with
from springback.contact.obstacles import Forces
from springback.contact.scene.faces import SolidScene
from springback.contact.surfaces import Surface
from springback.dynamics.moving_obstacles import flown_scene
from springback.dynamics.touches import PartPush, Pushes
from springback.kernels.concurrent.compilation import compile_with_help
from springback.kernels.layout import Buffer, rows
from springback.kernels.trees import rebuilt
from springback.kernels.vectors import Vec
from springback.simulation.flight import (
    LOG_ROWS,
    FlightRecord,
    Trace,
    empty_log,
    flight_buffers,
    flight_records,
    memory_at_start,
    own_types,
    shape_of,
    trace_columns,
    with_spin,
)
from springback.simulation.guided import (
    TICKS,
    GuidedFlown,
    TickRange,
    avionics_buffers,
    telemetry_head,
    ticks_of,
)
from springback.simulation.measuring.record import Model
from springback.simulation.onboard import Avionics
from springback.simulation.pair.parts import carried_bodies, parts_of
from springback.simulation.pair.solids import PartSolid, remember
from springback.simulation.pair.stepping import (
    NoAvionics,
    PairedBuffers,
    begin_and_end_both,
    pair_guide,
)
from springback.simulation.ticks import GUST_NOISE, FlightLog, layouts_of
from springback.simulation.trajectory import StoredRows, check_instants
from springback.vehicle.state import State


class PairedFlight(NamedTuple):
    """One of two vehicles, before the start."""

    model: Model  # in a world that is a scene
    start: State
    avionics: Avionics | None
    noise: Buffer | None  # of its sensors, shape (ticks, channels)
    solids: tuple[tuple[PartSolid, ...], ...] = ()  # of its parts, if the other one can touch them


class _Side:
    """One of two vehicles while it flies."""

    def __init__(
        self, flight: PairedFlight, trace: bool, interval: float, ticks: int, period: float
    ) -> None:
        self.flight = flight
        self.shape = shape_of(flight.model, flight.start)
        self.motion = flight_buffers(self.shape, [flight.model], [flight.start], 1)
        self.columns = len(trace_columns(self.shape))
        self.stored = StoredRows(self.columns, interval)
        self.trace = trace
        self.log = self._new_log()
        self.avionics: Any = flight.avionics or NoAvionics(period)
        self.onboard = avionics_buffers([self.avionics], 1)
        self.noise, head = np.zeros((ticks, GUST_NOISE)), list[str]()
        if flight.avionics is not None:
            assert flight.noise is not None
            self.noise = flight.noise
            head = telemetry_head(flight.avionics) if trace else []
        self.layouts = layouts_of(self.shape, self.avionics, self.noise.shape[1] - GUST_NOISE)
        self.head = tuple(head)
        self.telemetry = np.zeros((ticks if head else 0, max(len(head), 1)))

    def _new_log(self) -> Any:
        return empty_log(LOG_ROWS, self.columns) if self.trace else empty_log()

    def keep_log(self) -> None:
        """Put the log aside, and begin another."""
        self.stored.add(self.log.rows[: self.log.used[0]])
        self.log = self._new_log()

    @property
    def in_flight(self) -> PairedBuffers:
        """For the executor, until the log is full."""
        log = FlightLog(self.log, self.telemetry)
        return PairedBuffers(self.layouts, self.motion[0], self.onboard[0], self.noise, log)

    def result(self) -> GuidedFlown | FlightRecord:
        """Result."""
        flight = self.flight
        flown = flight_records(self.shape, [flight.model], [flight.start], self.motion, 1)[0]
        if self.trace:
            self.keep_log()
            flown = flown._replace(trace=Trace(trace_columns(self.shape), self.stored.all()))
        if flight.avionics is None:
            return flown
        at = rows(flight.avionics.systems)
        after = rebuilt(flight.avionics.onboard, self.onboard[0, at:])
        return GuidedFlown(flown, after, Trace(self.head, self.telemetry) if self.trace else None)


def beside_each_other(
    first: PairedFlight, second: PairedFlight, surface: Surface
) -> tuple[PairedFlight, PairedFlight]:
    """Two flights that know of each other: their parts are moving obstacles of the other one.

    Args:
        first: In a world that is a scene at rest.
        second: Likewise.
        surface: Of the contact between both.
    """

    def beside(one: PairedFlight, other: PairedFlight, surface: Surface | None) -> PairedFlight:
        still = one.model.world.obstacles
        assert isinstance(still, SolidScene)
        bodies = carried_bodies(other.model.airframe, other.solids, other.start, surface)
        if surface is not None and remember(surface, other.solids):
            still = still._replace(remembers=1.0)
        scene = flown_scene(scene_with(still, bodies))
        world = one.model.world._replace(obstacles=scene, laws=Forces(0.0))
        model = one.model._replace(world=world)
        memory, spins = (
            memory_at_start(model),
            hull_memory(one.start.memory, one.model.airframe.hull),
        )
        for spin in (spin for part in spins for spin in part.spin):
            memory = with_spin(memory, spin)
        parts = parts_of(other.model.airframe, other.start)
        start = one.start._replace(bodies=parts, memory=memory)
        avionics = one.avionics
        if avionics is not None:
            onboard = avionics.onboard._replace(before=start)
            avionics = avionics._replace(onboard=onboard)
        return one._replace(model=model, start=start, avionics=avionics)

    still = Vec(0.0, 0.0, 0.0)
    none = PartPush(still, still, 0.0, 0.0, still, still, 0.0)
    a, b = beside(first, second, surface), beside(second, first, None)
    airframe = second.model.airframe
    apart = (0.0,) * len(b.start.bodies)
    pushes = Pushes((none,) * len(airframe.arms), (none,) * len(airframe.hull), apart)
    return a, b._replace(model=b.model._replace(pushes=pushes))


def fly_both(
    first: PairedFlight,
    second: PairedFlight,
    surface: Surface,
    *,
    period: float,
    trace: bool = True,
    interval: float = 0.0,
    progress: Callable[[float], None] | None = None,
) -> tuple[GuidedFlown | FlightRecord, GuidedFlown | FlightRecord]:
    """Fly two vehicles together.

    Args:
        first: The one on whose side contact is computed.
        second: The other one.
        surface: Of the contact between both.
        period: Of a tick [s].
        trace: Record trajectories and telemetry.
        interval: Of which trajectories keep the first step [s]; 0: they keep each.
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If a trajectory would have too many instants to be recorded.
    """
    duration = first.model.timing.until
    guided = first.avionics is not None or second.avionics is not None
    period = period if guided else duration
    ticks = ticks_of(duration, period)
    sides = beside_each_other(first, second, surface)
    a, b = (_Side(each, trace, interval, ticks, period) for each in sides)
    fly, at = pair_guide(a.avionics, b.avionics), np.zeros(3, dtype=np.int64)
    while at[0] < ticks:
        end = min(ticks, int(at[0]) + TICKS)
        given = (a.in_flight, b.in_flight, TickRange(at, end, ticks - 1, duration, False))
        if not (at[0] or own_types(a.avionics) | own_types(b.avionics)):
            compile_with_help([(fly, given)], (begin_and_end_both, given))
        fly(*given)
        instants = a.stored.count + int(a.log.used[0])
        check_instants(instants if trace else 0, float(at[0]) * period, duration)
        if trace and max(a.log.used[0], b.log.used[0]) >= LOG_ROWS:
            a.keep_log()
            b.keep_log()
        if progress is not None:
            progress(int(at[0]) * period)
    flown = a.result()
    return flown, _with_given_work(b.result(), flown)


def _with_given_work(second: Any, first: Any) -> Any:
    """The second flight, with the work that the first did on it: less what that got from it."""
    flown, other = _flown(second), _flown(first)
    got = sum(body.driven for body in other.motion.work.bodies)
    work = flown.motion.work
    bodies = (work.bodies[0]._replace(driven=-got), *work.bodies[1:])
    motion = flown.motion._replace(work=work._replace(bodies=bodies))
    trace = flown.trace
    if trace is not None and other.trace is not None:
        names = [name for name in other.trace.columns if name.endswith(".driven")]
        got_then = np.array([other.trace[name] for name in names])
        trace.values[:, trace.columns.index("work.bodies.1.driven")] = -got_then.sum(axis=0)
    whole = flown._replace(motion=motion, trace=trace)
    return second._replace(flown=whole) if isinstance(second, GuidedFlown) else whole


def _flown(result: GuidedFlown | FlightRecord) -> FlightRecord:
    return result.flown if isinstance(result, GuidedFlown) else result
