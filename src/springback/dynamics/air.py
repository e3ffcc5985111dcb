"""The air: still and without drag, as the paper assumes, or with wind and drag.

`Still` is the paper's assumption 1 and costs nothing when compiled.  `Air` acts on the main body's
centre of mass.  The energy balance books −F·v as taken from the vehicle; wind can make it negative.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, NamedTuple

from pydantic import model_validator

from springback.dynamics.gusts import Dryden, NoGusts, dryden, low_altitude
from springback.kernels.compiler import generic, kernel
from springback.kernels.tracing import traceable  # for batch set-up
from springback.kernels.trees import fold
from springback.kernels.vectors import Mat3, Vec, norm
from springback.quantities import Speed, Triple, Unit
from springback.settings import Settings, problem


class Still(NamedTuple):
    """No aerodynamics (the paper's assumption 1)."""

    unused: float


class Air(NamedTuple):
    """Wind and drag.

    D = rotor_drag + T · thrust_drag is the diagonal of the rotors' linear drag.  Faessler, Franchi
    and Scaramuzza (RA-L 2018) use −R D Rᵀ v, there per mass and at a thrust near hover; the term
    in T is for rotors whose drag grows with their thrust.  The body's drag is ½ ρ C_d A |u|².
    """

    wind: Vec  # w, world [m/s]; that of the present tick
    rotor_drag: Vec  # along body x, y, z [N s/m]
    body_drag: float  # ½ ρ C_d A [kg/m]
    thrust_drag: Vec  # along body x, y, z, per collective thrust [s/m]


class Aerodynamics(NamedTuple):
    """Effect of the air at one instant."""

    force: Vec  # at the main body's centre of mass, body axes [N]
    loss: float  # power taken by the air; negative where it adds energy [W]


@kernel
def drag_force(air: Air, u: Vec, thrust: float) -> Vec:
    """Drag −(D + ½ ρ C_d A |u|) u, body axes [N].

    Args:
        air: Coefficients; its wind is not used here.
        u: Rᵀ(v − w), velocity through the air, body axes [m/s].
        thrust: T, collective [N].
    """
    d, body = air.rotor_drag + thrust * air.thrust_drag, air.body_drag * norm(u)
    return Vec(-(d.x + body) * u.x, -(d.y + body) * u.y, -(d.z + body) * u.z)


@generic
def aerodynamics(air: Any, velocity: Vec, r: Mat3, thrust: float) -> Aerodynamics:
    """Force of the air on the vehicle, and the power it takes.

    Args:
        air: `Still` or `Air`.
        velocity: Rᵀ v, of the main body, body axes [m/s].
        r: Body axes to world axes.
        thrust: Collective [N].
    """
    raise TypeError(f"{type(air).__name__} is not a model of the air; register aerodynamics for it")


@aerodynamics.register(Still)
@kernel
def _nothing(air: Still, velocity: Vec, r: Mat3, thrust: float) -> Aerodynamics:
    return Aerodynamics(Vec(0.0, 0.0, 0.0), 0.0)


@aerodynamics.register(Air)
@kernel
def _drag(air: Air, velocity: Vec, r: Mat3, thrust: float) -> Aerodynamics:
    force = drag_force(air, velocity - air.wind @ r, thrust)
    return Aerodynamics(force, -(force @ velocity))


@generic
def in_wind(air: Any, wind: Vec) -> Any:
    """The same air with another wind, world axes [m/s]; `Still` is returned unchanged."""
    raise TypeError(f"{type(air).__name__} is not a model of the air; register in_wind for it")


@in_wind.register(Still)
@kernel
def _still_in_wind(air: Still, wind: Vec) -> Still:
    return air


@in_wind.register(Air)
@kernel
def _air_in_wind(air: Air, wind: Vec) -> Air:
    return Air(wind, air.rotor_drag, air.body_drag, air.thrust_drag)


class GustSettings(Settings):
    """Dryden turbulence of MIL-F-8785C at low altitude."""

    wind_at_6_m: Annotated[float, Unit("m/s", least=0.0)]
    """W₂₀, mean wind 20 ft above the ground: 15, 30 and 45 knots are light, moderate and severe."""
    altitude: Annotated[float, Unit("m", least=3.048, most=304.8)] = 6.096
    """h above the ground, 10 to 1000 ft (the range of the formulas); the default is 20 ft."""
    airspeed: Speed | None = None
    """Speed V relative to the frozen field; by default the mean wind's, as in hover."""


class AirSettings(Settings):
    """Wind and drag; none by default."""

    wind: Annotated[Triple, Unit("m/s")] = (0.0, 0.0, 0.0)
    """Mean wind, world axes: the direction in which the air moves."""
    gusts: GustSettings | None = None
    rotor_drag: Annotated[Triple, Unit("N s/m")] = (0.0, 0.0, 0.0)
    """Linear drag along body x, y, z."""
    thrust_drag: Annotated[Triple, Unit("s/m")] = (0.0, 0.0, 0.0)
    """Linear drag along body x, y, z for each newton of collective thrust."""
    body_drag: Annotated[float, Unit("kg/m", least=0.0)] = 0.0
    """½ ρ C_d A of the quadratic drag."""

    @model_validator(mode="after")
    def _consistent(self) -> AirSettings:
        for name, unit in (("rotor_drag", "N s/m"), ("thrust_drag", "s/m")):
            given = getattr(self, name)
            if min(given) < 0.0:
                raise problem(f"must be at least 0 {unit} each (got {list(given)} {unit})", name)
        for name, blows in (("wind", any(self.wind)), ("gusts", self.gusts is not None)):
            if blows and not self.has_drag:
                raise problem("has no effect without rotor_drag, thrust_drag or body_drag", name)
        if self.gusts is not None and self.gusts.airspeed is None and not any(self.wind):
            raise problem("is missing; without mean wind gusts need it", "gusts.airspeed")
        return self

    @property
    def has_drag(self) -> bool:
        """True if the air acts on the vehicle at all."""
        return any((*self.rotor_drag, *self.thrust_drag, self.body_drag))

    def air(self) -> Still | Air:
        """Numbers for the equations of motion, in the mean wind."""
        if not self.has_drag:
            return Still(0.0)
        wind, linear, by_thrust = self.wind, self.rotor_drag, self.thrust_drag
        return Air(Vec(*wind), Vec(*linear), self.body_drag, Vec(*by_thrust))

    def turbulence(self, tick: float) -> NoGusts | Dryden:
        """Numbers of the gusts, for a tick of given duration [s]."""
        if self.gusts is None:
            return NoGusts(0.0)
        given = self.gusts
        return _turbulence(self.wind, given.wind_at_6_m, given.altitude, given.airspeed, tick)

    def drag_rate(self, mass: float, thrust: float, speed: float) -> float:
        """Rate at which drag slows a mass [kg], at a given thrust [N] and speed [m/s] [1/s]."""
        linear = max(d + thrust * k for d, k in zip(self.rotor_drag, self.thrust_drag, strict=True))
        return (linear + 2.0 * self.body_drag * speed) / mass


@traceable
def _turbulence(
    wind: Triple, wind_at_6_m: float, altitude: float, airspeed: float | None, tick: float
) -> Dryden:
    intensity, scale = low_altitude(wind_at_6_m, altitude)
    level = math.hypot(wind[0], wind[1])
    along = Vec(1.0, 0.0, 0.0)
    if level > 0.0:
        along = Vec(wind[0] / level, wind[1] / level, 0.0)
    return dryden(intensity, scale, airspeed or norm(Vec(*wind)), tick, along)


@kernel
def _about_z(moment: Vec, reaction: float) -> Vec:
    return Vec(moment.x, moment.y, moment.z + reaction)


@kernel
def with_reaction(moment: Vec, reaction: tuple[float, ...]) -> Vec:
    """Moment of the rotors [N m] with that of their changes of speed, about body z, if known."""
    return fold(_about_z, moment, reaction, ())
