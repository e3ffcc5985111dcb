"""The user's own scenario in the impact lab: what is taken from the file, and at which numbers."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from springback.contact.nets import Net
from springback.contact.obstacles import Plane
from springback.contact.parameters import Ground, Mat, SurfaceSettings, Wall
from springback.control.reference_parameters import RunUpSettings
from springback.interfaces.output.robots import ROBOTS, robot_label
from springback.kernels.vectors import Vec
from springback.scenario.code_files import with_absolute_names
from springback.scenario.files import read_scenario
from springback.scenario.overrides import apply_overrides
from springback.scenario.presets import is_vehicle_file, second_tables, thrust_of, vehicle_table
from springback.scenario.scenario import Scenario
from springback.scenario.source_text import source_text, toml_tables
from springback.scenario.worlds.imported import single_obstacles
from springback.vehicle.parameters import Vehicle

#: Most characters of the robot's label on the page (chosen).
LONGEST_LABEL = 24
#: Digits kept of numbers taken from a file, in the unit of the page (chosen).
DIGITS = 6

Table = dict[str, Any]


@dataclass(frozen=True)
class UserScenario:
    """A scenario file with its overrides."""

    name: str
    """File name, without folders."""
    tables: Table
    """Its tables as given, overrides applied."""
    scenario: Scenario
    """The same, checked."""

    @property
    def vehicle(self) -> Vehicle:
        """Its vehicle."""
        return self.scenario.vehicle

    @functools.cached_property
    def label(self) -> str:
        """Label of its robot on the page: the vehicle's name, or that of the file."""
        name = self.vehicle.name
        label = Path(self.name).stem if name == "vehicle" else robot_label(name)
        if label in {robot.label for robot in ROBOTS.values()}:
            label = f"My {label}"
        return label if len(label) <= LONGEST_LABEL else label[: LONGEST_LABEL - 1] + "…"

    @property
    def is_piloted(self) -> bool:
        """True if a pilot flies it as it is in the file."""
        return self.scenario.reference is not None or self.scenario.pilot is not None

    @property
    def run_up(self) -> RunUpSettings | None:
        """Its run-up, if it has one."""
        found = self.scenario.reference
        return found if isinstance(found, RunUpSettings) else None

    @functools.cached_property
    def target(self) -> Wall | Mat | Ground | None:
        """The obstacle that its start flies towards, else its first wall or mat; None without any.

        A ground counts only if nothing else does.
        """
        obstacles = [
            one
            for one in single_obstacles(self.scenario.world.obstacles)
            if isinstance(one, Wall | Mat | Ground)
        ]
        standing = [one for one in obstacles if not isinstance(one, Ground)]
        ahead = [(time, k) for k, one in enumerate(standing) if (time := self._time_to(one))]
        if ahead:
            return standing[min(ahead)[1]]
        return next(iter([*standing, *obstacles]), None)

    def _time_to(self, obstacle: Wall | Mat) -> float | None:
        """Time of flight to a wall or mat [s], straight on from the start; None if never."""
        plane, start = _face(obstacle), self.scenario.start
        closing = -(plane.normal @ Vec(*start.velocity))
        gap = plane.normal @ Vec(*start.position) - plane.offset
        return float(gap / closing) if closing > 0.0 and gap > 0.0 else None

    @functools.cached_property
    def surface(self) -> SurfaceSettings | None:
        """Surface of its wall or mat ahead, else of its first obstacle that has one, else None.

        A ground counts only if nothing else does.
        """
        if isinstance(self.target, Wall | Mat):
            return self.target.surface
        obstacles = single_obstacles(self.scenario.world.obstacles)
        standing = [one for one in obstacles if not isinstance(one, Ground)]
        found = (_surface_of(one) for one in [*standing, *obstacles])
        return next((one for one in found if one is not None), None)

    @property
    def surface_types(self) -> set[str]:
        """Types of the obstacles that `world_with_surface` changes."""
        return {str(one["type"]) for one in self._obstacles if self._takes(one)}

    def world_with_surface(self, surface: Any) -> Table:
        """Its raw world with another raw surface on all obstacles, in front of mats.

        Nets keep their own law, and grounds their surfaces unless nothing else has one.
        """
        found = [_coated(one, surface) if self._takes(one) else one for one in self._obstacles]
        world: Table = self.tables.get("world", {})
        return world | {"obstacles": found}

    @property
    def _obstacles(self) -> list[Table]:
        return list(self.tables.get("world", {}).get("obstacles", ()))

    def _takes(self, entry: Table) -> bool:
        """True if an obstacle takes another surface."""
        lies = all(one.get("type") in ("ground", "net") for one in self._obstacles)
        return entry.get("type") not in (("net",) if lies else ("ground", "net"))

    @property
    def speed(self) -> float | None:
        """Speed of its run-up, else of its start [m/s]; None for a start at rest."""
        if self.run_up is not None:
            return _rounded(float(self.run_up.speed))
        return _rounded(math.hypot(*self.scenario.start.velocity)) or None

    @property
    def pitch(self) -> float:
        """Pitch of its run-up, else of its start [deg]."""
        angle = float(self.scenario.start.angles()[1] if self.run_up is None else self.run_up.pitch)
        return _rounded(math.degrees(angle))

    @property
    def yaw(self) -> float:
        """Yaw of its start against its target [deg], from −180 to 180; 0 for a pilot."""
        if self.is_piloted:
            return 0.0
        towards = 0.0
        if isinstance(self.target, Wall | Mat):
            into = -1.0 * _face(self.target).normal
            towards = math.atan2(into.y, into.x) if math.hypot(into.x, into.y) > 1e-9 else 0.0
        yaw = self.scenario.start.angles()[2]
        return _rounded(math.degrees(math.remainder(yaw - towards, math.tau)))

    @property
    def start_yaw(self) -> float:
        """Yaw of its start in the world [deg], from −180 to 180."""
        yaw = self.scenario.start.angles()[2]
        return _rounded(math.degrees(math.remainder(yaw, math.tau)))


def _face(obstacle: Wall | Mat) -> Plane:
    return obstacle.plane(obstacle.thickness if isinstance(obstacle, Mat) else 0.0)


def _surface_of(obstacle: Any) -> SurfaceSettings | None:
    """Surface of an obstacle, of a union its first; None of a net, which has its own law."""
    for one in getattr(obstacle, "shapes", (obstacle,)):
        if not isinstance(one, Net):
            found: SurfaceSettings = one.surface
            return found
    return None


def _coated(entry: Table, surface: Any) -> Table:
    """A raw obstacle with a surface on all its parts, and of an import with its friction, too."""
    found = entry | {"surface": surface}
    if entry["type"] == "union":
        parts = entry["shapes"]
        found["shapes"] = [{k: v for k, v in one.items() if k != "surface"} for one in parts]
    if entry["type"] == "import":
        found = {k: v for k, v in found.items() if k != "surfaces"} | {"friction": "surface"}
    return found


def _rounded(number: float) -> float:
    return float(f"{number:.{DIGITS}g}") + 0.0


def read_user_scenario(path: Path, overrides: Sequence[str] = ()) -> UserScenario:
    """Scenario for the lab from a file; those of vehicle and thrusts that it names are read once.

    Raises:
        InputError: One line for each problem, as of `springback.scenario.files.read_scenario`.
    """
    scenario = read_scenario(path, overrides)
    given = with_absolute_names(toml_tables(source_text(path), str(path)), path.parent)
    given = with_absolute_names(apply_overrides(given, overrides), Path())
    vehicle = given["vehicle"]
    if is_vehicle_file(vehicle.get("preset") if isinstance(vehicle, dict) else vehicle):
        given["vehicle"] = _without_none(vehicle_table(vehicle))
    if "thrust" in given:
        given["thrust"] = thrust_of(given["thrust"])
    if given.get("second") is not None:
        given["second"] = _without_none(second_tables(given["second"]))
    return UserScenario(path.name, given, scenario)


def _without_none(table: Any) -> Any:
    """Raw table without keys that hold nothing, which TOML cannot write; they are the defaults."""
    if not isinstance(table, dict):
        return table
    return {key: _without_none(value) for key, value in table.items() if value is not None}
