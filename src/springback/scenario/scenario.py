"""A scenario: the validated input of one flight, ready to fly."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import ValidationError, ValidationInfo, model_validator

from springback.contact.parameters import SurfaceSettings
from springback.contact.worlds import Own
from springback.errors import InputError
from springback.kernels.memo import Memo
from springback.problems import dotted_path, problem_paths
from springback.random_streams import Purpose, stream
from springback.scenario.build import (
    ReadyFlight,
    UserParts,
    build_flight,
    unread_parts,
    user_parts,
)
from springback.scenario.checks import (
    check_apart,
    check_second,
    check_sensors,
    check_start,
    check_tables,
)
from springback.scenario.flight_kernels import compile_early
from springback.scenario.model import flight_model, start_state, true_airframe, true_vehicle
from springback.scenario.presets import expand_presets as expand_presets
from springback.scenario.presets import merge as merge
from springback.scenario.presets import preset as preset
from springback.scenario.tables import ScenarioTables, SecondVehicle
from springback.scenario.worlds.imported import single_obstacles
from springback.settings import Settings, problem
from springback.simulation.measuring.record import Model
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, State


class Scenario(ScenarioTables):
    """All input of one flight, checked to be flyable."""

    @model_validator(mode="before")
    @classmethod
    def _nothing_moves_beside_two(cls, given: Any) -> Any:
        """Reject moving obstacles beside a second vehicle before any grid of a mesh is made."""
        if isinstance(given, Mapping) and given.get("second") is not None:
            _refuse_moving(given.get("world"))
        return given

    @model_validator(mode="after")
    def _can_be_flown(self, info: ValidationInfo) -> Scenario:
        """Check across tables; files of the user's own are not run for it."""
        given = (info.context or {}).get("pilot")
        own = given or self.pilot is not None
        reads = not own and self.reference is None and "sensors" in self.model_fields_set
        if reads and self.simulation.record_interval > 0.0:
            what = "must be 0: without a pilot, sensors are read from every step"
            raise problem(what, "simulation.record_interval")
        compile_early(self, guided=bool(own) or self.reference is not None)
        if self.reference is None and given is None and not own:  # a pilot may be given later
            check_tables(self, self.parts)
            check_sensors(self)
            if self.start.touch_distance is None or not self._touches_own():
                check_start(self, self.flight_model(), self.start_state())
        else:
            advises = (info.context or {}).get("advises", True)
            self.build(unread_parts(self, pilot=bool(own)), advises=advises)
        if self.second is not None:
            other = self.beside()
            check_second(self, other)
            there = other.start_state()
            check_apart(self, self.flight_model(), self.start_state(), other.vehicle, there)
        return self

    def _touches_own(self) -> bool:
        """True if the obstacle that its start touches may be the user's own, known when built."""
        kinds = {entry.type for entry in single_obstacles(self.world.obstacles)}
        return "own" in kinds or kinds <= {"ground"}

    # -- built parts ------------------------------------------------------------------------------

    @functools.cached_property
    def parts(self) -> Memo:
        """Memo of built parts, so that nothing is built twice."""
        return Memo()

    def build(self, parts: UserParts | None = None, *, advises: bool = True) -> ReadyFlight:
        """The checked flight; see `springback.scenario.build.build_flight`.

        Args:
            parts: Your own parts; by default those that the scenario names, whose files are run.
            advises: Suggest a feasible distance if a run-up cannot be flown; slow.
        """
        own = self.parts(UserParts, *(user_parts(self) if parts is None else parts))
        return self.parts(build_flight, self, own, self.parts, None, advises)

    def true_vehicle(self) -> Vehicle:
        """The true vehicle: `vehicle` with model errors and payload."""
        return true_vehicle(self.vehicle, self.model_error, self.payload)

    def true_airframe(self) -> Airframe:
        """Airframe of the true vehicle, for the equations of motion."""
        return true_airframe(self.vehicle, self.model_error, self.payload)

    def flight_model(self, own: Sequence[Own] = ()) -> Model:
        """Model of the flight; ``own`` are the user's own shapes, with their surfaces."""
        return self.parts(flight_model, self, own, self.parts)

    def beside(self) -> Scenario:
        """Scenario of the second vehicle alone, in the world of this one.

        Raises:
            The first problem that it has in this world, with its path in this scenario.
        """
        return self.parts(_scenario_beside, self)

    def with_second(self, other: Scenario, surface: SurfaceSettings | None = None) -> Scenario:
        """This scenario with the vehicle of another one as its second.

        Args:
            other: Scenario of that vehicle, with the same world, clock and steps.
            surface: Surface of the contact between the two.

        Raises:
            InputError: If they cannot fly together; one line for each problem.
        """
        for name in SHARED:
            one, theirs = getattr(self, name), getattr(other, name)
            if one != theirs:
                keys = type(one).model_fields if isinstance(one, Settings) else ()
                key = next((f".{k}" for k in keys if getattr(one, k) != getattr(theirs, k)), "")
                raise InputError(f"{name}{key}: must be the same for both vehicles")
        names = other.model_fields_set & SecondVehicle.model_fields.keys()
        own = {name: getattr(other, name) for name in names | {"name", "seed"}}
        return self.model_copy(update={"second": SecondVehicle(**own, surface=surface)})

    def start_state(self) -> State:
        """State at time 0, arms at their free length."""
        return start_state(self.start, self.vehicle, self.flight_model(), self.parts)


def _refuse_moving(world: Any) -> None:
    """Reject raw obstacles that move, all in one sentence, each with its name."""
    entries = world.get("obstacles") if isinstance(world, Mapping) else None
    moving = [
        (f"world.obstacles[{k}]", f", {name}" if isinstance(name := one.get("name"), str) else "")
        for k, one in enumerate(entries if isinstance(entries, list | tuple) else ())
        if isinstance(one, Mapping) and one.get("motion") is not None
    ]
    if not moving:
        return
    (first, name), *others = moving
    also = " and ".join(place + called for place, called in others)
    raise problem(
        f"cannot be combined with a second vehicle: {name.removeprefix(', ') or 'it'} moves"
        + (f", and so {'does' if len(others) == 1 else 'do'} {also}" if others else ""),
        first,
    )


def _scenario_beside(first: Scenario) -> Scenario:
    """Scenario of the second vehicle of another one, which has one."""
    second = first.second
    assert second is not None
    own = {name: getattr(second, name) for name in second.model_fields_set - {"seed", "surface"}}
    shared = {name: getattr(first, name) for name in SHARED}
    seed = int(stream(first.seed, Purpose.SECOND).integers(2**63))
    own |= {"seed": seed if second.seed is None else second.seed, "name": second.name}
    if second.recovery is not None:
        own["recovery"] = second.recovery.among(upright=False)  # but for the first vehicle
    try:
        return Scenario.model_validate({**own, **shared})
    except ValidationError as error:
        [(path, what), *_] = problem_paths(error)
        raise problem(
            what, dotted_path(path if path[:1] in _PATHS else ("second", *path))
        ) from None


#: Tables that two vehicles have in common.
SHARED = ("world", "clock", "simulation")
_PATHS = tuple((name,) for name in SHARED)


def scenario_from(
    given: Mapping[str, Any], pilot: bool | None = None, *, advises: bool = True
) -> Scenario:
    """A scenario from plain tables, presets included.

    Args:
        given: The tables.
        pilot: True if a pilot of the user's own will fly it; None if unknown.
        advises: Suggest a feasible distance if a run-up cannot be flown; slow.

    Raises:
        InputError: One line for each problem, with its path.
    """
    try:
        return Scenario.model_validate(
            expand_presets(given), context={"pilot": pilot, "advises": advises}
        )
    except InputError as error:
        where = f"{dotted_path(error.path)}: " if error.path else ""
        raise InputError(*(where + line for line in error.problems)) from None
    except ValidationError as error:
        raise InputError(*Scenario.in_words(error)) from None
