"""Impact resilience: seven kinds of collision with a wall, both robots, and ten hits in a row.

One set of parameters flies all of it; nothing is tuned to a condition.  Friction is the paper's,
along the vertical; friction along both tangents and the noise that PX4's EKF2 assumes are flown
beside it (`springback.paper.choices`).  Trials differ in
their random draws (`Scatter`), the same for both robots.  What the paper leaves open is chosen here
and marked so: the distributions of the scatter, the duration of a flight, and the number of flights
of the repeated test.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np

from springback.campaign.analysis.envelope import Envelope
from springback.campaign.envelope_plan import fly_envelope, plan_envelope
from springback.intervals import CONFIDENCE
from springback.paper.choices import EKF2, VERTICAL, ChoiceResults, ConditionOutcome, fly_choices
from springback.paper.printed import (
    COLLISIONS_IN_A_ROW,
    RECOVERY_DISTANCE,
    RECOVERY_PITCH,
    SUCCESS,
    WALL_DISTANCE,
)
from springback.progress import Progress, silent, stage
from springback.recovery.state_machine import CRUISE, HOVER, LOOK, RECOVER
from springback.results.flight import Flight, fly
from springback.simulation.measuring.measures import Outcome
from springback.studies.comparison import Mark, Row, predicted_or_contradicted
from springback.studies.run_ups import CONDITIONS
from springback.studies.trials import (
    DURATION,
    HOME,
    Condition,
    Scatter,
    Tally,
    Trial,
    TrialNoise,
    fly_trials,
    tally,
    trial_tables,
)

Array = np.ndarray[Any, np.dtype[np.float64]]

ROBOTS = ("arq", "quad")
TRIALS = 10
"""Section Impact Resilience: ten trials of each condition."""
SLOWEST = (0.0, 1.0)
"""Pitch [deg] and speed [m/s] of flights that only serve to see how detection goes with speed."""
FASTEST = (0.0, 3.5)
"""Pitch [deg] and speed [m/s] of the collisions whose largest pitch is printed."""
REPEATED = (-45.0, 2.0)
"""Pitch [deg] and speed [m/s] of the repeated test."""
COMPARED = 20
"""Trials of each condition under each set of choices, chosen; `springback study choices` flies a
hundred."""
MAPPED = 4
"""Trials of each cell of the map, chosen."""
MAP = ("speed=2:6:5", "pitch=-45deg:45deg:5")
"""Axes of the map, chosen so that both robots fail on it."""
MAP_SETTINGS = ("estimator=px4-ekf2",)
"""Settings of the map: the noise with which the robots differ."""
REPEATS = 5
"""Flights of the repeated test, chosen."""
TIME_EACH = 12.0
"""For a collision of the repeated test, its way home included [s], chosen: it takes some 9 s, and
some 10 s where the robot comes back to the wall a second time."""
RETURN_TOLERANCE = 0.1
"""The robot must come back this near to the start [m]; chosen, L_c."""
FAR = 2.0
"""Chosen: a robot that was so far from the place of touch before it came to rest [m] rested at home
only."""
SAMPLES = (("arq", 0.0, 3.5), ("arq", 0.0, 2.0), ("quad", 0.0, 2.0))
"""Robot, pitch [deg] and speed [m/s] of the flights that the paper draws."""
PACE = "the duration of the way back was chosen so that it asks for the printed nose up"


@dataclass(frozen=True)
class Repeat:
    """One flight of the repeated test: collision after collision without landing."""

    robot: str
    trial: int
    outcome: Outcome
    asked: int
    """Collisions that were to be made."""
    collisions: int
    recovered: int
    returns: tuple[float, ...]
    """True distance from `HOME` each time that the robot took itself to be home [m]."""
    alarms: int
    """One for each collision; more where the robot swung back to the wall before it rested."""
    false_alarms: int
    flight: Flight | None = field(default=None, repr=False)
    """Kept for the first trial of each robot."""

    @property
    def success(self) -> bool:
        """Recovered from every collision, and came back near enough every time."""
        near = [gap <= RETURN_TOLERANCE for gap in self.returns]
        return self.outcome is Outcome.RECOVERED and all(near) and len(near) == self.asked

    def as_dict(self) -> dict[str, Any]:
        """Plain data."""
        return {
            "robot": self.robot, "trial": self.trial, "outcome": self.outcome.word,
            "success": self.success, "asked": self.asked, "collisions": self.collisions,
            "recovered": self.recovered, "alarms": self.alarms, "false_alarms": self.false_alarms,
            "returns": list(self.returns),
        }  # fmt: skip


@dataclass(frozen=True)
class Sample:
    """One trial with its trajectory."""

    robot: str
    pitch: float
    """[deg]"""
    speed: float
    """[m/s]"""
    noise_stream: TrialNoise
    flight: Flight = field(repr=False)


@dataclass
class ResilienceResults:
    """All collisions in flight."""

    trials: int
    scatter: Scatter = field(default_factory=Scatter)
    flown: list[Trial] = field(default_factory=list)
    """Of `CONDITIONS`."""
    slower: list[Trial] = field(default_factory=list)
    """At `SLOWEST`, which the paper does not fly."""
    repeats: list[Repeat] = field(default_factory=list)
    samples: list[Sample] = field(default_factory=list)
    choices: ChoiceResults | None = None
    """The same conditions under every set of choices."""
    envelope: Envelope | None = None
    """Success over speed and pitch, with `MAP_SETTINGS`."""

    def values(self, robot: str, pitch: float, speed: float, measure: str) -> list[float]:
        """A measure of all trials of a condition that have it."""
        found = [
            trial.measures[measure] for trial in [*self.flown, *self.slower]
            if trial.condition == (robot, pitch, speed)
        ]  # fmt: skip
        return [value for value in found if value is not None]

    def tallies(self) -> list[Tally]:
        """Successes of every condition that was flown, robot by robot."""
        asked = [(robot, *test) for robot in ROBOTS for test in CONDITIONS]
        found = ([t for t in self.flown if t.condition == of] for of in asked)
        return [tally(some) for some in found if some]

    def sample(self, robot: str, pitch: float, speed: float) -> Sample | None:
        """The trial of a condition whose trajectory was kept."""
        of = (robot, pitch, speed)
        return next((s for s in self.samples if (s.robot, s.pitch, s.speed) == of), None)

    def repeats_of(self, robot: str) -> list[Repeat]:
        """Flights of the repeated test."""
        return [repeat for repeat in self.repeats if repeat.robot == robot]

    def rows(self) -> list[Row]:
        """Ours beside print, for every printed number."""
        found = [*self._success_rows(), *self._pitch_rows(), *self._repeated_rows()]
        return [*_input_rows(), *found, *self._chosen_rows()] if self.flown else []

    def ekf2_conditions(self) -> dict[tuple[str, float, float], ConditionOutcome]:
        """Conditions with the paper's friction and EKF2's noise; empty if they were not flown."""
        if self.choices is None:
            return {}
        flown = self.choices.combinations
        found = [one for one in flown if (one[0].friction, one[0].estimator) == (VERTICAL, EKF2)]
        return self.choices.table(*found[0]) if found else {}

    def _chosen_rows(self) -> list[Row]:
        """Printed shares beside ours with EKF2's noise."""
        rows, table = [], self.ekf2_conditions()
        for of in SUCCESS:
            if cell := table.get(of):
                rows.append(_success_row(cell, f"; {EKF2}", f"trials of {cell.duration:g} s"))
        return rows

    def _success_rows(self) -> list[Row]:
        return [_success_row(one) for one in self.tallies() if one.condition in SUCCESS]

    def _pitch_rows(self) -> list[Row]:
        rows, name = [], condition_name(*FASTEST)
        for side, printed, measure in zip(
            ("nose up", "nose down"), RECOVERY_PITCH, ("nose_up", "nose_down"), strict=True
        ):
            flown = [math.degrees(x) for x in self.values("arq", *FASTEST, measure)]
            if flown:
                ours = float(np.median(flown))
                note = (
                    f"median of {len(flown)} trials, {min(flown):.1f} to {max(flown):.1f} deg; "
                    f"{PACE}"
                )
                mark = predicted_or_contradicted(ours, printed)
                rows.append(_row("arq", name, f"pitch, {side}", "deg", ours, printed, mark, note))
        sample = self.sample("arq", *FASTEST)
        asked = command_extremes(sample.flight) if sample is not None else None
        if asked is not None:
            (up, down), (least, most) = asked, RECOVERY_PITCH
            mark = predicted_or_contradicted(down, most)
            what = "commanded pitch"
            rows += [
                _row("arq", name, f"{what}, nose up", "deg", up, least, Mark.FITTED, PACE),
                _row("arq", name, f"{what}, nose down", "deg", down, most, mark, PACE),
            ]
        return rows

    def _repeated_rows(self) -> list[Row]:
        found = self.repeats_of("arq")
        if not found or found[0].asked != COLLISIONS_IN_A_ROW:
            return []
        ours = float(min(repeat.recovered for repeat in found))
        won = sum(repeat.success for repeat in found)
        note = (
            f"the fewest of {len(found)} flights; {won} of them came back to within "
            f"{RETURN_TOLERANCE:g} m every time"
        )
        mark = predicted_or_contradicted(ours, COLLISIONS_IN_A_ROW)
        name = condition_name(*REPEATED)
        return [_row("arq", name, "recovered in a row", "", ours, COLLISIONS_IN_A_ROW, mark, note)]


def _input_rows() -> list[Row]:
    """Printed numbers of the tests in flight that are put in."""
    given = (
        ("distance of the wall, D", WALL_DISTANCE),
        ("distance of the recovery point, L_c", RECOVERY_DISTANCE),
    )
    note = "section Impact Resilience"
    return [_row("", "", name, "m", value, value, Mark.GIVEN, note) for name, value in given]


def _row(
    robot: str, reading: str, quantity: str, unit: str, ours: float, printed: float, mark: Mark,
    note: str,
) -> Row:  # fmt: skip
    """A compared number; what print says of collisions in flight are physical tests."""
    return Row(
        "Resilience", robot, "wall", reading, quantity, unit, ours, printed, None, mark, 0.0, "",
        note,
    )  # fmt: skip


def _success_row(found: Tally, assumptions: str = "", trials: str = "") -> Row:
    """A printed share of successes, beside ours.

    Args:
        found: Our trials.
        assumptions: Words behind the condition.
        trials: Words for the trials.
    """
    (low, high), printed = found.interval, SUCCESS[found.condition]
    where = f" in {trials}" if trials else ""
    note = (
        f"{found.successes} of {found.trials}{where}, Wilson {100 * CONFIDENCE:g} % interval "
        f"{low:.3f} to {high:.3f}"
    )
    name = f"{condition_name(found.pitch, found.speed)}{assumptions}"
    mark = rate_mark(found.share, printed)
    return _row(found.robot, name, "success rate", "", found.share, printed, mark, note)


def condition_name(pitch: float, speed: float) -> str:
    """A condition in words."""
    return f"{speed:g} m/s, {pitch:g} deg"


def rate_mark(ours: float, printed: float) -> Mark:
    """The mark of a share, which may be printed as none at all."""
    if printed == 0.0:
        return Mark.PREDICTED if ours == 0.0 else Mark.CONTRADICTED
    return predicted_or_contradicted(ours, printed)


# -- measures of one flight ----------------------------------------------------------------------


def pitch_of(w: Array, x: Array, y: Array, z: Array) -> Array:
    """Pitch in the X-Z plane, positive nose down, over the whole turn, of attitudes [rad]."""
    return np.arctan2(2.0 * (w * y + x * z), 1.0 - 2.0 * (x * x + y * y))


def motion(flight: Flight) -> dict[str, Array]:
    """Flown and asked motion of a flight, tick by tick.

    Returns:
        ``t`` since first touch [s]; ``x`` [m], ``vx`` [m/s] and ``pitch`` [rad] as flown; the same
        with ``asked_`` as the reference asks for, pitch by its acceleration; ``aimed_pitch`` [rad]
        with feedback, as the position controller wants it.
    """
    c, d = flight.columns, flight.telemetry
    touch = flight.measures["touch_time"] or 0.0
    gravity = float(flight.scenario.world.gravity)
    true_pitch = pitch_of(*(c[f"q{part}"] for part in "wxyz"))
    flown = {"x": c["x"], "z": c["z"], "vx": c["vx"], "pitch": true_pitch}
    return {
        "t": d["t"] - touch,
        **{name: np.interp(d["t"], c["t"], curve) for name, curve in flown.items()},
        "asked_x": d["ref_x"],
        "asked_vx": d["ref_vx"],
        "asked_pitch": np.arctan2(d["ref_ax"], d["ref_az"] + gravity),
        "aimed_pitch": pitch_of(*(d[f"aim_q{part}"] for part in "wxyz")),
    }


def command_extremes(flight: Flight, curve: str = "asked_pitch") -> tuple[float, float] | None:
    """Smallest and largest commanded pitch on the way to p_r [deg]; None if there was no way."""
    pitch = np.degrees(motion(flight)[curve][flight.telemetry["phase"] == RECOVER])
    return (float(pitch.min()), float(pitch.max())) if len(pitch) else None


def _began(flight: Flight, phase: float) -> Array:
    """Times at which a phase began [s], without the start of the flight."""
    phases = flight.telemetry["phase"]
    began: Array = flight.telemetry["t"][1:][(phases[1:] == phase) & (phases[:-1] != phase)]
    return began


def returns_of(flight: Flight) -> tuple[float, ...]:
    """True distance from `HOME`, each time that the pilot ends its way home [m]."""
    c = flight.columns
    arrived = np.sort(np.concatenate([_began(flight, CRUISE), _began(flight, HOVER)]))
    gaps = [np.interp(arrived, c["t"], c[axis]) - HOME[k] for k, axis in enumerate("xyz")]
    return tuple(np.sqrt(sum(gap * gap for gap in gaps)).tolist())


# -- flights --------------------------------------------------------------------------------------


def fly_repeated_test(
    robot: str, trial: int, scatter: Scatter, seed: int, collisions: int, *, keep: bool = False
) -> Repeat:
    """Fly the repeated test once."""
    noise_stream = scatter.draw(robot, *REPEATED, trial, seed)
    changes = {
        "recovery": {"runs": collisions}, "simulation": {"duration": TIME_EACH * collisions},
    }  # fmt: skip
    flight = fly(trial_tables(robot, *REPEATED, noise_stream, changes))
    runs, recovered, false_alarms = (
        int(flight.measures[name] or 0.0) for name in ("runs", "recovered_runs", "false_alarms")
    )
    return Repeat(
        robot, trial, flight.outcome, collisions, runs, recovered, returns_of(flight),
        len(_began(flight, LOOK)), false_alarms, flight if keep else None,
    )  # fmt: skip


def fly_sample(robot: str, pitch: float, speed: float, scatter: Scatter, seed: int) -> Sample:
    """The first trial of a condition once more, with its trajectory."""
    noise_stream = scatter.draw(robot, pitch, speed, 0, seed)
    return Sample(
        robot, pitch, speed, noise_stream, fly(trial_tables(robot, pitch, speed, noise_stream))
    )


def resilience_experiments(
    trials: int = TRIALS,
    repeats: int = REPEATS,
    collisions: int = COLLISIONS_IN_A_ROW,
    *,
    compared: int = COMPARED,
    mapped: int = MAPPED,
    scatter: Scatter | None = None,
    seed: int = 0,
    progress: Progress = silent,
) -> ResilienceResults:
    """Fly all collisions in flight, every one with sensors, estimator and lagging rotors.

    Args:
        trials: Of each condition.
        repeats: Of the repeated test, for each robot.
        collisions: Of each repeated test.
        compared: Trials of each condition under each set of choices; none are flown with 0.
        mapped: Trials of each cell of the map; none are flown with 0.
        scatter: Standard deviations from trial to trial; by default those of `Scatter`.
        seed: Of all random draws.
        progress: Called with the fraction done.
    """
    scatter = scatter or Scatter()
    asked = [Condition(robot, *condition) for robot in ROBOTS for condition in CONDITIONS]
    more = [Condition(robot, *SLOWEST) for robot in ROBOTS]

    flown = fly_trials(
        [*asked, *more], trials, scatter=scatter, seed=seed, progress=stage(progress, 0.0, 0.2)
    )
    fast, slow = (list(chain(*some)) for some in (flown[: len(asked)], flown[len(asked) :]))
    results = ResilienceResults(trials, scatter, fast, slow)
    if compared:
        results.choices = fly_choices(
            compared, durations=(DURATION,), seed=seed, progress=stage(progress, 0.2, 0.2)
        )
    if mapped:
        plan = plan_envelope(*MAP, robots=ROBOTS, trials=mapped, seed=seed, settings=MAP_SETTINGS)
        results.envelope = fly_envelope(plan, stage(progress, 0.4, 0.2))
    left = len(SAMPLES) + repeats * len(ROBOTS)

    def tick() -> None:
        done = len(results.samples) + len(results.repeats)
        progress(0.6 + 0.4 * done / left)

    for sample in SAMPLES:
        results.samples.append(fly_sample(*sample, scatter, seed))
        tick()
    for robot in ROBOTS:
        for trial in range(repeats):
            keep = trial == 0
            results.repeats.append(
                fly_repeated_test(robot, trial, scatter, seed, collisions, keep=keep)
            )
            tick()
    return results
