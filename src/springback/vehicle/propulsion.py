"""Propulsion of a vehicle: its rotors, what stops them, and the battery behind them."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

from pydantic import BeforeValidator, model_validator

from springback.quantities import Length, Unit
from springback.settings import Settings, naming, none_for_false, problem
from springback.vehicle.rotor_stop import NoStop, RotorStop, StopSettings
from springback.vehicle.rotors import Rotors


class SurfaceEffect(NamedTuple):
    """Constants of rotors near surfaces; equal for all rotors."""

    radius: float  # R, of a disc [m]
    height: float  # of its middle from the place of the rotor, along its axis [m]
    least_height: float  # of that above a surface; nearer ones count as at this height [m]
    suction: float = 0.0  # by a wall beside a rotor, per thrust, at no distance
    reach: float = 1.0  # distance beyond which a wall draws nothing [m]


class SurfaceEffectSettings(Settings):
    """Rotors gain thrust above surfaces, and walls beside them may attract them.

    The gain is that of Cheeseman and Bennett, ARC R. & M. 3021, 1955.  Ceilings have no effect.
    """

    least_height: Annotated[float, Unit("", least=0.3)] = 0.5
    """Height of a disc above a surface, in radii, below which its gain grows no further.  The
    formula has a pole at a quarter; at the chosen 0.5 the gain is a third."""
    wall_suction: Annotated[float, Unit("", least=0.0, most=1.0)] = 0.0
    """Force towards a wall beside a rotor, per thrust, at zero distance; it falls linearly to zero
    at ``wall_reach``.  About 0.09 by tests of small quadrotors in a pressure chamber (Ground,
    Ceiling and Wall Effect Evaluation of Small Quadcopters in Pressure-controlled Environments), as
    quoted by others: F = ½ C ρ n² D⁴ with C = 0.02 (1 − d/(4 R)), and a thrust of 0.11 ρ n² D⁴.
    This is second-hand, and for one kind of craft: hence 0 by default.
    """
    wall_reach: Annotated[float, Unit("", above=0.0)] = 4.0
    """Distance of a disc's middle from a wall, in radii, beyond which the wall does not attract it;
    from the same tests."""


def effect_or_none(value: Any) -> Any:
    """Validate the table of an effect; True is one of defaults, False removes that of a preset."""
    return {} if value is True else none_for_false(value)


class Propulsion(Settings):
    """Identical rotors, and the battery that they share.

    The battery is needed only for hover power and hover time.
    """

    max_thrust: Annotated[float, Unit("N", above=0.0)]
    """Maximum thrust of one rotor."""
    min_thrust: Annotated[float, Unit("N", least=0.0)] = 0.0
    """Minimum thrust of one rotor; 0: rotors stop but do not turn backwards."""
    time_constant: Annotated[float, Unit("s", least=0.0)] = 0.025
    """τ of the thrust.  RotorS's Hummingbird: 12.5 ms up, 25 ms down, of which this is the slower;
    JSK's aerial_robot assumes 90 ms.  At 40 ms ARQ does not always survive
    (`springback study why`)."""
    figure_of_merit: Annotated[float, Unit("", above=0.0, most=1.0)] | None = None
    """Ratio of ideal induced power to battery power: propeller, motor and controller together."""
    disk_radius: Length | None = None
    """Radius of one propeller: it hits whatever reaches into its disc."""
    disk_height: Annotated[float, Unit("m")] = 0.0
    """Height of that disc above the plane of the arms, in which the cages lie, along body z.  For a
    rotor that the vehicle lists, it is from its position along its axis."""
    stop: Annotated[StopSettings | None, BeforeValidator(none_for_false)] = None
    """Rotors that stop when they are hit; without it, or with false in place of a preset's, they
    follow their commands whatever they hit.
    """
    surface_effect: Annotated[SurfaceEffectSettings | None, BeforeValidator(effect_or_none)] = None
    """Effects of surfaces on rotors, whose thrust grows above them: ``true`` for defaults; without
    it, or with false in place of a preset's, there are none."""
    battery_energy: Annotated[float, Unit("J", above=0.0)] | None = None
    """Energy of the full battery, such as ``"52 Wh"``."""
    usable_share: Annotated[float, Unit("", above=0.0, most=1.0)] = 0.8
    """Usable fraction of the energy; the rest is reserve.  Chosen: usual for lithium polymer."""
    electronics_power: Annotated[float, Unit("W", least=0.0)] = 0.0
    """Power of everything but the rotors."""
    air_density: Annotated[float, Unit("kg/m^3", above=0.0)] = 1.225
    """ρ of the International Standard Atmosphere at sea level (ISO 2533)."""

    @model_validator(mode="after")
    def _consistent(self) -> Propulsion:
        if not self.min_thrust < self.max_thrust:
            raise problem(
                f"must be less than max_thrust, {self.max_thrust:g} N (got {self.min_thrust:g} N)",
                "min_thrust",
            )
        if self.stop is not None:
            with naming("stop"):
                self.stop.check(self.disk_radius is not None)
        if self.surface_effect is not None and self.disk_radius is None:
            raise problem("needs propulsion.disk_radius, the size of the discs", "surface_effect")
        return self

    def check_guards(self, guarded: bool) -> None:
        """Reject a stop by guards alone, where none of the rotors is on an arm, which has some."""
        if self.stop is None or self.stop.guard_force is None or guarded:
            return
        with naming("stop"):
            if self.stop.disc == "ignore" or self.disk_radius is None:
                raise problem(
                    "stops no rotor: all are on the main body, where nothing guards them",
                    "guard_force",
                )

    def rotors(self) -> Rotors:
        """Numbers for the equations of motion."""
        return Rotors(self.min_thrust, self.max_thrust, self.time_constant)

    def effect(self) -> tuple[SurfaceEffect, ...]:
        """What surfaces do to the rotors; empty if nothing."""
        given, radius = self.surface_effect, self.disk_radius
        if given is None or radius is None:
            return ()
        return (
            SurfaceEffect(
                radius, self.disk_height, given.least_height * radius, given.wall_suction,
                given.wall_reach * radius,
            ),
        )  # fmt: skip

    def rotor_stop(self, tick: float) -> NoStop | RotorStop:
        """What stops the rotors, given the period of the clock [s]."""
        if self.stop is None:
            return NoStop(0.0)
        return self.stop.stop(tick, self.disk_radius is not None)
