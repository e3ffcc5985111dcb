"""Motions of obstacles: validated user input."""

from __future__ import annotations

import itertools
import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from springback.errors import shown_value
from springback.quantities import Angle, Mass, Triple, Unit
from springback.settings import Settings, problem

Place = Annotated[Triple, Unit("m")]
Direction = Annotated[Triple, Unit("")]
Velocity = Annotated[Triple, Unit("m/s")]
Spin = Annotated[Triple, Unit("rad/s")]
Turning = Annotated[float, Unit("rad/s")]
Inertia = Annotated[Triple, Unit("kg m^2", above=0.0)]
AngularStiffness = Annotated[float, Unit("N m/rad", least=0.0)]
AngularDamping = Annotated[float, Unit("N m s/rad", least=0.0)]
Instants = Annotated[tuple[Annotated[float, Unit("s")], ...], Field(min_length=2)]
Places = tuple[Annotated[Triple, Unit("m")], ...]
Angles = tuple[Angle, ...]

#: Stiffness of the stops of a hinge [N m/rad] (chosen: a door that is stopped within a degree).
STOP = 500.0
NOWHERE = (0.0, 0.0, 0.0)


class _GivenMotion(Settings):
    """What prescribed motions have: the obstacle moves as prescribed, whatever hits it."""

    axis: Direction = (0.0, 0.0, 1.0)
    """Axis about which it turns, of any length; by default upwards."""
    about: Place | None = None
    """Point about which the obstacle turns; by default its centre."""

    @model_validator(mode="after")
    def _has_direction(self) -> _GivenMotion:
        if not math.hypot(*self.axis) > 0.0:
            raise problem(f"must not be zero (got {shown_value(list(self.axis))})", "axis")
        return self


class ConstantMotion(_GivenMotion):
    """Constant velocity and turning."""

    type: Literal["constant"]
    velocity: Velocity = NOWHERE
    """Velocity of the obstacle, world axes."""
    turning: Turning = 0.0
    """Angular speed about `axis`, right-handed."""


class SineMotion(_GivenMotion):
    """A sine: displacement x = amplitude · sin(2π f t + φ) from the given place, and θ likewise."""

    type: Literal["sine"]
    amplitude: Place = NOWHERE
    """Amplitude of the displacement, world axes."""
    swing: Angle = 0.0
    """Amplitude of the angle about `axis`."""
    frequency: Annotated[float, Unit("Hz", above=0.0)]
    """f, of displacement and angle."""
    phase: Angle = 0.0
    """φ, of displacement and angle."""


class TableMotion(_GivenMotion):
    """A table of places and angles, joined by cubic splines; at rest before and after it."""

    type: Literal["table"]
    time: Instants
    """Instants, in order."""
    position: Places | None = None
    """Displacement at each instant from the given place [m]."""
    angle: Angles | None = None
    """Angle at each instant, about `axis`."""

    @model_validator(mode="after")
    def _fits(self) -> TableMotion:
        for k, (before, later) in enumerate(itertools.pairwise(self.time), start=1):
            if later <= before:
                raise problem(
                    f"must be more than {before:g} s, as instants increase (got {later:g} s)",
                    f"time[{k}]",
                )
        for name in ("position", "angle"):
            given = getattr(self, name)
            if given is not None and len(given) != len(self.time):
                count = f"{len(self.time)} instants (got {len(given)})"
                raise problem(f"must have an entry for each of {count}", name)
        if self.position is None and self.angle is None:
            raise problem("needs position, angle or both")
        return self


class _MassiveMotion(Settings):
    """What obstacles with mass have; unless given, the inertia is that of uniform density."""

    mass: Mass
    """Mass of the whole obstacle."""
    inertia: Inertia | None = None
    """Moments of inertia about the centre of mass, along the world's axes at the start, with zero
    products; by default those of uniform density."""


class FreeMotion(_MassiveMotion):
    """A free body: thrown, falling, or floating where there is no gravity."""

    type: Literal["free"]
    velocity: Velocity = NOWHERE
    """Velocity of its centre of mass at the start, world axes."""
    angular_velocity: Spin = NOWHERE
    """Angular velocity at the start, world axes."""


class PendulumMotion(_MassiveMotion):
    """A body on a rod without mass that turns freely about a point: a hanging ball."""

    type: Literal["pendulum"]
    pivot: Place
    """Point about which it turns."""
    angular_velocity: Spin = NOWHERE
    """Angular velocity about the pivot at the start, world axes."""
    damping: AngularDamping = 0.0
    """Damping c of the pivot, against its swing.  All its spin, including that about its own axis,
    decays at the same rate: c over its largest moment of inertia about the pivot."""


class HingeMotion(_MassiveMotion):
    """A body on a hinge, with a closer: a door.

    The closer is a torsion spring and damper, −k (θ − θ₀) − c θ̇.  Stops at both ends of its
    travel are stiff springs.  θ is 0 where the obstacle is placed, and within ±π.
    """

    type: Literal["hinge"]
    pivot: Place
    """A point on the hinge's axis."""
    axis: Direction = (0.0, 0.0, 1.0)
    """Axis of the hinge, of any length; by default upwards."""
    turning: Turning = 0.0
    """Angular speed at the start, about `axis`."""
    closer: AngularStiffness = 0.0
    """k of the closer."""
    damping: AngularDamping = 0.0
    """c of the closer."""
    rest: Angle = 0.0
    """Angle at which the closer is relaxed."""
    lowest: Annotated[float, Unit("rad", most=0.0)] = -math.pi
    """Angle of the stop against turning backwards; 0 is that at the start."""
    highest: Annotated[float, Unit("rad", least=0.0)] = math.pi
    """Angle of the stop against turning forwards; 0 is that at the start."""
    stop_stiffness: AngularStiffness = STOP
    """Stiffness of both stops."""

    @model_validator(mode="after")
    def _is_a_hinge(self) -> HingeMotion:
        if not math.hypot(*self.axis) > 0.0:
            raise problem(f"must not be zero (got {shown_value(list(self.axis))})", "axis")
        return self


_Given = ConstantMotion | SineMotion | TableMotion
_Massive = FreeMotion | PendulumMotion | HingeMotion
#: Prescribed motions, and all.
GivenMotions = Annotated[_Given, Field(discriminator="type")]
MotionSettings = Annotated[_Given | _Massive, Field(discriminator="type")]
