"""Flying a scenario, and its result."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic_core import PydanticCustomError

from springback.contact.parameters import Own
from springback.errors import CommandWarning, FlightWarning, InputError, LedgerWarning
from springback.results.meshes import Mesh, surfaces_of
from springback.results.recovery_measures import (
    RECOVERY_MEASURES,
    is_evaluated,
    recovery_measures,
    recovery_outcome,
)
from springback.scenario.arguments import check_executor, chosen_pilot
from springback.scenario.avionics import CompiledPilot
from springback.scenario.build import ReadyFlight, user_parts
from springback.scenario.files import apply_overrides, checked_scenario, read_scenario
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.user_pilots import AnyPilot, guarded_pilot, in_words, source_text, validate
from springback.simulation.flight import (
    Executor,
    FlightRecord,
    Trace,
    check_instants,
    fly_one,
    own_types,
)
from springback.simulation.guided import (
    GuidedFlight,
    GuidedFlown,
    fly_guided,
    ticks_of,
)
from springback.simulation.measures import (
    FAILURES,
    MEASURES,
    Outcome,
    measures_of,
    outcome_of,
)
from springback.simulation.noise import noise_table

if TYPE_CHECKING:
    import pandas
    import xarray

Array = np.ndarray[Any, np.dtype[np.float64]]


@dataclass(frozen=True, repr=False, eq=False)
class Flight:
    """Result of a flight.  Every measure is an attribute as well: ``flight.touch_speed``."""

    scenario: Scenario
    outcome: Outcome
    measures: dict[str, float | None]
    """Measures by name; units and meanings are in `springback.simulation.measures.MEASURES`."""
    columns: dict[str, Array]
    """Trajectory by column, each of shape (instants,); empty if it was not recorded."""
    units: dict[str, str]
    """Unit of each column, including telemetry."""
    telemetry: dict[str, Array] = field(default_factory=dict)
    """Measured, estimated, desired and commanded values at every tick; empty without a pilot."""
    work: dict[str, Array] = field(default_factory=dict)
    """Work done so far [J], by kind, and 1 during contact, each of shape (instants,), for
    `springback.results.energy_history`.  Files do not contain it.
    """
    own: tuple[Own, ...] = ()
    """The user's own obstacles; empty for a flight that was read back."""
    own_surfaces: tuple[Mesh, ...] = ()
    """Surfaces of those obstacles for drawing, in a flight that was read back."""

    def __getattr__(self, name: str) -> float | None:
        measures: dict[str, float | None] = self.__dict__.get("measures", {})
        if name in measures:
            return measures[name]
        raise AttributeError(f"a flight has no {name!r}; measures: {', '.join(measures)}")

    @property
    def success(self) -> bool:
        """Success as in campaigns: recovered, if required; else neither ground nor stop was hit.

        A simulation that diverged is not a success either.
        """
        if "runs" in self.measures:
            return self.outcome is Outcome.RECOVERED
        return self.outcome not in FAILURES

    @property
    def is_finite(self) -> bool:
        """True if the simulation stayed finite."""
        return self.outcome is not Outcome.NOT_FINITE

    @property
    def remarks(self) -> dict[type[FlightWarning], str]:
        """Warnings about the flight, a sentence each, by their kind."""
        found: dict[type[FlightWarning], str] = {}
        if self.measures.get("ledger_open"):
            left = self.measures["ledger_residual"]  # None if it is not finite
            share = "more than all" if left is None else f"{left:.1e}"
            found[LedgerWarning] = (
                f"the energy ledger leaves {share} of the energy: the "
                "numbers cannot be trusted; try smaller steps (simulation.impact_step)"
            )
        commands = [values for name, values in self.telemetry.items() if name.startswith("command")]
        lowest = np.min(commands, axis=0, initial=0.0)
        below = np.flatnonzero(lowest < 0.0)
        propulsion = self.scenario.vehicle.propulsion
        if len(below) and propulsion is not None:
            found[CommandWarning] = (
                f"the pilot commands less than 0 N at {len(below)} of {len(lowest)} ticks, first "
                f"at {self.telemetry['t'][below[0]]:.4g} s ({lowest[below[0]]:.3g} N): rotors do "
                f"not turn backwards and give their minimum, {propulsion.min_thrust:g} N"
            )
        return found

    @property
    def message(self) -> str:
        """The outcome in a sentence."""
        return self.outcome.value

    @property
    def t(self) -> Array:
        """Instants of the trajectory [s], shape (instants,)."""
        return self.columns["t"]

    def __repr__(self) -> str:
        shown = [
            ("touch_speed", "m/s"), ("restitution_at_separation", ""),
            ("impact_peak_acceleration", "m/s²"), ("contact_time", "s"), ("travel", "m"),
            ("impact_arm_stroke", "m"), ("contacts", ""), ("peak_acceleration", "m/s²"),
        ]  # fmt: skip
        if "runs" in self.measures:
            shown += [
                ("detection_delay", "s"), ("recovery_time", "s"), ("height_loss", "m"),
                ("nose_up", "deg"), ("nose_down", "deg"), ("runs", ""), ("recovered_runs", ""),
            ]  # fmt: skip
        lines = [f"Flight {self.scenario.name!r}: {self.message}"]
        width = max(len(name) for name, _ in shown)
        for name, unit in shown:
            value = self.measures[name]
            if unit == "deg" and value is not None:  # for reading; the measure is in rad
                value = math.degrees(value)
            lines.append(
                f"  {name:<{width}} {'-' if value is None else f'{value:.5g} {unit}'.rstrip()}"
            )
        return "\n".join(lines)

    def _need_trajectory(self) -> None:
        if not self.columns:
            raise InputError("this flight has no trajectory: fly it with trajectory=True")

    def to_dataframe(self) -> pandas.DataFrame:
        """Trajectory as a pandas DataFrame, one row per instant; units in ``attrs``.

        Raises:
            InputError: If pandas is not installed, or the trajectory was not recorded.
        """
        self._need_trajectory()
        from springback.extras import needs

        pd = needs("pandas", "dataframe")
        frame: pandas.DataFrame = pd.DataFrame(self.columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Trajectory as an xarray Dataset over ``t``; units and measures in ``attrs``.

        Raises:
            InputError: If xarray is not installed, or the trajectory was not recorded.
        """
        self._need_trajectory()
        from springback.extras import needs

        xr = needs("xarray", "xarray")
        data = {
            name: ("t", values, {"units": self.units[name]})
            for name, values in self.columns.items()
            if name != "t"
        }
        known = {name: value for name, value in self.measures.items() if value is not None}
        dataset: xarray.Dataset = xr.Dataset(
            data,
            coords={"t": ("t", self.t, {"units": "s"})},
            attrs={"name": self.scenario.name, "outcome": self.outcome.word, **known},
        )
        return dataset

    def summary(self) -> dict[str, Any]:
        """The result as plain data: outcome, measures, units, scenario, versions."""
        from springback.version import __version__

        known = MEASURES | (RECOVERY_MEASURES if "runs" in self.measures else {})
        return {
            "springback": __version__,
            "name": self.scenario.name,
            "outcome": self.outcome.word,
            "message": self.message,
            "measures": self.measures,
            "units": {name: unit for name, (unit, _) in known.items()},
            "scenario": self.scenario.model_dump(mode="json"),
            **self._own_obstacles(),
        }

    def _own_obstacles(self) -> dict[str, Any]:
        """Surfaces of the user's own obstacles near the flight, if any."""
        found = self.own_surfaces
        if self.own and self.columns:
            place = np.stack([self.columns[axis] for axis in "xyz"], axis=1)
            pressed = [c > 0.0 for name, c in self.columns.items() if name.startswith("fn")]
            touching = np.any(pressed, axis=0)
            found = surfaces_of(self.own, place[touching] if touching.any() else place)
        return {"own_obstacles": [one.as_dict() for one in found]} if found else {}


def _columns(flown: FlightRecord) -> tuple[dict[str, Array], dict[str, str]]:
    """Trajectory columns under their file names, with units."""
    trace = flown.trace
    if trace is None:
        return {}, {}
    state, view = "state", "acceleration"
    names: dict[str, tuple[str, str]] = {"t": ("time", "s")}
    names |= {axis: (f"{state}.position.{axis}", "m") for axis in "xyz"}
    names |= {f"q{part}": (f"{state}.attitude.{part}", "") for part in "wxyz"}
    names |= {f"v{axis}": (f"{state}.velocity.{axis}", "m/s") for axis in "xyz"}
    names |= {f"w{axis}": (f"{state}.angular_velocity.{axis}", "rad/s") for axis in "xyz"}
    count = range(1, len(flown.start.arm_length) + 1)
    names |= {f"l{j}": (f"{state}.arm_length.{j}", "m") for j in count}
    names |= {f"dl{j}": (f"{state}.arm_rate.{j}", "m/s") for j in count}
    names |= {f"a{axis}": (f"{view}.{axis}", "m/s^2") for axis in "xyz"}
    names |= {f"fn{j}": (f"arms.{j}.normal", "N") for j in count}
    names |= {"fn_body": ("hull.1.normal", "N")} if flown.model.airframe.hull else {}
    columns = {name: np.ascontiguousarray(trace[source]) for name, (source, _) in names.items()}
    units = {name: unit for name, (_, unit) in names.items()}
    rubbed = {f"ff{j}": f"arms.{j}.friction" for j in count}
    rubbed |= {"ff_body": "hull.1.friction"} if flown.model.airframe.hull else {}
    for name, source in rubbed.items():
        parts = np.stack([trace[f"{source}.{axis}"] for axis in "xyz"])
        columns[name], units[name] = np.linalg.norm(parts, axis=0), "N"
    return columns, units


def _work(flown: FlightRecord) -> dict[str, Array]:
    """Work in the trace by name, and a flag for contact of any cage."""
    trace, stem = flown.trace, "work."
    if trace is None:
        return {}
    names = [name for name in trace.columns if name.startswith(stem)]
    work = {name.removeprefix(stem): np.ascontiguousarray(trace[name]) for name in names}
    touching = np.zeros(len(trace.values))
    for name in trace.columns:
        if ".engaged." in name:
            np.maximum(touching, trace[name], out=touching)
    return work | {"touching": touching}


#: Columns of telemetry: name, source, unit.  An `n` represents the number of an arm.
_TELEMETRY = (
    ("t", "time", "s"),
    ("command{n}", "command.{n}", "N"), ("thrust{n}", "thrust.{n}", "N"),
    ("imu_a{a}", "measurement.inertial.specific_force.{a}", "m/s^2"),
    ("imu_w{a}", "measurement.inertial.angular_velocity.{a}", "rad/s"),
    ("imu_fresh", "measurement.inertial.fresh", ""),
    ("pose_{a}", "measurement.pose.position.{a}", "m"),
    ("pose_q{q}", "measurement.pose.attitude.{q}", ""),
    ("pose_fresh", "measurement.pose.fresh", ""), ("pose_age", "measurement.pose.age", "s"),
    ("hall{n}", "measurement.arm_length.{n}", "m"),
    ("est_{a}", "pilot.estimate.position.{a}", "m"),
    ("est_q{q}", "pilot.estimate.attitude.{q}", ""),
    ("est_v{a}", "pilot.estimate.velocity.{a}", "m/s"),
    ("est_w{a}", "pilot.estimate.angular_velocity.{a}", "rad/s"),
    ("ref_{a}", "pilot.wanted.position.{a}", "m"), ("ref_v{a}", "pilot.wanted.velocity.{a}", "m/s"),
    ("ref_a{a}", "pilot.wanted.acceleration.{a}", "m/s^2"), ("ref_yaw", "pilot.wanted.yaw", "rad"),
    ("aim_q{q}", "pilot.aim.attitude.{q}", ""), ("aim_thrust", "pilot.aim.thrust", "N"),
    ("aim_w{a}", "pilot.setpoint.{a}", "rad/s"),
    ("phase", "pilot.phase", ""), ("goal_{a}", "pilot.goal.{a}", "m"),
    ("pressed", "pilot.pressed", "m"), ("jolt", "pilot.jolt", "m/s^2"), ("push", "pilot.push", "N"),
    ("alarms_hall", "pilot.alarms.1", ""), ("alarms_acceleration", "pilot.alarms.2", ""),
    ("alarms_wrench", "pilot.alarms.3", ""),
    ("force_{a}", "pilot.force.{a}", "N"), ("moment_{a}", "pilot.moment.{a}", "N m"),
    ("hit_{a}", "pilot.direction.{a}", ""),
)  # fmt: skip


def _telemetry(trace: Trace | None, arms: int) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns of telemetry under their file names, with units; those that the pilot recorded."""
    columns: dict[str, Array] = {}
    units: dict[str, str] = {}
    if trace is None:
        return columns, units
    for name, source, unit in _TELEMETRY:
        for n in range(1, arms + 1) if "{n}" in source else (0,):
            for a in "xyz" if "{a}" in source else ("",):
                for q in "wxyz" if "{q}" in source else ("",):
                    known = source.format(n=n, a=a, q=q)
                    if known in trace.columns:
                        column = name.format(n=n, a=a, q=q)
                        columns[column] = np.ascontiguousarray(trace[known])
                        units[column] = unit
    return columns, units


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
        own: The user's own obstacles besides the scenario's: pairs of a shape, registered with
            `signed_distance` and `outward_normal`, and its `SurfaceSettings`.
        pilot: The user's own pilot, in place of the scenario's: a plain function ``(time,
            measurement, memory) -> (thrusts, memory)``, whose memory is None at first, or a
            `CompiledPilot`, which is compiled, or ``"file.py:name"`` of either.
        trajectory: Record the trajectory.
        executor: ``compiled``, or ``python`` for the same source run by the interpreter.
        progress: Called from time to time with the simulated time [s].

    Warns:
        LedgerWarning: If the energy ledger does not close to 1e-4.
        CommandWarning: If a pilot commands less than 0 N of a rotor and telemetry is recorded.

    Raises:
        InputError: If the scenario cannot be flown; one line for each problem.  If the distance or
            the normal of a user's own obstacle is wrong where the vehicle could touch it.  If a
            user's own pilot fails, in one line with its file and line; the exception that it raised
            is the cause.
    """
    check_executor(executor)
    flown_by = chosen_pilot(pilot)
    ready = as_scenario(scenario, overrides, flown_by is not None)
    parts = user_parts(ready, own, flown_by)
    with _as_input():
        built = ready.build(parts)
    if trajectory:
        timing, guided = built.model.timing, built.built_avionics is not None
        foreseen = timing.until * ready.clock if guided else timing.until / timing.free_step
        check_instants(int(foreseen), timing.until, timing.until)
    if built.built_avionics is not None:
        flight = _fly_guided(ready, built, trajectory, executor, progress)
        return _wary(replace(flight, own=parts.obstacles))
    flown = fly_one(
        built.model, built.start, trace=trajectory, executor=executor, progress=progress
    )
    columns, units = _columns(flown)
    outcome, measures = outcome_of(flown.record), measures_of(flown)
    work = _work(flown)
    return _wary(Flight(ready, outcome, measures, columns, units, work=work, own=parts.obstacles))


def _wary(flight: Flight) -> Flight:
    """The flight, after issuing its warnings."""
    for kind, sentence in flight.remarks.items():
        warnings.warn(f"{flight.scenario.name}: {sentence}", kind, stacklevel=3)
    return flight


def _fly_guided(
    ready: Scenario,
    built: ReadyFlight,
    trajectory: bool,
    executor: Executor,
    progress: Callable[[float], None] | None,
) -> Flight:
    """Fly with a pilot."""
    guided = fly_built(built, trace=trajectory, executor=executor, progress=progress)
    columns, units = _columns(guided.flown)
    telemetry, telemetry_units = _telemetry(guided.telemetry, len(built.start.arm_length))
    outcome, measures = guided_result(guided)
    return Flight(
        ready, outcome, measures, columns, units | telemetry_units, telemetry, _work(guided.flown)
    )


def fly_built(
    built: ReadyFlight,
    *,
    trace: bool = False,
    executor: Executor = "compiled",
    progress: Callable[[float], None] | None = None,
) -> GuidedFlown:
    """Fly a built flight with a pilot, of the user's own or not.

    Args:
        built: With avionics.
        trace: Record trajectory and telemetry.
        executor: ``compiled``, or ``python``.
        progress: Called from time to time with the simulated time [s].

    Raises:
        InputError: If a user's own pilot fails, in one line with its file and line.
    """
    assert built.built_avionics is not None  # only called for flights with a pilot
    avionics, draws = built.built_avionics
    rotors = len(built.start.arm_length)
    plain = None if built.plain is None else guarded_pilot(built.plain, rotors)
    own = check_user_pilot(built)
    ticks = ticks_of(built.model.timing.until, avionics.systems.period)
    with in_words(own):
        return fly_guided(
            GuidedFlight(built.model, built.start, avionics),
            noise_table(built.seed, 0, ticks, draws),
            pilot=plain, trace=trace, executor=executor, progress=progress,
        )  # fmt: skip


def check_user_pilot(built: ReadyFlight) -> CompiledPilot | None:
    """A compiled pilot of the user's own that flies, checked by one call in plain Python, or None.

    Raises:
        InputError: If it fails, with its file and line.
    """
    if built.built_avionics is None:
        return None
    avionics = built.built_avionics.avionics
    pilot = CompiledPilot(avionics.systems.pilot, avionics.onboard.pilot)
    if not own_types(pilot):
        return None
    validate(pilot, avionics.onboard.measurement, len(built.start.arm_length))
    return pilot


def guided_result(guided: GuidedFlown) -> tuple[Outcome, dict[str, float | None]]:
    """Outcome and measures of a flight with a pilot."""
    if not is_evaluated(guided):
        return outcome_of(guided.flown.record), measures_of(guided.flown)
    return recovery_outcome(guided), measures_of(guided.flown) | recovery_measures(guided)


@contextmanager
def _as_input() -> Iterator[None]:
    """Convert the problem of a scenario that was checked before to bad input."""
    try:
        yield
    except PydanticCustomError as error:
        raise InputError(f"{(error.context or {})['field']}: {error.message()}") from None


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
