"""Study of detection and characterisation: delay, reliability and accuracy.

Robots, the paper's or the user's own, fly at a wall, head on and askew, with the scatter of
`springback.studies.trials`; and they fly fast circles and steps in gusts, where there is nothing to
hit.  Every trigger watches every flight, whether it is in use or not.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from springback.progress import Progress, silent
from springback.recovery.characterisation import Collision
from springback.recovery.state_machine import LOOK
from springback.results.flight import fly_built
from springback.scenario.scenario import Scenario, scenario_from
from springback.simulation.guided import GuidedFlown
from springback.simulation.measuring.record import Model
from springback.simulation.onboard import Avionics
from springback.studies.roc import Array, FalseAlarms, RocPoint, TriggerSignal, curve, false_alarms
from springback.studies.run_ups import ROBOTS, WALL_DISTANCE, StudyVehicle, study_vehicles
from springback.studies.trials import Scatter, trial_tables
from springback.vehicle.arms.paths import arm_path
from springback.vehicle.state import Arm

#: Speeds at contact [m/s]; the paper's are 2 and 3.5.
SPEEDS = (0.25, 0.5, 1.0, 2.0, 3.5)
#: Below this speed a collision is only to be detected, not characterised [m/s], chosen.
CHARACTERISED_FROM = 1.0
#: Yaw of the wall and of the robot [deg]; −30 to 30 was required.
ASKEW = ((0, 0), (-30, 0), (-15, 0), (15, 0), (30, 0), (0, -30), (0, -15), (0, 15), (0, 30))
#: An alarm later than this after touch counts as a miss [s], chosen: contacts take 26 ms at least.
IN_TIME = 0.03
#: Free flight of each robot [s].
FREE = 1000.0
#: One free flight [s], chosen: its telemetry then takes some 30 MB.
PIECE = 50.0
#: From where the robot first cruises to the wall, at least [m], chosen; less for slow approaches.
RUN, SHORT_RUN, SLOW = 2.4, 0.6, 0.7
#: A wall that is never met [m]; with it free flights are of the same kind as the others.
FAR = 50.0
#: Peak over mean speed of the polynomial of least snap from rest to rest: 35/16.
PEAK_OVER_MEAN = 35.0 / 16.0
#: An arm took part if it took this share of the normal impulse by the end of the window (chosen).
TOOK_PART = 0.1
#: The signals of the telemetry, and the sensor at whose pace each changes.
SIGNALS = {"hall": "pressed", "acceleration": "jolt", "wrench": "push", "momentum": "push"}
UNITS = {"hall": "m", "acceleration": "m/s^2", "wrench": "N", "momentum": "N"}
SOURCES = ("arms", "acceleration", "wrench", "fused")
THRESHOLDS: dict[str, Array] = {
    "hall": np.geomspace(2e-5, 2e-2, 31),
    "acceleration": np.geomspace(1.0, 150.0, 31),
    "wrench": np.geomspace(0.5, 150.0, 31),
    "momentum": np.geomspace(0.5, 150.0, 31),
}
#: A storm for free flight: 6 m/s of mean wind, turbulence of a moderate wind of 30 knots; the drag
#: is strong for robots this heavy; all chosen.
STORM = {
    "wind": [6.0, 0.0, 0.0],
    "gusts": {"wind_at_6_m": 30.0 * 1852.0 / 3600.0},
    "rotor_drag": [0.3, 0.3, 0.1],
}
#: The observer on the estimated momentum, in place of the accelerometer.
ON_MOMENTUM = {"recovery": {"observer": {"basis": "momentum"}}}


class Approach(NamedTuple):
    """One flight at a wall."""

    robot: str
    speed: float  # at contact [m/s]
    wall_yaw: float  # of the wall [deg]
    robot_yaw: float  # of the robot [deg]
    trial: int


def contact_position(vehicle: StudyVehicle) -> float:
    """Where the main body is when a vehicle touches the paper's wall, not askew [m].

    It is rounded down to a decimetre: near its peak, speed hardly changes.
    """
    return math.floor(10.0 * (WALL_DISTANCE - vehicle.reach())) / 10.0


def approach_tables(
    approach: Approach, vehicle: StudyVehicle, seed: int, changes: dict[str, Any] | None = None
) -> dict[str, Any]:
    """The scenario of a flight at a wall: level cruise at the speed asked for, then contact.

    Args:
        approach: Speed and yaws.
        vehicle: Its robot.
        seed: Of all random draws.
        changes: Tables merged over those of the test.
    """
    robot, speed, wall_yaw, robot_yaw, trial = approach
    noise_stream = Scatter().draw(robot, 0.0, speed, trial, seed)
    noise_stream = noise_stream._replace(wall_yaw=noise_stream.wall_yaw + math.radians(wall_yaw))
    own = {"vehicle": vehicle.tables} | (changes or {})
    given = trial_tables(robot, 0.0, speed, noise_stream, own)
    run = RUN if speed > SLOW else SHORT_RUN
    begin, lasting = contact_position(vehicle) - run, PEAK_OVER_MEAN * 2.0 * run / speed
    x, y, z = noise_stream.position
    return given | {
        "name": f"{robot}, {speed:g} m/s, wall {wall_yaw:g} deg, robot {robot_yaw:g} deg",
        "reference": {
            "type": "waypoints",
            "positions": [[begin, 0.0, 1.0], [begin + 2.0 * run, 0.0, 1.0]],
            "duration": lasting,
            "yaw": math.radians(robot_yaw),
        },
        "control": given["control"] | {"feed_forward": True},
        "start": given["start"]
        | {"position": [x + begin, y, z], "yaw": noise_stream.heading + math.radians(robot_yaw)},
        "simulation": {"duration": round(0.5 * lasting + 0.4, 3)},
    }


def free_tables(
    vehicle: StudyVehicle, number: int, changes: dict[str, Any] | None = None
) -> dict[str, Any]:
    """The scenario of a free flight: fast circles and steps in turn, half of them in gusts.

    The circle is the paper's fast one (Free Flight: 1 m, period π s), whose speed jumps at first.

    Args:
        vehicle: Robot.
        number: Of the flight.
        changes: Tables laid over those of the test.
    """
    steps = [[0, 0, 1], [0, 0, 2], [1, 0, 2], [1, 1, 2], [-1, -1, 1], [1, 1, 3]]
    references: tuple[dict[str, Any], ...] = (
        {"type": "circle", "radius": 1.0, "period": math.pi},
        {"type": "steps", "dwell": 2.5, "positions": steps * 4},
    )
    start = ([1.0, 0.0, 1.0], [0.0, 0.0, 1.0])[number % 2]
    given: dict[str, Any] = {
        "name": f"{vehicle.name}, free flight {number + 1}",
        "vehicle": vehicle.tables,
        "reference": references[number % 2],
        "recovery": {},
        "world": {
            "obstacles": [
                {"type": "wall", "distance": FAR, "surface": "wall"},
                {"type": "ground", "surface": "wall"},
            ]
        },
        "start": {"position": start},
        "simulation": {"duration": PIECE},
        "seed": number,
    }
    if number % 4 >= 2:
        given["air"] = STORM
    return given | (changes or {})


class ReadyTrial(NamedTuple):
    """A flight ready to be flown."""

    scenario: Scenario
    model: Model
    avionics: Avionics


def fly_ready_trial(tables: dict[str, Any]) -> tuple[ReadyTrial, GuidedFlown]:
    """A flight, flown with its trajectory and telemetry."""
    scenario = scenario_from(tables)
    built = scenario.build()
    assert built.built_avionics is not None  # every flight of the study has a pilot
    ready = ReadyTrial(scenario, built.model, built.built_avionics.avionics)
    return ready, fly_built(built, trace=True)


def signals_of(ready: ReadyTrial, guided: GuidedFlown) -> dict[str, TriggerSignal]:
    """The signal of every trigger, tick by tick."""
    assert guided.telemetry is not None  # asked only of flights that keep one
    sensors, tick = ready.scenario.sensors, 1.0 / ready.scenario.clock
    paces: dict[str, Any] = {"pressed": sensors.hall, "jolt": sensors.imu, "push": sensors.imu}
    found = {}
    for name in ("hall", "acceleration", "wrench"):
        column, pace = SIGNALS[name], paces[SIGNALS[name]]
        every = 1 if pace.perfect else round(1.0 / (pace.rate * tick))
        values = np.ascontiguousarray(guided.telemetry[f"pilot.{column}"])
        found[name] = TriggerSignal(values, tick, every)
    return found


class CharacterisationError(NamedTuple):
    """Errors of the characterisation of one collision."""

    approach: Approach
    clipped: bool  # the accelerometer was at its range
    arms_right: bool  # those that took part
    to_impulse: dict[str, float | None]  # angle to the true contact impulse by source [rad]
    to_normal: dict[str, float | None]  # angle to the wall's normal by source [rad]
    friction: float  # angle from the normal to the true impulse [rad]
    position: float  # p_c, of the main body at the alarm, against the truth [m]
    contact_point: float  # against the true one at the alarm [m]
    intensity: float  # largest external force, over the largest contact force
    looked: float  # from touch to the end of the window [s]


@dataclass(frozen=True)
class CollisionTrial:
    """One collision, its detection and characterisation."""

    approach: Approach
    touch: float
    """Time of first touch [s]."""
    delays: dict[str, float | None]
    """Delay after touch of each trigger at its threshold [s]; None if it missed."""
    signals: dict[str, TriggerSignal] = field(repr=False)
    characterisation_error: CharacterisationError | None = None


def _angle(a: Any, b: Any) -> float | None:
    """Signed angle between the level parts of two vectors [rad]."""
    if math.hypot(a[0], a[1]) < 1e-9 or math.hypot(b[0], b[1]) < 1e-9:
        return None
    return math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])


def _vectors(columns: Any, stem: str, axes: str = "xyz") -> Array:
    """Columns of a vector side by side, shape (instants, axes)."""
    return np.stack([columns[f"{stem}.{axis}"] for axis in axes], axis=1)


def _rotation_matrix(quaternion: Array) -> Array:
    """Rotation matrix, body to world, of a quaternion wxyz."""
    w, (x, y, z) = quaternion[0], quaternion[1:]
    skewed = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turned: Array = np.eye(3) + 2.0 * w * skewed + 2.0 * skewed @ skewed
    return turned


def true_contact_point(trace: Any, airframe: Any, row: int, normal: Array, arms: Any) -> Array:
    """Mean of the foremost points of the cages that are hit, world [m], by NumPy.

    Args:
        trace: Of the flight.
        airframe: True.
        row: Of the instant.
        normal: Into the obstacle, world.
        arms: Which are hit, true or false.
    """
    r = _rotation_matrix(_vectors(trace, "state.attitude", "wxyz")[row])
    place = _vectors(trace, "state.position")[row]
    points = []
    for j, arm in enumerate(airframe.arms):
        if not arms[j]:
            continue
        length = trace[f"state.arm_length.{j + 1}"][row]
        path = arm_path(arm, np.array([length]))
        up = r @ path.turn[0, :, 2]
        flat = normal - (normal @ up) * up
        lever = length * (r @ path.direction[0]) if isinstance(arm, Arm) else r @ path.end[0]
        points.append(place + lever + arm.cage_radius * (flat / np.linalg.norm(flat)))
    mean: Array = np.mean(points, axis=0)
    return mean


def characterisation_error(
    approach: Approach, ready: ReadyTrial, guided: GuidedFlown, touch: float
) -> CharacterisationError | None:
    """The robot's characterisation of a collision, against the truth; None if it noticed nothing.

    Two things count as true: the direction of the impulse of the contact force, with friction, from
    touch to the end of the window; and the wall's normal.
    """
    telemetry, trace = guided.telemetry, guided.flown.trace
    assert telemetry is not None  # asked only of flights that keep both
    assert trace is not None
    looking = np.flatnonzero(telemetry["pilot.phase"] == LOOK)
    if not len(looking):
        return None
    alarm, end = (
        telemetry["time"][looking[0]],
        telemetry["time"][looking[-1]] + 1.0 / ready.scenario.clock,
    )
    hit: Collision = guided.onboard.pilot.collision
    t: Array = np.asarray(trace["time"])
    first, at, last = (min(int(np.searchsorted(t, x)), len(t) - 1) for x in (touch, alarm, end))
    impulse = -(_vectors(trace, "work.impulse")[last] - _vectors(trace, "work.impulse")[first])
    count = len(ready.model.airframe.arms)
    pressed = np.stack([trace[f"arms.{j + 1}.normal"][first : last + 1] for j in range(count)])
    shares = np.trapezoid(pressed, t[first : last + 1], axis=1)
    touched = shares >= TOOK_PART * shares.sum()
    normal = np.array(guided.flown.record.first_impact.inward)
    directions = (hit.by_arms, hit.by_acceleration, hit.by_wrench, hit.by_fusion)
    said = dict(zip(SOURCES, directions, strict=True))
    there = true_contact_point(trace, ready.model.airframe, at, normal, touched)
    force = np.linalg.norm(_vectors(trace, "contact_force")[first : last + 1], axis=1).max()
    place = _vectors(trace, "state.position")[at]
    imu = np.abs(_vectors(telemetry, "measurement.inertial.specific_force")[looking])
    limit = ready.avionics.systems.pilot.characterisation.limit
    return CharacterisationError(
        approach=approach,
        clipped=bool(imu.max() >= limit),
        arms_right=[bool(x) for x in hit.arms] == touched.tolist(),
        to_impulse={name: _angle(impulse, way) for name, way in said.items()},
        to_normal={name: _angle(normal, way) for name, way in said.items()},
        friction=_angle(normal, impulse) or 0.0,
        position=float(np.linalg.norm(np.array(hit.position) - place)),
        contact_point=float(np.linalg.norm(np.array(hit.contact_point) - there)),
        intensity=hit.intensity / float(force),
        looked=float(end - touch),
    )


def fly_collision(
    approach: Approach, vehicle: StudyVehicle, seed: int, changes: dict[str, Any] | None = None
) -> CollisionTrial:
    """Fly one approach and evaluate the collision.

    Args:
        approach: Speed and yaws.
        vehicle: Its robot.
        seed: Of all random draws.
        changes: Tables merged over those of the test.
    """
    ready, guided = fly_ready_trial(approach_tables(approach, vehicle, seed, changes))
    touch = guided.flown.record.first_impact.touch_time
    seen = guided.onboard.pilot.detection
    firsts = {name: getattr(seen, name).first for name in ("hall", "acceleration", "wrench")}
    delays = {name: first - touch if first >= touch else None for name, first in firsts.items()}
    end = int((touch + 0.1) / ready.avionics.systems.period)
    signals = {
        name: one._replace(signal=one.signal[:end].copy())
        for name, one in signals_of(ready, guided).items()
    }
    return CollisionTrial(
        approach, touch, delays, signals, characterisation_error(approach, ready, guided, touch)
    )


@dataclass
class DetectionResults:
    """All flights of the study."""

    flights: int
    """Trials of each approach."""
    seed: int
    vehicles: tuple[StudyVehicle, ...] = field(default_factory=lambda: study_vehicles(ROBOTS))
    collisions: list[CollisionTrial] = field(default_factory=list)
    on_momentum: list[CollisionTrial] = field(default_factory=list)
    free: dict[str, list[dict[str, TriggerSignal]]] = field(default_factory=dict)
    """Signals of the free flights of each robot."""
    free_on_momentum: dict[str, list[dict[str, TriggerSignal]]] = field(default_factory=dict)
    alarms: dict[str, dict[str, float]] = field(default_factory=dict)
    """Alarms of each trigger in the free flights of each robot, at its default threshold."""
    _false_alarms: dict[tuple[str, str, int], FalseAlarms] = field(default_factory=dict, repr=False)
    """Cache: free flight is long."""

    @property
    def robots(self) -> tuple[str, ...]:
        """Robots in order."""
        return tuple(one.name for one in self.vehicles)

    def free_time(self, robot: str) -> float:
        """Free flight of a robot [s]."""
        return sum(len(one["wrench"].signal) * one["wrench"].period for one in self.free[robot])

    def triggers(self, robot: str) -> list[str]:
        """Triggers of a robot; the arms' sensors are useless where no arm slides."""
        slides = next(one for one in self.vehicles if one.name == robot).vehicle.is_compliant
        return [name for name in SIGNALS if name != "hall" or slides]

    def hits(self, robot: str, trigger: str, speed: float | None = None) -> list[CollisionTrial]:
        """Collisions of a robot that a trigger watched."""
        flights = self.on_momentum if trigger == "momentum" else self.collisions
        return [
            one for one in flights
            if one.approach.robot == robot and speed in (None, one.approach.speed)
        ]  # fmt: skip

    def delays(self, robot: str, trigger: str, speed: float) -> list[float | None]:
        """Delays of a trigger at its default threshold [s]; None where it missed or was late."""
        name = "wrench" if trigger == "momentum" else trigger
        found = [one.delays[name] for one in self.hits(robot, trigger, speed)]
        return [x if x is not None and x <= IN_TIME else None for x in found]

    def curve(
        self, robot: str, trigger: str, speed: float | None = None, persistence: int = 1
    ) -> list[RocPoint]:
        """The receiver operating curve of a trigger, at one speed or over all."""
        key, name = (robot, trigger, persistence), "wrench" if trigger == "momentum" else trigger
        thresholds = THRESHOLDS[trigger].tolist()
        if key not in self._false_alarms:
            free = self.free_on_momentum if trigger == "momentum" else self.free
            signals = [one[name] for one in free[robot]]
            self._false_alarms[key] = false_alarms(signals, thresholds, persistence=persistence)
        return curve(
            self._false_alarms[key],
            [(one.signals[name], one.touch) for one in self.hits(robot, trigger, speed)],
            thresholds, persistence=persistence, within=IN_TIME,
        )  # fmt: skip

    def characterisation_error(
        self, robot: str | None = None, speed: float | None = None
    ) -> list[CharacterisationError]:
        """Errors of all characterised collisions, or of those of a robot or speed."""
        return [
            one.characterisation_error for one in self.collisions
            if one.characterisation_error is not None and robot in (None, one.approach.robot)
            and speed in (None, one.approach.speed) and one.approach.speed >= CHARACTERISED_FROM
        ]  # fmt: skip


def _approaches(
    vehicles: Sequence[StudyVehicle], flights: int, askew: Sequence[tuple[int, int]]
) -> Iterator[tuple[Approach, StudyVehicle]]:
    for one, speed, (wall, yaw), trial in product(vehicles, SPEEDS, askew, range(flights)):
        yield Approach(one.name, speed, float(wall), float(yaw), trial), one


def detection_study(
    flights: int = 4,
    *,
    robots: Sequence[str] = ROBOTS,
    free: float = FREE,
    seed: int = 0,
    askew: Sequence[tuple[int, int]] = ASKEW,
    progress: Progress = silent,
) -> DetectionResults:
    """Fly the study.

    Args:
        flights: Trials of each approach.
        robots: Presets, and files with a vehicle.
        free: Free flight of each robot [s], in pieces of `PIECE`.
        seed: Of all random draws.
        askew: Yaws of wall and robot [deg].
        progress: Called with the fraction done.

    Raises:
        InputError: If a robot is invalid.
    """
    results = DetectionResults(flights, seed, study_vehicles(robots))
    hits, straight = (
        list(_approaches(results.vehicles, flights, some)) for some in (askew, askew[:1])
    )
    pieces = max(1, round(free / PIECE))
    total = len(hits) + len(straight) + 2.0 * len(results.vehicles) * pieces
    done = 0.0

    def step() -> None:
        nonlocal done
        done += 1.0
        progress(done / total)

    for approach, vehicle in hits:
        results.collisions.append(fly_collision(approach, vehicle, seed))
        step()
    for approach, vehicle in straight:
        results.on_momentum.append(fly_collision(approach, vehicle, seed, ON_MOMENTUM))
        step()
    for vehicle in results.vehicles:
        raised = dict.fromkeys(("hall", "acceleration", "wrench", "momentum"), 0.0)
        for number in range(pieces):
            for changes, kept in ((None, results.free), (ON_MOMENTUM, results.free_on_momentum)):
                ready, guided = fly_ready_trial(free_tables(vehicle, number, changes))
                kept.setdefault(vehicle.name, []).append(signals_of(ready, guided))
                seen = guided.onboard.pilot.detection
                if changes is None:
                    for name in ("hall", "acceleration", "wrench"):
                        raised[name] += getattr(seen, name).alarms
                else:
                    raised["momentum"] += seen.wrench.alarms
                step()
        results.alarms[vehicle.name] = raised
    return results
