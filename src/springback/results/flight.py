"""Flying a scenario, and its result."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from springback.contact.thin_obstacles import ThinObstacle
from springback.contact.worlds import Own
from springback.errors import InputError
from springback.results.columns import telemetry_columns, trajectory_columns, work_columns
from springback.results.contacts.distances import gaps
from springback.results.contacts.places import first_obstacle, obstacle_contacts
from springback.results.contacts.thin_contacts import deep_contact
from springback.results.events import Event, events_of
from springback.results.hooks import NotebookPage, hook
from springback.results.motion import columns_at, sensor_readings, specific_force_at
from springback.results.pair.flying import fly_beside, of_second
from springback.results.recovery_measures import guided_result
from springback.results.result import FlightResult, ObstacleContact
from springback.scenario.build import ReadyFlight, user_parts
from springback.scenario.files import as_input, checked_scenario, read_scenario
from springback.scenario.flight_kernels import flights_compiled_early
from springback.scenario.overrides import apply_overrides
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.user.compiled import check_user_code, compiling
from springback.scenario.user.laws import source_text
from springback.scenario.user.pilots import (
    AnyPilot,
    chosen_pilot,
    guarded_pilot,
)
from springback.simulation.flight import Executor, FlightRecord, fly_one
from springback.simulation.guided import GuidedFlight, GuidedFlown, fly_guided, ticks_of
from springback.simulation.measuring.measures import measures_of, outcome_of
from springback.simulation.noise import noise_table
from springback.simulation.thrusts import ThrustTable
from springback.simulation.trajectory import check_instants

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = np.ndarray[Any, np.dtype[np.float64]]


class Flight(FlightResult):
    """Result of a flight.  Every measure is an attribute as well: ``flight.touch_speed``."""

    if TYPE_CHECKING:
        second: Flight | None
        """Flight of the second vehicle, if the scenario has one: at the same instants."""
        first: Flight | None
        """Of the flight of a second vehicle, that of the first."""

    @functools.cached_property
    def events(self) -> tuple[Event, ...]:
        """Events in order of time: touches, separations, peaks, stops, alarms, phases, the end.

        Raises:
            InputError: If the trajectory was not recorded.
        """
        self.need_trajectory()
        return events_of(self)

    @functools.cached_property
    def obstacle_contacts(self) -> tuple[ObstacleContact, ...]:
        """Obstacles that it touched, in order, each with its hardest contact."""
        return obstacle_contacts(self) if self.columns else ()

    def _deep(self, thin: Sequence[ThinObstacle]) -> str:
        """Warning of the first one whose forces do not hold where it was touched; else empty."""
        return deep_contact(self, thin) if self.columns else super()._deep(thin)

    @property
    def broken_parts(self) -> tuple[str, ...]:
        """What was loaded beyond its limit, and when, in order; empty without a trajectory."""
        if not self.columns or self.measures.get("broken_time") is None:
            return ()
        parts = [
            (one.label.removesuffix(" broken"), one) for one in self.events if one.kind == "broken"
        ]
        return tuple(f"{name} at {one.t:.5g} s{one.text[len(name) :]}" for name, one in parts)

    def resample(self, step: float | None = None, *, times: Any = None) -> dict[str, Array]:
        """Columns of trajectory and telemetry at evenly spaced or any other instants.

        The recorded instants are those of the integration: 0.1 ms apart in a contact, much more
        elsewhere.  Between them attitudes are interpolated spherically and all else linearly;
        telemetry keeps the value of the last tick, as on board.

        Args:
            step: Spacing of the instants from the start [s].
            times: Instants instead [s], shape (instants,).

        Raises:
            InputError: If the trajectory was not recorded, or an instant is not within it.
        """
        return columns_at(self, step, times)

    def specific_force(self, at: Sequence[float] = (0.0, 0.0, 0.0)) -> Array:
        """Specific force at a point fixed to the main body, as a perfect accelerometer feels there.

        ``Rᵀ(v̇ + g e_Z) + α × r + ω × (ω × r)``, with the exact angular acceleration α of the
        equations of motion.  At rest it is g upwards.

        Args:
            at: Position r of the point from the main body's centre of mass, body axes [m].

        Returns:
            At each instant of the trajectory, along the body axes [m/s²], shape (instants, 3).

        Raises:
            InputError: If the trajectory was not recorded, or obstacles of the user's own are
                unknown because the flight was read from a folder.
        """
        return specific_force_at(self, at)

    def gap(self, obstacle: int | None = None) -> Array:
        """Distance of each cage, and of the hull, from the obstacles, by the flight's contact laws.

        Args:
            obstacle: Number of the obstacle, from 0, in the order of the scenario and then of the
                user's own; None: the nearest one.

        Returns:
            At each instant, negative in penetration [m], shape (instants, cages), with one more
            column for the hull if there is one.

        Raises:
            InputError: If the trajectory was not recorded, there is no such obstacle, or it is the
                user's own and unknown because the flight was read from a folder.
        """
        return gaps(self, obstacle)

    # -- what the interfaces carry out --

    def save(self, folder: str | Path, *, force: bool = False, figures: bool = True) -> list[Path]:
        """Write the files that ``springback fly --out`` writes; `springback.load` reads them.

        Args:
            folder: Folder to write, completely or not at all.
            force: Replace the results in it.
            figures: Write figures too; they need matplotlib.

        Returns:
            The files.

        Raises:
            InputError: If the folder is not empty and ``force`` is false, or cannot be written.
        """
        return list(hook("Flight.save")(self, folder, force=force, figures=figures))

    def view(
        self,
        *others: Flight,
        export: str | Path | None = None,
        force: bool = False,
        browser: bool = True,
    ) -> NotebookPage:
        """Replay the flight, or several side by side, as ``springback view`` does.

        A notebook shows the result in a frame.  Elsewhere a browser is opened on
        a page that is served until Ctrl-C.

        Args:
            others: Flights to show beside it.
            export: Write a self-contained page to this file instead.
            force: Replace that file.
            browser: Open a browser; else only print the address.

        Raises:
            InputError: If a flight has no trajectory, the file exists, or an extra is missing.
        """
        view: NotebookPage = hook("Flight.view")(
            self, *others, export=export, force=force, browser=browser
        )
        return view

    def animate(
        self,
        path: str | Path,
        *others: Flight,
        slow: float = 20.0,
        begin: float | None = None,
        end: float | None = None,
        fps: float = 25.0,
        size: tuple[int, int] | None = None,
        force: bool = False,
    ) -> Path:
        """Write a film of the flight, or of two side by side, synchronised at first touch.

        Args:
            path: Ends in .gif, .webp or .mp4.
            others: At most one flight to show beside it.
            slow: Slow-motion factor of impacts.
            begin: First instant, from first touch [s]; by default shortly before it.
            end: Last instant, from first touch [s].
            fps: Frames a second.
            size: Width and height [px].
            force: Replace an existing file.

        Returns:
            The file.

        Raises:
            InputError: If there is nothing to show, the file exists, or an extra is missing.
        """
        options = {"slow": slow, "begin": begin, "end": end, "fps": fps, "size": size}
        return Path(hook("Flight.animate")(self, path, *others, force=force, **options))

    def plot(
        self,
        columns: str | Sequence[str | Sequence[str]] | None = None,
        *,
        width: float | str = "one column",
        height: float | str | None = None,
        window: tuple[float, float] | None = None,
    ) -> Figure:
        """Figure of columns over time, as wide as a column of a paper; also `springback.plot`.

        Args:
            columns: Names of columns of the trajectory or of telemetry.  Neighbours of one kind
                share a panel, as do those that are given as a list.  None draws the figure of the
                whole flight, whatever the width.
            width: ``one column`` (88 mm), ``two columns`` (180 mm), a number [m], or ``"120 mm"``.
            height: Height of the figure; by default 30 mm for each panel.
            window: First and last instant shown [s].

        Raises:
            InputError: If matplotlib is not installed, the flight has no trajectory, a column does
                not exist, or a size is out of range.
        """
        figure: Figure = hook("Flight.plot")(
            self, columns, width=width, height=height, window=window
        )
        return figure

    def _repr_html_(self) -> str:
        return str(hook("Flight.html")(self))


@flights_compiled_early()
def fly(
    scenario: Scenario | Mapping[str, Any] | str | Path,
    *overrides: str,
    own: Sequence[Own] = (),
    pilot: AnyPilot | str | None = None,
    trajectory: bool = True,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> Flight:
    """Fly a scenario.

    Args:
        scenario: A `Scenario`, plain tables, or the path of a TOML file.
        *overrides: Words such as ``"vehicle.arms.stiffness=6000"``; not with a `Scenario`.
        own: Your own obstacles besides the scenario's: pairs of a shape, registered with
            `signed_distance` and `outward_normal`, and its `SurfaceSettings`.
        pilot: Your own pilot, in place of the scenario's: a plain function ``(time,
            measurement, memory) -> (thrusts, memory)``, whose memory is None at first, with its
            alarm as a third value if it detects collisions; or a `CompiledPilot`, which is
            compiled; or ``"file.py:name"`` of either.
        trajectory: Record the trajectory.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter.
        progress: Called from time to time with the simulated time [s].

    Warns:
        LedgerWarning: If the energy ledger does not close to 1e-4.
        ContactWarning: If a contact was as deep as the middle of what it touched.
        OverlapWarning: If cages of one vehicle overlapped.
        CommandWarning: If a pilot commands less than 0 N from a rotor and telemetry is recorded.

    Raises:
        InputError: If the scenario cannot be flown; one line for each problem.  If the distance or
            the normal of a user's own obstacle is wrong where the vehicle could touch it.  If a
            user's own pilot fails, in one line with its file and line; the exception that it raised
            is the cause.
    """
    _check_executor(executor)
    flown_by = chosen_pilot(pilot)
    ready = as_scenario(scenario, overrides, flown_by is not None)
    with as_input(scenario, overrides):
        parts = user_parts(ready, own, flown_by)
        built = ready.build(parts)
    if trajectory:
        timing, guided = built.model.timing, built.built_avionics is not None
        every = max(timing.free_step, ready.simulation.record_interval)
        foreseen = timing.until * ready.clock if guided else timing.until / every
        check_instants(int(foreseen), timing.until, timing.until)
    if ready.second is not None:
        if own or executor != "compiled":
            raise InputError("second: cannot be combined with own obstacles, or executor 'python'")
        return _wary(pair_flight(ready, built, trace=trajectory, progress=progress))
    if built.built_avionics is not None:
        flight = guided_flight(
            ready, built, trajectory=trajectory, executor=executor, progress=progress
        )
        return _wary(replace(flight, own=parts.obstacles))
    with compiling(built):
        flown = fly_one(
            built.model, built.start, thrusts=built.thrusts, trace=trajectory, executor=executor,
            interval=ready.simulation.record_interval, progress=progress,
        )  # fmt: skip
    return _wary(replace(_flight_of(ready, flown, built.thrusts), own=parts.obstacles))


def _wary(flight: Flight) -> Flight:
    """The flight, after issuing its warnings, and those of the second vehicle."""
    for one in (flight, flight.second):
        for kind, sentence in ({} if one is None else one.remarks).items():
            warnings.warn(f"{flight.scenario.name}: {sentence}", kind, stacklevel=3)
    return flight


def pair_flight(ready: Scenario, built: ReadyFlight, **options: Any) -> Flight:
    """Flight of the first vehicle of a scenario, built, with that of the second.

    Args:
        ready: With a second vehicle.
        built: The first one.
        **options: Of `springback.results.pair.flying.fly_beside`.

    Raises:
        InputError: If the second cannot be flown, or code fails, in one line with file and line.
    """
    check_user_code(built)
    other = ready.beside()
    with of_second():
        built_beside = ready_flight(other)
    with compiling(built, built_beside):
        flown = fly_beside(ready, built, built_beside, **options)
    first, second = map(_flight_of, (ready, other), flown)
    return replace(first, second=replace(second, first=first))


def _flight_of(
    scenario: Scenario, result: GuidedFlown | FlightRecord, thrusts: ThrustTable | None = None
) -> Flight:
    """Flight of what was flown; without a pilot, with readings of the sensors if there are any."""
    flown = result.flown if isinstance(result, GuidedFlown) else result
    columns, units = trajectory_columns(flown, thrusts)
    outcome, measures, read = outcome_of(flown.record), measures_of(flown), None
    if isinstance(result, GuidedFlown):
        (outcome, measures), read = guided_result(result), result.telemetry
    elif columns and "sensors" in scenario.model_fields_set:
        with as_input():
            read = sensor_readings(scenario, columns)
    most = max(len(flown.start.arm_length), len(flown.model.thrust))
    telemetry, more = telemetry_columns(read, most)
    work = work_columns(flown)
    first = first_obstacle(scenario, flown)
    return Flight(scenario, outcome, measures, columns, units | more, telemetry, work, first)


def guided_flight(
    ready: Scenario,
    built: ReadyFlight,
    *,
    trajectory: bool = True,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> Flight:
    """Flight of a built scenario with a pilot, of the user's own or not.

    Args:
        ready: The scenario.
        built: The same, with avionics.
        trajectory: Record trajectory and telemetry.
        executor: ``compiled``, or ``python``.
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If a user's own part fails, in one line with its file and line.
    """
    interval = ready.simulation.record_interval
    return _flight_of(
        ready,
        fly_built(built, trace=trajectory, interval=interval, executor=executor, progress=progress),
    )


def fly_built(
    built: ReadyFlight,
    *,
    trace: bool = False,
    interval: float = 0.0,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> GuidedFlown:
    """Fly a built flight with a pilot, of the user's own or not.

    Args:
        built: With avionics.
        trace: Record trajectory and telemetry.
        interval: Of which the trajectory keeps the first step [s]; 0: it keeps each.
        executor: ``compiled``, or ``python``.
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If a user's own pilot fails, in one line with its file and line.
    """
    assert built.built_avionics is not None  # only called for flights with a pilot
    avionics, draws = built.built_avionics
    rotors = len(built.model.thrust)
    plain = None if built.plain is None else guarded_pilot(built.plain, rotors)
    ticks = ticks_of(built.model.timing.until, avionics.systems.period)
    with compiling(built):
        return fly_guided(
            GuidedFlight(built.model, built.start, avionics),
            noise_table(built.seed, 0, ticks, draws),
            pilot=plain, trace=trace, interval=interval, executor=executor, progress=progress,
        )  # fmt: skip


def ready_flight(scenario: Scenario) -> ReadyFlight:
    """Flight of a scenario, built with the user's own code that it names, which is checked.

    Raises:
        InputError: If it cannot be flown, or if the code fails, in one line with file and line.
    """
    with as_input():
        built = scenario.build()
    check_user_code(built)
    return built


def _check_executor(executor: str) -> None:
    """Reject an unknown executor."""
    known = get_args(Executor)
    if executor not in known:
        names = " or ".join(map(repr, known))
        raise InputError(f"executor must be {names} (got {source_text(executor)})")


def as_scenario(
    scenario: Scenario | Mapping[str, Any] | str | Path,
    overrides: tuple[str, ...] = (),
    pilot: bool | None = None,
) -> Scenario:
    """A checked scenario from any description of one.

    Args:
        scenario: A `Scenario`, plain tables, or the path of a TOML file.
        overrides: Words such as ``"vehicle.arms.stiffness=6000"``.
        pilot: True if a pilot of the user's own will fly it; None if unknown.

    Raises:
        InputError: If it is none of these, or cannot be flown; one line for each problem.
    """
    if isinstance(scenario, Scenario):
        if overrides:
            raise InputError(
                "overrides need a file or tables; change a Scenario by scenario.model_copy(update=)"
            )
        return scenario
    if isinstance(scenario, Mapping):
        if not overrides:
            return scenario_from(scenario, pilot)
        given = apply_overrides(dict(scenario), overrides)
        return checked_scenario(given, "scenario", "", overrides, pilot)
    if not isinstance(scenario, str | Path):
        raise InputError(
            "scenario must be a Scenario, tables, or the path of a TOML file "
            f"(got {source_text(scenario)})"
        )
    return read_scenario(scenario, overrides, pilot=pilot)
