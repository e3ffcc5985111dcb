"""Scenarios of the impact lab, one for each robot.

The lab flies the same text that it offers for download, so `springback fly` gives the same numbers.
"""

from __future__ import annotations

import functools
import math
import tomllib
from typing import Any

import numpy as np
import tomli_w

from springback.contact.cage import ArmTip, Ring, support
from springback.contact.parameters import Mat, Wall
from springback.errors import InputError
from springback.interfaces.lab.obstacles import (
    ROD,
    WORDS,
    is_on_slider,
    obstacle_of,
    shape_table,
    swinging,
)
from springback.interfaces.lab.second_vehicle import is_second_default, second_table
from springback.interfaces.lab.settings import (
    VEHICLE_SETTINGS,
    LabSettings,
    digits,
    is_default,
    query_of,
)
from springback.interfaces.lab.user_scenario import UserScenario
from springback.interfaces.lab.vehicles import is_balanced, robot_name, vehicle_of, vehicle_table_of
from springback.kernels.vectors import Vec
from springback.paper.slider import MAT_THICKNESS
from springback.scenario.model import RING_ROUNDING, true_vehicle
from springback.scenario.scenario import Scenario, scenario_from
from springback.scenario.tables import ModelError, Payload
from springback.studies.run_ups import WALL_DISTANCE, run_up_scenario
from springback.vehicle.arms.paths import free_end_along
from springback.vehicle.hulls import hull_reach
from springback.vehicle.parameters import Vehicle

#: Time before and after first touch of an impact [s] (chosen: contacts last up to 0.1 s).
BEFORE, AFTER = 0.025, 0.3
#: Duration of a flight with run-up, recovery and return, and of one without recovery [s] (chosen).
DURATION, UNANSWERED = 8.0, 5.0
#: Height of all flights [m], as in the paper.
HEIGHT = 1.0
GRAVITY = 9.81
#: Distance from which a shape is approached to find the first touch [m] (chosen: outside it).
AHEAD = 1.5
#: Longest swing of a ball before it hits a robot that a pilot flies [s], and widest [rad]; distance
#: in front of the place where it does so at which it would hang at rest [m] (chosen).
SWINGS, WIDEST_SWING, CLEAR = 0.5, 1.0, 0.6
#: Most of these that are remembered: they do not depend on the speed (chosen).
MOST_TOUCHES = 256

Table = dict[str, Any]


def robots_of(settings: LabSettings) -> tuple[str, ...]:
    """Names of the robots to fly: ``arq``, ``quad``; ``mine``, the file's ``file`` and ``twin``."""
    if settings.robot == "both":
        return "arq", "quad"
    beside = getattr(settings, "beside", "none")
    return (settings.robot, beside) if beside not in ("none", settings.robot) else (settings.robot,)


def is_piloted(settings: LabSettings) -> bool:
    """True if a pilot flies these settings."""
    user = settings.user
    return settings.mode == "flight" or (
        settings.mode == "file" and user is not None and user.is_piloted
    )


def lab_tables(settings: LabSettings, robot: str) -> Table:
    """Scenario of some settings, as plain tables.

    Args:
        settings: Settings of the lab.
        robot: One of `robots_of`.
    """
    user = settings.user
    if settings.mode == "file" and user is not None:
        return _as_in_file(settings, robot, user)
    return _flight(settings, robot) if settings.mode == "flight" else _impact(settings, robot)


def lab_toml(settings: LabSettings, robot: str) -> str:
    """`lab_tables` as the text of a scenario file."""
    query = query_of(settings)
    head = f"# From the impact lab: {query}\n" if query else "# From the impact lab, as it opens.\n"
    return (
        f"{head}#   springback fly {file_name(settings, robot)} --out results\n"
        f"{tomli_w.dumps(lab_tables(settings, robot))}"
    )


def file_name(settings: LabSettings, robot: str) -> str:
    """File name of a downloaded scenario; it contains no text from outside."""
    return f"{settings.mode}-{robot}.toml"


def lab_scenario(settings: LabSettings, robot: str) -> Scenario:
    """Scenario read back from `lab_toml`.

    Raises:
        InputError: If it cannot be flown; one line for each problem, with its field.
    """
    return scenario_from(tomllib.loads(lab_toml(settings, robot)))


# -- as in the file -------------------------------------------------------------------------------


def _as_in_file(s: LabSettings, robot: str, user: UserScenario) -> Table:
    """The user's scenario, with the changes of the page; unchanged, to its last number."""
    given = user.tables | {"vehicle": vehicle_table_of(s, robot, slides=False)}
    if user.run_up is not None:
        given["reference"] = user.tables["reference"] | _changes(
            s, speed=f"{digits(s.speed)} m/s", pitch=f"{digits(s.pitch)} deg"
        )
    elif not user.is_piloted:
        given["start"] = _start(s, user)
    is_coated = s.surface != "file" and user.surface is not None
    if is_coated:
        given["world"] = user.world_with_surface(_surface(s, slides=False))
    if not is_second_default(s):
        given["second"] = second_table(s, user)
    of_first = ("speed", "pitch", *_start_yaw(s), *VEHICLE_SETTINGS)
    as_given = is_default(s, *of_first) and is_second_default(s) and not is_coated
    if not as_given or robot not in ("mine", "file"):
        given["name"] = f"{robot_name(s, robot)}, {user.scenario.name}, changed"[:200]
    return given


def _changes(s: LabSettings, **values: str) -> Table:
    return {name: text for name, text in values.items() if not is_default(s, name)}


def _start(s: LabSettings, user: UserScenario) -> Table:
    """The start of the file, with its changed values."""
    start, found = user.scenario.start, dict(user.tables.get("start", {}))
    roll, pitch, yaw = start.angles()
    if not is_default(s, "speed") and user.speed:
        share = s.speed / math.hypot(*start.velocity)
        found["velocity"] = [share * v for v in start.velocity]
    if not is_default(s, "pitch", *_start_yaw(s)) and found.pop("quaternion", None):
        found |= {"roll": roll, "pitch": pitch, "yaw": yaw}
    if not is_default(s, "pitch"):
        found["pitch"] = f"{digits(s.pitch)} deg"
    if not is_default(s, *_start_yaw(s)):
        found["yaw"] = f"{digits(getattr(s, *_start_yaw(s)))} deg"
    return found


def _start_yaw(s: LabSettings) -> tuple[str, ...]:
    """Name of the setting for the yaw of the file's start, if it can be set."""
    return tuple(name for name in ("start_yaw",) if name in type(s).model_fields)


# -- impact ---------------------------------------------------------------------------------------


def _impact(s: LabSettings, robot: str) -> Table:
    """The collision alone, with its start computed backwards from first touch.

    Before it no moment acts on the robot, and its rotors, of equal thrust, accelerate it uniformly:
    it hits the wall at the requested speed, and level.  A ball hits it at that speed, while it
    hovers.  A robot that equal thrusts would turn falls freely, with its rotors off.
    """
    slides = is_on_slider(s)
    table = vehicle_table_of(s, robot, slides)
    vehicle, pitch, yaw = vehicle_of(table), s.pitch, s.yaw
    given: Table = {
        "name": _name(s, robot),
        "vehicle": table,
        "world": {"obstacles": _ahead(s, slides, 0.0), **_gravity(s)},
        **_physics(s, robot, slides),
    }
    gravity, hovers = given["world"].get("gravity", GRAVITY), is_balanced(vehicle)
    lift = _lift(given, vehicle) if hovers else 0.0
    pull = np.zeros(3) if slides else gravity * (lift * _upward(pitch, yaw) - np.array([0, 0, 1.0]))
    paper = given.get("model", {}).get("contact_point") == "paper"
    touch = np.array([WALL_DISTANCE - _reach(vehicle, pitch, yaw, paper), 0.0, HEIGHT])
    velocity = np.array([s.speed, 0.0, 0.0])
    if obstacle_of(s) not in ("wall", "robot"):
        touch[0] = _touch(given, touch[0], s)
    if obstacle_of(s) == "ball":
        [ball] = given["world"]["obstacles"]
        given["world"]["obstacles"] = [swinging(ball, s, gravity, BEFORE, 0.0)]
        velocity = np.zeros(3)
    start = touch - velocity * BEFORE + 0.5 * pull * BEFORE**2
    given["start"] = {
        "position": [float(x) for x in start],
        "velocity": [float(x) for x in velocity - pull * BEFORE],
        "pitch": f"{digits(pitch)} deg",
        "yaw": f"{digits(yaw)} deg",
    }
    thrust: Table = {"thrust": "hover"} if hovers and not slides else {}
    if obstacle_of(s) == "robot":
        given["second"] = _other(s, robot, given, thrust)
    return given | thrust


def _other(s: LabSettings, robot: str, given: Table, more: Table) -> Table:
    """A second robot like the first, level, whose foremost point arrives where a wall would be.

    Args:
        s: Settings.
        robot: One of `robots_of`.
        given: Scenario of the first.
        more: Further keys: its thrust, or what its pilot is to do.
    """
    paper = given.get("model", {}).get("contact_point") == "paper"
    ahead = WALL_DISTANCE + _reach(vehicle_of(given["vehicle"]), 0.0, 0.0, paper)
    speed = s.other_speed if s.mode == "impact" else 0.0
    start: Table = {"position": [ahead + speed * BEFORE, 1e-3 * s.offset, HEIGHT]}
    if speed:
        start["velocity"] = [-speed, 0.0, 0.0]
    turned = math.remainder(180.0 - s.yaw if s.mode == "flight" else 180.0, 360.0)
    own: Table = {key: given[key] for key in ("payload", "model_error") if key in given}
    other: Table = {
        "name": f"other {robot_name(s, robot)}",
        "vehicle": given["vehicle"],
        **own,
        **more,
    }
    if s.surface != "wall":
        other["surface"] = _surface(s, slides=False)
    return other | {"start": start | {"yaw": f"{digits(turned)} deg"}}


def _gravity(s: LabSettings) -> Table:
    """The file's gravity, where it is another."""
    g = GRAVITY if s.user is None else s.user.scenario.world.gravity
    return {} if g == GRAVITY else {"gravity": g}


def _physics(s: LabSettings, robot: str, slides: bool) -> Table:
    """Models and steps of an impact: the user's for the user's robot, else ours."""
    user, model = s.user, {"slider": [1.0, 0.0, 0.0]} if slides else {}
    if user is None or robot not in ("mine", "file", "twin"):
        found: Table = {"simulation": {"duration": BEFORE + AFTER}}
        return found | ({"model": {"contact_point": "paper", **model}} if slides else {})
    own: Table = {key: user.tables[key] for key in ("payload", "model_error") if key in user.tables}
    theirs = {k: v for k, v in user.tables.get("model", {}).items() if k != "slider"}
    steps = {"duration": BEFORE + AFTER}
    own["simulation"] = user.tables.get("simulation", {}) | steps
    return own | ({"model": theirs | model} if theirs | model else {})


def _lift(given: Table, vehicle: Vehicle) -> float:
    """Thrust over true weight at the hover thrust of the nominal vehicle."""
    error = ModelError(**given.get("model_error", {}))
    return vehicle.mass / true_vehicle(vehicle, error, Payload(**given.get("payload", {}))).mass


def _inward(pitch: float, yaw: float) -> Vec:
    """World X axis in body axes, at a pitch and yaw [deg]."""
    theta, psi = math.radians(pitch), math.radians(yaw)
    return Vec(math.cos(psi) * math.cos(theta), -math.sin(psi), math.cos(psi) * math.sin(theta))


def _upward(pitch: float, yaw: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Direction of the rotors' thrust in world axes, at a pitch and yaw [deg]."""
    theta, psi = math.radians(pitch), math.radians(yaw)
    tilt = math.sin(theta)
    return np.array([math.cos(psi) * tilt, math.sin(psi) * tilt, math.cos(theta)])


def _reach(vehicle: Vehicle, pitch: float, yaw: float, paper: bool) -> float:
    """Distance from the main body to the wall at first touch [m].

    By the paper's contact point, eq. (13), if ``paper``; else by the ring, whose rounding makes it
    touch a few µm before its foremost point would.
    """
    n, model = _inward(pitch, yaw), ArmTip(0.0) if paper else Ring(RING_ROUNDING)
    ends = []
    for j, angle in enumerate(vehicle.arms.directions if vehicle.arms.cages else ()):
        arm = Vec(math.cos(angle), math.sin(angle), 0.0)
        at = support(model, n, arm, vehicle.arms.at("cage_radius", j))
        ends.append(n @ (vehicle.arms.end(j) + at.point) - at.inset)
    airframe = vehicle.airframe()
    ends += [hull_reach(hull, n) for hull in airframe.hull]
    for one in airframe.arms:
        along = free_end_along(one, n)
        ends += [along + hull_reach(hull, n) for hull in one.hull]
    return float(max(ends))


def _touch(given: Table, ahead: float, s: LabSettings) -> float:
    """X of the main body as it first touches a shape [m]; as at a wall if it touches nothing."""
    start = {
        "position": [ahead - AHEAD, 0.0, HEIGHT], "velocity": [1.0, 0.0, 0.0],
        "pitch": f"{digits(s.pitch)} deg", "yaw": f"{digits(s.yaw)} deg", "touch_distance": 0.0,
    }  # fmt: skip
    found = _touch_of(tomli_w.dumps(given | {"name": "touch", "start": start}))
    return ahead if found is None else found


@functools.lru_cache(maxsize=MOST_TOUCHES)
def _touch_of(text: str) -> float | None:
    """X of the main body at the start of a scenario that begins at the touch [m]; None without."""
    try:
        return float(scenario_from(tomllib.loads(text)).start_state().position.x)
    except InputError:  # it passes by, or through; what else is wrong is said when it is flown
        return None


# -- flight ---------------------------------------------------------------------------------------


def _flight(s: LabSettings, robot: str) -> Table:
    """Run-up, collision and recovery; a yaw turns the obstacle, unknown to the pilot."""
    psi = math.radians(s.yaw)
    ahead = _ahead(s, slides=False, turned=-s.yaw)
    if s.yaw != 0.0 and obstacle_of(s) == "wall":
        [wall] = ahead
        del wall["distance"]
        wall["position"] = [WALL_DISTANCE, 0.0, 0.0]
        wall["normal"] = [-math.cos(psi), math.sin(psi), 0.0]
        if wall["type"] == "mat":  # the face stays where the robot expects it
            wall["position"][0] += wall["thickness"] / math.cos(psi)
    given = run_up_scenario(robot, s.pitch, s.speed)
    given |= {
        "name": _name(s, robot),
        "vehicle": vehicle_table_of(s, robot, slides=False),
        "world": {"obstacles": [*ahead, {"type": "ground", "surface": "wall"}], **_gravity(s)},
        "simulation": {"duration": DURATION},
    }
    if obstacle_of(s) == "ball":
        given |= _hover(s, given)
    if s.recovery == "none":
        given["simulation"] = {"duration": UNANSWERED}
    else:
        given["recovery"] = {"response": {"way": s.recovery}}
    if obstacle_of(s) == "robot":
        given["second"] = _hovering(s, robot, given)
    return given


def _hovering(s: LabSettings, robot: str, given: Table) -> Table:
    """A second robot with a pilot, who holds its place and answers a collision as the first."""
    told: Table = {
        key: given[key] for key in ("control", "sensors", "estimator", "recovery") if key in given
    }
    other = _other(s, robot, given, told)
    start = other["start"]
    return other | {"reference": {"type": "hold", **start}}


def _hover(s: LabSettings, given: Table) -> Table:
    """Tables of a flight in which the robot hovers where a ball is to hit it."""
    ball, *others = given["world"]["obstacles"]
    alone = given | {"world": given["world"] | {"obstacles": [ball]}}
    place = [_touch(alone, WALL_DISTANCE, s.with_checked(pitch=0.0)), 0.0, HEIGHT]
    gravity, yaw = given["world"].get("gravity", GRAVITY), f"{digits(s.yaw)} deg"
    # So that it starts at less than a right angle.
    before = min(SWINGS, WIDEST_SWING * ROD / s.speed)
    return {
        "world": given["world"]
        | {"obstacles": [swinging(ball, s, gravity, before, CLEAR), *others]},
        "reference": {"type": "hold", "position": place, "yaw": yaw},
        "start": {"position": place, "yaw": yaw},
    }


# -- both -----------------------------------------------------------------------------------------


#: Words for the surface of another obstacle than a wall.
_ALONE = {
    "wall": "surface of a wall", "mat": "surface of a mat", "own": "own surface",
    "file": "surface of the file",
}  # fmt: skip


def _name(s: LabSettings, robot: str) -> str:
    target = None if s.user is None else s.user.target
    of_file = f"{target.type} of the file" if isinstance(target, Wall | Mat) else _ALONE["file"]
    where = {"wall": "wall", "mat": "mat", "own": "own surface", "file": of_file}
    if obstacle_of(s) != "wall":
        what_is_hit = WORDS.get(s.obstacle, s.obstacle)
        where = {name: f"{what_is_hit}, {words}" for name, words in _ALONE.items()}
        if s.obstacle == "robot":
            where["wall"] = what_is_hit
    slides = ", slider" if is_on_slider(s) else ""
    what = f"{digits(s.speed)} m/s, {digits(s.pitch)} deg, {where[s.surface]}{slides}"
    return f"{robot_name(s, robot)}, {what}"


def _ahead(s: LabSettings, slides: bool, turned: float) -> list[Table]:
    """Obstacles ahead of a robot: one, or none if another robot is there."""
    if obstacle_of(s) == "robot":
        return []
    return [_obstacle(s, WALL_DISTANCE, slides, turned)]


def _obstacle(s: LabSettings, face: float, slides: bool, turned: float) -> Table:
    """Wall or mat whose face is at a distance [m]; a shape, which is turned by an angle [deg]."""
    if obstacle_of(s) != "wall":
        return shape_table(s, face, HEIGHT, _surface(s, slides=False), turned)
    more: Table = {"friction_axes": "vertical"} if slides else {}
    target = None if s.user is None else s.user.target
    if s.surface in ("file", "own") and isinstance(target, Mat):
        return {
            "type": "mat", "distance": face + target.thickness, "thickness": target.thickness,
            "surface": _surface(s, slides),
            "backing": target.backing.model_dump(exclude_none=True),
        }  # fmt: skip
    if s.surface == "mat":
        mat, wall = ({"preset": name, **more} if more else name for name in ("mat", "wall"))
        distance = face + MAT_THICKNESS
        return {
            "type": "mat", "distance": distance, "thickness": MAT_THICKNESS, "surface": mat,
            "backing": wall,
        }  # fmt: skip
    return {"type": "wall", "distance": face, "surface": _surface(s, slides)}


def _surface(s: LabSettings, slides: bool) -> Any:
    """Surface of the face, as a raw table: the file's; on the slider with the paper's friction."""
    more: Table = {"friction_axes": "vertical"} if slides else {}
    own = None if s.user is None else s.user.surface
    if s.surface == "file" and own is not None:
        return own.model_dump(exclude_none=True)
    if s.surface == "own":
        shared = 2 if own is None else own.shared_by
        return {
            "stiffness": 1e3 * s.contact_stiffness, "shared_by": shared, "friction": s.friction,
            "dissipation": s.dissipation, **more,
        }  # fmt: skip
    name = "mat" if s.surface == "mat" else "wall"
    return {"preset": name, **more} if more else name
