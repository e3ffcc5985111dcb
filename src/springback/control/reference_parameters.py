"""References: validated user input, converted to the numbers of the kernels.

The table is ``[reference]`` with ``type`` one of ``hold``, ``steps``, ``circle``, ``waypoints`` and
``run-up``.  Each class has ``reference(limits, reach)``: some references depend on the limits of
the vehicle and on the reach of its cages, the others ignore them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from springback.control.demands import Limits
from springback.control.polynomials import set_points, through
from springback.control.references import Circle, Polynomials
from springback.control.runup import RunUp, RunUpContact, RunUpTiming, run_up
from springback.errors import InputError
from springback.kernels.vectors import Vec
from springback.quantities import Angle, Duration, Length, Position, Speed, Triple, Unit
from springback.settings import Settings, problem

#: Distance of the foremost cage ahead of the main body [m] at a pitch [rad] and the yaw of the
#: reference, as `springback.control.runup.reach` of a vehicle.
Reach = Callable[[float], float]

Moment = Annotated[float, Unit("s", least=0.0)]
Place = Annotated[Triple, Unit("m")]

#: The paper's start and return point, section Impact Resilience [m].
HOME = (0.0, 0.0, 1.0)


#: Upper limit, to catch typing errors (chosen).
MOST_POSITIONS = 100


class HoldSettings(Settings):
    """Stay at one position."""

    type: Literal["hold"]
    position: Place = HOME
    """Position; by default ``start.position``, if that is given."""
    yaw: Angle = 0.0
    """Yaw; by default ``start.yaw``, if that is given."""

    def reference(self, limits: Limits, reach: Reach) -> Polynomials:
        """Reference for the kernels."""
        return set_points([Vec(*self.position)], yaw=self.yaw)


class StepsSettings(Settings):
    """Set-points in sequence, with jumps between them.

    The defaults are the paper's step response test (section Free Flight).
    """

    type: Literal["steps"]
    positions: tuple[Place, ...] = (HOME, (0.0, 0.0, 2.0), (1.0, 0.0, 2.0), (1.0, 1.0, 2.0))
    dwell: Duration = 5.0
    """Time at each set-point."""
    yaw: Angle = 0.0

    @model_validator(mode="after")
    def _some(self) -> StepsSettings:
        if not 1 <= len(self.positions) <= MOST_POSITIONS:
            count = len(self.positions)
            what = f"must name at least one position and at most {MOST_POSITIONS} (got {count})"
            raise problem(what, "positions")
        return self

    def reference(self, limits: Limits, reach: Reach) -> Polynomials:
        """Reference for the kernels."""
        return set_points([Vec(*p) for p in self.positions], self.dwell, self.yaw)


class CircleSettings(Settings):
    """A level circle.

    The defaults are the paper's slow circle (Free Flight: radius 1 m, period 2π s, from [1, 0, 1]);
    its centre and sense are not printed and taken as [0, 0, 1] and counter-clockwise.  Its desired
    velocity jumps at the start, as the paper says of its own; ``ramp`` avoids that.
    """

    type: Literal["circle"]
    centre: Place = HOME
    radius: Length = 1.0
    period: Duration = 2.0 * math.pi
    phase: Angle = 0.0
    """Angle at which it starts, from world X towards Y."""
    clockwise: bool = False
    """Direction as seen from above."""
    begins: Moment = 0.0
    """Start time; until then the robot waits at the first point."""
    ramp: Moment = 0.0
    """Time to full speed."""
    yaw: Angle = 0.0

    def reference(self, limits: Limits, reach: Reach) -> Circle:
        """Reference for the kernels."""
        rate = (-2.0 if self.clockwise else 2.0) * math.pi / self.period
        return Circle(
            Vec(*self.centre), self.radius, rate, self.phase, self.begins, self.ramp, self.yaw
        )


class WaypointsSettings(Settings):
    """Minimum snap through way-points, from rest to rest.

    With neither ``times`` nor ``duration`` it is as short as the vehicle's limits allow.
    """

    type: Literal["waypoints"]
    positions: tuple[Place, ...]
    times: tuple[Moment, ...] | None = None
    """Time at each position, the first being 0 s; by default distributed to minimise snap."""
    duration: Duration | None = None
    """Total duration, if no times are given."""
    begins: Moment = 0.0
    yaw: Angle = 0.0

    @model_validator(mode="after")
    def _consistent(self) -> WaypointsSettings:
        places: tuple[Any, ...] = self.positions
        times: tuple[Any, ...] | None = self.times
        if len(places) < 2 or any(a == b for a, b in pairwise(places)):
            raise problem("must be at least two, and neighbours distinct", "positions")
        if len(places) > MOST_POSITIONS:
            what = f"must be at most {MOST_POSITIONS} (got {len(places)})"
            raise problem(what, "positions")
        if times is None:
            return self
        if self.duration is not None:
            raise problem("cannot be combined with times; give only one", "duration")
        if len(times) != len(places):
            raise problem(f"has {len(times)} entries for {len(places)} positions", "times")
        if times[0] != 0.0 or not all(a < b for a, b in pairwise(times)):
            raise problem(f"must increase from 0 s (got {list(times)} s)", "times")
        return self

    def reference(self, limits: Limits, reach: Reach) -> Polynomials:
        """Reference for the kernels.

        Raises:
            InputError: If a limit is exceeded, and by how much.
        """
        return through(self.positions, limits, self.times, self.duration, self.yaw, self.begins)


class RunUpSettings(Settings):
    """Flight from rest to a wall across the X axis, arriving with a given speed and pitch.

    Wall and start are the paper's (section Impact Resilience).
    """

    type: Literal["run-up"]
    speed: Speed
    """Speed into the wall at contact."""
    pitch: Annotated[float, Unit("rad", least=-1.4, most=1.4)] = 0.0
    """Pitch at contact; positive is nose down, towards the wall.  With a yaw it is the tilt towards
    the wall, about the wall's horizontal."""
    yaw: Angle = 0.0
    """Heading from the wall's inward normal, held from the start to the end of the recovery."""
    wall_distance: Position = 2.75
    """Distance of the wall's face from the origin along X."""
    start: Place = HOME
    steady: Moment = 0.1
    """Time before contact in which the pitch is constant (chosen)."""
    beyond: Moment = 0.3
    """Time after contact for which the acceleration continues, the wall being unknown (chosen)."""
    begins: Moment = 0.0

    def run_up(self, limits: Limits, reach: Reach, advises: bool = True) -> RunUp:
        """The run-up and its demands on the vehicle; see `springback.control.runup.run_up`.

        Raises:
            InputError: If a limit is exceeded, which one, and by how much.
        """
        x, y, z = Vec(*self.start)
        there = self.wall_distance - reach(self.pitch)
        if not there > x:
            raise InputError(
                f"wall_distance of a run-up must be more than {x + reach(self.pitch):.4g} m, where "
                f"the cages are at the start (got {self.wall_distance:g} m)"
            )
        contact = RunUpContact(Vec(there, y, z), self.speed, self.pitch, self.yaw)
        timing = RunUpTiming(self.steady, self.beyond, self.begins)
        return run_up(Vec(x, y, z), contact, limits, timing, advises)

    def reference(self, limits: Limits, reach: Reach) -> Polynomials:
        """Reference for the kernels."""
        return self.run_up(limits, reach).reference


ReferenceSettings = Annotated[
    HoldSettings | StepsSettings | CircleSettings | WaypointsSettings | RunUpSettings,
    Field(discriminator="type"),
]
