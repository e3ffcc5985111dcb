"""Result of a flight: its scenario, outcome, measures and columns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from springback.contact.shapes import ShapeSettings, distance_around
from springback.contact.thin_obstacles import ThinObstacle, thin_obstacles
from springback.contact.worlds import Own
from springback.errors import (
    CommandWarning,
    ContactWarning,
    FlightWarning,
    InputError,
    LedgerWarning,
    OverlapWarning,
)
from springback.results.contacts.restitution import restitution_note
from springback.results.joints.overlap import overlapping_cages
from springback.results.measures import FlightMeasures
from springback.results.meshes import Mesh, surfaces_of
from springback.results.recovery_measures import RECOVERY_MEASURES
from springback.scenario.scenario import Scenario
from springback.scenario.warnings import scenario_warnings
from springback.scenario.worlds.imported import named_obstacles
from springback.simulation.measuring.measures import FAILURES, MEASURES, Outcome
from springback.vehicle.state import reach

if TYPE_CHECKING:
    import pandas
    import xarray

Array = np.ndarray[Any, np.dtype[np.float64]]


#: Places of a trajectory that are looked at (chosen).
PLACES = 1000
#: Touched obstacles that are printed (chosen).
NAMED = 6
#: Measures that are printed, those of a recovery last.
_PRINCIPAL = (
    "touch_speed", "restitution_at_separation", "impact_peak_acceleration", "contact_time",
    "travel", "impact_arm_stroke", "contacts", "peak_acceleration",
    "detection_delay", "recovery_time", "height_loss", "nose_up", "nose_down", "runs",
    "recovered_runs",
)  # fmt: skip

#: Measures of arms that move.
_OF_ARMS = ("impact_arm_stroke", "impact_arm_extension", "arm_stroke", "arm_extension")
#: Accelerations below this are rounding [m/s²].
ROUNDING = 1e-6
#: A hard peak [m/s²] that contact makes has at least this share of its force (chosen).
HARD, BY_CONTACT = 50.0, 0.1
#: Measures to be told of where they are not 0.
_DAMAGE = (
    "propellers_hit", "rotors_stopped", "guard_margin", "arm_margin", "component_margin",
    "broken_time",
)  # fmt: skip


class MeasureLine(NamedTuple):
    """A measure to read."""

    name: str
    value: float | None
    unit: str
    meaning: str

    @property
    def text(self) -> str:
        """Value with unit, angles in degrees."""
        if self.value is None:
            return "-"
        degrees = self.unit == "rad"  # for reading; the measure is in rad
        value, unit = (math.degrees(self.value), "deg") if degrees else (self.value, self.unit)
        return f"{value:.5g} {unit.replace('^2', '²')}".rstrip()


class ObstacleContact(NamedTuple):
    """An obstacle that a vehicle touched, with its hardest contact."""

    obstacle: str
    """Its place in the scenario and its type, such as ``world.obstacles[0], a pole``."""
    contacts: int
    """Number of contacts, those of each part for itself."""
    parts: tuple[str, ...]
    """That touched it: cages or other guards, the main body."""
    force: float
    """Largest normal force on one part [N]."""
    time: float
    """Of that force [s]."""
    part: str
    """That it acts on."""
    place: tuple[float, float, float] | None
    """Where it acts, world [m]."""
    impulse: float = 0.0
    """Largest impulse of a surface that has no force [N s]; 0 of others."""

    @property
    def text(self) -> str:
        """In words."""
        at = (
            ""
            if self.place is None
            else f", at [{', '.join(f'{round(x, 2) + 0.0:.2f}' for x in self.place)}] m"
        )
        hardest = (
            f"impulse up to {self.impulse:.3g} N s" if self.impulse and not self.force
            else f"normal force up to {self.force:.3g} N"
        )  # fmt: skip
        where = f"on {self.part}{at}, at {self.time:.3f} s"
        return f"{self.obstacle}: by {' and '.join(self.parts)}, {hardest} {where}"


@dataclass(frozen=True, repr=False, eq=False)
class FlightResult(FlightMeasures):
    """Numbers of a flight.  Every measure is an attribute as well: ``flight.touch_speed``."""

    scenario: Scenario
    """All input of the flight."""
    outcome: Outcome
    """Reason for its end; ``outcome.word`` is the word in files and rows."""
    measures: dict[str, float | None]
    """Measures by name; units and meanings: `springback.simulation.measuring.measures.MEASURES`."""
    columns: dict[str, Array]
    """Trajectory by column, each of shape (instants,); empty if it was not recorded."""
    units: dict[str, str]
    """Unit of each column, including telemetry."""
    telemetry: dict[str, Array] = field(default_factory=dict)
    """Measured, estimated, desired and commanded values at every tick; without a pilot, what the
    scenario's ``[sensors]`` measure, if it has any.
    """
    work: dict[str, Array] = field(default_factory=dict)
    """Work done so far [J], by kind, and 1 during contact, each of shape (instants,), for
    `springback.results.energy_history`.  Files do not contain it.
    """
    first_obstacle: str = ""
    """What it touched first, such as world.obstacles[0], a pole.  Empty if it touched nothing, and
    in a flight that was read back: `obstacle_contacts` tells.
    """
    own: tuple[Own, ...] = ()
    """The user's own obstacles; empty for a flight that was read back."""
    own_surfaces: tuple[Mesh, ...] = ()
    """Surfaces of those obstacles for drawing, in a flight that was read back."""
    own_contacts: dict[str, Array] = field(default_factory=dict)
    """Their contacts in a flight that was read back: `springback.results.contacts.stored`."""
    warned: tuple[str, ...] | None = None
    """What `warnings` were, of a flight that was read back; None: they are found."""
    second: FlightResult | None = None
    """Flight of the second vehicle, if the scenario has one: at the same instants."""
    first: FlightResult | None = None
    """Of the flight of a second vehicle: that of the first, which knows the contacts of both."""

    if not TYPE_CHECKING:  # for mypy a misspelt measure is an error

        def __getattr__(self, name: str) -> float | None:
            measures: dict[str, float | None] = self.__dict__.get("measures", {})
            if name in measures:
                return measures[name]
            raise AttributeError(f"a flight has no {name!r}; measures: {', '.join(measures)}")

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.measures})

    @property
    def success(self) -> bool:
        """Success as in campaigns: recovered, if required; else neither ground nor stop was hit.

        A simulation that diverged is not a success either.
        """
        if "runs" in self.measures and self.scenario.recovery is not None:
            return self.outcome is Outcome.RECOVERED
        return self.outcome not in (*FAILURES, Outcome.NOT_SETTLED)

    @property
    def is_second(self) -> bool:
        """True for the flight of a second vehicle."""
        return self.first is not None

    @property
    def is_beside_movers(self) -> bool:
        """True if obstacles move, or there is a second vehicle."""
        scenario = self.scenario
        moving = any(getattr(one, "motion", None) is not None for one in scenario.world.obstacles)
        return moving or scenario.second is not None or self.is_second

    @property
    def is_piloted(self) -> bool:
        """True if a pilot flew it, and its telemetry was recorded."""
        return "command1" in self.telemetry

    @property
    def is_finite(self) -> bool:
        """True if the simulation stayed finite."""
        return self.outcome is not Outcome.NOT_FINITE

    @cached_property
    def remarks(self) -> dict[type[FlightWarning], str]:
        """Warnings about the flight, a sentence each, by their kind."""
        found: dict[type[FlightWarning], str] = {}
        if self.measures.get("ledger_open"):
            left = self.measures["ledger_residual"]  # None if it is not finite
            share = "more than all" if left is None else f"{left:.1e}"
            found[LedgerWarning] = (
                f"the energy ledger leaves {share} of the energy: the "
                "numbers cannot be trusted; try a smaller simulation.impact_step"
            )
        if deep := self._deep(self._doubtful()):
            found[ContactWarning] = deep
        if (crossed := overlapping_cages(self.scenario.vehicle, self.columns)) is not None:
            found[OverlapWarning] = crossed
        commands = [values for name, values in self.telemetry.items() if name.startswith("command")]
        lowest = np.min(commands, axis=0, initial=0.0)
        below = np.flatnonzero(lowest < 0.0)
        propulsion = self.scenario.vehicle.propulsion
        if len(below) and propulsion is not None:
            found[CommandWarning] = (
                f"the pilot commands less than 0 N at {len(below)} of {len(lowest)} ticks, first "
                f"at {self.telemetry['t'][below[0]]:.4g} s ({lowest[below[0]]:.3g} N): rotors do "
                f"not turn backwards and give their minimum, {propulsion.min_thrust:g} N"
            )
        return found

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What may be meant otherwise or is doubtful, a sentence each, as `springback fly` says it.

        First those about the scenario, such as elements of imported worlds that are not there, then
        `remarks`.  Those about a second vehicle's flight are among its own.
        """
        told = self._of_scenario() if self.warned is None else self.warned
        mine = tuple(self.remarks.values())
        return (*(one for one in told if one not in (*mine, *self._beside())), *mine)

    def _of_scenario(self) -> list[str]:
        """Warnings about the scenario; with two vehicles among those of the first one's flight."""
        if self.is_second:
            return []
        by_own = self.is_piloted and "ref_x" not in self.telemetry
        return scenario_warnings(self.scenario, own=by_own or self.scenario.pilot is not None)

    def _beside(self) -> list[str]:
        """Remarks about the flight of the second vehicle."""
        if self.second is None:
            return []
        return [f"second: {sentence}" for sentence in self.second.remarks.values()]

    def _doubtful(self) -> list[ThinObstacle]:
        """Obstacles on the way whose forces may not hold to the depth of a contact."""
        depth = self.measures.get("penetration") or 0.0
        named = thin_obstacles(named_obstacles(self.scenario.world.obstacles))
        return [one for one in named if one.is_doubtful(depth) and self._comes_near(one.shape)]

    def _deep(self, thin: Sequence[ThinObstacle]) -> str:
        """Warning of the first one that the deepest contact may have pierced; else empty."""
        depth = self.measures.get("penetration") or 0.0
        pierced = [one for one in thin if one.is_pierced(depth)]
        return pierced[0].warning(depth) if pierced else ""

    def _comes_near(self, shape: ShapeSettings) -> bool:
        """True if the vehicle comes near a shape, or no trajectory tells."""
        if shape.motion is not None or "x" not in self.columns:
            return True
        every = max(1, len(self.t) // PLACES)
        path = np.stack([self.columns[axis][::every] for axis in "xyz"], axis=1)
        far = reach(self.scenario.true_airframe())
        return any(distance_around(one, path).min() < far for one in shape.bodies())

    @property
    def message(self) -> str:
        """The outcome in a sentence."""
        return self.outcome.value

    @property
    def t(self) -> Array:
        """Instants of the trajectory [s], shape (instants,)."""
        return self.columns["t"]

    def readable_measures(self, *, all_of_them: bool = False) -> list[MeasureLine]:
        """The principal measures for reading, angles in degrees, or all.

        Of arms that are locked there are none.
        """
        known = MEASURES | (RECOVERY_MEASURES if "runs" in self.measures else {})
        damage = [name for name in _DAMAGE if self.measures.get(name)]
        wanted = known if all_of_them else (*_PRINCIPAL, *damage)
        locked = () if self.scenario.vehicle.is_compliant else _OF_ARMS
        names = [name for name in wanted if name in known and name not in locked]
        return [MeasureLine(name, self.measures[name], *known[name]) for name in names]

    def __repr__(self) -> str:
        lines = [f"Flight {self.scenario.name!r}: {self.outcome.word} ({self.message})"]
        shown = self.readable_measures()
        width = max(len(line.name) for line in shown)
        note = restitution_note(self.measures, self.columns, self.scenario.vehicle.guard_word)
        beside = ", relative to what it touched" if self.is_beside_movers else ""
        whys = {
            "touch_speed": ""
            if self.measures["touch_speed"] is None
            else f", along the normal{beside}",
            "travel": "; driven back at once" if self.measures["travel"] == 0.0 else "",
            "restitution_at_separation": f"; {note}" if note else "",
            "impact_peak_acceleration": self._about_first_peak(),
            "peak_acceleration": self._later_peak(),
            "impact_arm_stroke": self._bottomed(),
            "height_loss": self._without_ground(),
            "broken_time": "".join(f", {part}" for part in self.broken_parts),
        }
        for line in shown:
            lines.append(f"  {line.name:<{width}} {line.text}{whys.get(line.name, '')}")
        lines += [f"  {'impulse':<{width}} {self.impulse_text}"] * bool(self.impulse_text)
        lines += [f"  {'touched':<{width}} {one.text}" for one in self.obstacle_contacts[:NAMED]]
        if (more := len(self.obstacle_contacts) - NAMED) > 0:
            lines.append(f"  {'':<{width}} and {more} more")
        return "\n".join(lines)

    @property
    def impulse_text(self) -> str:
        """Size and direction of the impulse of all contacts on it; empty without a contact."""
        found = [self.measures.get(f"impulse_{axis}") for axis in "xyz"]
        known = [each for each in found if each is not None]
        if not self.measures.get("contacts") or len(known) < len(found):
            return ""
        along = ", ".join(f"{each:.3g}" for each in known)
        return f"{math.hypot(*known):.4g} N s by all contacts: [{along}] N s, world axes"

    @property
    def obstacle_contacts(self) -> tuple[ObstacleContact, ...]:
        """Obstacles that it touched; without a trajectory not known."""
        return ()

    @property
    def broken_parts(self) -> tuple[str, ...]:
        """What was loaded beyond its limit, and when; without a trajectory not known."""
        return ()

    def _about_first_peak(self) -> str:
        """What the largest acceleration of the first impact may hide; mostly empty."""
        when, peak = (self.measures.get(f"impact_peak_acceleration{end}") for end in ("_time", ""))
        if when is None or peak is None:
            return ""
        end = self.scenario.simulation.duration
        if self.outcome is Outcome.IN_CONTACT and when >= (1.0 - 1e-9) * end:
            return ", as the flight ends: a longer simulation.duration shows whether it grows"
        forces = [values for name, values in self.columns.items() if name.startswith("fn")]
        row = np.searchsorted(self.columns.get("t", np.zeros(0)), when)
        pressed = sum(values[row] for values in forces if row < len(values))
        if not forces or peak < HARD or pressed > BY_CONTACT * peak * self.scenario.vehicle.mass:
            return ""
        return (
            f", at {when:.4g} s with {pressed:.2g} N of contact: arms that come back to a stop, or "
            "a latch that closes, make it"
        )

    def _later_peak(self) -> str:
        """When the largest acceleration was, if not in the first impact."""
        when = self.measures.get("peak_acceleration_time")
        left = self.measures.get("separation_time")
        peak, first = (self.measures.get(f"{of}peak_acceleration") for of in ("", "impact_"))
        if when is None or left is None or when <= left or peak is None or peak < ROUNDING:
            return ""
        if first is not None and peak <= first:  # while its arms settle
            return ""
        return f", at {when:.4g} s: after the first impact, which ended at {left:.4g} s"

    def _bottomed(self) -> str:
        """When an arm reached the end of its stroke, if it did."""
        when = self.measures.get("bottomed_time")
        return "" if when is None else f"; an arm reached the end of its stroke at {when:.4g} s"

    def _without_ground(self) -> str:
        """How far it comes down below zero height where its world has no ground, if it does."""
        obstacles, z = self.scenario.world.obstacles, self.columns.get("z", np.zeros(0))
        may_land = bool(self.own) or any(one.type in ("ground", "import") for one in obstacles)
        if may_land or not len(z) or z[0] <= 0.0 or z.min() >= 0.0:
            return ""
        return f", down to z = {z.min():.3g} m: the world has no ground, which it might have hit"

    def need_trajectory(self) -> None:
        """Raise an InputError if the trajectory was not recorded."""
        if not self.columns:
            raise InputError("this flight has no trajectory: fly it with trajectory=True")

    def to_dataframe(self) -> pandas.DataFrame:
        """Trajectory as a pandas DataFrame, one row per instant; units in ``attrs``.

        Raises:
            InputError: If pandas is not installed, or the trajectory was not recorded.
        """
        self.need_trajectory()
        from springback.extras import needs

        pd = needs("pandas", "dataframe")
        frame: pandas.DataFrame = pd.DataFrame(self.columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Trajectory as an xarray Dataset over ``t``; units and measures in ``attrs``.

        Raises:
            InputError: If xarray is not installed, or the trajectory was not recorded.
        """
        self.need_trajectory()
        from springback.extras import needs

        xr = needs("xarray", "xarray")
        data = {
            name: ("t", values, {"units": self.units[name]})
            for name, values in self.columns.items()
            if name != "t"
        }
        known = {name: value for name, value in self.measures.items() if value is not None}
        dataset: xarray.Dataset = xr.Dataset(
            data,
            coords={"t": ("t", self.t, {"units": "s"})},
            attrs={"name": self.scenario.name, "outcome": self.outcome.word, **known},
        )
        return dataset

    def summary(self) -> dict[str, Any]:
        """The result as plain data: outcome, measures, units, scenario, versions."""
        from springback.version import __version__

        known = MEASURES | (RECOVERY_MEASURES if "runs" in self.measures else {})
        return {
            "springback": __version__,
            "name": self.scenario.name,
            "outcome": self.outcome.word,
            "message": self.message,
            "measures": self.measures,
            "units": {name: unit for name, (unit, _) in known.items()},
            "scenario": self.scenario.model_dump(mode="json"),
            **self._contacts(),
            "warnings": [*self.warnings, *self._beside()],
            **self._own_obstacles(),
            **({} if self.second is None else {"second": self.second.verdict()}),
        }

    def verdict(self) -> dict[str, Any]:
        """Outcome, measures and touched obstacles as plain data."""
        return {
            "outcome": self.outcome.word,
            "message": self.message,
            "measures": self.measures,
            **self._contacts(),
        }

    def _contacts(self) -> dict[str, Any]:
        """Touched obstacles and what broke, if there is a trajectory that tells."""
        contacts = [one._asdict() for one in self.obstacle_contacts]
        broken = {"broken_parts": self.broken_parts} if self.broken_parts else {}
        return {"obstacle_contacts": contacts, **broken} if self.columns else {}

    def _own_obstacles(self) -> dict[str, Any]:
        """Surfaces of the user's own obstacles near the flight, if any."""
        found = self.own_surfaces
        if self.own and self.columns:
            place = np.stack([self.columns[axis] for axis in "xyz"], axis=1)
            pressed = [c > 0.0 for name, c in self.columns.items() if name.startswith("fn")]
            touching = np.any(pressed, axis=0)
            found = surfaces_of(self.own, place[touching] if touching.any() else place)
        return {"own_obstacles": [one.as_dict() for one in found]} if found else {}
