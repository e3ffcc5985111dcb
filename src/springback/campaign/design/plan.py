"""Plan of a campaign, as a user writes it."""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo, model_validator

from springback.campaign.design.materials import ranges_of, written_fields
from springback.campaign.design.posterior import Posterior, existing_file, with_overlay
from springback.errors import InputError, excerpt, shown_value
from springback.problems import dotted_path, key_path, problem_paths
from springback.quantities import Unit
from springback.scenario.code_files import absolute_code, with_absolute_names
from springback.scenario.files import place_of, read_scenario
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import (
    is_vehicle_file,
    read_vehicle,
    second_tables,
    thrust_of,
    vehicle_table,
    with_contents,
)
from springback.scenario.source_text import json_tables, source_text, toml_tables
from springback.settings import Name, Settings, naming, problem
from springback.studies.trials import Scatter
from springback.user_code import Arguments, CodeName
from springback.vehicle.library import VEHICLES

Method = Literal["grid", "random", "latin-hypercube", "sobol"]
#: Upper limit of samples, and of repeats, to catch typing errors (chosen).
MOST_SAMPLES = 10**8
#: Upper limits of levels of a field, and of fields, to catch typing errors (chosen).
MOST_LEVELS, MOST_FIELDS = 100_000, 100
Count = Annotated[int, Field(ge=1, le=MOST_SAMPLES, strict=True)]
#: Key of the field ``from_``, as ``from`` is a keyword of Python.
FROM = "from_"


class Spaced(Settings):
    """A table with a key ``from``, which is ``from_`` in Python."""

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, given: Any) -> Any:
        """Known keys of settings, with ``from`` for ``from_``."""
        if not isinstance(given, dict):
            return given
        known = Settings._known_keys.__func__
        return known(cls, {FROM if key == "from" else key: value for key, value in given.items()})


class Normal(Settings):
    """A normal distribution."""

    mean: Any = None
    """Mean; by default the scenario's own value."""
    deviation: Any
    """Standard deviation."""


class FactorLaw(Spaced):
    """Distribution of a factor that multiplies the scenario's own value."""

    deviation: Annotated[float, Unit("", above=0.0)] | None = None
    """Standard deviation of the factor's logarithm: 5 % gives factors of about 0.95 to 1.05."""
    from_: Annotated[float, Unit("", above=0.0)] | None = None
    to: Annotated[float, Unit("", above=0.0)] | None = None
    """Upper bound of a uniform factor, with ``from``."""

    @model_validator(mode="after")
    def _one_way(self) -> FactorLaw:
        pair = (self.from_ is not None, self.to is not None)
        if any(pair) if self.deviation is not None else not all(pair):
            raise problem("needs either deviation, or from and to")
        return self


class Vary(Spaced):
    """A field of the scenario that varies from sample to sample."""

    field: str
    """A short name, or the dotted path of any value of the scenario."""
    name: Name | None = None
    """Name of its column; by default that of the field."""
    from_: Any = None
    to: Any = None
    count: Annotated[int, Field(ge=2, le=MOST_LEVELS, strict=True)] | None = None
    """Number of levels from ``from`` to ``to``, inclusive; a grid needs it, or ``step``."""
    step: Any = None
    """Spacing of levels."""
    spacing: Literal["linear", "logarithmic"] = "linear"
    values: tuple[Any, ...] | None = None
    """List of levels: numbers, names of surfaces, or true and false."""
    normal: Normal | None = None
    factor: FactorLaw | None = None
    source: str | None = None
    """Where the range comes from, shown with the results."""

    @model_validator(mode="after")
    def _one_way(self) -> Vary:
        span = self.from_ is not None or self.to is not None
        ways = (span, self.values is not None, self.normal is not None, self.factor is not None)
        if sum(ways) != 1:
            raise problem("needs one of: from and to, values, normal, factor")
        if span and (self.from_ is None or self.to is None):
            raise problem("is missing", "from" if self.to else "to")
        if not span and (self.count or self.step is not None or self.spacing != "linear"):
            raise problem("count, step and spacing belong to from and to")
        if self.count and self.step is not None:
            raise problem("cannot be combined with count; give only one", "step")
        if self.step is not None and self.spacing != "linear":
            raise problem("belongs to linear spacing; give count", "step")
        if self.values is not None and not self.values:
            raise problem("needs at least one value", "values")
        if self.values is not None and len(self.values) > MOST_LEVELS:
            what = f"must be at most {MOST_LEVELS} values (got {len(self.values)})"
            raise problem(what, "values")
        return self


class ScatterSettings(Settings):
    """Standard deviations of the scatter, as in `springback.studies.trials.Scatter`.

    ``"trials"`` stands for those of the trials; quantities that are not given are not scattered.
    """

    position: Annotated[float, Unit("m", least=0.0)] = 0.0
    velocity: Annotated[float, Unit("m/s", least=0.0)] = 0.0
    heading: Annotated[float, Unit("rad", least=0.0)] = 0.0
    wall_distance: Annotated[float, Unit("m", least=0.0)] = 0.0
    wall_yaw: Annotated[float, Unit("rad", least=0.0)] = 0.0
    mass: Annotated[float, Unit("", least=0.0)] = 0.0
    inertia: Annotated[float, Unit("", least=0.0)] = 0.0
    gains: Annotated[float, Unit("", least=0.0)] = 0.0

    @model_validator(mode="before")
    @classmethod
    def _preset(cls, given: Any) -> Any:
        table = {"preset": given} if isinstance(given, str) else given
        if not isinstance(table, dict) or "preset" not in table:
            return table
        if table["preset"] != "trials":
            raise problem(f"must be trials (got {shown_value(table['preset'])})", "preset")
        return Scatter()._asdict() | {key: v for key, v in table.items() if key != "preset"}

    def deviations(self) -> Scatter:
        """Standard deviations as numbers."""
        return Scatter(**self.model_dump())


def _shown(value: Any) -> str:
    """A parameter in a name."""
    return f"{value:g}" if isinstance(value, float) else str(value)


#: Name of springback's own pilot among those of a plan.
SPRINGBACK = "springback"


class PlanPilot(Settings):
    """A pilot of a plan: springback's, or your own code with parameters.

    Its name alone, ``"FILE.py:NAME"`` or ``"springback"``, stands for a table.
    """

    code: CodeName | None = None
    """``FILE.py:NAME`` of the pilot, or of a function that returns it; none: springback's."""
    parameters: Arguments = Field(default_factory=dict)
    """Arguments of that function, in SI."""
    name: Name | None = None
    """Name of the pilot in the names of robots; by default ``NAME`` and the parameters."""

    @model_validator(mode="before")
    @classmethod
    def _named(cls, given: Any) -> Any:
        table = {"code": given} if isinstance(given, str) else given
        if not isinstance(table, dict) or table.get("name"):
            return table
        code, parameters = table.get("code"), table.get("parameters")
        if code in (None, SPRINGBACK):
            return {**table, "code": None, "name": SPRINGBACK}
        words = parameters.items() if isinstance(parameters, dict) else ()
        names = [str(code).rpartition(":")[2], *(f"{key} {_shown(value)}" for key, value in words)]
        return {**table, "name": " ".join(names)}

    @model_validator(mode="after")
    def _with_code(self) -> PlanPilot:
        if self.code is None and self.parameters:
            raise problem("belong to a pilot of your own; give its code", "parameters")
        return self

    def flown_in(self, tables: dict[str, Any]) -> dict[str, Any]:
        """Raw scenario that this pilot flies."""
        others = {key: value for key, value in tables.items() if key != "pilot"}
        if self.code is None:
            return others
        return {**others, "pilot": {"code": self.code, "parameters": self.parameters}}


def _conditions(value: Any) -> Any:
    """Condition in SQL, or conditions in words."""
    words = [*value] if isinstance(value, list | tuple) else None
    if words is None and not (value is None or isinstance(value, str)):
        raise problem(f"must be text in SQL, or a list of conditions (got {shown_value(value)})")
    if words is not None and not (words and all(isinstance(word, str) for word in words)):
        raise problem(f"must be a list of at least one text (got {shown_value(value)})")
    return value if words is None else tuple(words)


class Keep(Settings):
    """Selection of flights whose trajectories are stored."""

    where: Annotated[str | tuple[str, ...], BeforeValidator(_conditions)]
    """Condition on the columns of a row: a text is SQL; a list has conditions in words, as for
    ``success``, which must all hold.  ``success`` and ``not success`` are conditions here, too."""
    most: Annotated[int, Field(ge=1, le=100_000, strict=True)] = 20
    """Largest number of flights; the first that satisfy the condition are kept."""


class Plan(Settings):
    """Plan of the flights of a campaign.

    Flight k is robot ``k % robots``, repeat ``k // robots % repeats`` and sample
    ``k // robots // repeats``.  All robots get the same samples and the same noise.  Where pilots
    are given, each vehicle with each of them is a robot.
    """

    name: Name = "campaign"
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Seed of samples and noise."""
    scenario: dict[str, Any] | str
    """Scenario without variations: tables, or the path of a scenario file."""
    overlay: str | None = None
    """Path of values to overlay on it, such as ``identified.toml`` of a fit."""
    robots: tuple[str, ...] = ()
    """Presets, names in `vehicles`, or vehicle files, each in place of the scenario's vehicle; by
    default that alone."""
    vehicles: dict[Name, dict[str, Any]] = {}  # noqa: RUF012  # pydantic copies it
    """Your own vehicles by name, in place of files."""
    pilots: tuple[PlanPilot, ...] = ()
    """Pilots that fly each robot, in place of the scenario's: ``"springback"``, ``"FILE.py:NAME"``
    or tables; by default the scenario's own."""
    method: Method
    samples: Count | None = None
    """Number of samples; must not be given for a grid, whose number of points it is."""
    repeats: Count = 1
    """Flights with each sample and robot, with different sensor noise and scatter."""
    vary: tuple[Vary, ...] = ()
    posterior: Posterior | None = None
    """Path of a posterior, such as ``posterior.parquet`` of a fit, or a table: a whole row of its
    fields is drawn for each sample."""
    scatter: ScatterSettings | None = None
    success: Annotated[str | tuple[str, ...] | None, BeforeValidator(_conditions)] = None
    """Condition of success on the columns of a row: a text is SQL; a list has conditions in words,
    such as ``arm_stroke < 20 mm``, which must all hold.  By default the robot must have recovered
    or, without recovery, must not have touched the ground, used up a stroke or diverged; and, with
    a pilot of your own, it must have come to rest after a collision."""
    keep: Keep | None = None

    @model_validator(mode="before")
    @classmethod
    def _materials(cls, given: Any) -> Any:
        """A raw plan, its materials and guards replaced by the ranges that are known of them."""
        if not isinstance(given, dict) or not isinstance(given.get("vary"), list | tuple):
            return given
        fields = []
        for k, one in enumerate(given["vary"]):
            with naming(f"vary.{k}"):
                fields += ranges_of(one)
        return {**given, "vary": fields}

    @model_validator(mode="after")
    def _check_counts(self, info: ValidationInfo) -> Plan:
        if self.method == "grid" and self.samples is not None:
            raise problem("cannot be given for a grid, which has its points", "samples")
        if self.method != "grid" and self.samples is None:
            raise problem(f"is missing: how many a {self.method} design has", "samples")
        if len(self.vary) > MOST_FIELDS:
            raise problem(f"must be at most {MOST_FIELDS} fields (got {len(self.vary)})", "vary")
        if len(set(self.robots)) != len(self.robots):
            raise problem(f"names one twice (got {list(self.robots)})", "robots")
        pilots = [pilot.name for pilot in self.pilots]
        for k, name in enumerate(pilots):
            if name in pilots[:k]:
                what = f"is that of another pilot, {name!r}; give another"
                raise problem(what, f"pilots.{k}.name")
        return self

    @classmethod
    def in_words(cls, error: ValidationError) -> list[str]:
        """Problems of a plan built in Python, one line each."""
        return [Source().problem_line(*_in_users_words(*found)) for found in problem_paths(error)]

    def canonical(self) -> str:
        """Plan as JSON, the same text for the same plan."""
        return json.dumps(
            self.model_dump(mode="json"), sort_keys=True, ensure_ascii=False, allow_nan=False
        )

    def digest(self) -> str:
        """SHA-256 of everything that affects the flights, without ``name`` and ``keep``."""
        absent = {key for key in ("overlay", "posterior") if getattr(self, key) is None}
        data = self.model_dump(mode="json", exclude={"name", "keep", *absent})
        text = json.dumps(data, sort_keys=True, ensure_ascii=False, allow_nan=False)
        return hashlib.sha256(text.encode()).hexdigest()


#: Tables of scenarios that plans do not have.
OF_SCENARIOS = {"vehicle", "world", "start", "thrust", "reference", "simulation"}


class Source:
    """Origin of a plan, for messages about its problems."""

    def __init__(self, name: str = "", text: str = "", overrides: Sequence[str] = ()) -> None:
        """Origin in a file with its text and overrides; none for a plan built in Python."""
        self.name, self.text, self.overrides = name, text, tuple(overrides)
        #: Of each field of the plan, see `written_fields`; empty for a plan built in Python.
        self.fields: list[tuple[int, str]] = []

    def entry(self, field: int) -> int:
        """Number of the entry of ``vary``, as it is written, that a field of the plan is from."""
        return self.fields[field][0] if field < len(self.fields) else field

    def problem_line(self, path: Sequence[str | int], what: str) -> str:
        """Problem in one line; the path is one of the plan, whose materials have been replaced."""
        keys = tuple("from" if key == FROM else key for key in path)
        if keys[:1] == ("vary",) and isinstance(number := next(iter(keys[1:]), None), int):
            drawn = self.fields[number][1] if number < len(self.fields) else ""
            inner = keys[2:] if not drawn or keys[2:3] in (("field",), ("count",)) else (drawn,)
            keys = ("vary", self.entry(number), *inner)
        said = f"{dotted_path(keys)}: {what}" if keys else what
        if not self.name:
            return said
        for word in reversed(self.overrides):
            if keys and word.partition("=")[0].strip().split(".")[0] == keys[0]:
                return f"override {excerpt(word)}: {said}"
        return f"{place_of(self.name, self.text, keys)}: {said}"


def read_plan(path: str | Path, overrides: Sequence[str] = ()) -> tuple[Plan, Source]:
    """Read a plan file with its scenario, and apply overrides.

    Args:
        path: TOML file, or JSON file of a campaign's folder.
        overrides: Words such as ``samples=100``.

    Raises:
        InputError: One line for each problem: file and line or override, field, value, range.
    """
    path = Path(path)
    text = source_text(path)
    tables = json_tables if path.suffix == ".json" else toml_tables
    given = tables(text, str(path))
    source = Source(str(path), text, overrides)
    if "scenario" not in given and given.keys() & OF_SCENARIOS:
        raise InputError(
            f"{path}: is a scenario, not a plan of a campaign: name it in one, "
            f'scenario = "{path.name}", with what varies ([[vary]]); springback new campaign '
            "writes a plan to start from"
        )
    if any(key_path(word.partition("=")[0])[:1] == ("scenario",) for word in overrides):
        given = _with_tables(given, path.parent, source)
    plan = plan_from(apply_overrides(given, overrides), source)
    return with_scenario(plan, path.parent, source), source


def _with_tables(given: dict[str, Any], folder: Path, source: Source) -> dict[str, Any]:
    """A raw plan with the tables of its scenario if overrides refer to them."""
    if not isinstance(given.get("scenario"), str):
        return given
    tables = _scenario_tables(folder, given["scenario"], source)
    if not isinstance(given.get("overlay"), str):
        return {**given, "scenario": tables}
    tables = _overlaid(tables, folder, given["overlay"], source)
    return {**{key: value for key, value in given.items() if key != "overlay"}, "scenario": tables}


def _overlaid(tables: dict[str, Any], folder: Path, name: str, source: Source) -> dict[str, Any]:
    with _blaming(source, "overlay"):
        return with_overlay(tables, folder / name)


@contextlib.contextmanager
def _blaming(source: Source, *path: str | int) -> Iterator[None]:
    """Name an entry of the plan in problems that arise within."""
    try:
        yield
    except InputError as error:
        raise InputError(*(source.problem_line(path, line) for line in error.problems)) from None


def plan_from(given: dict[str, Any], source: Source | None = None) -> Plan:
    """Plan from plain tables.

    Raises:
        InputError: One line for each problem.
    """
    source = source or Source()
    source.fields = written_fields(given.get("vary"))
    problem_line = source.problem_line
    try:
        return Plan.model_validate(given)
    except ValidationError as error:
        raise InputError(
            *(problem_line(*_in_users_words(*found)) for found in problem_paths(error))
        ) from None


def _in_users_words(path: tuple[str | int, ...], what: str) -> tuple[tuple[str | int, ...], str]:
    """Path and message without pydantic's names of union branches, and with the user's keys."""
    kept = tuple(key for key in path if not (isinstance(key, str) and key.startswith("dict[")))
    if kept[:1] == ("scenario",):
        return ("scenario",), "must be a table, or the path of a scenario file"
    return kept, what.replace(FROM, "from")


def with_scenario(plan: Plan, folder: Path, source: Source) -> Plan:
    """Plan with its scenario file, and its files of vehicles and thrusts, replaced by their tables.

    Relative names of code become absolute.

    Args:
        plan: Any.
        folder: Folder that the scenario's path is relative to.
        source: Origin of the plan.
    """
    if isinstance(plan.scenario, str):
        tables = _scenario_tables(folder, plan.scenario, source)
    else:
        tables = with_absolute_names(plan.scenario, folder)
    if plan.overlay is not None:
        tables = _overlaid(tables, folder, plan.overlay, source)
    posterior = plan.posterior
    if posterior is not None:
        with _blaming(source, "posterior"):
            posterior = posterior.with_file_read(folder)
    tables = with_contents(tables)
    vehicle = tables.get("vehicle")
    word = vehicle.get("preset") if isinstance(vehicle, dict) else vehicle
    if is_vehicle_file(word):
        tables = {**tables, "vehicle": vehicle_table(vehicle)}
    if "thrust" in tables:
        tables = {**tables, "thrust": thrust_of(tables["thrust"])}
    if tables.get("second") is not None:
        tables = {**tables, "second": _second_tables(tables["second"], source)}
    pilots = tuple(
        one if one.code is None else one.with_checked(code=absolute_code(one.code, folder))
        for one in plan.pilots
    )
    whole = {"scenario": tables, "overlay": None, "posterior": posterior, "pilots": pilots}
    return _with_vehicles(plan.with_checked(**whole), folder, source)


def _second_tables(given: Any, source: Source) -> Any:
    """Raw second vehicle, its files replaced by their tables, without a seed of its own."""
    with _blaming(source, "scenario", "second"):
        tables = second_tables(given)
    if not isinstance(tables, dict):
        return tables
    return {key: value for key, value in tables.items() if key != "seed"}


def _with_vehicles(plan: Plan, folder: Path, source: Source) -> Plan:
    """Plan with the vehicle files among its robots read."""
    robots, vehicles = list(plan.robots), dict(plan.vehicles)
    for k, robot in enumerate(robots):
        if is_vehicle_file(robot):
            with _blaming(source, "robots", k):
                table = read_vehicle(folder / robot)
            robots[k] = str(table["name"])
            if robots[k] in vehicles or robots.count(robots[k]) > 1 or robots[k] in VEHICLES:
                what = f"{robot} has the name of another vehicle, {robots[k]!r}; give it another"
                raise InputError(source.problem_line(("robots", k), what))
            vehicles[robots[k]] = table
    return plan.with_checked(robots=tuple(robots), vehicles=vehicles)


def _scenario_tables(folder: Path, name: str, source: Source) -> dict[str, Any]:
    """Raw tables of a plan's scenario file."""
    path = folder / name
    with _blaming(source, "scenario"):
        existing_file(path)
    read_scenario(path, pilot=False)  # for errors that name its lines
    return with_absolute_names(toml_tables(source_text(path), str(path)), path.parent)
