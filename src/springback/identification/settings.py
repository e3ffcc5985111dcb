"""Plan of a fit, as a user writes it: ``fit.toml``."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError, field_validator, model_validator
from pydantic_core import PydanticCustomError

from springback.errors import InputError, shown_value
from springback.problems import dotted_path, key_path, problem_paths
from springback.quantities import Duration, Length, Unit, si_number
from springback.scenario.files import place_of
from springback.scenario.overrides import apply_overrides
from springback.scenario.source_text import source_text, toml_tables
from springback.settings import Name, Settings, problem

Rate = Annotated[float, Unit("Hz", above=0.0)]
#: Fields that are uncertain by default: what a scale and a ruler tell (chosen).
USUALLY_KNOWN = {
    "vehicle.body.mass": "+- 0.5 %",
    "vehicle.arms.mass": "+- 5 %",
    "vehicle.arms.directions": "+- 1 deg",
    "vehicle.body.inertia": "+- 5 %",
}
#: A number with its uncertainty, such as ``30 Hz +- 20 %``.
_ABOUT = re.compile(r"^\s*(?P<centre>.*?)\s*(?:\+-|\+/-|±)\s*(?P<uncertainty>.+?)\s*$")
#: Override of a field's uncertainty in a table of the plan.
_FIELD_WORD = re.compile(
    r"""^\s*(?P<table>free|known)\.(?P<quote>["']?)(?P<name>[^"'=]+?)(?P=quote)\s*=(?P<text>.*)$"""
)
#: The word for a field that is not uncertain.
EXACT = "exact"


class InertialChannel(Settings):
    """An accelerometer [m/s²] or a gyroscope [rad/s]; what is not given is taken from the log."""

    average: Duration | None = None
    """Each sample is the mean over this time before its instant."""
    low_pass: Rate | None = None
    """Corner of a low-pass after the range: ``bandwidth`` of a scenario's sensor.  A corner such as
    ``30 Hz +- 20 %`` is fitted with the rest, the same in every impact."""
    low_pass_uncertainty: Annotated[float, Unit("", above=0.0)] | None = None
    """Standard deviation of the corner, as a share of it; by default exact."""
    low_pass_order: Literal[1, 2] | None = None
    """1, or 2 for a Butterworth filter such as those of PX4 and ArduPilot; by default as in the
    log, or 1."""
    device_low_pass: Rate | None = None
    """Corner of the device's own first-order low-pass, before that of an autopilot; by default
    ``bandwidth`` of the scenario's sensor if ``low_pass`` is of second order."""

    @model_validator(mode="before")
    @classmethod
    def _corner(cls, given: Any) -> Any:
        """The uncertainty that is written behind a corner has a key of its own."""
        told = given.get("low_pass") if isinstance(given, Mapping) else None
        if not isinstance(told, str) or not (parts := _ABOUT.match(told)):
            return given
        if "low_pass_uncertainty" in given:
            raise problem("is given in low_pass as well", "low_pass_uncertainty")
        share: Any = parts["uncertainty"]
        if share.endswith("Hz"):  # what cannot be read is said of the keys themselves
            with contextlib.suppress(PydanticCustomError):
                ends = (si_number(one, "Hz", above=0.0) for one in (share, parts["centre"]))
                share = next(ends) / next(ends)
        return {**given, "low_pass": parts["centre"], "low_pass_uncertainty": share}

    @model_validator(mode="before")
    @classmethod
    def _as_of_a_log(cls, given: Any) -> Any:
        if isinstance(given, Mapping) and "bandwidth" in given:
            raise problem(
                "is called low_pass in a plan, as in a log's mapping; bandwidth is the same "
                "number of a scenario's sensors.imu",
                "bandwidth",
            )
        return given


class AccelerometerFit(InertialChannel):
    """Accelerometer."""

    full_scale: Annotated[float, Unit("m/s^2", above=0.0)] | None = None
    """End of its range; by default as the log or the scenario has it."""
    noise: Annotated[float, Unit("m/s^2", above=0.0)] | None = None
    """Standard deviation of a sample, if white; by default estimated before touch."""
    bias: Annotated[float, Unit("m/s^2", above=0.0)] = 0.2
    """Standard deviation of each axis (chosen)."""
    scale: Annotated[float, Unit("", above=0.0)] | None = None
    """Standard deviation of its factor, the same for all axes and impacts; by default exact."""
    misalignment: Annotated[float, Unit("rad", above=0.0)] | None = None
    """Standard deviation of each component of a small rotation from the body's axes; by default
    exact."""


class GyroscopeFit(InertialChannel):
    """Gyroscope."""

    full_scale: Annotated[float, Unit("rad/s", above=0.0)] | None = None
    """End of its range; by default as the log or the scenario has it."""
    noise: Annotated[float, Unit("rad/s", above=0.0)] | None = None
    """Standard deviation of a sample, if white; by default estimated before touch."""
    bias: Annotated[float, Unit("rad/s", above=0.0)] = 0.02
    """Standard deviation of each axis (chosen)."""


class MotionCaptureFit(Settings):
    """Motion capture."""

    noise: Annotated[float, Unit("m", above=0.0)] | None = None
    """Standard deviation of each axis of a position; by default estimated before touch."""
    attitude_noise: Annotated[float, Unit("rad", above=0.0)] | None = None
    """The same for a small rotation vector."""
    smoothing: Rate | None = None
    """Corner of the program's zero-phase Butterworth filter, of second order each way."""
    offset: Annotated[float, Unit("m", above=0.0)] = 0.02
    """Uncertainty of its origin relative to the scenario's obstacles, each axis (chosen)."""


class ArmLengthFit(Settings):
    """Sensors of the arms' lengths."""

    order: tuple[Annotated[int, Field(ge=1, strict=True)], ...] = ()
    """Arm of each column of the log, counted from 1 as in ``vehicle.arms.directions``; by default
    the columns are in that order."""
    noise: Annotated[float, Unit("m", above=0.0)] | None = None
    """Standard deviation of a sample; by default that of the scenario's Hall sensors."""
    shortest: Annotated[float, Unit("m", above=0.0)] | None = None
    """Least length that they can measure, as in the log; an arm that reads it may be shorter."""
    longest: Annotated[float, Unit("m", above=0.0)] | None = None
    """Largest length that they can measure; an arm that reads it may be longer."""


class FitSensors(Settings):
    """What stands between the motion and the logs, beyond what the logs say."""

    accelerometer: AccelerometerFit = AccelerometerFit()
    """The one with the fastest samples."""
    gyroscope: GyroscopeFit = GyroscopeFit()
    """The one in the same inertial unit."""
    motion_capture: MotionCaptureFit = MotionCaptureFit()
    """Positions and attitudes of the body, from a file of their own if there is one."""
    arm_length: ArmLengthFit = ArmLengthFit()
    """Lengths of the arms, as changes from before touch."""
    place: tuple[Any, Any, Any] | None = None
    """Position of the inertial unit from the main body's centre of mass, body axes; by default
    ``sensors.imu.offset`` of the scenario."""

    @field_validator("place")
    @classmethod
    def _metres(cls, given: Any) -> Any:
        return None if given is None else Unit("m").triple(given)


class ClockFit(Settings):
    """Clocks of other devices relative to that of the inertial unit."""

    offset: Annotated[float, Unit("s")] | None = None
    """Time added to theirs; by default found from the rotations that both measured."""
    uncertainty: Duration = 2e-3
    """Its standard deviation (chosen: what a correlation of rotations leaves)."""


class StartFit(Settings):
    """Uncertainty of the state at the start of the window, about what the log's tracks say."""

    position: Annotated[float, Unit("m", above=0.0)] = 0.02
    """Standard deviation of each axis (chosen); three times as much without a track, as are the
    next three."""
    velocity: Annotated[float, Unit("m/s", above=0.0)] = 0.2
    """Standard deviation of each axis (chosen)."""
    attitude: Annotated[float, Unit("rad", above=0.0)] = 0.06
    """Standard deviation of each component of a small rotation vector (chosen)."""
    angular_velocity: Annotated[float, Unit("rad/s", above=0.0)] = 0.5
    """Standard deviation of each axis (chosen)."""
    height: Annotated[float, Unit("m", above=0.0)] = 0.01
    """Standard deviation of the height of a drop, if no track recorded the fall (chosen): the
    height itself is that of the scenario's start; the others are then not three times as much."""


class WindowFit(Settings):
    """Part of a log that is fitted."""

    before: Duration = 0.3
    """Time before touch."""
    after: Duration | None = None
    """Time after release; by default three times the contact time, and at least 0.15 s."""


class LoggedFlight(Settings):
    """Logs of one flight."""

    logs: Annotated[tuple[str, ...], Field(min_length=1)]
    """Files, or folders that ``springback fly`` wrote, relative to the plan."""
    world: str | None = None
    """World axes of poses: nwu, enu, ned, z-up, y-up."""
    body: str | None = None
    """Body axes of poses: flu, frd, rfu, y-up."""
    track: str | None = None
    """Name of the vehicle among the bodies that motion capture tracked; by default the one that
    turns as the gyroscope says."""
    first: Annotated[float, Unit("s")] | None = None
    """First instant to read."""
    last: Annotated[float, Unit("s")] | None = None
    """Last instant to read."""
    no_check: bool = False
    """Go on, with a warning, if the data contradict their axes or their quaternion order."""
    at: tuple[Annotated[float, Unit("s")], ...] = ()
    """Instants of the touches to fit, to within 50 ms; by default all that are found."""
    change: tuple[str, ...] = ()
    """Overrides of the scenario for this flight, such as ``start.velocity.0=2``."""


class OtherExperiment(Settings):
    """A test that could be flown next."""

    name: Name
    change: tuple[str, ...]
    """Overrides of the scenario, such as ``world.obstacles.0.distance=2``."""


SensorName = Literal["imu", "motion-capture", "arm-length"]


class CandidateSettings(Settings):
    """Tests among which `springback identify plan` chooses: all of these combined, and others.

    Flights have speeds, pitches and yaws; drops have heights, rolls and pitches.
    """

    speeds: tuple[Annotated[float, Unit("m/s", above=0.0)], ...] = (1.0, 2.0, 3.5)
    """Speeds at touch, along the scenario's ``start.velocity``."""
    pitches: tuple[Annotated[float, Unit("rad")], ...] = (0.0, 0.2617993877991494)
    """Pitch of the start, nose down; none on a slider.  For drops, besides the start's."""
    yaws: tuple[Annotated[float, Unit("rad")], ...] = (0.0, 0.7853981633974483)
    """Yaw of the start; none on a slider."""
    heights: tuple[Length, ...] = (0.3, 0.7, 1.5)
    """Heights of drops, from the start to touch, along the slider if there is one."""
    rolls: tuple[Annotated[float, Unit("rad")], ...] = (0.0, 0.7853981633974483)
    """Roll of drops, in addition to that of the scenario's ``start``; none on a slider."""
    others: tuple[OtherExperiment, ...] = ()
    """Further tests, by overrides of the scenario."""
    sensors: tuple[SensorName, ...] = ("imu", "motion-capture")
    """Sensors that record, with the settings of the scenario's ``sensors``."""
    count: Annotated[int, Field(ge=1, le=20, strict=True)] = 3
    """Number of tests to choose, one after another."""


LawName = Literal["hunt-crossley", "hertz", "kelvin-voigt", "constant-restitution"]


class OtherModel(Settings):
    """A model to compare with the plan's."""

    name: Name
    change: tuple[str, ...] = ()
    """Overrides of the scenario."""
    free: dict[str, str] = Field(default_factory=dict)
    """Fields that are fitted in place of the plan's; by default the same."""


class ComparisonFit(Settings):
    """Models to compare by how well each predicts impacts that it was not fitted to."""

    laws: tuple[LawName, ...] = ()
    """Laws of the obstacle's surface; each begins as stiff and as lossy as the plan's fitted law,
    and its own numbers are free within a factor of 5 (1.5 for a restitution)."""
    obstacle: Annotated[int, Field(ge=0, strict=True)] = 0
    """Number of the obstacle whose law is compared."""
    others: tuple[OtherModel, ...] = ()
    """Further models, by overrides of the scenario."""


class FitPlan(Settings):
    """Plan of a fit."""

    name: Name = "fit"
    scenario: str
    """Path of the scenario: vehicle, obstacle hit, sensors; and start, where logs give none."""
    flights: tuple[LoggedFlight, ...] = ()
    """Recorded flights; ``logs`` may be given instead, for a single flight."""
    experiment: Literal["flight", "drop"] = "flight"
    """``drop``: impacts from above count; in a ``flight`` they are taken for landings."""
    free: dict[str, str]
    """Fields to be fitted, each with its uncertainty: ``factor 5``, ``+- 20 %``, ``+- 5 deg``,
    ``5 N/mm factor 3``."""
    known: dict[str, str] = Field(default_factory=dict)
    """Fields known to some uncertainty, such as ``1.88 kg +- 0.5 %``; ``exact`` if there is none.

    By default the mass of the body is known to 0.5 %, its moments of inertia to 5 % each, the mass
    of arms to 5 %, and the direction of each to 1 degree; ``vehicle.arms.directions`` and
    ``vehicle.body.inertia`` stand for all of theirs.
    """
    sensors: FitSensors = FitSensors()
    """What the sensors do to the motion, where the logs do not say."""
    clocks: ClockFit = ClockFit()
    """Clocks of devices besides the inertial unit."""
    start: StartFit = StartFit()
    """Uncertainty of the state before touch."""
    thrust: Annotated[float, Unit("", above=0.0)] = 0.05
    """Standard deviation of the factor of all thrusts (chosen)."""
    window: WindowFit = WindowFit()
    """Part of the logs that is fitted."""
    candidates: CandidateSettings = CandidateSettings()
    """Tests that could be flown next."""
    compare: ComparisonFit = ComparisonFit()
    """Laws, or other models, to compare by their predictions of impacts left out."""
    scatter: Literal["impact", "none"] = "impact"
    """``impact``: what is fitted may differ from impact to impact; ``none``: it may not."""
    method: Literal["laplace", "emcee"] = "laplace"
    """How ``posterior.parquet`` is drawn: by the normal approximation at the optimum, or by Monte
    Carlo (extra ``mcmc``) if the posterior is curved or cut off; that takes minutes."""
    starts: Annotated[int, Field(ge=1, le=64, strict=True)] = 4
    """Number of starts of the search: those nearest to the data of eight times as many points of a
    Sobol' sequence."""
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Seed of the scrambling of the starts, and of draws from the posterior."""

    @model_validator(mode="before")
    @classmethod
    def _single_flight(cls, given: Any) -> Any:
        """``logs`` alone are those of a single flight."""
        if isinstance(given, Mapping) and "logs" in given:
            if "flights" in given:
                raise problem("cannot be combined with [[flights]]", "logs")
            keys = ("logs", "track", "no_check")
            alone = {key: given[key] for key in keys if key in given}
            rest = {key: value for key, value in given.items() if key not in alone}
            return {**rest, "flights": [alone]}
        return given

    @model_validator(mode="after")
    def _something_free(self) -> FitPlan:
        if not self.free:
            raise problem("needs at least one field", "free")
        for name in self.free:
            if name in self.known:
                raise problem("is free as well", f"known.{name}")
        return self

    def uncertainties(self) -> dict[str, str]:
        """Known fields with their uncertainty, those that usually are included."""
        told = {name: text for name, text in USUALLY_KNOWN.items() if name not in self.free}
        told |= self.known
        return {name: text for name, text in told.items() if text.strip() != EXACT}

    def is_given(self, name: str) -> bool:
        """True if the plan says itself how well a field is known."""
        return name in self.free or name in self.known


def read_fit_plan(path: str | Path, overrides: Sequence[str] = ()) -> FitPlan:
    """Read a plan.

    Args:
        path: TOML file.
        overrides: Words such as ``starts=16``, or ``known.vehicle.body.mass=+- 1 %``, a field's
            name with or without quotes.

    Raises:
        InputError: One line for each problem, with file, line and field.
    """
    path = Path(path)
    text = source_text(path)
    given = toml_tables(text, str(path))
    rest = list[str]()
    for word in overrides:
        if match := _FIELD_WORD.match(word):  # its name has dots: one key
            table = given.setdefault(match["table"], {})
            table[match["name"]] = _unquoted(match["text"])
        else:
            rest.append(word)
    try:
        return FitPlan.model_validate(apply_overrides(given, rest))
    except ValidationError as error:
        problems = []
        for keys, what in problem_paths(error):
            said = f"{dotted_path(keys)}: {what}" if keys else what
            problems.append(f"{place_of(str(path), text, keys)}: {said}")
        raise InputError(*problems) from None


def _unquoted(text: str) -> str:
    text = text.strip()
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'" else text


@contextlib.contextmanager
def naming_places(path: str | Path) -> Iterator[None]:
    """Give problems of a plan's fields the file, the line and the table that they are of.

    Args:
        path: Of the plan.

    Raises:
        InputError: Again, each line that begins with a key of the plan with its place.
    """
    try:
        yield
    except InputError as error:
        text = source_text(Path(path))
        tables = toml_tables(text, str(path))
        raise InputError(
            *(_placed(one, str(path), text, tables) for one in error.problems)
        ) from None


def _placed(line: str, path: str, text: str, tables: Mapping[str, Any]) -> str:
    name, colon, rest = line.partition(": ")
    if not colon or line.startswith(path):
        return line
    for table in ("free", "known"):
        if name in tables.get(table, {}):
            return f"{place_of(path, text, (table, *key_path(name)))}: {table}.{name}: {rest}"
    keys = key_path(name)
    if keys and keys[0] in FitPlan.model_fields and keys[0] != "name":
        return f"{place_of(path, text, keys)}: {line}"
    return line


def refuse_second_vehicle(scenario: Any) -> None:
    """Refuse scenarios of two vehicles, of which a fit knows the start of one only."""
    if scenario.second is not None:
        raise InputError(
            f"second: must not be given in the scenario of a fit (got "
            f"{shown_value(scenario.second.name)})"
        )
