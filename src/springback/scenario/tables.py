"""Tables of a scenario: user input, each table validated by itself."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, model_validator

from springback.contact.parameters import Ground, Mat, SurfaceSettings, Wall
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import ReferenceSettings
from springback.dynamics.air import AirSettings
from springback.kernels.vectors import Vec
from springback.quantities import Angle, Duration, Triple, Unit
from springback.recovery.parameters import RecoverySettings
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.parameters import SensorSettings
from springback.settings import Name, Settings, naming, problem
from springback.user_code import Arguments, CodeName
from springback.vehicle.parameters import Vehicle, check_moments

#: Upper limit, to catch typing errors (chosen): a flight is compiled for each number of obstacles.
MOST_OBSTACLES = 64


class UserShape(Settings):
    """An obstacle of the user's own: a shape in a Python file, and its surface."""

    type: Literal["own"]
    shape: CodeName
    """``FILE.py:NAME`` of a shape, or of its type or a function, called with ``parameters``."""
    parameters: Arguments = Field(default_factory=dict)
    """Arguments of the type or function, in SI."""
    surface: SurfaceSettings


#: Any obstacle of a world.
AnyObstacle = Annotated[Wall | Ground | Mat | UserShape, Field(discriminator="type")]


class WorldSettings(Settings):
    """Obstacles and gravity."""

    gravity: Annotated[float, Unit("m/s^2", least=0.0)] = 9.81
    obstacles: tuple[AnyObstacle, ...] = ()

    @model_validator(mode="after")
    def _countable(self) -> WorldSettings:
        if len(self.obstacles) > MOST_OBSTACLES:
            what = f"must be at most {MOST_OBSTACLES} (got {len(self.obstacles)})"
            raise problem(what, "obstacles")
        return self


class Start(Settings):
    """State at time 0.  Euler angles are ZYX; positive pitch is nose down."""

    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 1.0)
    """Of the main body, less ``offset``; a run-up without a ``start`` of its own begins here."""
    offset: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Displacement of the vehicle from ``position``, which no reference follows, as by scatter."""
    velocity: Annotated[Triple, Unit("m/s")] = (0.0, 0.0, 0.0)
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0
    angular_velocity: Annotated[Triple, Unit("rad/s")] = (0.0, 0.0, 0.0)

    def place(self) -> Vec:
        """Position of the main body at time 0, world [m]."""
        return Vec(*self.position) + Vec(*self.offset)


class ModelSettings(Settings):
    """Choice of models, those of the paper and others."""

    contact_point: Literal["ring", "paper"] = "ring"
    """`ring`: exact support point of the tilted cage circle.  `paper`: eq. (13)."""
    arms: Literal["hybrid", "always-free"] = "hybrid"
    """`hybrid`: one rigid body in free flight (assumption 5).  `always-free`: arms always slide."""
    slider: Annotated[Triple, Unit("")] | None = None
    """World axis of a slider that constrains the vehicle, as on the testbed; none: free flight."""


class Payload(Settings):
    """True payload, unknown to the pilot."""

    mass: Annotated[float, Unit("kg", least=0.0)] = 0.0
    inertia: Annotated[Triple, Unit("kg m^2")] = (0.0, 0.0, 0.0)
    """Its own moments about its centre of mass, body axes; zero for a point mass."""
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Its centre of mass in body axes; only the main body's centre of mass is possible."""

    @model_validator(mode="after")
    def _possible(self) -> Payload:
        if any(self.position):
            raise problem(
                "must be [0, 0, 0] m: the equations have the main body's centre of mass in the "
                f"plane of arms and rotors, and a payload elsewhere would move it (got "
                f"{list(self.position)} m)",
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
    """True over nominal numbers of the whole vehicle; `vehicle` is the nominal one."""

    mass: Annotated[float, Unit("", above=0.0)] = 1.0
    """Factor for the mass; the difference is in the main body, the arms are nominal."""
    inertia: Annotated[float, Unit("", above=0.0)] = 1.0
    """Factor for the inertia about the main body with the arms at their free length."""


class SimulationSettings(Settings):
    """Duration and steps.  The defaults come from studies/convergence.py."""

    duration: Duration = 0.5
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


class ScenarioTables(Settings):
    """All input of one flight, each table validated by itself."""

    # Otherwise pydantic before 2.10 takes model_error for a name of its own.
    model_config = ConfigDict(protected_namespaces=())

    name: Name = "flight"
    vehicle: Vehicle
    world: WorldSettings = WorldSettings()
    start: Start = Start()
    thrust: Any = 0.0
    """Thrust of each rotor [N]: one for all, a list, or ``"hover"`` for the weight shared by all.

    That is the weight of the nominal `vehicle`, without a true payload.
    """
    pilot: CodeName | None = None
    """``FILE.py:NAME`` of a pilot of your own, which flies instead of the paper's."""
    reference: ReferenceSettings | None = None
    """Reference for a pilot; none: the rotors give a constant thrust."""
    control: ControlSettings = ControlSettings()
    recovery: RecoverySettings | None = None
    """Detection of collisions and the response to them; none: the pilot ignores them."""
    estimator: EstimatorSettings = EstimatorSettings()
    sensors: SensorSettings = SensorSettings()
    clock: Annotated[float, Unit("1/s", above=0.0)] = 1000.0
    """Ticks per second of all on-board devices [Hz]."""
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Seed of the noise."""
    air: AirSettings = AirSettings()
    payload: Payload = Payload()
    model_error: ModelError = ModelError()
    model: ModelSettings = ModelSettings()
    simulation: SimulationSettings = SimulationSettings()

    @property
    def code(self) -> list[tuple[str, str]]:
        """Path and name of each object of the user's own."""
        detector = None if self.recovery is None else self.recovery.detection.own
        named = {
            "pilot": self.pilot,
            "estimator.code": self.estimator.code,
            "recovery.detection.own.code": None if detector is None else detector.code,
        }
        shapes = {
            f"world.obstacles[{k}].shape": entry.shape
            for k, entry in enumerate(self.world.obstacles)
            if isinstance(entry, UserShape)
        }
        return [(path, word) for path, word in (named | shapes).items() if word is not None]
