"""The tables of a scenario as a user writes them down, each checked by itself."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, model_validator

from springback.contact.parameters import ObstacleSettings
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import ReferenceSettings
from springback.dynamics.air import AirSettings
from springback.quantities import Angle, Duration, Triple, Unit
from springback.recovery.parameters import RecoverySettings
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.parameters import SensorSettings
from springback.settings import Name, Settings, naming, problem
from springback.vehicle.parameters import Vehicle, check_moments

#: More obstacles are a slip of the pen (chosen): a flight is compiled for each number of them.
MOST_OBSTACLES = 64


class WorldSettings(Settings):
    """What is there to hit, and gravity."""

    gravity: Annotated[float, Unit("m/s^2", least=0.0)] = 9.81
    obstacles: tuple[ObstacleSettings, ...] = ()

    @model_validator(mode="after")
    def _countable(self) -> WorldSettings:
        if len(self.obstacles) > MOST_OBSTACLES:
            what = f"must be at most {MOST_OBSTACLES} (got {len(self.obstacles)})"
            raise problem(what, "obstacles")
        return self


class Start(Settings):
    """State at time 0.  Euler angles are ZYX; positive pitch is nose down."""

    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 1.0)
    velocity: Annotated[Triple, Unit("m/s")] = (0.0, 0.0, 0.0)
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0
    angular_velocity: Annotated[Triple, Unit("rad/s")] = (0.0, 0.0, 0.0)


class ModelSettings(Settings):
    """Which of the models of the paper, and beyond."""

    contact_point: Literal["ring", "paper"] = "ring"
    """`ring`: exact support point of the tilted cage circle.  `paper`: eq. (13)."""
    arms: Literal["hybrid", "always-free"] = "hybrid"
    """`hybrid`: one rigid body in free flight (assumption 5).  `always-free`: arms always slide."""
    slider: Annotated[Triple, Unit("")] | None = None
    """World axis of a slider that guides the vehicle, as on the testbed; none: free flight."""


class Payload(Settings):
    """What the vehicle carries in truth, unknown to who flies it."""

    mass: Annotated[float, Unit("kg", least=0.0)] = 0.0
    inertia: Annotated[Triple, Unit("kg m^2")] = (0.0, 0.0, 0.0)
    """Its own moments about its centre of mass, body axes; a point mass has none."""
    position: Annotated[Triple, Unit("m")] = (0.0, 0.0, 0.0)
    """Of its centre of mass in body axes; only the main body's centre of mass is possible."""

    @model_validator(mode="after")
    def _possible(self) -> Payload:
        if any(self.position):
            raise problem(
                "must be [0, 0, 0] m: the equations have the main body's centre of mass in the "
                f"plane of arms and rotors, where a payload aside would move it out (got "
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
    """True over believed numbers of the whole vehicle; `vehicle` is what is believed of it."""

    mass: Annotated[float, Unit("", above=0.0)] = 1.0
    """Of the mass; the difference is in the main body, the arms are as believed."""
    inertia: Annotated[float, Unit("", above=0.0)] = 1.0
    """Of the inertia about the main body with the arms at their free length."""


class SimulationSettings(Settings):
    """Duration and steps.  The defaults come from studies/convergence.py."""

    duration: Duration = 0.5
    free_step: Duration = 1e-3
    impact_step: Duration = 1e-4
    settle_step: Duration | None = None
    """While arms settle and nothing touches; by default as fine as their damping needs."""
    arm_tolerance: Annotated[float, Unit("m", above=0.0)] = 1e-5
    """An arm has settled within this distance of its free length ..."""
    rate_tolerance: Annotated[float, Unit("m/s", above=0.0)] = 1e-3
    """... moving slower than this."""
    dwell: Duration = 0.02
    """Contacts closer together than this are one impact."""


class ScenarioTables(Settings):
    """Everything one flight needs, each table checked by itself."""

    # Else pydantic before 2.10 takes model_error for a name of its own.
    model_config = ConfigDict(protected_namespaces=())

    name: Name = "flight"
    vehicle: Vehicle
    world: WorldSettings = WorldSettings()
    start: Start = Start()
    thrust: Any = 0.0
    """Of each rotor [N]: one for all, a list, or ``"hover"`` for the weight shared by all.

    That is the weight of `vehicle`, whatever it carries in truth.
    """
    reference: ReferenceSettings | None = None
    """Where a pilot should fly; none: the rotors give a constant thrust."""
    control: ControlSettings = ControlSettings()
    recovery: RecoverySettings | None = None
    """How collisions are noticed and answered; none: the pilot flies on as if there were none."""
    estimator: EstimatorSettings = EstimatorSettings()
    sensors: SensorSettings = SensorSettings()
    clock: Annotated[float, Unit("1/s", above=0.0)] = 1000.0
    """Ticks per second of everything aboard [Hz]."""
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Of the noise."""
    air: AirSettings = AirSettings()
    payload: Payload = Payload()
    model_error: ModelError = ModelError()
    model: ModelSettings = ModelSettings()
    simulation: SimulationSettings = SimulationSettings()
