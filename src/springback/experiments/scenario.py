"""A scenario: all that one flight needs, as a user writes it down, checked, made ready to fly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

from pydantic import ConfigDict, Field, ValidationError, ValidationInfo, model_validator

from springback.contact.parameters import Own
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import ReferenceSettings
from springback.dynamics.air import AirSettings
from springback.errors import InputError
from springback.experiments.checks import (
    check_aboard,
    check_start,
    check_tables,
    check_without_pilot,
)
from springback.experiments.numbers import (
    flight_model,
    hover_thrusts,
    start_state,
    thrusts_of,
    true_airframe,
    true_vehicle,
)
from springback.experiments.presets import expanded as expanded
from springback.experiments.presets import merged as merged
from springback.experiments.presets import preset as preset
from springback.experiments.tables import (
    ModelError,
    ModelSettings,
    Payload,
    Start,
    WorldSettings,
)
from springback.experiments.tables import SimulationSettings as SimulationSettings
from springback.problems import dotted
from springback.quantities import quantity
from springback.recovery.parameters import RecoverySettings
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.parameters import SensorSettings
from springback.settings import Name, Settings
from springback.simulation.record import Model
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, State


class Scenario(Settings):
    """Everything one flight needs."""

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
    clock: quantity("1/s", above=0.0) = 1000.0  # type: ignore[valid-type]
    """Ticks per second of everything aboard [Hz]."""
    seed: Annotated[int, Field(ge=0, strict=True)] = 0
    """Of the noise."""
    air: AirSettings = AirSettings()
    payload: Payload = Payload()
    model_error: ModelError = ModelError()
    model: ModelSettings = ModelSettings()
    simulation: SimulationSettings = SimulationSettings()

    @model_validator(mode="after")
    def _can_be_flown(self, info: ValidationInfo) -> Scenario:
        check_tables(self)
        check_start(self, self.flight_model(), self.start_state())
        given = (info.context or {}).get("pilot")
        if self.reference is not None or given:
            check_aboard(self, own=bool(given))
        elif given is False:
            check_without_pilot(self)
        return self

    # -- made ready -------------------------------------------------------------------------------

    def thrusts(self) -> tuple[float, ...]:
        """Thrust of each rotor [N]."""
        gravity, is_piloted = self.world.gravity, self.reference is not None
        return thrusts_of(self.vehicle, gravity, self.thrust, is_piloted)

    def hover_thrusts(self) -> tuple[float, ...]:
        """The weight of `vehicle`, shared by all rotors [N]."""
        return hover_thrusts(self.vehicle, self.world.gravity)

    def true_vehicle(self) -> Vehicle:
        """The vehicle as it is: `vehicle` with the errors of what is believed, and the payload."""
        return true_vehicle(self.vehicle, self.model_error, self.payload)

    def true_airframe(self) -> Airframe:
        """The numbers of the vehicle as it is, for the equations of motion."""
        return true_airframe(self.vehicle, self.model_error, self.payload)

    def flight_model(self, own: Sequence[Own] = ()) -> Model:
        """All numbers of the flight; ``own`` are shapes of the user's, with their surfaces."""
        return flight_model(self, own)

    def start_state(self) -> State:
        """State at time 0, arms at their free length."""
        return start_state(self.start, self.vehicle)

    def check_without_pilot(self) -> None:
        """Refuse what only a flight with a pilot can do; a scenario does not know its pilot."""
        check_without_pilot(self)


def scenario_from(given: Mapping[str, Any], pilot: bool | None = None) -> Scenario:
    """A scenario from plain tables, presets included.

    Args:
        given: The tables.
        pilot: Whether a pilot of the user's own will fly it; None if that is not known yet.

    Raises:
        InputError: One line for each problem: its path, and what is wrong.
    """
    try:
        return Scenario.model_validate(expanded(given), context={"pilot": pilot})
    except InputError as error:
        where = f"{dotted(error.path)}: " if error.path else ""
        raise InputError(*(where + line for line in error.problems)) from None
    except ValidationError as error:
        raise InputError(*Scenario.in_words(error)) from None
