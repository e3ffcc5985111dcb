"""A recorded impact, flown again from its start, and what every channel would have told."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from springback.errors import InputError
from springback.identification.observations.channel_window import ChannelWindow
from springback.identification.observations.drop_start import fall_of, is_drop
from springback.identification.observations.initial_state import InitialState, initial_state
from springback.identification.observations.likelihood import ImpactProblem
from springback.identification.observations.windows import (
    ImpactWindow,
    impact_window,
)
from springback.identification.replays.features import ForceRise
from springback.identification.replays.start import MeasuredStart, is_tracked, measured_start
from springback.identification.settings import ClockFit, FitSensors, StartFit, WindowFit
from springback.logs.clock_jumps import refuse_clock_jumps
from springback.logs.frame_check import refuse_units
from springback.logs.recording import (
    ANGULAR_VELOCITY,
    ATTITUDE,
    POSITION,
    ROTOR_COMMAND,
    SPECIFIC_FORCE,
    Array,
    Recording,
)
from springback.logs.segments import LogImpact, find_impacts, has_drops
from springback.logs.thrusts import is_share, logged_thrusts
from springback.logs.time_units import refuse_time_units
from springback.scenario.code_files import with_absolute_names
from springback.scenario.files import read_scenario
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import with_contents
from springback.scenario.scenario import Scenario
from springback.scenario.source_text import source_text, toml_tables

#: Distance within which a touch that is asked for is one that was found [s] (chosen).
NEAR = 0.05
#: Longest time before touch at which a replay begins [s] (chosen: errors of thrusts grow).
LONGEST = 5.0
#: Time after touch that is compared [s], that of the last row of the table.
AFTER = 0.3
#: Share by which thrusts may miss what the accelerometer says (chosen: that of `StartFit`).
MISSED = 0.1
#: Times that a start is moved for the touch to be when the log says (chosen).
ALIGNMENTS = 3
#: What a vehicle on a slider does not show.
TURNS = (ATTITUDE, ANGULAR_VELOCITY)
_AXES = "xyz"
_STARTS = ("position", "velocity", "attitude", "angular velocity")


class ReplayOptions(NamedTuple):
    """What of a log is flown again."""

    before: float = 0.1
    """Time before touch at which the replay begins [s]."""
    impact: float | None = None
    """Touch, by the log's clock, to 50 ms [s]; by default the first that can be used."""
    rotors: tuple[int, ...] = ()
    """For each rotor of the vehicle the number of the logged one, from 1; by default the same."""
    align: bool = False
    """Move the start along its velocity, so that touch is when the log says."""


class ReplayPlan(NamedTuple):
    """How logs are read for a replay, as `WindowPlan` has it."""

    window: WindowFit
    sensors: FitSensors = FitSensors()
    clocks: ClockFit = ClockFit()
    start: StartFit = StartFit()
    thrust: float = 0.05


class Replay:
    """A recorded impact beside its prediction; times are from the begin of the replay [s]."""

    def __init__(
        self,
        problem: ImpactProblem,
        tables: Mapping[str, Any],
        impact: LogImpact,
        start: MeasuredStart,
        told: Sequence[str],
        warnings: Sequence[str],
    ) -> None:
        """Prepare; `fly` predicts.

        Args:
            problem: Readings from the begin on, and their predictions.
            tables: Of the given scenario.
            impact: As found in the logs.
            start: State at the begin.
            told: Sentences on start and thrusts.
            warnings: Sentences on what the log lacks.
        """
        self.problem, self.impact, self.start = problem, impact, start
        self._given = dict(tables)
        self.told, self.warnings = list(told), list(warnings)
        self.point = np.zeros(len(problem.unknowns))
        self.touch = problem.impact.touch
        """Recorded touch [s]."""
        self.begin = impact.touch - self.touch
        """Begin, by the clock of the log [s]."""
        self.predicted: dict[str, Array] = {}
        """What each channel would have told, by its name, shape (samples, width)."""
        self.changed: dict[str, tuple[Array, Array]] = {}
        """The same, changed by each independent uncertainty to either side, shape (changes, …)."""

    @property
    def readings(self) -> list[ChannelWindow]:
        """Channels that are compared."""
        return self.problem.readings

    def fly(self) -> None:
        """Predict all channels, also with each uncertainty of start, clock and biases changed."""
        uncertainties = np.array([*self._uncertainties()])
        points = np.concatenate(
            [self.point[None], self.point + uncertainties, self.point - uncertainties]
        )
        found, count = self.problem.predictions(points), len(uncertainties)
        self.predicted = {name: values[0] for name, values in found.items()}
        self.changed = {
            name: (values[1 : 1 + count], values[1 + count :]) for name, values in found.items()
        }

    def shift(self, way: Array) -> None:
        """Move the start in the world, and the origin of the tracks against it [m]."""
        self._move(self.point, np.concatenate([way, np.zeros(9)]))
        for axis, part in zip(_AXES, way, strict=True):
            self._add(self.point, f"motion capture offset {axis}", -float(part))

    def flight_tables(self) -> dict[str, Any]:
        """Scenario of the replay, with the sensors of the given one."""
        tables = self.problem.flight_tables(self.point)
        sensors = self._given.get("sensors")
        return tables if sensors is None else tables | {"sensors": sensors}

    def _uncertainties(self) -> list[Array]:
        """Changes of the point by one standard deviation of each independent uncertainty."""
        found = []
        for change in self.start.changes:
            one = np.zeros(len(self.point))
            self._move(one, change)
            found.append(one)
        place, unknowns = self.problem.place, self.problem.unknowns
        if "clock offset" in place:
            one = np.zeros(len(self.point))
            one[place["clock offset"]] = 1.0
            self._move(one, self.start.by_clock * unknowns[place["clock offset"]].deviation)
            found.append(one)
        for word in ("accelerometer bias", "gyroscope bias"):
            for k, axis in enumerate(_AXES):
                if (name := f"{word} {axis}") not in place:
                    continue
                one = np.zeros(len(self.point))
                one[place[name]] = 1.0
                if word == "gyroscope bias":
                    self._move(one, self.start.by_bias[k] * unknowns[place[name]].deviation)
                found.append(one)
        return [one for one in found if one.any()]

    def _add(self, point: Array, name: str, value: float) -> None:
        """Add to an unknown, in SI, if there is one."""
        if name in self.problem.place:
            k = self.problem.place[name]
            point[k] += value / self.problem.unknowns[k].deviation

    def _move(self, point: Array, change: Array) -> None:
        """Add a change of the start, shape (12,), to a point."""
        if self.problem.slider is not None:
            axis = np.array(self.problem.slider) / np.linalg.norm(self.problem.slider)
            self._add(point, "start position", float(change[:3] @ axis))
            self._add(point, "start velocity", float(change[3:6] @ axis))
            return
        for k, value in enumerate(change):
            self._add(point, f"start {_STARTS[k // 3]} {_AXES[k % 3]}", float(value))

    def touch_error(self) -> float | None:
        """Predicted less recorded touch, both as the accelerometer tells [s]; None without one."""
        one = self.of(SPECIFIC_FORCE)
        if one is None:
            return None
        rise = ForceRise.of_recorded(one, self.touch, self.impact.release - self.impact.touch)
        late = rise.time(self.predicted[one.name]) - rise.time(one.values)
        return late if np.isfinite(late) else None

    def of(self, quantity: str) -> ChannelWindow | None:
        """Channel of a quantity, if there is one."""
        return next((one for one in self.readings if one.quantity == quantity), None)


def scenario_tables(path: Path, overrides: Sequence[str] = ()) -> tuple[Scenario, dict[str, Any]]:
    """A scenario, and its plain tables, overrides included.

    Raises:
        InputError: If it cannot be read.
    """
    scenario = read_scenario(path, overrides)
    tables = toml_tables(source_text(path), str(path))
    return scenario, apply_overrides(
        with_contents(with_absolute_names(tables, path.parent)), overrides
    )


def replay(
    scenario: Scenario,
    tables: Mapping[str, Any],
    recordings: Sequence[Recording],
    options: ReplayOptions | None = None,
) -> Replay:
    """Fly a recorded impact again, from the state that the log tells before touch.

    Without a pilot: the thrusts are those of the logged speeds or commands of the rotors.

    Args:
        scenario: Vehicle, obstacle, sensors.
        tables: The same as plain tables.
        recordings: Logs of the flight.
        options: What of them; by default the first impact that can be used.

    Raises:
        InputError: In one line: no impact that can be used; no track before touch and no start in
            the scenario; a second vehicle.
    """
    options = options or ReplayOptions()
    if scenario.second is not None:
        raise InputError(
            "second: must not be given with --against, which replays one vehicle (got "
            f"{scenario.second.name!r})"
        )
    if not 0.0 < options.before <= LONGEST:
        raise InputError(
            f"--before: must be above 0 s and at most {LONGEST:g} s (got {options.before:g} s)"
        )
    _check_order(scenario, options.rotors)
    refuse_time_units(recordings)
    refuse_clock_jumps(recordings)
    for one in recordings:
        refuse_units(one, max(scenario.start_state().arm_length, default=None))
    names = ", ".join(str(one.path) for one in recordings)
    found = _impacts(scenario, tables, recordings)
    impact = _chosen(found, options.impact, names)._replace(following=None)  # flown through it
    plan = ReplayPlan(WindowFit(before=options.before + max(options.before, 0.1), after=AFTER))
    read = impact_window(plan, scenario, recordings, impact, estimates=True)
    at = max(read.touch - options.before, 0.0)
    part = _from(read, at)
    slides = scenario.model.slider is not None
    tracks = [one for one in read.readings if not (slides and one.quantity in TURNS)]
    if is_tracked(tracks, at, read.touch):
        otherwise = _given_start(scenario)
    else:
        fall = fall_of(scenario) if impact.is_drop else None
        if fall is None:
            _check_given(scenario, tables, names)
        otherwise = initial_state(scenario, part.readings, part.touch, fall)
    start = measured_start(tracks, at, read.touch, otherwise, plan.start, plan.sensors)
    told, warnings = _start_words(start, at, read, options), list[str]()
    begin = impact.touch - part.touch
    thrusts = logged_thrusts(
        scenario, recordings, (begin, begin + part.until), impact.touch, options.rotors
    )
    told.append(_thrust_words(scenario, tables, thrusts))
    if impact.is_drop:
        told.append("a drop: impacts from above count, and bounces do not")
    if _has_pilot(tables):
        told.append("the scenario's pilot is left out: the replay is open loop")
    part = part._replace(
        start=_on_slider(scenario, start.guess), thrust=None if thrusts is None else thrusts.table
    )
    if thrusts is not None and abs(thrusts.carried - 1.0) > MISSED:
        warnings.append(
            f"before touch the thrusts carry {thrusts.carried:.2f} of what the accelerometer says: "
            "mass, largest thrust, or what a command means"
        )
    if thrusts is None and scenario.model.slider is None and any(
        not is_share(channel) for one in recordings for channel in one.of(ROTOR_COMMAND)
    ):  # fmt: skip
        warnings.append(
            "the logged commands are not shares of the largest thrust, and are not used"
        )
    warnings += _gaps(part, impact, found, recordings)
    problem = ImpactProblem(plan, scenario, tables, [], part)
    flown = Replay(problem, tables, impact, start, told, warnings)
    flown.fly()
    if options.align:
        _align(flown)
    return flown


def _align(flown: Replay) -> None:
    """Move the start along its velocity until touch is when the log says."""
    velocity, moved = flown.problem.impact.start.velocity, np.zeros(3)
    for _ in range(ALIGNMENTS):
        late = flown.touch_error()
        if late is None:
            raise InputError(
                "--align: needs an accelerometer in the log, and a touch in the replay"
            )
        moved += late * velocity
        flown.shift(late * velocity)
        flown.fly()
    flown.told.append(
        f"start moved by {1e3 * float(np.linalg.norm(moved)):.1f} mm "
        f"{'ahead' if moved @ velocity > 0.0 else 'back'} along its velocity so that touch is "
        "when the log says"
    )


def _check_order(scenario: Scenario, rotors: tuple[int, ...]) -> None:
    count = scenario.vehicle.rotor_count
    if rotors and (len(rotors) != count or min(rotors) < 1 or len(set(rotors)) != count):
        shown = ",".join(map(str, rotors))
        raise InputError(
            f"--rotors: must name {count} logged rotors, each once, from 1 (got {shown})"
        )


def _has_pilot(tables: Mapping[str, Any]) -> bool:
    return any(tables.get(key) is not None for key in ("reference", "pilot"))


def _impacts(
    scenario: Scenario, tables: Mapping[str, Any], recordings: Sequence[Recording]
) -> list[LogImpact]:
    """Impacts in logs; of a drop, if that is what the scenario or else the logs are."""
    found = find_impacts(recordings)
    if not _has_pilot(tables) and (is_drop(scenario) or has_drops(found, recordings)):
        return find_impacts(recordings, drops=True)
    return found


def _chosen(found: Sequence[LogImpact], wanted: float | None, names: str) -> LogImpact:
    """The impact that is asked for, else the first that can be used."""
    if not found:
        raise InputError(f"{names}: no impact was found; springback identify inspect tells more")
    known = ", ".join(f"{one.touch:.3f} s" for one in found)
    if wanted is not None:
        near = [one for one in found if abs(one.touch - wanted) <= NEAR]
        if not near:
            raise InputError(f"--impact: {names} has no impact at {wanted:g} s; found: {known}")
        if near[0].refused:
            raise InputError(f"{names}: impact at {near[0].touch:.3f} s: {near[0].refused}")
        return near[0]
    usable = [one for one in found if not one.refused]
    if not usable:
        raise InputError(*(
            f"{names}: impact at {one.touch:.3f} s: {one.refused}" for one in found
        ))  # fmt: skip
    return usable[0]


def _given_start(scenario: Scenario) -> InitialState:
    """State at the start of a scenario."""
    state = scenario.start_state()
    return InitialState(
        np.array(state.position), np.array(state.velocity), np.array(state.attitude),
        np.array(state.angular_velocity), False,
    )  # fmt: skip


def _check_given(scenario: Scenario, tables: Mapping[str, Any], names: str) -> None:
    """Refuse a start that neither a track nor the scenario tells."""
    if not isinstance(tables.get("start"), Mapping) or not any(scenario.start.velocity):
        raise InputError(
            f"{names}: has too few samples of a track before touch, and the scenario has no "
            "start.velocity to begin with"
        )


def _from(read: ImpactWindow, at: float) -> ImpactWindow:
    """Readings from an instant on, which becomes 0."""
    kept = []
    for one in read.readings:
        later = one.times >= at - 1e-9
        if later.sum() < 2:
            continue
        starts = one.starts[later].copy()
        starts[0] = True
        kept.append(one._replace(
            times=np.maximum(one.times[later] - at, 0.0), values=one.values[later], starts=starts,
            clipped=None if one.clipped is None else one.clipped[later],
        ))  # fmt: skip
    return read._replace(
        touch=read.touch - at, release=read.release - at, until=read.until - at,
        readings=tuple(kept),
    )  # fmt: skip


def _on_slider(scenario: Scenario, guess: InitialState) -> InitialState:
    """A start on the slider of a scenario, if it has one."""
    if scenario.model.slider is None:
        return guess
    unit = np.array(scenario.model.slider) / np.linalg.norm(scenario.model.slider)
    home = np.array(scenario.start_state().position)
    return guess._replace(
        position=home + ((guess.position - home) @ unit) * unit,
        velocity=(guess.velocity @ unit) * unit,
    )


# -- words ----------------------------------------------------------------------------------------


def _start_words(
    start: MeasuredStart, at: float, read: ImpactWindow, options: ReplayOptions
) -> list[str]:
    begin = read.touch - at
    speed = float(np.linalg.norm(start.guess.velocity))
    found = [f"start {begin:.3f} s before touch, {speed:.2f} m/s, from {start.sentence}"]
    if begin < options.before - 1e-3:
        found[0] += f" (the log begins {begin:.3f} s before touch)"
    return found


def _thrust_words(scenario: Scenario, tables: Mapping[str, Any], thrusts: Any) -> str:
    if scenario.model.slider is not None:
        return "on the scenario's slider: thrusts do not matter"
    if thrusts is not None:
        return str(thrusts.sentence)
    if _has_pilot(tables):
        return "no speeds nor commands of the rotors: they are assumed to hover"
    return "no speeds nor commands of the rotors: thrusts are those of the scenario"


def _gaps(
    part: ImpactWindow,
    impact: LogImpact,
    found: Sequence[LogImpact],
    recordings: Sequence[Recording],
) -> list[str]:
    """What the log lacks of a comparison until `AFTER`."""
    warnings = []
    if part.until < part.touch + AFTER - 0.01:
        warnings.append(f"the log ends {part.until - part.touch:.3f} s after touch")
    later = [one.touch for one in found if impact.touch < one.touch < impact.touch + AFTER]
    if later:
        warnings.append(
            f"the next impact is {later[0] - impact.touch:.3f} s after touch: what follows is "
            "compared through it"
        )
    estimated = [
        channel.name for one in recordings for channel in one.channels
        if channel.chain.estimated and channel.name in {each.name for each in part.readings}
    ]  # fmt: skip
    if estimated:
        warnings.append(
            f"estimates, not measurements, whose own errors are not in the uncertainty: "
            f"{', '.join(estimated)}"
        )
    missing = [
        quantity for quantity in (SPECIFIC_FORCE, POSITION, ATTITUDE) if part.of(quantity) is None
    ]
    if missing:
        warnings.append(f"not in the log, and not compared: {', '.join(missing)}")
    return warnings
