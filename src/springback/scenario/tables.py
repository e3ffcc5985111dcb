"""Tables of a scenario: user input, each table validated by itself."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import BeforeValidator, ConfigDict, Field, PlainValidator, model_validator

from springback.contact.parameters import Ground, PlaneSettings, SurfaceSettings
from springback.contact.shapes import ShapeSettings
from springback.contact.worlds import BuiltIn
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import ReferenceSettings
from springback.dynamics.air import AirSettings
from springback.errors import shown_value
from springback.frames import attitude_from_euler, euler_from_attitude
from springback.kernels.tracing import sqrt  # for batch set-up
from springback.kernels.vectors import Quat, Vec
from springback.quantities import Angle, Duration, PerArm, Quadruple, Triple, Unit, si_number
from springback.recovery.parameters import RecoverySettings
from springback.scenario.worlds.imported import Imported, single_obstacles
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.parameters import SensorSettings
from springback.settings import Name, Settings, naming, problem
from springback.user_code import Arguments, CodeName, NamedCode
from springback.vehicle.parameters import Vehicle, check_moments

#: Most planes and shapes of the user's own (chosen: a flight is compiled for each number of them),
#: and most obstacles in all.
MOST_OBSTACLES, MOST_SHAPES = 64, 10_000
#: Largest deviation of a quaternion's length from 1 (chosen: the rounding of four decimals).
UNIT_LENGTH = 1e-4


class UserShape(Settings):
    """An obstacle of your own: a shape in a Python file, and its surface."""

    type: Literal["own"]
    name: Name = ""
    """Name for messages and drawings."""
    shape: CodeName
    """``FILE.py:NAME`` of a shape, or of its type or a function, called with ``parameters``."""
    parameters: Arguments = Field(default_factory=dict)
    """Arguments of the type or function, in SI."""
    surface: SurfaceSettings


#: Any obstacle of a world.
AnyObstacle = Annotated[BuiltIn | UserShape | Imported, Field(discriminator="type")]


class WorldSettings(Settings):
    """Obstacles and gravity."""

    gravity: Annotated[float, Unit("m/s^2", least=0.0)] = 9.81
    obstacles: tuple[AnyObstacle, ...] = ()

    @model_validator(mode="after")
    def _countable(self) -> WorldSettings:
        count, own = len(single_obstacles(self.obstacles)), self.of_own_structure()
        if own > MOST_OBSTACLES:
            what = f"must be at most {MOST_OBSTACLES} (got {own})"
            raise problem(what, "obstacles")
        if count > MOST_SHAPES:
            raise problem(f"must be at most {MOST_SHAPES} (got {count})", "obstacles")
        return self

    def faces_are_upright(self) -> bool:
        """True if it has upright walls or mats, and nothing else but level ground."""
        solid = [entry for entry in self.obstacles if not isinstance(entry, Ground)]
        return bool(solid) and all(
            isinstance(entry, PlaneSettings) and entry.is_upright() for entry in solid
        )

    def of_own_structure(self) -> int:
        """Number of obstacles that each are a structure of their own to the compiler."""
        all_one_by_one = single_obstacles(self.obstacles)
        planes = any(isinstance(entry, ShapeSettings) for entry in all_one_by_one)
        return sum(isinstance(entry, UserShape) or not planes for entry in all_one_by_one)


class Start(Settings):
    """State at time 0.  Euler angles are ZYX; positive pitch is nose down."""

    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 1.0)
    """Position of the main body, without ``offset``; run-ups without a ``start`` begin here."""
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Displacement from ``position``, such as scatter; references do not follow it."""
    velocity: Annotated[Triple, Unit("m/s")] = (0.0, 0.0, 0.0)
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0
    quaternion: Annotated[Quadruple, Unit("")] | None = None
    """Attitude instead of roll, pitch and yaw: w, x, y, z (Hamilton), body to world.

    It is normalised; its length must be 1 to within 1e-4, the rounding of four decimals.
    """
    angular_velocity: Annotated[Triple, Unit("rad/s")] = (0.0, 0.0, 0.0)
    shell_spin: Annotated[Triple, Unit("rad/s")] = (0.0, 0.0, 0.0)
    """Angular velocity of a sphere in a gimbal, or of a ring about its axis, body axes; like
    ``angular_velocity``, relative to the world.
    """
    compression: Annotated[PerArm, Unit("m")] = 0.0
    """Compression of the arms, along the paths of their ends; one for all, or one for each."""
    second_compression: Annotated[PerArm, Unit("m")] = 0.0
    """The same for the second joints of arms on two joints, along the paths on these alone."""
    touch_distance: Annotated[float, Unit("m", least=0.0)] | None = None
    """Distance from the start to the first touch, along ``velocity``; 0: it begins at touch.

    The vehicle is moved from ``position`` along its velocity without turning: ahead to the first
    obstacle, or back if ``position`` is inside one; then back by this distance.
    """

    @model_validator(mode="after")
    def _one_attitude(self) -> Start:
        if self.quaternion is None:
            return self
        for name in ("roll", "pitch", "yaw"):
            if (angle := getattr(self, name)) != 0.0:
                given = f"{angle:g} rad, which is {math.degrees(angle):.6g} deg"
                raise problem(f"cannot be combined with a {name} (got {given})", "quaternion")
        self.attitude()
        return self

    def place(self) -> Vec:
        """Position of the main body at time 0, world [m], before any move to a touch."""
        return Vec(*self.position) + Vec(*self.offset)

    def attitude(self) -> Quat:
        """Attitude at time 0, body to world."""
        if self.quaternion is None:
            return Quat(*attitude_from_euler(self.roll, self.pitch, self.yaw))
        w, x, y, z = self.quaternion
        length = sqrt(w * w + x * x + y * y + z * z)
        if abs(length - 1.0) > UNIT_LENGTH:
            raise problem(
                f"must be of length 1 to within {UNIT_LENGTH:g} (got length {length:.6g})",
                "quaternion",
            )
        return Quat(w / length, x / length, y / length, z / length)

    def angles(self) -> Triple:
        """Roll, pitch and yaw at time 0 [rad]."""
        if self.quaternion is None:
            return self.roll, self.pitch, self.yaw
        with warnings.catch_warnings():  # nose up or down, one of many triples is as good
            warnings.simplefilter("ignore")
            roll, pitch, yaw = euler_from_attitude(self.quaternion).tolist()
        return roll, pitch, yaw


class ModelSettings(Settings):
    """Choice between the models of the paper and others."""

    contact_point: Literal["ring", "paper"] = "ring"
    """`ring`: exact support point of the tilted cage circle.  `paper`: eq. (13)."""
    arms: Literal["hybrid", "always-free"] = "hybrid"
    """`hybrid`: one rigid body in free flight (assumption 5).  `always-free`: arms always slide."""
    slider: Annotated[Triple, Unit("")] | None = None
    """World axis of a slider that constrains the vehicle, as on the testbed; none: free flight."""
    slider_friction: Annotated[float, Unit("N", least=0.0)] = 0.0
    """Dry friction F of the slider's rail, −F v/√(v² + v_s²) whatever presses on it: the reading of
    a spring scale that pulls the vehicle along slowly.  Viscous drag is ``air.rotor_drag``."""
    slider_slip_speed: Annotated[float, Unit("m/s", above=0.0)] = 0.03
    """v_s, speed along the rail below which that friction is regularised, as for surfaces."""

    @model_validator(mode="after")
    def _rail_is_there(self) -> ModelSettings:
        if self.slider is None and self.slider_friction != 0.0:
            raise problem("needs a slider", "slider_friction")
        return self


class Payload(Settings):
    """True payload, unknown to the pilot."""

    mass: Annotated[float, Unit("kg", least=0.0)] = 0.0
    inertia: Annotated[Triple, Unit("kg m^2")] = (0.0, 0.0, 0.0)
    """Its own moments of inertia about its centre of mass, body axes; zero for a point mass, or
    moments that a body of its mass can have within three times the reach of the vehicle."""
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Its centre of mass in body axes; only the main body's centre of mass is possible."""

    @model_validator(mode="after")
    def _possible(self) -> Payload:
        if any(self.position):
            raise problem(
                "must be [0, 0, 0] m: the equations have the main body's centre of mass in the "
                "plane of arms and rotors, and a payload elsewhere would move it; weigh what is "
                "elsewhere with the body, by vehicle.body.parts or mass and inertia "
                f"(got {list(self.position)} m)",
                "position",
            )
        if min(self.inertia) < 0.0:
            raise problem(
                f"must be at least 0 kg m^2 each (got {list(self.inertia)} kg m^2)", "inertia"
            )
        with naming("inertia"):
            check_moments(self.inertia)
        return self


class ModelError(Settings):
    """Ratios of true to nominal numbers of the whole vehicle; `vehicle` is the nominal one."""

    mass: Annotated[float, Unit("", above=0.0)] = 1.0
    """Factor for the mass; the difference is in the main body, and the arms are nominal."""
    inertia: Annotated[float, Unit("", above=0.0)] = 1.0
    """Factor for the inertia about the main body with the arms at their free length."""


class SimulationSettings(Settings):
    """Duration and steps.  The defaults come from studies/convergence.py."""

    duration: Duration = 0.5
    """Duration; 6 s if the reference is a run-up, for that, the impact and the recovery."""
    free_step: Duration = 1e-3
    impact_step: Duration = 1e-4
    settle_step: Duration | None = None
    """Step while arms settle without contact; by default as fine as their damping needs."""
    arm_tolerance: Annotated[float, Unit("m", above=0.0)] = 1e-5
    """Distance from its free length within which an arm has settled ..."""
    rate_tolerance: Annotated[float, Unit("m/s", above=0.0)] = 1e-3
    """... if it moves more slowly than this."""
    dwell: Duration = 0.02
    """Contacts closer together than this are one impact."""
    record_interval: Annotated[float, Unit("s", least=0.0)] = 0.0
    """The trajectory keeps the first step of each interval of this length, and the last of the
    flight; 0: every step.  Measures and events are those of all steps in any case."""


#: Largest number of instants of a table of thrusts (chosen: each takes a step at least).
MOST_INSTANTS = 100_000


def _thrust_instants(given: Any) -> tuple[float, ...]:
    """Instants that do not decrease, no three of them the same."""
    if not isinstance(given, list | tuple) or not 0 < len(given) <= MOST_INSTANTS:
        raise problem(f"must be a list of 1 to {MOST_INSTANTS} instants")
    found = list[float]()
    for k, entry in enumerate(given):
        with naming(str(k)):
            time = si_number(entry, "s", least=0.0)
            if found and time < found[-1]:
                raise problem(
                    f"must be at least {found[-1]:g} s, as instants increase (got {time:g} s)"
                )
            if found[-2:] == [time, time]:
                raise problem(f"must be later than {time:g} s, at which there is a jump already")
        found.append(time)
    return tuple(found)


def _thrust_rows(given: Any) -> tuple[tuple[float, ...], ...]:
    """Thrusts of all rotors, one row for each instant."""
    if not isinstance(given, list | tuple):
        raise problem("must be a list, for each instant one of the thrusts of all rotors")
    found = []
    for k, row in enumerate(given):
        if not isinstance(row, list | tuple):
            raise problem(
                f"must be a list of the thrusts of all rotors (got {shown_value(row)})", f"{k}"
            )
        thrusts = []
        for j, entry in enumerate(row):
            with naming(f"{k}.{j}"):
                thrusts.append(si_number(entry, "N", least=0.0))
        found.append(tuple(thrusts))
    return tuple(found)


class ThrustSettings(Settings):
    """Thrusts over time without a pilot: linear between the instants, constant outside of them."""

    time: Annotated[tuple[float, ...], BeforeValidator(_thrust_instants)]
    """Instants, in order [s]; an instant that is given twice is a jump."""
    values: Annotated[tuple[tuple[float, ...], ...], BeforeValidator(_thrust_rows)]
    """The thrust of each rotor at each instant [N]."""

    @model_validator(mode="after")
    def _rows_for_instants(self) -> ThrustSettings:
        if len(self.values) != len(self.time):
            what = f"must have a row for each of {len(self.time)} instants (got {len(self.values)})"
            raise problem(what, "values")
        return self


def _thrust(given: Any) -> Any:
    """Thrusts over time as settings; anything else is read with the vehicle."""
    return ThrustSettings.model_validate(given) if isinstance(given, Mapping) else given


class VehicleTables(Settings):
    """What one vehicle of a scenario is, where it starts, and who flies it."""

    # Otherwise pydantic before 2.10 takes model_error for a name of its own.
    model_config = ConfigDict(protected_namespaces=())

    vehicle: Vehicle
    start: Start = Start()
    thrust: Annotated[Any, PlainValidator(_thrust)] = 0.0
    """Thrust of each rotor [N]: one for all, a list, ``"hover"``, or `ThrustSettings` over time.

    ``"hover"`` is the weight of the nominal `vehicle`, without a true payload, shared by all.  The
    table may be a CSV file, ``"FILE.csv"``: its first line names the columns ``time`` [s] and
    ``thrust1``, ``thrust2``, … [N]; others are not read.
    """
    pilot: NamedCode | None = None
    """``FILE.py:NAME`` of a pilot of your own, which flies instead of the paper's; a table with
    ``code`` and ``parameters`` names a function that returns one."""
    reference: ReferenceSettings | None = None
    """Reference for a pilot; none: the rotors give a constant thrust."""
    control: ControlSettings = ControlSettings()
    recovery: RecoverySettings | None = None
    """Detection of collisions and the response to them; without it the pilot ignores them."""
    estimator: EstimatorSettings = EstimatorSettings()
    sensors: SensorSettings = SensorSettings()
    """Sensors.  Without a pilot, they are recorded if this table is given, even if it is empty."""
    air: AirSettings = AirSettings()
    payload: Payload = Payload()
    model_error: ModelError = ModelError()
    model: ModelSettings = ModelSettings()

    @model_validator(mode="after")
    def _gains_by_mass(self) -> Self:
        """The gains of a light vehicle where none are given: its own, and stored with the rest."""
        object.__setattr__(self, "control", self.control.for_mass(self.vehicle.mass))
        return self

    @property
    def code(self) -> list[tuple[str, str]]:
        """Path and name of each object of the user's own."""
        detector = None if self.recovery is None else self.recovery.detection.own
        named = {
            "pilot": None if self.pilot is None else self.pilot.code,
            "estimator.code": self.estimator.code,
            "recovery.detection.own.code": None if detector is None else detector.code,
        }
        return [(path, word) for path, word in named.items() if word is not None]


class SecondVehicle(VehicleTables):
    """A second vehicle in the world of a scenario, which the first one can hit.

    Obstacles, gravity, clock, duration and steps are those of the scenario.
    """

    name: Name = "second"
    seed: Annotated[int, Field(ge=0, strict=True)] | None = None
    """Seed of its noise; by default drawn from that of the scenario."""
    surface: SurfaceSettings | None = None
    """Surface of the contact between the two vehicles; by default that of two cages of the preset
    ``wall`` in series, with its friction."""


class ScenarioTables(VehicleTables):
    """All input of one flight, each table validated by itself."""

    name: Name = "flight"
    world: WorldSettings = WorldSettings()
    clock: Annotated[float, Unit("1/s", above=0.0)] = 1000.0
    """Clock rate of all on-board devices [Hz]."""
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Seed of the noise."""
    simulation: SimulationSettings = SimulationSettings()
    second: SecondVehicle | None = None
    """A second vehicle in this world, with or without a pilot of its own; or the path of a scenario
    file whose vehicle it is.  In a table, ``preset`` is that path, and further keys change it."""

    @property
    def is_upright(self) -> bool:
        """True if all that its vehicle can hit is upright, but for the ground."""
        return self.second is None and self.world.faces_are_upright()

    @property
    def code(self) -> list[tuple[str, str]]:
        """Path and name of each object of the user's own; those of the second vehicle are its."""
        shapes = [
            (f"world.obstacles[{k}].shape", entry.shape)
            for k, entry in enumerate(self.world.obstacles)
            if isinstance(entry, UserShape)
        ]
        return super().code + shapes
