"""A scenario: all that one flight needs, as a user writes it down, checked, made ready to fly."""

from __future__ import annotations

import contextlib
import difflib
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import ConfigDict, Field, ValidationError, ValidationInfo, model_validator
from pydantic_core import PydanticCustomError

from springback.contact.cage import ArmTip, Ring, meeting
from springback.contact.library import SURFACES
from springback.contact.obstacles import Forces, Impulses, World, obstacle_seen
from springback.contact.parameters import ObstacleSettings, Own, faces, obstacles
from springback.control.parameters import ControlSettings
from springback.control.reference_parameters import ReferenceSettings
from springback.dynamics.air import AirSettings
from springback.dynamics.motion import Free, Slider
from springback.errors import InputError
from springback.experiments.problems import dotted, problem_paths
from springback.frames import attitude_from_euler
from springback.kernels.vectors import Quat, Vec, norm, rotation
from springback.quantities import Angle, Duration, checked, quantity, triple
from springback.recovery.parameters import RecoverySettings
from springback.sensing.estimation import EstimatorSettings
from springback.sensing.parameters import SensorSettings
from springback.settings import Settings, naming, problem
from springback.simulation.record import Model, Timing
from springback.vehicle.library import VEHICLES
from springback.vehicle.parameters import Vehicle
from springback.vehicle.state import Airframe, State, arm_pose

#: Tilt within which a cage that lies flat on a surface is taken to touch at its centre [rad].
RING_ROUNDING = 5e-3
#: Classical Runge–Kutta is stable up to 2.78 on the real axis; steps stay below this.
STABLE = 2.5
#: More steps than this are a slip of the pen.
MOST_STEPS = 1e9
#: Most ticks of a flight with a pilot (chosen): its luck and its diary then take some 4 GB.
MOST_TICKS = 5e6


class WorldSettings(Settings):
    """What is there to hit, and gravity."""

    gravity: quantity("m/s^2", least=0.0) = 9.81  # type: ignore[valid-type]
    obstacles: tuple[ObstacleSettings, ...] = ()


class Start(Settings):
    """State at time 0.  Euler angles are ZYX; positive pitch is nose down."""

    position: triple("m") = (0.0, 0.0, 1.0)  # type: ignore[valid-type]
    velocity: triple("m/s") = (0.0, 0.0, 0.0)  # type: ignore[valid-type]
    roll: Angle = 0.0
    pitch: Angle = 0.0
    yaw: Angle = 0.0
    angular_velocity: triple("rad/s") = (0.0, 0.0, 0.0)  # type: ignore[valid-type]


class ModelSettings(Settings):
    """Which of the models of the paper, and beyond."""

    contact_point: Literal["ring", "paper"] = "ring"
    """`ring`: exact support point of the tilted cage circle.  `paper`: eq. (13)."""
    arms: Literal["hybrid", "always-free"] = "hybrid"
    """`hybrid`: one rigid body in free flight (assumption 5).  `always-free`: arms always slide."""
    slider: triple("") | None = None  # type: ignore[valid-type]
    """World axis of a slider that guides the vehicle, as on the testbed; none: free flight."""


class Payload(Settings):
    """What the vehicle carries in truth, unknown to who flies it."""

    mass: quantity("kg", least=0.0) = 0.0  # type: ignore[valid-type]
    inertia: triple("kg m^2") = (0.0, 0.0, 0.0)  # type: ignore[valid-type]
    """Its own moments about its centre of mass, body axes; a point mass has none."""
    position: triple("m") = (0.0, 0.0, 0.0)  # type: ignore[valid-type]
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
        return self


class ModelError(Settings):
    """True over believed numbers of the whole vehicle; `vehicle` is what is believed of it."""

    mass: quantity("", above=0.0) = 1.0  # type: ignore[valid-type]
    """Of the mass; the difference is in the main body, the arms are as believed."""
    inertia: quantity("", above=0.0) = 1.0  # type: ignore[valid-type]
    """Of the inertia about the main body with the arms at their free length."""


class SimulationSettings(Settings):
    """Duration and steps.  The defaults come from studies/convergence.py."""

    duration: Duration = 0.5
    free_step: Duration = 1e-3
    impact_step: Duration = 1e-4
    settle_step: Duration | None = None
    """While arms settle and nothing touches; by default as fine as their damping needs."""
    arm_tolerance: quantity("m", above=0.0) = 1e-5  # type: ignore[valid-type]
    """An arm has settled within this distance of its free length ..."""
    rate_tolerance: quantity("m/s", above=0.0) = 1e-3  # type: ignore[valid-type]
    """... moving slower than this."""
    dwell: Duration = 0.02
    """Contacts closer together than this are one impact."""


class Scenario(Settings):
    """Everything one flight needs."""

    # Else pydantic before 2.10 takes model_error for a name of its own.
    model_config = ConfigDict(protected_namespaces=())

    name: str = "flight"
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
        self._check_pilot()
        self.thrusts()
        self._check_slider()
        self.true_vehicle()
        self._check_steps()
        self._check_drag()
        self._check_start()
        given = (info.context or {}).get("pilot")
        if self.reference is not None or given:
            self._check_aboard(own=bool(given))
        elif given is False:
            self.check_without_pilot()
        return self

    # -- made ready -------------------------------------------------------------------------------

    def thrusts(self) -> tuple[float, ...]:
        """Thrust of each rotor [N]."""
        count = self.vehicle.arm_count
        if self.thrust == "hover" or self.reference is not None:
            return self.hover_thrusts()
        if isinstance(self.thrust, list | tuple) and len(self.thrust) != count:
            raise problem(f"has {len(self.thrust)} entries for {count} rotors", "thrust")
        given = self.thrust if isinstance(self.thrust, list | tuple) else (self.thrust,) * count
        with naming("thrust"):
            return tuple(checked(entry, "N", least=0.0) for entry in given)

    def hover_thrusts(self) -> tuple[float, ...]:
        """The weight of `vehicle`, shared by all rotors [N]."""
        count = self.vehicle.arm_count
        return (self.vehicle.mass * self.world.gravity / count,) * count

    def world_numbers(self, own: Sequence[Own] = ()) -> World:
        """Obstacles and gravity for the equations; ``own`` are shapes of the user's beside them."""
        built = obstacles(self.world.obstacles, own)
        impulsive = any(entry.surface.restitution >= 0.0 for entry in built)
        return World(built, Impulses(0.0) if impulsive else Forces(0.0), self.world.gravity)

    def true_vehicle(self) -> Vehicle:
        """The vehicle as it is: `vehicle` with the errors of what is believed, and the payload."""
        believed, error, load = self.vehicle, self.model_error, self.payload
        if error == ModelError() and load == Payload():
            return believed
        mass = believed.body.mass + (error.mass - 1.0) * believed.mass
        inertia = np.array(believed.body.inertia) + (error.inertia - 1.0) * believed.inertia()
        if not mass > 0.0:
            raise problem(
                f"must be more than {1.0 - believed.body.mass / believed.mass:.3g}, the share of "
                f"the arms (got {error.mass:g})",
                "model_error.mass",
            )
        if not np.linalg.eigvalsh(inertia)[0] > 0.0:
            raise problem(
                f"must leave the main body an inertia beside the arms' (got {error.inertia:g})",
                "model_error.inertia",
            )
        rows = (inertia + np.diag(load.inertia)).tolist()
        changes = {"mass": mass + load.mass, "inertia": tuple(tuple(row) for row in rows)}
        return believed.model_copy(update={"body": believed.body.model_copy(update=changes)})

    def true_airframe(self) -> Airframe:
        """The numbers of the vehicle as it is, for the equations of motion."""
        return self.true_vehicle().airframe()

    def flight_model(self, own: Sequence[Own] = ()) -> Model:
        """All numbers of the flight; ``own`` are shapes of the user's, with their surfaces."""
        s, m = self.simulation, self.model
        hybrid = m.arms == "hybrid"
        timing = Timing(
            until=s.duration,
            free_step=s.free_step,
            impact_step=s.impact_step,
            settle_step=self.settle_step(),
            arm_tolerance=s.arm_tolerance,
            rate_tolerance=s.rate_tolerance,
            dwell=s.dwell,
            hybrid=1.0 if hybrid else 0.0,
        )
        guide = Free(0.0) if m.slider is None else Slider(_unit(Vec(*m.slider)))
        point = Ring(RING_ROUNDING) if m.contact_point == "ring" else ArmTip(0.0)
        world, thrust = self.world_numbers(own), self.thrusts()
        air = self.air.air()
        return Model(self.true_airframe(), world, point, guide, air, thrust, timing)

    def settle_step(self) -> float:
        """Step while the arms settle [s]."""
        s = self.simulation
        if s.settle_step is not None:
            return float(s.settle_step)
        rate = self.vehicle.fastest_arm_rate()
        if rate == 0.0:
            return float(s.free_step)
        return float(max(s.impact_step, min(4.0 * s.impact_step, 0.5 / rate)))

    def start_state(self) -> State:
        """State at time 0, arms at their free length."""
        s = self.start
        attitude = Quat(*attitude_from_euler(s.roll, s.pitch, s.yaw))
        lengths = self.vehicle.lengths()
        return State(
            Vec(*s.position), attitude, Vec(*s.velocity), Vec(*s.angular_velocity),
            lengths, (0.0,) * len(lengths),
        )  # fmt: skip

    # -- checks across tables ---------------------------------------------------------------------

    def _check_pilot(self) -> None:
        if self.reference is None:
            return
        if self.thrust not in (0.0, "hover"):
            raise problem(
                f"cannot be given beside a reference, whose pilot commands it (got {self.thrust})",
                "thrust",
            )
        if self.model.slider is not None:
            raise problem("cannot be given beside a reference: nobody flies on it", "model.slider")

    def check_without_pilot(self) -> None:
        """Refuse what only a flight with a pilot can do; a scenario does not know its pilot."""
        if self.reference is None and self.air.gusts is not None:
            raise problem(
                "blow only where a pilot flies: give a [reference], or a pilot of your own",
                "air.gusts",
            )

    def _check_aboard(self, own: bool) -> None:
        from springback.experiments.guidance import board_of

        if own and self.model.slider is not None:
            raise problem("cannot be given to a pilot: nobody flies on it", "model.slider")
        most = MOST_TICKS / self.simulation.duration
        if self.clock > most:
            raise problem(
                f"must be at most {most:.6g} 1/s for a flight this long (got {self.clock:g} 1/s)",
                "clock",
            )
        with self._blaming_the_clock():
            board_of(self, self.flight_model(), self.start_state(), relay=own)

    @contextlib.contextmanager
    def _blaming_the_clock(self) -> Iterator[None]:
        """Where the clock was given and a rate was not, the clock is at fault, not the rate."""
        try:
            yield
        except PydanticCustomError as error:
            field = str((error.context or {}).get("field", ""))
            table = field.partition(".")[0]
            innocent = "clock" in self.model_fields_set and table not in self.model_fields_set
            if innocent and "clock" in error.message():
                raise problem(f"does not suit {field}, which {error.message()}", "clock") from None
            raise

    def _check_slider(self) -> None:
        axis = self.model.slider
        if axis is None:
            return
        if not math.hypot(*axis) > 0.0:
            raise problem("must not be zero", "model.slider")
        unit, velocity = _unit(Vec(*axis)), Vec(*self.start.velocity)
        across = velocity - (velocity @ unit) * unit
        if math.sqrt(across @ across) > 1e-9:
            raise problem("must lie along model.slider", "start.velocity")
        if any(self.start.angular_velocity):
            raise problem("must be zero on a slider", "start.angular_velocity")

    def _check_steps(self) -> None:
        shortest = self.simulation.duration / MOST_STEPS
        for name in ("impact_step", "settle_step", "free_step"):
            step = getattr(self.simulation, name)
            if step is not None and step < shortest:
                raise problem(
                    f"must be at least {shortest:.3g} s for a flight this long (got {step:g} s)",
                    f"simulation.{name}",
                )
        rate = self.vehicle.fastest_arm_rate()
        steps = {"impact_step": self.simulation.impact_step, "settle_step": self.settle_step()}
        for name, step in steps.items():
            if step * rate > STABLE:
                raise problem(
                    f"must be at most {STABLE / rate:.3g} s for arms this stiff, damped and light "
                    f"(got {step:g} s)",
                    f"simulation.{name}",
                )

    def _check_drag(self) -> None:
        start, wind = Vec(*self.start.velocity), Vec(*self.air.wind)
        mass = self.true_vehicle().body.mass
        rate = self.air.drag_rate(mass, sum(self.thrusts()), norm(start - wind))
        step = self.simulation.free_step
        if step * rate > STABLE:
            raise problem(
                f"must be at most {STABLE / rate:.3g} s for this much drag (got {step:g} s)",
                "simulation.free_step",
            )

    def _check_start(self) -> None:
        model, state, still = self.flight_model(), self.start_state(), Vec(0.0, 0.0, 0.0)
        r = rotation(state.attitude)
        vertical = Vec(0.0, 0.0, 1.0) @ r
        owners = [k for k, entry in enumerate(self.world.obstacles) for _ in faces(entry)]
        for owner, obstacle in zip(owners, model.world.obstacles, strict=False):
            there = obstacle_seen(obstacle, state.position, r)
            for j, arm in enumerate(model.airframe.arms):
                pose = arm_pose(arm, arm.length, 0.0, still)
                met = meeting(there, model.contact_point, arm.cage_radius, pose, still, vertical)
                if met.gap < 0.0:
                    kind = self.world.obstacles[owner].type
                    raise problem(
                        f"puts the cage of arm {j + 1} {-met.gap:.3g} m inside "
                        f"world.obstacles[{owner}], a {kind} (got {list(self.start.position)} m)",
                        "start.position",
                    )


def _unit(v: Vec) -> Vec:
    return v * (1.0 / math.sqrt(v @ v))


# -- presets and merging --------------------------------------------------------------------------


def preset(kind: str, name: str, known: Mapping[str, Any]) -> Any:
    """A preset by name.

    Raises:
        InputError: With the nearest known name.
    """
    if name in known:
        return known[name]
    near = difflib.get_close_matches(name, known, n=1, cutoff=0.4)
    hint = f"did you mean {near[0]}?" if near else ""
    raise InputError(
        " ".join(f"unknown {kind} preset {name!r}; known: {', '.join(known)}. {hint}".split())
    )


def merged(base: Mapping[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """``base`` with the values of ``over``, table by table."""
    result = dict(base)
    for key, value in over.items():
        inner = result.get(key)
        if isinstance(value, Mapping) and isinstance(inner, Mapping):
            result[key] = merged(inner, value)
        else:
            result[key] = value
    return result


def _vehicle(given: Any) -> Any:
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return given
    base = preset("vehicle", str(table["preset"]), {k: v.vehicle for k, v in VEHICLES.items()})
    own = {key: value for key, value in table.items() if key != "preset"}
    return merged(base.model_dump(), own)


def _surface(given: Any) -> Any:
    table = {"preset": given} if isinstance(given, str) else given
    if not isinstance(table, Mapping) or "preset" not in table:
        return given
    base = preset("surface", str(table["preset"]), SURFACES).model_dump(exclude_none=True)
    own = {key: value for key, value in table.items() if key != "preset"}
    if "dissipation" in own or own.get("law", "hunt-crossley") not in ("hunt-crossley", "impulse"):
        base.pop("restitution", None)
        base.pop("restitution_speed", None)
    if "restitution" in own and "restitution_speed" not in own:
        base.pop("restitution_speed", None)
    return merged(base, own)


def expanded(given: Mapping[str, Any]) -> dict[str, Any]:
    """A raw scenario with every preset replaced by what it stands for."""
    result = dict(given)
    if "vehicle" in result:
        result["vehicle"] = _vehicle(result["vehicle"])
    world = result.get("world")
    if isinstance(world, Mapping) and isinstance(world.get("obstacles"), list | tuple):
        entries = []
        for entry in world["obstacles"]:
            if isinstance(entry, Mapping):
                entry = dict(entry)
                for key in ("surface", "backing"):
                    if key in entry:
                        entry[key] = _surface(entry[key])
            entries.append(entry)
        result["world"] = {**world, "obstacles": entries}
    return result


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
    except ValidationError as error:
        lines = [f"{dotted(path)}: {what}" if path else what for path, what in problem_paths(error)]
        raise InputError(*lines) from None
